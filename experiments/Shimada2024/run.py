#!/usr/bin/env python3
"""Prints the tables of README.md beside this file again from the runs that are kept, and checks that the page holds them.

run.py PROGRAM [--write | --again THREADS]

PROGRAM is `tautline`. The runs are in compare.json, as `learn compare --checkpoint` keeps them; jobs that it lacks are
run. --write puts tables and picture into the page. --again forgets all runs and makes them anew, which takes about
20 minutes on two cores, and writes."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SCENES = HERE.parent.parent / "scenes/contact_free"
GROUPS = ["dots_{}", "two_bars_{}", "dots_{}_deployed", "complex_{}_deployed"]
BEGIN, END = "<!-- run:tables -->\n", "<!-- /run:tables -->\n"


def command(program, checkpoint, *options):
    scenes = [str(SCENES / (group.format(i) + ".yaml")) for group in GROUPS for i in range(1, 6)]
    return [program, "learn", "compare", *scenes, "--seeds", "3", "--penalty", "-1", "0", "--penalty-groups",
            "dots_deployed", "--ablation-groups", "two_bars", "--general", str(SCENES / "general.onnx"),
            "--checkpoint", str(checkpoint), *options]


def main():
    if len(sys.argv) not in (2, 3, 4) or (len(sys.argv) > 2 and sys.argv[2] not in ("--write", "--again")):
        sys.exit(__doc__)
    program, mode = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
    page, kept = HERE / "README.md", HERE / "compare.json"
    with tempfile.TemporaryDirectory() as folder:
        checkpoint = pathlib.Path(folder) / "compare.json"
        if mode != "--again":
            shutil.copy(kept, checkpoint)
        options = ["--threads", sys.argv[3]] if mode == "--again" else ["--kernels", "portable"]
        if mode:
            options += ["--svg", str(HERE / "img/paths.svg")]
        done = subprocess.run(command(program, checkpoint, *options), capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"exit {done.returncode}: {done.stderr.strip()}")
        if mode:
            shutil.copy(checkpoint, kept)
    text = page.read_text()
    head, rest = text.split(BEGIN)
    shown, tail = rest.split(END)
    tables = "\n" + done.stdout
    if mode:
        page.write_text(head + BEGIN + tables + END + tail)
    elif shown != tables:
        sys.exit(f"the page does not show what the kept runs say:\n{tables}")
    print(f"{len(done.stdout.splitlines())} lines agree")


if __name__ == "__main__":
    main()
