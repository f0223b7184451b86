"""`esg serve`: benchmark suites every night, compared with history."""

from __future__ import annotations

from collections.abc import Sequence
import datetime
from functools import partial
from pathlib import Path
import subprocess
import sys
import time
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from cronsim import CronSim

DEFAULT_SUITE = Path("paper")
"""The name of one that comes with the package."""
FIELDS = 5
MAX_CHARACTERS = 500
_SOME_DAY = datetime.datetime(2024, 1, 1, tzinfo=datetime.UTC)


def serve(
    *,
    cron: str | None = None,
    once: Annotated[bool, Parameter(negative="")] = False,
    suite: Annotated[list[Path] | None, Parameter(negative="")] = None,
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

    With --once the exit code is 3 if a suite is worse than its last good run, and 1 if a run could
    not be recorded. With --cron the command serves the schedule until it is interrupted.

    Args:
        cron: When, e.g. "0 3 * * *" (minute, hour, day of month, month, day of week).
        once: Run now and end.
        suite: Suite file, or name of one that comes with the package; may be given several times.
            Default paper.
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
    from esg.api.inputs import (
        check_cache,
        check_device,
        check_seed,
        check_workers,
        checked,
        in_range,
    )
    from esg.commands.bench import MAX_RUNS
    from esg.commands.console import emit
    from esg.metrics import load_suite, suite_file
    from esg.runs import database_path
    from esg.scenefolder import check_writable

    suites = suite or [DEFAULT_SUITE]
    device, *_ = checked(
        lambda: check_device(device),
        lambda: check_when(cron, once),
        lambda: check_seed(seed),
        lambda: in_range("--runs", runs, 1, MAX_RUNS),
        lambda: check_workers(workers),
        *(partial(load_suite, path) for path in suites),
        lambda: check_writable(out),
        check_cache,
    )
    options: dict[str, Any] = {
        "suites": [str(suite_file(p).resolve()) for p in suites], "out": str(out.resolve()),
        "database": str((db or database_path()).resolve()), "runs": runs, "seed": seed,
        "strategy": strategy, "engine": engine, "device": device,
        "workers": -1 if workers is None else workers, "cached": cached,
    }  # fmt: skip
    if cron is not None:
        return _serve(cron, options)
    nights = _once(options)
    if json:
        emit({"suites": nights, "regressed": [n["suite"] for n in nights if n["regressed"]]})
    else:
        print(describe(nights))
    if not all(n["run_id"] for n in nights):
        return 1
    return 3 if any(n["regressed"] for n in nights) else 0


def check_when(cron: str | None, once: bool) -> None:
    """Whether it is clear when to run.

    Raises:
        UserError: If both or neither of --cron and --once are given, or the expression is none.
    """
    from esg.outcomes import UserError

    if once == (cron is not None):
        raise UserError('give either --cron "0 3 * * *" or --once')
    if cron is not None:
        check_cron(cron)


def check_cron(text: str, after: datetime.datetime = _SOME_DAY) -> CronSim:
    """The times at which a cron expression fires.

    Args:
        text: Five fields.
        after: The times come after this one.

    Raises:
        UserError: If it is no such expression, or never fires.
    """
    from cronsim import CronSim, CronSimError

    from esg.outcomes import UserError

    reason = "it never fires"
    # The library takes a sixth field, for seconds, and numbers of any length.
    if len(text.split()) == FIELDS and len(text) <= MAX_CHARACTERS:
        try:
            next(CronSim(text, _SOME_DAY))
            return CronSim(text, after)
        except CronSimError as error:
            reason = str(error).lower()
        except StopIteration:
            pass
    elif len(text.split()) != FIELDS:
        reason = f"{len(text.split())} fields instead of five"
    else:
        reason = f"longer than {MAX_CHARACTERS} characters"
    raise UserError(
        f"--cron {text!r:.60}: {reason}; give minute, hour, day of month, month and day of week, "
        'e.g. "0 3 * * *" for every night at three (UTC)'
    )


def _once(options: dict[str, Any]) -> list[dict[str, Any]]:
    from esg.commands.console import note_first_use, progress
    from esg.metrics import load_suite
    from esg.pipeline import STAGES
    from esg.progress import StageEvent, listening

    note_first_use()
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
    """Serves the schedule: on the user's Prefect server if there is one, else by itself."""
    import os

    if os.environ.get("PREFECT_API_URL"):
        return _serve_on_server(cron, options)
    command = [sys.executable, "-m", "esg.cli", "serve", "--once", *arguments(options)]
    while True:
        following = next(check_cron(cron, datetime.datetime.now(datetime.UTC)))
        print(f"next run at {following:%Y-%m-%d %H:%M} UTC", flush=True)
        # In short steps: a clock that is set, or a machine that sleeps, must not lose a night.
        while datetime.datetime.now(datetime.UTC) < following:
            time.sleep(min(20.0, _seconds_until(following)))
        # A process a night: nothing of the last one is left in memory.
        with subprocess.Popen(command) as night:
            try:
                code = night.wait()
            except KeyboardInterrupt:
                night.terminate()  # SIGTERM reaches only this process
                raise
        print(f"ended with exit code {code}", flush=True)


def _seconds_until(moment: datetime.datetime) -> float:
    return max(0.1, (moment - datetime.datetime.now(datetime.UTC)).total_seconds())


def arguments(options: dict[str, Any]) -> list[str]:
    """The command-line arguments of a night that runs now."""
    out: list[str] = []
    for suite in options["suites"]:
        out += ["--suite", suite]
    for name in ("runs", "seed", "strategy", "engine", "device", "out"):
        out += [f"--{name}", str(options[name])]
    out += ["--db", options["database"]]
    if options["workers"] >= 0:
        out += ["--workers", str(options["workers"])]
    return [*out, "--cached"] if options["cached"] else out


def _serve_on_server(cron: str, options: dict[str, Any]) -> int:
    from flows.embedded import configure

    configure()
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
    from esg.fidelity import counted

    lines: list[str] = []
    for night in nights:
        row = night["summary"]
        lines.append(f"{night['suite']}: {night['verdict']}")
        if row.get("events") is not None and row.get("ecr_mean") is not None:
            lines.append(f"  events {row['ecr_mean']:.2f} of {row['events']}")
        lines.append(
            f"  {night['failed']} failed and {night['partial']} partial scene runs; "
            f"{night['folder']}"
        )
        if night["not_represented"]:
            lines.append(f"  most often not shown: {counted(night['not_represented'])}")
        if night["report"]:
            lines.append(f"  report: {night['report']}")
    return "\n".join(lines)
