"""osculo: the exact, event-driven collision simulator for circular bodies.

    import osculo
    run = osculo.simulate(osculo.preset("break"))
    run.events["time"], run.outcome["falls"], run.at(0.5)["position"]

SI units and radians throughout. Same scene and version: same bits.
"""

import os

from ._errors import FormatError, SceneError
from ._osculo import (
    EVENT_KINDS,
    FATES,
    PHASES,
    SHOT_FATES,
    SHOT_STATUSES,
    Batch,
    Run,
    Scene,
    Simulation,
    __version__,
    parse,
    parse_msgpack,
    perturb,
    preset,
    presets,
    simulate,
    simulate_batch,
    table,
    tournament_noise,
)

__all__ = [
    "EVENT_KINDS",
    "FATES",
    "PHASES",
    "SHOT_FATES",
    "SHOT_STATUSES",
    "Batch",
    "FormatError",
    "Run",
    "Scene",
    "SceneError",
    "Simulation",
    "load",
    "parse",
    "parse_msgpack",
    "perturb",
    "preset",
    "presets",
    "simulate",
    "simulate_batch",
    "table",
    "tournament_noise",
]


def load(path: "str | os.PathLike[str]") -> "Scene | Run":
    """The scene or the run in a file (.json, .msgpack). Raises OSError, SceneError, FormatError."""
    with open(path, "rb") as file:
        content = file.read()
    if os.fspath(path).endswith(".msgpack"):
        return parse_msgpack(content)
    return parse(content.decode())
