"""Individual names after a noun: "ball A", "balls A, B and C", "car 1", "player two"."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import is_adjective
from esg.draft.text.elements import Mention
from esg.draft.verbphrases import verb_readings

_CALLED = lex.word_set("called")
_QUOTES = frozenset({'"', "“", "”", "„", "«", "»", "'", "‘"})
_NAMING = lex.word_set("naming")


def _name(c: Chunks, j: int, m: Mention) -> int:
    """Reads "named Rex", "called "O'Brien"", "labelled "B-2"" after a head; the next index."""
    k = j
    comma = token_at(c, k) is not None and c.tokens[k].text == ","
    k += comma
    naming = low_at(c, k) in _CALLED
    of = low_at(c, k) == "of" and token_at(c, k + 1) is not None
    k += naming or (of and c.tokens[k + 1].text in _QUOTES)
    quoted = token_at(c, k) is not None and c.tokens[k].text in _QUOTES
    if not (naming or quoted) or m.letters:
        return 0
    if quoted:
        near = range(k + 1, min(k + 7, len(c.tokens)))
        ends = [n for n in near if c.tokens[n].text[-1] in _QUOTES]
        first = token_at(c, k + 1)
        if not ends or first is None or not (naming or first.text[:1].isupper()):
            return 0
        start, end = c.tokens[k].end, c.tokens[ends[0]].end
        after = ends[0] + 1
    else:
        if token_at(c, k) is None or not c.tokens[k].text[:1].isupper() or comma:
            return 0
        after = k + 1
        while token_at(c, after) is not None and c.tokens[after].text[:1].isupper():
            after += 1
        start, end = c.tokens[k].start, c.tokens[after - 1].end
    name = c.text[start:end].strip("\"'“”‘’ ")
    if not re.search(r"[A-Za-z]", name) or len(name) < 2:
        return 0
    m.letters.append(name)
    m.end = end
    return after


def letters(c: Chunks, j: int, m: Mention) -> int:
    """Individual names after a head: "ball A", "balls A, B and C", "car 1", "ball #2"."""

    def letter(k: int) -> str | None:
        token = token_at(c, k)
        if token is None:
            return None
        if token.kind == "word" and re.fullmatch(r"[A-Z]\d{0,2}", token.text):
            return token.text
        if token.kind == "number" and token.text[0] == "#":
            return token.text[1:]
        if token.low in _NAMING and not m.determiner and not m.plural and m.count is None:
            return token.low if match_noun(c, k + 1) is None else None
        if token.kind == "word" and re.fullmatch(r"[b-hj-z]", token.text):
            return token.text.upper()
        if token.kind == "word" and token.text == "a" and m.noun is not None:
            nxt = low_at(c, k + 1)
            known = bool(match_noun(c, k + 1)) or is_adjective(c, k + 1)
            if (verb_readings(nxt) or nxt in lex.MODALS) and not known and not m.determiner:
                return "A"
            if nxt in ("and", "'s") and not m.determiner:
                return "A"
        if token.kind == "number" and re.fullmatch(r"\d{1,2}", token.text):
            nxt = token_at(c, k + 1)
            if nxt is None or nxt.kind != "word" or not match_noun(c, k + 1):
                return token.text
            bare = (not m.determiner and m.count is None) or token.text == "1"
            if bare and any(r.form == "s" for r in verb_readings(nxt.low)):
                return token.text  # "ball 1 rams ball 2"
        return None

    if not m.head or m.pronoun or m.attribute:
        return j
    opening = token_at(c, j)
    if (
        m.plural
        and opening is not None
        and opening.text in (",", "(", ":")
        and letter(j + 1)
        and token_at(c, j + 2) is not None
        and (c.tokens[j + 2].text == "," or low_at(c, j + 2) == "and")
    ):
        j += 1
        m.letters.append(letter(j) or "")
        j += 1
        while True:
            k = j
            while token_at(c, k) is not None and (c.tokens[k].text == "," or low_at(c, k) == "and"):
                k += 1
            found = letter(k) if k > j else None
            if found is None:
                break
            m.letters.append(found)
            j = k + 1
        if token_at(c, j) is not None and c.tokens[j].text == ")":
            j += 1
        return j
    if token_at(c, j) is not None and c.tokens[j].text in ('"', "'", "“", "(") and letter(j + 1):
        found = letter(j + 1)
        closing = token_at(c, j + 2)
        if found and closing is not None and closing.text in ('"', "'", "”", ")"):
            m.letters.append(found)
            return j + 3
    named = _name(c, j, m)
    if named:
        return named
    if low_at(c, j) in ("labeled", "labelled", "named", "called", "number") and letter(j + 1):
        j += 1
    found = letter(j)
    if found is None:
        return j
    m.letters.append(found)
    j += 1
    while True:
        k = j
        if token_at(c, k) is not None and c.tokens[k].text == ",":
            k += 1
        if low_at(c, k) == "and":
            k += 1
        if k == j:
            return j
        found = letter(k) if (m.plural or len(m.letters) > 1) else None
        if found is None:
            return j
        m.letters.append(found)
        j = k + 1
