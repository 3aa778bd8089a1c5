#!/usr/bin/env python3
"""Checks `plan --goals`, `plan --field`, the prepared maps and the progress of the program.

run_plan_many.py PROGRAM"""
import json
import math
import os
import pathlib
import pty
import random
import re
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from refusals import Refusals

PROGRAM = ""
ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOM, OFFICE = str(ROOT / "scenes/store_room.yaml"), str(ROOT / "scenes/willow_demo.yaml")
TIMEOUT_S = 120


# Exit statuses of docs/formats.md.
SOLVED, INFEASIBLE, INTERRUPTED, CLOSED_PIPE = 0, 3, 130, 141


def call(*arguments, **how):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=TIMEOUT_S,
                          **{"capture_output": True, "stdin": None if "input" in how else subprocess.DEVNULL, **how})


def scene_with_goal(folder, scene, goal):
    """A copy of a scene with another goal; nothing of it may be relative to its folder."""
    lines = pathlib.Path(scene).read_text().splitlines(keepends=True)
    copy = folder / "copy.yaml"
    copy.write_text("".join(f"goal: [{goal[0]!r}, {goal[1]!r}]\n" if line.startswith("goal:") else line
                            for line in lines))
    return copy


class Many(Refusals, unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name


class Goals(Many):
    def test_each_line_is_the_document_of_its_goal(self):
        rng = random.Random(5)
        goals = [(round(rng.uniform(0, 12), 3), round(rng.uniform(0, 7), 3)) for _ in range(40)]
        text = "# goals\n" + "".join(f"{x},{y}\n" if i % 2 else f"  {x} {y}  # {i}\n\n"
                                     for i, (x, y) in enumerate(goals))
        for more in ([], ["--all", "--count", "3", "--verify"], ["--budget", "2"]):
            many = call("plan", ROOM, "--goals", "-", *more, input=text)
            self.assertEqual(many.stderr, "")
            lines = [json.loads(line) for line in many.stdout.splitlines()]
            self.assertEqual([tuple(line.pop("goal")) for line in lines], goals)
            worst = SOLVED
            for goal, line in zip(goals, lines):
                one = call("plan", scene_with_goal(self.folder, ROOM, goal), "--json", *more)
                self.assertEqual(line, json.loads(one.stdout), goal)
                worst = max(worst, one.returncode)
            self.assertEqual(many.returncode, worst)
        self.assertIn("infeasible", many.stdout)

    def test_bytes_do_not_depend_on_threads(self):
        rng = random.Random(6)
        goals = self.write("goals", "".join(f"{rng.uniform(0, 56)} {rng.uniform(0, 60)}\n" for _ in range(400)))
        answers = [call("plan", OFFICE, "--goals", goals, "--threads", n) for n in (1, 2, 5, 64)]
        for answer in answers:
            self.assertEqual((answer.returncode, answer.stderr), (INFEASIBLE, ""))
            self.assertEqual(answer.stdout, answers[0].stdout)
        self.assertEqual(answers[0].stdout.count("\n"), 400)

    def test_exit_status_is_zero_when_all_are_solved(self):
        process = call("plan", ROOM, "--goals", "-", "--quiet", input="1 1\n4.2 6.5\n")
        self.assertEqual((process.returncode, process.stderr, process.stdout.count("\n")), (SOLVED, "", 2))

    def test_the_scene_needs_no_goal_but_a_tether(self):
        text = pathlib.Path(ROOM).read_text()
        no_goal = self.write("a.yaml", "".join(line for line in text.splitlines(keepends=True)
                                               if not line.startswith("goal")))
        self.assertEqual(call("plan", no_goal, "--goals", "-", input="1 1").returncode, SOLVED)
        no_tether = self.write("b.yaml", "world: {outline: [[0, 0], [1, 0], [1, 1]]}\n")
        self.expect_refused(call("plan", no_tether, "--goals", "-", input="1 1"), "no tether")

    def test_bad_goals_are_refused_before_anything_is_printed(self):
        for text, words in {"1 1\nnan 2\n": ["standard input:2", "not a goal"], "1 1 1": ["standard input:1"],
                            "1e9 1": ["standard input:1", "1e7"], "": ["no goal"], "# 1 1\n": ["no goal"]}.items():
            self.expect_refused(call("plan", ROOM, "--goals", "-", input=text), *words)
        file = self.write("goals", "1 1\n\n2 x\n")
        self.expect_refused(call("plan", ROOM, "--goals", file), f"{file}:3: '2 x' is not a goal")
        self.expect_refused(call("plan", ROOM, "--goals", self.folder), str(self.folder))
        self.expect_refused(call("plan", ROOM, "--goals", self.folder / "none"), "no such file")
        self.expect_refused(call("plan", ROOM, "--goals", "--json"), "is an option")

    def test_pictures_are_refused(self):
        for option in ("--svg", "--png"):
            self.expect_refused(call("plan", ROOM, "--goals", "-", option, self.folder / "a", input="1 1"),
                                option, "a picture shows one goal")
        self.assertEqual(self.files(), [])
        self.expect_refused(call("plan", ROOM, "--goals", "-", "--field", input="1 1"), "--goals", "--field")

    def test_an_output_never_replaces_the_goals(self):
        goals = self.write("goals", "1 1\n")
        self.expect_refused(call("plan", ROOM, "--goals", goals, "--save-prepared", goals), "would replace the input")
        self.assertEqual(goals.read_text(), "1 1\n")

    def many_goals(self):
        return self.write("goals", "".join(f"{1 + i % 100 / 100} {1 + i // 100 % 100 / 100}\n" for i in range(200_000)))

    def test_interrupted_between_whole_lines(self):
        for threads in (1, 3):
            process = subprocess.Popen([PROGRAM, "plan", OFFICE, "--goals", self.many_goals(), "--threads",
                                        str(threads), "--save-prepared", self.folder / "kept"],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.addCleanup(process.communicate)
            self.addCleanup(process.kill)
            read = process.stdout.readline()
            self.assertTrue(read, "the first line comes before the last goal is planned")
            process.send_signal(signal.SIGINT)
            rest, errors = process.stdout.read(), process.stderr.read()
            process.wait(TIMEOUT_S)
            self.assertEqual((process.returncode, errors), (INTERRUPTED, b""))
            self.assertTrue((read + rest).endswith(b"}\n"))
            self.assertLess((read + rest).count(b"\n"), 200_000)
            for line in (read + rest).splitlines():
                json.loads(line)
            self.assertEqual(self.files(), ["goals"])

    def test_closed_pipe(self):
        process = subprocess.Popen([PROGRAM, "plan", OFFICE, "--goals", self.many_goals(), "--threads", "2"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.readline()
        process.stdout.close()
        self.assertEqual(process.wait(TIMEOUT_S), CLOSED_PIPE)
        self.assertEqual(process.stderr.read(), b"")
        process.stderr.close()


class Field(Many):
    def test_samples_are_what_plan_says(self):
        for classes in (1, 3):
            answer = call("plan", ROOM, "--field", "--resolution", "0.9", "--field-classes", classes, "--json",
                          "--verify")
            self.assertEqual((answer.returncode, answer.stderr), (SOLVED, ""))
            document = json.loads(answer.stdout)
            self.assertEqual((document["command"], document["status"], document["goal"], document["limit"],
                              document["resolution"]), ("plan", "solved", [4.2, 6.5], 12.4, 0.9))
            self.assertGreater(len(document["field"]), 60 * classes)
            self.assertGreater(document["verified"]["curves"], 100)
            for sample in random.Random(1).sample(document["field"], 12):
                self.check_sample(sample)

    def check_sample(self, sample):
        x, y = sample["at"]
        classes = json.loads(call("classes", ROOM, "--to", f"{x},{y}", "--word", " ".join(sample["word"]),
                                  "--json").stdout)["classes"]
        self.assertAlmostEqual(classes[0]["length"], sample["tether"], places=6)
        lines = [line for line in pathlib.Path(ROOM).read_text().splitlines() if not line.startswith("  laid:")]
        at = next(i for i, line in enumerate(lines) if line.startswith("tether:"))
        laid = json.dumps(classes[0]["path"])
        scene = self.write("laid.yaml", "\n".join(lines[:at + 1] + [f"  laid: {laid}"] + lines[at + 1:]) + "\n")
        plan = json.loads(call("plan", scene, "--json").stdout)
        self.assertAlmostEqual(plan["length"], sample["length"], places=6)
        (x0, y0), (x1, y1) = plan["path"][:2]
        self.assertLess(abs(math.remainder(math.atan2(y1 - y0, x1 - x0) - sample["heading"], 2 * math.pi)), 1e-6)

    def test_bytes_do_not_depend_on_threads(self):
        answers = [call("plan", OFFICE, "--field", "--resolution", 1.5, "--json", "--threads", n) for n in (1, 2, 7)]
        for answer in answers:
            self.assertEqual((answer.returncode, answer.stderr), (SOLVED, ""))
            self.assertEqual(answer.stdout, answers[0].stdout)

    def test_heading_is_null_at_the_goal(self):
        scene = self.write("a.json", json.dumps({"world": {"outline": [[0, 0], [4, 0], [4, 2], [0, 2]]},
                                                 "tether": {"base": [0.5, 0.5], "length": 3}, "goal": [1.5, 0.5]}))
        field = json.loads(call("plan", scene, "--field", "--resolution", 1, "--json").stdout)["field"]
        self.assertEqual([(s["at"], s["heading"], s["length"]) for s in field],
                         [([0.5, 0.5], 0.0, 1.0), ([1.5, 0.5], None, 0.0), ([2.5, 0.5], math.pi, 1.0), ([3.5, 0.5], math.pi, 2.0),
                          ([0.5, 1.5], -math.pi / 4, math.sqrt(2)), ([1.5, 1.5], -math.pi / 2, 1.0),
                          ([2.5, 1.5], -3 * math.pi / 4, math.sqrt(2))])

    def test_no_field_without_a_plan(self):
        scene = scene_with_goal(self.folder, ROOM, (11.6, 6.6))
        answer = call("plan", scene, "--field", "--json", "--svg", self.folder / "a.svg")
        document = json.loads(answer.stdout)
        self.assertEqual(answer.returncode, INFEASIBLE)
        self.assertEqual((document["status"], document["reason"], document["field"]),
                         ("infeasible", "tether_too_short", []))
        self.assertIn("No motion from anywhere: the tether of 12.4 m is", call("plan", scene, "--field").stdout)
        self.assertEqual(self.files(), ["a.svg", "copy.yaml"])

    def test_bad_calls(self):
        for bad in ("0", "-1", "nan", "inf", "x"):
            self.expect_refused(call("plan", ROOM, "--field", "--resolution", bad), "larger than 0")
        self.expect_refused(call("plan", ROOM, "--field", "--resolution", "1e-5"), "four million")
        self.expect_refused(call("plan", ROOM, "--field", "--field-classes", "0"), "1 or more")
        self.expect_refused(call("plan", ROOM, "--resolution", "1"), "--field")
        self.expect_refused(call("plan", ROOM, "--field", "--all"), "--all")


class Prepared(Many):
    def test_answers_are_the_same(self):
        kept, again = self.folder / "kept", self.folder / "again"
        calls = {"plan": [], "reach": [], "classes": ["--count", "5"]}
        for scene in (ROOM, OFFICE):
            for command, options in calls.items():
                plain = call(command, scene, "--json", *options)
                saved = call(command, scene, "--json", *options, "--save-prepared", kept)
                used = call(command, scene, "--json", *options, "--prepared", kept, "--save-prepared", again)
                self.assertEqual([p.stderr for p in (plain, saved, used)], ["", "", ""])
                self.assertEqual((saved.stdout, used.stdout), (plain.stdout, plain.stdout))
                self.assertEqual(kept.read_bytes(), again.read_bytes())
        for options in (["--goals", "-"], ["--field", "--resolution", "3", "--json"]):
            answers = [call("plan", OFFICE, *options, *more, input="10 10\n31 23\n")
                       for more in ([], ["--save-prepared", again], ["--prepared", kept])]
            self.assertEqual(len({answer.stdout for answer in answers}), 1)
            self.assertEqual(kept.read_bytes(), again.read_bytes())

    def test_refused_with_its_name(self):
        kept = self.folder / "kept"
        call("plan", ROOM, "--save-prepared", kept)
        bytes_ = kept.read_bytes()
        self.expect_refused(call("plan", OFFICE, "--prepared", kept), f"{kept}: the prepared map was made for another")
        self.expect_refused(call("reach", ROOM, "--prepared", ROOM), f"{ROOM}: not a prepared map")
        self.expect_refused(call("plan", ROOM, "--contact-free", "--prepared", kept), "--prepared")
        self.expect_refused(call("plan", ROOM, "--contact-free", "--save-prepared", kept), "--save-prepared")
        self.expect_refused(call("classes", ROOM, "--prepared", self.folder / "none"), "none: no such file")
        kept.write_bytes(bytes_[:-20])
        self.expect_refused(call("plan", ROOM, "--prepared", kept), f"{kept}: the prepared map is damaged")
        self.expect_refused(call("plan", ROOM, "--prepared", kept, "--goals", "-", input="1 1"), "damaged")
        kept.write_bytes(bytes_.replace(b"version 1", b"version 0"))
        self.expect_refused(call("plan", ROOM, "--prepared", kept), f"{kept}: a prepared map of another version")

    def test_too_large(self):
        large = self.folder / "large"
        with open(large, "wb") as file:
            file.truncate((1 << 30) + 1)
        self.expect_refused(call("plan", ROOM, "--prepared", large), f"{large}: larger than 1024 MiB")

    def test_outputs_stay_apart(self):
        kept = self.folder / "kept"
        call("plan", ROOM, "--save-prepared", kept)
        before = kept.read_bytes()
        for options in (["--svg", kept], ["--save-prepared", kept]):
            self.expect_refused(call("plan", ROOM, "--prepared", kept, *options), "would replace the input")
        self.expect_refused(call("plan", ROOM, "--svg", self.folder / "a", "--save-prepared", self.folder / "a"),
                            "name the same file")
        self.assertEqual(kept.read_bytes(), before)
        missing = self.folder / "none/kept"
        self.expect_refused(call("plan", ROOM, "--svg", self.folder / "a", "--save-prepared", missing), str(missing))
        self.assertEqual(self.files(), ["kept"])


class Progress(Many):
    """The line on the terminal, and that there is none elsewhere."""
    def large_scene(self, side):
        """Pillars; the preparation of some thousands takes seconds."""
        pillars = [{"polygon": [[x + r * math.cos(k * math.pi / 4 + x), y + r * math.sin(k * math.pi / 4 + x)]
                                for k in range(8)]}
                   for x in range(1, side) for y in range(1, side) for r in [0.05 + 0.01 * ((7 * x + y) % 5)]]
        return self.write("large.json", json.dumps(
            {"world": {"outline": [[0, 0], [side, 0], [side, side], [0, side]], "obstacles": pillars},
             "tether": {"base": [0.5, 0.5], "length": 60}, "goal": [30.5, 20.5]}))

    def grown_until(self, pattern, run):
        """What run(size) gave at the first size at which the terminal showed the pattern: machines differ in speed."""
        for size in (1, 2, 4, 8, 16):
            status, shown, out = run(size)
            if re.search(pattern, shown):
                return status, shown, out
        self.fail(f"{pattern} was not shown at any size: {shown!r}")

    def on_terminal(self, *arguments):
        """(exit status, what it wrote to the terminal as standard error, standard output)."""
        terminal, end = pty.openpty()
        with open(self.folder / "out", "w+") as out:
            process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=out, stderr=end)
            os.close(end)
            shown, deadline = b"", time.monotonic() + TIMEOUT_S
            while time.monotonic() < deadline:
                if not select.select([terminal], [], [], 0.1)[0]:
                    continue
                try:
                    block = os.read(terminal, 65536)
                except OSError:  # Its other end is closed.
                    break
                if not block:
                    break
                shown += block
            os.close(terminal)
            status = process.wait(TIMEOUT_S)
            out.seek(0)
            return status, shown.decode(), out.read()

    def test_shown_after_a_second_and_cleared(self):
        status, shown, out = self.grown_until(
            r"visibility graph +\d+ %, \d+ s left",
            lambda size: self.on_terminal("plan", self.large_scene(side=round(36 * math.sqrt(size)))))
        self.assertEqual(status, SOLVED, shown)
        self.assertIn("Solved", out)
        self.assertTrue(shown.endswith("\r\x1b[K"), repr(shown[-40:]))
        self.assertNotIn("\n", shown)

    def test_silent_where_nobody_looks(self):
        scene = self.large_scene(side=36)
        process = call("plan", scene)
        self.assertEqual((process.returncode, process.stderr), (SOLVED, ""))
        self.assertEqual(self.on_terminal("plan", scene, "--quiet"), (SOLVED, "", ""))
        self.assertEqual(self.on_terminal("plan", ROOM)[:2], (SOLVED, ""), "it takes less than a second")

    def test_goals_field_and_sheets_tell(self):
        def goals(size):
            return self.on_terminal("plan", OFFICE, "--goals", self.write("goals", "31 23\n" * (30 * size)), "--verify",
                                    "--threads", 2)

        status, _, out = self.grown_until(r"goals +\d+ %, \d+ (s|min) left", goals)
        self.assertEqual((status, out.count("\n") % 30), (SOLVED, 0))
        self.grown_until(r"field +\d+ %", lambda size: self.on_terminal("plan", OFFICE, "--field", "--resolution",
                                                                       0.4 / math.sqrt(size)))
        self.grown_until(r"classes +\d+ %", lambda size: self.on_terminal("reach", OFFICE, "--sheets", "--budget",
                                                                         50_000 * size))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=1)
