#!/usr/bin/env python3
"""Runs the Open Job Description template of `fumage-cli farm` as its specification says, as far as the template makes use of it.

usage: openjd_test.py <fumage-cli>
A reader of a subset of jobtemplate-2023-09 with TASK_CHUNKING: PATH, STRING and INT parameters with defaults, CHUNK[INT] ranges, format strings in
ranges, counts, commands and arguments, steps in the order of their dependencies, openjd_progress. Everything else in a template is refused, so
that nothing goes unread. Frames are run in tasks, in another order than they count; the folder has a name that has to be quoted.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SMALL = ["--size", "48", "--set", "emitter.count=500", "--set", "noise.slices=4", "--set", "noise.resolution=16"]


def only(node, *allowed):
    unknown = set(node) - set(allowed)
    assert not unknown, f"the reader does not know {unknown}"
    return node


def formatted(text, values):
    def value(match):
        return str(values[match.group(1)])

    return re.sub(r"\{\{\s*([\w.]+)\s*\}\}", value, str(text))


def parameters(template, folder, given):
    values = {}
    for each in template["parameterDefinitions"]:
        only(each, "name", "type", "objectType", "dataFlow", "default", "description", "minValue", "maxValue")
        assert re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]{0,63}", each["name"]), each["name"]
        value = given.get(each["name"], each.get("default"))
        if each["type"] == "PATH":
            assert each["objectType"] in ("FILE", "DIRECTORY") and each["dataFlow"] in ("NONE", "IN", "OUT", "INOUT"), each
            assert not pathlib.PurePath(each["default"]).is_absolute(), "defaults of paths are relative to the template"
            value = folder / value
        elif each["type"] == "INT":
            assert each.get("minValue", int(value)) <= int(value) <= each.get("maxValue", int(value)), each
        else:
            assert each["type"] == "STRING", each
        values["Param." + each["name"]] = value
    return values


def frames_of(text):
    frames = []
    for part in text.split(","):
        first, last, step = re.fullmatch(r"(\d+)(?:-(\d+)(?::(\d+))?)?", part.strip()).groups()
        frames += range(int(first), int(last or first) + 1, int(step or 1))
    return frames


def chunk_texts(definition, values):
    only(definition, "name", "type", "range", "chunks")
    chunks = only(definition["chunks"], "defaultTaskCount", "rangeConstraint")
    assert definition["type"] == "CHUNK[INT]"
    frames = frames_of(formatted(definition["range"], values))
    count = int(formatted(chunks["defaultTaskCount"], values))
    for at in range(0, len(frames), count):
        chunk = frames[at : at + count]
        step = chunk[1] - chunk[0] if len(chunk) > 1 else 1
        if chunks["rangeConstraint"] == "CONTIGUOUS":
            assert step == 1 and chunk == list(range(chunk[0], chunk[-1] + 1)), "a contiguous chunk has gaps"
            yield f"{chunk[0]}-{chunk[-1]}"
        else:
            assert chunks["rangeConstraint"] == "NONCONTIGUOUS"
            yield f"{chunk[0]}" if len(chunk) == 1 else f"{chunk[0]}-{chunk[-1]}" + (f":{step}" if step > 1 else "")


def run_action(action, values):
    only(action, "command", "args")
    command = [formatted(action["command"], values), *[formatted(each, values) for each in action["args"]]]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, (command, done.stdout)
    progress = [float(each) for each in re.findall(r"^openjd_progress: (.*)$", done.stdout, re.M)]
    assert all(0 <= each <= 100 for each in progress) and progress == sorted(progress), done.stdout
    return progress


def run_template(path, given):
    template = only(json.loads(path.read_text(encoding="utf-8")), "specificationVersion", "extensions", "name", "description", "parameterDefinitions", "steps")
    assert template["specificationVersion"] == "jobtemplate-2023-09" and template["extensions"] == ["TASK_CHUNKING"]
    assert 1 <= len(template["name"]) <= 128
    values = parameters(template, path.parent, given)
    done = set()
    tasks = 0
    for step in template["steps"]:
        only(step, "name", "parameterSpace", "script", "dependencies")
        assert all(each["dependsOn"] in done for each in step.get("dependencies", [])), "a step comes before what it depends on"
        action = only(only(only(step["script"], "actions")["actions"], "onRun")["onRun"], "command", "args")
        if "parameterSpace" in step:
            (definition,) = only(step["parameterSpace"], "taskParameterDefinitions")["taskParameterDefinitions"]
            for text in reversed(list(chunk_texts(definition, values))):
                progress = run_action(action, {**values, "Task.Param." + definition["name"]: text})
                assert progress and progress[-1] == 100, (text, progress)
                tasks += 1
        else:
            run_action(action, values)
        done.add(step["name"])
    return tasks


def check(cli, frames, chunk, tasks, submitted=None):
    """@param submitted other frames than those that the template was written for"""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "it's a \"farm\" é"
        output = folder / "smoke_####.exr"
        subprocess.run([cli, "farm", "thesis-2012", *SMALL, "--for", "openjd", "--frames", frames, "--chunk", str(chunk), "--then", "flipbook", "--grid", "3x2", "--output", str(output)],
            check=True, capture_output=True)
        ran = run_template(folder / "smoke.openjd.json", {"Program": cli, **({"Frames": submitted} if submitted else {})})
        assert ran == tasks, (ran, tasks)
        frames = submitted or frames
        subprocess.run([cli, "verify", str(folder), "--frames", frames], check=True, stdout=subprocess.PIPE)
        assert (folder / "smoke.sheet.png").exists() and (folder / "smoke.sheet.flipbook.json").exists()
        whole = pathlib.Path(name) / "whole"
        subprocess.run([cli, "render", "thesis-2012", *SMALL, "--frames", frames, "--output", str(whole / "smoke_####.exr")], check=True, capture_output=True)
        for picture in sorted(whole.iterdir()):
            assert picture.read_bytes() == (folder / picture.name).read_bytes(), picture.name
        print(f"frames {frames}: {ran} tasks, the same bytes as one process")


def main():
    cli = sys.argv[1]
    check(cli, "0-9", 4, 3)
    check(cli, "3-17:2", 3, 3)
    check(cli, "0-9", 4, 2, submitted="2-8")


if __name__ == "__main__":
    main()
