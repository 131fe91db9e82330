"""Values as a machine file writes them: numbers, texts with unit, pint quantities, lists and tables."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Protocol, Union

from laval import _native

if TYPE_CHECKING:
    from typing import TypeAlias


class SupportsUnits(Protocol):
    """A number with a unit, such as a quantity of pint."""

    @property
    def magnitude(self) -> Any: ...

    @property
    def units(self) -> Any: ...


Quantity: TypeAlias = Union[str, float, SupportsUnits]
"""A value with its unit: a text such as ``"3000 rpm"``, a pint quantity, or a number in SI units."""


def si(quantity: Quantity) -> float:
    """The value of a quantity in SI units: ``si("3000 rpm")`` is 314.159... rad/s."""
    plain = written(quantity)
    return _native.si(plain)[0] if isinstance(plain, str) else float(plain)


def span(start: Quantity, stop: Quantity, points: int | None = None) -> dict[str, Any]:
    """A range of a study or of a parameter: ``speed=span("100 rpm", "3000 rpm", points=50)``."""
    out: dict[str, Any] = {"from": start, "to": stop}
    return out if points is None else {**out, "points": points}


def written(value: Any) -> Any:
    """The value as texts, numbers, flags, lists and dictionaries alone.

    Raises:
        TypeError: a value that a machine file cannot hold.
    """
    if isinstance(value, (str, bool, int, float)):
        # of subclasses, such as numpy.float64, the plain value
        for kind in (bool, str, int, float):
            if isinstance(value, kind):
                return kind(value)
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return _with_unit(value.magnitude, _unit(value.units))
    inline = getattr(value, "_inline", None)
    if inline is not None:
        return written(inline())
    if isinstance(value, Mapping):
        return {str(key): written(entry) for key, entry in value.items()}
    if hasattr(value, "tolist"):
        return written(value.tolist())
    if isinstance(value, (Sequence, set, frozenset)) and not isinstance(value, (bytes, bytearray)):
        return [written(entry) for entry in value]
    raise TypeError(f"a machine cannot hold {value!r}: give a text with a unit, a number, a list or a dictionary")


def _with_unit(magnitude: Any, unit: str) -> Any:
    if hasattr(magnitude, "tolist"):
        magnitude = magnitude.tolist()
    if isinstance(magnitude, list):
        return [_with_unit(entry, unit) for entry in magnitude]
    return f"{float(magnitude)!r} {unit}" if unit else float(magnitude)


def _unit(units: Any) -> str:
    """The unit in letters that a machine file knows: `newton / meter` is `N/m`."""
    try:
        short = format(units, "~C")
    except (TypeError, ValueError):
        short = str(units)
    return short.replace("**", "^").replace(" ", "")
