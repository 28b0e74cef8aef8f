#!/usr/bin/env python3
"""Does what the README and the pages that it hands over to tell a newcomer to do, smaller:  check_readme.py <source tree> <fumage-cli>

Every command of their blocks names a program that ./dev leaves where the command says; those of the command line run, once each and in the order in
which they stand, in a folder that was empty, with few particles, small pictures and few frames. A block of JSON that is a list of exports is the file
that a command names. What `./dev` is asked for is what `./dev` knows. The README stays short, text as wide as people read it; every built-in preset
has its row among the pictures, with its own description.
"""
import json
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

SMALL = ["emitter.count=300", "air.resolution=16", "noise.slices=2", "noise.resolution=16", "light.resolution=8", "timeline.length=64"]
PAGES = ("README.md", "resources/docs/command-line.md", "resources/docs/exporting.md")
LINES, PROSE, ROW = 119, 100, 160  # the README's at most; the width of its text, and of a row of a table
NO_SETTINGS = ("presets", "farm", "info", "parameters")  # commands that take no --set, or for which it makes nothing cheaper


def blocks(text):
    """The blocks between fences: their language, and their lines."""
    return [(match[1], match[2].splitlines()) for match in re.finditer(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)]


def shape_faults(text, longest=LINES, row=ROW):
    """What is too long or too wide. Blocks are as wide as they must be, as is a line that is one picture or one link."""
    lines = text.splitlines()
    faults = [f"{len(lines)} lines: {longest} at most"] if len(lines) > longest else []
    fenced = False
    for number, line in enumerate(lines, 1):
        fenced ^= line.startswith("```")
        most = row if line.startswith("|") else PROSE
        if not fenced and len(line) > most and not re.fullmatch(r"\s*!?\[[^\]]*\]\([^)]*\)\S?", line):
            faults.append(f"line {number} has {len(line)} columns: {most} at most")
    return faults


def check_gallery(source):
    page = (source / "resources/docs/presets.md").read_text(encoding="utf-8")
    for path in sorted((source / "resources/presets").glob("*.json")):
        row = re.search(rf"^\| !\[.*\]\(\.\./pictures/{path.stem}\.png\) \| `{path.stem}` \| (.*) \|$", page, re.M)
        assert row, f"resources/docs/presets.md has no row of {path.stem}"
        description = json.loads(path.read_text(encoding="utf-8"))["description"]
        assert row[1] == description, f"resources/docs/presets.md does not describe {path.stem} as the preset does: {description}"


def smaller(words):
    """The same command for a picture that takes no time."""
    words = list(words)
    for i, word in enumerate(words[:-1]):
        if word == "--size":
            words[i + 1] = "32"
        if word == "--grid":
            words[i + 1] = "2x2"
        if word == "--frames":
            words[i + 1] = "0-3"
        if word == "--frame":
            words[i + 1] = "1"
    of_files = any(word.endswith(".manifest.json") for word in words)  # whose settings they had when they were made
    if words[0] not in NO_SETTINGS and "--jobs" not in words and not of_files:
        for setting in SMALL:
            words += ["--set", setting]
    return words


def write_jobs(jobs, cli, folder):
    """The list of exports under the name that the pages have for it, of a small preset and of few frames."""
    preset = json.loads(subprocess.run([cli, "presets", "--show", "thesis-2012"], check=True, capture_output=True, text=True).stdout)
    preset["scene"]["output"].update(width=16, height=16)
    preset["layers"][0]["emitter"]["count"] = 300
    (folder / "small.json").write_text(json.dumps(preset), encoding="utf-8")
    for job in jobs["jobs"]:
        job["preset"] = "small.json"
        job["frames"] = "0-3"
        job.update({"columns": 2, "rows": 2} if job.get("kind") == "flipbook" else {})
    (folder / "tonight.json").write_text(json.dumps(jobs), encoding="utf-8")


def run(cli, words, folder):
    if words[0] == "video" and not shutil.which("ffmpeg"):
        return "left out: there is no ffmpeg"
    output = words[words.index("--output") + 1] if "--output" in words and words[0] != "farm" else None
    pattern = re.sub("#+", "*", output or "")
    if "--layers-as" in words:  # names of layers come before the ending
        pattern = re.sub(r"(\.\w+)$", r"_*\1", pattern)
    pattern += "*" if pattern.endswith("/") else ""
    for old in filter(pathlib.Path.is_file, folder.glob(pattern) if output else []):
        old.unlink()  # of a command before, which this one's file has the name of
    done = subprocess.run([cli, *smaller(words)], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, f"{shlex.join(words)} ended with {done.returncode}: {done.stderr}"
    assert not output or list(folder.glob(pattern)), f"{shlex.join(words)} wrote no {output}"
    return "ran"


def check_command(words, source, cli, folder):
    program = words[0]
    if program == "./dev":
        usage = subprocess.run(["bash", str(source / "dev")], capture_output=True, text=True).stdout
        assert re.search(rf"^\./dev {words[1]}\b", usage, re.M), f"./dev knows no {words[1]}"
        return "is known"
    if program in ("cmake", "ctest"):
        return "is another's"
    assert program in ("build/bin/fumage-cli", "build/bin/fumage"), f"{program}: ./dev leaves programs in build/bin"
    return run(cli, words[1:], folder) if program.endswith("-cli") else "is there"


def main():
    source, cli = pathlib.Path(sys.argv[1]), str(pathlib.Path(sys.argv[2]).resolve())
    texts = {page: (source / page).read_text(encoding="utf-8") for page in PAGES}
    faults = shape_faults(texts["README.md"])
    assert not faults, "README.md: " + "; ".join(faults)
    check_gallery(source)
    done = set()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for language, lines in (block for text in texts.values() for block in blocks(text)):
            jobs = json.loads("\n".join(lines)) if language == "json" else {}
            if jobs.get("format") == "fumage-jobs":
                write_jobs(jobs, cli, folder)
        for page, text in texts.items():
            commands = 0
            for line in (line for language, lines in blocks(text) if language in ("", "sh", "bash") for line in lines):
                words = shlex.split(re.sub(r"\s# .*", "", line))
                commands += bool(words)
                if words and line not in done:
                    print(f"{line}\n    {check_command(words, source, cli, folder)}")
                    done.add(line)
            assert commands > 5, f"{page} has no commands"


if __name__ == "__main__":
    main()
