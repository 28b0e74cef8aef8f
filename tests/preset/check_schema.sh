#!/usr/bin/env bash
# Holds every built-in preset against the printed JSON Schema with an independent validator, and checks that the schema refuses what it should.
set -euo pipefail
cli=$1
presets=$2
schema=$(mktemp)
trap 'rm -f "$schema"' EXIT
"$cli" schema > "$schema"
/usr/bin/python3 - "$schema" "$presets"/*.json <<'PYTHON'
import copy, json, sys
from jsonschema import Draft202012Validator, ValidationError

schema = json.load(open(sys.argv[1]))
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
for path in sys.argv[2:]:
    preset = json.load(open(path))
    validator.validate(preset)
def owner(preset, group):
    return preset["scene"] if group in ("wind", "light") else preset["layers"][0]


wrong = [("wind", "strength", "fast"), ("motion", "randomness", 2), ("emitter", "normal", [0, 1]), ("emitter", "shape", "cube"), ("emitter", "count", 1.5), ("life", "size", [])]
for group, name, value in wrong:
    broken = copy.deepcopy(preset)
    owner(broken, group)[group][name] = value
    if validator.is_valid(broken):
        sys.exit(f"the schema accepts {group}.{name} = {value}")
for path in (("scene", "wind", "strngth"), ("scene", "wnd"), ("layers", 0, "motion", "grvity"), ("layers", 0, "motoin"), ("scnee",),
        ("scene", "motion"), ("layers", 0, "wind")):
    broken = copy.deepcopy(preset)
    place = broken
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = {}
    if validator.is_valid(broken):
        sys.exit(f"the schema accepts the key {'.'.join(map(str, path))}")
validator.validate({"$schema": "preset.schema.json", **preset})
print(f"{len(sys.argv) - 2} presets are valid, {len(wrong)} broken ones are not")
PYTHON
