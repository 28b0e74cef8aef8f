#!/usr/bin/env python3
"""Kills programs that write, over and over, and looks at what they leave: kill_loop.py BUILD_FOLDER [ROUNDS]

`./dev test-kill` builds what this needs and runs it.

Each round starts one of them, ends it with SIGKILL after a time of chance, and checks that every file is whole. A round
of each kind later the same program has started anew in the same folder: then nothing of the killed one may be left but
whole files. An export that was once on a queue's list stays on a list until its picture is there.
"""

import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import time
import zlib

from built_programs import built_programs

SMALL = ["--size", "64", "--set", "emitter.count=400", "--set", "noise.slices=2", "--set", "noise.resolution=16"]


def whole_png(data):
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        return False
    at = 8
    while at + 12 <= len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        end = at + 12 + length
        if end > len(data) or zlib.crc32(data[at + 4:end - 4]) != struct.unpack(">I", data[end - 4:end])[0]:
            return False
        if kind == b"IEND":
            return end == len(data)
        at = end
    return False


def whole_json(data):
    try:
        json.loads(data)
        return True
    except ValueError:
        return False


CHECKS = {".png": whole_png, ".json": whole_json}


class Victims:
    """The kinds of writers, each with a folder of its own."""

    def __init__(self, build, folder):
        cli, victim = built_programs(build, "bin/fumage-cli", "tests/kill_victim")
        self.folders = {kind: folder / kind for kind in ("render", "flipbook", "save", "recover", "queue")}
        for path in self.folders.values():
            path.mkdir()
        pictures = [cli, "render", "thesis-2012", "-f", "0-99", "-o", str(self.folders["render"] / "f_##.png")] + SMALL
        flipbook = [cli, "flipbook", "thesis-2012", "--grid", "2", "-o", str(self.folders["flipbook"] / "f.png")] + SMALL
        self.commands = {
            "render": pictures,
            "flipbook": flipbook,
            "save": [victim, "save", str(self.folders["save"] / "mine.json")],
            "recover": [victim, "recover", str(self.folders["recover"])],
            "queue": [victim, "queue", str(self.folders["queue"])],
        }
        self.listed = set()

    def leftovers(self, kind):
        """Names that are neither whole files nor those of a recovery."""
        known = (".png", ".json", ".origin", ".mark")
        return [p.name for p in self.folders[kind].iterdir() if p.is_file() and not p.name.endswith(known)]

    def broken(self, kind):
        return [p.name for p in self.folders[kind].iterdir() if p.suffix in CHECKS and not p.name.startswith(".") and not CHECKS[p.suffix](p.read_bytes())]

    def lost(self):
        """Exports that were on a list, and are neither on one nor done."""
        lists = [p.read_bytes() for p in (self.folders["queue"] / "lists").glob("*.json")]
        waiting = {job["name"] for text in lists for job in json.loads(text)["jobs"]}
        self.listed |= waiting
        return sorted(name for name in self.listed - waiting if not (self.folders["queue"] / (name + ".png")).exists())


def main():
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    seed = int(time.time())
    chance = random.Random(seed)
    print(f"seed {seed}")
    killed = left = faults = 0
    longest = {"render": 0.6, "flipbook": 0.3, "save": 0.1, "recover": 0.1, "queue": 4.0}
    with tempfile.TemporaryDirectory() as place:
        victims = Victims(sys.argv[1], pathlib.Path(place))
        for number in range(rounds):
            kind = list(victims.commands)[number % len(victims.commands)]
            program = subprocess.Popen(victims.commands[kind], stdout=subprocess.DEVNULL)
            try:
                code = program.wait(timeout=chance.uniform(0.005, longest[kind]))
            except subprocess.TimeoutExpired:
                program.kill()
                code = program.wait()
            killed += code == -9
            left += len(victims.leftovers(kind))
            broken = victims.broken(kind) + (victims.lost() if kind == "queue" else [])
            if broken or code not in (0, -9):
                faults += 1
                print(f"round {number}: {kind} ended with {code}, broken: {broken}")
        for kind in ("render", "flipbook"):
            subprocess.run(victims.commands[kind], check=True)
        for kind in ("save", "recover", "queue"):
            program = subprocess.Popen(victims.commands[kind])
            time.sleep(1)
            program.terminate()
            program.wait()
        lost = victims.lost()
        faults += len(lost)
        print(f"{len(victims.listed)} exports were on a list, {len(lost)} are lost")
        # The recovery's own lock is that of the program that was just ended.
        after = [name for kind in victims.commands for name in victims.leftovers(kind) if not name.endswith(".lock")]
        locks = [name for name in victims.leftovers("recover") if name.endswith(".lock")]
        print(f"{rounds} rounds, {killed} killed in the middle, {left} files left by them, {faults} faults; after the next start {len(after)} files and {len(locks)} lock(s) left")
        for name in after + locks[1:]:
            print(f"left: {name}")
        sys.exit(1 if faults or after or len(locks) > 1 else 0)


if __name__ == "__main__":
    main()
