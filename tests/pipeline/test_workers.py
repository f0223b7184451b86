"""Worker processes: warm, isolated, replaced when they die."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
import multiprocessing
import os
from pathlib import Path
import signal
import subprocess
import sys
import time
from typing import Any

import pytest

from esg import workers
from esg.workers import OutOfTime, WorkerDied, WorkerPool, default_processes


def process_id() -> int:
    return os.getpid()


def fail(text: str) -> None:
    raise ValueError(text)


def die() -> None:
    os._exit(9)


def die_once(mark: str) -> str:
    if not Path(mark).exists():
        Path(mark).write_text("")
        os._exit(9)
    return "alive"


def test_without_processes_calls_run_here() -> None:
    assert WorkerPool(0).run(process_id) == os.getpid()


def test_a_worker_lives_on_between_calls_and_after_errors() -> None:
    with WorkerPool(1) as pool:
        first = pool.run(process_id)
        assert first != os.getpid()
        with pytest.raises(ValueError, match="bad input"):
            pool.run(fail, "bad input")
        assert pool.run(process_id) == first


def test_a_worker_is_replaced_after_its_share_of_calls() -> None:
    with WorkerPool(1, recycle_after=2) as pool:
        ids = [pool.run(process_id) for _ in range(3)]
    assert ids[0] == ids[1] != ids[2]


def test_a_deadly_call_is_told_apart_from_bad_luck(tmp_path: Path) -> None:
    with WorkerPool(1) as pool:
        assert pool.run(die_once, str(tmp_path / "mark")) == "alive"
        with pytest.raises(WorkerDied, match="die"):
            pool.run(die)
        assert pool.run(process_id) != os.getpid()


def in_daemon(found: Any) -> None:
    with WorkerPool(1) as pool:
        found.put((os.getpid(), pool.run(process_id)))


def test_a_daemon_has_workers_too() -> None:
    """Dask's workers are daemons, which multiprocessing forbids to start processes."""
    context = multiprocessing.get_context("spawn")
    found = context.Queue()
    daemon = context.Process(target=in_daemon, args=(found,), daemon=True)
    daemon.start()
    daemon.join(120)
    assert daemon.exitcode == 0
    here, worker = found.get(timeout=10)
    assert (here == daemon.pid) and worker not in (here, os.getpid())


def test_workers_end_when_the_command_is_killed() -> None:
    code = (
        "import os, sys, signal\n"
        "from esg.workers import WorkerPool\n"
        "if __name__ == '__main__':\n"
        "    print(WorkerPool(1).run(os.getpid), flush=True)\n"
        "    os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False
    )
    worker = int(done.stdout)
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        try:
            os.kill(worker, 0)
        except ProcessLookupError:
            return
        if (
            Path(f"/proc/{worker}/stat").exists()
            and " Z " in Path(f"/proc/{worker}/stat").read_text()
        ):
            return
        time.sleep(0.1)
    pytest.fail("the worker outlived its command")


def sleep_and_tidy(mark: str) -> None:
    try:
        Path(mark).write_text("busy")
        time.sleep(60.0)
    finally:
        Path(mark).unlink()


def deaf(mark: str) -> None:
    signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGTERM])  # as in native code
    Path(mark).write_text("busy")
    time.sleep(60.0)


@pytest.mark.parametrize("function", [sleep_and_tidy, deaf])
def test_a_stopped_pool_interrupts_its_calls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, function: Callable[[str], None]
) -> None:
    monkeypatch.setattr(workers, "STOP_AFTER_S", 0.3)
    marks = [tmp_path / "0", tmp_path / "1"]
    with WorkerPool(2) as pool, ThreadPoolExecutor(3) as threads:
        calls = [threads.submit(pool.run, function, str(mark)) for mark in marks]
        waiting = threads.submit(pool.run, process_id)
        while not all(mark.exists() for mark in marks):
            time.sleep(0.02)
        pool.stop()
        for call in (*calls, waiting):
            with pytest.raises(KeyboardInterrupt):
                call.result(timeout=20)
    assert [mark.exists() for mark in marks] == [function is deaf] * 2


def test_a_pool_without_processes_stops_before_the_next_call() -> None:
    pool = WorkerPool(0)
    pool.stop()
    with pytest.raises(KeyboardInterrupt):
        pool.run(process_id)


def test_a_terminals_interrupt_does_not_reach_workers() -> None:
    with WorkerPool(1) as pool:
        number = pool.run(process_id)
        os.kill(number, signal.SIGINT)
        assert pool.run(process_id) == number


def test_few_scenes_need_no_processes() -> None:
    assert default_processes(1) == 0
    assert default_processes(100) >= 1


def allocate(gib: float) -> int:
    return len(bytearray(int(gib * 2**30)))


def out_of_time(mark: str) -> None:
    with Path(mark).open("a") as file:
        file.write("x")
    os._exit(workers.OUT_OF_TIME)


def test_a_worker_may_allocate_its_share_and_no_more(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ESG_WORKER_GIB", "0.5")
    with WorkerPool(1) as pool:
        assert pool.run(allocate, 0.1) > 0
        with pytest.raises(MemoryError):
            pool.run(allocate, 1.0)
        assert pool.run(process_id)
    monkeypatch.delenv("ESG_WORKER_GIB")
    monkeypatch.setattr(workers, "machine_memory", lambda: 64 * 2**30)
    assert [workers.memory_bound(n) // 2**30 for n in (1, 8, 64)] == [64, 8, 4]


def test_a_call_that_took_too_long_is_not_tried_again(tmp_path: Path) -> None:
    with WorkerPool(1) as pool, pytest.raises(OutOfTime, match="ESG_STAGE_SECONDS"):
        pool.run(out_of_time, str(tmp_path / "calls"))
    assert (tmp_path / "calls").read_text() == "x"


def test_the_lowest_rank_gets_the_next_free_worker(tmp_path: Path) -> None:
    done: list[str] = []
    with WorkerPool(1) as pool, ThreadPoolExecutor(5) as threads:
        slot = pool._take(())
        for n, (name, rank) in enumerate(
            [("proof", (1, 0)), ("late", (0, 2)), ("early", (0, 1)), ("again", (0, 1))], start=1
        ):
            threads.submit(lambda name=name, rank=rank: done.append(pool.run(str, name, rank=rank)))
            while len(pool._waiting) < n:
                time.sleep(0.001)
        pool._hand_on(slot)
        threads.shutdown()
    assert done == ["early", "again", "late", "proof"]
