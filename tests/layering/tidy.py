#!/usr/bin/env python3
"""clang-tidy over the sources named on the command line, but for those that were clean before with the same contents.

usage: tidy.py <folder with compile_commands.json> <source>...
What is clean is remembered under $XDG_CACHE_HOME/fumage-lint (~/.cache/fumage-lint), by the contents of a source and of all that it includes,
its flags, .clang-tidy and the version of clang-tidy; a month after its last use it is forgotten.
"""
import concurrent.futures
import functools
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys
import time

TIDY = "clang-tidy-14"
COMPILER = "clang++-14"
MONTH = 30 * 24 * 3600
# Of a compile command: what takes an argument, and is of the output and not of the source.
OUTPUT_WITH_VALUE = {"-o", "-MF", "-MT", "-MQ"}
OUTPUT = {"-c", "-MD", "-MMD", "-MP"}


@functools.lru_cache(maxsize=None)
def contents(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).digest()


def flags(entry):
    words = iter(shlex.split(entry["command"])[1:])
    kept = []
    for word in words:
        if word in OUTPUT_WITH_VALUE:
            next(words)
        elif word not in OUTPUT and word != entry["file"]:
            kept.append(word)
    return kept


def included(entry):
    """A source and all that it includes, or nothing where that cannot be found out: clang-tidy says why."""
    command = [COMPILER, "-w", "-Wno-unknown-warning-option", *flags(entry), "-M", "-MT", "x", entry["file"]]
    run = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True, check=False)
    return shlex.split(run.stdout.replace("\\\n", " "))[1:] if run.returncode == 0 else []


def key(entry, root, common):
    files = included(entry)
    if not files:
        return None
    digest = hashlib.sha256(common)
    # Where the tree lies is no part of it: a fresh clone knows what is clean.
    digest.update("\0".join(flags(entry)).replace(str(root), "").encode())
    for file in sorted(files):
        path = os.path.join(entry["directory"], file)
        digest.update(os.path.normpath(path).replace(str(root), "").encode())
        digest.update(contents(path))
    return digest.hexdigest()


def check(source, entry, root, build, common, memory):
    """What clang-tidy says, or None where the source is clean. One that this build leaves out has no entry, and is always looked at."""
    name = key(entry, root, common) if entry else None
    if name is not None and (memory / name).exists():
        (memory / name).touch()
        return None
    command = [TIDY, "-p", str(build), "--quiet", "--extra-arg=-Wno-unknown-warning-option", source]
    run = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return run.stdout + run.stderr
    if name is not None:
        (memory / name).touch()
    return None


def main():
    root = pathlib.Path.cwd()
    build = root / sys.argv[1]
    sources = [str(root / source) for source in sys.argv[2:]]
    entries = {entry["file"]: entry for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))}
    memory = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "fumage-lint"
    memory.mkdir(parents=True, exist_ok=True)
    for old in memory.iterdir():
        if old.stat().st_mtime < time.time() - MONTH:
            old.unlink()
    version = subprocess.run([TIDY, "--version"], capture_output=True, check=True).stdout
    common = version + (root / ".clang-tidy").read_bytes()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        said = [text for text in pool.map(lambda source: check(source, entries.get(source), root, build, common, memory), sources) if text]
    for text in said:
        print(text)
    print(f"clang-tidy: {len(sources)} sources, {len(said)} with something to mend")
    return 1 if said else 0


if __name__ == "__main__":
    sys.exit(main())
