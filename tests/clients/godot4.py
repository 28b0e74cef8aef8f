#!/usr/bin/python3
"""Reads what `fumage-cli flipbook --for godot` writes by Godot 4's rules, where there is no Godot 4.

usage: godot4.py <fumage-cli>
Needs glslang-tools. The scene: headings, resources that are declared before they are used and once, as many steps as the heading says, values that are
Godot's literals, parameters that the shader has, files that are there. The shader: Godot's language is GLSL ES 3.00 with words of its own (the manual,
"Shading language"); with those taken out and its built-in variables declared a compiler of Khronos has to take each of its functions.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
LITERAL = re.compile(rf'(?:{NUMBER}|true|false|"(?:[^"\\]|\\.)*"|(?:Vector[234]|Color|AABB|Transform3D)\({NUMBER}(?:, {NUMBER})*\)|(?:Ext|Sub)Resource\("[^"]*"\))')
HEADING = re.compile(r'\[(\w+)((?: \w+=(?:"(?:[^"\\]|\\.)*"|\w+|ExtResource\("[^"]*"\)))*)\]')
ATTRIBUTE = re.compile(r'(\w+)=("(?:[^"\\]|\\.)*"|\w+)')
HINTS = {"source_color", "filter_linear_mipmap", "filter_linear", "repeat_disable", "hint_range"}
MODES = {"blend_mix", "depth_draw_never", "cull_disabled", "unshaded", "specular_disabled", "ambient_light_disabled"}

# Of spatial shaders, from the manual's tables; what may be written has no const.
GLOBAL = "const float TIME = 0.0; const float PI = 3.14159265; const float TAU = 6.2831853;"
BUILT_INS = {
    "vertex": "mat4 MODELVIEW_MATRIX; mat3 MODELVIEW_NORMAL_MATRIX; vec3 VERTEX; vec3 NORMAL; vec2 UV; vec4 COLOR; uniform mat4 MODEL_MATRIX, VIEW_MATRIX, INV_VIEW_MATRIX, PROJECTION_MATRIX; uniform vec4 INSTANCE_CUSTOM;",
    "fragment": "uniform vec2 UV_; vec2 UV; vec4 COLOR; vec3 ALBEDO; float ALPHA; vec3 EMISSION; vec3 NORMAL;",
    "light": "uniform vec3 LIGHT, LIGHT_COLOR, NORMAL, VIEW, ALBEDO; uniform float ATTENUATION; vec3 DIFFUSE_LIGHT; vec3 SPECULAR_LIGHT;",
}


def check_scene(text, folder, uniforms):
    declared, needed, steps = {}, None, 0
    section = None
    for number, line in enumerate(text.splitlines(), 1):
        where = f"line {number}: {line}"
        if not line.strip():
            continue
        heading = HEADING.fullmatch(line)
        if heading:
            section = heading[1]
            attributes = dict(ATTRIBUTE.findall(heading[2]))
            if section == "gd_scene":
                assert number == 1 and attributes["format"] == "3", where
                needed = int(attributes["load_steps"])
            elif section in ("ext_resource", "sub_resource"):
                key = ("Ext" if section == "ext_resource" else "Sub", attributes["id"].strip('"'))
                assert key not in declared, where
                declared[key] = attributes["type"]
                steps += 1
                if section == "ext_resource":
                    assert (folder / attributes["path"].strip('"').removeprefix("res://")).exists(), where
            else:
                assert section == "node" and ("parent" in attributes) == (" parent=" in line), where
            continue
        name, equals, value = line.partition(" = ")
        assert equals and section in ("sub_resource", "node") and re.fullmatch(r"[\w/]+", name), where
        assert LITERAL.fullmatch(value), where
        for kind, key in re.findall(r'(Ext|Sub)Resource\("([^"]*)"\)', value):
            assert (kind, key) in declared, where
        if name.startswith("shader_parameter/"):
            assert name.split("/")[1] in uniforms, where
    assert needed == steps + 1, (needed, steps) # and the scene itself
    return len(declared)


def as_glsl(text, stage):
    """What is left for a function of the shader, as a fragment shader of GLSL ES."""
    assert re.search(r"^shader_type spatial;$", text, re.MULTILINE)
    modes = re.search(r"^render_mode ([^;]*);$", text, re.MULTILINE)[1].split(", ")
    assert set(modes) <= MODES, modes
    text = re.sub(r"^(shader_type|render_mode) .*$", "", text, flags=re.MULTILINE)

    def without_hints(found):
        hints = set(re.split(r",\s*", found[2].strip()))
        assert hints <= HINTS, hints
        return found[1]

    text = re.sub(r"(uniform \w+ \w+)\s*:\s*([^;=]*)", without_hints, text)
    text = re.sub(r"(uniform \w+ \w+)\s*=[^;]*;", r"\1;", text) # GLSL ES has no values of uniforms
    text = text.replace("varying ", "") # which Godot's functions both write and read
    for other in BUILT_INS:
        if other != stage:
            text = re.sub(rf"^void {other}\(\) \{{.*?^\}}", "", text, flags=re.MULTILINE | re.DOTALL)
    return f"#version 300 es\nprecision highp float;\n{GLOBAL}\n{BUILT_INS[stage]}\nout vec4 result;\n{text}\nvoid main() {{ {stage}(); result = vec4(0.0); }}\n"


def main():
    for passes in (["colour"], ["colour", "motion"], ["colour", "motion", "six-way"]):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            subprocess.run([sys.argv[1], "--quiet", "flipbook", "thesis-2012", "--for", "godot", "--passes", ",".join(passes), "--size", "32", "--grid", "2x2", "--output", folder / "smoke's_2x2.png"],
                check=True)
            shader = next(folder.glob("*.gdshader")).read_text()
            uniforms = set(re.findall(r"^uniform \w+ (\w+)", shader, re.MULTILINE))
            resources = check_scene(next(folder.glob("*.tscn")).read_text(), folder, uniforms)
            stages = [stage for stage in BUILT_INS if f"void {stage}()" in shader]
            for stage in stages:
                file = folder / f"{stage}.frag"
                file.write_text(as_glsl(shader, stage))
                compiled = subprocess.run(["glslangValidator", "-S", "frag", file], capture_output=True, text=True)
                assert compiled.returncode == 0, compiled.stdout
            print(f"{'+'.join(passes)}: a scene of {resources} resources; {', '.join(stages)} compile")


if __name__ == "__main__":
    main()
