"""A preset of three layers, made of the built-in campfire: smoke, clear flames in the middle of it, and ash. For clients that draw layers over one another."""
import copy
import json
import pathlib
import subprocess

import numpy
from PIL import Image

PRESETS = pathlib.Path(__file__).resolve().parents[2] / "resources/presets"
NAMES = ("Smoke", 'Flames "clear" <b>', "Ash's")


def preset_in(folder):
    """The file of the preset."""
    preset = json.loads((PRESETS / "campfire.json").read_text())
    smoke = preset["layers"][0]
    smoke["emitter"]["count"] = 6000
    smoke["glow"]["emission"] = 0
    smoke["look"] |= {"colour": [0.5, 0.5, 0.55], "size": 0.4}
    flames, ash = copy.deepcopy(smoke), copy.deepcopy(smoke)
    flames["emitter"]["seed"] = 5
    flames["glow"] |= {"emission": 3, "flame_opacity": 0.1}
    flames["life"] |= {"lifetime_variance": 0.5}
    ash["emitter"] |= {"seed": 9, "count": 4000}
    ash["look"] |= {"colour": [0.8, 0.15, 0.05], "opacity": 10}
    preset["layers"] = [smoke, flames, ash]
    for layer, name in zip(preset["layers"], NAMES):
        layer["name"] = name
    file = pathlib.Path(folder) / "layers.json"
    file.write_text(json.dumps(preset))
    return file


def sheets_in(folder, cli, engine, size, grid, *more):
    """Writes stacked sheets for an engine as stack*.png and the sheet of all as whole.png; cells of that over black, premultiplied, row by row."""
    preset = preset_in(folder)
    common = [cli, "--quiet", "flipbook", preset, "--frames", "0-35", "--size", str(size), "--grid", f"{grid}x{grid}", "--set", "timeline.loop=false", "--set", "air.resolution=32"]
    subprocess.run([*common, "--output", folder / "whole.png"], check=True)
    subprocess.run([*common, "--for", engine, "--layers-as", "stacked", *more, "--output", folder / "stack.png"], check=True)
    pixels = numpy.asarray(Image.open(folder / "whole.png").convert("RGBA"), dtype=numpy.float64) / 255.0
    cells = [pixels[y : y + size, x : x + size] for y in range(0, grid * size, size) for x in range(0, grid * size, size)]
    return [numpy.concatenate([cell[..., :3] * cell[..., 3:], cell[..., 3:]], axis=-1) for cell in cells]
