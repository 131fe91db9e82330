#!/usr/bin/env python3
"""Compares the numbers of two output folders of laval: findings of results.json and columns of all tables.

    tools/compare-runs.py BEFORE AFTER [--tolerance 1e-12]

Prints one line for each column or finding whose values differ by more than the tolerance relative to the largest
value of the column, and for each that only one folder has. The exit code is 1 where there is such a line.
"""
import argparse
import csv
import json
import math
from collections import Counter
from pathlib import Path

WORDS = {"inf": math.inf, "-inf": -math.inf, "NaN": math.nan, "nan": math.nan}


def number(cell):
    """The number in a cell, or None."""
    try:
        return WORDS[cell] if cell in WORDS else float(cell)
    except (TypeError, ValueError):
        return None


def difference(a, b):
    """Largest difference of two lists over the largest finite value in both; infinite where NaN, infinity or text differ."""
    if len(a) != len(b):
        return math.inf
    numbers = [(number(x), number(y)) for x, y in zip(a, b)]
    size = max((abs(v) for pair in numbers for v in pair if v is not None and math.isfinite(v)), default=0.0)
    worst = 0.0
    for (x, y), (text, other) in zip(numbers, zip(a, b)):
        if text == other or (x is not None and y is not None and math.isnan(x) and math.isnan(y)):
            continue
        if x is None or y is None or not (math.isfinite(x) and math.isfinite(y)):
            return math.inf
        worst = max(worst, abs(x - y) / size)
    return worst


def tables(folder):
    """Columns by table and name."""
    out = {}
    for path in sorted(folder.rglob("*.csv")):
        with path.open(newline="") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        for column in zip(*rows):
            out[f"{path.relative_to(folder).with_suffix('')}: {column[0]}"] = list(column[1:])
    return out


def findings(folder):
    """Values of findings and of their evidence by study, id and subject; those that occur several times are numbered."""
    out, seen = {}, Counter()
    for path in sorted(folder.rglob("results.json")):
        for study in json.loads(path.read_text())["studies"]:
            for finding in study["findings"]:
                name = " ".join(filter(None, [study["name"], finding["id"], finding.get("subject")]))
                seen[name] += 1
                name = name if seen[name] == 1 else f"{name} ({seen[name]})"
                if finding.get("value") is not None:
                    out[name] = [str(finding["value"])]
                for k, evidence in enumerate(finding.get("evidence", [])):
                    out[f"{name}, evidence {k + 1}: {evidence['what']}"] = [str(evidence["value"])]
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("before", type=Path)
    parser.add_argument("after", type=Path)
    parser.add_argument("--tolerance", type=float, default=1e-12)
    given = parser.parse_args()
    lines, compared = [], 0
    for read in (findings, tables):
        before, after = read(given.before), read(given.after)
        for name in sorted(before.keys() | after.keys()):
            if name not in after or name not in before:
                lines.append(f"only {'before' if name in before else 'after'}: {name}")
                continue
            compared += 1
            d = difference(before[name], after[name])
            if not d <= given.tolerance:
                rows = "" if len(before[name]) == len(after[name]) else f" ({len(before[name])} and {len(after[name])} rows)"
                lines.append(f"{d:8.1e}  {name}{rows}")
    print("\n".join(lines))
    print(f"{compared} compared, {len(lines)} differ")
    return 1 if lines or compared == 0 else 0


if __name__ == "__main__":
    raise SystemExit(main())
