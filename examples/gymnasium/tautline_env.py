"""A robot that drags its cable, as a Gymnasium environment: TautlineEnv("scene.yaml").

Works without gymnasium as well, with the same methods; where gymnasium is installed, TautlineEnv is a gymnasium.Env.
Needs libtautline_env.so: on the loader's path, named by the variable TAUTLINE_ENV_LIBRARY, or given as `library`.

Actions: 0 turns right, 1 goes straight, 2 turns left. Observations: x, y and heading, float32 in [-1, 1]; in metres
and radians with observation="metres". All options of `tautline learn train` about robot and rewards are keywords.
"""
import ctypes
import json
import os

try:
    import gymnasium
    import numpy
except ImportError:  # The methods are the same; spaces are None and observations are tuples.
    gymnasium = None

VERSION = 1
INPUTS = 3


class _Step(ctypes.Structure):
    _fields_ = [("observation", ctypes.c_float * INPUTS), ("reward", ctypes.c_double),
                *((name, ctypes.c_int32) for name in ("terminated", "truncated", "at_goal", "robot_obstacle",
                                                      "cable_obstacle", "cable_robot", "held"))]


class _Pose(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("x", "y", "heading")]


def load(library=None):
    """The C interface with the types of its functions."""
    c = ctypes.CDLL(library or os.environ.get("TAUTLINE_ENV_LIBRARY", "libtautline_env.so.1"))
    handle, floats, doubles = ctypes.c_void_p, ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_double)
    for name, result, arguments in (
            ("version", ctypes.c_int32, []),
            ("error", ctypes.c_char_p, []),
            ("create", handle, [ctypes.c_char_p, ctypes.c_char_p]),
            ("free", None, [handle]),
            ("reset", ctypes.c_int32, [handle, ctypes.c_uint64, floats]),
            ("step", ctypes.c_int32, [handle, ctypes.c_int32, ctypes.POINTER(_Step)]),
            ("observe", ctypes.c_int32, [handle, floats]),
            ("where", ctypes.c_int32, [handle, ctypes.POINTER(_Pose)]),
            ("cable", ctypes.c_int64, [handle, doubles, ctypes.c_size_t]),
            ("goal", ctypes.c_int32, [handle, doubles])):
        function = getattr(c, "tautline_env_" + name)
        function.restype, function.argtypes = result, arguments
    if c.tautline_env_version() != VERSION:
        raise OSError(f"libtautline_env has version {c.tautline_env_version()}, and this file is for {VERSION}")
    return c


class TautlineEnv(gymnasium.Env if gymnasium else object):
    """One robot on the task of one scene."""
    metadata = {"render_modes": []}
    render_mode = None

    def __init__(self, scene, library=None, **options):
        """ValueError where the scene or an option is wrong."""
        self._env = None
        self._c = load(library)
        self._env = self._c.tautline_env_create(os.fsencode(scene), json.dumps(options).encode())
        if not self._env:
            raise ValueError(self._error())
        self._seeds = 0
        self.action_space = self.observation_space = None
        if gymnasium:
            self.action_space = gymnasium.spaces.Discrete(3)
            bound = numpy.inf if options.get("observation") == "metres" else 1.1
            self.observation_space = gymnasium.spaces.Box(-bound, bound, (INPUTS,), numpy.float32)

    def _error(self):
        return self._c.tautline_env_error().decode(errors="replace")

    def _check(self, status):
        if status < 0:
            raise ValueError(self._error())
        return status

    @staticmethod
    def _seen(numbers):
        return numpy.array(numbers, numpy.float32) if gymnasium else tuple(numbers)

    def reset(self, *, seed=None, options=None):
        """Starts an episode; returns the observation and {}. Without a seed, each episode has the next one."""
        if gymnasium:
            super().reset(seed=seed)
        self._seeds = self._seeds + 1 if seed is None else seed
        seen = (ctypes.c_float * INPUTS)()
        self._check(self._c.tautline_env_reset(self._env, self._seeds & (1 << 64) - 1, seen))
        return self._seen(seen), {}

    def step(self, action):
        """One step; returns observation, reward, terminated, truncated, and what touched what."""
        result = _Step()
        self._check(self._c.tautline_env_step(self._env, int(action), ctypes.byref(result)))
        info = {name: bool(getattr(result, name))
                for name in ("at_goal", "robot_obstacle", "cable_obstacle", "cable_robot", "held")}
        return self._seen(result.observation), result.reward, bool(result.terminated), bool(result.truncated), info

    @property
    def pose(self):
        """x, y and heading, exactly."""
        pose = _Pose()
        self._check(self._c.tautline_env_where(self._env, ctypes.byref(pose)))
        return pose.x, pose.y, pose.heading

    @property
    def cable(self):
        """The points of the cable, from its base to the robot's tail."""
        count = self._check(self._c.tautline_env_cable(self._env, None, 0))
        points = (ctypes.c_double * (2 * count))()
        self._check(self._c.tautline_env_cable(self._env, points, count))
        return [(points[2 * i], points[2 * i + 1]) for i in range(count)]

    @property
    def goal(self):
        """x, y and the radius within which it is reached."""
        goal = (ctypes.c_double * 3)()
        self._check(self._c.tautline_env_goal(self._env, goal))
        return tuple(goal)

    def close(self):
        """Frees the environment; it is of no use then."""
        if self._env:
            self._c.tautline_env_free(self._env)
        self._env = None

    def __del__(self):
        if getattr(self, "_env", None):
            self.close()
