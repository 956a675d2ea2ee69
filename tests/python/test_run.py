"""Runs: events, pieces, states at any time, documents, pickling."""

import json
import pickle

import numpy as np
import pytest

import osculo


@pytest.fixture(scope="module")
def run():
    return osculo.simulate(osculo.preset("break"))


def same(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and (a == b).all()


def test_a_head_on_impact_in_closed_form():
    # Equal masses a distance of 3 - 1 apart at 1 m/s: they meet at 2 s and swap velocities.
    scene = osculo.Scene(
        balls=[
            {"id": "a", "mass": 1, "radius": 0.5, "position": [0, 0], "velocity": [1, 0]},
            {"id": "b", "mass": 1, "radius": 0.5, "position": [3, 0]},
        ],
        limits={"time": 5},
    )
    run = osculo.simulate(scene)
    assert (run.status, run.time, run.event_count) == ("time_limit", 5, 1)
    event = run.events[0]
    assert event["time"] == 2 and event["kind"] == osculo.EVENT_KINDS["ball_ball"]
    assert event["point"].tolist() == [2.5, 0] and abs(event["normal"]).tolist() == [1, 0]
    assert sorted(run.ids(0)) == ["a", "b"]
    first = list(scene.ids).index(run.ids(0)[0])
    assert event["after"]["velocity"][first].tolist() == [0, 0]
    assert event["after"]["velocity"][1 - first].tolist() == [1, 0]
    states = run.at([0, 1, 2, 5])
    assert states.shape == (4, 2)
    assert states["position"][:, 0, 0].tolist() == [0, 1, 2, 2]
    assert states["position"][:, 1, 0].tolist() == [3, 3, 3, 6]
    assert run.balls["state"]["position"].tolist() == [[2, 0], [6, 0]]


@pytest.mark.parametrize("name", list(osculo.presets()))
def test_arrays_say_what_the_file_says(name):
    run = osculo.simulate(osculo.preset(name).replace(limits={"time": 5, "events": 300}))
    document = run.to_dict()
    kinds = list(osculo.EVENT_KINDS)
    phases = list(osculo.PHASES)
    assert len(run.events) == len(document["events"]) == run.event_count
    for index, (event, written) in enumerate(zip(run.events, document["events"])):
        assert event["time"] == written["time"]
        assert kinds[event["kind"]] == written["kind"]
        assert list(run.ids(index))[: len(written["ids"])] == written["ids"]
        for side, states in (("before", event["before"]), ("after", event["after"])):
            for state, expected in zip(states, written[side]):
                assert state["position"].tolist() == expected["position"]
                assert state["velocity"].tolist() == expected["velocity"]
                assert state["spin"].tolist() == expected.get("spin", [0, 0, 0])
        assert event["cluster"] == written.get("cluster", 0)
        assert event["well_posed"] == written.get("well_posed", True)
        if written["kind"] == "transition":
            assert phases[event["from"]] == written["from"]
            assert phases[event["to"]] == written["to"]
        else:
            assert event["point"].tolist() == written["point"]
            assert event["normal"].tolist() == written["normal"]
    assert len(run.pieces) == len(document["pieces"])
    for piece, written in zip(run.pieces, document["pieces"]):
        assert run.scene.ids[piece["ball"]] == written["ball"]
        assert phases[piece["phase"]] == written["law"]
        if "rim" in written:
            assert run.scene.rim_ids[piece["rim"]] == written["rim"]
        for end in ("from", "to"):
            assert piece[end] == written[end]
            assert piece[end + "_low"] == written.get(end + "_low", 0)
        for vector in ("position", "velocity", "position_low", "acceleration"):
            assert piece[vector].tolist() == written.get(vector, [0, 0])
        for vector in ("spin", "spin_rate", "resistance"):
            assert piece[vector].tolist() == written.get(vector, [0, 0, 0])
    for ball, written in zip(run.balls, document["balls"]):
        assert list(osculo.FATES)[ball["fate"]] == written["state"]
        assert ball["state"]["position"].tolist() == written["position"]
        assert (run.scene.rim_ids[ball["rim"]] if ball["rim"] >= 0 else None) == written.get("rim")
    assert run.outcome == document["outcome"]


def test_drag_in_closed_form():
    # v' = -k v: x = v (1 - exp(-k t)) / k.
    scene = osculo.Scene(
        motion={"law": "resisted", "linear": 0.5},
        balls=[{"id": "a", "mass": 1, "radius": 1, "position": [0, 0], "velocity": [2, 0]}],
        limits={"time": 3},
    )
    run = osculo.simulate(scene)
    assert run.pieces["resistance"].tolist() == [[0, 0.5, 0]]
    assert run.pieces["phase"][0] == osculo.PHASES["resisted"]
    times = np.linspace(0, 3, 7)
    np.testing.assert_allclose(
        run.at(times)["position"][:, 0, 0], 4 * (1 - np.exp(-times / 2)), rtol=1e-14
    )


def test_a_hole_that_pulls():
    scene = osculo.Scene(
        balls=[{"id": "a", "mass": 1, "radius": 0.02, "position": [0, 0.03], "velocity": [2, 0]}],
        rims=[{"id": "hole", "center": [1, 0], "radius": 0.1, "law": "paper"}],
        limits={"time": 3},
    )
    run = osculo.simulate(scene)
    kinds = [list(osculo.EVENT_KINDS)[kind] for kind in run.events["kind"]]
    assert kinds[0] == "rim_entry"
    inside = run.pieces[run.pieces["phase"] == osculo.PHASES["rim"]]
    assert len(inside) > 0 and (inside["rim"] == 0).all()
    middle = (inside[0]["from"] + inside[0]["to"]) / 2
    place = run.at(middle)["position"][0]
    assert np.hypot(*(place - [1, 0])) < 0.1


def test_contacts_at_one_instant_are_a_cluster():
    ball = {"mass": 1, "radius": 0.5}
    row = [dict(ball, id=name, position=[x, 0]) for name, x in (("b", 2), ("c", 3))]
    first = dict(ball, id="a", position=[0, 0], velocity=[1, 0])
    run = osculo.simulate(osculo.Scene(balls=[first, *row], limits={"time": 3}))
    assert len(run.events) == 2 and set(run.events["cluster"]) == {1}
    assert run.settled_count == 0


def test_states_at_the_events_are_those_of_the_events(run):
    for event in run.events[:40]:
        state = run.at(event["time"])[event["ball"]]
        np.testing.assert_allclose(
            state["position"], event["before"][0]["position"], rtol=0, atol=1e-14
        )


def test_states_between_follow_the_formula_of_the_pieces(run):
    for piece in run.pieces[::7]:
        time = (piece["from"] + piece["to"]) / 2
        wait = time - piece["from"]
        half = piece["acceleration"] / 2
        position = piece["position"] + piece["velocity"] * wait + half * wait**2
        state = run.at(time)[piece["ball"]]
        np.testing.assert_allclose(state["position"], position, rtol=0, atol=1e-14)
        velocity = piece["velocity"] + piece["acceleration"] * wait
        np.testing.assert_allclose(state["velocity"], velocity, rtol=0, atol=1e-13)


def test_states_are_nan_where_there_are_none(run):
    assert np.isnan(run.at(-1e-9)["position"]).all()
    assert np.isnan(run.at(run.time + 1e-9)["position"]).all()
    captured = run.balls["fate"] == osculo.FATES["captured"]
    assert captured.any()
    at_end = np.isnan(run.at(run.time)["position"]).all(axis=1)
    assert (at_end == captured).all()
    unrecorded = osculo.simulate(run.scene, record="events")
    assert np.isnan(unrecorded.at(0.5)["velocity"]).all()


def test_shapes_of_times(run):
    assert run.at(0.5).shape == (16,)
    assert run.at(np.zeros((2, 3))).shape == (2, 3, 16)
    assert run.at([]).shape == (0, 16)


def test_arrays_are_views_that_outlive_their_run():
    run = osculo.simulate(osculo.preset("break"))
    events = run.events
    assert np.shares_memory(events, run.events) and not events.flags.writeable
    copy = events.copy()
    del run
    [osculo.simulate(osculo.preset("break", seed=seed)) for seed in range(5)]
    assert same(events, copy)


def test_record(run):
    events_only = osculo.simulate(run.scene, record="events")
    assert same(events_only.events, run.events) and len(events_only.pieces) == 0
    nothing = osculo.simulate(run.scene, record="none")
    assert len(nothing.events) == 0 and nothing.event_count == run.event_count
    assert nothing.outcome is None
    assert same(nothing.balls, run.balls)
    for option in ({"record": "all"}, {"precision": "single"}):
        with pytest.raises(ValueError, match="must be 'none'|must be 'double'"):
            osculo.simulate(run.scene, **option)


def test_audit_and_certificate(run):
    assert run.audit is None and run.certificate is None
    assert osculo.simulate(run.scene, audit=True).audit["clean"]
    certified = osculo.simulate(run.scene, certify=True)
    assert certified.certificate["certain"] and len(certified.certificate["balls"]) == 16


def test_precision(run):
    quad = osculo.simulate(run.scene, precision="quad")
    assert quad.event_count == run.event_count and "quad" in quad.engine
    np.testing.assert_allclose(
        quad.balls["state"]["position"], run.balls["state"]["position"], atol=1e-9
    )


def test_pickling_keeps_every_bit(run):
    again = pickle.loads(pickle.dumps(run))
    assert same(again.events, run.events)
    assert same(again.pieces, run.pieces)
    assert same(again.balls, run.balls)
    assert again.scene == run.scene and again.to_json() == run.to_json()


def test_files(run, tmp_path):
    path = tmp_path / "run.json"
    path.write_text(run.to_json())
    assert osculo.load(path).to_json() == run.to_json()
    assert json.loads(run.to_json()) == run.to_dict()


def test_pictures(run):
    svg = run.to_svg()
    assert svg.startswith("<svg") and run._repr_svg_() == svg
    assert len(run.to_svg(numbers=False)) < len(svg)
    assert repr(run) == f"<osculo.Run: at_rest at {run.time!r} s, {run.event_count} events>"


def test_a_dict_will_do_for_a_scene():
    assert osculo.simulate({"table": "pool-9ft", "rack": "nine-ball"}).event_count == 0


def test_ids_refuses_what_is_not_there(run):
    count = run.event_count
    assert run.ids(-1) == run.ids(count - 1)
    for index in (count, -count - 1):
        with pytest.raises(IndexError):
            run.ids(index)
