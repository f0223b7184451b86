"""Words that nothing in the finished document stands for.

Every phrase, adverb and argument of what is told is asked what carries it; what nothing carries is
owned up to. No list says what may be missing, only `data/carriers.csv` what can carry a
preposition, and the word set "passed over (unclaimed)" what shows nothing of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of
from esg.draft.document.comparisons import not_compared
from esg.draft.statements.account import NOTHING, PASSED_OVER, Account, Gap
from esg.draft.statements.adverbs import adverbs
from esg.draft.statements.arguments import (
    arguments,
    attempts,
    by_nobody,
    fewer,
    idle,
    kept_up,
    left_behind,
    others_of,
    parts_alone,
    some_of,
    unwaited,
)
from esg.draft.statements.phrases import adrift, phrases
from esg.draft.statements.places import alone, from_nothing, hung, lengths, up_and_down
from esg.draft.statements.qualities import MOTIONS, qualities, said_of_it
from esg.draft.statements.several import (
    in_the_middle,
    one_of_several,
    several_groups,
    the_ones,
)
from esg.graph.models import NodeEvent, Predicate

_SMALL = (
    lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.MODALS | lex.word_set("be")
    | frozenset({"and", "or", "but", "to", "not", "who", "which"})
)  # fmt: skip


def unclaimed(a: Account) -> Iterator[Gap]:
    """Everything that nothing in the document stands for."""
    for find in _FINDERS:
        yield from find(a)


def _comparisons(a: Account) -> Iterator[Gap]:
    """ "Of the same size", "bounces much higher", "twice as heavy as": what nothing sees to."""
    for start, end in not_compared(a.d.text, a.d.mentions, a.d.scene):
        if not any(s.start < end and start < s.end for s in a.kept):
            yield Gap(start, end, NOTHING)


def _left_out(a: Account) -> Iterator[Gap]:
    """Words that were taken off before anything was read ("in a blue shirt")."""
    read = [(e.start, e.end) for e in a.elements]
    for t in a.tokens:
        if t.kind != "word" or t.low in _SMALL or t.low in PASSED_OVER:
            continue
        if not any(start <= t.start < end for start, end in read):
            yield Gap(t.start, t.end, NOTHING)


_HIDING = frozenset({Predicate.BEHIND, Predicate.UNDER, Predicate.INSIDE})
_PARTICLES: dict[str, tuple[frozenset[str], frozenset[NodeEvent]]] = {
    "out": (frozenset({"away_from"}), frozenset({NodeEvent.ENTER_REGION, NodeEvent.FALL})),
    "in": (
        frozenset({"toward", "left", "right"}),
        frozenset({NodeEvent.ENTER_REGION, NodeEvent.REACH}),
    ),
}
"""Particles of verbs of motion, and the directions and events that show them."""


def _particles(a: Account) -> Iterator[Gap]:
    """ "The doors open and a man walks out": of what, if nothing shows it."""
    for c in a.d.scene.clauses:
        f = c.frame
        going = f.verb.sense in MOTIONS | {"launch"} and not f.verb.passive
        if not going or not c.movers or not any(f is g for g in a.frames):
            continue
        words = [*re.finditer(r"\S+", a.d.text[f.verb.start : f.verb.end + 4])]
        last = words[-1][0].lower().rstrip(".,;!") if words else ""
        if len(words) < 2 or last not in _PARTICLES or f.phrases:
            continue
        (ways, events), about = _PARTICLES[last], {*c.movers}
        shown = any(w.direction in ways and about & {*w.object} for w in a.kept)
        told = (n for n in a.d.timeline.nodes if n.event in events)
        if not shown and not any(about & {*n.participants} for n in told) and _enclosed(a, about):
            at = f.verb.start + words[-1].start()
            yield Gap(at, at + len(last), NOTHING, tuple(sorted(about)))


def _enclosed(a: Account, about: set[str]) -> bool:
    """Whether the scene has something that who moves could go into or come out of."""
    if any(entity_of(a.d, i).pattern == "stack" for i in about):
        return True  # "the middle one shoots out"
    if any(s.predicate in _HIDING and about & {*s.object} for s in a.kept):
        return True  # "rolls behind a screen and comes out"
    nouns = (entity_of(a.d, i).noun for i in {*a.d.world.entities} - about)
    return any(n.kind == "building" or "door" in n.name or "container" in n.traits for n in nouns)


_FINDERS: tuple[Callable[[Account], Iterator[Gap]], ...] = (
    phrases,
    adrift,
    arguments,
    left_behind,
    idle,
    kept_up,
    some_of,
    fewer,
    others_of,
    one_of_several,
    the_ones,
    several_groups,
    in_the_middle,
    parts_alone,
    attempts,
    by_nobody,
    unwaited,
    adverbs,
    _particles,
    qualities,
    said_of_it,
    _left_out,
    _comparisons,
    alone,
    from_nothing,
    hung,
    lengths,
    up_and_down,
)
