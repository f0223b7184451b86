"""What a model's timeline cannot keep is dropped, mildest first, and named."""

from __future__ import annotations

import json
from typing import Any

import pytest

from esg.draft import draft
from esg.draft.llm_prune import pruned
from esg.graph import canonical_json, verify

CHAIN = "A car hits a trashbin, knocking the trashbin into a picnic table."


@pytest.fixture
def raw() -> dict[str, Any]:
    return json.loads(canonical_json(draft(CHAIN)))


def graph(raw: dict[str, Any]) -> dict[str, Any]:
    return raw["timeline_system"]["sequence_graph"]


def events(raw: dict[str, Any]) -> list[str]:
    return [n["event"] for n in graph(raw)["nodes"]]


def test_a_sound_document_stays(raw: dict[str, Any]) -> None:
    assert pruned(raw) == (raw, ())


def test_a_time_out_of_range_is_left_open(raw: dict[str, Any]) -> None:
    graph(raw)["nodes"][1].update(timestamp=4000.0, window=None, time_is_prescribed=True)
    found, log = pruned(raw)
    assert not verify(found)
    assert events(found) == events(raw)
    assert any("left open" in line for line in log)
    assert graph(raw)["nodes"][1]["timestamp"] == 4000.0


def test_times_in_the_wrong_order_are_opened_along_the_path(raw: dict[str, Any]) -> None:
    first, second = graph(raw)["nodes"][1:]
    first["window"], second["window"] = [5.0, 6.0], [1.0, 2.0]
    found, log = pruned(raw)
    assert not verify(found)
    a, b = (n["window"] for n in graph(found)["nodes"][1:])
    assert a == [5.0, 6.0] and b[0] >= 6.0 and len(log) == 1


def test_a_segment_that_leads_nowhere_goes_and_with_it_what_it_led_to(raw: dict[str, Any]) -> None:
    graph(raw)["edges"][1]["to"] = "never"
    found, log = pruned(raw)
    assert not verify(found)
    assert events(found) == ["SceneStart", "Collision"]
    assert len(log) == 2 and all("dropped" in line for line in log)


def test_a_constraint_goes_before_its_event(raw: dict[str, Any]) -> None:
    graph(raw)["nodes"][1]["constraints"] = [
        {"quantity": "speed_after", "object": "nobody", "value": 100.0, "since": None}
    ]
    found, log = pruned(raw)
    assert events(found) == events(raw)
    assert log == ("constraint speed_after of 'nobody' dropped",)


def test_nothing_is_left_of_a_timeline_without_sound_events(raw: dict[str, Any]) -> None:
    for edge in graph(raw)["edges"]:
        edge["to"] = "never"
    assert pruned(raw) == (raw, ())


def test_other_parts_of_a_document_are_never_pruned(raw: dict[str, Any]) -> None:
    node = next(iter(raw["asset_requirement"]))
    raw["asset_requirement"][node]["expected_mass_kg"] = -1.0
    graph(raw)["nodes"][1].update(timestamp=4000.0, window=None)
    assert pruned(raw) == (raw, ())
