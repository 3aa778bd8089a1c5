#!/usr/bin/env python3
"""Makes the scenes of scenario 2 of Shimada2024 from those of scenario 1: the robot drives to its goal, cable and robot
stay as they are, and the next goal is assigned.

    tools/make_deployed_scenes.py build/release/apps/cli/tautline

writes scenes/contact_free/NAME_deployed.yaml; with --check it only says which files would change (exit status 1).
"""

import argparse
import json
import math
import pathlib
import re
import subprocess
import sys

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "contact_free"

# Chosen so that the cable is in the way: most goals lie past the base, or on the other side of the cable.
NEXT_GOAL = {
    "dots_1": (1.2, 1.2),
    "dots_2": (1.2, 5.8),
    "dots_3": (8.0, 1.2),
    "dots_4": (10.4, 1.2),
    "dots_5": (1.2, 1.2),
    "complex_1": (1.2, 10.4),
    "complex_2": (1.2, 3.5),
    "complex_3": (12.7, 1.2),
    "complex_4": (12.7, 8.1),
    "complex_5": (8.1, 1.2),
}


def drive(program, scene):
    """What the planner makes of scenario 1."""
    run = subprocess.run([program, "plan", scene, "--contact-free", "--json", "--quiet"], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{scene}: exit status {run.returncode}: {run.stderr or run.stdout}")
    return json.loads(run.stdout)


def deployed(text, name, answer):
    """The scene of scenario 2, as text."""
    found = answer["contact_free"]
    cable = [[round(x, 3), round(y, 3)] for x, y in found["cable"]]
    # The heading as the last link has it: the robot looks away from its tail.
    heading = round(math.remainder(found["heading"], 2 * math.pi), 4)
    points = ", ".join(f"[{x:g}, {y:g}]" for x, y in cable)
    text = re.sub(r"^# (.*?) The robot unreels its cable\.$",
                  rf"# \1 The robot has been to the goal of {name}.yaml; its cable lies as it came to.",
                  text, count=1, flags=re.M)
    base, length = re.search(r"^tether: \{base: (\[.*?\]), length: (.*?)\}$", text, flags=re.M).groups()
    text = re.sub(r"^tether: .*$", f"tether:\n  base: {base}\n  length: {length}\n  laid: [{points}]", text, flags=re.M)
    text = re.sub(r"^robot: \{radius: (.*?)\}$", rf"robot: {{radius: \1, heading: {heading:g}}}", text, flags=re.M)
    x, y = NEXT_GOAL[name]
    return re.sub(r"^goal: .*$", f"goal: [{x:g}, {y:g}]", text, flags=re.M)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    changed = 0
    for name in NEXT_GOAL:
        scene = FOLDER / f"{name}.yaml"
        target = FOLDER / f"{name}_deployed.yaml"
        text = deployed(scene.read_text(), name, drive(arguments.program, scene))
        if target.exists() and target.read_text() == text:
            continue
        changed += 1
        print(target.relative_to(FOLDER.parent.parent))
        if not arguments.check:
            target.write_text(text)
    return 1 if arguments.check and changed else 0


if __name__ == "__main__":
    sys.exit(main())
