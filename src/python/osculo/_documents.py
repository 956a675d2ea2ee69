"""Scenes on their way from Python's own objects to the reader of scene files."""

import json
import math
from collections import abc
from typing import Any

__all__ = ["as_json"]


def _plain(value: Any) -> Any:
    """The value with what JSON knows only: numpy's arrays as lists, mappings as objects. Numbers
    that are not finite become texts, which the reader refuses with their path."""
    if isinstance(value, abc.Mapping):
        return {key: _plain(member) for key, member in value.items()}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [_plain(element) for element in value]
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    return value


def as_json(source: Any, members: abc.Mapping[str, Any]) -> str:
    """The text of a scene file: `source` (a mapping, a JSON text or nothing) with these members in
    place of its own, and without those that are None."""
    if isinstance(source, str):
        text: str = source
        if not members:
            return text
        try:
            source = json.loads(source)
        except ValueError:
            return text  # for the reader to say what is wrong
    document = {"schema": "osculo/scene-1", **({} if source is None else source), **members}
    return json.dumps(_plain({key: value for key, value in document.items() if value is not None}))
