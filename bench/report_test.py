#!/usr/bin/env python3
"""Tests the report, on results made up here and on those of tiny benchmarks.

report_test.py RESULTS"""
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import report
import results
from line_chart import LineChart
from targets import Target, all_targets

FOLDER = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 else None
HERE = pathlib.Path(__file__).parent


class Numbers(unittest.TestCase):
    def test_units(self):
        self.assertEqual(results.seconds(2.5e-9), "2.5 ns")
        self.assertEqual(results.seconds(0.9999e-6), "1 µs")
        self.assertEqual(results.seconds(0.01234), "12.3 ms")
        self.assertEqual(results.seconds(1234), "1230 s")
        self.assertEqual(results.digits(0), "0")

    def test_targets_are_met_at_the_limit(self):
        ratio = Target("", lambda value: value, 100, at_least=True)
        self.assertTrue(ratio.met(100))
        self.assertFalse(ratio.met(99.9))
        none = Target("", lambda value: value, 0)
        self.assertTrue(none.met(0))
        self.assertFalse(none.met(1))


class Page(unittest.TestCase):
    def test_a_table_takes_the_place_of_the_old_one(self):
        page = "a\n<!-- bench:x -->\nold\n<!-- /bench:x -->\nb\n<!-- bench:y -->\n<!-- /bench:y -->\n"
        self.assertEqual(report.with_table(page, "x", "\\1 new"), page.replace("old", "\\1 new"))
        with self.assertRaises(SystemExit):
            report.with_table(page, "z", "new")

    def test_the_page_has_a_place_for_each_table(self):
        page = (HERE.parent / "docs/performance.md").read_text()
        for name in (*report.TABLES, "targets"):
            report.with_table(page, name, "")


class Chart(unittest.TestCase):
    def test_points_stand_where_the_axes_say(self):
        chart = LineChart("a < b", "x", "y", str, str)
        chart.add("line", [(1000, 1), (10, 0.01), (100, 0.1)])
        root = xml.etree.ElementTree.fromstring(chart.svg())
        dots = [(float(c.get("cx")), float(c.get("cy"))) for c in root.iter("{http://www.w3.org/2000/svg}circle")]
        self.assertEqual(len(dots), 3)
        # Powers of ten are evenly spaced, to the right and up.
        self.assertAlmostEqual(dots[1][0] - dots[0][0], dots[2][0] - dots[1][0], delta=0.2)
        self.assertAlmostEqual(dots[1][1] - dots[0][1], dots[2][1] - dots[1][1], delta=0.2)
        self.assertGreater(dots[1][0], dots[0][0])
        self.assertLess(dots[1][1], dots[0][1])


@unittest.skipIf(FOLDER is None, "no results given")
class Tiny(unittest.TestCase):
    def test_all_can_be_made(self):
        measured = results.Results(FOLDER)
        self.assertEqual(set(report.made(report.TABLES, measured)), set(report.TABLES))
        self.assertEqual(set(report.made(report.CHARTS, measured)), set(report.CHARTS))
        for chart in report.made(report.CHARTS, measured).values():
            xml.etree.ElementTree.fromstring(chart.svg())

    def test_what_was_not_run_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "some").mkdir()
            (root / "img").mkdir()
            (root / "some/funnel.json").write_text((FOLDER / "funnel_bench.json").read_text())
            (root / "some/empty.json").touch()
            before = (HERE.parent / "docs/performance.md").read_text()
            (root / "page.md").write_text(before)
            subprocess.run([sys.executable, "-B", HERE / "report.py", root / "some", root / "page.md"], check=True,
                           stdout=subprocess.DEVNULL)
            after = (root / "page.md").read_text()
            self.assertNotEqual(before, after)
            cut = "<!-- bench:funnel -->", "<!-- /bench:funnel -->"
            self.assertNotEqual(before.split(cut[0])[1].split(cut[1])[0], after.split(cut[0])[1].split(cut[1])[0])
            self.assertEqual(before.split(cut[1])[1], after.split(cut[1])[1])
            changed = [a for a, b in zip(after.split(cut[0])[0].splitlines(), before.splitlines()) if a != b]
            self.assertTrue(changed)
            self.assertEqual([line for line in changed if not line.startswith("| funnel")], [])
            self.assertEqual(list((root / "img").iterdir()), [])


if __name__ == "__main__":
    unittest.main()
