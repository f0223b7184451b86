"""What is stated of the scene as a whole: order of events, sizes, numbers, what is not there."""

from __future__ import annotations

from esg.engines.scene import Body
from esg.metrics.binding import named
from esg.metrics.replay import Replay
from esg.metrics.statements.query import Kept, StatementQuery
from esg.thresholds import BEFORE_S, SAME_TIME_S, SIZE_TOLERANCE


def _times(q: StatementQuery) -> tuple[float, float] | str:
    found: list[float] = []
    for event in (q.statement.a, q.statement.b):
        time = 0.0 if event == "start" else q.times.get(event or "")
        if time is None:
            return f"event {event} did not happen"
        found.append(time)
    return found[0], found[1]


def same_time(replay: Replay, q: StatementQuery) -> Kept:
    """Two events happen together."""
    times = _times(q)
    if isinstance(times, str):
        return Kept(False, reason=times)
    gap = abs(times[1] - times[0])
    reason = f"{gap:.2f} s lie between them; limit {SAME_TIME_S:g} s"
    # Binary rounding of decimal times must not decide the tie.
    return Kept.when(gap <= SAME_TIME_S + 1e-9, reason, gap_s=gap)


def before(replay: Replay, q: StatementQuery) -> Kept:
    """One event happens before another."""
    times = _times(q)
    if isinstance(times, str):
        return Kept(False, reason=times)
    lead = times[1] - times[0]
    word = f"only {lead:.2f} s before" if lead >= 0 else f"{-lead:.2f} s after"
    reason = f"{q.statement.a} comes {word} {q.statement.b}; limit {BEFORE_S:g} s before"
    return Kept.when(lead >= BEFORE_S - 1e-9, reason, lead_s=lead)


def size(replay: Replay, q: StatementQuery, body: int) -> Kept:
    """It has the stated size, or that of another thing."""
    quantity = q.statement.quantity or "size"
    own = _extent(replay.scene.bodies[body], quantity)
    low, high = q.limits()
    if q.alike.bodies:
        low = high = _extent(replay.scene.bodies[q.alike.bodies[0]], quantity)
    if low is None or high is None:
        return Kept(None, {f"{quantity}_m": own}, "names no size")
    wanted = f"{low:.2f} m" if low == high else f"{low:.2f} to {high:.2f} m"
    fits = low * (1 - SIZE_TOLERANCE) <= own <= high * (1 + SIZE_TOLERANCE)
    reason = f"its {quantity} is {own:.2f} m; {wanted} asked, limit {100 * SIZE_TOLERANCE:.0f}% off"
    return Kept.when(fits, reason, **{f"{quantity}_m": own})


def _extent(body: Body, quantity: str) -> float:
    """Height, length (the longer way on the ground), width or largest size of a body [m]."""
    x, y, z = (2.0 * h for h in body.half_extents)
    table = {"height": z, "length": max(x, y), "width": min(x, y)}
    return table.get(quantity, max(x, y, z))


def count(replay: Replay, q: StatementQuery) -> Kept:
    """So many of a kind are there."""
    s = q.statement
    bodies = q.object.bodies if s.object else named(s.noun or "", replay.scene)
    low, high = q.limits()
    if low is None or high is None:
        return Kept(None, reason="names no number")
    n = len(bodies)
    asked = f"{low:g}" if low == high else f"{low:g} to {high:g}"
    return Kept.when(low <= n <= high, f"{n} are there; {asked} asked", number=float(n))


def absent(replay: Replay, q: StatementQuery) -> Kept:
    """Nothing of a kind is there."""
    bodies = named(q.statement.noun or "", replay.scene, every=True)
    there = ", ".join(replay.scene.bodies[i].name for i in bodies)
    return Kept.when(not bodies, f"{there} is there", number=float(len(bodies)))
