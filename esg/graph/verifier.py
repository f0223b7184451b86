"""The verifier: every rule on one document, all violations at once.

Source: the paper's stage 1 ("a rule-based verifier checks schema validity, entity references,
relation compatibility, and event ordering") and the self-checks of its three system prompts.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from esg.graph import (
    rules_breaking,
    rules_casting,
    rules_dressing,
    rules_events,
    rules_joints,
    rules_relations,
    rules_scene,
    rules_segments,
    rules_stages,
    rules_statements,
    rules_timeline,
)
from esg.graph.canonical import plain
from esg.graph.context import Context
from esg.graph.models import EsgDocument
from esg.graph.parsing import parse
from esg.graph.violations import Findings, Violation


def verify(doc: EsgDocument | Mapping[str, Any]) -> tuple[Violation, ...]:
    """Checks a document, or plain JSON that should be one, against every rule.

    A broken part does not hide the violations of others: what does not fit the schema is reported,
    left out, and the remainder is checked.

    Args:
        doc: A document, or the plain JSON of one.

    Returns:
        All violations, schema first; empty for a valid document.
    """
    if isinstance(doc, EsgDocument):
        # A copy made with model_copy(update=…) is not validated: start from plain values.
        raw = plain(doc.model_dump(by_alias=True, warnings=False))
    else:
        raw = dict(doc)
    found = Findings()
    parsed = parse(raw, found)
    if parsed.doc is not None:
        ctx = Context(parsed.doc, parsed, found)
        for rules in (
            rules_scene,
            rules_relations,
            rules_timeline,
            rules_events,
            rules_segments,
            rules_statements,
            rules_joints,
            rules_breaking,
            rules_stages,
            rules_casting,
            rules_dressing,
        ):
            rules.check(ctx)
    return tuple(found.items)
