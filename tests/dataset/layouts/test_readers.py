"""The canonical layout as other projects read it, and the readers that the page shows."""

from __future__ import annotations

from pathlib import Path
import re

import numpy as np
import pytest

PAGE = Path(__file__).parents[3] / "docs" / "dataset" / "layouts.md"


def shown(kind: str, word: str) -> str:
    """The first block of the page in a language that has a word."""
    blocks = re.findall(rf"```{kind}\n(.*?)```", PAGE.read_text("utf-8"), flags=re.S)
    return next(block for block in blocks if word in block)


def test_datasets_sees_pictures_and_films(whole, tmp_path):
    datasets = pytest.importorskip("datasets")
    clips = datasets.load_dataset(str(whole), "clips", split="train", cache_dir=str(tmp_path))
    assert isinstance(clips.features["video"], datasets.Video)
    plain = clips.cast_column("video", datasets.Video(decode=False))
    for row in plain:
        assert row["video"]["bytes"] == (whole / row["video"]["path"]).read_bytes()
        assert row["prompt"] and row["scene_id"] and row["camera"] in (0, 1)
    scenes = datasets.load_dataset(str(whole), "scenes", split="train", cache_dir=str(tmp_path))
    assert isinstance(scenes.features["preview"], datasets.Image)
    assert scenes[0]["preview"] is None
    metrics = datasets.load_dataset(str(whole), "metrics", split="train", cache_dir=str(tmp_path))
    assert {"impulse_ns": 1.0}.items() <= {
        m["name"]: m["value"] for m in metrics[0]["measured"]
    }.items()


def test_every_row_of_every_table_has_its_prompt(whole):
    duckdb = pytest.importorskip("duckdb")
    tables = {p.parent.name for p in whole.glob("*/*.parquet")} - {"runs"}
    assert {"scenes", "clips", "trajectories", "metrics", "statements"} <= tables
    for table in tables:
        sql = f"SELECT count(*), count(prompt) FROM '{whole}/{table}/*.parquet'"
        rows, prompts = duckdb.sql(sql).fetchall()[0]
        assert rows == prompts > 0, table


def test_the_readers_of_the_page_work(whole, monkeypatch):
    duckdb = pytest.importorskip("duckdb")
    folder = str(whole)
    sql = shown("sql", "unnest").replace("sets/balls", folder)
    assert len(duckdb.sql(sql).fetchall()) == 10 * 3
    polars = pytest.importorskip("polars")
    code = shown("python", "pl.scan_parquet").replace("sets/balls", folder)
    lazy = eval(code.split("\n\n")[1], {"pl": polars})  # the page's own line
    assert lazy.collect().height >= 10


def test_the_webdataset_reader_of_the_page_gives_metres(whole):
    pytest.importorskip("webdataset")
    from tests.dataset.clips.synthetic import FAR_M, NEAR_M

    found: dict[str, np.ndarray] = {}
    exec(shown("python", "wds.").replace("sets/balls", str(whole)), found)
    assert found["metres"].shape == (6, 24, 32)
    assert sorted({round(float(v), 1) for v in found["metres"].ravel()}) == [0.0, NEAR_M, FAR_M]


def test_the_movi_reader_of_the_page_gives_nested_samples(whole):
    found: dict[str, object] = {}
    exec(shown("python", "def load"), found)
    sample = found["load"](whole / "layouts/movi/train/0000001_camera_1.npz")  # type: ignore[operator]
    assert sample["video"].shape == (6, 24, 32, 3)
    assert sample["metadata"]["depth_range"].shape == (2,)
    assert sample["events"]["collisions"]["instances"].shape[1] == 2
