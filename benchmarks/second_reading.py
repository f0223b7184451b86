"""What each question of the second reading finds, by how readers judged the draft.

    python -m benchmarks.second_reading                       # opened captions, public and dev
    python -m benchmarks.second_reading --files read11.tsv    # captions of some files only
    python -m benchmarks.second_reading --show "goes on"      # what a question finds

To ask the drafts that readers judged, and not today's, run it in a checkout of the version that
drafted them, with today's `esg/draft/audit`, its tables (`audit_acts.csv`, `doubts.csv`) and the
word sets "... (audit)" in it. Held-out prompts are never read.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
import csv
from dataclasses import dataclass
import sys
from unittest import mock

from benchmarks.drafting.corpus import PROMPTS, load
from esg.draft import audit, draft, rules
from esg.draft.audit.checks import CHECKS
from esg.graph.models import Coverage, EsgDocument, Statement
from esg.outcomes import UserError

CLASSES = ("silent wrong", "silent, main event right", "fully right", "other")


@dataclass(frozen=True)
class Found:
    """What a question finds in a prompt.

    Args:
        question: Its name.
        verdict: One of `CLASSES`, by the newest reading of the prompt.
        prompt, words: The text, and the words that nothing accounts for.
    """

    question: str
    verdict: str
    prompt: str
    words: str


def captions(files: Iterable[str] = ()) -> Iterator[tuple[str, str]]:
    """Captions with their newest verdicts.

    Args:
        files: Names of files; all that there are if empty.
    """
    for path in sorted(PROMPTS.glob("read*.tsv")):
        if files and path.name not in files:
            continue
        with path.open(encoding="utf-8", newline="") as file:
            for _, prompt, _, *verdicts in [*csv.reader(file, "excel-tab", quoting=3)][1:]:
                yield prompt, verdicts[-1] if verdicts[-1] in CLASSES else "other"


def ask(prompt: str, verdict: str) -> list[Found]:
    """Everything that the questions find, also what others of them own up to.

    Raises:
        UserError: If the prompt cannot be drafted.
    """
    out: list[Found] = []

    def owned_up(
        text: str, doc: EsgDocument, read: Coverage, held: tuple[Statement, ...] | None
    ) -> tuple[Statement, ...]:
        case = audit.case_of(text, doc, read, held)
        for name, check in CHECKS.items() if case is not None else ():
            words = dict.fromkeys(case.text[f.start : f.end] for f in check(case))
            out.extend(Found(name, verdict, prompt, w) for w in words)
        return ()

    with mock.patch.object(rules, "owned_up", owned_up):
        draft(prompt)
    return out


def main(argv: Sequence[str] | None = None) -> int:
    """Prints the table, or what a question finds."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.second_reading")
    parser.add_argument("--files", nargs="*", default=[], help="files of captions, and no others")
    parser.add_argument("--show", choices=[*CHECKS], help="list what a question finds")
    args = parser.parse_args(argv)
    prompts = dict(captions(args.files))
    for split in () if args.files else ("public", "dev"):
        for row in load(split):
            prompts.setdefault(row["prompt"], "other")
    asked: Counter[str] = Counter()
    found: list[Found] = []
    for prompt, verdict in prompts.items():
        try:
            found += ask(prompt, verdict)
        except UserError:
            continue
        asked[verdict] += 1
    if args.show:
        print(
            *(f"{f.verdict} | {f.words} | {f.prompt}" for f in found if f.question == args.show),
            sep="\n",
        )
        return 0
    print(" | ".join(["question", *(f"{v} ({asked[v]})" for v in CLASSES)]))
    for name in (*CHECKS, "any"):
        of = {(f.prompt, f.verdict) for f in found if name in (f.question, "any")}
        count = Counter(v for _, v in of)
        print(" | ".join([name, *(str(count[v]) for v in CLASSES)]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
