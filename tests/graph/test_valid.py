"""The verifier accepts every valid document, however it is handed over."""

from __future__ import annotations

import json

import pytest

from esg.graph import EsgDocument, verify
from tests.graph.builders import VALID


@pytest.mark.parametrize("name", VALID)
def test_valid_document_has_no_violation(name: str) -> None:
    """Accept a valid document as plain JSON and as a model."""
    raw = VALID[name]()
    assert verify(raw) == ()
    assert verify(EsgDocument.model_validate_json(json.dumps(raw))) == ()
