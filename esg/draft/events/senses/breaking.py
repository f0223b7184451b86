"""Verbs of coming apart: breaks, shatters, smashes; what is knocked down and was built of parts."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.breaking import breakable_of
from esg.draft.discourse.core import entity_of, mark_used, movable, structural
from esg.draft.discourse.record import Discourse, Time
from esg.draft.events.acts import add_hit
from esg.draft.events.consequences import already_hit, struck_before
from esg.draft.events.roles import filling
from esg.draft.events.senses.fall import drop
from esg.draft.events.stated import place_of
from esg.draft.events.table import read_as, sense
from esg.draft.events.timing import record_event, representatives, time_of
from esg.draft.events.told import at_rest, happened, ignore, moves, one_that, things
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent
from esg.lexicon.breakables import Breakable

_BREAKING = lex.word_set("breaking (senses)")
_PIECES = lex.word_set("to pieces")
_RUINING = lex.word_set("ruining")
_APART = frozenset({"apart", "open", "half", "two", "pieces", "bits", "shards", "fragments"})
_MET = ("on", "onto", "against", "at", "upon")


def row_of(d: Discourse, node: str) -> Breakable | None:
    """What a thing of the scene breaks at; None if it does not."""
    known = node in d.world.entities
    return breakable_of(d.scene, d.text, entity_of(d, node)) if known else None


def who_breaks(d: Discourse, f: Frame, subject: list[str]) -> list[str]:
    """ "A hammer hits a melon and it breaks apart": of those named last, what can."""
    if f.object is not None:
        return subject
    return one_that(d, f.subject, subject, lambda i: row_of(d, i) is not None)


def sense_of_breaking(d: Discourse, f: Frame, subject: list[str], objects: list[str]) -> bool:
    """Whether a clause tells that something comes apart that can."""
    bodies = [i for i in objects or subject if row_of(d, i) is not None]
    if not bodies or f.verb.negated:
        return False
    lemma = f.verb.lemma
    if lemma in ("fall", "come", "go"):
        return "apart" in f.adverbs or (f.phrase("to", "in") is not None and _to_pieces(f))
    if lemma in _RUINING:
        down = (
            lemma != "knock" or {"over", "down", "apart"} & {*f.adverbs} or f.verb.sense == "topple"
        )
        return bool(down) and all(row.falls_apart for i in bodies if (row := row_of(d, i)))
    if lemma not in _BREAKING or "off" in (*f.adverbs, f.verb.extra.get("particle")):
        return False
    after = d.text[f.verb.end :].split(".")[0].lower().split()[:5]
    if lemma in ("crack", "split"):
        return bool(_APART & {*f.adverbs, *(w.strip(",;") for w in after)})
    runs_into = lemma == "smash" and not objects and not f.verb.passive
    return not (runs_into and (f.phrase("into") is not None or "into" in after[:1]))


def _to_pieces(f: Frame) -> bool:
    return any(p.mention is not None and p.mention.head in _PIECES for p in f.phrases)


@sense("break")
def read_break(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """ "A ball breaks a window", "the vase shatters", "a plate breaks on the floor"."""
    told = f.verb.passive or not o
    bodies = [i for i in (s if told else o) if row_of(d, i) is not None]
    if not told or (f.verb.passive and filling(f, "agent")):
        _hit_first(d, f, s, o)
    else:
        for body in bodies:
            _meets(d, f, body)
    time = time_of(d, f)
    broken = [b for b in representatives(d, bodies, []) if come_apart(d, f, b, time)]
    if not broken:
        ignore(d, f, "nothing hits it")


def _hit_first(d: Discourse, f: Frame, s: list[str], o: list[str]) -> None:
    """What breaks something hits it, if that has not been told."""
    doers, done = (filling(f, "agent"), s) if f.verb.passive else (s, o)
    if not already_hit(d, f, doers, done):
        read_as(d, "hit", f, s, o)


def _meets(d: Discourse, f: Frame, body: str) -> None:
    """What breaks by itself comes down, or meets what the clause names."""
    struck_before(d, f, body)
    left = d.scene.supported_by.get(body) if happened(d, NodeEvent.FALL, body) else None
    solid = [i for i in things(f.phrase(*_MET)) if i not in (body, left) and not structural(d, i)]
    flat = any(structural(d, i) for i in things(f.phrase(*_MET)))
    going = not at_rest(d, body) or moves(d, body)
    if solid and (going or movable(d, body)):
        add_hit(d, f, [body], solid[:1])
    elif flat and not going and movable(d, body):
        drop(d, f, [body])


def come_apart(d: Discourse, f: Frame, body: str, time: Time | None = None) -> bool:
    """Tells that a body breaks, if something has happened to it that can break it."""
    row, track = row_of(d, body), d.timeline.tracks.get(body)
    if row is None:
        return False
    for word in _APART & {*f.adverbs}:
        at = place_of(word, d.text, f)
        if at is not None:
            d.scene.used[at] = "breaks"
    if happened(d, NodeEvent.BREAK, body):
        mark_used(
            d,
            f,
            next(
                n.id
                for n in d.timeline.nodes
                if n.event is NodeEvent.BREAK and body in n.participants
            ),
        )
        return True
    if track is None or not track.under_way:
        return False
    d.scene.breaking[body] = row
    node = record_event(d, NodeEvent.BREAK, (body,), f, time)
    mark_used(d, f, node)
    return True


def gone_through(d: Discourse, f: Frame) -> None:
    """ "A car crashes through a brick wall": what is in the way breaks."""
    for p in f.phrases:
        for other in things(p) if p.prep == "through" else []:
            if happened(d, NodeEvent.COLLISION, other):
                come_apart(d, f, other)
