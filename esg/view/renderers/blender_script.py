"""Run by Blender, which knows nothing of this package: draws the scene that `cycles` wrote.

    blender --background --factory-startup --python blender_script.py -- FOLDER

Reads scene.json and the arrays that it lists, writes image0.bin, ...: linear colour and coverage
of every pixel, rows from bottom to top, and Depth0.bin, Normal0.bin and DiffCol0.bin, four channels
each. Nothing is denoised: not every Blender can, and not every one has numpy.
"""

from __future__ import annotations

# Blender's own modules are not to be found here.
# pyright: basic, reportMissingImports=false, reportMissingModuleSource=false
from array import array
import json
import math
from pathlib import Path
import sys
from typing import Any

import bpy
from mathutils import Matrix, Quaternion, Vector

GROUND_HALF_M = 1500.0
PANE, PANE_ROUGHNESS, CLEAR = 0.6, 0.2, 0.97
PASSES = ("Depth", "Normal", "DiffCol")
STEP = 10
"""Frames of Blender between two of ours; the shutter is open for two of them."""


def main(folder: Path) -> None:
    told = json.loads((folder / "scene.json").read_text(encoding="utf-8"))
    arrays = {k: (read(folder / f"{k}.bin", v[0]), v[1]) for k, v in told["arrays"].items()}
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    movers = moving(arrays)
    for k, group in enumerate(told["groups"]):
        made = mesh(f"part{k}", arrays, k, material(group["look"], folder))
        if group["mover"] >= 0:
            made.parent = movers[group["mover"]]
    if told["ground"]:
        ground(told["ground"], folder)
    light(told["sun"], arrays["sky"])
    settings(scene, told, folder, blurred=arrays["position"][1][1] > 1)
    for k, camera in enumerate(told["cameras"]):
        look_through(scene, camera, told["size"])
        scene.frame_set(STEP * k)
        scene.render.filepath = str(folder / "seen.exr")
        bpy.ops.render.render(write_still=True)
        keep(folder / "seen.exr", folder / f"image{k}.bin")
        for name in PASSES:
            found = sorted(folder.glob(f"{name}-*.exr"))[0]
            keep(found, folder / f"{name}{k}.bin")
            found.unlink()


def read(path: Path, kind: str) -> Any:
    """Numbers of a file: "f" single floats, "i" integers."""
    values = array(kind)
    values.frombytes(path.read_bytes())
    return values


def keep(picture: Path, path: Path) -> None:
    """Writes the numbers of a picture, four a pixel."""
    image = bpy.data.images.load(str(picture))
    image.colorspace_settings.name = "Non-Color"
    pixels = array("f", bytes(4 * len(image.pixels)))
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    path.write_bytes(pixels.tobytes())


def moving(arrays: Any) -> list[Any]:
    """An empty for everything that has a pose, with a key at every instant of every frame."""
    position, (frames, instants, count, _) = arrays["position"]
    quaternion = arrays["quaternion"][0]
    out = []
    for m in range(count):
        holder = bpy.data.objects.new(f"mover{m}", None)
        holder.rotation_mode = "QUATERNION"
        bpy.context.scene.collection.objects.link(holder)
        for f in range(frames):
            for s in range(instants):
                at = STEP * f + (2.0 * s / (instants - 1) - 1.0 if instants > 1 else 0.0)
                k = (f * instants + s) * count + m
                x, y, z, w = quaternion[4 * k : 4 * k + 4]
                holder.location = position[3 * k : 3 * k + 3]
                holder.rotation_quaternion = (w, x, y, z)
                holder.keyframe_insert("location", frame=at)
                holder.keyframe_insert("rotation_quaternion", frame=at)
        for curve in holder.animation_data.action.fcurves:
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
        out.append(holder)
    return out


def mesh(name: str, arrays: Any, k: int, surface: Any) -> Any:
    """A mesh with texture coordinates and, where it is smooth, its own normals."""
    vertices, faces = arrays[f"vertices{k}"][0], arrays[f"faces{k}"][0]
    uvs = arrays[f"uvs{k}"][0]
    count = len(faces) // 3
    data = bpy.data.meshes.new(name)
    data.vertices.add(len(vertices) // 3)
    data.vertices.foreach_set("co", vertices)
    data.loops.add(len(faces))
    data.loops.foreach_set("vertex_index", faces)
    data.polygons.add(count)
    data.polygons.foreach_set("loop_start", array("i", range(0, 3 * count, 3)))
    data.polygons.foreach_set("loop_total", array("i", [3] * count))
    layer = data.uv_layers.new(name="uv")
    corners = array("f", (v for i in faces for v in (uvs[2 * i], uvs[2 * i + 1])))
    layer.data.foreach_set("uv", corners)
    data.materials.append(surface)
    data.update(calc_edges=True)
    if f"normals{k}" in arrays:
        n = arrays[f"normals{k}"][0]
        data.polygons.foreach_set("use_smooth", [True] * count)
        if hasattr(data, "use_auto_smooth"):
            data.use_auto_smooth = True
        own = [tuple(n[i : i + 3]) for i in range(0, len(n), 3)]
        data.normals_split_custom_set_from_vertices(own)
    made = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(made)
    return made


def ground(look: Any, folder: Path) -> None:
    """The plane just below z = 0; its texture counts metres."""
    h, z = GROUND_HALF_M, -0.0002
    data = bpy.data.meshes.new("ground")
    data.from_pydata([(-h, -h, z), (h, -h, z), (h, h, z), (-h, h, z)], [], [(0, 1, 2, 3)])
    layer = data.uv_layers.new(name="uv")
    t = h / look["tile_m"]
    layer.data.foreach_set("uv", [-t, -t, t, -t, t, t, -t, t])
    data.materials.append(material(look, folder))
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("ground", data))


def material(look: Any, folder: Path) -> Any:
    """A principled surface in a look's colour, roughness, metalness and textures."""
    made = bpy.data.materials.new(look["material"] or "plain")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    surface = nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*look["linear"], 1.0)
    surface.inputs["Roughness"].default_value = max(look["roughness"], 0.05)
    surface.inputs["Metallic"].default_value = look["metalness"]
    pane = look["alpha"] < PANE and look["roughness"] < PANE_ROUGHNESS
    if look["alpha"] < CLEAR:
        surface.inputs["Alpha"].default_value = max(look["alpha"], 0.08) if pane else look["alpha"]
    if not look["texture"]:
        return made

    def texture(kind: str, space: str) -> Any:
        node = nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(str(folder / f"{look['texture']}.{kind}.png"))
        node.image.colorspace_settings.name = space
        return node.outputs["Color"]

    tint = nodes.new("ShaderNodeVectorMath")
    tint.operation = "MULTIPLY"
    tint.inputs[1].default_value = look["linear"]
    links.new(texture("base_color", "sRGB"), tint.inputs[0])
    links.new(tint.outputs[0], surface.inputs["Base Color"])
    rough = nodes.new("ShaderNodeMath")
    rough.operation = "MULTIPLY"
    rough.inputs[1].default_value = look["roughness"]
    links.new(texture("roughness", "Non-Color"), rough.inputs[0])
    links.new(rough.outputs[0], surface.inputs["Roughness"])
    bent = nodes.new("ShaderNodeNormalMap")
    bent.inputs["Strength"].default_value = look["normal_strength"]
    links.new(texture("normal", "Non-Color"), bent.inputs["Color"])
    links.new(bent.outputs["Normal"], surface.inputs["Normal"])
    return made


def light(sun: Any, sky: Any) -> None:
    """The picture of the sky around everything, and a sun."""
    pixels, (rows, columns, _) = sky
    image = bpy.data.images.new("sky", columns, rows, float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    image.pixels.foreach_set(pixels)
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    around = nodes.new("ShaderNodeTexEnvironment")
    around.image = image
    links.new(around.outputs["Color"], nodes["Background"].inputs["Color"])
    lamp = bpy.data.lights.new("sun", "SUN")
    lamp.energy = math.pi
    lamp.color = sun["rgb"]
    lamp.angle = 2.0 * sun["radius"]
    made = bpy.data.objects.new("sun", lamp)
    made.rotation_mode = "QUATERNION"
    made.rotation_quaternion = Vector(sun["toward"]).to_track_quat("Z", "Y")
    bpy.context.scene.collection.objects.link(made)


def look_through(scene: Any, camera: Any, size: Any) -> None:
    """A camera of the same lens and place."""
    if scene.camera is None:
        lens = bpy.data.cameras.new("camera")
        scene.camera = bpy.data.objects.new("camera", lens)
        scene.collection.objects.link(scene.camera)
    lens = scene.camera.data
    lens.sensor_fit = "VERTICAL"
    lens.angle_y = camera["fov"]
    lens.clip_start, lens.clip_end = 0.01, 10000.0
    x, y, z, w = camera["quaternion"]
    turned = Quaternion((w, x, y, z)).to_matrix().to_4x4()
    scene.camera.matrix_world = Matrix.Translation(camera["eye"]) @ turned


def settings(scene: Any, told: Any, folder: Path, blurred: bool) -> None:
    """Cycles, with so many samples, a transparent sky and a pass of distances."""
    render = scene.render
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = told["size"]
    render.resolution_percentage = 100
    render.film_transparent = True
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGBA"
    render.image_settings.color_depth = "32"
    render.use_motion_blur = blurred
    render.motion_blur_shutter = 2.0
    scene.cycles.samples = told["samples"]
    scene.cycles.seed = told["seed"] & 0x7FFFFFFF
    scene.cycles.max_bounces = 6
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.film_transparent_glass = False
    scene.cycles.use_denoising = False
    if told["device"] != "cpu":
        kinds = bpy.context.preferences.addons["cycles"].preferences
        kinds.compute_device_type = "CUDA"
        kinds.get_devices()
        for device in kinds.devices:
            device.use = device.type == "CUDA"
        scene.cycles.device = "GPU"
    layer = bpy.context.view_layer
    layer.use_pass_z = layer.use_pass_normal = layer.use_pass_diffuse_color = True
    scene.use_nodes = True
    tree = scene.node_tree
    tree.nodes.clear()
    layers = tree.nodes.new("CompositorNodeRLayers")
    final = tree.nodes.new("CompositorNodeComposite")
    tree.links.new(layers.outputs["Image"], final.inputs["Image"])
    passes = tree.nodes.new("CompositorNodeOutputFile")
    passes.base_path = str(folder)
    passes.format.file_format = "OPEN_EXR"
    passes.format.color_depth = "32"
    passes.file_slots.clear()
    for name in PASSES:
        passes.file_slots.new(f"{name}-")
        tree.links.new(layers.outputs[name], passes.inputs[-1])


main(Path(sys.argv[sys.argv.index("--") + 1]))
