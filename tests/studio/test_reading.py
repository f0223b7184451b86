"""What a prompt is read as, and the numbers in it that can be turned."""

from __future__ import annotations

import json

import pytest

from esg.draft import draft
from esg.graph import EsgDocument, check_text, verify
from esg.studio.reading import knobs, read, turned

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
    [PROMPT, "A ball rolls off a table.", "A vase stands on a shelf.", "A car brakes and stops."],
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
