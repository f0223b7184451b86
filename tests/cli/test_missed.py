"""`esg bench` says why something of the suite did not happen, also in scenes that are solved."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, cast

import pytest

from esg.commands import bench
from esg.metrics.models import ConstraintVerdict, EventVerdict, LayoutVerdict, SceneVerdict


def verdict(completed: bool, score: float = 1.0, missing: tuple[str, ...] = ()) -> SceneVerdict:
    """One event and one constraint."""
    return SceneVerdict(
        scene_id="x", suite_scene="S1", engine="physx", dt_s=1 / 240,
        events=(EventVerdict(id="e1", type="collision", completed=completed,
                             reason="" if completed else "the pair never touches"),),
        constraints=(ConstraintVerdict(
            constraint="speed of car", kind="initial", quantity="speed", unit="m/s", measured=2.0,
            score=score, score_strict=score, score_lenient=score, target=(4.0, 5.0)),),
        layout=LayoutVerdict(valid=not missing, missing=missing),
    )  # fmt: skip


@pytest.fixture
def states(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Four runs: good, two that miss the same, one that never came to a verdict."""
    found = [verdict(True), verdict(False), verdict(False, 0.0, ("a cone",)), None]
    made = [
        SimpleNamespace(request=SimpleNamespace(name=f"S1-run{k}", seed=k), reason="no road", v=v)
        for k, v in enumerate(found)
    ]
    monkeypatch.setattr("esg.runs.verdict_of", lambda state: state.v)
    return made


def test_every_miss_has_its_reason(states: list[Any]) -> None:
    rows = bench.missed(cast(Any, states))
    assert [(r["scene"], r["what"], r["reason"]) for r in rows] == [
        ("S1-run1", "e1 (collision)", "the pair never touches"),
        ("S1-run2", "e1 (collision)", "the pair never touches"),
        ("S1-run2", "speed of car", "asked 4 to 5, measured 2"),
        ("S1-run2", "layout", "missing: a cone"),
        ("S1-run3", "all events", "no road"),
    ]
    assert bench.missed(cast(Any, states[:1])) == []


def test_runs_with_one_reason_share_a_line(states: list[Any]) -> None:
    lines = bench.missed_lines(bench.missed(cast(Any, states)))
    assert lines[0] == "missed  S1 run 1, 2: e1 (collision): the pair never touches"
    assert len(lines) == 4


def test_a_long_list_is_cut_and_says_where_the_rest_is() -> None:
    rows = [{"scene": f"S{k}-run0", "seed": 0, "what": "e1", "reason": "r"} for k in range(99)]
    lines = bench.missed_lines(rows)
    assert len(lines) == bench.MISSED_LINES + 1
    assert "69 more" in lines[-1]


def test_words_that_runs_do_not_show_share_a_line(
    states: list[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    lost = {"words": "straight up", "status": "not_represented", "reason": "no path that rises"}
    monkeypatch.setattr("esg.stages.not_kept", lambda state: [lost] * (state.request.seed > 1))
    rows = bench.not_kept(cast(Any, states))
    assert [(r["scene"], r["seed"], r["status"]) for r in rows] == [
        ("S1-run2", 2, "not_represented"),
        ("S1-run3", 3, "not_represented"),
    ]
    assert bench.missed_lines(rows, "not_kept") == [
        'not kept  S1 run 2, 3: "straight up": not represented: no path that rises'
    ]
