"""Propositions: the clauses that were read, with what they move and what they state of it."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.graph.models import Direction, Predicate


@dataclass(frozen=True)
class Row:
    """A row of the table: `part` is adverb, side ("to the left"), phrase, goal or verb."""

    part: str
    words: frozenset[str]
    states: Predicate
    direction: Direction | None
    pace: str
    example: str


@dataclass(frozen=True)
class Said:
    """One thing that a clause states.

    Args:
        row: What is stated.
        start, end: The words, in the text that is read.
        phrase: Of a direction that has a target.
    """

    row: Row
    start: int
    end: int
    phrase: Phrase | None = None


@dataclass
class Clause:
    """A clause that has been read.

    Args:
        frame: Its words.
        movers: What moves as it says (node ids).
        since: By mover, the event that its motion starts from.
        said: What its words state of the motion.
        told: Whether it added anything to the scene.
    """

    frame: Frame
    movers: list[str]
    since: dict[str, str]
    said: list[Said] = field(default_factory=list[Said])
    told: bool = True
