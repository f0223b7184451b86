"""Limits on how many scenes may be in one stage at a time."""

from __future__ import annotations

from pathlib import Path
import subprocess
import sys
import threading
import time

import pytest

from esg.limits import place_in, stage_limits
from esg.outcomes import UserError


def crowd(stage: str, people: int) -> int:
    """The most that were in a stage at a time."""
    inside, most, lock = [0], [0], threading.Lock()

    def visit() -> None:
        with place_in(stage):
            with lock:
                inside[0] += 1
                most[0] = max(most[0], inside[0])
            time.sleep(0.1)
            with lock:
                inside[0] -= 1

    threads = [threading.Thread(target=visit) for _ in range(people)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return most[0]


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_CACHE_DIR", str(tmp_path))


def test_no_more_than_the_limit_are_in_a_stage(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_STAGE_LIMITS", "optimize=2, replay=1")
    assert crowd("optimize", 6) == 2
    assert crowd("replay", 3) == 1
    assert crowd("judge", 6) > 2


def test_a_killed_process_leaves_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_STAGE_LIMITS", "optimize=1")
    code = "from esg.limits import place_in\nimport time\n"
    code += "with place_in('optimize'):\n print('in', flush=True)\n time.sleep(60)"
    with subprocess.Popen(
        [sys.executable, "-c", code], stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "in\n"
        threading.Timer(0.3, process.kill).start()
        start = time.monotonic()
        with place_in("optimize"):
            assert time.monotonic() - start > 0.2


def test_every_mistake_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(UserError) as told:
        stage_limits("optimise=1,replay=0,judge,draft=3")
    text = str(told.value)
    assert "no stage 'optimise'" in text
    assert "replay=2" in text
    assert "judge=2" in text
    assert "draft" not in text.replace("stages are draft", "")
    assert stage_limits("") == {}
