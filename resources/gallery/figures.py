#!/usr/bin/env python3
"""Measures every preset, and writes what it finds into figures.md: `./dev gallery figures`.

Of a second of each at 256 pixels, from frame 60 on, or in the middle of what is shorter: spike, shimmer, dots and
repetition (see faults.py); of its first frame and the next at 512: carried; of the first, fitted, at 384: contrast and
rims (see focus.py). Then what it takes to make its frame 40 alone at 512 pixels, and a sheet of 64 cells of 256.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass

import numpy as np

from faults import Carried, carried, dots, repetition, shimmer
from gallery import densities_of, focus_of, render, spike_of

SECOND = 30  # frames
USUAL_FIRST = 60
# What the pictures are held to (tests/rendering/faults_test.py holds three presets to the first two).
MOST = {"spike": 1.05, "shimmer": 1.2, "dots": 1.75}
TEXT = """# Figures of the presets

Written by `./dev gallery figures`, never by hand; what each says stands in [README.md](README.md).

## Faults and focus

`spike`, `shimmer`, `dots`, `repetition`: of a second at 256 pixels, see faults.py; solvers' pictures have 0 to 1.75
dots, 4000 small particles 7 to 11 and a shimmer of 1.5. `carried`: how much of the detail of a frame goes with the
smoke into the next, of 1; `way`: how far, in pixels of a picture of 512 (median). `contrast`: deviation of
ln(luminance) within the body, in the bands under 1, 1 to 2 and 2 to 4 pixels of a fitted picture of 384; `rims`: their
widths in pixels, the 10th, 50th and 90th percentile, see focus.py. A dash stands where there is no body.

| preset | spike | shimmer | dots | repetition | carried | way | contrast | rims |
|---|---|---|---|---|---|---|---|---|
{faults}

Beyond a spike of {spike}, a shimmer of {shimmer} or {dots} dots: {beyond}.

## Time

Seconds for frame 40 alone at 512 x 512 and for a sheet of 8 x 8 cells of 256, and the largest memory of the sheet;
the shorter of two runs, nothing is baked before, {threads} threads. Hosts differ: only figures of one table can be
compared.

| preset | frame, s | sheet, s | sheet, MB |
|---|---|---|---|
{times}
"""


@dataclass
class Run:
    seconds: float
    megabytes: float


def run(command: list[str]) -> Run:
    """Runs a command, and says what it took."""
    begun = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        raise subprocess.CalledProcessError(child.returncode, command)
    return Run(time.monotonic() - begun, usage.ru_maxrss / 1024)


def sooner(command: list[str]) -> Run:
    """The shorter of two runs: what else a machine does only adds to one."""
    return min((run(command) for _ in range(2)), key=lambda each: each.seconds)


def first_frame(cli: str, preset: str) -> int:
    told = subprocess.run([cli, "info", preset, "--json"], check=True, capture_output=True, text=True).stdout
    length = int(json.loads(told)["frames"])
    return USUAL_FIRST if length >= USUAL_FIRST + SECOND else max(0, (length - SECOND) // 2)


def carried_of(cli: str, preset: str, frame: int, folder: pathlib.Path) -> Carried:
    """Over grey, as the eye sees it."""
    frames = [np.asarray(render(cli, preset, number, folder / "seen.png", (512, 512), [], ()), dtype=float) / 255 for number in (frame, frame + 1)]
    alphas = [picture[..., 3] for picture in frames]
    seen = [picture[..., :3].mean(-1) * alpha + 0.25 * (1 - alpha) for picture, alpha in zip(frames, alphas)]
    return carried(*seen, np.minimum(*alphas) > 0.9)


def numbers(values: list[float], digits: int) -> str:
    return " ".join("-" if not np.isfinite(value) else f"{value:.{digits}f}" for value in values)


def main() -> None:
    cli = sys.argv[1]
    here = pathlib.Path(__file__).parent
    faults, times, beyond = [], [], []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for preset in sorted(path.stem for path in (here.parent / "presets").glob("*.json")):
            first = first_frame(cli, preset)
            second = densities_of(cli, preset, first, SECOND, folder, [])
            found = {"spike": spike_of(second), "shimmer": shimmer(second), "dots": dots(second[0])}
            going = carried_of(cli, preset, first, folder)
            bands, widths = focus_of(cli, preset, first, folder)
            faults.append(
                f"| {preset} | {numbers(list(found.values()), 2).replace(' ', ' | ')} | {repetition(second[0]):.2f} "
                f"| {numbers([going.share], 2)} | {numbers([going.pixels], 1)} "
                f"| {numbers(bands, 3)} | {numbers(widths, 1)} |"
            )
            if any(found[key] > most for key, most in MOST.items()):
                beyond.append(f"`{preset}`")
            alone = sooner([cli, "render", preset, "--frames", "40", "--size", "512", "--output", str(folder / "alone.png")])
            sheet = sooner([cli, "flipbook", preset, "--grid", "8x8", "--size", "256", "--output", str(folder / "sheet.png")])
            times.append(f"| {preset} | {alone.seconds:.1f} | {sheet.seconds:.1f} | {sheet.megabytes:.0f} |")
            print(faults[-1], times[-1], flush=True)
    threads = len(os.sched_getaffinity(0))
    (here / "figures.md").write_text(
        TEXT.format(faults="\n".join(faults), times="\n".join(times), beyond=", ".join(beyond) or "none", threads=threads, **MOST)
    )


if __name__ == "__main__":
    main()
