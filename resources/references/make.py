"""Makes the reference pictures of a scene with Blender's solver (Mantaflow) and path tracer (Cycles).

    blender -b --factory-startup --python resources/references/make.py -- SCENE FOLDER [--cells N] [--size N] [--samples N] [--frames N,N] [--bake-only]

SCENE is one of scenes.py. Bakes the air into FOLDER/SCENE, or takes what has been baked there, and writes FOLDER/SCENE_FRAME.png, 8 bits, straight
alpha. Drafts take fewer cells, pixels and samples. Prints seconds of both.
"""

import argparse
import math
import pathlib
import sys
import time

import bpy
from mathutils import Vector

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import scenes  # noqa: E402


def upright(place) -> Vector:
    """Ours, y up, as Blender's, z up."""
    return Vector((place[0], -place[2], place[1]))


def fluid(thing, kind: str):
    settings = thing.modifiers.new("Fluid", "FLUID")
    settings.fluid_type = kind
    return settings


def add_box(scene: dict, folder: pathlib.Path, cells: int, last: int):
    width, height, depth = scene["box"]
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, height / 2))
    box = bpy.context.object
    box.name = "Box"
    box.scale = (width, depth, height)
    bpy.ops.object.transform_apply(location=False, scale=True)
    domain = fluid(box, "DOMAIN").domain_settings
    domain.domain_type = "GAS"
    domain.resolution_max = cells
    domain.cache_type = "ALL"
    domain.cache_directory = str(folder / "cache")
    domain.cache_frame_start, domain.cache_frame_end = 1, last
    domain.alpha, domain.beta = scene["lift"]
    domain.vorticity = scene["vorticity"]
    domain.use_noise = True
    domain.noise_scale = 2
    domain.noise_strength = 0.8
    for side in ("front", "back", "left", "right"):
        setattr(domain, f"use_collision_border_{side}", False)
    domain.use_collision_border_bottom = True
    domain.use_collision_border_top = scene["ceiling"]
    if scene["fades"]:
        domain.use_dissolve_smoke = True
        domain.dissolve_speed = scene["fades"]
    if scene["burning"]:
        domain.burning_rate, domain.flame_smoke, domain.flame_vorticity, domain.flame_max_temp = scene["burning"]
    return box


def clouds(scene: dict, last: int, flow) -> None:
    """Makes the source patchy, by clouds that it drifts through."""
    texture = bpy.data.textures.new("Patches", "CLOUDS")
    texture.noise_scale = scene["clouds"]
    texture.contrast = 1.5
    flow.use_texture = True
    flow.noise_texture = texture
    flow.texture_offset = 0
    flow.keyframe_insert("texture_offset", frame=1)
    flow.texture_offset = last / 24
    flow.keyframe_insert("texture_offset", frame=last)


def add_source(scene: dict, last: int) -> None:
    if scene["source"] == "ball":
        bpy.ops.mesh.primitive_uv_sphere_add(radius=scene["radius"], location=(0, 0, scene["radius"] + 0.1))
    else:
        bpy.ops.mesh.primitive_cylinder_add(radius=scene["radius"], depth=scene["thickness"], location=(0, 0, 0.1 + scene["thickness"] / 2))
    source = bpy.context.object
    source.hide_render = True
    flow = fluid(source, "FLOW").flow_settings
    flow.flow_type = scene["emits"]
    flow.flow_behavior = "INFLOW"
    flow.density, flow.fuel_amount, flow.temperature = scene["density"], scene["fuel"], scene["heat"]
    flow.surface_distance = 1.0
    flow.use_initial_velocity = True
    up, outwards = scene["speed"]
    flow.velocity_coord = (0, 0, up)
    flow.velocity_normal = outwards
    clouds(scene, last, flow)
    if scene["until"]:
        flow.use_inflow = True
        flow.keyframe_insert("use_inflow", frame=scene["until"])
        flow.use_inflow = False
        flow.keyframe_insert("use_inflow", frame=scene["until"] + 1)


def bake(scene: dict, folder: pathlib.Path, cells: int) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    last = max(scene["moments"])
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 1, last
    bpy.context.scene.render.fps = 24
    add_source(scene, last)
    bpy.ops.object.effector_add(type="TURBULENCE", location=(0.3, 0.2, 0))
    field = bpy.context.object.field
    field.strength, field.size, field.flow, field.seed = scene["turbulence"], 1.0, 0.0, 3
    box = add_box(scene, folder, cells, last)
    folder.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "scene.blend"))
    with bpy.context.temp_override(scene=bpy.context.scene, active_object=box, object=box):
        bpy.ops.fluid.bake_all()
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / "baked.blend"))


def add_smoke(scene: dict, box) -> None:
    """What is seen of the cells: smoke, and flames whose colour follows how hot they are."""
    material = bpy.data.materials.new("Smoke")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    density = nodes.new("ShaderNodeAttribute")
    density.attribute_name = "density"
    extinction = nodes.new("ShaderNodeMath")
    extinction.operation = "MULTIPLY"
    extinction.inputs[1].default_value = scene["extinction"]
    volume = nodes.new("ShaderNodeVolumePrincipled")
    volume.inputs["Density Attribute"].default_value = ""
    volume.inputs["Color"].default_value = (scene["albedo"],) * 3 + (1,)
    volume.inputs["Anisotropy"].default_value = scenes.ANISOTROPY
    links.new(density.outputs["Fac"], extinction.inputs[0])
    links.new(extinction.outputs[0], volume.inputs["Density"])
    if scene["flames"]:
        flame = nodes.new("ShaderNodeAttribute")
        flame.attribute_name = "flame"
        colours = nodes.new("ShaderNodeValToRGB")
        for place, colour in ((0.15, (0, 0, 0)), (0.4, (0.25, 0.02, 0)), (0.7, (1, 0.22, 0.02)), (0.95, (1, 0.6, 0.2))):
            colours.color_ramp.elements.new(place).color = colour + (1,)
        colours.color_ramp.elements.remove(colours.color_ramp.elements[-1])
        links.new(flame.outputs["Fac"], colours.inputs[0])
        links.new(colours.outputs["Color"], volume.inputs["Emission Color"])
        volume.inputs["Emission Strength"].default_value = scene["flames"]
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(volume.outputs[0], output.inputs["Volume"])
    box.data.materials.clear()
    box.data.materials.append(material)


def add_light(scene: dict) -> None:
    bpy.ops.object.light_add(type="SUN")
    sun = bpy.context.object
    sun.data.energy = scene["sun"]
    sun.data.color = scenes.SUN_COLOUR
    sun.data.angle = math.radians(2)
    sun.rotation_euler = upright(scenes.SUN_DIRECTION).to_track_quat("-Z", "Y").to_euler()
    world = bpy.data.worlds.new("Sky")
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    place = nodes.new("ShaderNodeTexCoord")
    parts = nodes.new("ShaderNodeSeparateXYZ")
    height = nodes.new("ShaderNodeMapRange")
    height.inputs["From Min"].default_value = -0.3
    height.inputs["From Max"].default_value = 0.3
    mix = nodes.new("ShaderNodeMixRGB")
    mix.inputs["Color1"].default_value = scenes.GROUND + (1,)
    mix.inputs["Color2"].default_value = scenes.SKY + (1,)
    links.new(place.outputs["Generated"], parts.inputs[0])
    links.new(parts.outputs["Z"], height.inputs["Value"])
    links.new(height.outputs[0], mix.inputs["Fac"])
    links.new(mix.outputs[0], nodes["Background"].inputs["Color"])
    nodes["Background"].inputs["Strength"].default_value = 0.25 * scene["sun"]
    bpy.context.scene.world = world


def add_camera(scene: dict) -> None:
    bpy.ops.object.camera_add()
    camera = bpy.context.object
    camera.data.lens, camera.data.sensor_width = scenes.FOCAL_LENGTH, 36
    pitch = math.radians(scenes.PITCH)
    away = Vector((0, -math.cos(pitch), math.sin(pitch)))
    camera.location = upright(scene["target"]) + away * scene["distance"]
    camera.rotation_euler = (-away).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.camera = camera


def set_picture(size: int, samples: int) -> None:
    picture = bpy.context.scene
    picture.render.engine = "CYCLES"
    picture.cycles.samples = samples
    picture.cycles.use_denoising = False
    picture.cycles.use_adaptive_sampling = False
    picture.cycles.volume_bounces = 4
    picture.cycles.max_bounces = 4
    picture.cycles.volume_max_steps = 512
    picture.render.resolution_x = picture.render.resolution_y = size
    picture.render.film_transparent = True
    picture.render.image_settings.file_format = "PNG"
    picture.render.image_settings.color_mode = "RGBA"
    picture.render.image_settings.color_depth = "8"
    picture.render.image_settings.compression = 100
    picture.view_settings.view_transform = "Standard"


def let_flames_cover() -> None:
    """Raises alpha to the brightest channel where flames give more light than smoke covers: straight alpha cuts it off otherwise."""
    picture = bpy.context.scene
    picture.use_nodes = True
    nodes, links = picture.node_tree.nodes, picture.node_tree.links
    nodes.clear()
    layers = nodes.new("CompositorNodeRLayers")
    parts = nodes.new("CompositorNodeSepRGBA")
    links.new(layers.outputs["Image"], parts.inputs[0])
    covered = parts.outputs["A"]
    for channel in "RGB":
        larger = nodes.new("CompositorNodeMath")
        larger.operation = "MAXIMUM"
        larger.use_clamp = True
        links.new(covered, larger.inputs[0])
        links.new(parts.outputs[channel], larger.inputs[1])
        covered = larger.outputs[0]
    whole = nodes.new("CompositorNodeSetAlpha")
    whole.mode = "REPLACE_ALPHA"
    links.new(layers.outputs["Image"], whole.inputs["Image"])
    links.new(covered, whole.inputs["Alpha"])
    output = nodes.new("CompositorNodeComposite")
    links.new(whole.outputs[0], output.inputs["Image"])


def main() -> None:
    parser = argparse.ArgumentParser(prog="make.py")
    parser.add_argument("scene", choices=scenes.SCENES)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cells", type=int)
    parser.add_argument("--size", type=int, default=384)
    parser.add_argument("--samples", type=int, default=48)
    parser.add_argument("--frames", type=lambda text: [int(each) for each in text.split(",")])
    parser.add_argument("--bake-only", action="store_true")
    given = parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    scene = scenes.numbers(given.scene)
    folder = given.folder.resolve() / given.scene
    if not (folder / "baked.blend").exists():
        start = time.monotonic()
        bake(scene, folder, given.cells or scene["cells"])
        print(f"{given.scene}: baked in {time.monotonic() - start:.0f} s")
    if given.bake_only:
        return
    bpy.ops.wm.open_mainfile(filepath=str(folder / "baked.blend"))
    add_smoke(scene, bpy.data.objects["Box"])
    add_light(scene)
    add_camera(scene)
    set_picture(given.size, given.samples)
    let_flames_cover()
    for frame in given.frames or scene["moments"]:
        start = time.monotonic()
        bpy.context.scene.frame_set(frame)
        bpy.context.scene.render.filepath = str(given.folder.resolve() / f"{given.scene}_{frame:02}.png")
        bpy.ops.render.render(write_still=True)
        print(f"{given.scene}: frame {frame} rendered in {time.monotonic() - start:.0f} s")


main()
