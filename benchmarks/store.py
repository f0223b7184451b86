"""How fast results are ingested and views answer: 100,000 scene runs, a million metric rows.

    python -m benchmarks.store [FOLDER]

Target: a million metric rows in under 10 s, every view in under 0.5 s.
"""

from __future__ import annotations

import datetime
from pathlib import Path
import sys
import tempfile
import time
from typing import Any

import numpy as np
import pyarrow as pa

from esg.store.db import query
from esg.store.ingesting import ingest
from esg.store.tables import arrow_schema, to_table, write_part

SCENES, EVENTS, RUNS = 100_000, 10, 40
STAGES = (
    "draft", "resolve", "cast", "layout", "optimize", "compile", "replay", "judge", "dress",
    "record",
)  # fmt: skip
VIEWS = (
    "bench_summary", "bench_history", "scene_outcomes", "event_timings", "constraint_errors",
    "engine_transfer", "cost_per_stage", "coverage_gaps",
)  # fmt: skip


def table(name: str, columns: dict[str, Any], rows: int) -> pa.Table:
    """A table with the given columns and nulls elsewhere."""
    schema = arrow_schema(name)
    arrays = [
        pa.array(columns[f.name], f.type) if f.name in columns else pa.nulls(rows, f.type)
        for f in schema
    ]
    return pa.Table.from_arrays(arrays, schema=schema)


def make(folder: Path) -> None:
    """Writes the parts: 40 nightly runs of 500 scenes with 5 seeds."""
    rng = np.random.default_rng(0)
    run = np.repeat(np.arange(RUNS), SCENES // RUNS)
    scene = np.tile(np.arange(500), SCENES // 500)
    seed = np.tile(np.repeat(np.arange(5), 500), SCENES // 2500)
    names = np.array([f"run-{r:02d}" for r in run])
    keys = np.array([f"run-{r:02d}/big/S{s}/{d}" for r, s, d in zip(run, scene, seed, strict=True)])
    ids = np.array([f"S{s}" for s in scene])

    def common(repeat: int) -> dict[str, Any]:
        columns = {"run_id": names, "scene_key": keys, "scene_id": ids, "seed": seed}
        out = {k: np.repeat(v, repeat) for k, v in columns.items()}
        same = {"suite": "big", "strategy": "batched", "engine": "physx"}
        return {**out, **{k: [v] * (SCENES * repeat) for k, v in same.items()}}

    start = datetime.datetime(2026, 1, 1, tzinfo=datetime.UTC)
    runs = [
        {"run_id": f"run-{r:02d}", "suite": "big", "strategy": "batched", "engine": "physx",
         "started_at": start + datetime.timedelta(days=r)}
        for r in range(RUNS)
    ]  # fmt: skip
    write_part(to_table("runs", runs), folder / "runs" / "all.parquet")
    done = rng.integers(EVENTS - 2, EVENTS + 1, SCENES)
    data = {
        "scenes": {
            **common(1), "n_events": np.full(SCENES, EVENTS), "n_completed": done,
            "slr": rng.random(SCENES) < 0.97, "verified": done == EVENTS,
            "outcome": np.where(done == EVENTS, "solved", "not_converged"),
            "seconds": rng.random(SCENES), "prompt": ids,
        },
        "metrics": {
            **common(EVENTS), "event_id": np.tile([f"e{i}" for i in range(EVENTS)], SCENES),
            "event_type": ["collision"] * (SCENES * EVENTS),
            "completed": rng.random(SCENES * EVENTS) < 0.9,
            "time_s": rng.random(SCENES * EVENTS), "measured": [[]] * (SCENES * EVENTS),
        },
        "constraints": {
            **common(2), "constraint_index": np.tile([0, 1], SCENES),
            "constraint": ["time e1"] * (2 * SCENES), "error": rng.random(2 * SCENES),
            "score": rng.random(2 * SCENES), "score_strict": rng.random(2 * SCENES),
            "score_lenient": rng.random(2 * SCENES),
        },
        "timings": {
            **common(len(STAGES)), "stage": np.tile(STAGES, SCENES),
            "stage_index": np.tile(range(len(STAGES)), SCENES),
            "seconds": rng.random(len(STAGES) * SCENES),
            "cached": rng.random(len(STAGES) * SCENES) < 0.3,
        },
        "coverage": {
            **common(8), "item_index": np.tile(range(8), SCENES),
            "text": [f"word{i}" for i in rng.integers(0, 300, 8 * SCENES)],
            "status": rng.choice(["used", "ignored"], 8 * SCENES, p=[0.95, 0.05]),
        },
    }  # fmt: skip
    for name, columns in data.items():
        whole = table(name, columns, len(columns["run_id"]))
        step = -(-whole.num_rows // 20)
        for k in range(20):
            path = folder / name / f"part-{k:03d}.parquet"
            write_part(whole.slice(k * step, step), path)


def main(folder: Path) -> None:
    make(folder)
    db = folder / "results.duckdb"
    for name in ("metrics", "runs", "scenes", "constraints", "timings", "coverage"):
        start = time.perf_counter()
        report = ingest(db, [folder / name], force=True)
        print(f"ingest {name:12} {report.rows[name]:>9} rows {time.perf_counter() - start:6.2f} s")
    start = time.perf_counter()
    ingest(db, [folder / "metrics"], force=True)
    print(f"ingest metrics again {time.perf_counter() - start:6.2f} s")
    print(f"database {db.stat().st_size / 2**20:.0f} MiB")
    for view in VIEWS:
        times: list[float] = []
        for _ in range(3):
            start = time.perf_counter()
            rows = len(query(db, f"FROM {view}").rows)
            times.append(time.perf_counter() - start)
        print(f"{view:18} {rows:>6} rows {min(times):6.3f} s")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with tempfile.TemporaryDirectory() as name:
            main(Path(name))
