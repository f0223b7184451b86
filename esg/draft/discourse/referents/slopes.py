"""Boards that are set aslant: what rolls down them needs a slope."""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex

ASLANT = lex.word_set("aslant")
_BOARDS = lex.word_set("boards")


def as_slope(noun: lex.Noun, head: str, adjectives: list[str]) -> lex.Noun:
    """The noun of "an inclined plank", "a tilted board": a ramp; any other noun as it is."""
    if not ASLANT & {*adjectives} or head not in _BOARDS:
        return noun
    return replace(lex.nouns()["ramp"], description=f"{head} set aslant as a ramp")
