"""Where bodies are in the liquids of vessels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Region
from esg.lexicon.contents import CONTENT, contents
from esg.metrics.replay import Replay
from esg.units import quat_rotate


def content_name(region: Region) -> str:
    """Of which content a region is."""
    return region.name.rpartition("/")[2]


def is_liquid(region: Region) -> bool:
    """Whether a region is a liquid."""
    row = contents().get(content_name(region)) if region.kind == CONTENT else None
    return row is not None and row.liquid


def over_basin(
    replay: Replay, body: int, region: Region, frames: slice | NDArray[np.int64]
) -> tuple[NDArray[np.bool_], NDArray[np.float64]]:
    """Per frame: whether a centre of mass is between the sides of a region, and its level [m]."""
    vessel = replay.scene.index(region.parent)
    half = np.array(region.half_extents)
    turn, at = replay.quaternion[frames, vessel], replay.position[frames, vessel]
    middle = at + quat_rotate(turn, np.array(region.center)[None])
    inverse = turn * np.array([-1.0, -1.0, -1.0, 1.0])
    off = quat_rotate(inverse, replay.position[frames, body] - middle)
    return np.all(np.abs(off[:, :2]) <= half[:2], axis=1), middle[:, 2] + half[2]


def in_liquid(replay: Replay, body: int) -> NDArray[np.bool_]:
    """Per frame: whether some of a body is in a liquid."""
    out = np.zeros(len(replay.time), bool)
    regions = [r for r in replay.scene.regions if is_liquid(r)]
    for region in (r for r in regions if r.parent != replay.scene.bodies[body].name):
        over, level = over_basin(replay, body, region, slice(None))
        rows = quat_rotate(replay.quaternion[:, body][:, None], np.eye(3)[None])[..., 2]
        half = np.abs(rows) @ np.array(replay.scene.bodies[body].half_extents)
        out |= over & (replay.position[:, body, 2] - half < level)
    return out
