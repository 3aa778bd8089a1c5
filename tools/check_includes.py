#!/usr/bin/env python3
"""Checks every `#include "tautline/..."` against the table below.

check_includes.py [ROOT]

A file may include its own folder and the folders left of it; planners never include each other."""
import pathlib
import re
import sys

LEFT_TO_RIGHT = ["base", "network", "geometry", "scene", "homotopy", "cable", "planners", "draw"]
TOP = ["apps", "bench", "docs", "examples", "experiments", "fuzz", "tests"]
INCLUDE = re.compile(r'^\s*#\s*include\s+"tautline/([^"]+)"')


def rank(folder):
    return LEFT_TO_RIGHT.index(folder) if folder in LEFT_TO_RIGHT else len(LEFT_TO_RIGHT)


def fault(includer, included):
    """Why a file, given by its parts below tautline/ (None: above it), may not include another, or None."""
    if included[0] not in LEFT_TO_RIGHT:
        return f"{included[0]} is no folder of the table"
    if includer is None:
        return None
    if rank(included[0]) > rank(includer[0]):
        return f"{includer[0]} must not include {included[0]}"
    if includer[0] == included[0] == "planners" and includer[1] != included[1]:
        return "planners never include each other"
    return None


def check(root):
    """Every forbidden include below root, as text."""
    faults = []
    for top in ["tautline", *TOP]:
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            includer = path.relative_to(root / top).parts if top == "tautline" else None
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                why = match and fault(includer, match[1].split("/"))
                if why:
                    faults.append(f"{path.relative_to(root)}:{number}: {why}")
    return faults


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    print(*found, sep="\n", end="\n" if found else "")
    sys.exit(1 if found else 0)
