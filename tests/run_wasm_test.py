#!/usr/bin/env python3
import struct
import unittest
import zlib

import run_wasm
from png_to_pgm import png_to_pgm

SOLVED = {"status": 0, "answer": '{"status": "solved", "word": ["a"], "length": 2.5}', "error": ""}


def reply(**members):
    return {**SOLVED, **members}


def png(width, height, colour, rows):
    """A PNG of 8 bits; each row starts with its filter."""
    header = struct.pack(">IIBBBBB", width, height, 8, colour, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(rows)))
    bodies = [struct.pack(">I", len(body)) + kind + body + b"crc!" for kind, body in chunks]
    return b"\x89PNG\r\n\x1a\n" + b"".join(bodies)


class ReplyDifference(unittest.TestCase):
    def difference(self, answer):
        return run_wasm.reply_difference(SOLVED, reply(answer=answer))

    def test_equal_up_to_rounding(self):
        self.assertIsNone(self.difference('{"status": "solved", "word": ["a"], "length": 2.500000001}'))

    def test_other_length(self):
        self.assertIn("length", self.difference('{"status": "solved", "word": ["a"], "length": 2.50000001}'))

    def test_other_word(self):
        self.assertIn("word", self.difference('{"status": "solved", "word": ["a^-1"], "length": 2.5}'))
        self.assertIn("word", self.difference('{"status": "solved", "word": ["a", "a"], "length": 2.5}'))

    def test_other_status(self):
        self.assertIn("status", self.difference('{"status": "infeasible", "word": ["a"], "length": 2.5}'))

    def test_missing_member(self):
        self.assertIn("keys", self.difference('{"status": "solved", "word": ["a"]}'))

    def test_truth_is_no_number(self):
        self.assertIsNotNone(run_wasm.difference(True, 1))

    def test_no_answer(self):
        self.assertIsNotNone(self.difference(""))

    def test_other_exit_status_or_error(self):
        self.assertIn("exit", run_wasm.reply_difference(SOLVED, reply(status=3)))
        self.assertIn("error", run_wasm.reply_difference(reply(error="a"), reply(error="b")))


class Questions(unittest.TestCase):
    def test_options(self):
        arguments = ["--max-length", "2.5", "--all", "--to", "1,-2", "--word", "1"]
        self.assertEqual(run_wasm.options_json(arguments),
                         '{"max_length": 2.5, "all": true, "to": [1.0, -2.0], "word": "1"}')
        self.assertEqual(run_wasm.options_json(["--order", "r1,2", "--mode", "1"]), '{"order": ["r1", "2"], "mode": "1"}')

    def test_every_scene_is_asked_about(self):
        self.assertGreater(len(run_wasm.scene_files()), 10)


class PngToPgm(unittest.TestCase):
    def test_grey_with_filters(self):
        rows = bytes([0, 1, 2]) + bytes([1, 5, 5]) + bytes([2, 1, 1]) + bytes([3, 0, 0]) + bytes([4, 1, 1])
        # None; left: 5, 10; above: 6, 11; average: 3, 7; Paeth: 3 + 1, 7 + 1.
        self.assertEqual(png_to_pgm(png(2, 5, 0, rows)), b"P5 2 5 255\n" + bytes([1, 2, 5, 10, 6, 11, 3, 7, 4, 8]))

    def test_colours_are_summed(self):
        self.assertEqual(png_to_pgm(png(2, 1, 2, bytes([0, 255, 255, 255, 1, 2, 3]))),
                         b"P5 2 1 765\n" + struct.pack(">2H", 765, 6))

    def test_palettes_are_refused(self):
        with self.assertRaises(ValueError):
            png_to_pgm(png(1, 1, 3, bytes([0, 0])))


if __name__ == "__main__":
    unittest.main()
