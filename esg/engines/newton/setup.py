"""Warp without its banner, and how the solver is set."""

from __future__ import annotations

from functools import cache
import os
from typing import Any

from esg.outcomes import UserError
from esg.paths import kernel_cache_dir
from esg.workers import usable_cores

STEPS_PER_GRAPH, STEPS_PER_GRAPH_CPU = 4, 2
"""Even, so that the two states are back in place after one launch of the graph. On the CPU a launch
costs next to nothing, while each step takes 12 ms to record for every scene."""

ITERATIONS, LOOSE_ITERATIONS = 6, 24
"""Sweeps of the solver; more where joints are made of contacts."""
RESTITUTION_THRESHOLD_MPS = 0.2
FIXED_POINT = 1.0e9
"""Units per N s (and N s m) of the integer sums; integers make atomic sums independent of order."""
CONTACT_GAP_M = 0.005
BAUMGARTE = 0.2
"""Share of an overlap that the solver makes up for in a step."""
DRIVE_GAIN = 1e9
"""Damping towards the speed of a motor or of what rubs [N m s or N s/m]: as good as rigid."""
SPECULATIVE_GAP_M = 0.25
"""Fast bodies are seen as far ahead as they move in a step, up to this distance [m]."""


@cache
def quiet_warp() -> Any:
    """Imports and initializes warp without its banner and its notice that there is no GPU."""
    import warp as wp

    wp.config.log_level = wp.LOG_ERROR  # what an older version left in a cache is no news
    wp.config.kernel_cache_dir = str(kernel_cache_dir().parent)  # it adds its version
    # The notice is printed by native code, past Python's sys.stderr.
    saved = os.dup(2)
    null = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(null, 2)
        wp.init()
    finally:
        os.dup2(saved, 2)
        os.close(saved)
        os.close(null)
    wp.config.log_level = wp.LOG_WARNING
    return wp


def known_device(device: str, who: str) -> str:
    """The device, if this machine has it.

    Args:
        device: Warp device, such as "cpu" or "cuda:0".
        who: Asks for it, for the message.

    Raises:
        UserError: If it does not exist.
    """
    known = [str(d) for d in quiet_warp().get_devices()]
    if device not in known:
        raise UserError(f"no device {device!r} for {who}; this machine has {', '.join(known)}")
    return device


def cpu_threads() -> int:
    """Threads that share the worlds of a batch: as many as cores, at most four, or ESG_THREADS.

    Raises:
        UserError: If ESG_THREADS is no positive number.
    """
    text = os.environ.get("ESG_THREADS", "")
    if not text:
        return min(4, usable_cores())
    if not (text.isdigit() and int(text) > 0):
        raise UserError(f"ESG_THREADS is {text!r}; it must be a positive number of threads")
    return int(text)
