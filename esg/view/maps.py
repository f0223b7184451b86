"""Textures as renderers want them: linear light, and smaller and smaller for what is far away."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.assets.looks import Color

RASTER_PX = 256
"""Edge of the largest level that the fast renderer keeps of a texture."""
_KEPT = 24
"""Textures that a process keeps so, of 1.3 MiB each: more than a scene has. All that there are took
600 scenes of a dataset to gather."""


def linear(srgb: Any) -> NDArray[np.float32]:
    """Linear light of sRGB values in [0, 1] (IEC 61966-2-1)."""
    x = np.asarray(srgb, np.float32)
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4).astype(np.float32)


def encoded(light: Any) -> NDArray[np.uint8]:
    """Pixels of linear light, as every renderer shows it: a soft shoulder above 0.6, then sRGB."""
    y = np.maximum(np.asarray(light, np.float64), 0.0)
    y = np.where(y > 0.6, 0.6 + 0.4 * (1.0 - np.exp(-(y - 0.6) / 0.4)), y)
    srgb = np.where(y <= 0.0031308, 12.92 * y, 1.055 * y ** (1 / 2.4) - 0.055)
    return np.floor(np.clip(srgb, 0, 1) * 255 + 0.5).astype(np.uint8)


@lru_cache(maxsize=_KEPT)
def pyramid(name: str, size: int = RASTER_PX) -> tuple[NDArray[np.float32], ...]:
    """A texture's linear colour and roughness, shape [n, n, 4], at n = size, size / 2, ..., 1.

    Args:
        name: Of the texture.
        size: Of the first level, a power of two [px].
    """
    from esg.assets.textures import maps

    found = maps(name, size)
    color = linear(found.base_color / 255.0)
    rough = found.roughness[..., None].astype(np.float32) / 255.0
    levels = [np.concatenate([color, rough], axis=-1)]
    while len(levels[-1]) > 1:
        n = len(levels[-1]) // 2
        levels.append(levels[-1].reshape(n, 2, n, 2, 4).mean(axis=(1, 3)))
    return tuple(levels)


def mean_color(color: Color, texture: str | None) -> NDArray[np.float32]:
    """Linear mean colour of a surface, shape [3]."""
    plain = linear(color)
    return plain if texture is None else plain * pyramid(texture)[-1][0, 0, :3]


def bent(normal: NDArray[np.uint8], strength: float) -> NDArray[np.float32]:
    """A normal map whose slopes are multiplied with `strength`, in [0, 1], shape [n, n, 3]."""
    n = normal.astype(np.float32) / 127.5 - 1.0
    n[..., :2] *= strength
    return (0.5 + 0.5 * n / np.linalg.norm(n, axis=-1, keepdims=True)).astype(np.float32)
