#!/usr/bin/env python3
"""Kills the editor twice, over and over, and looks whether unsaved work is still there: kill_editor.py BUILD_FOLDER [ROUNDS]

`./dev test-kill` gives it what it needs: the programs, a screen (tests/editor/on_screen.sh) and xdotool. Each round
opens a document that has a file, changes it, kills the editor at a moment of chance after its copy is on the disk,
starts it again, kills it 0 to 3 seconds later, and starts it a third time: the work must be in the window then. The
folder of copies is looked at all the while: a whole copy of the work must be in it at every moment.
"""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time

from built_programs import built_programs

PATIENCE = 60.0  # seconds that a window or a copy may take; those in which the editor waits for a core do not count
LOOK = 0.004  # seconds between two looks at the folder
SMALL = {"emitter": {"count": 400}, "noise": {"slices": 2, "resolution": 16}, "air": {"enabled": False}, "light": {"resolution": 16}}


class Home:
    """A user of the editor, with one document."""

    def __init__(self, programs, place):
        self.editor, cli = programs
        self.place = place
        self.copies = place / "data/fumage/recovery"
        self.document = place / "mine.json"
        show = subprocess.run([cli, "presets", "--show", "thesis-2012"], capture_output=True, check=True)
        preset = json.loads(show.stdout)
        for group, values in SMALL.items():
            (preset["scene"] if group in preset["scene"] else preset["layers"][0])[group].update(values)
        self.document.write_text(json.dumps(preset))
        settings = place / "config/fumage/fumage.ini"
        settings.parent.mkdir(parents=True)
        settings.write_text("[start]\nshown=false\n")

    def start(self, *files):
        rooms = {f"XDG_{name.upper()}_HOME": str(self.place / name) for name in ("config", "data", "cache")}
        environment = {**os.environ, **rooms, "HOME": str(self.place), "FUMAGE_OPENGL": "none", "QT_QPA_PLATFORM": "xcb"}
        return subprocess.Popen([self.editor, *map(str, files)], env=environment, stderr=subprocess.DEVNULL)

    def copy(self):
        """The unsaved work on the disk; None where there is no whole copy of it."""
        for path in self.copies.glob("*.json"):
            try:
                return json.loads(path.read_text())
            except (OSError, ValueError):
                continue  # it has just been replaced, or is broken: the next look tells
        return None


class Guard(threading.Thread):
    """Looks at the folder all the while."""

    def __init__(self, home):
        super().__init__(daemon=True)
        self.home = home
        self.gaps = 0
        self.stopped = threading.Event()

    def run(self):
        while not self.stopped.wait(LOOK):
            # A file that is replaced between two system calls of one look is there in the next.
            if not any(self.home.copy() for _ in range(3)):
                self.gaps += 1

    def stop(self):
        self.stopped.set()
        self.join()
        return self.gaps


def starved(program):
    """Seconds that the program has waited for a core, by its first thread."""
    try:
        return int(pathlib.Path(f"/proc/{program.pid}/schedstat").read_text().split()[1]) * 1e-9
    except (OSError, IndexError):
        return 0.0  # it has ended, or the system does not tell


def wait_for(what, program):
    begin = time.monotonic() - starved(program)
    while time.monotonic() - begin - starved(program) < PATIENCE and program.poll() is None:
        if answer := what():
            return answer
        time.sleep(0.02)
    return None


def window_of(program, title):
    found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(program.pid), "--name", title], capture_output=True, text=True, check=False)
    return found.stdout.split()[0] if found.stdout.split() else None


def kill(program):
    program.kill()
    program.wait()


def change(home):
    """The work that an editor was killed with."""
    program = home.start(home.document)
    window = wait_for(lambda: window_of(program, "mine"), program)
    if window is None:
        kill(program)
        return None

    def try_once():
        subprocess.run(["xdotool", "windowactivate", window, "key", "ctrl+shift+r"], check=False, stderr=subprocess.DEVNULL)
        end = time.monotonic() + 3.0
        while time.monotonic() < end and home.copy() is None:
            time.sleep(0.02)
        return home.copy()

    work = wait_for(try_once, program)
    time.sleep(random.uniform(0.0, 0.5))
    kill(program)
    return home.copy() if work else None


def play(home):
    """What is wrong after two kills; empty: nothing."""
    work = change(home)
    if work is None:
        return "the first editor made no copy"
    guard = Guard(home)
    guard.start()
    second = home.start()
    time.sleep(random.uniform(0.0, 3.0))
    kill(second)
    if home.copy() != work:
        guard.stop()
        return "the work is lost by the second kill"
    third = home.start()
    window = wait_for(lambda: window_of(third, r"mine\*? — Fumage"), third)
    time.sleep(1.5)  # as long as the copy takes to be written anew
    there = home.copy() == work
    kill(third)
    gaps = guard.stop()
    return "the third editor does not show the work" if window is None or not there else f"{gaps} times no copy was on the disk" if gaps else ""


def main():
    programs = built_programs(sys.argv[1], "bin/fumage", "bin/fumage-cli")
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    seed = int(time.time())
    random.seed(seed)
    print(f"seed {seed}")
    faults = 0
    for number in range(rounds):
        place = pathlib.Path(tempfile.mkdtemp())
        wrong = play(Home(programs, place))
        shutil.rmtree(place, ignore_errors=True)
        if wrong:
            faults += 1
            print(f"round {number}: {wrong}", flush=True)
        if (number + 1) % 50 == 0 and number + 1 < rounds:
            print(f"{number + 1} rounds so far, {faults} faults", flush=True)
    print(f"{rounds} rounds, {faults} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
