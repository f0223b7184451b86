"""Places, sides and lengths that stand without a noun, and what falls or hangs from nothing."""

from __future__ import annotations

from collections.abc import Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import movable
from esg.draft.discourse.places import elevated
from esg.draft.discourse.scene import GROUND
from esg.draft.events.stated import start_of
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.statements.account import (
    NOTHING,
    Account,
    Gap,
    about_of,
    nodes_of,
    starts_somewhere,
)
from esg.draft.statements.phrases import carriers
from esg.draft.text.elements import Word
from esg.graph.models import NodeEvent

_ALONE = lex.word_set("places of their own (unclaimed)")
_HANG = frozenset({"hang", "dangle"})
_OFF = frozenset({"off", "out"})
_WAYS = frozenset({"way", "distance"})
_HOW_FAR = lex.word_set("how far (unclaimed)")
_OTHER = frozenset({"other", "opposite"})
_NEAR = 60
"""How far behind its verb a place may stand, in characters."""
_UP_AND_DOWN = re.compile(r"\s+(up and down)\b", re.IGNORECASE)
_TO_AND_FRO = frozenset({NodeEvent.JUMP, NodeEvent.BOUNCE, NodeEvent.SWING})
FROM_NOTHING = "it is on nothing that it could leave"
ON_NOTHING = "nothing holds it up"
HOW_FAR = "how far it gets is left open"


def alone(a: Account) -> Iterator[Gap]:
    """ "A jar leans on the door from inside": a place whose noun is left unsaid."""
    taken = {start_of(p, a.d.text) for f in (*a.frames, *a.lost) for p in f.phrases if p.mention}
    taken |= {start_of(p, a.d.text) for _, p in a.d.attached if p.mention is not None}
    told = sorted([*a.frames, *a.lost], key=lambda f: f.verb.start)
    for w in a.elements:
        if not isinstance(w, Word) or w.low not in _ALONE or w.start in taken:
            continue
        if w.kind not in ("prep", "adv") or _named_after(a, w):
            continue
        before = [f for f in told if f.verb.start <= w.start < f.verb.end + _NEAR]
        if not before or _stated(a, w) or before[-1].verb.end > w.start:
            continue
        if before[-1].verb.lemma == "leave":  # "was left behind"
            continue
        about = about_of(a.d, before[-1])
        if about and not _shown(a, w.low, about):
            yield Gap(w.start, w.end, NOTHING, tuple(sorted(about))[:1])


def up_and_down(a: Account) -> Iterator[Gap]:
    """ "Jumps up and down": of what stays on the ground, "up" alone is no course."""
    for f in a.lost:
        at = _UP_AND_DOWN.match(a.d.text, f.verb.end)
        about = about_of(a.d, f)
        shown = any(
            n.event in _TO_AND_FRO and about & {*n.participants} for n in a.d.timeline.nodes
        )
        if at is not None and not shown and not about & {j.child for j in a.d.scene.joints}:
            yield Gap(at.start(1), at.end(1), NOTHING, tuple(sorted(about))[:1])


def _named_after(a: Account, w: Word) -> bool:
    """Whether a noun follows that the place may belong to."""
    return any(0 <= m.start - w.end <= 1 for m in a.d.mentions)


def _stated(a: Account, w: Word) -> bool:
    return any(s.start < w.end and w.start < s.end for s in a.said)


def _shown(a: Account, word: str, about: set[str]) -> bool:
    """Whether a relation, a statement or an event has a place of what is told of."""
    by = carriers().get(word)
    if by is None:
        return True
    d = a.d
    at = d.scene.inside_of if "inside_of" in by.relations else {}
    return (
        any(r.kind in by.relations and about & {r.source, r.target} for r in d.scene.relations)
        or bool(about & {*at})
        or any(s.predicate.value in by.states and about & {*s.object} for s in a.kept)
        or any(n.event.value in by.events and about & {*n.participants} for n in d.timeline.nodes)
    )


def from_nothing(a: Account) -> Iterator[Gap]:
    """ "Until the front one drops off": what falls off or out has to be on or in something."""
    d = a.d
    for f in a.frames:
        word = next((w for w in f.adverbs if w in _OFF), "")
        fallen = {i for g, n in d.times.of_frame if g.verb is f.verb for i in _falls(a, n)}
        moved = {c.since.get(i) for c in d.scene.clauses if c.frame.verb is f.verb for i in fallen}
        if not fallen or any(_was_on_something(a, i) for i in fallen) or None in moved:
            continue
        if not word and not _beside_a_board(a, f, fallen):
            continue
        off = re.compile(rf"\b{word}\b") if word else None
        at = off.search(d.text, f.verb.start, f.verb.end + _NEAR) if off is not None else None
        span = at.span() if at is not None else (f.verb.start, f.verb.end)
        yield Gap(*span, FROM_NOTHING, tuple(sorted(fallen)))


def _beside_a_board(a: Account, f: Frame, fallen: set[str]) -> bool:
    """ "The mug falls on the floor", and there is a table: on which it is not."""
    d = a.d
    floor = f.phrase("on", "onto", "to")
    down = floor is not None and GROUND in nodes_of(d, floor.mention)
    known = f.subject is not None and f.subject.determiner == "the"
    moved = any(fallen & {*c.movers} for c in d.scene.clauses if c.frame.verb.start < f.verb.start)
    hits = (n for n in d.timeline.nodes if n.event is NodeEvent.COLLISION)
    met = any(fallen & {*n.participants} for n in hits)  # it comes down from what it hit
    boards = any(elevated(d, i) for i in d.world.entities)
    return down and known and moved and boards and not met


def _falls(a: Account, event: str) -> tuple[str, ...]:
    node = a.d.timeline.node(event)
    return () if node is None or node.event is not NodeEvent.FALL else node.participants


def _was_on_something(a: Account, who: str) -> bool:
    """Whether it starts on or in something, has been flying, or is a level of a stack."""
    d = a.d
    if any(c.actor == who for c in d.moves.climbs):
        return True
    flew = any(e.actor == who and e.params.elevation_deg is not None for e in d.timeline.edges)
    entity = d.world.entities.get(who)
    stacked = entity is not None and (entity.pattern == "stack" or entity.whole)
    host = d.scene.supported_by.get(who, "")
    return flew or bool(stacked) or (starts_somewhere(d, who) and host != GROUND)


def hung(a: Account) -> Iterator[Gap]:
    """ "A clock hangs above a picture": on what, if nothing holds it up?"""
    d = a.d
    says = {i for s in a.kept for i in s.object if s.predicate.value == "hangs_from"}
    for f in a.frames:
        if f.verb.lemma not in _HANG or f.verb.sense != "posture":
            continue
        who = f.object if f.object is not None and not f.verb.passive else f.subject
        held = says | {i for i in nodes_of(d, who) if starts_somewhere(d, i)}
        loose = [i for i in nodes_of(d, who) if i not in held and movable(d, i)]
        if loose and not _on_something(f):
            yield Gap(f.verb.start, f.verb.end, ON_NOTHING, tuple(loose))


def _on_something(f: Frame) -> bool:
    """Whether the words say on what it hangs: that is asked for by itself."""
    return any(p.prep in ("from", "on", "by", "off", "in", "at") and p.mention for p in f.phrases)


def lengths(a: Account) -> Iterator[Gap]:
    """ "Slides a short way", "drives the other way" of nobody whose way was told."""
    for m in a.d.mentions:
        if not m.attribute or m.amounts or not {m.head, m.part} & (_WAYS | {"direction"}):
            continue
        words = {*m.adjectives}
        if any(f.verb.negated or f.unreal for f in a.d.told if f.object is m):
            continue
        if _HOW_FAR & words and {m.head, m.part} & _WAYS and (m.start, m.end) not in a.d.scene.used:
            yield Gap(m.start, m.end, HOW_FAR)
        elif _OTHER & words and m.determiner == "the":
            yield Gap(m.start, m.end, NOTHING)
