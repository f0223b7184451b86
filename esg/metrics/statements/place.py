"""Where something is: on, in, above, hanging from, leaning on, and where it ends."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from esg.metrics.events.space import inside_volume, is_over, surface_distance, volumes
from esg.metrics.joined import chains, hook, joined, together
from esg.metrics.replay import Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import (
    Bools,
    Frames,
    bounds,
    carried,
    carried_by,
    local_position,
    lowest_curve,
)
from esg.thresholds import (
    ABOVE_TOLERANCE,
    AT_REST_MPS,
    CARRIED_M,
    LEANING_DEG,
    MEETS_M,
    MOMENT_S,
    MOST,
    NEAR_END_M,
    STILL_M,
    TOGETHER_M,
)
from esg.units import quat_rotate

OfBody = Callable[[Replay, StatementQuery, int], Kept]


def mostly(held: Bools, what: str, **measured: float) -> Kept:
    """Kept if something holds in `MOST` of the samples [n]; of one sample, if it holds there."""
    share = float(held.mean()) if len(held) else 0.0
    if len(held) == 1:
        return Kept.when(share == 1.0, f"does not {what}", **measured)
    reason = f"does {what} for {100 * share:.0f}% of the time; limit {100 * MOST:.0f}%"
    if share == 0.0:
        reason = f"does not {what}"
    return Kept.when(share >= MOST, reason, share=share, **measured)


def supported_by(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """The target carries it, or carries what of the same set carries it."""
    samples = q.window.samples(replay)
    held = _carried_in_set(replay, q, body, samples, frozenset())
    gap = surface_distance(replay, body, q.target, int(samples[0]))
    return mostly(held, f"rest on {q.goal}", gap_m=gap)


def _carried_in_set(
    replay: Replay, q: StatementQuery, body: int, frames: Frames, above: frozenset[int]
) -> Bools:
    held = carried(replay, body, q.target, frames) | _seated(replay, body, q, frames)
    for other in q.object.bodies:
        if other == body or other in above or held.mean() >= MOST:
            continue
        on_it = carried_by(replay, body, other, frames)
        if on_it.any():
            held = held | (on_it & _carried_in_set(replay, q, other, frames, above | {body}))
    return held


def _seated(replay: Replay, body: int, q: StatementQuery, frames: Frames) -> Bools:
    """Held to the target from above: who sits behind another rider, over no surface of it."""
    out = np.zeros(len(frames), bool)
    for j in joined(replay):
        if j.joint.kind == "fixed" and j.child == body and j.parent in q.target.bodies:
            above = lowest_curve(replay, body) > replay.position[:, j.parent, 2]
            out |= (j.intact & above)[frames]
    return out


def within(replay: Replay, q: StatementQuery, body: int) -> Bools:
    """Frames at which the centre of a body is in the target, shape [T]."""
    out = np.zeros(len(replay.time), bool)
    for region, container in volumes(replay, q.target):
        if container != body:
            out |= inside_volume(replay, body, region, container)[0]
    return out


def inside(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its centre is in the target's inside."""
    held = within(replay, q, body)[q.window.samples(replay)]
    return mostly(held, f"lie inside {q.goal}")


def above(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is clear of the target and over its footprint, at the stated distance."""
    samples = q.window.samples(replay)
    low = lowest_curve(replay, body)[samples]
    gap = low if q.target.ground else np.full(len(samples), np.nan)
    for other in q.target.bodies:
        if other == body:
            continue
        top = np.array([bounds(replay, other, int(k))[1][2] for k in samples])
        here = is_over(replay, body, other)[samples]
        gap = np.where(here & ~(gap <= low - top), low - top, gap)
    least, most = q.limits()
    kept = gap > MEETS_M
    wanted = ""
    if least is not None and most is not None:
        kept &= (gap >= least * (1 - ABOVE_TOLERANCE)) & (gap <= most * (1 + ABOVE_TOLERANCE))
        wanted = f" at {least:g} m" if least == most else f" at {least:g} to {most:g} m"
    seen = gap[np.isfinite(gap)]
    if not len(seen):
        return Kept(False, reason=f"is not over {q.goal}")
    return mostly(kept, f"stay clear above {q.goal}{wanted}", gap_m=float(np.median(seen)))


def attached_to(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Something holds the two together."""
    return _held(replay, q, body, lower=False)


def under(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """The target is over it: its centre lies within the target's outline, and lower."""
    samples = q.window.samples(replay)
    held = np.zeros(len(samples), bool)
    for other in (j for j in q.target.bodies if j != body):
        over = is_over(replay, body, other)[samples]
        held |= over & (replay.position[samples, body, 2] < replay.position[samples, other, 2])
    return mostly(held, f"stay under {q.goal}")


def on_side(side: str) -> OfBody:
    """A measure of being on a side of the target, in the viewer's directions: left is +X.

    Of the two horizontal offsets of their centres, the one to that side is the larger.
    """
    axis, sign = {"left": (0, 1), "right": (0, -1), "front": (1, 1), "behind": (1, -1)}[side]
    words = {"front": "in front of", "behind": "behind"}.get(side, f"{side} of")

    def measure(replay: Replay, q: StatementQuery, body: int) -> Kept:
        samples = q.window.samples(replay)
        held, last = np.zeros(len(samples), bool), 0.0
        for other in (j for j in q.target.bodies if j != body):
            offset = replay.position[samples, body] - replay.position[samples, other]
            off = sign * offset[:, axis]
            held |= (off > 0.0) & (off >= np.abs(offset[:, 1 - axis]))
            last = float(off[-1])
        return mostly(held, f"stay {words} {q.goal}", offset_m=last)

    return measure


def hangs_from(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Something holds the two together, and it is the lower one."""
    return _held(replay, q, body, lower=True)


def _held(replay: Replay, q: StatementQuery, body: int, *, lower: bool) -> Kept:
    """Joints hold them together, or both are fixed and touch."""
    samples = q.window.samples(replay)
    first = int(samples[0])
    name, centre = replay.scene.bodies[body].name, float(replay.position[first, body, 2])
    held = np.zeros(len(samples), bool)
    below = max((float(replay.position[first, j, 2]) for j in q.target.bodies), default=centre)
    below -= centre
    for other in (j for j in q.target.bodies if j != body):
        held |= together(replay, body, other)[samples]
        ends = [a for way in chains(replay, joined(replay), body, other) for a in way[-1:]]
        below = max([below, *(float(hook(replay, j)[first, 2]) - centre for j in ends)])
    if held.any():
        if lower and below <= 0.0:
            return Kept(False, {"below_m": below}, f"is not below {q.goal}")
        return mostly(held, f"stay held by {q.goal}", below_m=below)
    gap = surface_distance(replay, body, q.target, int(samples[0]))
    if gap > CARRIED_M:
        return Kept(False, {"gap_m": gap}, f"is {100 * gap:.0f} cm away from {q.goal}")
    fixed = [j for j in q.target.bodies if replay.scene.bodies[j].static]
    if not replay.scene.bodies[body].static or not fixed:
        return Kept(False, {"gap_m": gap}, f"no joint or rope holds {name} and {q.goal} together")
    if lower:
        return Kept.when(below > 0, f"is not below {q.goal}", gap_m=gap, below_m=below)
    return Kept(True, {"gap_m": gap})


def leans_on(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It touches the target, and none of its axes is upright."""
    samples = q.window.samples(replay)
    axes = quat_rotate(replay.quaternion[samples, body][:, None], np.eye(3)[None])
    slant = np.degrees(np.arccos(np.clip(np.abs(axes[..., 2]).max(axis=1), 0.0, 1.0)))
    gap = np.array([surface_distance(replay, body, q.target, int(k)) for k in samples])
    measured = {"slant_deg": float(np.median(slant)), "gap_m": float(np.median(gap))}
    if np.mean(gap <= CARRIED_M) < MOST:
        return Kept(False, measured, f"does not touch {q.goal}")
    return mostly(slant >= LEANING_DEG, f"lean on {q.goal}, but stands straight", **measured)


def carried_along(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It keeps its place in the axes of the target, and the target moves."""
    best = Kept(False, reason=f"nothing called {q.goal} moves")
    frames = q.window.frames
    for other in q.target.bodies:
        way = float(np.linalg.norm(np.ptp(replay.position[frames, other], axis=0)))
        if other == body or way < STILL_M:
            continue
        own = local_position(replay, body, other)[frames]
        stray = float(np.linalg.norm(own - own[0], axis=1).max())
        found = Kept.when(
            stray <= TOGETHER_M, f"strays by {100 * stray:.0f} cm from {q.goal}; limit 5 cm",
            strays_m=stray, moved_m=way,
        )  # fmt: skip
        best = best if best.kept else found
    return best


def _end_speed(replay: Replay, body: int) -> float:
    last = max(1, round(MOMENT_S / replay.frame_s))
    return float(np.median(replay.speed[-last:, body]))


def _ends(replay: Replay, body: int, there: bool, reason: str, **measured: float) -> Kept:
    speed = _end_speed(replay, body)
    measured["end_speed_mps"] = speed
    if speed > AT_REST_MPS:
        return Kept(False, measured, f"still moves at {speed:.2f} m/s at the end")
    return Kept.when(there, reason, **measured)


def ends_on(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is at rest on the target at the end."""
    last = np.array([len(replay.time) - 1])
    there = bool(carried(replay, body, q.target, last)[0])
    gap = surface_distance(replay, body, q.target, int(last[0]))
    reason = f"ends {100 * max(gap, 0.0):.0f} cm away from {q.goal}"
    if gap <= CARRIED_M:
        reason = f"ends beside {q.goal}, not on it"
    return _ends(replay, body, there, reason, gap_m=gap)


def ends_in(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is at rest in the target at the end."""
    gap = surface_distance(replay, body, q.target, len(replay.time) - 1)
    there = bool(within(replay, q, body)[-1])
    return _ends(replay, body, there, f"does not end inside {q.goal}", gap_m=gap)


def ends_near(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It is at rest near the target at the end."""
    gap = surface_distance(replay, body, q.target, len(replay.time) - 1)
    limit = max(NEAR_END_M, 2.0 * max(replay.scene.bodies[body].half_extents))
    reason = f"ends {gap:.2f} m away from {q.goal}; limit {limit:.2f} m"
    return _ends(replay, body, gap <= limit, reason, distance_m=gap)
