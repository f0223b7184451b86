"""Starting together without waiting for each other forever."""

from __future__ import annotations

import subprocess
import sys

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


def run(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=120, check=False
    )


def test_usd_that_is_loaded_first_waits_for_nobody() -> None:
    """USD's constructors wait for Python's lock while they hold the loader's."""
    done = run(_BUSY_LOADER.format(before="load_usd()"))
    assert done.returncode == 0, done.stderr


def test_a_session_loads_usd_before_it_starts_a_thread() -> None:
    """Loaded in the warm-up thread, it hung the first command of a fresh installation."""
    done = run(_SESSION)
    assert done.returncode == 0, done.stderr
