"""What a program that refuses a call must do."""

BAD_CALL = 2


class Refusals:
    """For test cases: mixed in beside unittest.TestCase."""

    def expect_refused(self, process, *words):
        """Exit status 2, one line that holds the words, nothing on standard output."""
        self.assertEqual(process.returncode, BAD_CALL, process.stderr)
        self.assertEqual(process.stderr.count("\n"), 1, process.stderr)
        for word in words:
            self.assertIn(word, process.stderr)
        self.assertFalse(process.stdout)
