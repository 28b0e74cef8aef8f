#!/usr/bin/python3
"""Plays the page of `fumage-cli flipbook --for web` in headless Chromium and holds it against frames that are rendered.

usage: web_page.py <fumage-cli> [presets]...
Needs chromium, python3-numpy and python3-pil. A sheet has every fourth frame; the page rebuilds those between, by blending alone and with the
vectors, with the signs of Unity, of Unreal and wrong ones. Fails where vectors are worse than blending or wrong ones better, where Unity's and
Unreal's differ in what is seen, or where a cell that is shown as it is differs from the picture.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

from browser import decibels, over_grey, pictures_of
from layered import sheets_in

SIZE = 128
CELLS = 8
FIRST = 24
STEP = 4 # of the frames in the sheet; those between are rebuilt
SHOWN = (1.5, 3.5, 5.5)
# What Chromium adds: it stores eight bits, premultiplied, and takes them apart again.
LEAST_OF_A_CELL = 40.0
LEAST_OF_LAYERS = 45.0


PROBE = """<script>
(async () => {
  const frame = () => new Promise(requestAnimationFrame);
  while (!document.body.dataset.ready) await frame();
  playing = false;
  // An opaque canvas is read as it is: of others Chromium divides eight bits by their alpha.
  if (BEHIND !== null) gl.clearColor = () => WebGLRenderingContext.prototype.clearColor.call(gl, BEHIND, BEHIND, BEHIND, 1);
  const scale = sheet.motionScale;
  const pictures = [];
  for (const shot of SHOTS) {
    place = shot.place;
    byId("blend").checked = shot.blend;
    if (byId("vectors")) byId("vectors").checked = shot.vectors !== 0;
    sheet.motionScale = scale * (shot.vectors < 0 ? -1 : 1);
    await frame();
    await frame();
    pictures.push(canvas.toDataURL());
  }
  await fetch("/pictures", { method: "POST", body: JSON.stringify(pictures) });
})();
</script></body>"""


def shown(page, shots, behind=None):
    """The canvas of a page at places of its sheet: (place, whether cells are blended, whether along vectors: 0, 1, or -1 for the wrong way). behind: a grey; none: it is transparent."""
    wanted = json.dumps([{"place": place, "blend": blend, "vectors": vectors} for place, blend, vectors in shots])
    text = page.read_text(encoding="utf-8").replace("</body>", PROBE.replace("SHOTS", wanted).replace("BEHIND", json.dumps(behind)))
    return pictures_of({"/": ("text/html", text.encode())})


def layers_make_the_picture(cli):
    """Three sheets drawn over one another, against the sheet of all."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        cells = sheets_in(folder, cli, "web", SIZE, 3)
        scores = []
        for behind in (0.0, 0.5):
            pictures = shown(folder / "stack.html", [(float(cell), False, 0) for cell in (2, 5, 8)], behind)
            wanted = [cells[cell][..., :3] + behind * (1.0 - cells[cell][..., 3:]) for cell in (2, 5, 8)]
            scores += [decibels(picture, true) for picture, true in zip(pictures, wanted)]
    print(f"three layers over one another: {', '.join(f'{score:.1f}' for score in scores)} dB", flush=True)
    return min(scores) >= LEAST_OF_LAYERS


def main():
    cli = sys.argv[1]
    failed = not layers_make_the_picture(cli)
    for preset in sys.argv[2:] or ["default", "explosion", "chimney"]:
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            last = FIRST + STEP * CELLS - 1
            common = ["--size", str(SIZE), "--set", "timeline.loop=false"]
            subprocess.run([cli, "render", preset, *common, "--frames", f"{FIRST}-{last}", "--output", str(folder / "true_###.png")], check=True, capture_output=True)
            for signs in ("unity", "unreal"):
                subprocess.run([cli, "flipbook", preset, *common, "--for", "web", "--vectors", signs, "--frames", f"{FIRST}-{last}", "--grid", f"{CELLS}x1", "--output", str(folder / f"{signs}.png")],
                    check=True, capture_output=True)
            pages = {signs: folder / f"{signs}.html" for signs in ("unity", "unreal")}
            truth = lambda frame: over_grey(Image.open(folder / f"true_{frame:03}.png"))
            wanted = [truth(FIRST + int(STEP * place)) for place in SHOWN]
            cell, *between = shown(pages["unity"], [(2.0, False, 0), *[(place, True, way) for way in (0, 1, -1) for place in SHOWN]])
            whole = decibels(cell, truth(FIRST + 2 * STEP))
            blended, moved, wrong = ([decibels(picture, true) for picture, true in zip(between[i : i + len(SHOWN)], wanted)] for i in range(0, len(between), len(SHOWN)))
            other = decibels(shown(pages["unreal"], [(SHOWN[-1], True, 1)])[0], wanted[-1])
            print(f"{preset:16} a cell {whole:5.1f} dB; between: blended {numpy.mean(blended):5.2f}, along vectors {numpy.mean(moved):5.2f}, the wrong way {numpy.mean(wrong):5.2f} dB;"
                f" the last with Unity's signs {moved[-1]:5.2f}, with Unreal's {other:5.2f}", flush=True)
            if whole < LEAST_OF_A_CELL or not numpy.mean(wrong) < numpy.mean(blended) < numpy.mean(moved) or abs(other - moved[-1]) > 0.05:
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
