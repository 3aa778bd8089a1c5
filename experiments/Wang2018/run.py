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

# What the paper prints. Areas and sums of the greatest cable lengths: now and in each future, with its probability.
FUTURES = {
    "10": {"now": (16200, 1138.39), "futures": [(0.5, 10250, 2155.56), (0.3, 11400, 1241.1), (0.2, 9450, 1364.59)],
           "expected": 10435, "longest": 2155.56},
    "11": {"now": (19300, 1435.66), "futures": [(0.5, 19300, 1488.13), (0.3, 20100, 1374.21), (0.2, 22925, 1283.95)],
           "expected": 20265, "longest": 1488.13},
}

# Table I: the words of the four sides, in the paper's signs.
TABLE_1 = {
    "now": "alpha | alpha^-1 beta^-1 gamma^-1 | gamma beta gamma^-1 | gamma",
    "P1, stage 1": "beta^-1 alpha beta | beta^-1 alpha^-1 gamma^-1 | gamma beta gamma^-1 | gamma",
    "P1, stage 2": "beta^-1 gamma^-1 alpha gamma beta | beta^-1 gamma^-1 alpha^-1 | gamma beta gamma^-1 | gamma",
    "P2, stage 1": "alpha | alpha^-1 gamma^-1 beta^-1 | beta | gamma",
    "P2, stage 2": "gamma^-1 alpha gamma | gamma^-1 alpha^-1 beta^-1 | beta | gamma",
    "P3, stage 1": "alpha | beta^-1 alpha^-1 gamma^-1 | gamma alpha beta alpha^-1 gamma^-1 | gamma",
}
LAST_STAGES = ["P1, stage 2", "P2, stage 2", "P3, stage 1"]


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

    def ask(self, command, picture=None, status=0):
        """The JSON answer to `tautline workspace COMMAND`, run beside this file, with a picture of it."""
        options = ["--svg", self.pictures / picture] if picture else []
        done = subprocess.run([self.program, "workspace", *command.split(), "--json", *options], cwd=HERE,
                              capture_output=True, text=True, timeout=TIMEOUT_S)
        if done.returncode != status:
            raise RuntimeError(f"workspace {command}: exit {done.returncode}, wanted {status}: {done.stderr.strip()}")
        return json.loads(done.stdout)


# What is computed here once more, by other means.

def ring_area(ring):
    """The paper's formula (Sec. III-H), positive."""
    return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1]))) / 2


def winding_number(ring, p):
    """How often a closed polygon winds around a point that is not on it."""
    turns = (math.atan2((a[0] - p[0]) * (b[1] - p[1]) - (a[1] - p[1]) * (b[0] - p[0]),
                        (a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]))
             for a, b in zip(ring, ring[1:] + ring[:1]))
    return round(sum(turns) / math.tau)


def is_convex(ring):
    turns = [(b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
             for a, b, c in zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2])]
    return min(turns) > 0 or max(turns) < 0


def rate_by_the_paper(sample, corner, velocity):
    """The speed of a cable towards its winch (Sec. V-B); nothing where the robot is at the corner."""
    x, y = corner[0] - sample["robot"][0], corner[1] - sample["robot"][1]
    return (x * velocity[0] + y * velocity[1]) / math.hypot(x, y) if math.hypot(x, y) > 1e-6 else None


def inverted(words):
    """Words in the other sign: every exponent negated."""
    return [[letter[:-3] if letter.endswith("^-1") else letter + "^-1" for letter in word.split()]
            for word in words.split(" | ")]


# Numbers and tables.

def number(x):
    return f"{x:.2f}".rstrip("0").rstrip(".")


def words_text(words):
    return ", ".join(f"`{' '.join(word) or chr(39) * 2}`" for word in words)


def table(head, rows):
    return "\n".join("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows])


# The figures. Each function returns rows of the table: figure, command, what the paper reports, what tautline finds.

def figure_2(tautline, faults):
    rows = []
    for part in "ab":
        command = f"boundary scenes/fig02{part}.yaml"
        answer = tautline.ask(command, f"fig02{part}.svg")
        faults.expect_close(command, ring_area(answer["boundary"]), answer["area"])
        rows.append([f"2{part}", command, "a valid boundary",
                     f"a valid boundary, area {number(answer['area'])}: {words_text(answer['words'])}"])
    command = "boundary scenes/fig02c.yaml"
    answer = tautline.ask(command, "fig02c.svg", status=3)
    faults.expect(command, answer["reason"], "boundary_not_closed")
    return rows + [["2c", command, "shortest paths that enclose no workspace", f"refused: `{answer['reason']}`"]]


def figure_7(tautline, faults):
    command = "boundary scenes/fig07.yaml"
    answer = tautline.ask(command)
    faults.expect_close(command, ring_area(answer["boundary"]), answer["area"])
    faults.expect(command, answer["words"], inverted(TABLE_1["now"]))
    return [["7", command, "area 16200", f"area {number(answer['area'])}: {words_text(answer['words'])}"]]


def figure_8(tautline, faults):
    command = "best scenes/fig08.yaml"
    scene = load("fig08.yaml")
    answer = tautline.ask(command, "fig08.svg")
    faults.expect(command, (answer["complete"], len(answer["boundaries"])), (True, 1))
    best = answer["boundaries"][0]
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        json.dump({key: value for key, value in scene.items() if key != "tasks"}, file)
        file.flush()
        every = tautline.ask(f"best {file.name}")["boundaries"]
    holding = [b["words"] for b in every if all(winding_number(b["boundary"], task) for task in scene["tasks"])]
    faults.expect(f"{command}: the boundaries that hold all tasks", holding, [best["words"]])
    rank = 1 + [b["words"] for b in every].index(best["words"])
    return [["8", command, "one valid boundary within *L* = 900",
             f"one of the {len(every)} valid boundaries within 900: area {number(best['area'])}, {ordinal(rank)} "
             f"largest; {words_text(best['words'])}"]]


def figure_10(tautline, faults):
    command = "boundary scenes/fig10.yaml"
    answer = tautline.ask(command, "fig10.svg")
    check_futures(command, answer, faults)
    faults.expect(command, [f["words"] for f in answer["futures"]], [inverted(TABLE_1[row]) for row in LAST_STAGES])
    return [["10", command, "expected area 10435", f"expected area {number(answer['expected_area'])}"]], answer


def figure_11(tautline, faults):
    command = "best scenes/fig11.yaml"
    answer = tautline.ask(command)
    best, largest = answer["boundaries"][0], max(answer["boundaries"], key=lambda b: b["area"])
    faults.expect(command, answer["complete"], True)
    faults.expect(f"{command}: sorted by expectation", best["expected_area"],
                  max(b["expected_area"] for b in answer["boundaries"]))
    laid = tautline.ask("boundary scenes/fig11.yaml", "fig11.svg")
    check_futures("boundary scenes/fig11.yaml", laid, faults)
    faults.expect("the words of fig11.yaml", laid["words"], best["words"])
    faults.expect_close("boundary scenes/fig11.yaml", laid["expected_area"], best["expected_area"])
    return [["11", command, "best expected area 20265",
             f"best expected area of {answer['found']} valid boundaries within {number(answer['max_boundary'])}: "
             f"{number(best['expected_area'])}. The largest now, {number(largest['area'])}, is expected to have "
             f"{number(largest['expected_area'])}"]], laid


def figure_13(tautline, faults):
    command = "move scenes/fig13.yaml --speed 10"
    answer = tautline.ask(command, "fig13.svg")
    checked = 0
    for sample in answer["samples"]:
        piece = [p for p in answer["pieces"] if p["t"] <= sample["t"] + 1e-9][-1]
        velocity = [sample["speed"] * (b - a) / piece["length"] for a, b in zip(piece["from"], piece["to"])]
        for rate, corner in zip(sample["rates"], sample["corners"]):
            towards_winch = rate_by_the_paper(sample, corner, velocity)
            if towards_winch is not None:
                faults.expect_close(f"{command}: rate at {sample['t']}", -rate, towards_winch, 1e-6)
                checked += 1
    faults.expect(f"{command}: rates checked", checked > 3 * len(answer["samples"]), True)
    return [["13", command, "a path; speeds of the cables by the formula of Sec. V-B",
             f"a path of {number(answer['length'])} with {len(answer['path']) - 2} corners; cables switch corners "
             f"{len(answer['switches'])} times; the rates are those of the formula, with the other sign"]]


def figure_15(tautline, faults):
    command = "tour scenes/fig15.yaml"
    answer = tautline.ask(command, "fig15.svg")
    faults.expect(command, (answer["optimal"], sorted(answer["order"])), (True, list(range(12))))
    faults.expect_close(command, sum(leg["length"] for leg in answer["legs"]), answer["length"])
    faults.expect("the workspace of fig15.yaml", tautline.ask("boundary scenes/fig15.yaml")["words"],
                  tautline.ask("boundary scenes/fig13.yaml")["words"])
    return [["15", command, "a shortest path over 12 tasks and back to the start",
             f"the shortest tour over the 12 tasks and back: {number(answer['length'])}"]]


def check_futures(command, answer, faults):
    faults.expect(f"{command}: futures", [f["status"] for f in answer["futures"]], ["solved"] * 3)
    for future in [answer, *answer["futures"]]:
        faults.expect_close(command, ring_area(future["boundary"]), future["area"])
    faults.expect_close(f"{command}: the expectation", sum(f["probability"] * f["area"] for f in answer["futures"]),
                        answer["expected_area"])
    over_all = [max(lengths) for lengths in zip(answer["max_cable_lengths"],
                                                *(f["max_cable_lengths"] for f in answer["futures"]))]
    for got, want in zip(answer["max_cable_lengths_over_futures"], over_all):
        faults.expect_close(f"{command}: the longest cables", got, want)


def ordinal(n):
    return {1: "the", 2: "the second", 3: "the third"}[n]


# Figures 10 and 11 in numbers, and Table I.

def futures_table(answers):
    """Areas and sums of greatest cable lengths, paper and tautline side by side."""
    rows = []
    for figure, answer in answers.items():
        paper, found = FUTURES[figure], [answer, *answer["futures"]]
        names = ["now"] + [f"P{i + 1}, probability {p}" for i, (p, _, _) in enumerate(paper["futures"])]
        printed = [paper["now"], *((area, cables) for _, area, cables in paper["futures"])]
        for name, (area, cables), ours in zip(names, printed, found):
            rows.append([figure, name, number(area), number(ours["area"]), number(cables),
                         number(sum(ours["max_cable_lengths"]))])
        rows.append([figure, "expected, and cables for all", number(paper["expected"]),
                     number(answer["expected_area"]), number(paper["longest"]),
                     number(sum(answer["max_cable_lengths_over_futures"]))])
    return table(["figure", "", "area, paper", "area here", "cables, paper", "cables here"], rows)


def words_table(tautline, faults):
    answer = tautline.ask("boundary scenes/table1.yaml")
    rows = []
    for (name, words), found in zip(TABLE_1.items(), [answer, *answer["futures"]]):
        faults.expect(f"Table I, {name}", found["words"], inverted(words))
        rows.append([name, *(words_text([word]) for word in found["words"])])
    return table(["", "1 to 2", "2 to 3", "3 to 4", "4 to 1"], rows)


def check_the_paper(faults):
    """The sums and maxima that the paper prints."""
    for figure, paper in FUTURES.items():
        faults.expect_close(f"expectation of Fig. {figure}", sum(p * area for p, area, _ in paper["futures"]),
                            paper["expected"])
        faults.expect(f"cables of Fig. {figure}", max(paper["now"][1], *(c for _, _, c in paper["futures"])),
                      paper["longest"])


# The scenes and the page.

def load(scene):
    return yaml.safe_load((HERE / "scenes" / scene).read_text())


def check_scenes(faults):
    """That scenes are as the paper says, and the same where they should be."""
    for path in sorted((HERE / "scenes").glob("*.yaml")):
        scene = load(path.name)
        square = [[0, 0], [200, 0], [200, 200], [0, 200]]
        faults.expect(f"{path.name}: the room", scene["world"]["outline"], square)
        faults.expect(f"{path.name}: the winches", sorted(scene["cables"]["anchors"]), sorted(square))
        faults.expect(f"{path.name}: convex obstacles",
                      sum(is_convex(o["polygon"]) for o in scene["world"]["obstacles"]), 2)
        faults.expect(f"{path.name}: obstacles", len(scene["world"]["obstacles"]), 3)
    for first, others in {"fig02a": ["fig02b", "fig02c"], "fig07": ["fig10", "fig11", "table1"],
                          "fig13": ["fig15"]}.items():
        for other in others:
            faults.expect(f"the world of {other}.yaml", load(f"{other}.yaml")["world"], load(f"{first}.yaml")["world"])
    faults.expect("the futures of fig11.yaml", load("fig11.yaml")["futures"], load("fig10.yaml")["futures"])
    for scene in ("fig10.yaml", "table1.yaml"):
        faults.expect(f"the cables of {scene}", load(scene)["cables"], load("fig07.yaml")["cables"])


def with_table(page, name, text, faults):
    """The page with a table put between its two marks."""
    begin, end = f"<!-- run:{name} -->\n", f"\n<!-- /run:{name} -->"
    changed, count = re.subn(re.escape(begin) + ".*?" + re.escape(end), lambda _: begin + text + end, page, flags=re.S)
    faults.expect(f"marks of {name} on the page", count, 1)
    return changed


def make(tautline, faults):
    """The tables of the page, by name."""
    fig10, answer10 = figure_10(tautline, faults)
    fig11, answer11 = figure_11(tautline, faults)
    rows = [*figure_2(tautline, faults), *figure_7(tautline, faults), *figure_8(tautline, faults), *fig10, *fig11,
            *figure_13(tautline, faults), *figure_15(tautline, faults)]
    rows = [[figure, f"`tautline workspace {command}`", paper, found] for figure, command, paper, found in rows]
    return {"figures": table(["figure", "command", "the paper reports", "tautline finds"], rows),
            "futures": futures_table({"10": answer10, "11": answer11}),
            "words": words_table(tautline, faults)}


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    write, faults, readme = len(sys.argv) == 3, Faults(), HERE / "README.md"
    page = changed = readme.read_text()
    with tempfile.TemporaryDirectory() as folder:
        pictures = HERE / "img" if write else pathlib.Path(folder)
        tautline = Tautline(pathlib.Path(sys.argv[1]).resolve(), pictures)
        check_the_paper(faults)
        check_scenes(faults)
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
