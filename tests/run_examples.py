#!/usr/bin/env python3
"""Runs the programs of examples/, built against an installed tautline, and compares what they print with the program
`tautline` of the same installation.

run_examples.py BUILD PREFIX: BUILD holds a folder for each example, PREFIX/bin the program. Run it in the root of the
repository."""
import json
import pathlib
import subprocess
import sys
import tempfile

from run_cases import report

SCENE = "scenes/store_room.yaml"


def call(*command):
    done = subprocess.run([str(c) for c in command], text=True, capture_output=True, timeout=120,
                          stdin=subprocess.DEVNULL)
    return done.returncode, done.stdout.splitlines(), done.stderr


def plan_once(build, _):
    """It prints what the README says."""
    want = (0, ["13 6", "12 7", "4 7", "4 3", "12 3", "13 4"], "")
    got = call(build / "plan_once/plan_once")
    return None if got == want else f"{got}, wanted {want}"


def tick(program, goal):
    """What a tick of replan must say about a goal, asked of the program."""
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as scene:
        scene.writelines(f"goal: [{goal[0]}, {goal[1]}]\n" if line.startswith("goal:") else line
                         for line in pathlib.Path(SCENE).read_text().splitlines(keepends=True))
        scene.flush()
        answer = json.loads("\n".join(call(program, "plan", scene.name, "--json")[1]))
    said = f"solved {answer['length']:.4f} m" if answer["status"] == "solved" else f"infeasible {answer['reason']}"
    return f"goal {goal[0]:.3f} {goal[1]:.3f}  {said}"


def replan(build, program):
    """The goal goes around the crate, and beyond the tether."""
    status, lines, errors = call(build / "replan/replan", SCENE, "11.6,6.6", "0.6")
    if status != 0 or errors or len(lines) != 31:
        return f"exit {status}, {len(lines)} lines, {errors}"
    for i, line in enumerate(lines):
        share = i / 30
        goal = (4.2 + share * (11.6 - 4.2), 6.5 + share * (6.6 - 6.5))
        want = f"{i / 50:.2f} s  {tick(program, goal)}"
        if line != want:
            return f"tick {i}: {line!r}, wanted {want!r}"
    if len({line.split()[5] for line in lines}) != 2 or not any("tether_too_short" in line for line in lines):
        return f"the line of the goal shows too little: {lines}"
    return None


def replan_complains(build, _):
    status, lines, errors = call(build / "replan/replan", "scenes/no_such.yaml", "1,1", "1")
    return None if status == 2 and not lines and errors.count("\n") == 1 else f"exit {status}, {lines}, {errors}"


def list_classes(build, program):
    ends, limit = ("3.5,45.5", "45.5,3.5"), "68"
    status, lines, errors = call(build / "list_classes/list_classes", "scenes/maps/movingai/arena.map", *ends, limit)
    answer = json.loads("\n".join(call(program, "classes", "scenes/arena.yaml", "--from", ends[0], "--to", ends[1],
                                       "--max-length", limit, "--json")[1]))
    want = [f"{c['length']:.4f}  {' '.join(c['word'])}" for c in answer["classes"]]
    if not answer["complete"] or len(want) < 3:
        return f"the question shows too little: {len(want)} classes"
    return None if (status, lines, errors) == (0, want, "") else f"exit {status}, {lines}, {errors}, wanted {want}"


def list_classes_none(build, _):
    """No class is shorter than the straight line."""
    got = call(build / "list_classes/list_classes", "scenes/maps/movingai/arena.map", "3.5,45.5", "45.5,3.5", "59")
    return None if got == (3, [], "") else f"{got}"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    build, program = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]) / "bin/tautline"
    checks = [plan_once, replan, replan_complains, list_classes, list_classes_none]
    examples = {path.name for path in pathlib.Path("examples").iterdir() if (path / "CMakeLists.txt").exists()}
    results = [(f"examples/{name}", "is not checked") for name in examples - {c.__name__ for c in checks}]
    results += [(check.__name__, check(build, program)) for check in checks]
    sys.exit(report(results))


if __name__ == "__main__":
    main()
