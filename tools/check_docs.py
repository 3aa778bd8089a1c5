#!/usr/bin/env python3
"""Runs the commands shown in the documentation, follows its relative links and looks up cited works.

check_docs.py PROGRAM [ROOT]

In README.md and docs/**/*.md, every line `$ tautline ...` of a block fenced as ```console runs in a
scratch folder beside a link to scenes/ (commands of one page share the folder). It must exit with
status 0, or with N in a block fenced as ```console exit=N. Lines shown below a command must be what it
prints on both outputs together; a line `...` stands for any lines. A trailing \\ continues a command;
other `$` commands are not run.

A comment that cites [Key2000] must find its key in docs/references.bib."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```console[ \t]*(?:exit=(\d+))?[ \t]*\n(.*?)^```[ \t]*$", re.M | re.S)
FENCED = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.M | re.S)
LINK = re.compile(r"\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)|<(?:img|a)\s[^>]*(?:src|href)=\"([^\"]+)\"")
CITATION = re.compile(r"\[([A-Z][A-Za-z]+\d{4}[a-z]?)[], ]")
ANYTHING = r"(?:.*\n)*?"


def commands(block):
    """The (command, lines shown below it) pairs of a block."""
    found = []
    for line in block.replace("\\\n", " ").splitlines():
        if line.startswith("$ "):
            found.append((line[2:].strip(), []))
        elif found:
            found[-1][1].append(line.rstrip())
    return found


def matches(shown, printed):
    """Whether the lines shown describe the text printed; nothing shown describes everything."""
    while shown and not shown[-1]:
        shown = shown[:-1]
    if not shown:
        return True
    pattern = "".join(ANYTHING if line == "..." else re.escape(line) + "\n" for line in shown)
    text = "".join(line.rstrip() + "\n" for line in printed.rstrip().splitlines())
    return re.fullmatch(pattern, text) is not None


def run_page(page, program, root):
    """The faults of the commands on one page, as text."""
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(f"{folder}/bin")
        os.mkdir(f"{folder}/page")
        os.symlink(program, f"{folder}/bin/tautline")
        os.symlink(root / "scenes", f"{folder}/page/scenes")
        environment = {**os.environ, "PATH": f"{folder}/bin:{os.environ['PATH']}"}
        for match in BLOCK.finditer(page.read_text()):
            want = int(match[1] or 0)
            for command, shown in commands(match[2]):
                if command.split()[0] != "tautline":
                    continue
                process = subprocess.run(["bash", "-c", command], cwd=f"{folder}/page", env=environment,
                                         stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                         stderr=subprocess.STDOUT, text=True, timeout=120)
                if process.returncode != want:
                    faults.append(f"`{command}`: exit {process.returncode}, wanted {want}\n{process.stdout}")
                elif not matches(shown, process.stdout):
                    faults.append(f"`{command}` does not print what the page shows, but:\n{process.stdout}")
    return faults


def broken_links(page):
    """The faults of the relative links and pictures on one page, as text."""
    targets = [a or b for a, b in LINK.findall(FENCED.sub("", page.read_text()))]
    paths = [t.partition("#")[0] for t in targets if not re.match(r"[a-z]+:", t)]
    return [f"broken link {path}" for path in paths if path and not (page.parent / path).exists()]


def unknown_citations(root):
    """The faults of the citations in sources and pages, as text."""
    known = set(re.findall(r"^@\w+\{(\w+),", (root / "docs/references.bib").read_text(), re.M))
    sources = [path for top in ("tautline", "apps", "tests", "docs") for path in sorted((root / top).rglob("*"))
               if path.suffix in (".h", ".cc", ".py", ".md")]
    return [f"{path.relative_to(root)}: [{key}] is not in docs/references.bib"
            for path in sources for key in CITATION.findall(path.read_text()) if key not in known]


def pages(root):
    """Every Markdown page of the repository, build folders left out."""
    return [page for page in sorted(root.rglob("*.md")) if not {"build", ".git"} & set(page.relative_to(root).parts)]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve()
    root = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".").resolve()
    faults = unknown_citations(root)
    for page in pages(root):
        name = page.relative_to(root)
        found = broken_links(page)
        if name.parts[0] in ("README.md", "docs"):
            found += run_page(page, program, root)
        faults += [f"{name}: {fault}" for fault in found]
    print(*faults, sep="\n", end="\n" if faults else "")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
