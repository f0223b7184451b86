"""Verbs parted by "does" or "did": "only then does the lamp fall" is "only then the lamp falls"."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.draft import lexicon as lex
from esg.draft.text.elements import Token
from esg.draft.verbphrases import verb_readings

_DOES = frozenset({"do", "does", "did"})
_OPENS = re.compile(r"(?:(?:and|but) )?(?:only|not until|not before \d)\b.*")
_ALONE = frozenset({"only", "then", "now"})
"""Words after which no comma parts the clause that follows."""
_STOPS = frozenset(".;:!?\n")
_ENDS = lex.word_set("particles (reorder)") | {"and", "or", "to", "with", "at", "onto", "over"}


def straight_verbs(tokens: list[Token]) -> list[Token]:
    """Puts verbs that stand behind their subject, with "does" before it, into plain order.

    Args:
        tokens: Words and quantities of a prompt.
    """
    out: list[Token] = []
    begin = 0
    verbs: set[int] = set()
    for i, token in enumerate(tokens):
        if token.low in _STOPS:
            begin = len(out) + 1
        verb = _verb(tokens, i) if token.low in _DOES else -1
        opening = " ".join(t.low for t in out[begin:]) if verb >= 0 else ""
        if verb < 0 or not _OPENS.fullmatch(opening):
            changed = replace(token, text=_third(token.low), tag="VERB") if i in verbs else token
            out.append(changed)
            continue
        verbs.add(verb)
        if opening.split()[-1] not in _ALONE:
            out.append(Token(",", token.start, token.start, "punct"))
        if out[begin + 1 : begin + 2] and out[begin].low == "not":
            first, until = out[begin], out[begin + 1]
            out[begin : begin + 2] = [Token("after", first.start, until.end, "word")]
    return out


def _verb(tokens: list[Token], i: int) -> int:
    """Where the verb stands that "does" at i belongs to; -1 if there is none."""
    found = -1
    for k in range(i + 2, len(tokens)):
        token = tokens[k]
        named = found >= 0 or k > i + 2
        if token.kind != "word" or token.low in _ENDS:
            break
        if named and token.low in lex.DETERMINERS | lex.PRONOUNS:
            break
        if any(r.form == "base" for r in verb_readings(token.low)):
            found = k
    return found


def _third(verb: str) -> str:
    """The form of a verb after "it"."""
    if verb.endswith(("s", "x", "ch", "sh", "o", "z")):
        return f"{verb}es"
    return f"{verb[:-1]}ies" if re.search(r"[^aeiou]y$", verb) else f"{verb}s"
