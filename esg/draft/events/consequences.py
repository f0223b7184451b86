"""What a hit does to what is hit: knocked on, off or over, carried along."""

from __future__ import annotations

from esg.draft.discourse.core import aimable, entity_of, kind_of, structural
from esg.draft.discourse.places import carries, elevated, place
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event, add_hit, share_support
from esg.draft.events.timing import enter, enterable, representatives, time_of
from esg.draft.events.told import recent, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_RIMS = ("edge", "side", "end", "rim")


def knock_on(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "hits the ball into the pocket": what happens to the body that was hit."""
    bodies = representatives(d, bodies, [])
    for p in f.phrases:
        m = p.mention
        if m is None:
            continue
        others = [i for i in m.entities if i not in bodies]
        for body in bodies:
            if m.part in _RIMS and not m.entities:
                if p.prep in ("over", "off"):
                    add_event(d, NodeEvent.FALL, (body,), f, None)
            elif others and not m.attribute:
                _knocked(d, f, body, others, p)


def _knocked(d: Discourse, f: Frame, body: str, others: list[str], p: Phrase) -> None:
    """Where a blow sends a body: to, onto, into or off something."""
    other, part = others[0], p.mention.part if p.mention is not None else ""
    if p.prep in ("to", "onto", "on") and structural(d, other):
        _down(d, f, body)
    elif p.prep in ("into", "in") and enterable(d, other):
        enter(d, f, body, other, time_of(d, f))
    elif p.prep in ("into", "in") and not structural(d, other):
        add_hit(d, f, [body], others, time_of(d, f))
    elif p.prep in ("onto", "against") and not structural(d, other):
        add_hit(d, f, [body], others, None)
    elif p.prep in ("off", "out of", "over", "from") and (p.prep != "over" or part):
        outside = p.prep == "out of" and kind_of(d, other) == "building"
        if outside or not (elevated(d, other) or carries(d, other, body)):
            return
        place(d, [body], [other], "on")
        if d.moves.last_hit is not None and d.moves.last_hit[1] == body:
            share_support(d, f, *d.moves.last_hit)
        add_event(d, NodeEvent.FALL, (body,), f, None)


def _down(d: Discourse, f: Frame, body: str) -> None:
    """ "knocks a glass to the floor": it falls off what it stands on, or topples."""
    if body not in d.scene.supported_by:
        hosts = [i for i in recent(d) if i != body and "support" in traits_of(d, i)]
        if hosts:
            place(d, [body], hosts[:1], "on")
    fell = body in d.scene.supported_by
    add_event(d, NodeEvent.FALL if fell else NodeEvent.TOPPLE, (body,), f, None)


def already_hit(d: Discourse, f: Frame, s: list[str], o: list[str]) -> bool:
    if not any(d.timeline.tracks.get(b) is not None and d.timeline.tracks[b].hit for b in o):
        return False
    if f.causer is not None:
        return True
    last = d.moves.last_hit
    if last is None or last[1] not in o or f.link not in ("cause", "then", "while"):
        return False
    # "the second hits it and the third knocks it over": a hit of its own
    people = all(kind_of(d, i) == "person" for i in s)
    mates = {i for x in s for i in d.world.groups.get(entity_of(d, x).group or "", [x])}
    return (
        not s
        or last[0] in s
        or (people and kind_of(d, last[0]) != "person")
        or (last[0] not in mates and not aimable(d, s[0]))
    )


def consequence(d: Discourse, f: Frame, bodies: list[str]) -> None:
    words = " ".join(f.adverbs)
    if "over" in f.adverbs or "down" in f.adverbs or "upside down" in words:
        for b in representatives(d, bodies, []):
            add_event(d, NodeEvent.TOPPLE, (b,), f, None)
    elif _at_last(f, "off") and f.verb.sense in ("knock", "launch", "cause"):
        for b in representatives(d, bodies, []):
            _beside_its_mates(d, b)
            stacked = entity_of(d, b).pattern == "stack" and entity_of(d, b).in_group
            if b in d.scene.supported_by or stacked:
                add_event(d, NodeEvent.FALL, (b,), f, None)


def _at_last(f: Frame, word: str) -> bool:
    """Whether the clause ends with an adverb, "too" and the like left out."""
    rest = [a for a in f.adverbs if a not in ("too", "also", "again", "then", "instead")]
    return bool(rest) and rest[-1] == word


def _beside_its_mates(d: Discourse, body: str) -> None:
    """ "pushes the red block off the table ... and the green block off too": from there too."""


def struck_before(d: Discourse, f: Frame, body: str) -> None:
    """ "thrown at a bottle, which falls": the fall implies the hit."""
    if body in d.timeline.tracks:
        return
    for mover, aimed in d.moves.aim.items():
        track = d.timeline.tracks.get(mover)
        if aimed == body and track is not None and not track.closed:
            add_hit(d, f, [mover], [body])
            return
