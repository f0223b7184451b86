"""The deployment file, against a server of this machine: deployed, started by a worker, finished."""

from __future__ import annotations

import json
import os
from pathlib import Path
import subprocess
import sys
from typing import Any
import urllib.request

import pytest

from flows.artifacts import REPORTS_URL, _address
from flows.embedded import prefect_api

ROOT = Path(__file__).parents[2]
SUITE = """
suite: nothing
scenes:
  - {id: A, prompt: "xyzzy plugh", events: []}
"""


def prefect(*arguments: str, **variables: str) -> str:
    """Output of a Prefect command that succeeded."""
    done = subprocess.run(
        [sys.executable, "-m", "prefect", "--no-prompt", *arguments], cwd=ROOT,
        env={**os.environ, "PREFECT_CLI_COLORS": "false", **variables},
        capture_output=True, text=True, timeout=240, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def ask(what: str) -> list[dict[str, Any]]:
    request = urllib.request.Request(
        f"{os.environ['PREFECT_API_URL']}/{what}/filter", b"{}",
        {"Content-Type": "application/json"},
    )  # fmt: skip
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with opener.open(request, timeout=30) as answer:
        return json.load(answer)


@pytest.mark.slow
def test_a_worker_runs_a_night_of_the_deployment(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PREFECT_API_URL", raising=False)
    suite = tmp_path / "nothing.yaml"
    suite.write_text(SUITE)
    with prefect_api() as api:
        api.wait()
        prefect("work-pool", "create", "esg", "--type", "process")
        prefect("deploy", "--all")
        (deployed,) = ask("deployments")
        assert deployed["entrypoint"] == "flows/nightly.py:nightly"
        assert [s["schedule"]["cron"] for s in deployed["schedules"]] == ["0 3 * * *"]
        night = {"suites": [str(suite)], "runs": 1, "out": str(tmp_path / "nights"),
                 "database": str(tmp_path / "x.duckdb"), "raise_on_regression": False}  # fmt: skip
        prefect("deployment", "run", "nightly/nightly", "--params", json.dumps(night))
        prefect("worker", "start", "--pool", "esg", "--run-once", ESG_HOME=str(ROOT))
        (run,) = [r for r in ask("flow_runs") if r["name"].startswith("nightly")]
        assert run["state_type"] == "COMPLETED", run["state"]["message"]
        assert {"esg", "nightly"} <= set(run["tags"])
        assert {a["key"] for a in ask("artifacts")} >= {"nightly-nothing", "nightly-nothing-report"}


def test_reports_are_linked_to_where_they_are_served(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    report = tmp_path / "nights" / "a b" / "report.html"
    monkeypatch.delenv(REPORTS_URL, raising=False)
    link, said = _address(report, tmp_path / "nights")
    assert link == report.as_uri()
    assert REPORTS_URL in said
    monkeypatch.setenv(REPORTS_URL, "http://reports.example.org:8081/")
    link, _ = _address(report, tmp_path / "nights")
    assert link == "http://reports.example.org:8081/a%20b/report.html"
    outside, _ = _address(tmp_path / "report.html", tmp_path / "nights")
    assert outside.startswith("file:")
