"""The same numbers as the program, bit for bit: the folders of both are the same, byte for byte."""

from __future__ import annotations

import subprocess
import warnings
from pathlib import Path

import pytest

import laval
from conftest import EXAMPLES, ROOT

# compute within seconds
QUICK = ("01-oil-separator", "02-rigid-rotor", "03-overhung-disc", "04-ball-balancer")


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file() and path.name != ".lock"}


@pytest.mark.parametrize("example", EXAMPLES)
def test_examples(example: str, program: Path, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    if example not in QUICK and not request.config.getoption("--all-examples"):
        pytest.skip("takes long: --all-examples")
    file = ROOT / "examples" / example / "machine.toml"
    subprocess.run([program, "run", file, "--out", tmp_path / "program", "--quiet", "--lang", "en"], check=False, timeout=3600)
    with warnings.catch_warnings():
        # what the program says on the terminal
        warnings.simplefilter("ignore", laval.MachineWarning)
        results = laval.load(file).run(out=tmp_path / "python")
    ours, theirs = files(tmp_path / "python"), files(tmp_path / "program")
    assert list(ours) == list(theirs)
    assert [name for name in ours if ours[name] != theirs[name]] == []
    # and the tables in memory are those of the files, bit for bit
    parquet = pytest.importorskip("pyarrow.parquet")
    for study, entries in zip(results, results.data()["studies"]):
        for table, entry in zip(study.tables.values(), entries["tables"]):
            stored = parquet.read_table(tmp_path / "program" / f"{entry['file']}.parquet")
            assert stored.column_names == list(table)
            for name in table:
                values = stored[name].to_numpy()
                assert values.astype(table[name].dtype).tobytes() == table[name].tobytes() or table[name].dtype == object, name
                assert table[name].dtype != object or values.tolist() == table[name].tolist(), name
