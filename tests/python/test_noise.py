"""Noise and the probability of success."""

import math

import numpy as np
import pytest

import osculo
from osculo import eightball

SHOT = [2.0, 0.3, math.nan, 0.1, -0.1]
RADIUS = 0.028575


def test_tournament_noise_scales():
    noise = osculo.tournament_noise()
    assert noise["azimuth"] == pytest.approx(math.radians(0.125))
    assert noise["side"] == pytest.approx(0.0005) and noise["speed"] == pytest.approx(0.075)
    half = osculo.tournament_noise(0.5)
    assert all(half[name] == pytest.approx(noise[name] / 2) for name in noise)


def test_perturbed_shots_have_the_moments_asked_for():
    shots = osculo.perturb([SHOT, SHOT], draws=20000, radius=RADIUS, seed=7)
    assert shots.shape == (2, 20000, 5)
    assert not (shots[0, :, 0] == shots[1, :, 0]).any()
    noise = osculo.tournament_noise()
    due = [noise["speed"], noise["azimuth"], None, noise["side"] / RADIUS, noise["height"] / RADIUS]
    for column, deviation in enumerate(due):
        if deviation is None:
            assert np.isnan(shots[:, :, column]).all()
            continue
        # Standard errors of mean and deviation: 1 / sqrt(n) and 1 / sqrt(2 n) of the deviation.
        values = shots[0, :, column]
        assert abs(values.mean() - SHOT[column]) < 5 * deviation / math.sqrt(20000)
        assert abs(values.std() / deviation - 1) < 5 / math.sqrt(40000)
    again = osculo.perturb([SHOT, SHOT], draws=5, radius=RADIUS, seed=7)
    assert (again[:, :, 0] == shots[:, :5, 0]).all()
    assert (osculo.perturb([SHOT], draws=3, radius=RADIUS, noise=0.0)[0, :, 0] == 2).all()


def test_one_kind_of_noise_alone():
    shots = osculo.perturb([SHOT], draws=10, radius=RADIUS, noise={"speed": 0.1})
    assert (shots[0, :, 1] == 0.3).all() and (shots[0, :, 0] != 2).all()
    with pytest.raises(KeyError, match="velocity"):
        osculo.perturb([SHOT], draws=1, radius=RADIUS, noise={"velocity": 0.1})


def test_success_of_a_straight_pot():
    positions = {"cue": (0.6, 1.27), "1": (0.3, 1.27), "8": (1.0, 2.0)}
    scene = osculo.table("pool-9ft").replace(balls=eightball.balls_at(positions))
    batch = osculo.Batch(scene)
    shot = [1.2, math.pi, math.nan, 0, 0]
    exact = batch.success(shot, pots=["1"], first_hit="1", noise=0.0, draws=10)
    assert exact["probability"] == 1 and exact["draws"] == exact["successes"] == 10
    noisy = batch.success(shot, pots=["1"], draws=500, seed=3)
    assert 0.5 < noisy["low"] < noisy["probability"] < noisy["high"] < 1 or noisy["high"] == 1
    assert noisy == batch.success(shot, pots=["1"], draws=500, seed=3)
    assert batch.success(shot, pots=["8"], draws=50)["probability"] == 0
    assert batch.success(shot, pots=["1"], width=0.2)["draws"] < 10000
    with pytest.raises(KeyError, match="no ball '2'"):
        batch.success(shot, pots=["2"])
