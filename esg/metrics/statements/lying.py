"""How things lie and stand: which of their own axes points up, and whether they rest."""

from __future__ import annotations

import numpy as np

from esg.lexicon.lying import poses, ups
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import touching
from esg.thresholds import MOST
from esg.units import quat_inverse, quat_multiply, quat_rotate

_UNTURNED = (0.0, 0.0, 0.0, 1.0)


def turned_by(replay: Replay, body: int) -> Floats:
    """How the model of a body is turned from how it is drawn, (x, y, z, w)."""
    return np.asarray(replay.scene.bodies[body].turned or _UNTURNED)


def lies(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """An own axis that its pose lets point up does, within the pose's limit, and it rests.

    The axes are those of its model as it is usually drawn, its proportions those of what collides.
    """
    row = poses().get(q.statement.noun or "")
    if row is None:
        return Kept(None, reason=f"nothing lies {q.statement.noun}")
    frames = q.window.samples(replay)
    turned = turned_by(replay, body)
    size = _extents(replay, body, turned)
    if size is None:
        return Kept(None, reason="it has no body")
    # Heights of the own axes' ends, shape [T, 3].
    own = quat_rotate(quat_multiply(replay.quaternion[frames, body], turned)[:, None], np.eye(3))
    allowed = [sign * own[:, axis, 2] for axis, sign in ups(row.name, size)]
    off = np.degrees(np.arccos(np.clip(np.max(allowed, axis=0), -1.0, 1.0)))
    holds = off <= row.within_deg
    if not replay.scene.bodies[body].static and q.statement.when != "start":
        holds &= touching(replay, body)[frames]
    middle, share = float(np.median(off)), float(holds.mean())
    reason = f"it is {middle:.0f} degrees off lying {row.name}; limit {row.within_deg:.0f}"
    if middle <= row.within_deg:
        reason = f"for {100 * (1 - share):.0f}% of the time it does not lie {row.name}"
    return Kept.when(share >= MOST, reason, off_deg=middle)


def _extents(replay: Replay, body: int, turned: Floats) -> tuple[float, float, float] | None:
    """Extents along the own axes of its model as it is drawn [m]."""
    cores = replay.cores[body]
    if not cores:
        return None
    back = quat_inverse(turned)
    points = [(quat_rotate(back, c.points), c.radius) for c in cores]
    low = np.min([p.min(axis=0) - r for p, r in points], axis=0)
    high = np.max([p.max(axis=0) + r for p, r in points], axis=0)
    x, y, z = (float(v) for v in high - low)
    return x, y, z
