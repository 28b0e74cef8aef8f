#!/usr/bin/python3
"""Packs PNG pictures into an icon of Windows:  icon.py OUT.ico PICTURE.png...

Up to 128 pixels as bitmaps, which every program that shows icons reads; larger ones as the PNG that they are.
"""
import pathlib
import struct
import sys

from PIL import Image  # Debian's python3-pil

MAX_BITMAP = 128  # pixels a side


def bitmap(image):
    """Rows from below, BGRA, and a mask of one bit, which is nowhere set: alpha says it."""
    width, height = image.size
    pixels = image.transpose(Image.Transpose.FLIP_TOP_BOTTOM).tobytes("raw", "BGRA")
    mask = bytes((width + 31) // 32 * 4 * height)
    return struct.pack("<IiiHHIIiiII", 40, width, 2 * height, 1, 32, 0, len(pixels) + len(mask), 0, 0, 0, 0) + pixels + mask


def main():
    out, pictures = pathlib.Path(sys.argv[1]), [pathlib.Path(word) for word in sys.argv[2:]]
    images = [(path, Image.open(path).convert("RGBA")) for path in pictures]
    parts = [bitmap(image) if image.width <= MAX_BITMAP else path.read_bytes() for path, image in images]
    header = struct.pack("<HHH", 0, 1, len(parts))
    at = len(header) + 16 * len(parts)
    for (_, image), part in zip(images, parts):
        header += struct.pack("<BBBBHHII", image.width % 256, image.height % 256, 0, 0, 1, 32, len(part), at)
        at += len(part)
    out.write_bytes(header + b"".join(parts))


main()
