"""The rules reader as subject of pruning: its corpora, held-out sets and rewordings."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
import csv
import hashlib
import importlib
import random
import re
import sys
from typing import Any

import yaml

from benchmarks import metamorphic
from benchmarks.drafting import BLIND, FILES, load, score_document
from benchmarks.drafting.corpus import PROMPTS
from benchmarks.drafting.whole import Outcome
from benchmarks.lib.drafting_soak import texts
from benchmarks.pruning.effect import Case, Subject
from esg.outcomes import UserError

COUNTS = (
    "prompts", "usable", "objects", "objects_found", "events", "events_found", "quantities",
    "quantities_found", "drafted", "invented",
)  # fmt: skip
REWORDINGS = "rewordings"
SOAK = "soak"
SEEN = "seen"
"""Prompts of suites and those that were read as a stranger: no label, but their documents count."""
_ALIKE = 0.6
"""Share of words (Jaccard) from which two prompts of one file are one story told twice."""


class Reader(Subject):
    """`esg.draft.draft`, judged by the labels of the corpora."""

    package = "esg.draft"

    def __init__(self) -> None:
        self._tags: dict[str, Any] = {}

    def reader(self) -> Callable[[str], Any]:
        """The rules reader."""
        return importlib.import_module(self.package).draft

    def prepare(self) -> None:
        """Keeps every text's tags: the tagger is no part of what is pruned, and slow."""
        _keep_models()
        self.reader()("A ball hits a box.")
        known = self._tags
        for name, module in list(sys.modules.items()):
            tag = vars(module).get("pos_tags")
            if name.startswith(self.package + ".") and tag is not None:

                def tags(text: str, tag: Callable[[str], Any] = tag) -> Any:
                    if text not in known:
                        known[text] = tag(text)
                    return known[text]

                vars(module)["pos_tags"] = tags

    def mark(self, result: Any) -> tuple[str, str]:
        """Digests of the document with its warnings, and of its account of the prompt's words."""
        whole = result.model_dump_json(exclude={"coverage"}) + "\n".join(result.coverage.warnings)
        account = result.coverage.model_dump_json().encode()
        return _digest(whole.encode()), _digest(account)

    def judge(self, case: Case, result: Any) -> tuple[float, tuple[float, ...]]:
        """Labels met and validity less inventions (of whole labels: all faults), and counts."""
        if case.row is None:
            return 0.0, (0.0,) * len(COUNTS)
        score = score_document(case.row, result)
        counts = tuple(float(getattr(score, name)) for name in COUNTS)
        found = score.usable + score.objects_found + score.events_found + score.quantities_found
        silent = sum(v.outcome is Outcome.SILENT for v in score.verdicts)
        faults = sum(len(v.faults) for v in score.verdicts) + silent
        return found - score.invented - faults, counts

    def drops(
        self, before: dict[str, list[float]], after: dict[str, list[float]]
    ) -> dict[str, float]:
        """Largest drop of a figure of each corpus [points]; more inventions are a drop."""
        out: dict[str, float] = {}
        for corpus, counts in before.items():
            if corpus in (SOAK, SEEN):
                continue
            was, now = percentages(counts), percentages(after[corpus])
            was["invented_events"], now["invented_events"] = (
                -was["invented_events"], -now["invented_events"],
            )  # fmt: skip
            out[corpus] = max(was[name] - now[name] for name in was)
        return out

    def refused(self, error: Exception) -> bool:
        """User errors are refusals."""
        return isinstance(error, UserError)


def _keep_models() -> None:
    """Loads a language model once and compiles a pattern once, however often the reader is."""
    import spacy

    re._MAXCACHE = 1_000_000  # type: ignore[attr-defined]
    if getattr(spacy.load, "kept", None) is None:
        load, kept = spacy.load, dict[str, Any]()

        def loaded(name: str, **named: Any) -> Any:
            if name not in kept:
                kept[name] = load(name, **named)
            return kept[name]

        loaded.kept = kept  # type: ignore[attr-defined]
        spacy.load = loaded


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=9).hexdigest()


def cases(
    every: int = 1, held_out: bool = True, files: Iterable[str] = FILES, soak: int = 0
) -> list[Case]:
    """Which prompts there are: some decide, the others enter totals only.

    Development prompts, the open half of `public`, one story of each rewording, suites and the
    prompts that were read decide.

    Args:
        every: Every n-th deciding prompt only, for a quick look.
        held_out: Whether the totals of `test`, the blind sets and all rewordings are wanted.
        files: Files of the development corpus.
        soak: Prompts of the soak test that must not crash.
    """
    out: list[Case] = []
    for name in files:
        rows = load("dev", [name])
        for row, story in zip(rows, _stories([r["prompt"] for r in rows]), strict=True):
            out.append(Case(row["id"], row["prompt"], f"{name}:{story}", "dev", row))
    rewordings: list[Case] = []
    by_wording: dict[str, list[dict[str, Any]]] = {}
    for wording, row in metamorphic.rows():
        by_wording.setdefault(f"{row['band']}: {wording}", []).append(row)
    for n, (wording, rows) in enumerate(by_wording.items()):
        chosen = random.Random(n).randrange(len(rows))
        for k, row in enumerate(rows):
            family = f"{REWORDINGS}:{row['id']}"
            case = Case(f"{wording} {k}", row["prompt"], family, REWORDINGS, row, k == chosen)
            (out if k == chosen else rewordings).append(case)
    for row in load("public"):
        out.append(Case(row["id"], row["prompt"], f"public:{row['id']}", "public", row))
    out = [*out, *_seen()][::every]
    dev = [r for name in files for r in load("dev", [name])]
    for n, text in enumerate(texts(soak, dev, seed=7) if soak else ()):
        out.append(Case(f"{SOAK}:{n}", text, f"{SOAK}:{n}", SOAK))
    if not held_out:
        return out
    for split in ("test", *BLIND):
        for row in load(split):
            out.append(Case(f"{split}:{row['id']}", row["prompt"], "", split, row, False))
    return out + rewordings


def _seen() -> Iterator[Case]:
    """Suites and the prompts of `read*.tsv`."""
    for path in sorted((PROMPTS.parent / "suites").glob("*.yaml")):
        for scene in yaml.safe_load(path.read_text(encoding="utf-8"))["scenes"]:
            name = f"{path.stem}:{scene['id']}"
            yield Case(name, scene["prompt"], name, SEEN)
    for path in sorted(PROMPTS.glob("read*.tsv")):
        with path.open(encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file, delimiter="\t"):
                name = f"{path.stem}:{row['id']}"
                yield Case(name, row["prompt"], name, SEEN)


def _stories(prompts: list[str]) -> list[int]:
    """For every prompt of a file the number of the first that tells the same in other words."""
    words = [set(re.findall(r"[a-z]+", p.lower())) for p in prompts]
    out: list[int] = []
    for k, own in enumerate(words):
        same = (out[j] for j in range(k) if len(own & words[j]) >= _ALIKE * len(own | words[j]))
        out.append(next(same, k))
    return out


def percentages(values: Iterable[float]) -> dict[str, float]:
    """Figures of the drafting benchmark from sums of counts."""
    v = dict(zip(COUNTS, values, strict=True))

    def percent(a: str, b: str, empty: float = 100.0) -> float:
        return round(100.0 * v[a] / v[b], 2) if v[b] else empty

    return {
        "prompts": v["prompts"],
        "usability": percent("usable", "prompts"),
        "object_recall": percent("objects_found", "objects"),
        "event_recall": percent("events_found", "events"),
        "quantity_recall": percent("quantities_found", "quantities"),
        "invented_events": percent("invented", "drafted", 0.0),
    }


def totals(counts: Iterable[tuple[str, tuple[float, ...]]]) -> dict[str, dict[str, float]]:
    """Percentages of each corpus from the counts of its cases."""
    sums: dict[str, list[float]] = {}
    for corpus, values in counts:
        if corpus in (SOAK, SEEN):
            continue
        have = sums.setdefault(corpus, [0.0] * len(COUNTS))
        for k, value in enumerate(values):
            have[k] += value
    return {corpus: percentages(values) for corpus, values in sums.items()}


__all__ = ["COUNTS", "REWORDINGS", "Reader", "cases", "percentages", "totals"]
