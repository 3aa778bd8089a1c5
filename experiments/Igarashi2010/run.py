#!/usr/bin/env python3
"""Runs the experiment of README.md beside this file and checks that the page's tables hold what it finds.

run.py PROGRAM [--write] [--runs FILE] [--again N] [--only ALGORITHM]

PROGRAM is `tautline`. Each finished run is a line of FILE (default: runs.jsonl beside this file); runs that are there,
of the same scene and options, are not run again, so an experiment that was stopped goes on. --again: the quick runs of
the first N orders are made again and must equal those of FILE. --only: nothing but the runs of this algorithm on the
layouts. With --write, the tables and pictures of the page are made again; without it, a table that has changed is a
fault."""
import argparse
import difflib
import hashlib
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile

import yaml

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT_S = 1800
LAYOUTS = ["layout1", "layout2", "layout3"]
ORDERS = 10
HEURISTIC = ["--untangle", "heuristic"]
ALGORITHMS = {
    "basic": ["--controller", "basic"],
    "extended": [*HEURISTIC, "--no-deadlock-prevention"],
    "areas": [*HEURISTIC, "--deadlock-prevention", "areas"],
    "prevention": [*HEURISTIC, "--deadlock-prevention", "both"],
    "lookahead": [*HEURISTIC, "--deadlock-prevention", "lookahead"],
    "search": ["--untangle", "both", "--search-trials", "60", "--no-deadlock-prevention"],
    "retreat": ["--untangle", "both", "--search-trials", "60", "--no-deadlock-prevention", "--keep-retreat"],
    "retract": ["--controller", "retract"],
}
# What --again makes again: runs of seconds.
AGAIN = [("layout1", "basic"), ("layout1", "prevention"), ("layout2", "basic"), ("layout2", "prevention"),
         ("layout2", "retract"), ("layout3", "basic"), ("layout3", "extended")]
# Maps whose cells have 1 m take a robot of their size.
METRE_CELLS = ["--robot-radius", "0.4", "--speed", "1", "--link", "0.25", "--dt", "0.1"]
MAPS = {
    "depot": ["--resolution", "0.1"],
    "tb3_sandbox": ["--resolution", "0.1"],
    "willow": ["--resolution", "0.1"],
    "intel_lab": ["--resolution", "0.1"],
    "westport_house": ["--resolution", "0.1"],
    **{name: METRE_CELLS for name in ("arena", "den312d", "lak104d", "maze-32-32-2", "random-32-32-10",
                                      "room-64-64-16", "empty-16-16")},
}
MAP_ALGORITHMS = ["basic", "extended", "prevention", "retract"]
# Table 1: success ratio, average time, average collisions of cable and robot, by layout.
PAPER = {
    "basic": [(1.0, 83.9, 1.8), (1.0, 100.4, 1.7), (1.0, 88.5, 2)],
    "extended": [(0.8, 100.9, 0.25), (0.5, 103.2, 0.4), (0.8, 93.0, 0.125)],
    "prevention": [(1.0, 89.4, 0.4), (1.0, 110.4, 0.3), (1.0, 92.5, 0.2)],
}


def orders():
    """Ten permutations of six targets, the same for all layouts and algorithms."""
    rng = random.Random(2010)
    return [rng.sample(range(6), 6) for _ in range(ORDERS)]


def scene_file(scene):
    return HERE / "scenes" / f"{scene}.yaml"


def key_of(scene, order, options):
    text = scene_file(scene).read_text() + json.dumps([order, options])
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def run(program, scene, order, options, extra=()):
    """One drive: what of its result is kept."""
    tasks = yaml.safe_load(scene_file(scene).read_text())["tasks"]
    goals = "".join(f"{tasks[i][0]} {tasks[i][1]}\n" for i in order)
    done = subprocess.run([program, "drive", scene_file(scene), "--goals", "-", "--json", *options, *extra],
                          input=goals, capture_output=True, text=True, timeout=TIMEOUT_S)
    if done.returncode not in (0, 3):
        raise RuntimeError(f"{scene} {order} {options}: exit {done.returncode}: {done.stderr.strip()}")
    answer = json.loads(done.stdout)
    return {"success": answer["success"], "time": round(answer["time"], 3), "contacts": answer["cable_robot_contacts"],
            "untanglings": sum(goal["untanglings"] for goal in answer["goals"]),
            "visited": sum(goal["reached"] for goal in answer["goals"]), "vertices": answer["vertices"],
            "at": [c["at"] for c in answer["contacts"] if c["kind"] == "cable-robot"]}


class Runs:
    """Finished runs in a file, one a line. What a kill leaves of a line is dropped."""

    def __init__(self, path):
        self.path, self.found = path, {}
        if not path.exists():
            return
        text = path.read_text()
        whole = text[:text.rfind("\n") + 1]
        if whole != text:
            path.write_text(whole)
        for line in whole.splitlines():
            record = json.loads(line)
            self.found[record["key"]] = record

    def get(self, program, scene, algorithm, order, extra=()):
        options = [*ALGORITHMS[algorithm], *extra]
        key = key_of(scene, order, options)
        if key not in self.found:
            record = {"key": key, "scene": scene, "algorithm": algorithm, "order": order,
                      **run(program, scene, order, options)}
            with self.path.open("a") as file:
                file.write(json.dumps(record) + "\n")
                file.flush()
                os.fsync(file.fileno())
            self.found[key] = record
        return self.found[key]

    def on_map(self, program, name, algorithm):
        return self.get(program, f"maps/{name}", algorithm, list(range(5)), MAPS[name])


def number(x, digits):
    return f"{x:.{digits}f}"


def average(records, name):
    return sum(record[name] for record in records) / len(records) if records else float("nan")


def row(algorithm, found, paper):
    """One algorithm: success, time of successful runs, contacts; each layout found (paper)."""
    cells = [algorithm]
    for what, digits in (("success", 0), ("time", 1), ("contacts", 2)):
        for i in range(len(LAYOUTS)):
            records = found[i]
            done = [record for record in records if record["success"]]
            if what == "success":
                text, printed = f"{100 * average(records, 'success'):.0f} %", paper and f"{100 * paper[i][0]:.0f} %"
            elif what == "time":
                text, printed = number(average(done, "time"), 1) if done else "-", paper and number(paper[i][1], 1)
            else:
                text, printed = number(average(records, "contacts"), 2), paper and f"{paper[i][2]:g}"
            cells.append(f"{text} ({printed})" if printed else text)
    return cells


def table(head, rows):
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [head, ["---"] * len(head), *rows])


def tables(runs, program):
    head = ["algorithm"] + [f"{what} {i}" for what in ("success", "time, s,", "contacts") for i in (1, 2, 3)]
    rows, more = [], []
    for algorithm in ALGORITHMS:
        found = [[runs.get(program, layout, algorithm, order) for order in orders()] for layout in LAYOUTS]
        rows.append(row(algorithm, found, PAPER.get(algorithm)))
        more.append([algorithm] + [number(average(records, "untanglings"), 1) for records in found] +
                    [number(average(records, "visited"), 1) for records in found])
    maps = []
    for name in MAPS:
        found = [runs.on_map(program, name, algorithm) for algorithm in MAP_ALGORITHMS]
        maps.append([name, str(found[0]["vertices"])] + [str(record["visited"]) for record in found] +
                    [str(record["contacts"]) for record in found])
    head_maps = ["map", "vertices"] + [f"{what} {algorithm}" for what in ("visited,", "contacts,")
                                       for algorithm in MAP_ALGORITHMS]
    head_more = ["algorithm"] + [f"targets {i}" for i in (1, 2, 3)] + [f"visited {i}" for i in (1, 2, 3)]
    return {"table1": table(head, rows), "more": table(head_more, more), "maps": table(head_maps, maps)}


def with_table(page, name, text, faults):
    begin, end = f"<!-- run:{name} -->\n", f"\n<!-- /run:{name} -->"
    changed, count = re.subn(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.S)
    if count != 1:
        faults.append(f"marks of {name} on the page: {count}, wanted 1")
    return changed


def heat_map(runs, layout):
    """Where basic drives over its cable: cells of 0.25 m, the darker the more often in all orders."""
    counts = {}
    for order in orders():
        for x, y in runs.found[key_of(layout, order, ALGORITHMS["basic"])]["at"]:
            cell = (int(x / 0.25), int(y / 0.25))
            counts[cell] = counts.get(cell, 0) + 1
    scene = yaml.safe_load(scene_file(layout).read_text())
    most = max(counts.values(), default=1)
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="540" height="360" viewBox="-20 -20 540 360">',
             '<rect x="-20" y="-20" width="540" height="360" fill="#ffffff"/>']
    parts += [f'<rect x="{25 * i}" y="{300 - 25 * (j + 1)}" width="25" height="25" fill="#b8400a" '
              f'fill-opacity="{n / most:.2f}"/>' for (i, j), n in sorted(counts.items())]
    parts += [f'<circle cx="{100 * x:g}" cy="{300 - 100 * y:g}" r="{100 * r:g}" fill="#b9bec5" stroke="#4b5057"/>'
              for x, y, r in (o["circle"] for o in scene["world"]["obstacles"])]
    parts += [f'<path d="M{100 * x - 5:g} {300 - 100 * y:g}h10m-5-5v10" stroke="#0b4a8f" stroke-width="2"/>'
              for x, y in scene["tasks"]]
    x, y = scene["tether"]["base"]
    parts += [f'<rect x="{100 * x - 5:g}" y="{300 - 100 * y - 5:g}" width="10" height="10" fill="#1a1a1a"/>',
              '<rect width="500" height="300" fill="none" stroke="#4b5057"/>', "</svg>"]
    return "\n".join(parts) + "\n"


def make_pictures(program, runs):
    for layout in LAYOUTS:
        (HERE / "img" / f"contacts_{layout}.svg").write_text(heat_map(runs, layout))
    run(program, "layout1", orders()[1], ALGORITHMS["extended"],
        ["--candidates", "4", "--svg", HERE / "img" / "candidates.svg"])
    for algorithm in ("basic", "prevention"):
        run(program, "layout2", orders()[2], ALGORITHMS[algorithm],
            ["--svg", HERE / "img" / f"layout2_{algorithm}.svg"])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--runs", type=pathlib.Path, default=HERE / "runs.jsonl")
    parser.add_argument("--again", type=int, default=0)
    parser.add_argument("--only", choices=ALGORITHMS)
    options = parser.parse_args()
    faults, runs = [], Runs(options.runs)
    if options.only:
        for layout in LAYOUTS:
            for order in orders():
                runs.get(options.program, layout, options.only, order)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        again = Runs(pathlib.Path(folder, "runs.jsonl"))
        for layout, algorithm in AGAIN:
            for order in orders()[:options.again]:
                got, kept = (r.get(options.program, layout, algorithm, order) for r in (again, runs))
                if got != kept:
                    faults.append(f"{layout}, {algorithm}, {order}: {got}, kept: {kept}")
    page = (HERE / "README.md").read_text()
    changed = page
    for name, text in tables(runs, options.program).items():
        changed = with_table(changed, name, text, faults)
    if options.write:
        (HERE / "README.md").write_text(changed)
        make_pictures(options.program, runs)
    elif changed != page:
        faults.append("\n".join(difflib.unified_diff(page.splitlines(), changed.splitlines(), "page", "found",
                                                     lineterm="")))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
