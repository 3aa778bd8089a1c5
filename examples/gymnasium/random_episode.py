#!/usr/bin/env python3
"""Plays an episode at random and tells what it was worth: random_episode.py SCENE"""
import random
import sys

from tautline_env import TautlineEnv

env = TautlineEnv(sys.argv[1])
chance = random.Random(1)
env.reset(seed=1)
total, steps, ended = 0.0, 0, False
while not ended:
    observation, reward, terminated, truncated, info = env.step(chance.choice((0, 1, 1, 1, 2)))
    total, steps, ended = total + reward, steps + 1, terminated or truncated
print(f"{steps} steps, return {total:.2f}, at the goal: {info['at_goal']}")
