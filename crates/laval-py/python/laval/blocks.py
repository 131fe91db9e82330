"""What stands beside the parts of a machine: limits, operation, suspension, cups, report.

    >>> laval.blocks.limits(speed="12000 rpm")
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval import _registry

if not TYPE_CHECKING:
    __all__ = list(_registry.kinds("blocks"))


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    made = globals()[name] = _registry.function("blocks", name)
    return made


def __dir__() -> list[str]:
    return list(_registry.kinds("blocks"))
