"""Starting together without waiting for each other forever."""

from __future__ import annotations

import ast
import subprocess
import sys

from esg.machine.forked import RENEWED_AFTER, SHARES_BEFORE_RENEWAL

_BUSY_LOADER = """
import ctypes, threading
from flows.session import load_usd
{before}
thread = threading.Thread(target=load_usd)
thread.start()
while thread.is_alive():  # as importing a compiled module does: Python's lock held, the loader's asked
    ctypes.CDLL("libm.so.6")
"""

_SESSION = """
import contextlib, os, sys, threading
import flows.session as session
seen = []
session.warm_up = lambda: seen.append("pxr.UsdPhysics" in sys.modules)
session.prefect_api = contextlib.nullcontext
os.environ["PREFECT_API_URL"] = "http://127.0.0.1:9/api"
with session.session(0):
    for thread in threading.enumerate():
        if thread is not threading.current_thread() and not thread.name.startswith("prefect"):
            thread.join(5)
assert seen == [True], seen
"""


_RENEWALS = """
import contextlib, os, sys
import flows.session as session
made = []
class Pool(session.WorkerPool):
    def __init__(self, processes, recycle_after=0, *more, **options):
        made.append((processes, recycle_after))
        super().__init__(0, recycle_after, *more, **options)
    def warm(self, function, *args):
        made.append((function.__name__, args))
session.WorkerPool = Pool
session.begin = lambda forked: None
session.load_usd = session.warm_up = lambda *args: None
session.prefect_api = contextlib.nullcontext
os.environ["PREFECT_API_URL"] = "http://127.0.0.1:9/api"
with session.session(4, searchers=int(sys.argv[1]), forked="drafting"):
    pass
print(made)
"""


def run(code: str, *args: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code, *args],
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_usd_that_is_loaded_first_waits_for_nobody() -> None:
    """USD's constructors wait for Python's lock while they hold the loader's."""
    done = run(_BUSY_LOADER.format(before="load_usd()"))
    assert done.returncode == 0, done.stderr


def test_a_session_loads_usd_before_it_starts_a_thread() -> None:
    """Loaded in the warm-up thread, it hung the first command of a fresh installation."""
    done = run(_SESSION)
    assert done.returncode == 0, done.stderr


def test_workers_beside_searches_live_for_more_calls_as_each_is_smaller() -> None:
    """Each of them loads what comes after drafts; replaced as often as others, they load all day.

    Processes that search are told that others need the cores.
    """
    alone, beside = (run(_RENEWALS, n) for n in "02")
    assert alone.returncode == 0, alone.stderr
    assert beside.returncode == 0, beside.stderr
    without, with_searches = (ast.literal_eval(r.stdout) for r in (alone, beside))
    assert without[0] == (4, RENEWED_AFTER)
    assert with_searches[0] == (4, SHARES_BEFORE_RENEWAL)
    assert SHARES_BEFORE_RENEWAL >= 4 * RENEWED_AFTER
    assert ("<lambda>", (True,)) in with_searches
