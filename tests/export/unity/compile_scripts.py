#!/usr/bin/env python3
"""Compiles and runs the C# that sheets bring for Unity, against as much of Unity as it uses:  compile_scripts.py <fumage-cli>

Of sheets with and without layers, light maps, glow and markers, and with names that would break C#: each script compiles without warnings in one project
with the others, its menu item finds the pictures, and the events of its animation are the markers, at their times, with their very names. Where there is
no mcs or mono the test is skipped (77).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
FEW = [word for layer in range(1, 5) for word in ("--set", f"{layer}/emitter.count=20")]
MARKERS = ['Boom "q" \\u0022 é', "{{#loop}} */ // ${x}", "烟 @if", "a\\", "%s {0}"]
SHEETS = {  # name of the picture: preset and options
    "plain.png": ["thesis-2012", "--set", "emitter.count=20"],
    "glows.png": ["blast", *FEW, "--passes", "colour,six-way,motion"],
    "stacked.png": ["blast", *FEW, "--layers-as", "stacked"],
    "loops.png": ["torch", "--set", "1/emitter.count=20", "--set", "2/emitter.count=20", "--set", "air.enabled=false", "--frames", "0-89"],
    'a "b\' é {{x}} \\u0022;.png': ["thesis-2012", "--set", "emitter.count=20"],
    "1 class if.png": ["thesis-2012", "--set", "emitter.count=20"],
}


def checked(command, **options):
    done = subprocess.run(command, capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{command}:\n{done.stdout[:3000]}{done.stderr[:3000]}"
    return done.stdout


def make_sheet(cli, folder, name, words, number):
    """A sheet with markers, but for the first, in a folder of its own. Gives the events that its description has."""
    folder.mkdir()
    markers = [word for i, each in enumerate(MARKERS if number else []) for word in ("--marker", f"{each}={0.1 + 0.05 * i:.2f}")]
    checked([cli, "-q", "flipbook", *words, "--for", "unity", "--size", "16", "--grid", "2x2", *markers, "--output", name], cwd=folder)
    description = next(folder.glob("*.flipbook.json"))
    return json.loads(description.read_text(encoding="utf-8")).get("events", [])


def main(cli):
    missing = [program for program in ("mcs", "mono") if shutil.which(program) is None]
    if missing:
        print("skipped: there is no " + " and no ".join(missing))
        return SKIPPED
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        wanted = [make_sheet(cli, folder / str(i), *sheet, i) for i, sheet in enumerate(SHEETS.items())]
        scripts = sorted(folder.glob("*/Editor/*.cs"), key=lambda path: int(path.parts[-3]))
        assert len(scripts) == len(SHEETS), scripts
        program = folder / "project.exe"
        engine = pathlib.Path(__file__).parent / "engine.cs"
        checked(["mcs", "-warnaserror", "-define:UNITY_EDITOR", f"-out:{program}", engine, *scripts])
        pictures = sorted(path.name for path in folder.glob("*/*.png"))
        lines = checked(["mono", program, *pictures]).splitlines()
        assert not [line for line in lines if line.startswith("error")], lines
        assert sum(line.startswith("script ") for line in lines) == len(scripts), lines
        found = [(float(line.split()[2]), bytes.fromhex(line.split()[4]).decode(), int(line.split()[3])) for line in lines if line.startswith("event OnMarker ")]
        expected = [(each["seconds"], each["name"], each["cell"]) for events in wanted for each in events]
        assert len(found) == len(expected) and len(expected) >= len(MARKERS), (found, expected)
        for (seconds, name, cell), event in zip(sorted(expected, key=lambda each: each[1:]), sorted(found, key=lambda each: each[1:])):
            assert (name, cell) == event[1:] and abs(seconds - event[0]) < 1e-5, (name, seconds, cell, event)
    print(f"{len(scripts)} scripts compile and run; {len(expected)} events are called by their names")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
