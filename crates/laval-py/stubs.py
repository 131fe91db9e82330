"""Writes `laval/parts.pyi`, `studies.pyi` and `blocks.pyi`: what the functions take that the registries of the library make.

    python crates/laval-py/stubs.py          # write them
    python crates/laval-py/stubs.py --check  # fail where they are not current
"""

from __future__ import annotations

import sys
from pathlib import Path
from textwrap import indent
from typing import Any

from laval import _registry

FOLDER = Path(__file__).parent / "python" / "laval"
TITLES = {
    "parts": ("Elements of machines: one function for each kind of part, with the keys of the machine file.", "Part"),
    "studies": ("Analyses of machines: one function for each kind of study, with the keys of the machine file.", "Study"),
    "blocks": ("What stands beside the parts of a machine: limits, operation, suspension, cups, report.", "Extra"),
}
TYPES = {
    "quantity": "Quantity",
    "lateral": "Lateral",
    "integer": "int",
    "flag": "bool",
    "text": "str",
    "point": "Point",
    "between": "tuple[Point, Point] | list[Point]",
    "range": "Range",
    "list": "Quantities",
    "parameter": "str",
    "parameter_range": "ParameterRange",
    "parameter_ranges": "Sequence[ParameterRange]",
    "coordinate": "str",
    "named": "Named",
    "state": "Mapping[str, Quantity]",
    "study": "str | Study",
    "tolerances": "Sequence[Tolerance]",
    "integer_or_auto": 'int | Literal["auto"]',
}


def literal(words: list[str]) -> str:
    return f"Literal[{', '.join(repr(word).replace(chr(39), chr(34)) for word in words)}]"


def hint(field: dict[str, Any]) -> str:
    """The type of an argument."""
    kind = field["type"]
    if kind == "choice":
        return literal(field["words"])
    if kind == "one_of":
        return f"Mapping[{literal(field['words'])}, Quantity]"
    if kind == "columns":
        return f"Mapping[{literal(field['words'])}, Quantities]"
    return TYPES[kind]


def function(module: str, name: str) -> str:
    word, kind = _registry.kinds(module)[name]
    lines = ["    *,"]
    if _registry.named(module, word):
        lines.append("    name: str | None = None,")
    for field in _registry.ordered(kind):
        end = "," if field["required"] else " | None = None,"
        lines.append(f"    {_registry.argument(field['name'])}: {hint(field)}{end}")
    text = _registry.documentation(module, {**kind, "word": word}).replace("\\", "\\\\")
    doc = indent(f'"""{text}\n"""', "    ", lambda line: line.strip() != "")
    arguments = "\n".join(lines) if len(lines) > 1 else ""
    head = f"def {name}(\n{arguments}\n) -> {TITLES[module][1]}:" if arguments else f"def {name}() -> {TITLES[module][1]}:"
    return f"{head}\n{doc}\n"


def stub(module: str) -> str:
    """The whole file."""
    title, _ = TITLES[module]
    names = list(_registry.kinds(module))
    imports = "from laval._types import Lateral, Named, ParameterRange, Point, Quantities, Quantity, Range, Tolerance"
    head = (
        f'"""{title}\n\nWritten by crates/laval-py/stubs.py from the registry of the library.\n"""\n\n'
        "from collections.abc import Mapping, Sequence\nfrom typing import Any, Literal\n\n"
        f"from laval._blocks import Extra, Part, Study\n{imports}\n\n"
        f"__all__ = {names!r}\n\ndef __getattr__(name: str) -> Any: ...\ndef __dir__() -> list[str]: ...\n"
    )
    return head + "\n" + "\n".join(function(module, name) for name in names)


def main() -> int:
    old = []
    for module in TITLES:
        path, text = FOLDER / f"{module}.pyi", stub(module)
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        old.append(path.name)
        if "--check" not in sys.argv:
            path.write_text(text, encoding="utf-8")
    if "--check" in sys.argv and old:
        print(f"not current: {', '.join(old)}; run python {Path(__file__).name}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
