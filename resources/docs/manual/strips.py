#!/usr/bin/env python3
"""Renders a strip for each parameter of the manual: low, middle and high in three pictures of a named preset.

    strips.py <fumage-cli> [key or group]...

What is rendered says strips.json: `bases` are presets with a frame and the settings that all strips of them have, `groups` the base of each group of
parameters, `rows` one entry a parameter: its `values`, and a `base`, `frame`, `set`, `size` or `layer` of its own where the group's does not show it.
Choices and toggles have their values from the table of parameters. A row with a `reason` has no strip, and its page says why.

A strip whose neighbours differ by less than `difference` (the mean over pixels and channels, of 255) fails, with the row's name: it would show nothing.
"""
import hashlib
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
BACKGROUND = (74, 80, 88)  # mid-dark: smoke is brighter, soot darker
CHOICES = 4  # pictures of a strip at most
PICTURE = 128  # pixels an edge of what a strip shows
QUALITY = 80


def load_table():
    return json.loads((HERE / "strips.json").read_text(encoding="utf-8"))


def load_parameters(cli):
    """The rows of the program's table, in its order."""
    answer = subprocess.run([cli, "parameters", "--json"], check=True, capture_output=True, text=True)
    return json.loads(answer.stdout)


def text(value):
    """A value as --set takes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return value if isinstance(value, str) else json.dumps(value, separators=(",", ":"))


def values_of(parameter, row):
    if "values" in row:
        return row["values"]
    if "choices" in parameter:
        return parameter["choices"][:CHOICES]
    if isinstance(parameter["default"], bool):
        return [False, True]
    raise SystemExit(f"strips.json: {parameter['key']} has no values")


class Strip:
    """What one parameter's strip shows, and the commands that render it."""

    def __init__(self, table, parameter):
        self.key = parameter["key"]
        if self.key not in table["rows"]:
            raise SystemExit(f"strips.json has no row of {self.key}: it needs values, or a reason why nothing can be seen")
        row = table["rows"][self.key]
        self.reason = row.get("reason")
        if self.reason:
            return
        base = table["bases"][row.get("base", table["groups"][parameter["group"]])]
        self.preset = base["preset"]
        self.frame = row.get("frame", base.get("frame"))
        self.tile = base.get("tile", False)
        self.size = row.get("size", table["size"])
        self.layer = row.get("layer", base.get("layer"))
        self.settings = {**base.get("set", {}), **row.get("set", {})}
        self.values = values_of(parameter, row)

    def command(self, value, output):
        """The arguments of fumage-cli for one picture."""
        # A preset's layer is the one that is looked at; what all layers share has no layer.
        prefix = f"{self.layer}/" if self.layer else ""
        shared = ("air.", "wind.", "light.", "camera.", "timeline.", "output.")
        words = ["bake-noise", self.preset] if self.tile else ["render", self.preset, "--frame", str(self.frame)]
        if self.key not in ("output.width", "output.height"):
            words += ["--size", str(self.size)]
        for key, each in {**self.settings, self.key: value}.items():
            words += ["--set", f"{'' if '/' in key or key.startswith(shared) else prefix}{key}={text(each)}"]
        return words + ["--output", output]

    def mark(self):
        """What the picture was made of, in the picture: a strip of other commands, or of a preset that looks otherwise now, is stale."""
        looks = dict(line.split() for line in (ROOT / "tests/golden/golden.txt").read_text().splitlines())
        made_of = [looks[self.preset], *(shlex.join(self.command(value, "")) for value in self.values)]
        return hashlib.sha256("\n".join(made_of).encode()).hexdigest()[:16].encode()

    def shown_command(self):
        """As a page has it: of the middle picture."""
        return shlex.join(["build/bin/fumage-cli", *self.command(self.values[len(self.values) // 2], "picture.png")])


def picture(path):
    """What was rendered, on the background, in a square of the strip."""
    from PIL import Image
    seen = Image.open(path).convert("RGBA")
    scale = PICTURE / max(seen.size)
    # Pixels of small pictures are shown as they are.
    way = Image.Resampling.NEAREST if scale > 1 else Image.Resampling.BOX
    seen = seen.resize((max(1, round(seen.width * scale)), max(1, round(seen.height * scale))), way)
    square = Image.new("RGBA", (PICTURE, PICTURE), (*BACKGROUND, 255))
    square.alpha_composite(seen, ((PICTURE - seen.width) // 2, (PICTURE - seen.height) // 2))
    return square.convert("RGB")


def difference(one, other):
    """Mean absolute difference over pixels and channels, of 255."""
    from PIL import ImageChops, ImageStat
    return sum(ImageStat.Stat(ImageChops.difference(one, other)).mean) / 3


def render(cli, strip, folder):
    """The strip as one picture, and how much its neighbours differ at least."""
    from PIL import Image
    seen = []
    for number, value in enumerate(strip.values):
        path = f"{folder}/{number}.png"
        done = subprocess.run([cli, "--quiet", *strip.command(value, path)], cwd=ROOT, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(f"{strip.key} = {text(value)}: {done.stderr.strip()}")
        seen.append(picture(path))
    whole = Image.new("RGB", (PICTURE * len(seen), PICTURE))
    for number, each in enumerate(seen):
        whole.paste(each, (PICTURE * number, 0))
    return whole, min(difference(a, b) for a, b in zip(seen, seen[1:]))


def make(cli, table, parameters, target):
    """Renders the strips of these parameters into a folder; what is wrong with them, a line each."""
    faults = []
    target.mkdir(exist_ok=True)
    for parameter in parameters:
        strip = Strip(table, parameter)
        path = target / f"{strip.key}.jpg"
        if strip.reason:
            path.unlink(missing_ok=True)
            continue
        try:
            with tempfile.TemporaryDirectory() as folder:
                whole, least = render(cli, strip, folder)
        except RuntimeError as error:
            faults.append(str(error))
            continue
        print(f"{strip.key:32} {least:6.2f}", flush=True)
        if least < table["difference"]:
            faults.append(f"{strip.key}: its pictures differ by {least:.2f} of 255, less than {table['difference']}: it shows nothing")
        whole.save(path, quality=QUALITY, optimize=True, comment=strip.mark())
    return faults


def main():
    cli = str(pathlib.Path(sys.argv[1]).resolve())
    table, parameters = load_table(), load_parameters(cli)
    known = {parameter["key"] for parameter in parameters}
    faults = [f"strips.json has a row of {key}, which is no parameter" for key in table["rows"] if key not in known]
    if len(sys.argv) > 2:
        parameters = [each for each in parameters if each["key"] in sys.argv[2:] or each["group"] in sys.argv[2:]]
    faults += make(cli, table, parameters, HERE / "strips")
    for old in (HERE / "strips").glob("*.jpg"):
        if old.stem not in known:
            old.unlink()
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
