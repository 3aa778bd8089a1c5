#!/usr/bin/env python3
"""Kills run.py beside this file while it runs, and starts it again: finished runs are not lost and not made again.

resume_test.py PROGRAM"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

RUN = pathlib.Path(__file__).resolve().parent / "run.py"
PROGRAM = ""
TIMEOUT_S = 120
# Three layouts in ten orders, of which two are the same.
ALL = 27


def records(path):
    return [json.loads(line) for line in path.read_text().splitlines()]


class Resume(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.runs, self.calls = pathlib.Path(folder.name, "runs.jsonl"), pathlib.Path(folder.name, "calls")
        self.counted = pathlib.Path(folder.name, "counted")
        self.counted.write_text(f'#!/bin/sh\necho >> "{self.calls}"\nexec "{PROGRAM}" "$@"\n')
        self.counted.chmod(0o755)

    def command(self):
        return [sys.executable, "-B", RUN, self.counted, "--runs", self.runs, "--only", "basic"]

    def count_calls(self):
        return len(self.calls.read_text().splitlines()) if self.calls.exists() else 0

    def kill_after(self, finished):
        process = subprocess.Popen(self.command(), start_new_session=True)
        end = time.monotonic() + TIMEOUT_S
        while not self.runs.exists() or len(self.runs.read_text().splitlines()) < finished:
            self.assertIsNone(process.poll(), "ended before it was killed")
            self.assertLess(time.monotonic(), end)
            time.sleep(0.002)
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()

    def test_goes_on_after_kills(self):
        self.kill_after(4)
        self.kill_after(9)
        text = self.runs.read_text()
        before = text[:text.rfind("\n") + 1]
        kept, made = len(before.splitlines()), self.count_calls()
        self.assertLess(kept, ALL)
        subprocess.run(self.command(), check=True, timeout=TIMEOUT_S)
        self.assertTrue(self.runs.read_text().startswith(before))
        self.assertEqual(len({record["key"] for record in records(self.runs)}), ALL)
        self.assertEqual(len(records(self.runs)), ALL)
        self.assertEqual(self.count_calls(), made + ALL - kept)
        self.assertLessEqual(made, kept + 2, "only what was under way at a kill is made again")

    def test_drops_half_a_line(self):
        self.kill_after(3)
        whole = self.runs.read_text()
        self.runs.write_text(whole[:-20])
        subprocess.run(self.command(), check=True, timeout=TIMEOUT_S)
        self.assertEqual(len(records(self.runs)), ALL)
        calls = self.count_calls()
        subprocess.run(self.command(), check=True, timeout=TIMEOUT_S)
        self.assertEqual(self.count_calls(), calls, "nothing is left to do")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
