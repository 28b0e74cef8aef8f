#!/usr/bin/env python3
"""Tries the editor for Windows under Wine, on a screen that DISPLAY names:  check_editor.py WINDOWS_BUILD LINUX_BUILD [STEPS]...

Steps: pictures   what the viewport shows of every preset has the same bits as on Linux
       widgets    tests of the editor that need no screen
       start      it starts, draws and plays, with OpenGL and without; light where the desktop is light and dark where it is dark
       files      a preset of any letters and more than 260 of them is opened, changed and saved; a picture is opened
       export     a picture is exported by the dialog
       recover    unsaved work is there again after a kill, after the end of the session and after Ctrl-C
       odd        where nothing can be written beside it and the user's folder has any letters, without fonts, and at 100 to 200 %
       install    the installer installs, offers its files, and takes everything away again; not while it runs, and nothing of others
What was seen lies in WINDOWS_BUILD/seen.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from PIL import Image, ImageChops, ImageStat

ROOT = pathlib.Path(__file__).resolve().parents[2]
WINE = ["bash", str(ROOT / "cmake/windows/wine.sh")]
ODD = "r\u00f6k \u70df \U0001F525"
SCREEN = (1920, 1080)  # of on_screen.sh
FRAME = 2  # pixels: xdotool counts the border of a frame twice
TESTS = ["document", "theme", "svg", "point_strip", "timeline", "key_graph", "marker_lane", "work_line", "viewport", "preview_renderer"]
faults = []


def check(holds, what):
    print(f"{'good  ' if holds else 'FAILED'}  {what}", flush=True)
    if not holds:
        faults.append(what)
    return holds


def in_wine(path):
    return "Z:" + str(path).replace("/", "\\")


def until(condition, seconds):
    """@return what the condition gives as soon as it gives something; else what it gives at last"""
    end = time.monotonic() + seconds
    while not (seen := condition()) and time.monotonic() < end:
        time.sleep(0.2)
    return seen


def x11(*words):
    return subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True).stdout.split()


def small(picture):
    return picture.convert("RGB").resize((320, 180))


def differ(one, other):
    """@return mean difference of two pictures, 0 to 255"""
    return sum(ImageStat.Stat(ImageChops.difference(small(one), small(other))).mean) / 3


class Editor:
    """fumage.exe on the screen."""

    def __init__(self, folder, *words, environment=None):
        self.process = subprocess.Popen([*WINE, str(folder / "fumage.exe"), *words], env={**os.environ, **(environment or {})},
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.window = None

    def wait(self, title="Fumage", seconds=240):
        """@return whether a window with this in its title is there"""
        found = until(lambda: self.process.poll() is not None or x11("search", "--onlyvisible", "--name", title), seconds)
        if not isinstance(found, list) or not found:
            return False
        self.window = found[0]
        x11("windowactivate", "--sync", self.window, "windowsize", "--sync", self.window, 1600, 900)
        time.sleep(3)
        return True

    def keys(self, *names, pause=1.5):
        for name in names:
            x11("key", "--clearmodifiers", name)
            time.sleep(pause)

    def box(self, window=None):
        """@return left, top, right and bottom of a window on the screen, without its frame"""
        known = dict(line.split("=") for line in x11("getwindowgeometry", "--shell", window or self.window) if "=" in line)
        left, top, width, height = (int(known[name]) for name in ("X", "Y", "WIDTH", "HEIGHT"))
        return left, top, left + width, top + height

    def title(self):
        return subprocess.run(["xdotool", "getwindowname", self.window or "0"], capture_output=True, text=True).stdout.strip()

    def kill(self):
        """As the Task Manager does."""
        subprocess.run([*WINE, "taskkill", "/F", "/IM", "fumage.exe"], capture_output=True)
        self.process.wait(timeout=60)


class Checks:
    def __init__(self, build, linux, place):
        self.build = build
        self.linux = linux
        self.place = place
        self.seen = build / "seen"
        self.seen.mkdir(exist_ok=True)
        self.portable = place / ODD / "portable"
        self.portable.mkdir(parents=True)
        subprocess.run(["unzip", "-q", str(next((build / "packages").glob("*.zip"))), "-d", str(self.portable)], check=True)
        self.folder = next(self.portable.iterdir()) if not (self.portable / "fumage.exe").exists() else self.portable
        self.data = self.folder / "fumage-data" / "fumage"
        self.data.mkdir(parents=True)
        self.settings()

    def settings(self, theme=1):
        (self.data / "fumage.ini").write_text(f"[face]\ntheme={theme}\n[start]\nshown=false\ntour=true\n")

    def cli(self, *words):
        return subprocess.run([str(self.linux / "bin/fumage-cli"), *map(str, words)], capture_output=True, text=True)

    def shot(self, name):
        file = self.seen / f"{name}.png"
        subprocess.run(["import", "-window", "root", str(file)], check=True)
        return Image.open(file)

    def preset(self, folder, name="smoke"):
        folder.mkdir(parents=True, exist_ok=True)
        file = folder / f"{name}.json"
        file.write_text(self.cli("presets", "--show", "thesis-2012").stdout)
        return file

    def pictures(self):
        run = lambda command: subprocess.run(command, capture_output=True, text=True).stdout.replace("\r", "").split("\n")[:-1]
        ours = run([str(self.linux / "bin/preview_checksums")])
        theirs = run([*WINE, str(self.build / "bin/preview_checksums.exe")])
        different = sorted(set(ours) ^ set(theirs))
        check(ours and not different, f"{len(theirs)} pictures of the viewport have the bits of Linux {different or ''}")

    def widgets(self):
        for name in TESTS:
            said = self.place / f"{name}.txt"  # a program with windows has no standard output
            done = subprocess.run([*WINE, str(self.build / f"tests/{name}_test.exe"), "-o", f"{in_wine(said)},txt"], capture_output=True,
                                  env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}, timeout=600)
            lines = said.read_text(errors="replace").split("\n") if said.exists() else []
            totals = next((line for line in lines if line.startswith("Totals:")), None)
            failed = [line for line in lines if line.startswith("FAIL")]
            check(done.returncode == 0 and totals and not failed, f"{name}_test: {totals} {failed or ''}")

    def start(self):
        file = self.preset(self.place / "start")
        for name, environment, theme in (("software", {"FUMAGE_OPENGL": "none"}, 1), ("opengl", {"FUMAGE_OPENGL": "software"}, 2)):
            self.settings(theme)
            editor = Editor(self.folder, in_wine(file), environment=environment)
            if not check(editor.wait("smoke"), f"{name}: a window opens: {editor.title()}"):
                self.shot(f"start_{name}_failed")
                editor.kill()
                continue
            time.sleep(10)
            first = self.shot(f"start_{name}")
            editor.keys("space", pause=6)
            second = self.shot(f"start_{name}_later")
            left, top, right, bottom = editor.box()
            middle = (left + (right - left) // 3, top + 100, left + 2 * (right - left) // 3, bottom - 200)
            spread = ImageStat.Stat(first.convert("L").crop(middle)).stddev[0]
            check(spread > 3, f"{name}: smoke is drawn (brightness varies by {spread:.1f})")
            check(differ(first.crop(middle), second.crop(middle)) > 0.05, f"{name}: the picture moves ({differ(first.crop(middle), second.crop(middle)):.2f})")
            dark = ImageStat.Stat(first.convert("L").crop((left, top, right, top + 60))).mean[0] < 128
            check(dark == (theme == 1), f"{name}: the theme is {'dark' if dark else 'light'}")
            editor.kill()
        self.settings()

    def files(self):
        deep = self.place / ODD
        while len(in_wine(deep)) < 300:
            deep = deep / "a folder with a long name, as they come about"
        file = self.preset(deep, ODD)
        before = file.read_bytes()
        editor = Editor(self.folder, in_wine(file))
        if check(editor.wait(), f"a preset with {len(in_wine(file))} letters is opened: {editor.title()}"):
            check(ODD in editor.title(), "its name is in the title")
            editor.keys("ctrl+shift+r", "ctrl+s", pause=4)
            check(until(lambda: file.read_bytes() != before, 20), "it is changed and saved")
            check(self.cli("validate", file).returncode == 0, "what was saved is a preset")
            self.shot("files_long")
        editor.kill()
        picture = self.place / "picture.png"
        self.cli("--quiet", "render", "thesis-2012", "-f", "20", "--size", "128", "-o", picture)
        editor = Editor(self.folder, in_wine(picture))
        if check(editor.wait("Thesis 2012"), f"a picture is opened: {editor.title()}"):
            time.sleep(6)
            self.shot("files_picture")
            editor.keys("F1")
            check(until(lambda: x11("search", "--onlyvisible", "--name", "Manual"), 60), "the manual opens")
            time.sleep(5)
            self.shot("files_manual")
        editor.kill()

    def export(self):
        file = self.preset(self.place / "export")
        editor = Editor(self.folder, in_wine(file))
        if check(editor.wait("smoke"), "export: a window opens"):
            editor.keys("ctrl+e", pause=8)
            self.shot("export_dialog")
            before = set(self.place.rglob("*.png"))
            editor.keys("Return", pause=10)
            self.shot("export_running")
            made = until(lambda: sorted(set(self.place.rglob("*.png")) - before), 240)
            check(made, f"the dialog exports {[p.name for p in made][:4]}")
            time.sleep(4)
            self.shot("export_done")
            if made:
                shutil.copy(made[-1], self.seen / "export_made.png")
                check(self.cli("info", made[-1]).returncode == 0 or Image.open(made[-1]).size[0] > 0, "what was made is a picture")
        editor.kill()

    def recover(self):
        for number, (name, end) in enumerate((("a kill", lambda editor: editor.kill()), ("the end of the session", self.end_session))):
            file = self.preset(self.place / "recover", f"work{number}")
            editor = Editor(self.folder, in_wine(file))
            if not check(editor.wait(f"work{number}"), f"before {name} a window opens"):
                editor.kill()
                continue
            editor.keys("ctrl+shift+r")
            copies = lambda: list((self.data / "recovery").glob("*.json"))
            check(until(copies, 20), f"before {name} a copy is kept")
            end(editor)
            check(editor.process.poll() is not None and copies(), f"after {name} the program is gone and the copy is there")
            changed = copies()[0].read_bytes() if copies() else b""
            editor = Editor(self.folder)
            if check(editor.wait(f"work{number}"), f"after {name} it is open again: {editor.title()}"):
                time.sleep(5)
                self.shot(f"recover_{number}")
                editor.keys("ctrl+s", pause=4)
                check(until(lambda: json.loads(file.read_text()) == json.loads(changed), 20), "and is what it was")
            editor.kill()
            for left in (self.data / "recovery").glob("*"):
                left.unlink()

    def end_session(self, editor):
        try:
            subprocess.run([*WINE, "wineboot", "--end-session"], capture_output=True, timeout=120)
            editor.process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            editor.kill()
            check(False, "the end of the session ends the program")

    def odd(self):
        self.odd_folders()
        self.odd_fonts()
        self.odd_scales()

    def odd_folders(self):
        """The program lies where it cannot write; work is kept in the user's folder, whose name has any letters."""
        folder = self.place / "locked"
        shutil.copytree(self.folder, folder)
        shutil.rmtree(folder / "fumage-data")
        (folder / "fumage-data").symlink_to("/proc/self")  # where not even root makes a file
        user = self.place / f"user {ODD}"
        user.mkdir()
        key = "HKCU\\Software\\Microsoft\\Windows\\CurrentVersion\\Explorer\\User Shell Folders"
        for value in ("AppData", "Local AppData"):
            subprocess.run([*WINE, "reg", "add", key, "/v", value, "/d", in_wine(user), "/f"], capture_output=True)
        file = self.preset(self.place / "odd", "locked")
        copies = lambda: list((user / "fumage/recovery").glob("*.json"))
        editor = Editor(folder, in_wine(file))
        if check(editor.wait("locked"), f"odd: where nothing can be written beside it, a window opens: {editor.title()}"):
            editor.keys("ctrl+shift+r")
            check(until(copies, 20), "odd: unsaved work is kept in the user's folder")
            self.shot("odd_folders")
        editor.kill()
        editor = Editor(folder)
        if check(editor.wait("locked"), "odd: and is open again after a kill"):
            editor.keys("ctrl+s", pause=4)
        editor.kill()
        for value in ("AppData", "Local AppData"):
            subprocess.run([*WINE, "reg", "delete", key, "/v", value, "/f"], capture_output=True)

    def odd_fonts(self):
        editor = Editor(self.folder, in_wine(self.preset(self.place / "odd", "fonts")), environment={"FONTCONFIG_FILE": "/dev/null"})
        if check(editor.wait("fonts"), "odd: without fonts a window opens"):
            self.shot("odd_fonts")
        editor.kill()

    def odd_scales(self):
        file = self.preset(self.place / "odd", "scale")
        for percent in (100, 150, 200):
            for key in ("HKCU\\Control Panel\\Desktop", "HKCU\\Software\\Wine\\Fonts"):
                subprocess.run([*WINE, "reg", "add", key, "/v", "LogPixels", "/t", "REG_DWORD", "/d", str(96 * percent // 100), "/f"], capture_output=True)
            subprocess.run(["wineserver", "-k"], env={**os.environ, "WINEPREFIX": os.environ["FUMAGE_WINE_FOLDER"]}, capture_output=True)
            editor = Editor(self.folder, in_wine(file))
            if check(editor.wait("scale"), f"odd: at {percent} % a window opens"):
                self.shot(f"odd_scale_{percent}")
                editor.keys("ctrl+e", pause=8)
                self.shot(f"odd_scale_{percent}_export")
                dialogs = x11("search", "--onlyvisible", "--name", "Export")
                if check(dialogs, f"odd: at {percent} % the export dialog opens"):
                    left, top, right, bottom = editor.box(dialogs[0])
                    inside = left >= 0 and top >= 0 and right <= SCREEN[0] + FRAME and bottom <= SCREEN[1] + FRAME
                    check(inside, f"odd: at {percent} % it is on the screen: {left}, {top} to {right}, {bottom}")
            editor.kill()

    def registry(self, key):
        return subprocess.run([*WINE, "reg", "query", key], capture_output=True, text=True, errors="replace").stdout

    def install_while_it_runs(self, setup, folder):
        editor = Editor(folder)
        if check(editor.wait(), "the installed program opens a window"):
            note = folder / "LICENSE.txt"
            note.write_text("old")
            refused = lambda program: subprocess.run([*WINE, str(program), "/S", f"_?={in_wine(folder)}"], timeout=300).returncode == 2
            check(refused(setup) and note.read_text() == "old", "nothing is installed while it runs")
            check(refused(folder / "uninstall.exe") and note.exists() and (folder / "fumage.exe").exists(), "nothing is taken away while it runs")
        editor.kill()

    def install_beside_others(self, setup):
        """In a folder of other things a folder of its own is made, and they stay."""
        other = self.place / f"andra_{ODD.replace(' ', '')}"
        theirs = [other / name for name in ("README.txt", "uninstall.exe", "licences/theirs.txt")]
        for file in theirs:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text("theirs")
        subprocess.run([*WINE, str(setup), "/S", f"/D={in_wine(other)}"], timeout=300)
        ours = other / "Fumage"
        check(until((ours / "uninstall.exe").exists, 120), "in a folder of other things it gets one of its own")
        third = self.place / "third"
        subprocess.run([*WINE, str(setup), "/S", f"/D={in_wine(third)}"], timeout=300)
        check(until((third / "uninstall.exe").exists, 120), "it is installed a second time, elsewhere")
        subprocess.run([*WINE, str(ours / "uninstall.exe"), "/S"], timeout=300)
        check(until(lambda: not ours.exists(), 60) and all(file.read_text() == "theirs" for file in theirs), "and they stay when it goes")
        offered = lambda: "third" in self.registry("HKCU\\Software\\Classes\\Fumage.Preset\\shell\\open\\command")
        check(offered(), "what the later one offers stays when the earlier goes")
        subprocess.run([*WINE, str(third / "uninstall.exe"), "/S"], timeout=300)
        check(until(lambda: not third.exists(), 60) and not offered(), "and goes with it")

    def install(self):
        setup = next((self.build / "packages").glob("*-setup.exe"))
        subprocess.run([*WINE, str(setup), "/S"], timeout=300)
        prefix = pathlib.Path(os.environ["FUMAGE_WINE_FOLDER"])
        find = lambda: list(prefix.rglob("Programs/Fumage/fumage.exe"))
        installed = until(find, 120)
        if not check(installed, "the installer installs for one user"):
            return
        folder = installed[0].parent
        check((folder / "share/fumage/docs/manual").is_dir() and (folder / "licences").is_dir(), "manual and licences lie beside it")
        check(not (folder / "fumage-data").exists(), "settings are kept where Windows has them")
        for ending in (".json", ".png", ".exr"):
            check("Fumage." in self.registry(f"HKCU\\Software\\Classes\\{ending}\\OpenWithProgids"), f"it offers to open {ending}")
        check(list(prefix.rglob("Start Menu/Programs/Fumage.lnk")), "it is in the start menu")
        done = subprocess.run([*WINE, str(folder / "fumage.exe"), "--keys"], capture_output=True, text=True, errors="replace", timeout=120)
        check("Ctrl+Z" in done.stdout, "the installed program says its keys")
        self.install_while_it_runs(setup, folder)
        subprocess.run([*WINE, str(folder / "uninstall.exe"), "/S"], timeout=300)
        check(until(lambda: not folder.exists(), 60), f"the uninstaller takes it away {sorted(p.name for p in folder.rglob('*'))[:4] if folder.exists() else ''}")
        check("Fumage." not in self.registry("HKCU\\Software\\Classes\\.json\\OpenWithProgids"), "and its offers")
        self.install_beside_others(setup)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("linux", type=pathlib.Path)
    parser.add_argument("steps", nargs="*", default=[])
    given = parser.parse_args()
    steps = given.steps or ["pictures", "widgets", "start", "files", "export", "recover", "odd", "install"]
    # Pictures that the editor writes to the user's folders lie in this one.
    with tempfile.TemporaryDirectory() as place:
        os.environ["FUMAGE_WINE_DISPLAY"] = os.environ["DISPLAY"]
        os.environ["FUMAGE_WINE_FOLDER"] = str(pathlib.Path(place) / "wine")
        os.environ["HOME"] = place
        os.environ["LC_ALL"] = "C.UTF-8"  # by which Wine names files
        subprocess.run([*WINE, "wineboot", "--init"], capture_output=True)
        checks = Checks(given.build.resolve(), given.linux.resolve(), pathlib.Path(place))
        try:
            for step in steps:
                print(f"-- {step}", flush=True)
                getattr(checks, step)()
        finally:
            subprocess.run(["wineserver", "-k"], env={**os.environ, "WINEPREFIX": os.environ["FUMAGE_WINE_FOLDER"]}, capture_output=True)
    print(f"{len(faults)} fault(s)" if faults else "all good")
    sys.exit(1 if faults else 0)


main()
