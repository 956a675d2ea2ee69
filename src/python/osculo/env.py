"""An environment for learning to pot balls, in the form of Gymnasium's, which need not be there.

    import osculo.env
    env = osculo.env.EightBallPotting()
    observation, info = env.reset(seed=1)
    observation, reward, terminated, truncated, info = env.step(env.action_space.sample())

The player alone at a table of eight-ball, with the solids. An episode begins with a random layout
and ends when the "8" falls or after so many shots.
"""

import math
from typing import Any, Optional

import numpy

from . import eightball
from ._osculo import SHOT_FATES, SHOT_STATUSES, Batch, Scene, perturb

try:
    from gymnasium import Env as _Env
    from gymnasium.spaces import Box
except ImportError:  # the same as far as it is used here
    from ._spaces import Box, Env as _Env

__all__ = ["EightBallPotting"]

_Array = numpy.ndarray[Any, Any]

# Of an action: speed of the cue [m/s], azimuth [rad], offset of the tip to the left and upwards
# [ball radii].
_LOW = numpy.array([0.2, -math.pi, -0.5, -0.5], dtype=numpy.float32)
_HIGH = numpy.array([8.0, math.pi, 0.5, 0.5], dtype=numpy.float32)
_LARGEST_OFFSET = 0.5  # below the miscue limit, which noise may still pass


class EightBallPotting(_Env):  # type: ignore[misc]
    """Potting the solids, and then the "8", one shot after another.

    Action: float32 (4,): speed of the cue [m/s], 0.2 to 8; azimuth [rad], from x towards y, -pi to
    pi; offset of the tip to the left and upwards [ball radii], brought within 0.5 of the middle.
    The cue is as level as what is behind the ball lets it be. Values out of range are taken as the
    nearest in it.

    Observation: float32 (16, 3), a row for each of osculo.eightball.BALLS: position over the width
    of the bed, over its length, and 1; or 0, 0, 0 for a ball that is not on the table.

    Reward: 1 for every solid that falls in a legal shot, and for the "8" after the last of them;
    -1 for a foul: the cue ball falls, hits nothing or hits a wrong ball first, or the stick has no
    room or miscues; -1 for an "8" that falls too early. What falls in a foul stays down. A cue ball
    that fell is placed at random.

    table: name of a pool table. balls: object balls at the start. noise: magnitude of the noise of
    the computational pool tournaments, 0 for none. most_shots: in an episode. `info` has "legal",
    "potted" (ids) and "status" of the shot.
    """

    metadata: dict[str, Any] = {"render_modes": ["svg"]}
    render_mode: Optional[str] = None

    def __init__(
        self,
        table: str = "pool-9ft",
        balls: int = 15,
        noise: float = 0.0,
        most_shots: int = 50,
        render_mode: Optional[str] = None,
    ) -> None:
        if render_mode not in (None, "svg"):
            raise ValueError(f"render_mode must be None or 'svg', but it is {render_mode!r}")
        self.action_space = Box(low=_LOW, high=_HIGH, dtype=numpy.float32)
        # Captured balls are at 0; those on the table are on the bed.
        self.observation_space = Box(low=0.0, high=1.0, shape=(16, 3), dtype=numpy.float32)
        self.render_mode = render_mode
        self._table, self._balls, self._noise, self._most_shots = table, balls, noise, most_shots
        self._scene: Optional[Scene] = None
        self._shots = 0

    @property
    def scene(self) -> Scene:
        """The table as it is now, without a cue."""
        if self._scene is None:
            raise RuntimeError("reset() comes first")
        return self._scene

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None
    ) -> tuple[_Array, dict[str, Any]]:
        """A new episode. The same seed gives the same layout, noise and placements; without one
        they go on from the last. options: {"scene": Scene} begins with that one."""
        super().reset(seed=seed)
        drawn = int(self.np_random.integers(2**31))
        given = (options or {}).get("scene")
        layout = eightball.random_layout(drawn, self._table, self._balls)
        self._scene = layout if given is None else given
        self._shots = 0
        return self._observation(), {}

    def step(self, action: Any) -> tuple[_Array, float, bool, bool, dict[str, Any]]:
        """Plays one shot until everything is at rest."""
        scene = self.scene
        if "8" not in scene.ids:
            raise RuntimeError("the episode is over: reset() comes first")
        result = Batch(scene, threads=1).strike(self._strike(action))
        self._shots += 1
        info: dict[str, Any] = {"legal": False, "potted": (), "status": _name(result["status"][0])}
        own = eightball.targets(scene)
        if result["status"][0] != SHOT_STATUSES["at_rest"]:  # no shot at all: the table stays
            return self._observation(), -1.0, False, self._shots >= self._most_shots, info

        fell = result["fate"][0] == SHOT_FATES["captured"]
        potted = tuple(ball for ball, down in zip(scene.ids, fell) if down)
        first = int(result["first_hit"][0])
        foul = "cue" in potted or first < 0 or scene.ids[first] not in own
        lost = "8" in potted and (foul or own != ("8",))
        reward = -1.0 if foul or lost else float(len(set(potted) & set(own)))
        info.update(legal=not (foul or lost), potted=potted)
        self._scene = self._after(scene, result["position"][0], fell)
        terminated = "8" in potted
        truncated = not terminated and self._shots >= self._most_shots
        return self._observation(), reward, terminated, truncated, info

    def render(self) -> Optional[str]:
        """The table as SVG, with render_mode "svg"."""
        return self.scene.to_svg() if self.render_mode == "svg" else None

    def close(self) -> None:
        """Nothing is open."""

    def _strike(self, action: Any) -> _Array:
        values = numpy.asarray(action, dtype=float)
        if values.shape != (4,) or not numpy.isfinite(values).all():
            raise ValueError("an action is four finite numbers")
        speed, azimuth, side, height = numpy.clip(values, _LOW.astype(float), _HIGH.astype(float))
        shrink = min(1.0, _LARGEST_OFFSET / max(math.hypot(side, height), 1e-9))
        shot = numpy.array([[speed, azimuth, math.nan, side * shrink, height * shrink]])
        if self._noise == 0:
            return shot
        seed = int(self.np_random.integers(2**63))
        radius = float(self.scene.radii[0])
        noisy: _Array = perturb(shot, draws=1, radius=radius, noise=self._noise, seed=seed)[0]
        return noisy

    def _after(self, scene: Scene, positions: _Array, fell: _Array) -> Scene:
        standing = {
            ball: position
            for ball, position, down in zip(scene.ids, positions, fell)
            if ball != "cue" and not down
        }
        index = scene.ids.index("cue")
        if fell[index]:
            taken = numpy.array(list(standing.values())).reshape(-1, 2)
            cue = eightball.place(scene, taken, self.np_random)
        else:
            cue = positions[index]
        return scene.replace(balls=eightball.balls_at({"cue": cue, **standing}))

    def _observation(self) -> _Array:
        scene = self.scene
        observation = numpy.zeros((16, 3), dtype=numpy.float32)
        rows = [eightball.BALLS.index(ball) for ball in scene.ids]
        # A ball may come to rest in the mouth of a pocket, beside the bed.
        observation[rows, :2] = numpy.clip(scene.positions / eightball.bed(scene), 0, 1)
        observation[rows, 2] = 1
        return observation


def _name(code: int) -> str:
    return tuple(SHOT_STATUSES)[code]
