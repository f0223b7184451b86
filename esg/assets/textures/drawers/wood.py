"""Wood, and what is made of boards. The grain runs along u."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.assets.textures.noise import (
    Field,
    Random,
    cells,
    grid,
    noise,
    per_cell,
    smoothstep,
    strokes,
    taken,
)
from esg.assets.textures.recipe import Relief, texture


def _grown(
    n: int, rng: Random, rings: int, wander: float, pores: float, figure: float = 1.0
) -> tuple[Field, Field]:
    """Darkness in [0, 1] and height of sawn wood.

    Args:
        n: Pixels along each side.
        rng: Where its randomness comes from.
        rings: Growth rings across a tile.
        wander: How far they stray from straight lines [rings].
        pores: Strength of the short dark pores.
        figure: How dark late wood is.
    """
    _, v = grid(n)
    # Rings are lines of v that low noise, drawn out along the grain, bends into arches.
    place = rings * v + wander * noise(n, rng, 1, 3, 1.0, across=2.0)
    place = place + 0.10 * noise(n, rng, 4, 30, 1.0, across=10)
    phase = place - np.floor(place)
    late = smoothstep(0.25, 0.95, phase) * (1.0 - smoothstep(0.95, 1.0, phase))
    strength = 0.7 + 0.3 * per_cell(np.floor(place).astype(np.int64) % 97, rng)
    fibre = noise(n, rng, 20, 256, 0.3, across=24)
    streak = smoothstep(0.9, 2.4, noise(n, rng, 40, 256, 0.0, across=14))
    mottle = noise(n, rng, 1, 8, 1.2, across=3)
    dark = 0.32 + figure * 0.34 * late * strength + 0.10 * fibre + 0.07 * mottle
    dark = dark + pores * streak
    return np.clip(dark, 0.0, 1.0), -0.6 * late - 0.35 * fibre - 1.6 * pores * streak


def _stained(dark: Field, depth: float = 1.0) -> NDArray[np.floating]:
    """Neutral light wood to its darker, redder late wood."""
    light = np.array([1.0, 1.0, 1.0], np.float32)
    deep = np.array([0.40, 0.30, 0.22], np.float32)
    return light + (deep - light) * np.clip(depth * dark, 0.0, 1.0)[..., None]


@texture(mean=(0.86, 0.84, 0.82), depth=0.0007, along=True)
def wood_grain(n: int, rng: Random) -> Relief:
    """Fine, quiet grain, as of veneer or planed hardwood; 0.6 m."""
    dark, height = _grown(n, rng, 14, 1.1, 0.12, 0.8)
    return Relief(_stained(dark, 0.8), height, 0.9 + 0.1 * (1.0 - dark))


@texture(mean=(0.83, 0.80, 0.77), depth=0.0012, along=True)
def oak(n: int, rng: Random) -> Relief:
    """Open grain with long pores; 0.5 m."""
    dark, height = _grown(n, rng, 10, 0.9, 0.45, 1.0)
    return Relief(_stained(dark), height, 0.88 + 0.12 * (1.0 - dark))


@texture(mean=(0.86, 0.84, 0.81), depth=0.0009, along=True)
def pine(n: int, rng: Random) -> Relief:
    """Wide contrasting rings, and knots; 0.6 m."""
    u, v = grid(n)
    knots = cells(u + 0.25, v, rng, 1, 2, 0.7)
    close = np.exp(-((knots.du / 0.10) ** 2) - (knots.dv / 0.11) ** 2)
    place = 10.0 * v + 0.7 * noise(n, rng, 1, 3, 1.0, across=2.5)
    aside = np.exp(-((knots.du / 0.16) ** 2) - (np.abs(knots.dv) / 0.35))
    place = place + 1.1 * np.tanh(knots.dv / 0.10) * aside
    phase = place - np.floor(place)
    late = smoothstep(0.35, 0.92, phase) * (1.0 - smoothstep(0.93, 1.0, phase))
    fibre = noise(n, rng, 20, 256, 0.3, across=24)
    ring = 0.5 + 0.5 * np.cos(34.0 * np.hypot(knots.du, 0.55 * knots.dv))
    dark = 0.22 + 0.50 * late + 0.08 * fibre
    knot = smoothstep(0.62, 0.80, close)
    dark = dark * (1.0 - knot) + knot * (0.85 + 0.25 * ring)
    dark = dark + 0.35 * smoothstep(0.45, 0.62, close) * (1.0 - knot)
    return Relief(_stained(np.clip(dark, 0.0, 1.15), 0.9), -0.5 * late - 0.3 * fibre, 1.0)


@texture(mean=(0.84, 0.82, 0.79), depth=0.0006, along=True)
def plywood(n: int, rng: Random) -> Relief:
    """Rotary-cut veneer: broad islands of late wood, and a patch; 1.2 m."""
    field = noise(n, rng, 1, 5, 1.6, across=2.2)
    place = 5.0 * field
    phase = place - np.floor(place)
    late = smoothstep(0.3, 0.9, phase) * (1.0 - smoothstep(0.9, 1.0, phase))
    fibre = noise(n, rng, 24, 256, 0.2, across=20)
    dark = 0.30 + 0.26 * late + 0.12 * fibre + 0.05 * noise(n, rng, 2, 20, 1.0)
    return Relief(_stained(np.clip(dark, 0.0, 1.0), 0.85), -0.3 * late - 0.4 * fibre, 1.0)


def _boards(
    n: int, rng: Random, down: int, joints: int, gap: float, rings: int, contrast: float
) -> tuple[NDArray[np.int64], Field, Field, Field]:
    """Number of the board, openness of its gaps, darkness and height of its wood.

    Args:
        n: Pixels along each side.
        rng: Where its randomness comes from.
        down: Boards across a tile.
        joints: Butt joints of a board in a tile.
        gap: Width of a gap [tiles].
        rings: Growth rings across a tile of the wood.
        contrast: How much boards differ.
    """
    u, v = grid(n)
    row = np.floor(v * down).astype(np.int64)
    start = rng.permutation(down).astype(np.float32) / down
    x = u * joints + start[row] * joints + 0.11 * (row % 3)
    piece = np.floor(x).astype(np.int64) % joints
    number = row * joints + piece
    fx, fy = x - np.floor(x), v * down - row
    ends = np.minimum(fx, 1.0 - fx) / joints
    sides = np.minimum(fy, 1.0 - fy) / down
    open_ = 1.0 - smoothstep(0.3 * gap, gap, np.minimum(ends, sides))
    dark, height = _grown(n, rng, rings, 1.2, 0.2, 0.9)
    jump = rng.random((2, down * joints), dtype=np.float32)
    dark = taken(dark, u + jump[0][number], v + jump[1][number])
    height = taken(height, u + jump[0][number], v + jump[1][number])
    tone = per_cell(number, rng) - 0.5
    return number, open_, np.clip(dark + contrast * tone, 0.0, 1.0), height


@texture(mean=(0.80, 0.78, 0.75), depth=0.006, along=True)
def planks(n: int, rng: Random) -> Relief:
    """Eight sawn, weathered boards with gaps and nails; 1.2 m."""
    number, gaps, dark, height = _boards(n, rng, 8, 1, 0.006, 26, 0.35)
    u, v = grid(n)
    fy = v * 8 - np.floor(v * 8)
    worn = noise(n, rng, 2, 40, 1.0, across=6)
    color = _stained(np.clip(dark + 0.05 * worn, 0.0, 1.0), 1.0)
    nail = np.hypot((u * 8 + 0.37 * number) % 4 - 2.0, 4.0 * (np.abs(fy - 0.5) - 0.3))
    nail = 1.0 - smoothstep(0.030, 0.055, nail)
    color = color * (1.0 - 0.85 * gaps)[..., None] * (1.0 - 0.6 * nail)[..., None]
    relief = 0.10 * height + 0.25 * (per_cell(number, rng) - 0.5) * (1.0 - gaps) - gaps
    return Relief(color, relief - 0.2 * nail, 1.0)


@texture(mean=(0.84, 0.82, 0.79), depth=0.002, along=True)
def strip_floor(n: int, rng: Random) -> Relief:
    """A lane or a court: 18 tight maple strips; 1.1 m."""
    _, gaps, dark, height = _boards(n, rng, 18, 1, 0.0022, 34, 0.30)
    color = _stained(dark, 0.55) * (1.0 - 0.55 * gaps)[..., None]
    return Relief(color, 0.03 * height - 0.5 * gaps, 0.9 + 0.1 * gaps)


@texture(mean=(0.82, 0.79, 0.75), depth=0.003)
def parquet(n: int, rng: Random) -> Relief:
    """Herringbone of 7.5 x 30 cm; 1.2 m."""
    u, v = grid(n)
    across, length = 16, 4
    x, y = u * across, v * across
    i, j = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    step = (i - j) % (2 * length)
    lying = step < length
    back = np.where(lying, step, 2 * length - 1 - step)
    first_i, first_j = np.where(lying, i - back, i), np.where(lying, j, j - back)
    number = (first_i % across) + across * (first_j % across)
    along = np.where(lying, x - first_i, y - first_j)
    side = np.where(lying, y - j, x - i)
    edge = np.minimum(np.minimum(along, length - along), np.minimum(side, 1.0 - side)) / across
    gaps = 1.0 - smoothstep(0.0005, 0.0028, edge)
    dark, height = _grown(n, rng, 26, 1.2, 0.25, 0.9)
    jump = rng.random((2, across * across), dtype=np.float32)
    at = (along / across + jump[0][number], side / across + jump[1][number])
    tone = per_cell(number, rng) - 0.5
    dark = np.clip(taken(dark, *at) + 0.4 * tone, 0.0, 1.0)
    color = _stained(dark, 0.9) * (1.0 - 0.6 * gaps)[..., None]
    return Relief(color, 0.04 * taken(height, *at) - 0.6 * gaps, 0.9 + 0.1 * gaps)


@texture(mean=(0.70, 0.66, 0.62), depth=0.035, along=True)
def bark(n: int, rng: Random) -> Relief:
    """Long plates with deep cracks between them, along the trunk; 0.6 m."""
    u, v = grid(n)
    bend = noise(n, rng, 1, 6, 1.2, across=0.6)
    wave = noise(n, rng, 4, 30, 1.0)
    plates = cells(u + 0.02 * wave, v + 0.02 * bend + 0.004 * wave, rng, 4, 11, 1.0)
    crack = smoothstep(0.02, 0.42, plates.edge + 0.10 * noise(n, rng, 10, 80, 0.7, across=3))
    rough = noise(n, rng, 12, 200, 0.7, across=4)
    flakes = noise(n, rng, 6, 40, 0.8, across=6)
    height = crack + 0.14 * rough + 0.12 * flakes
    tone = 0.22 + 0.62 * crack * (0.75 + 0.35 * per_cell(plates.number, rng)) + 0.10 * rough
    color = np.clip(tone, 0.03, 1.2)[..., None] * np.array([1.0, 0.93, 0.85], np.float32)
    return Relief(color, height, 1.0)


@texture(mean=(0.86, 0.80, 0.70), depth=0.02, along=True)
def straw(n: int, rng: Random) -> Relief:
    """Stalks lying about, mostly along u; 0.5 m."""
    laid = strokes(n, rng, 1300, 0.2, 0.013, 0.0, spread=0.4, bend=0.15, pointed=0.0)
    round_ = np.sqrt(np.clip(1.0 - laid.side**2, 0.0, 1.0))
    tone = per_cell(laid.number + 1, rng)
    light = (0.35 + 0.65 * laid.rank) * (0.55 + 0.45 * round_) * (0.65 + 0.5 * tone)
    color = light[..., None] * np.array([1.0, 0.94, 0.80], np.float32)
    return Relief(color, laid.rank + 0.35 * round_, 1.0)


@texture(mean=(0.78, 0.75, 0.71), depth=0.05)
def wicker(n: int, rng: Random) -> Relief:
    """Rods woven around stakes; 12 cm."""
    u, v = grid(n)
    rows, stakes = 14, 6
    row = np.floor(v * rows).astype(np.int64)
    swing = np.cos(np.pi * (u * stakes * 2.0 / 2.0) * 2.0 + np.pi * (row % 2))
    fy = v * rows - row - 0.5
    rod = np.sqrt(np.clip(1.0 - (2.05 * fy) ** 2, 0.0, 1.0))
    over = 0.5 + 0.5 * swing
    stake = np.sqrt(np.clip(1.0 - ((u * stakes - np.floor(u * stakes) - 0.5) / 0.2) ** 2, 0, 1))
    fibre = noise(n, rng, 16, 200, 0.4, across=10)
    height = np.maximum(rod * (0.25 + 0.75 * over), 0.55 * stake * (1.0 - over))
    tone = per_cell(row, rng)
    light = (0.25 + 0.75 * height) * (0.8 + 0.3 * tone) * (1.0 + 0.10 * fibre)
    color = np.clip(light, 0.02, 1.2)[..., None] * np.array([1.0, 0.94, 0.86], np.float32)
    return Relief(color, height + 0.03 * fibre, 1.0)
