#!/usr/bin/env python3
"""Interrupts the program, closes its pipe and fills its disk: no partial file is left, and the exit status is true.

run_outputs.py PROGRAM"""
import contextlib
import os
import pathlib
import resource
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
SCENE, LARGE = str(ROOT / "scenes/pillar.yaml"), str(ROOT / "scenes/willow_demo.yaml")
LOCKED = str(ROOT / "experiments/Igarashi2010/scenes/maps/tb3_sandbox.yaml")
TIMEOUT_S = 120
OLD = "what was there before\n"

# Exit statuses of docs/formats.md.
SOLVED, BAD_OUTPUT, INTERRUPTED, CLOSED_PIPE = 0, 2, 130, 141


def wait_for(condition, what):
    end = time.monotonic() + TIMEOUT_S
    while not condition():
        if time.monotonic() > end:
            raise AssertionError(f"waited in vain for {what}")
        time.sleep(0.01)


@contextlib.contextmanager
def mounted(*arguments):
    """A mount, or None where this process may not make one."""
    process = subprocess.run(["mount", *arguments], capture_output=True, text=True)
    try:
        yield None if process.returncode else arguments[-1]
    finally:
        if not process.returncode:
            subprocess.run(["umount", arguments[-1]], check=True)


class Outputs(Refusals, unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.svg, self.png = self.folder / "a.svg", self.folder / "a.png"

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def call(self, *options, scene=SCENE, **how):
        return subprocess.run([PROGRAM, "plan", scene, *map(str, options)], text=True, timeout=TIMEOUT_S,
                              **{"capture_output": True, **how})

    def start(self, *arguments, **how):
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stderr=subprocess.PIPE, **how)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    # Ctrl-C

    def test_interrupted_in_a_long_search(self):
        process = self.start("classes", LARGE, "--count", 10**9, "--max-length", 1000, "--budget", 10**12,
                             "--svg", self.svg, stdout=subprocess.PIPE)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(TIMEOUT_S), INTERRUPTED)
        self.assertEqual(process.stdout.read() + process.stderr.read(), b"")
        self.assertEqual(self.files(), [])

    def test_interrupted_in_a_drive(self):
        # The fourth goal has no way, for which the search takes minutes.
        process = self.start("drive", LOCKED, "--resolution", 0.1, "--search-trials", 10**6, "--lookahead-trials", 10**6,
                             "--json", "--svg", self.svg, "--animate", self.folder / "film.svg",
                             stdout=subprocess.PIPE)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(TIMEOUT_S), INTERRUPTED)
        self.assertEqual(process.stdout.read() + process.stderr.read(), b"")
        self.assertEqual(self.files(), [])

    def test_interrupted_between_two_pictures(self):
        # The second picture goes to a pipe that nobody opens, so the program waits with the first one half done.
        os.mkfifo(self.svg)
        self.png.write_text(OLD)
        process = self.start("plan", SCENE, "--png", self.png, "--svg", self.svg, stdout=subprocess.DEVNULL)
        wait_for(lambda: len(self.files()) == 3, "the temporary file")
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(TIMEOUT_S), INTERRUPTED)
        self.assertEqual(self.files(), ["a.png", "a.svg"])
        self.assertEqual(self.png.read_text(), OLD)

    # Closed pipes

    def test_pipe_closed_before_the_answer(self):
        read_end, write_end = os.pipe()
        os.close(read_end)
        process = self.call("--svg", self.svg, stdout=write_end, stderr=subprocess.PIPE, capture_output=False)
        os.close(write_end)
        self.assertEqual((process.returncode, process.stderr), (CLOSED_PIPE, ""))
        self.assertEqual(self.files(), [])

    def test_pipe_closed_within_the_answer(self):
        process = self.start("classes", LARGE, "--count", 300, "--json", "--svg", self.svg, stdout=subprocess.PIPE)
        self.assertEqual(process.stdout.read(1), b"{")
        process.stdout.close()
        self.assertEqual(process.wait(TIMEOUT_S), CLOSED_PIPE)
        self.assertEqual(process.stderr.read(), b"")
        self.assertEqual(self.files(), [])

    def test_standard_output_closed_from_the_start(self):
        process = subprocess.run(["sh", "-c", f'exec "{PROGRAM}" plan "{SCENE}" --svg "{self.svg}" >&-'],
                                 stderr=subprocess.PIPE, text=True, timeout=TIMEOUT_S)
        self.assertEqual(process.returncode, BAD_OUTPUT)
        self.assertIn("standard output: cannot be written", process.stderr)
        self.assertEqual(self.files(), [])

    # Full disks

    def test_standard_output_on_a_full_disk(self):
        self.svg.write_text(OLD)
        with open("/dev/full", "w") as full:
            process = self.call("--svg", self.svg, "--png", self.png, stdout=full, stderr=subprocess.PIPE,
                                capture_output=False)
        self.expect_refused(process, "standard output: cannot be written", "No space left")
        self.assertEqual(self.files(), ["a.svg"])
        self.assertEqual(self.svg.read_text(), OLD)

    def test_picture_larger_than_the_limit_of_files(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        for path, option in ((self.svg, "--svg"), (self.png, "--png")):
            path.write_text(OLD)
            self.expect_refused(self.call(option, path, preexec_fn=limit), str(path), "File too large")
            self.assertEqual(path.read_text(), OLD)
        self.assertEqual(self.files(), ["a.png", "a.svg"])

    def test_picture_on_a_full_disk(self):
        with mounted("-t", "tmpfs", "-o", "size=16k", "tmpfs", str(self.folder)) as disk:
            if disk is None:
                print("SKIPPED: a full disk (mount needs root and its capability)", file=sys.stderr)
                self.skipTest("cannot mount")
            self.svg.write_text(OLD)
            self.expect_refused(self.call("--svg", self.svg, "--png", self.png), "No space left")
            self.assertEqual(self.files(), ["a.svg"])
            self.assertEqual(self.svg.read_text(), OLD)

    # Two pictures, of which one cannot be written

    def test_neither_picture_changes_when_one_cannot_be_written(self):
        (self.folder / "folder").mkdir()
        bad = {"No such file": self.folder / "none/a", "Is a directory": self.folder / "folder",
               "No space left": "/dev/full"}
        for good_option, bad_option in (("--svg", "--png"), ("--png", "--svg")):
            for reason, path in bad.items():
                with self.subTest(reason=reason, bad_option=bad_option):
                    self.svg.write_text(OLD)
                    self.expect_refused(self.call(good_option, self.svg, bad_option, path), str(path), reason)
                    self.assertEqual(self.svg.read_text(), OLD)
                    self.assertEqual(self.files(), ["a.svg", "folder"])

    def test_neither_picture_changes_when_one_cannot_be_put_in_place(self):
        self.svg.write_text(OLD)
        self.png.write_text(OLD)
        with mounted("--bind", str(self.svg), str(self.svg)) as busy:
            if busy is None:
                print("SKIPPED: a file that cannot be replaced (mount needs root)", file=sys.stderr)
                self.skipTest("cannot mount")
            process = self.call("--svg", self.svg, "--png", self.png)
            self.assertEqual(process.returncode, BAD_OUTPUT, process.stderr)
            self.assertIn(f"{self.svg}: cannot be written", process.stderr)
            self.assertEqual((self.svg.read_text(), self.png.read_text()), (OLD, OLD))
            self.png.unlink()
            self.assertEqual(self.call("--svg", self.svg, "--png", self.png).returncode, BAD_OUTPUT)
            self.assertEqual(self.files(), ["a.svg"])

    def test_folder_that_may_not_be_written(self):
        folder = self.folder / "locked"
        folder.mkdir(mode=0o555)
        if os.access(folder, os.W_OK):  # Root may; nobody may write here:
            folder = pathlib.Path("/proc/self")
        self.expect_refused(self.call("--svg", folder / "a.svg"), str(folder), "cannot be written")
        self.assertEqual([name for name in self.files() if name != "locked"], [])

    # Inputs and outputs that meet

    def test_an_output_never_replaces_an_input(self):
        scene, link = self.folder / "s.yaml", self.folder / "link.svg"
        scene.write_text(f"world: {{map: m.map}}\ntether: {{base: [0.5, 0.5], length: 9}}\ngoal: [2.5, 0.5]\n")
        (self.folder / "m.map").write_text("type octile\nheight 1\nwidth 3\nmap\n...\n")
        link.symlink_to("s.yaml")
        before = {name: (self.folder / name).read_text() for name in self.files()}
        for output in (scene, link, self.folder / "../" / self.folder.name / "s.yaml", self.folder / "m.map"):
            for option in ("--svg", "--png"):
                self.expect_refused(self.call(option, output, scene=str(scene)), "would replace the input")
        self.assertEqual({name: (self.folder / name).read_text() for name in self.files()}, before)

    def test_two_outputs_never_share_a_file(self):
        other = self.folder / "../" / self.folder.name / "a.svg"
        for exists in (False, True):
            if exists:
                self.svg.write_text(OLD)
            self.expect_refused(self.call("--svg", self.svg, "--png", other), "name the same file")
            self.assertEqual(self.files(), ["a.svg"] if exists else [])

    # And when nothing goes wrong

    def test_links_are_followed_and_files_replaced(self):
        target = self.folder / "target.svg"
        target.write_text(OLD)
        self.svg.symlink_to("target.svg")
        process = self.call("--svg", self.svg, "--png", self.png)
        self.assertEqual(process.returncode, SOLVED, process.stderr)
        self.assertEqual(self.files(), ["a.png", "a.svg", "target.svg"])
        self.assertTrue(self.svg.is_symlink())
        self.assertTrue(target.read_text().rstrip().endswith("</svg>"))

    def test_pipes_and_devices_are_written_to(self):
        process = self.call("--quiet", "--svg", "/dev/stdout", "--png", "/dev/null")
        self.assertEqual(process.returncode, SOLVED, process.stderr)
        self.assertTrue(process.stdout.rstrip().endswith("</svg>"))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main(verbosity=1)
