#!/usr/bin/env python3
"""Runs the example of docs/wasm.md beside the browser's module, and checks the sizes that the page tells.

run_wasm_page.py MODULE

The first block fenced as ```js must print what the first block fenced as ```text shows. Each row `name | bytes | with
gzip` of the page's table must be within a tenth of the file's size."""
import gzip
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).parent.parent / "docs/wasm.md"
TIMEOUT_S = 60
SIZE_TOLERANCE = 0.1


def block(text, language):
    """The first block of the page in a language."""
    return re.search(rf"^```{language}\n(.*?)^```$", text, re.M | re.S)[1]


def example_fault(text, module):
    """In what way the example does not do what the page shows, or None."""
    with tempfile.TemporaryDirectory() as folder:
        for file in (module, module.with_suffix(".wasm")):
            pathlib.Path(folder, file.name).write_bytes(file.read_bytes())
        pathlib.Path(folder, "example.js").write_text(block(text, "js"))
        process = subprocess.run(["node", "example.js"], cwd=folder, capture_output=True, text=True, timeout=TIMEOUT_S)
    if process.returncode != 0:
        return f"the example: exit {process.returncode}: {process.stderr[-1000:]}"
    return None if process.stdout == block(text, "text") else f"the example prints:\n{process.stdout}"


def size_faults(text, folder):
    """The sizes of the page that are off, as text."""
    rows = re.findall(r"^\| `(tautline\.\w+)` \| (\d+) \| (\d+) \|$", text, re.M)
    faults = [] if len(rows) == 2 else [f"{len(rows)} rows of sizes, wanted 2"]
    for name, raw, packed in rows:
        data = (folder / name).read_bytes()
        sizes = (len(data), len(gzip.compress(data, 9, mtime=0)))
        if any(abs(size - int(told)) > SIZE_TOLERANCE * size for size, told in zip(sizes, (raw, packed))):
            faults.append(f"{name} has {sizes[0]} bytes, {sizes[1]} with gzip; the page says {raw} and {packed}")
    return faults


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    module = pathlib.Path(sys.argv[1])
    text = PAGE.read_text()
    faults = [fault for fault in [example_fault(text, module)] if fault] + size_faults(text, module.parent)
    for fault in faults:
        print(f"docs/wasm.md: {fault}")
    print(f"docs/wasm.md: {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
