#!/usr/bin/python3
"""Plays the page of `fumage-cli flipbook --for web` in headless Chromium and holds it against frames that are rendered.

usage: web_page.py <fumage-cli> [presets]...
Needs chromium, python3-numpy and python3-pil. A sheet has every fourth frame; the page rebuilds those between, by blending alone and with the
vectors, with the signs of Unity, of Unreal and wrong ones. Fails where vectors are worse than blending or wrong ones better, where Unity's and
Unreal's differ in what is seen, or where a cell that is shown as it is differs from the picture.
"""
import base64
import http.server
import io
import json
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading

import numpy
from PIL import Image

SIZE = 128
CELLS = 8
FIRST = 24
STEP = 4 # of the frames in the sheet; those between are rebuilt
SHOWN = (1.5, 3.5, 5.5)
# What Chromium adds: it stores eight bits, premultiplied, and takes them apart again.
LEAST_OF_A_CELL = 40.0


def decibels(a, b):
    error = numpy.mean((a - b) ** 2)
    return 99.0 if error == 0 else -10.0 * numpy.log10(error)


def over_grey(image):
    pixels = numpy.asarray(image.convert("RGBA"), dtype=numpy.float64) / 255.0
    return pixels[..., :3] * pixels[..., 3:] + 0.5 * (1.0 - pixels[..., 3:])


PROBE = """<script>
(async () => {
  const frame = () => new Promise(requestAnimationFrame);
  while (!document.body.dataset.ready) await frame();
  playing = false;
  const scale = sheet.motionScale;
  const pictures = [];
  for (const shot of SHOTS) {
    place = shot.place;
    byId("blend").checked = shot.blend;
    byId("vectors").checked = shot.vectors !== 0;
    sheet.motionScale = scale * (shot.vectors < 0 ? -1 : 1);
    await frame();
    await frame();
    pictures.push(canvas.toDataURL());
  }
  await fetch("/pictures", { method: "POST", body: JSON.stringify(pictures) });
})();
</script></body>"""


class Listener(http.server.BaseHTTPRequestHandler):
    """Gives out one page, and takes what it sends back."""

    def do_GET(self):
        page = self.server.page if self.path == "/" else b""
        self.send_response(200 if page else 404)
        self.send_header("Content-Length", str(len(page)))
        self.end_headers()
        self.wfile.write(page)

    def do_POST(self):
        self.server.answers.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


def shown(page, shots):
    """The canvas of a page at places of its sheet: (place, whether cells are blended, whether along vectors: 0, 1, or -1 for the wrong way)."""
    wanted = json.dumps([{"place": place, "blend": blend, "vectors": vectors} for place, blend, vectors in shots])
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Listener)
    server.page = page.read_text(encoding="utf-8").replace("</body>", PROBE.replace("SHOTS", wanted)).encode()
    server.answers = queue.Queue()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = ["chromium", "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"]
        browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            pictures = server.answers.get(timeout=120)
        except queue.Empty:
            sys.exit(f"{page.name} showed nothing within two minutes")
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()
    return [over_grey(Image.open(io.BytesIO(base64.b64decode(picture.split(",")[1])))) for picture in pictures]


def main():
    cli = sys.argv[1]
    failed = False
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
