"""How something moves: rolling, sliding, spinning, upright, still, in the air, and how fast."""

from __future__ import annotations

import numpy as np

from esg.engines.scene import Body
from esg.metrics.binding import Binding
from esg.metrics.events import names, pairs
from esg.metrics.events.space import is_over
from esg.metrics.joined import held, joined
from esg.metrics.replay import GROUND_INDEX, Floats, Replay
from esg.metrics.statements.place import mostly
from esg.metrics.statements.query import Kept, StatementQuery
from esg.metrics.support import contact_times, on_ground, touching
from esg.thresholds import (
    AT_REST_MPS,
    BRAKED_TO,
    ROLLING,
    ROLLING_SHARE,
    SLIDING,
    SPUN_DEG,
    STILL_M,
    STOPPED_MPS,
    TUMBLED_DEG,
    UPRIGHT_DEG,
    WHEELS_DEG,
)
from esg.units import quat_rotate


def rolls(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its spin is that of rolling while it moves on its support."""
    low, high = ROLLING
    return _spin_share(replay, q, body, "rolls", low, high)


def slides(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It hardly spins while it moves on its support."""
    return _spin_share(replay, q, body, "slides", -np.inf, SLIDING)


def _spin_share(
    replay: Replay, q: StatementQuery, body: int, verb: str, low: float, high: float
) -> Kept:
    frames = q.window.frames
    moves = (replay.speed[:, body] > STOPPED_MPS)[frames]
    on_rails = [j for j in joined(replay) if j.joint.kind == "slider"]
    guided = held(tuple(on_rails), body, len(replay.time))
    counted = moves & (touching(replay, body) | guided)[frames]
    if not counted.any():
        reason = "never touches anything while it moves" if moves.any() else "does not move"
        return Kept(False, reason=reason)
    ratio = spin_ratio(replay, body)[frames][counted]
    share = float(np.mean((ratio >= low) & (ratio <= high)))
    typical = float(np.median(ratio))
    limits = f"{low:g} to {high:g}" if np.isfinite(low) else f"under {high:g}"
    return Kept.when(
        share >= ROLLING_SHARE,
        f"{verb} for {100 * share:.0f}% of its way, limit {100 * ROLLING_SHARE:.0f}%: its spin is "
        f"{typical:.2f} of rolling ({limits})",
        share=share,
        spin_ratio=typical,
    )


def spin_ratio(replay: Replay, body: int) -> Floats:
    """Spin about the axis that the motion would roll about, over v/r; 0 at rest, shape [T].

    Wheels are not simulated: upright on them and along its heading a wheeled body rolls (1), else
    it slides (0).
    """
    b = replay.scene.bodies[body]
    velocity = replay.velocity[:, body]
    level = np.hypot(velocity[:, 0], velocity[:, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        if b.wheeled:
            forward = quat_rotate(replay.quaternion[:, body], np.array([1.0, 0.0, 0.0]))
            along = np.abs((forward * velocity).sum(axis=1)) / replay.speed[:, body]
            upright = replay.up(body)[:, 2] >= np.cos(np.radians(UPRIGHT_DEG))
            out = upright & (along >= np.cos(np.radians(WHEELS_DEG)))
            return out.astype(float)
        axis = np.stack([-velocity[:, 1], velocity[:, 0], np.zeros(len(level))], axis=1)
        about = (replay.spin[:, body] * axis).sum(axis=1) / level
        ratio = about * rolling_radius(b) / replay.speed[:, body]
    return np.nan_to_num(ratio, nan=0.0, posinf=0.0, neginf=0.0)


def rolling_radius(body: Body) -> float:
    """Radius on which a body rolls [m]: of its round shapes, else the middle one of its half
    extents.
    """
    if body.roll_radius > 0:
        return body.roll_radius
    round_ = [s.size[0] for s in body.shapes if s.kind in ("sphere", "capsule", "cylinder")]
    return max(round_) if round_ else sorted(body.half_extents)[1]


def spins(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It turns about its vertical."""
    rate = replay.spin[q.window.frames, body, 2]
    turned = abs(float(np.degrees(rate.sum() * replay.frame_s)))
    reason = f"turns by {turned:.0f} degrees about its vertical; limit {SPUN_DEG:.0f}"
    return Kept.when(turned >= SPUN_DEG, reason, turned_deg=turned)


def tumbles(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It turns over from how it was."""
    up = replay.up(body)[q.window.frames]
    tilt = float(np.degrees(np.arccos(np.clip(up @ up[0], -1.0, 1.0))).max())
    reason = f"tilts by {tilt:.0f} degrees at most; limit {TUMBLED_DEG:.0f}"
    return Kept.when(tilt >= TUMBLED_DEG, reason, tilt_deg=tilt)


def airborne(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Nothing touches it."""
    return mostly(~touching(replay, body)[q.window.frames], "stay in the air")


def stays_upright(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its up axis stays near the vertical."""
    up = replay.up(body)[q.window.frames, 2]
    tilt = float(np.degrees(np.arccos(np.clip(up, -1.0, 1.0))).max())
    reason = f"tilts by {tilt:.0f} degrees; limit {UPRIGHT_DEG:.0f}"
    return Kept.when(tilt < UPRIGHT_DEG, reason, tilt_deg=tilt)


def stays_still(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It stays where it is."""
    path = replay.position[q.window.frames, body]
    moved = float(np.linalg.norm(path - path[0], axis=1).max())
    reason = f"moves by {100 * moved:.0f} cm; limit {100 * STILL_M:.0f} cm"
    return Kept.when(moved < STILL_M, reason, moved_m=moved)


def at_rest(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It has no speed."""
    speed = float(replay.speed[q.window.frames, body].max())
    reason = f"moves at up to {speed:.2f} m/s; limit {AT_REST_MPS:g} m/s"
    return Kept.when(speed < AT_REST_MPS, reason, speed_mps=speed)


def slower_than(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its largest speed stays under a limit; of a deceleration, how hard it brakes."""
    if q.statement.quantity == "deceleration":
        return _brakes(replay, q, body, hard=False)
    speed = float(replay.speed[q.window.frames, body].max())
    limit = q.limits()[1]
    if limit is None:
        return Kept(None, reason="names no speed")
    reason = f"moves at up to {speed:.2f} m/s; limit {limit:g} m/s"
    return Kept.when(speed < limit, reason, speed_mps=speed)


def faster_than(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """Its largest speed is over a limit; of a deceleration, how hard it brakes."""
    if q.statement.quantity == "deceleration":
        return _brakes(replay, q, body, hard=True)
    speed = float(replay.speed[q.window.frames, body].max())
    limit = q.limits()[0]
    if limit is None:
        return Kept(None, reason="names no speed")
    reason = f"moves at {speed:.2f} m/s at most; needs more than {limit:g} m/s"
    return Kept.when(speed > limit, reason, speed_mps=speed)


def _brakes(replay: Replay, q: StatementQuery, body: int, *, hard: bool) -> Kept:
    """Its mean deceleration, from the start of a braking until half of its speed is left."""
    limit, rates = q.limits()[0 if hard else 1], list[float]()
    for time in replay.brakings(body):
        begin = replay.frame_before(time) if time > 0 else 0
        later = replay.speed[begin:, body]
        slow = np.flatnonzero(later <= BRAKED_TO * later[0])
        if q.window.contains(time, replay) and len(slow) and later[0] > STOPPED_MPS:
            lost = float(later[0] - later[slow[0]])
            rates.append(lost / (max(int(slow[0]), 1) * replay.frame_s))
    if limit is None or not rates:
        return Kept(None if limit is None else False, reason="never brakes to half of its speed")
    rate = max(rates)
    needs = "needs more than" if hard else "limit"
    reason = f"brakes at {rate:.1f} m/s^2; {needs} {limit:g} m/s^2"
    return Kept.when(rate > limit if hard else rate < limit, reason, deceleration_mps2=rate)


def touches(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """The two touch."""
    contact = _first_contact(replay, q, body)
    return Kept(False, reason=f"never touches {q.goal}") if contact is None else contact[0]


def never_touches(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """The two do not touch."""
    contact = _first_contact(replay, q, body)
    if contact is None:
        return Kept(True)
    return Kept(False, contact[0].measured, f"touches {contact[1]}")


def _first_contact(replay: Replay, q: StatementQuery, body: int) -> tuple[Kept, str] | None:
    """The first touch in the time, and with whom."""
    first: tuple[float, str] | None = None
    for _, other in pairs(Binding("", bodies=(body,)), q.target):
        if other == GROUND_INDEX:
            times = replay.time[on_ground(replay, body)]
        elif not replay.cores[other]:
            times = replay.time[on_ground(replay, body) & is_over(replay, body, other)]
        else:
            times = contact_times(replay, body, other)
        seen = [float(t) for t in times if q.window.contains(float(t), replay)]
        if seen and (first is None or seen[0] < first[0]):
            first = seen[0], names(replay, (other,))[0]
    if first is None:
        return None
    return Kept(True, {"time_s": first[0]}), f"{first[1]} at {first[0]:.2f} s"
