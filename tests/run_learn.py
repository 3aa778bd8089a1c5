#!/usr/bin/env python3
"""Trains, kills and resumes `tautline learn train`: the same bytes come out whatever happens on the way.

run_learn.py PROGRAM"""
import json
import pathlib
import re
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
SCENE = str(ROOT / "scenes/quiet_room.yaml")
TIMEOUT_S = 300
SMALL = ["--hidden", "24", "24", "--learning-starts", "500", "--evaluate-every", "1000",
         "--max-steps", "100", "--checkpoint-every", "200", "--kernels", "portable"]
NOT_REACHED, INTERRUPTED = 3, 130


class Learn(Refusals, unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def words(self, out, *options, scene=SCENE, steps=4000):
        return [PROGRAM, "learn", "train", scene, "--out", str(self.folder / out), *SMALL, "--steps", str(steps),
                *map(str, options)]

    def train(self, out, *options, **how):
        return subprocess.run(self.words(out, *options, **how), text=True, capture_output=True, timeout=TIMEOUT_S)

    def evaluate(self, policy, *options):
        return subprocess.run([PROGRAM, "learn", "evaluate", SCENE, "--policy", str(policy), *options], text=True,
                              capture_output=True, timeout=TIMEOUT_S)

    def compare(self, *options, scenes=(SCENE,)):
        return subprocess.run([PROGRAM, "learn", "compare", *scenes, "--steps", "1000", "--seeds", "1", "--kernels",
                               "portable", *map(str, options)], text=True, capture_output=True, timeout=TIMEOUT_S)

    def imitate(self, *options, **how):
        return subprocess.run([PROGRAM, "learn", "imitate", "--courses", "1", "--rounds", "0", "--epochs", "1",
                               "--test", "1", "--kernels", "portable", *map(str, options)], text=True,
                              timeout=TIMEOUT_S, **{"capture_output": True, **how})

    def bytes_of(self, out):
        folder = self.folder / out
        return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def expect_same(self, out, other):
        got, want = self.bytes_of(out), self.bytes_of(other)
        self.assertEqual(sorted(got), sorted(want))
        for name in want:
            self.assertTrue(got[name] == want[name], f"{name} differs")

    def stopped(self, out, sent):
        """A training that got a signal after its first checkpoint; its exit status."""
        with subprocess.Popen(self.words(out, steps=1_000_000), stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            end = time.monotonic() + TIMEOUT_S
            while not (self.folder / out / "seed-1/checkpoint").exists():
                self.assertIsNone(process.poll(), "it ended before it kept anything")
                self.assertLess(time.monotonic(), end)
                time.sleep(0.005)
            process.send_signal(sent)
            return process.wait(timeout=TIMEOUT_S)

    def test_the_folder_holds_what_the_page_says(self):
        done = self.train("a", "--json")
        self.assertIn(done.returncode, (0, NOT_REACHED), done.stderr)
        answer = json.loads(done.stdout)
        self.assertEqual(answer["command"], "learn train")
        self.assertEqual(answer["success"], done.returncode == 0)
        self.assertEqual(sorted(self.bytes_of("a")), sorted(
            ["options.json", "policy.onnx", "result.json", "curves.svg", "visits.svg", "path.svg"] +
            [f"seed-1/{name}" for name in ("checkpoint", "episodes.csv", "evaluations.csv", "policy.onnx",
                                           "visits.csv")]))
        self.assertEqual(json.loads(self.bytes_of("a")["result.json"]), answer)
        evaluations = self.bytes_of("a")["seed-1/evaluations.csv"].decode().splitlines()
        self.assertEqual([line.split(",")[0] for line in evaluations], ["step", "1000", "2000", "3000", "4000"])
        visits = self.bytes_of("a")["seed-1/visits.csv"].decode().splitlines()[1:]
        self.assertEqual(sum(int(line.split(",")[2]) for line in visits), 4000)
        # The policy in the file drives as the one in memory did.
        again = json.loads(self.evaluate(self.folder / "a/policy.onnx", "--json", "--kernels", "portable").stdout)
        for key in ("path", "length", "return", "time", "cable_robot_per_minute", "cable_obstacle_per_minute"):
            self.assertEqual(again[key], answer[key], key)

    def test_threads_change_no_byte(self):
        self.train("one", "--seeds", 3)
        self.train("many", "--seeds", 3, "--threads", 3)
        self.expect_same("many", "one")
        policies = [self.bytes_of("one")[f"seed-{seed}/policy.onnx"] for seed in (1, 2, 3)]
        self.assertEqual(len(set(policies)), 3)

    def test_a_training_that_was_killed_goes_on_to_the_same_bytes(self):
        self.assertEqual(self.stopped("killed", signal.SIGKILL), -signal.SIGKILL)
        # Steps are part of what a training is, so the kept state is that of a long one.
        self.expect_refused(self.train("killed", "--resume"), "other options")
        shutil.rmtree(self.folder / "killed")
        with subprocess.Popen(self.words("killed"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            while process.poll() is None and not (self.folder / "killed/seed-1/checkpoint").exists():
                pass
            process.kill()
        # Killed while it writes, it leaves a part of a file behind. What others put there is theirs.
        left, other = self.folder / "killed/seed-1/checkpoint.Ab3xYz", self.folder / "killed/seed-1/mine.Ab3xYz"
        for file in left, other:
            file.write_text("half")
        resumed = self.train("killed", "--resume")
        self.assertFalse(left.exists())
        other.unlink()
        whole = self.train("whole")
        self.assertEqual(resumed.returncode, whole.returncode, resumed.stderr)
        self.expect_same("killed", "whole")
        # Once more, when all is done: nothing changes.
        self.train("killed", "--resume")
        self.expect_same("killed", "whole")

    def test_ctrl_c_keeps_the_state(self):
        self.assertEqual(self.stopped("stopped", signal.SIGINT), INTERRUPTED)
        names = sorted(self.bytes_of("stopped"))
        self.assertEqual(names, ["options.json", "seed-1/checkpoint"])

    def test_wrong_calls_are_refused(self):
        self.train("a")
        self.expect_refused(self.train("a"), "holds a training", "--resume")
        self.expect_refused(self.train("a", "--resume", "--discount", "0.8"), "options.json", "other options")
        self.expect_refused(self.train("b", "--discount", "1.5"), "--discount")
        self.expect_refused(self.train("b", "--robot-radius", "-1"), "--robot-radius")
        self.expect_refused(self.train("b", "--dt", "0"), "step")
        self.assertFalse((self.folder / "b").exists())
        (self.folder / "full").mkdir()
        (self.folder / "full/mine.txt").write_text("mine")
        self.expect_refused(self.train("full"), "not empty")
        checkpoint = self.folder / "a/seed-1/checkpoint"
        checkpoint.write_bytes(checkpoint.read_bytes()[:-1])
        self.expect_refused(self.train("a", "--resume"), "checkpoint")
        self.expect_refused(self.evaluate(SCENE), "no whole ONNX file")
        self.expect_refused(self.evaluate(self.folder / "none.onnx"), "none.onnx")

    def test_numbers_and_names_that_cannot_be_are_refused(self):
        self.expect_refused(self.train("b", "--reward-goal", "nan"), "rewards")
        self.expect_refused(self.train("b", "--deviation-from", "inf"), "rewards")
        endless = [PROGRAM, "learn", "train", SCENE, "--out", str(self.folder / "b"), "--max-steps", "1000001"]
        self.expect_refused(subprocess.run(endless, text=True, capture_output=True, timeout=TIMEOUT_S), "1000000 steps")
        long = "a" * 300
        self.expect_refused(self.train(long), "cannot be made")
        self.expect_refused(self.compare("--checkpoint", self.folder / long), "cannot be written")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_imitation_writes_its_policy_and_nothing_else(self):
        policy = self.folder / "policy.onnx"
        answer = json.loads(self.imitate("--out", policy, "--json").stdout)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["policy.onnx"])
        # The file says how it was taught, and drives as the policy in memory did.
        options = re.search(rb'{"courses".*?}', policy.read_bytes()).group()
        self.assertEqual(json.loads(options), {"courses": 1, "rounds": 0, "recoveries": 3, "epochs": 1, "seed": 1})
        self.assertEqual(json.loads(self.imitate("--policy", policy, "--json").stdout), answer)
        self.assertEqual(self.imitate("--policy", policy, "--quiet").stdout, "")

    def test_imitation_on_a_full_disk(self):
        with open("/dev/full", "w") as full:
            done = self.imitate("--out", self.folder / "policy.onnx", stdout=full, stderr=subprocess.PIPE,
                                capture_output=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("standard output", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_imitation_refuses_wrong_calls(self):
        self.expect_refused(self.imitate(), "--out", "--policy")
        self.expect_refused(self.imitate("--policy", SCENE), "no whole ONNX file")
        self.expect_refused(self.imitate("--policy", ROOT / "scenes/quiet_room.onnx"), "no policy for all maps")
        # The courses of round 100 would be those of the test.
        words = [PROGRAM, "learn", "imitate", "--rounds", "100", "--out", str(self.folder / "p")]
        self.expect_refused(subprocess.run(words, text=True, capture_output=True, timeout=TIMEOUT_S), "--rounds")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_comparison_refuses_wrong_calls(self):
        self.expect_refused(self.compare("--penalty", "nan", "--penalty-groups", "quiet_room"), "--penalty", "finite")
        self.expect_refused(self.compare("--penalty", "-1"), "--penalty-groups")
        self.expect_refused(self.compare("--penalty", "-1", "--penalty-groups", "room"), "room")
        self.expect_refused(self.compare("--ablation-groups", "room"), "--ablation-groups", "room")
        self.expect_refused(self.compare(scenes=[SCENE, SCENE]), "quiet_room", "twice")
        policy = self.folder / "policy.onnx"
        shutil.copy(ROOT / "scenes/contact_free/general.onnx", policy)
        kept = policy.read_bytes()
        self.expect_refused(self.compare("--general", policy, "--svg", policy), "would replace the input")
        self.assertEqual(policy.read_bytes(), kept)

    def test_a_comparison_goes_on_only_with_the_same_scene_and_seed(self):
        scene, checkpoint = self.folder / "room.yaml", self.folder / "jobs.json"
        text = pathlib.Path(SCENE).read_text()
        scene.write_text(text)
        first = self.compare("--checkpoint", checkpoint, scenes=[str(scene)])
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertEqual(self.compare("--checkpoint", checkpoint, scenes=[str(scene)]).stdout, first.stdout)
        for change in (("length: 12", "length: 13"), ("radius: 0.3", "radius: 0.25"), ("heading: 1.2", "heading: 1")):
            self.assertIn(change[0], text)
            scene.write_text(text.replace(*change))
            self.expect_refused(self.compare("--checkpoint", checkpoint, scenes=[str(scene)]), "jobs.json")
        seeds = json.loads(self.compare("--seed", 2**40, "--json").stdout)["jobs"]
        self.assertEqual({path["seed"] for job in seeds for path in job["paths"]}, {0, 2**40})

    def test_no_course_is_taught_and_tested(self):
        """Rounds and courses that would reach the seeds of the tests."""
        for option, value in (("--rounds", "100"), ("--courses", "10000001"), ("--test", "10000001")):
            self.expect_refused(subprocess.run([PROGRAM, "learn", "imitate", "--out", str(self.folder / "p"), option,
                                                value], text=True, capture_output=True, timeout=TIMEOUT_S), option)

    def test_a_goal_out_of_reach_is_told(self):
        scene = self.folder / "short.yaml"
        scene.write_text("world: {outline: [[0, 0], [8, 0], [8, 6], [0, 6]]}\n"
                         "tether: {base: [1, 1], length: 3}\ngoal: [7, 5]\n")
        done = self.train("c", "--json", scene=str(scene))
        self.assertEqual(done.returncode, NOT_REACHED, done.stderr)
        answer = json.loads(done.stdout)
        self.assertEqual((answer["status"], answer["reason"]), ("infeasible", "tether_too_short"))
        self.assertFalse((self.folder / "c").exists())


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
