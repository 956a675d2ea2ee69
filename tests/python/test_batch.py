"""Batches: the same bits as single runs, no copies, errors, Ctrl-C."""

import os
import signal
import threading
import tracemalloc

import numpy as np
import pytest

import osculo

SCENE = osculo.preset("break")


def breaks(count):
    """Shots that differ a little in azimuth and tip."""
    turn = np.linspace(-0.01, 0.01, count)
    zero = np.zeros(count)
    return np.column_stack([zero + 7, np.pi / 2 + turn, zero + np.nan, 10 * turn, zero])


def test_every_shot_is_that_of_simulate():
    shots = breaks(12)
    batch = osculo.simulate_batch(SCENE, shots, record="pieces", states=True)
    assert set(batch["status"]) == {osculo.SHOT_STATUSES["at_rest"]}
    for i, (speed, azimuth, _, side, height) in enumerate(shots):
        cue = {"speed": speed, "azimuth": azimuth, "offset": [side, height]}
        run = osculo.simulate(SCENE.replace(cue=cue))
        assert batch["time"][i] == run.time and batch["event_count"][i] == run.event_count
        assert (batch["state"][i] == run.balls["state"]).all()
        assert (batch["position"][i] == run.balls["state"]["position"]).all()
        assert (batch["fate"][i] == run.balls["fate"]).all()
        assert (batch["rim"][i] == run.balls["rim"]).all()
        events = batch["events"][batch["event_offsets"][i] : batch["event_offsets"][i + 1]]
        assert (events == run.events).all()
        pieces = batch["pieces"][batch["piece_offsets"][i] : batch["piece_offsets"][i + 1]]
        assert (pieces == run.pieces).all()
        outcome = run.outcome
        assert SCENE.ids[batch["first_hit"][i]] == outcome["hits"][0]["ball"]
        assert SCENE.ids[batch["cue_ball"][i]] == outcome["cue_ball"]
        assert batch["kisses"][i] == outcome["kisses"]
        assert batch["settled_count"][i] == run.settled_count
        assert batch["driven_to_cushion"][i] == outcome["driven_to_cushion"]
        assert batch["ball_contacts"][i].tolist() == [ball["balls"] for ball in outcome["balls"]]
        falls = {fall["ball"]: fall["time"] for fall in outcome["falls"]}
        for ball, time in zip(SCENE.ids, batch["capture_time"][i]):
            assert time == falls[ball] if ball in falls else np.isnan(time)


def test_threads_and_chunks_change_no_bit():
    shots = breaks(40)
    one = osculo.simulate_batch(SCENE, shots, threads=1)
    for options in ({"threads": 3}, {"threads": 2, "chunk": 7}):
        other = osculo.simulate_batch(SCENE, shots, **options)
        assert one.keys() == other.keys()
        for name in one:
            np.testing.assert_array_equal(one[name], other[name], name)


def test_starts():
    scene = osculo.preset("box", balls=5)
    rng = np.random.default_rng(7)
    starts = np.zeros((8, 5, 7))
    starts[:, :, :2] = scene.positions
    starts[:, :, 2:4] = rng.normal(size=(8, 5, 2))
    present = rng.random((8, 5)) < 0.7
    batch = osculo.Batch(scene, time=3, states=True).release(starts, present)
    for i in range(8):
        balls = [
            dict(ball, velocity=starts[i, j, 2:4], position=starts[i, j, :2])
            for j, ball in enumerate(scene.to_dict()["balls"])
            if present[i, j]
        ]
        run = osculo.simulate(scene.replace(balls=balls, limits={"time": 3}))
        assert (batch["state"][i][present[i]] == run.balls["state"]).all()
        assert (batch["fate"][i][~present[i]] == osculo.SHOT_FATES["absent"]).all()


def test_results_are_views_that_live_on():
    batch = osculo.Batch(SCENE)
    first = batch.strike(breaks(20))
    kept = {name: column.copy() for name, column in first.items()}
    position = first["position"]
    assert not position.flags.owndata and not position.flags.writeable
    assert position.base is first["time"].base
    batch.strike(breaks(30))
    del batch
    for name, column in first.items():
        np.testing.assert_array_equal(column, kept[name], name)


def peak_of_numpy(play):
    """Memory that numpy and Python allocate meanwhile, at most [bytes]."""
    tracemalloc.start()
    try:
        play()
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_contiguous_doubles_are_read_in_place():
    batch = osculo.Batch(SCENE)
    shots = np.full((100_000, 5), -1.0)  # invalid ones take no time
    assert peak_of_numpy(lambda: batch.strike(shots)) < 100_000
    narrow = shots.astype(np.float32)
    assert peak_of_numpy(lambda: batch.strike(narrow)) > shots.nbytes


def test_no_shots():
    batch = osculo.simulate_batch(SCENE, np.empty((0, 5)))
    assert batch["status"].shape == (0,) and batch["position"].shape == (0, 16, 2)


def test_an_invalid_shot_leaves_the_others_alone():
    shots = breaks(3)
    shots[1, 0] = -1
    status = osculo.simulate_batch(SCENE, shots)["status"]
    assert status.tolist() == [0, osculo.SHOT_STATUSES["invalid"], 0]


@pytest.mark.parametrize("shape", [(5,), (3, 4), (2, 2, 5)])
def test_wrong_shapes_of_shots(shape):
    with pytest.raises(ValueError, match=r"\(N, 5\)"):
        osculo.simulate_batch(SCENE, np.ones(shape))


def test_wrong_shapes_of_starts():
    batch = osculo.Batch(SCENE)
    with pytest.raises(ValueError, match=r"\(N, 16, 7\)"):
        batch.release(np.zeros((3, 15, 7)))
    with pytest.raises(ValueError, match=r"\(N, 16\)"):
        batch.release(np.zeros((3, 16, 7)), np.ones((2, 16), bool))


def test_strikes_need_cloth():
    with pytest.raises(osculo.SceneError):
        osculo.simulate_batch(osculo.preset("gas"), breaks(1))


def test_limits_and_options():
    batch = osculo.Batch(SCENE, time=0.5, threads=1)
    assert batch.threads == 1 and batch.engine.startswith("cloth/") and batch.scene == SCENE
    result = batch.strike(breaks(2))
    assert result["time"].tolist() == [0.5, 0.5]
    assert set(result["status"]) == {osculo.SHOT_STATUSES["time_limit"]}
    assert set(osculo.simulate_batch(SCENE, breaks(2), events=3)["event_count"]) == {3}


def test_progress_counts_up_to_all():
    seen = []
    osculo.simulate_batch(SCENE, breaks(200), progress=lambda done, all: seen.append((done, all)))
    assert seen[-1] == (200, 200) and seen == sorted(seen)


def test_what_progress_raises_ends_the_batch():
    def refuse(done, all):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        osculo.simulate_batch(SCENE, breaks(200), progress=refuse)


def test_ctrl_c_ends_a_batch():
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        osculo.simulate_batch(SCENE, breaks(200_000), threads=1)
    timer.join()


def test_a_batch_that_is_being_played_refuses_another_thread():
    batch = osculo.Batch(SCENE, threads=1)
    caught = []

    def progress(done, all):
        try:
            batch.strike(breaks(1))
        except RuntimeError as error:
            caught.append(error)

    batch.strike(breaks(50), progress)
    assert caught
