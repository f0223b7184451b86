"""Whether a draft holds a labelled statement: as one, or as what the judge sees without it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
import math
from typing import Any

from benchmarks.drafting.corpus import bind, head_of, words_of
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    NodeEvent,
    Predicate,
    RegionType,
    Statement,
    TimelineEdge,
    TimelineNode,
)

_OF_EVENTS = ("before", "same_time")
_MUTUAL = ("touches", "never_touches", "attached_to", "near", "adjacent", "between")
_AS = {"on": "supported_by", "inside_of": "inside"}
"""Names of relations in labels, and the predicates that say the same."""
_AT_THE_END = {"supported_by": "ends_on", "inside": "ends_in"}
"""What a statement about the end is also called."""
_PAIRS = {
    "left_of": "right_of", "in_front_of": "behind", "above": "under",
    "higher_than": "lower_than", "near": "near", "adjacent": "adjacent",
    "far_from": "far_from", "same_level_as": "same_level_as",
}  # fmt: skip
_INVERSE = {**_PAIRS, **{b: a for a, b in _PAIRS.items()}}
_ALIKE = {"near": ("near", "adjacent"), "adjacent": ("near", "adjacent")}
"""Relations that the same words of a prompt ("next to", "beside") may be labelled with."""
_OWN_MOTION = (EdgeEvent.TOWARD, EdgeEvent.UNIFORM_MOTION, EdgeEvent.ACCELERATED_MOTION)
_SAME_MOMENT_S = 0.3
"""Of `same_time` (data format of the suites, second edition)."""
_RELATIVE_TOLERANCE = 0.15
"""Of a size or a distance (the same; of `above` it is stricter there, of the replay)."""


@dataclass(frozen=True)
class _Asked:
    """A labelled statement with its participants bound to the nodes of a draft."""

    label: dict[str, Any]
    says: str
    objects: tuple[tuple[str, ...], ...]
    targets: tuple[tuple[str, ...], ...]
    direction: str | None
    events: dict[str, TimelineNode | TimelineEdge]

    @property
    def of_the_start(self) -> bool:
        """Whether the initial state answers it."""
        return self.label.get("when", "throughout") in ("throughout", "start")


def holds(
    doc: EsgDocument, label: dict[str, Any], events: dict[str, TimelineNode | TimelineEdge]
) -> bool:
    """Whether a draft holds a labelled statement.

    Args:
        doc: Draft.
        label: A `statements` item of the corpus; values in m, m/s, degrees.
        events: What the labelled events were found as, by their ids.
    """
    asked = _asked(doc, label, events)
    if any(_same(s, asked) for s in doc.statements or ()):
        return True
    if asked.says not in (*_OF_EVENTS, "absent", "count") and not _bound(asked):
        return False
    equivalent = _EQUIVALENT.get(asked.says, _related)
    return equivalent(doc, asked)


def _asked(
    doc: EsgDocument, label: dict[str, Any], events: dict[str, TimelineNode | TimelineEdge]
) -> _Asked:
    says: str = label["says"]
    direction, _, rest = str(label.get("direction", "")).partition(" ")
    if says in _OF_EVENTS:
        return _Asked(label, says, (), (), None, events)

    def bound(phrases: Any) -> tuple[tuple[str, ...], ...]:
        listed = [phrases] if isinstance(phrases, str) else phrases or ()
        return tuple(tuple(bind(doc, p)) for p in listed if words_of(p))

    return _Asked(
        label,
        _AS.get(says, says),
        bound(label.get("object", label.get("a"))),
        bound(label.get("target", label.get("b", rest or None))),
        direction or None,
        events,
    )


def _bound(asked: _Asked) -> bool:
    return bool(asked.objects) and all(asked.objects) and all(asked.targets)


def _pairs(asked: _Asked) -> Iterable[tuple[str, str]]:
    """Every node of the object with every node of the target."""
    for one in asked.objects:
        for other in asked.targets:
            yield from ((a, b) for a in one for b in other if a != b)


_PLACES = frozenset({"supported_by", "inside", "above", "airborne", "carried_by", "attached_to"})
"""Predicates of being somewhere: what holds throughout holds at the start."""


def _same(statement: Statement, asked: _Asked) -> bool:
    """Whether a statement of the document says what is asked."""
    says, when = asked.says, asked.label.get("when", "throughout")
    predicate = statement.predicate.value
    if predicate != says:
        return (
            when == "end" and predicate == _AT_THE_END.get(says) and _participants(statement, asked)
        )
    if says in _OF_EVENTS:
        return _of_events(statement, asked)
    if says in ("absent", "count"):
        nouns = words_of(statement.noun or "")[-1:], words_of(asked.label["noun"])[-1:]
        return nouns[0] == nouns[1] and _value(statement, asked.label, 1.0)
    always = statement.when == "throughout" and says in _PLACES
    if when != "throughout" and not always and statement.when != _moments(when, asked):
        return False
    if asked.direction and statement.direction != asked.direction:
        return False
    factor = 1.0 if statement.quantity in ("angle", "count") else 100.0
    compared = says in ("size", "above")
    return _participants(statement, asked) and (
        not compared or _value(statement, asked.label, factor)
    )


def _participants(statement: Statement, asked: _Asked) -> bool:
    if not _bound(asked):
        return False
    a, b = set(statement.object), set(statement.target)

    def named(objects: set[str], targets: set[str]) -> bool:
        return all(objects & set(ids) for ids in asked.objects) and all(
            targets & set(ids) for ids in asked.targets
        )

    return named(a, b) or (asked.says in _MUTUAL and named(b, a))


def _of_events(statement: Statement, asked: _Asked) -> bool:
    names = [getattr(asked.events.get(asked.label[x]), "id", None) for x in ("a", "b")]
    said = list(statement.object)
    return None not in names and (
        said == names or (asked.says == "same_time" and said == names[::-1])
    )


def _moments(when: str, asked: _Asked) -> str | None:
    """`when` of a label with the ids of the document's events; None where one was not found."""
    out: list[str] = []
    for moment in when.split(".."):
        event = asked.events.get(moment)
        if moment not in ("start", "end") and not isinstance(event, TimelineNode):
            return None
        out.append(event.id if isinstance(event, TimelineNode) else moment)
    return "..".join(out)


def _value(statement: Statement, label: dict[str, Any], factor: float) -> bool:
    want = label.get("value", label.get("distance"))
    if want is None:
        return True
    if statement.value is None:
        return False
    found = statement.value
    low, high = found if isinstance(found, tuple) else (found, found)
    slack = 0.0 if factor == 1.0 else _RELATIVE_TOLERANCE * abs(want)
    return low / factor - slack <= want <= high / factor + slack


def _supported(doc: EsgDocument, asked: _Asked) -> bool:
    return asked.of_the_start and any(
        _parent(doc, a, (RegionType.SUPPORT_SURFACE, RegionType.STORAGE)) == b
        or _relation(doc, "on", a, b)
        for a, b in _pairs(asked)
    )


def _inside(doc: EsgDocument, asked: _Asked) -> bool:
    return asked.of_the_start and any(
        _parent(doc, a, (RegionType.STORAGE,)) == b or _relation(doc, "inside_of", a, b)
        for a, b in _pairs(asked)
    )


def _parent(doc: EsgDocument, name: str, kinds: tuple[RegionType, ...]) -> str | None:
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[name].semantic_region or "")
    return region.parent_object if region and region.region_type in kinds else None


def _relation(doc: EsgDocument, relation: str, a: str, b: str) -> bool:
    edges = doc.spatial_relation_graph.edges.binary_relations
    kinds = _ALIKE.get(relation, (relation,))
    back = [_INVERSE.get(k) for k in kinds]
    return any(
        (r.from_ == a and r.to == b and r.relation_type.value in kinds)
        or (r.from_ == b and r.to == a and r.relation_type.value in back)
        for r in edges
    )


def _related(doc: EsgDocument, asked: _Asked) -> bool:
    """A relation of that name at the start; predicates that are none have no equivalent."""
    if not asked.of_the_start:
        return False
    if any(_relation(doc, asked.says, a, b) for a, b in _pairs(asked)):
        return True
    return any(
        r.relation_type.value == asked.says
        and all(set(r.subjects) & set(ids) for ids in asked.objects)
        and all(set(r.targets) & set(ids) for ids in asked.targets)
        for r in doc.spatial_relation_graph.edges.multi_relations
    )


def _points(doc: EsgDocument) -> tuple[TimelineNode, ...]:
    return doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()


def _between(doc: EsgDocument, asked: _Asked, event: NodeEvent) -> bool:
    """Whether the two are participants of such a point event."""
    return any(
        n.event is event and {a, b} <= set(n.participants)
        for n in _points(doc)
        for a, b in _pairs(asked)
    )


def _ends_in(doc: EsgDocument, asked: _Asked) -> bool:
    """Whether the last that happens to it, but for stopping, is entering the target."""
    for a, b in _pairs(asked):
        own = [n for n in _points(doc) if a in n.participants]
        own = [n for n in own if n.event not in (NodeEvent.STOP, NodeEvent.TRIGGER)]
        last = own[-1] if own else None
        if last and last.event is NodeEvent.ENTER_REGION and (last.region or "").split("/")[0] == b:
            return True
    return False


def _moves(doc: EsgDocument, asked: _Asked) -> bool:
    """Toward something that a segment aims at, past something that is missed."""
    if asked.direction == "past":
        return _between(doc, asked, NodeEvent.MISS)
    if _climbs(doc, asked):
        return True
    timeline = doc.timeline_system
    edges = timeline.sequence_graph.edges if timeline else ()
    wanted = set(_pairs(asked))
    return asked.direction == "toward" and any(
        e.event in _OWN_MOTION and (e.actor, e.target) in wanted for e in edges
    )


def _climbs(doc: EsgDocument, asked: _Asked) -> bool:
    """Up or down what somebody climbs, or along it: "runs up the stairs"."""
    own = {i for ids in asked.objects for i in ids}
    other = {i for ids in asked.targets for i in ids}
    return any(
        s.predicate is Predicate.CLIMBS
        and own & {*s.object}
        and (s.direction == asked.direction or asked.direction == "along")
        and (not other or bool(other & {*s.target}))
        for s in doc.statements or ()
    )


def _on_it(doc: EsgDocument, asked: _Asked) -> bool:
    """Who climbs something is told to keep to its surface: "a bear climbing a tree"."""
    pairs = {frozenset(pair) for pair in _pairs(asked)}
    climbs = [s for s in doc.statements or () if s.predicate is Predicate.CLIMBS]
    return any(frozenset((a, b)) in pairs for s in climbs for a in s.object for b in s.target)


def _absent(doc: EsgDocument, asked: _Asked) -> bool:
    noun = words_of(asked.label["noun"])[-1:]
    return not any([head_of(doc, name)] == noun for name in doc.spatial_relation_graph.nodes)


def _count(doc: EsgDocument, asked: _Asked) -> bool:
    return len(bind(doc, asked.label["noun"])) == asked.label["value"]


def _size(doc: EsgDocument, asked: _Asked) -> bool:
    """A stated side is one of the prescribed dimensions."""
    want = asked.label.get("value")
    nodes = doc.spatial_relation_graph.nodes
    assets = [doc.asset_requirement[nodes[i].asset_id] for ids in asked.objects for i in ids]
    return want is not None and any(
        a.dimensions_are_prescribed
        and any(
            abs(x / 100.0 - want) <= _RELATIVE_TOLERANCE * want for x in a.expected_dimensions_cm
        )
        for a in assets
    )


def _ordered(doc: EsgDocument, asked: _Asked) -> bool:
    """Order of two found events by the graph of segments, else by their windows."""
    first, second = (_point(doc, asked.events.get(asked.label[x])) for x in ("a", "b"))
    if first is None or second is None:
        return False
    (low, high), (low2, high2) = _window(first), _window(second)
    if asked.says == "same_time":
        return abs(low - low2) <= _SAME_MOMENT_S and abs(high - high2) <= _SAME_MOMENT_S
    return high <= low2 or second.id in _after(doc, first.id)


def _point(doc: EsgDocument, event: TimelineNode | TimelineEdge | None) -> TimelineNode | None:
    """The event itself, or the one that a motion begins with."""
    if isinstance(event, TimelineEdge):
        return next(n for n in _points(doc) if n.id == event.from_)
    return event


def _window(node: TimelineNode) -> tuple[float, float]:
    if node.timestamp is not None:
        return node.timestamp, node.timestamp
    return node.window or (0.0, math.inf)


def _after(doc: EsgDocument, start: str) -> set[str]:
    """Ids of the point events that segments lead to from one."""
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    out: set[str] = set()
    todo = [start]
    while todo:
        here = todo.pop()
        new = {e.to for e in edges if e.from_ == here} - out
        out |= new
        todo += new
    return out


_EQUIVALENT: dict[str, Callable[[EsgDocument, _Asked], bool]] = {
    Predicate.SUPPORTED_BY.value: _supported,
    Predicate.INSIDE.value: _inside,
    Predicate.MOVES.value: _moves,
    Predicate.ENDS_IN.value: _ends_in,
    Predicate.TOUCHES.value: lambda doc, asked: (
        _between(doc, asked, NodeEvent.COLLISION) or _on_it(doc, asked)
    ),
    Predicate.NEVER_TOUCHES.value: lambda doc, asked: _between(doc, asked, NodeEvent.MISS),
    Predicate.ABSENT.value: _absent,
    Predicate.COUNT.value: _count,
    Predicate.SIZE.value: _size,
    Predicate.BEFORE.value: _ordered,
    Predicate.SAME_TIME.value: _ordered,
}
"""What the judge sees of a statement that the document does not make."""
