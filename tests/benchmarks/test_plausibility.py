"""The table over runs counts every replay once and names the worst of each check."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks.plausibility import read, rows, table


def check(name: str, ratio: float) -> dict[str, object]:
    return {"name": name, "unit": "m", "ok": ratio <= 1.0, "measured": ratio, "limit": 1.0,
            "body": "car_1", "time_s": 0.0, "note": ""}  # fmt: skip


def test_results_and_scene_folders_give_the_same_table(tmp_path: Path) -> None:
    played = [[check("speed", 0.5), check("braking", 2.0)], [check("speed", 3.0)], []]
    scenes = [{"id": "A", "plausibility": played[:1]}, {"id": "B", "plausibility": played[1:]}]
    document = tmp_path / "bench.json"
    document.write_text(json.dumps({"suite": "s", "scenes": scenes}))
    for name, checks in (("A-run0", played[0]), ("B-run0", played[1])):
        (tmp_path / "s" / name).mkdir(parents=True)
        metrics = {"plausibility": {"checks": checks}}
        (tmp_path / "s" / name / "metrics.json").write_text(json.dumps(metrics))
    found = read(document)
    assert found == read(tmp_path / "s")
    by_check = {row["check"]: row for row in rows(found)}
    assert (by_check["speed"]["replays"], by_check["speed"]["failed"]) == (2, 1)
    assert (by_check["speed"]["worst"], by_check["speed"]["scene"]) == (3.0, "s B-run0")
    assert by_check["energy"]["replays"] == 0
    assert "s: 0 of 2 plausible (0%)" in table(found)


def test_a_run_from_before_is_refused(tmp_path: Path) -> None:
    (tmp_path / "old.json").write_text(json.dumps({"suite": "s", "scenes": [{"id": "A"}]}))
    with pytest.raises(SystemExit, match="--again"):
        read(tmp_path / "old.json")
