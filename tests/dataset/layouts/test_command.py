"""`esg dataset --layout`: to a finished dataset, and refused before any work."""

from __future__ import annotations

import json
from pathlib import Path
import shutil

import pytest

from esg.commands.datasets.dataset import dataset
from esg.commands.datasets.layouts import LayoutOptions
from esg.dataset.folder import DatasetFolder
from esg.dataset.plan import Shard
from esg.outcomes import UserError
from tests.dataset.layouts.sets import make_set


@pytest.fixture
def plain(whole: Path, tmp_path: Path) -> Path:
    """A finished dataset with clips and without layouts."""
    return Path(shutil.copytree(whole, tmp_path / "set", ignore=shutil.ignore_patterns("layouts")))


def test_a_finished_dataset_gets_layouts_and_remembers_them(plain, whole, capsys):
    dataset(out=str(plain), resume=True, layouts=LayoutOptions("movi"), json=True)
    assert json.loads(capsys.readouterr().out)["layouts"] == ["parquet", "movi"]
    assert [p.name for p in (plain / "layouts").iterdir()] == ["movi"]
    shutil.rmtree(plain / "layouts")
    dataset(out=str(plain), resume=True, layouts=LayoutOptions("webdataset,parquet"), json=True)
    assert sorted(p.name for p in (plain / "layouts").iterdir()) == ["movi", "webdataset"]
    for path in (whole / "layouts" / "webdataset").iterdir():
        assert (plain / "layouts" / "webdataset" / path.name).read_bytes() == path.read_bytes()
    assert not list(plain.rglob(".*"))
    card = (plain / "README.md").read_text("utf-8")
    assert "wds.WebDataset" in card and "layouts/movi" in card and "lerobot" not in card


def test_mistakes_cost_nothing(plain, tmp_path):
    for text, told in (("tfrecord", "there is no layout"), ("", "there is no layout")):
        with pytest.raises(UserError, match=told) as error:
            dataset(out=str(plain), resume=True, layouts=LayoutOptions(text))
        assert error.value.exit_code == 2
    bare = make_set(tmp_path / "bare", rendered=False)
    with pytest.raises(UserError, match="has none; render them") as error:
        dataset(out=str(bare), resume=True, layouts=LayoutOptions("lerobot"))
    assert error.value.exit_code == 2
    with pytest.raises(UserError, match="has none; render them"):
        dataset(out=str(tmp_path / "new"), sample=2, layouts=LayoutOptions("lerobot"))
    assert not (tmp_path / "new").exists()
    assert not (bare / "layouts").exists() and not (bare / "meta" / "layouts.json").exists()


def test_no_lock_is_left_but_those_that_are_held(plain):
    folder = DatasetFolder(plain)
    with folder.locked(Shard(2, 2)):
        with folder.locked(Shard(1, 2)):
            pass
        assert [p.name for p in plain.glob(".lock-*")] == [".lock-2-of-2"]
    assert not list(plain.glob(".lock-*"))
