"""Rules on motion segments: ends, roles, parameters and inertial connectors."""

from __future__ import annotations

from esg.graph.context import Context, bounds
from esg.graph.joints import KINDS_OF_JOINT, TOWED
from esg.graph.models import (
    EdgeEvent,
    ForceDirection,
    NodeEvent,
    Role,
    TimelineEdge,
    TimelineNode,
    TimelineSystem,
)
from esg.graph.rules_events import MAX_SPEED_CM_S
from esg.graph.rules_scene import interval, outside
from esg.graph.violations import listing, pointer
from esg.untyped import is_array

M = EdgeEvent
LEAST_SPEED_CM_S = 20.0
"""Below this, benchmark suites do not call it motion; intervals in m/s by mistake end here."""

LIMITS: dict[str, tuple[float, float, str]] = {
    "acceleration": (-2e4, 2e4, "cm/s^2"),
    "damping": (0.0, 100.0, "1/s"),
    "heading_deg": (-720.0, 720.0, "degrees"),
    "elevation_deg": (-90.0, 90.0, "degrees"),
    "turn_degrees": (0.0, 720.0, "degrees"),
    "turn_rate_deg_s": (0.0, 720.0, "degrees/s"),
    "duration": (0.0, 600.0, "s"),
    "lift_cm": (0.0, 5000.0, "cm"),
    "clearance_cm": (0.0, 5000.0, "cm"),
    "height_cm": (1.0, 1000.0, "cm"),
    "opening": (-2e4, 2e4, "degrees or cm"),
}
ONLY: dict[str, frozenset[EdgeEvent]] = {
    "damping": frozenset({M.BRAKE}),
    "elevation_deg": frozenset({M.TOWARD, M.UNIFORM_MOTION}),
    "turn_degrees": frozenset({M.TURN}),
    "turn_direction": frozenset({M.TURN, M.SPIN}),
    "turn_rate_deg_s": frozenset({M.TURN, M.SPIN}),
    "lift_cm": frozenset({M.GUIDE}),
    "clearance_cm": frozenset({M.GUIDE}),
    "release": frozenset({M.GUIDE}),
    "height_cm": frozenset({M.TOWARD, M.GUIDE}),
    "climbs": frozenset({M.GUIDE}),
    "posture": frozenset({M.GUIDE}),
    "opening": frozenset({M.DRIVE}),
}
"""Parameters that only some segments have; all others fit every driven segment."""

LEADS_TO: dict[NodeEvent, EdgeEvent] = {
    NodeEvent.PICKED_UP: M.GUIDE,
    NodeEvent.PLACED: M.GUIDE,
    NodeEvent.JUMP: M.TOWARD,
}
"""Events that only one type of segment of their first participant brings about."""
GUIDED_TO = frozenset(
    {NodeEvent.PICKED_UP, NodeEvent.PLACED, NodeEvent.TRIGGER, NodeEvent.ENTER_REGION}
)
"""Where a Guide may end."""

_NODES = ("timeline_system", "sequence_graph", "nodes")
_EDGES = ("timeline_system", "sequence_graph", "edges")
_PLACES = ("spatial_relation_graph",)


def check(ctx: Context) -> None:
    """Adds violations of motion segments."""
    timeline = ctx.doc.timeline_system
    if timeline is None:
        return
    graph = timeline.sequence_graph
    events = {n.id: n for n in reversed(graph.nodes)}
    for i, edge in enumerate(graph.edges):
        where = pointer(*_EDGES, i)
        _references(ctx, timeline, where, edge)
        _role(ctx, timeline, where, edge, events)
        check_parameters(ctx, timeline, where, edge, events)
        _guided_end(ctx, where, edge, events.get(edge.to))
        _joint_of(ctx, where, edge)
    for i, node in enumerate(graph.nodes):
        _brought_about(ctx, timeline, pointer(*_NODES, i), node)


def _guided_end(ctx: Context, where: str, edge: TimelineEdge, end: TimelineNode | None) -> None:
    if edge.event is not M.GUIDE or end is None or end.event in GUIDED_TO:
        return
    ctx.add(
        "GUIDE_END",
        where + "/to",
        edge.to,
        f"Guide {edge.id!r} leads to {edge.to!r}, which is a {end.event.value}.",
        f"Lead to one of {listing(e.value for e in GUIDED_TO)}; physics goes on from there.",
    )


def _joint_of(ctx: Context, where: str, edge: TimelineEdge) -> None:
    kinds = KINDS_OF_JOINT.get(edge.event)
    if kinds is None or not ctx.parsed.intact(*_PLACES):
        return
    if not any(j.child == edge.actor and j.kind in kinds for j in ctx.graph.joints or ()):
        ctx.add(
            "EDGE_NO_JOINT",
            where + "/actor",
            edge.actor,
            f"{edge.event.value} {edge.id!r} is of {edge.actor!r}, which hangs on no "
            f"{listing(kinds)}.",
            "Name the child of such a joint, or add it to spatial_relation_graph.joints.",
        )


def _brought_about(ctx: Context, timeline: TimelineSystem, where: str, node: TimelineNode) -> None:
    """Checks that what is placed, picked up or jumps is guided or launched there."""
    needed = LEADS_TO.get(node.event)
    if needed is None or not node.participants or not ctx.parsed.intact(*_EDGES):
        return
    leading = [e for e in timeline.sequence_graph.edges if e.to == node.id]
    if not leading or any(e.event is needed for e in leading):
        return  # What nothing leads to is reported as TIMELINE_UNREACHABLE.
    ctx.add(
        "EVENT_NOT_LED_TO",
        where + "/event",
        node.event.value,
        f"No {needed.value} leads {node.participants[0]!r} to {node.event.value} {node.id!r}.",
        f"Add a {needed.value} segment of it that ends there.",
    )


def _references(ctx: Context, timeline: TimelineSystem, where: str, edge: TimelineEdge) -> None:
    declared = ctx.event_names
    for key, name in (("from", edge.from_), ("to", edge.to)):
        if name not in declared:
            ctx.add(
                "REF_EVENT",
                f"{where}/{key}",
                name,
                f"Segment {edge.id!r} names {name!r}, which is not a point event.",
                f"Use one of {listing(declared)}.",
            )
    actors = ctx.actor_names
    if edge.actor not in actors:
        ctx.add(
            "REF_EDGE_ACTOR",
            where + "/actor",
            edge.actor,
            f"Segment {edge.id!r} moves {edge.actor!r}, which is not an actor.",
            f"Use one of {listing(actors)}, or add the actor.",
        )
    if edge.target is None:
        return
    if edge.target not in ctx.node_names:
        ctx.add(
            "REF_EDGE_TARGET",
            where + "/target",
            edge.target,
            f"Segment {edge.id!r} heads for {edge.target!r}, which is not a node.",
            f"Use one of {listing(ctx.node_names)}.",
        )
    if edge.target == edge.actor:
        ctx.add(
            "EDGE_TARGET_SELF",
            where + "/target",
            edge.target,
            f"Segment {edge.id!r} moves {edge.actor!r} towards itself.",
            "Name another object, or leave out the target.",
        )


def _role(
    ctx: Context,
    timeline: TimelineSystem,
    where: str,
    edge: TimelineEdge,
    events: dict[str, TimelineNode],
) -> None:
    actor = timeline.actors.get(edge.actor)
    if actor is None:
        return
    connector = edge.event is M.INERTIAL_CONNECTOR
    if connector and actor.role is Role.ACTIVE:
        ctx.add(
            "CONNECTOR_ACTIVE",
            where + "/event",
            edge.event.value,
            f"Segment {edge.id!r} is an inertial connector of {edge.actor!r}, which is active.",
            "Use a driven segment, or make the actor passive.",
        )
    if not connector and actor.role is Role.PASSIVE:
        ctx.add(
            "EDGE_ACTOR_PASSIVE",
            where + "/event",
            edge.event.value,
            f"Segment {edge.id!r} drives {edge.actor!r} ({edge.event.value}), which is passive.",
            "Make the actor active, or use InertialConnector after the collision that moves it.",
        )
    end, begin = events.get(edge.to), events.get(edge.from_)
    intact = ctx.parsed.intact(*_NODES)
    if end is not None and edge.actor not in end.participants and intact:
        code = "CONNECTOR_DOWNSTREAM" if connector else "EDGE_ACTOR_ABSENT"
        ctx.add(
            code,
            where + "/to",
            edge.to,
            f"Segment {edge.id!r} leads {edge.actor!r} to {edge.to!r}, in which it takes no part.",
            f"Lead to an event of {edge.actor!r}, or name the actor of {edge.to!r}.",
        )
    elif connector and end is not None and end.event in (NodeEvent.TRIGGER, NodeEvent.SCENE_START):
        ctx.add(
            "CONNECTOR_DOWNSTREAM",
            where + "/to",
            edge.to,
            f"Inertial connector {edge.id!r} leads to a {end.event.value}.",
            "Let it lead to the next collision or outcome of its body.",
        )
    intact = intact and ctx.parsed.intact(*_EDGES)
    passive = connector and actor.role is Role.PASSIVE and intact
    if passive and begin is not None and not _was_hit(ctx, edge, begin, events):
        ctx.add(
            "CONNECTOR_UPSTREAM",
            where + "/from",
            edge.from_,
            f"Inertial connector {edge.id!r} starts at {edge.from_!r}, where no collision has "
            f"moved {edge.actor!r} yet.",
            f"Start at a collision in which {edge.actor!r}, what it rests on, or another member of "
            "its plural is hit.",
        )


def _was_hit(
    ctx: Context, edge: TimelineEdge, begin: TimelineNode, events: dict[str, TimelineNode]
) -> bool:
    """Whether the body was hit at the begin or, if it takes part in that, at an event before it.

    A hit of what the body rests on, or of another member of its plural (a stack, a train), moves
    it too, and so does one of what hangs beside it (the balls of a cradle). What is drawn along is
    moved by who draws it, what stands on a flap by its opening.
    """
    if _drawn_by(ctx, edge.actor) & {*begin.participants}:
        return True
    movers = {edge.actor, *ctx.supports(edge.actor)} | _plural(ctx, edge.actor)
    movers |= _hung_beside(ctx, edge.actor)
    if edge.actor not in begin.participants:
        borne = bool(movers & {*begin.participants}) or not _support_known(ctx, edge.actor)
        return _gave_way(ctx, edge, begin) or (begin.event is NodeEvent.COLLISION and borne)
    seen: set[str] = set()
    stack = [begin.id]
    while stack:
        name = stack.pop()
        if name in seen or name not in events:
            continue
        seen.add(name)
        event = events[name]
        hit = event.event is NodeEvent.COLLISION and movers & {*event.participants}
        if hit or _gave_way(ctx, edge, event):
            return True
        stack.extend(ctx.events_before.get(name, ()))
    return False


def _gave_way(ctx: Context, edge: TimelineEdge, event: TimelineNode) -> bool:
    """Whether what a body stands on opens: a trapdoor."""
    below = {*ctx.supports(edge.actor)}
    return event.event is NodeEvent.OPEN and bool(below & {*event.participants})


def _drawn_by(ctx: Context, name: str) -> set[str]:
    """What draws a node along behind it, directly or over others."""
    ahead: set[str] = set()
    found = {name}
    while found:
        joints = ctx.graph.joints or ()
        tows = (j for j in joints if j.child in found and (j.parent_mount, j.child_mount) == TOWED)
        found = {j.parent for j in tows if j.parent is not None} - ahead
        ahead |= found
    return ahead


def _support_known(ctx: Context, name: str) -> bool:
    """Whether every region down to the ground is declared; if not, that is reported elsewhere."""
    if not ctx.parsed.intact(*_PLACES):
        return False
    for current in (name, *ctx.supports(name)):
        node = ctx.nodes.get(current)
        if node is None:
            return False
        if not node.is_structural and ctx.support_of(current) is None:
            return False
    return True


def _plural(ctx: Context, name: str) -> set[str]:
    """The other members of a node's plural."""
    node = ctx.nodes.get(name)
    if node is None or node.group is None:
        return set()
    return {other for other, n in ctx.nodes.items() if n.group == node.group and other != name}


def _hung_beside(ctx: Context, name: str) -> set[str]:
    """What hangs on joints from the same thing as a node."""
    joints = ctx.graph.joints or ()
    carriers = {j.parent for j in joints if j.child == name and j.parent is not None}
    return {j.child for j in joints if j.parent in carriers}


def check_parameters(
    ctx: Context,
    timeline: TimelineSystem,
    where: str,
    edge: TimelineEdge,
    events: dict[str, TimelineNode],
) -> None:
    params = edge.params
    at = where + "/params"
    if params.speed is not None:
        _speed(ctx, at + "/speed", edge)
    for name, limits in LIMITS.items():
        value: float | tuple[float, float] | None = getattr(params, name)
        if value is None:
            continue
        if isinstance(value, tuple) and not interval(ctx, f"{at}/{name}", value):
            continue
        low, high = bounds(value)
        if outside(low, limits[:2]) or outside(high, limits[:2]):
            ctx.add(
                "EDGE_PARAM_RANGE",
                f"{at}/{name}",
                value,
                f"{name} {value} {limits[2]} of {edge.id!r} is not plausible.",
                f"Use {limits[0]:g} to {limits[1]:g} {limits[2]}.",
            )
    connector = edge.event is M.INERTIAL_CONNECTOR
    for name, kinds in ONLY.items():
        value = getattr(params, name)
        if value is not None and not connector and edge.event not in kinds:
            ctx.add(
                "EDGE_PARAM_FORBIDDEN",
                f"{at}/{name}",
                value,
                f"{edge.event.value} {edge.id!r} has {name!r}.",
                f"Remove it, or make the segment {listing(k.value for k in kinds)}.",
            )
    if connector:
        _connector_parameters(ctx, at, edge)
    if edge.event is M.TURN:
        _turn(ctx, at, edge, events)
    _force(ctx, timeline, at, edge)


def _force(ctx: Context, timeline: TimelineSystem, at: str, edge: TimelineEdge) -> None:
    actor = timeline.actors.get(edge.actor)
    allowed = actor.force_direction if actor is not None else None
    elevation = edge.params.elevation_deg
    if allowed in (None, ForceDirection.ANY_3D) or elevation is None:
        return
    if bounds(elevation) != (0.0, 0.0):
        ctx.add(
            "EDGE_FORCE_DIRECTION",
            at + "/elevation_deg",
            elevation,
            f"{edge.id!r} leaves the ground, but {edge.actor!r} moves {allowed.value} only.",
            "Use force_direction ANY_3D, or remove the elevation.",
        )


def _speed(ctx: Context, where: str, edge: TimelineEdge) -> None:
    value = edge.params.speed
    if value is None or (isinstance(value, tuple) and not interval(ctx, where, value)):
        return
    low, high = bounds(value)
    if low < 0.0 or high > MAX_SPEED_CM_S:
        ctx.add(
            "UNIT_SPEED",
            where,
            value,
            f"Speed {value} cm/s of {edge.id!r} is not plausible.",
            f"Use 0 to {MAX_SPEED_CM_S:g} cm/s (the unit is cm/s; heading says which way).",
        )
    elif isinstance(value, tuple) and high < LEAST_SPEED_CM_S and not edge.speed_is_prescribed:
        ctx.add(
            "UNIT_SPEED",
            where,
            value,
            f"Speed {value} cm/s of {edge.id!r} is too slow to count as motion.",
            f"Let the interval reach {LEAST_SPEED_CM_S:g} cm/s or more (is it in m/s?).",
        )


def _connector_parameters(ctx: Context, at: str, edge: TimelineEdge) -> None:
    given = edge.params.model_dump(exclude_none=True, exclude={"spin"})
    if given:
        ctx.add(
            "EDGE_PARAM_FORBIDDEN",
            at,
            given,
            f"Inertial connector {edge.id!r} has parameters, but physics alone moves its body.",
            "Remove them; put a prescribed outcome into the constraints of its events.",
        )


def _turn(ctx: Context, at: str, edge: TimelineEdge, events: dict[str, TimelineNode]) -> None:
    end = events.get(edge.to)
    for name in ("turn_direction", "turn_degrees"):
        stated = getattr(edge.params, name)
        reached = getattr(end, name) if end is not None else None
        if stated is None and reached is None:
            ctx.add(
                "EDGE_PARAM_MISSING",
                f"{at}/{name}",
                None,
                f"Turn {edge.id!r} has no {name}.",
                "State it here or in the HeadingReached event it leads to.",
            )
        elif stated is not None and reached is not None and _differ(stated, reached):
            ctx.add(
                "CONSTRAINT_CONTRADICTION",
                f"{at}/{name}",
                stated,
                f"Turn {edge.id!r} has {name} {stated}, but {edge.to!r} asks for {reached}.",
                "Make both the same.",
            )


def _differ(stated: object, reached: object) -> bool:
    if is_array(stated) and isinstance(reached, float):
        return not min(stated) <= reached <= max(stated)
    return stated != reached
