"""Figures as series of numbers: what matplotlib and plotly draw."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import numpy as np

    from laval._tables import Table

    Array = np.ndarray[Any, Any]


class Series(NamedTuple):
    """A curve, or markers."""

    kind: str
    """``line`` or ``points``."""
    x: Array
    y: Array
    name: str
    """Name in the legend; empty for none."""
    colour: int | None
    """Number of its colour; ``None`` is grey."""
    dashed: bool
    """A dashed curve, or open markers."""


class Grid(NamedTuple):
    """A heat map."""

    x: Array
    y: Array
    z: Array
    """By y, then x; NaN where there is no cell."""
    label: str
    classes: tuple[str, ...]
    """Names of the whole numbers that ``z`` holds; empty where it holds values."""
    diverging: bool


def label(axis: Mapping[str, Any]) -> str:
    """Name and unit of an axis."""
    return f"{axis['label']} [{axis['unit']}]" if axis["unit"] else str(axis["label"])


def _groups(table: Table, column: str | None) -> list[tuple[str, Array]]:
    """Values of a column in the order in which they come, and the rows of each."""
    import numpy as np

    if column is None:
        return [("", np.arange(table.rows))]
    values = table[column]
    seen = dict.fromkeys(values.tolist())
    return [(str(value), np.flatnonzero(values == value)) for value in seen]


def _pieces(flags: Array, begins: Array) -> list[tuple[int, int, bool]]:
    """First row, last row and solidity of the pieces of a curve: solid where the flag holds at both ends."""
    out: list[tuple[int, int, bool]] = []
    for k in range(len(flags) - 1):
        if begins[k + 1]:
            continue
        solid = bool(flags[k] and flags[k + 1])
        if out and out[-1][1] == k and out[-1][2] == solid:
            out[-1] = (out[-1][0], k + 1, solid)
        else:
            out.append((k, k + 1, solid))
    return out


def _joined(x: Array, y: Array, pieces: list[tuple[int, int, bool]], solid: bool) -> tuple[Array, Array]:
    """The pieces of one solidity, with gaps between them."""
    import numpy as np

    gap = np.array([np.nan])
    parts = [(np.append(x[a : b + 1], gap), np.append(y[a : b + 1], gap)) for a, b, s in pieces if s == solid]
    if not parts:
        return np.empty(0), np.empty(0)
    return np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])


def lines(mark: Mapping[str, Any], tables: Mapping[str, Table], fx: float, fy: float) -> list[Series]:
    """The curves of a mark, in the units of the axes."""
    import numpy as np

    table = tables[mark["table"]]
    out = []
    classes = [name for name, _ in _groups(table, mark["class"])] if mark["class"] else []
    for number, (name, rows) in enumerate(_groups(table, mark["group"])):
        x, y = table[mark["x"]][rows] * fx, table[mark["y"]][rows].astype(float)
        if mark["wrapped"]:
            y = (y + np.pi) % (2 * np.pi) - np.pi
        y = y * fy
        flags = table[mark["solid_where"]][rows] if mark["solid_where"] else np.ones(len(rows), dtype=bool)
        begins = table[mark["begins_where"]][rows] if mark["begins_where"] else np.zeros(len(rows), dtype=bool)
        kind = str(table[mark["class"]][rows][0]) if mark["class"] and len(rows) else name
        shown = mark["called"].get(kind) or mark["called"].get(name) or mark["name"] or kind.replace("_", " ")
        muted = kind in mark["muted"] or mark["reference"]
        colour = None if muted else classes.index(kind) if classes else number
        pieces = _pieces(flags, begins)
        for solid in (True, False):
            px, py = _joined(x, y, pieces, solid)
            if len(px) and not (mark["solid_only"] and not solid):
                out.append(Series("line", px, py, shown, colour, not solid))
    return out


def points(mark: Mapping[str, Any], tables: Mapping[str, Table], fx: float, fy: float) -> list[Series]:
    """The markers of a mark, in the units of the axes."""
    import numpy as np

    table = tables[mark["table"]]
    out = []
    for number, (name, rows) in enumerate(_groups(table, mark["group"])):
        x, y = table[mark["x"]][rows] * fx, table[mark["y"]][rows] * fy
        filled = table[mark["filled_where"]][rows] if mark["filled_where"] else np.ones(len(rows), dtype=bool)
        shown = mark["name"] or name.replace("_", " ")
        for full in (True, False):
            chosen = filled == full
            if chosen.any():
                out.append(Series("points", x[chosen], y[chosen], shown, None if name in mark["muted"] else number, not full))
    return out


def grid(mark: Mapping[str, Any], tables: Mapping[str, Table], fx: float, fy: float) -> Grid:
    """A heat map, in the units of the axes."""
    import numpy as np

    table = tables[mark["table"]]
    xs, i = np.unique(table[mark["x"]], return_inverse=True)
    ys, j = np.unique(table[mark["y"]], return_inverse=True)
    z = np.full((len(ys), len(xs)), np.nan)
    classes = mark["classes"]
    values = table[mark["value"]]
    if classes:
        number = {name: float(k) for k, name in enumerate(classes)}
        z[j, i] = [number.get(value, np.nan) for value in values]
    else:
        z[j, i] = values * mark["colours"]["factor"]
    names = tuple(mark["called"].get(name, name.replace("_", " ")) for name in classes)
    return Grid(xs * fx, ys * fy, z, label(mark["colours"]), names, mark["diverging"])
