"""TGA as others read it.

    python3 tests/clients/tga.py <fumage-cli>

Needs python3-numpy and python3-pil. A flipbook with all of its passes, as PNG and as TGA: Pillow, and ImageMagick where it is installed, read the same pixels.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

FLIPBOOK = ["campfire", "--grid", "3x2", "--size", "100x60", "--passes", "all", "--set", "emitter.count=2000"]


def pixels(file):
    return numpy.asarray(Image.open(file))


def by_imagemagick(file, like):
    program = shutil.which("convert-im6.q16") or shutil.which("magick")
    if not program:
        return None
    letters = {1: "gray", 3: "rgb", 4: "rgba"}[like.shape[2] if like.ndim == 3 else 1]
    raw = subprocess.run([program, file, "-depth", "8", letters + ":-"], check=True, capture_output=True).stdout
    return numpy.frombuffer(raw, numpy.uint8).reshape(like.shape)


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for name in ["book.png", "book.tga"]:
            subprocess.run([program, "--quiet", "flipbook", *FLIPBOOK, "--output", pathlib.Path(folder) / name], check=True)
        for more in [[], ["--set", "output.background=colour"]]:
            for name in ["frame.png", "frame.tga"]:
                subprocess.run([program, "--quiet", "render", "campfire", "--frames", "20", "--size", "100", *more, "--output", pathlib.Path(folder) / (name[:5] + str(len(more)) + name[5:])], check=True)
        files = sorted(pathlib.Path(folder).glob("*.tga"))
        assert len(files) == 14, files
        for tga in files:
            expected = pixels(tga.with_suffix(".png"))
            seen = pixels(tga)
            expected = expected[..., :3] if expected.shape[-1] == 4 and seen.shape[-1] == 3 else expected
            assert numpy.array_equal(seen, expected), tga.name
            other = by_imagemagick(tga, expected)
            assert other is None or numpy.array_equal(other, expected), tga.name
            print(f"{tga.name}: {seen.shape}, {tga.stat().st_size / (seen.size + 44):.0%} of its pixels' bytes{'' if other is None else ', ImageMagick agrees'}")


main()
