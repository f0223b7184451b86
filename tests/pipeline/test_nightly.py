"""Nights: verdicts against history, folders, the command's checks."""

from __future__ import annotations

import datetime
from pathlib import Path

import pytest

from esg.commands.serve import DEFAULT_SUITE, arguments, check_cron, describe, serve
from esg.nightly import conclude_suite, history_row, verdict
from esg.outcomes import Outcome, UserError
from esg.pipeline import SceneRequest, SceneState
from esg.store import ingest, write_tables
from tests.store.samples import record, run_info


def night(folder: Path, day: int, complete: bool) -> str:
    run = run_info(f"night-{day}", day=day)
    records = [record(run, "S1", seed, complete=complete) for seed in (0, 1)]
    ingest(folder / "x.duckdb", write_tables(folder / "parts", records, name=run.run_id).values())
    return run.run_id


def test_a_worse_night_is_a_regression_until_it_is_good_again(tmp_path: Path) -> None:
    db = tmp_path / "x.duckdb"
    first, second, third, fourth = (
        night(tmp_path, day, good) for day, good in ((1, True), (2, False), (3, False), (4, True))
    )
    assert "nothing to compare" in verdict(history_row(db, first))
    for bad in (second, third):
        row = history_row(db, bad)
        assert (row["regressed"], row["last_good"]) == (True, first)
        assert verdict(row).startswith("REGRESSED: events -1")
    row = history_row(db, fourth)
    assert (row["regressed"], verdict(row).split(":")[0]) == (False, "no worse")


def test_runs_that_are_not_recorded_are_said_to_be(tmp_path: Path) -> None:
    night(tmp_path, 1, True)
    assert history_row(tmp_path / "x.duckdb", "it's none") == {}
    assert verdict({}) == "not recorded, so not compared"


@pytest.mark.parametrize("text", ["0 3 * * *", "*/15 0-6,22 1 1-12/2 1-5", "5 4 * * mon-fri"])
def test_cron_expressions(text: str) -> None:
    check_cron(text)


@pytest.mark.parametrize(
    "text", ["", "3", "* * * *", "60 3 * * *", "0 24 * * *", "0 3 0 * *", "a b c d e", "5-1 * * * *",
             "mon * * * *", "*/0 * * * *", "0 3 * * * *", "0 3 30 2 *"],
)  # fmt: skip
def test_what_is_no_cron_expression_is_refused(text: str) -> None:
    with pytest.raises(UserError, match="--cron"):
        check_cron(text)


def following(text: str, moment: str) -> str:
    start = datetime.datetime.fromisoformat(f"{moment}:00+00:00")
    return next(check_cron(text, start)).strftime("%Y-%m-%dT%H:%M")


@pytest.mark.parametrize(
    ("text", "moment", "expected"),
    [
        ("0 3 * * *", "2026-11-21T02:59", "2026-11-21T03:00"),
        ("0 3 * * *", "2026-11-21T03:00", "2026-11-22T03:00"),
        ("*/20 * * * *", "2026-12-31T23:45", "2027-01-01T00:00"),
        ("30 4 * * mon", "2026-11-21T00:00", "2026-11-23T04:30"),
        ("0 0 29 2 *", "2026-03-01T00:00", "2028-02-29T00:00"),
        ("0 0 1 * 7", "2026-11-21T00:00", "2026-11-22T00:00"),
        ("5 1-3/2,6 * jan *", "2026-11-21T00:00", "2027-01-01T01:05"),
    ],
)
def test_when_an_expression_fires_next(text: str, moment: str, expected: str) -> None:
    assert following(text, moment) == expected


def test_a_scheduled_night_runs_with_the_same_options() -> None:
    options = {
        "suites": ["a.yaml", "b.yaml"], "out": "o", "database": "d", "runs": 3, "seed": 1,
        "strategy": "fd", "engine": "rapier", "device": "cpu", "workers": 2, "cached": True,
    }  # fmt: skip
    text = " ".join(arguments(options))
    assert text == (
        "--suite a.yaml --suite b.yaml --runs 3 --seed 1 --strategy fd --engine rapier "
        "--device cpu --out o --db d --workers 2 --cached"
    )


def test_mistakes_are_told_before_any_work(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="either --cron"):
        serve()
    with pytest.raises(UserError, match="either --cron"):
        serve(once=True, cron="0 3 * * *")
    with pytest.raises(UserError, match="does not exist"):
        serve(once=True, suite=[tmp_path / "no.yaml"])
    with pytest.raises(UserError, match="--runs 0"):
        serve(once=True, runs=0)


def test_description_names_folder_and_verdict() -> None:
    summary = {"events": 18, "ecr_mean": 17.5}
    text = describe([
        {"suite": "paper", "verdict": "no worse", "summary": summary, "failed": 1,
         "folder": "runs/x", "report": "runs/x/report.html", "partial": 2,
         "not_represented": [{"words": "slowly", "status": "not_represented", "scenes": 2}]},
    ])  # fmt: skip
    assert "events 17.50 of 18" in text
    assert "runs/x/report.html" in text
    assert "1 failed and 2 partial scene runs" in text
    assert 'most often not shown: "slowly" (2)' in text


def test_a_night_counts_partial_scenes_apart_from_failures(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lost = [{"words": "Slowly", "status": "not_represented", "start": 0, "end": 6, "reason": ""}]
    for place, value in {
        "esg.scenefolder.publish": lambda state, folder: folder,
        "esg.failures.report_failures": lambda *_: None,
        "esg.nightly._report": lambda *_: "",
        "esg.nightly.not_kept": lambda s: lost if s.outcome is Outcome.PARTIAL else [],
    }.items():
        monkeypatch.setattr(place, value)
    ends = [Outcome.PARTIAL] * 2 + [Outcome.CRASHED] + [Outcome.SOLVED] * 7
    states = [SceneState(SceneRequest("x", name=f"S{k}"), outcome=o) for k, o in enumerate(ends)]
    found = conclude_suite(states, str(DEFAULT_SUITE), 1, tmp_path, tmp_path / "x.duckdb")
    assert (found.failed, found.partial) == (1, 2)
    assert found.to_json()["not_represented"] == [
        {"words": "slowly", "status": "not_represented", "scenes": 2}
    ]


def test_the_default_suite_is_found_from_any_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from esg.metrics import load_suite

    monkeypatch.chdir(tmp_path)
    assert load_suite(DEFAULT_SUITE).suite == "paper"
