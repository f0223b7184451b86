"""What lies on the ground and grows from it."""

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
from esg.assets.textures.recipe import Relief, mixed, texture


@texture(mean=(0.34, 0.52, 0.24), depth=0.03)
def grass(n: int, rng: Random) -> Relief:
    """A lawn from above: short blades over thatch; 2 m."""
    blades = strokes(n, rng, 38000, 0.022, 0.0040, 0.5 * np.pi, spread=1.1, bend=0.6)
    patch = noise(n, rng, 4, 24, 0.8)
    dry = smoothstep(0.90, 1.0, per_cell(blades.number + 1, rng))
    tone = per_cell(blades.number + 1, rng)
    light = (0.28 + 0.72 * blades.rank) * (0.55 + 0.45 * blades.along) * (0.6 + 0.5 * tone)
    green = mixed((0.085, 0.20, 0.04), (0.16, 0.28, 0.07), np.clip(0.5 + 0.25 * patch, 0, 1))
    yellow = np.array([0.32, 0.31, 0.12], np.float32)
    blade = green + (yellow - green) * (0.75 * dry)[..., None]
    color = blade * (1.6 * light * (1.0 + 0.04 * patch))[..., None]
    return Relief(color, blades.rank + 0.3 * blades.along, 1.0)


@texture(mean=(0.33, 0.48, 0.24), depth=0.05)
def leaves(n: int, rng: Random) -> Relief:
    """Foliage of a hedge or a crown; 0.6 m."""
    laid = strokes(n, rng, 1300, 0.085, 0.056, 0.5 * np.pi, spread=1.6, bend=0.35, pointed=2.0)
    tone = per_cell(laid.number + 1, rng)
    rib = smoothstep(0.0, 0.14, np.abs(laid.side))
    vein = 0.5 + 0.5 * np.cos(26.0 * laid.along + 9.0 * np.abs(laid.side))
    depth = smoothstep(0.15, 1.0, laid.rank)
    light = (0.16 + 0.84 * depth) * (0.75 + 0.35 * tone) * (0.82 + 0.12 * rib + 0.06 * vein)
    hue = mixed((0.06, 0.17, 0.025), (0.17, 0.28, 0.05), per_cell(laid.number + 1, rng))
    bow = 1.0 - np.abs(laid.side)
    return Relief(
        hue * light[..., None] * 1.4, laid.rank * 1.6 + 0.18 * bow, 0.75 + 0.25 * (1 - depth)
    )


@texture(mean=(0.86, 0.84, 0.80), depth=0.012)
def sand(n: int, rng: Random) -> Relief:
    """Dry sand with footworn dents and grains; 0.8 m."""
    dunes = noise(n, rng, 3, 16, 1.3, across=1.6)
    grain = noise(n, rng, 120, 256, -0.5)
    specks = smoothstep(2.0, 3.0, noise(n, rng, 100, 256, 0.0))
    tone = 0.86 + 0.022 * dunes + 0.075 * grain
    color = np.clip(tone * (1.0 - 0.45 * specks), 0.1, 1.2)
    shade = color[..., None] * np.array([1.0, 0.985, 0.96], np.float32)
    return Relief(shade, 0.7 * dunes + 0.10 * grain, 1.0)


@texture(mean=(0.72, 0.71, 0.69), depth=0.05)
def gravel(n: int, rng: Random) -> Relief:
    """Pebbles of 1 to 4 cm, the larger on the smaller; 0.8 m."""
    u, v = grid(n)
    warp = noise(n, rng, 4, 40, 1.0)
    color = np.full((n, n, 3), 0.12, np.float32)
    height = np.zeros((n, n), np.float32)
    for count, share in ((60, 1.0), (36, 0.75), (20, 0.5)):
        heap = cells(u + 0.004 * warp, v + 0.004 * np.roll(warp, 77, 0), rng, count, count, 0.9)
        there = per_cell(heap.number, rng) < share
        size = 0.38 + 0.16 * per_cell(heap.number, rng)
        dome = np.sqrt(np.clip(1.0 - (heap.near / size) ** 2, 0.0, 1.0)) * there
        tone = 0.35 + 0.65 * per_cell(heap.number, rng)
        hue = mixed((1.0, 0.93, 0.84), (0.88, 0.94, 1.0), per_cell(heap.number, rng))
        top = 20.0 / count * dome + 0.02 * (60 - count) / 40
        above = (dome > 0.0) & (top > height)
        shade = (tone * (0.45 + 0.55 * dome))[..., None] * hue
        color = np.where(above[..., None], shade, color)
        height = np.where(above, top, height)
    grain = noise(n, rng, 60, 256, 0.3)
    return Relief(color * (1.0 + 0.06 * grain)[..., None], height + 0.01 * grain, 0.95)


@texture(mean=(0.70, 0.66, 0.62), depth=0.03)
def soil(n: int, rng: Random) -> Relief:
    """Earth: crumbs, small stones, roots; 0.8 m."""
    u, v = grid(n)
    lumps, crumbs = noise(n, rng, 2, 30, 1.0), noise(n, rng, 30, 256, 0.5)
    stones = cells(u, v, rng, 26, 26, 1.0)
    size = 0.30 * smoothstep(0.80, 1.0, per_cell(stones.number, rng))
    pebble = smoothstep(1.0, 0.8, stones.near / (size + 1e-3)) * (size > 0.06)
    tone = 0.62 + 0.16 * lumps + 0.16 * crumbs
    earth = np.clip(tone, 0.08, 1.4)[..., None] * np.array([1.0, 0.90, 0.80], np.float32)
    grey = (
        np.array([1.15, 1.10, 1.02], np.float32)
        * (0.7 + 0.3 * per_cell(stones.number, rng))[..., None]
    )
    color = earth + (grey - earth) * pebble[..., None]
    return Relief(color, 0.5 * lumps + 0.25 * crumbs + 0.35 * pebble, 1.0)
