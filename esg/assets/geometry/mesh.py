"""Meshes of configurations: trimesh scenes in cm, and deterministic GLB files.

A GLB follows glTF 2.0: metres, Y up. The asset's front (+X) stays +X; local Z becomes +Y and local
Y becomes -Z. Readers that want the document's frame apply the inverse (x, y, z) -> 100 (x, -z, y).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
import hashlib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.appearance import USUAL, Appearance
from esg.assets.appearances import appearances, first_of_asset
from esg.assets.colors import color_word
from esg.assets.configuration import node_mesh_path, parametric_entry
from esg.assets.geometry.finishing import (
    Drawing,
    Surface,
    completed,
    finished,
    finished_key,
    joined,
)
from esg.assets.geometry.lying import turned
from esg.assets.geometry.rolling import drawn_size, is_rolling_form, rolling
from esg.assets.geometry.rotations import GLTF_FROM_LOCAL
from esg.assets.geometry.sketch import Limb, Sketch
from esg.assets.geometry.wheels import wheels_of
from esg.assets.gltf.asset import asset_glb, models_glb
from esg.assets.imports.imported import load_imported
from esg.assets.library.catalogue import Entry, build_sketch
from esg.assets.looks import Color, Look
from esg.assets.materials import look_of
from esg.assets.postures import config_of, taken
from esg.assets.textures import has_grain
from esg.graph.casting import effective
from esg.graph.models import AssetConfiguration, EsgDocument, Lying, Vec3, Wheel
from esg.outcomes import UserError

if TYPE_CHECKING:
    import trimesh


@dataclass(frozen=True)
class _Piece:
    """One part of a model, and how it is finished."""

    drawing: Drawing
    tile_cm: float
    grain: bool
    smallest_cm: float

    def surface(self) -> Surface:
        return finished(self.drawing, self.tile_cm, grain=self.grain, smallest_cm=self.smallest_cm)

    def key(self) -> bytes:
        return finished_key(
            self.drawing, self.tile_cm, grain=self.grain, smallest_cm=self.smallest_cm
        )


@dataclass(frozen=True)
class Model:
    """What is of one look and turns together.

    Args:
        name: Unique in its asset.
        pieces: Its parts.
        look: How it looks.
        color: sRGB in [0, 1] of the surface on average.
        wheel: Index of its wheel; None for what does not turn.
        axle_cm: Of that wheel.
    """

    name: str
    pieces: tuple[_Piece, ...]
    look: Look
    color: Color
    wheel: int | None = None
    axle_cm: Vec3 | None = None

    @property
    def surface(self) -> Surface:
        """In the asset's frame, or about the axle of its wheel [cm]; it cannot be written to."""
        return self._surface

    @cached_property
    def _surface(self) -> Surface:
        surfaces = [piece.surface() for piece in self.pieces]
        if self.axle_cm is not None:
            surfaces = [s._replace(vertices=s.vertices - self.axle_cm) for s in surfaces]
        surface = joined(surfaces)
        for array in surface:
            array.setflags(write=False)
        for piece in self.pieces:
            piece.drawing.drop()
        return surface

    @property
    def key(self) -> bytes:
        """Tells its surface from others, without making it."""
        return b"".join([repr(self.axle_cm).encode(), *(piece.key() for piece in self.pieces)])


_BEVELLED = 0.03
"""Boxes and rods longer than this share of their asset's longest extent are bevelled."""

_KEPT = 48
"""Assets whose geometry a process keeps: those of two large scenes."""
_KEPT_FILES = 12
"""Assets whose files a process keeps: those of one scene, drawn before its record asks for them."""
_FOREIGN_TILE_CM = 100.0
"""Edge of one tile of the coordinates that an imported mesh without any is given."""


Form = bool | Lying
"""Whether an asset is the form that rolls on its rim, or how it lies otherwise than it is drawn."""


def form_of(config: AssetConfiguration) -> Form:
    """The form of an asset that is drawn."""
    return config.rolls if config.lying is None else config.lying


def build_mesh(config: AssetConfiguration, appearance: Appearance = USUAL) -> trimesh.Scene:
    """The asset's geometry [cm] in its local frame, one mesh a look, apart for every wheel.

    Each mesh has normals and texture coordinates (in tiles, v up); its `metadata` holds the `Look`
    and the colour [sRGB] of its surface.

    Raises:
        UserError: If the configuration names an asset that no library on this machine holds.
    """
    entry = parametric_entry(config)
    if entry is None:
        return _completed(load_imported(config))
    return _drawn(entry, config.dimensions_cm, config.color_rgb, form_of(config), appearance)


def _drawn(
    entry: Entry, dimensions_cm: Vec3, color: Color, form: Form, appearance: Appearance
) -> trimesh.Scene:
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    scene = trimesh.Scene()
    models, wheels = _models(entry, dimensions_cm, color, form, appearance)
    for wheel in wheels:
        scene.graph.update(frame_to=wheel.name, matrix=_moved(wheel.axle_cm))
    for model in models:
        look, surface = model.look, model.surface
        material = PBRMaterial(
            name=look.material,
            baseColorFactor=[round(255 * c) for c in (*model.color, look.alpha)],
            roughnessFactor=look.roughness,
            metallicFactor=look.metalness,
            alphaMode="BLEND" if look.alpha < 1.0 else "OPAQUE",
        )
        mesh = trimesh.Trimesh(
            surface.vertices,
            surface.faces,
            vertex_normals=surface.normals,
            visual=TextureVisuals(uv=surface.uvs, material=material),
            metadata={"look": look, "color": model.color},
            process=False,
        )
        scene.add_geometry(
            mesh,
            node_name=model.name,
            geom_name=model.name,
            parent_node_name=None if model.wheel is None else wheels[model.wheel].name,
        )
    return scene


def _completed(scene: trimesh.Scene) -> trimesh.Scene:
    """A foreign asset with the normals and texture coordinates it lacks."""
    for name, geometry in list(scene.geometry.items()):
        scene.geometry[name] = completed(geometry, _FOREIGN_TILE_CM)
    return scene


def closed_mesh(config: AssetConfiguration) -> trimesh.Trimesh:
    """The asset as its builder drew it [cm], local frame: closed parts with sharp edges.

    Raises:
        UserError: If the configuration names an asset that no library on this machine holds.
    """
    import trimesh

    entry = parametric_entry(config)
    if entry is None:
        meshes: list[Any] = load_imported(config).dump()
    else:
        meshes = [part.mesh() for part in configured_sketch(entry, config).parts]
    whole: Any = trimesh.util.concatenate(meshes)
    return whole


@lru_cache(maxsize=_KEPT)
def _models(
    entry: Entry, dimensions_cm: Vec3, color: Color, form: Form, appearance: Appearance
) -> tuple[tuple[Model, ...], tuple[Wheel, ...]]:
    """What an entry draws, together what is of one look and turns together, and its wheels.

    A scene's record asks for each of its assets more than once: for files, exports and pictures.
    """
    sketch = _sketch(entry, dimensions_cm, color, form, appearance)
    wheels = wheels_of(sketch) or ()
    drawings = [Drawing(part.mesh) for part in sketch.parts]
    smallest = _BEVELLED * max((d.outline.extent_cm for d in drawings), default=0.0)
    groups: dict[tuple[Look, Color, int | None], tuple[list[str], list[_Piece]]] = {}
    for part, drawing in zip(sketch.parts, drawings, strict=True):
        look = look_of(part.material, part.color, roughness=part.roughness, alpha=part.alpha)
        piece = _Piece(drawing, 100.0 * look.tile_m, has_grain(look.texture), smallest)
        red, green, blue = (round(c, 4) for c in part.color)
        names, pieces = groups.setdefault((look, (red, green, blue), part.axle), ([], []))
        names.append(part.name)
        pieces.append(piece)
    taken = {wheel.name for wheel in wheels}
    out: list[Model] = []
    for (look, color, axle), (names, pieces) in groups.items():
        name = names[0] if len(set(names)) == 1 else look.material
        name = name if axle is None else f"{wheels[axle].name}_{name}"
        at = None if axle is None else wheels[axle].axle_cm
        model = Model(_free_name(name, color, taken), tuple(pieces), look, color, axle, at)
        out.append(model)
    return tuple(out), wheels


@dataclass(frozen=True)
class Member:
    """What is of one look on one limb.

    Args:
        limb: Name of the limb; empty for what is on none.
        tip: Whether it is beyond the limb's last joint.
        surface: In the asset's frame [cm]; it cannot be written to.
        look: How it looks.
        color: sRGB in [0, 1] of the surface on average.
    """

    limb: str
    tip: bool
    surface: Surface
    look: Look
    color: Color


def limbed(
    config: AssetConfiguration, appearance: Appearance = USUAL
) -> tuple[tuple[Limb, ...], tuple[Member, ...]]:
    """The limbs of an asset's drawing, and its geometry apart for each; none of what has none.

    Args:
        config: Which asset, and how large.
        appearance: How it looks.
    """
    entry = parametric_entry(config)
    if entry is None:
        return (), ()
    return _limbed(entry, config.dimensions_cm, config.color_rgb, form_of(config), appearance)


@lru_cache(maxsize=_KEPT_FILES)
def _limbed(
    entry: Entry, dimensions_cm: Vec3, color: Color, form: Form, appearance: Appearance
) -> tuple[tuple[Limb, ...], tuple[Member, ...]]:
    sketch = _sketch(entry, dimensions_cm, color, form, appearance)
    if not sketch.limbs:
        return (), ()
    drawings = [Drawing(part.mesh) for part in sketch.parts]
    smallest = _BEVELLED * max((d.outline.extent_cm for d in drawings), default=0.0)
    groups: dict[tuple[str, bool, Look, Color], list[Surface]] = {}
    for part, drawing in zip(sketch.parts, drawings, strict=True):
        look = look_of(part.material, part.color, roughness=part.roughness, alpha=part.alpha)
        piece = _Piece(drawing, 100.0 * look.tile_m, has_grain(look.texture), smallest)
        red, green, blue = (round(c, 4) for c in part.color)
        key = (part.limb, part.tip, look, (red, green, blue))
        groups.setdefault(key, []).append(piece.surface())
    members = tuple(
        Member(limb, tip, joined(surfaces), look, color)
        for (limb, tip, look, color), surfaces in groups.items()
    )
    return tuple(sketch.limbs), members


def _free_name(name: str, color: Color, taken: set[str]) -> str:
    """The name, told apart by its colour, or else its number, if another has it."""
    named = name if name not in taken else f"{name}_{color_word(color)}"
    out, count = named, 1
    while out in taken:
        count += 1
        out = f"{named}_{count}"
    taken.add(out)
    return out


def _moved(by: Vec3 | NDArray[np.float64]) -> NDArray[np.float64]:
    matrix = np.eye(4)
    matrix[:3, 3] = by
    return matrix


def configured_sketch(
    entry: Entry, config: AssetConfiguration, appearance: Appearance = USUAL
) -> Sketch:
    """What an entry draws for a configuration: as it is drawn, as it lies, or on its rim."""
    return _sketch(entry, config.dimensions_cm, config.color_rgb, form_of(config), appearance)


def _sketch(
    entry: Entry, dimensions_cm: Vec3, color: Color, form: Form, appearance: Appearance
) -> Sketch:
    if isinstance(form, Lying):
        return turned(build_sketch(entry, form.drawn_cm, color, appearance), form)
    if not is_rolling_form(entry, form):
        return build_sketch(entry, dimensions_cm, color, appearance)
    size = drawn_size(entry, dimensions_cm)
    return rolling(entry, build_sketch(entry, size, color, appearance), size)


def glb_bytes(config: AssetConfiguration, appearance: Appearance = USUAL) -> bytes:
    """The asset as binary glTF (metres, Y up); the same configuration gives the same bytes."""
    entry = parametric_entry(config)
    if entry is not None:
        return _drawn_glb(
            entry, config.dimensions_cm, config.color_rgb, form_of(config), appearance
        )
    scene = build_mesh(config, appearance)
    if all("look" in geometry.metadata for geometry in scene.geometry.values()):
        return asset_glb(scene)
    scene.apply_transform(GLTF_FROM_LOCAL)
    data = scene.export(file_type="glb", include_normals=True)
    if not isinstance(data, bytes):
        raise UserError(f"{config.asset_name}: the mesh could not be exported as GLB", exit_code=1)
    return data


@lru_cache(maxsize=_KEPT_FILES)
def _drawn_glb(
    entry: Entry, dimensions_cm: Vec3, color: Color, form: Form, appearance: Appearance
) -> bytes:
    return models_glb(*_models(entry, dimensions_cm, color, form, appearance))


def write_meshes(doc: EsgDocument, folder: Path) -> dict[str, str]:
    """Writes the GLB of every configuration at its `mesh_path` below `folder`.

    Nodes that look unlike the first with the same asset get a file of their own beside it
    (`node_mesh_path`).

    Returns:
        SHA-256 of each file by asset id.

    Raises:
        UserError: If a file cannot be written.
    """
    doc = effective(doc)
    hashes: dict[str, str] = {}
    for mesh in _meshes(doc):
        _write(Path(folder) / mesh.path, mesh.glb)
        if mesh.path == doc.asset_configurations[mesh.asset].mesh_path:
            hashes[mesh.asset] = hashlib.sha256(mesh.glb).hexdigest()
    _write_attribution(doc, Path(folder))
    return hashes


@dataclass(frozen=True)
class MeshFile:
    """One mesh of a scene.

    Args:
        path: Below the scene's folder.
        asset: Id of its configuration.
        glb: The file.
    """

    path: str
    asset: str
    glb: bytes


def meshes_of(doc: EsgDocument) -> Iterator[MeshFile]:
    """The files that `write_meshes` writes, one after the other."""
    return _meshes(effective(doc))


def _meshes(doc: EsgDocument) -> Iterator[MeshFile]:
    looks = appearances(doc)
    firsts = first_of_asset(doc, looks)
    for key, config in doc.asset_configurations.items():
        yield MeshFile(config.mesh_path, key, glb_bytes(config, firsts.get(key, USUAL)))
    for name, node in doc.spatial_relation_graph.nodes.items():
        config = doc.asset_configurations.get(node.asset_id)
        if config is not None and looks[name] != firsts[node.asset_id]:
            path = node_mesh_path(config.mesh_path, name)
            yield MeshFile(path, node.asset_id, glb_bytes(config, looks[name]))
    for name, postures in taken(doc).items():
        for h in postures:
            own = glb_bytes(config_of(doc, name), h.drawn(looks[name]))
            yield MeshFile(h.mesh, doc.spatial_relation_graph.nodes[name].asset_id, own)


def _write(path: Path, data: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        partial = path.with_suffix(".part")
        partial.write_bytes(data)
        partial.replace(path)
    except OSError as error:
        raise UserError(f"cannot write {path}: {error.strerror}; choose another folder") from None


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
