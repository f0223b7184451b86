"""What a prompt is read as, and the numbers in it that can be turned."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
import json
import time

import pytest

from esg.draft import draft
from esg.graph import EsgDocument, check_text, verify
from esg.studio.knobs import knobs, turned
from esg.studio.reading import read

PROMPT = "A red car at 10 m/s hits a bin and splashes loudly through paint."


def test_every_word_has_its_fate() -> None:
    told = read(PROMPT, 0)
    assert "".join(p["text"] for p in told["pieces"]) == PROMPT
    fates = {p["text"].strip(): p["fate"] for p in told["pieces"] if p["fate"]}
    assert fates["10 m/s"] == "used"
    assert {"not_represented", "not_understood"} & set(fates.values())
    assert told["lost"] and "red car" in told["objects"]
    assert check_text(told["document"]).ok


@pytest.mark.parametrize(
    "prompt",
    [
        PROMPT,
        "A ball rolls off a table.",
        "A vase stands on a shelf.",
        "A car brakes and stops.",
        "A lamp stands left of a sofa.",
        "A car stops 2 m in front of a gate.",
    ],
)
def test_turned_numbers_are_stated_and_the_document_holds(prompt: str) -> None:
    doc = draft(prompt, seed=0)
    found = knobs(doc)
    assert len({k.id for k in found}) == len(found)
    assert all(k.low < k.value < k.high for k in found)
    chosen = {k.id: 0.5 * (k.low + k.value) for k in found}
    after = turned(doc, chosen)
    assert [v for v in verify(after) if v.code.startswith("SCHEMA")] == []
    again = EsgDocument.model_validate(json.loads(after.model_dump_json(by_alias=True)))
    for knob in knobs(again):
        assert knob.stated, knob.id
        assert knob.value == pytest.approx(chosen[knob.id])
    assert turned(doc, {}) == doc == turned(doc, {"speed/nothing": 1.0})


def test_places_are_distances_of_relations_and_of_ends() -> None:
    doc = draft("A lamp stands left of a sofa. A car stops 2 m in front of a gate.", seed=0)
    found = {k.label: k for k in knobs(doc)}
    gap = found["distance: lamp left of sofa"]
    assert not gap.stated
    (end,) = (k for label, k in found.items() if label.startswith("distance of car"))
    assert end.stated and end.value == pytest.approx(2.0)
    after = turned(doc, {gap.id: 1.5, end.id: 3.0})
    relations = after.spatial_relation_graph.edges.binary_relations
    assert [r.distance_cm for r in relations if r.distance_cm is not None] == [150.0]
    assert after.timeline_system is not None
    nodes = after.timeline_system.sequence_graph.nodes
    assert [c.value for n in nodes for c in n.constraints] == [300.0]
    assert verify(after) == verify(doc)


def test_of_readers_that_come_at_once_one_drafts(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first draft loads the language model; ten at once would load it ten times."""
    at_once, most = [0], [0]

    def slow(prompt: str, seed: int) -> EsgDocument:
        at_once[0] += 1
        most[0] = max(most[0], at_once[0])
        time.sleep(0.02)
        at_once[0] -= 1
        return drafted

    drafted = draft("A ball rolls.", seed=0)
    monkeypatch.setattr("esg.draft.draft", slow)
    with ThreadPoolExecutor(5) as threads:
        found = list(threads.map(lambda _: read("A ball rolls.", 0), range(5)))
    assert len(found) == 5 and most == [1]
