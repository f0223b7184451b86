"""Whose work is in a dataset, and under which licences."""

from __future__ import annotations

from collections import Counter
import json
from typing import Any

from esg.dataset.card.facts.tables import Tables


def licences(tables: Tables) -> dict[str, Any]:
    """Assets by licence and attribution: how many scenes show one of them."""
    shown: Counter[tuple[str, str]] = Counter()
    for row in tables.rows("scenes", ["esg_resolve"]):
        if not row["esg_resolve"]:
            continue
        found = json.loads(row["esg_resolve"]).get("asset_configurations", {}).values()
        shown.update({(c.get("license", ""), c.get("attribution", "")) for c in found})
    return {
        "licences": [
            {"license": name, "attribution": whose, "scenes": n}
            for (name, whose), n in sorted(shown.items())
        ]
    }
