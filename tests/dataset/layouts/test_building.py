"""Layouts of a finished dataset: written, resumed, renewed, refused."""

from __future__ import annotations

import json
from pathlib import Path
import shutil

import pytest

from esg.dataset.layouts import building
from esg.dataset.layouts.building import add_layouts, missing_layouts, want_layouts
from esg.dataset.layouts.registry import LAYOUTS, chosen
from esg.dataset.layouts.source import Source
from esg.outcomes import UserError
from esg.store.verifying import verify
from tests.dataset.layouts.sets import make_set


@pytest.fixture
def copy(whole: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(whole, tmp_path / "copy"))


def below(folder: Path) -> dict[str, bytes]:
    return {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    }


def test_names_are_checked_and_the_canonical_one_is_no_news():
    assert chosen("parquet") == ()
    assert chosen(" movi,webdataset,movi,Parquet") == ("webdataset", "movi")
    with pytest.raises(UserError, match="there is no layout 'tfrecord', 'zarr'; choose of parquet"):
        chosen("zarr,webdataset,tfrecord")
    with pytest.raises(UserError):
        chosen("")


def test_clips_come_in_the_order_of_scenes_with_what_is_known_of_them(whole):
    found = list(Source(whole).samples("train", ("metrics",)))
    assert [s.key for s in found] == [f"{k:07d}_camera_{c}" for k in range(3) for c in range(2)]
    assert [len(s.more["metrics"]) for s in found] == [2] * 6
    assert all(s.scene["scene_key"] == s.clip.record.scene_key for s in found)
    assert {r["scene_key"] for s in found for r in s.more["metrics"]} == {
        s.scene["scene_key"] for s in found
    }


@pytest.mark.parametrize("name", LAYOUTS)
def test_equal_datasets_have_equal_layouts(name, whole, tmp_path):
    other = make_set(tmp_path / "other")
    add_layouts(other, [name], print)
    first, second = (below(out / "layouts" / name) for out in (whole, other))
    assert first == second
    assert set(json.loads(first["layout.json"])["files"]) == set(first) - {"layout.json"}


@pytest.mark.parametrize("name", LAYOUTS)
def test_an_interrupted_layout_goes_on_after_its_last_whole_file(name, copy, whole, monkeypatch):
    folder = copy / "layouts" / name
    names = list(json.loads((folder / "layout.json").read_text())["files"])
    shutil.rmtree(folder)
    written: list[str] = []
    real = building.atomic_write

    def dying(path, write):
        if len(written) == len(names) // 2:
            path.parent.mkdir(parents=True, exist_ok=True)
            (path.parent / f".{path.name}.1.tmp").write_bytes(b"half")
            raise KeyboardInterrupt
        written.append(path.name)
        real(path, write)

    monkeypatch.setattr(building, "atomic_write", dying)
    with pytest.raises(KeyboardInterrupt):
        add_layouts(copy, [name], print)
    assert missing_layouts(copy, [name]) == [name]
    assert not (folder / "layout.json").exists()
    again: list[str] = []
    monkeypatch.setattr(building, "atomic_write", lambda p, w: (again.append(p.name), real(p, w)))
    assert add_layouts(copy, [name], print) == [name]
    assert len(again) == len(names) - len(names) // 2
    assert below(folder) == below(whole / "layouts" / name)


def test_a_layout_that_is_there_is_left_alone(copy):
    before = {p: p.stat().st_mtime_ns for p in (copy / "layouts").rglob("*")}
    assert add_layouts(copy, LAYOUTS, print) == []
    assert before == {p: p.stat().st_mtime_ns for p in (copy / "layouts").rglob("*")}


def test_a_layout_of_other_content_is_written_anew(copy):
    next((copy / "clips").glob("test-*.parquet")).unlink()
    (copy / "layouts" / "webdataset" / "old.tar").write_bytes(b"")
    assert missing_layouts(copy, LAYOUTS) == list(LAYOUTS)
    add_layouts(copy, ["webdataset"], print)
    names = {p.name for p in (copy / "layouts" / "webdataset").iterdir()}
    assert names == {"train-000000.tar", "validation-000000.tar", "layout.json"}


def test_what_was_asked_for_is_remembered(tmp_path):
    assert want_layouts(tmp_path, ["movi"]) == ("movi",)
    assert want_layouts(tmp_path, ["webdataset"]) == ("webdataset", "movi")
    assert want_layouts(tmp_path, []) == ("webdataset", "movi")


def test_a_dataset_without_clips_has_no_such_layouts(tmp_path):
    out = make_set(tmp_path / "set", rendered=False)
    with pytest.raises(UserError, match="has none; render them with --render"):
        add_layouts(out, ["webdataset"], print)
    assert not (out / "layouts").exists()


def test_a_full_disk_is_told_and_what_is_whole_stays(copy, monkeypatch):
    shutil.rmtree(copy / "layouts" / "webdataset")
    real = building.atomic_write

    def full(path, write):
        if path.name.startswith("test"):
            raise OSError(28, "No space left on device", str(path))
        real(path, write)

    monkeypatch.setattr(building, "atomic_write", full)
    with pytest.raises(UserError, match="No space left on device; the dataset is complete") as told:
        add_layouts(copy, ["webdataset"], print)
    assert told.value.exit_code == 1
    names = {p.name for p in (copy / "layouts" / "webdataset").iterdir() if p.name[0] != "."}
    assert names == {"train-000000.tar", "validation-000000.tar"}


def test_verification_knows_the_files_of_layouts(copy):
    """They are other projects' formats, whose files have no checksums of ours."""
    assert verify(None, [copy]).problems == ()
    path = copy / "layouts" / "movi" / "test" / "0000004_camera_1.npz"
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)
    (problem,) = verify(None, [copy]).problems
    assert problem.startswith(f"{path} is damaged; delete {copy / 'layouts' / 'movi'}")
    (copy / "layouts" / "lerobot" / "layout.json").write_text("[]")
    assert len(verify(None, [copy]).problems) == 2
