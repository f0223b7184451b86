"""JSON Schemas of what is written beside the tables: MCAP event messages and verdicts.

`python -m esg.store.schemas FOLDER` writes them; a test keeps `schemas/` in sync.
"""

from __future__ import annotations

import json
from pathlib import Path
import sys
from typing import Any


def message_schemas() -> dict[str, dict[str, Any]]:
    """File name to JSON Schema."""
    from esg.metrics.models import SceneVerdict
    from esg.store.mcap_log import EVENT_SCHEMA

    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    verdict = SceneVerdict.model_json_schema(mode="serialization")
    # to_json adds the derived numbers.
    verdict.pop("additionalProperties", None)
    return {
        "event.schema.json": {**draft, **EVENT_SCHEMA},
        "verdict.schema.json": {**draft, **verdict},
    }


def schema_text(schema: dict[str, Any]) -> str:
    """Canonical text of a schema file."""
    return json.dumps(schema, indent=2, sort_keys=True) + "\n"


def main(folder: Path) -> None:
    """Writes all schema files."""
    for name, schema in message_schemas().items():
        (folder / name).write_text(schema_text(schema), encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "schemas"))
