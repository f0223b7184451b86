"""Periodic fields that textures are made of: shape [n, n], rows from top to bottom, float32.

All frequencies count cycles a tile, all coordinates tiles, so that a field does not depend on the
number of its pixels but for detail, and continues across its border.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import fft

Field = NDArray[np.floating]
Random = np.random.Generator


def grid(n: int) -> tuple[Field, Field]:
    """Coordinates u (right) and v (down) of the pixels' middles, in [0, 1)."""
    at = ((np.arange(n) + 0.5) / n).astype(np.float32)
    u, v = np.meshgrid(at, at)
    return u, v


def smoothstep(low: float, high: float, x: Field) -> Field:
    """0 below `low`, 1 above `high`, smooth between; falls where `high` is the smaller."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def noise(
    n: int, rng: Random, low: float, high: float, slope: float = 1.0, across: float = 1.0
) -> Field:
    """Noise of mean 0 and deviation 1 with frequencies in [low, high].

    Args:
        n: Pixels along each side.
        rng: Where its randomness comes from.
        low, high: Band [cycles a tile].
        slope: Amplitude falls with frequency to this power.
        across: How many times finer it is along v than along u; 8 gives fibres along u.
    """
    white = rng.standard_normal((n, n), dtype=np.float32)
    fu = fft.rfftfreq(n, 1.0 / n).astype(np.float32)[None, :]
    fv = fft.fftfreq(n, 1.0 / n).astype(np.float32)[:, None]
    f = np.sqrt((fu * across) ** 2 + fv**2)
    f[0, 0] = 1.0
    keep = np.exp(-((f / high) ** 4)) * (1.0 - np.exp(-((f / low) ** 4))) * f**-slope
    keep[0, 0] = 0.0
    out: Field = fft.irfft2(fft.rfft2(white) * keep, s=(n, n))  # pyright: ignore[reportOperatorIssue, reportAssignmentType]  # typed as dispatching
    return (out / max(float(out.std()), 1e-9)).astype(np.float32)


def blurred(field: Field, sigma: float) -> Field:
    """A field smoothed by a Gaussian of `sigma` tiles."""
    n = len(field)
    fu = fft.rfftfreq(n, 1.0 / n).astype(np.float32)[None, :]
    fv = fft.fftfreq(n, 1.0 / n).astype(np.float32)[:, None]
    keep = np.exp(-2.0 * (np.pi * sigma) ** 2 * (fu * fu + fv * fv))
    out: Field = fft.irfft2(fft.rfft2(field) * keep, s=(n, n))  # pyright: ignore[reportOperatorIssue, reportAssignmentType]  # typed as dispatching
    return out.astype(np.float32)


def taken(field: NDArray[np.floating], u: Field, v: Field) -> NDArray[np.floating]:
    """What a field of any number of channels has at coordinates (nearest pixel, wrapped)."""
    n = len(field)
    return field[np.floor(v * n).astype(int) % n, np.floor(u * n).astype(int) % n]


class Cells(NamedTuple):
    """A cellular pattern.

    Args:
        near, second: Distances to the nearest and the second nearest point [cells].
        number: Of the nearest point's cell.
        du, dv: From the nearest point to the pixel [cells].
    """

    near: Field
    second: Field
    number: NDArray[np.int64]
    du: Field
    dv: Field

    @property
    def edge(self) -> Field:
        """0 where two cells meet, growing inwards [cells]."""
        return self.second - self.near


def cells(u: Field, v: Field, rng: Random, across: int, down: int, jitter: float = 0.9) -> Cells:
    """Cells around one random point in each square of a grid.

    Args:
        u, v: Where, in tiles, shape [n, n].
        rng: Where its randomness comes from.
        across, down: Squares along u and v.
        jitter: 0 leaves the points in the middle of their squares, 1 spreads them all over.
    """
    points = 0.5 + jitter * (rng.random((2, down, across), dtype=np.float32) - 0.5)
    columns, rows = points[0].ravel(), points[1].ravel()
    x, y = u * across, v * down
    i, j = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    fx, fy = (x - i).astype(np.float32), (y - j).astype(np.float32)
    near = np.full(u.shape, 9.0, np.float32)
    second, du, dv = near.copy(), near.copy(), near.copy()
    number = np.zeros(u.shape, np.int64)
    for dj in (-1, 0, 1):
        for di in (-1, 0, 1):
            cell = ((j + dj) % down) * across + (i + di) % across
            px = fx - np.float32(di) - columns[cell]
            py = fy - np.float32(dj) - rows[cell]
            d = px * px + py * py
            closer = d < near
            second = np.where(closer, near, np.minimum(second, d))
            near = np.where(closer, d, near)
            du, dv = np.where(closer, px, du), np.where(closer, py, dv)
            number = np.where(closer, cell, number)
    return Cells(np.sqrt(near), np.sqrt(second), number, du, dv)


def per_cell(number: NDArray[np.int64], rng: Random) -> Field:
    """One random number in [0, 1) for every cell."""
    return rng.random(int(number.max()) + 1, dtype=np.float32)[number]


class Strokes(NamedTuple):
    """What strokes leave on a tile, the later over the earlier.

    Args:
        rank: Of the topmost stroke in [0, 1], 0 where there is none.
        along: From its root 0 to its tip 1.
        side: From one of its edges -1 to the other 1.
        number: Of the stroke, -1 where there is none.
    """

    rank: Field
    along: Field
    side: Field
    number: NDArray[np.int64]


def strokes(
    n: int,
    rng: Random,
    count: int,
    length: float,
    width: float,
    angle: NDArray[np.floating] | float,
    *,
    spread: float = 0.0,
    bend: float = 0.0,
    pointed: float = 1.0,
    at: tuple[NDArray[np.floating], NDArray[np.floating]] | None = None,
) -> Strokes:
    """Blades, hairs, straws or leaves strewn over a tile.

    Args:
        n: Pixels along each side.
        rng: Where its randomness comes from.
        count: How many.
        length, width: [tiles].
        angle: Direction of growth [rad], 0 along u, up positive; one, or one a stroke.
        spread: Deviation of the angle [rad].
        bend: Deviation of the change of angle along a stroke [rad].
        pointed: 1 tapers to a point, 0 keeps its width, 2 is a leaf, widest in its middle.
        at: Roots [tiles], shape [count] each; random by default.
    """
    u0, v0 = at if at is not None else rng.random((2, count), dtype=np.float32)
    turn = angle + spread * rng.standard_normal(count, dtype=np.float32)
    curl = bend * rng.standard_normal(count, dtype=np.float32)
    size = length * (0.65 + 0.7 * rng.random(count, dtype=np.float32))
    steps = max(4, int(1.1 * length * 1.35 * n))
    sides = max(1, int(np.ceil(1.4 * width * n)))
    t = ((np.arange(steps) + 0.5) / steps).astype(np.float32)[None, :, None]
    s = (np.arange(sides) - 0.5 * (sides - 1)).astype(np.float32)[None, None, :]
    s = s / max(0.5 * sides, 0.5)
    heading = turn[:, None, None] + curl[:, None, None] * t
    middle = turn[:, None, None] + 0.5 * curl[:, None, None] * t
    half = 0.5 * width * _profile(t, pointed)
    u = u0[:, None, None] + size[:, None, None] * t * np.cos(middle) - s * half * np.sin(heading)
    v = v0[:, None, None] - size[:, None, None] * t * np.sin(middle) - s * half * np.cos(heading)
    pixel = (np.floor(v * n).astype(np.int64) % n) * n + np.floor(u * n).astype(np.int64) % n
    number = np.full(n * n, -1, np.int64)
    along, side = np.zeros(n * n, np.float32), np.zeros(n * n, np.float32)
    flat = pixel.reshape(-1)
    shape = np.broadcast_shapes(u.shape, t.shape, s.shape)
    number[flat] = np.repeat(np.arange(count), steps * sides)
    along[flat] = np.broadcast_to(t, shape).reshape(-1)
    side[flat] = np.broadcast_to(s, shape).reshape(-1)
    rank = ((number + 1) / count).astype(np.float32)
    return Strokes(
        rank.reshape(n, n), along.reshape(n, n), side.reshape(n, n), number.reshape(n, n)
    )


def _profile(t: NDArray[np.floating], pointed: float) -> NDArray[np.floating]:
    if pointed > 1.0:
        return np.sqrt(np.clip(4.0 * t * (1.0 - t), 0.0, 1.0)) * (1.25 - 0.5 * t)
    return 1.0 - pointed * t**2


def normals(height: Field, depth: float) -> NDArray[np.floating]:
    """Unit normals of a relief, +X right and +Y up the picture, shape [n, n, 3].

    Args:
        height: [n, n].
        depth: How many tiles high a height of 1 is.
    """
    n = len(height)
    right = 0.5 * (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * n * depth
    down = 0.5 * (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * n * depth
    out = np.stack([-right, down, np.ones_like(height)], axis=-1)
    return out / np.linalg.norm(out, axis=-1, keepdims=True)
