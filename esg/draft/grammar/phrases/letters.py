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


def _letter(c: Chunks, k: int, m: Mention) -> str | None:
    """The name at token k: "A", "#2", "one", "3"; None where none stands there."""
    token = token_at(c, k)
    if token is None:
        return None
    if token.kind == "number":
        return _number(c, k, m)
    if token.kind != "word":
        return None
    if re.fullmatch(r"[A-Z]\d{0,2}", token.text):
        return token.text
    if token.low in _NAMING and not m.determiner and not m.plural and m.count is None:
        return token.low if match_noun(c, k + 1) is None else None
    if re.fullmatch(r"[b-hj-z]", token.text):
        return token.text.upper()
    if token.text != "a" or m.noun is None or m.determiner:
        return None
    nxt = low_at(c, k + 1)
    known = bool(match_noun(c, k + 1)) or is_adjective(c, k + 1)
    acts = (verb_readings(nxt) or nxt in lex.MODALS) and not known
    return "A" if acts or nxt in ("and", "'s") else None


def _number(c: Chunks, k: int, m: Mention) -> str | None:
    """ "#2", "3": a number that names, not one that counts what follows."""
    text = c.tokens[k].text
    if text[0] == "#":
        return text[1:]
    if not re.fullmatch(r"\d{1,2}", text):
        return None
    nxt = token_at(c, k + 1)
    if nxt is None or nxt.kind != "word" or not match_noun(c, k + 1):
        return text
    bare = (not m.determiner and m.count is None) or text == "1"
    acts = any(r.form == "s" for r in verb_readings(nxt.low))
    return text if bare and acts else None  # "ball 1 rams ball 2"


def _text(c: Chunks, k: int) -> str:
    token = token_at(c, k)
    return token.text if token is not None else ""


def _separator(c: Chunks, k: int) -> bool:
    return _text(c, k) == "," or low_at(c, k) == "and"


def _list(c: Chunks, j: int, m: Mention) -> int:
    """Further names after the first: ", B and C"; the next index."""
    while True:
        k = j
        while k < j + 2 and _separator(c, k):
            k += 1
        found = _letter(c, k, m) if k > j and (m.plural or len(m.letters) > 1) else None
        if found is None:
            return j
        m.letters.append(found)
        j = k + 1


def letters(c: Chunks, j: int, m: Mention) -> int:
    """Individual names after a head: "ball A", "balls A, B and C", "car 1", "ball #2"."""
    if not m.head or m.pronoun or m.attribute:
        return j
    first = _letter(c, j + 1, m)
    if m.plural and _text(c, j) in (",", "(", ":") and first and _separator(c, j + 2):
        m.letters.append(first)
        j = _list(c, j + 2, m)
        return j + (_text(c, j) == ")")
    quoted = _text(c, j) in ('"', "'", "“", "(") and _text(c, j + 2) in ('"', "'", "”", ")")
    if quoted and first:
        m.letters.append(first)
        return j + 3
    named = _name(c, j, m)
    if named:
        return named
    if low_at(c, j) in ("labeled", "labelled", "named", "called", "number") and first:
        j += 1
    found = _letter(c, j, m)
    if found is None:
        return j
    m.letters.append(found)
    return _list(c, j + 1, m)
