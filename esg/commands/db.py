"""`esg db`: rebuilding, filling and pruning the run database."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import App, Parameter

app = App(name="db", help="Rebuild, fill, prune and look after the run database.")

_Json = Annotated[bool, Parameter(negative="")]


@app.command
def rebuild(*folders: Path, db: Path | None = None, json: _Json = False) -> int:
    """Make the database anew from Parquet. The old one stays until the new one is whole.

    Args:
        folders: Folders of parts or datasets; default the parts beside the database.
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        json: Print one JSON document.
    """
    from esg.commands.console import emit
    from esg.runs import database_path
    from esg.store import rebuild as run

    path = db or database_path()
    report = run(path, list(folders) or [path.parent / "parts"])
    if json:
        emit({"database": str(path), "files": report.files, "rows": report.rows})
    else:
        print(f"{path}: {sum(report.rows.values())} rows of {report.files} files")
    return 0


@app.command
def ingest(*paths: Path, db: Path | None = None, json: _Json = False) -> int:
    """Add Parquet files, parts or datasets to the database; unchanged files are skipped.

    Args:
        paths: Files or folders.
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        json: Print one JSON document.
    """
    from esg.commands.console import emit
    from esg.outcomes import UserError
    from esg.runs import database_path
    from esg.store import ingest as run

    if not paths:
        raise UserError("give at least one Parquet file or folder")
    path = db or database_path()
    report = run(path, paths)
    if json:
        emit(
            {
                "database": str(path),
                "files": report.files,
                "unchanged": report.unchanged,
                "rows": report.rows,
            }
        )
    else:
        total = sum(report.rows.values())
        print(f"{path}: {total} rows of {report.files} files, {report.unchanged} files unchanged")
    return 0


@app.command
def verify(*folders: Path, db: Path | None = None, json: _Json = False) -> int:
    """Read all data with its checksums: the database, Parquet tables, recordings and rollouts.

    Removes what killed writers left there a day ago or earlier. The exit code is 3 if something is
    damaged; every such file is named with what makes it again.

    Args:
        folders: Folders of runs, parts or datasets; default that of the database.
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        json: Print one JSON document.
    """
    from esg.commands.console import emit
    from esg.runs import database_path
    from esg.store.verifying import verify as run

    path = db or database_path()
    found = run(path, list(folders) or [path.parent])
    if json:
        emit(
            {
                "files": found.files,
                "damaged": list(found.problems),
                "leftovers": found.leftovers,
            }
        )
    else:
        print("\n".join([f"{found.files} files, {len(found.problems)} damaged", *found.problems]))
    return 3 if found.problems else 0


@app.command
def prune(
    *,
    keep_days: float,
    db: Path | None = None,
    artifacts: Annotated[bool, Parameter(negative="")] = False,
    dry_run: Annotated[bool, Parameter(negative="")] = False,
    json: _Json = False,
) -> int:
    """Forget runs that are older than so many days, with their Parquet parts.

    A run that younger ones are compared with (the last good one) stays however old it is.

    Args:
        keep_days: Age in days up to which runs are kept.
        db: The run database; default $ESG_DB or runs/esg.duckdb.
        artifacts: Also delete stage results of that age from the cache, and what killed processes
            left there.
        dry_run: Only tell what would go.
        json: Print one JSON document.
    """
    from esg.api.inputs import in_range
    from esg.commands.console import emit
    from esg.runs import database_path
    from esg.store.artifacts import ArtifactStore
    from esg.store.retention import prune_runs

    in_range("--keep-days", keep_days, 0, 1e6)
    path = db or database_path()
    gone = prune_runs(path, keep_days, parts=path.parent / "parts", dry_run=dry_run)
    stages = 0
    if artifacts and not dry_run:
        store = ArtifactStore()
        stages = store.prune(keep_days * 86400.0)
        store.sweep()
    if json:
        emit(
            {
                "runs": list(gone.runs),
                "kept_as_standard": list(gone.kept_as_standard),
                "files": gone.files,
                "rows": gone.rows,
                "artifacts": stages,
                "dry_run": dry_run,
            }
        )
        return 0
    verb = "would go" if dry_run else "deleted"
    print(f"{len(gone.runs)} runs and {gone.files} files {verb}, {stages} stage results")
    for name in gone.kept_as_standard:
        print(f"  {name} stays: younger runs are compared with it")
    return 0
