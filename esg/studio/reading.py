"""What a prompt is read as while it is typed."""

from __future__ import annotations

from dataclasses import asdict
import json
import threading
from typing import Any

_one = threading.Lock()
"""The first draft loads the language model: the others wait instead of loading it as well."""


def read(prompt: str, seed: int) -> dict[str, Any]:
    """A prompt as the drafter reads it, for the page.

    Args:
        prompt: As `esg.api.inputs.clean_prompt` gives it.
        seed: Of the draft.

    Returns:
        Pieces of the prompt with what became of each, objects, events, warnings, what is not kept,
        violations, knobs and the document as text.
    """
    from esg.draft import draft
    from esg.fidelity import shortfalls, statement_rows
    from esg.graph import verify
    from esg.report.words import pieces
    from esg.studio.knobs import knobs

    with _one:
        doc = draft(prompt, seed=seed)
    data = doc.model_dump(mode="json", by_alias=True, exclude_none=True)
    rows = statement_rows(data)
    timeline = doc.timeline_system
    return {
        "pieces": pieces(prompt, data, rows),
        "objects": [n.label or name for name, n in doc.spatial_relation_graph.nodes.items()
                    if not n.is_structural],
        "events": [n.description for n in timeline.sequence_graph.nodes if n.participants]
        if timeline else [],
        "warnings": list(doc.coverage.warnings),
        "lost": shortfalls(data, rows),
        "violations": [v.to_json() for v in verify(doc)],
        "knobs": [asdict(k) for k in knobs(doc)],
        "document": json.dumps(data, indent=1, ensure_ascii=False),
    }  # fmt: skip
