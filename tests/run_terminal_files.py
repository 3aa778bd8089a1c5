#!/usr/bin/env python3
"""Checks the shell completions and the manual page against what the program's own --help says.

run_terminal_files.py PROGRAM FOLDER

FOLDER holds `tautline` (bash), `_tautline` (zsh) and `tautline.1`. The completions are not read but used: bash calls
its function, and zsh completes what is typed on a terminal. Needs bash, zsh, man and mandoc."""
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

from run_cases import report

OPTION = re.compile(r"^  (?:(-\w),)?(--[\w-]+)(?: ([^\s=:]+)(?::\{([^}]*)\})?)?", re.M)
COMMAND = re.compile(r"^  (\w+)  ", re.M)

# Hands every match that zsh finds to a file; Tab completes, says so, and empties the line.
ZSH_SETUP = r"""
PROMPT= RPROMPT= LISTMAX=100000; unsetopt AUTO_LIST BEEP; fpath=(FOLDER $fpath)
autoload -Uz compinit && compinit -D -u
compadd() {
  if [[ ${@[1,(i)(-|--)]} != *-(O|A|D)\ * ]]; then
    local -a found; builtin compadd -O found "$@"; print -rl -- $found >> OUT
  fi
  builtin compadd "$@"
}
probe() { zle complete-word; BUFFER=; : > OUT.done; }
zle -N probe; bindkey '^I' probe; : > OUT.done
"""
WITHOUT_SCENE = {("learn", "imitate")}  # Draws its own.


def run(command, **options):
    return subprocess.run(command, text=True, capture_output=True, timeout=60, stdin=subprocess.DEVNULL, **options)


def read_help(program, words=()):
    """{words: {option: its words or []}} of a command and all below it, as --help prints them."""
    text = run([program, *words, "--help"]).stdout
    options = {}
    for short, long, _, choices in OPTION.findall(text.partition("\nOptions:\n")[2]):
        for name in filter(None, (short, long)):
            options[name] = choices.split(",") if choices else []
    found = {words: options}
    for name in COMMAND.findall(text.partition("\nSubcommands:\n")[2]):
        found.update(read_help(program, (*words, name)))
    return found


class Bash:
    """Calls the completion function as bash does."""
    SCRIPT = r"""
source "$1" && shift || exit 1
read -r _ _ function _ < <(complete -p tautline)
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMP_LINE="$*" COMP_POINT=${#COMP_LINE}
"$function" tautline "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\n' "${COMPREPLY[@]}"
"""

    def __init__(self, file, folder):
        self.file, self.folder = file, folder

    def offers(self, *words):
        # As bash splits words: --option=value is three.
        split = [part for word in words for part in (re.split("(=)", word) if word.startswith("--") else [word])]
        if split[-1] == "" and len(split) > 1 and split[-2] == "=":
            split.pop()
        done = run(["bash", "--norc", "-uc", self.SCRIPT, "bash", self.file, *split], cwd=self.folder)
        if done.returncode != 0 or done.stderr:
            raise ValueError(f"bash: {done.stderr}")
        return set(done.stdout.split("\n")) - {""}


class Zsh:
    """Types on a terminal that zsh believes to be one."""
    def __init__(self, file, folder, scratch):
        self.out = scratch / "zsh_found"
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe("zsh", ["zsh", "-f", "-i"], {**os.environ, "TERM": "dumb", "HOME": str(scratch)})
        setup = scratch / "setup.zsh"
        setup.write_text(ZSH_SETUP.replace("FOLDER", str(file.parent)).replace("OUT", str(self.out)))
        self.type(f"source {setup}\n")

    def type(self, text):
        """Types and waits until zsh has said that it is done."""
        done = pathlib.Path(f"{self.out}.done")
        os.write(self.terminal, text.encode())
        shown, deadline = b"", time.monotonic() + 30
        while not done.exists():
            if time.monotonic() > deadline:
                raise ValueError(f"zsh does not answer to {text!r}: {shown.decode(errors='replace')}")
            if select.select([self.terminal], [], [], 0.02)[0]:
                shown += os.read(self.terminal, 65536)
        done.unlink()

    def offers(self, *words):
        self.out.write_text("")
        self.type(" ".join(words) + "\t")
        return set(self.out.read_text().split("\n")) - {""}

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.process, 0)


def check_shell(shell, commands):
    """(what, why it is wrong or None) for all that a shell has to offer."""
    results = []

    def expect(words, wanted, unwanted=()):
        try:
            found = shell.offers("tautline", *words)
            missing, surplus = set(wanted) - found, set(unwanted) & found
            why = f"missing {sorted(missing)}, wrong {sorted(surplus)}, found {sorted(found)}"
            results.append((f"{type(shell).__name__} tautline {' '.join(words)}", why if missing or surplus else None))
        except (ValueError, OSError, subprocess.TimeoutExpired) as error:
            results.append((f"{type(shell).__name__} tautline {' '.join(words)}", str(error)))

    for words, options in commands.items():
        below = {w[len(words)] for w in commands if len(w) == len(words) + 1 and w[:len(words)] == words}
        if below:
            expect([*words, ""], below, {"room.yaml"})
        elif tuple(words) in WITHOUT_SCENE:
            expect([*words, ""], options, {"room.yaml"})
        else:
            expect([*words, ""], {"room.yaml", "room.json"}, {"notes.txt", *options})
        expect([*words, "-"], options)
        for name, choices in options.items():
            if choices:
                expect([*words, name, ""], choices, {"room.yaml", *options})
                start = choices[-1][:2]
                fitting = {choice for choice in choices if choice.startswith(start)}
                expect([*words, f"{name}={start}"], fitting, set(choices) - fitting)
    expect(["plan", "--svg", "no"], {"notes.txt"}, {"room.yaml"})
    expect(["plan", "room.yaml", "--sv"], {"--svg"}, {"--png", "room.yaml"})
    expect(["plan", "room.yaml", "--seed", ""], set(), {"room.yaml", "--svg"})
    expect(["plan", "--json", "ro"], {"room.yaml"}, {"notes.txt"})
    expect(["classes", "--from", "1,2", "sub"], {"sub"})
    expect(["pl"], {"plan"}, {"classes"})
    expect(["--ver"], {"--version"}, {"--help"})
    return results


def check_manual(page, commands):
    results = []
    for tool in (["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8"], ["groff", "-man", "-ww", "-z"],
                 ["mandoc", "-T", "lint", "-W", "warning"]):
        done = run([*tool, page], env={**os.environ, "MANROFFSEQ": "", "LC_ALL": "C.UTF-8", "MANWIDTH": "80"})
        complaints = done.stderr + (done.stdout if tool[0] == "mandoc" else "")
        results.append((" ".join(tool[:1]) + " tautline.1", complaints or None))
    text = page.read_text().replace("\\-", "-")
    common, _, rest = text.partition(".SH COMMANDS\n")
    sections = dict(part.partition("\n")[::2] for part in rest.split(".SS ")[1:])
    for words, options in commands.items():
        call = " ".join(("tautline", *words))
        is_leaf = not any(w[:len(words)] == words and w != words for w in commands)
        where = common + (sections.get(call, "") if is_leaf else "")
        missing = [name for name in options if not re.search(rf"^\.TP\n.*\\fB{re.escape(name)}\\fR", where, re.M)]
        if is_leaf and call not in sections:
            missing.append("the command")
        results.append((f"tautline.1: {call}", f"missing {missing}" if missing else None))
    return results


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = (pathlib.Path(a).resolve() for a in sys.argv[1:])
    commands = read_help(program)
    if ("plan",) not in commands or "--unknown" not in commands["plan",]:
        sys.exit(f"--help cannot be read: {commands}")
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        work = scratch / "work"
        (work / "sub").mkdir(parents=True)
        for name in ("room.yaml", "room.json", "notes.txt"):
            (work / name).touch()
        results += check_shell(Bash(folder / "tautline", work), commands)
        syntax = run(["zsh", "-n", folder / "_tautline"])
        results.append(("zsh -n", syntax.stderr or None))
        zsh = Zsh(folder / "_tautline", work, scratch)
        results += check_shell(zsh, commands)
        zsh.close()
    results += check_manual(folder / "tautline.1", commands)
    sys.exit(report(results))


if __name__ == "__main__":
    main()
