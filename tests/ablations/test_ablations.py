"""The paper's ablations: what is run for them, what it changes, and their tables."""

from __future__ import annotations

import json
import os
from pathlib import Path
import subprocess
import sys

import pytest

from esg.ablations.drafts import draft_table
from esg.ablations.tables import MEASURES, table_of
from esg.ablations.variants import ABLATIONS, FULL, NO_DYNAMIC, chosen, variants_of
from esg.assets import resolve
from esg.draft import draft
from esg.metrics import load_suite
from esg.outcomes import Outcome, UserError
from esg.pipeline import SceneRequest, SceneState
from esg.stages import configuration

ROOT = Path(__file__).parents[2]


def test_every_ablation_of_the_paper_is_there() -> None:
    keys = [ablation.key for ablation in ABLATIONS]
    assert keys == [
        "draft", "assets", "initial", "global", "gradients", "collision", "optimization",
    ]  # fmt: skip
    assert [a.key for a in chosen([])] == keys
    assert [a.key for a in chosen(["collision,draft", "assets"])] == [
        "draft",
        "assets",
        "collision",
    ]
    with pytest.raises(UserError, match="nothing, never: choose among draft, assets"):
        chosen(["nothing", "draft,never"])


def test_measures_and_paper_s_columns_are_whole() -> None:
    for ablation in ABLATIONS:
        assert set(ablation.measures) <= set(MEASURES)
        for cells in ablation.paper.values():
            assert len(cells) == len(ablation.paper_columns)


def test_a_variant_is_run_once_on_all_scenes_that_anything_asks_for() -> None:
    runs = variants_of(chosen([]))
    assert runs[FULL] == () and runs[NO_DYNAMIC] == ()
    assert {v.key for v, scenes in runs.items() if scenes == ("S6",)} == {
        "ad", "fd", "hybrid", "proxy", "sdf",
    }  # fmt: skip
    assert len({v.key for v in runs}) == len(runs) - 1  # hybrid is written twice, of equal scenes
    assert variants_of(chosen(["gradients"]))[FULL] == ("S6",)


def test_what_is_left_out_is_part_of_its_stage_s_key_and_of_no_other() -> None:
    plain = SceneRequest("A ball.")
    for without, stage in (("generation", "resolve"), ("global", "layout"), ("initial", "layout")):
        request = SceneRequest("A ball.", without=without)
        for name in ("draft", "resolve", "cast", "layout", "optimize"):
            told = configuration(name, request)
            assert told == configuration(name, plain) | (
                {"without": without} if name == stage else {}
            )


def test_retrieval_alone_takes_what_is_closest_whatever_it_is() -> None:
    doc = draft("A ball hits a theremin.")
    key = next(k for k, r in doc.asset_requirement.items() if "theremin" in r.asset_category)
    made = (resolve(doc).asset_configurations or {})[key]
    taken = (resolve(doc, retrieval_only=True).asset_configurations or {})[key]
    assert made.source == "fallback"
    assert taken.asset_name != made.asset_name
    assert taken.reason == f"the library holds nothing closer than {taken.asset_name}"


def test_runs_without_a_replay_count_as_nothing() -> None:
    suite = load_suite("paper")
    states = [
        SceneState(
            SceneRequest(scene.prompt, name=f"{scene.id}-run0", strategy="none"),
            outcome=Outcome.CRASHED,
        )
        for scene in suite.scenes
    ]
    (ablation,) = chosen(["optimization"])
    table = table_of(ablation, {FULL: states, NO_DYNAMIC: states}, suite)
    row = dict(zip(table.columns, table.rows[1], strict=True))
    assert row["events of 18"] == "0.0 ± 0.0" and row["PPA"] == "0.0%"
    assert row["off the paper's w/o Opt."] == "-8.8 (outside its ± 2.1)"
    assert row["paper: events"] == "8.8 ± 2.1"


def test_what_only_a_model_can_do_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in list(os.environ):
        if name.startswith("ESG_LLM_"):
            monkeypatch.delenv(name)
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path))
    suite = load_suite("paper")
    one = suite.model_copy(update={"scenes": suite.scenes[6:7]})
    (ablation,) = chosen(["draft"])
    table = draft_table(ablation, one, 0)
    assert [row[1] for row in table.rows] == ["-", "-", "-", "100.0"]
    assert all("none is configured" in row[3] for row in table.rows[:3])
    assert [row[4:] for row in table.rows[:3]] == [
        ("76.5", "58.0"), ("88.5", "79.7"), ("99.0", "89.5"),
    ]  # fmt: skip


@pytest.mark.slow
def test_the_command_prints_its_tables_and_leaves_a_folder_a_variant(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "esg", "bench", "paper", "--ablations", "collision", "--runs", "1",
         "--out", str(tmp_path / "out"), "--json", str(tmp_path / "tables.json")],
        capture_output=True, text=True, cwd=ROOT, check=False,
        env={**os.environ, "ESG_CACHE_DIR": str(tmp_path / "cache")},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "Simple proxy only" in done.stdout and "8/10" in done.stdout
    (table,) = json.loads((tmp_path / "tables.json").read_text())["tables"]
    assert [row["variant"] for row in table["rows"]] == [
        "Simple proxy only", "Proxy + SDF", "Exact parts",
    ]  # fmt: skip
    assert (tmp_path / "out" / "sdf" / "S6-run0" / "preview.mp4").is_file()
