"""Nouns of two words that are read as one: "dust pan", "mouse trap", "bike path".

The head of such a compound alone names another thing: a dust pan is no pan to fry in.
"""

from __future__ import annotations

import csv
from dataclasses import replace
from functools import cache

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.likeness import in_dictionary, names_another
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
"""What is no first word of a compound."""


_LINKS = lex.word_set("links")
"""Ropes and lines, which what they are for tells nothing new of."""


@cache
def _rows() -> dict[str, str]:
    """Compounds by their words, and the noun that each is read as: `compounds.csv`."""
    with open(lex.DATA / "compounds.csv", encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE)
        return {words: row["reads as"] for row in rows for words in row["words"].split("|")}


def join_compounds(tokens: list[Token]) -> list[Token]:
    """Tokens of a prompt with each such noun as one token.

    Args:
        tokens: Tokens in order, with spaCy's tags where there are any.
    """
    out: list[Token] = []
    i = 0
    while i < len(tokens):
        if known := _known(tokens, i):
            out += tokens[i : i + known]
            i += known
            continue
        n, word = next(((n, w) for n in (3, 2) if (w := _compound(tokens, i, n))), (1, ""))
        if word:
            end = tokens[i + n - 1].end
            out.append(replace(tokens[i], text=word, end=end, tag="NOUN"))
        else:
            out.append(tokens[i])
        i += n
    return out


def _known(tokens: list[Token], i: int) -> int:
    """How many tokens a noun of the lexicon of several words has at token i; 0 if none is there."""
    for n in range(min(lex.longest_nouns().get(tokens[i].low, 1), len(tokens) - i), 1, -1):
        low = " ".join(t.low for t in tokens[i : i + n])
        if low in lex.nouns() or lex.singular(low)[0] in lex.nouns():
            return n
    return 0


def _compound(tokens: list[Token], i: int, n: int) -> str:
    """What the n tokens from i on are read as, "" if they are no such noun."""
    here = tokens[i : i + n]
    if len(here) < n or any(t.kind != "word" or len(t.low) < 2 for t in here):
        return ""
    low = " ".join(t.low for t in here)
    one, several = lex.singular(low)
    if n > 2:  # "boxes of matches", "box of matches"
        several = here[1].low == "of" and lex.singular(here[0].low)[1]
    joined = lex.singular(low.replace(" ", ""))[0]
    row = _rows().get(low) or _rows().get(one)
    read = row or (_dictionary(here, one, joined) if n == 2 else "")
    if not read or not (_may_stand(tokens, i, n) if row is None else _noun_here(tokens, i, n)):
        return ""
    return _many(read) if several and not read.endswith("s") else read


def _many(noun: str) -> str:
    return f"{noun}es" if noun.endswith(("sh", "ch", "x")) else f"{noun}s"


@cache
def _spelled(one: str, joined: str) -> str:
    """How the dictionaries spell a noun of two words of which the second names something else."""
    last = one.rpartition(" ")[2]
    if joined in lex.nouns():
        return joined
    if last in lex.PARTS or lex.is_part(last) or last in _LINKS:
        return ""
    known = last in lex.nouns()
    if not known and (last in lex.SUBSTANCES or no_things().get(last) == "substance"):
        return ""
    if in_dictionary(one):
        if not known:  # an unknown noun looks at the word before it by itself
            return one if verb_readings(last) else ""
        return one if names_another(one, last) else ""
    return joined if in_dictionary(joined) and (not known or names_another(joined, last)) else ""


def _dictionary(here: list[Token], one: str, joined: str) -> str:
    first, last = here[0].low, here[1].low
    if first in _CLOSED or first in lex.PARTS or last in _CLOSED or here[0].tag == "ADJ":
        return ""
    if parse_number(first) is not None:
        return ""  # "ten pins"
    return _spelled(one, joined) if lex.singular(first)[0] == first else ""


def _noun_here(tokens: list[Token], i: int, n: int) -> bool:
    """Whether the last of n tokens may be a noun: no verb that ends in -s or is of the past."""
    last, after = tokens[i + n - 1], tokens[i + n] if i + n < len(tokens) else None
    acts = any(r.form != "base" for r in verb_readings(last.low))
    objects = after is not None and after.low in lex.DETERMINERS | lex.PRONOUNS
    return not (acts and (objects or last.tag == "VERB"))


def _may_stand(tokens: list[Token], i: int, n: int) -> bool:
    """Whether such a noun may stand here, as neither of its words is a verb."""
    first, last = tokens[i], tokens[i + n - 1]
    if any(r.form != "base" for r in verb_readings(last.low)) and last.tag != "NOUN":
        return False
    if not _noun_here(tokens, i, n):
        return False
    k = i - 1
    while k >= 0 and tokens[k].tag == "ADJ" and tokens[k].low not in _BEFORE:
        k -= 1
    told = k >= 0 and tokens[k].low in _BEFORE
    verbs = verb_readings(first.low) or verb_readings(last.low)
    return told or not verbs
