#!/usr/bin/python3
"""Plays a sheet of `fumage-cli flipbook` with three.js in headless Chromium, by what its side-car says, and holds it against the cells and the frames.

usage: three.py <fumage-cli> [presets]...
Needs chromium, npm (it fetches three), python3-numpy and python3-pil. Each cell is shown as sprites usually are, by offset and repeat of the texture; then
the moments between cells by a shader of a few lines, with the formula of Unity and the scale of the side-car: nearer to the frames that are there than a
cross-fade, and farther with the vectors turned round.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from browser import decibels, over_grey, pictures_of

SIZE = 128
GRID = (4, 2)
FIRST = 24
STEP = 4 # frames from cell to cell
BETWEEN = (1, 3, 5) # cells after which a moment in the middle is shown
LEAST = 45.0 # dB of a cell; the canvas has eight bits, premultiplied

PAGE = """<!DOCTYPE html><body><script type="importmap">{"imports": {"three": "/three.module.js"}}</script><script type="module">
import * as THREE from "three";
const answer = (what) => fetch("/pictures", { method: "POST", body: JSON.stringify(what) });
try {
  const book = await (await fetch("/sheet.flipbook.json")).json();
  const vectors = book.pictures.find((picture) => picture.pass === "motion");
  const loader = new THREE.TextureLoader();
  const [sheet, motion] = await Promise.all([book.picture, vectors.file].map((file) => loader.loadAsync("/" + file)));
  sheet.colorSpace = book.colour === "sRGB" ? THREE.SRGBColorSpace : THREE.NoColorSpace;
  sheet.generateMipmaps = motion.generateMipmaps = false;
  sheet.minFilter = sheet.magFilter = THREE.NearestFilter;
  motion.minFilter = THREE.LinearFilter;

  const renderer = new THREE.WebGLRenderer({ alpha: true, preserveDrawingBuffer: true });
  renderer.setSize(book.cell_width, book.cell_height);
  renderer.setClearColor(0x000000, 0);
  const camera = new THREE.OrthographicCamera(-0.5, 0.5, 0.5, -0.5, 0, 2);
  camera.position.z = 1;
  const show = (object) => {
    const scene = new THREE.Scene();
    scene.add(object);
    renderer.render(scene, camera);
    return renderer.domElement.toDataURL();
  };
  const pictures = [];
  sheet.repeat.set(1 / book.columns, 1 / book.rows);
  const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: sheet, transparent: true }));
  for (let cell = 0; cell < book.columns * book.rows; ++cell) {
    sheet.offset.set((cell % book.columns) / book.columns, 1 - (Math.floor(cell / book.columns) + 1) / book.rows);
    pictures.push(show(sprite));
  }
  sheet.minFilter = sheet.magFilter = THREE.LinearFilter;
  sheet.needsUpdate = true;
  const material = new THREE.ShaderMaterial({
    transparent: true,
    premultipliedAlpha: true,
    blending: THREE.CustomBlending, blendSrc: THREE.OneFactor, blendDst: THREE.OneMinusSrcAlphaFactor,
    uniforms: { sheet: { value: sheet }, motion: { value: motion }, grid: { value: new THREE.Vector2(book.columns, book.rows) }, cell: { value: 0 }, scale: { value: 0 } },
    vertexShader: "varying vec2 place; void main() { place = uv; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
    fragmentShader: `
      uniform sampler2D sheet, motion; uniform vec2 grid; uniform float cell, scale; varying vec2 place;
      vec2 corner(float number) { return vec2(mod(number, grid.x), grid.y - 1.0 - floor(number / grid.x)) / grid; }
      vec2 way(float number) { return (texture2D(motion, corner(number) + place / grid).rg * 2.0 - 1.0) * scale / grid; }
      vec4 seen(float number, vec2 off) { vec4 c = texture2D(sheet, corner(number) + place / grid + off); return vec4(c.rgb * c.a, c.a); }
      void main() {
        gl_FragColor = mix(seen(cell, -0.5 * way(cell)), seen(cell + 1.0, 0.5 * way(cell + 1.0)), 0.5);
        gl_FragColor.rgb = gl_FragColor.a > 0.0 ? linearToOutputTexel(vec4(gl_FragColor.rgb / gl_FragColor.a, 1.0)).rgb * gl_FragColor.a : vec3(0.0);
      }`,
  });
  const quad = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), material);
  for (const sign of [0, 1, -1]) {
    for (const cell of BETWEEN) {
      material.uniforms.cell.value = cell;
      material.uniforms.scale.value = sign * vectors.scale;
      pictures.push(show(quad));
    }
  }
  await answer(pictures);
} catch (error) {
  await answer(String(error));
}
</script></body>"""


def fetch_three(folder):
    subprocess.run(["npm", "install", "--prefix", folder, "--no-audit", "--no-fund", "--ignore-scripts", "three@0.180"], check=True, capture_output=True)
    build = pathlib.Path(folder) / "node_modules/three/build"
    return {"/" + name: ("text/javascript", (build / name).read_bytes()) for name in ("three.module.js", "three.core.js")}


def main():
    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        three = fetch_three(name)
        for preset in sys.argv[2:] or ["steam", "cigarette"]:
            last = FIRST + STEP * GRID[0] * GRID[1] - 1
            common = ["--size", str(SIZE), "--set", "timeline.loop=false"]
            subprocess.run([sys.argv[1], "flipbook", preset, *common, "--passes", "colour,motion", "--frames", f"{FIRST}-{last}", "--grid", f"{GRID[0]}x{GRID[1]}", "--output", folder / "sheet.png"],
                check=True, capture_output=True)
            subprocess.run([sys.argv[1], "render", preset, *common, "--frames", f"{FIRST}-{last}", "--output", folder / "true_###.png"], check=True, capture_output=True)
            files = {"/" + file.name: ("image/png", file.read_bytes()) for file in folder.glob("sheet*.png")}
            files["/sheet.flipbook.json"] = ("application/json", (folder / "sheet.flipbook.json").read_bytes())
            shown = pictures_of({"/": ("text/html", PAGE.replace("BETWEEN", json.dumps(BETWEEN)).encode()), **three, **files})
            sheet = over_grey(Image.open(folder / "sheet.png"))
            cells = [sheet[y : y + SIZE, x : x + SIZE] for y in range(0, GRID[1] * SIZE, SIZE) for x in range(0, GRID[0] * SIZE, SIZE)]
            whole = min(decibels(picture, cell) for picture, cell in zip(shown, cells))
            truth = [over_grey(Image.open(folder / f"true_{FIRST + STEP * cell + STEP // 2:03}.png")) for cell in BETWEEN]
            between = [numpy.mean([decibels(picture, true) for picture, true in zip(shown[at : at + len(BETWEEN)], truth)]) for at in range(len(cells), len(shown), len(BETWEEN))]
            faded, moved, wrong = between
            print(f"{preset:16} three.js shows {len(cells)} cells, the worst with {whole:.1f} dB; between: cross-faded {faded:.2f}, along vectors {moved:.2f}, the wrong way {wrong:.2f} dB", flush=True)
            failed = failed or whole < LEAST or not wrong < faded < moved
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
