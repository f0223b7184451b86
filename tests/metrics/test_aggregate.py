"""K runs to the benchmark report."""

from __future__ import annotations

import json
from pathlib import Path
import statistics

import pytest

from esg.metrics import (
    SceneRun,
    Suite,
    SuiteConstraint,
    SuiteScene,
    SuiteStatement,
    bench_json,
    comparison_table,
    load_paper_results,
    load_suite,
)
from esg.metrics.judging import failed_verdict
from tests.metrics.test_events import CHAIN, chain

MASS = SuiteConstraint(kind="initial", quantity="mass", object="ball 1", value=1.0)
TIME = SuiteConstraint(kind="outcome", quantity="time", event="e2", value=0.8)
SCENES = (
    SuiteScene(id="A", prompt="a", events=tuple(CHAIN), constraints=(MASS, TIME)),
    SuiteScene(id="B", prompt="b", events=tuple(CHAIN[:1])),
)
SUITE = Suite(suite="two", scenes=SCENES)


def good(scene: SuiteScene):
    return chain(0.4, 0.8).judge(scene.events, scene.constraints)


def half(scene: SuiteScene):
    world = chain(0.4, 0.8)
    world.contacts = world.contacts[:1]
    return world.judge(scene.events, scene.constraints)


def report():
    runs = {
        "A": [
            SceneRun(0, good(SCENES[0]), "solved", 1.0),
            SceneRun(1, half(SCENES[0]), "not_converged", 2.0),
            SceneRun(2, None, "crashed", 3.0),
        ],
        "B": [SceneRun(k, good(SCENES[1]), "solved", 4.0) for k in range(3)],
    }
    return bench_json(SUITE, runs, strategy="batched", engine="physx", dt=1 / 240)


def test_report_has_the_stable_shape():
    data = report()
    assert list(data) == ["suite", "runs", "strategy", "engine", "dt", "scenes", "totals"]
    assert list(data["scenes"][0]) == [
        "id", "n_events", "completed", "slr", "ppa", "statements", "plausible", "plausibility",
        "outcome", "seconds",
    ]  # fmt: skip
    assert list(data["scenes"][0]["ppa"][0]) == ["constraint", "scores", "measured"]
    assert list(data["totals"]) == [
        "events", "ecr_mean", "ecr_std", "slr", "ppa", "ppa_strict", "ppa_lenient", "skr",
        "plausible", "seconds_per_scene",
    ]  # fmt: skip
    json.dumps(data, allow_nan=False)


def test_plausible_runs_are_counted_among_those_that_came_to_a_replay():
    fine, bad = {"name": "speed", "ok": True}, {"name": "speed", "ok": False}
    runs = {
        "A": [SceneRun(k, good(SCENES[0]), "solved", 1.0, c) for k, c in enumerate(([fine], [bad, fine], []))],
        "B": [SceneRun(k, good(SCENES[1]), "solved", 1.0, [fine]) for k in range(3)],
    }  # fmt: skip
    data = bench_json(SUITE, runs, strategy="batched", engine="physx", dt=1 / 240)
    assert data["scenes"][0]["plausible"] == [True, False, None]
    assert data["scenes"][0]["plausibility"] == [[fine], [bad, fine], []]
    assert data["totals"]["plausible"] == pytest.approx(100 * 4 / 5)
    assert "| 80%" in comparison_table(data)
    assert report()["totals"]["plausible"] is None


def test_totals():
    data = report()
    assert data["scenes"][0]["completed"] == [2, 1, 0]
    assert data["scenes"][0]["slr"] == [1, 1, 0]
    assert data["scenes"][0]["outcome"] == ["solved", "not_converged", "crashed"]
    mass, time = data["scenes"][0]["ppa"]
    assert mass["scores"] == [1.0, 1.0, 0.0]
    assert time["scores"] == [1.0, 0.0, 0.0]
    assert time["measured"] == [pytest.approx(0.8), None, None]
    totals = data["totals"]
    assert totals["events"] == 3
    # Per-run sums over scenes: 3, 2, 1.
    assert totals["ecr_mean"] == 2.0
    assert totals["ecr_std"] == pytest.approx(statistics.pstdev([3, 2, 1]))
    assert totals["slr"] == pytest.approx(100 * 5 / 6)
    assert totals["ppa"] == pytest.approx(50.0)
    assert totals["seconds_per_scene"] == pytest.approx(3.0)


def test_a_suite_without_constraints_has_no_ppa():
    suite = Suite(suite="b", scenes=SCENES[1:])
    runs = {"B": [SceneRun(0, good(SCENES[1]), "solved", 1.0)]}
    totals = bench_json(suite, runs, strategy="none", engine="physx", dt=0.01)["totals"]
    assert totals["ppa"] is None


def test_a_scene_without_listed_events_has_no_rate():
    asked, open_ = (
        SuiteScene(id="B", prompt="b", events=tuple(CHAIN[:1])),
        SuiteScene(id="C", prompt="c"),
    )
    suite = Suite(suite="b", scenes=(asked, open_))
    runs = {s.id: [SceneRun(0, good(s), "solved", 1.0)] for s in suite.scenes}
    text = comparison_table(bench_json(suite, runs, strategy="none", engine="physx", dt=0.01))
    rows = {line.split("|")[1].strip(): line for line in text.splitlines()}
    assert "1.0 ± 0.0" in rows["B"] and "none listed" not in rows["B"]
    assert "none listed" in rows["C"] and "±" not in rows["C"]
    assert "1.0 ± 0.0" in rows["Total"]
    alone = Suite(suite="c", scenes=(open_,))
    text = comparison_table(
        bench_json(alone, {"C": runs["C"]}, strategy="none", engine="physx", dt=0.01)
    )
    assert text.count("none listed") == 2 and "±" not in text


def test_every_scene_needs_the_same_number_of_runs():
    with pytest.raises(ValueError, match="same number of runs"):
        bench_json(SUITE, {"A": []}, strategy="none", engine="physx", dt=0.01)
    with pytest.raises(ValueError, match="'B': 0"):
        one = [SceneRun(0, None, "crashed", 1.0)]
        bench_json(SUITE, {"A": one}, strategy="none", engine="physx", dt=0.01)


def test_failed_verdict_counts_everything_as_missing():
    verdict = failed_verdict("x", SCENES[0], "physx", 0.01, "no draft")
    assert (verdict.completed, verdict.n_events, verdict.slr) == (0, 2, False)
    assert verdict.ppa() == 0.0
    assert verdict.events[0].reason == "no draft"


def test_the_papers_numbers_add_up():
    paper = load_paper_results()
    for method in paper["methods"]:
        total = sum(row[method][0] for row in paper["completion"].values())
        # The paper's own rows of Scene Language sum to 3.2 and of w/o Opt. to 8.8.
        assert total == pytest.approx(paper["totals"]["ecr"][method][0], abs=0.05)
    assert sum(r["n_events"] for r in paper["completion"].values()) == 18
    assert "source" in paper


def test_the_papers_constraints_are_those_of_the_suite():
    suite = load_suite(Path(__file__).parents[2] / "data" / "suites" / "paper.yaml")
    labels = [(s.id, c.label) for s in suite.scenes for c in s.constraints]
    assert labels == [(e["scene"], e["constraint"]) for e in load_paper_results()["errors"]]


def test_comparison_shows_the_papers_columns_for_its_suite_only():
    data = report()
    text = comparison_table(data)
    assert "Scene Language" not in text
    assert "2.0 ± 0.8" in text
    assert "1 solved, 1 not_converged, 1 crashed" in text
    suite = load_suite(Path(__file__).parents[2] / "data" / "suites" / "paper.yaml")
    runs = {s.id: [SceneRun(0, None, "crashed", 1.0)] for s in suite.scenes}
    paper = comparison_table(bench_json(suite, runs, strategy="none", engine="physx", dt=0.01))
    assert "| S9 " in paper
    assert "2.2 ± 0.8" in paper
    assert "16.4 ± 1.0" in paper
    assert "0.0 ± 0.0" in paper


def test_paper_results_are_reachable_in_data():
    link = Path(__file__).parents[2] / "data" / "paper_results.json"
    assert json.loads(link.read_text()) == load_paper_results()


def test_statements_kept_are_counted_over_all_scenes_and_runs():
    says = (
        SuiteStatement(id="s1", says="faster_than", object="ball 1", value=1.0, when="start..e1"),
        SuiteStatement(id="s2", says="absent", noun="ball"),
    )
    scenes = (
        SuiteScene(id="A", prompt="a", events=tuple(CHAIN), statements=says),
        SuiteScene(id="B", prompt="b", events=tuple(CHAIN[:1])),
    )
    suite = Suite(suite="two", scenes=scenes)
    verdict = chain(0.4, 0.8).judge(CHAIN, statements=says)
    runs = {
        "A": [SceneRun(0, verdict, "solved", 1.0), SceneRun(1, None, "crashed", 1.0)],
        "B": [SceneRun(k, good(scenes[1]), "solved", 1.0) for k in range(2)],
    }
    data = bench_json(suite, runs, strategy="batched", engine="physx", dt=1 / 240)
    first, second = data["scenes"][0]["statements"]
    assert (first["id"], first["says"], first["kept"]) == ("s1", "faster_than", [True, False])
    assert first["measured"] == [{"speed_mps": pytest.approx(2.0, abs=0.01)}, {}]
    assert second["kept"] == [False, False]
    assert data["totals"]["skr"] == pytest.approx(25.0)
    assert data["scenes"][1]["statements"] == []
    json.dumps(data, allow_nan=False)
    table = comparison_table(data)
    assert "SKR" in table
    assert "25.0%" in table
    assert "SKR" not in comparison_table(report())
