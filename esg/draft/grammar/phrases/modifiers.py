"""Modifiers of several words in front of a noun, read as one: "slightly damaged", "brand new".

They say how a thing looks. Left apart, their participle reads as a verb ("a badly dented car") or
their noun as the thing ("a brand new bus").
"""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.text.elements import Token
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_DEGREES = lex.word_set("degrees")
_SET = {
    "brand": frozenset({"new"}),
    "stone": frozenset({"cold", "dead"}),
    "bone": frozenset({"dry"}),
    "rock": frozenset({"hard", "solid"}),
    "wide": frozenset({"open", "awake"}),
    "fast": frozenset({"asleep"}),
    "pitch": frozenset({"black", "dark"}),
    "razor": frozenset({"sharp"}),
    "soaking": frozenset({"wet"}),
    "ice": frozenset({"cold"}),
}
"""Nouns and adjectives that only strengthen the adjective after them."""
_MOST = 12
"""Most words in front of a noun that are looked back over for its determiner."""
_OWNERS = lex.word_set("owners")


def join_modifiers(tokens: list[Token], text: str) -> list[Token]:
    """Tokens of a prompt with each such modifier as one adjective.

    Args:
        tokens: Tokens in order, with spaCy's tags where there are any.
        text: The prompt.
    """
    out: list[Token] = []
    i = 0
    while i < len(tokens):
        token = tokens[i]
        n = _modifier(tokens, i) if token.kind == "word" and _opens(out) else 0
        if n:
            end = tokens[i + n - 1].end
            out.append(replace(token, text=text[token.start : end], end=end, tag="ADJ"))
        elif _second_of_two(tokens, i, out):
            pass  # "a wet and heavy towel"
        elif _lone_participle(tokens, i, out):
            out.append(replace(token, tag="ADJ"))
        else:
            out.append(token)
        i += n or 1
    return out


def _opens(before: list[Token]) -> bool:
    """Whether modifiers of a noun can follow."""
    n = len(before)
    for _ in range(_MOST):
        if n <= 0:
            return False
        last = before[n - 1]
        if last.low in lex.DETERMINERS or last.low in _OWNERS or _counts(last):
            return True
        if last.text == "," and n > 1 and before[n - 2].tag == "ADJ":
            n -= 2
            continue
        plain = last.tag == "ADJ" and last.kind == "word" and not verb_readings(last.low)
        if not plain and not _degree(last):
            return False
        n -= 1
    return False


def _modifier(tokens: list[Token], i: int) -> int:
    """Number of tokens of a modifier of two or more words at token i; 0 if there is none."""
    k = i
    low = tokens[k].low
    if k + 1 < len(tokens) and tokens[k + 1].low in _SET.get(low, ()):
        return 2 if _noun_follows(tokens, k + 2) else 0
    while k < len(tokens) and k < i + 3 and _degree(tokens[k]):
        k += 1
    if k == i or k >= len(tokens) or tokens[k].kind != "word":
        return 0
    low = tokens[k].low
    if low in lex.COLORS or low in lex.SIZES or low in lex.WEIGHTS or low in lex.MATERIALS:
        return 0
    if (
        low in lex.DETERMINERS
        or low in lex.PREPOSITIONS
        or low in lex.ORDINALS
        or low.endswith("s")
    ):
        return 0
    participle = any(r.form in ("pp", "ing") for r in verb_readings(low))
    participle = participle or tokens[k].tag == "VERB"  # "a brightly lit window"
    if not participle and tokens[k].tag != "ADJ":
        return 0
    return k + 1 - i if _noun_follows(tokens, k + 1) else 0


def _lone_participle(tokens: list[Token], i: int, out: list[Token]) -> bool:
    """ "A stretched plastic sheet": a participle of a verb that no table has."""
    token = tokens[i]
    shaped = token.kind == "word" and token.low.endswith(("ed", "en")) and token.tag == "VERB"
    known = bool(verb_readings(token.low)) or token.low in lex.nouns()
    return shaped and not known and _opens(out) and _noun_follows(tokens, i + 1)


def _counts(token: Token) -> bool:
    """ "Two brightly painted boats": a number that no unit follows."""
    told = token.kind == "number" or (token.kind == "word" and token.low in lex.VAGUE_COUNTS)
    return told or (token.kind == "word" and isinstance(parse_number(token.low), float))


def _degree(token: Token) -> bool:
    low = token.low
    if token.kind != "word" or low in lex.nouns() or low in lex.COLORS:
        return False
    return low in _DEGREES or (low.endswith("ly") and token.tag in ("ADV", ""))


def _noun_follows(tokens: list[Token], i: int) -> bool:
    """Whether adjectives at most and then a noun follow."""
    for k in range(i, min(i + 4, len(tokens))):
        token = tokens[k]
        if token.kind != "word" or token.low in lex.DETERMINERS | lex.PREPOSITIONS | lex.PRONOUNS:
            return False
        single = lex.singular(token.low)[0]
        if token.tag in ("NOUN", "PROPN") or token.low in lex.nouns() or single in lex.nouns():
            return True
        if token.tag not in ("ADJ", "VERB", "") and not _degree(token):
            return False
    return False


def _second_of_two(tokens: list[Token], i: int, out: list[Token]) -> bool:
    """ "and" between two adjectives of one thing."""
    if tokens[i].low != "and" or not out or i + 1 >= len(tokens) or not _opens(out):
        return False
    first, n = out[-1], _modifier(tokens, i + 1)
    opens = len(out) > 1 and out[-2].low in lex.DETERMINERS and first.tag == "ADV"
    if opens and first.low not in lex.nouns():
        first = replace(first, tag="ADJ")  # "a still and clear river"
    if first.tag != "ADJ" or first.kind != "word" or first.low in lex.DETERMINERS:
        return False
    pair = [first] if n else [first, tokens[i + 1]]
    apart = {*lex.ORDINALS, *lex.PLACE_ADJECTIVES, *lex.COLORS}
    if any(
        (t.tag != "ADJ" and "-" not in t.low) or t.low in apart or verb_readings(t.low)
        for t in pair
    ):
        return False
    follows = _noun_follows(tokens, i + 1 + (n or 1))
    return follows and tokens[i + 1].low not in lex.nouns()
