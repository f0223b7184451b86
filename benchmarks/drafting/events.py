"""Which labelled events a draft has, and which of its own no label accounts for."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from benchmarks.drafting.corpus import bind, second_edition
from esg.graph.models import EsgDocument, TimelineEdge, TimelineNode

NODE_EVENTS = {
    "collision": "Collision", "enters": "EnterRegion", "falls": "Fall", "topples": "Topple",
    "stops": "Stop", "turns": "HeadingReached", "reaches": "Reach", "misses": "Miss",
}  # fmt: skip
_STEMS = {
    "bounces": ("bounc",), "picked_up": ("pick", "lift"), "placed": ("plac",),
    "jumps": ("jump",), "spins": ("spin",), "opens": ("open",), "closes": ("clos",),
    "swings": ("swing",), "breaks": ("break", "broke", "shatter"),
    "separates": ("separat", "detach"),
}  # fmt: skip
"""How the names of point events of the second edition's types begin."""
_SCAFFOLD = ("SceneStart", "Trigger", "PositionAt")
_ENTAILED = {
    "bounces": ("collision",),
    "placed": ("collision", "enters", "reaches", "stops"),
}
"""What happens by definition in an event with a target, and is invented by nobody who draws it."""


@dataclass(frozen=True)
class Told:
    """How the timeline of a draft compares with the labelled events.

    Args:
        found: Point event or motion segment of each label by its id (`e1` is the first).
        missing: Labels without one.
        drafted: Point events that count, scaffolding left out.
        invented: Those of them that no label accounts for.
    """

    found: dict[str, TimelineNode | TimelineEdge]
    missing: tuple[dict[str, Any], ...]
    drafted: tuple[TimelineNode, ...]
    invented: tuple[TimelineNode, ...]


def compare(doc: EsgDocument, row: dict[str, Any]) -> Told:
    """Compares the timeline of a draft with the events of a row."""
    timeline = doc.timeline_system
    drafted = tuple(
        n
        for n in (timeline.sequence_graph.nodes if timeline else ())
        if (
            n.event.value not in _SCAFFOLD
            if second_edition(row)
            else n.event.value in NODE_EVENTS.values()
        )
    )
    free = list(drafted)
    found: dict[str, TimelineNode | TimelineEdge] = {}
    missing: list[dict[str, Any]] = []
    for number, event in enumerate(row["events"], 1):
        hit: TimelineNode | TimelineEdge | None
        if event["type"] in ("moves", "brakes"):
            hit = _segment(doc, event)
        else:
            hit = next((n for n in free if _matches(doc, n, event)), None)
        if hit is None:
            missing.append(event)
            continue
        found[event.get("id", f"e{number}")] = hit
        if isinstance(hit, TimelineNode):
            free.remove(hit)
    accounted = _repeated(doc, row["events"], drafted, free)
    free = [n for n in free if n not in accounted]
    for event in row["events"]:
        accounted = _entailed(doc, event, free)
        free = [n for n in free if n not in accounted]
    return Told(found, tuple(missing), drafted, tuple(free))


def _is(node: TimelineNode, kind: str) -> bool:
    if kind in NODE_EVENTS:
        return node.event.value == NODE_EVENTS[kind]
    return node.event.value.lower().startswith(_STEMS.get(kind, ("-",)))


def _put_in(doc: EsgDocument, node: TimelineNode) -> bool:
    """Whether something is guided into a container and let go there: placed in it."""
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    guided = any(e.to == node.id and e.event.value == "Guide" for e in edges)
    return guided and node.event.value == "EnterRegion"


def _turned(doc: EsgDocument, node: TimelineNode) -> str | None:
    """The side to which something is turned where it is; None of what just spins."""
    edges = doc.timeline_system.sequence_graph.edges if doc.timeline_system else ()
    spun = (e for e in edges if e.to == node.id and e.event.value == "Spin")
    return next((e.params.turn_direction for e in spun), None)


def _matches(doc: EsgDocument, node: TimelineNode, event: dict[str, Any]) -> bool:
    kind = event["type"]
    alike = (kind == "placed" and _put_in(doc, node)) or (kind == "turns" and _turned(doc, node))
    if not (alike or _is(node, kind)):
        return False
    first = bind(doc, event.get("a") or event["object"])
    participants = node.participants
    if event["type"] in ("collision", "separates"):
        second = bind(doc, event["b"])
        a, b = participants[0], participants[-1]
        return (a in first and b in second) or (b in first and a in second)
    if participants[0] not in first:
        return False
    if event["type"] == "turns":
        side = node.turn_direction or _turned(doc, node)
        return event.get("direction", "any") in ("any", side)
    target = event.get("target", "")
    if event["type"] == "enters":
        region = node.region or ""
        return target.split()[-1] in region or region.split("/")[0] in bind(doc, target)
    if target and (event["type"] in ("reaches", "misses") or event["type"] in _STEMS):
        return _at(doc, node, target)
    return True


def _at(doc: EsgDocument, node: TimelineNode, target: str) -> bool:
    """Whether a point event names its target; the ground need not be named."""
    ids = bind(doc, target)
    named = list(node.participants[1:]) + ([node.region.split("/")[0]] if node.region else [])
    if named:
        return bool(set(named) & set(ids))
    nodes = doc.spatial_relation_graph.nodes
    return any(nodes[i].is_structural for i in ids)


def _repeated(
    doc: EsgDocument,
    events: Iterable[dict[str, Any]],
    points: Iterable[TimelineNode],
    free: list[TimelineNode],
) -> list[TimelineNode]:
    """Free events that an `each` label states of further members of its plural.

    Only once a member: the same participants again are an invention.
    """
    told = {(n.event, frozenset(n.participants)) for n in points if n not in free}
    out: list[TimelineNode] = []
    for event in events:
        if not event.get("each"):
            continue
        for node in free:
            key = (node.event, frozenset(node.participants))
            if key not in told and _matches(doc, node, event):
                told.add(key)
                out.append(node)
    return out


def _entailed(
    doc: EsgDocument, event: dict[str, Any], free: list[TimelineNode]
) -> list[TimelineNode]:
    """Free events that are part of a labelled one, one of each type."""
    out: list[TimelineNode] = []
    if not event.get("target"):
        return out
    for kind in _ENTAILED.get(event["type"], ()):
        part = {"type": kind, "object": event["object"], "target": event["target"]}
        if kind == "collision":
            part = {"type": kind, "a": event["object"], "b": event["target"]}
        out += [n for n in free if _matches(doc, n, part)][:1]
    return out


def _segment(doc: EsgDocument, event: dict[str, Any]) -> TimelineEdge | None:
    """The first motion (or braking) of what a label is of."""
    timeline = doc.timeline_system
    ids = bind(doc, event["object"])
    for edge in timeline.sequence_graph.edges if timeline else ():
        kind = edge.event.value
        wanted = kind == "Brake" if event["type"] == "brakes" else kind != "InertialConnector"
        if edge.actor in ids and wanted:
            return edge
    return None
