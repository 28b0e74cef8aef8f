"""A page in headless Chromium, and the pictures that it sends back. Needs chromium and python3-pil."""
import base64
import http.server
import io
import json
import queue
import subprocess
import sys
import tempfile
import threading

import numpy
from PIL import Image


def decibels(a, b):
    error = numpy.mean((a - b) ** 2)
    return 99.0 if error == 0 else -10.0 * numpy.log10(error)


def over_grey(image):
    pixels = numpy.asarray(image.convert("RGBA"), dtype=numpy.float64) / 255.0
    return pixels[..., :3] * pixels[..., 3:] + 0.5 * (1.0 - pixels[..., 3:])


class Listener(http.server.BaseHTTPRequestHandler):
    """Gives out files, and takes what the page sends back."""

    def do_GET(self):
        kind, contents = self.server.files.get(self.path, ("text/plain", None))
        self.send_response(404 if contents is None else 200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(contents or b"")))
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.end_headers()
        self.wfile.write(contents or b"")

    def do_POST(self):
        self.server.answers.put(json.loads(self.rfile.read(int(self.headers["Content-Length"]))))
        self.send_response(204)
        self.end_headers()

    def log_message(self, *_):
        pass


def answer_of(files):
    """What a page sends to /pictures.

    files: {path: (type, bytes)}; the page is at /. Pages are isolated from others, as engines with threads ask for.
    """
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Listener)
    server.files = files
    server.answers = queue.Queue()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = ["chromium", "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--user-data-dir={profile}", f"http://127.0.0.1:{server.server_port}/"]
        browser = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            return server.answers.get(timeout=240)
        except queue.Empty:
            sys.exit("the page showed nothing within four minutes")
        finally:
            browser.terminate()
            browser.wait()
            server.shutdown()


def picture_of(address):
    """Red, green and blue of a data URL, over grey where it is transparent."""
    return over_grey(Image.open(io.BytesIO(base64.b64decode(address.split(",")[1]))))


def pictures_of(files):
    """What a page sends to /pictures: data URLs of its canvas, or a text that says what went wrong."""
    pictures = answer_of(files)
    if isinstance(pictures, str):
        sys.exit(f"the page says: {pictures}")
    return [picture_of(picture) for picture in pictures]
