"""Asides in a clause: participles with an agent, relative clauses without "that", "is seen to".

"The scooter, bumped by a taxi and then by a van, ...", "the tray he was carrying falls", "the gnome
is seen falling": what they say of a noun is marked, so that the main verb is found.
"""

from __future__ import annotations

from esg.draft.elements import Element, Mention, Verb, Word
from esg.draft.gaps import finite, word_at

_DONE_TO = frozenset(
    {"hit", "knock", "topple", "launch", "roll", "slide", "cause", "drop", "tow", "carry", "stop",
     "scatter", "spin", "slow", "miss"}
)  # fmt: skip
_SEEING = frozenset({"see", "show", "film", "watch", "picture", "depict", "capture", "observe"})
_HOLDING = frozenset({"carry", "have", "tow", "follow", "launch", "drop", "hit", "roll", "own"})
_ADVERBS = frozenset({"again", "twice", "then", "hard", "both"})
_AGENTLESS = frozenset({"inch", "whisker", "hair", "accident", "itself", "himself", "herself"})


def set_apart(elements: list[Element]) -> list[Element]:
    """Marks participles with an agent as passives and gives relative clauses their pronoun.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        e = elements[i]
        nxt = elements[i + 1] if i + 1 < len(elements) else None
        if isinstance(e, Verb) and _by_agent(elements, i, out):
            e.form, e.passive = "pp", True
            e.extra = {**e.extra, "agent": "1"}
        elif isinstance(e, Verb) and isinstance(nxt, Mention) and _puts_over(elements, i + 2):
            e.extra = {**e.extra, "over": "1"}
        elif isinstance(e, Verb) and e.lemma in _SEEING and e.passive and isinstance(nxt, Verb):
            if (nxt.form == "ing" and not nxt.auxiliary) or nxt.infinitive:
                nxt.form, nxt.start, nxt.infinitive = "s", e.start, False
                nxt.negated = nxt.negated or e.negated
                i += 1
                continue
        elif isinstance(e, Mention) and _without_that(elements, i, out):
            out.append(e)
            assert nxt is not None
            out.append(Word(nxt.start, nxt.start, "rel", "that"))
            i += 1
            continue
        out.append(e)
        i += 1
    return out


def _by_agent(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "..., bumped by a taxi": a participle, whatever its form could be besides."""
    v = elements[i]
    if not isinstance(v, Verb) or v.auxiliary or v.infinitive or v.passive:
        return False
    if v.form not in ("past", "pp", "base") or v.sense not in _DONE_TO:
        return False
    k = i + 1
    while (small := word_at(elements, k)) is not None and small.low in _ADVERBS:
        k += 1
    by = word_at(elements, k)
    agent = elements[k + 1] if k + 1 < len(elements) else None
    if by is None or by.low != "by" or not isinstance(agent, Mention) or agent.attribute:
        return False
    if agent.head in _AGENTLESS or agent.pronoun in _AGENTLESS:
        return False
    before = out[-1] if out else None
    while isinstance(before, Word) and before.kind == "adv" and len(out) > 1:
        before = out[out.index(before) - 1]
    if before is None or (isinstance(before, Word) and before.low in ".;:!?\n,(-–—"):
        return v.form != "base" or before is None
    told = any(isinstance(x, Verb) and "agent" in x.extra for x in out[-8:])
    return isinstance(before, Word) and before.kind == "conj" and told


def _puts_over(elements: list[Element], i: int) -> bool:
    """ "whacks the lamp over": the particle ends the clause."""
    particle, end = word_at(elements, i), elements[i + 1] if i + 1 < len(elements) else None
    if particle is None or particle.low not in ("over", "down", "flat"):
        return False
    return end is None or (isinstance(end, Word) and end.kind in ("punct", "conj", "sub", "rel"))


def _without_that(elements: list[Element], i: int, out: list[Element]) -> bool:
    """ "the tray he was carrying falls": a clause between a noun and its verb."""
    head, subject = elements[i], elements[i + 1] if i + 1 < len(elements) else None
    verb = elements[i + 2] if i + 2 < len(elements) else None
    if not isinstance(head, Mention) or not isinstance(subject, Mention) or head.pronoun:
        return False
    known = subject.pronoun in ("he", "she", "it", "they", "we", "i", "you")
    if not (known or subject.determiner in ("the", "his", "her", "its")) or head.attribute:
        return False
    if not isinstance(verb, Verb) or verb.infinitive or verb.sense not in _HOLDING:
        return False
    if not (finite(verb) or verb.auxiliary) or verb.passive:
        return False
    k = i + 3
    while (small := word_at(elements, k)) is not None and small.kind == "adv":
        k += 1
    main = elements[k] if k < len(elements) else None
    if isinstance(main, Verb):
        return not main.infinitive and main.form in ("s", "past", "pp")
    closes = word_at(elements, k)
    before = out[-1] if out else None
    inverted = isinstance(before, Verb) and before.sense in ("own", "roll", "slide", "fly", "fall")
    return inverted and closes is not None and closes.low in ",."
