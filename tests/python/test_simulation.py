"""Runs in parts: stopped, copied, kept, played on."""

import copy
import pickle
import threading

import pytest

import osculo

SCENE = osculo.preset("break")


def same(one, other):
    return one.to_json() == other.to_json()


def test_in_parts_is_the_run_in_one():
    whole = osculo.simulate(SCENE)
    simulation = osculo.Simulation(SCENE)
    assert simulation.status == "event_limit" and simulation.event_count == 0
    assert simulation.play(time=0.3) == simulation.status == "time_limit"
    assert 0 < simulation.time <= 0.3
    assert simulation.play(events=60) == "event_limit" and simulation.event_count == 60
    kept = [
        copy.copy(simulation),
        copy.deepcopy(simulation),
        pickle.loads(pickle.dumps(simulation)),
        osculo.Simulation.from_snapshot(simulation.snapshot()),
    ]
    assert simulation.play() == "at_rest"
    assert same(simulation.result(), whole)
    for other in kept:
        assert other.event_count == 60
        assert other.play() == "at_rest" and same(other.result(), whole)


def test_a_stop_is_a_run_with_that_limit():
    simulation = osculo.Simulation(SCENE, precision="extended", record="events")
    simulation.play(time=0.5)
    limits = {"time": 0.5, "events": SCENE.to_dict()["limits"]["events"]}
    stopped = osculo.simulate(
        SCENE.replace(limits=limits), precision="extended", record="events"
    )
    assert same(simulation.result(), stopped)


def test_threads_may_share_it():
    simulation = osculo.Simulation(SCENE, record="none")
    counts = []
    threads = [
        threading.Thread(target=lambda n=n: (simulation.play(events=n), counts.append(n)))
        for n in range(10, 100, 10)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(counts) == 9 and simulation.event_count == 90


def test_what_cannot_be():
    with pytest.raises(osculo.FormatError, match="is no snapshot"):
        osculo.Simulation.from_snapshot(b"nonsense")
    snapshot = bytearray(osculo.Simulation(SCENE).snapshot())
    snapshot[-5] ^= 1
    with pytest.raises(osculo.FormatError, match="is damaged"):
        osculo.Simulation.from_snapshot(bytes(snapshot))
    with pytest.raises(ValueError, match="precision"):
        osculo.Simulation(SCENE, precision="half")
