"""Analyses of machines: one function for each kind of study, with the keys of the machine file.

    >>> laval.studies.modes(speed="3000 rpm")
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval import _registry

if not TYPE_CHECKING:
    __all__ = list(_registry.kinds("studies"))


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    made = globals()[name] = _registry.function("studies", name)
    return made


def __dir__() -> list[str]:
    return list(_registry.kinds("studies"))
