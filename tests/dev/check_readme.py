#!/usr/bin/env python3
"""Does what the README tells a newcomer to do, smaller:  check_readme.py <source tree> <fumage-cli>

Every command of its blocks names a program that ./dev leaves where the command says; those of the command line run, in an empty folder, with few
particles, small pictures and two frames. A block of JSON that is a list of exports is the file that a command names. What `./dev` is asked for is
what `./dev` knows.
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
NO_SETTINGS = ("presets", "farm")  # commands that take no --set, or for which it makes nothing cheaper


def blocks(text):
    """The blocks between fences: their language, and their lines."""
    return [(match[1], match[2].splitlines()) for match in re.finditer(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)]


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
    if words[0] not in NO_SETTINGS and "--jobs" not in words:
        for setting in SMALL:
            words += ["--set", setting]
    return words


def write_jobs(jobs, cli, folder):
    """The list of exports under the name that the README has for it, of a small preset and of few frames."""
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
    done = subprocess.run([cli, *smaller(words)], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, f"{shlex.join(words)} ended with {done.returncode}: {done.stderr}"
    output = words[words.index("--output") + 1] if "--output" in words else None
    if output and words[0] != "farm":
        pattern = re.sub("#+", "*", output)
        made = list(folder.glob(pattern + "*" if pattern.endswith("/") else pattern))
        assert made, f"{shlex.join(words)} wrote no {output}"
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
    commands = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        text = (source / "README.md").read_text(encoding="utf-8")
        lists = [json.loads("\n".join(lines)) for language, lines in blocks(text) if language == "json"]
        for each in lists:
            if each.get("format") == "fumage-jobs":
                write_jobs(each, cli, folder)
        for language, lines in blocks(text):
            for line in lines if language in ("", "sh", "bash") else []:
                words = shlex.split(re.sub(r"\s# .*", "", line))
                if words:
                    print(f"{line}\n    {check_command(words, source, cli, folder)}")
                    commands += 1
    assert commands > 10, "the README has no commands"


if __name__ == "__main__":
    main()
