"""`esg serve`: benchmark suites every night, compared with history."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
import re
from typing import Annotated, Any, Literal

from cyclopts import Parameter

DEFAULT_SUITE = Path("data") / "suites" / "paper.yaml"


def serve(
    *,
    cron: str | None = None,
    once: Annotated[bool, Parameter(negative="")] = False,
    suite: list[Path] | None = None,
    runs: int = 3,
    seed: int = 0,
    strategy: Literal["batched", "hybrid", "fd", "ad", "none"] = "batched",
    engine: Literal["physx", "rapier", "newton"] = "physx",
    device: str = "cpu",
    out: Path = Path("runs") / "nightly",
    db: Path | None = None,
    workers: int | None = None,
    cached: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Run suites on a schedule or once: ingest, compare with the last good run, write reports.

    With --once the exit code is 3 if a suite is worse than its last good run. With --cron the
    command serves the schedule until it is interrupted; a night that regressed is shown as failed.

    Args:
        cron: When, e.g. "0 3 * * *" (minute, hour, day of month, month, day of week).
        once: Run now and end.
        suite: Suite file; may be given several times. Default data/suites/paper.yaml.
        runs: Seeds a scene.
        seed: First seed.
        strategy: How the physics is searched.
        engine: Engine of the replay: physx runs the emitted class.
        device: cpu or cuda:N.
        out: Folder; every suite gets SUITE/DATE below it.
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        workers: Worker processes; default one a core.
        cached: Use finished stages of earlier runs instead of making everything anew.
        json: Print one JSON document (with --once).
    """
    from esg.commands.bench import MAX_RUNS
    from esg.commands.console import emit
    from esg.commands.database import database_path
    from esg.commands.inputs import check_device
    from esg.metrics import load_suite
    from esg.outcomes import UserError
    from esg.scenefolder import check_writable

    if once == (cron is not None):
        raise UserError('give either --cron "0 3 * * *" or --once')
    if not 1 <= runs <= MAX_RUNS:
        raise UserError(f"--runs {runs}: choose 1 to {MAX_RUNS}")
    if workers is not None and not 0 <= workers <= 256:
        raise UserError(f"--workers {workers}: choose 0 to 256")
    if cron is not None:
        check_cron(cron)
    suites = suite or [DEFAULT_SUITE]
    for path in suites:
        load_suite(path)
    check_writable(out)
    options: dict[str, Any] = {
        "suites": [str(p.resolve()) for p in suites], "out": str(out.resolve()),
        "database": str((db or database_path()).resolve()), "runs": runs, "seed": seed,
        "strategy": strategy, "engine": engine, "device": check_device(device),
        "workers": -1 if workers is None else workers, "cached": cached,
    }  # fmt: skip
    if cron is not None:
        return _serve(cron, options)
    nights = _once(options)
    if json:
        emit({"suites": nights, "regressed": [n["suite"] for n in nights if n["regressed"]]})
    else:
        print(describe(nights))
    return 3 if any(n["regressed"] for n in nights) else 0


def check_cron(text: str) -> None:
    """Checks a cron expression.

    Raises:
        UserError: If it is none.
    """
    from esg.outcomes import UserError

    fields = text.split()
    good = len(fields) == len(_CRON_RANGES) and all(
        _cron_field(field, *limits) for field, limits in zip(fields, _CRON_RANGES, strict=True)
    )
    if not good:
        raise UserError(
            f"--cron {text!r} is no cron expression; give minute, hour, day of month, month and "
            'day of week, e.g. "0 3 * * *" for every night at three (UTC)'
        )


_CRON_RANGES = ((0, 59), (0, 23), (1, 31), (1, 12), (0, 7))
_CRON_ITEM = re.compile(r"(?:\*|(\d+)(?:-(\d+))?)(?:/([1-9]\d*))?")


def _cron_field(field: str, low: int, high: int) -> bool:
    """Whether a field is a list of numbers, ranges and steps; names of days pass as they are."""
    if re.fullmatch(r"[A-Za-z]{3}(?:[,-][A-Za-z]{3})*", field):
        return high in (7, 12)
    for item in field.split(","):
        found = _CRON_ITEM.fullmatch(item)
        if found is None:
            return False
        numbers = [int(n) for n in found.groups()[:2] if n]
        if any(not low <= n <= high for n in numbers) or numbers != sorted(numbers):
            return False
    return True


def _once(options: dict[str, Any]) -> list[dict[str, Any]]:
    from esg.commands.console import progress
    from esg.metrics import load_suite
    from esg.pipeline import STAGES
    from esg.progress import StageEvent, listening

    total = sum(len(load_suite(s).scenes) for s in options["suites"]) * options["runs"]
    with progress(total * len(STAGES), "starting") as bar:

        def show(event: StageEvent) -> None:
            if event.status == "finished":
                bar.step(f"{event.scene} {event.stage}")

        from flows.session import session

        with listening(show), session(0) as call:
            from flows.nightly import nightly

            return call(nightly, **options, raise_on_regression=False)


def _serve(cron: str, options: dict[str, Any]) -> int:
    from flows.session import serving

    with serving():
        from flows.nightly import nightly

        nightly.serve(
            name="nightly",
            cron=cron,
            parameters=options,
            limit=1,
            pause_on_shutdown=False,
            print_starting_message=False,
        )
    return 0


def describe(nights: Sequence[dict[str, Any]]) -> str:
    """What a night brought, for people."""
    lines: list[str] = []
    for night in nights:
        row = night["summary"]
        lines.append(f"{night['suite']}: {night['verdict']}")
        if row.get("events") is not None and row.get("ecr_mean") is not None:
            lines.append(f"  events {row['ecr_mean']:.2f} of {row['events']}")
        lines.append(f"  {night['failed']} failed scene runs; {night['folder']}")
        if night["report"]:
            lines.append(f"  report: {night['report']}")
    return "\n".join(lines)
