"""Cloth of all kinds, felt, carpet and rope."""

from __future__ import annotations

import numpy as np

from esg.assets.textures.noise import (
    Random,
    cells,
    grid,
    noise,
    per_cell,
    smoothstep,
    strokes,
)
from esg.assets.textures.recipe import Relief, texture


@texture(mean=(0.86, 0.86, 0.86), depth=0.012)
def weave(n: int, rng: Random) -> Relief:
    """Plain weave, 24 threads each way; 6 cm."""
    u, v = grid(n)
    count = 24
    slub = 0.10 * noise(n, rng, 1, 12, 1.0, across=8)
    slub_across = 0.10 * noise(n, rng, 1, 12, 1.0, across=1 / 8)
    x, y = u * count + 0.6 * slub_across, v * count + 0.6 * slub
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    fx, fy = x - column - 0.5, y - row - 0.5
    over = (column + row) % 2 == 0
    warp = np.sqrt(np.clip(1.0 - (2.05 * fx) ** 2, 0, 1)) * np.cos(np.pi * fy * 0.9)
    weft = np.sqrt(np.clip(1.0 - (2.05 * fy) ** 2, 0, 1)) * np.cos(np.pi * fx * 0.9)
    height = np.where(over, warp, weft)
    thread = np.where(over, per_cell(column % count, rng), per_cell(row % count, rng))
    fuzz = noise(n, rng, 60, 256, 0.0)
    tone = (0.45 + 0.55 * height) * (0.88 + 0.18 * thread) + 0.04 * fuzz
    return Relief(np.clip(tone, 0.1, 1.2), height + 0.06 * fuzz, 1.0)


@texture(mean=(0.84, 0.84, 0.84), depth=0.03)
def knit(n: int, rng: Random) -> Relief:
    """Stocking stitch: columns of V; 12 cm."""
    u, v = grid(n)
    across, down = 16, 20
    x, y = u * across, v * down
    fx = x - np.floor(x) - 0.5
    side = np.abs(fx)
    place = y + 1.1 * side
    fy = place - np.floor(place) - 0.5
    number = (np.floor(place).astype(np.int64) % down) * across + np.floor(x).astype(np.int64)
    yarn = np.sqrt(np.clip(1.0 - (2.1 * fy) ** 2, 0, 1))
    yarn = yarn * smoothstep(0.5, 0.36, side) * (0.55 + 0.45 * smoothstep(0.0, 0.10, side))
    twist = 0.5 + 0.5 * np.cos(2.0 * np.pi * (3.0 * fy + 2.0 * side * np.sign(fx)))
    fuzz = noise(n, rng, 50, 256, 0.0)
    tone = (0.30 + 0.70 * yarn) * (0.90 + 0.10 * per_cell(number % (across * down), rng))
    tone = tone * (0.9 + 0.1 * twist) + 0.05 * fuzz
    return Relief(np.clip(tone, 0.05, 1.2), yarn + 0.08 * twist * yarn + 0.04 * fuzz, 1.0)


@texture(mean=(0.88, 0.88, 0.88), depth=0.004)
def felt(n: int, rng: Random) -> Relief:
    """Matted fibres without direction; 0.3 m."""
    laid = strokes(n, rng, 5000, 0.05, 0.002, 0.0, spread=3.0, bend=1.5, pointed=0.0)
    fuzz, cloud = noise(n, rng, 40, 256, 0.1), noise(n, rng, 2, 20, 0.8)
    fibre = np.where(laid.number >= 0, laid.rank, 0.0)
    tone = 0.84 + 0.08 * fibre + 0.055 * fuzz + 0.015 * cloud
    return Relief(tone, 0.6 * fuzz + 0.4 * fibre, 1.0)


@texture(mean=(0.80, 0.80, 0.80), depth=0.02)
def carpet(n: int, rng: Random) -> Relief:
    """Cut pile in tufts; 0.4 m."""
    u, v = grid(n)
    warp = noise(n, rng, 10, 80, 0.6)
    tufts = cells(u + 0.004 * warp, v + 0.004 * np.roll(warp, 40, 0), rng, 80, 80, 0.8)
    dome = np.clip(1.0 - 1.3 * tufts.near, 0.0, 1.0)
    lay, fuzz = noise(n, rng, 1, 10, 1.2), noise(n, rng, 60, 256, 0.0)
    tone = (0.30 + 0.70 * dome) * (0.80 + 0.28 * per_cell(tufts.number, rng))
    tone = tone * (1.0 + 0.06 * lay) + 0.06 * fuzz
    return Relief(np.clip(tone, 0.05, 1.3), dome + 0.15 * fuzz, 1.0)


@texture(mean=(0.78, 0.76, 0.72), depth=0.08, along=True)
def rope(n: int, rng: Random) -> Relief:
    """Laid strands at a slant; 6 cm, along u."""
    u, v = grid(n)
    count = 5
    place = count * (u + v)
    phase = place - np.floor(place) - 0.5
    strand = np.sqrt(np.clip(1.0 - (2.0 * phase) ** 2, 0, 1))
    yarn = 0.5 + 0.5 * np.cos(2.0 * np.pi * (8.0 * u - 12.0 * v))
    fuzz = noise(n, rng, 30, 256, 0.2)
    tone = (0.25 + 0.75 * strand) * (0.82 + 0.18 * yarn) * (1.0 + 0.08 * fuzz)
    color = np.clip(tone, 0.05, 1.2)[..., None] * np.array([1.0, 0.96, 0.88], np.float32)
    return Relief(color, strand + 0.10 * yarn + 0.03 * fuzz, 1.0)


@texture(mean=(0.86, 0.86, 0.86), depth=0.03)
def foam(n: int, rng: Random) -> Relief:
    """Pores of two sizes: foam, cork, crumb; 0.1 m."""
    u, v = grid(n)
    height, tone = np.ones_like(u), np.ones_like(u)
    warp = noise(n, rng, 6, 60, 0.8)
    for count, share, deep in ((22, 0.5, 1.0), (48, 0.6, 0.5)):
        pores = cells(u + 0.006 * warp, v + 0.006 * np.roll(warp, 40, 1), rng, count, count, 1.0)
        there = per_cell(pores.number, rng) < share
        size = 0.22 + 0.25 * per_cell(pores.number, rng)
        hole = smoothstep(1.0, 0.6, pores.near / size) * there
        height = height - deep * hole
        tone = tone * (1.0 - 0.45 * deep * hole)
    grain, cloud = noise(n, rng, 60, 256, 0.0), noise(n, rng, 1, 10, 1.0)
    return Relief(tone * (1.0 + 0.04 * cloud) + 0.04 * grain, height + 0.08 * grain, 1.0)
