#!/usr/bin/env python3
"""Reads what names look like in several languages with the languages' own readers.

usage: read_names.py <folder>
In the folder each file LANGUAGE.txt has one name a line, as it stands between quotes. For each, LANGUAGE.hex is written with what its reader makes of
it, in hexadecimal UTF-8, one a line; for readers that are not on this machine there is none.
"""
import ast
import html.parser
import json
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

CSHARP = """class Names {
    static void Main() {
        foreach (string name in new string[] {
NAMES
        }) System.Console.WriteLine(System.BitConverter.ToString(System.Text.Encoding.UTF8.GetBytes(name)).Replace("-", "").ToLower());
    }
}
"""


class Text(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.text = ""

    def handle_starttag(self, tag, attributes):
        raise ValueError(tag)

    handle_endtag = handle_comment = handle_decl = handle_pi = unknown_decl = handle_starttag

    def handle_data(self, data):
        self.text += data


def html_text(line):
    reader = Text()
    reader.feed(line)
    reader.close()
    return reader.text


def xml_text(line):
    root = xml.fromstring(f'<a b="{line}">{line}</a>')
    assert len(root) == 0 and root.text == root.get("b")
    return root.text


def in_csharp(folder, lines):
    source = folder / "names.cs"
    source.write_text(CSHARP.replace("NAMES", ",\n".join(f'"{line}"' for line in lines)), encoding="utf-8")
    subprocess.run(["mcs", "-out:" + str(folder / "names.exe"), source], check=True, capture_output=True)
    return subprocess.run(["mono", folder / "names.exe"], check=True, capture_output=True, text=True).stdout.split("\n")[:-1]


def in_javascript(folder, lines):
    source = folder / "names.js"
    literals = ",\n".join(f'"{line}"' for line in lines)
    source.write_text(f'"use strict";\nfor (const name of [\n{literals}\n]) console.log(Buffer.from(name).toString("hex"));\n', encoding="utf-8")
    return subprocess.run(["node", source], check=True, capture_output=True, text=True).stdout.split("\n")[:-1]


def in_bash(folder, lines):
    source = folder / "names.sh"
    source.write_bytes(b"".join(b"printf '%s\\0' " + line.encode() + b"\n" for line in lines))
    subprocess.run(["bash", "-n", source], check=True)
    return [name.hex() for name in subprocess.run(["bash", source], check=True, capture_output=True).stdout.split(b"\0")[:-1]]


def each(reader):
    return lambda folder, lines: [reader(line).encode().hex() for line in lines]


READERS = {
    "python": each(lambda line: ast.literal_eval(f'"{line}"')),
    "godot": each(lambda line: ast.literal_eval(f'"{line}"')), # it has no other escapes than Python's
    "protobuf": each(lambda line: ast.literal_eval(f'b"{line}"').decode()), # the same, of bytes
    "json": each(lambda line: json.loads(f'"{line}"')),
    "xml": each(xml_text),
    "html": each(html_text),
    "shell": in_bash,
    "csharp": in_csharp if shutil.which("mcs") and shutil.which("mono") else None,
    "javascript": in_javascript if shutil.which("node") else None,
}


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, reader in READERS.items():
        lines = (folder / f"{name}.txt").read_bytes().decode().split("\n")[:-1]
        if reader:
            (folder / f"{name}.hex").write_text("".join(line + "\n" for line in reader(folder, lines)))


if __name__ == "__main__":
    main()
