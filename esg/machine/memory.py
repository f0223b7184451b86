"""Memory that is free in a process and that the system could use."""

from __future__ import annotations

import ctypes
import gc
import multiprocessing
import sys

_state = {"settled": False}


def give_back() -> None:
    """Gives free memory back to the system; for a worker between two batches.

    What a scene needs for a moment, pictures above all, leaves holes between what stays: glibc
    keeps them, 60 to 130 MiB in a worker that renders, more of them the longer it lives. Objects in
    circles go first: with a million that stay, Python looks for them only once a quarter as many
    are new. In a worker those that are there after its first batch (models, words, kernels) are not
    looked through again, which makes every later search a short one.
    """
    gc.collect()
    if not _state["settled"] and multiprocessing.parent_process() is not None:
        gc.freeze()
        _state["settled"] = True
    if "pyarrow" in sys.modules:
        import pyarrow as pa

        pa.default_memory_pool().release_unused()
    trim = getattr(_c_library(), "malloc_trim", None)
    if trim is not None:
        trim(ctypes.c_size_t(0))


def _c_library() -> ctypes.CDLL | None:
    """The C library of this process; None on Windows, which has no such call."""
    return None if sys.platform == "win32" else ctypes.CDLL(None)
