#!/usr/bin/env python3
"""Makes the comparison sheets and their figures: `./dev gallery [folder of references] [folder of older presets]`.

Without a folder the references are those of resources/references, beside our presets of the same kind. The sheets show each reference picture beside ours with the same framing, light and background, the sketches of smoke in air beside ours, every preset at
three moments, beside itself as it was before where older presets are given, and sixty frames of each. The figures
compare the pictures of density (alpha) of the references that have one: the slope of the radial power spectrum, whether it rises again at the size of
the sprites, steep gradients, how far apart structure is (see structure.py; beside it that of two pictures which are known to be worse), and dots at the fringe. Of each preset:
the change from frame to frame, shimmer, dots and repetition (see faults.py), contrast by size and widths of rims (see focus.py).
"""

import pathlib
import subprocess
import sys

import numpy as np
from PIL import Image, ImageDraw

from faults import dots, repetition, shimmer
from focus import contrast, rims
from structure import structure_between

EDGE = 512
BACKGROUND = (29, 79, 145)
# Where the references were taken from: 9 m away at 2.8 m height, level, 50 mm on a 36 mm sensor.
CAMERA = ["camera.mode=fixed", "camera.position=[0,2.8,9]", "camera.view=[0,0,-1]", "camera.focal_length=50"]
FRONT = ["light.direction=[-0.66,-0.64,-0.38]"]
BACK = ["light.direction=[-0.32,0.34,0.88]"]
YOUNG = ["timeline.prewarm=false"]
AIR = ["air.resolution=96", "source.unevenness=1", "look.overlap=6", "look.texture=0.3", "look.deformation=0.5", "life.size=[[0,0.7],[1,1.2]]"]
PLUME = AIR + ["emitter.position=[0,0,0]", "emitter.radius=0.55", "emitter.speed=1.3", "emitter.count=500000", "air.buoyancy=2.2", "air.size=[3,8,3]", "air.turbulence=8", "air.turbulence_scale=0.35"]
SMALL = ["look.size=0.09", "look.opacity=1.5"]
OLD = ["life.fade_rate=0.012", "look.size=0.1", "look.opacity=1.2"]
WIND = AIR + ["light.direction=[0.86,-0.5,0]", "emitter.position=[-1.45,0.58,0]", "emitter.radius=0.22", "emitter.speed=0.3", "life.fade_rate=0.03", "wind.strength=2.6", "motion.drag=2", "air.drag=2", "air.buoyancy=0.7",
              "wind.gust=0", "air.size=[5,2.5,2]", "air.offset=[1.8,-0.6,0]", "air.turbulence=4", "air.turbulence_scale=0.2", "look.size=0.075", "look.opacity=0.7"]
WISP = AIR + ["emitter.position=[0,0.56,0]", "emitter.radius=0.2", "emitter.count=100000", "emitter.speed=0.35", "life.fade_rate=0.012", "air.buoyancy=0.4", "air.size=[1.5,3.5,1.5]", "air.turbulence=0.6",
              "air.turbulence_scale=0.2", "look.size=0.075", "look.opacity=0.25"]
# reference file, preset, frame, what to set
PAIRS = [
    ("solver_plume_rgba_080.png", "plume", 78, CAMERA + FRONT + PLUME + SMALL + YOUNG),
    ("solver_plume_rgba_150.png", "plume", 120, CAMERA + FRONT + PLUME + OLD),
    ("solver_plume_rgba_150_back.png", "plume", 120, CAMERA + BACK + PLUME + OLD),
    ("solver_wind_rgba_110.png", "plume", 110, CAMERA + WIND),
    ("solver_wisp_rgba_140.png", "plume", 140, CAMERA + FRONT + YOUNG + WISP),
]
# resources/references has other scenes than ours: the same kind of smoke at the same age, each in its own picture.
SCENES = [("plume_30.png", "plume", 38, YOUNG), ("plume_54.png", "plume", 68, YOUNG), ("fire_36.png", "campfire", 60, []), ("fire_60.png", "campfire", 75, []), ("explosion_08.png", "explosion", 10, []), ("explosion_20.png", "explosion", 25, [])]
# Eight frames of 128 x 256 side by side, each lit from the right and from above, and the mean of both; no other light.
EMBERGEN = "embergen_fire_smoke_frames.png"
EMBERGEN_FRAMES = (15, 30, 45, 60, 75, 90, 105, 120)
EMBERGEN_BACKGROUND = (64, 96, 128)
EMBERGEN_LIGHTS = ("light.direction=[-1,0,0]", "light.direction=[0,-1,0]")
EMBERGEN_LOOK = ["camera.distance=4.7", "camera.target=[0,2.9,0]", "emitter.radius=0.32", "emitter.count=250000", "life.fade_rate=0.022", "light.intensity=5", "light.colour=[1,1,1]", "light.ambient=0.02", "light.shadow=4",
                 "light.scattering=0.2", "light.anisotropy=0", "look.colour=[0.9,0.9,0.9]", "look.size=0.13", "look.opacity=3", "look.relief=0.5", "motion.pull=0.25"]
# sketch, preset, frame
SKETCHES = [("flow_sketch_plume.png", "plume", 110), ("flow_sketch_mushroom.png", "mushroom-cloud", 80), ("flow_sketch_explosion.png", "explosion", 50)]
# What is known to be worse than ours: smoke that moves like noise; a few large sprites.
WORSE = (["air.enabled=false"], ["air.enabled=false", "emitter.count=1500", "look.opacity=6", "look.size=0.35"])
BAND = (8, 64)  # cycles a picture: from the large billows down to 8 pixels
STEEP = 99.9  # percentile of the reference's gradients


def render(
    cli: str, preset: str, frame: int, out: pathlib.Path, size: tuple[int, int], settings: list[str], options: tuple[str, ...] = ("--supersample", "2")
) -> Image.Image:
    command = [cli, "render", preset, "--frames", str(frame), "--size", f"{size[0]}x{size[1]}", *options, "--output", str(out)]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return Image.open(out).convert("RGBA")


def flat(image: Image.Image, background: tuple[int, int, int] = BACKGROUND) -> Image.Image:
    base = Image.new("RGBA", image.size, background + (255,))
    return Image.alpha_composite(base, image).convert("RGB")


def density(image: Image.Image) -> np.ndarray:
    return np.asarray(image.getchannel("A"), dtype=np.float64) / 255.0


def spectrum(alpha: np.ndarray) -> np.ndarray:
    """Mean power at each whole number of cycles a picture; a Hann window takes the picture's edges out."""
    size = alpha.shape[0]
    window = np.outer(np.hanning(size), np.hanning(size))
    power = np.abs(np.fft.fftshift(np.fft.fft2((alpha - alpha.mean()) * window))) ** 2
    y, x = np.indices(power.shape) - size // 2
    ring = np.hypot(x, y).round().astype(int).ravel()
    return np.bincount(ring, power.ravel())[: size // 2] / np.bincount(ring)[: size // 2]


def slope_of(power: np.ndarray) -> float:
    cycles = np.arange(*BAND)
    return float(np.polyfit(np.log(cycles), np.log(power[cycles]), 1)[0])


def rise_of(power: np.ndarray) -> float:
    """How far the spectrum rises again after it has fallen, between 16 and 128 cycles, in factors of e: sprites of one size, or a grid, would show."""
    smooth = np.convolve(np.log(power[12:132]), np.ones(9) / 9, mode="valid")
    return float((smooth - np.minimum.accumulate(smooth)).max())


def gradients(alpha: np.ndarray) -> np.ndarray:
    dy, dx = np.gradient(alpha)
    return np.hypot(dx, dy)


def densities_of(cli: str, preset: str, first: int, count: int, folder: pathlib.Path, settings: list[str]) -> list[np.ndarray]:
    """The densities of some of its frames, at the size of a flipbook's cell."""
    command = [cli, "render", preset, "--frames", f"{first}-{first + count - 1}", "--size", "256", "--output", str(folder / "step_####.png")]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return [density(Image.open(folder / f"step_{frame:04}.png").convert("RGBA")) for frame in range(first, first + count)]


def spike_of(frames: list[np.ndarray]) -> float:
    """Largest change of density from one frame to the next, beside the mean of the changes before and after it."""
    steps = np.array([np.abs(b - a).mean() for a, b in zip(frames, frames[1:])])
    return float((steps[1:-1] / np.maximum(0.5 * (steps[:-2] + steps[2:]), 1e-9)).max())


def focus_of(cli: str, preset: str, frame: int, folder: pathlib.Path) -> tuple[list[float], list[float]]:
    """Contrast and rims of a frame where the smoke fills the picture, at the size of a sheet's large cell."""
    picture = render(cli, preset, frame, folder / "focus.png", (384, 384), [], ("--fit",))
    pixels = np.asarray(picture, dtype=np.float64) / 255.0
    return contrast(pixels), rims(pixels[..., 3])


def embergen_rows(cli: str, theirs: Image.Image, out: pathlib.Path) -> Image.Image:
    """Their frames above ours, at the size of the sheet, which has a border of two pixels around each frame."""
    sheet = Image.new("RGB", (8 * 128, 2 * 256))
    for i, frame in enumerate(EMBERGEN_FRAMES):
        sheet.paste(theirs.convert("RGB").crop((132 * i + 2, 2, 132 * i + 130, 258)), (128 * i, 0))
        lit = [flat(render(cli, "default", frame, out / "embergen.png", (128, 256), EMBERGEN_LOOK + [light]), EMBERGEN_BACKGROUND) for light in EMBERGEN_LIGHTS]
        sheet.paste(Image.blend(lit[0], lit[1], 0.5), (128 * i, 256))
    return sheet


def sketch_sheet(cli: str, references: pathlib.Path, out: pathlib.Path) -> Image.Image:
    """Each sketch, as wide as it is, above ours."""
    sheet = Image.new("RGB", (2 * EDGE, 2 * EDGE * len(SKETCHES)), BACKGROUND)
    for i, (name, preset, frame) in enumerate(SKETCHES):
        if (references / name).exists():
            theirs = Image.open(references / name).convert("RGB")
            theirs.thumbnail((2 * EDGE, EDGE))
            sheet.paste(theirs, (0, 2 * i * EDGE))
        sheet.paste(flat(render(cli, preset, frame, out / "sketched.png", (EDGE, EDGE), [])), (0, (2 * i + 1) * EDGE))
    return sheet


def contact_sheet(cli: str, preset: str, out: pathlib.Path) -> None:
    """Sixty frames in ten columns."""
    subprocess.run([cli, "flipbook", preset, "--grid", "10x6", "--size", "128", "--output", str(out)], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    flat(Image.open(out).convert("RGBA")).save(out)


def before_and_now(cli: str, older: pathlib.Path, presets: list[str], out: pathlib.Path) -> Image.Image:
    """Two columns of three moments: a preset as it was, and as it is."""
    half = EDGE // 2
    both = [preset for preset in presets if (older / f"{preset}.json").exists()]
    sheet = Image.new("RGB", (6 * half, half * len(both)))
    for y, preset in enumerate(both):
        for side, source in enumerate((str(older / f"{preset}.json"), preset)):
            for x, frame in enumerate((20, 60, 110)):
                sheet.paste(flat(render(cli, source, frame, out / "then.png", (half, half), [])), ((3 * side + x) * half, y * half))
    return sheet


def main() -> None:
    cli, out, references = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    older = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
    out.mkdir(parents=True, exist_ok=True)
    rows: list[list[Image.Image]] = []
    print(f"{'reference':34s} {'slope':>7s} {'ours':>7s} {'apart':>6s} {'rise':>6s} {'ours':>6s} {'steep %':>8s} {'ours %':>7s} {'structure':>10s} {'no air':>7s} {'sprites':>8s} {'dots':>6s} {'ours':>6s}")
    for name, preset, frame, settings in PAIRS + SCENES:
        if not (references / name).exists():
            continue
        theirs = Image.open(references / name).convert("RGBA")
        size = theirs.size  # at which both are measured: made larger, a picture has nothing fine
        ours = render(cli, preset, frame, out / f"ours_{name}", size, settings)
        a, b = density(theirs), density(ours)
        power_a, power_b = spectrum(a), spectrum(b)
        limit = np.percentile(gradients(a), STEEP)
        steep = [100.0 * float((gradients(image) > limit).mean()) for image in (a, b)]
        slopes = slope_of(power_a), slope_of(power_b)
        apart = [structure_between(a, b)]
        for worse in WORSE:
            apart.append(structure_between(a, density(render(cli, preset, frame, out / "worse.png", size, settings + worse))))
        print(f"{name:34s} {slopes[0]:7.2f} {slopes[1]:7.2f} {abs(slopes[0] - slopes[1]):6.2f} {rise_of(power_a):6.2f} {rise_of(power_b):6.2f} {steep[0]:8.3f} {steep[1]:7.3f} "
              f"{apart[0]:10.3f} {apart[1]:7.3f} {apart[2]:8.3f} {dots(a):6.2f} {dots(b):6.2f}")
        rows.append([flat(image).resize((EDGE, EDGE)) for image in (theirs, ours)])
    presets = sorted(path.stem for path in (pathlib.Path(__file__).parents[1] / "presets").glob("*.json"))
    print(f"\n{'preset':18s} {'spike':>6s} {'shimmer':>8s} {'dots':>6s} {'repetition':>11s} {'contrast 1 2 4 px':>20s} {'rims 10 50 90 %':>18s}")
    moments = []
    for preset in presets:
        second = densities_of(cli, preset, 60, 30, out, [])
        print(f"{preset:18s} {spike_of(second):6.2f} {shimmer(second):8.2f} {dots(second[0]):6.2f} {repetition(second[0]):11.2f} ", end="")
        bands, widths = focus_of(cli, preset, 60, out)
        print(" ".join(f"{value:6.3f}" for value in bands), " ".join(f"{value:5.1f}" for value in widths))
        moments.append([flat(render(cli, preset, frame, out / "moment.png", (EDGE // 2, EDGE // 2), [])) for frame in (20, 60, 110)])
    embergen = (references / EMBERGEN).exists()
    sheet = Image.new("RGB", (2 * EDGE, EDGE * (len(rows) + embergen)))
    for y, row in enumerate(rows):
        for x, image in enumerate(row):
            sheet.paste(image, (x * EDGE, y * EDGE))
    if embergen:
        sheet.paste(embergen_rows(cli, Image.open(references / EMBERGEN), out), (0, EDGE * len(rows)))
    sheet.save(out / "references.png")
    half = EDGE // 2
    sheet = Image.new("RGB", (6 * half, half * ((len(moments) + 1) // 2)))
    draw = ImageDraw.Draw(sheet)
    for i, (preset, row) in enumerate(zip(presets, moments)):
        for x, image in enumerate(row):
            sheet.paste(image, ((i % 2 * 3 + x) * half, i // 2 * half))
        draw.text((i % 2 * 3 * half + 6, i // 2 * half + 4), preset, fill=(255, 255, 255))
    sheet.save(out / "presets.png")
    if any((references / name).exists() for name, _, _ in SKETCHES):
        sketch_sheet(cli, references, out).save(out / "sketches.png")
    if older is not None:
        before_and_now(cli, older, presets, out).save(out / "before_and_now.png")
    for preset in presets:
        contact_sheet(cli, preset, out / f"frames_{preset}.png")
    print(f"\n{out / 'references.png'}\n{out / 'presets.png'}")


if __name__ == "__main__":
    main()
