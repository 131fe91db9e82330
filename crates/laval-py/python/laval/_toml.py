"""A machine as the text of a machine file."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _key(key: str) -> str:
    return key if _BARE.fullmatch(key) else _text(key)


def _text(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def value(x: Any) -> str:
    """A value in one line."""
    if isinstance(x, str):
        return _text(x)
    if isinstance(x, bool):
        return "true" if x else "false"
    if isinstance(x, (int, float)):
        return repr(x)
    if isinstance(x, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {value(v)}" for k, v in x.items()) + " }" if x else "{}"
    return "[" + ", ".join(value(v) for v in x) + "]"


def _block(header: str, block: Mapping[str, Any]) -> str:
    return header + "\n" + "".join(f"{_key(k)} = {value(v)}\n" for k, v in block.items())


def document(tree: Mapping[str, Any]) -> str:
    """The text of a machine file: the machine, its parts, blocks beside them, studies."""
    rest = [word for word in tree if word not in ("machine", "part", "study")]
    out = []
    for word in ["machine", "part", *rest, "study"]:
        found = tree.get(word)
        if isinstance(found, Mapping):
            out.append(_block(f"[{word}]", found))
        elif found:
            out += [_block(f"[[{word}]]", block) for block in found]
    return "\n".join(out)
