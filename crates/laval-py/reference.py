"""Writes `docs/python-reference.md`: the package's classes from their documentation, its functions of parts, studies and blocks from the registries.

    python crates/laval-py/reference.py          # write it
    python crates/laval-py/reference.py --check  # fail where it is not current
"""

from __future__ import annotations

import inspect
import re
import sys
from pathlib import Path
from typing import Any

import laval
from laval import _registry, designs

PAGE = Path(__file__).parents[2] / "docs" / "python-reference.md"
PAGES = {"parts": "parts.md", "studies": "studies.md", "blocks": "separation-blocks.md"}
TITLES = {"parts": "Parts", "studies": "Studies", "blocks": "Blocks beside them"}
CALLED = {"Machine", "Mode", "Peak", "Jump", "Sweep", "Cases"}
"""Classes that a user makes; others come from runs and functions."""
GROUPS = {
    "Machines": ["load", "loads", "from_ross", "Machine", "Parameter", "si", "span"],
    "Results": ["Results", "StudyResults", "Finding", "Value", "Evidence", "SpecialPoint", "Check", "Table", "Figure"],
    "Derivatives": ["Mode", "Peak", "Jump", "Derivatives", "Function"],
    "Many machines": ["Sweep", "Cases"],
    "Studio": ["studio", "Studio"],
    "Mistakes": ["MachineError", "Diagnostic", "MachineWarning", "Interrupted"],
    "Blocks of a machine": ["Block", "Part", "Study", "Extra"],
}


def signature(name: str, thing: Any) -> str:
    """As it is called, without types."""
    try:
        found = inspect.signature(thing)
    except (TypeError, ValueError):
        return name
    shown = []
    for parameter in found.parameters.values():
        if parameter.name == "self" or parameter.name.startswith("_"):
            continue
        if parameter.kind is parameter.KEYWORD_ONLY and "*" not in shown and not any(p.startswith("*") for p in shown):
            shown.append("*")
        star = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        default = "" if parameter.default is parameter.empty else f"={parameter.default!r}"
        shown.append(f"{star}{parameter.name}{default}")
        if parameter.kind is parameter.POSITIONAL_ONLY:
            shown.append("/")
    return f"{name}({', '.join(shown)})"


def first(doc: str | None) -> str:
    """The first sentence, as Markdown."""
    text = " ".join(inspect.cleandoc(doc or "").split("\n\n")[0].split())
    return re.sub(r":[a-z]+:`(?:~)?([^`]+)`", r"`\1`", text).replace("``", "`").replace("|", "\\|")


def whole(doc: str | None) -> str:
    """The documentation, as Markdown: what it takes and raises as lists."""
    text = re.sub(r":[a-z]+:`(?:~)?([^`]+)`", r"`\1`", inspect.cleandoc(doc or "")).replace("``", "`")
    out: list[str] = []
    listed = False
    for line in text.split("\n"):
        if line in ("Args:", "Raises:"):
            listed = True
            out += [{"Args:": "Arguments:", "Raises:": "Raises:"}[line], ""]
        elif listed and line.startswith("    ") and not line.startswith("     "):
            name, _, meaning = line.strip().partition(": ")
            out.append(f"- `{name}`: {meaning}")
        elif listed and line.strip():
            out.append("  " + line.strip())
        else:
            listed = listed and not line
            out.append(line)
    return re.sub(r"\n{3,}", "\n\n", re.sub(r"((?:^>>>.*\n?)+)", lambda m: f"```python no-run\n{m[1].rstrip()}\n```\n", "\n".join(out), flags=re.M)).strip()


def members(thing: type) -> list[tuple[str, str]]:
    """Methods, properties and documented attributes of a class of this package."""
    out = []
    for name, member in vars(thing).items():
        if name.startswith("_"):
            continue
        call = getattr(member, "__func__", member)
        if inspect.isfunction(call):
            out.append((signature(name, call), first(call.__doc__)))
        elif isinstance(member, property) or hasattr(member, "attrname"):
            out.append((name, first(member.__doc__)))
    documented = attributes(thing)
    return [(name, doc) for name, doc in documented if name not in {n for n, _ in out}] + out


def attributes(thing: type) -> list[tuple[str, str]]:
    """Attributes with a text behind them in the source."""
    try:
        source = inspect.getsource(thing)
    except (OSError, TypeError):
        return []
    # the last line of a documentation looks like an attribute
    source = re.sub(r'^( *(?:class|def) .*?:\n +)""".*?"""', r"\1", source, flags=re.M | re.S)
    found = re.findall(r'^ +(?:self\.)?([a-z]\w*)(?:: [^=\n]+)?(?: = [^\n]+)?\n +"""(.+?)"""$', source, re.M | re.S)
    return [(name, first(doc)) for name, doc in found]


def table(rows: list[tuple[str, str]]) -> str:
    return "\n".join(["| | |", "| --- | --- |", *(f"| `{name}` | {doc} |" for name, doc in rows)]) if rows else ""


def page() -> str:
    """The page."""
    missing = set(laval.__all__) - {name for group in GROUPS.values() for name in group} - {*PAGES, "designs", "__version__"}
    if missing:
        raise SystemExit(f"no group for {', '.join(sorted(missing))}")
    out = [
        "# Python: reference\n\nWritten by `crates/laval-py/reference.py` from the package and its registries. [Python](python.md) is the introduction, "
        "[many machines](many-machines.md) that to cases."
    ]
    for group, names in GROUPS.items():
        out.append(f"## {group}")
        for name in names:
            thing = getattr(laval, name)
            call = f"```python no-run\nlaval.{signature(name, thing)}\n```\n\n"
            made = not inspect.isclass(thing) or name in CALLED
            out.append(f"### {name}\n\n{call if made else ''}{whole(thing.__doc__)}")
            if inspect.isclass(thing):
                out.append(table(members(thing)))
                calls = ((n, getattr(m, "__func__", m)) for n, m in vars(thing).items() if not n.startswith("_"))
                long = [(n, c) for n, c in calls if inspect.isfunction(c) and ("Args:" in (c.__doc__ or "") or "Raises:" in (c.__doc__ or ""))]
                out += [f"#### {name}.{n}\n\n{whole(c.__doc__)}" for n, c in long]
    out.append("## Designs\n\n" + whole(designs.__doc__).split("\n\n")[0])
    for name in [n for n in designs.__all__ if n != "Design"]:
        thing = getattr(designs, name)
        out.append(f"### {name}\n\n```python no-run\nlaval.designs.{signature(name, thing)}\n```\n\n{whole(thing.__doc__)}")
    for module, file in PAGES.items():
        rows = []
        for name, (_, kind) in _registry.kinds(module).items():
            doc = first(kind["doc"]).split(". ")[0].rstrip(".")
            rows.append((signature(name, getattr(getattr(laval, module), name)), doc))
        about = f"Functions of `laval.{module}`, with the keys of the machine file; [{file}]({file}) describes each key, `help(laval.{module}.NAME)` does so in Python."
        out.append(f"## {TITLES[module]}\n\n{about}\n\n{table(rows)}")
    return "\n\n".join(part for part in out if part).replace("\n\n\n", "\n\n") + "\n"


def main() -> int:
    text = page()
    if PAGE.exists() and PAGE.read_text(encoding="utf-8") == text:
        return 0
    if "--check" in sys.argv:
        print(f"not current: {PAGE.name}; run python crates/laval-py/reference.py")
        return 1
    PAGE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
