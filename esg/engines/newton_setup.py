"""Warp without its banner, Newton's kernels shared by all models, and how the solver is set."""

from __future__ import annotations

from functools import cache
import os
from typing import Any

STEPS_PER_GRAPH = 4
"""Even, so that the two states are back in place after one launch of the graph."""

ITERATIONS = 6
RESTITUTION_THRESHOLD_MPS = 0.2
CONTACT_GAP_M = 0.005
SPECULATIVE_GAP_M = 0.25
"""Fast bodies are seen as far ahead as they move in a step, up to this distance [m]."""

POINTS_PER_WORLD = 16
POINTS_PER_SHAPE = 4
"""Room for contact points before it has to grow."""


@cache
def quiet_warp() -> Any:
    """Imports and initializes warp without its banner and its notice that there is no GPU."""
    import warp as wp

    wp.config.quiet = True
    wp.config.log_level = wp.LOG_WARNING
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
    return wp


@cache
def share_kernels() -> None:
    """Lets all models of a process share Newton's narrow-phase kernels.

    Newton writes these two kernels anew for every collision pipeline, although they depend on a
    few switches only. Generating and hashing them again takes longer than simulating a scene.
    """
    from newton._src.geometry import narrow_phase

    for name in ("create_narrow_phase_primitive_kernel", "create_narrow_phase_kernel_gjk_mpr"):
        factory = getattr(narrow_phase, name, None)
        if factory is not None:
            setattr(narrow_phase, name, cache(factory))
