#!/usr/bin/env python3
"""Measures functions and files of core, ui and app, and fails where one has grown too long to be seen whole.

usage: function_lengths.py [folder of the source tree]
Needs universal ctags, which knows where a function ends.
"""
import json
import pathlib
import statistics
import subprocess
import sys

LONGEST_FILE = 400
LONGEST_FUNCTION = 60
LONGEST_99TH = 50  # percentile

# A table is one statement, however long: dividing it would not make it plainer.
FLAT_TABLES = {"core/effect/parameter_table.cpp", "ui/shell/action_table.cpp"}


def is_kernel(path):
    """Compiled once for every instruction set; the passes of such a file keep their state in registers and are one piece."""
    return path.name.endswith("-inl.h") or "HWY_TARGET_INCLUDE" in path.read_text(encoding="utf-8")


def functions(root, files):
    """(file, name, lines) of every function with a body."""
    command = ["ctags", "--output-format=json", "--language-force=C++", "--kinds-C++=f", "--fields=+neS", "-I", "HWY_ATTR,HWY_INLINE,HWY_API", "-f", "-", *map(str, files)]
    for line in subprocess.run(command, cwd=root, check=True, capture_output=True, text=True).stdout.splitlines():
        tag = json.loads(line)
        if "end" in tag:
            yield tag["path"], tag["name"], tag["end"] - tag["line"] + 1


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    failures = []
    files = {path.relative_to(root) for room in ("core", "ui", "app") for ending in ("*.h", "*.cpp") for path in (root / room).rglob(ending)}
    long_files = {str(file): lines for file in sorted(files) if (lines := len((root / file).read_text(encoding="utf-8").splitlines())) > LONGEST_FILE}
    for file, lines in long_files.items():
        if file not in FLAT_TABLES:
            failures.append(f"{file} has {lines} lines (at most {LONGEST_FILE})")

    kernels = {str(file) for file in files if is_kernel(root / file)}
    long_functions = {}
    print(f"{'':6}{'functions':>10}{'median':>8}{'99th':>6}{'longest':>9}")
    for room in ("core", "ui", "app"):
        found = list(functions(root, sorted(file for file in files if file.parts[0] == room)))
        plain = [each for each in found if each[0] not in kernels]
        lengths = [lines for _, _, lines in plain]
        file, name, longest = max(plain, key=lambda each: each[2])
        print(f"{room:6}{len(lengths):>10}{statistics.median(lengths):>8g}{percentile(lengths, 0.99):>6}{longest:>9}  {name} in {file}")
        if (high := percentile(lengths, 0.99)) > LONGEST_99TH:
            failures.append(f"{room}: the 99th percentile of its functions is {high} lines (at most {LONGEST_99TH})")
        long_functions |= {f"{file}:{name}": lines for file, name, lines in plain if lines > LONGEST_FUNCTION}
        if room == "core":
            _, name, longest = max((each for each in found if each[0] in kernels), key=lambda each: each[2])
            print(f"      longest in a kernel: {longest}, {name}")
    failures += [f"{name} has {lines} lines (at most {LONGEST_FUNCTION})" for name, lines in long_functions.items()]
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
