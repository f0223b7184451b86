"""Drafts of many prompts at once, and scenes that wait for answers to request files."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.draft.llm.gathering import Gathered
    from esg.graph.models import EsgDocument

INDEX = "drafts.jsonl"
WAITING = 3
"""Exit code where scenes wait: nothing is wrong, and not all is done."""


@Parameter(name="*")
@dataclass(frozen=True)
class Drafting:
    """Who drafts: the options that several commands share.

    Args:
        drafter: rules needs nothing; llm needs an OpenAI-compatible endpoint; auto asks the model
            if one is configured and answers, else the rules.
        llm_batch: Folder of request files: write what a model is to be asked, end with exit code
            3 while scenes wait, go on with the answers that are put beside it
            (docs/drafting_llm.md).
    """

    drafter: Literal["rules", "llm", "auto"] = "rules"
    llm_batch: Path | None = None

    def check(self) -> None:
        """Checks that the folder of request files can be used.

        Raises:
            UserError: If not.
        """
        from esg.outcomes import UserError
        from esg.scenefolder import check_writable

        if self.llm_batch is None:
            return
        if self.drafter == "rules":
            raise UserError("--llm-batch belongs to --drafter llm or auto; the rules ask no model")
        check_writable(self.llm_batch)

    def gathered(self, prompts: Sequence[str], seeds: Sequence[int]) -> Gathered | None:
        """The drafts that the answers in the folder give; None if there is no such folder.

        Raises:
            UserError: If the folder cannot be read or written.
        """
        if self.llm_batch is None:
            return None
        from esg.draft.llm.gathering import gather

        return gather(prompts, self.llm_batch, seed=seeds)


RULES = Drafting()
"""Nothing said: the embedded drafter."""


@contextmanager
def from_answers(found: Gathered | None) -> Generator[None]:
    """Lets every draft of the body come from answers; does nothing without any."""
    if found is None:
        yield
        return
    from esg.draft.llm.gathering import replaying
    from esg.notices import warn

    for problem in found.problems:
        warn(f"answers: {problem}")
    with replaying(found.folder):
        yield


def tell_waiting(found: Gathered, as_json: bool) -> int:
    """Prints what waits, and what to do; returns the exit code."""
    from esg.commands.console import emit

    if as_json:
        emit({"waiting": found.data()})
    else:
        print(found.text())
    return WAITING


def draft_many(path: Path, out: Path, seed: int, drafting: Drafting, as_json: bool) -> int:
    """Drafts a file of prompts; returns the exit code.

    Args:
        path: Prompts file, as of `esg dataset`.
        out: Folder that receives one document a prompt and `drafts.jsonl`.
        seed: Of prompts that have none of their own.
        drafting: Who drafts.
        as_json: Whether stdout gets one JSON document.
    """
    from esg.commands.console import emit
    from esg.dataset.plan import read_prompts

    prompts = read_prompts(path)
    seeds = [seed if p.seed is None else p.seed for p in prompts]
    texts = [p.prompt for p in prompts]
    found, drafter = drafting.gathered(texts, seeds), drafting.drafter
    if found is None:
        rows = [_one(t, s, drafter) for t, s in zip(texts, seeds, strict=True)]
    else:
        rows = [_of_model(d, s, drafter) for d, s in zip(found.drafts, seeds, strict=True)]
    summary = _written(rows, out)
    if found is not None:
        summary["waiting_for"] = found.data()
    if as_json:
        emit(summary)
    else:
        print(
            f"{summary['drafted']} of {summary['prompts']} prompts drafted, "
            f"{summary['failed']} failed, {summary['waiting']} waiting; documents in {out}"
        )
        if found is not None and (text := found.text()):
            print(text)
    return WAITING if summary["failed"] or summary["waiting"] else 0


_Row = tuple[dict[str, Any], "EsgDocument | None"]


def _one(prompt: str, seed: int, drafter: str) -> _Row:
    from esg.draft import draft
    from esg.graph import verify
    from esg.outcomes import Outcome, UserError

    row: dict[str, Any] = {"prompt": prompt, "seed": seed, "drafter": drafter}
    try:
        doc = draft(prompt, seed=seed, drafter=drafter)
    except UserError as error:
        return {**row, "outcome": Outcome.INVALID_DRAFT.value, "reason": str(error)}, None
    broken = [v.to_json() for v in verify(doc)]
    outcome = Outcome.INVALID_DRAFT if broken else Outcome.SOLVED
    return {**row, "outcome": outcome.value, "reason": "", "violations": broken}, doc


def _of_model(made: Any, seed: int, drafter: str) -> _Row:
    from esg.outcomes import Outcome

    if drafter == "auto" and not made.waiting and made.outcome is not Outcome.SOLVED:
        row, doc = _one(made.prompt, seed, "rules")
        return {**row, "drafter": "rules", "model_failed": made.reason}, doc
    document = None if made.waiting else made.document
    if drafter == "auto" and document is not None:
        from esg.draft.llm.auto import compared

        document = compared(document, seed=seed)
    return {
        "prompt": made.prompt,
        "seed": seed,
        "drafter": "llm",
        "outcome": "waiting" if made.waiting else made.outcome.value,
        "reason": made.reason,
        "violations": [v.to_json() for v in made.violations],
        "rounds": made.rounds,
        "repairs": list(made.repairs),
        "replies": len(made.calls),
        "models": sorted({c.model for c in made.calls if c.model}),
        "input_tokens": made.input_tokens,
        "output_tokens": made.output_tokens,
        "cost_usd": made.cost_usd,
    }, document


def _written(rows: Sequence[_Row], out: Path) -> dict[str, Any]:
    """Writes documents and their index, whole or not at all."""
    import json

    from esg.draft.llm.store import write_whole
    from esg.graph import canonical_json

    lines: list[str] = []
    for number, (row, doc) in enumerate(rows):
        name = None
        if doc is not None:
            name = f"{number:05d}-{doc.scene_definition.scene_id}.json"
            write_whole(out / name, canonical_json(doc).decode())
        line = {"index": number, "document": name, **row}
        lines.append(json.dumps(line, ensure_ascii=False, sort_keys=True) + "\n")
    write_whole(out / INDEX, "".join(lines))
    outcomes = [row["outcome"] for row, _ in rows]
    waiting, drafted = outcomes.count("waiting"), outcomes.count("solved")
    return {
        "prompts": len(rows),
        "drafted": drafted,
        "failed": len(rows) - waiting - drafted,
        "waiting": waiting,
        "folder": str(out),
        "index": str(out / INDEX),
    }
