"""Drafts of many prompts at once, and scenes that wait for answers to request files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.draft.llm.gathering import Gathered
    from esg.graph.models import EsgDocument

INDEX = "drafts.jsonl"
WAITING = 3
"""Exit code where scenes wait: nothing is wrong, and not all is done."""


def gathered(
    drafter: str, folder: Path | None, prompts: Sequence[str], seeds: Sequence[int]
) -> Gathered | None:
    """The drafts that the answers in a folder give; None if there is no such folder.

    Raises:
        UserError: If the drafter asks no model, or the folder cannot be read or written.
    """
    if folder is None:
        return None
    check_batch(drafter, folder)
    from esg.draft.llm.gathering import gather

    return gather(prompts, folder, seed=seeds)


def check_batch(drafter: str, folder: Path | None) -> None:
    """Checks that a folder of request files can be used.

    Raises:
        UserError: If not.
    """
    from esg.outcomes import UserError
    from esg.scenefolder import check_writable

    if folder is None:
        return
    if drafter == "rules":
        raise UserError("--llm-batch belongs to --drafter llm or auto; the rules ask no model")
    check_writable(folder)


def tell_waiting(found: Gathered, as_json: bool) -> int:
    """Prints what waits, and what to do; returns the exit code."""
    from esg.commands.console import emit

    if as_json:
        emit({"waiting": found.data()})
    else:
        print(found.text())
    return WAITING


def tell_problems(found: Gathered) -> None:
    """Says on stderr what is wrong with answers, where nothing waits for them."""
    from esg.notices import warn

    for problem in found.problems:
        warn(f"answers: {problem}")


def draft_many(
    path: Path, out: Path, seed: int, drafter: str, batch: Path | None, as_json: bool
) -> int:
    """Drafts a file of prompts; returns the exit code.

    Args:
        path: Prompts file, as of `esg dataset`.
        out: Folder that receives one document a prompt and `drafts.jsonl`.
        seed: Of prompts that have none of their own.
        drafter: rules, llm or auto.
        batch: Folder of request files; None asks the server.
        as_json: Whether stdout gets one JSON document.
    """
    from esg.commands.console import emit
    from esg.dataset.plan import read_prompts

    prompts = read_prompts(path)
    seeds = [seed if p.seed is None else p.seed for p in prompts]
    texts = [p.prompt for p in prompts]
    found = gathered(drafter, batch, texts, seeds)
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
    }, None if made.waiting else made.document


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
