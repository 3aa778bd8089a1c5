#!/usr/bin/env python3
"""Checks that objects compiled for wide vectors share no code with others: check_kernel_symbols.py OBJECTS

OBJECTS are paths separated by semicolons; only those whose names tell of wide vectors are looked at.

The linker keeps one copy of each function that several objects define weakly. One that was compiled for wide vectors
would then run everywhere, also on processors that lack them."""
import subprocess
import sys


def shared(path):
    """The weak functions and objects of an object file that are not its very own."""
    names = subprocess.run(["nm", "-C", "--defined-only", path], text=True, capture_output=True, check=True)
    found = []
    for line in names.stdout.splitlines():
        _, kind, name = line.split(maxsplit=2)
        # What a sanitizer, the exception handling or a type's description adds is data that is the same everywhere.
        data = ("DW.ref.", "__asan", "__tsan", "__ubsan", "typeinfo ")
        if kind in "WVu" and "EigenAvx" not in name and not name.startswith(data):
            found.append(name)
    return found


if __name__ == "__main__":
    wide = [path for path in sys.argv[1].split(";") if "kernels_avx" in path]
    faults = [f"{path}: {name}" for path in wide for name in shared(path)]
    print(*faults, sep="\n", end="\n" if faults else "")
    sys.exit(1 if faults or not wide else 0)
