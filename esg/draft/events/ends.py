"""Where motions end: edges and openings, arrivals, what is taken up from above."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used, structural
from esg.draft.discourse.places import elevated, holds, place
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.scene import LIVING, STRUCK
from esg.draft.events.motions import lies_on_something
from esg.draft.events.timing import settle
from esg.draft.events.told import recent, traits_of
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import NodeEvent

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
            near = _carrier_named(d, actor, back)
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
    return down and rests and kind_of(d, actor) not in LIVING


def _carrier_named(d: Discourse, actor: str, back: bool) -> str:
    """What the prompt spoke of last that the actor can stand or run on, or is loaded on."""
    for i in recent(d):
        loaded = back and kind_of(d, i) in ("vehicle", "cart", "watercraft")
        carries = not structural(d, i) and {"support", "incline"} & traits_of(d, i)
        if i != actor and (loaded or (carries and not back)):
            return i
    return ""


_OPEN_CARTS = lex.word_set("open carts")
_TOUCHES = lex.word_set("touches")
_LIDDED = lex.word_set("lidded")
_STUFF = lex.word_set("substances")
_VESSELS = lex.word_set("open vessels")


def heads_for(d: Discourse, f: Frame, actor: str, other: str, time: Time | None) -> None:
    """ "runs to the ball and carries it to a bench": one arrival after the other.

    What is thrown or passed to somebody is for him to take: no arrival is told.
    """
    sent = f.verb.sense in ("launch", "pass") and kind_of(d, other) in LIVING
    sent = sent and f.phrase("from") is None  # "from one player to another" is a way
    if sent and kind_of(d, actor) in STRUCK | {"sliding"}:
        mark_used(d, f, "for somebody to take")
        return
    before = d.times.pending.get(actor)
    another = before is not None and before[0] is NodeEvent.REACH and before[2] != other
    if another and before is not None and before[1] is not f:
        settle(d, actor, None)
    d.times.pending[actor] = (NodeEvent.REACH, f, other, time)


def touches_later(d: Discourse, f: Frame, other: str) -> bool:
    """ "runs past a scooter and brushes it": no miss."""
    for g in d.told:
        if g.sentence != f.sentence or g.verb.start < f.verb.start or g.subject is None:
            continue
        mine = f.subject is not None and g.subject.entities == f.subject.entities
        touched = g.object is not None and other in g.object.entities
        if mine and touched and g.verb.sense in _TOUCHES and not (g.verb.negated or g.unreal):
            return True
    return False


def takes_up_from_above(d: Discourse, host: str, prep: str) -> bool:
    """Whether what falls "into" it is inside then: open carts and trays, and unknown things."""
    noun = entity_of(d, host).noun
    heap = noun.kind == "generic" and " of " in entity_of(d, host).label
    if heap and entity_of(d, host).head in _STUFF:
        return False  # "a pile of hay"
    open_ = noun.kind == "generic" or (noun.kind == "cart" and noun.name in _OPEN_CARTS)
    head = entity_of(d, host).head.rpartition(" ")[2]
    open_ = open_ or noun.name in ("tray", "container", "barrel") or head in _VESSELS
    open_ = open_ or (prep == "in" and noun.name in _LIDDED)  # what it lands in stood open
    return prep in ("into", "in", "through") and (holds(d, host) or open_)


def bounces_over(d: Discourse, actor: str, host: str) -> bool:
    """Whether a bounce leads over the host's rim: what came down, and a ball into a vessel.

    A box that a ball bounces into may as well be what it bumps against.
    """
    vessel = kind_of(d, host) != "box" and kind_of(d, actor) in STRUCK
    return actor in d.moves.came_down or (vessel and holds(d, host))


def implied_goal(d: Discourse, ball: str) -> str:
    """The goal or hoop that a ball goes into, where the prompt names none."""
    name = "basketball hoop" if entity_of(d, ball).noun.name == "basketball" else "goal"
    return add_entity(d.world, lex.nouns()[name], name, mentioned=False).id
