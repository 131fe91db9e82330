"""Functions made from the registries: all kinds, signatures, documentation, stubs."""

from __future__ import annotations

import inspect
import json
import subprocess
import sys
from pathlib import Path

import pytest

import laval
from laval import _native, _registry

HERE = Path(__file__).parents[1]
KINDS = [(module, name) for module in ("parts", "studies", "blocks") for name in _registry.kinds(module)]


def test_every_kind_of_the_registry_has_a_function() -> None:
    declared = json.loads(_native.catalog())
    assert {kind["kind"] for kind in declared["parts"]} == set(dir(laval.parts))
    assert {kind["kind"] for kind in declared["studies"]} == set(dir(laval.studies))
    assert {kind["kind"] for block in declared["blocks"] for kind in block["kinds"]} == set(dir(laval.blocks))
    # no two blocks have a kind of one name
    assert sum(len(block["kinds"]) for block in declared["blocks"]) == len(dir(laval.blocks))


@pytest.mark.parametrize(("module", "name"), KINDS)
def test_signature_and_documentation(module: str, name: str) -> None:
    function = getattr(getattr(laval, module), name)
    word, kind = _registry.kinds(module)[name]
    parameters = dict(inspect.signature(function).parameters)
    if _registry.named(module, word):
        assert parameters.pop("name").default is None
    for field in kind["fields"]:
        parameter = parameters.pop(_registry.argument(field["name"]))
        assert (parameter.default is inspect.Parameter.empty) == field["required"]
        assert field["doc"] in (function.__doc__ or "")
    assert not parameters
    assert function.__name__ == name and function.__module__ == f"laval.{module}"


@pytest.mark.parametrize(("module", "name"), [k for k in KINDS if k[0] != "blocks"])
def test_the_example_of_the_file_gives_the_same_block(module: str, name: str) -> None:
    tomllib = pytest.importorskip("tomllib")
    word, kind = _registry.kinds(module)[name]
    (given,) = tomllib.loads(kind["example"])[word]
    values = {_registry.argument(key): value for key, value in given.items() if key != "kind"}
    block = getattr(getattr(laval, module), name)(**values)
    assert block._entries() == given


def test_what_does_not_exist() -> None:
    with pytest.raises(AttributeError, match="did you mean 'damper'"):
        laval.parts.dampr
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        laval.nothing
    assert "in_" in inspect.signature(laval.parts.liquid).parameters


def test_blocks_are_values() -> None:
    disc = laval.parts.disc(name="disc", mass=1)
    assert disc == laval.parts.disc(name="disc", mass=1) and hash(disc) == hash(laval.parts.disc(name="disc", mass=1))
    assert disc != laval.parts.disc(name="disc", mass=2) and disc.values == {"mass": 1}
    assert repr(disc) == "disc(name='disc', mass=1)"
    with pytest.raises(AttributeError, match="does not change"):
        disc.name = "other"
    with pytest.raises(ValueError, match="give the disc a name"):
        laval.parts.damper(between=(laval.parts.disc(mass=1), "ground"), damping=1)


def test_stubs_are_current() -> None:
    done = subprocess.run([sys.executable, HERE / "stubs.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_reference_is_current() -> None:
    done = subprocess.run([sys.executable, HERE / "reference.py", "--check"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_machine_has_the_keys_of_the_file() -> None:
    declared = {field["name"] for field in json.loads(_native.catalog())["machine"]["fields"]}
    assert declared == set(inspect.signature(laval.Machine).parameters) - {"parts", "studies", "blocks"}


def test_types_agree_with_the_package() -> None:
    pytest.importorskip("mypy")
    allowed = HERE / "tests" / "stubtest-allowed.txt"
    run = [sys.executable, "-m", "mypy.stubtest", "laval", "--allowlist", str(allowed), "--mypy-config-file", "pyproject.toml"]
    done = subprocess.run(run, capture_output=True, text=True, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr
