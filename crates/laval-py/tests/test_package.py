"""The package itself: its wheel, its imports, its pages."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from importlib.metadata import distribution
from pathlib import Path

import pytest

import laval
from conftest import ROOT

HERE = Path(__file__).parents[1]


def test_the_wheel_is_of_the_stable_interface() -> None:
    wheel = distribution("laval").read_text("WHEEL") or ""
    tags = re.findall(r"^Tag: (.*)$", wheel, re.MULTILINE)
    assert tags and all(tag.startswith("cp310-abi3-") for tag in tags)
    assert distribution("laval").version == laval.__version__


def test_the_wheel_is_small() -> None:
    given = os.environ.get("LAVAL_WHEEL")
    if not given:
        pytest.skip("LAVAL_WHEEL names the wheel")
    assert re.fullmatch(r"laval-.*-cp310-abi3-.*\.whl", Path(given).name)
    assert Path(given).stat().st_size < 20e6


def test_nothing_large_is_imported_before_it_is_needed() -> None:
    code = "import sys, laval; print(*(m for m in sys.modules if m in sys.argv[1:]))"
    large = ["numpy", "tqdm", "matplotlib", "plotly", "polars", "pandas", "pyarrow", "pint", "inspect", "distributed"]
    large += ["laval.parts", "laval.designs", "laval._cases", "laval._figures"]
    done = subprocess.run([sys.executable, "-c", code, *large], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []


def blocks(page: Path) -> list[str]:
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def test_the_page_can_be_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("scipy", "polars", "matplotlib", "pint"):
        pytest.importorskip(module)
    (tmp_path / "machine.toml").write_bytes((ROOT / "examples" / "02-rigid-rotor" / "machine.toml").read_bytes())
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    found = blocks(ROOT / "docs" / "python.md")
    assert len(found) >= 8
    for block in found:
        exec(compile(block, "docs/python.md", "exec"), names)


@pytest.mark.parametrize("notebook", sorted((ROOT / "examples" / "python").glob("*.ipynb")), ids=lambda p: p.stem)
def test_notebooks(notebook: Path, tmp_path: Path) -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    pytest.importorskip("ipykernel")
    book = nbformat.read(notebook, as_version=4)
    # kept without results: they would be old soon
    assert all(not cell.get("outputs") for cell in book.cells)
    nbformat.validate(book)
    nbclient.NotebookClient(book, timeout=300, resources={"metadata": {"path": str(notebook.parent)}}).execute()
    shown = json.dumps(book)
    # page one of a report, or a figure
    assert ("<iframe srcdoc" in shown) == (notebook.stem == "first-steps")
    assert "image/png" in shown or "<svg" in shown
