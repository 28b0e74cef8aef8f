#!/usr/bin/python3
"""Pictures with the preset that they carry, in programs that know nothing of it.

usage: notes.py <fumage-cli>
Needs ffmpeg; ImageMagick where it is installed. ffmpeg reads the pixels of every EXR that carries a preset, with layers and without, as of one that
carries none: of all built-in presets, and of forty that differ in the length of their description. What ImageMagick writes anew of a PNG still opens as
the preset and the frame that it was made of.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

SIZE = 24
FEW = ["--set", "emitter.count=300", "--set", "noise.slices=4", "--set", "noise.resolution=16", "--set", "air.resolution=16", "--size", SIZE]
FRAME = 20


def run(*arguments):
    return subprocess.run([str(each) for each in arguments], check=True, capture_output=True).stdout


def floats_of(exr):
    """What ffmpeg makes of an EXR: planes of 32-bit floats."""
    return run("ffmpeg", "-v", "error", "-i", exr, "-f", "rawvideo", "-pix_fmt", "gbrapf32le", "-")


def check_exr(cli, preset, folder):
    """Returns whether there is smoke in the picture."""
    carrying, bare = folder / "carrying.exr", folder / "bare.exr"
    run(cli, "--quiet", "render", preset, "--frame", FRAME, "--no-preset", *FEW, "--output", bare)
    truth = floats_of(bare)
    assert len(truth) == 4 * 4 * SIZE * SIZE, (preset, len(truth))
    for more in ([], ["--passes", "alpha,normal,depth"], ["--format", "exr32"]):
        run(cli, "--quiet", "render", preset, "--frame", FRAME, *FEW, *more, "--output", carrying)
        seen = floats_of(carrying)
        assert more[:1] == ["--format"] and len(seen) == len(truth) or seen == truth, (preset, more)
    return any(truth)


def presets_of_lengths(cli, folder):
    preset = json.loads(run(cli, "presets", "--show", "magic"))
    for length in range(40):
        preset["description"] = "x" * length + "煙" * (length % 3)
        file = folder / f"length{length}.json"
        file.write_text(json.dumps(preset))
        yield file


def check_png(cli, preset, folder):
    ours, theirs = folder / "ours.png", folder / "theirs.png"
    for form in ("png", "png16"):
        run(cli, "--quiet", "render", preset, "--frame", FRAME, *FEW, "--format", form, "--output", ours)
        for change in ([], ["-resize", "50%"], ["-colors", "16"]):
            run("convert", ours, *change, theirs)
            assert run(cli, "presets", "--show", theirs) == run(cli, "presets", "--show", ours), (preset, change)
            assert json.loads(run(cli, "info", theirs, "--json"))["frame"] == FRAME, (preset, change)


def main():
    cli = pathlib.Path(sys.argv[1]).resolve()
    names = [each["id"] for each in json.loads(run(cli, "presets", "--json")) if each["builtin"]]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        presets = names + list(presets_of_lengths(cli, folder))
        with_smoke = sum(check_exr(cli, preset, folder) for preset in presets)
        assert with_smoke > len(presets) - 4, with_smoke  # some are still empty at this frame
        print(f"ffmpeg reads {len(presets)} EXR with their presets, with layers and without, as those without; {with_smoke} of them have smoke")
        if shutil.which("convert"):
            for preset in presets[-3:] + names[:3]:
                check_png(cli, preset, folder)
            print("what ImageMagick writes anew of a PNG is still the preset and the frame")


if __name__ == "__main__":
    main()
