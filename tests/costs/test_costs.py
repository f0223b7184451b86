"""What runs spent is added up by stage, and what is predicted follows from runs that were made."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import esg
from esg.commands.cost import cost as command
from esg.costs import predicted
from esg.costs.predicted import Measured, predict, table
from esg.costs.spent import Spent, core_time, line, spent
from esg.outcomes import UserError


def entry(stage: str, seconds: float, cores: float, **more: Any) -> dict[str, Any]:
    return {"stage": stage, "cached": False, "seconds": seconds, "core_seconds": cores, **more}


LOGS = [
    [entry("draft", 1.0, 0.5), entry("record", 3.0, 5.0), {"outcome": "solved"}],
    [entry("draft", 9.0, 9.0, cached=True), entry("record", 1.0, 2.2)],
]


def test_stages_add_up_and_the_cache_costs_nothing() -> None:
    told = spent(LOGS).to_json()
    assert told["scenes"] == 2
    assert told["seconds_a_scene"] == pytest.approx(2.5)
    assert told["core_hours"] == pytest.approx(7.7 / 3600, abs=1e-6)
    assert told["stages"]["record"]["core_hours_a_scene"] == pytest.approx(3.6 / 3600, abs=1e-8)
    assert told["stages"]["draft"]["seconds_a_scene"] == pytest.approx(0.5)


def test_the_line_names_seconds_by_stage_and_core_hours() -> None:
    said = line(spent(LOGS).to_json())
    assert said.startswith("cost a scene: 2.50 s (draft 0.50, record 2.00)")
    assert "core-hours in all" in said
    assert line(Spent(0, {}, {}).to_json())  # nothing was computed


def test_the_time_of_children_counts() -> None:
    """The compiler's and the film's: both are other processes."""
    import subprocess
    import sys

    before = core_time()
    subprocess.run([sys.executable, "-c", "sum(range(3_000_000))"], check=True)
    assert core_time() - before > 0.01


def test_scenes_of_python_cost_what_their_logs_say(tmp_path: Path) -> None:
    class Folder:
        folder = tmp_path

    (tmp_path / "log.jsonl").write_text("\n".join(json.dumps(e) for e in LOGS[0]) + "\n")
    told = esg.cost([Folder()])  # type: ignore[list-item]
    assert told["seconds_a_scene"] == pytest.approx(4.0)


def run(use: str, scenes: int, core_s: float, seconds: float = 0.0, render: str = "") -> Measured:
    return Measured("box", render, use, scenes, 4, seconds, core_s, "abc", "2026-11-23", "a run")  # type: ignore[arg-type]


def test_a_prediction_scales_with_scenes_and_cores() -> None:
    rows = (run("fit", 100, 200.0, 62.5), run("check", 50, 110.0))
    found = predict(36_000, "box", rows=rows)
    assert found.core_hours == pytest.approx(20.0)
    assert found.busy == pytest.approx(0.8)
    assert found.hours == pytest.approx(20.0 / 4 / 0.8)
    assert found.errors == (pytest.approx(0.1),)


def test_the_latest_run_counts_and_an_earlier_one_says_how_busy_cores_were() -> None:
    old = Measured("box", "", "fit", 100, 4, 100.0, 360.0, "abc", "2026-11-21", "idle")
    older_check = Measured("box", "", "check", 100, 4, 0.0, 900.0, "abc", "2026-11-21", "x")
    found = predict(1, "box", rows=(old, older_check, run("fit", 100, 200.0)))
    assert found.core_seconds == pytest.approx(2.0)
    assert found.busy == pytest.approx(0.9)
    assert found.errors == ()


def test_rendering_is_a_price_of_its_own() -> None:
    rows = (run("fit", 10, 20.0), run("fit", 10, 80.0, render="raster"))
    assert predict(1, "box", "raster", rows).core_seconds == pytest.approx(8.0)
    with pytest.raises(UserError, match="measured on box: raster"):
        predict(1, "box", "trace", rows)


def test_what_was_not_measured_is_not_predicted() -> None:
    with pytest.raises(UserError, match="measured are box"):
        predict(1, "moon", rows=(run("fit", 1, 1.0),))


def test_every_row_of_the_table_says_where_it_comes_from() -> None:
    assert table()
    for row in table():
        assert row.commit and row.date.startswith("20") and row.about
        assert row.scenes > 0 and row.cores > 0 and row.core_seconds > 0.0
        assert row.use in ("fit", "check")


def test_held_out_runs_are_predicted_within_a_fifth() -> None:
    checked = [predict(1, kind) for kind in predicted.kinds()]
    errors = [error for found in checked for error in found.errors]
    assert errors
    assert max(abs(error) for error in errors) <= 0.2


def test_the_command_prints_its_sources(capsys: pytest.CaptureFixture[str]) -> None:
    assert command(scenes=1_000_000, json=True) == 0
    (first, *_) = json.loads(capsys.readouterr().out)
    assert first["scenes"] == 1_000_000
    assert first["measured"][0]["commit"]
    assert command(scenes=10) == 0
    assert "core-hours" in capsys.readouterr().out
