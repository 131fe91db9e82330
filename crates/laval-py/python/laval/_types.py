"""Types of the arguments of parts, studies and blocks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from laval._blocks import Part
from laval._quantities import Quantity as Quantity

if TYPE_CHECKING:
    from typing import TypeAlias

Lateral: TypeAlias = Union[Quantity, Mapping[str, Quantity]]
"""One value for both lateral directions, or ``{"x": .., "y": ..}``."""

Point: TypeAlias = Union[str, Part, Mapping[str, Any]]
"""A body by name or as a part, ``{"body": .., "at": "40 mm"}``, or ``"ground"`` where that is allowed."""

Range: TypeAlias = Union[Quantity, Mapping[str, Any]]
"""One value, or :func:`laval.span`: ``{"from": .., "to": .., "points": ..}``."""

Quantities: TypeAlias = Union[Sequence[Quantity], Any]
"""A list, a NumPy array, or an array of pint."""

Named: TypeAlias = Union[Quantity, Mapping[str, Quantity]]
"""One value for all, or one for each name."""

ParameterRange: TypeAlias = Mapping[str, Any]
"""``{"parameter": "drum.mass", **laval.span("2 kg", "4 kg", points=20)}``."""

Tolerance: TypeAlias = Mapping[str, Any]
"""``{"parameter": "drum.mass", "distribution": "normal", "deviation": "2 %"}``."""
