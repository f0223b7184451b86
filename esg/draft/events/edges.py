"""Edges, ends and openings: where things leave what carries them, or pass through."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, structural
from esg.draft.discourse.places import elevated, place
from esg.draft.discourse.record import Discourse, Time
from esg.draft.events.motions import lies_on_something
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

_ENDS = lex.word_set("ends (edges)")
EDGES = lex.word_set("edges")
_HATCHES = lex.word_set("hatches")
_BACKS = lex.word_set("backs")


def opening(d: Discourse, ids: list[str]) -> bool:
    """Whether it is a hatch or the like, which things pass and nothing stays in."""
    return len(ids) == 1 and bool(set(entity_of(d, ids[0]).head.split()) & _HATCHES)


def off_the_edge(d: Discourse, f: Frame, p: Phrase, actors: list[str], time: Time | None) -> bool:
    """ "falls off the end", "over its edge": of the support it moves on."""
    m = p.mention
    falls = f.verb.sense in ("fall", "drop")  # "falls at the end of the bar"
    if m is None:
        return False
    back = p.prep == "off" and m.head in _BACKS and m.determiner == "the" and not m.noun
    if m.part not in EDGES and not back:
        return False
    if p.prep not in ("off", "over") and not (falls and p.prep in ("at", "from")):
        return False
    hosts = [i for i in m.entities if i not in actors]
    if hosts and not elevated(d, hosts[0]):
        return False
    for actor in actors:
        if hosts:
            place(d, [actor], hosts[:1], "on")
        if not hosts and actor not in d.scene.supported_by:
            near = _loaded_named(d, actor) if back else _carrier_named(d, actor)
            if not near:
                return False
            place(d, [actor], [near], "on")
        d.add_event(NodeEvent.FALL, (actor,), f, time)
    return bool(actors)


def comes_down(d: Discourse, f: Frame, actor: str, p: Phrase) -> bool:
    """ "slides down to the ground" from the heap it lies on."""
    assert p.mention is not None
    down = "down" in d.text[f.verb.end : p.mention.start].lower().split()
    rests = actor in d.scene.supported_by or lies_on_something(d, actor)
    return down and rests and kind_of(d, actor) not in ("person", "animal")


def _loaded_named(d: Discourse, actor: str) -> str:
    """ "A lorry stops and pipes roll off the back": the vehicle or cart named last."""
    for ids in reversed(d.world.salience):
        for i in ids:
            known = i in d.world.entities and i != actor
            if known and kind_of(d, i) in ("vehicle", "cart", "watercraft"):
                return i
    return ""


def _carrier_named(d: Discourse, actor: str) -> str:
    """What the prompt spoke of last that the actor can stand or run on."""
    for ids in reversed(d.world.salience):
        for i in ids:
            known = i in d.world.entities and i != actor and not structural(d, i)
            if known and {"support", "incline"} & entity_of(d, i).noun.traits:
                return i
    return ""
