"""A document's statements in the terms of a suite: exact references, base units."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from esg.graph.models import EsgDocument, Predicate, Statement
from esg.metrics.models import OF_EVENTS, SuiteStatement
from esg.units import m_from_cm

_SPEEDS = frozenset({Predicate.SLOWER_THAN, Predicate.FASTER_THAN})
_IN_CM = frozenset({"speed", "deceleration", "distance", "height", "length", "width"})


@dataclass(frozen=True)
class Moments:
    """What stands for a point event of the timeline where the judge needs a time.

    Args:
        begins: By its id, the measured event from whose time on something holds, or "start".
        ends: By its id, the measured event until whose time it holds, or "end".
    """

    begins: Mapping[str, str]
    ends: Mapping[str, str]

    def of(self, when: str) -> str:
        """A statement's `when` in terms of measured events; unknown names stay as they are."""
        first, dots, last = when.partition("..")
        begin = self.begins.get(first, first)
        return begin + dots + self.ends.get(last, last) if dots else begin


def expected_statements(doc: EsgDocument, moments: Moments) -> tuple[SuiteStatement, ...]:
    """All statements of a document, those that it cannot represent included.

    Args:
        doc: A document.
        moments: What stands for the point events of its timeline.
    """
    return tuple(_statement(s, moments) for s in doc.statements or ())


def _statement(s: Statement, moments: Moments) -> SuiteStatement:
    value, span = _si(s)
    same_size = s.predicate is Predicate.SIZE and bool(s.target)
    participants = {
        "object": _ref(s.object),
        "target": None if same_size else _ref(s.target),
        "alike": _ref(s.target) if same_size else None,
    }
    if s.predicate in OF_EVENTS:
        participants = dict(zip("ab", (moments.of(e) for e in s.object), strict=False))
    return SuiteStatement.model_validate(
        {
            **participants,
            "id": s.id,
            "says": s.predicate,
            "words": s.text,
            "direction": s.direction,
            "side": s.side,
            "filming": s.filming,
            "quantity": s.quantity,
            "value": value,
            "range": span,
            "noun": s.noun,
            "when": moments.of(s.when),
            "note": s.note,
        }
    )


def _ref(names: Iterable[str]) -> str | None:
    text = ",".join(names)
    return f"={text}" if text else None


def _si(s: Statement) -> tuple[float | None, tuple[float, float] | None]:
    """A statement's value, or its range, in base units."""
    quantity = s.quantity or ("speed" if s.predicate in _SPEEDS else "")
    in_cm = quantity in _IN_CM or s.predicate in (Predicate.ABOVE, Predicate.CLIMBS)
    if isinstance(s.value, tuple):
        low, high = s.value
        return None, (m_from_cm(low), m_from_cm(high)) if in_cm else (low, high)
    if s.value is None or not in_cm:
        return s.value, None
    return m_from_cm(s.value), None
