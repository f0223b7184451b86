"""Limits that a user sets: what exceeds them ends, is told, and leaves the rest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
import shutil

from benchmarks.faults.ground import PATIENCE_S, PROMPT, esg

HEADS = ("limit", "command", "exit code", "seconds", "wrong")
_HUGE = "SELECT count(*) FROM range(100000000) a, range(100000) b WHERE a.range % 7 = b.range % 5"
_WIDE = "SELECT list(range) FROM range(400000000)"


@dataclass(frozen=True)
class Limit:
    """A limit and a command that exceeds it.

    Args:
        arguments: Of the command.
        variables: Of its environment.
        codes: Exit codes that are right.
        says: What it tells.
    """

    arguments: Sequence[str]
    variables: Mapping[str, str]
    codes: tuple[int, ...]
    says: str


LIMITS = {
    "0.3 s a stage, generate": Limit(
        ["generate", PROMPT, "--out", "k"], {"ESG_STAGE_SECONDS": "0.3"}, (3,), "ESG_STAGE_SECONDS"
    ),
    "0.3 s a stage, bench": Limit(
        ["bench", "faults.yaml", "--runs", "1", "--out", "k"],
        {"ESG_STAGE_SECONDS": "0.3"}, (3,), "ESG_STAGE_SECONDS",
    ),
    "no number": Limit(
        ["bench", "faults.yaml", "--runs", "1", "--out", "k"],
        {"ESG_STAGE_SECONDS": "soon"}, (2,), "ESG_STAGE_SECONDS=soon",
    ),
    "2 s of SQL": Limit(["sql", _HUGE], {"ESG_SQL_SECONDS": "2"}, (1, 2), "ESG_SQL_SECONDS"),
    "0.2 GiB of SQL": Limit(["sql", _WIDE], {"ESG_SQL_GIB": "0.2"}, (1, 2), "ESG_SQL_GIB"),
    "0.05 GiB a worker": Limit(
        ["dataset", "--sample", "2", "--out", "k", "--workers", "1"],
        {"ESG_WORKER_GIB": "0.05"}, (1, 3), "memory",
    ),
}  # fmt: skip
"""Limits by what they are."""


def exceeded(ground: Path, place: Path, name: str) -> list[tuple[tuple[object, ...], str]]:
    """A command that exceeds a limit.

    Args:
        ground: A prepared folder.
        place: Where it happens.
        name: Of `LIMITS`.

    Returns:
        A row for `HEADS`, with what is wrong.
    """
    limit = LIMITS[name]
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    shutil.copyfile(ground / "faults.yaml", place / "faults.yaml")
    shutil.copytree(ground / "runs", place / "runs")
    shutil.copytree(ground / "cache" / "prefect", place / "cache" / "prefect")
    ended = esg(limit.arguments, place, place / "cache", 3 * PATIENCE_S, **limit.variables)
    wrong = ended.wrong(limit.codes)
    told = (
        ended.out
        + ended.err
        + "".join(p.read_text("utf-8", "replace") for p in (place / "k").glob("failures.jsonl"))
    )
    if not wrong and limit.says not in told:
        wrong = f"does not say {limit.says}: {' '.join(told.split())[-300:]}"
    cells = (name, limit.arguments[0], ended.code, f"{ended.seconds:.1f}", int(bool(wrong)))
    return [(cells, wrong)]
