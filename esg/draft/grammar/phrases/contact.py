"""Relative clauses without their word: "a ball someone threw" is "a ball that someone threw"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Token
from esg.draft.text.numerals import parse_number
from esg.draft.verbphrases import verb_readings

_WHO = frozenset({"he", "she", "they", "i", "we", "you", "someone", "somebody"})
"""Subjects that need no article."""
_DONE_TO = frozenset({"launch", "drop", "hit", "carry", "knock", "tow"})
"""Senses of verbs whose object may stand before them."""
_MADE = lex.word_set("made (relatives)")
_BEFORE_THE_VERB = frozenset({"just", "already", "only", "had", "has", "have", "once"})
_SHARES = frozenset({"all", "both", "several", "many"})
_FINITE = frozenset({"VERB", "AUX"})
_NOUNS = frozenset({"NOUN", "PROPN"})
_STOPS = frozenset(".;:!?\n")
_MOST = 3
"""Words of a subject after its article, at most."""


def name_relatives(tokens: list[Token]) -> list[Token]:
    """Puts "that" before clauses that follow a noun without it.

    Args:
        tokens: Words and quantities of a prompt.
    """
    out: list[Token] = []
    sub = False
    for i, token in enumerate(tokens):
        before = tokens[i - 1].low if i else "."
        if before in _STOPS:
            sub = token.low in lex.SUBORDINATORS | lex.PREPOSITIONS
        elif before == ",":
            sub |= token.low in lex.SUBORDINATORS
        verb = _verb_of(tokens, i) if _after_noun(tokens, i) else -1
        if verb > 0 and _bare(tokens, verb, sub):
            out.append(Token("that", token.start, token.start, "word", tag="PRON"))
        out.append(token)
    return out


def some_of_them(tokens: list[Token]) -> list[Token]:
    """Tells what some do in a clause of their own: "six cans, two of which fall", "of which two".

    Args:
        tokens: Words and quantities of a prompt.
    """
    out: list[Token] = []
    i = 0
    while i < len(tokens):
        share_first = _how_many(tokens, i) and _of_which(tokens, i + 1)
        share_last = bool(i) and _of_which(tokens, i) and _how_many(tokens, i + 2)
        if not (share_first or share_last) or not _told_before(tokens, i):
            out.append(tokens[i])
            i += 1
        elif share_first:
            of, which = tokens[i + 1], tokens[i + 2]
            out += _apart(out, tokens[i].start)
            out += [tokens[i], of, Token("them", which.start, which.end, "word", tag="PRON")]
            i += 3
        else:
            some = tokens[i + 2]
            out += [*_apart(out, tokens[i].start), some]
            out.append(Token("of", some.end, some.end, "word", tag="ADP"))
            out.append(Token("them", some.end, some.end, "word", tag="PRON"))
            i += 3
    return out


def _told_before(tokens: list[Token], i: int) -> bool:
    """Whether the sentence has a verb already: "three men, one of whom waves, walk" has none."""
    for k in range(i - 1, -1, -1):
        if tokens[k].low in _STOPS:
            return False
        if tokens[k].tag in _FINITE or any(
            r.form in ("s", "past", "base") for r in verb_readings(tokens[k].low)
        ):
            return True
    return False


def _of_which(tokens: list[Token], i: int) -> bool:
    after = [t.low for t in tokens[i : i + 2]]
    return after in (["of", "which"], ["of", "whom"])


def _how_many(tokens: list[Token], i: int) -> bool:
    if i >= len(tokens) or tokens[i].kind not in ("word", "number") or tokens[i].low == "one":
        return False  # "one of which falls" is a row of `rewrites.csv`
    return tokens[i].low in _SHARES or parse_number(tokens[i].low) is not None


def _apart(before: list[Token], at: int) -> list[Token]:
    """A comma, where none parts the clause from its noun."""
    return [] if before and before[-1].kind == "punct" else [Token(",", at, at, "punct")]


def _after_noun(tokens: list[Token], i: int) -> bool:
    """Whether token i follows a noun with an article ("a red ball", "the box")."""
    if i < 2 or tokens[i - 1].tag not in _NOUNS or tokens[i - 1].kind != "word":
        return False
    before = (tokens[k] for k in range(i - 2, max(-1, i - 5), -1))
    first = next((t for t in before if t.tag != "ADJ"), None)
    return first is not None and first.low in lex.DETERMINERS


def _verb_of(tokens: list[Token], i: int) -> int:
    """The verb in the past whose subject begins at token i; -1 if there is none."""
    k = i + 1
    if tokens[i].low in lex.DETERMINERS and tokens[i].low not in _WHO:
        while k < len(tokens) and k <= i + _MOST and tokens[k].tag in (*_NOUNS, "ADJ"):
            k += 1
        if k == i + 1 or tokens[k - 1].tag not in _NOUNS:
            return -1
    elif tokens[i].low not in _WHO:
        return -1
    while k < len(tokens) and tokens[k].low in _BEFORE_THE_VERB:
        k += 1
    if k >= len(tokens) or tokens[k].tag != "VERB":
        return -1
    readings = [r for r in verb_readings(tokens[k].low) if r.form in ("past", "pp")]
    done = any(r.form == "past" and r.sense in _DONE_TO for r in readings)
    return k if done or (readings and tokens[k].low in _MADE) else -1


def _bare(tokens: list[Token], verb: int, sub: bool) -> bool:
    """Whether no object follows a verb: another verb does, or, in a main clause, its end.

    Args:
        sub: Whether the sentence opens with a clause or a place ("When the ball hit the box").
    """
    after = tokens[verb + 1] if verb + 1 < len(tokens) else None
    if after is None or after.low in _STOPS or after.low == "," or after.low in lex.PREPOSITIONS:
        return not sub
    small = lex.PREPOSITIONS | lex.ADVERBS | lex.DETERMINERS | lex.PRONOUNS
    finite = any(r.form in ("s", "past") for r in verb_readings(after.low))
    return (finite and after.low not in small) or after.low in ("is", "was", "has", "had")
