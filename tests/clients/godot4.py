#!/usr/bin/python3
"""Plays what `fumage-cli flipbook --for godot` writes in Godot 4's own engine (its web build), after reading it by Godot's grammar.

usage: godot4.py <fumage-cli>
Needs chromium, npm, python3-numpy and python3-pil; with glslang-tools the shader goes through a compiler of Khronos, too. The scene: headings, resources
that are declared before they are used and once, as many steps as the heading says, values that are Godot's literals, parameters that the shader has, files
that are there. The engine: the shader compiles without a word, between cells it shows what the formula says, light comes from where it stands, fire has the
colours of the emission pass, and cold smoke does not glow.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from browser import decibels
from godot4_engine import Godot
from layered import sheets_in

SIZE = 96
GRID = 3
LEAST_BETWEEN = 45.0 # dB, eight bits of sRGB
LEAST_LIT = 35.0
LEAST_GLOWING = 32.0

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
TEXT = r'&?"(?:[^"\\]|\\.)*"' # over several lines, too
TYPES = {"Vector2", "Vector3", "Vector4", "Color", "AABB", "Transform3D", "PackedFloat32Array", "PackedColorArray", "NodePath", "ExtResource", "SubResource"}
TOKEN = re.compile(rf'\s*(?:({NUMBER}|true|false|null|{TEXT})|([A-Za-z]\w*)\(|([\[\]{{}}(),:]))', re.DOTALL)
HEADING = re.compile(r'\[(\w+)((?: \w+=(?:"(?:[^"\\]|\\.)*"|\w+|ExtResource\("[^"]*"\)))*)\]')
ATTRIBUTE = re.compile(r'(\w+)=("(?:[^"\\]|\\.)*"|\w+)')
HINTS = {"source_color", "filter_linear_mipmap", "filter_linear", "repeat_disable", "hint_range"}
MODES = {"blend_mix", "blend_premul_alpha", "depth_draw_never", "cull_disabled", "unshaded", "specular_disabled", "ambient_light_disabled"}

# Of spatial shaders, from the manual's tables; what may be written has no const.
GLOBAL = "const float TIME = 0.0; const float PI = 3.14159265; const float TAU = 6.2831853;"
BUILT_INS = {
    "vertex": "mat4 MODELVIEW_MATRIX; mat3 MODELVIEW_NORMAL_MATRIX; vec3 VERTEX; vec3 NORMAL; vec2 UV; vec4 COLOR; uniform mat4 MODEL_MATRIX, VIEW_MATRIX, INV_VIEW_MATRIX, PROJECTION_MATRIX; uniform vec4 INSTANCE_CUSTOM;",
    "fragment": "uniform vec2 UV_; vec2 UV; vec4 COLOR; vec3 ALBEDO; float ALPHA; vec3 EMISSION; vec3 NORMAL;",
    "light": "uniform vec3 LIGHT, LIGHT_COLOR, NORMAL, VIEW, ALBEDO; uniform float ATTENUATION; vec3 DIFFUSE_LIGHT; vec3 SPECULAR_LIGHT;",
}


def value_at(text, at):
    """Where a value of Godot's text format ends: a number, a text, a list, a dictionary, or a type with its parts. Nothing: there is none."""
    token = TOKEN.match(text, at)
    if not token:
        return None
    if token[1]:
        return token.end()
    close = {"[": "]", "{": "}"}.get(token[3]) or (")" if token[2] in TYPES else None)
    at = token.end()
    while close:
        token = TOKEN.match(text, at)
        if token and token[3] == close:
            return token.end()
        at = value_at(text, at)
        if close == "}" and at:
            colon = TOKEN.match(text, at)
            at = value_at(text, colon.end()) if colon and colon[3] == ":" else None
        token = TOKEN.match(text, at) if at else None
        if not token or token[3] not in (",", close):
            return None
        at = token.end() if token[3] == "," else at
    return None


def lines_of(text):
    """Lines, of which a value that goes over several is one, with their numbers."""
    at = 0
    while at < len(text):
        end = text.index("\n", at)
        equals = text.find(" = ", at, end)
        value = value_at(text, equals + 3) if equals >= 0 and text[at] != "[" else None
        end = max(end, value or end)
        yield text.count("\n", 0, at) + 1, text[at:end]
        at = end + 1


def check_scene(text, folder, uniforms):
    declared, needed, steps = {}, None, 0
    section = None
    for number, line in lines_of(text):
        where = f"line {number}: {line}"
        if not line.strip():
            continue
        heading = HEADING.fullmatch(line)
        if heading:
            section = heading[1]
            attributes = dict(ATTRIBUTE.findall(heading[2]))
            if section == "gd_scene":
                assert number == 1 and attributes["format"] == "3", where
                needed = int(attributes["load_steps"])
            elif section in ("ext_resource", "sub_resource"):
                key = ("Ext" if section == "ext_resource" else "Sub", attributes["id"].strip('"'))
                assert key not in declared, where
                declared[key] = attributes["type"]
                steps += 1
                if section == "ext_resource":
                    assert (folder / attributes["path"].strip('"').removeprefix("res://")).exists(), where
            else:
                assert section == "node" and ("parent" in attributes) == (" parent=" in line), where
            continue
        name, equals, value = line.partition(" = ")
        assert equals and section in ("sub_resource", "node") and re.fullmatch(r"[\w/]+", name), where
        assert value_at(value, 0) == len(value), where
        for kind, key in re.findall(r'(Ext|Sub)Resource\("([^"]*)"\)', value):
            assert (kind, key) in declared, where
        if name.startswith("shader_parameter/"):
            assert name.split("/")[1] in uniforms, where
    assert needed == steps + 1, (needed, steps) # and the scene itself
    return len(declared)


def as_glsl(text, stage):
    """What is left for a function of the shader, as a fragment shader of GLSL ES."""
    assert re.search(r"^shader_type spatial;$", text, re.MULTILINE)
    modes = re.search(r"^render_mode ([^;]*);$", text, re.MULTILINE)[1].split(", ")
    assert set(modes) <= MODES, modes
    text = re.sub(r"^(shader_type|render_mode) .*$", "", text, flags=re.MULTILINE)

    def without_hints(found):
        hints = set(re.split(r",\s*", found[2].strip()))
        assert hints <= HINTS, hints
        return found[1]

    text = re.sub(r"(uniform \w+ \w+)\s*:\s*([^;=]*)", without_hints, text)
    text = re.sub(r"(uniform \w+ \w+)\s*=[^;]*;", r"\1;", text) # GLSL ES has no values of uniforms
    text = text.replace("varying ", "") # which Godot's functions both write and read
    for other in BUILT_INS:
        if other != stage:
            text = re.sub(rf"^void {other}\(\) \{{.*?^\}}", "", text, flags=re.MULTILINE | re.DOTALL)
    return f"#version 300 es\nprecision highp float;\n{GLOBAL}\n{BUILT_INS[stage]}\nout vec4 result;\n{text}\nvoid main() {{ {stage}(); result = vec4(0.0); }}\n"


def read_by_grammar(cli, passes, preset="thesis-2012", markers=()):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([cli, "--quiet", "flipbook", preset, "--for", "godot", "--passes", ",".join(passes), "--size", "32", "--grid", "2x2", "--set", "output.quality=draft",
            *(word for i, name in enumerate(markers) for word in ("--marker", f"{name}={0.1 * i + 0.1:.1f}")), "--output", folder / "smoke's_2x2.png"], check=True)
        shader = next(folder.glob("*.gdshader")).read_text()
        uniforms = set(re.findall(r"^uniform \w+ (\w+)", shader, re.MULTILINE))
        scene = next(folder.glob("*.tscn")).read_text()
        resources = check_scene(scene, folder, uniforms)
        called = [json.loads(name) for name in re.findall(r'"args": \[("(?:[^"\\]|\\.)*")\]', scene)]
        assert called == list(markers), called
        stages = [stage for stage in BUILT_INS if f"void {stage}()" in shader]
        for stage in stages if shutil.which("glslangValidator") else []:
            file = folder / f"{stage}.frag"
            file.write_text(as_glsl(shader, stage))
            compiled = subprocess.run(["glslangValidator", "-S", "frag", file], capture_output=True, text=True)
            assert compiled.returncode == 0, compiled.stdout
        print(f"{preset}, {'+'.join(passes)}: a scene of {resources} resources; {', '.join(stages)}", flush=True)


def linear_of(stored):
    return numpy.where(stored <= 0.04045, stored / 12.92, ((stored + 0.055) / 1.055) ** 2.4)


def stored_of(linear):
    linear = numpy.clip(linear, 0.0, 1.0)
    return numpy.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055)


class Sheet:
    """A flipbook for Godot, and its pictures as cells of numbers."""

    def __init__(self, cli, folder, preset, passes, *settings):
        self.folder = pathlib.Path(folder) / f"{preset}-{'-'.join(passes)}"
        self.folder.mkdir()
        subprocess.run([cli, "--quiet", "flipbook", preset, "--for", "godot", "--passes", ",".join(passes), "--size", str(SIZE), "--grid", str(GRID), "--set", "output.quality=draft", *settings,
            "--output", self.folder / "sheet.png"], check=True)
        self.facts = json.loads((self.folder / "sheet.flipbook.json").read_text())
        self.passes = {picture["pass"]: picture for picture in self.facts["pictures"]}
        self.shader = (self.folder / "sheet.gdshader").read_text()

    def cells(self, name):
        pixels = numpy.asarray(Image.open(self.folder / self.passes[name]["file"]), dtype=numpy.float64) / 255.0
        return [pixels[y : y + SIZE, x : x + SIZE] for y in range(0, GRID * SIZE, SIZE) for x in range(0, GRID * SIZE, SIZE)]

    def shot(self, cell, **more):
        return {"scene": "res://sheet.tscn", "size": SIZE, "place": (cell + 1e-4) / (GRID * GRID), **more}


def fetch(cell, x, y):
    """Bilinear, at the middle of pixels; beyond the outermost it is theirs."""
    x, y = numpy.clip(x, 0, SIZE - 1), numpy.clip(y, 0, SIZE - 1)
    left, top = x.astype(int), y.astype(int)
    right, bottom = numpy.minimum(left + 1, SIZE - 1), numpy.minimum(top + 1, SIZE - 1)
    across, down = (x - left)[..., None], (y - top)[..., None]
    return (cell[top, left] * (1 - across) + cell[top, right] * across) * (1 - down) + (cell[bottom, left] * (1 - across) + cell[bottom, right] * across) * down


def between(cells, vectors, place, way):
    """Over black between two cells, as the Compatibility renderer blends: what is stored, not light. way: 1 along the vectors, 0 blended alone, -1 the wrong way."""
    now, share = int(place), place - int(place)
    y, x = numpy.mgrid[0:SIZE, 0:SIZE].astype(float)
    seen = []
    for cell, step in ((now, -share), (now + 1, 1 - share)):
        moved = fetch(cells[cell], x + way * vectors[cell][..., 0] * step * SIZE, y - way * vectors[cell][..., 1] * step * SIZE)
        seen.append(numpy.concatenate([moved[..., :3] * moved[..., 3:], moved[..., 3:]], axis=-1))
    mixed = seen[0] * (1 - share) + seen[1] * share
    return stored_of(mixed[..., :3] / numpy.maximum(mixed[..., 3:], 1e-4)) * mixed[..., 3:]


def check_blending(godot, cli, folder, preset):
    sheet = Sheet(cli, folder, preset, ["colour", "motion"], "--set", "timeline.loop=false")
    cells = [numpy.concatenate([linear_of(cell[..., :3]), cell[..., 3:]], axis=-1) for cell in sheet.cells("colour")]
    vectors = [(cell[..., :2] * 2 - 1) * sheet.passes["motion"]["scale"] for cell in sheet.cells("motion")]
    places = [2.0, 3.25, 4.5, 5.75]
    *shown, playing = godot.show(sheet.folder, [sheet.shot(place) for place in places] + [sheet.shot(0, particles=True)])
    scores = {way: [decibels(picture, between(cells, vectors, place + 1e-4, way)) for picture, place in zip(shown, places)] for way in (1, 0, -1)}
    print(f"{preset}: Godot shows the formula with {min(scores[1]):.1f} dB or more; blended alone {numpy.mean(scores[0][1:]):.1f}, the wrong way {numpy.mean(scores[-1][1:]):.1f}; "
        f"its particles are as bright as {playing.max():.2f}", flush=True)
    return min(scores[1]) > LEAST_BETWEEN and all(scores[1][i] > scores[0][i] > scores[-1][i] for i in (1, 2, 3)) and playing.max() > 0.05


def check_light(godot, cli, folder, preset):
    sheet = Sheet(cli, folder, preset, ["colour", "six-way"], "--set", "glow.emission=0", "--set", "timeline.loop=false")
    a, b = sheet.cells("six-way-a")[4], sheet.cells("six-way-b")[4]
    light, alpha = sheet.passes["six-way-a"]["scale"], sheet.cells("colour")[4][..., 3:]
    ways = {"right": ([1, 0, 0], a, 0), "left": ([-1, 0, 0], b, 0), "top": ([0, 1, 0], a, 1), "bottom": ([0, -1, 0], b, 1), "back": ([0, 0, -1], a, 2), "front": ([0, 0, 1], b, 2)}
    wanted = {way: numpy.repeat(stored_of(cells[..., channel, None] * light) * alpha, 3, axis=-1) for way, (_, cells, channel) in ways.items()}
    black = {"ambient": [0, 0, 0]}
    *shown, dark = godot.show(sheet.folder, [sheet.shot(4, light=to, set=black) for to, _, _ in ways.values()] + [sheet.shot(4, set=black)])
    scores = {way: {other: decibels(picture, wanted[other]) for other in ways} for way, picture in zip(ways, shown)}
    print(f"{preset}, light from {', '.join(f'{way} {scores[way][way]:.1f}' for way in ways)} dB; in the dark it is {dark.max():.3f}", flush=True)
    good = all(scores[way][way] > LEAST_LIT and max(scores[way], key=scores[way].get) == way for way in ways)
    return good and dark.max() == 0.0 and "glow" not in sheet.shader


def check_glow(godot, cli, folder, preset):
    sheet = Sheet(cli, folder, preset, ["colour", "six-way", "emission"], "--set", "timeline.loop=false")
    alpha = sheet.cells("colour")[4][..., 3:]
    glow = sheet.cells("emission")[4][..., :3] * sheet.passes["emission"]["scale"]
    most = (glow * (alpha > 0.1)).max()
    scale = sheet.passes["six-way-b"]["emissive"]["scale"]
    shown = godot.show(sheet.folder, [sheet.shot(4, set={"ambient": [0, 0, 0], "glow_scale": scale / most})])[0]
    wanted = stored_of(glow / most) * alpha
    score = decibels(shown, wanted)
    hues = [linear_of(picture).sum(axis=(0, 1)) for picture in (shown, wanted)]
    hues = [numpy.round(hue / hue.max(), 3) for hue in hues]
    print(f"{preset}: glows as its emission pass with {score:.1f} dB; hue {hues[0]}, of the pass {hues[1]}; the brightest is {most:.2f}", flush=True)
    return score > LEAST_GLOWING and numpy.abs(hues[0] - hues[1]).max() < 0.05


def check_layers(godot, cli, folder):
    """Three sheets drawn over one another, against the sheet of all; Compatibility blends what is stored."""
    folder = pathlib.Path(folder) / "layers"
    folder.mkdir()
    cells = sheets_in(folder, cli, "godot", SIZE, GRID, "--blending", "encoded")
    shader = (folder / "stack.gdshader").read_text()
    check_scene((folder / "stack.tscn").read_text(), folder, set(re.findall(r"^uniform \w+ (\w+)", shader, re.MULTILINE)))
    as_glsl(shader, "fragment")
    places = (2, 5, 7)
    shown = godot.show(folder, [{"scene": "res://stack.tscn", "size": SIZE, "place": (place + 1e-4) / (GRID * GRID)} for place in places])
    scores = [decibels(picture, cells[place][..., :3]) for picture, place in zip(shown, places)]
    print(f"three layers over one another: {', '.join(f'{score:.1f}' for score in scores)} dB", flush=True)
    return min(scores) > LEAST_BETWEEN


def main():
    cli = pathlib.Path(sys.argv[1]).resolve()
    for passes in (["colour"], ["colour", "motion"], ["colour", "motion", "six-way"]):
        read_by_grammar(cli, passes)
    read_by_grammar(cli, ["colour", "six-way"], "campfire")
    read_by_grammar(cli, ["colour"], markers=['Boom "q" \\ é', "{{x}}: [}", "&a"])
    with tempfile.TemporaryDirectory() as name:
        godot = Godot(name)
        good = [check_layers(godot, cli, name), check_blending(godot, cli, name, "explosion"), check_light(godot, cli, name, "steam"), check_glow(godot, cli, name, "campfire"), check_glow(godot, cli, name, "magic")]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
