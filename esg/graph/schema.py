"""JSON Schema of the ESG document: `python -m esg.graph.schema` writes schemas/esg.schema.json."""

from __future__ import annotations

import json
from pathlib import Path
import sys
from typing import Any

from esg.graph.models import SCHEMA_VERSION, EsgDocument

SCHEMA_PATH = Path(__file__).resolve().parents[2] / "schemas" / "esg.schema.json"


def document_schema() -> dict[str, Any]:
    """JSON Schema (2020-12) that a document's JSON fulfils."""
    schema = EsgDocument.model_json_schema(by_alias=True, mode="validation")
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": f"urn:esg:schema:{SCHEMA_VERSION}",
        **schema,
        "title": "Evolutive Scene Graph",
    }


def schema_text() -> str:
    """The schema as it is written: sorted keys, two spaces, a final newline."""
    return json.dumps(document_schema(), indent=2, sort_keys=True, ensure_ascii=False) + "\n"


def main() -> int:
    """Writes the schema to schemas/esg.schema.json, or to the path given."""
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else SCHEMA_PATH
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(schema_text(), encoding="utf-8")
    print(path, file=sys.stderr)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
