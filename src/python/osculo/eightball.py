"""Eight-ball as a potting task: random layouts, and what makes a shot legal.

The shooter has the solids, "1" to "7", and the "8" when none of them is left on the table.
"""

from typing import Any

import numpy

from ._osculo import SHOT_FATES, SHOT_STATUSES, Scene, table

__all__ = ["BALLS", "SOLIDS", "STRIPES", "bed", "judge", "random_layout", "targets"]

_Array = numpy.ndarray[Any, Any]

SOLIDS = tuple(str(number) for number in range(1, 8))
STRIPES = tuple(str(number) for number in range(9, 16))
BALLS = ("cue", *SOLIDS, "8", *STRIPES)

_RADIUS = 0.028575  # [m]
_MASS = 0.170097  # [kg]
_GAP = 1e-3  # between balls, and between balls and noses, at least [m]


def _rims(scene: Scene) -> tuple[_Array, _Array]:
    rims = scene.to_dict()["rims"]
    centers = numpy.array([rim["center"] for rim in rims])
    return centers, numpy.array([rim["radius"] for rim in rims])


def bed(scene: Scene) -> _Array:
    """Width and length of the bed of a pool table between the noses [m]."""
    rails = {segment["id"]: segment for segment in scene.to_dict()["segments"]}
    return numpy.array([rails["right-lower"]["from"][0], rails["top"]["from"][1]])


def place(scene: Scene, taken: _Array, rng: numpy.random.Generator) -> _Array:
    """A place [m] at random on the bed of a pool table, clear of balls at `taken` and pockets."""
    centers, radii = _rims(scene)
    low = _RADIUS + _GAP
    high = bed(scene) - low
    while True:
        point: _Array = rng.uniform(low, high)
        free = (numpy.hypot(*(taken - point).T) > 2 * _RADIUS + _GAP).all()
        if free and (numpy.hypot(*(centers - point).T) > radii + _RADIUS).all():
            return point


def balls_at(positions: "dict[str, Any]") -> list[dict[str, Any]]:
    """Pool balls at rest at these positions [m], as members of a scene."""
    return [
        {"id": ball, "mass": _MASS, "radius": _RADIUS, "position": [float(x) for x in position]}
        for ball, position in positions.items()
    ]


def random_layout(seed: int, name: str = "pool-9ft", balls: int = 15) -> Scene:
    """A table with the cue ball and some object balls (the "8" among them) at random places.

    The same seed gives the same layout. Which of the other balls there are is drawn, too.
    """
    if not 1 <= balls <= 15:
        raise ValueError(f"balls must be from 1 to 15, but it is {balls}")
    rng = numpy.random.default_rng(seed)
    others = rng.permutation([*SOLIDS, *STRIPES])[: balls - 1]
    scene = table(name)
    positions: dict[str, Any] = {}
    for ball in ("cue", "8", *sorted(map(str, others), key=int)):
        taken = numpy.array(list(positions.values())).reshape(-1, 2)
        positions[ball] = place(scene, taken, rng)
    return scene.replace(balls=balls_at(positions))


def targets(scene: Scene) -> tuple[str, ...]:
    """The ids of the balls that the shooter may hit first and has to pot."""
    solids = tuple(ball for ball in scene.ids if ball in SOLIDS)
    return solids or tuple(ball for ball in scene.ids if ball == "8")


def judge(scene: Scene, result: "dict[str, _Array]") -> _Array:
    """Which shots of a batch are legal pots: the first ball hit is an own one, an own one falls,
    and neither the cue ball nor, before its time, the "8" does. Shape (N,)."""
    own = targets(scene)
    is_own = numpy.array([ball in own for ball in scene.ids])
    must_stay = numpy.array([ball in ("cue", "8") and ball not in own for ball in scene.ids])
    fell = result["fate"] == SHOT_FATES["captured"]
    first = result["first_hit"]
    hit_own = (first >= 0) & is_own[first]
    came_to_rest = result["status"] == SHOT_STATUSES["at_rest"]
    legal: _Array = (
        came_to_rest & hit_own & fell[:, is_own].any(axis=1) & ~fell[:, must_stay].any(axis=1)
    )
    return legal
