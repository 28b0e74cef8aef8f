#!/usr/bin/python3
"""What exrheader and oiiotool see in an EXR of all passes.

usage: exr.py <fumage-cli>
Needs openexr and openimageio-tools. Every layer is there with its letters, and what the file says of itself; the numbers of layers fit one another.
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

SIZE = 24
LAYERS = {
    "": "RGBA", "alpha": "Y", "density": "Y", "sixway_a": "RGBA", "sixway_b": "RGBA", "motion": "XYZ", "normal": "XYZ", "depth": "Z", "emission": "RGBA", "albedo": "RGBA",
    "temperature": "Y", "shadow": "Y",
}
CHANNELS = {f"{layer}.{letter}".lstrip(".") for layer, letters in LAYERS.items() for letter in letters}


def run(*arguments):
    return subprocess.run([str(each) for each in arguments], check=True, capture_output=True, text=True).stdout


def pixels(file):
    """Dictionaries of channels."""
    names = None
    for line in run("oiiotool", "--info", "-v", file).splitlines():
        if "channel list:" in line:
            names = [name.split()[0] for name in line.split(":", 1)[1].split(",")]
    assert names is not None
    for line in run("oiiotool", "--dumpdata", file).splitlines():
        found = re.match(r"\s*Pixel \(\d+, \d+\): (.*)", line)
        if found:
            yield dict(zip(names, map(float, found[1].split("(")[0].split())))


def main():
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "all.exr"
        run(sys.argv[1], "--quiet", "render", "steam", "--set", "glow.emission=1", "--frames", 30, "--size", SIZE, "--passes", "all", "--output", file)
        header = run("exrheader", file)
        seen = set(re.findall(r"^\s+([\w.]+), 16-bit floating-point", header, re.MULTILINE))
        assert seen == CHANNELS, seen ^ CHANNELS
        for attribute in ("chromaticities", "framesPerSecond", "software"):
            assert attribute in header, attribute
        info = run("oiiotool", "--info", "-v", file)
        assert f"{SIZE} x {SIZE}" in re.sub(r" +", " ", info), info
        count = 0
        for pixel in pixels(file):
            assert set(pixel) == CHANNELS, set(pixel) ^ CHANNELS
            alpha = pixel["A"]
            assert abs(pixel["alpha.Y"] - alpha) < 1e-6
            assert alpha > 0.999 or abs(1.0 - math.exp(-pixel["density.Y"]) - alpha) < 2e-3, pixel
            for layer in ("sixway_a", "albedo"):
                assert abs(pixel[f"{layer}.A"] - alpha) < 1e-6
            count += alpha > 0.0
        assert count > SIZE, count
        print(f"exrheader and oiiotool see {len(CHANNELS)} channels of {len(LAYERS)} layers; they fit one another in {count} pixels with smoke")


if __name__ == "__main__":
    main()
