#!/usr/bin/env python3
"""Spreads `tautline manifold --best-base` over threads, interrupted runs and shards: every way must give the bytes of
one run.

run_best_base.py PROGRAM"""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

SEARCH = ["manifold", "scenes/pier.yaml", "--resolution", "0.2", "--best-base", "--objective", "deadlock"]

faults = []


def check(holds, what):
    if not holds:
        faults.append(what)


def run(program, *arguments):
    return subprocess.run([program, *SEARCH, *arguments], capture_output=True, text=True)


def answer(program, *arguments):
    result = run(program, *arguments, "--json")
    check(result.returncode == 0 and not result.stderr, f"{arguments}: {result.returncode} {result.stderr}")
    return result.stdout


def check_interrupted(program, one, folder):
    part = folder / "kept.json"
    command = [program, *SEARCH, "--checkpoint", str(part), "--quiet"]
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(0.3)
    running.send_signal(signal.SIGKILL)
    running.wait()
    check(answer(program, "--checkpoint", str(part)) == one, "other bytes after an interruption")
    check(json.loads(part.read_text())["status"] == "solved", "the checkpoint is not complete at the end")


def check_shards(program, one, folder):
    parts = [str(folder / f"part{i}.json") for i in (1, 2, 3)]
    for i, part in enumerate(parts):
        check(run(program, "--shard", f"{i + 1}/3", "--checkpoint", part).returncode == 0, f"shard {i + 1} failed")
    check(answer(program, "--parts", *parts) == one, "other bytes from shards")
    for arguments, said in [
        (["--parts", parts[0], parts[1]], "stand in no part"),
        (["--parts", parts[0], parts[0]], "holds job 0"),
        (["--parts", *parts, "--spacing", "1"], "belongs to another search"),
        (["--parts", "scenes/pier.yaml"], "is no part of"),
        (["--shard", "4/3", "--json"], "must be I/N"),
        (["--shard", "1/3"], "nothing would be left"),
        (["--shard", "1/3", "--checkpoint", parts[1]], "of another shard"),
    ]:
        result = run(program, *arguments)
        check(result.returncode == 2 and said in result.stderr, f"{arguments}: {result.returncode} {result.stderr}")
        check(len(result.stderr.splitlines()) == 1, f"{arguments}: not one line")


def main():
    program = sys.argv[1]
    one = answer(program)
    best = json.loads(one)
    check(best["base"] == best["candidates"][0]["base"], "the best is not the first")
    check(answer(program, "--threads", "4") == one, "other bytes with four threads")
    with tempfile.TemporaryDirectory() as folder:
        check_interrupted(program, one, pathlib.Path(folder))
        check_shards(program, one, pathlib.Path(folder))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
