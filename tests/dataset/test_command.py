"""`esg dataset`: mistakes are told before any work, in one message, with exit code 2."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Any

import pytest

from esg.commands.datasets.dataset import dataset, describe
from esg.commands.datasets.drawing import DrawOptions
from esg.dataset.folder import _is_unbegun
from esg.outcomes import UserError


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "either --prompts FILE or --sample N"),
        ({"sample": 3, "prompts": Path("p.txt")}, "either --prompts FILE or --sample N"),
        ({"sample": 0}, "--sample 0"),
        ({"sample": 3, "shard": "3/2"}, "--shard '3/2'"),
        ({"sample": 3, "seed": -1}, "--seed -1"),
        ({"sample": 3, "workers": 0}, "--workers 0"),
        ({"sample": 3, "batch": 0}, "--batch 0"),
        ({"sample": 4, "batch": 3, "draw": DrawOptions(counterfactual=True)}, "no pair is parted"),
        ({"prompts": Path("nope.txt")}, "nope.txt does not exist"),
        (
            {"prompts": Path("nope.txt"), "draw": DrawOptions(counterfactual=True)},
            "--counterfactual belongs to",
        ),
        (
            {"sample": 3, "draw": DrawOptions(distribution=Path("nope.yaml"))},
            "nope.yaml does not exist",
        ),
        ({"sample": 3, "device": "tpu"}, "--device 'tpu'"),
        ({"sample": 0, "out": "s3:/x"}, "two slashes(.|\n)*--sample 0|--sample 0(.|\n)*two slash"),
        ({"resume": True}, "either --prompts FILE or --sample N"),
    ],
)
def test_mistakes_leave_nothing_behind(
    tmp_path: Path, options: dict[str, Any], message: str
) -> None:
    with pytest.raises(UserError, match=message) as error:
        dataset(**{"out": str(tmp_path / "set"), **options})
    assert error.value.exit_code == 2
    assert not (tmp_path / "set").exists()


@pytest.mark.parametrize("left", [[], ["run.json"], ["prompts.jsonl", "run.json", ".plan.tmp"]])
def test_what_a_cut_off_beginning_left_is_no_other_folder(tmp_path: Path, left: list[str]) -> None:
    meta = tmp_path / "meta"
    meta.mkdir()
    for name in left:
        (meta / name).write_text("{}")
    assert _is_unbegun(meta)
    (meta / "mine.txt").write_text("")
    assert not _is_unbegun(meta)


def test_a_place_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UserError, match="not a folder"):
        dataset(out=str(tmp_path / "file" / "set"), sample=2)


def test_a_read_only_disk_is_told_with_its_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> str:
        raise OSError(errno.EROFS, "Read-only file system", str(tmp_path))

    monkeypatch.setattr("esg.scenefolder.tempfile.mkdtemp", refuse)
    with pytest.raises(UserError, match="read-only: choose a folder on another") as error:
        dataset(out=str(tmp_path / "set"), sample=2)
    assert error.value.exit_code == 2
    assert not (tmp_path / "set").exists()


def test_people_are_told_counts_splits_and_where_failures_are() -> None:
    text = describe({
        "scenes": 10, "planned": 10, "folder": "x", "complete": True, "verified": 8, "failed": 1, "partial": 1,
        "outcomes": {"solved": 8, "crashed": 1, "partial": 1}, "splits": {"train": 10},
        "not_represented": [{"words": "slowly", "status": "not_represented", "scenes": 1}],
        "failures": "x/failures.jsonl",
    })  # fmt: skip
    assert "8 verified, 1 partial, 1 failed" in text
    assert 'most often not shown: "slowly" (1)' in text
    assert "x/failures.jsonl" in text
