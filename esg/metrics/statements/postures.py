"""How somebody holds his body: how high it is, and whether it rests on something."""

from __future__ import annotations

import numpy as np

from esg.lexicon.postures import STANDS, posture_of
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import lowest_curve, runs, touching
from esg.thresholds import MOST, POSTURE_S
from esg.units import quat_inverse, quat_rotate


def posture(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its body has the height of the posture, against that of it as it stands, and rests.

    At the start, at the end and throughout it is so then; between two moments it is for a while.
    """
    told, own = q.statement.noun or "", replay.scene.bodies[body]
    plan = "people" if own.half_extents[2] > own.half_extents[0] else "beasts"
    row = posture_of(plan, told)
    if row is None:
        return Kept(None, reason=f"nobody of its kind {told}")
    share = _heights(replay, body)[q.window.frames]
    rests = touching(replay, body)[q.window.frames]
    holds = (share >= row.least) & (share <= row.most) & rests
    if told != STANDS:
        holds &= replay.absent[q.window.frames, body]
    middle = float(np.median(share))
    measured = {"height_share": float(np.median(share[holds])) if holds.any() else middle}
    reason = f"its height is {middle:.2f} of what it is standing; {told}: "
    reason += f"{row.least:g} to {row.most:g}, on something"
    if ".." in q.statement.when:
        least = max(1, round(POSTURE_S / replay.frame_s))
        longest = max((stop - start for start, stop in runs(holds)), default=0)
        return Kept.when(longest >= least, reason, **measured)
    return Kept.when(float(holds.mean()) >= MOST, reason, **measured)


def _heights(replay: Replay, body: int) -> Floats:
    """Height of the posture that is there over that of who stands, shape [T]."""
    scene = replay.scene
    out = np.ones(len(replay.time))
    for name in scene.bodies[body].postures:
        k = scene.index(name)
        there = ~replay.absent[:, k]
        if there.any():
            high = _highest(replay, k)
            tall = 2.0 * scene.bodies[body].half_extents[2]
            out[there] = ((high - lowest_curve(replay, k)) / tall)[there]
    return out


def _highest(replay: Replay, body: int) -> Floats:
    """Height of a body's highest point over time [m], shape [T]."""
    up = quat_rotate(quat_inverse(replay.quaternion[:, body]), np.array([0.0, 0.0, 1.0]))
    reach = [(up @ c.points.T).max(axis=1) + c.radius for c in replay.cores[body]]
    return np.max(reach, axis=0) + replay.position[:, body, 2]
