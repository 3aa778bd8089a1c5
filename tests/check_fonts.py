#!/usr/bin/env python3
"""Checks that a PNG without letters is announced: check_fonts.py PROGRAM"""
import os
import pathlib
import subprocess
import sys
import tempfile

from run_cases import report


def complaint(program, folder, *options, fonts):
    """What the program says on standard error when it draws, with the system's fonts or without any."""
    environment = dict(os.environ)
    if not fonts:
        configuration = pathlib.Path(folder) / "fonts.conf"
        configuration.write_text("<?xml version='1.0'?><fontconfig></fontconfig>")
        environment["FONTCONFIG_FILE"] = str(configuration)
    done = subprocess.run([program, "show", "scenes/two_ways.yaml", *options], cwd=".", env=environment, text=True,
                          capture_output=True, timeout=60)
    return done.stderr if done.returncode == 0 else f"exit {done.returncode}: {done.stderr}"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        png, svg = f"{folder}/show.png", f"{folder}/show.svg"
        results = []
        for options, fonts, warns in [(("--png", png), True, False), (("--png", png), False, True),
                                      (("--svg", svg), False, False), (("--quiet", "--png", png), False, False)]:
            said = complaint(program, folder, *options, fonts=fonts)
            right = said.count("\n") == 1 and "no font" in said if warns else said == ""
            results.append((f"{options[0]}, fonts {fonts}", None if right else f"said {said!r}"))
    sys.exit(report(results))


if __name__ == "__main__":
    main()
