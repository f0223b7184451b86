"""Reading a run: order, totals, what came before."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from esg.outcomes import UserError
from esg.report.run import find_scenes, load_run, natural, read_scene, totals_of
from tests.report.folders import write_scene


def test_names_with_numbers_sort_by_their_numbers() -> None:
    """S2 comes before S10, and plain words keep their order."""
    names = ["S10-run0", "S2-run1", "S2-run0", "alpha"]
    assert sorted(names, key=natural) == ["S2-run0", "S2-run1", "S10-run0", "alpha"]


def test_scenes_are_found_in_order_and_other_folders_are_not(tmp_path: Path) -> None:
    """Only folders that hold a scene count."""
    for name in ("S10-run0", "S2-run0"):
        write_scene(tmp_path / name)
    (tmp_path / "notes").mkdir()
    assert [p.name for p in find_scenes(tmp_path)] == ["S2-run0", "S10-run0"]


def test_totals_count_like_a_benchmark(tmp_path: Path) -> None:
    """Two runs of two scenes: sums of completed events per run, a lost scene scores nothing."""
    write_scene(tmp_path / "S1-run0")
    write_scene(tmp_path / "S1-run1", completed=False, outcome="not_converged")
    write_scene(tmp_path / "S2-run0")
    write_scene(tmp_path / "S2-run1", outcome="crashed")
    totals = totals_of([read_scene(p) for p in find_scenes(tmp_path)])
    assert totals["events"] == 2
    assert totals["ecr_mean"] == 1.0  # (2 + 0) / 2
    assert totals["ecr_std"] == 1.0
    assert totals["slr"] == 75.0
    assert totals["ppa"] == 75.0
    assert totals["seconds_per_scene"] == 2.0


def test_the_results_document_of_a_benchmark_wins(tmp_path: Path) -> None:
    """Figures of the suite's own document are shown as they are; the paper's only for its suite."""
    write_scene(tmp_path / "S1-run0")
    document = {"suite": "other", "totals": {"events": 7, "ecr_mean": 3.0}, "scenes": []}
    (tmp_path / "run.json").write_text(json.dumps(document))
    run = load_run(tmp_path)
    assert run.totals["events"] == 7
    assert run.paper == {}
    (tmp_path / "run.json").write_text(json.dumps({**document, "suite": "paper"}))
    assert load_run(tmp_path).paper["totals"]["ecr"]["paper"][0] == 16.4


def test_an_earlier_run_can_be_named(tmp_path: Path) -> None:
    """By folder or by results file; one without results is refused by name."""
    write_scene(tmp_path / "now" / "S1-run0")
    write_scene(tmp_path / "then" / "S1-run0", completed=False, outcome="not_converged")
    run = load_run(tmp_path / "now", against=tmp_path / "then")
    assert run.before["ecr_mean"] == 0.0
    assert run.before["name"] == "then"
    bad = tmp_path / "bad.json"
    bad.write_text("{}")
    with pytest.raises(UserError, match=r"bad\.json"):
        load_run(tmp_path / "now", against=bad)


def test_a_folder_without_scenes_is_refused(tmp_path: Path) -> None:
    """The message says what to give instead."""
    with pytest.raises(UserError, match="--out of a bench or generate"):
        load_run(tmp_path)
    with pytest.raises(UserError, match="not a folder"):
        load_run(tmp_path / "nowhere")


def test_a_damaged_scene_is_shown_as_far_as_it_can_be_read(tmp_path: Path) -> None:
    """Half a metrics file takes down neither the scene nor the run."""
    folder = write_scene(tmp_path / "S1-run0")
    (folder / "metrics.json").write_text('{"outcome": "sol')
    scene = read_scene(folder)
    assert scene.metrics == {}
    assert scene.prompt.startswith("A red ball")


def test_the_prompt_is_kept_to_the_letter(tmp_path: Path) -> None:
    """Coverage counts characters: only the newline that was added is taken off."""
    assert read_scene(write_scene(tmp_path / "a", "one\n\ntwo ")).prompt == "one\n\ntwo "
