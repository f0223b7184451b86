"""Parquet parts, splits, datasets."""

from __future__ import annotations

import errno
import json
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pyarrow as pa
import pytest

from esg import files
from esg.outcomes import UserError
from esg.store.assembling import assemble
from esg.store.checking import check_footer, content_digest
from esg.store.columns import arrow_type
from esg.store.records import prompt_family, split_of
from esg.store.tables import (
    COLUMNS,
    KEYS,
    TABLES,
    arrow_schema,
    iter_rows,
    part_files,
    read_table,
    table_of,
    to_table,
    write_tables,
)
from tests.store.samples import record, records, run_info


def bytes_below(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes()
        for p in sorted(folder.rglob("*"))
        if p.is_file()
    }


@pytest.mark.parametrize("table", TABLES)
def test_keys_are_required_columns(table):
    schema = arrow_schema(table)
    assert set(KEYS[table]) <= set(COLUMNS[table])
    assert all(not schema.field(k).nullable for k in KEYS[table])
    assert schema.metadata[b"esg.table"] == table.encode()


def test_parts_hold_what_was_recorded(tmp_path):
    paths = write_tables(tmp_path, records(run_info()), name="part-000")
    assert set(paths) == set(TABLES)
    assert {t: read_table(p).num_rows for t, p in paths.items()} == {
        "runs": 1, "scenes": 6, "trajectories": 6, "metrics": 12, "constraints": 12,
        "coverage": 12, "timings": 12, "statements": 18,
        "plausibility_checks": 12, "clips": 6, "truth_checks": 6, "captions": 6, "questions": 6,
        "engine_events": 6, "what_ifs": 6, "meshes": 6,
    }  # fmt: skip
    scene = read_table(paths["scenes"]).to_pylist()[0]
    assert (scene["scene_key"], scene["n_events"]) == ("run-1/paper/S1/0", 2)
    assert scene["seconds"] == 2.0
    metric = read_table(paths["metrics"]).to_pylist()[0]
    assert metric["time_s"] == pytest.approx(0.4)
    assert {"name": "impulse_ns", "value": 1.0} in metric["measured"]
    assert metric["prompt"] == scene["prompt"] != ""


def test_trajectories_can_be_reshaped(tmp_path):
    run = run_info()
    paths = write_tables(tmp_path, [record(run, "S1", 0)], name="p")
    row = read_table(paths["trajectories"]).to_pylist()[0]
    shape = (row["n_frames"], len(row["bodies"]), 3)
    position = np.array(row["position_m"], np.float32).reshape(shape)
    assert row["bodies"] == ["ball_1", "ball_2", "ball_3"]
    assert position[-1, 0, 0] == pytest.approx(0.8)
    assert row["fps"] == pytest.approx(240.0)
    assert row["contact_a"] == [0, 1]


def test_types_nest():
    kind = arrow_type(
        "list<struct<id: string, at: struct<x: float32, y: float32>, tags: list<string>>>"
    )
    at = pa.struct([("x", pa.float32()), ("y", pa.float32())])
    assert kind == pa.list_(
        pa.struct([("id", pa.string()), ("at", at), ("tags", pa.list_(pa.string()))])
    )
    assert arrow_type("image") == pa.struct([("bytes", pa.binary()), ("path", pa.string())])
    with pytest.raises(ValueError):
        arrow_type("list<colour>")


@pytest.mark.parametrize(
    "other",
    [
        [{"a": 1.0, "b": ["x"]}],  # a number
        [{"a": 2.0, "b": ["y"]}],  # a text within
        [{"a": 2.0, "b": None}],
        [None],
        None,
    ],
)
def test_the_digest_knows_what_structs_hold(other):
    kind = arrow_type("list<struct<a: float64, b: list<string>>>")
    first = pa.table({"v": pa.array([[{"a": 2.0, "b": ["x"]}]], kind)})
    assert content_digest(first) != content_digest(pa.table({"v": pa.array([other], kind)}))


def test_a_footer_that_was_touched_is_told_before_it_is_parsed(tmp_path):
    path = write_tables(tmp_path, [record(run_info(), "S1", 0)], name="p")["metrics"]
    whole = path.read_bytes()
    check_footer(path)
    place = whole.index(b"ESGFOOT1")
    assert path.stat().st_size - place > 200
    for at in range(place + 8, len(whole), 7):
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1 :])
        with pytest.raises(UserError, match="damaged"):
            read_table(path)


def test_unknown_columns_are_refused():
    with pytest.raises(ValueError, match="no columns"):
        to_table("runs", [{"run_id": "x", "speed": 1}])


def test_files_are_compressed_in_row_groups_of_a_hundred_scenes(tmp_path):
    import pyarrow.parquet as pq

    run = run_info()
    base = record(run, "S1", 0).rows["scenes"][0]
    rows = [{**base, "scene_key": f"k{i:04d}"} for i in range(250)]
    from esg.store.tables import write_part

    write_part(to_table("scenes", rows), tmp_path / "a.parquet")
    with pq.ParquetFile(tmp_path / "a.parquet") as file:
        assert [file.metadata.row_group(i).num_rows for i in range(3)] == [100, 100, 50]
        assert file.metadata.row_group(0).column(0).compression == "ZSTD"


def test_a_dataset_does_not_depend_on_how_parts_were_dealt(tmp_path):
    run = run_info()
    items = records(run, scenes=6)
    write_tables(tmp_path / "one", items, name="all")
    for k, item in enumerate(reversed(items)):
        write_tables(tmp_path / "many", [item], name=f"part-{k:03d}")
    # A part written twice (a resumed worker) changes nothing.
    write_tables(tmp_path / "many", items[:2], name="again")
    first = assemble(tmp_path / "one", tmp_path / "a", scenes_per_file=2)
    second = assemble(tmp_path / "many", tmp_path / "b", scenes_per_file=2)
    assert first == second
    assert bytes_below(tmp_path / "a") == bytes_below(tmp_path / "b")


def test_dataset_layout_info_and_card(tmp_path):
    write_tables(tmp_path / "parts", records(run_info(), scenes=12), name="p")
    out = tmp_path / "out"
    counts = assemble(tmp_path / "parts", out, title="test set", scenes_per_file=5)
    names = [p.name for p in part_files(out, "scenes")]
    trains = [n for n in names if n.startswith("train-")]
    assert trains[0] == f"train-00000-of-{len(trains):05d}.parquet"
    info = json.loads((out / "meta" / "info.json").read_text())
    assert info["format_version"] == "2.0.0"
    assert info["rows"] == counts
    assert sum(info["scenes_per_split"].values()) == 24
    card = (out / "README.md").read_text()
    assert card.startswith("---\n")
    assert "config_name: scenes" in card
    assert "path: scenes/train-*.parquet" in card
    assert not list(out.rglob("*.tmp"))


def test_no_family_is_in_two_splits(tmp_path):
    write_tables(tmp_path / "parts", records(run_info(), scenes=12), name="p")
    assemble(tmp_path / "parts", tmp_path / "out")
    where: dict[str, set[str]] = {}
    for path in part_files(tmp_path / "out", "scenes"):
        for row in read_table(path).to_pylist():
            where.setdefault(row["family"], set()).add(path.name.split("-")[0])
    assert all(len(splits) == 1 for splits in where.values())
    # All tables of a scene are in the scene's split.
    for path in part_files(tmp_path / "out", "metrics"):
        keys = set(read_table(path)["scene_key"].to_pylist())
        scenes = tmp_path / "out" / "scenes"
        split = path.name.split("-")[0]
        same = {
            k for p in scenes.glob(f"{split}-*") for k in read_table(p)["scene_key"].to_pylist()
        }
        assert keys <= same


def test_family_forgets_numbers_and_articles():
    a = prompt_family("A car hits the jeep after 3 seconds at 10.5 m/s.")
    assert a == prompt_family("a car hits a Jeep after 12 seconds at 7 m/s")
    assert a != prompt_family("a car hits a truck after 12 seconds at 7 m/s")


@given(st.text(max_size=60))
def test_every_prompt_has_a_family_and_a_split(text):
    family = prompt_family(text)
    assert prompt_family(family) == family
    assert split_of(family) in ("train", "validation", "test")


def test_splits_are_about_eight_one_one():
    counts = {"train": 0, "validation": 0, "test": 0}
    for k in range(4000):
        counts[split_of(f"family {k}")] += 1
    assert counts["train"] == pytest.approx(3200, rel=0.05)
    assert counts["test"] == pytest.approx(400, rel=0.2)


def test_truncated_and_foreign_files_are_named(tmp_path):
    path = write_tables(tmp_path, [record(run_info(), "S1", 0)], name="p")["scenes"]
    whole = path.read_bytes()
    for size in (0, 10, len(whole) // 2, len(whole) - 4):
        path.write_bytes(whole[:size])
        with pytest.raises(UserError, match=r"p\.parquet is damaged"):
            read_table(path)
    with pytest.raises(UserError, match="damaged"):
        assemble(tmp_path, tmp_path / "out")
    import pyarrow as pa
    import pyarrow.parquet as pq

    pq.write_table(pa.table({"x": [1]}), tmp_path / "x.parquet")
    with pytest.raises(UserError, match="not a table of this project"):
        table_of(tmp_path / "x.parquet")
    with pytest.raises(UserError, match="does not exist"):
        table_of(tmp_path / "y.parquet")


def test_damaged_pages_are_noticed(tmp_path):
    path = write_tables(tmp_path, [record(run_info(), "S1", 0)], name="p")["trajectories"]
    data = bytearray(path.read_bytes())
    data[200:2000] = bytes(1800)
    path.write_bytes(data)
    with pytest.raises(UserError, match="damaged"):
        read_table(path)


def test_full_disk_leaves_no_part(tmp_path, monkeypatch):
    def full(path: Path) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(path))

    monkeypatch.setattr(files, "sync_file", full)
    with pytest.raises(OSError, match="free some space"):
        write_tables(tmp_path, [record(run_info(), "S1", 0)], name="p")
    assert not [p for p in tmp_path.rglob("*") if p.is_file()]


def test_unfinished_parts_are_not_read(tmp_path):
    write_tables(tmp_path, [record(run_info(), "S1", 0)], name="p")
    (tmp_path / "scenes" / ".q.parquet.123-abc.tmp").write_bytes(b"half")
    assert [p.name for p in part_files(tmp_path, "scenes")] == ["p.parquet"]
    assert files.sweep(tmp_path / "scenes", older_than_s=-1) == 1


@pytest.mark.parametrize("name", ["run:1", "s3:x", "{a,b} [1] é", "-x"])
def test_a_relative_folder_is_no_url(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    paths = write_tables(Path(name), [record(run_info(), "S1", 0)], name="p")
    assert {t: read_table(p).num_rows for t, p in paths.items()}["metrics"] == 2
    assert [r["scene_key"] for r in iter_rows([paths["scenes"]])] == ["run-1/paper/S1/0"]
