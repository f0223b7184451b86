"""Workers forked off one process that has loaded everything, instead of loading it each.

Sixteen workers that start at once each spend ten processor seconds on imports and first uses. Here
one process does that once, by itself, while the command plans and its scheduler starts; workers
are forked off it (`multiprocessing`'s fork server) and share what it has loaded. It uses no GPU,
which a fork could not use, and runs one thread.
"""

from __future__ import annotations

from collections.abc import Mapping
import multiprocessing
from multiprocessing import forkserver
from multiprocessing.context import BaseContext
import os
import sys

from esg.workers import usable_cores

LOADER = "esg.api.loading"
"""The module that the process imports; it loads what `ASKED` says."""
ASKED = "ESG_FORKED_OFF"
"""Says how workers search, in that process alone."""
DRAFTING = "drafting"
"""They do not: a GPU waits for what they draft, and they are forked off as soon as they can."""
RENEWED_AFTER = 12
"""Calls after which a worker that was forked off is replaced: the next one costs little, and what
bounded caches, modules of kernels and holes between them take up grows slowly, but for weeks."""
SHARES_BEFORE_RENEWAL = 96
"""The same for workers beside a GPU, whose calls are half of a batch's work or less, and which load
six seconds of libraries each that the process they are forked off had no time for."""
_TOLD = ("ESG_", "PYTHON", "HOME", "XDG_", "TMPDIR", "LANG", "LC_")
"""What starts so in the environment may decide what is loaded, or where from."""
_OWN = {
    "CUDA_VISIBLE_DEVICES": "",
    "PXR_WORK_THREAD_LIMIT": "1",  # USD's threads do not survive forks
    "TF_ENV_SETTING_ALERTS_ENABLED": "0",
    "OMP_NUM_THREADS": "1",
    "ESG_THREADS": "1",
}
_running: dict[str, str] | None = None
"""What `_TOLD` names, as it was when the process started."""


def begin(search: str) -> None:
    """Starts the process, which loads by itself from then on; a second call does nothing.

    Args:
        search: The strategy of the searches that workers run (`esg.dynamics`), or `DRAFTING`.
    """
    global _running
    if _running is not None or sys.platform != "linux" or usable_cores() < 2:
        return
    before = dict(os.environ)
    _running = _told(before)
    multiprocessing.get_context("forkserver").set_forkserver_preload([LOADER])
    os.environ.update(_OWN, **{ASKED: search})
    try:
        forkserver.ensure_running()
    finally:
        for name in (*_OWN, ASKED):
            if name in before:
                os.environ[name] = before[name]
            else:
                del os.environ[name]


def context() -> BaseContext:
    """How workers start: forked off, if the process was begun in this environment; else spawned."""
    same = _running is not None and _running == _told(os.environ)
    return multiprocessing.get_context("forkserver" if same else "spawn")


def _told(environment: Mapping[str, str]) -> dict[str, str]:
    return {k: v for k, v in environment.items() if k.startswith(_TOLD)}
