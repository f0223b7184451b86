"""Meshes of configurations: trimesh scenes in cm, and deterministic GLB files.

A GLB follows glTF 2.0: metres, Y up. The asset's front (+X) stays +X; local Z becomes +Y and local
Y becomes -Z. Readers that want the document's frame apply the inverse (x, y, z) -> 100 (x, -z, y).
"""

from __future__ import annotations

import hashlib
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from esg.assets.configuration import parametric_entry
from esg.assets.geometry.rolling import drawn_size, is_rolling_form, rolling
from esg.assets.geometry.rotations import GLTF_FROM_LOCAL
from esg.assets.geometry.sketch import Sketch
from esg.assets.geometry.wheels import wheels_of
from esg.assets.imports.imported import load_imported
from esg.assets.library.catalogue import Entry, build_sketch
from esg.assets.materials import look_of
from esg.graph.casting import effective
from esg.graph.models import AssetConfiguration, EsgDocument, Vec3
from esg.outcomes import UserError

if TYPE_CHECKING:
    import trimesh


def build_mesh(config: AssetConfiguration) -> trimesh.Scene:
    """The asset's geometry [cm] in its local frame, one coloured closed mesh a part.

    Raises:
        UserError: If the configuration names an asset that no library on this machine holds.
    """
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    entry = parametric_entry(config)
    if entry is None:
        return load_imported(config)
    scene = trimesh.Scene()
    sketch = configured_sketch(entry, config)
    wheels = wheels_of(sketch) or ()
    for wheel in wheels:
        scene.graph.update(frame_to=wheel.name, matrix=_moved(wheel.axle_cm))
    for part in sketch.parts:
        mesh = part.mesh()
        wheel = None if part.axle is None else wheels[part.axle]
        if wheel is not None:
            mesh.apply_translation([-c for c in wheel.axle_cm])
        look = look_of(part.material, part.color, roughness=part.roughness, alpha=part.alpha)
        rgba = [round(255 * c) for c in (*part.color, look.alpha)]
        mesh.visual = TextureVisuals(
            material=PBRMaterial(
                name=look.material,
                baseColorFactor=rgba,
                roughnessFactor=look.roughness,
                metallicFactor=look.metalness,
                alphaMode="BLEND" if look.alpha < 1.0 else "OPAQUE",
            )
        )
        red, green, blue = part.color
        mesh.metadata.update(look=look, color=(red, green, blue))
        name = _free_name(scene, part.name)
        scene.add_geometry(
            mesh,
            node_name=name,
            geom_name=name,
            parent_node_name=None if wheel is None else wheel.name,
        )
    return scene


def _free_name(scene: trimesh.Scene, name: str) -> str:
    """The name, numbered from the second part on that has it."""
    taken, out, count = set(scene.graph.nodes), name, 1
    while out in taken:
        count += 1
        out = f"{name}_{count}"
    return out


def _moved(by: Vec3 | NDArray[np.float64]) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def configured_sketch(entry: Entry, config: AssetConfiguration) -> Sketch:
    """What an entry draws for a configuration: lying, or on its rim."""
    if not is_rolling_form(entry, config.rolls):
        return build_sketch(entry, config.dimensions_cm, config.color_rgb)
    size = drawn_size(entry, config.dimensions_cm)
    return rolling(entry, build_sketch(entry, size, config.color_rgb), size)


def glb_bytes(config: AssetConfiguration) -> bytes:
    """The asset as binary glTF (metres, Y up); the same configuration gives the same bytes."""
    scene = build_mesh(config)
    _to_gltf(scene)
    data = scene.export(file_type="glb")
    if not isinstance(data, bytes):
        raise UserError(f"{config.asset_name}: the mesh could not be exported as GLB", exit_code=1)
    return data


def _to_gltf(scene: trimesh.Scene) -> None:
    """Leads a scene into glTF's frame; nodes of wheels keep no more than their place, to turn."""
    graph = scene.graph
    scene.apply_transform(GLTF_FROM_LOCAL)
    for wheel in set(graph.nodes) - set(graph.nodes_geometry) - {graph.base_frame}:
        place = _moved(graph[wheel][0][:3, 3])
        graph.update(frame_to=wheel, matrix=place)
        for part in graph.transforms.children[wheel]:
            matrix = GLTF_FROM_LOCAL.copy()
            graph.update(frame_from=wheel, frame_to=part, matrix=matrix)


def write_meshes(doc: EsgDocument, folder: Path) -> dict[str, str]:
    """Writes the GLB of every configuration at its `mesh_path` below `folder`.

    Returns:
        SHA-256 of each file by asset id.

    Raises:
        UserError: If a file cannot be written.
    """
    doc = effective(doc)
    hashes: dict[str, str] = {}
    for key, config in doc.asset_configurations.items():
        path = Path(folder) / config.mesh_path
        data = glb_bytes(config)
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            partial = path.with_suffix(".part")
            partial.write_bytes(data)
            partial.replace(path)
        except OSError as error:
            raise UserError(
                f"cannot write {path}: {error.strerror}; choose another folder"
            ) from None
        hashes[key] = hashlib.sha256(data).hexdigest()
    _write_attribution(doc, Path(folder))
    return hashes


def _write_attribution(doc: EsgDocument, folder: Path) -> None:
    """Names creator and licence of every borrowed mesh beside the meshes, as their licences ask."""
    lines = [
        f"{config.mesh_path}: {config.attribution or config.asset_name} [{config.license}]\n"
        for _, config in sorted(doc.asset_configurations.items())
        if config.source in ("library", "generated")
    ]
    path = folder / "meshes" / "ATTRIBUTION.txt"
    if lines:
        path.write_text("".join(lines), encoding="utf-8")
    elif path.is_file():
        path.unlink()
