#!/usr/bin/env python3
"""Writes the manual as one folder of HTML that works without a server: navigation, a search box, one stylesheet.  html_folder.py <folder>

Pages that the manual links to beside itself (resources/docs, resources/parameters.md) come along in reference/; what lies elsewhere in the repository
becomes plain text. Needs python3-markdown.
"""
import html
import json
import os
import pathlib
import re
import shutil
import sys

import markdown

HERE = pathlib.Path(__file__).resolve().parent
RESOURCES = HERE.parents[1]
CHAPTERS = ("README.md", "first-ten-minutes.md", "recipes.md", "exporting-to-engines.md", "layers.md", "key-frames.md", "parameters/README.md",
            "presets.md", "thesis.md", "troubleshooting.md")

STYLE = """
:root { color-scheme: light dark; --back: #fff; --text: #1c2128; --dim: #59636e; --line: #d1d9e0; --code: #f0f2f5; --link: #0a5fb4; }
@media (prefers-color-scheme: dark) { :root { --back: #16191d; --text: #dde3ea; --dim: #94a0ad; --line: #333b44; --code: #22272e; --link: #6cb2ff; } }
body { margin: 0; display: flex; font: 16px/1.5 sans-serif; color: var(--text); background: var(--back); }
nav { position: sticky; top: 0; box-sizing: border-box; width: 17rem; height: 100vh; padding: 1rem; overflow: auto; flex: none;
  border-right: 1px solid var(--line); font-size: 0.9rem; }
nav ul { list-style: none; margin: 0.3rem 0; padding-left: 0.7rem; }
nav input { box-sizing: border-box; width: 100%; padding: 0.4rem; font: inherit; }
nav .here { font-weight: bold; }
#found p { margin: 0 0 0.5rem; color: var(--dim); }
main { max-width: 46rem; min-width: 0; padding: 1rem 2rem 6rem; }
a { color: var(--link); }
img { max-width: 100%; }
table { border-collapse: collapse; display: block; overflow: auto; }
td, th { padding: 0.3rem 0.6rem; border: 1px solid var(--line); vertical-align: top; text-align: left; }
code { background: var(--code); padding: 0.1em 0.3em; font-size: 0.9em; }
pre { background: var(--code); padding: 0.7rem; overflow: auto; }
pre code { padding: 0; }
blockquote { margin-left: 0; padding-left: 1rem; border-left: 3px solid var(--line); color: var(--dim); }
@media (max-width: 50rem) { body { display: block; } nav { position: static; width: auto; height: auto; border: 0; } }
"""

SEARCH = """
'use strict';
// Sections in which all words occur, those of a parameter whose key is a word first, then those with a word in their heading. What is found is shown as text, never as markup.
const box = document.getElementById('search');
const found = document.getElementById('found');
const root = box.dataset.root;
function score(section, words) {
  const title = section.title.toLowerCase(), text = section.text.toLowerCase();
  let sum = 0;
  for (const word of words) {
    if (section.url.endsWith('#' + word)) sum += 100;
    else if (title.includes(word)) sum += 10;
    else if (text.includes(word)) sum += 1;
    else return 0;
  }
  return sum;
}
function show() {
  const words = box.value.toLowerCase().split(/\\s+/).filter(Boolean);
  found.replaceChildren();
  if (!words.length) return;
  const hits = sections.map(section => [score(section, words), section]).filter(hit => hit[0]).sort((a, b) => b[0] - a[0]);
  for (const [, section] of hits.slice(0, 30)) {
    const link = document.createElement('a');
    link.href = root + section.url;
    link.textContent = section.title;
    const where = document.createElement('p');
    where.append(link, ' ' + section.page);
    found.append(where);
  }
  if (!hits.length) found.textContent = 'Nothing. Try a part of a word, or another word.';
}
box.addEventListener('input', show);
"""

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} - Fumage</title>
<link rel="stylesheet" href="{root}manual.css">
</head>
<body>
<nav>
<input id="search" type="search" placeholder="Search" aria-label="Search the manual" data-root="{root}">
<div id="found"></div>
{navigation}
</nav>
<main>
{body}
</main>
<script src="{root}sections.js"></script>
<script src="{root}search.js"></script>
</body>
</html>
"""


def slug(heading, separator="-"):
    """The anchor of a heading, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)


def title_of(path):
    return re.search(r"^# (.*)$", path.read_text(encoding="utf-8"), re.M)[1]


def place(path):
    """Where a page or picture goes in the folder; none for what stays behind."""
    if HERE in path.parents:
        inside = path.relative_to(HERE).as_posix()
    elif path.suffix == ".md" and (path.parent == RESOURCES / "docs" or path == RESOURCES / "parameters.md"):
        inside = f"reference/{path.name}"
    elif path.suffix in (".png", ".jpg", ".gif") and path.parent == RESOURCES / "pictures":
        inside = f"pictures/{path.name}"
    else:
        return None
    return re.sub(r"\.md$", ".html", re.sub(r"README\.md$", "index.md", inside))


class Folder:
    """What is written, and what is still to be."""

    def __init__(self, target):
        self.target = target
        self.waiting = [HERE / chapter for chapter in CHAPTERS]
        self.done = set()
        self.sections = []

    def link(self, page, match):
        """The same attribute, of a page of the folder. What it names is written or copied."""
        attribute, address = match[1], html.unescape(match[2])
        if re.match(r"[a-z]+:|#", address):
            return match[0]
        name, _, anchor = address.partition("#")
        other = pathlib.Path(os.path.normpath(page.parent / name))
        there = place(other)
        if not there or not other.exists():
            return 'class="elsewhere"'
        if other.suffix == ".md":
            self.waiting.append(other)
        else:
            (self.target / there).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(other, self.target / there)
        way = os.path.relpath(there, pathlib.PurePosixPath(place(page)).parent)
        return f'{attribute}="{html.escape(way + ("#" + anchor if anchor else ""))}"'

    def index(self, page, title, body):
        """A section a heading, for the search."""
        parts = re.split(r'<h([1-4]) id="([^"]*)">(.*?)</h\1>', body, flags=re.S)
        for at in range(1, len(parts), 4):
            own = re.search(r'<a id="([^"]+)">', parts[at + 2])
            words = html.unescape(re.sub(r"<[^>]*>", " ", parts[at + 3]))
            self.sections.append({"title": html.unescape(re.sub(r"<[^>]*>", "", parts[at + 2])), "page": title,
                                  "url": f"{place(page)}#{own[1] if own else parts[at + 1]}",
                                  "text": " ".join([own[1] if own else "", *words.split()])})

    def navigation(self, page):
        def entry(path):
            way = os.path.relpath(place(path), pathlib.PurePosixPath(place(page)).parent)
            here = ' class="here"' if path == page else ""
            return f'<a href="{html.escape(way)}"{here}>{html.escape(title_of(path))}</a>'
        lines = []
        for chapter in CHAPTERS:
            lines.append(f"<li>{entry(HERE / chapter)}")
            if chapter == "parameters/README.md":
                groups = [HERE / "parameters" / name for name in re.findall(r"^## \[.*\]\((.*)\)$", (HERE / chapter).read_text(encoding="utf-8"), re.M)]
                lines.append("<ul>" + "".join(f"<li>{entry(group)}</li>" for group in groups) + "</ul>")
            lines.append("</li>")
        return "<ul>\n" + "\n".join(lines) + "\n</ul>"

    def write(self, page):
        text = page.read_text(encoding="utf-8")
        body = markdown.markdown(text, extensions=["tables", "fenced_code", "toc"], extension_configs={"toc": {"slugify": slug}})
        body = re.sub(r'(href|src)="([^"]*)"', lambda match: self.link(page, match), body)
        title = title_of(page)
        self.index(page, title, body)
        here = self.target / place(page)
        here.parent.mkdir(parents=True, exist_ok=True)
        root = "../" * (len(pathlib.PurePosixPath(place(page)).parts) - 1)
        here.write_text(PAGE.format(title=html.escape(title), root=root, navigation=self.navigation(page), body=body), encoding="utf-8")

    def write_all(self):
        while self.waiting:
            page = self.waiting.pop(0)
            if page not in self.done:
                self.done.add(page)
                self.write(page)
        (self.target / "manual.css").write_text(STYLE.lstrip(), encoding="utf-8")
        (self.target / "search.js").write_text(SEARCH.lstrip(), encoding="utf-8")
        (self.target / "sections.js").write_text("const sections = " + json.dumps(self.sections, indent=0) + ";\n", encoding="utf-8")


def main():
    target = pathlib.Path(sys.argv[1])
    # Only what this program wrote goes: a folder of somebody else's is left as it is.
    if target.exists() and any(target.iterdir()):
        if not (target / "sections.js").exists():
            sys.exit(f"{target} is not empty, and not a manual")
        shutil.rmtree(target)
    target.mkdir(parents=True, exist_ok=True)
    Folder(target).write_all()
    print(f"{target}/index.html")


if __name__ == "__main__":
    main()
