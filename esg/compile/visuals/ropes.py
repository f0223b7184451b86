"""Ropes and springs as meshes that follow their ends."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Look
from esg.engines.joints import Joint, Path, joint_ends, joint_poses
from esg.engines.scene import SimScene
from esg.thresholds import PIECE_GAP_M
from esg.units import quat_from_down

Floats = NDArray[np.float64]

THICKNESS = 0.005
"""Radius of a rope by its length, within `RADII_M`."""
RADII_M = (0.0015, 0.012)
COIL = 4.0
"""Radius of a spring's coil by that of its wire."""
TURNS, STEPS, SIDES = 12, 12, 6
WIRE = 0.006
"""Half height of a spring's wire by its length."""
LOOKS = {
    "rope": Look("rope", (0.55, 0.44, 0.30), roughness=0.9),
    "spring": Look("steel", (0.56, 0.57, 0.58), roughness=0.35, metalness=1.0),
}


@dataclass(frozen=True)
class Rope:
    """A rope or spring, frame by frame.

    Args:
        name: Of the joint.
        kind: rope or spring.
        radius: Of the rope or of the spring's coil [m].
        position: Its upper end in the world [m], shape [T, 3].
        quaternion: Turns -Z toward its other end, shape [T, 4].
        length: From end to end [m], shape [T]; 0 once it has broken.
    """

    name: str
    kind: str
    radius: float
    position: Floats
    quaternion: Floats
    length: Floats


def ropes_of(scene: SimScene, position: Path, quaternion: Path) -> list[Rope]:
    """The ropes and springs of a scene that moves.

    Args:
        scene: Bodies and joints.
        position: Of all bodies [m], shape [T, B, 3].
        quaternion: Of all bodies (x, y, z, w), shape [T, B, 4].
    """
    return [_rope(scene, j, position, quaternion) for j in scene.joints if j.flexible]


def _rope(scene: SimScene, joint: Joint, position: Path, quaternion: Path) -> Rope:
    top, bottom = joint_ends(joint, *joint_poses(scene, joint, position, quaternion))
    along = bottom - top
    length = np.linalg.norm(along, axis=1)
    least, most = RADII_M
    radius = float(np.clip(THICKNESS * (joint.upper or length.max()), least, most))
    if joint.kind == "rope" and joint.upper is not None:
        broken = np.maximum.accumulate(length > joint.upper + PIECE_GAP_M)
        length = np.where(broken, 0.0, length)
    else:
        radius *= COIL
    safe = np.where(length > 0.0, length, 1.0)[:, None]
    down = np.where(length[:, None] > 0.0, along / safe, (0.0, 0.0, -1.0))
    return Rope(joint.name, joint.kind, radius, top, quat_from_down(down), length)


@cache
def rope_mesh(kind: str, turns: int = TURNS) -> tuple[Floats, NDArray[np.int64], Floats]:
    """Vertices, faces and normals of a rope or spring of radius 1 from 0 to -1 along Z.

    Args:
        kind: rope or spring.
        turns: Of a spring; those of a whole one are `TURNS`.
    """
    turn = np.linspace(0.0, 2 * np.pi * turns, turns * STEPS + 1 if kind == "spring" else 2)
    outward = np.stack([np.cos(turn), np.sin(turn), np.zeros(len(turn))], axis=1)
    upward = np.array([0.0, 0.0, 1.0])
    around = np.linspace(0.0, 2 * np.pi, SIDES, endpoint=False)[:, None]
    cosine, sine = np.cos(around), np.sin(around)
    middle = np.outer(-np.linspace(0.0, 1.0, len(turn)), upward)
    if kind == "spring":
        # Across it is scaled by centimetres, along by metres: the wire is flat along.
        normals = cosine * outward[:, None] - sine * upward
        rings = (middle + outward)[:, None] + normals * (1 / COIL, 1 / COIL, WIRE * TURNS / turns)
    else:
        normals = cosine * np.array([1.0, 0.0, 0.0]) + sine * np.array([0.0, -1.0, 0.0])
        normals = np.broadcast_to(normals, (len(turn), SIDES, 3))
        rings = middle[:, None] + normals
    first, beside = np.arange(SIDES), (np.arange(SIDES) + 1) % SIDES
    start = SIDES * np.arange(len(turn) - 1)[:, None]
    quads = np.stack([first + start, beside + start, beside + start + SIDES, first + start + SIDES])
    quads = np.moveaxis(quads, 0, -1).reshape(-1, 4)
    faces = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return rings.reshape(-1, 3), faces, normals.reshape(-1, 3)
