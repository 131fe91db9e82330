"""Which machines a :class:`laval.Sweep` computes: grids, points that fill a space evenly, lists.

    >>> laval.designs.grid({"drum.mass": ["2 kg", "2.5 kg", "3 kg"], "losses.damping": laval.span(20.0, 60.0, points=5)})
    >>> laval.designs.sobol({"drum.mass": {"distribution": "normal", "deviation": "2 %"}}, cases=1024)

Every design is a function of the number of the case alone: it does not depend on how cases are divided.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from laval import _native
from laval._quantities import written

if TYPE_CHECKING:
    import numpy as np

__all__ = ["Design", "grid", "latin_hypercube", "random", "sobol", "table"]


class Design:
    """Cases of a machine, made by the functions of this module."""

    __slots__ = ("_data", "_units", "_values", "cases", "parameters")

    cases: int
    """Number of cases."""
    parameters: tuple[str, ...]
    """Paths of the parameters that vary."""

    def __init__(
        self,
        data: dict[str, Any],
        parameters: Iterable[str],
        cases: int,
        units: Mapping[str, str] | None = None,
        values: np.ndarray[Any, Any] | None = None,
    ) -> None:
        self._data = data
        self._units = dict(units or {})
        self._values = values
        self.cases = cases
        self.parameters = tuple(parameters)

    def _written(self, chunk: int) -> dict[str, Any]:
        """As the folder of the cases holds it."""
        if self._values is None:
            return self._data
        blocks = (self._values[first : first + chunk] for first in range(0, self.cases, chunk))
        return {**self._data, "sums": [hashlib.sha256(block.tobytes()).hexdigest() for block in blocks]}

    def _check(self, known: Mapping[str, str]) -> None:
        """Units that were given are those of the parameters."""
        for path, unit in self._units.items():
            own = known.get(path, known.get(path + ".x"))
            # a path that does not exist is reported with those that are near
            if own is not None and _native.si(f"1 {own}".strip())[1] != unit:
                raise ValueError(f"{path} is in {own or 'no unit'}, not in {unit or 'no unit'}")

    def __repr__(self) -> str:
        return f"<laval.designs: {self._data['kind']} of {self.cases} cases over {', '.join(self.parameters)}>"


def _numbers(path: str, values: Any) -> tuple[np.ndarray[Any, Any], str | None]:
    """Values in SI units, and the unit that they were given in, in SI."""
    import numpy as np

    if isinstance(values, Mapping):
        if set(values) != {"from", "to", "points"}:
            raise ValueError(f"{path}: give a list of values, or laval.span(.., .., points=..)")
        ends, unit = _numbers(path, [values["from"], values["to"]])
        return np.linspace(ends[0], ends[1], int(values["points"])), unit
    plain = written(values)
    if not isinstance(plain, list):
        plain = [plain]
    if not any(isinstance(x, str) for x in plain):
        return np.ascontiguousarray(plain, dtype="<f8"), None
    read = [_native.si(x) if isinstance(x, str) else (float(x), None) for x in plain]
    units = {unit for _, unit in read if unit is not None}
    if len(units) > 1:
        raise ValueError(f"{path}: values in {' and in '.join(sorted(units))}")
    return np.array([x for x, _ in read], dtype="<f8"), units.pop()


def grid(axes: Mapping[str, Any]) -> Design:
    """Every combination of the values of the axes; those of the last axis follow each other.

    Args:
        axes: by path of the parameter a list of values, or ``laval.span(first, last, points=n)``.
    """
    read = {path: _numbers(path, values) for path, values in axes.items()}
    cases = 1
    for path, (values, _) in read.items():
        if not all(map(math.isfinite, values)):
            raise ValueError(f"{path}: every value of a grid is a finite number")
        cases *= len(values)
    units = {path: unit for path, (_, unit) in read.items() if unit is not None}
    data = {"kind": "grid", "axes": [[path, values.tolist()] for path, (values, _) in read.items()]}
    return Design(data, read, cases, units)


def _spread(kind: str, parameters: Mapping[str, Any], cases: int, seed: int) -> Design:
    def one(path: str, given: Any) -> dict[str, Any]:
        plain = written(given)
        if isinstance(plain, list) and len(plain) == 2:
            plain = {"from": plain[0], "to": plain[1]}
        if not isinstance(plain, dict):
            raise TypeError(f"{path}: give laval.span(from, to) or a distribution, such as {{'distribution': 'normal', 'deviation': '2 %'}}")
        return {"parameter": path, "distribution": "uniform", **plain}

    if isinstance(cases, bool) or not isinstance(cases, int) or cases < 1:
        raise ValueError(f"the number of cases is a whole number from 1 on, not {cases!r}")
    listed = [one(path, given) for path, given in parameters.items()]
    return Design({"kind": kind, "cases": cases, "seed": int(seed), "parameters": listed}, parameters, cases)


def sobol(parameters: Mapping[str, Any], cases: int, seed: int = 1) -> Design:
    """Points of a scrambled Sobol sequence, which fill the space evenly; best with a power of two. Behind 65536 points another scrambling follows.

    Args:
        parameters: by path ``laval.span(from, to)``, or a distribution as in the study `uncertainty`: ``{"distribution": "normal", "deviation": "2 %"}``.
        cases: number of points.
        seed: another one gives other points.
    """
    return _spread("sobol", parameters, cases, seed)


def latin_hypercube(parameters: Mapping[str, Any], cases: int, seed: int = 1) -> Design:
    """A Latin hypercube: for each parameter, one point in each of ``cases`` equally probable intervals.

    Args:
        parameters: as for :func:`sobol`.
        cases: number of points.
        seed: another one gives other points.
    """
    return _spread("latin_hypercube", parameters, cases, seed)


def random(parameters: Mapping[str, Any], cases: int, seed: int = 1) -> Design:
    """Independent random points.

    Args:
        parameters: as for :func:`sobol`.
        cases: number of points.
        seed: another one gives other points.
    """
    return _spread("random", parameters, cases, seed)


def table(columns: Any) -> Design:
    """One case for each row of a table.

    Args:
        columns: a dictionary of arrays, a data frame of polars or pandas, or any table of Arrow; the names of the columns are paths of parameters,
            numbers are in SI units.
    """
    import numpy as np

    read = {path: _numbers(path, values) for path, values in _columns(columns).items()}
    lengths = {len(values) for values, _ in read.values()}
    if len(lengths) != 1:
        raise ValueError("a table needs columns, all of one length")
    units = {path: unit for path, (_, unit) in read.items() if unit is not None}
    cases = lengths.pop()
    values = np.empty((cases, len(read)), dtype="<f8")
    for k, (column, _) in enumerate(read.values()):
        values[:, k] = column
    return Design({"kind": "list", "parameters": list(read), "cases": cases}, read, cases, units, values)


def _columns(given: Any) -> dict[str, Any]:
    import numpy as np

    def plain(column: Any) -> Any:
        array = np.asarray(column)
        # texts with units, and whatever else is no number, are read one by one
        return array.astype("<f8") if array.dtype.kind in "fiu" else list(column)

    if isinstance(given, Mapping):
        return {str(name): values if isinstance(values, Mapping) else plain(values) for name, values in given.items()}
    if hasattr(given, "columns") and hasattr(given, "shape") and not hasattr(given, "column_names"):
        return {str(name): plain(given[name].to_numpy()) for name in given.columns}
    if hasattr(given, "__arrow_c_stream__"):
        import pyarrow

        found = pyarrow.table(given)
        return {name: plain(found.column(name).to_numpy()) for name in found.column_names}
    raise TypeError(f"a {type(given).__name__} is no table: give a dictionary of arrays, a data frame or a table of Arrow")
