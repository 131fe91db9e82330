"""Tables of results, shared without copies with NumPy and with whatever takes Arrow."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from laval import _native

if TYPE_CHECKING:
    import numpy as np
    import pandas
    import polars
    import pyarrow


class Table(Mapping[str, Any]):
    """Named columns of one length, in SI units: a mapping from names to NumPy arrays.

    Arrays of numbers and flags are views of the memory of the result, and read-only. NaN stands for "no value". The table is a stream of the
    Arrow C interface, which polars, pandas, pyarrow, DuckDB and others take: ``polars.DataFrame(table)``.
    """

    __slots__ = ("_core",)

    def __init__(self, native: _native.Table) -> None:
        self._core = native

    @property
    def name(self) -> str:
        """Name of the table."""
        return self._core.name

    @property
    def doc(self) -> str:
        """What it holds."""
        return self._core.doc

    @property
    def rows(self) -> int:
        """Number of rows."""
        return self._core.rows

    @property
    def units(self) -> dict[str, str]:
        """SI units of the columns; empty for pure numbers, texts and flags."""
        return {name: self._core.column(name).unit for name in self._core.names}

    @property
    def docs(self) -> dict[str, str]:
        """What the columns hold."""
        return {name: self._core.column(name).doc for name in self._core.names}

    def __getitem__(self, name: str) -> np.ndarray[Any, Any]:
        import numpy as np

        column = self._core.column(name)
        if column.kind == "text":
            out = np.empty(len(column), dtype=object)
            out[:] = column.to_list()
            return out
        return np.asarray(column)

    def __iter__(self) -> Iterator[str]:
        return iter(self._core.names)

    def __len__(self) -> int:
        """Number of columns."""
        return len(self._core.names)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self._core.__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        return self._core.__arrow_c_schema__()

    def polars(self) -> polars.DataFrame:
        """The table as a data frame of polars, over the same memory."""
        import polars

        return polars.DataFrame(self)

    def pyarrow(self) -> pyarrow.Table:
        """The table as one of pyarrow, over the same memory; units and meanings are metadata of its columns."""
        import pyarrow

        return pyarrow.table(self)

    def pandas(self) -> pandas.DataFrame:
        """The table as a data frame of pandas."""
        import pandas

        return pandas.DataFrame(dict(self), copy=False)

    def __eq__(self, other: object) -> bool:
        """The same columns with the same values, NaN being equal to NaN."""
        if not isinstance(other, Table):
            return NotImplemented
        import numpy as np

        if (self.name, self.units) != (other.name, other.units):
            return False
        pairs = ((self[name], other[name]) for name in self)
        return all(np.array_equal(a, b, equal_nan=a.dtype.kind == "f" == b.dtype.kind) for a, b in pairs)

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        def values(column: _native.Column) -> Any:
            return column.to_list() if column.kind == "text" else self[column.name]

        columns = [self._core.column(name) for name in self._core.names]
        return _table, (self.name, self.doc, [(c.name, c.unit, c.doc, c.kind, values(c)) for c in columns])

    def __repr__(self) -> str:
        columns = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in self.units.items())
        return f"<laval.Table {self.name!r}, {self.rows} rows: {columns}>"

    def _repr_html_(self) -> str:
        """The first rows, for notebooks."""
        from html import escape

        most = 10
        heads = "".join(f"<th>{escape(name)}<br><small>{escape(unit)}</small></th>" for name, unit in self.units.items())
        columns = [self._core.column(name) for name in self._core.names]
        shown = range(min(most, self.rows))
        rows = "".join("<tr>" + "".join(f"<td>{_cell(column[k])}</td>" for column in columns) + "</tr>" for k in shown)
        more = f"<p>{self.rows - most} more rows</p>" if self.rows > most else ""
        return f"<table><caption>{escape(self.doc)}</caption><thead><tr>{heads}</tr></thead><tbody>{rows}</tbody></table>{more}"


def _cell(value: Any) -> str:
    from html import escape

    return f"{value:.6g}" if isinstance(value, float) else escape(str(value))


def _table(name: str, doc: str, columns: list[tuple[str, str, str, str, Any]]) -> Table:
    return Table(_native.Table(name, doc, columns))
