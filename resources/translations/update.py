#!/usr/bin/env python3
"""Brings the translation files up to date with the texts of the program: `./dev translations`.

Texts of the editor are found by lupdate; those of the parameter table, of the presets and of messages, which the core keeps in plain English, are read from there.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "core/effect/parameters"


def table_texts() -> list[str]:
    """Labels, search words, tips, sources, choices and headings of the parameters, as they stand in the source."""
    literal = r'"(?:[^"\\]|\\.)*"'
    rows, choices, headings = [], [], []
    for file in sorted(TABLE.glob("*.h")):
        source = file.read_text()
        rows += re.findall(rf"\.(?:label|synonyms|tip|source) =\s*({literal}(?:\s+{literal})*)", source)
        for names in re.findall(r"string_view, \d+> k\w+\{(.*?)\};", source):
            choices += re.findall(literal, names)
        headings += re.findall(rf"kGroup<\w+>\{{[^;]*, ({literal}),\s*Scope::\w+\}};", source)
    texts = ["".join(part[1:-1] for part in re.findall(literal, text)) for text in rows + choices + headings]
    return list(dict.fromkeys(texts))


def preset_texts() -> list[str]:
    """Names and descriptions of the built-in presets."""
    presets = [json.loads(file.read_text()) for file in sorted((ROOT / "resources/presets").glob("*.json"))]
    return [json.dumps(preset[member], ensure_ascii=False)[1:-1] for preset in presets for member in ("name", "description")]


def message_texts() -> list[str]:
    """What the core and the editor say by makeMessage(), wherever it comes to a user of the editor."""
    sources = [file for room in ("core", "ui") for ending in ("*.h", "*.cpp") for file in sorted((ROOT / room).rglob(ending))]
    literal = r'"(?:[^"\\]|\\.)*"'
    found = [text for file in sources for text in re.findall(rf"\bmakeMessage\(\s*({literal}(?:\s+{literal})*)", file.read_text())]
    texts = ["".join(part[1:-1] for part in re.findall(literal, text)) for text in found]
    return list(dict.fromkeys(texts))


def plain_contexts() -> list[str]:
    """Contexts that are names of their own and not of classes: the sources ask by them."""
    asked = r'\b(?:translate|QT_TRANSLATE_NOOP)\(\s*"(\w+)"|\bQ_DECLARE_TR_FUNCTIONS\((\w+)\)'
    sources = [file.read_text() for ending in ("*.h", "*.cpp") for file in (ROOT / "ui").rglob(ending)]
    return sorted({one or other for source in sources for one, other in re.findall(asked, source)})


def rename_contexts(path: pathlib.Path, qualified: bool) -> None:
    """Adds or takes away the namespace of classes: lupdate does not see nested namespaces, at run time they belong to the context."""
    text = path.read_text()
    text = text.replace("<name>fumage::ui::", "<name>")
    if qualified:
        text = re.sub(r"<name>(?!(?:%s)</name>)" % "|".join(plain_contexts()), "<name>fumage::ui::", text)
    path.write_text(text)


def main() -> None:
    lupdate = sys.argv[1]
    files = sorted((ROOT / "resources/translations").glob("*.ts"))
    for file in files:
        rename_contexts(file, qualified=False)
    with tempfile.TemporaryDirectory(dir=ROOT / "build") as folder:
        stub = pathlib.Path(folder) / "parameter_texts.cpp"
        texts = [("Parameters", text) for text in table_texts()] + [("Presets", text) for text in preset_texts()]
        texts += [("Messages", text) for text in message_texts()]
        stub.write_text("".join(f'QT_TRANSLATE_NOOP("{context}", "{text}");\n' for context, text in texts))
        subprocess.run([lupdate, str(ROOT / "ui"), str(stub), "-locations", "none", "-no-obsolete", "-ts", *map(str, files)], check=True)
    for file in files:
        rename_contexts(file, qualified=True)


if __name__ == "__main__":
    main()
