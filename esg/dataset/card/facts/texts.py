"""Captions and questions."""

from __future__ import annotations

from typing import Any

from esg.dataset.card.facts.tables import Tables, counted, spread


def texts(tables: Tables) -> dict[str, Any]:
    """Length of captions [words], questions by kind, and examples of both."""
    out: dict[str, Any] = {}
    if tables.has("captions"):
        rows = list(tables.rows("captions", ["scene_key", "short", "medium", "long"]))
        kinds = ("short", "medium", "long")
        first = min(rows, key=lambda r: r["scene_key"])
        out["captions"] = {
            "words": {k: spread([len((r[k] or "").split()) for r in rows]) for k in kinds},
            "example": {k: first[k] for k in kinds},
        }
    if tables.has("questions"):
        rows = list(tables.rows("questions", ["scene_key", "kind", "question", "answer"]))
        examples: dict[str, dict[str, str]] = {}
        for row in sorted(rows, key=lambda r: (r["scene_key"], r["question"])):
            told = {k: row[k] for k in ("question", "answer")}
            examples.setdefault(row["kind"], told)
        out["questions"] = {
            "kinds": counted(r["kind"] for r in rows),
            "examples": dict(sorted(examples.items())),
        }
    return out
