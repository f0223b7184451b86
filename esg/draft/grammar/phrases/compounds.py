"""Nouns of two or three words that are read as one: "dust pan", "mouse trap", "bike path".

The head of such a compound alone names another thing: a dust pan is no pan to fry in.
"""

from __future__ import annotations

import csv
from dataclasses import replace
from functools import cache, lru_cache

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.likeness import in_dictionary, in_wordnet, names_another
from esg.draft.text.elements import Token
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings
from esg.lexicon.senses import no_things

_BEFORE = lex.DETERMINERS | lex.PREPOSITIONS | lex.word_set("quantifiers of") | {"'s"}
_CLOSED = (
    lex.PREPOSITIONS | lex.ADVERBS | lex.DETERMINERS | lex.PRONOUNS | lex.SUBORDINATORS
    | lex.MODALS | lex.COLORS.keys() | lex.SIZES.keys() | lex.ORDINALS.keys()
    | lex.STRETCHES.keys() | lex.WEIGHTS.keys()
)  # fmt: skip
"""What is no word of a compound that no row spells."""
_LINKS = lex.word_set("links")
"""Ropes and lines, which what they are for tells nothing new of."""
_LONGEST = 3


@cache
def _rows() -> dict[str, str]:
    """Compounds by their words, and the noun that each is read as: `compounds.csv`."""
    with open(lex.DATA / "compounds.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE)
        return {words: row["reads as"] for row in rows for words in row["words"].split("|")}


@cache
def _opening() -> frozenset[str]:
    """First words of rows of three words, in the singular."""
    return frozenset(words.split()[0] for words in _rows() if words.count(" ") > 1)


def join_compounds(tokens: list[Token]) -> list[Token]:
    """Tokens of a prompt with each such noun as one token.

    Args:
        tokens: Tokens in order, with spaCy's tags where there are any.
    """
    out: list[Token] = []
    i = 0
    while i < len(tokens):
        n, word = _told(tokens, i)
        if not word:
            n = _known(tokens, i)
            n, word = (n, "") if n else _compound(tokens, i)
        if word:
            end = tokens[i + n - 1].end
            out.append(replace(tokens[i], text=word, end=end, tag="NOUN"))
        else:
            out += tokens[i : i + n]
        i += n
    return out


def _known(tokens: list[Token], i: int) -> int:
    """How many tokens a noun of the lexicon of several words has at token i; 0 if none is there."""
    most = lex.longest_nouns().get(tokens[i].low, 1)
    for n in range(min(most, len(tokens) - i), 1, -1):
        low = " ".join(t.low for t in tokens[i : i + n])
        if low in lex.nouns() or lex.singular(low)[0] in lex.nouns():
            return n
    return 0


def _told(tokens: list[Token], i: int) -> tuple[int, str]:
    """How many tokens from i on a row of the table has, and what they are read as; or 0 and ""."""
    first = tokens[i]
    if first.low in _rows():
        return 1, _rows()[first.low]  # "the baseboard"
    if lex.singular(first.low)[0] in _opening():
        here = tokens[i : i + _LONGEST]
        read = _row(" ".join(t.low for t in here)) if len(here) == _LONGEST else ""
        if read and _noun_here(tokens, i, _LONGEST):
            return _LONGEST, read
    last = tokens[i + 1] if i + 1 < len(tokens) else None
    read = _row(f"{first.low} {last.low}") if last is not None else ""
    return (2, read) if read and _noun_here(tokens, i, 2) else (0, "")


def _compound(tokens: list[Token], i: int) -> tuple[int, str]:
    """2 and what two tokens are read as that no row has; 1 and "" if they are no such noun."""
    first, last = tokens[i], tokens[i + 1] if i + 1 < len(tokens) else None
    if last is None or first.kind != "word" or last.kind != "word" or first.tag == "ADJ":
        return 1, ""
    read = _spelled(first.low, last.low)
    return (2, _number(read, last.low)) if read and _may_stand(tokens, i) else (1, "")


@lru_cache(maxsize=65536)
def _row(low: str) -> str:
    """What a row of the table reads words as, a plural of them as a plural; "" if none has them."""
    if (read := _rows().get(low)) is not None:
        return read  # "monkey bars"
    front, of, back = low.partition(" of ")
    one, several = lex.singular(front if of else low)
    read = _rows().get(f"{one}{of}{back}", "") if several else ""
    return _number(read, front if of else low) if read else ""


def _number(noun: str, counted: str) -> str:
    """The noun as a plural where the word that is counted is one."""
    if not lex.singular(counted)[1] or noun.endswith("s"):
        return noun
    return f"{noun}es" if noun.endswith(("sh", "ch", "x")) else f"{noun}s"


@lru_cache(maxsize=65536)
def _spelled(first: str, last: str) -> str:
    """How the dictionaries spell a noun of two words of which the second names something else."""
    if min(len(first), len(last)) < 2 or first in _CLOSED or last in _CLOSED:
        return ""
    if first in lex.PARTS or lex.singular(first)[1] or parse_number(first) is not None:
        return ""  # "ten pins"
    one, joined, last = (lex.singular(w)[0] for w in (f"{first} {last}", first + last, last))
    if joined in lex.nouns():
        return joined
    if last in lex.PARTS or lex.is_part(last) or last in _LINKS:
        return ""
    if any(r.form == "ing" for r in verb_readings(first)) and not in_wordnet(one):
        return ""  # "the hanging lantern"
    known = last in lex.nouns()
    if not known and (last in lex.SUBSTANCES or no_things().get(last) == "substance"):
        return ""
    if in_dictionary(one):
        if not known:  # an unknown noun looks at the word before it by itself
            return one if verb_readings(last) else ""
        return one if names_another(one, last) else ""
    return joined if in_dictionary(joined) and (not known or names_another(joined, last)) else ""


def _noun_here(tokens: list[Token], i: int, n: int) -> bool:
    """Whether the last of n tokens may be a noun: no verb that ends in -s or is of the past."""
    last, after = tokens[i + n - 1], tokens[i + n] if i + n < len(tokens) else None
    acts = any(r.form != "base" for r in verb_readings(last.low))
    objects = after is not None and after.low in lex.DETERMINERS | lex.PRONOUNS
    return not (acts and (objects or last.tag == "VERB"))


def _may_stand(tokens: list[Token], i: int) -> bool:
    """Whether a noun of two words that no row spells may stand at token i: neither is a verb."""
    first, last = tokens[i], tokens[i + 1]
    readings = verb_readings(last.low)
    if last.tag == "VERB" and readings:
        return False  # "the sheep walk through a gate"
    if any(r.form != "base" for r in readings) and last.tag != "NOUN":
        return False
    if not _noun_here(tokens, i, 2):
        return False
    k = i - 1
    while k >= 0 and tokens[k].tag == "ADJ" and tokens[k].low not in _BEFORE:
        k -= 1
    told = k >= 0 and tokens[k].low in _BEFORE
    return told or not (verb_readings(first.low) or verb_readings(last.low))
