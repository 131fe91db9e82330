"""The functions of `laval.parts`, `laval.studies` and `laval.blocks`, made from what the registries of the library declare."""

from __future__ import annotations

import json
import keyword
from collections.abc import Callable
from functools import cache
from typing import Any

from laval import _native
from laval._blocks import Block, Extra, Part, Study


@cache
def catalog() -> dict[str, Any]:
    """All kinds with their keys."""
    found: dict[str, Any] = json.loads(_native.catalog())
    return found


def argument(name: str) -> str:
    """A key of the file as an argument of Python: ``in`` is ``in_``."""
    return name + "_" if keyword.iskeyword(name) else name


@cache
def kinds(module: str) -> dict[str, tuple[str, dict[str, Any]]]:
    """By the name of their function: the word of the block and the kind, for `parts`, `studies` or `blocks`."""
    if module == "blocks":
        listed = [(block["word"], kind) for block in catalog()["blocks"] for kind in block["kinds"]]
    else:
        word = {"parts": "part", "studies": "study"}[module]
        listed = [(word, kind) for kind in catalog()[module]]
    return {argument(kind["kind"]): (word, kind) for word, kind in listed}


def named(module: str, word: str) -> bool:
    """Blocks of this word have names: there may be several."""
    return module != "blocks" or any(block["word"] == word and block["several"] for block in catalog()["blocks"])


def ordered(kind: dict[str, Any]) -> list[dict[str, Any]]:
    """The keys of a kind, those that are required first."""
    return sorted(kind["fields"], key=lambda field: not field["required"])


def documentation(module: str, kind: dict[str, Any]) -> str:
    """What the function does and takes."""
    lines = [kind["doc"], "", "Args:"]
    if named(module, kind.get("word", "")):
        lines.append("    name: by which others refer to it.")
    for field in ordered(kind):
        presence = "required" if field["required"] else f"default {field['default']}" if field["default"] else "optional"
        lines.append(f"    {argument(field['name'])}: {field['doc']} ({presence}).")
        lines.append(f"        {field['takes']}")
    lines += ["", "In a machine file::", ""]
    lines += [f"    {line}".rstrip() for line in kind["example"].splitlines()]
    return "\n".join(lines)


def function(module: str, name: str) -> Callable[..., Block]:
    """The function that makes a block of this kind.

    Raises:
        AttributeError: there is no such kind.
    """
    try:
        word, kind = kinds(module)[name]
    except KeyError:
        from difflib import get_close_matches

        near = get_close_matches(name, kinds(module), 1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise AttributeError(f"module 'laval.{module}' has no attribute {name!r}{hint}") from None
    made = {"parts": Part, "studies": Study, "blocks": Extra}[module]
    keys = {argument(field["name"]): field["name"] for field in ordered(kind)}
    required = [argument(field["name"]) for field in kind["fields"] if field["required"]]
    own_name = named(module, word)

    def make(**values: Any) -> Block:
        # a wrong or missing argument is a TypeError as of any function
        given = signature().bind(**values).arguments
        label = given.pop("name", None)
        return made(word, kind["kind"], label, {keys[key]: value for key, value in given.items() if value is not None})

    @cache
    def signature() -> Any:
        from inspect import Parameter, Signature

        names = [*(["name"] if own_name and "name" not in keys else []), *keys]
        empty = Parameter.empty
        parameters = [
            Parameter(key, Parameter.KEYWORD_ONLY, default=empty if key in required else None) for key in names
        ]
        return Signature(parameters)

    make.__name__ = make.__qualname__ = name
    make.__module__ = f"laval.{module}"
    make.__doc__ = documentation(module, {**kind, "word": word})
    make.__signature__ = signature()  # type: ignore[attr-defined]
    return make
