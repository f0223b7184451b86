"""What casting chose is kept apart, and applied in one place."""

from __future__ import annotations

import json

from esg.graph import EsgDocument, canonical_json, effective, verify
from esg.graph.models import Choreography
from tests.graph.builders import Json, finished


def cast() -> Json:
    """The finished document with a choice of every kind."""
    raw = finished()
    lighter = {**raw["asset_configurations"]["bin"], "friction": 0.1}
    return {
        **raw,
        "casting": {
            "assets": {
                "bin": {"configuration": lighter, "reasons": ["friction: it slides on ice"]}
            },
            "nodes": {"picnic_table_1": {"is_static": True, "reasons": ["it stays"]}},
            "actors": {"car_1": {"force_direction": "ALONG_FORWARD_ONLY"}},
            "segments": {"car_drive": {"params": {"speed": [400, 500]}}},
        },
    }


def test_a_cast_document_is_valid_and_survives_json() -> None:
    doc = EsgDocument.model_validate(cast())
    assert verify(doc) == ()
    assert EsgDocument.model_validate_json(canonical_json(doc)) == doc


def test_every_choice_takes_the_place_of_what_was_given_and_of_nothing_else() -> None:
    raw = cast()
    doc = EsgDocument.model_validate(raw)
    played = effective(doc)
    choices = raw.pop("casting")
    raw["asset_configurations"]["bin"] = choices["assets"]["bin"]["configuration"]
    raw["spatial_relation_graph"]["nodes"]["picnic_table_1"]["is_static"] = True
    raw["timeline_system"]["actors"]["car_1"]["force_direction"] = "ALONG_FORWARD_ONLY"
    edges = raw["timeline_system"]["sequence_graph"]["edges"]
    next(e for e in edges if e["id"] == "car_drive")["params"] = {"speed": [400, 500]}
    assert played == EsgDocument.model_validate(raw)
    assert played != doc


def test_it_is_applied_once_and_changes_nothing_without_choices() -> None:
    doc = EsgDocument.model_validate(cast())
    assert effective(effective(doc)) is not doc
    assert effective(effective(doc)) == effective(doc)
    plain = EsgDocument.model_validate(finished())
    assert effective(plain) is plain


def test_absent_fields_leave_no_bytes() -> None:
    """Documents without casting keep their hash."""
    written = json.loads(canonical_json(EsgDocument.model_validate(finished())))
    assert not {"casting", "choreography"} & set(written)
    assert "wording" not in written["scene_definition"]
    nodes = written["spatial_relation_graph"]["nodes"].values()
    assert not any("size_is_stated" in n for n in nodes)


def test_a_heading_left_open_stays_open_in_json() -> None:
    """None is no heading of zero, and None is what JSON leaves out."""
    start = {"node": "car_1", "x_cm": 1.0, "y_cm": 2.0}
    told = Choreography.model_validate(
        {"constellations": [{"placements": [start, {**start, "yaw_deg": 0.0}]}]}
    )
    doc = EsgDocument.model_validate(finished()).model_copy(update={"choreography": told})
    again = EsgDocument.model_validate_json(canonical_json(doc))
    assert [p.yaw_deg for p in again.choreography.constellations[0].placements] == [None, 0.0]
