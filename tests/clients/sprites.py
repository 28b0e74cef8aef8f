#!/usr/bin/python3
"""Loads the atlas of `fumage-cli flipbook --for pixi` with Phaser and Babylon.js in headless Chromium and holds their cells against those of the sheet.

usage: sprites.py <fumage-cli> [presets]...
Needs chromium, npm (it fetches phaser and babylonjs), python3-numpy and python3-pil.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from browser import decibels, over_grey, pictures_of

SIZE = 64
GRID = (4, 3)
LEAST = 45.0 # dB; alpha is multiplied in eight bits

PHASER = """<!DOCTYPE html><body><script src="/engine.js"></script><script>
const answer = (what) => fetch("/pictures", { method: "POST", body: JSON.stringify(what) });
class Probe extends Phaser.Scene {
  preload() { this.load.atlas("sheet", "/sheet.png", "/sheet.atlas.json"); }
  create() {
    const names = this.textures.get("sheet").getFrameNames().sort();
    const image = this.add.image(SIZE / 2, SIZE / 2, "sheet");
    const pictures = [];
    const next = (i) => {
      if (i === names.length) return answer(pictures);
      image.setFrame(names[i]);
      this.game.renderer.snapshot((shot) => { pictures.push(shot.src); next(i + 1); });
    };
    next(0);
  }
}
new Phaser.Game({ type: Phaser.WEBGL, width: SIZE, height: SIZE, backgroundColor: "#808080", scene: Probe, banner: false, audio: { noAudio: true } });
</script></body>"""

BABYLON = """<!DOCTYPE html><body><canvas id="canvas" width="SIZE" height="SIZE"></canvas><script src="/engine.js"></script><script type="module">
const answer = (what) => fetch("/pictures", { method: "POST", body: JSON.stringify(what) });
try {
  const canvas = document.getElementById("canvas");
  const engine = new BABYLON.Engine(canvas, false, { preserveDrawingBuffer: true });
  const scene = new BABYLON.Scene(engine);
  scene.clearColor = new BABYLON.Color4(0.5, 0.5, 0.5, 1);
  const camera = new BABYLON.FreeCamera("camera", new BABYLON.Vector3(0, 0, -10), scene);
  camera.mode = BABYLON.Camera.ORTHOGRAPHIC_CAMERA;
  [camera.orthoLeft, camera.orthoRight, camera.orthoBottom, camera.orthoTop] = [-0.5, 0.5, -0.5, 0.5];
  const atlas = await (await fetch("/sheet.atlas.json")).text();
  const manager = new BABYLON.SpritePackedManager("sheet", "/sheet.png", 1, scene, atlas);
  const sprite = new BABYLON.Sprite("smoke", manager);
  sprite.width = sprite.height = 1;
  await scene.whenReadyAsync();
  await new Promise((done) => manager.texture.isReady() ? done() : manager.texture.onLoadObservable.addOnce(done));
  const pictures = [];
  for (const name of Object.keys(JSON.parse(atlas).frames).sort()) {
    sprite.cellRef = name;
    scene.render();
    pictures.push(canvas.toDataURL());
  }
  await answer(pictures);
} catch (error) {
  await answer(String(error));
}
</script></body>"""

ENGINES = {"Phaser": ("phaser@4", "phaser/dist/phaser.min.js", PHASER), "Babylon.js": ("babylonjs@9", "babylonjs/babylon.js", BABYLON)}


def main():
    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        packages = [package for package, _, _ in ENGINES.values()]
        subprocess.run(["npm", "install", "--prefix", name, "--no-audit", "--no-fund", "--ignore-scripts", *packages], check=True, capture_output=True)
        for preset in sys.argv[2:] or ["campfire", "default"]:
            subprocess.run([sys.argv[1], "flipbook", preset, "--for", "pixi", "--size", str(SIZE), "--grid", f"{GRID[0]}x{GRID[1]}", "--set", "output.quality=draft", "--output", folder / "sheet.png"],
                check=True, capture_output=True)
            sheet = over_grey(Image.open(folder / "sheet.png"))
            cells = [sheet[y : y + SIZE, x : x + SIZE] for y in range(0, GRID[1] * SIZE, SIZE) for x in range(0, GRID[0] * SIZE, SIZE)]
            for engine, (_, script, page) in ENGINES.items():
                shown = pictures_of({
                    "/": ("text/html", page.replace("SIZE", str(SIZE)).encode()),
                    "/engine.js": ("text/javascript", (folder / "node_modules" / script).read_bytes()),
                    "/sheet.atlas.json": ("application/json", (folder / "sheet.atlas.json").read_bytes()),
                    "/sheet.png": ("image/png", (folder / "sheet.png").read_bytes()),
                })
                scores = [decibels(picture, cell) for picture, cell in zip(shown, cells)]
                print(f"{preset:16} {engine} shows {len(shown)} of {len(cells)} cells, the worst with {min(scores):.1f} dB", flush=True)
                if len(shown) != len(cells) or min(scores) < LEAST or numpy.ptp(numpy.stack(cells)) < 0.1:
                    failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
