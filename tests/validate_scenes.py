#!/usr/bin/env python3
"""Checks every scene of the repository against docs/scene.schema.json, and that broken scenes are refused.

validate_scenes.py [PROGRAM]

With a program, that must read every scene too, and answer a broken one with exit status 2, one line on standard error
and nothing on standard output. Needs python3-jsonschema and python3-yaml."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema
import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
TIMEOUT_S = 60

SQUARE = [[4, 4], [6, 4], [6, 6], [4, 6]]
OUTLINE = [[0, 0], [20, 0], [20, 10], [0, 10]]


class CoreLoader(yaml.SafeLoader):
    """YAML with the numbers of the core schema of YAML 1.2, as tautline reads them: 1e-6 is one."""


CoreLoader.add_implicit_resolver(
    "tag:yaml.org,2002:float",
    re.compile(r"^[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"),
    list("-+.0123456789"))


def world(**members):
    """A scene with a world of the given members, in a room unless they say otherwise."""
    return {"world": {"outline": OUTLINE, **members}}


def obstacle(**members):
    return world(obstacles=[members])


# Broken scenes, and whether the schema can tell (the reader always must).
BROKEN = {
    "neither world nor fleet": ({}, True),
    "not a map": ([1, 2], True),
    "unknown key": ({**world(), "gaol": [1, 2]}, True),
    "unknown key in an obstacle": (obstacle(polygon=SQUARE, colour="red"), True),
    "map and outline": (world(map="a.yaml"), True),
    "outline of two points": ({"world": {"outline": OUTLINE[:2]}}, True),
    "outline crosses itself": ({"world": {"outline": [[0, 0], [4, 4], [4, 0], [0, 3]]}}, False),
    "polygon without area": (obstacle(polygon=[[1, 1], [2, 2], [3, 3]]), False),
    "polygon and circle": (obstacle(polygon=SQUARE, circle=[1, 1, 1]), True),
    "neither polygon nor circle": (obstacle(name="a"), True),
    "circle of radius 0": (obstacle(circle=[1, 1, 0]), True),
    "name with a blank": (obstacle(polygon=SQUARE, name="a b"), True),
    "name like a letter's inverse": (obstacle(polygon=SQUARE, name="a^-1"), True),
    "name twice": (world(obstacles=[{"polygon": SQUARE, "name": "a"}, {"circle": [9, 2, 1], "name": "a"}]), False),
    "representative outside": (obstacle(polygon=SQUARE, representative=[1, 1]), False),
    "negative clearance": (world(clearance=-1), True),
    "tether without length": ({**world(), "tether": {"base": [1, 1]}}, True),
    "negative length": ({**world(), "tether": {"base": [1, 1], "length": -1}}, True),
    "length as text": ({**world(), "tether": {"base": [1, 1], "length": "18"}}, True),
    "laid cable away from the base": ({**world(), "tether": {"base": [1, 1], "length": 9, "laid": [[2, 2]]}}, False),
    "robot of radius 0": ({**world(), "robot": {"radius": 0}}, True),
    "heading as text": ({**world(), "robot": {"heading": "north"}}, True),
    "robot with a colour": ({**world(), "robot": {"colour": 3}}, True),
    "robot without a world": ({"robot": {"radius": 1}, "fleet": {"robots": []}}, True),
    "goal of three numbers": ({**world(), "goal": [1, 2, 3]}, True),
    "goal beyond 1e7 metres": ({**world(), "goal": [1, -1.1e7]}, True),
    "circle beyond 1e7 metres": (obstacle(circle=[9e6, 0, 2e6]), False),
    "goal without a world": ({"goal": [1, 2], "fleet": {"robots": []}}, True),
    "two anchors": ({**world(), "cables": {"anchors": [[0, 0], [20, 0]]}}, True),
    "laid cables and words": ({**world(), "cables": {
        "anchors": [[0, 0], [20, 0], [20, 10]], "words": ["", "", ""],
        "laid": [[[9, 5], [0, 0]], [[9, 5], [20, 0]], [[9, 5], [20, 10]]]}}, True),
    "two words for three anchors": (
        {**world(), "cables": {"anchors": [[0, 0], [20, 0], [20, 10]], "words": ["", ""]}}, False),
    "a number for a word": ({**world(), "cables": {"anchors": [[0, 0], [20, 0], [20, 10]], "words": ["", 1, ""]}}, True),
    "probabilities sum to 0.5": ({**world(), "futures": [{"probability": 0.5, "moves": []}]}, False),
    "no such obstacle": (
        {**world(), "futures": [{"probability": 1, "moves": [{"obstacle": "a", "path": SQUARE}]}]}, False),
    "robot without a target": ({"fleet": {"speed": 1, "robots": [{"start": [0, 0]}]}}, True),
    "robot without a speed": ({"fleet": {"robots": [{"start": [0, 0], "target": [1, 0]}]}}, False),
}


def scene_files():
    """The scenes that are files of their own."""
    return sorted([*ROOT.glob("scenes/*.yaml"), *ROOT.glob("scenes/*.json"), *ROOT.glob("experiments/*/scenes/*.yaml")])


def load(path):
    return yaml.load(path.read_text(), CoreLoader)


def has_world(scene):
    """A fleet alone in the plane has none, and `show` draws worlds."""
    return "world" in scene


def scene_members():
    """(name, scene) for the scenes inside of other files: cases and the maps of cdt2025."""
    for path in sorted([*ROOT.glob("tests/cases/*.json"), *ROOT.glob("scenes/maps/cdt2025/*.json")]):
        content = json.loads(path.read_text())
        if isinstance(content, dict) and "scene" in content:
            yield path.relative_to(ROOT), content["scene"]


def run(program, path):
    return subprocess.run([program, "show", str(path), "--json"], capture_output=True, text=True, timeout=TIMEOUT_S)


def fault_of_answer(process):
    """In what way the answer to a broken scene is wrong, or None."""
    if process.returncode != 2:
        return f"exit {process.returncode}, wanted 2"
    if process.stdout:
        return "something on standard output"
    if process.stderr.count("\n") != 1 or not process.stderr.endswith("\n"):
        return f"not one line on standard error: {process.stderr!r}"
    return None


def schema_faults(validator):
    """(name, fault) for every good scene that the schema refuses and every broken one that it takes."""
    good = [(path.relative_to(ROOT), load(path)) for path in scene_files()]
    for name, scene in [*good, *scene_members()]:
        for error in validator.iter_errors(scene):
            yield name, f"{error.json_path}: {error.message}"
    for name, (scene, by_schema) in BROKEN.items():
        if by_schema and validator.is_valid(scene):
            yield name, "the schema takes it"


def program_faults(program):
    """(name, fault) for every good scene that the program refuses and every broken one that it does not refuse."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "scene.json")
        for file in scene_files():
            if not has_world(load(file)):
                continue
            process = run(program, file)
            if process.returncode != 0:
                yield file.relative_to(ROOT), f"exit {process.returncode}: {process.stderr.strip()[:200]}"
        for name, scene in scene_members():
            if not has_world(scene):
                continue
            path.write_text(json.dumps(scene))
            process = run(program, path)
            if process.returncode != 0:
                yield name, f"exit {process.returncode}: {process.stderr.strip()[:200]}"
        for name, (scene, _) in BROKEN.items():
            path.write_text(json.dumps(scene))
            fault = fault_of_answer(run(program, path))
            if fault:
                yield name, fault


def main():
    if len(sys.argv) > 2 or "--help" in sys.argv:
        sys.exit(__doc__)
    schema = json.loads((ROOT / "docs/scene.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    faults = list(schema_faults(jsonschema.Draft202012Validator(schema)))
    if len(sys.argv) == 2:
        faults += program_faults(sys.argv[1])
    for name, fault in faults:
        print(f"{name}: {fault}")
    count = len(scene_files()) + len(list(scene_members()))
    print(f"{count} scenes and {len(BROKEN)} broken ones: {len(faults)} faults")
    sys.exit(1 if faults or not count else 0)


if __name__ == "__main__":
    main()
