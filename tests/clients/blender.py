#!/usr/bin/env python3
"""Volumes, particles and layers as Blender reads them, and the smoke that Cycles makes of a volume beside ours.

    /usr/bin/python3 tests/clients/blender.py build/release/bin/fumage-cli [folder for the pictures]

Needs blender (3.4), python3-numpy and python3-pil; a minute or two. Smoke in wind is seen from the side, so that nothing in it is symmetric: a volume that were
mirrored or turned would not lie on our picture. How much smoke there is, and where its middle is, Blender tells by pictures along parallel lines.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

from smoke import mass, particles, run

PRESET = "plume"
FRAMES = [40, 41, 42]
SIZE = 256
CELLS = 96
PLACE, VIEW = (5.5, 3.2, 9.5), (-0.4, -0.05, -1.0)
SETTINGS = [f"--set={each}" for each in ("wind.strength=1.2", "wind.angle=0", "emitter.count=30000", "timeline.prewarm=false", "camera.mode=fixed", f"camera.position={list(PLACE)}",
                                         f"camera.view={list(VIEW)}", "camera.focal_length=50", "light.direction=[-0.6,-0.64,-0.48]")]
LAYERS = {"Combined", "Alpha", "albedo", "alpha", "density", "depth", "emission", "motion", "normal", "shadow", "sixway_a", "sixway_b", "temperature"}
# Motion is that of what is seen, and of dense smoke only the surface is seen. Of smoke this thin all is, each particle as much as it holds.
THIN = ["--set=look.opacity=0.02"]


def upright(place):
    """Ours, y up, as Blender's, z up."""
    return np.array([place[0], -place[2], place[1]])


def camera():
    forward = upright(VIEW) / np.linalg.norm(VIEW)
    right = np.cross(forward, (0, 0, 1))
    right /= np.linalg.norm(right)
    return upright(PLACE), forward, np.cross(right, forward)


def write(cli, folder):
    """What Blender is to read."""
    volumes = [folder / f"smoke_{frame:04}.vdb" for frame in FRAMES]
    last = FRAMES[-1]
    run(cli, "volume", PRESET, "--frames", f"{FRAMES[0]}-{last}", "--cells", CELLS, "--output", folder / "smoke_####.vdb", *SETTINGS)
    run(cli, "dump", PRESET, "--frame", last, "--up", "z", "--output", folder / "smoke.ply", *SETTINGS)
    for name, extra in (("layers.exr", ["--passes", "all"]), ("thin.exr", ["--passes", "colour,motion", *THIN]), ("ours.png", [])):
        run(cli, "render", PRESET, "--frames", last, "--size", SIZE, "--output", folder / name, *SETTINGS, *extra)
    place, forward, up = camera()
    return {"folder": str(folder), "frames": FRAMES, "volumes": [str(each) for each in volumes], "views": 96, "size": SIZE, "albedo": 0.82, "sun": upright((-0.6, -0.64, -0.48)).tolist(),
            "camera": {"place": place.tolist(), "forward": forward.tolist(), "up": up.tolist(), "lens": 50, "sensor": 36}, "points": str(folder / "smoke.ply"), "layers": ["layers", "thin"]}


def ask_blender(task, folder):
    (folder / "task.json").write_text(json.dumps(task))
    inside = pathlib.Path(__file__).with_name("blender_reads.py")
    done = subprocess.run(["blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", inside, "--", folder / "task.json", folder / "answer.json"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stdout[-4000:] + done.stderr[-4000:])
    return json.loads((folder / "answer.json").read_text())


def check_volumes(cli, seen):
    assert seen["sequence"] and seen["duration"] == len(FRAMES), seen
    for frame, found in zip(FRAMES, seen["frames"]):
        assert found["file"].endswith(f"smoke_{frame:04}.vdb"), found["file"]
        assert found["grids"] == {"density": ["FLOAT", 1], "temperature": ["FLOAT", 1], "vel": ["VECTOR_FLOAT", 3]}, found["grids"]
        smoke = particles(cli, PRESET, frame, "z", SETTINGS)
        places = np.stack([smoke[axis] for axis in "xyz"])
        weight = mass(smoke)
        middle = (places * weight).sum(1) / weight.sum()
        lower, upper = np.array(found["bounds"])
        reach = (upper - lower).max() / CELLS
        # All that particles cover, and no more than some cells around it.
        least, most = (places - smoke["radius"]).min(1), (places + smoke["radius"]).max(1)
        assert (lower <= least + reach).all() and (upper >= most - reach).all(), (found["bounds"], least, most)
        assert (lower >= least - 10 * reach).all() and (upper <= most + 10 * reach).all(), (found["bounds"], least, most)
        for view, axes in (("front", (0, 2)), ("side", (1, 2))):
            whole = found[view]["whole"] / weight.sum()
            away = [float(found[view]["centre"][axis] - middle[axis]) / reach for axis in axes]
            print(f"frame {frame}, {view}: {whole:.3f} of the smoke, its middle {away[0]:.2f} and {away[1]:.2f} cells away along {'xyz'[axes[0]]} and z")
            assert abs(whole - 1) < 0.03 and np.abs(away).max() < 0.75, (whole, found[view]["centre"], middle)


def check_points(cli, seen):
    smoke = particles(cli, PRESET, FRAMES[-1], "z", SETTINGS)
    places = np.stack([smoke[axis] for axis in "xyz"])
    assert seen["count"] == places.shape[1], (seen["count"], places.shape)
    assert np.allclose(seen["bounds"], [places.min(1), places.max(1)], atol=1e-5), seen["bounds"]
    assert np.allclose(np.array(seen["sum"]) / seen["count"], places.mean(1), atol=1e-4)
    print(f"points: {seen['count']}, in their places")


def check_layers(folder, names, away):
    assert set(names) == LAYERS, names
    for name in LAYERS:
        assert (folder / f"layers_{name}.npy").exists(), f"Blender reads nothing of {name}"
    layers = {name: np.load(folder / f"layers_{name}.npy") for name in LAYERS}
    ours = np.asarray(Image.open(folder / "ours.png"), dtype=np.float64)[::-1] / 255
    colour = layers["Combined"]
    alpha = colour[..., 3]
    straight = colour[..., :3] / np.maximum(alpha, 1e-6)[..., None]
    coded = np.where(straight < 0.0031308, 12.92 * straight, 1.055 * np.maximum(straight, 0) ** (1 / 2.4) - 0.055)
    thick = alpha > 0.2
    apart = np.abs(np.clip(coded, 0, 1) - ours[..., :3])[thick].max() * 255
    assert np.abs(alpha - ours[..., 3]).max() * 255 < 1 and apart < 2, apart
    assert np.abs(layers["alpha"][..., 0] - alpha).max() < 1e-3 and np.abs(layers["Alpha"][..., 0] - alpha).max() < 1e-3
    depth = layers["depth"][..., 0][thick]
    assert away.min() - 0.5 < depth.min() and depth.max() < away.max() + 0.5, (depth.min(), depth.max(), away.min(), away.max())
    print(f"layers: {len(names)}, colour within {apart:.1f} / 255 of the PNG's, depth {depth.min():.2f} to {depth.max():.2f} m")


def check_motion(folder, smoke, away):
    """The mean of the layer over the smoke of each pixel beside that of the particles over what each holds."""
    alpha = np.load(folder / "thin_Combined.npy")[..., 3]
    motion = np.load(folder / "thin_motion.npy")
    assert alpha.max() < 0.6, f"smoke that hides itself: alpha is up to {alpha.max()}"
    _, forward, up = camera()
    velocity = np.stack([smoke["v" + axis] for axis in "xyz"])
    weight = mass(smoke)
    pixels = 50 / 36 * SIZE / 30 / away
    for axis, across in enumerate((np.cross(forward, up), up)):
        expected = ((across @ velocity) * pixels * weight).sum() / weight.sum()
        moved = (motion[..., axis] * alpha).sum() / alpha.sum()
        print(f"motion {'XY'[axis]}: {moved:.2f} pixels a frame, particles {expected:.2f}")
        assert abs(moved - expected) < 0.2 * max(abs(expected), 0.5), (moved, expected)


def check_pictures(folder, keep):
    """Cycles knows nothing of how we draw: what must agree is what is covered, and that no other way of holding it would agree better."""
    ours, theirs = (Image.open(folder / name).convert("RGBA") for name in ("ours.png", "blender.png"))
    a, b = (np.asarray(image, dtype=np.float64)[..., 3] for image in (ours, theirs))
    ways = {"as it is": b, "mirrored": b[:, ::-1], "upside down": b[::-1], "turned": b[::-1, ::-1], "shifted by 8 pixels": np.roll(b, 8, 1), "raised by 8 pixels": np.roll(b, 8, 0)}
    alike = {way: float(np.corrcoef(a.ravel(), other.ravel())[0, 1]) for way, other in ways.items()}
    print("cover in both pictures, correlation: " + ", ".join(f"{way} {value:.3f}" for way, value in alike.items()))
    sheet = Image.new("RGBA", (2 * SIZE, SIZE), (29, 79, 145, 255))
    sheet.alpha_composite(ours, (0, 0))
    sheet.alpha_composite(theirs, (SIZE, 0))
    if keep:
        keep.mkdir(parents=True, exist_ok=True)
        sheet.convert("RGB").save(keep / "ours_and_blender.png")
    assert alike["as it is"] > 0.9 and max(alike, key=alike.get) == "as it is", alike


def main():
    cli = sys.argv[1]
    keep = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        seen = ask_blender(write(cli, folder), folder)
        check_volumes(cli, seen["volumes"])
        check_points(cli, seen["points"])
        smoke = particles(cli, PRESET, FRAMES[-1], "z", SETTINGS)
        place, forward, _ = camera()
        away = forward @ (np.stack([smoke[axis] for axis in "xyz"]) - place[:, None])
        check_layers(folder, seen["layers"]["layers"], away)
        check_motion(folder, smoke, away)
        check_pictures(folder, keep)
        print(f"Blender {seen['version']}")


if __name__ == "__main__":
    main()
