#!/usr/bin/python3
"""Plays the scene of `fumage-cli flipbook --for godot3` in Godot 3 and holds what it shows against the cells of the sheet.

usage: godot3.py <fumage-cli> [presets]...
Needs Debian's godot3 and godot3-server, python3-numpy, python3-pil, and a display (tests/editor/on_screen.sh gives one). The server imports the
textures, as the editor does when it comes to the front. A camera without perspective sees the quad pixel for pixel; after half the lifetime Godot must
show the middle of the sheet, give or take a few frames of the screen: what lies between two cells is rebuilt here by the formula of engines:
C_i read against its vectors, C_i+1 along its own, mixed.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

SIZE = 128
GRID = 4
LEAST = 35.0 # dB; the moment is found to a 16th of a cell

PROJECT = """[application]
config/name="Fumage"
[rendering]
quality/driver/driver_name="GLES3"
environment/default_clear_color=Color( 0, 0, 0, 1 )
"""
PROBE = """extends SceneTree
var seconds = 0.0
var smoke
func _init():
	var scene = load("res://sheet.tscn").instance()
	get_root().add_child(scene)
	smoke = scene.get_node("Smoke")
	var camera = Camera.new()
	camera.projection = Camera.PROJECTION_ORTHOGONAL
	camera.size = smoke.draw_pass_1.size.y
	camera.transform.origin = smoke.transform.origin + Vector3(0, 0, 9)
	get_root().add_child(camera)
	camera.current = true
func _idle(delta):
	seconds += delta
	if seconds >= 0.5 * smoke.lifetime:
		var image = get_root().get_texture().get_data()
		image.flip_y()
		image.save_png("res://shot.png")
		quit()
	return false
"""


def decibels(a, b):
    return -10.0 * numpy.log10(numpy.mean((a - b) ** 2) + 1e-10)


def linear_of(stored):
    return numpy.where(stored <= 0.04045, stored / 12.92, ((stored + 0.055) / 1.055) ** 2.4)


def stored_of(linear):
    return numpy.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055)


def fetch(cell, x, y):
    """Bilinear, at the middle of pixels; beyond the outermost it is theirs."""
    x, y = numpy.clip(x, 0, SIZE - 1), numpy.clip(y, 0, SIZE - 1)
    left, top = x.astype(int), y.astype(int)
    right, bottom = numpy.minimum(left + 1, SIZE - 1), numpy.minimum(top + 1, SIZE - 1)
    across, down = (x - left)[..., None], (y - top)[..., None]
    return (cell[top, left] * (1 - across) + cell[top, right] * across) * (1 - down) + (cell[bottom, left] * (1 - across) + cell[bottom, right] * across) * down


def expected(cells, vectors, place):
    """What stands over black between two cells."""
    now, share = int(place), place - int(place)
    y, x = numpy.mgrid[0:SIZE, 0:SIZE].astype(float)
    seen = []
    for cell, way in ((now, -share), (now + 1, 1 - share)):
        moved = fetch(cells[cell], x + vectors[cell][..., 0] * way * SIZE, y - vectors[cell][..., 1] * way * SIZE)
        seen.append(numpy.concatenate([moved[..., :3] * moved[..., 3:], moved[..., 3:]], axis=-1))
    return stored_of((seen[0] * (1 - share) + seen[1] * share)[..., :3])


def cells_of(pixels):
    return [pixels[y : y + SIZE, x : x + SIZE] for y in range(0, GRID * SIZE, SIZE) for x in range(0, GRID * SIZE, SIZE)]


def main():
    cli = pathlib.Path(sys.argv[1]).resolve()
    failed = False
    for preset in sys.argv[2:] or ["campfire", "default"]:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            subprocess.run([cli, "flipbook", preset, "--for", "godot3", "--size", str(SIZE), "--grid", str(GRID), "--output", folder / "sheet.png"], check=True, capture_output=True)
            (folder / "project.godot").write_text(PROJECT)
            (folder / "probe.gd").write_text(PROBE)
            subprocess.run(["godot3-server", "--path", name, "--editor", "--quit"], check=True, capture_output=True, timeout=120)
            subprocess.run(["godot3", "--audio-driver", "Dummy", "--path", name, "--resolution", f"{SIZE}x{SIZE}", "--fixed-fps", "60", "-s", "probe.gd"], check=True, capture_output=True, timeout=240)
            shot = numpy.asarray(Image.open(folder / "shot.png").convert("RGB"), dtype=numpy.float64) / 255.0
            sheet = numpy.asarray(Image.open(folder / "sheet.png").convert("RGBA"), dtype=numpy.float64) / 255.0
            cells = cells_of(numpy.concatenate([linear_of(sheet[..., :3]), sheet[..., 3:]], axis=-1))
            facts = json.loads((folder / "sheet.flipbook.json").read_text())
            scale = next(picture["scale"] for picture in facts["pictures"] if picture["pass"] == "motion")
            motion = numpy.asarray(Image.open(folder / "sheet_motion.png").convert("RGB"), dtype=numpy.float64) / 255.0
            vectors = cells_of((motion[..., :2] * 2 - 1) * scale)
            middle = len(cells) // 2
            scores = {place: decibels(shot, expected(cells, vectors, place)) for place in (middle + i / 16 for i in range(-24, 25))}
            best = max(scores, key=scores.get)
            print(f"{preset:16} Godot shows place {best} of {len(cells)} with {scores[best]:.1f} dB; half a cell from it there are {scores[best - 0.5 if best > middle else best + 0.5]:.1f} dB", flush=True)
            once = "false" if facts["loop"] else "true"
            once = "false" if facts["loop"] else "true"
            if abs(best - middle) > 0.5 or scores[best] < LEAST or f"one_shot = {once}" not in (folder / "sheet.tscn").read_text():
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
