"""What is read from a finished dataset for its card: a collector a subject, in one table."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from esg.dataset.card.facts import clips, licences, outcomes, texts, variety
from esg.dataset.card.facts.failures import failure_table
from esg.dataset.card.facts.tables import Tables
from esg.dataset.whatifs import what_if_statistics

COLLECTORS: tuple[Callable[[Tables], Mapping[str, Any]], ...] = (
    outcomes.endings,
    outcomes.statements,
    outcomes.plausibility,
    outcomes.events,
    outcomes.sizes,
    variety.drawn,
    variety.duplicates,
    clips.clips,
    clips.truth,
    texts.texts,
    lambda tables: what_if_statistics(tables.out),
    licences.licences,
)
"""Each gives some named facts, which end in `meta/info.json` as `statistics`."""


def collect(out: Path, failed: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """All facts of a dataset whose split files are written.

    Args:
        out: Folder of the dataset.
        failed: Rows of `failures.jsonl`.
    """
    tables = Tables(out)
    facts: dict[str, Any] = {}
    for collector in COLLECTORS:
        facts |= collector(tables)
    return {**facts, "failures": failure_table(failed)}
