"""Scenes: how they are made, refused, shown and kept."""

import json
import math
import pickle

import numpy as np
import pytest

import osculo

TWO_BALLS = {
    "balls": [
        {"id": "a", "mass": 1, "radius": 0.5, "position": [0, 0], "velocity": [1, 0]},
        {"id": "b", "mass": 2, "radius": 0.25, "position": [3, 0.1]},
    ]
}


def test_the_same_scene_from_mapping_text_members_and_scene():
    scene = osculo.Scene(TWO_BALLS)
    text = json.dumps({"schema": "osculo/scene-1", **TWO_BALLS})
    assert osculo.Scene(text) == scene
    assert osculo.Scene(**TWO_BALLS) == scene
    assert osculo.Scene(scene) == scene
    assert osculo.Scene(scene.to_dict()) == scene
    assert osculo.parse(scene.to_json()) == scene
    assert hash(osculo.Scene(text)) == hash(scene)
    assert scene != osculo.preset("break")


def test_columns_are_views_in_the_order_of_the_ids():
    scene = osculo.Scene(TWO_BALLS)
    assert scene.ids == ("a", "b") and len(scene) == 2
    assert scene.positions.tolist() == [[0, 0], [3, 0.1]]
    assert scene.velocities.tolist() == [[1, 0], [0, 0]]
    assert scene.spins.tolist() == [[0, 0, 0], [0, 0, 0]]
    assert scene.radii.tolist() == [0.5, 0.25]
    assert scene.masses.tolist() == [1, 2]
    assert np.shares_memory(scene.positions, scene.positions)
    with pytest.raises(ValueError):
        scene.positions[0, 0] = 1


def test_a_view_outlives_its_scene():
    positions = osculo.Scene(TWO_BALLS).positions
    [osculo.Scene(TWO_BALLS) for _ in range(100)]
    assert positions.tolist() == [[0, 0], [3, 0.1]]


def test_no_balls_no_rows():
    table = osculo.table("pool-9ft")
    assert table.positions.shape == (0, 2) and table.radii.shape == (0,)
    assert len(table.rim_ids) == 6


@pytest.mark.parametrize(
    ("members", "path", "rule", "value"),
    [
        ({"balls": [dict(TWO_BALLS["balls"][0], mass=-1)]}, "balls[0].mass", "must be > 0", "-1"),
        ({"balls": [dict(TWO_BALLS["balls"][0], mass=math.nan)]}, "balls[0].mass", "number", "nan"),
        ({"limits": {"time": -1}}, "limits.time", "must be", "-1"),
        ({"bals": []}, "bals", "did you mean balls?", ""),
        ({"table": "pool-10ft"}, "table", "did you mean pool-7ft?", "pool-10ft"),
    ],
)
def test_what_is_refused_has_its_path(members, path, rule, value):
    with pytest.raises(osculo.SceneError) as caught:
        osculo.Scene(**members)
    error = caught.value
    assert isinstance(error, ValueError)
    assert error.path == path and rule in error.rule and value in error.value
    assert str(error).startswith(path + ": ")
    again = pickle.loads(pickle.dumps(error))
    assert (again.path, again.rule, again.value) == (error.path, error.rule, error.value)


def test_what_is_no_file_of_osculo():
    with pytest.raises(osculo.FormatError, match="line 1"):
        osculo.Scene("{")
    with pytest.raises(osculo.FormatError, match="line 1"):
        osculo.Scene("{", table="pool-9ft")
    with pytest.raises(TypeError):
        osculo.Scene(balls=object())


def test_numpy_values_are_numbers():
    ball = dict(TWO_BALLS["balls"][0], position=np.array([0.1, 0.2]), mass=np.float32(0.5))
    scene = osculo.Scene(balls=[ball], limits={"events": np.int64(7)})
    assert scene.positions.tolist() == [[0.1, 0.2]] and scene.masses[0] == 0.5
    assert scene.to_dict()["limits"]["events"] == 7


def test_replace():
    scene = osculo.preset("break")
    slower = scene.replace(cue={"speed": 2, "azimuth": math.pi / 2})
    assert slower.to_dict()["cue"]["speed"] == 2
    # The least elevation that passes over the rail behind the cue ball, as in a file.
    assert slower.to_dict()["cue"]["elevation"] == scene.to_dict()["cue"]["elevation"] > 0
    assert "cue" not in scene.replace(cue=None).to_dict()
    assert scene == osculo.preset("break")


@pytest.mark.parametrize("name", list(osculo.presets()))
def test_presets_survive_pickling(name):
    scene = osculo.preset(name)
    again = pickle.loads(pickle.dumps(scene))
    assert again == scene and again.to_json() == scene.to_json()


def test_parameters_of_presets():
    assert len(osculo.preset("gas", balls=7, seed=3)) == 7
    with pytest.raises(osculo.SceneError) as caught:
        osculo.preset("pi", packing=0.1)
    assert caught.value.path == "packing"
    with pytest.raises(osculo.SceneError):
        osculo.preset("brake")


def test_shown():
    scene = osculo.preset("break")
    text = "<osculo.Scene: 16 balls, 18 segments, 12 arcs, 6 rims, a cue>"
    assert repr(scene) == text
    assert repr(osculo.Scene(TWO_BALLS)).startswith("<osculo.Scene: 2 balls, 0 segments")
    assert scene._repr_svg_() == scene.to_svg() and scene.to_svg().startswith("<svg")
    assert 'width="300"' in scene.to_svg(300)


def test_explain_names_the_engine():
    name, left_out = osculo.Scene(TWO_BALLS).explain(record="none")
    assert name.startswith("uniform/") and "/none/" in name and left_out
    assert osculo.simulate(osculo.Scene(TWO_BALLS), record="none").engine == name


def test_load(tmp_path):
    scene = osculo.Scene(TWO_BALLS)
    path = tmp_path / "scene.json"
    path.write_text(scene.to_json())
    assert osculo.load(path) == scene == osculo.load(str(path))
    with pytest.raises(OSError):
        osculo.load(tmp_path / "nothing.json")
    packed = tmp_path / "scene.msgpack"
    packed.write_bytes(b"\xc1")
    with pytest.raises(osculo.FormatError, match="byte"):
        osculo.load(packed)
