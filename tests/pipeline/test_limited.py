"""A stage may take so long and no longer, in the command's process as in a worker."""

from __future__ import annotations

import os
from pathlib import Path
import subprocess
import sys
import time

import pytest

from esg.limits import StageTimeout, limited
from esg.outcomes import Outcome, UserError
from esg.pipeline import SceneRequest, SceneState
from esg.settings import STAGE_S, check_limits
from tasks.batch import run_batch

ROOT = Path(__file__).parents[2]


def test_what_python_runs_is_interrupted_and_nothing_later() -> None:
    told = r"layout ran longer than its limit of 0\.2 s"
    with pytest.raises(StageTimeout, match=told), limited("layout", 0.2):
        deadline = time.monotonic() + 30.0
        while time.monotonic() < deadline:
            sum(range(1000))
    with limited("layout", 30.0):
        pass
    for _ in range(100):
        time.sleep(0.001)


def test_a_stage_without_a_limit_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_STAGE_SECONDS", "0")
    assert STAGE_S.value == 0.0
    with limited("layout"):
        pass


def test_no_handler_of_a_stage_swallows_the_interruption(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The scene ends as crashed in that stage, the others of its batch go on."""

    def run(stage: str, state: SceneState) -> SceneState:
        deadline = time.monotonic() + 30.0
        while "hangs" in state.request.prompt and time.monotonic() < deadline:
            try:
                sum(range(1000))
            except Exception:
                continue
        return state

    monkeypatch.setenv("ESG_STAGE_SECONDS", "0.3")
    monkeypatch.setattr("esg.alone.guarded.run_stage", run)
    states = [SceneState(SceneRequest(p)) for p in ("a", "b hangs", "c")]
    done = run_batch("optimize", states, last_attempt=True)
    assert [s.outcome for s in done] == [None, Outcome.CRASHED, None]
    assert done[1].log[-1]["stage"] == "optimize"
    assert "optimize ran longer than its limit of 0.3 s (ESG_STAGE_SECONDS)" in done[1].reason


def test_native_code_that_never_comes_back_ends_the_command_with_a_message() -> None:
    code = (
        "import esg.limits, time\n"
        "esg.limits._INTERRUPTS = 1\n"
        "with esg.limits.limited('optimize', 0.3):\n"
        "    time.sleep(60.0)\n"
    )
    start = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert (done.returncode, time.monotonic() - start < 30) == (1, True)
    assert done.stderr == "esg: optimize ran longer than its limit of 0.3 s (ESG_STAGE_SECONDS)\n"


def test_every_limit_that_is_no_number_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_STAGE_SECONDS", "soon")
    monkeypatch.setenv("ESG_SQL_GIB", "-1")
    monkeypatch.setenv("ESG_WORKER_GIB", "nan")
    with pytest.raises(UserError) as told:
        check_limits()
    assert [line.split("=")[0] for line in str(told.value).splitlines()] == [
        "ESG_STAGE_SECONDS", "ESG_WORKER_GIB", "ESG_SQL_GIB",
    ]  # fmt: skip
