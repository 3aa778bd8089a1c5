#!/usr/bin/env python3
"""Runs the cases of tests/cases through the program and compares with the answers stored in them.

run_cases.py PROGRAM [NAME_PREFIX...]

A case is a JSON file: `command` (a list), `scene` (or an ASCII `grid` with `base` and `length`), `expect`, `tolerance` (relative, for every length) and
a `note`. What `expect` may hold is what `difference` looks for."""
import json
import pathlib
import subprocess
import sys
import tempfile

EXIT_STATUS = {"solved": 0, "infeasible": 3, "budget_exceeded": 3}
TIMEOUT_S = 120


def close(a, b, tolerance):
    return abs(a - b) <= tolerance * max(1.0, abs(b))


def write_grid(case, folder):
    """The scene of a case that draws its grid: '#' is blocked, `base` is column and row from the upper left."""
    grid = case["grid"]
    rows = "".join(row.replace("#", "@") + "\n" for row in grid)
    pathlib.Path(folder, "grid.map").write_text(
        f"type octile\nheight {len(grid)}\nwidth {len(grid[0])}\nmap\n{rows}")
    column, row = case["base"]
    return {"world": {"map": "grid.map"},
            "tether": {"base": [column + 0.5, len(grid) - row - 0.5], "length": case["length"]}}


def ask(program, scene, command):
    """The program's JSON answer to a command on a scene, or on a case with a grid; ValueError when it gives none."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "scene.json")
        path.write_text(json.dumps(write_grid(scene, folder) if "grid" in scene else scene))
        words = 2 if command[0] in ("workspace", "fleet", "learn") else 1
        process = subprocess.run([program, *command[:words], path, *command[words:], "--json"],
                                 capture_output=True, text=True, timeout=TIMEOUT_S)
    try:
        answer = json.loads(process.stdout)
    except ValueError:
        raise ValueError(f"exit {process.returncode}: {process.stderr.strip()[:200]}") from None
    if process.returncode != EXIT_STATUS[answer["status"]]:
        raise ValueError(f"exit {process.returncode} with status {answer['status']}")
    return answer


def words_by_length(lengths, words, tolerance):
    """Groups of equal length, each with its words sorted: classes of one length may come in any order."""
    groups = []
    for length, word in zip(lengths, words):
        if not groups or not close(length, groups[-1][0], tolerance):
            groups.append((length, []))
        groups[-1][1].append(word)
    return [sorted(group) for _, group in groups]


def class_difference(got, want, tolerance):
    """The first way in which a list of classes differs from what is expected, or None."""
    lengths = [c["length"] for c in got]
    if "count" in want and len(got) != want["count"]:
        return f"{len(got)} classes, wanted {want['count']}"
    for i, (a, b) in enumerate(zip(lengths, want.get("lengths", []))):
        if not close(a, b, tolerance):
            return f"length {a} of class {i}, wanted {b}"
    if "words" in want:
        found = words_by_length(want["lengths"], [c["word"] for c in got], tolerance)
        wanted = words_by_length(want["lengths"], want["words"], tolerance)
        if found != wanted:
            return f"words {found}, wanted {wanted}"
    return None


def motion_difference(got, want, tolerance):
    """The first way in which a motion or a tour in a workspace differs from what is expected, or None."""
    if got["command"] not in ("workspace move", "workspace tour"):
        return None
    for key in ("status", "reason", "order", "optimal"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    for key in ("length", "duration"):
        if key in want and not close(got[key], want[key], tolerance):
            return f"{key} {got[key]}, wanted {want[key]}"
    return None


def reach_difference(got, want, tolerance):
    """The first way in which a reach differs from what is expected, or None. `at` is the least tether to the point,
    `rings` the number of rings of the boundary, `words` those of all sheets in any order."""
    found = {"status": got["status"], "reason": got.get("reason"), "classes": got.get("classes"),
             "rings": len(got.get("regions", [])), "words": sorted(s["word"] for s in got.get("sheets", []))}
    for key in found:
        expected = sorted(want[key]) if key == "words" and key in want else want.get(key)
        if key in want and found[key] != expected:
            return f"{key} {found[key]}, wanted {expected}"
    lengths = {"area": got.get("area"), "sheet_area": got.get("sheet_area"),
               "at": got.get("at", {}).get("least_tether", {}).get("length")}
    for key, value in lengths.items():
        if key in want and (value is None or not close(value, want[key], tolerance)):
            return f"{key} {value}, wanted {want[key]}"
    return None


def workspace_difference(got, want, tolerance):
    """The first way in which a workspace, a pose or a list of boundaries differs from what is expected, or None.
    `lengths` are those of the sides, `areas` those of the boundaries of a list."""
    if "count" in want or "areas" in want:
        areas = [b["area"] for b in got["boundaries"]]
        if len(areas) != want.get("count", len(areas)) or got["complete"] is not True:
            return f"{len(areas)} boundaries, complete: {got['complete']}, wanted {want['count']}"
        found = {"areas": areas}
    else:
        found = {"area": got.get("area"), "margin": got.get("margin"),
                 "lengths": [s["length"] for s in got.get("sides", [])],
                 "max_cable_lengths": got.get("max_cable_lengths"), "boundary": got.get("boundary"),
                 "cable_lengths": [c["length"] for c in got.get("cables", [])]}
    for key in ("status", "reason", "words", "position", "spans", "touches"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    for key, value in found.items():
        if key in want and not all_close(value, want[key], tolerance):
            return f"{key} {value}, wanted {want[key]}"
    return None


def fleet_plan_difference(got, want, tolerance):
    """The first way in which a fleet's plan differs from what is expected, or None. `deadlocked_pairs` are positions
    from 1, or names; `chains` the labels along each path; `makespan` that of straight paths without a detour."""
    for key in ("status", "reason", "robots", "pair_graph", "detours", "entangled", "network_deadlocks"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    if "realizable" not in want:
        return None
    names = [robot["robot"] for robot in got["schedule"]]
    pairs = [[p if isinstance(p, str) else names[p - 1] for p in pair] for pair in want["deadlocked_pairs"]]
    if got["deadlocked_pairs"] != pairs:
        return f"deadlocked_pairs {got['deadlocked_pairs']}, wanted {pairs}"
    for key, mode in (("realizable", "straight-concurrent"), ("sequential", "straight-sequential")):
        if got["modes"][mode] != want[key]:
            return f"{mode} {got['modes'][mode]}, wanted {want[key]}"
    chains = {c["robot"]: ["/".join(e["passings"]) for e in c["events"] if "passings" in e]
              for c in got["event_graph"]["chains"]}
    if "chains" in want and chains != want["chains"]:
        return f"chains {chains}, wanted {want['chains']}"
    if want["realizable"] and not close(got["travel_time"], want["makespan"], tolerance):
        return f"travel_time {got['travel_time']}, wanted {want['makespan']}"
    return None


def all_close(got, want, tolerance):
    """Whether two numbers, or two lists of such, agree."""
    if isinstance(want, list):
        return isinstance(got, list) and len(got) == len(want) and all(
            all_close(a, b, tolerance) for a, b in zip(got, want))
    return got is not None and close(got, want, tolerance)


def manifold_difference(got, want, tolerance):
    """The first way in which a manifold differs from what is expected, or None."""
    for key in ("status", "reason", "vertices", "edges", "multiplicity", "classes"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    if "max_distance" in want and not close(got["max_distance"], want["max_distance"], tolerance):
        return f"max_distance {got['max_distance']}, wanted {want['max_distance']}"
    return None


def drive_difference(got, want, tolerance):
    """The first way in which a drive differs from what is expected, or None. `reached` and `untanglings` are those of
    each goal."""
    found = {"status": got["status"], "reason": got.get("reason"), "contacts": got.get("cable_robot_contacts"),
             "reached": [goal["reached"] for goal in got.get("goals", [])],
             "untanglings": [goal["untanglings"] for goal in got.get("goals", [])]}
    for key in found:
        if key in want and found[key] != want[key]:
            return f"{key} {found[key]}, wanted {want[key]}"
    if "time" in want and not close(got["time"], want["time"], tolerance):
        return f"time {got['time']}, wanted {want['time']}"
    return None


def reference_difference(got, want, tolerance):
    """The first way in which a reference path differs from what is expected, or None. `fits` and `tethers` are those of
    the classes, `yen` the words that the paper's way finds, `ends` those of the tracked paths."""
    found = {"status": got["status"], "reason": got.get("reason"), "word": got.get("word"),
             "fits": [c["fits"] for c in got["classes"]], "yen": [c["word"] for c in got.get("yen", {}).get("classes", [])],
             "yen_reason": got.get("yen", {}).get("reason"), "ends": [t.get("end") for t in got.get("tracked", [])]}
    for key in found:
        if key in want and found[key] != want[key]:
            return f"{key} {found[key]}, wanted {want[key]}"
    lengths = {"length": got.get("length"), "tether": got.get("tether", {}).get("length"),
               "shortest_tether": got.get("shortest_tether", {}).get("length"),
               "tethers": [c["tether"]["length"] for c in got["classes"]]}
    for key, value in lengths.items():
        if key in want and not all_close(value, want[key], tolerance):
            return f"{key} {value}, wanted {want[key]}"
    return class_difference(got["classes"], want, tolerance)


def drive_of_policy_difference(got, want, tolerance):
    """The first way in which a policy's drive differs from what is expected, or None."""
    for key in ("status", "reason", "success", "cable_robot_steps", "cable_obstacle_steps"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    found = {"length": got.get("length"), "time": got.get("time"), "reference": got.get("reference", {}).get("length")}
    for key, value in found.items():
        if key in want and not all_close(value, want[key], tolerance):
            return f"{key} {value}, wanted {want[key]}"
    return None


def difference(got, want, tolerance):
    """The first way in which an answer differs from what is expected, or None."""
    if got["command"] == "fleet plan":
        return fleet_plan_difference(got, want, tolerance)
    if got["command"].startswith("workspace"):
        return workspace_difference(got, want, tolerance)
    if got["command"] == "drive":
        return drive_difference(got, want, tolerance)
    if got["command"] == "learn reference":
        return reference_difference(got, want, tolerance)
    if got["command"] == "manifold":
        return manifold_difference(got, want, tolerance)
    if got["command"] == "reach":
        return reach_difference(got, want, tolerance)
    if got["command"] == "learn evaluate":
        return drive_of_policy_difference(got, want, tolerance)
    if "classes" in got:
        return class_difference(got["classes"], want, tolerance)
    for key in ("status", "reason", "word", "homology"):
        if key in want and got.get(key) != want[key]:
            return f"{key} {got.get(key)}, wanted {want[key]}"
    if "length" in want and not close(got["length"], want["length"], tolerance):
        return f"length {got['length']}, wanted {want['length']}"
    if "words" in want and got["tether"]["word"] not in want["words"]:
        return f"word at the goal {got['tether']['word']}, wanted one of {want['words']}"
    return None


def report(results):
    """Prints the (name, fault or None) pairs that have a fault; the exit status."""
    faults = [(name, why) for name, why in results if why]
    for name, why in faults:
        print(f"{name}: {why}")
    print(f"{len(results) - len(faults)} of {len(results)} agree")
    return 1 if faults or not results else 0


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, prefixes = sys.argv[1], tuple(sys.argv[2:]) or ("",)
    results = []
    for path in sorted(pathlib.Path(__file__).parent.glob("cases/*.json")):
        if not path.name.startswith(prefixes):
            continue
        case = json.loads(path.read_text())
        try:
            answer = ask(program, case.get("scene", case), case["command"])
            why = difference(answer, case["expect"], case["tolerance"])
            why = why or motion_difference(answer, case["expect"], case["tolerance"])
        except (ValueError, KeyError, subprocess.TimeoutExpired) as error:
            why = f"{type(error).__name__}: {error}"
        results.append((path.name, why))
    sys.exit(report(results))


if __name__ == "__main__":
    main()
