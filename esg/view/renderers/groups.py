"""Meshes for renderers that keep one material a mesh: all parts of one look that move as one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.units import quat_rotate
from esg.view.pieces import Movers, Part
from esg.view.tracer.stage import surface


@dataclass
class Group:
    """All parts of one look that move as one.

    Args:
        mover: Index among `Movers`; -1 for the world.
        vertices: Shape [n, 3] [m].
        normals: At the vertices, shape [n, 3]; None for flat faces.
    """

    mover: int
    look: Look
    vertices: NDArray[np.float32]
    faces: NDArray[np.uint32]
    normals: NDArray[np.float32] | None
    uvs: NDArray[np.float32]


def groups(parts: Iterable[Part], movers: Movers) -> list[Group]:
    """Parts of one look, one pose and one kind of normals together."""
    found: dict[tuple[int, Look, bool], list[Part]] = {}
    for part in parts:
        if len(part.faces):
            key = (movers.of(part), surface(part), part.normals is not None)
            found.setdefault(key, []).append(part)
    out: list[Group] = []
    for (mover, look, smooth), members in found.items():
        starts = np.cumsum([0, *(len(p.vertices) for p in members[:-1])])
        faces = [p.faces + s for p, s in zip(members, starts, strict=True)]
        uvs = [np.zeros((len(p.vertices), 2)) if p.uvs is None else p.uvs for p in members]
        normals = [p.normals for p in members if p.normals is not None] if smooth else None
        out.append(
            Group(
                mover,
                look,
                np.concatenate([p.vertices for p in members]).astype(np.float32),
                np.concatenate(faces).astype(np.uint32),
                np.concatenate(normals).astype(np.float32) if normals else None,
                np.concatenate(uvs).astype(np.float32),
            )
        )
    return out


def moved(
    group: Group, position: NDArray[Any], quaternion: NDArray[Any]
) -> tuple[NDArray[np.float32], NDArray[np.float32] | None]:
    """Vertices and normals of a group in the world, for poses of all movers."""
    at, turn = position[group.mover], quaternion[group.mover]
    vertices = quat_rotate(turn, group.vertices.astype(np.float64)) + at
    normals = None
    if group.normals is not None:
        normals = quat_rotate(turn, group.normals.astype(np.float64)).astype(np.float32)
    return vertices.astype(np.float32), normals
