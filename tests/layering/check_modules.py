#!/usr/bin/env python3
"""Looks for circles of modules: a header and its source, with the halves for each system, are one; so are all that include each other in a ring.

usage: check_modules.py [folder of the source tree]
"""
import pathlib
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s+"((?:core|ui|app)/[^"]+)"', re.MULTILINE)


def module_of(path):
    stem = re.sub(r"(_posix|_windows|-inl)?\.(h|cpp)$", "", str(path))
    return stem


def graph_of(root):
    graph = {}
    for room in ("core", "ui", "app"):
        for path in sorted((root / room).rglob("*")):
            if path.suffix in (".h", ".cpp"):
                here = module_of(path.relative_to(root))
                included = INCLUDE.findall(path.read_text(encoding="utf-8"))
                graph.setdefault(here, set()).update(module_of(each) for each in included)
    return {here: {there for there in included if there != here and there in graph} for here, included in graph.items()}


def circles_of(graph):
    """Tarjan's strongly connected components of more than one module."""
    number, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(here):
        number[here] = low[here] = len(number)
        stack.append(here)
        on_stack.add(here)
        for there in sorted(graph[here]):
            if there not in number:
                visit(there)
                low[here] = min(low[here], low[there])
            elif there in on_stack:
                low[here] = min(low[here], number[there])
        if low[here] == number[here]:
            circle = []
            while circle[-1:] != [here]:
                circle.append(stack.pop())
                on_stack.remove(circle[-1])
            if len(circle) > 1:
                found.append(sorted(circle))

    sys.setrecursionlimit(10000)
    for here in sorted(graph):
        if here not in number:
            visit(here)
    return found


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    graph = graph_of(root)
    circles = circles_of(graph)
    for circle in circles:
        inside = set(circle)
        print("a circle of modules:")
        for here in circle:
            print(f"  {here} includes {', '.join(sorted(graph[here] & inside))}")
    print(f"{len(graph)} modules, {len(circles)} circles")
    return 1 if circles else 0


if __name__ == "__main__":
    sys.exit(main())
