#!/usr/bin/env python3
"""Writes the pages of the manual that are made from the program's own table and presets: parameters/<group>.md and presets.md.

    pages.py <fumage-cli> [folder]        by default into the manual itself; elsewhere a test compares them
"""
import json
import pathlib
import re
import subprocess
import sys
import textwrap

from strips import HERE, Strip, load_parameters, load_table, text

WIDTH = 100
KEY_FRAMES = {"at each frame": "key frames are read at each frame", "at each step": "key frames are read at each step",
              "at birth": "key frames are read at the birth of a particle", "summed up": "key frames are a rate, summed up over time",
              "": "no key frames"}
LEFT_OUT = ("camera", "output", "timeline")  # groups that are not how a smoke is made
NOT_READ = ("rings.", "motion.buoyancy", "motion.cooling", "motion.pull")  # where the air carries the smoke


def wrapped(words, first="", others=""):
    """Prose as wide as the manual's. Links and code stay whole."""
    whole = re.sub(r"`[^`]*`|\[[^\]]*\]\([^)]*\)", lambda match: match[0].replace(" ", "\0"), words)
    lines = textwrap.wrap(whole, WIDTH, initial_indent=first, subsequent_indent=others, break_long_words=False, break_on_hyphens=False)
    return "\n".join(lines).replace("\0", " ")


class Table:
    """What `parameters --markdown` says beyond --json: the groups' names, defaults and ranges as people read them, and key frames."""

    def __init__(self, cli):
        answer = subprocess.run([cli, "parameters", "--markdown"], check=True, capture_output=True, text=True).stdout
        self.rows, self.groups = {}, {}
        label = ""
        for line in answer.splitlines():
            if line.startswith("## "):
                label = line[3:]
            row = re.match(r'\| <a id="([^"]+)"></a>`[^`]+` \| (.*?) \| (.*?) \| (.*?) \| (.*?) \| (.*) \|$', line)
            if row:
                self.rows[row[1]] = {"default": row[2], "range": row[3], "unit": row[4], "keys": row[5], "tip": row[6]}
                self.groups.setdefault(row[1].split(".")[0], label)


def strip_lines(strip):
    """The picture with its values and the command that made it, or why there is none."""
    if strip.reason:
        return [wrapped(f"No strip: {strip.reason}")]
    values = [f"`{text(value) or 'none'}`" for value in strip.values]
    if len(values) == 3 and all(type(value) in (int, float) for value in strip.values):
        values = [f"{place} {value}" for place, value in zip(("low", "middle", "high"), values)]
    where = f"the noise tile of `{strip.preset}`" if strip.tile else f"frame {strip.frame} of `{strip.preset}`"
    layer = f", layer {strip.layer}" if strip.layer else ""
    lines = [f"![{strip.key}](../strips/{strip.key}.jpg)", "", wrapped(f"From left to right: {', '.join(values)}. Of {where}{layer}:")]
    return lines + ["", "```", strip.shown_command(), "```"]


def parameter_section(strip, label, row):
    facts = [f"`{strip.key}`", f"default {row['default']}", f"range {row['range']}" + (f" {row['unit']}" if row["unit"] else "")]
    return [f'## <a id="{strip.key}"></a>{label}', "", wrapped(row["tip"]), "", *strip_lines(strip), "",
            wrapped("; ".join(facts) + f"; {KEY_FRAMES[row['keys']]}."), ""]


def write_parameters(cli, folder):
    strips_table, table, parameters = load_table(), Table(cli), load_parameters(cli)
    (folder / "parameters").mkdir(parents=True, exist_ok=True)
    index = ["# Parameters", "", "Written by `./dev manual`. Each parameter with what it does, and a strip: low, middle, high.", ""]
    for group, label in table.groups.items():
        page = [f"# {label}", "", "Written by `./dev manual`. [All groups](README.md)", ""]
        links = []
        for parameter in (each for each in parameters if each["group"] == group):
            key = parameter["key"]
            page += parameter_section(Strip(strips_table, parameter), parameter["label"], table.rows[key])
            links.append(f"[{parameter['label']}]({group}.md#{key})")
        (folder / "parameters" / f"{group}.md").write_text("\n".join(page).rstrip() + "\n", encoding="utf-8")
        index += [f"## [{label}]({group}.md)", "", wrapped(", ".join(links) + "."), ""]
    (folder / "parameters" / "README.md").write_text("\n".join(index).rstrip() + "\n", encoding="utf-8")


def differences(cli, name):
    """What `info` says differs from a new document: (layer or none, key, value)."""
    answer = subprocess.run([cli, "info", name], check=True, capture_output=True, text=True).stdout
    layers = dict(re.findall(r"^layer (\d+) +(.*)$", answer, re.M))
    return layers, re.findall(r"^  (?:(\d+)/)?([a-z_]+\.[a-z_]+) = (.*)$", answer, re.M)


def preset_settings(table, labels, layers, found):
    """A line a layer and group: what is set there."""
    airy = (None, "air.enabled", "true") in found or ("", "air.enabled", "true") in found
    by_place = {}
    for layer, key, value in found:
        group, name = key.split(".")
        is_read = not key.startswith(NOT_READ) if airy else group != "air"
        if group in LEFT_OUT or name == "seed" or not is_read:
            continue
        shown = value if len(value) < 60 else "of its own"
        shown = re.sub(r"^\[.*\]", lambda match: f"`{match[0]}`", shown)
        by_place.setdefault((layer, group), []).append(f"{labels[key]} {shown}")
    lines, said = [], {}
    for layer in sorted({place[0] for place in by_place}, key=lambda each: int(each or 0)):
        lines += ["", f"Layer {layer}, {layers[layer]}:" if layer else "What all layers share:" if layers else "What it sets:", ""]
        same = {}
        for group in (place[1] for place in by_place if place[0] == layer):
            link, what = f"[{table.groups[group]}](parameters/{group}.md)", ", ".join(by_place[layer, group])
            first = said.setdefault((group, what), layer)
            if first == layer:
                lines.append(wrapped(f"{link}: {what}.", "- ", "  "))
            else:
                same.setdefault(first, []).append(link)
        lines += [wrapped(f"{', '.join(links)}: as layer {first}.", "- ", "  ") for first, links in same.items()]
    return lines


def write_presets(cli, folder):
    table = Table(cli)
    labels = {parameter["key"]: parameter["label"] for parameter in load_parameters(cli)}
    notes = json.loads((HERE / "preset_notes.json").read_text(encoding="utf-8"))
    built_in = {path.stem for path in (HERE.parents[1] / "presets").glob("*.json")}
    if built_in != set(notes):
        raise SystemExit(f"preset_notes.json does not tell of each preset: {', '.join(sorted(built_in ^ set(notes)))}")
    page = ["# How the built-in presets are made", "",
            wrapped("Written by `./dev manual`. Each preset with how it works, and what it sets that a new document does not have. "
                    "[The built-in presets](../presets.md) shows all of them side by side; open one, and change what you read here. Seeds, camera, "
                    "timeline and output are left out."), ""]
    for name in sorted(notes):
        layers, found = differences(cli, name)
        page += [f"## {name}", "", f"![{name}](../../pictures/{name}.png)", "", wrapped(notes[name]), ""]
        page += [*preset_settings(table, labels, layers, found)[1:], ""]
    (folder / "presets.md").write_text("\n".join(page).rstrip() + "\n", encoding="utf-8")


def main():
    cli = str(pathlib.Path(sys.argv[1]).resolve())
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else HERE
    write_parameters(cli, folder)
    write_presets(cli, folder)


if __name__ == "__main__":
    main()
