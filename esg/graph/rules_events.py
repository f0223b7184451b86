"""Rules on point events: participants, times, fields and constraints."""

from __future__ import annotations

from esg.graph.context import TIME_EPS_S, Context, bounds, reachable, time_span
from esg.graph.models import (
    EventConstraint,
    NodeEvent,
    Quantity,
    Role,
    TimelineNode,
    TimelineSystem,
)
from esg.graph.rules_scene import interval, outside
from esg.graph.violations import listing, pointer

E = NodeEvent
TIME_S = (0.0, 600.0)
MAX_SPEED_CM_S = 15_000.0

PAIRS = frozenset({E.COLLISION, E.REACH, E.MISS, E.PLACED, E.BOUNCE})
JOINTED = frozenset({E.OPEN, E.CLOSE, E.SWING})
"""What happens to a joint."""
SINGLES = JOINTED | {E.BREAK, E.POSITION_AT, E.ENTER_REGION, E.HEADING_REACHED, E.PICKED_UP, E.SPIN}

OWN_FIELDS: dict[str, tuple[NodeEvent, ...]] = {
    "position_cm": (E.POSITION_AT,),
    "region": (E.ENTER_REGION,),
    "turn_direction": (E.HEADING_REACHED,),
    "turn_degrees": (E.HEADING_REACHED, E.SPIN, E.OPEN, E.CLOSE),
    "times": (E.BOUNCE, E.JUMP, E.SWING),
}
"""Fields that only some events have."""
_NEEDED: dict[str, NodeEvent] = {
    "position_cm": E.POSITION_AT,
    "region": E.ENTER_REGION,
    "turn_direction": E.HEADING_REACHED,
    "turn_degrees": E.HEADING_REACHED,
}
MOST_TURNS_DEG = 7200.0
"""Of a spin; a turn of what drives has 720 at most."""
MOST_TIMES = 20
_CONSTRAINT_LIMITS: dict[str, tuple[float, float, str]] = {
    "speed_after": (0.0, MAX_SPEED_CM_S, "cm/s"),
    "speed_before": (0.0, MAX_SPEED_CM_S, "cm/s"),
    "time_since": (0.0, TIME_S[1], "s"),
    "time_to_stop": (0.0, TIME_S[1], "s"),
    "distance": (0.0, 2e4, "cm"),
    "height": (-2e4, 2e4, "cm"),
    "angle": (-720.0, 720.0, "degrees"),
}
_NODES = ("timeline_system", "sequence_graph", "nodes")
_EDGES = ("timeline_system", "sequence_graph", "edges")


def check(ctx: Context) -> None:
    """Adds violations of every point event."""
    timeline = ctx.doc.timeline_system
    if timeline is None:
        return
    for i, node in enumerate(timeline.sequence_graph.nodes):
        _event(ctx, timeline, i, node)


def _event(ctx: Context, timeline: TimelineSystem, i: int, node: TimelineNode) -> None:
    where = pointer(*_NODES, i)
    for k, name in enumerate(node.participants):
        if name not in ctx.node_names:
            ctx.add(
                "REF_PARTICIPANT",
                f"{where}/participants/{k}",
                name,
                f"{node.event.value} {node.id!r} names {name!r}, which is not a node.",
                f"Use one of {listing(ctx.node_names)}.",
            )
    _time(ctx, where, node)
    _participants(ctx, timeline, where, node)
    _fields(ctx, where, node)
    for k, constraint in enumerate(node.constraints):
        _constraint(ctx, f"{where}/constraints/{k}", node, constraint, timeline)
    _contradictions(ctx, where, node)


def _time(ctx: Context, where: str, node: TimelineNode) -> None:
    if node.event is E.SCENE_START:
        return
    what = f"{node.event.value} {node.id!r}"
    if node.timestamp is not None and node.window is not None:
        ctx.add(
            "TIME_BOTH",
            where,
            {"timestamp": node.timestamp, "window": list(node.window)},
            f"{what} has a timestamp and a window.",
            "Keep the timestamp if the prompt states the time, else the window.",
        )
    span = time_span(node)
    if span is None:
        if ctx.parsed.intact(*_NODES):
            ctx.add(
                "TIME_MISSING",
                where,
                None,
                f"{what} has neither a timestamp nor a window.",
                "Give the time the prompt states, else a plausible window [earliest, latest] in s.",
            )
        return
    if node.window is not None:
        interval(ctx, where + "/window", node.window)
    if outside(span[0], TIME_S) or outside(span[1], TIME_S):
        field = "window" if node.window is not None else "timestamp"
        ctx.add(
            "TIME_RANGE",
            f"{where}/{field}",
            list(span) if node.window is not None else node.timestamp,
            f"{what} happens at {span[0]:g} to {span[1]:g} s.",
            f"Use {TIME_S[0]:g} to {TIME_S[1]:g} s.",
        )


def _participants(ctx: Context, timeline: TimelineSystem, where: str, node: TimelineNode) -> None:
    if node.event is E.SCENE_START or not ctx.parsed.intact(*_NODES):
        return
    count, distinct = len(node.participants), len(set(node.participants))
    need = "two" if node.event in PAIRS else "one" if node.event in SINGLES else "at least one"
    wrong = count != {"two": 2, "one": 1}.get(need, count) or count == 0
    if wrong or distinct != count:
        ctx.add(
            "EVENT_PARTICIPANTS",
            where + "/participants",
            list(node.participants),
            f"{node.event.value} {node.id!r} has {count} participants ({distinct} different).",
            f"Name {need}, each once.",
        )
    actors = [timeline.actors[p] for p in node.participants if p in timeline.actors]
    if not actors and count and ctx.parsed.intact("timeline_system", "actors"):
        ctx.add(
            "EVENT_NO_ACTOR",
            where + "/participants",
            list(node.participants),
            f"No participant of {node.event.value} {node.id!r} is an actor, so nothing causes it.",
            "List what moves, or is moved, among the actors.",
        )
    if node.event is E.COLLISION and count == 2:
        _mover(ctx, where, node)
    if node.event in JOINTED:
        _jointed(ctx, where, node)
    if node.event is E.BREAK:
        _breaking(ctx, where, node)
    if node.event is E.TRIGGER:
        for k, name in enumerate(node.participants):
            actor = timeline.actors.get(name)
            if actor is not None and actor.role is Role.PASSIVE:
                ctx.add(
                    "TRIGGER_PASSIVE",
                    f"{where}/participants/{k}",
                    name,
                    f"Trigger {node.id!r} controls {name!r}, which is passive.",
                    "Make it active, or use an event that physics brings about.",
                )


def _jointed(ctx: Context, where: str, node: TimelineNode) -> None:
    held = {name for j in ctx.graph.joints or () for name in (j.child, j.parent)}
    if not ctx.parsed.intact("spatial_relation_graph"):
        return
    for k, name in enumerate(node.participants):
        if name in ctx.node_names and name not in held:
            ctx.add(
                "EVENT_NO_JOINT",
                f"{where}/participants/{k}",
                name,
                f"{node.event.value} {node.id!r} is of {name!r}, which no joint holds.",
                "Add the joint to spatial_relation_graph.joints, or name what a joint holds.",
            )


def _breaking(ctx: Context, where: str, node: TimelineNode) -> None:
    for k, name in enumerate(node.participants):
        if name in ctx.nodes and ctx.nodes[name].breaking is None:
            ctx.add(
                "EVENT_UNBROKEN",
                f"{where}/participants/{k}",
                name,
                f"{node.event.value} {node.id!r} is of {name!r}, which does not break.",
                f"Give /spatial_relation_graph/nodes/{name} its `breaking`.",
            )


def _mover(ctx: Context, where: str, node: TimelineNode) -> None:
    leads = ctx.actors_leading_to.get(node.id, ())
    first, second = node.participants
    if first not in ctx.node_names:
        return  # Reported as REF_PARTICIPANT already.
    if second in leads and first not in leads and ctx.parsed.intact(*_EDGES):
        ctx.add(
            "EVENT_MOVER",
            where + "/participants/0",
            first,
            f"Collision {node.id!r} names {first!r} as the mover, but segments lead {second!r} to "
            "it.",
            f"Write {second!r} first: (mover, target).",
        )


def _fields(ctx: Context, where: str, node: TimelineNode) -> None:
    """Checks that a point event has the fields of its own type and no other's."""
    for field, owners in OWN_FIELDS.items():
        value = getattr(node, field)
        if value is None and node.event is _NEEDED.get(field) and ctx.parsed.intact(*_NODES):
            ctx.add(
                "EVENT_FIELD_MISSING",
                f"{where}/{field}",
                None,
                f"{node.event.value} {node.id!r} has no {field}.",
                f"Add {field!r}.",
            )
        elif value is not None and node.event not in owners:
            owner = " or ".join(o.value for o in owners)
            ctx.add(
                "EVENT_FIELD_FORBIDDEN",
                f"{where}/{field}",
                value,
                f"{node.event.value} {node.id!r} has {field!r}, which belongs to {owner}.",
                f"Remove it, or make the event {owner}.",
            )
    most = MOST_TURNS_DEG if node.event is E.SPIN else 720.0
    if node.turn_degrees is not None and not 0.0 < node.turn_degrees <= most:
        ctx.add(
            "EVENT_RANGE",
            where + "/turn_degrees",
            node.turn_degrees,
            f"A turn by {node.turn_degrees:g} degrees is not plausible.",
            f"Use more than 0 and at most {most:g}; turn_direction says which way.",
        )
    if node.times is not None and not 1 <= node.times <= MOST_TIMES:
        ctx.add(
            "EVENT_RANGE",
            where + "/times",
            node.times,
            f"{node.event.value} {node.id!r} happens {node.times} times.",
            f"Use 1 to {MOST_TIMES}.",
        )
    if node.position_cm is not None:
        low, high = ctx.doc.scene_definition.coordinate_system.world_bounds_cm
        if any(not low[k] <= node.position_cm[k] <= high[k] for k in range(3)):
            ctx.add(
                "EVENT_RANGE",
                where + "/position_cm",
                list(node.position_cm),
                f"The position of {node.id!r} lies outside the world.",
                f"Stay within {list(low)} to {list(high)} cm.",
            )
    if node.region is not None and node.event is E.ENTER_REGION:
        _named_region(ctx, where + "/region", node.region)


def _named_region(ctx: Context, where: str, text: str) -> None:
    owner, slash, name = text.partition("/")
    if not slash or not name.strip() or owner not in ctx.node_names:
        ctx.add(
            "REF_NAMED_REGION",
            where,
            text,
            f"Region {text!r} is not a node and one of its regions.",
            f"Write 'node/region name' with a node of {listing(ctx.node_names)}.",
        )
        return
    node = ctx.nodes.get(owner)
    configuration = ctx.configurations.get(node.asset_id) if node else None
    if configuration is None or not ctx.parsed.intact("asset_configurations"):
        return
    names = [r.name for r in configuration.regions]
    if name not in names:
        ctx.add(
            "REF_NAMED_REGION",
            where,
            text,
            f"{owner!r} ({configuration.asset_name}) has no region {name!r}.",
            f"Use one of {listing(names)}.",
        )


def _constraint(
    ctx: Context, where: str, node: TimelineNode, c: EventConstraint, timeline: TimelineSystem
) -> None:
    if c.object not in ctx.node_names:
        ctx.add(
            "REF_CONSTRAINT",
            where + "/object",
            c.object,
            f"A constraint of {node.id!r} is on {c.object!r}, which is not a node.",
            f"Use one of {listing(node.participants)}.",
        )
    elif (
        node.event is not E.SCENE_START
        and c.object not in node.participants
        and ctx.parsed.intact(*_NODES)
    ):
        ctx.add(
            "CONSTRAINT_OBJECT",
            where + "/object",
            c.object,
            f"{c.object!r} has a {c.quantity} at {node.id!r} but takes no part in it.",
            f"Use one of {listing(node.participants)}, or another event.",
        )
    _measured_to(ctx, where, c)
    _since(ctx, where, node, c, timeline)
    if isinstance(c.value, tuple) and not interval(ctx, where + "/value", c.value):
        return
    low, high, unit = _CONSTRAINT_LIMITS[c.quantity]
    lower, upper = bounds(c.value)
    if lower < low or upper > high:
        ctx.add(
            "CONSTRAINT_RANGE",
            where + "/value",
            c.value,
            f"{c.quantity} {c.value} {unit} is not plausible.",
            f"Use {low:g} to {high:g} {unit}.",
        )


def _measured_to(ctx: Context, where: str, c: EventConstraint) -> None:
    """The other end of a distance is another object."""
    if c.to is None:
        return
    if c.to not in ctx.node_names:
        ctx.add(
            "REF_CONSTRAINT",
            where + "/to",
            c.to,
            f"A distance of {c.object!r} is measured to {c.to!r}, which is not a node.",
            f"Use one of {listing(ctx.node_names)}.",
        )
    elif c.to == c.object or c.quantity != "distance":
        ctx.add(
            "CONSTRAINT_OBJECT",
            where + "/to",
            c.to,
            f"{c.quantity} of {c.object!r} is measured to {c.to!r}.",
            "Give `to` only to a distance, and name another object.",
        )


def _since(
    ctx: Context, where: str, node: TimelineNode, c: EventConstraint, timeline: TimelineSystem
) -> None:
    if c.since is None:
        if c.quantity == "time_since":
            ctx.add(
                "CONSTRAINT_SINCE",
                where,
                None,
                f"time_since of {node.id!r} names no earlier event.",
                "Set `since` to the id of the event the time counts from.",
            )
        return
    graph = timeline.sequence_graph
    if c.since not in ctx.event_names:
        ctx.add(
            "REF_EVENT",
            where + "/since",
            c.since,
            f"{node.id!r} counts time from {c.since!r}, which is not a point event.",
            f"Use one of {listing(n.id for n in graph.nodes)}.",
        )
        return
    later = reachable(node.id, [(e.from_, e.to) for e in graph.edges])
    if c.since == node.id or c.since in later:
        ctx.add(
            "CONSTRAINT_SINCE",
            where + "/since",
            c.since,
            f"{node.id!r} counts time from {c.since!r}, which is not earlier.",
            "Name an event that comes before.",
        )
        return
    _since_fits(ctx, where, node, c, timeline)


def _since_fits(
    ctx: Context, where: str, node: TimelineNode, c: EventConstraint, timeline: TimelineSystem
) -> None:
    """Compares a prescribed interval between two events with what their windows allow."""
    earlier = next((n for n in timeline.sequence_graph.nodes if n.id == c.since), None)
    begin = time_span(earlier) if earlier is not None else None
    end = time_span(node)
    if c.quantity != "time_since" or begin is None or end is None:
        return
    if any(outside(t, TIME_S) for t in (*begin, *end)):
        return  # Reported as TIME_RANGE already.
    low, high = bounds(c.value)
    least, most = end[0] - begin[1], end[1] - begin[0]
    if high < least - TIME_EPS_S or low > most + TIME_EPS_S:
        ctx.add(
            "CONSTRAINT_CONTRADICTION",
            where + "/value",
            c.value,
            f"{node.id!r} shall follow {c.since!r} by {c.value} s, but their windows allow "
            f"{least:g} to {most:g} s.",
            "Move a window, or correct the time.",
        )


def _contradictions(ctx: Context, where: str, node: TimelineNode) -> None:
    first: dict[tuple[str, str, str | None], Quantity] = {}
    for k, c in enumerate(node.constraints):
        key = (c.quantity, c.object, c.since or c.to)
        if key not in first:
            first[key] = c.value
            continue
        a, b = bounds(first[key]), bounds(c.value)
        if max(min(a), min(b)) > min(max(a), max(b)):
            ctx.add(
                "CONSTRAINT_CONTRADICTION",
                f"{where}/constraints/{k}/value",
                c.value,
                f"{c.quantity} of {c.object!r} at {node.id!r} is {first[key]} and {c.value}.",
                "Keep one of them.",
            )
