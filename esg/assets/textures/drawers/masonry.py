"""What people build with: bricks, tiles, plaster, paving."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.assets.textures.noise import Field, Random, cells, grid, noise, per_cell, smoothstep
from esg.assets.textures.recipe import Relief, mixed, texture


def courses(
    u: Field, v: Field, across: int, down: int, shift: float = 0.5
) -> tuple[NDArray[np.int64], Field, Field]:
    """A running bond: number of the stone, distance to its upright and its level joints [tiles].

    Args:
        u, v: Where, in tiles.
        across, down: Stones along u, courses along v.
        shift: By how much of a stone every second course is shifted.
    """
    row = np.floor(v * down).astype(np.int64)
    x = u * across + shift * (row % 2)
    column = np.floor(x).astype(np.int64)
    fx, fy = x - column, v * down - row
    upright = np.minimum(fx, 1.0 - fx) / across
    level = np.minimum(fy, 1.0 - fy) / down
    return (row % down) * across + column % across, upright, level


@texture(mean=(0.60, 0.34, 0.27), depth=0.008)
def brick(n: int, rng: Random) -> Relief:
    """Running bond: 4 x 12 bricks of 21.5 x 6.5 cm in 0.9 m, with mortar."""
    u, v = grid(n)
    wobble = noise(n, rng, 6, 40, 1.2)
    number, upright, level = courses(
        u + 0.0008 * wobble, v + 0.0008 * np.roll(wobble, 99, 1), 4, 12
    )
    grain = noise(n, rng, 30, 256, 0.4)
    inside = np.minimum(upright, level) + 0.0007 * grain
    stone = smoothstep(0.0045, 0.0075, inside)
    red = mixed((0.30, 0.085, 0.05), (0.44, 0.16, 0.09), per_cell(number, rng))
    burnt = smoothstep(0.82, 1.0, per_cell(number, rng))[..., None]
    red = red * (1.0 - 0.55 * burnt) * (1.0 + 0.10 * grain + 0.10 * noise(n, rng, 8, 60))[..., None]
    mortar = np.array([0.42, 0.40, 0.36], np.float32) * (1.0 + 0.08 * grain)[..., None]
    color = mortar + (red - mortar) * stone[..., None]
    height = stone * (1.0 + 0.06 * grain) + 0.05 * grain
    return Relief(color, height, 0.94 + 0.06 * stone)


@texture(mean=(0.90, 0.90, 0.90), depth=0.004)
def tiles(n: int, rng: Random) -> Relief:
    """Glazed tiles of 15 cm with grout; 0.6 m."""
    u, v = grid(n)
    number, upright, level = courses(u, v, 4, 4, 0.0)
    inside = np.minimum(upright, level)
    glaze = smoothstep(0.0025, 0.0055, inside)
    bulge = smoothstep(0.0, 0.012, inside)
    tone = 0.97 + 0.06 * (per_cell(number, rng) - 0.5) + 0.012 * noise(n, rng, 2, 20)
    grout = 0.52 + 0.05 * noise(n, rng, 20, 200, 0.5)
    color = grout + (tone - grout) * glaze
    return Relief(color, bulge + 0.008 * noise(n, rng, 2, 10), np.where(glaze > 0.5, 0.45, 1.0))


@texture(mean=(0.80, 0.80, 0.79), depth=0.006)
def paving(n: int, rng: Random) -> Relief:
    """Concrete slabs of 60 x 30 cm; 1.2 m."""
    u, v = grid(n)
    number, upright, level = courses(u, v, 2, 4)
    grain = noise(n, rng, 40, 256, 0.2)
    stain = noise(n, rng, 1, 16, 1.2)
    inside = np.minimum(upright, level) + 0.0006 * grain
    slab = smoothstep(0.0015, 0.006, inside)
    tone = 0.86 + 0.14 * (per_cell(number, rng) - 0.5) + 0.05 * stain + 0.07 * grain
    pits = smoothstep(1.7, 2.6, noise(n, rng, 30, 120, 0.0))
    color = (0.30 + (tone - 0.30) * slab) * (1.0 - 0.35 * pits)
    shade = color[..., None] * np.array([1.0, 0.99, 0.965], np.float32)
    return Relief(shade, slab + 0.03 * grain - 0.08 * pits, 1.0)


@texture(mean=(0.72, 0.71, 0.69), depth=0.03)
def cobbles(n: int, rng: Random) -> Relief:
    """Setts of about 10 cm in rows; 1 m."""
    u, v = grid(n)
    wobble = noise(n, rng, 3, 20, 1.2)
    number, upright, level = courses(u + 0.004 * wobble, v - 0.004 * np.roll(wobble, 70, 0), 9, 10)
    fx, fy = upright * 9, level * 10
    inside = -np.log(np.exp(-9.0 * fx) + np.exp(-9.0 * fy) + 1e-9) / 9.0
    stone = smoothstep(0.01, 0.22, inside)
    grain = noise(n, rng, 30, 256, 0.4)
    tilt = per_cell(number, rng)
    tone = (0.55 + 0.45 * tilt) * (1.0 + 0.14 * grain)
    rock = tone[..., None] * mixed((0.95, 0.92, 0.88), (0.88, 0.93, 1.0), per_cell(number, rng))
    earth = np.array([0.22, 0.20, 0.17], np.float32) * (1.0 + 0.2 * grain)[..., None]
    color = earth + (rock - earth) * smoothstep(0.0, 0.06, inside)[..., None]
    return Relief(color, stone * (0.85 + 0.25 * tilt) + 0.03 * grain, 0.85 + 0.15 * (1.0 - stone))


@texture(mean=(0.74, 0.72, 0.71), depth=0.05)
def roof_tiles(n: int, rng: Random) -> Relief:
    """Pantiles in overlapping rows; 1.2 m, the ridge is up."""
    u, v = grid(n)
    across, down = 6, 5
    row = np.floor(v * down).astype(np.int64)
    fy = v * down - row
    column = np.floor(u * across).astype(np.int64) % across
    fx = u * across - np.floor(u * across)
    wave = 0.5 + 0.5 * np.cos(2.0 * np.pi * fx)
    number = row * across + column
    fy = fy + 0.06 * wave
    row = row + (fy > 1.0)
    fy = fy - (fy > 1.0)
    number = (row % down) * across + column
    lip = smoothstep(0.0, 0.05, fy)
    height = 0.55 * wave + 0.45 * fy * lip
    grain = noise(n, rng, 10, 200, 0.7)
    dirt = noise(n, rng, 2, 12, 1.0)
    tone = (0.72 + 0.30 * per_cell(number, rng)) * (1.0 + 0.08 * grain - 0.07 * dirt)
    shadow = (0.25 + 0.75 * smoothstep(-0.02, 0.10, fy)) * (0.55 + 0.45 * smoothstep(0, 0.5, wave))
    color = (tone * shadow)[..., None] * mixed((1, 0.96, 0.94), (0.92, 1, 1), per_cell(number, rng))
    return Relief(color, height + 0.01 * grain, 1.0)


@texture(mean=(0.90, 0.90, 0.89), depth=0.003)
def plaster(n: int, rng: Random) -> Relief:
    """Rendered wall with the marks of the float; 1.5 m."""
    grain = noise(n, rng, 60, 256, -0.2)
    float_ = noise(n, rng, 4, 50, 0.9, across=1.6)
    stain = noise(n, rng, 1, 6, 1.3)
    tone = 0.95 + 0.012 * grain + 0.015 * float_ + 0.02 * stain
    return Relief(tone, 0.35 * grain + 0.5 * float_, 1.0)


@texture(mean=(0.89, 0.89, 0.88), depth=0.001)
def wallpaper(n: int, rng: Random) -> Relief:
    """A damask of leaves in offset rows, tone in tone; one width of 53 cm."""
    u, v = grid(n)
    paper = noise(n, rng, 60, 256, 0.0)
    ornament = np.zeros_like(u)
    for shift in (0.0, 0.5):
        x = 3.0 * u + shift
        y = 2.0 * v + shift
        x, y = x - np.floor(x) - 0.5, y - np.floor(y) - 0.5
        r, a = np.hypot(1.5 * x, y), np.arctan2(np.abs(x) * 1.5, -y)
        petals = 0.26 + 0.10 * np.cos(5.0 * a) + 0.05 * np.cos(11.0 * a)
        leaf = smoothstep(0.012, -0.012, r - petals) * smoothstep(-0.012, 0.012, r - 0.55 * petals)
        heart = smoothstep(0.012, -0.012, r - 0.32 * petals)
        stem = smoothstep(0.016, 0.006, np.abs(np.abs(x) - 0.16 * np.sin(np.pi * y) ** 2 - 0.02))
        stem = stem * smoothstep(0.30, 0.36, np.abs(y))
        ornament = np.maximum(ornament, np.maximum(leaf, np.maximum(heart, stem)))
    tone = 0.96 - 0.17 * ornament + 0.012 * paper
    return Relief(tone, 0.5 * ornament + 0.15 * paper, 1.0 - 0.25 * ornament)


@texture(mean=(0.84, 0.84, 0.83), depth=0.004)
def concrete(n: int, rng: Random) -> Relief:
    """Cast concrete: clouds, pores, fine grain; 2 m."""
    grain = noise(n, rng, 60, 256, 0.0)
    cloud = noise(n, rng, 1, 20, 1.3)
    u, v = grid(n)
    holes = cells(u, v, rng, 44, 44, 1.0)
    size = per_cell(holes.number, rng)
    pores = smoothstep(1.0, 0.55, holes.near / (0.02 + 0.22 * smoothstep(0.75, 1.0, size)))
    tone = 0.90 + 0.045 * cloud + 0.035 * grain
    color = np.clip(tone * (1.0 - 0.5 * pores), 0.05, 1.2)
    shade = color[..., None] * np.array([1.0, 0.99, 0.97], np.float32)
    return Relief(shade, 0.12 * grain + 0.1 * cloud - pores, 1.0)
