"""The manifest: round trip, canonical bytes, schema, and every mistake reported at once."""

from __future__ import annotations

import json
import math
from pathlib import Path

import jsonschema
import pytest

from esg.engines.manifest import (
    load_manifest,
    manifest_bytes,
    manifest_from_json,
    manifest_to_json,
)
from esg.engines.manifest_model import manifest_schema
from esg.engines.program import HoldVelocity, Program
from esg.engines.scene import Region, SimScene
from esg.outcomes import UserError
from tests.engines.lab import PROGRAM, SCENE

SCHEMA = Path(__file__).parents[2] / "schemas" / "manifest.schema.json"
LAB = SimScene(
    "lab", SCENE.bodies, (Region("pit/hole", "pit", (0, 0, 0), (0.1, 0.1, 0.1), "hole"),)
)
WATCH = (("elastic 1", "elastic 2"), ("turner", "ground"))


def lab_json():
    return manifest_to_json(LAB, PROGRAM, watch=WATCH, dt=1 / 240, extra={"seed": 3})


def test_round_trip_keeps_everything():
    manifest = manifest_from_json(json.loads(manifest_bytes(lab_json())))
    assert manifest.scene == LAB
    assert manifest.program == PROGRAM
    assert manifest.watch == WATCH
    assert manifest.dt == 1 / 240
    assert manifest.extra == {"seed": 3}


def test_infinite_numbers_of_a_hold_survive():
    hold = HoldVelocity("drop", 0.0, math.inf, 1.0, 0.0, max_speed=math.inf)
    program = Program((hold,), 1.0)
    data = manifest_to_json(LAB, program, dt=0.01)
    assert manifest_from_json(json.loads(manifest_bytes(data))).program == program


def test_bytes_are_canonical():
    again = manifest_from_json(lab_json())
    data = manifest_to_json(
        again.scene, again.program, watch=again.watch, dt=again.dt, extra=again.extra
    )
    assert manifest_bytes(data) == manifest_bytes(lab_json())
    assert manifest_bytes(dict(reversed(list(data.items())))) == manifest_bytes(data)


def test_schema_file_is_in_sync_and_accepts_a_manifest():
    schema = json.loads(SCHEMA.read_text())
    assert schema == json.loads(json.dumps(manifest_schema()))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(lab_json(), schema)


def test_effective_pairs_are_the_average_and_use_the_right_ground():
    pairs = {(p["a"], p["b"]): p for p in lab_json()["effective_pairs"]}
    assert pairs["slide", "ground"]["friction"] == pytest.approx(0.5 * (0.3 + LAB.ground_friction))
    assert pairs["turner", "ground"]["friction"] == 0.0
    assert pairs["elastic 1", "elastic 2"]["restitution"] == 1.0
    assert ("wall", "ground") not in pairs


def test_every_mistake_is_reported_with_its_pointer():
    data = json.loads(manifest_bytes(lab_json()))
    data["bodies"][0]["mass"] = -1
    data["bodies"][1]["colour"] = "red"
    data["program"]["primitives"][0]["linear"] = [1, 2]
    with pytest.raises(UserError) as caught:
        manifest_from_json(data)
    message = str(caught.value)
    for pointer in ("/bodies/0/mass", "/bodies/1/colour", "/program/primitives/0"):
        assert pointer in message
    assert caught.value.exit_code == 2


def test_names_must_refer_to_bodies():
    data = json.loads(manifest_bytes(lab_json()))
    data["watch"][0][1] = "nobody"
    data["regions"][0]["parent"] = "none"
    data["program"]["primitives"][0]["body"] = "ghost"
    with pytest.raises(UserError, match=r"(?s)none.*ghost.*nobody"):
        manifest_from_json(data)
    with pytest.raises(ValueError, match="nobody"):
        manifest_to_json(LAB, PROGRAM, watch=[("nobody", "drop")], dt=0.01)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{", "not JSON"),
        ('{"format": "x"}', "/format"),
        ('{"format": "esg-manifest", "version": 9}', "/version"),
        ("[]", "not a valid manifest"),
    ],
)
def test_unreadable_files_are_user_errors(tmp_path, text, message):
    path = tmp_path / "manifest.json"
    path.write_text(text)
    with pytest.raises(UserError, match=message):
        load_manifest(path)


def test_missing_file_is_a_user_error(tmp_path):
    with pytest.raises(UserError, match="cannot read"):
        load_manifest(tmp_path / "none.json")
