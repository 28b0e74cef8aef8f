#!/usr/bin/env python3
"""Laws of the model, measured on what `fumage-cli dump` and `fumage-cli render` write, and on nothing else.

usage: laws_from_outside.py <fumage-cli>
"""
import csv
import io
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

CLI = sys.argv[1]
# Where Kolmogorov's distance times the root of the count lies once in ten thousand.
ONE_IN_TEN_THOUSAND = 2.2255

# One burst of particles that stay, and nothing that moves them.
STILL = {"emitter.mode": "burst", "emitter.burst_duration": 0, "emitter.speed": 0, "emitter.velocity_randomness": 0, "emitter.normal": "0,1,0", "motion.gravity": 0,
         "wind.strength": 0, "motion.randomness": 0, "motion.rotation_jitter": 0, "life.fade_rate": 0.005, "timeline.prewarm": "false"}


def cli(*arguments):
    run = subprocess.run([CLI, *arguments], capture_output=True, check=False)
    assert run.returncode == 0, run.stderr.decode()
    return run.stdout.decode()


def settings(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def particles(frame, **changes):
    """Rows of floats by the names of the columns."""
    values = STILL | {key.replace("__", "."): value for key, value in changes.items()}
    text = cli("dump", "thesis-2012", "--frame", str(frame), *settings(values))
    return [{key: float(number) for key, number in row.items()} for row in csv.DictReader(io.StringIO(text))]


def distance_from_uniform(numbers, low, high):
    ordered = sorted((number - low) / (high - low) for number in numbers)
    count = len(ordered)
    return max(max((i + 1) / count - u, u - i / count) for i, u in enumerate(ordered))


def premultiplied(png):
    """Linear premultiplied luminance and alpha of each pixel of a PNG with 16 bits and alpha."""
    data = png.read_bytes()
    at, packed, width = 8, b"", 0
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, _, depth, colour, _, _, _ = struct.unpack(">IIBBBBB", body)
            assert (depth, colour) == (16, 6)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    raw = zlib.decompress(packed)
    stride = width * 8
    before = bytearray(stride)
    for begin in range(0, len(raw), stride + 1):
        kind, line = raw[begin], bytearray(raw[begin + 1:begin + 1 + stride])
        for i in range(stride):
            left, up, corner = (line[i - 8] if i >= 8 else 0), before[i], (before[i - 8] if i >= 8 else 0)
            nearest = min((left, up, corner), key=lambda byte: abs(left + up - corner - byte))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
        before = line
        for r, g, b, a in struct.iter_unpack(">4H", line):
            if a:
                yield (0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)) * a / 65535, a / 65535


def linear(value):
    """IEC 61966-2-1."""
    value /= 65535
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


class Laws(unittest.TestCase):
    def test_directions_are_even_over_the_cone(self):
        for spread in (1, 30, 90, 180):
            born = particles(0, emitter__count=20000, emitter__speed=1, emitter__spread=spread)
            heights = [((row["vx"]) ** 2 + (row["vy"] - 1) ** 2 + row["vz"] ** 2) / 2 for row in born]  # 1 - cos(angle), from the chord
            distance = distance_from_uniform(heights, 0, 1 - math.cos(math.radians(spread)))
            self.assertLess(distance * math.sqrt(len(heights)), ONE_IN_TEN_THOUSAND, f"at {spread} degrees")

    def test_a_vortex_keeps_its_radius(self):
        for steps in (1, 8):
            changes = {"emitter__count": 2000, "vortex__strength": 1, "vortex__radius": 0.5, "timeline__steps_per_frame": steps}
            radii = [[math.hypot(row["x"], row["z"]) for row in particles(frame, **changes)] for frame in (0, 300)]
            self.assertAlmostEqual(sum(radii[1]) / sum(radii[0]), 1, delta=0.01)

    def test_terminal_velocity_is_the_force_over_the_drag(self):
        for drag in (0.8, 5, 29, 90):  # times 1/30 s: up to 3
            falling = particles(1500, emitter__count=10, motion__gravity=3, motion__drag=drag, life__fade_rate=0.001)
            for row in falling:
                self.assertAlmostEqual(row["vy"] / (-3 / drag), 1, delta=1e-3)

    def test_smoke_is_as_bright_in_few_particles_as_in_many(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "smoke.png"
            shipped = json.loads(cli("presets", "--show", "plume"))
            opacity = 0.6  # a particle that is opaque by itself cannot stand for sixteen
            brightness = {}
            for share in (1 / 16, 1 / 4, 1, 8):
                changes = {"emitter.count": round(shipped["layers"][0]["emitter"]["count"] * share), "look.opacity": opacity / share, "output.view_transform": "standard", "output.exposure": -2}
                cli("render", "plume", "--frames", "60", "--size", "96", "--format", "png16", "--output", str(picture), *settings(changes))
                pairs = list(premultiplied(picture))
                brightness[share] = sum(light for light, _ in pairs) / sum(alpha for _, alpha in pairs)
            for share, value in brightness.items():
                self.assertAlmostEqual(value / brightness[1], 1, delta=0.02, msg=f"with {share} of the particles: {brightness}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
