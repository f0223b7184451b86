"""The meshes of a dressing: each thing's own, in the world, a mesh a surface."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import dataclass
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets import build_mesh
from esg.assets.library.catalogue import entries_by_name
from esg.assets.looks import Color, Look
from esg.assets.materials import look_of
from esg.dressing.builders import BUILDERS, Wish
from esg.dressing.solids import Drawing
from esg.graph.models import AssetConfiguration, Dressing, DressingItem, Marking, Vec3
from esg.lexicon.places import surfaces
from esg.machine.recent import Recent
from esg.units import CM_PER_M

Floats = NDArray[np.float64]
LAYER_M = 0.001
"""Markings lie so much above each other: what stands on them is sunk by no more than two of it."""
ROUND_SIDES = 48


@dataclass(frozen=True)
class Mesh:
    """Triangles of one look, fixed to the world.

    Args:
        name: Id of its thing, "/" and its surface; what stands at a wall is a part of the wall.
        vertices: [m], shape [n, 3].
        faces: Counter-clockwise seen from outside, shape [m, 3].
        normals: At the vertices, shape [n, 3].
        uvs: At the vertices in tiles, v up, shape [n, 2].
        look: Its surface.
        color: sRGB, of the surface on average.
    """

    name: str
    vertices: Floats
    faces: NDArray[np.int64]
    normals: Floats
    uvs: Floats
    look: Look
    color: Color


def _bytes(meshes: list[Mesh]) -> int:
    return sum(a.nbytes for m in meshes for a in (m.vertices, m.faces, m.normals, m.uvs))


_kept: Recent[Hashable, list[Mesh]] = Recent(16 * 2**20, _bytes)
"""What the library drew: what stands in a row is built once."""


def surface_look(name: str, color: Color | None = None) -> tuple[Look, Color]:
    """How a surface looks in a colour, or in its usual one, and that colour (sRGB).

    Args:
        name: Row of the table of surfaces.
        color: sRGB in [0, 1]; None for the usual one.
    """
    from esg.assets.materials import MATERIALS

    row = surfaces()[name]
    shown = color or row.rgb
    look = look_of(row.material, shown, roughness=row.roughness)
    return look, shown or MATERIALS[row.material].color


def meshes_of(dressing: Dressing) -> Iterator[Mesh]:
    """Every mesh of a dressing, markings first.

    Args:
        dressing: Of a verified document.
    """
    for number, marking in enumerate(dressing.markings, 1):
        yield _marking(marking, number)
    night = "night" in dressing.sky
    for item in dressing.items:
        yield from _standing(item, night)


def _standing(item: DressingItem, night: bool) -> Iterator[Mesh]:
    yaw = math.radians(item.yaw_deg)
    turn = np.array(
        [[math.cos(yaw), math.sin(yaw), 0.0], [-math.sin(yaw), math.cos(yaw), 0.0], [0, 0, 1.0]]
    )
    at = np.array(item.position_cm) / CM_PER_M
    key = (item.kind, item.size_cm, item.surface, item.color_rgb, item.variant, night)
    built = item.kind in BUILDERS
    for own in _built(*key) if built else _kept.get(key, lambda: _library(*key)):
        name = f"{item.id}/{own.name}" if item.wall is None else f"{item.wall}/{item.id}_{own.name}"
        yield Mesh(
            name,
            own.vertices @ turn + at,
            own.faces,
            own.normals @ turn,
            own.uvs,
            own.look,
            own.color,
        )


def _built(
    kind: str, size_cm: Vec3, surface: str | None, color: Color | None, variant: int, night: bool
) -> list[Mesh]:
    drawing = Drawing(np.random.default_rng(variant), night=night)
    depth, width, height = (c / CM_PER_M for c in size_cm)
    BUILDERS[kind].run(drawing, Wish(depth, width, height, surface or "", color))
    out: list[Mesh] = []
    for solid in drawing.solids():
        look, shown = surface_look(solid.surface, solid.color)
        out.append(
            Mesh(
                solid.surface,
                solid.vertices,
                solid.faces,
                solid.normals,
                solid.uvs / look.tile_m,
                look,
                shown,
            )
        )
    return out


def _library(
    kind: str, size_cm: Vec3, surface: str | None, color: Color | None, variant: int, night: bool
) -> list[Mesh]:
    """An entry of the parametric library."""
    entry = entries_by_name()[kind]
    config = AssetConfiguration(
        asset_name=kind,
        source="parametric",
        category=kind,
        mesh_path="",
        dimensions_cm=size_cm,
        mass_kg=entry.mass_kg,
        is_movable=entry.movable,
        friction=0.5,
        restitution=0.2,
        color_rgb=color or entry.color_rgb,
    )
    return [piece for piece in _merged(build_mesh(config))]


def _merged(scene: Any) -> Iterator[Mesh]:
    """The geometries of an asset [m], those of one look as one."""
    groups: dict[Look, list[tuple[Floats, NDArray[np.int64], Floats, Floats, Color]]] = {}
    for name in sorted(scene.graph.nodes_geometry):
        transform, geometry_name = scene.graph[name]
        geometry = scene.geometry[geometry_name]
        look = geometry.metadata.get("look")
        if look is None or not len(geometry.faces):
            continue
        turn = transform[:3, :3]
        vertices = (np.asarray(geometry.vertices, float) @ turn.T + transform[:3, 3]) / CM_PER_M
        uv = getattr(geometry.visual, "uv", None)
        groups.setdefault(look, []).append(
            (
                vertices,
                np.asarray(geometry.faces),
                np.asarray(geometry.vertex_normals, float) @ turn.T,
                np.zeros((len(vertices), 2)) if uv is None else np.asarray(uv, float),
                geometry.metadata.get("color") or look.color,
            )
        )
    for look, members in groups.items():
        starts = np.cumsum([0, *(len(m[0]) for m in members[:-1])])
        yield Mesh(
            look.material,
            np.concatenate([m[0] for m in members]),
            np.concatenate([m[1] + s for m, s in zip(members, starts, strict=True)]),
            np.concatenate([m[2] for m in members]),
            np.concatenate([m[3] for m in members]),
            look,
            members[0][4],
        )


def _marking(marking: Marking, number: int) -> Mesh:
    look, shown = surface_look(marking.surface)
    (a, b), (x, y) = marking.half_cm, marking.center_cm
    half = np.array([a, b]) / CM_PER_M
    outline = _outline(marking.shape)
    flat = outline * half
    n = len(outline)
    k = np.arange(n)
    if marking.line_cm is None:
        flat = np.concatenate([[[0.0, 0.0]], flat])
        faces = np.stack([np.zeros(n, int), 1 + k, 1 + (k + 1) % n], axis=1)
    else:
        inner = outline * np.maximum(half - marking.line_cm / CM_PER_M, 0.0)
        flat = np.concatenate([flat, inner])
        nxt = (k + 1) % n
        faces = np.concatenate(
            [np.stack([k, nxt, n + nxt], axis=1), np.stack([k, n + nxt, n + k], axis=1)]
        )
    yaw = math.radians(marking.yaw_deg)
    turn = np.array([[math.cos(yaw), math.sin(yaw)], [-math.sin(yaw), math.cos(yaw)]])
    height = np.full((len(flat), 1), LAYER_M * marking.layer)
    world = flat @ turn + np.array([x, y]) / CM_PER_M
    return Mesh(
        f"ground/{marking.surface}_{number}",
        np.concatenate([world, height], axis=1),
        faces,
        np.tile([0.0, 0.0, 1.0], (len(flat), 1)),
        flat / look.tile_m,
        look,
        shown,
    )


def _outline(shape: str) -> Floats:
    """Corners of the unit shape, counter-clockwise, shape [n, 2]."""
    if shape == "rectangle":
        return np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
    angles = np.arange(ROUND_SIDES) * (2 * math.pi / ROUND_SIDES)
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)
