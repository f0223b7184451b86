"""Relative clauses without their word: "a ball someone threw" is "a ball that someone threw"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.text.elements import Token
from esg.draft.verbphrases import verb_readings

_WHO = frozenset({"he", "she", "they", "i", "we", "you", "someone", "somebody"})
"""Subjects that need no article."""
_DONE_TO = frozenset({"launch", "drop", "hit", "carry", "knock", "tow"})
"""Senses of verbs whose object may stand before them."""
_MADE = lex.word_set("made (relatives)")
_BEFORE_THE_VERB = frozenset({"just", "already", "only", "had", "has", "have", "once"})
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
