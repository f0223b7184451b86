"""A verb of a new sense is a row and a function, both from outside the reader."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from esg.draft import draft
from esg.draft import lexicon as lex
from esg.draft.discourse.record import Discourse
from esg.draft.events.acts import add_event
from esg.draft.events.table import SENSES, sense
from esg.draft.grammar.clauses.frames import Frame
from esg.draft.verbphrases import verb_readings
from esg.graph import verify
from esg.graph.models import NodeEvent


@pytest.fixture
def flumps(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """The verb "flump": what flumps tips over."""

    def read_flump(d: Discourse, f: Frame, subjects: list[str], objects: list[str]) -> None:
        for node in subjects:
            add_event(d, NodeEvent.TOPPLE, (node,), f, None)

    forms = {"flump": "base", "flumps": "s", "flumped": "past", "flumping": "ing"}
    for word, form in forms.items():
        monkeypatch.setitem(lex.verb_forms(), word, (lex.VerbForm("flump", "flump", form),))
    verb_readings.cache_clear()
    sense("flump")(read_flump)
    yield
    del SENSES["flump"]
    verb_readings.cache_clear()


def test_a_registered_sense_is_read(flumps: None) -> None:
    doc = draft("A car hits a bollard. The bollard flumps.")
    assert doc.timeline_system is not None
    told = [(n.event, n.participants) for n in doc.timeline_system.sequence_graph.nodes[1:]]
    assert told == [
        (NodeEvent.COLLISION, ("car_1", "bollard_1")),
        (NodeEvent.TOPPLE, ("bollard_1",)),
    ]
    assert not verify(doc)


def test_a_sense_has_one_reader(flumps: None) -> None:
    with pytest.raises(ValueError, match="flump"):
        sense("flump")(SENSES["hit"])


def test_an_unregistered_verb_is_told_as_not_understood() -> None:
    doc = draft("A car hits a bollard. The bollard flumps.")
    said = [i for i in doc.coverage.items if "flumps" in i.text]
    assert all(i.status != "used" for i in said)
