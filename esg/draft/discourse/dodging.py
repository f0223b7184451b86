"""Who gets out of the way of what comes at him: the clause that aimed at him is a near miss."""

from __future__ import annotations

import re

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame, Phrase

_DODGING = lex.word_set("dodging")
_STEPPING = lex.word_set("stepping (dodging)")
_ASIDE = re.compile(
    r"\s*(?:\w+ly\s+)?(?:just\s+)?(?:aside|out of (?:the|its|his|her|their) (?:way|path))\b",
    re.IGNORECASE,
)
_AIMED = lex.word_set("aimed (dodging)")
_COMING = lex.word_set("coming")


def dodge(frames: list[Frame], text: str) -> None:
    """Lets what was aimed at something that gets out of the way go past it.

    Args:
        frames: Frames with their entities, in order of time; the aiming ones are rewritten.
        text: The prompt.
    """
    for k, g in enumerate(frames):
        who = set(g.subject.entities) if g.subject is not None else set[str]()
        aside = g.verb.lemma in _DODGING or (
            g.verb.lemma in _STEPPING and _ASIDE.match(text, g.verb.end) is not None
        )
        asserted = not (g.verb.negated or g.unreal or "tried" in g.verb.extra or g.verb.infinitive)
        if len(who) != 1 or not aside or g.object is not None or not asserted:
            continue
        for f in reversed(frames[:k]):
            p = _aim(f, who)
            if f.sentence < g.sentence - 1:
                break
            if p is None or f.verb.passive or f.unreal:
                continue
            p.prep = "past"
            break


def _aim(f: Frame, who: set[str]) -> Phrase | None:
    """The phrase of a clause that says what it is aimed at."""
    if f.verb.sense not in _COMING:
        return None
    for p in f.phrases:
        if p.prep in _AIMED and p.mention is not None and set(p.mention.entities) == who:
            return p
    return None
