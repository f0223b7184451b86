"""How noun phrases begin: letters that are names, counts, and what a number goes with."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks, NounMatch
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import is_adjective
from esg.draft.text.elements import Mention, Verb, Word
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

EXTENTS = ("tall", "wide", "long", "high", "thick", "deep", "diameter", "heavy", "radius")
"""What an amount in front of a noun says the size of: "a 2 m long pole"."""
_OF_A_SIZE = lex.word_set("of a size")
_NOT_VAGUE = frozenset({"some", "both", "couple", "pair", "dozen", "dozens"})


_OWNED_BY = lex.word_set("owned by")


def lone_letter(c: Chunks, j: int) -> bool:
    """A capital that names an individual introduced before ("A moves ... B moves")."""
    token = token_at(c, j)
    if token is None or token.text == "I":
        return False
    known = {x for e in c.elements if isinstance(e, Mention) for x in e.letters}
    if len(token.text) > 2 and token.text[0].isupper():
        return token.text in known  # "Rex stops"
    if re.fullmatch(r"#\d{1,3}|[A-Z]\d{1,2}", token.text):
        start = token.text[0] if token.text[0] != "#" else ""
        alike = any(re.fullmatch(rf"{start}\d+", x) for x in known)
        return alike and match_noun(c, j + 1) is None  # "Robot R1 stops. R2 hits R1."
    if not re.fullmatch(r"[A-Z]", token.text):
        return False
    if token.text not in known:
        return _next_letter(c, token.text, known)
    nxt = low_at(c, j + 1)
    if token.text != "A" or nxt == "and":
        return True
    acts = bool(verb_readings(nxt)) or nxt in lex.MODALS
    return acts and match_noun(c, j + 1) is None and not is_adjective(c, j + 1)


def _next_letter(c: Chunks, letter: str, known: set[str]) -> bool:
    """ "A hits B": B comes after the letters known, where an object is told."""
    capitals = [x for x in known if len(x) == 1 and x.isalpha()]
    follows = bool(capitals) and ord(letter) == ord(max(capitals)) + 1
    previous = c.elements[-1] if c.elements else None
    link = isinstance(previous, Word) and previous.kind in ("prep", "conj")
    return follows and (link or isinstance(previous, Verb))


def numbered(c: Chunks, j: int) -> bool:
    """Whether a number that names an individual follows a bare noun, and then its verb."""
    number = low_at(c, j + 1) in ("one", "two", "three", "four", "five")
    acts = any(r.form in ("s", "past") for r in verb_readings(low_at(c, j + 2)))
    return number and low_at(c, j - 1) not in lex.DETERMINERS and acts


def parts_of(c: Chunks, j: int) -> bool:
    """ "from opposite ends of a table": parts of a thing follow."""
    return lex.singular(low_at(c, j))[0] in lex.PARTS_OF and low_at(c, j + 1) == "of"


def verb_next(c: Chunks, j: int) -> bool:
    """Whether a finite verb and its object follow ("this pushes the bin")."""
    nxt = low_at(c, j + 1)
    finite = any(r.form in ("s", "past") for r in verb_readings(low_at(c, j)))
    return finite and (nxt in lex.DETERMINERS or nxt in lex.PRONOUNS or nxt in lex.PREPOSITIONS)


def alone(c: Chunks, j: int) -> bool:
    """Whether a phrase ends before token j: a verb, a mark or a small word follows."""
    token = token_at(c, j)
    if token is None or token.kind == "punct":
        return True
    forms = {r.form for r in verb_readings(token.low)}
    small = lex.PREPOSITIONS | lex.MODALS | {"and", "but", "who", "which", "then"}
    return bool(forms & {"s", "past"}) or token.low in small or token.low.endswith("ly")


def count_of(c: Chunks, j: int, m: Mention) -> int:
    """Reads the number of things at token j; returns the token after it, j if there is none."""
    token, compound = token_at(c, j), match_noun(c, j)
    if token is None or token.kind == "qty" or (compound is not None and compound[1] > 1):
        return j  # "eight ball"
    if token.kind == "number":
        return _digits(c, j, m) if token.text[0] != "#" else j
    low = token.low
    group = low in lex.GROUP_WORDS and low_at(c, j + 1) == "of"  # "a handful of marbles"
    if low in lex.VAGUE_COUNTS and low not in _NOT_VAGUE and not group:
        m.count, m.vague = lex.VAGUE_COUNTS[low], True
        return j + 1
    value = parse_number(low) if low not in ("a", "an", "half", "a half") else None
    if not isinstance(value, float) or not value.is_integer() or value < 1:
        return j
    following = match_noun(c, j + 1)
    if _one_of_the_set(value, following, m):
        m.letters = [str(int(value))]  # "the seven pin"
        return j + 1
    if low == "one" and not _counts_one(c, j, m, following):
        return j
    times = {"dozen": 12, "hundred": 100}.get(low_at(c, j + 1), 0)
    m.count = int(value) * (times or 1)
    return j + (2 if times else 1)


def _digits(c: Chunks, j: int, m: Mention) -> int:
    value, nxt = parse_number(c.tokens[j].text), token_at(c, j + 1)
    if not isinstance(value, float) or not value.is_integer():
        return j
    if nxt is None or nxt.kind != "word" or _finite_verb(c, j + 1):
        return j
    m.count = int(value)
    return j + 1


def _counts_one(c: Chunks, j: int, m: Mention, following: NounMatch | None) -> bool:
    """Whether "one" counts the noun after it; "another one tips over", "one slides into it"."""
    if m.determiner == "another" and any(r.form == "s" for r in verb_readings(low_at(c, j + 1))):
        return False
    if low_at(c, j + 1) in ("next", "close") and low_at(c, j + 2) == "to":
        return False  # "the one next to it"
    nxt = token_at(c, j + 1)
    if nxt is None or nxt.kind != "word" or (following is not None and following[2]):
        return False
    if low_at(c, j + 1) in lex.PARTS and low_at(c, j + 2) == "of":
        return True  # "one end of a seesaw"
    if low_at(c, j + 1) in ("end", "side") and low_at(c, j - 1) in lex.PREPOSITIONS:
        return True  # "drops on one end"
    return bool(following or is_adjective(c, j + 1) or m.determiner)


def _one_of_the_set(value: float, noun: NounMatch | None, m: Mention) -> bool:
    """ "the seven pin", "the six ball": a name, as the noun is singular."""
    if noun is None or noun[2] or m.determiner != "the" or value < 2:
        return False
    return noun[0].kind in ("pin", "billiard")


def part_of_plural(c: Chunks, j: int) -> bool:
    """ "two of the ten pins": some of a plural that a noun names."""
    if low_at(c, j + 1) != "of" or low_at(c, j + 2) not in _OWNED_BY:
        return False
    value = parse_number(low_at(c, j)) if low_at(c, j) not in ("a", "an", "half") else None
    if not (isinstance(value, float) and value.is_integer() and 2 <= value <= 12):
        return False
    for k in range(j + 3, min(j + 7, len(c.tokens))):
        noun = match_noun(c, k)
        if noun is not None:
            return noun[2] or match_noun(c, k + noun[1]) is not None
    return False


def _finite_verb(c: Chunks, j: int) -> bool:
    """ "going 60 hits a wall": a verb with its object, not sixty of something."""
    finite = any(r.form == "s" for r in verb_readings(low_at(c, j)))
    return finite and match_noun(c, j) is None and low_at(c, j + 1) in lex.DETERMINERS


def finite_after_of(c: Chunks, i: int, k: int) -> bool:
    """ "with a mass of 25 kg slides": the noun after the quantity is the verb."""
    finite = any(r.form in ("s", "past") for r in verb_readings(low_at(c, k)))
    if finite and low_at(c, i - 1) == "at" and low_at(c, k + 1) in lex.DETERMINERS:
        return True  # "a motorboat at 18 knots rams a pontoon"
    if not finite and _plurally(c, i, k):
        return True
    return finite and low_at(c, i - 1) in _OF_A_SIZE


def _plurally(c: Chunks, i: int, k: int) -> bool:
    """ "crates of 5 kg and 9 kg stand on a shelf": a bare verb, after what measures many."""
    amount = c.tokens[i].amount
    listed = amount is not None and bool(amount.shares)
    low, after = low_at(c, k), low_at(c, k + 1)
    bare = any(r.form == "base" for r in verb_readings(low)) and lex.singular(low)[0] == low
    goes_on = after in lex.PREPOSITIONS | lex.DETERMINERS | lex.ADVERBS or after == ""
    return bare and listed and (goes_on or after in ("and", ",", "."))


def last_of_sizes(c: Chunks, i: int, k: int) -> bool:
    """ "a glass 15 cm tall and 7 cm wide tips over": its second side, and the verb."""
    listed = low_at(c, i - 1) in ("and", ",") and low_at(c, i - 2) in EXTENTS
    return listed and any(r.form in ("s", "past") for r in verb_readings(low_at(c, k + 1)))


def noun_at_or_after(c: Chunks, k: int) -> bool:
    for j in range(k, min(k + 5, len(c.tokens))):
        low = low_at(c, j)
        listed = c.tokens[j].text == "," and j + 1 < len(c.tokens)
        if c.tokens[j].kind == "qty" or (listed and c.tokens[j + 1].kind == "qty"):
            continue
        if match_noun(c, j) is not None:
            return low not in lex.ATTRIBUTES
        if low in ("one", "ones"):
            return True  # "the 5 kg one"
        if low in EXTENTS:
            continue
        if not is_adjective(c, j):
            return c.tokens[j].tag in ("NOUN", "PROPN") and low not in lex.ATTRIBUTES and j == k
    return False
