"""Machines: read, built, changed, compared."""

from __future__ import annotations

import copy
import math
import pickle
from pathlib import Path

import numpy as np
import pytest

import laval
from conftest import EXAMPLES, ROOT, ROTOR


def built() -> laval.Machine:
    disc = laval.parts.disc(name="disc", mass="3 kg", eccentricity="20 um")
    return laval.Machine(
        name="Laval rotor",
        speed="2000 rpm",
        parts=[
            disc,
            laval.parts.shaft_lumped(name="shaft", between=(disc, "ground"), stiffness="3e5 N/m"),
            laval.parts.damper(name="air", between=["disc", "ground"], damping=20.0),
        ],
        studies=[
            laval.studies.modes(),
            laval.studies.critical_speeds(speed=laval.span("100 rad/s", "600 rad/s")),
            laval.studies.forced_response(name="response", speed=laval.span("100 rad/s", 600.0, points=50)),
        ],
    )


def test_a_machine_of_python_is_that_of_the_file(rotor: laval.Machine) -> None:
    assert built() == rotor
    assert hash(built()) == hash(rotor)
    assert built() != rotor.with_({"disc.mass": "3.1 kg"})
    assert rotor.parts == ("disc", "shaft", "air")
    assert rotor.studies == {"modes": "modes", "critical_speeds": "critical_speeds", "response": "forced_response"}
    assert rotor.coordinates == ("disc.x", "disc.y")
    assert rotor.speed == 2000 * 2 * math.pi / 60
    assert rotor.parameters["shaft.stiffness.x"] == (3e5, "N/m")


@pytest.mark.parametrize("example", EXAMPLES)
def test_canonical_text_pickle_and_copy_are_the_same_machine(example: str) -> None:
    machine = laval.load(ROOT / "examples" / example / "machine.toml")
    assert machine.source == (ROOT / "examples" / example / "machine.toml").read_text(encoding="utf-8")
    again = pickle.loads(pickle.dumps(machine))
    assert again == machine and again.source == machine.text == again.text
    assert copy.copy(machine) == machine and copy.deepcopy(machine) == machine
    # without changes, and with values written anew
    assert machine.with_() == machine
    assert machine.with_({"machine.name": machine.name}) == machine


def test_changes(rotor: laval.Machine) -> None:
    changed = rotor.with_({"shaft.stiffness.y": "4e5 N/m", "machine.speed": 100.0, "response.speed.points": 7})
    values = {path: changed.parameters[path].value for path in ("shaft.stiffness.x", "shaft.stiffness.y")}
    assert values == {"shaft.stiffness.x": 3e5, "shaft.stiffness.y": 4e5}
    assert changed.speed == 100.0
    assert changed.values["study"][2]["speed"]["points"] == 7
    assert rotor.with_({"disc.eccentricity": None}).parameters["disc.eccentricity"].value == 0.0
    assert rotor.with_(studies=[laval.studies.modes()]).studies == {"modes": "modes"}
    heavier = rotor.with_(parts=[laval.parts.disc(name="disc", mass="4 kg")])
    assert heavier.parts == rotor.parts and heavier.parameters["disc.mass"].value == 4.0
    with pytest.raises(KeyError, match="did you mean 'shaft'"):
        rotor.with_({"shaf.stiffness": 1.0})
    with pytest.raises(laval.MachineError) as caught:
        rotor.with_({"shaft.stifness": "1 N/m"})
    assert caught.value.diagnostics[0].code.startswith("key.")


def test_a_fill_is_changed_by_any_of_its_forms() -> None:
    machine = laval.load(ROOT / "examples" / "01-oil-separator" / "machine.toml")
    by_volume = machine.with_({"oil.volume": "0.3 l"})
    assert by_volume == machine.with_({"oil.fill.volume": 0.3e-3}) == machine.with_({"oil.fill": {"volume": "0.3 l"}})
    assert by_volume != machine


def test_quantities(rotor: laval.Machine) -> None:
    assert laval.si("3000 rpm") == 3000 * 2 * math.pi / 60
    assert laval.si(7) == 7.0
    for value in (3, 3.0, np.float64(3), np.int64(3), np.float32(3), "3 kg", "3000 g"):
        assert rotor.with_({"disc.mass": value}) == rotor
    with pytest.raises(ValueError, match="unit"):
        laval.si("3 quatloos")
    with pytest.raises(TypeError, match="a machine cannot hold"):
        laval.parts.disc(mass=object())


def test_quantities_of_pint(rotor: laval.Machine) -> None:
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    cases = {
        "disc.mass": (3 * u.kg, "3 kg"),
        "disc.eccentricity": (20 * u.micrometer, "20 um"),
        "shaft.stiffness": (300 * u.newton / u.millimeter, "300 N/mm"),
        "air.damping": (20 * u.newton * u.second / u.meter, "20 N s/m"),
        "machine.speed": (2000 * u.rpm, "2000 rpm"),
        "disc.eccentricity_phase": (30 * u.degree, "30 deg"),
        "response.speed.from": (16 * u.hertz, "16 Hz"),
    }
    for path, (quantity, text) in cases.items():
        assert rotor.with_({path: quantity}) == rotor.with_({path: text}), path
    with pytest.raises(laval.MachineError) as caught:
        rotor.with_({"disc.mass": 3 * u.meter})
    assert caught.value.diagnostics[0].code == "unit.dimension"


def test_all_mistakes_come_in_one_exception_with_their_places() -> None:
    wrong = ROTOR.replace('mass = "3 kg"', 'mass = "3 m"').replace("between = [\"disc\", \"ground\"]\ndamping", "between = [\"dsc\", \"ground\"]\ndamping")
    with pytest.raises(laval.MachineError) as caught:
        laval.loads(wrong, "rotor.toml")
    found = caught.value.diagnostics
    lines = wrong.splitlines()
    assert [d.code for d in found] == ["unit.dimension", "body.missing"]
    assert [lines[d.line - 1].strip() for d in found if d.line] == ['mass = "3 m"', 'between = ["dsc", "ground"]']
    # the unit is what is wrong
    assert found[0].column == lines[8].index('m"') + 1
    assert found[1].help and "disc" in found[1].help
    assert all(d.severity == "error" for d in found)
    assert "rotor.toml:" in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.diagnostics == found and str(again) == str(caught.value)
    # as ValueError too, as one expects of a wrong text
    assert isinstance(caught.value, ValueError)
    with pytest.raises(FileNotFoundError):
        laval.load("nowhere.toml")


def test_mistakes_of_a_machine_of_python_have_places_in_its_text() -> None:
    with pytest.raises(laval.MachineError) as caught:
        laval.Machine(parts=[laval.parts.disc(name="disc", mass="3 K")])
    found = caught.value.diagnostics
    assert found[0].code == "unit.dimension" and found[0].line is not None
    with pytest.raises(TypeError, match="missing a required argument: 'mass'"):
        laval.parts.disc(name="disc")
    with pytest.raises(TypeError, match="unexpected keyword argument 'masss'"):
        laval.parts.disc(mass=1, masss=1)


class Saved:
    """What is used of a ``ross.Rotor``."""

    def save(self, file: Path) -> None:
        file.write_bytes((ROOT / "crates/laval/tests/reference/ross/pedestals.json").read_bytes())


def test_a_rotor_of_ross_is_a_machine() -> None:
    file = ROOT / "crates/laval/tests/reference/ross/cones.toml"
    machine = laval.from_ross(file)
    assert machine.name == "cones" and machine.speed == 314 and "impeller" in machine.parts
    assert "# - " in machine.source
    assert "left pedestal" in laval.from_ross(Saved(), "rotor").parts


def test_a_file_of_another_kind_is_no_rotor(tmp_path: Path) -> None:
    file = tmp_path / "rotor.toml"
    file.write_text("a = 1")
    with pytest.raises(laval.MachineError, match="no model that ROSS has saved"):
        laval.from_ross(file)
