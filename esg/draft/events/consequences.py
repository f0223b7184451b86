"""What a hit or a fall leads to: knocked on, off or over, where it comes down."""

from __future__ import annotations

from esg.draft.discourse.core import aimable, entity_of, kind_of, mark_used, structural
from esg.draft.discourse.places import carries, elevated, place
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.scene import LIVING
from esg.draft.events.acts import add_event, add_hit, share_support, those_with
from esg.draft.events.ends import opening, takes_up_from_above
from esg.draft.events.hanging import tipped
from esg.draft.events.roles import role
from esg.draft.events.timing import enter, enterable, is_airborne, representatives, time_of
from esg.draft.events.told import happened, mates_of, recent, traits_of
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
        place(d, [body, *those_with(d, f, body)], [other], "on")
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
    """Whether a clause tells what the hit before it led to, and no hit of its own."""
    last, tracks = d.moves.last_hit, [d.timeline.tracks.get(b) for b in o]
    if not any(t is not None and t.hit for t in tracks):
        return False
    if f.causer is not None:
        return True
    if last is None or last[1] not in o or f.link not in ("cause", "then", "while"):
        return False
    # "the second hits it and the third knocks it over": a hit of its own
    people = all(kind_of(d, i) == "person" for i in s) and kind_of(d, last[0]) != "person"
    fixed = bool(s) and not aimable(d, s[0]) and not any(last[0] in mates_of(d, x) for x in s)
    return last[0] in s or people or fixed


def consequence(d: Discourse, f: Frame, bodies: list[str]) -> None:
    """ "knocks it over", "pushes it off": what comes of the hit."""
    rest = [a for a in f.adverbs if a not in ("too", "also", "again", "then", "instead")]
    off = rest[-1:] == ["off"] and f.verb.sense in ("knock", "launch", "cause")
    over = {"over", "down"} & {*f.adverbs} or "upside down" in " ".join(f.adverbs)
    for b in representatives(d, bodies, []) if over or off else []:
        e = entity_of(d, b)
        if over and e.noun.shape == "sphere":
            continue  # "a ball is thrown down": nothing of it can tip over
        if over:
            add_event(d, NodeEvent.TOPPLE, (b,), f, None)
        elif b in d.scene.supported_by or (e.pattern == "stack" and e.in_group):
            add_event(d, NodeEvent.FALL, (b,), f, None)


def struck_before(d: Discourse, f: Frame, body: str) -> None:
    """ "thrown at a bottle, which falls": the fall implies the hit."""
    if body in d.timeline.tracks:
        return
    last = d.moves.last_hit
    if body in d.now.each and last is not None and last[1] in mates_of(d, body):
        add_hit(d, f, [last[0]], [body])  # "hits two boxes and both fall"
        return
    for mover, aimed in d.moves.aim.items():
        track = d.timeline.tracks.get(mover)
        if aimed == body and track is not None and not track.closed:
            add_hit(d, f, [mover], [body])
            return


def met_in_its_row(d: Discourse, body: str) -> str:
    """The last hit told of others in the row that a body stands in; "" if none."""
    mates = {*mates_of(d, body)} - {body} if entity_of(d, body).pattern == "row" else set[str]()
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    met = [n.id for n in hits if mates & {*n.participants}]
    return met[-1] if met else ""


def passed_on(d: Discourse, f: Frame, body: str) -> None:
    """ "A marble hits the first domino, and the last one falls": by touch, and not by itself.

    The one that was hit has then fallen, too.
    """
    met = d.timeline.node(met_in_its_row(d, body))
    if met is None:
        return
    struck = next(p for p in reversed(met.participants) if p in mates_of(d, body))
    if not happened(d, NodeEvent.TOPPLE, struck):
        add_event(d, NodeEvent.TOPPLE, (struck,), f, None)
    d.timeline.carry(body, met.id)


def landing_of(d: Discourse, f: Frame, moved: list[str]) -> bool:
    """Reads where what falls comes down; whether the clause says so."""
    for way in f.phrases:
        if way.prep == "through" and way.mention and opening(d, way.mention.entities):
            way.prep = "by way of"  # "drops through a hatch onto a cart"
    p = role(f, "landing")
    m = p.mention if p is not None else None
    if p is None or m is None:
        return False
    if not m.entities or (structural(d, m.entities[0]) and m.start < f.verb.start):
        return False  # "In a café a waiter drops a tray": where, not where to
    other = m.entities[0]
    tipped(d, m)
    d.moves.came_down.update(moved)
    for t in [t for t in moved if t != other]:
        if structural(d, other):
            _on_the_ground(d, f, t)
        elif takes_up_from_above(d, other, p.prep) or kind_of(d, other) in ("region", "water"):
            enter(d, f, t, other, time_of(d, f))
        else:
            add_hit(d, f, [t], m.entities, time_of(d, f))
    return True


def _on_the_ground(d: Discourse, f: Frame, body: str) -> None:
    """A fall to the ground, unless it was in the air: a flight or a jump ends there."""
    lands = f.verb.sense == "land"
    held = body in d.scene.supported_by
    if kind_of(d, body) == "flyer" or (lands and is_airborne(d, body) and not held):
        return
    leaper = kind_of(d, body) in LIVING and lands
    if leaper and not held and body not in d.scene.heights:
        mark_used(d, f, "end of a jump")
    elif not happened(d, NodeEvent.FALL, body):
        add_event(d, NodeEvent.FALL, (body,), f, time_of(d, f))
