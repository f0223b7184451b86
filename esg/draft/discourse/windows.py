"""Time windows of point events, in topological order."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from esg.graph.models import (
    EdgeEvent,
    EventConstraint,
    Interval,
    NodeEvent,
    Quantity,
    TimelineEdge,
)

START = "scene_start"
GAP_S = 0.1
EARLIER, LATER = 0.8, 1.3
"""How much sooner or later than by its stated way and speed something may happen."""
_DURATIONS: dict[NodeEvent, tuple[float, float]] = {
    NodeEvent.COLLISION: (0.5, 2.0),
    NodeEvent.TRIGGER: (0.5, 1.5),
    NodeEvent.HEADING_REACHED: (0.5, 2.5),
    NodeEvent.STOP: (0.5, 4.0),
    NodeEvent.ENTER_REGION: (0.2, 3.0),
    NodeEvent.TOPPLE: (0.05, 2.0),
    NodeEvent.FALL: (0.05, 2.0),
    NodeEvent.REACH: (0.5, 3.0),
    NodeEvent.MISS: (0.5, 2.5),
    NodeEvent.POSITION_AT: (0.5, 3.0),
    NodeEvent.PICKED_UP: (0.3, 3.0),
    NodeEvent.PLACED: (0.8, 8.0),
    NodeEvent.BOUNCE: (0.3, 6.0),
    NodeEvent.JUMP: (0.2, 5.0),
    NodeEvent.SPIN: (0.5, 5.0),
    NodeEvent.OPEN: (0.2, 5.0),
    NodeEvent.CLOSE: (0.2, 8.0),
    NodeEvent.SWING: (0.1, 10.0),
    NodeEvent.BREAK: (0.0, 2.0),
}
"""Shortest and longest time since the event before, where the prompt states none [s]."""


@dataclass
class Draft:
    """A point event under construction."""

    id: str
    event: NodeEvent
    participants: tuple[str, ...]
    description: str
    time: Quantity | None = None
    time_prescribed: bool = False
    constraints: list[EventConstraint] = field(default_factory=list[EventConstraint])
    extra: dict[str, Any] = field(default_factory=dict[str, Any])
    usual: float | None = None
    """Time from the event before that follows from what the prompt states [s]."""
    after: list[str] = field(default_factory=list[str])
    """Events that come before without a common actor."""


def _bounds(value: Quantity) -> Interval:
    return value if isinstance(value, tuple) else (value, value)


@dataclass
class _Plan:
    """What the windows have to respect.

    Args:
        before: What has to be over before an event.
        ancestors: All that comes before it.
        relative: Events a stated time after another, and that time.
        cap: Widest window of what a stated time counts from [s].
        inside: Room for what happens within a stated time [s].
    """

    before: dict[str, set[str]]
    ancestors: dict[str, set[str]] = field(default_factory=dict[str, set[str]])
    relative: dict[str, tuple[str, Interval]] = field(
        default_factory=dict[str, tuple[str, Interval]]
    )
    cap: dict[str, float] = field(default_factory=dict[str, float])
    inside: dict[str, float] = field(default_factory=dict[str, float])


def plan_times(nodes: list[Draft], edges: list[TimelineEdge]) -> dict[str, Interval]:
    """Timestamp or window of every point event [s].

    Nodes come in an order in which predecessors are first. A stated absolute time stays; relative
    times (time_since, time_to_stop) shift the window of the event they count from, which is kept
    no wider than the stated time so that both can be met; all other windows follow their
    predecessors with a gap. Events before a stated time are squeezed into the time left.
    """
    plan = _Plan({n.id: set(n.after) for n in nodes})
    for e in edges:
        if e.from_ != START and e.to in plan.before:
            plan.before[e.to].add(e.from_)
    for n in nodes:
        earlier = (plan.ancestors.get(p, set()) for p in plan.before[n.id])
        plan.ancestors[n.id] = plan.before[n.id].union(*earlier)
    for n in nodes:
        for c in n.constraints:
            _relate(plan, nodes, edges, n, c)
    by_id = {n.id: n for n in nodes}
    scale, spans = 1.0, _place(plan, nodes, 1.0)
    for _ in range(12):
        squeeze = 1.0
        for n in nodes:
            if n.time is None or not n.time_prescribed:
                continue
            low, high = _bounds(n.time)
            limit = max(low, 0.5 * high)  # an upper bound leaves half of it to what comes before
            free = (p for p in plan.ancestors[n.id] if not by_id[p].time_prescribed)
            latest = max((spans[p][1] for p in free), default=0.0)
            if latest > limit * 0.95 and limit > 0.0:
                squeeze = min(squeeze, 0.9 * limit / latest)
        if squeeze >= 1.0:
            break
        scale *= squeeze
        spans = _place(plan, nodes, scale)
    return spans


def _relate(
    plan: _Plan, nodes: list[Draft], edges: list[TimelineEdge], n: Draft, c: EventConstraint
) -> None:
    """Notes a stated time between two events."""
    since = c.since
    if c.quantity == "time_to_stop":
        brakes = (e.from_ for e in edges if e.to == n.id and e.event is EdgeEvent.BRAKE)
        since = next(brakes, None)
    if c.quantity not in ("time_since", "time_to_stop") or since not in plan.before:
        return
    plan.relative[n.id] = (since, _bounds(c.value))
    asked = _bounds(c.value)[0]
    between = [
        m.id for m in nodes if m.id in plan.ancestors[n.id] and since in plan.ancestors[m.id]
    ]
    if asked <= 0.0:
        return  # at the same time: the same window
    plan.cap[since] = max(0.05, (0.3 if between else 0.8) * asked)
    for name in between:  # what happens meanwhile has to fit in
        share = 0.5 * asked / len(between)
        plan.inside[name] = min(plan.inside.get(name, share), share)


def _place(plan: _Plan, nodes: list[Draft], scale: float) -> dict[str, Interval]:
    """Windows one after another, where nothing else is stated in usual times times `scale`."""
    spans: dict[str, Interval] = {}
    for n in nodes:
        first = not plan.before[n.id]
        ready = max((spans[p][1] for p in plan.before[n.id] if p in spans), default=0.0)
        since, (a, b) = plan.relative.get(n.id, ("", (0.0, 0.0)))
        if n.time is not None and n.time_prescribed:
            low, high = _bounds(n.time)
            low = ready if low < ready < high else low  # "brakes at 3 s and stops by 5 s"
        elif since in spans:
            soon = GAP_S if a == 0.0 < b else 0.0  # soon after it, not with it
            low = max(spans[since][0] + a, ready + soon)
            high = max(low, spans[since][1] + b)
        else:
            short, long = _DURATIONS[n.event]
            if n.usual is not None:
                short, long = EARLIER * n.usual, LATER * n.usual
            gap = GAP_S * min(scale, 1.0)
            low = short * scale if first else ready + gap * scale
            width = (long - short) * scale
            if n.id in plan.inside and not first:
                low = ready + min(gap, 0.2 * plan.inside[n.id])
                width = min(width, 0.7 * plan.inside[n.id])
            high = low + min(width, plan.cap.get(n.id, width))
        spans[n.id] = (round(low, 4), round(high, 4))
    return spans
