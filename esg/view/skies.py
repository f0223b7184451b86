"""Pictures of the sky, the same for all renderers: gradient, seeded clouds, glow of the sun."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.view.surroundings import Sky, Vec

Floats = NDArray[np.float32]

SKY_PX = (1024, 256)
"""Columns around the horizon and rows up to the zenith."""
BLURRED_PX = (32, 16)
BLURS_RAD = (0.12, 0.3, 0.6, 1.0)
"""What surfaces of growing roughness reflect is blurred by so much."""


@dataclass(frozen=True)
class Air:
    """How a kind of sky behaves.

    Args:
        cover: Share of clouds.
        glow: Brightness around the sun, in its own.
        sun_radius: Of the light's disc [rad]; the real sun's is 0.005, haze and clouds widen it.
        reach_m: What is farther away casts no shadow: a lamp hangs below the ceiling.
        haze_m: Distance in which the far ground turns into the horizon; 0 for none.
    """

    cover: float
    glow: float
    sun_radius: float
    reach_m: float = 300.0
    haze_m: float = 600.0


AIRS = {
    "plain": Air(0.0, 0.0, 0.03, haze_m=250.0),
    "clear": Air(0.3, 0.25, 0.012),
    "cloudy": Air(0.9, 0.1, 0.2, haze_m=400.0),
    "dusk": Air(0.4, 0.5, 0.03),
    "night": Air(0.15, 0.1, 0.03, haze_m=400.0),
    "indoor": Air(0.0, 0.0, 0.12, reach_m=2.2, haze_m=0.0),
}


def sun_behind(azimuth: float) -> Vec:
    """Direction of a sun behind a viewer's right shoulder, so that what one sees is lit.

    Args:
        azimuth: Direction from the scene to the viewer, counter-clockwise from +X [rad].
    """
    toward = azimuth - math.radians(42)
    sun = np.array([0.67 * math.cos(toward), 0.67 * math.sin(toward), 0.9])
    x, y, z = sun / np.linalg.norm(sun)
    return float(x), float(y), float(z)


@lru_cache(maxsize=8)
def haze_of(sky: Sky) -> float:
    """Distance in which things turn into the horizon [m]; 0 for never."""
    haze = AIRS[sky.kind].haze_m
    return min(haze or sky.sight_m, sky.sight_m) if sky.sight_m else haze


def sky_map(sky: Sky, seed: int = 0, size: tuple[int, int] = SKY_PX) -> Floats:
    """Linear colour of every direction above the horizon, shape [rows, columns, 3].

    Rows rise evenly from the horizon to the zenith; columns go counter-clockwise from -X.

    Args:
        sky: Colours, sun and kind.
        seed: Of the clouds.
        size: Columns and rows.
    """
    air, d = AIRS[sky.kind], _directions(size)
    horizon, zenith = np.array(sky.horizon), np.array(sky.zenith)
    height = d[..., 2:]
    out = horizon + (zenith - horizon) * height**0.5
    if air.cover:
        out = _clouded(out, d, sky, air, _clouds(seed, size))
    toward = np.clip(d @ np.array(sky.sun), -1, 1)[..., None]
    angle = np.arccos(toward)
    out = out + air.glow * np.array(sky.sun_rgb) * (np.exp(-angle / 0.12) + 0.3 * np.exp(-angle))
    return out.astype(np.float32)


@lru_cache(maxsize=2)
def _directions(size: tuple[int, int]) -> Any:
    """Unit vectors to the pixels of a picture of the sky, shape [rows, columns, 3]."""
    columns, rows = size
    azimuth = ((np.arange(columns) + 0.5) / columns - 0.5) * 2 * math.pi
    rise = (np.arange(rows) + 0.5) / rows * math.pi / 2
    horizontal = np.cos(rise)[:, None]
    return np.stack(
        [
            horizontal * np.cos(azimuth),
            horizontal * np.sin(azimuth),
            np.broadcast_to(np.sin(rise)[:, None], (rows, columns)),
        ],
        axis=-1,
    )


def sky_at(sky: Floats, directions: NDArray[Any]) -> NDArray[np.float64]:
    """Colours of a picture of the sky; below the horizon that of the horizon, shape [..., 3].

    Args:
        sky: Of `sky_map`.
        directions: Unit vectors, shape [..., 3].
    """
    rows, columns = sky.shape[:2]
    d = np.asarray(directions, float)
    x = (np.arctan2(d[..., 1], d[..., 0]) / (2 * math.pi) + 0.5) * columns - 0.5
    y = np.arcsin(np.clip(d[..., 2], 0, 1)) / (math.pi / 2) * rows - 0.5
    y = np.clip(y, 0, rows - 1.001)
    x0, y0 = np.floor(x).astype(int), y.astype(int)
    fx, fy = (x - x0)[..., None], (y - y0)[..., None]
    xa, xb, y1 = x0 % columns, (x0 + 1) % columns, np.minimum(y0 + 1, rows - 1)
    low = sky[y0, xa] * (1 - fx) + sky[y0, xb] * fx
    return low * (1 - fy) + (sky[y1, xa] * (1 - fx) + sky[y1, xb] * fx) * fy


def lighting_map(sky: Sky, seed: int, below: NDArray[Any]) -> Floats:
    """The light of the sky from all sides, as strong as `Sky.ambient_rgb` says.

    Args:
        sky: Its colours.
        seed: Of the clouds.
        below: Linear colour of what is below the horizon, shape [3].

    Returns:
        Linear colours, shape [2 rows, columns, 3], rows from straight down to straight up, columns
        as of `sky_map`.
    """
    seen = sky_map(sky, seed)
    rise = (np.arange(len(seen)) + 0.5) / len(seen) * math.pi / 2
    share = (np.sin(rise) * np.cos(rise))[:, None, None]
    irradiance = (seen * share).sum(axis=(0, 1)) / (share.sum() * seen.shape[1])
    ambient = np.array(sky.ambient_rgb)
    lower = np.broadcast_to(below * ambient, seen.shape)
    return np.concatenate([lower, seen * (ambient / np.maximum(irradiance, 1e-6))]).astype(
        np.float32
    )


@lru_cache(maxsize=2)
def _clouds(seed: int, size: tuple[int, int]) -> tuple[Any, Any]:
    """Noise, and its values where pixels of the sky see a plane high above, shape [rows, columns].

    They are the same for all skies of a seed.
    """
    noise, d = _noise(512, np.random.default_rng([seed, 7])), _directions(size)
    plane = 90.0 * d[..., :2] / (d[..., 2:] + 0.12)
    x, y = (plane[..., k] % 512 for k in (0, 1))
    x0, y0 = x.astype(int), y.astype(int)
    fx, fy = x - x0, y - y0
    x1, y1 = (x0 + 1) % 512, (y0 + 1) % 512
    value = (noise[y0, x0] * (1 - fx) + noise[y0, x1] * fx) * (1 - fy)
    return noise, value + (noise[y1, x0] * (1 - fx) + noise[y1, x1] * fx) * fy


def _clouded(out: Any, d: Any, sky: Sky, air: Air, clouds: tuple[Any, Any]) -> Any:
    """Clouds on a plane high above, thinning toward the horizon."""
    noise, value = clouds
    edge = np.quantile(noise, 1 - air.cover)
    thick = np.clip((value - edge) / 0.22, 0, 1)[..., None]
    thick = thick * np.clip(d[..., 2:] / 0.25, 0, 1) ** 0.7 * (0.9 if air.cover < 0.8 else 0.75)
    # Lit from above and behind: bright rims, greyer where thick.
    light = 0.55 * np.array(sky.sun_rgb) + 1.1 * np.array(sky.ambient_rgb)
    cloud = light * (1.05 - 0.35 * thick)
    return out + (cloud - out) * thick


def _noise(size: int, rng: np.random.Generator) -> Any:
    """Periodic noise whose power falls with the fourth of its frequency, in [0, 1]."""
    k = np.fft.fftfreq(size) * size
    frequency = np.hypot(k[:, None], k[None, :])
    frequency[0, 0] = np.inf
    spectrum = np.fft.fft2(rng.standard_normal((size, size))) / np.maximum(frequency, 3.0) ** 1.7
    field = np.real(np.fft.ifft2(spectrum))
    low, high = field.min(), field.max()
    return (field - low) / (high - low)


@lru_cache(maxsize=8)
def blurred_maps(sky: Sky, seed: int, ground: Vec) -> Floats:
    """What surfaces of growing roughness reflect, shape [levels, rows, columns, 3].

    Rows rise evenly from straight down to straight up.

    Args:
        sky: Colours, sun and kind.
        seed: Of the clouds.
        ground: Linear colour of everything below the horizon.
    """
    columns, rows = BLURRED_PX
    seen = sky_map(sky, seed)
    height, width = seen.shape[:2]
    coarse = seen.reshape(rows // 2, height // (rows // 2), columns, width // columns, 3)
    coarse = coarse.mean(axis=(1, 3))
    full = np.concatenate([np.broadcast_to(ground, coarse.shape), coarse]).astype(np.float32)
    azimuth = ((np.arange(columns) + 0.5) / columns - 0.5) * 2 * math.pi
    rise = ((np.arange(rows) + 0.5) / rows - 0.5) * math.pi
    area = np.repeat(np.cos(rise), columns)
    d = np.stack(
        [
            np.outer(np.cos(rise), np.cos(azimuth)).ravel(),
            np.outer(np.cos(rise), np.sin(azimuth)).ravel(),
            np.repeat(np.sin(rise), columns),
        ],
        axis=-1,
    ).astype(np.float32)
    apart = d @ d.T - 1.0
    flat = full.reshape(-1, 3)
    out = []
    for blur in BLURS_RAD:
        weight = np.exp(apart / blur**2) * area
        out.append((weight @ flat / weight.sum(axis=1, keepdims=True)).reshape(rows, columns, 3))
    return np.stack(out).astype(np.float32)
