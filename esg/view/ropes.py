"""Ropes and springs of a scene, which have no mesh: where they run."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import joint_ends, joint_poses
from esg.engines.scene import Rollout, SimScene
from esg.thresholds import PIECE_GAP_M


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
