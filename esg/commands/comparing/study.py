"""`esg study`: a page that asks people what they see, and what came of their answers."""

from __future__ import annotations

from collections.abc import Sequence
import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.study.analysis import Estimate, Preference

VARIANTS = "full,no_global,no_initial,no_dynamic,no_generation"


def study(
    run: Path | None = None,
    *,
    variants: str = VARIANTS,
    scenes: int = 20,
    seed: int = 0,
    pairs: str = "full",
    consent: Path | None = None,
    out: Path = Path("study.html"),
    analyse: Annotated[list[Path] | None, Parameter(consume_multiple=True, negative="")] = None,
    key: Path | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Write the page of a human study, or analyse what its participants answered (docs/study.md).

    Args:
        run: Folder with a folder of scenes a variant, as esg bench --ablations makes.
        variants: Names of those folders, with commas between.
        scenes: Most scenes to show of each; 0 for all that every variant has.
        seed: Of the choice of scenes and of every order.
        pairs: Variant that the others are set beside; none for no pairs.
        consent: Text file that stands for the usual text of consent.
        out: The page; its key (out with .key.json) is written beside it.
        analyse: Files of answers to analyse instead of writing a page.
        key: Key of the study, with --analyse; default the only *.key.json in the current folder.
        json: Print one JSON document, with --analyse.
    """
    from esg.outcomes import UserError

    if analyse is not None:
        return _analyse(analyse, key, as_json=json)
    if run is None:
        raise UserError("name the folder of a run with a folder a variant, or --analyse FILES")
    return _write(run, variants, scenes, seed, pairs, consent, out)


def _write(
    run: Path,
    variants: str,
    scenes: int,
    seed: int,
    pairs: str,
    consent: Path | None,
    out: Path,
) -> int:
    from esg.api import inputs
    from esg.files import read_limited
    from esg.outcomes import UserError
    from esg.study.clips import find_clips
    from esg.study.page import write_study

    names = [name.strip() for name in variants.split(",") if name.strip()]
    against = None if pairs == "none" else pairs

    def text() -> str:
        if consent is None:
            return ""
        inputs.existing_file(consent, "--consent")
        return read_limited(consent, 20_000).decode("utf-8", "replace").strip()

    def compared() -> None:
        if against is not None and against not in names:
            raise UserError(f"--pairs {pairs!r} is none of --variants; write none for no pairs")

    clips, words, *_ = inputs.checked(
        lambda: find_clips(run, names, scenes, seed),
        text,
        compared,
        lambda: inputs.in_range("--scenes", scenes, 0, 1000),
        lambda: inputs.in_range("--seed", seed, 0, 2**32 - 1),
        lambda: inputs.check_target("--out", out, "an HTML file"),
    )
    page, key = write_study(clips, out, seed=seed, pairs=against, consent=words)
    shown = len({clip.scene for clip in clips})
    print(f"{page}: {len(clips)} clips of {shown} scenes in {len(names)} variants")
    print(f"{key}: which clip is which; --analyse needs it, participants must not have it")
    return 0


def _analyse(files: Sequence[Path], key: Path | None, *, as_json: bool) -> int:
    from esg.commands.console import emit
    from esg.outcomes import UserError
    from esg.study.analysis import preferences_of, ratings_of, read_answers, read_key

    if key is None:
        here = sorted(Path().glob("*.key.json"))
        if len(here) != 1:
            raise UserError("--key: name the key that was written beside the study's page")
        key = here[0]
    known = read_key(key)
    answers = read_answers(files, known)
    ratings, preferences = ratings_of(answers, known), preferences_of(answers, known)
    if as_json:
        emit(
            {
                "study": known.study,
                "participants": len(answers),
                "confidence": 0.95,
                "ratings": {
                    v: {q: e.to_json() for q, e in rows.items()} for v, rows in ratings.items()
                },
                "pairs": [_pair_json(p) for p in preferences],
            }
        )
        return 0
    _tell(ratings, preferences, len(answers))
    return 0


def _pair_json(p: Preference) -> dict[str, Any]:
    interval = [p.low, p.high] if math.isfinite(p.low) else None
    return {
        "one": p.one, "other": p.other, "question": p.question, "preferred_one": p.wins,
        "preferred_other": p.losses, "no_difference": p.same, "interval_of_share": interval,
    }  # fmt: skip


def _tell(
    ratings: dict[str, dict[str, Estimate]], preferences: list[Preference], participants: int
) -> None:
    from esg.commands.console import table
    from esg.study.analysis import PAPER, QUESTIONS

    columns = ["variant", "scene quality", "95% interval", "input alignment", "95% interval",
               "paper: quality", "paper: alignment"]  # fmt: skip
    rows: list[list[str]] = []
    for variant, found in ratings.items():
        cells = [part for q in QUESTIONS for part in _cells(found[q])]
        rows.append([variant, *cells, *PAPER.get(variant, ("", ""))])
    title = (
        f"{participants} participants; mean ± std over participants of their means, Student's t "
        "interval; paper: 37 participants, 20 scenes"
    )
    print(table(columns, rows, title))
    if preferences:
        rows = [
            [p.one, p.other, p.question, str(p.wins), str(p.losses), str(p.same), _share(p)]
            for p in preferences
        ]
        columns = ["one", "other", "question", "one", "other", "same", "share of one, 95% interval"]
        print(f"\n{table(columns, rows, 'Side by side; Wilson intervals over all judgements')}")


def _cells(found: Estimate) -> tuple[str, str]:
    interval = f"{found.low:.2f} to {found.high:.2f}" if math.isfinite(found.low) else "-"
    return f"{found.mean:.2f} ± {found.std:.2f}", interval


def _share(p: Preference) -> str:
    count = p.wins + p.losses
    return (
        f"{100 * p.wins / count:.0f}% ({100 * p.low:.0f} to {100 * p.high:.0f})" if count else "-"
    )
