"""Misspelt words: read as the one word of the lexicon that is a slip away.

A word is misspelt if no table has it, the tagger's model has never met it (it knows some 80,000
words), and it is no form or compound of words that are known. Slips are letters changed round,
doubled or not doubled, one taken for another of the same word, a vowel or the last letter left
out: rare words that are spelled well ("buckboard", "doorstop") are further from others than that.
It is read as another word only where a single one can be meant. Without a model nothing is
corrected.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from itertools import chain

from esg.draft import lexicon as lex
from esg.draft.text.elements import Token
from esg.draft.text.tagging import vocabulary
from esg.lexicon import kinds, plural
from esg.lexicon.hypernyms import hypernyms
from esg.lexicon.senses import no_things

_LETTERS = "abcdefghijklmnopqrstuvwxyz"
_VOWELS = "aeiou"
_LEAST, _LEAST_CUT_OFF = 5, 8
"""Letters that a misspelt word has, and one whose last letter is left out."""
_RIGHT = lex.word_set("spelled right")
_ENDINGS = (
    "ing", "ings", "ed", "er", "ers", "s", "es", "ly", "y", "ish", "less", "ness", "like", "able",
    "est", "en", "al", "ment", "ful", "let", "ette", "ous", "ist", "ism", "proof", "wards",
)  # fmt: skip


def spelled(tokens: list[Token]) -> tuple[list[Token], list[tuple[str, str]]]:
    """Tokens with misspelt words put right, and what was read as what.

    Args:
        tokens: Tokens in order, as the prompt spells them.
    """
    words = vocabulary()
    if not words:
        return tokens, []
    out: list[Token] = []
    read: list[tuple[str, str]] = []
    for token in tokens:
        meant = _meant(token, words) if token.kind == "word" else ""
        if meant:
            read.append((token.text, meant))
        out.append(replace(token, text=meant) if meant else token)
    return out, read


def _meant(token: Token, words: frozenset[str]) -> str:
    """What a misspelt word is to be; "" for what is spelled well, or means nothing known."""
    low = token.text
    if len(low) < _LEAST or not (low.isascii() and low.isalpha() and low.islower()):
        return ""
    return "" if _known(low, words) else _nearest(low)


def _known(low: str, words: frozenset[str]) -> bool:
    """Whether a word is in a dictionary, is a form of one that is, or made of two that are."""
    if low in words or low in _tables() or low in _RIGHT:
        return True
    for ending in _ENDINGS:
        stem = low.removesuffix(ending)
        if stem == low or len(stem) < _LEAST:
            continue
        twice = stem[-1:] == stem[-2:-1] != stem[-3:-2]
        doubled = stem[:-1] if twice else stem
        stems = {stem, stem + "e", doubled, stem[:-1] + "y" if stem.endswith("i") else stem}
        if any(s in words or s in _tables() for s in stems):
            return True
    halves = ((low[:k], low[k:]) for k in range(3, len(low) - 2))
    return any(a in lex.nouns() and b in lex.nouns() for a, b in halves)


@cache
def _nearest(low: str) -> str:
    """The only word of the lexicon that a misspelt one can mean; "" if there is none.

    Of several, one that has the same letters is meant ("palced", "rabit").
    """
    near = {w for w in _edits(low) if w in _meanings() and w[0] == low[0]}
    alike = {w for w in near if set(w) == set(low)}
    found = alike or {w for w in near if _left_out(low, w)}
    if len({_meanings()[w] for w in found}) != 1:
        return ""
    return min(found, key=lambda w: (abs(len(w) - len(low)), w))


def _left_out(low: str, word: str) -> bool:
    """Whether a word lacks only a vowel, or its last letter ("sidwalk", "flashligh")."""
    if len(word) != len(low) + 1:
        return False
    if word[:-1] == low:
        return len(low) >= _LEAST_CUT_OFF and word[-1] != "s"
    return any(word[:k] + word[k + 1 :] == low and word[k] in _VOWELS for k in range(1, len(word)))


@cache
def _edits(low: str) -> frozenset[str]:
    """All words one letter away: one left out, one more, another one, two changed round."""
    parts = [(low[:k], low[k:]) for k in range(len(low) + 1)]
    return frozenset(
        chain(
            (a + b[1:] for a, b in parts if b),
            (a + b[1] + b[0] + b[2:] for a, b in parts if len(b) > 1),
            (a + x + b[1:] for a, b in parts if b for x in _LETTERS),
            (a + x + b for a, b in parts for x in _LETTERS),
        )
    )


@cache
def _meanings() -> dict[str, str]:
    """Words that can be meant, with what they are forms of."""
    out: dict[str, str] = {}
    found = chain.from_iterable((k.name, *k.found_as) for k in kinds())
    for name in chain.from_iterable(n.split() for n in chain(lex.nouns(), found)):
        if name.isalpha() and len(name) >= _LEAST:
            out.setdefault(name, name)
            out.setdefault(plural(name), name)
    for form, readings in lex.verb_forms().items():
        if form.isalpha() and len(form) >= _LEAST:
            out.setdefault(form, readings[0].lemma)
    small = chain(lex.PREPOSITIONS, lex.ADVERBS, lex.COLORS, lex.SIZES, lex.SUBORDINATORS)
    for word in small:
        if word.isalpha() and len(word) >= _LEAST:
            out.setdefault(word, word)
    return out


@cache
def _tables() -> frozenset[str]:
    """Every word of the project's tables."""
    names = chain(lex.nouns(), hypernyms(), no_things(), _meanings(), *lex.every_set())
    return frozenset(part for name in names for part in name.replace("-", " ").split())
