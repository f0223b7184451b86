"""Adverbs that neither order events nor state anything."""

from __future__ import annotations

from collections.abc import Callable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of
from esg.draft.events.stated import exactly
from esg.draft.statements.account import (
    NOTHING,
    PASSED_OVER,
    Account,
    Gap,
    about_of,
    nodes_of,
    turns,
)
from esg.draft.statements.arranged import SHOWN_BY
from esg.draft.text.elements import Word
from esg.graph.models import EdgeEvent, NodeEvent, Predicate

_TURNS = frozenset(
    {"left", "right", "clockwise", "counterclockwise", "anticlockwise", "around", "round"}
)
_ALWAYS = lex.word_set("all the time (adverbs)")
_BACK_AND_FORTH = frozenset({"back", "forth", "fro"})
HALF_TURN_DEG = 180.0
NO_EDGE = "all that moves stays in the picture"
_COUNTED = frozenset({NodeEvent.BOUNCE, NodeEvent.JUMP, NodeEvent.SPIN, NodeEvent.SWING})
"""Events that happen as often as is said."""
ONCE = "it happens once"
NOT_BEFORE = "nothing in the scene has it happen before"
NOT_TIMED = "nothing sees to it that the others come later"
_THIN = 0.3
"""Height over width of what lies flat by itself, at most."""
_EVERY = frozenset({"each", "every"})
_UNMEASURED = frozenset({NodeEvent.SCENE_START, NodeEvent.TRIGGER})
_ARRIVING = lex.word_set("arriving (first)")
_STANDS = frozenset({"be", "posture", "miss", "left_so", "put", "slide", "own", "roll"})
_DOWN = (NodeEvent.TOPPLE,)
NO_MANNER = "manner is not simulated"


def adverbs(a: Account) -> Iterator[Gap]:
    """Adverbs that neither order events nor state anything."""
    turned = turns(a.d)
    yield from _times(a, any(n.event in _COUNTED for n in a.d.timeline.nodes))
    rebounds = {w for f in a.frames if f.verb.sense == "bounce" for w in f.adverbs}
    for w in a.elements:
        if isinstance(w, Word) and w.low == "out of view":
            yield Gap(w.start, w.end, NO_EDGE)
            continue
        if not isinstance(w, Word) or w.kind != "adv" or (w.start, w.end) in a.d.scene.used:
            continue
        for word, fails, why in _UNMET:
            if w.low == word and fails(a, w):
                yield Gap(w.start, w.end, why)
        shown = SHOWN_BY.get(w.low)
        if shown is not None and not _stated(a, w):
            told = (about_of(a.d, f) for f in a.frames if w.low in f.adverbs)
            if not all(shown(a.d, about) for about in told if len(about) > 1):
                yield Gap(w.start, w.end, NOTHING)
            continue
        if w.low in rebounds or (turned and w.low in _TURNS) or _needs_nothing(a, w):
            continue
        if not _stated(a, w):
            yield Gap(w.start, w.end, NO_MANNER if w.low.endswith("ly") else NOTHING)


def _goes_back_and_forth(a: Account, w: Word) -> bool:
    """Whether the words that an adverb was read from tell of a way and its return."""
    return bool({*a.d.text[w.start : w.end].lower().split()} & _BACK_AND_FORTH)


def _needs_nothing(a: Account, w: Word) -> bool:
    """Whether nothing in the document needs to stand for an adverb."""
    return w.low in PASSED_OVER or (w.start, w.end) in a.untold or _says_how(a, w)


def _no_race(a: Account, w: Word) -> bool:
    """ "The red ball arrives first": nothing sees to it, if no event of another one comes later."""
    told = (f for f in a.frames if "first" in f.adverbs and f.verb.lemma in _ARRIVING)
    f = min(told, key=lambda f: abs(f.verb.start - w.start), default=None)
    if f is None or f.unreal or f.verb.negated:
        return False
    about = about_of(a.d, f)
    measured = [n for n in a.d.timeline.nodes if n.event not in _UNMEASURED]
    done = {i for n in measured for i in n.participants} | about
    rivals = {e.actor for e in a.d.timeline.edges} - about
    if rivals and rivals <= done:
        return False  # "gets there first, and the other one stumbles"
    ordered = {s.object[0] for s in a.kept if s.predicate is Predicate.BEFORE and s.object}
    nodes = (a.d.timeline.node(n) for n in ordered)
    return not any(n is not None and about & {*n.participants} for n in nodes)


def _of_several(a: Account, w: Word) -> bool:
    """ "Only one comes out": nothing sees to it that the others of a plural do not."""
    m = next((m for m in a.d.mentions if m.start == w.end + 1), None)
    subject = m is not None and any(f.subject is m for f in a.frames)
    named = {*nodes_of(a.d, m)}
    groups = {entity_of(a.d, i).group for i in named} - {None}
    acting = {e.actor for e in a.d.timeline.edges}
    alike = {i for g in groups for i in a.d.world.groups.get(g or "", [])}
    return subject and bool(groups) and not alike & acting <= named


def _times(a: Account, counted: bool) -> Iterator[Gap]:
    """ "Butts a gate four times": it does so once."""
    for m in a.d.mentions:
        every = m.determiner in _EVERY
        again = m.attribute and m.head == "time" and ((m.count or 0) > 1 or every)
        figure = not every and re.match(r"\s+(?:as|the)\s", a.d.text[m.end :])
        if again and not counted and not figure:
            start = a.d.text.lower().rfind(m.determiner, 0, m.end) if every else m.start
            yield Gap(start, m.end, ONCE)


def _says_how(a: Account, w: Word) -> bool:
    """Whether an adverb tells how exactly, how much or why of what the scene has."""
    if w.low == "right":
        return exactly(a.d.text, w.end)
    if w.low == "apart":  # "2 m apart": a distance
        return any(t.kind == "qty" and w.start - 2 < t.end <= w.start for t in a.tokens)
    if w.low in ("twice", "half", "thrice"):  # "twice as fast as": a figure
        return re.match(r"\s+as\s", a.d.text[w.end :]) is not None
    f = next((f for f in a.frames if w.low in f.adverbs), None)
    if f is None:
        return False
    about = about_of(a.d, f)
    if w.low == "upright" and f.verb.sense in _STANDS:  # what lands so may well tip over
        down = {i for n in a.d.timeline.nodes if n.event in _DOWN for i in n.participants}
        return not about & down
    if w.low in _ALWAYS and f.verb.sense in ("be", "posture"):  # "is stationary throughout"
        return not any(e.actor in about for e in a.d.timeline.edges)
    if w.low == "from behind":
        ways = [e for e in a.d.timeline.edges if e.actor in about and e.target in about]
        ends = {(r.source, r.target) for r in a.d.scene.relations if r.kind == "behind"}
        return any((e.actor, e.target) in ends for e in ways)
    if w.low == "late" and f.verb.sense == "brake":  # it hits something all the same
        hits = {n.id for n in a.d.timeline.nodes if n.event is NodeEvent.COLLISION}
        braked = (e for e in a.d.timeline.edges if e.event is EdgeEvent.BRAKE)
        return any(e.actor in about and e.to in hits for e in braked)
    return w.low == "back" and any(
        n.event is NodeEvent.HEADING_REACHED and n.extra.get("turn_degrees") == HALF_TURN_DEG
        for n in a.d.timeline.nodes
        if about & {*n.participants}
    )


def _stated(a: Account, w: Word) -> bool:
    return any(s.start < w.end and w.start < s.end for s in a.said)


def _happens_once(a: Account, w: Word) -> bool:
    """ "Hits the nail repeatedly", "falls again and again": it does so once, if nothing counts."""
    about = {i for f in a.frames if w.low in f.adverbs for i in about_of(a.d, f)}
    counted = (n for n in a.d.timeline.nodes if n.event in _COUNTED)
    return bool(about) and not any(about & {*n.participants} for n in counted)


def _not_flat(a: Account, w: Word) -> bool:
    """ "Presses the can flat": nothing has it tip over, and it is not thin."""
    told = (f for f in a.frames if "flat" in f.adverbs)
    f = min(told, key=lambda f: abs(f.verb.start - w.start), default=None)
    about = about_of(a.d, f) if f is not None else set[str]()
    down = {i for n in a.d.timeline.nodes if n.event is NodeEvent.TOPPLE for i in n.participants}
    sizes = [sorted(entity_of(a.d, i).noun.dimensions_cm) for i in about]
    return f is not None and not about & down and not any(x < _THIN * y for x, y, _ in sizes)


def _never_before(a: Account, w: Word) -> bool:
    """ "The book falls onto the floor again": nothing has happened to it before."""
    told = (f for f in a.frames if "again" in f.adverbs)
    f = min(told, key=lambda f: abs(f.verb.start - w.start), default=None)
    if f is None or f.unreal or f.verb.negated:
        return False
    about, earlier = about_of(a.d, f), (g for g in a.d.told if g.verb.start < f.verb.start)
    return not any(about & about_of(a.d, g) for g in earlier)


_UNMET: tuple[tuple[str, Callable[[Account, Word], bool], str], ...] = (
    ("indeed", _goes_back_and_forth, NOTHING),
    ("only", _of_several, NOTHING),
    ("first", _no_race, NOT_TIMED),
    ("again", _never_before, NOT_BEFORE),
    ("flat", _not_flat, NOTHING),
    ("repeatedly", _happens_once, ONCE),
)
"""Adverbs with the question whether the document leaves them out, and what is said of them then."""
