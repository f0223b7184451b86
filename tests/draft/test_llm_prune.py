"""What a model's timeline cannot keep is dropped, mildest first, and named."""

from __future__ import annotations

import json
from typing import Any

import pytest

from esg.draft import draft
from esg.draft.llm.prune import pruned
from esg.draft.llm.scripted import ScriptedModel
from esg.draft.llm.words.coverage import cover
from esg.graph import canonical_json, verify
from esg.outcomes import Outcome
from tests.draft.test_llm import Spoiled, change, run

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


def test_a_model_that_cannot_mend_a_time_still_gives_a_draft() -> None:
    """Spend the rounds first, then drop the time, say so in repairs, coverage and provenance."""

    def late(tree: dict[str, Any]) -> None:
        tree["events"][0].update(earliest_s=4000.0, latest_s=5000.0)

    client = Spoiled("timeline", change(late), times=99)
    result = run(CHAIN, client, max_rounds=2)
    assert result.outcome is Outcome.SOLVED and result.rounds == 2
    assert result.document is not None
    assert any("left open" in text for text in result.repairs)
    assert any("left open" in text for text in result.document.coverage.warnings)
    assert any("left open" in r for r in result.document.provenance[0].config["repairs"])


def test_a_draft_that_keeps_nothing_of_the_prompt_is_refused() -> None:
    """Hold the rules by saying something else, as a very small model does: no draft."""

    def elsewhere(tree: dict[str, Any]) -> None:
        people = tree["events"][0]["participants"][:1]
        stop = {"id": "e1", "event": "Stop", "participants": people}
        tree["events"] = [{**tree["events"][0], **stop, "latest_s": 5000.0}]
        tree["segments"] = [{**tree["segments"][0], "end": "e1", "target": None}]

    result = run(CHAIN, Spoiled("timeline", change(elsewhere), times=99), max_rounds=0)
    assert result.outcome is Outcome.INVALID_DRAFT
    assert "none of the prompt's events" in result.reason
    assert [v.code for v in result.violations] == ["TIME_RANGE"]


def test_other_variants_are_not_pruned() -> None:
    def late(tree: dict[str, Any]) -> None:
        tree["events"][0].update(earliest_s=4000.0, latest_s=5000.0)

    result = run(CHAIN, Spoiled("timeline", change(late), times=99), variant="no_validation")
    assert result.outcome is Outcome.INVALID_DRAFT


def test_the_coverage_of_a_draft_that_holds_all_finds_all() -> None:
    """Find events by their kind, and a thing that is named again."""
    doc = draft(CHAIN)
    coverage = cover(CHAIN, doc)
    assert {i.text for i in coverage.items if i.kind == "event"} == {"hits", "knocking"}
    assert {i.status for i in coverage.items} == {"used"}
    assert not coverage.warnings
    other = cover(CHAIN, draft("A car stops. A trashbin and a picnic table stand there."))
    assert [i.status for i in other.items if i.kind == "event"] == ["not_understood"] * 2


def test_a_model_can_state_the_gap_that_is_left() -> None:
    prompt = "A bus at 15 m/s stops 1 m in front of a barrier."
    result = run(prompt, ScriptedModel(0.0, 0.0))
    assert result.document is not None and result.document.timeline_system is not None
    stop = result.document.timeline_system.sequence_graph.nodes[-1]
    assert [(c.quantity, c.value, c.to) for c in stop.constraints] == [
        ("distance", 100.0, "barrier_1")
    ]
