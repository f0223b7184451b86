"""Captions that leave out "is": "a ball pushed across a table by a dog"."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import PARTING, Mention, Verb, Word

DOERS = frozenset({"person", "animal", "vehicle", "robot", "flyer", "cart", "watercraft"})
"""Kinds of things that act."""
_DONE_TO = lex.word_set("senses done to a thing (captions)")
_ALSO_BY_ITSELF = lex.word_set("also by itself (captions)")
"""Verbs of those senses that a thing does by itself, too: "a car crashed"."""
STRUCK = frozenset({"hit", "knock"})
"""Senses of blows."""
_LIVING = frozenset({"person", "animal"})


def done_by_somebody(c: Clauses, subject: Mention, v: Verb, i: int) -> bool:
    """Whether a participle is all that is told of its subject, and "by" names who does it.

    Args:
        c: Where the verb stands.
        subject: What stands before it.
        v: The verb, which no other verb of its clause follows.
        i: Its place among the elements.
    """
    if v.form not in ("pp", "past") or v.auxiliary or v.passive or v.extra.get("agent"):
        return False
    doer = _after_by(c, i)
    if doer is None:
        return False
    kind = doer.noun.kind if doer.noun is not None else ""
    if v.lemma not in _ALSO_BY_ITSELF and v.sense in STRUCK:
        return True  # "a vase hit by a ball"
    if v.form == "pp" or (v.sense in _DONE_TO and v.lemma not in _ALSO_BY_ITSELF):
        return kind in DOERS
    moved = subject.noun is not None and subject.noun.kind not in _LIVING
    return moved and kind in _LIVING and v.lemma in _ALSO_BY_ITSELF


def _after_by(c: Clauses, i: int) -> Mention | None:
    """Who is named after "by" in the clause of a verb that acts on nothing."""
    following = c.elements[i + 1 :]
    if following and isinstance(following[0], Mention) and not following[0].attribute:
        return None
    for k, e in enumerate(following[:-1]):
        if isinstance(e, Verb) or (isinstance(e, Word) and e.kind in PARTING):
            return None
        nxt = following[k + 1]
        if isinstance(e, Word) and e.low == "by" and isinstance(nxt, Mention):
            return None if nxt.attribute or nxt.pronoun == "itself" else nxt
    return None
