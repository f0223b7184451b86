"""Rows of constructions and of argument frames: every example is read as its row says."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.grammar.clauses import idioms
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.grammar.rewrites import patterns
from esg.draft.grammar.rewrites.patterns import Row, Spans
from esg.draft.text.elements import Element

CONSTRUCTIONS = [row for rows in patterns.table().values() for row in rows]


def events(prompt: str) -> list[tuple[str, tuple[str, ...]]]:
    """What happens, and to what."""
    timeline = draft(prompt).timeline_system
    nodes = timeline.sequence_graph.nodes if timeline is not None else ()
    return sorted((n.event.value, tuple(n.participants)) for n in nodes)


@pytest.mark.parametrize("row", CONSTRUCTIONS, ids=[row.example for row in CONSTRUCTIONS])
def test_a_construction_tells_what_plain_words_tell(
    row: Row, monkeypatch: pytest.MonkeyPatch
) -> None:
    matched: list[Row] = []

    def match(tried: Row, elements: list[Element], i: int, out: list[Element]) -> Spans | None:
        spans = original(tried, elements, i, out)
        if spans is not None:
            matched.append(tried)
        return spans

    original = patterns.match
    monkeypatch.setattr(patterns, "match", match)
    told = events(row.example)
    assert row in matched
    assert told == events(row.plain)


@pytest.mark.parametrize("row", idioms.rows(), ids=[row.name for row in idioms.rows()])
def test_an_argument_frame_fits_its_example(
    row: idioms.FrameRow, monkeypatch: pytest.MonkeyPatch
) -> None:
    fitting: list[str] = []

    def row_of(frame: Frame) -> idioms.FrameRow | None:
        found = original(frame)
        fitting.append(found.name if found is not None else "")
        return found

    original = idioms.row_of
    monkeypatch.setattr(idioms, "row_of", row_of)
    draft(row.example)
    assert row.name in fitting
