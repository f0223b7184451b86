"""Kernels that gather the touches of many scenes: sums of pairs become a list on the device."""

from __future__ import annotations

# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
import warp as wp

wp.set_module_options({"enable_backward": False})


@wp.kernel(enable_backward=False)
def pack_pairs(
    frame: int,
    impulse: wp.array2d(dtype=wp.int64),
    first: wp.array2d(dtype=int),
    depth: wp.array2d(dtype=float),
    moments: wp.array3d(dtype=wp.int64),
    count: wp.array(dtype=int),
    ints: wp.array2d(dtype=int),
    depths: wp.array(dtype=float),
    sums: wp.array2d(dtype=wp.int64),
):
    """Appends the pairs that touched in a chunk to a list, in any order, and clears the chunk."""
    slot, p = wp.tid()
    weight = impulse[slot, p]
    if weight > wp.int64(0):
        row = wp.atomic_add(count, 0, 1)
        if row < depths.shape[0]:
            ints[row, 0] = frame + slot
            ints[row, 1] = p
            ints[row, 2] = first[slot, p]
            depths[row] = depth[slot, p]
            sums[row, 0] = weight
            for k in range(6):
                sums[row, 1 + k] = moments[slot, p, k]
    impulse[slot, p] = wp.int64(0)
    first[slot, p] = 2147483647
    depth[slot, p] = 0.0
    for k in range(6):
        moments[slot, p, k] = wp.int64(0)


@wp.kernel(enable_backward=False)
def begin_chunk(clock: wp.array(dtype=int), first: int, frames: int):
    """Tells the kernels of a step which frames the sums of pairs are for."""
    clock[2] = first
    clock[3] = frames
