"""`failures.jsonl` gathers what failed in a folder and forgets what is mended or gone."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
import json
from pathlib import Path
import shutil

from esg.failures import FILE, report_failures
from esg.outcomes import Outcome
from esg.pipeline import SceneRequest, SceneState


def scene(out: Path, name: str, outcome: Outcome) -> tuple[list[SceneState], list[Path]]:
    """A scene that has ended, and its folder."""
    folder = out / name
    folder.mkdir(parents=True, exist_ok=True)
    for mark in ("prompt.txt", "log.jsonl"):
        (folder / mark).write_text("")
    log = ({"stage": "judge", "seconds": 0.1},)
    request = SceneRequest(f"Prompt of {name}: 猫 → é")
    return [SceneState(request, {}, log, outcome, f"reason of {name}")], [folder]


def told(out: Path) -> list[str]:
    return [json.loads(line)["scene"] for line in (out / FILE).read_bytes().splitlines()]


def test_single_scenes_gather_and_a_mended_one_goes(tmp_path: Path) -> None:
    for name in ("a", "b", "c"):
        report_failures(*scene(tmp_path, name, Outcome.CRASHED), tmp_path, adding=True)
    report_failures(*scene(tmp_path, "fine", Outcome.SOLVED), tmp_path, adding=True)
    assert told(tmp_path) == ["a", "b", "c"]
    report_failures(*scene(tmp_path, "b", Outcome.SOLVED), tmp_path, adding=True)
    shutil.rmtree(tmp_path / "c")
    report_failures(*scene(tmp_path, "a", Outcome.INFEASIBLE), tmp_path, adding=True)
    assert told(tmp_path) == ["a"]
    assert "infeasible" in (tmp_path / FILE).read_text("utf-8")
    report_failures(*scene(tmp_path, "a", Outcome.SOLVED), tmp_path, adding=True)
    assert not (tmp_path / FILE).exists()


def test_a_suite_tells_of_its_own_run_alone(tmp_path: Path) -> None:
    report_failures(*scene(tmp_path, "a", Outcome.CRASHED), tmp_path)
    report_failures(*scene(tmp_path, "b", Outcome.CRASHED), tmp_path)
    assert told(tmp_path) == ["b"]
    report_failures(*scene(tmp_path, "b", Outcome.SOLVED), tmp_path)
    assert not (tmp_path / FILE).exists()


def test_the_stage_that_decided_is_named(tmp_path: Path) -> None:
    """Later stages run and are logged, too: the judge decides, the record stage only carries on."""
    (state,), folders = scene(tmp_path, "a", Outcome.NOT_CONVERGED)
    log = [{"stage": s, "seconds": 0.1} for s in ("layout", "judge", "record")]
    log[1]["outcome"] = log[2]["outcome"] = "not_converged"
    report_failures([replace(state, log=tuple(log))], folders, tmp_path)
    assert json.loads((tmp_path / FILE).read_text())["stage"] == "judge"
    log[2]["outcome"] = "crashed"
    crashed = replace(state, log=tuple(log), outcome=Outcome.CRASHED)
    report_failures([crashed], folders, tmp_path)
    assert json.loads((tmp_path / FILE).read_text())["stage"] == "record"


def test_a_damaged_file_costs_only_its_damaged_lines(tmp_path: Path) -> None:
    report_failures(*scene(tmp_path, "a", Outcome.CRASHED), tmp_path, adding=True)
    with (tmp_path / FILE).open("ab") as file:
        file.write(b'{"scene": \xff\n[1]\n{"prompt": "x"}\nnull\n{"scene": "b", "pro')
    report_failures(*scene(tmp_path, "c", Outcome.CRASHED), tmp_path, adding=True)
    assert told(tmp_path) == ["a", "c"]


def test_no_line_is_lost_when_commands_end_together(tmp_path: Path) -> None:
    ended = [scene(tmp_path, f"s{k}", Outcome.CRASHED) for k in range(24)]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda e: report_failures(*e, tmp_path, adding=True), ended))
    assert sorted(told(tmp_path)) == sorted(f"s{k}" for k in range(24))
    assert not list(tmp_path.glob(".*"))
