"""Parts, studies and blocks beside them, before they are in a machine."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from laval import _toml
from laval._quantities import written


class Block:
    """One block of a machine: its kind, its name and its values as they were given."""

    __slots__ = ("_values", "kind", "name", "word")

    _values: dict[str, Any]
    kind: str
    """The word of its kind."""
    name: str | None
    """Its name; a machine gives one to a block that has none."""
    word: str
    """The word in the brackets of the file: ``part``, ``study``, ``limits``."""

    def __init__(self, word: str, kind: str, name: str | None, values: Mapping[str, Any]) -> None:
        object.__setattr__(self, "word", word)
        object.__setattr__(self, "kind", kind)
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "_values", {key: written(value) for key, value in values.items()})

    @property
    def values(self) -> dict[str, Any]:
        """The values given, as a machine file writes them."""
        return dict(self._values)

    def _entries(self) -> dict[str, Any]:
        """What stands in the block."""
        head = {"kind": self.kind} if self.kind != self.word else {}
        return {**head, **({"name": self.name} if self.name is not None else {}), **self._values}

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError("a block does not change; make another one")

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.word, self.kind, self.name, self._values)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Block):
            return NotImplemented
        return (self.word, self._entries()) == (other.word, other._entries())

    def __hash__(self) -> int:
        return hash((self.word, self.kind, self.name, _toml.value(self._values)))

    def __repr__(self) -> str:
        given = {**({"name": self.name} if self.name is not None else {}), **self._values}
        return f"{self.kind}({', '.join(f'{key}={value!r}' for key, value in given.items())})"


class Part(Block):
    """An element of a machine, made by a function of :mod:`laval.parts`. Where a point of a body is wanted, the body may be given itself."""

    __slots__ = ()

    def _inline(self) -> str:
        if self.name is None:
            raise ValueError(f"give the {self.kind} a name, so that others can refer to it")
        return self.name


class Study(Block):
    """An analysis of a machine, made by a function of :mod:`laval.studies`."""

    __slots__ = ()

    def _inline(self) -> dict[str, Any]:
        return {"kind": self.kind, **self._values}


class Extra(Block):
    """What stands beside the parts of a machine, made by a function of :mod:`laval.blocks`."""

    __slots__ = ()
