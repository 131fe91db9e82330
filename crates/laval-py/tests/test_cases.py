"""Many machines: designs, rows, parts, folders."""

from __future__ import annotations

import json
import os
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import laval
from conftest import ROOT
from laval import designs

MASS, STIFFNESS, DAMPING = "disc.mass", "shaft.stiffness", "air.damping"
MODES = laval.studies.modes()
GRID = {MASS: ["2 kg", "3 kg", -1.0], STIFFNESS: laval.span(1e5, 4e5, points=4)}


def files(folder: Path) -> dict[str, bytes]:
    """All files of a folder; locks are held by running processes alone."""
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file() and p.name != ".lock"}


def spread(cases: int, seed: int = 1) -> designs.Design:
    return designs.latin_hypercube({MASS: {"distribution": "normal", "deviation": "5 %"}, DAMPING: laval.span(10.0, 30.0)}, cases, seed)


def test_a_grid_has_the_numbers_of_single_runs(rotor: laval.Machine, tmp_path: Path) -> None:
    cases = laval.Sweep(rotor, GRID, MODES).run(tmp_path / "grid", client=False)
    assert cases.complete and cases.rows == cases.done == 12
    assert cases["case"].tolist() == list(range(12))
    assert cases[MASS].tolist() == [2.0] * 4 + [3.0] * 4 + [-1.0] * 4
    assert cases[STIFFNESS].tolist() == [1e5, 2e5, 3e5, 4e5] * 3
    assert cases.units[MASS] == "kg" and cases.units[STIFFNESS] == "N/m"
    numbers = cases.columns[3:-3]
    assert cases.columns[:3] == ("case", MASS, STIFFNESS) and cases.columns[-3:] == ("others", "invalid", "failure")
    assert set(numbers) == {"least_damped_mode damping ratio", "stable"} and cases.units["stable"] == "1/s"
    rows = cases.pandas() if _has("pandas") else None
    for row in range(8):
        changed = rotor.with_({MASS: float(cases[MASS][row]), STIFFNESS: float(cases[STIFFNESS][row])})
        found = {f.id + (f" {f.subject}" if f.subject else ""): f.value for f in changed.run(MODES)[0].findings if f.value is not None}
        assert set(found) == set(numbers)
        for name in numbers:
            assert cases[name][row] == found[name], name
            if rows is not None:
                assert np.array_equal(rows[name][row], cases[name][row], equal_nan=True)
    # a machine that does not exist is a row with its reason
    assert np.isnan(cases[numbers[0]][8:]).all() and not np.isnan(cases[numbers[0]][:8]).any()
    assert (cases["failure"][:8] == "").all()
    (reason,) = cases.failures()
    assert "mass" in reason and cases.failures()[reason] == 4


def _has(module: str) -> bool:
    from importlib.util import find_spec

    return find_spec(module) is not None


def test_designs_do_not_depend_on_anything_but_their_arguments(rotor: laval.Machine, tmp_path: Path) -> None:
    found = {}
    for make in (designs.sobol, designs.latin_hypercube, designs.random):
        for seed in (1, 1, 2):
            parameters = {MASS: {"distribution": "normal", "deviation": "5 %"}, DAMPING: laval.span("10 N s/m", "30 N s/m")}
            design = make(parameters, cases=64, seed=seed)
            assert design.cases == 64 and design.parameters == (MASS, DAMPING) and "64 cases" in repr(design)
            folder = tmp_path / f"{make.__name__}-{seed}-{len(found)}"
            cases = laval.Sweep(rotor, pickle.loads(pickle.dumps(design)), MODES).run(folder, client=False)
            damping = cases[DAMPING]
            assert ((10 < damping) & (damping < 30)).all() and abs(cases[MASS].mean() - 3.0) < 0.1
            if make is not designs.random:
                # one case in each of 64 intervals
                assert sorted(((damping - 10) / 20 * 64).astype(int).tolist()) == list(range(64))
            key = (make.__name__, seed)
            if key in found:
                assert found[key] == damping.tolist()
            found[key] = damping.tolist()
    assert len({tuple(v) for v in found.values()}) == 6


@pytest.mark.parametrize("kind", ["dict", "texts", "polars", "pandas", "pyarrow", "table"])
def test_lists_from_tables(kind: str, rotor: laval.Machine, tmp_path: Path) -> None:
    columns = {MASS: np.array([2.0, 3.0, np.nan]), DAMPING: np.array([10.0, 20.0, 30.0])}
    given: object = columns
    if kind == "texts":
        given = designs.table({MASS: ["2000 g", "3 kg", float("nan")], DAMPING: [10, 20, 30]})
    elif kind == "polars":
        given = pytest.importorskip("polars").DataFrame(columns)
    elif kind == "pandas":
        given = pytest.importorskip("pandas").DataFrame(columns)
    elif kind == "pyarrow":
        given = pytest.importorskip("pyarrow").table(columns)
    elif kind == "table":
        (given,) = laval.Sweep(rotor, designs.table(columns), MODES, chunk=3).run(tmp_path / "b", client=False).batches([MASS, DAMPING])
    else:
        given = designs.table(columns)
    cases = laval.Sweep(rotor, given, MODES, chunk=2).run(tmp_path, client=False)
    assert cases[MASS].tolist()[:2] == [2.0, 3.0] and cases[DAMPING].tolist() == [10.0, 20.0, 30.0]
    # a value that is no number fails its case
    assert [bool(reason) for reason in cases["failure"]] == [False, False, True]
    # a damaged list is refused
    whole = (tmp_path / "list.f64").read_bytes()
    (tmp_path / "list.f64").write_bytes(whole[:-1] + bytes([whole[-1] ^ 1]))
    for file in (tmp_path / "cases").glob("chunk-*"):
        file.unlink()
    with pytest.raises(OSError, match="damaged"):
        laval.Cases(tmp_path).part(1, 1)


def test_parts_give_the_files_of_one_run(rotor: laval.Machine, tmp_path: Path) -> None:
    sweep = laval.Sweep(rotor, spread(90), MODES, chunk=7)
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    sweep.run(whole, client=False)
    cases = sweep.prepare(parts)
    assert cases.chunks == 13 and cases.done == 0 and not cases.complete
    cases.part(3, 4)
    assert cases.done == 21
    with pytest.raises(LookupError, match="missing"):
        cases.collect()
    # from the command line, and divided anew
    for number in (2, 1, 2):
        command = [sys.executable, "-m", "laval", "part", str(parts), f"{number}/2", "--threads", "1"]
        done = subprocess.run(command, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
    assert done.stdout == "90 of 90 cases in 13 files, which is the largest number of parts\n"
    assert subprocess.run([sys.executable, "-m", "laval", "collect", str(parts)]).returncode == 0
    assert files(whole) == files(parts) and len(files(parts)) == 15
    # nothing is computed or written again
    before = {p: p.stat().st_mtime_ns for p in (parts / "cases").glob("chunk-*")}
    sweep.run(parts, client=False)
    assert before == {p: p.stat().st_mtime_ns for p in (parts / "cases").glob("chunk-*")}
    # a damaged file is computed again
    damaged = parts / "cases" / "chunk-000005.parquet"
    damaged.write_bytes(damaged.read_bytes()[:100])
    with pytest.raises(OSError, match="damaged"):
        list(cases.batches())
    with pytest.warns(laval.MachineWarning, match="damaged"):
        sweep.run(parts, client=False)
    assert files(whole) == files(parts)


def test_a_folder_of_other_cases_is_refused(rotor: laval.Machine, tmp_path: Path) -> None:
    laval.Sweep(rotor, spread(8), MODES).prepare(tmp_path)
    for other in (
        laval.Sweep(rotor, spread(8, seed=2), MODES),
        laval.Sweep(rotor.with_({MASS: 4.0}), spread(8), MODES),
        laval.Sweep(rotor, spread(8), laval.studies.modes(speed="100 rpm")),
        laval.Sweep(rotor, spread(8), MODES, chunk=3),
        laval.Sweep(rotor, spread(8), MODES, numbers={"other": "m"}),
    ):
        with pytest.raises(ValueError, match="holds other cases"):
            other.prepare(tmp_path)
    assert laval.Sweep(rotor, spread(8), MODES).prepare(tmp_path).rows == 8
    with pytest.raises(FileNotFoundError):
        laval.Cases(tmp_path / "nothing")
    # files of another build or request are not mixed in
    laval.Sweep(rotor, spread(8, seed=2), MODES).run(tmp_path / "b", client=False)
    cases = laval.Sweep(rotor, spread(8), MODES).run(tmp_path / "a", client=False)
    os.replace(tmp_path / "b" / "cases" / "chunk-000003.parquet", tmp_path / "a" / "cases" / "chunk-000003.parquet")
    with pytest.raises(OSError, match="another study"):
        list(cases.batches())


def test_rows_are_read_lazily(rotor: laval.Machine, tmp_path: Path) -> None:
    cases = laval.Sweep(rotor, spread(40), MODES, chunk=16).run(tmp_path, client=False)
    batches = list(cases.batches([MASS, "failure"]))
    assert [batch.rows for batch in batches] == [16, 16, 8] and list(batches[0]) == [MASS, "failure"]
    assert np.concatenate([batch[MASS] for batch in batches]).tolist() == cases[MASS].tolist()
    again = pickle.loads(pickle.dumps(cases))
    assert again[MASS].tolist() == cases[MASS].tolist() and "40 of 40" in repr(again)
    with pytest.raises(KeyError, match="disc.mass"):
        cases["mass"]
    with pytest.raises(KeyError):
        cases.stream(["mass"]).__arrow_c_stream__()
    with pytest.raises(ValueError, match="twice"):
        next(cases.batches([MASS, MASS]))
    # what is there of a folder that is not complete
    (tmp_path / "cases" / "chunk-000001.parquet").unlink()
    assert cases.done == 24 and len(cases.files) == 2 and cases["case"].tolist() == [*range(16), *range(32, 40)]


def test_rows_in_other_libraries(rotor: laval.Machine, tmp_path: Path) -> None:
    polars, pyarrow = pytest.importorskip("polars"), pytest.importorskip("pyarrow")
    cases = laval.Sweep(rotor, {**GRID, DAMPING: [5.0, 6.0]}, MODES, chunk=5).run(tmp_path, client=False)
    lazy = cases.polars()
    assert isinstance(lazy, polars.LazyFrame) and list(lazy.collect_schema()) == list(cases.columns)
    assert lazy.filter(polars.col(MASS) == 3.0).collect().height == 8
    data = cases.pyarrow()
    assert data.count_rows() == 24 and data.schema.names == list(cases.columns)
    stream = pyarrow.RecordBatchReader.from_stream(cases.stream(["case", MASS]))
    assert [batch.num_rows for batch in stream] == [5, 5, 5, 5, 4]
    frame = polars.DataFrame(cases)
    for name in cases.columns:
        ours = cases[name].tolist()
        for theirs in (frame[name].to_list(), lazy.collect()[name].to_list(), data.to_table()[name].to_pylist()):
            assert np.array_equal(np.array(theirs), np.array(ours), equal_nan=isinstance(ours[0], float)), name
    # an error on the way is raised in the consumer
    (tmp_path / "cases" / "chunk-000002.parquet").write_bytes(b"nothing")
    with pytest.raises(Exception, match="damaged"):
        pyarrow.table(cases)


def test_numbers_without_a_column_stand_together(rotor: laval.Machine, tmp_path: Path) -> None:
    cases = laval.Sweep(rotor, {MASS: [2.0, 3.0]}, MODES).run(tmp_path / "all", client=False)
    name = "stable"
    few = laval.Sweep(rotor, {MASS: [2.0, 3.0]}, MODES, numbers={"nothing": "m"}).run(tmp_path / "few", client=False)
    assert np.isnan(few["nothing"]).all() and name not in few.columns
    found = [json.loads(text) for text in few["others"]]
    assert [entry[name] for entry in found] == [[x, "1/s"] for x in cases[name]]
    assert (cases["others"] == "").all()


def test_progress_and_ctrl_c(rotor: laval.Machine, tmp_path: Path) -> None:
    study = laval.studies.critical_speeds(speed=laval.span("100 rad/s", "600 rad/s"))
    sweep = laval.Sweep(rotor, spread(1500), study)

    def stop(extent: object) -> None:
        if extent.done > 100:  # type: ignore[attr-defined]
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep.run(tmp_path, client=False, progress=stop)
    cases = laval.Cases(tmp_path)
    assert 0 < cases.done < 1500
    seen: list[Any] = []
    sweep.run(tmp_path, client=False, progress=seen.append)
    first, *_, last = seen
    assert first.done > 0 and np.isnan(first.rate)
    assert last.done == last.total == 1500 and last.rate > 0 and last.remaining == 0.0
    assert files(sweep.run(tmp_path / "b", client=False, progress=True).folder / "cases") == files(tmp_path / "cases")


def test_requests_that_cannot_be_met(rotor: laval.Machine) -> None:
    with pytest.raises(laval.MachineError, match="no parameter"):
        laval.Sweep(rotor, {"disc.mas": [1.0]}, MODES)
    with pytest.raises(ValueError, match="in kg, not in"):
        laval.Sweep(rotor, {MASS: ["1 m"]}, MODES)
    with pytest.raises(ValueError, match="no case"):
        laval.Sweep(rotor, {MASS: []}, MODES)
    with pytest.raises(ValueError, match="whole number"):
        laval.Sweep(rotor, {MASS: [1.0]}, MODES, chunk=0)
    with pytest.raises(laval.MachineError, match="no study"):
        laval.Sweep(rotor, {MASS: [1.0]}, "nothing")
    with pytest.raises(ValueError, match="finite"):
        laval.Sweep(rotor, {MASS: [np.nan]}, MODES)
    with pytest.raises(laval.MachineError, match="deviation"):
        laval.Sweep(rotor, designs.sobol({MASS: {"distribution": "normal"}}, 4), MODES)
    with pytest.raises(ValueError, match="one length"):
        designs.table({MASS: [1.0, 2.0], DAMPING: [1.0]})
    with pytest.raises(ValueError, match="whole number"):
        designs.sobol({MASS: (1.0, 2.0)}, 0)
    with pytest.raises(TypeError, match="no table"):
        designs.table(3.0)


def blocks(page: str) -> list[str]:
    import re

    text = (ROOT / "docs" / page).read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", ["slurm.md", "joblib.md", "many-machines.md"])
def test_the_pages_can_be_followed(page: str, tmp_path: Path) -> None:
    if page == "joblib.md":
        pytest.importorskip("joblib")
    (tmp_path / "machine.toml").write_bytes((ROOT / "examples" / "02-rigid-rotor" / "machine.toml").read_bytes())
    (block,) = blocks(page)
    (tmp_path / "page.py").write_text(block, encoding="utf-8")
    done = subprocess.run([sys.executable, "page.py"], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    if page == "slurm.md":
        import re

        text = (ROOT / "docs" / page).read_text(encoding="utf-8")
        (script,) = re.findall(r"^```bash\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
        script = script.replace("python -m", f"{sys.executable} -m")
        first, last = map(int, re.search(r"--array=(\d+)-(\d+)", script).groups())  # type: ignore[union-attr]
        for task in range(first, last + 1):
            of_slurm = {"SLURM_ARRAY_TASK_ID": str(task), "SLURM_ARRAY_TASK_COUNT": str(last), "SLURM_CPUS_PER_TASK": "2"}
            done = subprocess.run(["bash", "-c", script], cwd=tmp_path, env={**os.environ, **of_slurm}, capture_output=True, text=True)
            assert done.returncode == 0, done.stderr
        assert laval.Cases(tmp_path / "tolerances").collect().complete
    elif page == "joblib.md":
        assert laval.Cases(tmp_path / "grid").rows == 256 and "256 of 256" in done.stdout
