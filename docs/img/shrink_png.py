#!/usr/bin/env python3
"""Makes pictures smaller: a PNG with 8 bits for each of red, green and blue gets a palette.

shrink_png.py FILE...   rewrites each file with its 256 most frequent colours; other PNGs stay as they are."""
import collections
import pathlib
import struct
import sys
import zlib

COLOURS = 256


def chunks(data):
    """The (kind, body) pairs of a PNG."""
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += size + 12


def chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def paeth(left, above, corner):
    guess = left + above - corner
    return min((abs(guess - left), 0, left), (abs(guess - above), 1, above), (abs(guess - corner), 2, corner))[2]


def rows(raw, width, height):
    """The rows of an RGB picture, with the filters of PNG undone."""
    stride, above = 3 * width, bytearray(3 * width)
    for start in range(0, height * (stride + 1), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
            add = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]
            row[i] = (row[i] + add) & 255
        yield row
        above = row


def shrunk(data):
    """The PNG with a palette."""
    parts = list(chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if (depth, colour, interlaced) != (8, 2, 0):
        return data
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    pixels = [list(zip(row[0::3], row[1::3], row[2::3])) for row in rows(raw, width, height)]
    counts = collections.Counter(pixel for row in pixels for pixel in row)
    palette = [pixel for pixel, _ in counts.most_common(COLOURS)]
    nearest = {pixel: min(range(len(palette)), key=lambda k: sum((a - b)**2 for a, b in zip(pixel, palette[k])))
               for pixel in counts}
    lines = b"".join(b"\0" + bytes(nearest[pixel] for pixel in row) for row in pixels)
    return (data[:8] + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)) +
            chunk(b"PLTE", b"".join(map(bytes, palette))) + chunk(b"IDAT", zlib.compress(lines, 9)) +
            chunk(b"IEND", b""))


for name in sys.argv[1:]:
    path = pathlib.Path(name)
    path.write_bytes(shrunk(path.read_bytes()))
