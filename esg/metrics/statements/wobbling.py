"""Whether something wobbles: it leans to one side, to the other and back, and does not fall."""

from __future__ import annotations

import numpy as np

from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.lying import turned_by
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import TOPPLED_DEG, WOBBLES_DEG, WOBBLES_TIMES
from esg.units import quat_multiply, quat_rotate


def wobbles(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its own upright axis swings through where it ends, `WOBBLES_TIMES` sides on end."""
    quaternion = quat_multiply(replay.quaternion[q.window.frames, body], turned_by(replay, body))
    axis = quat_rotate(quaternion, np.array([0.0, 0.0, 1.0]))
    if float(np.degrees(np.arccos(np.clip(axis[-1, 2], -1.0, 1.0)))) > TOPPLED_DEG:
        return Kept(False, reason="falls over")
    rest = axis[-max(1, len(axis) // 4) :].mean(axis=0)
    rest /= np.linalg.norm(rest)
    lean = axis - (axis @ rest)[:, None] * rest
    most = lean[np.argmax(np.linalg.norm(lean, axis=1))]
    along = most / max(float(np.linalg.norm(most)), 1e-12)
    swings = _swings(np.degrees(np.arcsin(np.clip(lean @ along, -1.0, 1.0))))
    reason = (
        f"leans to {len(swings)} sides on end by {WOBBLES_DEG:g} degrees; needs {WOBBLES_TIMES}"
    )
    return Kept.when(
        len(swings) >= WOBBLES_TIMES, reason, lean_deg=max(swings, default=0.0), swings=len(swings)
    )


def _swings(lean: Floats) -> list[float]:
    """Greatest leans of the sides on end that are leant to by enough [degrees]."""
    out: list[float] = []
    side = 0.0
    for v in lean:
        if abs(v) < WOBBLES_DEG:
            continue
        if np.sign(v) != side:
            side = float(np.sign(v))
            out.append(0.0)
        out[-1] = max(out[-1], float(abs(v)))
    return out
