"""What is written down as statements, and words of the text that they need."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from esg.draft.discourse.record import Discourse
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.text.elements import Element, Token
from esg.graph.models import Predicate, Statement


@dataclass
class Book:
    """The statements so far."""

    d: Discourse
    items: list[Statement] = field(default_factory=list[Statement])

    def add(self, says: Predicate, start: int, end: int, **more: Any) -> None:
        """Writes down a statement whose words stand in the text from start to end."""
        words = (self.d.scene.fillings.told or self.d.text)[start:end]
        told = Statement(
            id=f"s{len(self.items) + 1}", predicate=says, text=words, start=start, end=end, **more
        )
        lost = says is Predicate.NOT_REPRESENTED  # each word of its own
        same = ("id",) if lost else ("id", "text", "start", "end")
        if all(
            told.model_dump(exclude={*same}) != x.model_dump(exclude={*same}) for x in self.items
        ):
            self.items.append(told)
        if not lost:
            self.d.scene.used.setdefault((start, end), f"statement: {says.value}")


@dataclass(frozen=True)
class Told:
    """What is read of a prompt, and the statements to which it is added."""

    d: Discourse
    book: Book
    frames: list[Frame]
    """All clauses."""
    elements: list[Element]
    """What the text was read as."""
    tokens: list[Token]
    """Its words."""


def span(f: Frame) -> tuple[int, int]:
    """Where the verb of a clause stands in the text."""
    return (f.verb.start, f.verb.end)


def ids(m: object) -> list[str]:
    """The nodes that a mention means; none of what is no mention."""
    return list(getattr(m, "entities", ()))


def word_end(text: str, start: int) -> int:
    """Where the word ends that starts there, one character on at least."""
    end = start
    while end < len(text) and (text[end].isalnum() or text[end] in "'’"):
        end += 1
    return max(end, start + 1)
