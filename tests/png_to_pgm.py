"""PNG as PGM, for the core without libpng."""
import struct
import zlib


def chunks(data):
    """The (kind, body) pairs of a PNG."""
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += size + 12


def paeth(left, above, corner):
    guess = left + above - corner
    return min((abs(guess - left), 0, left), (abs(guess - above), 1, above), (abs(guess - corner), 2, corner))[2]


def unfiltered(raw, stride, channels):
    """The bytes of a picture of `stride` bytes a row, with the filters of PNG undone."""
    above, pixels = bytearray(stride), bytearray()
    for start in range(0, len(raw), stride + 1):
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left, corner = (row[i - channels], above[i - channels]) if i >= channels else (0, 0)
            row[i] = (row[i] + (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind]) & 255
        pixels += row
        above = row
    return bytes(pixels)


def png_to_pgm(data):
    """The same picture as PGM: colours as the sum of red, green and blue out of 765, which is as bright exactly.
    ValueError unless it is grey or RGB of 8 bits, not interlaced and without transparency."""
    parts = list(chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    channels = {0: 1, 2: 3}.get(colour, 0)
    if not channels or depth != 8 or interlaced or any(kind == b"tRNS" for kind, _ in parts):
        raise ValueError("not a PNG of 8 bits, grey or RGB")
    raw = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    pixels = unfiltered(raw, channels * width, channels)
    if channels == 1:
        return f"P5 {width} {height} 255\n".encode() + pixels
    sums = [sum(pixels[i:i + 3]) for i in range(0, len(pixels), 3)]
    return f"P5 {width} {height} 765\n".encode() + struct.pack(f">{len(sums)}H", *sums)
