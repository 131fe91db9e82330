"""Exact derivatives of results in the parameters of a machine, as functions that optimisers take."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from laval import _native
from laval._quantities import written

if TYPE_CHECKING:
    import numpy as np

    from laval._machine import Machine
    from laval._quantities import Quantity


class Derivatives(NamedTuple):
    """A result and how it moves with parameters."""

    value: float
    """In SI units."""
    unit: str
    """SI unit."""
    gradient: dict[str, float]
    """Derivative in each parameter, by path, SI. NaN where there is none."""


class Mode:
    """A natural mode at a spin speed, as a result to be differentiated.

    Derivatives are exact for linear parts and for those in the frequency domain. Where parameters of nonlinear parts change the stiffness at rest,
    or move the state of rest, that share is taken by differences of fourth order.

    Args:
        number: in order of frequency, from 1, among those of ``whirl`` where that is given.
        quantity: ``frequency`` (rad/s), ``growth`` (1/s) or ``damping_ratio``.
        whirl: ``forward``, ``backward``, ``mixed`` or ``none``.
        speed: of the spin; that of the machine unless given.
        about: ``rest``, or ``turning`` for the state that turns with the rotor.
    """

    def __init__(
        self,
        number: int = 1,
        quantity: Literal["frequency", "growth", "damping_ratio"] = "frequency",
        *,
        whirl: Literal["forward", "backward", "mixed", "none"] | None = None,
        speed: Quantity | None = None,
        about: Literal["rest", "turning"] = "rest",
    ) -> None:
        if quantity not in ("frequency", "growth", "damping_ratio"):
            raise ValueError("a mode has a frequency, a growth and a damping_ratio")
        self.number, self.quantity, self.whirl = number, quantity, whirl
        self._fields: dict[str, Any] = {"about": about, **({} if speed is None else {"speed": written(speed)})}

    def evaluate(self, machine: Machine, changes: Mapping[str, float], paths: Sequence[str] | None) -> Derivatives:
        """Its value and its derivatives for a machine with other values of parameters."""
        fields, items = json.dumps(self._fields), list(changes.items())
        names = None if paths is None else list(paths)
        growth, frequency, slopes = _native.mode(machine._core, fields, self.number, self.whirl, items, names)
        if self.quantity == "frequency":
            return Derivatives(frequency, "rad/s", {path: f for path, _, f in slopes})
        if self.quantity == "growth":
            return Derivatives(growth, "1/s", {path: g for path, g, _ in slopes})
        size = math.hypot(growth, frequency)
        # d(-g/|s|) = -dg/|s| + g (g dg + f df)/|s|^3
        ratio = {path: -g / size + growth * (growth * g + frequency * f) / size**3 for path, g, f in slopes}
        return Derivatives(-growth / size, "", ratio)


class Peak:
    """A peak of the steady unbalance response, as a result to be differentiated.

    Args:
        speed: range of the spin speed, made by :func:`laval.span`.
        of: the body or point whose motion it is; that of the largest displacement unless given.
        quantity: ``value`` (m, or rad for a tilt) or ``speed`` (rad/s).
        near: a speed; the peak nearest to it, instead of the largest one.
        harmonics: orders of the spin frequency kept.
    """

    _kinds = ("peak",)
    _missing = "the response has no such peak in this range"

    def __init__(
        self,
        speed: Mapping[str, Any],
        *,
        of: str | None = None,
        quantity: Literal["value", "speed"] = "value",
        near: Quantity | None = None,
        harmonics: int | Literal["auto"] = "auto",
    ) -> None:
        from laval._quantities import si

        if quantity not in ("value", "speed"):
            raise ValueError("a place of the response has a value and a speed")
        self.of, self.quantity = of, quantity
        self.near = None if near is None else si(near)
        self._fields = {"speed": written(speed), "harmonics": harmonics}

    def evaluate(self, machine: Machine, changes: Mapping[str, float], paths: Sequence[str] | None) -> Derivatives:
        """Its value and its derivatives for a machine with other values of parameters.

        Raises:
            ValueError: there is no such place in the range.
        """
        names = None if paths is None else list(paths)
        found = _native.places(machine._core, json.dumps(self._fields), list(changes.items()), names)
        own = [place for place in found if place[0] in self._kinds and self.of in (None, place[1])]
        if not own:
            raise ValueError(self._missing)
        if self.near is not None:
            near = self.near
            chosen = min(own, key=lambda place: abs(place[2] - near))
        else:
            # a displacement and a tilt do not compare
            metres = [place for place in own if place[4] == "m"] or own
            chosen = max(metres, key=lambda place: place[3])
        _, _, speed, value, unit, slopes = chosen
        if self.quantity == "speed":
            return Derivatives(speed, "rad/s", {path: s for path, s, _ in slopes})
        return Derivatives(value, unit, {path: v for path, _, v in slopes})


class Jump(Peak):
    """A fold of the steady unbalance response, where a slow run-up or run-down jumps, as a result to be differentiated.

    Args:
        speed: range of the spin speed, made by :func:`laval.span`.
        direction: ``up`` to a larger motion, ``down`` to a smaller one.
        of: the body or point whose motion it is.
        quantity: ``speed`` (rad/s) or ``value`` (m).
        near: a speed; the jump nearest to it.
        harmonics: orders of the spin frequency kept.
    """

    _missing = "the response has no such jump in this range"

    def __init__(
        self,
        speed: Mapping[str, Any],
        direction: Literal["up", "down"],
        *,
        of: str | None = None,
        quantity: Literal["value", "speed"] = "speed",
        near: Quantity | None = None,
        harmonics: int | Literal["auto"] = "auto",
    ) -> None:
        super().__init__(speed, of=of, quantity=quantity, near=near, harmonics=harmonics)
        self._kinds = (f"jump_{direction}",)


class Function:
    """A result as a function of parameters: ``f(x)`` is its value and its gradient, as ``scipy.optimize.minimize(f, f.x0, jac=True)`` takes them."""

    def __init__(self, machine: Machine, result: Mode | Peak, parameters: Sequence[str]) -> None:
        self.machine = machine
        """The machine, whose other values stay."""
        self.result = result
        """What is differentiated."""
        self.parameters = tuple(parameters)
        """Paths, in the order of ``x``."""
        values = machine.parameters
        pair = [path if path in values else path + ".x" for path in self.parameters]
        unknown = [path for path, half in zip(self.parameters, pair) if half not in values]
        if unknown:
            # the library says which are near
            _native.bounds(machine._core, unknown[0])
        self._x0 = [values[path].value for path in pair]

    @property
    def x0(self) -> np.ndarray[Any, Any]:
        """Values of the machine, SI."""
        import numpy as np

        return np.array(self._x0)

    @property
    def bounds(self) -> list[tuple[float, float]]:
        """What each parameter admits, SI."""
        return [_native.bounds(self.machine._core, path) for path in self.parameters]

    def derivatives(self, x: Sequence[float]) -> Derivatives:
        """Value and derivatives with their names and units."""
        changes = {path: float(value) for path, value in zip(self.parameters, x, strict=True)}
        return self.result.evaluate(self.machine, changes, self.parameters)

    def __call__(self, x: Sequence[float]) -> tuple[float, np.ndarray[Any, Any]]:
        import numpy as np

        found = self.derivatives(x)
        return found.value, np.array([found.gradient[path] for path in self.parameters])
