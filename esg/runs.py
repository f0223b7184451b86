"""What a run of many scenes comes to: its results, and its rows in the run database."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from esg.metrics.models import Suite
    from esg.pipeline import SceneState


def database_path() -> Path:
    """`$ESG_DB`, else `runs/esg.duckdb` in the current folder."""
    return Path(os.environ.get("ESG_DB") or Path("runs") / "esg.duckdb")


def record_run(
    states: list[SceneState],
    kind: str,
    *,
    suite: str = "",
    seeds: int = 1,
    database: Path | None = None,
) -> str | None:
    """Writes the Parquet part of a run and ingests it.

    The scenes are finished and stay whatever becomes of the database: the reason is told on stderr,
    and the Parquet part, if it was written, can be ingested later. A command whose run is not
    recorded ends with 1 (`exit_code`), or nobody would notice a night without a row.

    Args:
        states: Finished scenes of one run.
        kind: generate or bench.
        suite: Name of the suite.
        seeds: Seeds a scene.
        database: Default `database_path()`.

    Returns:
        Id of the run, None if it could not be recorded.
    """
    import datetime
    import hashlib
    import platform

    from esg import __version__
    from esg.codeversion import code_version
    from esg.files import safe_name
    from esg.notices import warn
    from esg.outcomes import UserError
    from esg.pipeline import STAGES
    from esg.stages import REPLAY_RATE_HZ
    from esg.store import RunInfo, ingest, record_of, write_tables

    now = datetime.datetime.now(datetime.UTC)
    request = states[0].request
    versions = "".join(code_version(stage) for stage in STAGES)
    title = "-".join(filter(None, (kind, safe_name(suite))))
    run = RunInfo(
        run_id=f"{title}-{now:%Y%m%dT%H%M%S%f}-{os.getpid()}",
        kind=kind,
        started_at=now,
        suite=suite,
        strategy=request.strategy,
        engine=request.engine,
        dt_s=1.0 / REPLAY_RATE_HZ,
        seeds=seeds,
        version=__version__,
        code_version=hashlib.sha256(versions.encode()).hexdigest()[:16],
        machine=f"{platform.machine()}, {os.cpu_count()} cores, {request.device}",
    )
    db = database or database_path()
    try:
        records = [record_of(state, run) for state in states]
        parts = write_tables(db.parent / "parts", records, name=run.run_id)
        ingest(db, parts.values())
    except (OSError, UserError) as error:
        why = f"{error.filename}: {error.strerror}" if isinstance(error, OSError) else str(error)
        warn([f"the run is not in the database {db}: {why}"])
        return None
    return run.run_id


def exit_code(states: list[SceneState], recorded: bool, *, strict: bool = False) -> int:
    """Of a command that made scenes: 1 if the run is not recorded, 3 if a scene failed, else 0.

    Args:
        states: Its scenes, ended.
        recorded: Whether their rows are in the run database.
        strict: Whether what is `partial` or not plausible counts as a failure.
    """
    from esg.pipeline import failures

    if not recorded:
        return 1
    return 3 if failures(states, strict=strict) else 0


def results(
    suite: Suite, states: list[SceneState], runs: int, seed: int, strategy: str, engine: str
) -> dict[str, Any]:
    """The document of `--json`.

    Args:
        suite: The suite.
        states: Final states, all runs of the first scene first.
        runs: Runs a scene.
        seed: Seed of the first run.
        strategy: Search strategy.
        engine: Engine of the replay.
    """
    from esg.metrics import SceneRun, bench_json
    from esg.stages import REPLAY_RATE_HZ, plausibility

    by_scene: dict[str, list[SceneRun]] = {}
    for k, scene in enumerate(suite.scenes):
        by_scene[scene.id] = [
            SceneRun(
                seed=seed + run,
                verdict=verdict_of(state),
                outcome=state.outcome.value if state.outcome else "crashed",
                seconds=round(state.seconds, 3),
                checks=(plausibility(state) or {}).get("checks", ()),
            )
            for run, state in enumerate(states[k * runs : (k + 1) * runs])
        ]
    return bench_json(suite, by_scene, strategy=strategy, engine=engine, dt=1 / REPLAY_RATE_HZ)


def verdict_of(state: SceneState) -> Any:
    """The judge's verdict of a scene, None if it did not come to that."""
    from esg.stages import load_verdict

    return load_verdict(state) if "judge" in state.artifacts else None
