"""Changes of a machine in the form of its file: dictionaries and lists."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from typing import Any

from laval._blocks import Block, Extra
from laval._registry import kinds, named


def add(tree: dict[str, Any], blocks: Iterable[Block]) -> None:
    """Adds blocks; one with the name of another of its word replaces it."""
    for block in blocks:
        if not isinstance(block, Block):
            raise TypeError(f"{block!r} is no part, study or block of a machine")
        entries = block._entries()
        if isinstance(block, Extra) and not named("blocks", block.word):
            tree[block.word] = entries
            continue
        there = tree.setdefault(block.word, [])
        same = [k for k, other in enumerate(there) if block.name is not None and other.get("name") == block.name]
        if same:
            there[same[0]] = entries
        else:
            there.append(entries)


def _places(tree: dict[str, Any]) -> dict[str, tuple[str, dict[str, Any]]]:
    """What a path may begin with: word and content of each block."""
    found: dict[str, tuple[str, dict[str, Any]]] = {"machine": ("machine", tree.setdefault("machine", {}))}
    for word, content in tree.items():
        if isinstance(content, list):
            found.update({block["name"]: (word, block) for block in content if "name" in block})
        elif word != "machine":
            found.setdefault(word, (word, content))
    return found


def set_value(tree: dict[str, Any], path: str, value: Any) -> None:
    """Sets the value at a path; ``None`` takes it away."""
    places = _places(tree)
    heads = [name for name in places if path.startswith(name + ".")]
    if not heads:
        near = get_close_matches(path.split(".")[0], places, 1)
        hint = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(places)}"
        raise KeyError(f"{path!r} begins with no name of this machine; {hint}")
    head = max(heads, key=len)
    word, block = places[head]
    keys = path[len(head) + 1 :].split(".")
    module = {"part": "parts", "study": "studies"}.get(word, "blocks")
    kind = next((kind for w, kind in kinds(module).values() if w == word and kind["kind"] == block.get("kind", word)), None)
    fields = kind["fields"] if kind else []
    if len(keys) == 1 and not any(field["name"] == keys[0] for field in fields):
        # `oil.volume` is one of several ways to give `oil.fill`
        keys = next(([field["name"], keys[0]] for field in fields if field["type"] == "one_of" and keys[0] in field["words"]), keys)
    field = next((field for field in fields if field["name"] == keys[0]), None)
    _set(block, keys, value, field["type"] if field else "")


def _set(block: dict[str, Any], keys: list[str], value: Any, kind: str) -> None:
    for key in keys[:-1]:
        inner = block[key] = _inner(block.get(key), kind)
        block = inner
    if value is None:
        block.pop(keys[-1], None)
    else:
        block[keys[-1]] = value


def _inner(there: Any, kind: str) -> dict[str, Any]:
    """What a key holds, as a table in which another key can be set."""
    if kind == "one_of":
        return {}
    if isinstance(there, dict):
        return there
    return {"x": there, "y": there} if kind == "lateral" and there is not None else {}
