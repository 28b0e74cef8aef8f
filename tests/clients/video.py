#!/usr/bin/env python3
"""Films by the real ffmpeg: frames, rate and alpha as ffprobe and ffmpeg's own decoder see them, against rendered pictures.

    tests/clients/video.py build/release/bin/fumage-cli

Needs ffmpeg (with libx264 and libvpx) and python3-numpy; some minutes.
"""
import fractions
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SIZE = 128
FRAMES = range(20, 32)
LEAST = {"mp4": 34, "webm": 34, "mov": 44, "gif": 24, "apng": 90}
ALPHA = {"webm", "mov", "apng"}


def run(*arguments):
    return subprocess.run([str(each) for each in arguments], check=True, capture_output=True).stdout


def decoded(path):
    decoder = ["-c:v", "libvpx-vp9"] if path.suffix == ".webm" else []
    raw = run("ffmpeg", "-loglevel", "error", *decoder, "-i", path, "-f", "rawvideo", "-pix_fmt", "rgba", "-")
    return np.frombuffer(raw, np.uint8).reshape(-1, SIZE, SIZE, 4).astype(float)


def covered(pictures, behind):
    """Straight alpha over a colour."""
    alpha = pictures[..., 3:] / 255
    return pictures[..., :3] * alpha + np.array(behind) * (1 - alpha)


def main():
    cli = sys.argv[1]
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        common = ["chimney", "--frames", f"{FRAMES[0]}-{FRAMES[-1]}", "--size", SIZE, "--quiet"]
        for ending, least in LEAST.items():
            background = ["--set", "output.background=" + ("transparent" if ending in ALPHA else "colour")]
            run(cli, "render", *common, *background, "--output", folder / ending / "still_##.png")
            film = folder / f"film.{ending}"
            run(cli, "video", *common, *background, "--output", film)
            stream = json.loads(run("ffprobe", "-v", "error", "-count_frames", "-show_streams", "-of", "json", film))["streams"][0]
            stills = np.concatenate([decoded(folder / ending / f"still_{frame:02}.png") for frame in FRAMES])
            frames = decoded(film)
            error = min(10 * np.log10(255**2 / max(1e-9, np.mean((covered(frames, behind) - covered(stills, behind)) ** 2))) for behind in ((0, 0, 0), (255, 255, 255)))
            # Frames of a GIF last whole hundredths of a second.
            rate = float(fractions.Fraction(stream["avg_frame_rate"]))
            right = len(frames) == len(FRAMES) and error >= least and abs(rate - 30) < (4 if ending == "gif" else 0.01) and (stream["width"], stream["height"]) == (SIZE, SIZE)
            right &= (frames[..., 3].min() == 0) == (ending in ALPHA)
            print(f"{ending:5} {stream['codec_name']:10} {len(frames)} frames, {error:.1f} dB over black or white, alpha {frames[..., 3].min():.0f} to {frames[..., 3].max():.0f}: {'as rendered' if right else 'WRONG'}")
            failed |= not right
    return failed


sys.exit(main())
