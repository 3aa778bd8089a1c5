#!/usr/bin/env python3
"""Counts the classes within the tether on the two maps of [Liu2025] and compares their lengths.

run_cdt2025.py PROGRAM"""
import json
import pathlib
import subprocess
import sys

from run_cases import ask, report

MAPS = pathlib.Path(__file__).parent.parent / "scenes/maps/cdt2025"
TOLERANCE = 0.01  # The lengths are stored with two decimals.


def difference(answer, want):
    """The first way in which an answer differs from what is expected, or None."""
    lengths = [c["length"] for c in answer["classes"]]
    if len(lengths) != want["classes"]:
        return f"{len(lengths)} classes, wanted {want['classes']}"
    if not answer["complete"]:
        return "not complete"
    wrong = [(a, b) for a, b in zip(lengths, want["lengths"]) if abs(a - b) > TOLERANCE]
    return f"length {wrong[0][0]}, wanted {wrong[0][1]}" if wrong else None


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    results = []
    for name in ("maze", "mess"):
        data = json.loads((MAPS / f"{name}.json").read_text())
        limit = str(data["scene"]["tether"]["length"])
        for want in data["expected"]:
            goal = "{},{}".format(*want["goal"])
            try:
                answer = ask(sys.argv[1], data["scene"], ["classes", "--max-length", limit, "--to", goal])
                why = difference(answer, want)
            except (ValueError, KeyError, subprocess.TimeoutExpired) as error:
                why = f"{type(error).__name__}: {error}"
            results.append((f"{name} to {goal}", why))
    sys.exit(report(results))


if __name__ == "__main__":
    main()
