"""The particles of a frame, as `fumage-cli dump` writes them. Needs python3-numpy."""
import csv
import io
import math
import subprocess

import numpy as np


def run(*arguments):
    return subprocess.run([str(each) for each in arguments], check=True, capture_output=True, text=True).stdout


def particles(cli, preset, frame, up, settings):
    """Columns by their names."""
    rows = csv.DictReader(io.StringIO(run(cli, "dump", preset, "--frame", frame, "--up", up, *settings)))
    return {key: np.array(values) for key, values in zip(rows.fieldnames, zip(*[[float(each) for each in row.values()] for row in rows]))}


def mass(smoke):
    """Of each particle: its extinction over its volume, in square metres."""
    return smoke["alpha"] * math.pi * smoke["radius"] ** 2 / 3
