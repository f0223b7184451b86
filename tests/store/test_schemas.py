"""Committed JSON Schemas are those of the code, and real messages satisfy them."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest

from esg.store.schemas import message_schemas, schema_text
from tests.metrics.test_events import CHAIN
from tests.store.samples import world

SCHEMAS = Path(__file__).parents[2] / "schemas"


@pytest.mark.parametrize("name", ["event.schema.json", "verdict.schema.json"])
def test_committed_schema_is_in_sync(name):
    assert (SCHEMAS / name).read_text() == schema_text(message_schemas()[name])


def test_a_verdict_satisfies_its_schema():
    verdict = world().judge(CHAIN).to_json()
    schema = json.loads((SCHEMAS / "verdict.schema.json").read_text())
    jsonschema.validate(verdict, schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**verdict, "dt_s": "fast"}, schema)
