"""Where motions end: arrivals, what is taken up from above, what is passed over."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, kind_of, mark_used
from esg.draft.discourse.places import holds
from esg.draft.discourse.record import Discourse, Time
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.scene import STRUCK
from esg.draft.events.timing import settle
from esg.draft.grammar.clauses.frames import Frame
from esg.graph.models import NodeEvent

_OPEN_CARTS = lex.word_set("open carts")
_TOUCHES = lex.word_set("touches")
_LIDDED = lex.word_set("lidded")


def heads_for(d: Discourse, f: Frame, actor: str, other: str, time: Time | None) -> None:
    """ "runs to the ball and carries it to a bench": one arrival after the other.

    What is thrown or passed to somebody is for him to take: no arrival is told.
    """
    sent = f.verb.sense in ("launch", "pass") and kind_of(d, other) in ("person", "animal")
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
    open_ = noun.kind == "generic" or (noun.kind == "cart" and noun.name in _OPEN_CARTS)
    open_ = open_ or noun.name in ("tray", "container", "barrel")
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
