"""A flow against the private API process: retries, cached states, clean-up."""

from __future__ import annotations

from dataclasses import replace
import os

import pytest

from esg.outcomes import Outcome
from esg.pipeline import STAGES, SceneRequest, SceneState
from flows.session import session


def test_flow_retries_what_may_pass_and_cleans_up(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One flow run of three scenes: one fails to connect once, one has a defect."""
    monkeypatch.delenv("PREFECT_API_URL", raising=False)
    failed: list[str] = []
    calls: list[str] = []

    def run(stage: str, state: SceneState) -> SceneState:
        calls.append(f"{stage} {state.request.prompt}")
        if stage == "layout" and state.request.prompt == "flaky" and not failed:
            failed.append("once")
            raise ConnectionResetError("reset by peer")
        if state.request.prompt == "defect":
            return replace(state, outcome=Outcome.CRASHED)
        entry = {"stage": stage, "cached": stage == "draft", "seconds": 0.0}
        return replace(state, log=(*state.log, entry))

    heard: list[str] = []
    with session(0, lambda stage, state: heard.append(stage)) as call:
        api = os.environ["PREFECT_API_URL"]
        from esg.alone import guarded
        from flows.generate import generate

        monkeypatch.setattr(guarded, "run_stage", run)
        states = call(generate, ["good", "flaky", "defect"])
    assert api.startswith("http://127.0.0.1:")
    assert "PREFECT_API_URL" not in os.environ
    assert [len(s.log) for s in states] == [len(STAGES), len(STAGES), 0]
    assert states[2].outcome is Outcome.CRASHED
    assert calls.count("layout flaky") == 2
    assert set(heard) == set(STAGES)
    assert states[0].request == SceneRequest("good")
