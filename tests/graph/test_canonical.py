"""Canonical JSON and hash: equal documents give equal bytes, different ones do not."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
import subprocess
import sys

from hypothesis import given
from hypothesis import strategies as st
import jsonschema
import pytest

from esg.graph import EsgDocument, canonical_json, document_hash
from esg.graph.schema import SCHEMA_PATH, schema_text
from tests.graph.builders import VALID
from tests.graph.mutations import corruptions


def model(raw: dict) -> EsgDocument:
    return EsgDocument.model_validate_json(json.dumps(raw))


def reverse_keys(value: object) -> object:
    if isinstance(value, dict):
        return {k: reverse_keys(value[k]) for k in reversed(value)}
    if isinstance(value, list):
        return [reverse_keys(v) for v in value]
    return value


@pytest.mark.parametrize("name", VALID)
def test_key_order_does_not_matter(name: str) -> None:
    """Give the same bytes whatever the order of keys in the input."""
    raw = VALID[name]()
    assert canonical_json(model(raw)) == canonical_json(model(reverse_keys(raw)))


@pytest.mark.parametrize("name", VALID)
def test_round_trip(name: str) -> None:
    """Restore an equal document, and again the same bytes, from the canonical JSON."""
    doc = model(VALID[name]())
    data = canonical_json(doc)
    again = EsgDocument.model_validate_json(data)
    assert again == doc
    assert canonical_json(again) == data
    assert json.loads(canonical_json(doc, indent=2)) == json.loads(data)


def test_hash_is_sha256_of_the_canonical_json() -> None:
    """Hash exactly the canonical bytes."""
    doc = model(VALID["chain"]())
    assert document_hash(doc) == hashlib.sha256(canonical_json(doc)).hexdigest()


def test_hash_tells_documents_apart() -> None:
    """Give every changed document its own hash, a change in the last digit included."""
    doc = model(VALID["chain"]())
    hashes = {document_hash(doc)}
    raw = VALID["chain"]()
    raw["asset_requirement"]["sedan"]["expected_mass_kg"] = 1400.0000000000002
    hashes.add(document_hash(model(raw)))
    raw["scene_definition"]["scene_id"] = "chain_2"
    hashes.add(document_hash(model(raw)))
    assert len(hashes) == 3


def test_negative_zero_is_zero() -> None:
    """Give 0.0 and -0.0 the same text, in free-form parts too."""
    texts = set()
    for zero in (0.0, -0.0):
        raw = VALID["finished"]()
        raw["layout_result"]["energy"] = zero
        raw["dynamics_result"]["program"]["primitives"][0]["heading"] = zero
        texts.add(canonical_json(model(raw)))
    assert len(texts) == 1
    assert b"-0" not in texts.pop()


def test_equal_numbers_are_written_alike() -> None:
    """Hash 12 and 12.0 alike, even in a model whose values were replaced without validation."""
    doc = model(VALID["chain"]())
    spec = doc.asset_requirement["bin"]
    hashes = set()
    for mass in (12, 12.0):
        changed = spec.model_copy(update={"expected_mass_kg": mass})
        assets = {**doc.asset_requirement, "bin": changed}
        hashes.add(document_hash(doc.model_copy(update={"asset_requirement": assets})))
    assert hashes == {document_hash(doc)}


def test_absent_optional_fields_leave_no_trace() -> None:
    """Hash a document alike whether an unused optional field is left out or null."""
    raw = VALID["chain"]()
    left_out = document_hash(model(raw))
    raw["layout_result"] = None
    raw["spatial_relation_graph"]["nodes"]["car_1"]["group"] = None
    assert document_hash(model(raw)) == left_out


def test_free_form_null_is_kept() -> None:
    """Keep null inside a control program, where it means an endless hold."""
    tree = json.loads(canonical_json(model(VALID["finished"]())))
    assert tree["dynamics_result"]["program"]["primitives"][0]["end"] is None


def test_not_finite_is_refused() -> None:
    """Refuse NaN in a free-form part rather than write text that is not JSON."""
    doc = model(VALID["finished"]())
    assert doc.dynamics_result is not None
    bad = doc.dynamics_result.model_copy(update={"program": {"x": float("nan")}})
    with pytest.raises(ValueError, match="JSON"):
        canonical_json(doc.model_copy(update={"dynamics_result": bad}))


@given(st.floats(1e-3, 1e5), st.text(max_size=40))
def test_any_number_and_text_survives(mass: float, prompt: str) -> None:
    """Restore every number bit by bit, and every text."""
    raw = VALID["chain"]()
    raw["asset_requirement"]["bin"]["expected_mass_kg"] = mass
    raw["scene_definition"]["original_description"] = prompt
    again = EsgDocument.model_validate_json(canonical_json(model(raw)))
    assert again.asset_requirement["bin"].expected_mass_kg == mass
    assert again.scene_definition.original_description == prompt


def test_hash_does_not_depend_on_the_process() -> None:
    """Give the same hash in a process with another hash seed."""
    code = (
        "import json, sys; from esg.graph import EsgDocument, document_hash;"
        "print(document_hash(EsgDocument.model_validate_json(sys.stdin.read())))"
    )
    raw = json.dumps(VALID["study"]())
    out = [
        subprocess.run(
            [sys.executable, "-c", code],
            input=raw,
            capture_output=True,
            text=True,
            check=True,
            cwd=Path(__file__).parents[2],
            env={"PYTHONHASHSEED": seed},
        ).stdout
        for seed in ("1", "2")
    ]
    assert out[0] == out[1] == document_hash(model(VALID["study"]())) + "\n"


def test_schema_file_is_in_sync() -> None:
    """Keep schemas/esg.schema.json what `python -m esg.graph.schema` writes."""
    assert SCHEMA_PATH.read_text(encoding="utf-8") == schema_text()


def test_json_schema_agrees_with_the_verifier() -> None:
    """Accept valid documents and refuse schema damage by the JSON Schema alone."""
    validator = jsonschema.Draft202012Validator(json.loads(schema_text()))
    for name, build in VALID.items():
        assert validator.is_valid(build()), name
    damaged = [c for c in corruptions() if c.code in ("SCHEMA_MISSING", "SCHEMA_VALUE")]
    assert damaged
    for case in damaged:
        assert not validator.is_valid(case.raw), case.name
