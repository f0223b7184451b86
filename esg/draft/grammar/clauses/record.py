"""Elements on their way to clauses."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Element, Mention, Verb
from esg.draft.text.quantities import Amount


@dataclass
class Clauses:
    """The clauses read so far, and what stands outside of any."""

    elements: list[Element]
    frames: list[Frame] = field(default_factory=list[Frame])
    mentions: list[Mention] = field(default_factory=list[Mention])
    attachments: list[tuple[Mention, Phrase]] = field(default_factory=list[tuple[Mention, Phrase]])
    """Noun phrase + prepositional phrase outside any verb ("a table with bottles on it")."""
    loose: list[tuple[int, Amount]] = field(default_factory=list[tuple[int, Amount]])
    sentence: int = 0
    nominal: list[Verb] = field(default_factory=list[Verb])
    """Gerunds that name a time span or a means."""
    told: set[int] = field(default_factory=set[int])
    """Quantities that a property beside its noun has taken."""
    quantified: Mention | None = None
    """Noun that the last quantity was a property of."""
