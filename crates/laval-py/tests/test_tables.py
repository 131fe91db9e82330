"""Tables: the same memory in Python, Arrow, polars, pandas."""

from __future__ import annotations

import copy
import gc
import pickle

import numpy as np
import pytest

import laval
from laval import _native


@pytest.fixture
def table(rotor: laval.Machine) -> laval.Table:
    return rotor.run(only="modes")["modes"].tables["modes"]


def big(rows: int = 100_000) -> laval.Table:
    values = np.random.default_rng(1).normal(size=rows)
    columns = [
        ("x", "m", "a place", "float", values.tolist()),
        ("n", "", "", "int", list(range(rows))),
        ("odd", "", "", "flag", [k % 2 == 1 for k in range(rows)]),
        ("word", "", "", "text", [f"wört {k % 7}" for k in range(rows)]),
    ]
    return laval.Table(_native.Table("big", "", columns))


def test_columns(table: laval.Table) -> None:
    assert table.rows == 2 and len(table) == len(list(table)) and "frequency" in table
    assert table.units["frequency"] == "rad/s" and table.docs["growth"].startswith("growth rate")
    frequency = table["frequency"]
    assert frequency.dtype == np.float64 and np.allclose(frequency, np.sqrt(3e5 / 3), rtol=1e-3)
    assert table["stable"].dtype == bool and table["mode"].tolist() == [1, 2]
    assert set(table["whirl"]) == {"forward", "backward"} or set(table["whirl"]) == {"mixed"} or len(table["whirl"]) == 2
    with pytest.raises(KeyError):
        table["nothing"]
    assert "frequency [rad/s]" in repr(table)


def test_arrays_are_views_that_outlive_the_results(rotor: laval.Machine) -> None:
    results = rotor.run(only="response")
    table = results["response"].tables["response"]
    first, second = table["speed"], table["speed"]
    assert first.ctypes.data == second.ctypes.data and not first.flags.owndata and not first.flags.writeable
    values = first.copy()
    del results, table, second
    gc.collect()
    assert np.array_equal(first, values)
    with pytest.raises(ValueError, match="read-only"):
        first[0] = 1.0


def test_arrow_takes_numbers_where_they_lie() -> None:
    pa = pytest.importorskip("pyarrow")
    table = big()
    arrow = table.pyarrow()
    assert arrow.num_rows == table.rows and arrow.column_names == list(table)
    for name in ("x", "n"):
        assert arrow[name].chunk(0).buffers()[1].address == table[name].ctypes.data, name
    assert arrow.schema.field("x").metadata == {b"unit": b"m", b"doc": b"a place"}
    assert arrow["odd"].to_pylist() == table["odd"].tolist() and arrow["word"].to_pylist() == table["word"].tolist()
    assert arrow.schema.field("word").type == pa.large_string()
    x = table["x"].copy()
    del table
    gc.collect()
    assert np.array_equal(arrow["x"].to_numpy(), x)
    assert pa.schema(big(3)).names == ["x", "n", "odd", "word"]
    assert arrow.validate(full=True) is None
    # a column by itself
    column = big(5)._core.column("x")
    assert pa.array(column).to_pylist() == column.to_list()
    # an empty table, and a capsule that nobody takes
    assert big(0).pyarrow().num_rows == 0
    big(5).__arrow_c_stream__()
    big(5)._core.column("word").__arrow_c_array__()


def test_polars_and_pandas() -> None:
    polars, pandas = pytest.importorskip("polars"), pytest.importorskip("pandas")
    table = big(1000)
    frame = table.polars()
    assert frame.columns == list(table) and frame["word"].to_list() == table["word"].tolist()
    assert np.array_equal(frame["x"].to_numpy(), table["x"]) and frame["odd"].to_list() == table["odd"].tolist()
    assert polars.DataFrame(table).equals(frame)
    assert frame["x"].to_numpy().ctypes.data == table["x"].ctypes.data
    other = table.pandas()
    assert isinstance(other, pandas.DataFrame)
    assert list(other.columns) == list(table) and np.array_equal(other["x"], table["x"])


def test_tables_travel(table: laval.Table) -> None:
    for again in (pickle.loads(pickle.dumps(table)), copy.deepcopy(table)):
        assert again == table and again.units == table.units and again.docs == table.docs
    assert big(10) != table and big(10) == big(10)


def test_columns_are_sequences() -> None:
    column = big(4)._core.column("word")
    assert (len(column), column[0], column[-1], column.kind) == (4, "wört 0", "wört 3", "text")
    with pytest.raises(IndexError):
        column[4]
    assert np.asarray(column).tolist() == column.to_list()
    with pytest.raises(ValueError, match="rows"):
        _native.Table("t", "", [("a", "", "", "int", [1]), ("b", "", "", "int", [])])
