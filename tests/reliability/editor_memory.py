#!/usr/bin/env python3
"""Measures what the editor takes while a restless hand works with the default smoke: editor_memory.py BUILD_FOLDER [SECONDS]

Needs a screen (tests/editor/on_screen.sh gives one) and xdotool. Drags sliders, turns the camera, throws dice, undoes, plays and scrubs; looks at the
resident memory of the process each second. Then the hand rests, and begins a new document. Fails where the editor took more than README says, or where
a new document gives nothing back. The figures are printed.
"""

import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

from built_programs import built_programs

MOST_MB = 1200  # as README.md says


def xdo(*words):
    return subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True, check=False).stdout


def resident(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1]) // 1024
    return 0


class Hand:
    """Gestures in a window that fills a screen of 1920 x 1080."""

    KEYS = ("ctrl+shift+r", "ctrl+z", "ctrl+z", "ctrl+shift+z", "space", "f", "1", "3", "Right", "Left", "s", "ctrl+b", "t")

    def __init__(self, window):
        self.window = window
        xdo("windowsize", "--sync", window, 1900, 1040, "windowmove", window, 0, 20)

    def drag(self, button, start, end):
        xdo("mousemove", *start, "mousedown", button)
        for step in range(1, 7):
            xdo("mousemove", *(round(a + (b - a) * step / 6) for a, b in zip(start, end)))
        xdo("mouseup", button)

    def gesture(self):
        kind = random.choice(("slider", "slider", "camera", "key", "key", "wheel"))
        if kind == "slider":
            row = random.randint(160, 900)
            self.drag(1, (random.randint(1680, 1780), row), (random.randint(1680, 1880), row))
        elif kind == "camera":
            self.drag(2, (900, 400), (random.randint(700, 1100), random.randint(300, 500)))
        elif kind == "wheel":
            xdo("mousemove", 900, 400, "click", random.choice((4, 5)))
        else:
            xdo("mousemove", 900, 300, "key", random.choice(self.KEYS))


def start(editor, home):
    settings = home / "config/fumage/fumage.ini"
    settings.parent.mkdir(parents=True)
    settings.write_text("[start]\nshown=false\n")
    rooms = {f"XDG_{name.upper()}_HOME": str(home / name) for name in ("config", "data", "cache")}
    return subprocess.Popen([editor], env={**os.environ, **rooms, "HOME": str(home), "QT_QPA_PLATFORM": "xcb"})


def window_of(program):
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if found := xdo("search", "--onlyvisible", "--pid", program.pid, "--name", "Fumage").split():
            return found[0]
        time.sleep(0.1)
    sys.exit("the editor opened no window")


def main():
    (editor,) = built_programs(sys.argv[1], "bin/fumage")
    seconds = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    seed = int(time.time())
    random.seed(seed)
    print(f"seed {seed}")
    home = pathlib.Path(tempfile.mkdtemp())
    program = start(editor, home)
    hand = Hand(window_of(program))
    time.sleep(5)
    first = most = resident(program.pid)
    begin = time.monotonic()
    told = 0
    while program.poll() is None and time.monotonic() - begin < seconds:
        hand.gesture()
        most = max(most, resident(program.pid))
        if int(time.monotonic() - begin) // 30 > told:
            told = int(time.monotonic() - begin) // 30
            print(f"{30 * told} s: {resident(program.pid)} MB", flush=True)
    if program.poll() is not None:
        sys.exit(f"the editor ended with {program.returncode}")
    time.sleep(8)
    rested = resident(program.pid)
    xdo("key", "ctrl+n")
    time.sleep(2)
    xdo("key", "Tab", "space")  # "Unsaved changes": Discard
    time.sleep(10)
    new = resident(program.pid)
    program.kill()
    program.wait()
    shutil.rmtree(home, ignore_errors=True)
    print(f"at first {first} MB, at most {most} MB, at rest {rested} MB, with a new document {new} MB")
    sys.exit(1 if most > MOST_MB or new > rested + 100 else 0)


if __name__ == "__main__":
    main()
