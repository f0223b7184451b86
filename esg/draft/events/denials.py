"""Contacts that are told not to take place: "touches neither", "hits none of them"."""

from __future__ import annotations

from esg.draft.discourse.core import aimable, entity_of, mark_used, movable
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.matching import same_kind
from esg.draft.discourse.scene import Untouched
from esg.draft.events.acts import add_event, ensure_mover
from esg.draft.events.told import at_rest, has_stopped, moves
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.clauses.modality import almost
from esg.graph.models import NodeEvent

BY_NONE = "by none"
"""What a verb says that is denied of every subject: "nothing touches it"."""
_TOUCHES = frozenset({"brush", "bump", "clip", "contact", "hit", "ram", "strike", "touch"})
"""Verbs of which "is not" says that nothing touches it: what is not damaged may be hit."""
_FEW = 3
"""Most things of which each is an event of its own."""


def touches_none(d: Discourse, f: Frame, who: list[str], others: list[str]) -> bool:
    """Reads a denied contact with several things, or with nothing; False if it is with one.

    Each of few things that is got by is a Miss; that none of them is touched is a statement.

    Args:
        d: The discourse.
        f: A clause with a negated verb of contact.
        who: Its subject (node ids).
        others: Its object (node ids).
    """
    by_none = f.verb.extra.get("denied") == BY_NONE
    met_by_none = f.verb.lemma in _TOUCHES and not almost(f, d.text)
    if f.verb.passive and not met_by_none:
        return False
    if f.verb.passive or by_none:
        return _touched_by_none(d, f, others if by_none else who)
    met = _met(d, f, who, others)
    several = len(met) > 1 or "denied" in f.verb.extra
    if not several or not who:
        return False
    for actor in who:
        near = [i for i in met if i != actor]
        if near and movable(d, actor):
            _gets_by(d, f, actor, near)
            told = Untouched(f.verb.start, f.verb.end, actor, tuple(near))
            d.scene.untouched.append(told)
    mark_used(d, f, "never touches")
    return True


def _touched_by_none(d: Discourse, f: Frame, who: list[str]) -> bool:
    """ "The box is not hit", "nothing hits the box": by who is told, else by all that is named."""
    by = [i for p in f.phrases if p.prep == "by" and p.mention for i in p.mention.entities]
    if by and not any(_told_of(d, f, i) for i in by):
        return False  # nothing else is told of it: it gets by
    for body in who:
        told = by or _others_named(d, who)
        near = tuple(i for i in told if i not in who and aimable(d, i) and movable(d, i))
        if near:
            d.scene.untouched.append(Untouched(f.verb.start, f.verb.end, body, near))
    mark_used(d, f, "never touched")
    return bool(who)


def _told_of(d: Discourse, f: Frame, body: str) -> bool:
    """Whether another clause is about something."""
    told = (g.subject for g in d.told if g is not f and g.subject is not None)
    return any(body in m.entities for m in told)


def falls_short(d: Discourse, f: Frame, who: list[str], others: list[str]) -> bool:
    """ "Never reaches the cup": it does not touch it; False where there is nothing to touch.

    Args:
        d: The discourse.
        f: A clause with a negated verb of arrival.
        who: Its subject (node ids).
        others: Its object (node ids).
    """
    parts = f.object is not None and bool(f.object.part)  # "the edge of the table"
    near = tuple(i for i in others if aimable(d, i) and i not in who and not parts)
    short = [i for i in who if near and movable(d, i)]
    for actor in short:
        if at_rest(d, actor) and not _told_of(d, f, actor):
            ensure_mover(d, f, actor, None)
        d.scene.untouched.append(Untouched(f.verb.start, f.verb.end, actor, near))
    if short:
        mark_used(d, f, "never touches")
    return bool(short)


def _others_named(d: Discourse, who: list[str]) -> list[str]:
    """What the prompt has named but some things, what they are on or in, and who threw them."""
    hosts = {d.scene.supported_by.get(i, "") for i in who} | {
        d.scene.inside_of.get(i, "") for i in who
    }
    throwers = {i for i, thrown in d.refs.launched_by.items() if {*thrown} & {*who}}
    return [i for i in d.world.entities if i not in {*who, *hosts, *throwers} and aimable(d, i)]


def _gets_by(d: Discourse, f: Frame, actor: str, near: list[str]) -> None:
    met = {frozenset(n.participants) for n in d.timeline.nodes if n.event in _TOLD}
    new = [i for i in near if frozenset((actor, i)) not in met]
    nothing = f.verb.extra.get("denied") == "nothing"
    if nothing or len(near) > _FEW or _way_told(d, actor, near):
        if not (moves(d, actor) or has_stopped(d, actor)):
            ensure_mover(d, f, actor, near[0])
        return
    for other in new if not has_stopped(d, actor) else ():
        ensure_mover(d, f, actor, other)
        add_event(d, NodeEvent.MISS, (actor, other), f, None)


def _way_told(d: Discourse, actor: str, near: list[str]) -> bool:
    """ "Rolls between two cones and touches neither": its way by them is a statement already."""
    for c in d.scene.clauses:
        ways = [p.mention for p in c.frame.phrases if p.prep in _WAYS and p.mention is not None]
        if actor in c.movers and any({*near} & {*m.entities} for m in ways):
            return True
    return False


_WAYS = frozenset({"between", "among", "amid", "through"})
_TOLD = frozenset({NodeEvent.MISS, NodeEvent.COLLISION})


def _met(d: Discourse, f: Frame, who: list[str], others: list[str]) -> list[str]:
    """What is told not to be touched."""
    denied, m = f.verb.extra.get("denied", ""), f.object
    if not denied or (others and denied != "nothing"):
        into = [i for p in f.phrases if p.prep in ("into", "against") and p.mention
                for i in p.mention.entities]  # fmt: skip
        return [i for i in dict.fromkeys(others or into) if aimable(d, i)]
    named = _others_named(d, who)
    if m is not None and denied == "no":
        return [i for i in named if same_kind(m, entity_of(d, i))]
    return named if denied == "nothing" else []
