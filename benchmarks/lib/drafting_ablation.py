"""Usability and recall of the language-model drafter's three variants with a scripted model.

The scripted model answers with the rules drafter's documents and spoils a fixed share of its
answers. It shows what repair and feedback are worth against such faults. Its rates are chosen, not
measured, and every fault breaks the document: the figures say nothing about any real model, and the
order of the two variants without validation depends on the prompts.
"""

from __future__ import annotations

from collections.abc import Sequence
import time
from typing import Any, cast

from benchmarks.drafting import PAPER, Score, score_document
from esg.draft.llm.drafter import draft_llm_batch
from esg.draft.llm.records import Variant
from esg.draft.llm.scripted import ScriptedModel
from esg.draft.llm.settings import LlmSettings

FAULT_RATE = 0.3
RELAPSE_RATE = 0.1


def ablation(
    rows: Sequence[dict[str, Any]], seed: int = 0
) -> tuple[dict[str, dict[str, Any]], dict[str, Score]]:
    """Drafts every prompt in the three variants.

    Args:
        rows: Rows of the corpus.
        seed: Seed of the drafts, and with it of the scripted faults.

    Returns:
        For each variant: mean revision rounds and wall time of a prompt [ms] beside the rates of
        faults; and its score, where a draft that breaks a rule finds nothing.
    """
    settings = LlmSettings(backoff_s=0.0, concurrency=1, cassette=None, cache=None)
    table: dict[str, dict[str, Any]] = {}
    scores: dict[str, Score] = {}
    for variant, paper in PAPER.items():
        client = ScriptedModel(FAULT_RATE, RELAPSE_RATE)
        began = time.perf_counter()
        results = draft_llm_batch(
            [row["prompt"] for row in rows],
            seed=seed,
            settings=settings,
            variant=cast(Variant, variant),
            client=client,
        )
        seconds = time.perf_counter() - began
        score = scores[variant] = Score()
        for row, result in zip(rows, results, strict=True):
            # A draft that breaks a rule goes no further (outcome invalid_draft): it finds nothing.
            draft = None if result.violations else result.document
            score.add(score_document(row, draft, result.reason))
        table[variant] = {
            "usability": score.row()["usability"],
            "paper": paper,
            "rounds": round(sum(r.rounds for r in results) / max(1, len(results)), 2),
            "ms_per_prompt": round(1000.0 * seconds / max(1, len(results)), 1),
            "fault_rate": FAULT_RATE,
            "relapse_rate": RELAPSE_RATE,
        }
    return table, scores
