"""What runs are called, and that Prefect shows it."""

from __future__ import annotations

import os
from typing import Any

import pytest

from esg.outcomes import Outcome
from esg.pipeline import SceneRequest, SceneState
from flows.naming import MAX_NAME, run_name, run_tags, scene_names
from flows.session import session


@pytest.mark.parametrize(
    ("flow", "parameters", "name"),
    [
        ("benchmark", {"suite": "a/paper.yaml", "runs": 5, "seed": 0},
         "benchmark: paper, 5 runs a scene, seed 0"),
        ("nightly", {"suites": ["paper.yaml", "x/breadth.yaml"], "runs": 3, "seed": 1},
         "nightly: paper, breadth, 3 runs a scene, seed 1"),
        ("generate", {"prompts": ["A ball rolls."], "seed": 7}, "generate: A ball rolls., seed 7"),
        ("generate", {"prompts": ["a", "b"], "seed": 0}, "generate: 2 prompts, seed 0"),
        ("dataset", {"out": "sets/balls", "scenes": 40}, "dataset: balls, 40 scenes"),
        ("other", {}, "other"),
    ],
)  # fmt: skip
def test_a_run_is_named_after_what_it_makes(
    flow: str, parameters: dict[str, Any], name: str
) -> None:
    assert run_name(flow, parameters) == name


def test_a_long_prompt_does_not_make_a_long_name() -> None:
    name = run_name("generate", {"prompts": ["ball " * 100], "seed": 0})
    assert len(name) == MAX_NAME
    assert name.endswith("…")


def test_tags_name_flow_suites_and_how_it_ran() -> None:
    parameters = {"suite": "paper.yaml", "engine": "rapier", "device": "cpu", "strategy": ""}
    assert run_tags("benchmark", parameters) == ["esg", "benchmark", "paper", "rapier", "cpu"]


def test_tasks_name_their_scenes() -> None:
    states = [SceneState(SceneRequest("p", name=f"S{k}")) for k in (1, 1, 2, 3, 4, 5)]
    assert scene_names(states) == "S1, S2, S3 and 2 more"
    assert scene_names([SceneState(SceneRequest("A ball rolls."))]) == "A ball rolls."


def test_the_server_shows_names_tags_and_parameters(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("PREFECT_API_URL", raising=False)

    def run(stage: str, state: SceneState) -> SceneState:
        from dataclasses import replace

        return replace(state, outcome=Outcome.CRASHED)

    with session(0) as call:
        from esg.alone import guarded
        from flows.generate import generate

        monkeypatch.setattr(guarded, "run_stage", run)
        call(generate, ["A ball rolls."], 3)
        runs, tasks = _seen(os.environ["PREFECT_API_URL"])
    (mine,) = [r for r in runs if r["name"] == "generate: A ball rolls., seed 3"]
    assert {"esg", "generate", "batched", "cpu"} <= set(mine["tags"])
    assert mine["parameters"]["seed"] == 3
    assert "layout of A ball rolls." in {t["name"] for t in tasks}


def _seen(api: str) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Flow runs and task runs that a server knows."""
    import json
    import urllib.request

    def ask(what: str) -> list[dict[str, Any]]:
        request = urllib.request.Request(
            f"{api}/{what}/filter", b"{}", {"Content-Type": "application/json"}
        )
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        with opener.open(request, timeout=30) as answer:
            return json.load(answer)

    return ask("flow_runs"), ask("task_runs")
