"""Questions beside a description: what they ask does not happen because it is asked."""

from __future__ import annotations

from dataclasses import dataclass
import re

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.clauses.record import Clauses
from esg.draft.text.elements import Mention

ASKED = "a question"
_SENTENCE = re.compile(r"[^.;!?\n]*[.;!?\n]?")
_WH = re.compile(r"\s*(?:which|what|whose|how\s+(?:many|much))\s+(?!of\b)", re.IGNORECASE)
_OPENS_WHEN = lex.word_set("opens a case (questions)")


@dataclass(frozen=True)
class Question:
    """A sentence that asks.

    Args:
        start, end: Its place in the text.
        answered: Whether what is told besides has an act that it asks for.
    """

    start: int
    end: int
    answered: bool


def ask(clauses: Clauses, text: str) -> list[Question]:
    """Takes what is only asked for no event and no thing; none where nothing else is told.

    "Can a ball hit a box?" alone asks for that scene.

    Args:
        clauses: Clauses of the text; `unreal` of their frames and `attribute` of their noun
            phrases are set.
        text: The prompt.

    Returns:
        The questions, in the order of the text.
    """
    spans = [m.span() for m in _SENTENCE.finditer(text) if m[0].rstrip().endswith("?")]
    told = [f for f in clauses.frames if not _within(f.verb.start, spans)]
    if not any(f.verb.sense != "be" for f in told):
        return []
    out: list[Question] = []
    for start, end in spans:
        own = [f for f in clauses.frames if start <= f.verb.start < end]
        what_if = any(f.verb.lemma in _HAPPENS for f in own)
        asked = [f for f in own if not (what_if and f.subordinate in _OPENS_WHEN)]
        for f in asked:
            f.unreal = f.unreal or ASKED
        if len(asked) == len(own):
            _things(clauses, text, (start, end))
        begin = start + len(text[start:end]) - len(text[start:end].lstrip())
        out.append(Question(begin, end, _answered(asked, told)))
    return out


_ANSWERS = (
    frozenset({"hit", "miss", "pass", "knock", "bounce", "avoid"}),
    frozenset({"fall", "topple", "drop", "knock"}),
    frozenset({"stop", "brake"}),
    frozenset({"reach", "hit", "enter"}),
)
"""Senses of verbs of which one answers what is asked with another."""
_HAPPENS = frozenset({"happen", "occur"})


def _within(at: int, spans: list[tuple[int, int]]) -> bool:
    return any(start <= at < end for start, end in spans)


def _answered(asked: list[Frame], told: list[Frame]) -> bool:
    """Whether an act is told that the question asks for; "What happens?" asks for any."""
    acts = {f.verb.lemma for f in asked if f.verb.sense not in ("be", "have")} - _HAPPENS
    if not asked:
        return False
    alike = {f.verb.sense for f in asked if f.verb.sense not in ("be", "noop", "unknown")}
    does = {f.verb.sense for f in told}
    does |= {"hit" for f in told if f.phrase("into", "against")}  # "slides into a ball"
    answers = {sense for group in _ANSWERS if alike & group for sense in group}
    return acts <= {f.verb.lemma for f in told} or bool((alike | answers) & does)


def _things(clauses: Clauses, text: str, span: tuple[int, int]) -> None:
    """ "Which ball", and "the ball" of which "a ball" is told: no things of their own."""
    own = [m for m in clauses.mentions if span[0] <= m.start < span[1]]
    wh = _WH.match(text, *span)
    rest = [m for m in clauses.mentions if not span[0] <= m.start < span[1] and not m.pronoun]
    for m in own:
        asked_for = wh is not None and m.start <= wh.end() < m.end
        asked_for = asked_for or (wh is not None and m.start == wh.end())
        if asked_for or (m.determiner == "the" and any(_tells_of(x, m) for x in rest)):
            m.attribute = True


def _tells_of(x: Mention, m: Mention) -> bool:
    """Whether a noun phrase outside brings in what a question calls "the ball"."""
    new = x.determiner not in ("the", "this", "that", "its", "his", "her", "their")
    same = m.head in (x.head, x.group_word) or (m.noun is not None and m.noun == x.noun)
    return bool(m.head) and new and same and {*m.adjectives} <= {*x.adjectives}
