"""What is wrong: all mistakes of a machine in one exception, each at its place."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from laval._results import Results


class Diagnostic(NamedTuple):
    """One thing that is wrong, or doubtful, in a machine file."""

    code: str
    """Stable machine-readable code, such as ``unit.dimension``."""
    severity: str
    """``error`` or ``warning``."""
    message: str
    """One sentence."""
    line: int | None
    """Line in the text of the machine, from 1."""
    column: int | None
    """Column there, in characters, from 1."""
    end_line: int | None
    end_column: int | None
    label: str | None
    """What the marked place is."""
    help: str | None
    """What to do about it."""
    also: tuple[tuple[int, int], ...]
    """Line and column of other places where the same is wrong."""

    def __str__(self) -> str:
        place = "" if self.line is None else f"line {self.line}, column {self.column}: "
        return f"{place}{self.message}" + (f" ({self.help})" if self.help else "")


def diagnostics(text: str) -> tuple[Diagnostic, ...]:
    """From the JSON of the native half."""

    def one(d: dict[str, Any]) -> Diagnostic:
        place = d["place"] or {}
        line, column, end_line, end_column = (place.get(key) for key in ("line", "column", "end_line", "end_column"))
        also = tuple((p["line"], p["column"]) for p in d["also"])
        return Diagnostic(d["code"], d["severity"], d["message"], line, column, end_line, end_column, d["label"], d["help"], also)

    return tuple(one(d) for d in json.loads(text))


class MachineError(ValueError):
    """All mistakes of a machine, in the order of their places."""

    def __init__(self, message: str, found: str = "[]") -> None:
        super().__init__(message, found)
        self._message = message
        self.diagnostics: tuple[Diagnostic, ...] = diagnostics(found)
        """The mistakes: code, message, line, column and help of each."""

    def __str__(self) -> str:
        return self._message


class MachineWarning(UserWarning):
    """A study that the machine cannot answer, or a remark on a run."""


class Interrupted(KeyboardInterrupt):
    """A run was stopped by Ctrl-C; ``results`` holds what was done before."""

    def __init__(self, results: Results) -> None:
        super().__init__("the run was stopped; .results of this exception holds what was done before")
        self.results = results
        """What was done before the stop."""
