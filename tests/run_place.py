#!/usr/bin/env python3
"""Spreads `tautline workspace place` over threads, interrupted runs, shards and the tools that the documentation shows:
every way must give the bytes of one run.

run_place.py PROGRAM"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

SCENE = "scenes/winches.yaml"
SEARCH = ["workspace", "place", SCENE, "--max-boundary", "110"]
SMALL = [*SEARCH, "--jobs", "12", "--evaluations", "80"]
FIVE, SIX = ["--seed", "5"], ["--seed", "6"]
LONG = [*SEARCH, *FIVE, "--jobs", "300", "--evaluations", "60"]

# What stands in the documentation is too long for a test.
SHOWN, TESTED = "1024", "20"

# Takes the place of dask, which would bring a web server: the same calls, one after the other.
STAND_IN = """
class Client:
    def __enter__(self):
        return self
    def __exit__(self, *fault):
        pass
    def map(self, function, values):
        return [function(value) for value in values]
    def gather(self, results):
        return results
"""

faults = []


def check(holds, what):
    if not holds:
        faults.append(what)


def run(program, *arguments, **options):
    return subprocess.run([program, *arguments], capture_output=True, text=True, **options)


def answer(program, *arguments):
    result = run(program, *arguments, "--json")
    check(result.returncode == 0 and not result.stderr, f"{arguments}: {result.returncode} {result.stderr}")
    return result.stdout


def check_threads(program):
    one = answer(program, *SMALL, *FIVE)
    for threads in ["2", "5"]:
        check(answer(program, *SMALL, *FIVE, "--threads", threads) == one, f"other bytes with {threads} threads")
    check(answer(program, *SMALL, *SIX) != one, "the seed changes nothing")
    return one


def check_shards(program, folder, one):
    for count in [1, 3, 13]:
        parts = []
        for shard in range(count, 0, -1):
            parts.append(str(folder / f"part{shard}of{count}.json"))
            arguments = [*SMALL, *FIVE, "--shard", f"{shard}/{count}", "--threads", str(1 + shard % 2)]
            if shard % 2:
                result = run(program, *arguments, "--checkpoint", parts[-1])
                check(result.returncode == 0 and "is done" in result.stdout, f"shard {shard}/{count}: {result}")
            else:
                pathlib.Path(parts[-1]).write_text(answer(program, *arguments))
        check(answer(program, "workspace", "merge", SCENE, *parts) == one, f"{count} shards give other bytes")


def done(checkpoint):
    return len(json.loads(checkpoint.read_text())["done"]) if checkpoint.exists() else 0


def check_interruption(program, folder):
    whole = answer(program, *LONG)
    checkpoint = folder / "long.json"
    jobs_left = []
    for sent, status in [(signal.SIGINT, 130), (signal.SIGKILL, -signal.SIGKILL)]:
        before = done(checkpoint)
        process = subprocess.Popen([program, *LONG, "--checkpoint", checkpoint, "--threads", "2"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        while process.poll() is None and done(checkpoint) == before:
            time.sleep(0.05)
        process.send_signal(sent)
        output = process.communicate()
        check(process.returncode in (status, 0) and output[1] == b"", f"{sent}: {process.returncode} {output}")
        check(done(checkpoint) > before, f"{sent}: nothing is kept")
        jobs_left.append(300 - done(checkpoint))
    check(jobs_left[0] > 0, "the search ended before it could be interrupted; make it longer")
    part = run(program, "workspace", "merge", SCENE, checkpoint, "--unfinished", "--json")
    check(json.loads(part.stdout)["jobs_done"] == done(checkpoint), "the best so far cannot be asked for")
    check(answer(program, *LONG, "--checkpoint", str(checkpoint)) == whole, "an interrupted search gives other bytes")
    check(done(checkpoint) == 300, "the checkpoint is not complete")
    check(answer(program, *LONG, "--checkpoint", str(checkpoint)) == whole, "a complete checkpoint gives other bytes")
    temporary = [name for name in os.listdir(folder) if name.startswith("long.json.")]
    check(len(temporary) <= 1, f"temporary files are left: {temporary}")  # SIGKILL may leave the one being written.


def check_refusals(program, folder):
    def refused(text, *arguments):
        result = run(program, *arguments)
        clean = result.returncode == 2 and not result.stdout and result.stderr.count("\n") == 1
        check(clean and text in result.stderr, f"{arguments}: {result}")

    first, second, other = (str(folder / name) for name in ["a.json", "b.json", "other.json"])
    answer(program, *SMALL, *FIVE, "--shard", "1/2", "--checkpoint", first)
    answer(program, *SMALL, *FIVE, "--shard", "2/2", "--checkpoint", second)
    answer(program, *SMALL, *SIX, "--shard", "2/2", "--checkpoint", other)
    merge = ["workspace", "merge", SCENE]
    refused("its seed is 6 instead of 5", *merge, first, other)
    refused("of 12 jobs 6 stand in no part", *merge, first)
    refused("holds job 0", *merge, first, second, first)
    refused("another scene", "workspace", "merge", "scenes/workspace.yaml", first, second, "--quiet")
    refused("is no part", *merge, SCENE)
    refused("no_such_file", *merge, "no_such_file.json")
    refused("would replace the input", *merge, first, second, "--svg", second)
    refused("its seed is 5 instead of 6", *SMALL, *SIX, "--checkpoint", first)
    refused("of another shard", *SMALL, *FIVE, "--shard", "2/2", "--checkpoint", first)
    refused("--shard", *SMALL, *FIVE, "--shard", "3/2", "--checkpoint", first)
    refused("--shard", *SMALL, *FIVE, "--shard", "1of2", "--checkpoint", first)
    refused("nothing would be left", *SMALL, *FIVE, "--shard", "1/2")
    refused("--svg", *SMALL, *FIVE, "--shard", "1/2", "--json", "--svg", str(folder / "none.svg"))
    refused("no_such_folder", *SMALL, *FIVE, "--checkpoint", "no_such_folder/jobs.json")
    notes = folder / "notes.txt"
    notes.write_text("not a checkpoint")
    refused("is no part", *SMALL, *FIVE, "--checkpoint", str(notes))
    check(notes.read_text() == "not a checkpoint", "a file that is no checkpoint was replaced")


def snippet(page, title):
    block = re.search(rf"^### {re.escape(title)}\n.*?^```\w+\n(.*?)^```$", page, re.M | re.S)[1]
    check(SHOWN in block, f"{title}: the documentation shows no {SHOWN} jobs")
    return block.replace(f'"{SHOWN}"', f'"{TESTED}", "--evaluations", "20"').replace(
        f"--jobs {SHOWN}", f"--jobs {TESTED} --evaluations 20")


def check_documentation(program, folder):
    """What the documentation shows, with fewer jobs; Slurm's and dask's own part is played by the test."""
    page = pathlib.Path("docs/workspace_place.md").read_text()
    bin_folder = folder / "bin"
    bin_folder.mkdir()
    (bin_folder / "tautline").symlink_to(pathlib.Path(program).resolve())
    dask = folder / "stand_in" / "dask"
    dask.mkdir(parents=True)
    (dask / "__init__.py").write_text("")
    (dask / "distributed.py").write_text(STAND_IN)
    environment = {**os.environ, "PATH": f"{bin_folder}:{os.environ['PATH']}", "PYTHONPATH": str(dask.parent)}
    want = answer(program, "workspace", "place", SCENE, "--jobs", TESTED, "--evaluations", "20")

    def spread(name, command, **variables):
        place = folder / name
        place.mkdir(exist_ok=True)
        if not (place / "hall.yaml").exists():
            (place / "hall.yaml").write_text(pathlib.Path(SCENE).read_text())
        result = subprocess.run(command, cwd=place, capture_output=True, text=True, env={**environment, **variables})
        check(result.returncode == 0, f"{name}: {result}")
        return place

    def compare(place):
        parts = sorted(str(part) for part in place.glob("part*.json"))
        check(len(parts) == 16, f"{place.name}: {len(parts)} parts")
        check(answer(program, "workspace", "merge", SCENE, *parts) == want, f"{place.name}: other bytes")

    place = spread("parallel", ["sh", "-ec", snippet(page, "GNU parallel")])
    compare(place)
    check((place / "place.svg").exists(), "GNU parallel: no picture")
    for task in range(1, 17):
        place = spread("slurm", ["sh", "-ec", snippet(page, "Slurm")], SLURM_ARRAY_TASK_ID=str(task),
                       SLURM_ARRAY_TASK_COUNT="16", SLURM_CPUS_PER_TASK="2")
    compare(place)
    place = spread("dask", [sys.executable, "-c", snippet(page, "Dask")])
    compare(place)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        one = check_threads(program)
        check_shards(program, folder, one)
        check_interruption(program, folder)
        check_refusals(program, folder)
        check_documentation(program, folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
