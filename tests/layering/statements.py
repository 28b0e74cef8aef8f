#!/usr/bin/env python3
"""Prints C++ sources statement by statement, "file:line:statement": what is wrapped stands on one line, and literals beside each other are one.

usage: statements.py <folder>...
For checks that grep.
"""
import pathlib
import re
import sys


def statements(text):
    """(line, statement) of a source; comments of a whole line are left out."""
    begin, parts = 1, []
    for number, line in enumerate(text.splitlines(), 1):
        stripped = line.strip()
        if stripped.startswith(("//", "#")) or not stripped:
            if stripped.startswith("#"):
                yield number, stripped
            continue
        if not parts:
            begin = number
        parts.append(stripped)
        if stripped.endswith((";", "{", "}", ":", ",")) and balanced(parts):
            yield begin, joined(parts)
            parts = []
    if parts:
        yield begin, joined(parts)


def balanced(parts):
    bare = re.sub(r'"(?:[^"\\]|\\.)*"', "", " ".join(parts))
    return bare.count("(") <= bare.count(")") or bare.endswith("{")


def joined(parts):
    text = " ".join(parts)
    text = re.sub(r'(?<!\\)" "', "", text)
    return re.sub(r"\( ", "(", text)


def main():
    for folder in sys.argv[1:]:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                for line, statement in statements(path.read_text(encoding="utf-8")):
                    print(f"{path}:{line}:{statement}")


if __name__ == "__main__":
    main()
