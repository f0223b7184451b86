"""Drafting benchmark (`python -m benchmarks.drafting`): drafts against labels of their prompts."""

from benchmarks.drafting.corpus import BANDS, BLIND, FILES, PROMPTS, load
from benchmarks.drafting.score import PAPER, Score, score_document, score_row

__all__ = [
    "BANDS",
    "BLIND",
    "FILES",
    "PAPER",
    "PROMPTS",
    "Score",
    "load",
    "score_document",
    "score_row",
]
