"""Drafts against labels: counts over prompts, and the verdicts on whole drafts."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
import time
from typing import Any

from benchmarks.drafting.corpus import BANDS, FILES, bind, load, second_edition
from benchmarks.drafting.events import compare
from benchmarks.drafting.quantities import has_quantity
from benchmarks.drafting.whole import Fault, Verdict, judge, owned_up
from esg.graph import verify
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

PAPER = {"single_shot": 76.5, "no_validation": 88.5, "full": 99.0}
"""Usability [%] of the paper's ablation (GPT-4.1, its own prompts), by our variants' names."""
CRASHED = "crashed"
"""How the reason begins where a draft ended in an error that is none of the user's."""


@dataclass
class Score:
    """Counts over prompts; usability counts prompts, the others count expectations."""

    prompts: int = 0
    usable: int = 0
    objects: int = 0
    objects_found: int = 0
    events: int = 0
    events_found: int = 0
    quantities: int = 0
    quantities_found: int = 0
    drafted: int = 0
    invented: int = 0
    problems: list[str] = field(default_factory=list[str])
    verdicts: list[Verdict] = field(default_factory=list[Verdict])
    """Of the prompts whose labels say all that is stated."""
    notes: list[tuple[str, str]] = field(default_factory=list[tuple[str, str]])
    """What drafts own up to: note and words, once a prompt."""

    def add(self, other: Score) -> None:
        """Adds another score's counts and problems."""
        for name in self.__dataclass_fields__:
            setattr(self, name, getattr(self, name) + getattr(other, name))

    def row(self) -> dict[str, float]:
        """Percentages."""

        def percent(a: int, b: int) -> float:
            return round(100.0 * a / b, 1) if b else 100.0

        return {
            "prompts": self.prompts,
            "usability": percent(self.usable, self.prompts),
            "object_recall": percent(self.objects_found, self.objects),
            "event_recall": percent(self.events_found, self.events),
            "quantity_recall": percent(self.quantities_found, self.quantities),
            "invented_events": round(100.0 * self.invented / self.drafted, 1)
            if self.drafted
            else 0.0,
        }


def score_row(row: dict[str, Any], drafter: Callable[[str], EsgDocument]) -> Score:
    """Drafts one prompt and compares it with its expectations."""
    try:
        doc = drafter(row["prompt"])
    except Exception as error:  # a crash counts like a refusal, and the run goes on
        how = "refused" if isinstance(error, UserError) else f"{CRASHED}: {type(error).__name__}"
        return score_document(row, None, f"{how}: {error}")
    return score_document(row, doc)


def score_document(row: dict[str, Any], doc: EsgDocument | None, reason: str = "") -> Score:
    """Compares a draft with the expectations of its prompt.

    Args:
        row: Row of the corpus.
        doc: Draft, valid or not; None misses everything that is expected.
        reason: Why there is none.
    """
    out = Score(
        prompts=1,
        objects=len(row["objects"]),
        events=len(row["events"]),
        quantities=len(row["constraints"]),
    )
    if doc is None:
        out.problems.append(f"{row['id']} {reason} | {row['prompt']}")
        if second_edition(row):
            said = not reason.startswith(CRASHED)
            out.verdicts.append(judge(row, None, None, [Fault("unusable", reason)], said))
        return out
    violations = verify(doc)
    out.usable = int(not violations)
    unusable = [f"{v.code} {v.pointer}" for v in violations]
    objects = [(item, bind(doc, item["phrase"])) for item in row["objects"]]
    lost = [(item, ids) for item, ids in objects if not ids or len(ids) < item.get("count", 1)]
    out.objects_found = len(objects) - len(lost)
    told = compare(doc, row)
    out.events_found = len(row["events"]) - len(told.missing)
    out.drafted, out.invented = len(told.drafted), len(told.invented)
    unmet = [want for want in row["constraints"] if not has_quantity(doc, want)]
    out.quantities_found = len(row["constraints"]) - len(unmet)
    out.notes = owned_up(doc)
    if second_edition(row):
        faults = [Fault("unusable", v) for v in unusable]
        faults += [Fault("quantity", str(want)) for want in unmet]
        verdict = judge(row, doc, told, faults)
        out.verdicts.append(verdict)
        lines = [verdict.outcome.value, *(f"{f.kind} {f.what}" for f in verdict.faults)]
    else:
        lines = unusable + [f"object {item} got {ids}" for item, ids in lost]
        lines += [f"missing {event}" for event in told.missing]
        lines += [f"invented {n.event.value}{n.participants}" for n in told.invented]
        lines += [f"quantity {want}" for want in unmet]
    out.problems = [f"{row['id']} {line} | {row['prompt']}" for line in lines]
    return out


def run(
    split: str, drafter: Callable[[str], EsgDocument], files: Iterable[str] = FILES
) -> tuple[dict[str, Score], float]:
    """Scores by band and in total, and the mean time of a draft [s]."""
    scores = {band: Score() for band in BANDS} | {"total": Score()}
    began = time.perf_counter()
    rows = load(split, files)
    for row in rows:
        one = score_row(row, drafter)
        for key in (row["band"], "total"):
            scores[key].add(one)
    return scores, (time.perf_counter() - began) / max(1, len(rows))
