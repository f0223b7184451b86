"""Traces and numbers of a run, behind their switches."""

from __future__ import annotations

import json
from pathlib import Path
import socket
import urllib.request

import pytest

from esg.outcomes import UserError
from esg.progress import StageEvent, emit
from esg.telemetry.watching import watched

pytest.importorskip("opentelemetry.sdk", reason="the extra `observe` is not installed")

SCENE = ("A ball rolls.", 3)


def event(stage: str, status: str, outcome: str = "", *, cached: bool = False) -> StageEvent:
    scene, seed = SCENE
    return StageEvent(scene, stage, status, seed, 0.25, cached, outcome, "why")  # type: ignore[arg-type]


def a_run() -> None:
    """Two stages; the search claims what the judge takes back."""
    emit(event("optimize", "started"))
    emit(event("optimize", "finished", "solved"))
    emit(event("judge", "started"))
    emit(event("judge", "finished", "not_converged", cached=True))


def test_nothing_is_loaded_without_the_switch(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ESG_TRACES", raising=False)
    monkeypatch.delenv("ESG_PROMETHEUS", raising=False)
    monkeypatch.setitem(__import__("sys").modules, "opentelemetry.sdk.trace", None)
    with watched(["generate"]):
        a_run()


def test_a_trace_has_a_span_a_stage_below_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "spans.jsonl"
    monkeypatch.setenv("ESG_TRACES", str(path))
    with watched(["bench", "paper"]):
        a_run()
    spans = {s["name"]: s for s in map(json.loads, path.read_text().splitlines())}
    assert set(spans) == {"esg bench", "optimize", "judge"}
    root = spans["esg bench"]["context"]
    for stage in ("optimize", "judge"):
        assert spans[stage]["parent_id"] == root["span_id"]
        assert spans[stage]["context"]["trace_id"] == root["trace_id"]
        assert spans[stage]["attributes"]["esg.scene"] == SCENE[0]
    assert spans["judge"]["attributes"]["esg.cached"] is True
    assert spans["judge"]["attributes"]["esg.outcome"] == "not_converged"


def test_a_crash_is_an_error_span(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "spans.jsonl"
    monkeypatch.setenv("ESG_TRACES", str(path))
    with watched([]):
        emit(event("layout", "started"))
        emit(event("layout", "finished", "crashed"))
    spans = {s["name"]: s for s in map(json.loads, path.read_text().splitlines())}
    assert spans["layout"]["status"] == {"status_code": "ERROR", "description": "why"}


def expected(text: str) -> None:
    assert 'esg_stage_seconds_count{stage="optimize"} 1.0' in text
    assert 'esg_stage_seconds_sum{stage="optimize"} 0.25' in text
    assert 'esg_cached_stages_total{stage="judge"} 1.0' in text
    assert 'esg_scenes{outcome="not_converged"} 1.0' in text
    assert 'esg_scenes{outcome="solved"} 0.0' in text
    assert 'esg_running_stages{stage="judge"} 0.0' in text


def test_numbers_in_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "esg.prom"
    monkeypatch.setenv("ESG_PROMETHEUS", str(path))
    with watched(["generate"]):
        a_run()
    expected(path.read_text())


def test_numbers_at_a_port_while_the_command_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    monkeypatch.setenv("ESG_PROMETHEUS", str(port))
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with watched(["generate"]):
        a_run()
        with opener.open(f"http://127.0.0.1:{port}/metrics", timeout=30) as answer:
            expected(answer.read().decode())


@pytest.mark.parametrize("where", ["70000", "no/such/folder/x.prom", "x.txt", "-1"])
def test_a_place_that_is_none_is_told(where: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_PROMETHEUS", where)
    with pytest.raises(UserError, match="ESG_PROMETHEUS"), watched([]):
        pass


def test_a_trace_that_cannot_be_written_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_TRACES", "no/such/folder/x.jsonl")
    with pytest.raises(UserError, match=r"ESG_TRACES.*otlp"), watched([]):
        pass
