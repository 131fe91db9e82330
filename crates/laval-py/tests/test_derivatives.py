"""Derivatives of results: closed forms, differences, SciPy."""

from __future__ import annotations

import math

import numpy as np
import pytest

import laval
from conftest import EXAMPLES, ROOT

M, K, C, E = 3.0, 3e5, 20.0, 20e-6
SPEEDS = laval.span(100.0, 600.0)


def test_a_mode_of_the_laval_rotor_in_closed_form(rotor: laval.Machine) -> None:
    # s = -c/2m + i sqrt(k/m - (c/2m)^2)
    decay = C / (2 * M)
    frequency = math.sqrt(K / M - decay**2)
    found = rotor.derivatives(laval.Mode(1), ["shaft.stiffness", "disc.mass", "air.damping"])
    assert found.unit == "rad/s" and math.isclose(found.value, frequency, rel_tol=1e-13)
    exact = {
        "shaft.stiffness": 1 / (2 * M * frequency),
        "disc.mass": (-K / M**2 + 2 * decay**2 / M) / (2 * frequency),
        "air.damping": -C / (4 * M**2 * frequency),
    }
    for path, slope in exact.items():
        assert math.isclose(found.gradient[path], slope, rel_tol=1e-11), path
    growth = rotor.derivatives(laval.Mode(1, "growth"), list(exact))
    assert math.isclose(growth.value, -decay, rel_tol=1e-11)
    assert math.isclose(growth.gradient["disc.mass"], decay / M, rel_tol=1e-10)
    assert math.isclose(growth.gradient["air.damping"], -1 / (2 * M), rel_tol=1e-11)
    # D = c / (2 sqrt(k m))
    ratio = rotor.derivatives(laval.Mode(1, "damping_ratio"), list(exact))
    damping = C / (2 * math.sqrt(K * M))
    assert ratio.unit == "" and math.isclose(ratio.value, damping, rel_tol=1e-11)
    assert math.isclose(ratio.gradient["shaft.stiffness"], -damping / (2 * K), rel_tol=1e-9)
    # all that may vary: pairs together, and what does not act is zero
    every = rotor.derivatives(laval.Mode(1)).gradient
    assert math.isclose(every["shaft.stiffness"], exact["shaft.stiffness"], rel_tol=1e-11)
    assert abs(every["disc.eccentricity"]) < 1e-12


def test_the_peak_of_the_laval_rotor_in_closed_form(rotor: laval.Machine) -> None:
    # largest e r^2 / sqrt((1-r^2)^2 + (2 D r)^2) over r: e / (2 D sqrt(1-D^2)) at r = 1/sqrt(1-2D^2)
    def peak(m: float, k: float, c: float, e: float) -> float:
        d = c / (2 * math.sqrt(k * m))
        return e / (2 * d * math.sqrt(1 - d * d))

    d = C / (2 * math.sqrt(K * M))
    found = rotor.derivatives(laval.Peak(SPEEDS), ["disc.eccentricity", "air.damping", "shaft.stiffness"])
    assert found.unit == "m" and math.isclose(found.value, peak(M, K, C, E), rel_tol=1e-9)
    assert math.isclose(found.gradient["disc.eccentricity"], peak(M, K, C, E) / E, rel_tol=1e-8)
    slope = (peak(M, K, C * (1 + 1e-5), E) - peak(M, K, C * (1 - 1e-5), E)) / (2e-5 * C)
    assert math.isclose(found.gradient["air.damping"], slope, rel_tol=1e-7)
    at = rotor.derivatives(laval.Peak(SPEEDS, quantity="speed"), ["shaft.stiffness"])
    assert math.isclose(at.value, math.sqrt(K / M) / math.sqrt(1 - 2 * d * d), rel_tol=1e-9)
    every = rotor.derivatives(laval.Peak(SPEEDS)).gradient
    assert math.isclose(every["air.damping"], found.gradient["air.damping"], rel_tol=1e-9)


@pytest.mark.parametrize("result", [laval.Mode(1), laval.Mode(2, "growth"), laval.Peak(laval.span(25.0, 4000.0)), laval.Jump(laval.span(25.0, 4000.0), "down")])
def test_gradients_of_a_nonlinear_machine_agree_with_differences(result: laval.Mode | laval.Peak) -> None:
    machine = laval.load(ROOT / "examples" / "02-rigid-rotor" / "machine.toml")
    function = machine.function(result, ["drum.mass", "bearing.stiffness", "losses.damping"])
    value, gradient = function(function.x0)
    assert value == function.derivatives(function.x0).value and gradient.shape == (3,)
    for k, x in enumerate(function.x0):
        step = np.zeros(3)
        step[k] = 1e-4 * x
        ahead, behind = (function(function.x0 + sign * step)[0] for sign in (1, -1))
        difference = (ahead - behind) / (2 * step[k])
        scale = abs(value) / x
        assert abs(gradient[k] - difference) <= 1e-5 * abs(difference) + 1e-7 * scale, function.parameters[k]


def test_a_liquid_in_the_frequency_domain() -> None:
    machine = laval.load(ROOT / "examples" / "01-oil-separator" / "machine.toml")
    function = machine.function(laval.Mode(1, "growth", speed="1600 rpm"), ["oil.wave_damping", "losses.damping", "drum.mass"])
    value, gradient = function(function.x0)
    for k, x in enumerate(function.x0):
        step = np.zeros(3)
        step[k] = 1e-4 * x
        ahead, behind = (function(function.x0 + sign * step)[0] for sign in (1, -1))
        assert math.isclose(gradient[k], (ahead - behind) / (2 * step[k]), rel_tol=1e-5, abs_tol=1e-9 * abs(value) / x)


def test_an_optimiser_takes_it(rotor: laval.Machine) -> None:
    optimize = pytest.importorskip("scipy.optimize")
    f = rotor.function(laval.Mode(1), ["shaft.stiffness"])
    assert f.x0.tolist() == [3e5] and f.bounds[0][0] == 0.0

    def gap(z: np.ndarray) -> tuple[float, np.ndarray]:
        # in units of the stiffness, so that both numbers are near one
        value, gradient = f(z * 3e5)
        return (value / 250 - 1) ** 2, 2 * (value / 250 - 1) * gradient / 250 * 3e5

    found = optimize.minimize(gap, [1.0], jac=True, tol=1e-14)
    assert math.isclose(found.x[0] * 3e5, M * (250**2 + (C / (2 * M)) ** 2), rel_tol=1e-5)
    assert optimize.check_grad(lambda x: f(x)[0], lambda x: f(x)[1], f.x0, epsilon=1.0) < 1e-8


def test_requests_that_cannot_be_met(rotor: laval.Machine) -> None:
    with pytest.raises(laval.MachineError, match="no parameter"):
        rotor.derivatives(laval.Mode(1), ["shaft.stifness"])
    with pytest.raises(ValueError, match="no parameter"):
        rotor.function(laval.Mode(1), ["shaft.stifness"])
    with pytest.raises(laval.MachineError, match="no mode 9"):
        rotor.derivatives(laval.Mode(9))
    with pytest.raises(ValueError, match="no such jump"):
        rotor.derivatives(laval.Jump(SPEEDS, "up"))
    with pytest.raises(ValueError, match="a frequency"):
        laval.Mode(1, "colour")  # type: ignore[arg-type]
    with pytest.raises(ValueError):
        f = rotor.function(laval.Mode(1), ["shaft.stiffness"])
        f([1.0, 2.0])
