"""Opens a GLB or USD file in Blender and says what it finds there: run by an interpreter with bpy.

    python in_blender.py JOB.json

The job names the file, instants, size and where to write the picture and the answer. Nothing of
this project is used.
"""

from __future__ import annotations

import json
from pathlib import Path
import sys
from typing import Any

import bpy

PRINCIPLED = "BSDF_PRINCIPLED"
INPUTS = {"base": "Base Color", "rough_metal": "Roughness", "normal": "Normal"}


def open_file(path: str) -> None:
    """Takes Blender's own objects away and imports the file with its camera, lights and motion."""
    bpy.ops.wm.read_factory_settings()
    bpy.data.batch_remove([*bpy.data.objects, *bpy.data.meshes, *bpy.data.materials])
    if path.endswith(".glb"):
        bpy.ops.import_scene.gltf(filepath=path, export_import_convert_lighting_mode="RAW")
    else:
        bpy.ops.wm.usd_import(filepath=path, import_guide=False, set_frame_range=True)


def surface_of(material: Any) -> dict[str, Any] | None:
    """Factors of a material, and which of its inputs a picture feeds."""
    if not material.use_nodes:
        return None
    found = [n for n in material.node_tree.nodes if n.type == PRINCIPLED]
    if not found:
        return None
    inputs = found[0].inputs
    fed = {kind: pictures(inputs[name]) for kind, name in INPUTS.items()}
    color, rough, metal = (inputs[n] for n in ("Base Color", "Roughness", "Metallic"))
    return {
        "color": None if color.links else list(color.default_value)[:3],
        "roughness": None if rough.links else rough.default_value,
        "metalness": None if metal.links else metal.default_value,
        "pictures": {kind: sizes[0] for kind, sizes in fed.items() if sizes},
    }


def pictures(socket: Any) -> list[list[int]]:
    """Sizes of the pictures above an input [px]; 0 x 0 for one that could not be read."""
    out: list[list[int]] = []
    waiting = [link.from_node for link in socket.links]
    while waiting:
        node = waiting.pop()
        if node.type == "TEX_IMAGE":
            out.append(list(node.image.size) if node.image else [0, 0])
        waiting += [link.from_node for one in node.inputs for link in one.links]
    return out


def places(times: list[float], rate: float) -> list[dict[str, Any]]:
    """World matrices of all objects at some instants, rows first."""
    scene, out = bpy.context.scene, []
    for time in times:
        frame = time * rate
        scene.frame_set(int(frame), subframe=frame % 1.0)
        bpy.context.view_layer.update()
        out.append({o.name: [list(row) for row in o.matrix_world] for o in scene.objects})
    return out


def render(job: dict[str, Any], rate: float) -> None:
    """Draws the scene through the file's camera by the file's sun under an even sky."""
    scene = bpy.context.scene
    camera = next(o for o in scene.objects if o.type == "CAMERA")
    scene.camera = camera
    scene.frame_set(round(job["at"] * rate))
    if job["file"].endswith(".glb"):
        # glTF has no word for what comes from all sides: that is left to the viewer.
        sky = scene.world.node_tree.nodes["Background"]
        sky.inputs["Color"].default_value = (*job["ambient"], 1.0)
        sky.inputs["Strength"].default_value = 1.0
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = job["samples"]
    scene.cycles.use_denoising = True
    scene.cycles.max_bounces = 3
    scene.render.threads_mode, scene.render.threads = "FIXED", job["threads"]
    scene.render.resolution_x, scene.render.resolution_y = job["size"]
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    scene.render.filepath = job["picture"]
    bpy.ops.render.render(write_still=True)


def main() -> None:
    job = json.loads(Path(sys.argv[-1]).read_text())
    open_file(job["file"])
    scene = bpy.context.scene
    # A GLB states seconds, a USD file frames.
    rate = scene.render.fps / scene.render.fps_base if job["file"].endswith(".glb") else job["rate"]
    answer = {
        "version": bpy.app.version_string,
        "materials": {m.name: surface_of(m) for m in bpy.data.materials if m.users},
        "places": places(job["times"], rate),
        "lights": {o.name: o.data.energy for o in scene.objects if o.type == "LIGHT"},
        "cameras": [o.name for o in scene.objects if o.type == "CAMERA"],
        "meshes": sum(o.type == "MESH" for o in scene.objects),
    }
    render(job, rate)
    Path(job["answer"]).write_text(json.dumps(answer))


if __name__ == "__main__":
    main()
