#!/usr/bin/env python3
"""Tries fumage-cli.exe under Wine:  check_windows.py WINDOWS_BUILD LINUX_BUILD [--rounds N] [--presets A,B] [STEPS]...

Steps: platform  what the core promises of files, locks, programs and memory, by tests/windows/platform_checks.cpp
       golden    the checksums of tests/golden/golden.txt
       bits      a table of presets and frames, rendered here and there: the hashes of their manifests are the same
       files     all other formats are the same, byte for byte
       library   a program in C that steps smoke with the DLL says what it says with the library of Linux
       console   arguments and paths of any letters, standard streams of any bytes, the user's folder, Ctrl-C
       kill      the program is killed while it writes, 100 times: every file is whole, and the next start clears the rest away
"""

import argparse
import contextlib
import json
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/reliability"))
from kill_loop import CHECKS, SMALL, whole_png  # noqa: E402

WINE = ["bash", str(ROOT / "cmake/windows/wine.sh")]
TINY = ["--size", "96", "--set", "emitter.count=4000"]
FRAMES = "15-45:15"
faults = []


def check(holds, what):
    print(f"{'good  ' if holds else 'FAILED'}  {what}", flush=True)
    if not holds:
        faults.append(what)


def in_wine(path):
    return "Z:" + str(path).replace("/", "\\")


class Program:
    """fumage-cli, of Windows or of Linux."""

    def __init__(self, command):
        self.command = command

    def run(self, *words, expect=0, **options):
        done = subprocess.run(self.command + list(words), capture_output=True, **options)
        if done.returncode != expect:
            check(False, f"{' '.join(words)} ends with {expect}, not {done.returncode}: {done.stderr.decode(errors='replace').strip()}")
        return done

    def start(self, *words, **options):
        # What a shell runs in the background does not hear Ctrl-C, nor what that starts.
        options.setdefault("stderr", subprocess.DEVNULL)
        return subprocess.Popen(self.command + list(words), stdout=subprocess.DEVNULL,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL), **options)


class Checks:
    def __init__(self, build, linux, folder, rounds, presets):
        self.build = build
        self.windows = Program(WINE + [str(build / "bin/fumage-cli.exe")])
        self.other = linux
        self.linux = Program([str(linux / "bin/fumage-cli")])
        self.folder = folder
        self.rounds = rounds
        self.presets = presets or sorted(p.stem for p in (ROOT / "resources/presets").glob("*.json"))

    def platform(self):
        done = subprocess.run(WINE + [str(self.build / "bin/platform_checks.exe"), str(self.folder)], capture_output=True, text=True)
        print(done.stdout.replace("\r", ""), end="")
        check(done.returncode == 0, "all of the core's files for Windows")

    def golden(self):
        expected = [line for line in (ROOT / "tests/golden/golden.txt").read_text().split("\n")[:-1] if line.split()[0] in self.presets]
        done = subprocess.run(WINE + [str(self.build / "bin/golden_checksums.exe"), *self.presets], capture_output=True, text=True)
        seen = done.stdout.replace("\r", "").split("\n")[:-1]
        different = sorted(set(expected) ^ set(seen))
        check(not different, f"{len(seen)} golden checksums are those of every machine {different or ''}")

    def hashes(self, program, folder, preset, options=()):
        program.run("--quiet", *options, "render", preset, "-f", FRAMES, *TINY, "--manifest", "-o", str(folder / f"{preset}_###.exr"))
        return {entry["file"]: entry["pixels"] for part in sorted(folder.glob(f"{preset}*.manifest.json")) for entry in json.loads(part.read_text())["files"]}

    def bits(self):
        sets = json.loads(self.windows.run("info", "--json").stdout)["instructionSets"]
        ours, theirs = self.folder / "linux", self.folder / "windows"
        same = total = 0
        print("        file                     SHA-256 of what it shows, by Linux and by Windows")
        for number, preset in enumerate(self.presets):
            simd = sets[number % len(sets)]
            expected = self.hashes(self.linux, ours, preset)
            seen = self.hashes(self.windows, theirs, preset, ["--simd", simd])
            for file, value in expected.items():
                is_same = seen.get(file) == value
                print(f"{'good  ' if is_same else 'FAILED'}  {file:<24} {value[:16]} {str(seen.get(file))[:16]} {simd}", flush=True)
                same += is_same
                total += 1
        check(same == total == 3 * len(self.presets), f"{same} of {total} frames have the same hash, with {', '.join(sets)} by turns")
        check(self.linux.run("--quiet", "verify", str(theirs)).returncode == 0, "Linux finds the files of Windows to be what their manifests say")
        check(self.windows.run("--quiet", "verify", str(ours)).returncode == 0, "and the other way round")

    def files(self):
        jobs = {
            "smoke.ply": ["dump", "default", "--frame", "20", "--format", "ply"],
            "smoke.pcache": ["dump", "thesis-2012", "--frame", "20", "--format", "pcache"],
            "smoke.vdb": ["volume", "steam", "--frames", "20"],
            "smoke.fga": ["air", "campfire", "--frame", "10"],
            "noise.png": ["bake-noise", "default", "--size", "128"],
            "smoke.tga": ["render", "magic", "--frames", "20"] + TINY,
            "smoke.png": ["render", "magic", "--frames", "20"] + TINY,
            "sheet.png": ["flipbook", "steam", "--grid", "4x4", "--size", "64", "--passes", "colour,six-way,motion", "--for", "godot"] + TINY[2:],
        }
        for name, words in jobs.items():
            for place, program in (("l", self.linux), ("w", self.windows)):
                (self.folder / place / name).mkdir(parents=True)
                program.run("--quiet", *words, "-o", str(self.folder / place / name / name))
            ours = {p.name: p.read_bytes() for p in (self.folder / "l" / name).iterdir()}
            theirs = {p.name: p.read_bytes() for p in (self.folder / "w" / name).iterdir()}
            differ = sorted(file for file in ours.keys() | theirs.keys() if ours.get(file) != theirs.get(file))
            check(ours and not differ, f"{words[0]} writes the same {len(ours)} file(s) {differ or ''}")

    def library(self):
        source = ["-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror", str(ROOT / "tests/consumer/smoke.c"), "-I" + str(self.other / "include")]
        subprocess.run(["cc", *source, "-o", str(self.folder / "smoke"), str(self.other / "lib/libfumage.so")], check=True)
        subprocess.run(["x86_64-w64-mingw32-gcc", *source, "-o", str(self.folder / "smoke.exe"), str(self.build / "lib/libfumage.dll.a")], check=True)
        ours = subprocess.run([str(self.folder / "smoke")], capture_output=True, text=True, env={**os.environ, "LD_LIBRARY_PATH": str(self.other / "lib")})
        theirs = subprocess.run(WINE + [str(self.folder / "smoke.exe")], capture_output=True, text=True, env={**os.environ, "WINEPATH": "Z:" + str(self.build / "bin")})
        check(ours.returncode == theirs.returncode == 0 and ours.stdout == theirs.stdout.replace("\r", ""), f"with libfumage.dll: {theirs.stdout.strip()}")
        exports = subprocess.run(["x86_64-w64-mingw32-objdump", "-p", str(self.build / "bin/libfumage.dll")], capture_output=True, text=True).stdout
        names = re.findall(r"^\s*\[\s*\d+\][^\n]*\s(\w+)$", exports[exports.find("[Ordinal/Name Pointer]"):], re.MULTILINE)
        check(names and all(name.startswith("fumage_") for name in names), f"the DLL exports its {len(names)} functions and nothing else")

    def console(self):
        shown = self.linux.run("presets", "--show", "default").stdout
        check(self.windows.run("presets", "--show", "default").stdout == shown, "standard output has the same bytes, line ends too")
        check(self.windows.run("validate", "-", input=shown.replace(b"\n", b"\r\n")).returncode == 0, "standard input takes a preset with line ends of Windows")
        self.letters()
        self.interrupted()

    def letters(self):
        name = "r\u00f6k \u70df \U0001F525"
        place = self.folder / name
        place.mkdir()
        preset = place / f"{name}.json"
        preset.write_bytes(self.linux.run("presets", "--show", "default").stdout)
        picture = place / f"{name}_new" / "f_##.png"
        done = self.windows.run("render", str(preset), "-f", "3", *SMALL, "-o", str(picture))
        written = list(picture.parent.glob("*")) if picture.parent.exists() else []
        check([p.name for p in written] == ["f_03.png"] and whole_png(written[0].read_bytes()), "arguments and paths of any letters arrive")
        check(name.encode() in done.stderr, "and are said as UTF-8")
        missing = self.windows.run("render", str(self.folder / f"{name}.json"), expect=1)
        check(name.encode() in missing.stderr and b"there is no such file" in missing.stderr, "a file that is missing is named")
        self.letters_in_files(place, name)
        library = place / "fumage" / "presets"
        library.mkdir(parents=True)
        (library / f"{name} mine.json").write_bytes(preset.read_bytes())
        # Wine gives the first program that it starts a folder of its own; that program hands on what it likes.
        shell = Program(WINE + ["cmd", "/c", f"set APPDATA={in_wine(place)}&&{in_wine(self.build / 'bin/fumage-cli.exe')}"])
        listed = shell.run("presets").stdout
        check(f"{name} mine".encode() in listed, "presets of the user's folder are listed")

    def letters_in_files(self, place, name):
        """Names that stand in jobs, in manifests, and in what is written for engines and farms."""
        jobs = place / f"{name} jobs.json"
        job = {"name": name, "preset": str(place / f"{name}.json"), "output": str(place / "jobs" / f"{name}_##.png"), "frames": "3"}
        jobs.write_text(json.dumps({"format": "fumage-jobs", "version": 1, "jobs": [job]}))
        self.windows.run("render", "--jobs", str(jobs))
        check((place / "jobs" / f"{name}_03.png").exists(), "jobs name presets and files of any letters")
        sheets = place / "sheets"
        manifest = sheets / f"{name} list.manifest.json"
        self.windows.run("flipbook", "thesis-2012", "--grid", "2", *SMALL, "--for", "godot", f"--manifest={manifest}", "-o", str(sheets / f"{name}.png"))
        written = {p.name for p in sheets.glob("*")}
        wanted = {manifest.name, *(name + ending for ending in (".png", ".png.import", ".tscn", ".gdshader", ".flipbook.json"))}
        check(wanted <= written, f"so do manifests and an engine's files {sorted(wanted - written) or ''}")
        for program, system in ((self.windows, "Windows"), (self.linux, "Linux")):
            check(program.run("--quiet", "verify", "--render", "0-999", str(sheets)).returncode == 0, f"{system} verifies them, and renders them again")
        for farm, ending in (("slurm", ".slurm.sh"), ("openjd", ".openjd.json"), ("flamenco", ".flamenco.js"), ("deadline", ".deadline.sh")):
            self.windows.run("farm", "thesis-2012", "-f", "0-3", "--for", farm, "-o", str(place / "farm" / f"{name}_##.exr"))
            check((place / "farm" / f"{name}{ending}").exists(), f"{farm} has its files")

    def interrupted(self):
        place = self.folder / "interrupted"
        place.mkdir()
        program = self.windows.start("render", "thesis-2012", "-f", "0-999", "-o", str(place / "f_###.png"))
        while not list(place.glob("f_*.png")) and program.poll() is None:
            time.sleep(0.05)
        program.send_signal(signal.SIGINT)
        code = program.wait(timeout=60)
        left = [p for p in place.iterdir() if p.suffix != ".png" or not whole_png(p.read_bytes())]
        check(code == 130 and not left, f"Ctrl-C ends it with 130 and leaves whole pictures: {code}, {left}")
        waiting = self.windows.start("validate", "-", stdin=subprocess.PIPE)
        time.sleep(3)
        waiting.send_signal(signal.SIGINT)
        check(waiting.wait(timeout=60) == 130, "Ctrl-C ends waiting for standard input")

    def kill(self):
        seed = int(time.time())
        chance = random.Random(seed)
        place = self.folder / "killed"
        words = {"render": ["render", "thesis-2012", "-f", "0-999", *SMALL, "-o", str(place / "render" / "f_###.png")],
                 "flipbook": ["flipbook", "thesis-2012", "--grid", "2", *SMALL, "-o", str(place / "flipbook" / "f.png")]}
        killed = left = 0
        for number in range(self.rounds):
            kind = list(words)[number % 2]
            folder = place / kind
            folder.mkdir(parents=True, exist_ok=True)
            for file in folder.glob("*.png") if number % 10 < 2 else ():
                file.unlink()
            # From when it begins to write, not from when Wine does.
            before = self.stamps(folder)
            with open(place / "said", "wb") as said:
                program = self.windows.start(*words[kind], stderr=said)
            while self.stamps(folder) == before and program.poll() is None:
                time.sleep(0.002)
            time.sleep(chance.uniform(0.0, 0.3 if kind == "render" else 0.05))
            program.kill()
            code = program.wait()
            killed += code == -9
            left += len(self.drafts(folder))
            broken = [p.name for p in folder.iterdir() if p.suffix in CHECKS and not p.name.startswith(".") and not CHECKS[p.suffix](p.read_bytes())]
            if broken or code not in (0, -9):
                check(False, f"round {number} (seed {seed}): {kind} ended with {code}, broken: {broken}; it said: {(place / 'said').read_text()[-500:]}")
        for kind, command in words.items():
            last = [word if word != "0-999" else "0" for word in command]
            self.windows.run("--quiet", *last)
        after = [p.name for kind in words for p in self.drafts(place / kind)]
        check(not after, f"{self.rounds} rounds, {killed} killed while they wrote, no half file; {left} drafts left, {len(after)} after the next start (seed {seed})")

    @staticmethod
    def drafts(folder):
        return [p for p in folder.iterdir() if p.name.startswith(".fumage-")]

    @staticmethod
    def stamps(folder):
        """What shows that something is being written."""
        found = {}
        for entry in os.scandir(folder):
            with contextlib.suppress(FileNotFoundError):  # a draft that has become a file since
                found[entry.name] = entry.stat().st_mtime_ns
        return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("linux", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=100)
    parser.add_argument("--presets", default="", help="of golden and bits; default: all")
    parser.add_argument("steps", nargs="*", default=[])
    given = parser.parse_args()
    steps = given.steps or ["platform", "console", "library", "golden", "bits", "files", "kill"]
    with tempfile.TemporaryDirectory() as place:
        checks = Checks(given.build.resolve(), given.linux.resolve(), pathlib.Path(place), given.rounds, [name for name in given.presets.split(",") if name])
        for step in steps:
            print(f"-- {step}", flush=True)
            getattr(checks, step)()
    print(f"{len(faults)} fault(s)" if faults else "all good")
    sys.exit(1 if faults else 0)


main()
