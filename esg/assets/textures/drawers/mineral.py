"""Stone, ice, water and metal."""

from __future__ import annotations

import numpy as np

from esg.assets.textures.noise import Random, cells, grid, noise, per_cell, smoothstep, strokes
from esg.assets.textures.recipe import Relief, mixed, texture


@texture(mean=(0.78, 0.77, 0.75), depth=0.03)
def stone(n: int, rng: Random) -> Relief:
    """Weathered rock with cracks and lichen; 0.8 m."""
    u, v = grid(n)
    big, small = noise(n, rng, 1, 12, 1.4), noise(n, rng, 12, 256, 0.8)
    blocks = cells(u + 0.05 * big, v + 0.05 * noise(n, rng, 1, 12, 1.4), rng, 3, 3, 1.0)
    crack = smoothstep(0.0, 0.05, blocks.edge + 0.01 * small)
    tone = (0.75 + 0.12 * big + 0.10 * small) * (0.45 + 0.55 * crack)
    color = np.clip(tone, 0.05, 1.2)[..., None] * np.array([1.0, 0.98, 0.94], np.float32)
    lichen = smoothstep(1.0, 1.5, noise(n, rng, 3, 30, 1.0) + 0.3 * small)[..., None]
    color = color * (1.0 - 0.4 * lichen) + lichen * np.array([0.36, 0.36, 0.24], np.float32)
    return Relief(color, 0.5 * big + 0.16 * small + 0.5 * crack, 1.0)


@texture(mean=(0.80, 0.80, 0.80), depth=0.0005)
def granite(n: int, rng: Random) -> Relief:
    """Polished granite: grains of feldspar, quartz and mica; 0.3 m."""
    u, v = grid(n)
    warp = noise(n, rng, 10, 120, 1.0)
    grains = cells(u + 0.006 * warp, v + 0.006 * np.roll(warp, 50, 0), rng, 56, 56, 1.0)
    kind = per_cell(grains.number, rng)
    tone = np.where(kind < 0.20, 0.12, np.where(kind < 0.55, 0.62, 0.98))
    pink = smoothstep(0.8, 0.82, kind)[..., None] * np.array([0.06, -0.03, -0.06], np.float32)
    color = (tone * (0.92 + 0.16 * per_cell(grains.number, rng)))[..., None] + pink
    return Relief(np.clip(color, 0.02, 1.1), 0.1 * kind, 1.0)


@texture(mean=(0.90, 0.90, 0.89), depth=0.0002)
def marble(n: int, rng: Random) -> Relief:
    """White marble with grey veins along a slant; 1.2 m."""
    u, v = grid(n)
    bend, turn = noise(n, rng, 1, 9, 1.8), noise(n, rng, 1, 16, 1.6)
    slant = u + 2.0 * v
    veins = np.zeros_like(u)
    for count, sharp, weight in ((2, 0.020, 1.0), (3, 0.012, 0.6), (5, 0.007, 0.35)):
        place = count * slant + 0.45 * bend + 0.12 * count * turn
        near = np.abs(place - np.round(place)) / count
        width = sharp * (0.35 + 0.65 * smoothstep(-1.0, 1.5, np.roll(turn, 37 * count, 0)))
        shown = smoothstep(-0.6, 0.8, np.roll(bend, 61 * count, 1))
        veins = veins + weight * shown * np.exp(-((near / width) ** 1.2))
    cloud = noise(n, rng, 1, 8, 1.4)
    tone = np.clip(0.97 - 0.05 * np.abs(cloud) - 0.5 * np.clip(veins, 0.0, 1.0), 0.1, 1.0)
    warm = np.clip(veins, 0, 1)[..., None] * np.array([0.02, 0.0, -0.03], np.float32)
    return Relief(tone[..., None] + warm, 0.05 * cloud, 1.0)


@texture(mean=(0.90, 0.92, 0.94), depth=0.002)
def ice(n: int, rng: Random) -> Relief:
    """A sheet of ice: clouds and scratches of blades, few cracks; 2 m."""
    u, v = grid(n)
    bend = noise(n, rng, 1, 12, 1.4)
    cracks = cells(u + 0.06 * bend, v + 0.06 * np.roll(bend, 111, 1), rng, 3, 3, 1.0)
    fine = noise(n, rng, 6, 60, 0.8)
    line = np.exp(-((cracks.edge + 0.004 * fine) / 0.010)) * smoothstep(-0.2, 0.6, bend)
    cloud = smoothstep(-0.8, 2.2, noise(n, rng, 1, 20, 1.2))
    cuts = strokes(n, rng, 150, 0.4, 0.0021, 0.0, spread=3.0, bend=0.7, pointed=0.0)
    scratch = np.where(cuts.number >= 0, 0.3 + 0.7 * per_cell(cuts.number + 1, rng), 0.0)
    tone = 0.86 + 0.10 * cloud + 0.30 * line + 0.07 * scratch
    blue = (1.0 - cloud)[..., None] * np.array([-0.07, -0.01, 0.02], np.float32)
    color = np.clip(tone[..., None] + blue, 0.0, 1.1)
    return Relief(color, -0.5 * line - 0.3 * scratch + 0.03 * fine, 0.7 + 0.3 * cloud)


@texture(mean=(0.88, 0.88, 0.88), depth=0.02)
def ripples(n: int, rng: Random) -> Relief:
    """Small waves on water; 2 m."""
    swell = noise(n, rng, 3, 12, 2.4, across=1.6)
    small = noise(n, rng, 12, 40, 2.4, across=1.3)
    height = 0.6 * swell + 0.10 * small
    crest = smoothstep(0.6, 2.2, swell)
    return Relief(0.88 + 0.10 * crest + 0.02 * swell, height, 1.0)


@texture(mean=(0.94, 0.95, 0.96), depth=0.02)
def snow(n: int, rng: Random) -> Relief:
    """Settled snow, soft and grainy; 1 m."""
    drift, grain = noise(n, rng, 1, 10, 1.6), noise(n, rng, 60, 256, 0.0)
    tone = 0.95 + 0.02 * drift + 0.03 * grain
    blue = np.clip(-drift, 0, 2)[..., None] * np.array([-0.02, -0.01, 0.0], np.float32)
    return Relief(tone[..., None] + blue, 0.5 * drift + 0.08 * grain, 0.9)


@texture(mean=(0.93, 0.93, 0.93), depth=0.0006, along=True)
def brushed(n: int, rng: Random) -> Relief:
    """Brushed metal, strokes along u; 0.3 m."""
    lines = noise(n, rng, 20, 256, 0.15, across=60)
    cloud = noise(n, rng, 1, 6, 1.0)
    return Relief(0.94 + 0.035 * lines + 0.015 * cloud, lines, 0.88 + 0.07 * lines)


@texture(mean=(0.88, 0.88, 0.88), depth=0.006)
def cast_metal(n: int, rng: Random) -> Relief:
    """The skin of a sand casting; 0.12 m."""
    bumps, grain = noise(n, rng, 8, 60, 0.6), noise(n, rng, 60, 256, 0.0)
    tone = 0.86 + 0.06 * bumps + 0.04 * grain
    return Relief(tone, bumps + 0.3 * grain, 0.9 + 0.06 * bumps)


@texture(mean=(0.90, 0.90, 0.90), depth=0.05)
def corrugated(n: int, rng: Random) -> Relief:
    """Trapezoidal sheet, six ribs; 0.6 m, ribs are upright."""
    u, _ = grid(n)
    x = u * 6 - np.floor(u * 6)
    rib = smoothstep(0.10, 0.22, x) * smoothstep(0.72, 0.60, x)
    stain = noise(n, rng, 1, 30, 1.0, across=0.3)
    tone = 0.93 + 0.03 * stain - 0.05 * (1.0 - rib)
    dirt = smoothstep(0.9, 2.4, noise(n, rng, 2, 60, 1.0, across=0.25))
    return Relief(tone * (1.0 - 0.14 * dirt), rib, 0.94 + 0.06 * dirt)


@texture(mean=(0.86, 0.86, 0.86), depth=0.012)
def asphalt(n: int, rng: Random) -> Relief:
    """Asphalt concrete: stones of up to 2 cm in bitumen; 2 m."""
    u, v = grid(n)
    warp = noise(n, rng, 10, 100, 0.8)
    stones = cells(u + 0.003 * warp, v + 0.003 * np.roll(warp, 50, 0), rng, 120, 120, 1.0)
    tone = per_cell(stones.number, rng)
    top = smoothstep(0.60, 0.25, stones.near)
    bare = top * smoothstep(0.25, 0.9, tone)
    grain, worn = noise(n, rng, 80, 256, 0.0), noise(n, rng, 1, 8, 1.3)
    light = 0.36 + 0.95 * bare * (0.35 + 0.65 * tone) + 0.08 * grain + 0.025 * worn
    color = np.clip(light, 0.12, 1.4)[..., None] * mixed(
        (1.0, 0.97, 0.92), (0.95, 0.98, 1.0), per_cell(stones.number, rng)
    )
    return Relief(color, 0.5 * top + 0.12 * grain, 1.0)
