"""Usability of the language-model drafter's three variants with a scripted model.

The scripted model answers with the rules drafter's documents and spoils a fixed share of its
answers. It shows what repair and feedback are worth against such faults. Its rates are chosen, not
measured, and every fault breaks the document: the figures say nothing about any real model, and the
order of the two variants without validation depends on the prompts.
"""

from __future__ import annotations

from collections.abc import Sequence
import time
from typing import Any

from esg.draft.llm import draft_llm_batch
from esg.draft.llm_scripted import ScriptedModel
from esg.draft.llm_settings import LlmSettings

PAPER = {"single_shot": 76.5, "no_validation": 88.5, "full": 99.0}
"""Usability in percent of the paper's ablation (GPT-4.1, its own prompts), by our variant names."""
FAULT_RATE = 0.3
RELAPSE_RATE = 0.1


def ablation(prompts: Sequence[str], seed: int = 0) -> dict[str, dict[str, Any]]:
    """Share of prompts with a verifier-clean draft, per variant.

    Args:
        prompts: Scene descriptions.
        seed: Seed of the drafts, and with it of the scripted faults.

    Returns:
        For each variant: usability [%], the paper's figure [%], mean revision rounds, and mean
        wall time of a prompt [ms].
    """
    settings = LlmSettings(backoff_s=0.0, concurrency=1, cassette=None, cache=None)
    table: dict[str, dict[str, Any]] = {}
    for variant, paper in PAPER.items():
        client = ScriptedModel(FAULT_RATE, RELAPSE_RATE)
        began = time.perf_counter()
        results = draft_llm_batch(
            list(prompts), seed=seed, settings=settings, variant=variant, client=client
        )
        seconds = time.perf_counter() - began
        good = sum(r.document is not None and not r.violations for r in results)
        table[variant] = {
            "usability": round(100.0 * good / max(1, len(results)), 1),
            "paper": paper,
            "rounds": round(sum(r.rounds for r in results) / max(1, len(results)), 2),
            "ms_per_prompt": round(1000.0 * seconds / max(1, len(results)), 1),
        }
    return table


def show(table: dict[str, dict[str, Any]], prompts: int) -> str:
    """The table as text."""
    lines = [
        f"language-model drafter with a scripted model, {prompts} prompts "
        f"({100 * FAULT_RATE:.0f}% of answers spoiled, {100 * RELAPSE_RATE:.0f}% of corrections)",
        f"{'variant':<16}{'usability':>11}{'rounds':>9}{'paper':>8}",
    ]
    for variant, row in table.items():
        lines.append(f"{variant:<16}{row['usability']:>11}{row['rounds']:>9}{row['paper']:>8}")
    lines.append(
        "Scripted faults show what validation mends; rates and order say nothing about a real "
        "model."
    )
    return "\n".join(lines)
