"""Words that nothing in the finished document stands for.

Every phrase, adverb and argument of what is told is asked what carries it; what nothing carries is
owned up to. No list says what may be missing, only `data/carriers.csv` what can carry a
preposition, and the word set "passed over (unclaimed)" what shows nothing of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.core import entity_of, movable, structural
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.slopes import ASLANT
from esg.draft.document.comparisons import not_compared
from esg.draft.events.stated import NAMED_BY
from esg.draft.statements.account import NOTHING, PASSED_OVER, Account, Gap, nodes_of, turns
from esg.draft.statements.adverbs import adverbs
from esg.draft.statements.arguments import (
    arguments,
    attempts,
    fewer,
    idle,
    left_behind,
    others_of,
    parts_alone,
    some_of,
)
from esg.draft.statements.phrases import adrift, phrases
from esg.draft.statements.places import alone, from_nothing, hung, lengths, up_and_down
from esg.draft.text.elements import ONE_OF_THESE, Mention
from esg.draft.verbphrases import verb_readings
from esg.graph.models import NodeEvent, Predicate

_QUALITIES = lex.word_set("unseen qualities")
_MOTIONS = frozenset({"own", "fly", "fall", "roll", "accelerate", "spin"})
_SMALL = (
    lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS | lex.MODALS | lex.word_set("be")
    | frozenset({"and", "or", "but", "to", "not", "who", "which"})
)  # fmt: skip


def unclaimed(a: Account) -> Iterator[Gap]:
    """Everything that nothing in the document stands for."""
    for find in _FINDERS:
        yield from find(a)


def _qualities(a: Account) -> Iterator[Gap]:
    """ "A curious sloth", and "a moving vehicle" that does not move."""
    moving = {e.actor for e in a.d.timeline.edges}
    for m in a.d.mentions:
        ids = nodes_of(a.d, m)
        if ids and structural(a.d, ids[0]):
            yield from _aslant_ground(a, m, ids)
        if not ids or structural(a.d, ids[0]):
            continue
        if ONE_OF_THESE in m.adjectives and not _in_order(a.d, ids[0]):
            yield Gap(m.start, m.end, NOTHING, tuple(ids))
        for t in a.tokens:
            if not m.start <= t.start < m.end or t.low not in m.adjectives:
                continue
            noun = entity_of(a.d, ids[0]).noun
            going = t.low.endswith("ing") and (
                _manner(t.low) or (_motion(t.low) and movable(a.d, ids[0]))
            )
            shown = _shows(a, t.low, {*ids}) or bool({*ids} & moving and not _manner(t.low))
            aslant = t.low in ASLANT and "incline" not in noun.traits
            if t.low in _QUALITIES or (going and t.low not in noun.name and not shown) or aslant:
                yield Gap(t.start, t.end, NOTHING, tuple(ids))


def _aslant_ground(a: Account, m: Mention, ids: list[str]) -> Iterator[Gap]:
    """ "Rolls down a sloped parking lot": all grounds but ramps are level."""
    for t in a.tokens:
        if m.start <= t.start < m.end and t.low in ASLANT and t.low in m.adjectives:
            yield Gap(t.start, t.end, NOTHING, tuple(ids))


def _comparisons(a: Account) -> Iterator[Gap]:
    """ "Of the same size", "bounces much higher", "twice as heavy as": what nothing sees to."""
    for start, end in not_compared(a.d.text, a.d.mentions, a.d.scene):
        if not any(s.start < end and start < s.end for s in a.kept):
            yield Gap(start, end, NOTHING)


def _in_order(d: Discourse, who: str) -> bool:
    """Whether what is ahead of another one, or behind it, is gone for by it, or goes for it."""
    movers = {e.actor for e in d.timeline.edges}
    return any(who in {e.actor, e.target} <= movers for e in d.timeline.edges)


def _motion(word: str) -> bool:
    return bool(_senses(word) & _MOTIONS) or _manner(word)


def _manner(word: str) -> bool:
    """Whether a participle tells more than that something moves ("a reversing van")."""
    return bool(_senses(word) & {*_SHOWN_BY})


def _senses(word: str) -> set[str]:
    told = (r for r in verb_readings(word) if r.form == "ing" and word not in NAMED_BY)
    return {r.lemma if r.lemma in _SHOWN_BY else r.sense for r in told}


def _jointed(a: Account, ids: set[str]) -> bool:
    return bool(ids & {j.child for j in a.d.scene.joints})


def _swings(a: Account, ids: set[str]) -> bool:
    acting = {i for n in a.d.timeline.nodes for i in n.participants}
    return _jointed(a, ids) and bool(ids & (acting | {e.actor for e in a.d.timeline.edges}))


def _hangs(a: Account, ids: set[str]) -> bool:
    says = {i for s in a.kept if s.predicate is Predicate.HANGS_FROM for i in s.object}
    return _jointed(a, ids) or bool(ids & ({*a.d.scene.attached} | says))


def _backs(a: Account, ids: set[str]) -> bool:
    return any(s.direction == "backward" and ids & {*s.object} for s in a.kept)


_SHOWN_BY: dict[str, Callable[[Account, set[str]], bool]] = {
    "spin": lambda a, ids: turns(a.d, ids),
    "turn": lambda a, ids: turns(a.d, ids),
    "reverse": _backs,
    "swing": _swings,
    "sway": _swings,
    "hang": _hangs,
    "dangle": _hangs,
}
"""What shows a participle by its sense: a van that is reversing has to go backward."""


def _shows(a: Account, word: str, ids: set[str]) -> bool:
    return any(_SHOWN_BY[s](a, ids) for s in _senses(word) & {*_SHOWN_BY})


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
        going = f.verb.sense in _MOTIONS | {"launch"} and not f.verb.passive
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
    some_of,
    fewer,
    others_of,
    parts_alone,
    attempts,
    adverbs,
    _particles,
    _qualities,
    _left_out,
    _comparisons,
    alone,
    from_nothing,
    hung,
    lengths,
    up_and_down,
)
