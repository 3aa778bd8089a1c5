#!/usr/bin/env python3
"""Asks the program and the browser's module the same questions and compares their answers.

run_wasm.py PROGRAM MODULE

MODULE is the tautline.js that `make wasm` builds; it runs under node. Questions: every command on every scene of the
repository, the commands of tests/cases, classes between the goals of cdt2025, plans for fleets from targets alone, and
broken scenes. Exit statuses, error messages, statuses, words and all other texts must be equal, and numbers equal to
1e-9; of equally long classes, a list may be cut at different ones. Prints how many scenes were compared, how many could
not be since the core cannot read their map, and the size of the module."""
import base64
import copy
import dataclasses
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

from png_to_pgm import png_to_pgm
from validate_scenes import BROKEN, ROOT, load, scene_files, scene_members

TOLERANCE = 1e-9
TIMEOUT_S = 600
BROKEN_PREFIX = "broken: "
COMMANDS = {
    "show": [],
    "plan": ["--all", "--count", "5", "--verify"],
    "reach": ["--sheets", "--budget", "2000", "--verify"],
    "classes": ["--count", "8", "--verify"],
    "taut": ["--verify"],
    "workspace boundary": ["--verify"],
    "workspace best": ["--verify", "--count", "5"],
    "workspace pose": ["--verify"],
    "workspace move": ["--acceleration", "0.5", "--winch-limit", "0.4", "--dt", "7", "--verify"],
    "workspace tour": ["--round", "--rounds", "20", "--verify"],
    "fleet check": ["--verify"],
    "fleet layouts": ["--count", "5", "--budget", "200000", "--verify"],
    "fleet plan": ["--speeds", "--gap", "0.1"],
    "fleet simulate": ["--mode", "bent-sequential"],
    "manifold": ["--resolution", "0.5", "--max-nodes", "20000", "--sheets", "--field"],
}
TEXTS = ("word", "unknown", "mode")


def close(a, b):
    return abs(a - b) <= TOLERANCE * max(1.0, abs(a), abs(b))


def difference(native, browser, where=""):
    """The first way in which two JSON values differ, or None. Numbers may differ by TOLERANCE."""
    number = (int, float)
    if isinstance(native, number) and isinstance(browser, number) and not isinstance(native, bool):
        return None if close(native, browser) else f"{where}: {native!r}, in the browser {browser!r}"
    if type(native) is not type(browser):
        return f"{where}: {native!r}, in the browser {browser!r}"
    if isinstance(native, dict):
        if list(native) != list(browser):
            return f"{where}: keys {list(native)}, in the browser {list(browser)}"
        pairs = [(f"{where}.{key}", native[key], browser[key]) for key in native]
    elif isinstance(native, list):
        if len(native) != len(browser):
            return f"{where}: {len(native)} entries, in the browser {len(browser)}"
        pairs = [(f"{where}[{i}]", a, b) for i, (a, b) in enumerate(zip(native, browser))]
    else:
        return None if native == browser else f"{where}: {native!r}, in the browser {browser!r}"
    return next((why for name, a, b in pairs if (why := difference(a, b, name))), None)


def reply_difference(native, browser):
    """The first way in which two replies differ, or None."""
    if native["status"] != browser["status"]:
        return f"exit {native['status']}, in the browser {browser['status']}: {native['error']} | {browser['error']}"
    if native["error"] != browser["error"]:
        return f"error {native['error']!r}, in the browser {browser['error']!r}"
    if not native["answer"] or not browser["answer"]:
        return None if native["answer"] == browser["answer"] else "one of the answers is empty"
    return difference(json.loads(native["answer"]), json.loads(browser["answer"]), "answer")


def options_json(arguments):
    """Options of the command line as the module wants them: ["--count", "5"] is {"count": 5}."""
    options, key = {}, None
    for argument in arguments:
        if argument.startswith("--"):
            key = argument[2:].replace("-", "_")
            options[key] = True
        elif key in ("from", "to", "at"):
            options[key] = [float(part) for part in argument.split(",")]
        elif key == "order":
            options[key] = argument.split(",")
        else:
            options[key] = argument if key in TEXTS else float(argument)
    return json.dumps(options)


def map_files(scene, folder):
    """The files that a scene needs, by their names, with YAML and PNG as the core reads them: JSON and PGM.
    ValueError for a PNG that has no exact counterpart."""
    name = scene.get("world", {}).get("map") if isinstance(scene, dict) else None
    if name is None or not (folder / name).exists():
        return {}
    path = folder / name
    if path.suffix not in (".yaml", ".yml"):
        return {name: path.read_bytes()}
    settings = load(path)
    image = (path.parent / settings["image"]).read_bytes()
    image_name = str(pathlib.PurePosixPath(name).parent / settings["image"])
    return {name: json.dumps(settings).encode(), image_name: png_to_pgm(image) if image[0] == 0x89 else image}


@dataclasses.dataclass
class Question:
    """One command on one scene."""

    scene_name: str
    path: pathlib.Path  # What the program reads.
    scene: object       # What the module gets.
    command: list
    files: dict = dataclasses.field(default_factory=dict)

    @property
    def name(self):
        return f"{self.scene_name}: {' '.join(self.command)}"

    def ask_program(self, program):
        """The reply of the program, in the module's form."""
        process = subprocess.run([program, *self.command[0].split(), self.path, *self.command[1:], "--json"],
                                 capture_output=True, text=True, timeout=TIMEOUT_S)
        error = process.stderr.strip().removeprefix("tautline: ").replace(str(self.path), "scene")
        return {"status": process.returncode, "answer": process.stdout, "error": error}

    def line(self):
        """The question as ask_wasm.js reads it."""
        files = {name: base64.b64encode(data).decode() for name, data in self.files.items()}
        return json.dumps({"command": self.command[0], "scene": json.dumps(self.scene),
                           "options": options_json(self.command[1:]), "files": files})


def file_questions(skipped):
    """Every command on every scene that is a file; scenes with maps that the core cannot get go to `skipped`."""
    for path in scene_files():
        name, scene = str(path.relative_to(ROOT)), load(path)
        try:
            files = map_files(scene, path.parent)
        except ValueError as error:
            skipped.append(f"{name}: not comparable, its map is {error}")
            continue
        for command, options in COMMANDS.items():
            yield Question(name, path, scene, [command, *options], files)


def member_questions(folder):
    """The same for scenes inside of other files, with the questions that stand beside them; written to `folder`."""
    for i, (name, scene) in enumerate(scene_members()):
        path = pathlib.Path(folder, f"{i}.json")
        path.write_text(json.dumps(scene))
        content = json.loads((ROOT / name).read_text())
        commands = [[command, *options] for command, options in COMMANDS.items()]
        if "command" in content:
            words = 2 if content["command"][0] in ("workspace", "fleet") else 1
            command, options = " ".join(content["command"][:words]), content["command"][words:]
            # The module lacks some; docs/wasm.md names them.
            if command in COMMANDS and "--contact-free" not in options:
                commands.append([command, *options])
        for want in content.get("expected", []):
            goal = "{},{}".format(*want["goal"])
            commands.append(["classes", "--to", goal, "--max-length", str(scene["tether"]["length"])])
        for command in commands:
            yield Question(str(name), path, scene, command)


def target_questions(folder):
    """Which layout to make, for every fleet without its cable lines; written to `folder`."""
    scenes = [(str(path.relative_to(ROOT)), load(path)) for path in scene_files()] + list(scene_members())
    for i, (name, scene) in enumerate((name, scene) for name, scene in scenes if "fleet" in scene):
        scene = copy.deepcopy(scene)
        for robot in scene["fleet"]["robots"]:
            robot.pop("cable", None)
        path = pathlib.Path(folder, f"targets{i}.json")
        path.write_text(json.dumps(scene))
        yield Question(f"{name} without cable lines", path, scene, ["fleet plan", "--budget", "200"])


def broken_questions(folder):
    """Broken scenes, which both must refuse in the same words; written to `folder`."""
    for i, (name, (scene, _)) in enumerate(BROKEN.items()):
        path = pathlib.Path(folder, f"broken{i}.json")
        path.write_text(json.dumps(scene))
        yield Question(BROKEN_PREFIX + name, path, scene, ["show"])


def ask_module(module, asked):
    """The replies of the module to all questions, in order."""
    driver = pathlib.Path(__file__).parent / "ask_wasm.js"
    process = subprocess.run(["node", driver, module], input="".join(q.line() + "\n" for q in asked),
                             capture_output=True, text=True, timeout=TIMEOUT_S)
    replies = [json.loads(line) for line in process.stdout.splitlines()]
    if process.returncode != 0 or len(replies) != len(asked):
        after = asked[len(replies)].name if len(replies) < len(asked) else "the last question"
        sys.exit(f"node: exit {process.returncode} at {after}: {process.stderr[:1000]}")
    return replies


def report_size(module):
    """Prints how large the module is, raw and as a server would send it."""
    for path in (module.with_suffix(".wasm"), module):
        data = path.read_bytes()
        print(f"{path.name}: {len(data)} bytes, {len(gzip.compress(data, 9, mtime=0))} with gzip")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, module, skipped = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), []
    with tempfile.TemporaryDirectory() as folder:
        asked = [*file_questions(skipped), *member_questions(folder), *target_questions(folder),
                 *broken_questions(folder)]
        native = [question.ask_program(program) for question in asked]
    browser = ask_module(module, asked)
    faults = [f"{question.name}: {why}" for question, a, b in zip(asked, native, browser)
              if (why := reply_difference(a, b))]
    print(*faults, *skipped, sep="\n", end="\n" if faults or skipped else "")
    solved = sum(reply["status"] == 0 for reply in native)
    same = sum(a["answer"] == b["answer"] for a, b in zip(native, browser))
    scenes = {question.scene_name for question in asked}
    broken = sum(name.startswith(BROKEN_PREFIX) for name in scenes)
    print(f"{len(scenes) - broken} scenes and {broken} broken ones compared in {len(asked)} questions ({solved} solved, "
          f"{same} alike to the last byte), "
          f"{len(skipped)} not comparable: {len(faults)} differ")
    report_size(module)
    sys.exit(1 if faults or not asked else 0)


if __name__ == "__main__":
    main()
