"""Climbing: up or down something, or over it, at its surface all the way."""

from __future__ import annotations

import numpy as np

from esg.metrics.events.space import is_over, surface_distance
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import Frames, bounds, lowest_curve
from esg.thresholds import (
    CLIMBED_SHARE,
    CLIMBED_SIZE,
    CLIMBED_TOLERANCE,
    CLIMBING_M,
    MOST,
    SAMPLE_S,
    STILL_M,
)


def climbs(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It gets up or down the target, or over it, and keeps within reach of its surface."""
    things = [j for j in q.target.bodies if j != body]
    if not things:
        return Kept(False, reason=f"{q.goal} is nothing to climb")
    low = lowest_curve(replay, body)[q.window.frames]
    direction = q.statement.direction or "up"
    if direction == "across":
        return _over(replay, q, body, low, things)
    sign = 1.0 if direction == "up" else -1.0
    rise = sign * replay.position[q.window.frames, body, 2]
    turn = int(np.argmax(rise >= rise.max() - STILL_M))
    gained = float(rise[turn] - rise[: turn + 1].min())
    begin = turn - int(np.argmin(rise[: turn + 1][::-1]))
    size = 2.0 * max(replay.scene.bodies[body].half_extents)
    boxes = [bounds(replay, j, q.window.first) for j in things]
    need = CLIMBED_SHARE * min(float(high[2] - base[2]) for base, high in boxes)
    need = min(need, CLIMBED_SIZE * size)
    measured = {"rises_m": sign * gained}
    least, most = q.limits()
    if least is not None and most is not None:
        need = (1.0 - CLIMBED_TOLERANCE) * least
        if gained > (1.0 + CLIMBED_TOLERANCE) * most:
            return Kept(False, measured, f"climbs {gained:.2f} m; asked for {most:.2f} m")
    if gained < need:
        verb = "rises" if direction == "up" else "sinks"
        return Kept(False, measured, f"{verb} by {gained:.2f} m at {q.goal}; needs {need:.2f} m")
    off = low[begin : turn + 1] > min(low[begin], low[turn]) + STILL_M
    return _at_surface(replay, q, body, begin + np.flatnonzero(off), measured)


def _at_surface(
    replay: Replay, q: StatementQuery, body: int, frames: Frames, measured: dict[str, float]
) -> Kept:
    """Whether it is near the target at most of some frames of the window."""
    step = max(1, round(SAMPLE_S / replay.frame_s))
    samples = q.window.first + frames[::step]
    reach = min(CLIMBING_M, 2.0 * max(replay.scene.bodies[body].half_extents))
    gaps = np.array([surface_distance(replay, body, q.target, int(k)) for k in samples])
    if not len(gaps):
        return Kept(False, measured, f"does not leave the ground at {q.goal}")
    share = float((gaps <= reach).mean())
    widest = float(gaps.max())
    reason = f"gets {100 * widest:.0f} cm away from {q.goal}; limit {100 * reach:.0f} cm"
    return Kept.when(share >= MOST, reason, **measured, gap_m=widest)


def _over(replay: Replay, q: StatementQuery, body: int, low: Floats, things: list[int]) -> Kept:
    """Over: up one side, across the top, and down on another side."""
    path = replay.position[q.window.frames, body, :2]
    reason = f"never is over {q.goal}"
    for other in things:
        top = float(bounds(replay, other, q.window.first)[1][2])
        above = is_over(replay, body, other)[q.window.frames] & (low >= top - CLIMBING_M)
        seen = np.flatnonzero(above)
        if not len(seen):
            continue
        highest = int(seen[len(seen) // 2])
        down = low[highest:] <= low[0] + STILL_M
        if not down.any():
            reason = f"does not get down from {q.goal}"
            continue
        end = highest + int(np.argmax(down))
        came, left = path[highest] - path[0], path[end] - path[highest]
        if float(came @ left) <= 0.0:
            reason = f"comes down from {q.goal} where it went up"
            continue
        off = np.flatnonzero(low[:end] > low[0] + STILL_M)
        return _at_surface(replay, q, body, off, {"rises_m": float(low.max() - low[0])})
    return Kept(False, reason=reason)
