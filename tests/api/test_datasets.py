"""A finished dataset read from Python."""

from __future__ import annotations

import json
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import esg
from esg.dataset.folder import INFO, DatasetFolder
from esg.dataset.plan import DatasetSpec


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Seventy scenes in two splits, as `finish` leaves them."""
    DatasetFolder(tmp_path).begin(DatasetSpec(source="sample", n=70), [], resume=False)
    (tmp_path / INFO).write_text(json.dumps({"format_version": 1, "scenes": 70}))
    (tmp_path / "scenes").mkdir()
    for split, numbers in (("train", range(66)), ("test", range(66, 70))):
        table = pa.table({"prompt": [f"prompt {n}" for n in numbers]})
        pq.write_table(table, tmp_path / "scenes" / f"{split}-00000-of-00001.parquet")
    return tmp_path


def test_rows_come_by_split_and_are_counted(folder: Path) -> None:
    found = esg.load_dataset(folder)
    assert (len(found), found.tables, found.info["scenes"]) == (70, ("scenes",), 70)
    assert [row["prompt"] for row in found.rows(split="test")] == [
        f"prompt {n}" for n in range(66, 70)
    ]
    assert len(list(found.rows())) == found.table().num_rows == 70
    assert found.table(split="train").num_rows == 66


def test_what_is_not_there_is_told_with_what_is(folder: Path, tmp_path: Path) -> None:
    found = esg.load_dataset(folder)
    with pytest.raises(esg.UserError, match="no table 'frames'; it has scenes"):
        found.table("frames")
    with pytest.raises(esg.UserError, match="no split 'validation'; it has test, train"):
        list(found.rows(split="validation"))
    (folder / INFO).unlink()
    with pytest.raises(esg.UserError, match="is not finished"):
        esg.load_dataset(folder)
    with pytest.raises(esg.UserError, match="holds no dataset"):
        esg.load_dataset(tmp_path / "elsewhere")
