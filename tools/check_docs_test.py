#!/usr/bin/env python3
import pathlib
import tempfile
import unittest

import check_docs

PROGRAM = '#!/bin/sh\necho "$@"\necho 12 ms >&2\n[ "$1" != fail ] || exit 3\n'


class CheckDocs(unittest.TestCase):
    def faults(self, text):
        """The faults of a page, run with a program that prints its arguments and a time."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "scenes").mkdir()
            (root / "picture.png").touch()
            program = root / "program"
            program.write_text(PROGRAM)
            program.chmod(0o755)
            page = root / "README.md"
            page.write_text(text)
            return check_docs.run_page(page, program, root) + check_docs.broken_links(page)

    def test_output_as_shown(self):
        self.assertEqual(self.faults("```console\n$ tautline plan \\\n  x\nplan x\n12 ms\n```\n"), [])

    def test_dots_match_anything(self):
        self.assertEqual(self.faults("```console\n$ tautline plan\nplan\n...\n```\n"), [])

    def test_other_output(self):
        self.assertEqual(len(self.faults("```console\n$ tautline plan\nplan\n13 ms\n```\n")), 1)

    def test_exit_status(self):
        self.assertEqual(self.faults("```console exit=3\n$ tautline fail\n```\n"), [])
        self.assertEqual(len(self.faults("```console\n$ tautline fail\n```\n")), 1)

    def test_other_commands_are_not_run(self):
        self.assertEqual(self.faults("```console\n$ false\nnothing\n$ tautline plan\n```\n"), [])

    def test_links(self):
        self.assertEqual(self.faults("![a](picture.png) [b](https://example.org) [c](#here)"), [])
        self.assertEqual(self.faults("[a](missing.md#part)"), ["broken link missing.md"])


if __name__ == "__main__":
    unittest.main()
