"""Paper, cardboard and sports floors."""

from __future__ import annotations

import numpy as np

from esg.assets.textures.noise import Random, cells, grid, noise, per_cell, smoothstep, strokes
from esg.assets.textures.recipe import Relief, mixed, texture


@texture(mean=(0.95, 0.95, 0.94), depth=0.001)
def paper(n: int, rng: Random) -> Relief:
    """Uncoated paper: a felt of fibres; 0.2 m."""
    fibre, cloud = noise(n, rng, 30, 256, 0.1), noise(n, rng, 4, 40, 0.8)
    return Relief(0.96 + 0.012 * fibre + 0.012 * cloud, fibre, 1.0)


@texture(mean=(0.86, 0.85, 0.83), depth=0.006, along=True)
def cardboard(n: int, rng: Random) -> Relief:
    """Corrugated board: the flutes show through, fibres in the liner; 0.3 m."""
    _, v = grid(n)
    flutes = np.cos(2.0 * np.pi * 44.0 * v + 0.4 * noise(n, rng, 1, 8, 1.0))
    laid = strokes(n, rng, 1800, 0.02, 0.0022, 0.0, spread=3.0, bend=1.0, pointed=0.0)
    fleck = np.where(laid.number >= 0, per_cell(laid.number + 1, rng) - 0.5, 0.0)
    fine, cloud = noise(n, rng, 40, 256, 0.1), noise(n, rng, 1, 10, 1.0)
    tone = 0.88 + 0.02 * flutes + 0.12 * fleck + 0.03 * fine + 0.02 * cloud
    color = tone[..., None] * np.array([1.0, 0.985, 0.96], np.float32)
    return Relief(color, 0.5 * flutes + 0.15 * fine, 1.0)


@texture(mean=(0.80, 0.80, 0.80), depth=0.004)
def speckle(n: int, rng: Random) -> Relief:
    """Rubber flooring with coloured granules; 0.6 m."""
    u, v = grid(n)
    warp = noise(n, rng, 10, 100, 0.8)
    grains = cells(u + 0.003 * warp, v + 0.003 * np.roll(warp, 60, 0), rng, 90, 90, 1.0)
    shown = (per_cell(grains.number, rng) < 0.14) * smoothstep(0.5, 0.35, grains.near)
    hue = mixed((0.75, 1.0, 1.25), (1.25, 1.1, 0.85), per_cell(grains.number, rng))
    base = (0.55 + 0.04 * noise(n, rng, 40, 256, 0.2))[..., None]
    color = base + (1.35 * hue - base) * shown[..., None]
    return Relief(color, 0.4 * shown + 0.15 * noise(n, rng, 60, 256, 0.0), 1.0)
