"""When what is told takes place: before a hit that it goes on after, and by the clock."""

from __future__ import annotations

from itertools import pairwise

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Verb

_CONTROL = lex.word_set("control")
_ON = lex.word_set("on")
_DRIVING = lex.word_set("driving (underway)")
_AT_REST = lex.word_set("at rest")
_RESTING = lex.word_set("resting (underway)")


def goes_on(told: list[Frame], verb: Verb, actor: str, words: list[str], text: str) -> bool:
    """Whether what is hit was moving: the first thing told of it afterwards presupposes that.

    Args:
        told: The clauses in order of time, with their noun phrases resolved.
        verb: The verb of the hit.
        actor: What is hit, that can move by itself and of which no motion has been told.
        words: Adjectives of `actor`.
        text: The prompt.
    """
    at = next((k for k, f in enumerate(told) if f.verb is verb), -1)
    if at < 0 or _RESTING & set(words):
        return False
    for k, f in enumerate(told):
        if f.subject is None or actor not in f.subject.entities or f.verb is verb:
            continue
        if f.verb.sense in _AT_REST and (k < at or f.reduced):
            return False
        if k < at:
            continue
        if f.unreal or f.verb.negated or f.verb.passive or f.verb.infinitive:
            return False
        particles = {*f.adverbs, *text[f.verb.start : f.verb.end].lower().split()}
        on = bool(_ON & particles) or "continue" in f.verb.extra
        on = on or f.verb.sense == "continue"
        return f.verb.sense in _CONTROL or (on and f.verb.sense in _DRIVING)
    return False


def by_the_clock(frames: list[Frame]) -> list[Frame]:
    """ "At 4 s it hits a lamp. At 2 s it hits a car.": the clauses, the earlier sentence first.

    Args:
        frames: Clauses in the order told.
    """
    now = -1.0
    keys: list[float] = []
    spoken = -1
    for f in frames:
        times = [(p.prep, p.amount) for p in f.phrases if p.amount is not None]
        at = [a for p, a in times if a.dimension == "time" and (p == "at" or a.measure == "start")]
        if at and f.sentence != spoken and not f.subordinate and not f.unreal:
            now, spoken = at[0].low, f.sentence
        keys.append(now)
    if all(a <= b for a, b in pairwise(keys)):
        return frames
    order = sorted(range(len(frames)), key=lambda k: keys[k])
    return [frames[k] for k in order]
