"""The environment: seeds, spaces, rewards, and the rules behind them."""

import math
import sys
import types

import numpy as np
import pytest

import osculo
from osculo import env as module
from osculo import eightball


def shot_at(scene, ball, speed):
    way = scene.positions[scene.ids.index(ball)] - scene.positions[scene.ids.index("cue")]
    return np.array([speed, math.atan2(way[1], way[0]), 0, 0], dtype=np.float32)


def layout(**positions):
    """Balls on the 9 ft table, by their names with a leading underscore for numbers."""
    named = {name.lstrip("_"): place for name, place in positions.items()}
    return osculo.table("pool-9ft").replace(balls=eightball.balls_at(named))


def straight_at_left_pocket(ball="_1", **others):
    """The ball, the cue ball and the middle of the left side pocket on a line."""
    return layout(**{"cue": (0.6, 1.27), ball: (0.3, 1.27), **others})


@pytest.mark.parametrize("seed", range(5))
def test_layouts(seed):
    scene = eightball.random_layout(seed)
    assert sorted(scene.ids) == sorted(eightball.BALLS)
    assert scene == eightball.random_layout(seed) != eightball.random_layout(seed + 1)
    few = eightball.random_layout(seed, "pool-7ft", 4)
    assert len(few) == 5 and {"cue", "8"} <= set(few.ids)
    assert len(eightball.random_layout(seed, balls=1)) == 2
    with pytest.raises(ValueError):
        eightball.random_layout(seed, balls=16)


def test_the_same_seed_plays_the_same_episode():
    def play(env, seed):
        observation, _ = env.reset(seed=seed)
        trace = [observation]
        for angle in np.linspace(-3, 3, 6):
            observation, reward, terminated, truncated, info = env.step([3, angle, 0.1, 0.2])
            trace += [observation, reward, terminated, truncated, sorted(info.items())]
            if terminated:
                break
        return trace

    env = module.EightBallPotting(noise=1.0)
    first = play(env, 3)
    again = play(module.EightBallPotting(noise=1.0), 3)
    other = play(env, 4)
    assert repr(first) == repr(again) != repr(other)
    assert repr(play(env, 3)) == repr(first)


def test_noise_changes_what_happens():
    scene = eightball.random_layout(1)
    results = set()
    for noise in (0.0, 1.0):
        env = module.EightBallPotting(noise=noise)
        env.reset(seed=1, options={"scene": scene})
        results.add(env.step(shot_at(scene, "1", 3))[0].tobytes())
    assert len(results) == 2


def test_observations_and_actions_are_in_their_spaces():
    env = module.EightBallPotting()
    observation, info = env.reset(seed=2)
    assert observation.shape == (16, 3) and observation.dtype == np.float32 and info == {}
    assert observation[:, 2].all()
    env.action_space.seed(5)
    for _ in range(20):
        action = env.action_space.sample()
        assert action in env.action_space
        observation, reward, terminated, truncated, info = env.step(action)
        assert observation in env.observation_space
        assert isinstance(reward, float) and isinstance(info["legal"], bool)
        assert isinstance(terminated, bool) and isinstance(truncated, bool)
        if terminated or truncated:
            break
    assert np.zeros((16, 3)) not in env.action_space


def test_a_straight_pot_is_rewarded():
    scene = straight_at_left_pocket(_2=(1.0, 0.4), _8=(1.0, 2.0))
    env = module.EightBallPotting()
    env.reset(seed=0, options={"scene": scene})
    observation, reward, terminated, truncated, info = env.step(shot_at(scene, "1", 1.2))
    assert (reward, terminated, truncated) == (1, False, False)
    assert info == {"legal": True, "potted": ("1",), "status": "at_rest"}
    assert set(env.scene.ids) == {"cue", "2", "8"}
    assert observation[eightball.BALLS.index("1")].tolist() == [0, 0, 0]


def test_the_eight_wins_after_the_solids_and_loses_before():
    for others, reward_due in (({}, 1), ({"_1": (1.0, 0.4)}, -1)):
        scene = straight_at_left_pocket("_8", **others)
        env = module.EightBallPotting()
        env.reset(seed=0, options={"scene": scene})
        _, reward, terminated, _, info = env.step(shot_at(scene, "8", 1.2))
        assert (reward, terminated, info["legal"]) == (reward_due, True, reward_due > 0)
        with pytest.raises(RuntimeError, match="reset"):
            env.step([1, 0, 0, 0])


def test_fouls():
    # A stripe is hit first and falls; nothing is hit; the cue ball follows into the pocket.
    wrong = straight_at_left_pocket("_9", _1=(1.0, 0.4), _8=(1.0, 2.0))
    env = module.EightBallPotting()
    env.reset(seed=0, options={"scene": wrong})
    _, reward, _, _, info = env.step(shot_at(wrong, "9", 1.2))
    assert (reward, info["potted"]) == (-1, ("9",))
    env.reset(seed=0, options={"scene": wrong})
    _, reward, _, _, info = env.step([0.3, math.pi / 2, 0, 0])
    assert (reward, info["potted"]) == (-1, ())
    scratch = layout(cue=(0.3, 1.27), _1=(1.0, 0.4), _8=(1.0, 2.0))
    env.reset(seed=0, options={"scene": scratch})
    _, reward, _, _, info = env.step([2, math.pi, 0, 0])
    assert (reward, info["potted"]) == (-1, ("cue",))
    assert "cue" in env.scene.ids  # placed anew


def test_whole_episodes_of_random_shots():
    env = module.EightBallPotting(table="pool-7ft", noise=1.0, most_shots=25)
    env.action_space.seed(11)
    potted = 0
    for seed in range(12):
        observation, _ = env.reset(seed=seed)
        terminated = truncated = False
        while not (terminated or truncated):
            observation, _, terminated, truncated, info = env.step(env.action_space.sample())
            assert observation in env.observation_space
            assert int(observation[:, 2].sum()) == len(env.scene)
            potted += len(info["potted"])
    assert potted > 20


def test_an_episode_ends_after_so_many_shots():
    env = module.EightBallPotting(most_shots=2)
    env.reset(seed=0, options={"scene": straight_at_left_pocket(_8=(1.0, 2.0))})
    assert env.step([0.3, 0, 0, 0])[3] is False
    assert env.step([0.3, 0, 0, 0])[3] is True


def test_actions_out_of_range():
    env = module.EightBallPotting()
    scene = straight_at_left_pocket(_8=(1.0, 2.0))
    env.reset(seed=0, options={"scene": scene})
    within = env.step([8, math.pi, 0, 0.5])[0]
    env.reset(seed=0, options={"scene": scene})
    assert (env.step([100, 4, 0, 7])[0] == within).all()
    for action in ([1, 2, 3], [1, math.nan, 0, 0]):
        with pytest.raises(ValueError):
            env.step(action)


def test_render():
    env = module.EightBallPotting(render_mode="svg")
    with pytest.raises(RuntimeError):
        env.render()
    env.reset(seed=1)
    assert env.render().startswith("<svg")
    assert module.EightBallPotting().render_mode is None
    with pytest.raises(ValueError):
        module.EightBallPotting(render_mode="human")


def test_gymnasium_is_used_if_it_is_there(monkeypatch):
    """With stand-ins for gymnasium's modules: the real ones may not be installed."""
    gymnasium, spaces = types.ModuleType("gymnasium"), types.ModuleType("gymnasium.spaces")

    class Env:
        def reset(self, *, seed=None, options=None):
            self.np_random = np.random.default_rng(seed)

    class Box:
        def __init__(self, low, high, shape=None, dtype=None):
            self.bounds = low, high

    gymnasium.Env, spaces.Box, gymnasium.spaces = Env, Box, spaces
    monkeypatch.setitem(sys.modules, "gymnasium", gymnasium)
    monkeypatch.setitem(sys.modules, "gymnasium.spaces", spaces)
    monkeypatch.delitem(sys.modules, "osculo.env")
    import importlib

    fresh = importlib.import_module("osculo.env")
    env = fresh.EightBallPotting()
    assert isinstance(env, Env) and isinstance(env.action_space, Box)
    assert (env.reset(seed=7)[0] == module.EightBallPotting().reset(seed=7)[0]).all()
    monkeypatch.setitem(sys.modules, "osculo.env", module)


def test_gymnasium_agrees():
    """What Gymnasium itself says about the environment, where it is installed."""
    checker = pytest.importorskip("gymnasium.utils.env_checker")
    checker.check_env(module.EightBallPotting(), skip_render_check=True)
