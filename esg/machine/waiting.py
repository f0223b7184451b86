"""How a process waits for its GPU."""

from __future__ import annotations

import contextlib
import ctypes

_BLOCKING_SYNC = 0x04
"""CU_CTX_SCHED_BLOCKING_SYNC of CUDA's driver API."""


def sleep_for_gpus() -> int:
    """Lets this process sleep while it waits for a GPU; CUDA has it ask again and again by default.

    That answers some microseconds sooner and takes a whole core, of which several processes that
    share a GPU have better use. It must be called before anything uses the GPU.

    Returns:
        The number of GPUs that were told; 0 where there is no NVIDIA driver.
    """
    with contextlib.suppress(OSError):
        cuda = ctypes.CDLL("libcuda.so.1")
        count = ctypes.c_int(0)
        if cuda.cuInit(0) == 0 and cuda.cuDeviceGetCount(ctypes.byref(count)) == 0:
            tell = cuda.cuDevicePrimaryCtxSetFlags_v2
            return sum(1 for k in range(count.value) if tell(k, _BLOCKING_SYNC) == 0)
    return 0
