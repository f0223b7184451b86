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
EARLY_S: Interval = (0.1, 0.2)
"""When a manoeuvre begins that begins at once [s]."""
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
    constraints: list[EventConstraint] = field(default_factory=list)
    extra: dict[str, Any] = field(default_factory=dict)
    usual: float | None = None
    """Time from the event before that follows from what the prompt states [s]."""
    after: list[str] = field(default_factory=list)
    """Events that come before without a common actor."""


def _bounds(value: Quantity) -> Interval:
    return value if isinstance(value, tuple) else (value, value)


def settle_ambiguous(nodes: list[Draft], edges: list[TimelineEdge]) -> None:
    """Lets a manoeuvre begin at once where a time may count from it as well as from the start.

    "A car drives at 15 m/s, slows down and hits a cone after 4 seconds": if it slows down at once
    the hit is 4 s after both, whichever was meant.
    """
    by_id = {n.id: n for n in nodes}
    led_to = {e.to for e in edges if e.from_ != START}
    for n in nodes:
        for c in n.constraints:
            since = by_id.get(c.since or "") if c.quantity == "time_since" else None
            if since is None or since.event is not NodeEvent.TRIGGER or since.time is not None:
                continue
            own = since.participants[:1] == n.participants[:1]
            if own and not since.constraints and not since.after and since.id not in led_to:
                since.time, since.time_prescribed = EARLY_S, True


def plan_times(nodes: list[Draft], edges: list[TimelineEdge]) -> dict[str, Interval]:
    """Timestamp or window of every point event [s].

    Nodes come in an order in which predecessors are first. A stated absolute time stays; relative
    times (time_since, time_to_stop) shift the window of the event they count from, which is kept
    no wider than the stated time so that both can be met; all other windows follow their
    predecessors with a gap. Events before a stated time are squeezed into the time left.
    """
    before: dict[str, set[str]] = {n.id: set(n.after) for n in nodes}
    for e in edges:
        if e.from_ != START and e.to in before:
            before[e.to].add(e.from_)
    by_id = {n.id: n for n in nodes}

    ancestors: dict[str, set[str]] = {}
    for n in nodes:
        found: set[str] = set()
        for p in before[n.id]:
            found |= {p} | ancestors.get(p, set())
        ancestors[n.id] = found

    relative: dict[str, tuple[str, Interval]] = {}
    cap: dict[str, float] = {}
    inside: dict[str, float] = {}
    for n in nodes:
        for c in n.constraints:
            since = c.since
            if c.quantity == "time_to_stop":
                since = next(
                    (e.from_ for e in edges if e.to == n.id and e.event is EdgeEvent.BRAKE), None
                )
            if c.quantity in ("time_since", "time_to_stop") and since in by_id:
                relative[n.id] = (since, _bounds(c.value))
                asked = _bounds(c.value)[0]
                between = [
                    m.id for m in nodes if m.id in ancestors[n.id] and since in ancestors[m.id]
                ]
                if asked <= 0.0:
                    continue  # at the same time: the same window
                cap[since] = max(0.05, (0.3 if between else 0.8) * asked)
                for name in between:  # what happens meanwhile has to fit in
                    share = 0.5 * asked / len(between)
                    inside[name] = min(inside.get(name, share), share)

    def place(scale: float, offset: dict[str, float]) -> dict[str, Interval]:
        spans: dict[str, Interval] = {}
        for n in nodes:
            ready = max((spans[p][1] for p in before[n.id] if p in spans), default=0.0)
            if n.time is not None and n.time_prescribed:
                low, high = _bounds(n.time)
                if low < ready < high:
                    low = ready  # "brakes at 3 s and stops by 5 s"
                spans[n.id] = (round(low, 4), round(high, 4))
                continue
            if n.id in relative and relative[n.id][0] in spans:
                since, (a, b) = relative[n.id]
                low, high = spans[since][0] + a, spans[since][1] + b
                low = max(low, ready)
                spans[n.id] = (round(low, 4), round(max(low, high), 4))
                continue
            short, long = _DURATIONS[n.event]
            if n.usual is not None:
                short, long = EARLIER * n.usual, LATER * n.usual
            gap = GAP_S * min(scale, 1.0)
            low = ready + (short if not before[n.id] else gap) * scale
            low = low if before[n.id] else short * scale
            width = (long - short) * scale
            if n.id in inside and before[n.id]:
                low = ready + min(gap, 0.2 * inside[n.id])
                width = min(width, 0.7 * inside[n.id])
            if n.id in cap:
                width = min(width, cap[n.id])
            spans[n.id] = (round(low, 4), round(low + width, 4))
        return spans

    spans = place(1.0, {})
    scale = 1.0
    for _ in range(12):
        squeeze = 1.0
        for n in nodes:
            if n.time is None or not n.time_prescribed:
                continue
            low, high = _bounds(n.time)
            limit = max(low, 0.5 * high)  # an upper bound leaves half of it to what comes before
            latest = max(
                (spans[p][1] for p in ancestors[n.id] if not by_id[p].time_prescribed), default=0.0
            )
            if latest > limit * 0.95 and limit > 0.0:
                squeeze = min(squeeze, 0.9 * limit / latest)
        if squeeze >= 1.0:
            break
        scale *= squeeze
        spans = place(scale, {})
    return spans
