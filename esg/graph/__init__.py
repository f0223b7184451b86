"""The ESG document: models, verifier, canonical JSON and hash, JSON Schema."""

from __future__ import annotations

from esg.graph.canonical import canonical_json, document_hash
from esg.graph.casting import effective
from esg.graph.files import CheckReport, check_file, check_text, load_document
from esg.graph.models import EsgDocument
from esg.graph.verifier import verify
from esg.graph.violations import RULES, Violation

__all__ = [
    "RULES",
    "CheckReport",
    "EsgDocument",
    "Violation",
    "canonical_json",
    "check_file",
    "check_text",
    "document_hash",
    "effective",
    "load_document",
    "verify",
]
