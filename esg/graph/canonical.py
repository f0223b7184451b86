"""Canonical JSON and content hash: one document, one byte string."""

from __future__ import annotations

import enum
import hashlib
import json
from typing import Any

from esg.graph.models import EsgDocument
from esg.untyped import is_array, is_object

_EXACT = 2.0**53
"""Whole numbers below this are the same as int and as float."""


def plain(value: Any) -> Any:
    """Plain JSON of dumped values in which equal numbers read alike.

    Whole numbers are written without a fraction (as in RFC 8785): 10 and 10.0, 0 and -0.0 are equal
    in a document, so they must be equal in its hash.
    """
    if isinstance(value, enum.Enum):
        return value.value
    if isinstance(value, float):
        return int(value) if abs(value) < _EXACT and value.is_integer() else float(value)
    if is_object(value):
        return {str(k): plain(v) for k, v in value.items()}
    if is_array(value):
        return [plain(v) for v in value]
    return value


def canonical_json(doc: EsgDocument, *, indent: int | None = None) -> bytes:
    """UTF-8 JSON of a document with sorted keys and the shortest text that restores each number.

    Absent optional fields (None) are left out, so that a field added later with None as its default
    changes no old hash. Equal documents give equal bytes on every machine.

    Args:
        doc: The document.
        indent: None for the compact form that is hashed; a number for files that people read.

    Raises:
        ValueError: If a free-form part (a control program, a stage's configuration) holds NaN or
            infinity.
    """
    tree = plain(doc.model_dump(by_alias=True, exclude_none=True))
    separators = (",", ":") if indent is None else (",", ": ")
    text = json.dumps(
        tree,
        sort_keys=True,
        ensure_ascii=False,
        allow_nan=False,
        separators=separators,
        indent=indent,
    )
    return text.encode("utf-8")


def document_hash(doc: EsgDocument) -> str:
    """SHA-256 of the canonical JSON, as 64 hexadecimal digits."""
    return hashlib.sha256(canonical_json(doc)).hexdigest()
