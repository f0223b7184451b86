"""Workers that are forked off one process: loaded once, otherwise as if they were spawned."""

from __future__ import annotations

import os
from pathlib import Path
import signal
import subprocess
import sys
import time

import pytest

from esg.machine import forked

pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or len(os.sched_getaffinity(0)) < 2, reason="needs forks and two cores"
)

CODE = """
import os, signal, sys
from esg.machine import forked
from esg.workers import WorkerPool
from tests.pipeline.test_forked import seen

if __name__ == "__main__":
    forked.begin(forked.DRAFTING)
    os.environ["UNRELATED"] = "told"
    with WorkerPool(2, context=forked.context) as pool:
        print(*pool.run(seen), flush=True)
        if sys.argv[1] == "killed":
            os.kill(os.getpid(), signal.SIGKILL)
        os.environ["ESG_TEST_OTHER"] = "1"
        pool.close()
        print(*pool.run(seen), flush=True)
"""


def seen() -> tuple[object, ...]:
    """What a worker finds: itself, its parent, what is loaded, threads there, its environment."""
    status = Path(f"/proc/{os.getppid()}/status").read_text()
    threads = next(x.split()[1] for x in status.splitlines() if x.startswith("Threads"))
    return (
        os.getpid(),
        os.getppid(),
        "esg.api.loading" in sys.modules,
        threads,
        os.environ.get("UNRELATED"),
        forked.ASKED in os.environ,
        os.environ.get("CUDA_VISIBLE_DEVICES"),
    )


def command(how: str) -> subprocess.CompletedProcess[str]:
    environment = {k: v for k, v in os.environ.items() if k != "CUDA_VISIBLE_DEVICES"}
    return subprocess.run(
        [sys.executable, "-c", CODE, how],
        capture_output=True, text=True, timeout=120, check=False, env=environment,
        cwd=Path(__file__).parents[2],
    )  # fmt: skip


def test_a_forked_worker_is_loaded_and_a_changed_environment_gets_a_spawned_one() -> None:
    done = command("whole")
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""  # what libraries say while they load reaches nobody
    first, second = (line.split() for line in done.stdout.splitlines())
    assert first[2:] == ["True", "1", "told", "False", "None"]
    assert second[2] == "False" and second[4] == "told"
    assert second[1] != first[1]  # the command's own child


def test_forked_workers_end_when_the_command_is_killed() -> None:
    done = command("killed")
    assert done.returncode == -signal.SIGKILL
    worker, server = (Path("/proc", pid, "stat") for pid in done.stdout.split()[:2])
    deadline = time.monotonic() + 20.0
    while time.monotonic() < deadline and any(_lives(p) for p in (worker, server)):
        time.sleep(0.1)
    assert not _lives(worker) and not _lives(server)


def _lives(stat: Path) -> bool:
    try:
        return stat.read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
