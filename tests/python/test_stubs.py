"""The stubs have the arguments of the functions: stubtest cannot see those of compiled ones."""

import ast
import inspect
from pathlib import Path

import pytest

import osculo
from osculo import _osculo


def stub_functions():
    tree = ast.parse(Path(_osculo.__file__).with_name("_osculo.pyi").read_text())
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            yield node.name, node
        if isinstance(node, ast.ClassDef):
            for member in node.body:
                if isinstance(member, ast.FunctionDef) and not member.decorator_list:
                    yield f"{node.name}.{member.name}", member


def documented(function):
    """The arguments, and those with defaults, in the signature that pybind11 writes."""
    line = function.__doc__.strip().splitlines()[0]
    arguments = ast.parse("def " + _plain(line) + ": ...").body[0].args
    return arguments


def _plain(line):
    """The signature with every annotation and default that Python could not parse taken out."""
    name, rest = line.split("(", 1)
    depth, parts, part = 0, [], ""
    for character in rest:
        if character == ")" and depth == 0:
            break
        depth += (character in "([{<") - (character in ")]}>")
        if character == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += character
    parts.append(part)
    plain = []
    for part in filter(None, map(str.strip, parts)):
        argument = part.split(":")[0].split("=")[0].strip()
        plain.append(argument + ("=0" if "=" in part else ""))
    return f"{name}({', '.join(plain)})"


def shape(arguments):
    required = len(arguments.args) - len(arguments.defaults)
    return (
        [argument.arg for argument in arguments.args if argument.arg not in ("self", "arg0")],
        required,
        [argument.arg for argument in arguments.kwonlyargs],
        [default is not None for default in arguments.kw_defaults],
        arguments.kwarg is not None,
    )


@pytest.mark.parametrize(("name", "node"), list(stub_functions()), ids=lambda x: str(x))
def test_arguments(name, node):
    if name.split(".")[-1] in ("__eq__", "__hash__", "__len__", "__getstate__", "__setstate__"):
        pytest.skip("pybind11 gives their arguments no names")
    function = _osculo
    for part in name.split("."):
        function = getattr(function, part)
    assert shape(documented(function)) == shape(node.args), function.__doc__


def test_everything_public_is_documented():
    for name in osculo.__all__:
        thing = getattr(osculo, name)
        if not callable(thing):
            continue
        assert inspect.getdoc(thing), name
        for member, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_"):
                text = inspect.getdoc(value) or ""
                # The signature alone is no documentation.
                assert "\n" in text or isinstance(value, property) and text, f"{name}.{member}"
