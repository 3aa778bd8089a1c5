#!/usr/bin/env python3
"""Plays with the environment as other programs do, through libtautline_env.so, and calls it wrongly.

run_env.py LIBRARY"""
import ctypes
import importlib
import math
import os
import pathlib
import subprocess
import sys
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "examples/gymnasium"))
SCENE = ROOT / "scenes/quiet_room.yaml"
LIBRARY = ""


def make(**options):
    import tautline_env
    return tautline_env.TautlineEnv(SCENE, library=LIBRARY, **options)


class Environment(unittest.TestCase):
    def test_a_step_goes_where_it_says(self):
        env = make(heading_noise=0)
        seen, info = env.reset(seed=1)
        self.assertEqual((len(seen), info), (3, {}))
        x, y, heading = env.pose
        self.assertEqual((x, y, heading), (1.2, 1.5, 1.2))
        seen, reward, terminated, truncated, info = env.step(1)
        self.assertAlmostEqual(env.pose[0], x + 0.1 * math.cos(heading), 12)
        self.assertAlmostEqual(env.pose[1], y + 0.1 * math.sin(heading), 12)
        self.assertFalse(terminated or truncated)
        before = env.pose
        _, reward, *_ = env.step(2)
        self.assertAlmostEqual(env.pose[2], before[2] + 0.2, 12)
        self.assertLess(reward, -0.1)
        self.assertEqual(env.cable[0], (1.2, 1.5))
        self.assertAlmostEqual(math.dist(env.cable[-1], env.pose[:2]), 0.3, 9)
        self.assertEqual(env.goal, (6.6, 1.6, 0.5))
        env.close()

    def test_episodes_end_and_begin_anew(self):
        env = make(max_steps=7)
        first, _ = env.reset(seed=3)
        ends = [env.step(2)[3] for _ in range(7)]
        self.assertEqual(ends, [False] * 6 + [True])
        with self.assertRaisesRegex(ValueError, "reset first"):
            env.step(1)
        self.assertEqual(list(env.reset(seed=3)[0]), list(first))
        env.reset()
        result = env.step(1)
        while not result[2] and not result[3]:
            result = env.step(1)
        env.close()

    def test_options_are_those_of_the_command(self):
        a, b = make(), make(reward_rotation=-7, observation="metres")
        a.reset(seed=1), b.reset(seed=1)
        self.assertAlmostEqual(a.step(0)[1] - b.step(0)[1], 6.9, 9)
        self.assertAlmostEqual(float(b.step(1)[0][0]), round(b.pose[0] / 0.2) * 0.2, 5)
        for wrong, word in (({"no_such": 1}, "no_such"), ({"dt": "x"}, "dt"), ({"max_steps": 1.5}, "max_steps"),
                            ({"max_steps": 2**32 + 5}, "max_steps: must be"), ({"max_steps": -10**30}, "max_steps"),
                            ({"observation": 3}, "observation"), ({"robot_radius": -1}, "positive"),
                            ({"use_reference": 1}, "use_reference"), ({"max_steps": 0}, "step")):
            with self.assertRaisesRegex(ValueError, word):
                make(**wrong)

    def test_the_example_plays(self):
        done = subprocess.run([sys.executable, "-B", ROOT / "examples/gymnasium/random_episode.py", SCENE], text=True,
                              capture_output=True, env={**os.environ, "TAUTLINE_ENV_LIBRARY": LIBRARY}, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^\d+ steps, return -?\d+\.\d\d, at the goal: (True|False)\n$")

    def test_wrong_calls_are_refused(self):
        import tautline_env
        c = tautline_env.load(LIBRARY)
        error = c.tautline_env_error
        self.assertIsNone(c.tautline_env_create(None, None))
        self.assertIn(b"scene", error())
        self.assertIsNone(c.tautline_env_create(b"/none/such.yaml", None))
        self.assertIn(b"such.yaml", error())
        self.assertIsNone(c.tautline_env_create(str(SCENE).encode(), b"[1]"))
        self.assertIn(b"JSON", error())
        env = c.tautline_env_create(str(SCENE).encode(), None)
        self.assertTrue(env)
        step = tautline_env._Step()
        self.assertEqual(c.tautline_env_step(env, 1, ctypes.byref(step)), -1)
        self.assertIn(b"reset first", error())
        self.assertEqual(c.tautline_env_reset(env, 1, None), 0)
        for action in (-1, 3, 2**31 - 1):
            self.assertEqual(c.tautline_env_step(env, action, ctypes.byref(step)), -1)
            self.assertIn(b"no action", error())
        for wrong in (None, 8, 0x1234567812345678):
            self.assertEqual(c.tautline_env_reset(wrong, 1, None), -1)
            self.assertIn(b"no such environment", error())
            self.assertEqual(c.tautline_env_step(wrong, 1, ctypes.byref(step)), -1)
            self.assertEqual(c.tautline_env_cable(wrong, None, 0), -1)
            c.tautline_env_free(wrong)
        self.assertEqual(c.tautline_env_step(env, 1, None), -1)
        self.assertEqual(c.tautline_env_observe(env, None), -1)
        self.assertEqual(c.tautline_env_where(env, None), -1)
        self.assertEqual(c.tautline_env_goal(env, None), -1)
        c.tautline_env_free(env)
        c.tautline_env_free(env)
        self.assertEqual(c.tautline_env_step(env, 1, ctypes.byref(step)), -1)

    def test_only_the_interface_is_seen(self):
        names = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], text=True, capture_output=True, check=True)
        seen = {line.split()[-1].split("@")[0] for line in names.stdout.splitlines()}
        self.assertEqual({name for name in seen if not name.startswith("tautline_env_")}, set())
        self.assertGreater(len(seen), 9)

    def test_with_gymnasium_it_is_one_of_its_environments(self):
        """With a stand-in that has the two names in use, since Debian has no gymnasium."""
        import tautline_env
        try:
            import numpy
        except ImportError:
            self.skipTest("no numpy")
        stub = types.ModuleType("gymnasium")
        stub.Env = type("Env", (), {"reset": lambda self, *, seed=None, options=None: None})
        stub.spaces = types.SimpleNamespace(Discrete=lambda n: ("Discrete", n), Box=lambda *a: ("Box", *a))
        sys.modules["gymnasium"] = stub
        try:
            module = importlib.reload(tautline_env)
            env = module.TautlineEnv(SCENE, library=LIBRARY)
            self.assertIsInstance(env, stub.Env)
            self.assertEqual(env.action_space, ("Discrete", 3))
            seen, _ = env.reset(seed=5)
            self.assertEqual((seen.dtype, seen.shape), (numpy.float32, (3,)))
        finally:
            del sys.modules["gymnasium"]
            importlib.reload(tautline_env)


if __name__ == "__main__":
    LIBRARY = sys.argv.pop(1)
    unittest.main()
