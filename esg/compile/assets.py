"""Mesh assets of a class: Unreal paths, collision primitives, query shapes, mass frames.

Bodies with the same mesh and the same collision share an asset. Collision is kept in the asset's
local frame (origin bottom centre), in Unreal's units and handedness, because that is what the
import script writes into the static mesh.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.configuration import node_mesh_path
from esg.compile import frames, names
from esg.engines.scene import Body, Shape, SimScene
from esg.outcomes import UserError

Floats = NDArray[np.float64]

DISC_BOX = 0.886226925452758
"""sqrt(pi) / 2: half side of the square with the area of a unit disc."""

ROUND_DIGITS = 9
"""Decimals [cm] to which collision numbers are kept when assets are compared."""


@dataclass(frozen=True)
class Primitive:
    """One collision shape in the asset's local frame, Unreal cm; sizes as in `Shape`."""

    kind: str
    size: tuple[float, float, float]
    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]
    vertices: tuple[tuple[float, float, float], ...] = ()


@dataclass(frozen=True)
class Probe:
    """A shape FCollisionShape can express, standing in for a primitive in penetration queries."""

    kind: str
    size: tuple[float, float, float]
    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]


@dataclass(frozen=True)
class MeshAsset:
    """One static mesh.

    Args:
        identifier: Unique in the class.
        path: Unreal object path, `/Game/ESG/<Scene>/SM_x.SM_x`.
        source: GLB inside the scene folder, "" if the body has none.
        collision: Primitives; empty for decals.
        half_extents: Of the bounding box [cm].
    """

    identifier: str
    path: str
    source: str
    collision: tuple[Primitive, ...]
    half_extents: tuple[float, float, float]


def safe_source(mesh: str) -> str:
    """`mesh` if it stays inside the scene folder.

    Raises:
        UserError: For an absolute path or one that climbs out.
    """
    path = PurePosixPath(mesh.replace("\\", "/"))
    if path.is_absolute() or ".." in path.parts or ":" in mesh or "\0" in mesh:
        raise UserError(f"mesh path {mesh!r} leaves the scene folder; meshes must lie below it")
    return "" if str(path) == "." else str(path)


def mesh_file(folder: Path, mesh: str, node: str = "") -> Path | None:
    """The file of a mesh in a scene folder, None if there is none.

    Args:
        folder: Of the scene.
        mesh: Path of the mesh in it.
        node: Whose mesh it is: its own file is preferred, if it looks unlike its asset.

    Raises:
        UserError: If the path leaves the folder, be it through a symbolic link.
    """
    source = safe_source(mesh)
    path = folder / source
    own = folder / node_mesh_path(source, node)
    path = own if node and own.is_file() else path
    if not source or not path.is_file():
        return None
    if not path.resolve().is_relative_to(folder.resolve()):
        raise UserError(f"mesh path {mesh!r} leaves the scene folder through a symbolic link")
    return path


def mesh_assets(scene: SimScene, root: str) -> tuple[MeshAsset, ...]:
    """The asset of every body, in body order; equal for bodies that share one."""
    known: dict[Any, MeshAsset] = {}
    taken: dict[str, int] = {}
    out: list[MeshAsset] = []
    for body in scene.bodies:
        source = safe_source(body.mesh)
        collision = tuple(_primitive(s, body) for s in body.shapes)
        half = tuple(round(v * frames.CM_PER_M, ROUND_DIGITS) for v in body.half_extents)
        key = (source, _rounded(collision), half)
        if key not in known:
            stem = names.identifier(PurePosixPath(source).stem if source else body.name, "Mesh")
            number = taken[stem.lower()] = taken.get(stem.lower(), 0) + 1
            unique = stem if number == 1 else f"{stem}__{number}"
            path = f"{root}/SM_{unique}.SM_{unique}"
            known[key] = MeshAsset(unique.replace("__", "_v"), path, source, collision, half)  # type: ignore[arg-type]
        out.append(known[key])
    return tuple(out)


def _primitive(shape: Shape, body: Body) -> Primitive:
    local = np.asarray(shape.position, float) - np.asarray(body.origin_offset, float)
    vertices = frames.vector_to_unreal(np.reshape(shape.vertices, (-1, 3)))
    return Primitive(
        kind=shape.kind,
        size=_triple(np.asarray(shape.size, float) * frames.CM_PER_M),
        position=_triple(frames.vector_to_unreal(local)),
        quaternion=tuple(float(v) for v in frames.quaternion_to_unreal(shape.quaternion)),  # type: ignore[arg-type]
        vertices=tuple(_triple(v) for v in vertices),
    )


def _triple(values: Any) -> tuple[float, float, float]:
    x, y, z = (float(v) for v in values)
    return x, y, z


def _rounded(collision: tuple[Primitive, ...]) -> Any:
    def r(values: Any) -> Any:
        return tuple(round(float(v), ROUND_DIGITS) + 0.0 for v in values)

    return tuple(
        (p.kind, r(p.size), r(p.position), r(p.quaternion), tuple(r(v) for v in p.vertices))
        for p in collision
    )


def probes(asset: MeshAsset) -> tuple[Probe, ...]:
    """Query shapes of an asset.

    Spheres, boxes and capsules are exact. A tall cylinder becomes the capsule inside it, a flat one
    a box of the same area, a hull the largest box of its own proportions inside it: stand-ins never
    report an overlap of more than the hull's own.
    """
    return tuple(_probe(p) for p in asset.collision)


def _probe(p: Primitive) -> Probe:
    r, _, h = p.size
    if p.kind == "cylinder":
        if h >= r:
            return Probe("capsule", (r, r, h - r), p.position, p.quaternion)
        side = r * DISC_BOX
        return Probe("box", (side, side, h), p.position, p.quaternion)
    if p.kind == "convex":
        return _box_inside(p)
    return Probe(p.kind, p.size, p.position, p.quaternion)


def _box_inside(p: Primitive) -> Probe:
    """Largest box with the proportions of the hull's bounding box, centred on its vertices' box."""
    from scipy.spatial import ConvexHull

    from esg.units import quat_rotate

    points = np.asarray(p.vertices, float)
    low, high = points.min(0), points.max(0)
    half = (high - low) / 2
    hull = ConvexHull(points)
    center = points[hull.vertices].mean(0)
    # Farthest corner along each face normal n . x + d <= 0 limits the scale of the box.
    normals, offsets = hull.equations[:, :3], hull.equations[:, 3]
    room = -(normals @ center + offsets)
    reach = np.abs(normals) @ half
    scale = float(np.clip((room / np.maximum(reach, 1e-12)).min(), 1e-3, 1.0))
    where = np.asarray(p.position) + quat_rotate(p.quaternion, center)
    return Probe("box", _triple(half * scale), _triple(where), p.quaternion)
