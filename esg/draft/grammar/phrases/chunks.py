"""A prompt on its way from tokens to phrases."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from esg.draft.lexicon import Noun
from esg.draft.text.elements import Element, Token

NounMatch = tuple[Noun, int, bool, str]
"""A noun of the lexicon: entry, tokens used, plural, phrase."""


@dataclass
class Chunks:
    """Tokens, and the phrases read so far.

    `noun_phrase` reads the phrase that starts at a token and returns the token after it; it is
    a field because noun phrases stand within noun phrases.
    """

    text: str
    tokens: list[Token]
    lows: tuple[str, ...]
    """Lower-case words; "" for punctuation."""
    noun_phrase: Callable[[int], int | None]
    elements: list[Element] = field(default_factory=list[Element])
    nouns_at: dict[int, NounMatch | None] = field(default_factory=dict[int, "NounMatch | None"])
