"""Ctrl-C and SIGTERM: an answer within two seconds, a message, the right exit code."""

from __future__ import annotations

import ctypes
import os
from pathlib import Path
import signal
import subprocess
import sys
import time

import pytest

ROOT = Path(__file__).parents[2]
BUSY = {
    "python": "while True: pass",
    # Another thread gets the signal: this one comes back to Python in a minute.
    "native": "import ctypes, signal\n"
    "signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT, signal.SIGTERM])\n"
    "ctypes.CDLL(None).sleep(60)",
    "finalizer": "class Held:\n    def __del__(self):\n        import time; time.sleep(60)\n"
    "Held()\nwhile True: pass",
    "query": "import duckdb\nduckdb.execute('SELECT count(*) FROM range(10000000) a, '\n"
    "    'range(100000) b WHERE a.range % 7 = b.range % 5')",
    "slow to unwind": "try:\n    import time; time.sleep(60)\nfinally:\n    time.sleep(60)",
}


@pytest.mark.parametrize("what", list(BUSY))
@pytest.mark.parametrize(
    ("number", "code", "word"),
    [(signal.SIGINT, 130, "interrupted"), (signal.SIGTERM, 143, "terminated (SIGTERM)")],
)
def test_a_command_answers_whatever_it_is_doing(
    what: str, number: int, code: int, word: str, tmp_path: Path
) -> None:
    body = "".join(f"    {line}\n" for line in BUSY[what].splitlines())
    script = (
        "import sys\nfrom esg import cli\nsys.argv = ['esg', 'doctor', '--json']\n"
        f"def app():\n    print('busy', file=sys.stderr, flush=True)\n{body}\n"
        "cli.build_app = app\ncli.main()\n"
    )
    command = subprocess.Popen(
        [sys.executable, "-c", script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    assert command.stderr is not None
    assert command.stderr.readline() == "busy\n"
    time.sleep(1.0 if what == "query" else 0.1)
    start = time.monotonic()
    command.send_signal(number)
    out, err = command.communicate(timeout=30)
    assert time.monotonic() - start < 10  # 2 s, on a machine that does something else as well
    assert command.returncode == code
    assert err.startswith(f"esg: {word}; finished stages are kept")
    assert err.count("\n") == 1
    assert f'"exit_code": {code}' in out


def hold(mark: str) -> None:
    """Native code that lets no other thread of Python's go on."""
    Path(mark).touch()
    ctypes.PyDLL(None).sleep(60)


def test_workers_that_do_not_listen_end_with_the_command(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    script = (
        "import sys\nfrom esg import cli\nfrom esg.workers import WorkerPool\n"
        "from tests.cli.test_stopping import hold\nsys.argv = ['esg', 'doctor']\n"
        f"def app():\n    WorkerPool(1).run(hold, {str(mark)!r})\n"
        "cli.build_app = app\ncli.main()\n"
    )
    command = subprocess.Popen(
        [sys.executable, "-c", script], stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    while not mark.exists():
        assert command.poll() is None
        time.sleep(0.05)
    command.send_signal(signal.SIGTERM)
    command.communicate(timeout=30)  # until nobody has its output any more
    assert command.returncode == 143
