#!/usr/bin/env python3
"""Holds the manual against the program:  check_pages.py <source tree> <fumage-cli>

Every link, anchor and picture of its pages is there; every command of its blocks runs, smaller, in a folder that was empty; what a comment
`<!-- check: command => text -->` claims, the command prints; the pages that are written by ./dev manual are as it would write them; every parameter has
its section with a strip that shows something, or with the reason why there is none; every built-in preset is told of; and the folder of HTML has the
same links.
"""
import html
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import urllib.parse

import check_readme

LONGEST, ROW = 2000, 260  # lines of a page, columns of a row of a table
STRIPS = 1500000  # bytes of all strips
PICTURE = 128  # pixels an edge of what a strip shows
SHOWS = 0.4  # of 255, as strips.json has it
SAMPLE = 6  # one of so many commands of strips runs: all of them ran when the strips were made
DERIVED = {"life.fade_rate": "lifetime"}  # rows that are shown under two names


def without_code(text):
    """The page without what is between fences and in code, in which brackets are no links."""
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


def slug(heading):
    """As GitHub makes an anchor of a heading."""
    words = re.sub(r"<[^>]*>|\]\([^)]*\)", "", heading)
    return re.sub(r"[^\w\- ]", "", words.strip().lower()).replace(" ", "-")


def anchors(path, known={}):
    if path not in known:
        text = path.read_text(encoding="utf-8")
        known[path] = set(re.findall(r'<a id="([^"]+)">', text)) | {slug(each) for each in re.findall(r"^#+ (.*)$", without_code(text), re.M)}
    return known[path]


def check_links(manual, pages, labels):
    """Every link leads to a file and an anchor that are there, every page is led to, and one to a parameter is named as the editor names it."""
    reached = {manual / "README.md"}
    for page in pages:
        for words, address in re.findall(r"\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)]+)\)", without_code(page.read_text(encoding="utf-8"))):
            if address.startswith("https:"):
                continue
            name, _, anchor = address.partition("#")
            there = pathlib.Path(os.path.normpath(page.parent / name)) if name else page
            assert there.is_file(), f"{page}: there is no {address}"
            assert not anchor or anchor in anchors(there), f"{page}: {there.name} has no {anchor}"
            if anchor in labels and there.parent.name == "parameters":
                allowed = {labels[anchor].lower(), DERIVED.get(anchor), anchor}
                assert words.lower() in allowed, f"{page}: {anchor} is called {labels[anchor]} in the editor, not {words}"
            reached.add(there)
        for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text(encoding="utf-8")):
            assert (page.parent / picture).stat().st_size > 0, f"{page}: {picture} is empty"
    assert not set(pages) - reached, f"no page links to {sorted(map(str, set(pages) - reached))}"


def check_shape(pages):
    for page in pages:
        text = re.sub(r"^<!-- check: .* -->$", "", page.read_text(encoding="utf-8"), flags=re.M)
        faults = check_readme.shape_faults(text, LONGEST, ROW)
        assert not faults, f"{page}: {'; '.join(faults)}"


def check_written(manual, cli, folder):
    """The pages that are written by a program are as it writes them now."""
    subprocess.run([sys.executable, "-B", str(manual / "pages.py"), cli, str(folder)], check=True)
    for path in sorted(folder.rglob("*.md")):
        ours = manual / path.relative_to(folder)
        assert ours.exists() and ours.read_bytes() == path.read_bytes(), f"{ours} is not as it would be written now: ./dev manual pages"
    assert {each.name for each in (folder / "parameters").iterdir()} == {each.name for each in (manual / "parameters").iterdir()}


def check_parameters(manual, parameters, strips):
    """Each row has its section, with its strip or the reason why there is none."""
    table = strips.load_table()
    assert set(table["rows"]) == {each["key"] for each in parameters}, "strips.json has rows of other parameters"
    assert table["difference"] == SHOWS
    for each in parameters:
        page = (manual / "parameters" / f"{each['group']}.md").read_text(encoding="utf-8")
        section = re.search(rf'^## <a id="{re.escape(each["key"])}"></a>.*?(?=^## |\Z)', page, re.M | re.S)
        assert section, f"{each['key']} has no section"
        reason = table["rows"][each["key"]].get("reason")
        expected = f"No strip: {reason.split()[0]}" if reason else f"](../strips/{each['key']}.jpg)"
        assert expected in section[0], f"the section of {each['key']} has neither strip nor reason"


def check_strips(manual, parameters, strips):
    """The strips are those of the table, small, and each shows a difference."""
    from PIL import Image
    table = strips.load_table()
    wanted = {}
    for each in parameters:
        strip = strips.Strip(table, each)
        if not strip.reason:
            wanted[f"{strip.key}.jpg"] = strip
    files = list((manual / "strips").iterdir())
    assert {each.name for each in files} == set(wanted), f"strips and strips.json differ: {sorted({each.name for each in files} ^ set(wanted))}"
    assert sum(each.stat().st_size for each in files) < STRIPS, "the strips take too much room"
    for file in files:
        whole, strip = Image.open(file), wanted[file.name]
        assert whole.info.get("comment") == strip.mark(), f"{file.name} was made by other commands: ./dev manual {strip.key}"
        whole = whole.convert("RGB")
        assert whole.size == (PICTURE * len(strip.values), PICTURE), f"{file.name} has {whole.size} pixels"
        seen = [whole.crop((x, 0, x + PICTURE, PICTURE)) for x in range(0, whole.width, PICTURE)]
        assert all(strips.difference(a, b) > SHOWS / 2 for a, b in zip(seen, seen[1:])), f"{file.name} shows no difference"


def check_that_strips_fail(cli, parameters, strips, folder):
    """A strip that shows nothing fails by its name, and one that cannot be rendered does."""
    table = {"size": 16, "difference": SHOWS, "bases": {"small": {"preset": "thesis-2012", "frame": 20, "set": {"emitter.count": 300}}},
             "groups": {"look": "small"}, "rows": {"look.opacity": {"values": [1, 1]}, "look.size": {"values": [0.1, 2]}, "look.colour": {"values": ["no"]}}}
    chosen = {each["key"]: each for each in parameters if each["key"] in table["rows"]}
    assert strips.make(cli, table, [chosen["look.size"]], folder) == []
    assert (folder / "look.size.jpg").exists()
    for key in ("look.opacity", "look.colour"):
        faults = strips.make(cli, table, [chosen[key]], folder)
        assert len(faults) == 1 and faults[0].startswith(key), f"{key} should have failed: {faults}"


def check_presets(manual, source, cli):
    """Each built-in preset is told of, and numbers in what is told by hand are among those that it sets."""
    notes = json.loads((manual / "preset_notes.json").read_text(encoding="utf-8"))
    page = (manual / "presets.md").read_text(encoding="utf-8")
    for path in (source / "resources/presets").glob("*.json"):
        assert re.search(rf"^## {path.stem}$", page, re.M), f"presets.md does not tell of {path.stem}"
        answer = subprocess.run([cli, "info", path.stem], check=True, capture_output=True, text=True).stdout
        said = set(re.findall(r"[\d.]*\d", answer))
        strange = set(re.findall(r"(?<![-\w])[\d.]*\d", notes[path.stem])) - said - {"2012", "0"}
        assert not strange, f"preset_notes.json says {strange} of {path.stem}, which has no such number"


def check_claims(pages, cli, folder):
    """What comments claim that a command prints."""
    claims = 0
    for page in pages:
        for command, text in re.findall(r"<!-- check: (.*?) => (.*?) -->", page.read_text(encoding="utf-8")):
            words = shlex.split(command)
            assert words[0] == "build/bin/fumage-cli", f"{page}: {command} is no command of ours"
            done = subprocess.run([cli, *words[1:]], cwd=folder, capture_output=True, text=True)
            assert text in done.stdout + done.stderr, f"{page}: {command} does not say: {text}\nbut: {done.stdout[-500:]}{done.stderr[-500:]}"
            claims += 1
    assert claims > 5, "no claims are found: have their comments another form?"
    print(f"{claims} claims hold")


def check_commands(pages, source, cli, folder):
    """The commands of the blocks run; of those of the strips a sample."""
    (folder / "resources").symlink_to(source / "resources")
    done, of_strips = set(), 0
    for page in pages:
        for language, lines in check_readme.blocks(page.read_text(encoding="utf-8")):
            for line in lines if language in ("", "sh", "bash") else []:
                of_strips += page.parent.name == "parameters"
                words = shlex.split(line)
                if not words or line in done or page.parent.name == "parameters" and of_strips % SAMPLE:
                    continue
                print(f"{line}\n    {check_readme.check_command(words, source, cli, folder)}", flush=True)
                done.add(line)
    assert len(done) > 40, "the manual has no commands"


def check_html(manual, folder):
    """The folder of HTML: every link and picture of it is there, with its anchor; the search knows the pages."""
    try:
        import markdown as _
    except ImportError:
        print("no HTML: there is no python3-markdown")
        return
    subprocess.run([sys.executable, "-B", str(manual / "html_folder.py"), str(folder)], check=True)
    ids = {}
    for page in folder.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        ids[page] = set(re.findall(r'\bid="([^"]+)"', text))
        assert text.count("<script") == 2, f"{page} has scripts of its own"
    for page in ids:
        for address in re.findall(r'\b(?:href|src)="([^"]*)"', page.read_text(encoding="utf-8")):
            if address.startswith("https:"):
                continue
            name, _, anchor = html.unescape(urllib.parse.unquote(address)).partition("#")
            there = pathlib.Path(os.path.normpath(page.parent / name)) if name else page
            assert there.exists(), f"{page}: there is no {address}"
            assert not anchor or anchor in ids[there], f"{page}: {address} has no such anchor"
    sections = json.loads((folder / "sections.js").read_text(encoding="utf-8").removeprefix("const sections = ").rstrip(";\n"))
    for section in sections:
        name, _, anchor = section["url"].partition("#")
        assert anchor in ids[folder / name], f"the search leads to {section['url']}, which is not there"
    assert {section["url"].split("#")[0] for section in sections} == {each.relative_to(folder).as_posix() for each in ids}


def main():
    source, cli = pathlib.Path(sys.argv[1]).resolve(), str(pathlib.Path(sys.argv[2]).resolve())
    manual = source / "resources/docs/manual"
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(manual))
    import strips
    pages = sorted(manual.rglob("*.md"))
    parameters = strips.load_parameters(cli)
    check_shape(pages)
    check_links(manual, pages, {each["key"]: each["label"] for each in parameters})
    check_parameters(manual, parameters, strips)
    check_strips(manual, parameters, strips)
    check_presets(manual, source, cli)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for each in ("written", "claims", "commands", "strips"):
            (folder / each).mkdir()
        check_written(manual, cli, folder / "written")
        check_html(manual, folder / "html")
        check_that_strips_fail(cli, parameters, strips, folder / "strips")
        check_claims(pages, cli, folder / "claims")
        check_commands(pages, source, cli, folder / "commands")


if __name__ == "__main__":
    main()
