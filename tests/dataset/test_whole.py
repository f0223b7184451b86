"""Real scenes, minutes long: kills, runners, and readers of other projects."""

from __future__ import annotations

import json
from pathlib import Path
import subprocess
import sys

import pytest

from benchmarks.resume import differences, files
import esg

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]


def make(out: Path, *more: str) -> Path:
    command = [sys.executable, "-m", "esg.cli", "dataset", "--out", str(out), *more]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 3), done.stderr
    return out


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("sets") / "small"
    return make(out, "--sample", "8", "--workers", "2", "--mcap", "sample")


def test_killed_three_times_equals_uninterrupted(tmp_path: Path) -> None:
    done = subprocess.run(
        [
            *(sys.executable, "-m", "benchmarks.resume", "--scenes", "8", "--kills", "3"),
            *("--shortest", "10", "--longest", "25", "--out", str(tmp_path)),
        ],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize(("runner", "package"), [("dask", "prefect_dask"), ("ray", "prefect_ray")])
def test_clusters_give_the_same_bytes(
    small: Path, tmp_path: Path, runner: str, package: str
) -> None:
    pytest.importorskip(package)
    other = make(
        tmp_path / runner, "--sample", "8", "--workers", "2", "--mcap", "sample", "--runner", runner
    )
    assert len(files(small)) > 10
    assert differences(small, other) == []


def test_scenes_searched_together_end_as_those_searched_alone(
    small: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As on a GPU, but on the CPU: outcomes are the same, losses to the last digits."""
    monkeypatch.setenv("ESG_SEARCH_TOGETHER", "1")
    other = make(tmp_path / "together", "--sample", "8", "--workers", "2", "--mcap", "sample")
    assert set(differences(small, other)) <= {
        f"differs: {name}" for name in files(small) if name.startswith(("scenes/", "mcap/"))
    }
    timings = json.loads((other / "meta" / "timings.json").read_bytes())
    assert timings["seconds"]["optimize"] > 0
    assert {"annotations", "meshes", "recordings", "overhead"} <= {*timings["seconds"]}
    assert timings["seconds"]["meshes"] > 0


def test_datasets_reads_every_table_and_split(small: Path) -> None:
    datasets = pytest.importorskip("datasets")
    for table in ("scenes", "trajectories", "metrics", "constraints", "coverage", "timings"):
        splits = datasets.load_dataset(str(small), table)
        assert sum(len(s) for s in splits.values()) >= 8
    row = datasets.load_dataset(str(small), "trajectories", split="train")[0]
    assert len(row["position_m"]) == 3 * row["n_frames"] * len(row["bodies"])


def test_python_reads_it(small: Path) -> None:
    found = esg.load_dataset(small)
    assert len(found) == 8
    assert {"scenes", "trajectories"} <= set(found.tables)
    assert all(row["prompt"] for row in found.rows())


def test_polars_and_duckdb_read_it(small: Path) -> None:
    import duckdb

    pattern = str(small / "scenes" / "*.parquet")
    assert duckdb.sql(f"SELECT count(*) FROM '{pattern}'").fetchall() == [(8,)]
    polars = pytest.importorskip("polars")
    assert polars.scan_parquet(pattern).select("prompt").collect().height == 8
