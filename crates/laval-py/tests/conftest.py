"""Machines that the tests share, and the program beside the package."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

import laval

ROOT = Path(__file__).parents[3]
EXAMPLES = sorted(path.parent.name for path in (ROOT / "examples").glob("*/machine.toml"))

ROTOR = """
[machine]
name = "Laval rotor"
speed = "2000 rpm"

[[part]]
kind = "disc"
name = "disc"
mass = "3 kg"
eccentricity = "20 um"

[[part]]
kind = "shaft_lumped"
name = "shaft"
between = ["disc", "ground"]
stiffness = "3e5 N/m"

[[part]]
kind = "damper"
name = "air"
between = ["disc", "ground"]
damping = "20 N s/m"

[[study]]
kind = "modes"

[[study]]
kind = "critical_speeds"
speed = { from = "100 rad/s", to = "600 rad/s" }

[[study]]
kind = "forced_response"
name = "response"
speed = { from = "100 rad/s", to = "600 rad/s", points = 50 }
"""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--all-examples", action="store_true", help="compare all examples with the program, also those that take minutes")


@pytest.fixture
def rotor() -> laval.Machine:
    """A disc on a flexible shaft."""
    return laval.loads(ROTOR, "rotor")


@pytest.fixture(scope="session")
def program() -> Path:
    """The program `laval`: that of LAVAL_PROGRAM, or built by cargo."""
    given = os.environ.get("LAVAL_PROGRAM")
    if given:
        return Path(given)
    if shutil.which("cargo") is None:
        pytest.skip("the program is not there: set LAVAL_PROGRAM, or install cargo")
    subprocess.run(["cargo", "build", "--release", "--quiet", "-p", "laval-cli"], cwd=ROOT, check=True)
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    return target / "release" / ("laval.exe" if os.name == "nt" else "laval")
