#!/usr/bin/python3
"""Loads the atlas of `fumage-cli flipbook --for pixi` with PixiJS in headless Chromium and holds its animation against the cells of the sheet.

usage: pixi.py <fumage-cli> [presets]...
Needs chromium, npm (it fetches pixi.js), python3-numpy and python3-pil.
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
LEAST = 45.0 # dB; PixiJS multiplies by alpha in eight bits

PAGE = """<!DOCTYPE html><body><script type="module">
import { Application, Assets, AnimatedSprite } from "/pixi.mjs";
const answer = (what) => fetch("/pictures", { method: "POST", body: JSON.stringify(what) });
try {
  const app = new Application();
  await app.init({ width: SIZE, height: SIZE, background: "#808080", preference: "webgl", preserveDrawingBuffer: true, autoStart: false });
  const sheet = await Assets.load("/sheet.atlas.json");
  const sprite = new AnimatedSprite(sheet.animations.sheet);
  app.stage.addChild(sprite);
  const pictures = [];
  for (let i = 0; i < sprite.totalFrames; ++i) {
    sprite.gotoAndStop(i);
    app.render();
    pictures.push(app.canvas.toDataURL());
  }
  await answer(pictures);
} catch (error) {
  await answer(String(error));
}
</script></body>"""


def main():
    failed = False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run(["npm", "install", "--prefix", name, "--no-audit", "--no-fund", "--ignore-scripts", "pixi.js@8"], check=True, capture_output=True)
        pixi = (folder / "node_modules/pixi.js/dist/pixi.min.mjs").read_bytes()
        for preset in sys.argv[2:] or ["campfire", "default"]:
            subprocess.run([sys.argv[1], "flipbook", preset, "--for", "pixi", "--size", str(SIZE), "--grid", f"{GRID[0]}x{GRID[1]}", "--output", folder / "sheet.png"], check=True, capture_output=True)
            shown = pictures_of({
                "/": ("text/html", PAGE.replace("SIZE", str(SIZE)).encode()),
                "/pixi.mjs": ("text/javascript", pixi),
                "/sheet.atlas.json": ("application/json", (folder / "sheet.atlas.json").read_bytes()),
                "/sheet.png": ("image/png", (folder / "sheet.png").read_bytes()),
            })
            sheet = over_grey(Image.open(folder / "sheet.png"))
            cells = [sheet[y : y + SIZE, x : x + SIZE] for y in range(0, GRID[1] * SIZE, SIZE) for x in range(0, GRID[0] * SIZE, SIZE)]
            scores = [decibels(picture, cell) for picture, cell in zip(shown, cells)]
            print(f"{preset:16} PixiJS shows {len(shown)} of {len(cells)} cells, the worst with {min(scores):.1f} dB", flush=True)
            if len(shown) != len(cells) or min(scores) < LEAST or numpy.ptp(numpy.stack(cells)) < 0.1:
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
