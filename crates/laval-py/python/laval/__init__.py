"""Dynamics of rotating machines, from a text file or from Python to findings, tables and figures.

    >>> import laval
    >>> machine = laval.load("machine.toml")
    >>> results = machine.run()
    >>> print(results)

A machine is also built from :mod:`laval.parts` and :mod:`laval.studies`. Values with a unit are texts (``"3000 rpm"``) or pint quantities; a
bare number is in SI units. Results are in SI units.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from laval._blocks import Block, Extra, Part, Study
from laval._errors import Diagnostic, Interrupted, MachineError, MachineWarning
from laval._machine import Machine, Parameter, from_ross, load, loads
from laval._native import __version__
from laval._quantities import si, span
from laval._results import Check, Evidence, Finding, Results, SpecialPoint, StudyResults, Value
from laval._tables import Table

if TYPE_CHECKING:
    from laval import blocks as blocks, designs as designs, parts as parts, studies as studies
    from laval._cases import Cases as Cases, Sweep as Sweep
    from laval._derivatives import Derivatives as Derivatives, Function as Function, Jump as Jump, Mode as Mode, Peak as Peak
    from laval._figures import Figure as Figure
    from laval._studio import Studio as Studio, studio as studio

__all__ = [
    "Block",
    "Cases",
    "Check",
    "Derivatives",
    "Diagnostic",
    "Evidence",
    "Extra",
    "Figure",
    "Finding",
    "Function",
    "Interrupted",
    "Jump",
    "Machine",
    "MachineError",
    "MachineWarning",
    "Mode",
    "Parameter",
    "Part",
    "Peak",
    "Results",
    "SpecialPoint",
    "Studio",
    "Study",
    "StudyResults",
    "Sweep",
    "Table",
    "Value",
    "__version__",
    "blocks",
    "designs",
    "from_ross",
    "load",
    "loads",
    "parts",
    "si",
    "span",
    "studies",
    "studio",
]

_LAZY = {
    **dict.fromkeys(("blocks", "designs", "parts", "studies")),
    **dict.fromkeys(("Derivatives", "Function", "Jump", "Mode", "Peak"), "laval._derivatives"),
    "Figure": "laval._figures",
    **dict.fromkeys(("Studio", "studio"), "laval._studio"),
    **dict.fromkeys(("Cases", "Sweep"), "laval._cases"),
}


def __getattr__(name: str) -> Any:
    if name not in _LAZY:
        raise AttributeError(f"module 'laval' has no attribute {name!r}")
    from importlib import import_module

    home = _LAZY[name]
    found = import_module(f"laval.{name}") if home is None else getattr(import_module(home), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted(__all__)
