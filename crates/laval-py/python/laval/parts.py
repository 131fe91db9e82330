"""Elements of machines: one function for each kind of part, with the keys of the machine file.

    >>> laval.parts.disc(name="drum", mass="2.4 kg", eccentricity="20 um")
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval import _registry

if not TYPE_CHECKING:
    __all__ = list(_registry.kinds("parts"))


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    made = globals()[name] = _registry.function("parts", name)
    return made


def __dir__() -> list[str]:
    return list(_registry.kinds("parts"))
