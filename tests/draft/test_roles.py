"""Every row of the table of roles, by its example."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.draft.discourse.record import Discourse
from esg.draft.events import interpret
from esg.draft.events.roles import examples, role
from esg.draft.grammar.clauses.frames import Frame


@pytest.mark.parametrize(("name", "sentence", "filler"), examples())
def test_the_example_of_a_role_fills_it(
    name: str, sentence: str, filler: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[str] = []
    read = interpret.read_frame

    def noted(d: Discourse, f: Frame) -> None:
        p = role(f, name)
        told.append(p.mention.head if p is not None and p.mention is not None else "")
        read(d, f)

    monkeypatch.setattr(interpret, "read_frame", noted)
    draft(sentence)
    assert filler in told
