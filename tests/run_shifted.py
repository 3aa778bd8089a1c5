#!/usr/bin/env python3
"""Asks the questions of tests/cases again far from the origin, and what a millimetre decides there.

run_shifted.py PROGRAM [NAME_PREFIX...]

Every scene is moved to the edges of the range of coordinates. Status and words must stay, and lengths up to TOLERANCE_M:
coordinates near 1e7 m have a spacing of 2e-9 m, and the grid there one of 7.5e-9 m."""
import copy
import json
import pathlib
import subprocess
import sys

from run_cases import ask, report, words_by_length

SHIFTS = [(9_980_877.125, -9_979_001.5), (-9_970_000.3, 9_876_543.21)]
TOLERANCE_M = 1e-6
# They ask from a vertex where obstacles touch: far from the origin no point is exactly that vertex.
EXACT = {"reach_touching.json", "classes_word_touching_courtyard.json", "classes_word_touching_outside.json"}

GATE = {"world": {"outline": [[0, 0], [10, 0], [10, 6], [0, 6]],
                  "obstacles": [{"name": "low", "polygon": [[4.9, -1], [5.1, -1], [5.1, 2.9995], [4.9, 2.9995]]},
                                {"name": "high", "polygon": [[4.9, 3.0005], [5.1, 3.0005], [5.1, 7], [4.9, 7]]},
                                {"name": "pin", "polygon": [[7, 2.9995], [7.001, 2.9995], [7.001, 3.0005], [7, 3.0005]]}]},
        "tether": {"base": [1, 3], "length": 9}, "goal": [9, 3]}


def moved(value, shift, key=""):
    """A part of a scene with every point moved; `key` is what it stands under."""
    if key == "circle":
        return [value[0] + shift[0], value[1] + shift[1], value[2]]
    if isinstance(value, dict):
        return {k: moved(v, shift, k) for k, v in value.items()}
    if not isinstance(value, list):
        return value
    if len(value) == 2 and all(isinstance(v, (int, float)) for v in value):
        return [value[0] + shift[0], value[1] + shift[1]]
    return [moved(v, shift, key) for v in value]


def moved_command(command, shift):
    """The points of --from, --to and --at move, too."""
    command = list(command)
    for option in ("--from", "--to", "--at"):
        if option in command:
            i = command.index(option) + 1
            x, y = map(float, command[i].split(","))
            command[i] = f"{x + shift[0]!r},{y + shift[1]!r}"
    return command


def facts(answer):
    """Status, lengths and words of an answer."""
    classes = answer.get("classes", [])
    if isinstance(classes, int):  # How many there are, of reach.
        classes = []
    lengths = [c["length"] for c in classes]
    words = words_by_length(lengths, [c["word"] for c in classes], TOLERANCE_M)
    word = answer.get("word", answer.get("tether", {}).get("word"))
    found = [answer[key] for key in ("length", "shortest_tether", "area", "sheet_area") if key in answer]
    lengths += [each["length"] if isinstance(each, dict) else each for each in found]
    return (answer["status"], answer.get("reason"), word, words), lengths


def difference(got, want):
    """The first way in which two answers differ, or None."""
    (got_rest, got_lengths), (want_rest, want_lengths) = facts(got), facts(want)
    if got_rest != want_rest:
        return f"{got_rest}, at home {want_rest}"
    for a, b in zip(got_lengths, want_lengths):
        if abs(a - b) > TOLERANCE_M:
            return f"length {a}, at home {b}"
    return None


def case_results(program, prefixes):
    for path in sorted(pathlib.Path(__file__).parent.glob("cases/*.json")):
        if not path.name.startswith(prefixes) or path.name in EXACT:
            continue
        case = json.loads(path.read_text())
        if case["command"][0] == "manifold" or "--contact-free" in case["command"] or "evaluate" in case["command"]:
            continue  # Cells lie where the outline or the map begins, or at the origin: nothing to be shifted against.
        home = ask(program, case["scene"], case["command"])
        for shift in SHIFTS:
            there = ask(program, moved(case["scene"], shift), moved_command(case["command"], shift))
            ties = not {"word", "words", "lengths"} & set(case["expect"])
            if "tether" in home and (ties or there["tether"]["word"] in case["expect"].get("words", [])):
                there["tether"]["word"] = home["tether"]["word"]  # One of several that are equally good.
            yield f"{path.name} at {shift}", difference(there, home)


def gate_results(program):
    """A gap of 1 mm passes with no clearance and is closed by 0.6 mm; a pin of 1 mm is an obstacle."""
    for shift in [(0, 0), *SHIFTS]:
        scene = moved(GATE, shift)
        answer = ask(program, scene, ["plan", "--verify"])
        fault = None if answer["status"] == "solved" and abs(answer["length"] - 8) < 1e-3 else f"{answer['status']}"
        yield f"gap of 1 mm at {shift}", fault
        found = ask(program, scene, ["classes", "--count", "2", "--verify"])["classes"]
        words = sorted(c["word"] for c in found)
        yield f"pin of 1 mm at {shift}", None if words == [[], ["pin"]] else f"words {words}"
        closed = copy.deepcopy(scene)
        closed["world"]["clearance"] = 0.0006
        answer = ask(program, closed, ["plan"])
        yield f"gap closed by 0.6 mm at {shift}", None if answer.get("reason") == "goal_unreachable" else str(answer)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, prefixes = sys.argv[1], tuple(sys.argv[2:]) or ("",)
    try:
        results = [*gate_results(program), *case_results(program, prefixes)]
    except (ValueError, KeyError, subprocess.TimeoutExpired) as error:
        sys.exit(f"{type(error).__name__}: {error}")
    sys.exit(report(results))


if __name__ == "__main__":
    main()
