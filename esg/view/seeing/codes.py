"""Exact channels as whole numbers of 16 bits, and back again.

Scales and offsets are of single precision on both sides: what is read is what was meant.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating]
Codes = NDArray[np.uint16]

MOST = 65535
SHIFT_ZERO = 32768
SHIFT_MOST = 32767
FARTHEST_SHIFT = 2.0
"""Shifts beyond so many of the picture's longer sides are not told: they would blur all others."""


def depth_codes(depth: Floats) -> tuple[Codes, np.float32, np.float32]:
    """Distances of one picture, in equal steps of their logarithm.

    From the nearest to the farthest pixel all relative errors are alike: 1 mm to 2 km is told to
    one part in 8,000, a room to one in 60,000. Equal steps in metres would tell a ball 3 m away to
    3 cm wherever the horizon is seen.

    Args:
        depth: Along the camera's axis [m], 0 where nothing is hit, shape [H, L].

    Returns:
        Codes (0 nothing), offset and scale: metres are exp(offset + scale * code).
    """
    hit = depth > 0
    if not hit.any():
        return np.zeros(depth.shape, np.uint16), np.float32(0), np.float32(0)
    log = np.log(np.where(hit, depth, 1.0).astype(np.float64))
    low, high = log.min(where=hit, initial=np.inf), log.max(where=hit, initial=-np.inf)
    # The last step leaves room for the rounding of the scale itself.
    scale = np.float32(max(high - low, 1e-6) / (MOST - 2))
    offset = np.float32(low - float(scale))
    log -= float(offset)
    log /= float(scale)
    np.rint(log, out=log)
    np.clip(log, 1, MOST, out=log)
    out = log.astype(np.uint16)
    out[~hit] = 0
    return out, offset, scale


def depth_metres(codes: Codes, offset: float, scale: float) -> NDArray[np.float32]:
    """The inverse of `depth_codes` [m], 0 where nothing is hit."""
    metres = np.exp(float(offset) + float(scale) * codes.astype(np.float64))
    return np.where(codes > 0, metres, 0.0).astype(np.float32)


def shift_codes(shift: Floats) -> tuple[Codes, np.float32]:
    """Shifts of one picture, in steps of 1/32767 of the longest.

    Args:
        shift: Of every pixel to where its surface is in another picture [px], NaN where unknown,
            shape [H, L, 2].

    Returns:
        Codes (u, v, 65535 where known), shape [H, L, 3], and the scale [px]: (u, v) is
        (codes - 32768) * scale.
    """
    ways = [np.ascontiguousarray(shift[..., k], np.float32) for k in range(2)]
    size = np.maximum(np.abs(ways[0]), np.abs(ways[1]))
    told = size <= FARTHEST_SHIFT * max(size.shape)  # no NaN is
    longest = float(size.max(where=told, initial=0.0))
    scale = np.float32(longest / SHIFT_MOST) if longest > 0 else np.float32(1.0)
    out, unknown = _planes(told.shape), ~told
    for k, way in enumerate(ways):
        way = way / scale
        np.rint(way, out=way)
        np.clip(way, -SHIFT_MOST, SHIFT_MOST, out=way)
        way += SHIFT_ZERO
        way[unknown] = 0
        out[k] = way
    np.multiply(told, np.uint16(MOST), out=out[2])
    return np.moveaxis(out, 0, -1), scale


def _planes(shape: tuple[int, ...]) -> Codes:
    """Room for the three colours of a picture, one after the other as encoders take them."""
    return np.zeros((3, *shape), np.uint16)


def shift_pixels(codes: Codes, scale: float) -> tuple[NDArray[np.float32], NDArray[np.bool_]]:
    """Shifts [px], 0 where unknown, shape [..., 2], and where they are known, shape [...]."""
    known = codes[..., 2] > 0
    shift = (codes[..., :2].astype(np.float64) - SHIFT_ZERO) * float(scale)
    return np.where(known[..., None], shift, 0.0).astype(np.float32), known


def normal_codes(normal: Floats) -> Codes:
    """Unit normals of one picture, (n + 1) / 2 * 65534; black where nothing is hit, [H, L, 3]."""
    codes = np.clip(normal, -1, 1)
    codes += 1
    codes *= (MOST - 1) / 2
    np.rint(codes, out=codes)
    out = codes.astype(np.uint16)
    out[(normal[..., 0] == 0) & (normal[..., 1] == 0) & (normal[..., 2] == 0)] = 0
    return out


def normal_vectors(codes: Codes) -> NDArray[np.float32]:
    """The inverse of `normal_codes`, 0 where nothing is hit."""
    hit = codes.any(axis=-1, keepdims=True)
    return np.where(hit, codes / (MOST - 1) * 2.0 - 1.0, 0.0).astype(np.float32)


def place_codes(share: Floats, known: NDArray[np.bool_]) -> Codes:
    """Places on bodies of one picture, 1 + share * 65534; black where there is no body, [H, L, 3].

    Args:
        share: Of the way from the lower to the upper bound of the body, shape [H, L, 3].
        known: Where there is a body, shape [H, L].
    """
    at, out = np.flatnonzero(known), _planes(known.shape)
    rows = share.reshape(-1, 3)[at]
    for k, plane in enumerate(out):
        plane.reshape(-1)[at] = 1 + np.rint(np.clip(rows[:, k], 0.0, 1.0) * (MOST - 1))
    return np.moveaxis(out, 0, -1)


def place_shares(codes: Codes) -> NDArray[np.float32]:
    """The inverse of `place_codes`, 0 where there is no body."""
    return (np.maximum(codes.astype(np.float64) - 1.0, 0.0) / (MOST - 1)).astype(np.float32)
