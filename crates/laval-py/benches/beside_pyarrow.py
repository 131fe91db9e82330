"""The table of `crates/laval/benches/tables.rs` written by pyarrow: seconds of all processors. `pip install pyarrow`.

    python crates/laval-py/benches/beside_pyarrow.py [ROWS]
"""

from __future__ import annotations

import io
import math
import sys
import time
from array import array

ROWS = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
COLUMNS = 8


def main() -> None:
    try:
        import pyarrow as pa
        import pyarrow.csv
        import pyarrow.parquet
    except ImportError as why:
        print(f"pyarrow is not here ({why}): pip install pyarrow")
        return
    times = [20.0 * i / ROWS for i in range(ROWS)]
    columns = {"t": pa.array(times)}
    for k in range(1, COLUMNS):
        values = array("d", (1e-4 * math.exp(-0.05 * t) * math.sin(300 * t + k) + 1e-6 * math.cos(1234.5 * t * k) for t in times))
        columns[f"x{k}"] = pa.array(memoryview(values))
    table = pa.table(columns)
    split = [c for c in table.column_names]

    def plain(out: io.BytesIO) -> None:
        pyarrow.parquet.write_table(table, out, compression="zstd")

    def by_bytes(out: io.BytesIO) -> None:
        pyarrow.parquet.write_table(table, out, compression="zstd", use_dictionary=False, use_byte_stream_split=split)

    ways = {"CSV": lambda out: pyarrow.csv.write_csv(table, out), "Parquet, dictionary": plain, "Parquet": by_bytes}
    for what, write in ways.items():
        out, wall, spent = io.BytesIO(), time.perf_counter(), time.process_time()
        write(out)
        wall, spent = time.perf_counter() - wall, time.process_time() - spent
        print(f"{what:20} {wall:7.3f} s, {spent:7.3f} s of processors, {1e-6 * out.tell():.1f} MB", flush=True)


if __name__ == "__main__":
    main()
