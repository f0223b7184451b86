"""Ropes and springs of a scene: where they run, and what they look like."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.compile.visuals.ropes import LOOKS, TURNS, rope_mesh, ropes_of
from esg.engines.joints import WORLD, joint_ends, joint_poses
from esg.engines.scene import Rollout, SimScene
from esg.thresholds import PIECE_GAP_M
from esg.view.pieces import Part, Strand


def ropes_at(scene: SimScene, rollout: Rollout, frame: int) -> list[NDArray[np.float64]]:
    """Ends [m] of the ropes and springs that hold at a frame of the first world, each [2, 3]."""
    p, q = rollout.position[0, frame], rollout.quaternion[0, frame]
    out: list[NDArray[np.float64]] = []
    for joint in scene.joints:
        if not joint.flexible:
            continue
        ends = np.array(joint_ends(joint, *joint_poses(scene, joint, p, q)))
        slack = joint.upper if joint.kind == "rope" and joint.upper is not None else np.inf
        if float(np.linalg.norm(ends[1] - ends[0])) <= slack + PIECE_GAP_M:
            out.append(ends)
    return out


def rope_parts(scene: SimScene, rollout: Rollout) -> list[Part]:
    """The ropes and springs of the first world in pieces, which follow their ends.

    Args:
        scene: Bodies and joints.
        rollout: Their motion, by which it is known how long a spring becomes.
    """
    out: list[Part] = []
    joints = [j for j in scene.joints if j.flexible]
    ropes = ropes_of(scene, rollout.position[0], rollout.quaternion[0])
    for joint, rope in zip(joints, ropes, strict=True):
        piece = float(rope.length.max()) / TURNS
        vertices, faces, normals = rope_mesh(rope.kind, 1)
        upper = -1 if joint.parent == WORLD else scene.index(joint.parent)
        bodies = upper, scene.index(joint.child)
        anchors = joint.parent_anchor, joint.child_anchor
        look, longest = LOOKS[rope.kind], np.inf
        if rope.kind == "rope" and joint.upper is not None:
            longest = joint.upper + PIECE_GAP_M
        out += [
            Part(
                -1,
                vertices * (rope.radius, rope.radius, piece),
                faces,
                look.color,
                look=look,
                normals=normals,
                name=rope.kind,
                strand=Strand(bodies, anchors, piece, k / (TURNS - 1), longest),
            )
            for k in range(TURNS)
        ]
    return out
