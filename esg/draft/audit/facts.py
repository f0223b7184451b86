"""What a document says of its things, fact by fact, and which words of the text name them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from esg.draft.audit.parse import Arg
from esg.graph.models import (
    Coverage,
    CoverageItem,
    EdgeEvent,
    EsgDocument,
    NodeEvent,
    Predicate,
    SpatialRelationGraph,
    Statement,
    TimelineEdge,
    TimelineNode,
)

_SCAFFOLD = frozenset({NodeEvent.SCENE_START, NodeEvent.TRIGGER, NodeEvent.POSITION_AT})
NODES = "/spatial_relation_graph/nodes/"


@dataclass(frozen=True)
class Fact:
    """One thing that the document says.

    Args:
        kind: An event, "motion", a relation, "support", "inside", a predicate, "joint".
        who: What it is said of.
        whom: The others that take part.
        way: Of "moves": the direction.
    """

    kind: str
    who: frozenset[str]
    whom: frozenset[str] = frozenset()
    way: str = ""

    @property
    def all(self) -> frozenset[str]:
        """Everything that takes part."""
        return self.who | self.whom


@dataclass(frozen=True)
class Facts:
    """All of them, and what they are about."""

    doc: EsgDocument
    facts: tuple[Fact, ...]
    spans: tuple[tuple[int, int, str], ...]
    """Where things are named: start, end, node."""
    said: tuple[tuple[int, int], ...]
    """Words that are owned up to, without adjectives of what is drawn."""
    held: tuple[tuple[int, int], ...]
    """Words of statements that the document holds."""
    read: frozenset[int] = frozenset()
    """Where verbs begin that the drafter made something of."""
    verbs: tuple[CoverageItem, ...] = ()
    """What the drafter took for verbs, and what it made of each."""
    kept: tuple[Statement, ...] = ()
    """Statements that the document holds."""
    events: tuple[TimelineNode, ...] = ()
    edges: tuple[TimelineEdge, ...] = ()

    def about(self, nodes: frozenset[str]) -> list[Fact]:
        """Those in which one of some things takes part."""
        return [f for f in self.facts if f.all & nodes]

    def owns_up(self, start: int, end: int) -> bool:
        """Whether some of these words are owned up to."""
        return any(a < end and start < b for a, b in self.said)

    def verb(self, start: int) -> CoverageItem | None:
        """What the drafter took for a verb at this place; None if it did not."""
        return next((i for i in self.verbs if i.start <= start < i.end), None)

    def named(self, arg: Arg) -> str:
        """The node that a noun phrase names; empty if it names none."""
        found = [(b - a, n) for a, b, n in self.spans if a <= arg.start and arg.end <= b]
        return min(found)[1] if found else ""


def facts_of(doc: EsgDocument, coverage: Coverage, statements: tuple[Statement, ...]) -> Facts:
    """Reads a document.

    Args:
        doc: A draft.
        coverage: Its record, with places in the text that is parsed.
        statements: What it states, with places there, too.
    """
    spans = tuple(
        (i.start, i.end, i.pointer.removeprefix(NODES).split("/")[0])
        for i in coverage.items
        if i.pointer.startswith(NODES)
    )
    kept = [s for s in statements if s.predicate is not Predicate.NOT_REPRESENTED]
    lost = [(s.start, s.end) for s in statements if s.predicate is Predicate.NOT_REPRESENTED]
    said = [(a, b) for a, b in lost if not any(x <= a and b < y for x, y, _ in spans)]
    said += [(i.start, i.end) for i in coverage.items if i.status == "not_understood"]
    held = tuple((s.start, s.end) for s in kept)
    verbs = tuple(i for i in coverage.items if i.kind == "event")
    read = frozenset(i.start for i in verbs if i.status == "used")
    timeline = doc.timeline_system.sequence_graph if doc.timeline_system is not None else None
    events, edges = (timeline.nodes, timeline.edges) if timeline is not None else ((), ())
    found = (
        *_of_events(events),
        *_of_motions(edges),
        *_of_places(doc.spatial_relation_graph),
        *_of_statements(kept),
    )
    return Facts(doc, found, spans, tuple(said), held, read, verbs, tuple(kept), events, edges)


def _of_events(events: Iterable[TimelineNode]) -> Iterator[Fact]:
    """What happens, to whom, and in what."""
    for n in events:
        if n.event not in _SCAFFOLD:
            inside = frozenset({n.region.split("/")[0]} if n.region else set[str]())
            first = frozenset(n.participants[:1])
            others = frozenset(c.to for c in n.constraints if c.to) | inside
            yield Fact(n.event.value, first, frozenset(n.participants[1:]) | others)


def _of_motions(edges: Iterable[TimelineEdge]) -> Iterator[Fact]:
    """What moves, or is pushed, and to what."""
    for e in edges:
        kind = "pushed" if e.event is EdgeEvent.INERTIAL_CONNECTOR else "motion"
        whom = frozenset({e.target} if e.target else set[str]())
        yield Fact(kind, frozenset({e.actor}), whom)


def _of_places(graph: SpatialRelationGraph) -> Iterator[Fact]:
    """Where things are: by relations, on or in what has a region for them, and on joints."""
    for r in graph.edges.binary_relations:
        if r.relation_type.value != "face":
            yield Fact(r.relation_type.value, frozenset({r.from_}), frozenset({r.to}))
    for m in graph.edges.multi_relations:
        yield Fact(m.relation_type.value, frozenset(m.subjects), frozenset(m.targets))
    for name, node in graph.nodes.items():
        region = graph.semantic_regions.get(node.semantic_region or "")
        if region is not None and not graph.nodes[region.parent_object].is_structural:
            kind = region.region_type.value
            yield Fact(kind, frozenset({name}), frozenset({region.parent_object}))
    for j in graph.joints or ():
        parent = frozenset({j.parent} if j.parent else set[str]())
        yield Fact("joint", frozenset({j.child}), parent)


def _of_statements(kept: Iterable[Statement]) -> Iterator[Fact]:
    """What is stated of things, without the order in which it happens."""
    for s in kept:
        if s.predicate not in (Predicate.BEFORE, Predicate.SAME_TIME):
            yield Fact(
                s.predicate.value, frozenset(s.object), frozenset(s.target), s.direction or ""
            )
