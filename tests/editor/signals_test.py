#!/usr/bin/env python3
"""The editor ends when it is told to, also where a question about a file that it opens stands open.

    signals_test.py <fumage>
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

# An unknown parameter is told of in a box before the window is used.
ODD = {"format": "fumage-preset", "version": 2, "name": "Odd", "scene": {},
       "layers": [{"name": "Smoke", "motion": {"no_such_parameter": 1}}]}
CASES = {"no file": [], "a file": [{**ODD, "layers": [{"name": "Smoke"}]}], "a question": [ODD], "two questions": [ODD, ODD]}


def listens(process, number):
    """Whether a program has a handler of its own for a signal, which is set before files are opened."""
    for line in Path(f"/proc/{process}/status").read_text().split("\n"):
        if line.startswith("SigCgt:"):
            return int(line.split()[1], 16) >> (number - 1) & 1
    return False


def threads(process):
    return len(os.listdir(f"/proc/{process}/task"))


def main():
    program = sys.argv[1]
    for name, files in CASES.items():
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            with tempfile.TemporaryDirectory() as folder:
                paths = []
                for i, preset in enumerate(files):
                    paths.append(Path(folder, f"{i}.json"))
                    paths[-1].write_text(json.dumps(preset))
                environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": folder, "HOME": folder}
                editor = subprocess.Popen([program, *paths], env=environment, stderr=subprocess.DEVNULL)
                while not (listens(editor.pid, number) and threads(editor.pid) > 4):  # a window has threads of its own
                    assert editor.poll() is None, f"{name}: it ended by itself"
                    time.sleep(.05)
                editor.send_signal(number)
                try:
                    code = editor.wait(60)
                except subprocess.TimeoutExpired:
                    editor.kill()
                    sys.exit(f"{name}: {number.name} does not end it")
                if code != 128 + number:
                    sys.exit(f"{name}: {number.name} ends it with {code}")
    print(f"{len(CASES) * 3} editors ended when they were told to")


if __name__ == "__main__":
    main()
