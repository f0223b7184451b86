"""Nouns of the lexicon among the tokens of a text."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks, NounMatch
from esg.draft.text.elements import Token
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_TURNS_GREEN = re.compile(
    r"\s+(?:\w+\s+){1,2}?(?:to\s+|back\s+to\s+)?(?:red|green|amber)\b|\s+to\s+change\b",
    re.IGNORECASE,
)

_WAITS_AT = re.compile(
    r"\b(?:brak|halt|idl|pull|queu|stand|stop|wait)\w*\s+(?:up\s+)?at\s+(?:the|a|some)\s+$",
    re.IGNORECASE,
)
"""What traffic does "at the light"."""
_COMPOUND = 2
"""Words of a noun whose last one may be a verb."""
_AFTER_A_NOUN = frozenset(
    {"", ".", ",", ";", "and", "then", "when", "while", "until", "for", "as", "to"}
)


def token_at(c: Chunks, i: int) -> Token | None:
    return c.tokens[i] if 0 <= i < len(c.tokens) else None


def low_at(c: Chunks, i: int) -> str:
    return c.lows[i] if 0 <= i < len(c.lows) else ""


def match_noun(c: Chunks, i: int) -> NounMatch | None:
    """Longest lexicon noun at token i: entry, tokens used, plural, phrase."""
    if i not in c.nouns_at:  # asked several times, of tokens that stay as they are
        c.nouns_at[i] = _find_noun(c, i)
    return c.nouns_at[i]


def _find_noun(c: Chunks, i: int) -> NounMatch | None:
    if not 0 <= i < len(c.tokens) or _modal(c, i) or _picks_up(c, i):
        return None
    most = lex.longest_nouns().get(c.tokens[i].low, 1)
    if low_at(c, i + 1) == "of":
        most = max(most, lex.longest_nouns().get(lex.singular(c.tokens[i].low)[0], 1))
    for n in range(min(most, len(c.tokens) - i), 0, -1):
        window = c.tokens[i : i + n]
        if any(t.kind != "word" and (t.kind != "number" or n == 1) for t in window):
            continue
        found, verb = _entry(c, i, [t.low for t in window])
        if found is not None or verb:
            return found
    return _compounded(c, i)


def _entry(c: Chunks, i: int, words: list[str]) -> tuple[NounMatch | None, bool]:
    """The entry of just these words; and whether they are a verb and no noun at all."""
    table, n = lex.nouns(), len(words)
    phrase = " ".join(words)
    last, plural = lex.singular(words[-1])
    single = " ".join([*words[:-1], last])
    if phrase in table and (single == phrase or single not in table):
        if n == _COMPOUND and pair_acts(c, i + 1) and _alike(c, i):
            return None, False
        return (table[phrase], n, words[-1] == "billiards", phrase), False
    if single in table:
        if plural and table[single].kind == "ground" and _lands_on(c, i + n - 1):
            return None, True
        counted = parse_number(words[0]) is not None  # "eight balls" are not "the eight ball"
        if n == _COMPOUND and pair_acts(c, i + 1) and _alike(c, i):
            return None, False
        if not (n > 1 and plural and (counted or _subject_and_verb(c, i, words))):
            return (table[single], n, plural or words[-1] == "billiards", single), False
    if n > 2 and words[1] == "of":  # "two blocks of ice"
        first, several = lex.singular(words[0])
        piece = " ".join([first, *words[1:]])
        if several and piece in table:
            return (table[piece], n, True, piece), False
    dashed = "-".join(words)
    return ((table[dashed], n, False, dashed) if n > 1 and dashed in table else None), False


def _compounded(c: Chunks, i: int) -> NounMatch | None:
    """Nouns that no entry spells: "six-year-olds", "lights" that turn green."""
    table, low = lex.nouns(), low_at(c, i)
    if low.removesuffix("s").endswith("-year-old"):
        return table["child"], 1, low.endswith("s"), "child"
    if low in ("light", "lights") and _of_traffic(c, i):
        return table["traffic light"], 1, False, "traffic light"
    return None


def _modal(c: Chunks, i: int) -> bool:
    """ "The viewer can watch": no tin."""
    if low_at(c, i) != "can" or i == 0 or i + 1 >= len(c.tokens):
        return False
    before, after = c.tokens[i - 1], c.tokens[i + 1]
    if before.tag not in ("NOUN", "PROPN"):
        return False
    verb = after.tag == "VERB" or low_at(c, i + 1) == "be"
    return verb and c.tokens[i].tag == "AUX" and lex.singular(after.low)[0] == after.low


def _picks_up(c: Chunks, i: int) -> bool:
    """ "Pick up the cup": no lorry."""
    up = low_at(c, i) == "pick" and low_at(c, i + 1) == "up"
    return up and low_at(c, i + 2) in lex.DETERMINERS


def _of_traffic(c: Chunks, i: int) -> bool:
    """ "The lights turn green", "stops at the light": no lamps."""
    here = c.tokens[i]
    stops = _WAITS_AT.search(c.text, max(0, here.start - 30), here.start)
    alone = low_at(c, i + 1) in _AFTER_A_NOUN and stops is not None
    return alone or _TURNS_GREEN.match(c.text, here.end) is not None


def _lands_on(c: Chunks, i: int) -> bool:
    """ "The brick lands on a car", "seen from afar crosses a bridge": verbs, no grounds."""
    verb = any(r.form == "s" for r in verb_readings(low_at(c, i)))
    return verb and low_at(c, i + 1) in lex.PREPOSITIONS | {"a", "an", "the"}


def pair_acts(c: Chunks, i: int) -> bool:
    """ "A truck and a bus stop": what two do is told by word i, and no bus stop stands there."""
    if i < _COMPOUND or not any(r.form == "base" for r in verb_readings(low_at(c, i))):
        return False
    articles = low_at(c, i - 2) in ("a", "an", "the") and low_at(c, i - 3) == "and"
    start = next((k for k in range(i - 1, -1, -1) if c.tokens[k].text in ".;:!?"), -1) + 1
    end = next((k for k in range(i, len(c.tokens)) if c.tokens[k].text in ".;:!?"), len(c.tokens))
    rest = [*range(start, i - 1), *range(i + 1, end)]
    one = low_at(c, start) in ("a", "an", "the") and low_at(c, start) != low_at(c, i - 3)
    told = any(c.tokens[k].tag in ("VERB", "AUX") or _finite(low_at(c, k)) for k in rest)
    return articles and one and not told and low_at(c, i + 1) not in ("of", "and")


def _finite(low: str) -> bool:
    return low not in lex.nouns() and any(r.form in ("s", "past") for r in verb_readings(low))


def _alike(c: Chunks, i: int) -> bool:
    """Whether the nouns before "and" and after it are of one kind: a truck and a bus."""
    one, other = (lex.nouns().get(low_at(c, k)) for k in (i - 3, i))
    return one is not None and other is not None and one.kind == other.kind


def _subject_and_verb(c: Chunks, i: int, words: list[str]) -> bool:
    """ "The bus stops at the crossing": a subject with its verb, not several bus stops."""
    if i == 0 or low_at(c, i - 1) not in ("a", "an", "the", "this", "that", "each", "every"):
        return False
    if " ".join(words[:-1]) not in lex.nouns():
        return False
    nxt = low_at(c, i + len(words))
    plural_verb = nxt in lex.MODALS or nxt in ("are", "were", "have", "that", "which", "of")
    return not plural_verb and any(r.form == "s" for r in verb_readings(words[-1]))
