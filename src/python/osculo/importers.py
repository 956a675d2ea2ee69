"""Scenes from the descriptions of other simulators of pool.

    from osculo import importers
    importers.from_pooltool(json.load(open("shot.json")))
    importers.from_fastfiz(state, {"a": 0, "b": 0, "theta": 5, "phi": 90, "v": 3})

Geometry, balls and strike are those of the description; the laws are the nearest that osculo has,
as each function says. Contacts at one instant are resolved one after another, as they do.
"""

import math
from collections import abc
from typing import Any, Optional

from ._osculo import Scene

__all__ = ["from_fastfiz", "from_pooltool"]

_Document = abc.Mapping[str, Any]

# pooltool: state labels of balls.
_POCKETED = 4


def _common(balls: abc.Mapping[str, _Document], name: str) -> float:
    """A parameter that all balls have to share, since it is one of the laws here."""
    values = {float(ball["params"][name]) for ball in balls.values()}
    if len(values) != 1:
        raise ValueError(f"balls must have the same {name}, but they have {sorted(values)}")
    return values.pop()


def _segment(cushion: _Document) -> dict[str, Any]:
    (x1, y1), (x2, y2) = cushion["p1"][:2], cushion["p2"][:2]
    direction = int(cushion.get("direction", 2))
    # The side is told by the normal (1, 0) of a vertical cushion, and that with y > 0 of any other:
    # 1 stops balls on its side, 0 those on the other one. Here it is the left from end to end.
    is_left = x2 > x1 or (x2 == x1 and y2 < y1)
    ends = [[x1, y1], [x2, y2]]
    if direction != 2 and is_left != (direction == 1):
        ends.reverse()
    side = "both" if direction == 2 else "left"
    return {"id": f"cushion-{cushion['id']}", "from": ends[0], "to": ends[1], "side": side}


def _pooltool_ball(name: str, ball: _Document) -> Optional[dict[str, Any]]:
    # A shot that was simulated has its start in its history.
    states = ball.get("history", {}).get("states", [])
    state = states[0] if states else ball["state"]
    if int(state["s"]) == _POCKETED:
        return None
    position, velocity, spin = state["rvw"]
    return {
        "id": name,
        "mass": ball["params"]["m"],
        "radius": ball["params"]["R"],
        "position": position[:2],
        "velocity": velocity[:2],
        "spin": list(spin),
    }


def _pooltool_ball_ball(law: str, balls: abc.Mapping[str, _Document]) -> dict[str, Any]:
    if law == "frictionless_elastic":
        return {"law": "restitution", "restitution": 1}
    if law not in ("frictional_inelastic", "frictional_inelastic_avg"):
        raise ValueError(f"no law of balls like {law!r}")
    restitution = _common(balls, "e_b")
    # Rubbing is limited there by friction times e, here by friction times (1 + e) / 2.
    scale = 2 * restitution / (1 + restitution)
    friction: Any = scale * _common(balls, "u_b")
    if law == "frictional_inelastic":
        # The friction falls with the slip speed [Alciatore, technical proof A.14].
        friction = [scale * 0.009951, scale * 0.108, 1.088]
    return {"law": "frictional", "restitution": restitution, "friction": friction}


def _pooltool_cushion(
    law: str, balls: abc.Mapping[str, _Document], height: float
) -> dict[str, Any]:
    restitution = _common(balls, "e_c")
    if law == "unrealistic_e":
        return {"law": "restitution", "restitution": restitution}
    known = {
        "han_2005": "han_2005",
        "mathavan_2010": "mathavan_2010",
        "impulse_frictional_inelastic": "han_2005",
        "stronge_compliant": "stronge",
    }
    if law not in known:
        raise ValueError(f"no law of cushions like {law!r}")
    if law in ("impulse_frictional_inelastic", "stronge_compliant"):
        # These take the direction to the nose, a radius away from the middle of the ball, for the
        # normal; the others the one from there to the point of contact on the ball. The height at
        # which that is the same:
        radius = _common(balls, "R")
        rise = height - radius
        height = radius + radius * rise / math.hypot(radius, rise)
    return {
        "law": known[law],
        "restitution": restitution,
        "friction": _common(balls, "f_c"),
        "height": height,
    }


def _pooltool_cue(cue: _Document) -> dict[str, Any]:
    specs = cue.get("specs", {})
    return {
        "ball": cue["cue_ball_id"],
        "speed": cue["V0"],
        "azimuth": math.radians(cue["phi"]),
        "elevation": math.radians(cue["theta"]),
        "offset": [cue["a"], cue["b"]],
        "mass": specs.get("M", 0.567),
        "end_mass": specs.get("end_mass", 0),
        # There every offset inside the ball is a strike, and the stick passes through everything.
        "miscue_limit": 1,
        "allow_obstructed": True,
    }


def from_pooltool(
    system: _Document,
    *,
    ball_ball: str = "frictional_inelastic",
    ball_cushion: str = "han_2005",
) -> Scene:
    """The scene of a pooltool System, as it is saved in JSON: cue, table and balls.

    Lengths in m, angles of the cue in degrees, its tip in ball radii. Balls are where they were
    before the shot, if it has been simulated; pocketed ones are left out. A cue that has a speed
    strikes its ball, unless a ball moves.

    The models of impacts are no part of such a file. ball_ball: "frictionless_elastic",
    "frictional_inelastic" or "frictional_inelastic_avg". ball_cushion: "han_2005",
    "mathavan_2010", "stronge_compliant", "impulse_frictional_inelastic" or "unrealistic_e"; at
    jaws the third and the fourth take another height there. Raises ValueError for others, and
    where balls differ in a coefficient that osculo has once; KeyError for what is missing;
    SceneError.
    """
    table, balls = system["table"], system["balls"]
    linear = list(table["cushion_segments"]["linear"].values())
    circular = list(table["cushion_segments"]["circular"].values())
    standing = [_pooltool_ball(name, ball) for name, ball in balls.items()]
    placed = [ball for ball in standing if ball is not None]
    heights = {float(cushion.get("height", cushion["p1"][2])) for cushion in linear}
    if len(heights) > 1:
        raise ValueError(f"cushions must have the same height, but they have {sorted(heights)}")
    moving = any(any(ball["velocity"]) or any(ball["spin"]) for ball in placed)
    cue = system.get("cue", {})
    is_there = any(ball["id"] == cue.get("cue_ball_id") for ball in placed)
    strikes = cue.get("V0", 0) > 0 and is_there and not moving
    radius = _common(balls, "R")
    return Scene(
        motion={
            "law": "cloth",
            "sliding_friction": _common(balls, "u_s"),
            "rolling_friction": _common(balls, "u_r"),
            "spinning_friction": _common(balls, "u_sp_proportionality") * radius,
        },
        gravity=_common(balls, "g"),
        balls=placed,
        segments=[_segment(cushion) for cushion in linear],
        arcs=[
            {"id": f"jaw-{jaw['id']}", "center": jaw["center"][:2], "radius": jaw["radius"]}
            for jaw in circular
        ],
        rims=[
            {
                "id": f"pocket-{pocket['id']}",
                "center": pocket["center"][:2],
                "radius": pocket["radius"],
            }
            for pocket in table.get("pockets", {}).values()
        ],
        impacts={
            "ball_ball": _pooltool_ball_ball(ball_ball, balls),
            "ball_cushion": _pooltool_cushion(ball_cushion, balls, max(heights)),
            "simultaneous": "sequential",
        },
        cue=_pooltool_cue(cue) if strikes else None,
    )


# FastFiz: what its tables, balls and cues are, where nothing else is said.
_FASTFIZ_TABLE = {
    "length": 2.236,
    "width": 1.116,
    "corner_pocket_width": 0.11,
    "side_pocket_width": 0.12,
    "sliding_friction": 0.2,
    "rolling_friction": 0.015,
    "spinning_friction": 0.044,
}
_FASTFIZ_BALL_MASS = 0.16301
_FASTFIZ_BALL_RADIUS = 0.028575
_FASTFIZ_CUE_MASS = 0.6
_FASTFIZ_BALL_FRICTION = 0.01
_FASTFIZ_RAIL_RESTITUTION = 0.9
_FASTFIZ_IN_PLAY = range(1, 5)  # stationary, spinning, sliding, rolling


def _fastfiz_balls(state: str) -> list[dict[str, Any]]:
    words = state.split()
    # A TableState begins with the number of balls; a GameState puts five words before it, and those
    # of the game may follow.
    for start in (0, 5):
        count = int(words[start]) if len(words) > start and words[start].isdigit() else -1
        end = start + 1 + 5 * count
        if count >= 0 and (end == len(words) if start == 0 else end <= len(words)):
            rows = [words[i : i + 5] for i in range(start + 1, end, 5)]
            break
    else:
        raise ValueError("state must be the text of a TableState or a GameState")
    balls: list[dict[str, Any]] = []
    for radius, phase, number, x, y in rows:
        if int(phase) in _FASTFIZ_IN_PLAY:
            name = "cue" if int(number) == 0 else str(int(number))
            balls.append(
                {
                    "id": name,
                    "mass": _FASTFIZ_BALL_MASS,
                    "radius": float(radius),
                    "position": [float(x), float(y)],
                }
            )
    return balls


def _through(left: Any, right: Any, inward: Any, reach: float) -> dict[str, Any]:
    """The circle through two points that reaches so far beyond the line between them."""
    half = math.dist(left, right) / 2
    radius = (half**2 + reach**2) / (2 * reach)
    middle = [(a + b) / 2 for a, b in zip(left, right)]
    return {
        "center": [m - n * (radius - reach) for m, n in zip(middle, inward)],
        "radius": radius,
    }


def _fastfiz_table(table: dict[str, float]) -> dict[str, Any]:
    width, length = table["width"], table["length"]
    corner = table["corner_pocket_width"] / math.sqrt(2)
    side = table["side_pocket_width"] / 2
    middle, diagonal = length / 2, math.sqrt(0.5)
    # The horns of each pocket, and the way from there onto the bed.
    horns = {
        "SW": ([corner, 0], [0, corner], [diagonal, diagonal]),
        "W": ([0, middle - side], [0, middle + side], [1, 0]),
        "NW": ([0, length - corner], [corner, length], [diagonal, -diagonal]),
        "NE": ([width - corner, length], [width, length - corner], [-diagonal, -diagonal]),
        "E": ([width, middle + side], [width, middle - side], [-1, 0]),
        "SE": ([width, corner], [width - corner, 0], [-diagonal, diagonal]),
    }
    # Clockwise around the bed, with it on the left from the far end to the near one.
    names = list(horns)
    rails = ("SW", "NW", "N", "NE", "SE", "S")
    return {
        "segments": [
            {
                "id": f"{rail}-rail",
                "from": horns[names[(i + 1) % 6]][0],
                "to": horns[names[i]][1],
                "side": "left",
            }
            for i, rail in enumerate(rails)
        ],
        "rims": [
            {"id": f"{name}-pocket", **_through(*mouth, _FASTFIZ_BALL_RADIUS)}
            for name, mouth in horns.items()
        ],
    }


def _fastfiz_cue(shot: abc.Mapping[str, float]) -> dict[str, Any]:
    unit = 1000 * _FASTFIZ_BALL_RADIUS  # [mm]
    return {
        "speed": shot["v"],
        "azimuth": math.radians(shot["phi"]),
        "elevation": math.radians(shot["theta"]),
        "offset": [-shot["a"] / unit, shot["b"] / unit],
        "mass": _FASTFIZ_CUE_MASS,
        "end_mass": 0,
        "miscue_limit": 1,
        "allow_obstructed": True,
    }


def from_fastfiz(
    state: str,
    shot: Optional[abc.Mapping[str, float]] = None,
    table: Optional[abc.Mapping[str, float]] = None,
) -> Scene:
    """The scene of a state of FastFiz, as its toString() writes it.

    state: of a TableState or of a GameState; balls in pockets or not in play are left out.
    shot: a, b of the tip to the right and upwards [mm], theta and phi, elevation and azimuth
    [degrees], v [m/s].
    table: what differs from FastFiz's own: length, width, corner_pocket_width, side_pocket_width
    [m], sliding_friction, rolling_friction, spinning_friction.

    Rails are straight and end at the horns of the pockets. FastFiz takes a ball as soon as it
    touches the line between two horns; here a rim does, through the horns and as far as one ball's
    radius in front of that line. Its rails take a tenth of the speed, across and along, and nine
    tenths of the spin; here they take a tenth of the speed across. Raises ValueError, SceneError.
    """
    unknown = set(table or {}) - set(_FASTFIZ_TABLE)
    if unknown:
        raise ValueError(f"a table has no {sorted(unknown)}")
    made = {**_FASTFIZ_TABLE, **(table or {})}
    return Scene(
        motion={
            "law": "cloth",
            **{name: value for name, value in made.items() if name.endswith("friction")},
        },
        balls=_fastfiz_balls(state),
        impacts={
            "ball_ball": {
                "law": "frictional",
                "restitution": 1,
                "friction": _FASTFIZ_BALL_FRICTION,
            },
            "ball_cushion": {"law": "restitution", "restitution": _FASTFIZ_RAIL_RESTITUTION},
            "simultaneous": "sequential",
        },
        cue=_fastfiz_cue(shot) if shot else None,
        closed=True,
        **_fastfiz_table(made),
    )
