"""The prompt corpus, and which nodes of a draft the noun phrases of its labels mean."""

from __future__ import annotations

from collections.abc import Iterable
import json
from pathlib import Path
import re
from typing import Any

from esg.graph.models import EsgDocument

PROMPTS = Path(__file__).resolve().parents[2] / "data" / "prompts"
BANDS = ("single", "quantified", "chain", "multi_phase")
FILES = (
    *BANDS,
    "varied",
    "cold",
    "wide",
    "wide2",
    "prose",
    "stranger",
    "prose2",
    "stranger2",
    "stranger3",
    "stranger4",
    "plain",
    "plain2",
    "plain3",
    "plain4",
    "plain5",
)
"""All but the bands hold further prompts of all four bands, for development only."""
BLIND = ("blind", "blind2")
"""Splits that are files of their own, no part of `all`."""
PUBLIC = ("public", "public_blind")
"""Halves of `public`, whose labels say all that a prompt states (second edition)."""
HELD_OUT = ("test", *BLIND, "public_blind")
"""Splits for totals only: who improves the drafter reads no miss of them."""


def load(split: str | None, files: Iterable[str] = FILES) -> list[dict[str, Any]]:
    """The corpus without `BLIND` and `PUBLIC`, or one split of it, or of some files."""
    own = {**{name: name for name in BLIND}, **dict.fromkeys(PUBLIC, "public")}
    rows: list[dict[str, Any]] = []
    for name in (own[split],) if split in own else files:
        for line in (PROMPTS / f"{name}.jsonl").read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            if split in (None, "all", row["split"]):
                rows.append(row)
    return rows


def second_edition(row: dict[str, Any]) -> bool:
    """Whether a row's labels say all that the prompt states, so that a whole draft is judged."""
    return "statements" in row


def words_of(text: str) -> list[str]:
    """Words of a phrase in lower case, plurals as singulars."""
    out: list[str] = []
    for w in re.findall(r"[a-z0-9]+", text.lower()):
        if len(w) > 3 and w.endswith("s") and not w.endswith("ss"):
            w = w[:-2] if w.endswith(("xes", "ches", "shes")) else w[:-1]
        out.append(w)
    return out


def bind(doc: EsgDocument, phrase: str) -> list[str]:
    """Nodes that a noun phrase of the expectations can mean."""
    want = words_of(phrase)
    best: list[str] = []
    best_score = 0
    for name, node in doc.spatial_relation_graph.nodes.items():
        asset = doc.asset_requirement[node.asset_id]
        own = set(words_of(node.label) + words_of(name.replace("_", " ")))
        own |= set(words_of(asset.asset_category.replace("_", " ")))
        own |= set(words_of(asset.asset_description.split(":")[0]))
        if asset.color:
            own.add(asset.color)
        joined = "".join(want)
        head = want[-1] if len(want[-1]) > 1 and not want[-1].isdigit() else want[0]
        if head not in own and joined not in own and joined not in "".join(words_of(node.label)):
            continue
        score = 1 + sum(w in own for w in want)
        if joined in "".join(words_of(node.label)):
            score = max(score, 1 + len(want))
        if score > best_score:
            best, best_score = [name], score
        elif score == best_score:
            best.append(name)
    return best if best_score >= 1 + min(len(want), 1) else []


def head_of(doc: EsgDocument, name: str) -> str:
    """The noun that a node's own name ends in, letters and numbers of members left out."""
    own = words_of(doc.spatial_relation_graph.nodes[name].label) or words_of(name.replace("_", " "))
    return next((w for w in reversed(own) if len(w) > 1 and not w.isdigit()), "")
