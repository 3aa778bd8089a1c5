#!/usr/bin/env python3
"""Asks `tautline drive` and `tautline manifold` what cannot be answered: each refusal is one line, each stop says what
stopped it.

run_on_cells.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

from refusals import Refusals

PROGRAM = sys.argv.pop(1) if len(sys.argv) > 1 else ""
HALL = "scenes/cable_hall.yaml"
INFEASIBLE = 3


class OnCells(Refusals, unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def call(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60)

    def stopped(self, *arguments):
        """The answer of a call that ends at a budget."""
        process = self.call(*arguments, "--json")
        self.assertEqual((process.returncode, process.stderr), (INFEASIBLE, ""))
        answer = json.loads(process.stdout)
        self.assertEqual(answer["status"], "budget_exceeded")
        return answer

    def scene(self, text):
        path = self.folder / "scene.yaml"
        path.write_text(text)
        return path

    def test_refuses_what_would_never_end(self):
        for options in (["--dt", 1e-9], ["--dt", 1e-300], ["--speed", 1e-9], ["--speed", 1e-300, "--dt", 1e-300]):
            self.expect_refused(self.call("drive", HALL, *options), "too short", "give a longer --dt")

    def test_refuses_numbers_that_make_no_sense(self):
        for option in ("--speed", "--dt", "--link", "--resolution", "--robot-radius", "--sample", "--time-limit"):
            for value in ("nan", "inf", -1, "x"):
                self.expect_refused(self.call("drive", HALL, option, value), option, str(value))
        for command in (["drive", HALL], ["manifold", HALL, "--resolution", 0.1]):
            for value in (0, 1.5, "x"):
                self.expect_refused(self.call(*command, "--connectivity", value), "neither 4 nor 8")
            self.expect_refused(self.call(*command, "--max-nodes", 0), "--max-nodes")
        self.expect_refused(self.call("drive", HALL, "--link", 1e-9), "links of 1e-09 m", "--link")
        self.expect_refused(self.call("drive", HALL, "--resolution", 1e-9), "cells of 1e-09 m", "--resolution")
        self.expect_refused(self.call("drive", HALL, "--candidates", 7), "--candidates")

    def test_refuses_goals_that_are_none(self):
        bad = self.folder / "goals.txt"
        bad.write_text("1 1\n2 nan\n")
        for goals, said in ((bad, "goals.txt:2"), (self.folder, "cannot be read"), (self.folder / "none", "no such file")):
            self.expect_refused(self.call("drive", HALL, "--goals", goals), said)

    def test_names_the_budget_that_it_stopped_at(self):
        for command in (["drive", HALL], ["manifold", HALL, "--resolution", 0.1]):
            nodes = self.stopped(*command, "--max-nodes", 7)["explanation"]
            self.assertIn("more than 7 vertices", nodes)
            self.assertNotIn("bytes", nodes)
            self.assertIn("more than 7 bytes", self.stopped(*command, "--max-bytes", 7)["explanation"])

    def test_a_prepared_manifold_does_not_stop_at_the_budget_of_this_call(self):
        prepared = self.folder / "manifold"
        command = ["manifold", HALL, "--resolution", 0.1]
        self.assertEqual(self.call(*command, "--max-nodes", 1000, "--save-prepared", prepared).returncode, INFEASIBLE)
        explanation = self.stopped(*command, "--prepared", prepared)["explanation"]
        self.assertIn("make it anew", explanation)
        self.assertNotIn("200000000", explanation)

    def test_an_empty_manifold_has_no_average(self):
        process = self.call("manifold", HALL, "--resolution", 0.1, "--max-nodes", 1)
        self.assertEqual(process.returncode, INFEASIBLE)
        self.assertIn("0 vertices", process.stdout)
        self.assertNotIn("nan", process.stdout)

    def test_a_tether_too_long_for_the_cells_is_told(self):
        # A ring as wide as one cell: few vertices, however long the tether.
        ring = self.scene("world: {outline: [[0, 0], [5, 0], [5, 5], [0, 5]], obstacles: [{polygon: [[1, 1], [4, 1], "
                          "[4, 4], [1, 4]]}]}\ntether: {base: [0.5, 0.5], length: 30000}\ngoal: [4.5, 4.5]\n")
        for command in ("drive", "manifold"):
            answer = self.stopped(command, ring, "--resolution", 1, "--connectivity", 4)
            self.assertIn("larger --resolution", answer["explanation"])
            self.assertIn("cells", answer["explanation"])
            self.assertNotIn("bytes", answer["explanation"])

    def test_search_is_advised_where_there_is_one(self):
        # The robot has its cable behind it in a corridor as wide as three cells.
        corridor = self.scene("world: {outline: [[0, 0], [2.4, 0], [2.4, 0.3], [0, 0.3]]}\n"
                              "tether: {base: [0.15, 0.15], length: 3}\ntasks: [[2.25, 0.15], [0.75, 0.15]]\n")
        options = ["--deadlock-prevention", "none", "--untangle", "heuristic"]
        self.assertIn("--untangle both", self.stopped("drive", corridor, *options)["explanation"])


if __name__ == "__main__":
    unittest.main()
