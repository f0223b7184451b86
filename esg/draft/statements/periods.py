"""In which part of the scene a statement holds, and whether an event tells it."""

from __future__ import annotations

from collections.abc import Iterator

from esg.draft.discourse.proposition import Clause
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.windows import START
from esg.draft.events.courses import measurable
from esg.draft.events.hanging import SENT_UP
from esg.draft.statements.book import span
from esg.graph.models import EdgeEvent, NodeEvent, TimelineEdge

STRAIGHT_DOWN_DEG = -90.0
"""Elevation of what is dropped."""


def period(d: Discourse, clause: Clause, mover: str) -> str:
    """The part of the scene that a clause tells: from one event to the next."""
    since = clause.since.get(mover, START)
    if d.scene.used.get(span(clause.frame)) == SENT_UP and (jolted := since_the_jolt(d, mover)):
        return jolted
    edge = segment_from(d, mover, since)
    kinds = {n.id: n.event for n in d.timeline.nodes}
    begin = "start" if since == START else since
    end = edge.to if edge is not None else "end"
    # A leap is told when it takes off, a lift when it has left what carries it.
    if kinds.get(end) in (NodeEvent.JUMP, NodeEvent.PICKED_UP):
        lands = segment_from(d, mover, end)
        end = lands.to if lands is not None else "end"
    turns = any(e.event is EdgeEvent.TURN for e in segments(d, mover))
    if turns and end in kinds and not measurable(kinds[end]):
        return "start" if begin == "start" else "throughout"  # it goes another way later
    track = d.timeline.tracks.get(mover)
    first = next(segments(d, mover), None)
    if begin == "start" and track is not None and track.after and first is not edge:
        begin = track.after  # it stands still until then
    if begin != "start" and not measurable(kinds[begin]):
        return "throughout"
    end = end if end in kinds and measurable(kinds[end]) else "end"
    return "throughout" if (begin, end) == ("start", "end") else f"{begin}..{end}"


def segments(d: Discourse, mover: str) -> Iterator[TimelineEdge]:
    """The segments of a mover's motion, in order."""
    return (e for e in d.timeline.edges if e.actor == mover)


def segment_from(d: Discourse, mover: str, since: str) -> TimelineEdge | None:
    """The segment of a motion that is told from an event on: the one after a wait, if it waits."""
    edge = next((e for e in segments(d, mover) if e.from_ == since), None)
    if edge is not None and edge.event is EdgeEvent.UNIFORM_MOTION and edge.params.speed == 0.0:
        return next((e for e in segments(d, mover) if e.from_ == edge.to), edge)
    return edge


def hurled(d: Discourse, mover: str) -> bool:
    """Whether it is let go into the air, and not downwards."""
    ways = (e.params.elevation_deg for e in segments(d, mover))
    return any(way not in (None, STRAIGHT_DOWN_DEG) for way in ways)


def is_told(d: Discourse, mover: str, others: list[str]) -> bool:
    """Whether an event tells of the mover and one of the others."""
    for n in d.timeline.nodes:
        about = {*n.participants, str(n.extra.get("region", "")).split("/")[0]}
        if measurable(n.event) and mover in about and about & {*others}:
            return True
    return False


def since_the_jolt(d: Discourse, body: str) -> str:
    """The time after something has hit the seesaw that a body is on; "" if nothing does."""
    board = d.scene.supported_by.get(body)
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    jolt = next((n.id for n in hits if board in n.participants), "")
    return jolt and f"{jolt}..end"
