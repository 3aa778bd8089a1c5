#!/usr/bin/env python3
"""Runs the commands of README.md beside this file and checks that the page's tables hold what they find.

run.py PROGRAM [--write]

PROGRAM is `tautline`. With --write, the tables of the page and the pictures in img are made again; without it, a
table that has changed is a fault. What the paper says and can be checked is checked either way. Needs python3-yaml."""
import difflib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import yaml

HERE = pathlib.Path(__file__).resolve().parent
TIMEOUT_S = 60
MODES = ["straight-concurrent", "straight-sequential", "bent-concurrent", "bent-sequential"]

# What the paper prints: the crossings of each robot in order, and who passes first.
ORDERS = {
    "fig01.yaml": ({"r1": "A C", "r2": "B A", "r3": "C B"}, {"A": "r1 r2", "B": "r2 r3", "C": "r3 r1"}),
    "fig10b.yaml": ({"r1": "C A", "r2": "A B", "r3": "B C"}, {"A": "r1 r2", "B": "r2 r3", "C": "r3 r1"}),
    "fig07.yaml": ({"r1": "C B A", "r2": "B F", "r3": "E", "r4": "E A F D", "r5": "D C"}, None),
    "figC20.yaml": ({"r1": "B O1 A", "r2": "A", "r3": "B"}, None),
}

# Table 1: metres and seconds.
TABLE_1 = {"straight-concurrent": (21, 14), "straight-sequential": (21, 40), "bent-concurrent": (30, 20),
           "bent-sequential": (30, 60)}


class Faults(list):
    def expect(self, what, got, want):
        if got != want:
            self.append(f"{what}: {got}, wanted {want}")

    def expect_close(self, what, got, want, tolerance=1e-9):
        if abs(got - want) > tolerance * max(1, abs(want)):
            self.append(f"{what}: {got}, wanted {want}")


class Tautline:
    """The program, and where its pictures go."""

    def __init__(self, program, pictures):
        self.program, self.pictures = program, pictures

    def ask(self, command, picture=None, film=None, status=0):
        """The JSON answer to `tautline fleet COMMAND`, run beside this file, with a picture or a film of it."""
        options = ["--svg", self.pictures / picture] if picture else []
        options += ["--animate", self.pictures / film] if film else []
        done = subprocess.run([self.program, "fleet", *command.split(), "--json", *options], cwd=HERE,
                              capture_output=True, text=True, timeout=TIMEOUT_S)
        if done.returncode != status:
            raise RuntimeError(f"fleet {command}: exit {done.returncode}, wanted {status}: {done.stderr.strip()}")
        return json.loads(done.stdout)


# What is computed here once more, by other means.

def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def length(line):
    return sum(math.dist(a, b) for a, b in zip(line, line[1:]))


def crossing_along(one, other):
    """How far along a segment another one crosses it; None where they do not cross."""
    (a, b), (c, d) = one, other
    if cross(a, b, c) * cross(a, b, d) >= 0 or cross(c, d, a) * cross(c, d, b) >= 0:
        return None
    return math.dist(a, b) * cross(a, c, d) / (cross(a, c, d) - cross(b, c, d))


def straight_chains(robots):
    """For each robot, the others in the order in which it meets their straight paths."""
    paths = {r["name"]: (r["start"], r["target"]) for r in robots}
    chains = {}
    for name, path in paths.items():
        met = {other: crossing_along(path, paths[other]) for other in paths if other != name}
        chains[name] = sorted((other for other in met if met[other] is not None), key=met.get)
    return chains


def inside(cable, at):
    """Whether a point that is not on it, or the inner side of a bend there, lies in a cable polygon (even-odd rule)."""
    if at in cable:
        k = cable.index(at)
        before, after = cable[k - 1], cable[k + 1]
        to_before, to_after = math.dist(before, at), math.dist(after, at)
        at = [at[i] + 1e-6 * ((before[i] - at[i]) / to_before + (after[i] - at[i]) / to_after) for i in range(2)]
    count = 0
    for (x1, y1), (x2, y2) in zip(cable, cable[1:] + cable[:1]):
        if (y1 > at[1]) != (y2 > at[1]) and at[0] < x1 + (at[1] - y1) / (y2 - y1) * (x2 - x1):
            count += 1
    return count % 2 == 1


def pair_type(robots, a, b):
    """The type of the interaction of two robots (Sec. 4.2), 1 to 4."""
    by_name = {r["name"]: r for r in robots}
    a_in_b = inside(by_name[b]["cable"], by_name[a]["target"])
    b_in_a = inside(by_name[a]["cable"], by_name[b]["target"])
    return {(False, False): 1, (True, False): 2, (False, True): 3, (True, True): 4}[a_in_b, b_in_a]


# What an answer says.

def passings(answer):
    """Who passes first, by crossing: {"A": ("r1", "r2")}."""
    return {p["label"]: tuple(p["robots"]) for p in answer["passings"]}


def chains(answer):
    """By robot the other robot at each crossing that it passes, in order; "bend" where it bends."""
    pairs, found = passings(answer), {}
    for chain in answer["event_graph"]["chains"]:
        events = found[chain["robot"]] = []
        for event in chain["events"]:
            for label in event.get("passings", []):
                events.append(next(robot for robot in pairs[label] if robot != chain["robot"]))
            if event["point"] == "bend":
                events.append("bend")
    return found


def printed_chains(scene):
    """The same from the labels that the paper prints; a crossing joins the two robots whose chains hold its label."""
    rows = {robot: row.split() for robot, row in ORDERS[scene][0].items()}
    return {robot: ["bend" if label.startswith("O") else next(r for r in rows if r != robot and label in rows[r])
                    for label in row] for robot, row in rows.items()}


def order_text(answer):
    return ", ".join(f"{first} before {second}" for first, second in sorted(passings(answer).values()))


def expect_played(tautline, command, faults):
    """That the playback of the same plan makes the layout."""
    answer = tautline.ask(f"simulate {command}")
    faults.expect(f"simulate {command}", answer["matches_target"], True)


# Numbers and tables.

def number(x):
    return f"{x:.2f}".rstrip("0").rstrip(".")


def table(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows])


# The figures. Each function returns rows of the table: figure, command, what the paper reports, what tautline finds.

def figure_1(tautline, faults):
    command = "plan scenes/fig01.yaml"
    answer = tautline.ask(command, "fig01.svg", film="fig01_film.svg")
    faults.expect(f"{command}: detours", answer["detours"], [])
    faults.expect(f"{command}: chains", chains(answer), printed_chains("fig01.yaml"))
    faults.expect(f"{command}: orders", set(passings(answer).values()),
                  {tuple(pair.split()) for pair in ORDERS["fig01.yaml"][1].values()})
    return [["1, 10a", command, "straight and concurrent: r1 before r2, r2 before r3, r3 before r1",
             f"{order_text(answer)}; all arrive after {number(answer['travel_time'])} s"]]


def figure_2(tautline, faults):
    rows = []
    for part, mode in [("a", "bent-sequential"), ("c", "straight-concurrent")]:
        command = f"simulate scenes/fig01.yaml --mode {mode}"
        answer = tautline.ask(command)
        faults.expect(command, (answer["matches_target"], answer["orders_kept"]), (True, True))
        rows.append([f"2{part}", command, "makes the layout", "makes the layout"])
    command = "simulate scenes/fig01.yaml --order r1,r2,r3"
    answer = tautline.ask(command, "fig02b.svg", film="fig02b_film.svg", status=3)
    faults.expect(command, answer["matches_target"], False)
    plan = tautline.ask("plan scenes/fig01.yaml --mode straight-sequential")
    faults.expect(f"{command}: planned", plan["modes"]["straight-sequential"], False)
    rows.insert(1, ["2b", command, "does not make the layout", "does not make the layout"])
    return rows


def figure_3(tautline, faults):
    bad, good = "check scenes/fig03a.yaml", "check scenes/fig03b.yaml"
    answer = tautline.ask(bad, "fig03a.svg", status=3)
    faults.expect(bad, (answer["reason"], len(answer["self_loops"])), ("self_loop", 1))
    other = tautline.ask(good, "fig03b.svg")
    faults.expect(good, other["crossings"], [])
    return [["3a", bad, "a self loop", f"refused: `{answer['reason']}`; {number(answer['length'])} m of cable"],
            ["3b", good, "a simple layout instead", f"free of crossings; {number(other['length'])} m"]]


def figure_7(tautline, faults):
    command = "plan scenes/fig07.yaml"
    answer = tautline.ask(command, "fig07.svg", film="fig07_film.svg")
    robots = load("fig07.yaml")["fleet"]["robots"]
    faults.expect(f"{command}: chains", chains(answer), printed_chains("fig07.yaml"))
    faults.expect(f"{command}: chains, computed here", chains(answer), straight_chains(robots))
    orders = set(passings(answer).values())
    faults.expect(f"{command}: the loop", {("r1", "r5"), ("r5", "r4"), ("r4", "r1")} <= orders, True)
    faults.expect(f"{command}: modes", (answer["modes"]["straight-sequential"], answer["modes"]["straight-concurrent"]),
                  (False, True))
    wrong = "simulate scenes/fig07.yaml --order r3,r1,r5,r4,r2"
    outcome = tautline.ask(wrong, "fig07b.svg", status=3)
    faults.expect(wrong, outcome["matches_target"], False)
    expect_played(tautline, "scenes/fig07.yaml", faults)
    return [["7b", wrong, "does not make the layout", "does not make the layout"],
            ["7, 11", command, "not straight and sequential: r1, r5 and r4 wait for each other in a circle; "
                               "straight and concurrent without a detour of r4",
             f"the same; {order_text(answer)}; {number(answer['travel_time'])} s"]]


def figure_9(tautline, faults):
    rows = []
    for parts, kind, paper in [("ab", 1, "no order of r1 and r2"), ("cd", 3, "r1 before r2"),
                               ("ef", 4, "a pair deadlock of r1 and r2")]:
        for part in parts:
            command = f"plan scenes/fig09{part}.yaml"
            answer = tautline.ask(command, f"fig09{part}.svg" if part in "ae" else None)
            faults.expect(f"{command}: type", pair_type(load(f"fig09{part}.yaml")["fleet"]["robots"], "r1", "r2"), kind)
            order = [pair for pair in passings(answer).values() if set(pair) == {"r1", "r2"}]
            faults.expect(f"{command}: orders", order, [("r1", "r2")] if kind == 3 else [])
            dead = ["r1", "r2"] in answer["deadlocked_pairs"]
            faults.expect(f"{command}: deadlock", dead, kind == 4)
            expect_played(tautline, f"scenes/fig09{part}.yaml", faults)
            found = "no order" if kind == 1 else "r1 before r2" if kind == 3 else (
                f"a pair deadlock; {' and '.join(answer['detours'])} follows its cable line, "
                f"{number(answer['travel_time'])} s")
            rows.append([f"9{part}", command, paper, found])
    return rows


def figure_10b(tautline, faults):
    command = "plan scenes/fig10b.yaml"
    answer = tautline.ask(command, "fig10b.svg")
    orders = set(passings(answer).values())
    faults.expect(f"{command}: the pair graph of Fig. 10a", orders,
                  {tuple(pair.split()) for pair in ORDERS["fig10b.yaml"][1].values()})
    faults.expect(f"{command}: chains", straight_chains(load("fig10b.yaml")["fleet"]["robots"]),
                  printed_chains("fig10b.yaml"))
    faults.expect(f"{command}: deadlocks", answer["network_deadlocks"], [["r1", "r2", "r3"]])
    faults.expect(f"{command}: detours", len(answer["detours"]), 1)
    expect_played(tautline, "scenes/fig10b.yaml", faults)
    return [["10b", command, "the same pair graph as Fig. 10a, but a network deadlock",
             f"{order_text(answer)}; a network deadlock of {', '.join(answer['network_deadlocks'][0])}: "
             f"{answer['detours'][0]} follows its cable line, {number(answer['travel_time'])} s"]]


def figure_c19(tautline, faults):
    rows = []
    for part, bends, paper in [("a", [], "straight paths, r1 before r2"),
                               ("b", ["bend"], "r1 must bend around the obstacle, and pass before r2")]:
        command = f"plan scenes/figC19{part}.yaml"
        answer = tautline.ask(command, f"figC19{part}.svg")
        faults.expect(f"{command}: orders", set(passings(answer).values()), {("r1", "r2")})
        faults.expect(f"{command}: bends", [e for e in chains(answer)["r1"] if e == "bend"], bends)
        expect_played(tautline, f"scenes/figC19{part}.yaml", faults)
        rows.append([f"C.19{part}" if part == "a" else "C.19b, c", command, paper,
                     f"{order_text(answer)}; the path of r1 has {len(bends) or 'no'} bend{'s' if not bends else ''}"])
    return rows


def figure_c20(tautline, faults):
    command = "plan scenes/figC20.yaml"
    answer = tautline.ask(command, "figC20.svg", film="figC20_film.svg")
    faults.expect(f"{command}: chains", chains(answer), printed_chains("figC20.yaml"))
    faults.expect(f"{command}: detours", answer["detours"], [])
    expect_played(tautline, "scenes/figC20.yaml", faults)
    return [["C.20", command, "K1: B, O1, A; K2: A; K3: B", f"the same chains; {order_text(answer)}"]]


def table_1(tautline, faults):
    """Metres and seconds of the four modes, paper and tautline side by side."""
    rows = []
    robots = load("fig01.yaml")["fleet"]["robots"]
    for robot in robots:
        faults.expect_close(f"the path of {robot['name']}", length([robot["start"], robot["target"]]), 7, 1e-6)
        faults.expect_close(f"the cable line of {robot['name']}", length(robot["cable"]), 10, 1e-6)
    for mode in MODES:
        answer = tautline.ask(f"plan scenes/fig01.yaml --mode {mode}")
        metres, seconds = TABLE_1[mode]
        cost, note = {"time": answer["travel_time"], "distance": answer["travel_distance"]}, "yes"
        if not answer["modes"][mode]:
            without = answer["mode_details"][mode]["without_detours"]
            cost = {"time": without["travel_time"], "distance": without["travel_distance"]}
            note = f"no; {number(answer['travel_time'])} s and {number(answer['travel_distance'])} m with a detour"
        faults.expect_close(f"Table 1, {mode}, metres", cost["distance"], metres, 1e-6)
        # The paper measured 40 s; at 0.5 m/s, 21 m one after the other take 42 s.
        faults.expect_close(f"Table 1, {mode}, seconds", cost["time"], 42 if seconds == 40 else seconds, 1e-6)
        rows.append([mode, number(metres), number(cost["distance"]), number(seconds), number(cost["time"]), note])
    return table(["mode", "m, paper", "m here", "s, paper", "s here", "makes the layout"], rows)


# The scenes and the page.

def load(scene):
    return yaml.safe_load((HERE / "scenes" / scene).read_text())


def with_table(page, name, text, faults):
    """The page with a table put between its two marks."""
    begin, end = f"<!-- run:{name} -->\n", f"\n<!-- /run:{name} -->"
    changed, count = re.subn(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.S)
    faults.expect(f"marks of {name} on the page", count, 1)
    return changed


def make(tautline, faults):
    """The tables of the page, by name."""
    figures = [figure_1, figure_2, figure_3, figure_7, figure_9, figure_10b, figure_c19, figure_c20]
    rows = [[figure, f"`tautline fleet {command}`", paper, found]
            for make_rows in figures for figure, command, paper, found in make_rows(tautline, faults)]
    return {"figures": table(["figure", "command", "the paper reports", "tautline finds"], rows),
            "table1": table_1(tautline, faults)}


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    write, faults, readme = len(sys.argv) == 3, Faults(), HERE / "README.md"
    page = changed = readme.read_text()
    with tempfile.TemporaryDirectory() as folder:
        pictures = HERE / "img" if write else pathlib.Path(folder)
        tautline = Tautline(pathlib.Path(sys.argv[1]).resolve(), pictures)
        for name, text in make(tautline, faults).items():
            changed = with_table(changed, name, text, faults)
        drawn = {path.name for path in pictures.iterdir()}
    faults.expect("pictures in img", {path.name for path in (HERE / "img").iterdir()}, drawn)
    faults.expect("pictures on the page", set(re.findall(r"img/([^)\"]+)", page)), drawn)
    if write:
        readme.write_text(changed)
    else:
        before, after = page.splitlines(), changed.splitlines()
        changes = "\n".join(difflib.unified_diff(before, after, "README.md", "found now", n=0, lineterm=""))
        if changes:
            faults.append(f"tables differ, see --write:\n{changes}")
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
