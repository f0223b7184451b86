"""What a night leaves: scene folders, a row of history, a verdict, a report. No scheduler here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
import datetime
import json
from pathlib import Path
from typing import Any

from esg.fidelity import most_unseen
from esg.outcomes import Outcome
from esg.pipeline import SceneState, failures
from esg.stages import not_kept

_SHOWN = (
    "run_id", "started_at", "suite", "strategy", "engine", "runs", "events", "ecr_mean", "ecr_std",
    "slr", "ppa", "seconds_per_scene", "last_good", "last_good_ecr", "ecr_change", "slr_change",
    "ppa_change", "time_ratio", "regressed",
)  # fmt: skip


@dataclass(frozen=True)
class NightlyResult:
    """One suite of one night.

    Args:
        suite: Its name.
        run_id: Of its rows in the database; empty if they could not be recorded.
        folder: With the scene folders.
        summary: The run's row of view `bench_history`.
        regressed: Whether it is worse than the last good run (docs/sql.md).
        verdict: The same in words.
        failed: Number of scene runs that did not end well.
        partial: Number of scene runs that do not show all of their prompt.
        not_represented: The words that most often are not shown: words, status, scenes.
        report: Path of the report; empty if there is none.
    """

    suite: str
    run_id: str
    folder: str
    summary: dict[str, Any]
    regressed: bool
    verdict: str
    failed: int
    partial: int = 0
    not_represented: list[dict[str, Any]] = field(default_factory=list)
    report: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON."""
        return asdict(self)


def conclude_suite(
    states: Sequence[SceneState],
    suite: str,
    runs: int,
    out: Path,
    database: Path | None = None,
    now: datetime.datetime | None = None,
) -> NightlyResult:
    """Publishes, records, compares and reports a suite's finished scenes.

    Args:
        states: Final states, all runs of the first scene first.
        suite: Path of the suite.
        runs: Seeds a scene.
        out: Folder of all nights.
        database: The run database; default that of the command line.
        now: For the folder's name; default the clock.

    Raises:
        UserError: If the folder cannot be written.
    """
    from esg.failures import report_failures
    from esg.files import safe_name, write_json
    from esg.metrics import load_suite
    from esg.report.run import RUN_FILE
    from esg.runs import database_path, record_run, results
    from esg.scenefolder import publish

    loaded = load_suite(suite)
    request = states[0].request
    moment = now or datetime.datetime.now(datetime.UTC)
    folder = out / (safe_name(loaded.suite) or "suite") / f"{moment:%Y-%m-%dT%H%M%SZ}"
    folders = [publish(state, folder) for state in states]
    report_failures(states, folders, folder)
    document = results(loaded, list(states), runs, request.seed, request.strategy, request.engine)
    db = database or database_path()
    run_id = record_run(list(states), "bench", suite=loaded.suite, seeds=runs, database=database)
    write_json(folder / RUN_FILE, {"run_id": run_id, **document})
    summary = history_row(db, run_id) if run_id else {}
    return NightlyResult(
        suite=loaded.suite,
        run_id=run_id or "",
        folder=str(folder),
        summary=summary or {"suite": loaded.suite, **document["totals"]},
        regressed=bool(summary.get("regressed")),
        verdict=verdict(summary),
        failed=len(failures(states)),
        partial=sum(state.outcome is Outcome.PARTIAL for state in states),
        not_represented=most_unseen(not_kept(state) for state in states),
        report=_report(folder, db),
    )


def history_row(db: Path, run_id: str) -> dict[str, Any]:
    """A run's row of view `bench_history` as JSON values; empty if it has none."""
    from esg.store import query

    name = run_id.replace("'", "''")
    rows = query(db, f"SELECT * FROM bench_history WHERE run_id = '{name}'").dicts()
    if not rows:
        return {}
    return json.loads(json.dumps({k: rows[0].get(k) for k in _SHOWN}, default=str))


def verdict(row: dict[str, Any]) -> str:
    """What a row of `bench_history` says, in a sentence."""
    if not row:
        return "not recorded, so not compared"
    if not row["last_good"]:
        return "the first run of its kind: nothing to compare with"
    changes = [
        f"{label} {row[key]:+.3g}"
        for key, label in (("ecr_change", "events"), ("slr_change", "SLR"), ("ppa_change", "PPA"))
        if row[key] is not None
    ]
    word = "REGRESSED" if row["regressed"] else "no worse"
    return f"{word}: {', '.join(changes)} against {row['last_good']}"


def _report(folder: Path, db: Path) -> str:
    """The run's report; a report that cannot be written is no reason to fail the night."""
    try:
        from esg.report import load_run, write_report

        path = folder / "report.html"
        write_report(load_run(folder, database=db), path)
    except Exception as error:
        from esg.notices import warn

        warn([f"no report: {type(error).__name__}: {error}"])
        return ""
    return str(path)
