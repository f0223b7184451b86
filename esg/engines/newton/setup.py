"""Warp without its banner, Newton's kernels shared by all models, and how the solver is set."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import cache, wraps
import os
from typing import Any

from esg.outcomes import UserError

STEPS_PER_GRAPH, STEPS_PER_GRAPH_CPU = 4, 2
"""Even, so that the two states are back in place after one launch of the graph. On the CPU a launch
costs next to nothing, while each step takes 12 ms to record for every scene."""

ITERATIONS = 6
RESTITUTION_THRESHOLD_MPS = 0.2
FIXED_POINT = 1.0e9
"""Units per N s (and N s m) of the integer sums; integers make atomic sums independent of order."""
CONTACT_GAP_M = 0.005
SPECULATIVE_GAP_M = 0.25
"""Fast bodies are seen as far ahead as they move in a step, up to this distance [m]."""


@cache
def quiet_warp() -> Any:
    """Imports and initializes warp without its banner and its notice that there is no GPU."""
    import warp as wp

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
        return min(4, len(os.sched_getaffinity(0)))
    if not (text.isdigit() and int(text) > 0):
        raise UserError(f"ESG_THREADS is {text!r}; it must be a positive number of threads")
    return int(text)


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


@cache
def sort_few_contacts() -> None:
    """Lets Newton sort the contacts there are on the CPU, not all it has room for.

    Before friction is solved, every step sorts the contacts of all worlds by pair of bodies. Warp's
    radix sort counts in four tables of 65,536 numbers whatever there is to sort, which took a third
    of the time of a scene with few contacts. The order is the same.
    """
    wp = quiet_warp()
    from newton._src.solvers.steel import friction_patches

    from esg.engines.newton.kernels import sort_pairs

    state = getattr(friction_patches, "_FrictionPatchState", None)
    if state is None or not hasattr(state, "build"):
        return
    build = state.build

    @wraps(build)
    def build_and_sort(self: Any, model: Any, poses: Any, contacts: Any, **options: Any) -> None:
        if model.device.is_cuda:
            build(self, model, poses, contacts, **options)
            return
        with _sorting(wp, self.current.keys, contacts.rigid_contact_count, sort_pairs):
            build(self, model, poses, contacts, **options)

    state.build = build_and_sort


@contextmanager
def _sorting(wp: Any, known: Any, count: Any, kernel: Any) -> Generator[None]:
    """Sorts `known`, whose first count[0] keys are in use, by a kernel, all else as always."""
    usual = wp.utils.radix_sort_pairs

    def sort(keys: Any, values: Any, limit: int, *bits: Any, **more: Any) -> None:
        if keys is known and not bits and not more:
            wp.launch(kernel, dim=1, inputs=[count, limit, keys, values], device=keys.device)
        else:
            usual(keys, values, limit, *bits, **more)

    wp.utils.radix_sort_pairs = sort
    try:
        yield
    finally:
        wp.utils.radix_sort_pairs = usual
