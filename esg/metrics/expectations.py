"""What a document promises, as a suite scene: lets a generated scene be judged.

A benchmark never uses this: there the suite is the ground truth. Participants are exact references,
so that nothing depends on how phrases bind.
"""

from __future__ import annotations

from collections.abc import Iterable

from esg.engines.scene import SimScene
from esg.graph.casting import effective
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    EventConstraint,
    NodeEvent,
    RegionType,
    SequenceGraph,
    TimelineEdge,
    TimelineNode,
)
from esg.metrics.models import (
    EVENT_DEGREES,
    EVENT_FIELDS,
    EVENT_OPTIONAL,
    SuiteConstraint,
    SuiteEvent,
    SuiteScene,
)
from esg.metrics.quantities import BASE_UNIT, DIMENSION_OF
from esg.metrics.statements.expected import Moments, expected_statements
from esg.units import m_from_cm

_LEAVES = frozenset({"falls", "enters", "placed", "picked_up", "jumps", "reaches"})
"""Events after which something may be on another thing than at the start."""
_OWN_POWER = (EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION)


def expectations_from_timeline(doc: EsgDocument, scene: SimScene | None = None) -> SuiteScene:
    """The events and constraints of a document's timeline, and its statements.

    Point events become events of the same meaning; a Brake segment becomes a `brakes` event; motion
    under own power that leads to no measurable event becomes a `moves` event. SceneStart and
    Trigger are no outcomes. `after` follows the sequence graph. Prescribed times, speeds and
    masses become constraints; plausible guesses do not.

    Args:
        doc: A document with or without a timeline (without: no events, but its statements).
        scene: Restricts participants to bodies and regions that exist; None takes all.
    """
    doc = effective(doc)
    definition = doc.scene_definition
    events: list[SuiteEvent] = []
    constraints: list[SuiteConstraint] = []
    moments = Moments({}, {})
    if doc.timeline_system is not None:
        graph = doc.timeline_system.sequence_graph
        moments = _moments(graph)
        events = _any_member(doc, _from_supports(doc, _events(graph)))
        constraints = _constraints(graph, events)
    constraints += _masses(doc)
    mentioned = [
        f"={name}"
        for name, node in doc.spatial_relation_graph.nodes.items()
        if node.mentioned and not node.is_structural and (scene is None or name in scene.names)
    ]
    return SuiteScene(
        id=definition.scene_id,
        prompt=definition.original_description or definition.scene_id,
        level="timeline",
        events=tuple(events),
        constraints=tuple(constraints),
        objects=tuple(mentioned),
        statements=expected_statements(doc, moments),
    )


def _from_supports(doc: EsgDocument, events: list[SuiteEvent]) -> list[SuiteEvent]:
    """Asks of the first fall of what starts on another thing that it is from there.

    After an event of its own it may be somewhere else.
    """
    relations = doc.spatial_relation_graph
    regions, met, out = relations.semantic_regions, set[str](), list[SuiteEvent]()
    for e in events:
        who = [n for p in e.participants for n in p[1:].split(",")]
        node = relations.nodes.get(who[0]) if len(who) == 1 else None
        if e.type == "falls" and e.from_ is None and node is not None and who[0] not in met:
            region = regions.get(node.semantic_region or "")
            on = region.parent_object if region is not None else ""
            surface = region is not None and region.region_type is RegionType.SUPPORT_SURFACE
            if surface and on in relations.nodes and not relations.nodes[on].is_structural:
                e = e.model_copy(update={"from_": _ref([on])})
        out.append(e)
        met |= {*who} if e.type in _LEAVES else set()
    return out


def _any_member(doc: EsgDocument, events: list[SuiteEvent]) -> list[SuiteEvent]:
    """Lets any member of a group count where the timeline names one to stand for all (the head pin
    of a rack); a timeline that names several members means each of them.
    """
    groups: dict[str, list[str]] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        if node.group:
            groups.setdefault(node.group, []).append(name)
    named = {n for e in events for p in e.participants for n in p[1:].split(",")}
    whole = {
        _ref(found): _ref(members)
        for members in groups.values()
        if len(members) > 1 and len(found := [m for m in members if m in named]) == 1
    }
    fields = ("a", "b", "object", "target")
    return [
        e.model_copy(update={f: whole[v] for f in fields if (v := getattr(e, f)) in whole})
        for e in events
    ]


def _ref(names: Iterable[str]) -> str:
    return "=" + ",".join(names)


def _point(position_cm: tuple[float, float, float]) -> str:
    return "@" + ",".join(f"{m_from_cm(x):.6g}" for x in position_cm)


def _node_event(node: TimelineNode) -> SuiteEvent | None:
    who = node.participants
    if not who:
        return None
    one = _ref(who[:1])
    other = _ref(who[1:2]) if len(who) > 1 else None
    if other and node.event is NodeEvent.COLLISION:
        return SuiteEvent(id=node.id, type="collision", a=one, b=other)
    if other and node.event is NodeEvent.MISS:
        return SuiteEvent(id=node.id, type="misses", a=one, b=other)
    if other and node.event is NodeEvent.REACH:
        return SuiteEvent(id=node.id, type="reaches", object=one, target=other)
    if node.event is NodeEvent.STOP:
        return SuiteEvent(id=node.id, type="stops", object=one)
    if node.event is NodeEvent.TOPPLE:
        return SuiteEvent(id=node.id, type="topples", object=_ref(who))
    if node.event is NodeEvent.FALL:
        return SuiteEvent(id=node.id, type="falls", object=one, from_=other)
    if node.event is NodeEvent.HEADING_REACHED:
        return SuiteEvent(
            id=node.id,
            type="turns",
            object=one,
            direction=node.turn_direction or "left",
            degrees=node.turn_degrees or 90.0,
        )
    if (further := _further_event(node, one, other)) is not None:
        return further
    target = f"={node.region}" if node.region else other
    if target and node.event is NodeEvent.ENTER_REGION:
        return SuiteEvent(id=node.id, type="enters", object=one, target=target)
    if node.event is NodeEvent.POSITION_AT and node.position_cm is not None:
        return SuiteEvent(id=node.id, type="reaches", object=one, target=_point(node.position_cm))
    return None


_FURTHER = {
    "Bounce": "bounces",
    "Placed": "placed",
    "PickedUp": "picked_up",
    "Jump": "jumps",
    "Spin": "spins",
    "Open": "opens",
    "Close": "closes",
    "Swing": "swings",
    "Break": "breaks",
}
"""Types of events that are named alike, by the point event's value."""


def _further_event(node: TimelineNode, one: str, other: str | None) -> SuiteEvent | None:
    kind = _FURTHER.get(node.event.value)
    if kind is None:
        return None
    required, optional = EVENT_FIELDS[kind], EVENT_OPTIONAL.get(kind, ())
    if "target" in required and other is None:
        return None
    fields: dict[str, object] = {"id": node.id, "type": kind, "object": one}
    if "target" in required:
        fields["target"] = other
    if "degrees" in optional:
        fields["degrees"] = node.turn_degrees or EVENT_DEGREES[kind]
    if "times" in optional:
        fields["times"] = node.model_dump().get("times") or 1
    return SuiteEvent.model_validate(fields)


def _edge_event(edge: TimelineEdge, measurable: set[str]) -> SuiteEvent | None:
    if edge.event is EdgeEvent.BRAKE:
        return SuiteEvent(id=edge.id, type="brakes", object=_ref([edge.actor]))
    hovers = edge.params.speed == 0.0  # it holds its height, and goes nowhere
    if edge.event in _OWN_POWER and edge.to not in measurable and not hovers:
        return SuiteEvent(id=edge.id, type="moves", object=_ref([edge.actor]))
    return None


def _events(graph: SequenceGraph) -> list[SuiteEvent]:
    """All events in topological order of the sequence graph, `after` set to what must precede."""
    at_node = {n.id: e for n in graph.nodes if (e := _node_event(n)) is not None}
    on_edge = {
        e.id: event for e in graph.edges if (event := _edge_event(e, set(at_node))) is not None
    }
    order = _topological(graph)
    before: dict[str, tuple[str, ...]] = {}
    out: list[SuiteEvent] = []
    for node_id in order:
        arriving: list[str] = []
        for edge in (e for e in graph.edges if e.to == node_id):
            earlier = before.get(edge.from_, ())
            event = on_edge.get(edge.id)
            if event is not None:
                out.append(event.model_copy(update={"after": earlier}))
                # A segment's event starts the segment; what ends it comes later.
                arriving.append(event.id)
            else:
                arriving += earlier
        after = tuple(dict.fromkeys(arriving))
        here = at_node.get(node_id)
        if here is not None:
            out.append(here.model_copy(update={"after": after}))
            before[node_id] = (here.id,)
        else:
            before[node_id] = after
    return out


def _moments(graph: SequenceGraph) -> Moments:
    """Which measured events stand for the point events that `when` may name.

    A point event that is measured stands for itself. For one that is not (a trigger) the measured
    event before it begins a time, and the one after it ends a time.
    """
    measured = {n.id for n in graph.nodes if _node_event(n) is not None}
    order = _topological(graph)
    begins: dict[str, str] = {}
    ends: dict[str, str] = {}
    for node in order:
        before = [begins[e.from_] for e in graph.edges if e.to == node and e.from_ in begins]
        begins[node] = node if node in measured else (before[-1] if before else "start")
    for node in reversed(order):
        later = [ends[e.to] for e in graph.edges if e.from_ == node and e.to in ends]
        ends[node] = node if node in measured else (later[0] if later else "end")
    for node in graph.nodes:
        if node.event is NodeEvent.SCENE_START:
            begins[node.id] = ends[node.id] = "start"
    return Moments(begins, ends)


def _topological(graph: SequenceGraph) -> list[str]:
    """Node ids, predecessors first; ties keep the document's order; cycles fall to the end."""
    left = [n.id for n in graph.nodes]
    done: list[str] = []
    while left:
        ready = next(
            (
                n
                for n in left
                if all(e.from_ in done or e.from_ not in left for e in graph.edges if e.to == n)
            ),
            left[0],
        )
        left.remove(ready)
        done.append(ready)
    return done


def _constraints(graph: SequenceGraph, events: list[SuiteEvent]) -> list[SuiteConstraint]:
    known = {e.id: e.id for e in events}
    # A segment's event happens where the segment starts: "since the trigger" is since its braking.
    for edge in graph.edges:
        if edge.id in known:
            known.setdefault(edge.from_, edge.id)
    known |= {n.id: "start" for n in graph.nodes if n.event is NodeEvent.SCENE_START}
    out: list[SuiteConstraint] = []
    for node in graph.nodes:
        if known.get(node.id) != node.id:
            continue
        if node.time_is_prescribed:
            out += _bounded("outcome", "time", node.timestamp, node.window, event=node.id)
        out += [c for item in node.constraints if (c := _outcome(node, item, known)) is not None]
    starts = {n.id for n in graph.nodes if n.event is NodeEvent.SCENE_START}
    for edge in graph.edges:
        speed = edge.params.speed
        if edge.speed_is_prescribed and edge.from_ in starts and speed is not None:
            value, span = _si("speed", speed)
            out += _bounded("initial", "speed", value, span, object=f"={edge.actor}", at="start")
    return out


def _bounded(
    kind: str,
    quantity: str,
    value: float | None,
    span: tuple[float, float] | None,
    **fields: str | None,
) -> list[SuiteConstraint]:
    if value is None and (span is None or span[0] >= span[1]):
        if span is None:
            return []
        value, span = span[0], None
    return [
        SuiteConstraint.model_validate(
            {
                "kind": kind,
                "quantity": quantity,
                "unit": BASE_UNIT[DIMENSION_OF[quantity]],
                "value": value,
                "range": None if value is not None else span,
                **fields,
            }
        )
    ]


def _si(
    quantity: str, value: float | tuple[float, float]
) -> tuple[float | None, tuple[float, float] | None]:
    scale = 0.01 if DIMENSION_OF[quantity] in ("speed", "length") else 1.0
    if isinstance(value, tuple):
        return None, (value[0] * scale, value[1] * scale)
    return value * scale, None


def _outcome(
    node: TimelineNode, item: EventConstraint, known: dict[str, str]
) -> SuiteConstraint | None:
    quantity = "speed" if item.quantity == "speed_before" else item.quantity
    value, span = _si(quantity, item.value)
    fields: dict[str, str | None] = {"object": f"={item.object}"}
    fields["at" if item.quantity == "speed_before" else "event"] = node.id
    if quantity == "time_since":
        since = known.get(item.since or "")
        if since is None:
            return None
        fields["since"] = since
    if item.to is not None:
        fields["target"] = f"={item.to}"
    found = _bounded("outcome", quantity, value, span, **fields)
    return found[0] if found else None


def _masses(doc: EsgDocument) -> list[SuiteConstraint]:
    out: list[SuiteConstraint] = []
    for asset_id, asset in doc.asset_requirement.items():
        if not asset.mass_is_prescribed:
            continue
        users = [
            name
            for name, node in doc.spatial_relation_graph.nodes.items()
            if node.asset_id == asset_id
        ]
        if users:
            out += _bounded("initial", "mass", asset.expected_mass_kg, None, object=_ref(users))
    return out
