"""A dataset of a million scenes, on paper real in everything but its physics: rows, parts, marks.

    python -m benchmarks.scale --scenes 1000000 --folder /big/disk
    python -m benchmarks.scale --scenes 20000            # a minute

Makes the folder of a dataset whose batches are done (plan, parts of six tables, marks) with values
drawn at random, and then uses it for real: plans a batch, finds a part that was lost, takes all
rows into a database, asks ten usual questions of it and of the Parquet files as they lie, puts the
parts together and writes the card. docs/scale.md has the figures.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator
import contextlib
from dataclasses import replace
import json
from pathlib import Path
import tempfile
import time
from typing import Any

import numpy as np

from benchmarks.store import table
from esg.dataset.finish import describe
from esg.dataset.folder import DatasetFolder, write_mark
from esg.dataset.job import BatchResult, batch_name
from esg.dataset.plan import DatasetSpec, PlannedScene, plan_batch
from esg.dataset.running import SCENE_STAGES
from esg.store.assembling import assemble_tables
from esg.store.db import query
from esg.store.ingesting import ingest
from esg.store.records import RunInfo
from esg.store.tables import to_table, write_part

EVENTS, CONSTRAINTS, STATEMENTS, WORDS = 3, 1, 2, 6
"""Rows a scene of their tables: about those of a sampled dataset."""
ROWS = 1 + EVENTS + CONSTRAINTS + STATEMENTS + WORDS + len(SCENE_STAGES)
QUESTIONS = {
    "outcomes": "SELECT outcome, count(*) FROM scenes GROUP BY 1 ORDER BY 2 DESC",
    "share verified by rule": "SELECT rule, avg(verified::int) FROM scenes GROUP BY 1 ORDER BY 2",
    "splits": "SELECT split, count(*), avg(verified::int) FROM scenes GROUP BY 1",
    "events by type": "SELECT event_type, count(*), avg(completed::int) FROM metrics GROUP BY 1",
    "when events happen": "SELECT event_type, quantile_cont(time_s, [0.1, 0.5, 0.9]) FROM metrics "
    "GROUP BY 1",
    "worst constraints": "SELECT scene_key, error FROM constraints ORDER BY error DESC LIMIT 20",
    "seconds by stage": "SELECT stage, sum(seconds), avg(cached::int) FROM timings GROUP BY 1",
    "statements kept": "SELECT says, count(*), avg(kept::int) FROM statements GROUP BY 1",
    "words not understood": "SELECT text, count(*) FROM coverage WHERE status <> 'used' "
    "GROUP BY 1 ORDER BY 2 DESC LIMIT 20",
    "one scene": "SELECT * FROM scenes WHERE scene_id = '{scene}'",
}
TABLES = ("scenes", "metrics", "constraints", "statements", "timings", "coverage")


def batch_tables(
    run: RunInfo, scenes: tuple[PlannedScene, ...], rng: np.random.Generator
) -> dict[str, Any]:
    """Rows of a batch, as a batch of real scenes has them."""
    n = len(scenes)
    keys = [f"{run.run_id}/{s.scene_id}/{s.request.seed}" for s in scenes]

    def common(repeat: int) -> dict[str, Any]:
        own = {
            "scene_key": keys,
            "scene_id": [s.scene_id for s in scenes],
            "seed": [s.request.seed for s in scenes],
            "prompt": [s.request.prompt for s in scenes],
        }
        shared = {"run_id": run.run_id, "suite": "", "strategy": "batched", "engine": "physx"}
        size = n * repeat
        return {k: np.repeat(v, repeat) for k, v in own.items()} | {
            k: [v] * size for k, v in shared.items()
        }

    done = rng.random(n) < 0.96
    return {
        "scenes": common(1)
        | {
            "split": [s.split for s in scenes],
            "family": [s.family for s in scenes],
            "level": [s.level for s in scenes],
            "rule": [s.rule for s in scenes],
            "outcome": np.where(done, "solved", "not_converged"),
            "verified": done,
            "slr": np.ones(n, bool),
            "n_events": np.full(n, EVENTS),
            "n_completed": np.where(done, EVENTS, EVENTS - 1),
            "seconds": rng.random(n),
        },
        "metrics": common(EVENTS)
        | {
            "event_id": np.tile([f"e{i}" for i in range(EVENTS)], n),
            "event_index": np.tile(range(EVENTS), n),
            "event_type": rng.choice(["collision", "falls", "topples"], EVENTS * n),
            "completed": np.repeat(done, EVENTS),
            "time_s": 5 * rng.random(EVENTS * n),
            "measured": [[]] * (EVENTS * n),
        },
        "constraints": common(CONSTRAINTS)
        | {
            "constraint_index": np.zeros(n, int),
            "constraint": ["time e1"] * n,
            "error": rng.random(n),
            "score": rng.random(n),
            "quantity": ["time"] * n,
        },
        "statements": common(STATEMENTS)
        | {
            "statement_id": np.tile([f"s{i}" for i in range(STATEMENTS)], n),
            "statement_index": np.tile(range(STATEMENTS), n),
            "source": ["document"] * (STATEMENTS * n),
            "says": rng.choice(["moves", "supported_by", "rolls"], STATEMENTS * n),
            "kept": rng.random(STATEMENTS * n) < 0.97,
            "measured": [[]] * (STATEMENTS * n),
        },
        "timings": common(len(SCENE_STAGES))
        | {
            "stage": np.tile(SCENE_STAGES, n),
            "stage_index": np.tile(range(len(SCENE_STAGES)), n),
            "seconds": rng.random(len(SCENE_STAGES) * n),
            "cached": np.zeros(len(SCENE_STAGES) * n, bool),
        },
        "coverage": common(WORDS)
        | {
            "item_index": np.tile(range(WORDS), n),
            "text": [f"word{i}" for i in rng.integers(0, 300, WORDS * n)],
            "status": rng.choice(["used", "ignored"], WORDS * n, p=[0.95, 0.05]),
        },
    }


def make(folder: DatasetFolder, spec: DatasetSpec, every: int) -> None:
    """Writes plan, parts and marks; of every so many batches one is planned, the rest repeat it."""
    run = folder.begin(spec, [], resume=False)
    planned: tuple[PlannedScene, ...] = ()
    for number in range(spec.n_batches):
        first = number * spec.batch_size
        if number % every == 0:
            planned = plan_batch(spec, number)
        scenes = tuple(_moved(s, first + k) for k, s in enumerate(planned) if first + k < spec.n)
        files: dict[str, int] = {}
        rows = batch_tables(run, scenes, np.random.default_rng([7, number]))
        for name, columns in rows.items():
            path = folder.path / "parts" / name / f"{batch_name(number)}.parquet"
            write_part(table(name, columns, len(columns["run_id"])), path)
            files[path.relative_to(folder.path).as_posix()] = path.stat().st_size
        write_mark(
            folder.path,
            BatchResult(number, len(scenes), len(scenes), {"solved": len(scenes)}, files=files),
        )


def _moved(scene: PlannedScene, index: int) -> PlannedScene:
    return replace(scene, index=index, scene_id=f"{index:07d}-{scene.rule}")


@contextlib.contextmanager
def told(found: dict[str, Any], name: str) -> Iterator[None]:
    """Notes and prints the seconds, and those of cores, of what is done inside."""
    start, cores = time.perf_counter(), time.process_time()
    yield
    found[name] = round(time.perf_counter() - start, 3)
    found[f"{name}, cores"] = round(time.process_time() - cores, 3)
    print(f"{name:32} {found[name]:9.3f} s, cores {found[f'{name}, cores']:9.3f} s", flush=True)


def fastest(ask: Callable[[], Any]) -> float:
    """The shortest of three times [s]."""
    times: list[float] = []
    for _ in range(3):
        start = time.perf_counter()
        ask()
        times.append(time.perf_counter() - start)
    return round(min(times), 3)


def answers(db: Path, scene: str) -> dict[str, float]:
    """Seconds of the ten questions, by name."""
    out: dict[str, float] = {}
    for name, text in QUESTIONS.items():
        sql = text.format(scene=scene)
        out[name] = fastest(lambda sql=sql: query(db, sql).rows)
    return out


def in_place(parts: Path, scene: str) -> dict[str, float]:
    """The same, of the Parquet files as they lie: nothing is copied."""
    import duckdb

    base = duckdb.connect()
    for name in TABLES:
        base.execute(f"CREATE VIEW {name} AS FROM read_parquet('{parts / name}/*.parquet')")
    return {
        name: fastest(lambda text=text: base.execute(text.format(scene=scene)).fetchall())
        for name, text in QUESTIONS.items()
    }


def measure(root: Path, n: int, batch: int, every: int) -> dict[str, Any]:
    """Makes the dataset and uses it; seconds by what was done."""
    spec = DatasetSpec(source="sample", n=n, batch=batch)
    folder, found = DatasetFolder(root / "dataset"), dict[str, Any]()
    found["scenes"], found["batches"], found["rows"] = n, spec.n_batches, n * ROWS
    with told(found, "plan of the last batch"):
        last = plan_batch(spec, spec.n_batches - 1)
    with told(found, "made"):
        make(folder, spec, every)
    size = sum(p.stat().st_size for p in folder.path.rglob("*.parquet"))
    found["parquet_bytes_a_scene"] = round(size / n)
    (folder.path / "parts" / "metrics" / f"{batch_name(spec.n_batches // 2)}.parquet").unlink()
    with told(found, "lost part found and planned"):
        done = folder.done(range(spec.n_batches))
        lost = [b for b in range(spec.n_batches) if b not in done]
        again = plan_batch(spec, lost[0])
    assert lost == [spec.n_batches // 2] and len(again) == batch
    make_again(folder, spec, lost[0], again)
    db = root / "results.duckdb"
    with told(found, "ingested"):
        report = ingest(db, [folder.path / "parts" / name for name in TABLES])
    found["ingested_rows_a_second"] = round(sum(report.rows.values()) / found["ingested"])
    found["database_bytes_a_scene"] = round(db.stat().st_size / n)
    found["questions_database_s"] = answers(db, last[-1].scene_id)
    found["questions_in_place_s"] = in_place(folder.path / "parts", last[-1].scene_id)
    with told(found, "put together"):
        write_part(
            to_table("runs", [folder.run().row()]),
            folder.path / "parts" / "runs" / "run.parquet",
        )
        counts = assemble_tables(folder.path / "parts", folder.path)
    files = [p for t in TABLES for p in (folder.path / t).glob("*.parquet")]
    found["files_put_together"] = len(files)
    with told(found, "card"):
        describe(folder.path, spec, spec.name(), counts, [])
    return found


def make_again(
    folder: DatasetFolder, spec: DatasetSpec, number: int, scenes: tuple[PlannedScene, ...]
) -> None:
    """The lost batch, so that the rest has all rows."""
    rows = batch_tables(folder.run(), scenes, np.random.default_rng([7, number]))["metrics"]
    path = folder.path / "parts" / "metrics" / f"{batch_name(number)}.parquet"
    write_part(table("metrics", rows, len(rows["run_id"])), path)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--scenes", type=int, default=20_000)
    parser.add_argument("--batch", type=int, default=1000)
    parser.add_argument("--every", type=int, default=10, help="of so many batches one is planned")
    parser.add_argument("--folder", type=Path, help="default a temporary one")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=args.folder) as root:
        found = measure(Path(root), args.scenes, args.batch, args.every)
    print(json.dumps(found, indent=1))
    if args.json:
        args.json.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
