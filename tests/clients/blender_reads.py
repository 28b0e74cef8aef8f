"""What Blender makes of files of Fumage; runs inside Blender, for blender.py.

    blender -b --factory-startup --python tests/clients/blender_reads.py -- TASK.json ANSWER.json

The task names the files, a camera (place, forward, up, lens) and a sun; places and directions are Blender's, z up. The answer has what can be read, the
rest are pictures in the task's folder.
"""
import json
import pathlib
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

# Light is taken away in proportion to density, so weakly that pictures can be turned into lengths of smoke.
THINNED = 0.02


def aimed(place, forward, up):
    forward, up = Vector(forward), Vector(up)
    turn = Matrix((forward.cross(up), up, -forward)).transposed().to_4x4()
    return Matrix.Translation(Vector(place)) @ turn


def add_camera(matrix, **settings):
    bpy.ops.object.camera_add()
    camera = bpy.context.object
    camera.matrix_world = matrix
    for key, value in settings.items():
        setattr(camera.data, key, value)
    bpy.context.scene.camera = camera


def set_picture(size, samples, kind):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.volume_max_steps = 2048
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.film_transparent = True
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = kind
    scene.render.image_settings.color_mode = "RGBA"
    scene.render.image_settings.color_depth = "32" if kind == "OPEN_EXR" else "8"


def render(file):
    bpy.context.scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)


def smoke_material(albedo, factor):
    """As Blender makes it for a new volume: density is the grid of that name."""
    material = bpy.data.materials.new("Smoke")
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    volume = nodes.new("ShaderNodeVolumePrincipled")
    volume.inputs["Density"].default_value = factor
    volume.inputs["Color"].default_value = (albedo, albedo, albedo, 1)
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(volume.outputs[0], output.inputs["Volume"])
    return material


def bounds(thing):
    corners = [thing.matrix_world @ Vector(corner) for corner in thing.bound_box]
    return [[pick(corner[axis] for corner in corners) for axis in range(3)] for pick in (min, max)]


def read_volumes(task):
    """A sequence: what its grids are at each frame, and two views of it that show how much smoke stands where."""
    frames = task["frames"]
    folder = str(pathlib.Path(task["volumes"][0]).parent)
    files = [{"name": pathlib.Path(each).name} for each in task["volumes"]]
    bpy.ops.object.volume_import(directory=folder, files=files, use_sequence_detection=True, align="WORLD", location=(0, 0, 0))
    volume = bpy.context.object
    data = volume.data
    found = {"sequence": data.is_sequence, "duration": data.frame_duration, "frames": []}
    data.frame_start = frames[0]
    data.materials.append(smoke_material(0, THINNED))
    add_sun(task)
    for frame in frames:
        bpy.context.scene.frame_set(frame)
        assert data.grids.load(), data.grids.error_message
        found["frames"].append({"grids": {grid.name: [grid.data_type, grid.channels] for grid in data.grids}, "bounds": bounds(volume), "file": data.grids.frame_filepath})
        lower, upper = found["frames"][-1]["bounds"]
        for name, forward, up in (("front", (0, 1, 0), (0, 0, 1)), ("side", (-1, 0, 0), (0, 0, 1))):
            middle = (Vector(lower) + Vector(upper)) / 2
            width = 1.05 * max(b - a for a, b in zip(lower, upper))
            add_camera(aimed(middle - 50 * Vector(forward), forward, up), type="ORTHO", ortho_scale=width, clip_end=1000)
            set_picture(task["views"], 16, "OPEN_EXR")
            render(pathlib.Path(task["folder"]) / f"{name}_{frame}.exr")
            found["frames"][-1][name] = {"width": width, "middle": list(middle)} | lengths(pathlib.Path(task["folder"]) / f"{name}_{frame}.exr", width, middle, forward, up)
    data.materials[0] = smoke_material(task["albedo"], 1.0)
    return found


def pixels_of(image):
    """Rows from the bottom, four channels."""
    values = numpy.empty(image.size[0] * image.size[1] * 4, dtype=numpy.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)


def lengths(file, width, middle, forward, up):
    """Of a view along parallel lines: the integral of density over space, and the middle of it."""
    image = bpy.data.images.load(str(file))
    size = image.size[0]
    alpha = pixels_of(image)[..., 3]
    smoke = -numpy.log(numpy.maximum(1 - alpha, 1e-6)) / THINNED * (width / size) ** 2
    whole = float(smoke.sum())
    places = width * ((numpy.arange(size) + 0.5) / size - 0.5)
    right, up = Vector(forward).cross(Vector(up)), Vector(up)
    across, upwards = float((smoke.sum(0) * places).sum()) / whole, float((smoke.sum(1) * places).sum()) / whole
    return {"whole": whole, "centre": list(middle + across * right + upwards * up)}


def add_sun(task):
    bpy.ops.object.light_add(type="SUN")
    sun = bpy.context.object
    sun.data.energy = 4
    sun.rotation_euler = Vector(task["sun"]).to_track_quat("-Z", "Y").to_euler()
    world = bpy.data.worlds.new("Sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.42, 0.52, 0.68, 1)
    bpy.context.scene.world = world


def picture_of_volume(task):
    camera = task["camera"]
    add_camera(aimed(camera["place"], camera["forward"], camera["up"]), lens=camera["lens"], sensor_width=camera["sensor"], clip_end=1000)
    set_picture(task["size"], 32, "PNG")
    bpy.context.scene.frame_set(task["frames"][-1])
    render(pathlib.Path(task["folder"]) / "blender.png")


def read_points(task):
    bpy.ops.import_mesh.ply(filepath=task["points"])
    mesh = bpy.context.object
    places = [tuple(mesh.matrix_world @ vertex.co) for vertex in mesh.data.vertices]
    return {"count": len(places), "bounds": [[pick(place[axis] for place in places) for axis in range(3)] for pick in (min, max)], "sum": [sum(place[axis] for place in places) for axis in range(3)]}


def read_layers(task, picture):
    """Every layer of a multilayer EXR, written as a picture by the compositor, and that as numpy's file of the picture's and its own name."""
    folder = pathlib.Path(task["folder"])
    image = bpy.data.images.load(str(folder / f"{picture}.exr"))
    scene = bpy.data.scenes.new("Layers")
    bpy.context.window.scene = scene
    scene.use_nodes = True
    nodes = scene.node_tree.nodes
    nodes.clear()
    files = nodes.new("CompositorNodeOutputFile")
    files.base_path = task["folder"]
    files.format.file_format = "OPEN_EXR"
    files.format.color_depth = "32"
    files.file_slots.clear()
    node = nodes.new("CompositorNodeImage")
    node.image = image
    names = [output.name for output in node.outputs if output.enabled]
    for name in names:
        slot = f"{picture}_{name}-"
        files.file_slots.new(slot)
        scene.node_tree.links.new(node.outputs[name], files.inputs[slot])
    scene.render.resolution_x = scene.render.resolution_y = task["size"]
    bpy.ops.render.render(scene=scene.name)
    for name in names:
        for written in folder.glob(f"{picture}_{name}-*.exr"):
            numpy.save(folder / f"{picture}_{name}.npy", pixels_of(bpy.data.images.load(str(written))))
    return names


def main():
    task_file, answer_file = sys.argv[sys.argv.index("--") + 1 :]
    task = json.loads(pathlib.Path(task_file).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    answer = {"version": bpy.app.version_string, "volumes": read_volumes(task)}
    picture_of_volume(task)
    answer["points"] = read_points(task)
    answer["layers"] = {picture: read_layers(task, picture) for picture in task["layers"]}
    pathlib.Path(answer_file).write_text(json.dumps(answer, indent=1))


main()
