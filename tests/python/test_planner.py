"""The example that plans pots."""

import importlib.util
import math
from pathlib import Path

import numpy as np
import pytest

import osculo
from osculo import eightball

EXAMPLE = Path(__file__).parents[2] / "src/python/examples/potting_planner.py"
spec = importlib.util.spec_from_file_location("potting_planner", EXAMPLE)
planner = importlib.util.module_from_spec(spec)
spec.loader.exec_module(planner)


def layout(**positions):
    named = {name.lstrip("_"): place for name, place in positions.items()}
    return osculo.table("pool-9ft").replace(balls=eightball.balls_at(named))


def test_the_ghost_ball_of_a_cut_in_closed_form():
    # The pocket is straight above the target, so the ghost ball is a diameter straight below it.
    scene = layout(cue=(0.3, 0.5), _1=(0.6, 1.0), _8=(1.2, 0.3))
    aim = planner.Aim(scene, "1", np.array([0.6, 2.0]))
    dx, dy = 0.3, 1.0 - 2 * 0.028575 - 0.5
    assert aim.azimuth == pytest.approx(math.atan2(dy, dx))
    assert aim.cosine == pytest.approx(dy / math.hypot(dx, dy))
    assert aim.clear and aim.possible
    assert not planner.Aim(scene, "1", np.array([0.6, 0.2])).possible  # from behind
    between = layout(cue=(0.3, 0.5), _1=(0.6, 1.0), _8=(0.6, 1.5))
    assert not planner.Aim(between, "1", np.array([0.6, 2.0])).clear


def test_what_is_legal():
    scene = layout(cue=(0.6, 1.27), _1=(0.3, 1.27), _9=(0.9, 1.27), _8=(1.0, 2.0))
    left, right = planner.shots([math.pi, 0], 1.2)
    batch = osculo.simulate_batch(scene, np.array([left, right]))
    assert eightball.judge(scene, batch).tolist() == [True, False]


def test_the_planner_is_better_than_geometry_and_chance():
    rows = planner.compare(layouts=8, attempts=10, noise=1.0, balls=15, progress=None)
    rate = {name: rate for name, rate, *_ in rows}
    assert rate["planner"] > rate["ghost ball"] > rate["random aim"]
    assert rate["planner"] > 0.6
    # The same decisions every time.
    again = planner.compare(layouts=8, attempts=10, noise=1.0, balls=15, progress=None)
    assert [row[:3] for row in again] == [row[:3] for row in rows]
