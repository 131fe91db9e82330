"""Parts of cases from the command line of any scheduler: ``python -m laval part FOLDER I/N``, ``python -m laval collect FOLDER``."""

from __future__ import annotations

import argparse
import sys


def main(arguments: list[str] | None = None) -> int:
    """Runs a command; 0 when it has done its work."""
    from laval import Cases

    parser = argparse.ArgumentParser(prog="python -m laval", description="Cases of a laval.Sweep, computed in parts.")
    commands = parser.add_subparsers(dest="command", required=True)
    part = commands.add_parser("part", help="compute one part of the cases in a folder")
    part.add_argument("folder")
    part.add_argument("part", metavar="I/N")
    part.add_argument("--threads", type=int, help="all of the computer unless given")
    for word, help in (("collect", "check all files"), ("plan", "say how the cases divide")):
        commands.add_parser(word, help=help).add_argument("folder")
    given = parser.parse_args(arguments)
    try:
        cases = Cases(given.folder)
        if given.command == "part":
            number, _, of = given.part.partition("/")
            if not (number.isdigit() and of.isdigit()):
                raise ValueError("give the number of the part and the number of all parts, as in 3/10")
            cases.part(int(number), int(of), threads=given.threads)
        elif given.command == "collect":
            cases.collect()
        print(f"{cases.done} of {cases.rows} cases in {cases.chunks} files, which is the largest number of parts")
    except (OSError, ValueError, LookupError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
