"""Skins: leather, fur, feathers, peel, and what imitates them."""

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
)
from esg.assets.textures.recipe import Relief, texture


@texture(mean=(0.86, 0.85, 0.84), depth=0.007)
def leather(n: int, rng: Random) -> Relief:
    """Grained cowhide: small fields between creases; 12 cm."""
    u, v = grid(n)
    warp, other = noise(n, rng, 3, 40, 1.0), noise(n, rng, 3, 40, 1.0)
    fields = cells(u + 0.012 * warp, v + 0.012 * other, rng, 34, 34, 0.95)
    dome = smoothstep(0.0, 0.45, fields.edge)
    creases = np.abs(noise(n, rng, 2, 14, 1.2))
    crease = smoothstep(0.10, 0.0, creases)
    patina = noise(n, rng, 1, 8, 1.2)
    tone = (0.86 + 0.14 * dome) * (0.96 + 0.06 * per_cell(fields.number, rng))
    tone = tone * (1.0 - 0.16 * crease) * (1.0 + 0.05 * patina)
    return Relief(tone, dome - 0.5 * crease, 0.8 + 0.2 * (1.0 - dome))


@texture(mean=(0.90, 0.88, 0.87), depth=0.0016)
def skin(n: int, rng: Random) -> Relief:
    """Skin: a faint net of lines, freckles; 10 cm."""
    u, v = grid(n)
    warp = noise(n, rng, 4, 40, 1.0)
    net = cells(u + 0.008 * warp, v + 0.008 * np.roll(warp, 90, 0), rng, 60, 60, 1.0)
    dome = smoothstep(0.0, 0.35, net.edge)
    blood = noise(n, rng, 1, 12, 1.2)
    tone = (0.95 + 0.04 * dome)[..., None] + blood[..., None] * np.array(
        [0.012, -0.014, -0.012], np.float32
    )
    return Relief(tone, dome + 0.4 * noise(n, rng, 20, 120, 0.5), 0.9 + 0.1 * dome)


@texture(mean=(0.78, 0.77, 0.76), depth=0.02, along=True)
def fur(n: int, rng: Random) -> Relief:
    """Short hair lying along u in locks; 0.25 m."""
    lie = noise(n, rng, 1, 6, 1.4)
    count = 11000
    u, v = rng.random((2, count), dtype=np.float32)
    turn = 0.45 * lie[(v * n).astype(int) % n, (u * n).astype(int) % n]
    hairs = strokes(n, rng, count, 0.085, 0.0052, turn, spread=0.16, bend=0.25, at=(u, v))
    tone = per_cell(hairs.number + 1, rng)
    light = (0.42 + 0.58 * hairs.along) * (0.62 + 0.45 * tone) * (0.55 + 0.45 * hairs.rank)
    color = light[..., None] * np.array([1.0, 0.97, 0.94], np.float32)
    return Relief(color, hairs.rank + 0.25 * hairs.along, 1.0)


@texture(mean=(0.74, 0.73, 0.72), depth=0.02, along=True)
def hair(n: int, rng: Random) -> Relief:
    """Long combed strands along u; 12 cm."""
    strands = noise(n, rng, 12, 256, 0.35, across=28)
    locks = noise(n, rng, 2, 14, 0.9, across=9)
    light = np.clip(0.58 + 0.20 * strands + 0.11 * locks, 0.06, 1.3)
    color = light[..., None] * np.array([1.0, 0.96, 0.92], np.float32)
    return Relief(color, 0.5 * strands + 0.5 * locks, 0.9)


@texture(mean=(0.82, 0.82, 0.81), depth=0.02)
def feathers(n: int, rng: Random) -> Relief:
    """Rows of overlapping feathers, tips down; 0.18 m."""
    u, v = grid(n)
    across, down = 7, 10
    row = np.floor(v * down).astype(np.int64)

    def of(row: NDArray[np.int64]) -> tuple[Field, Field, NDArray[np.int64]]:
        x = u * across + 0.5 * (row % 2)
        column = np.floor(x).astype(np.int64)
        return 2.0 * (x - column) - 1.0, v * down - row, (row % down) * across + column % across

    fx, y, number = of(row - 1)  # its tips lie on the roots of the next row
    over = y < 1.55 - 0.55 * fx**2
    here = of(row)
    fx, y = np.where(over, fx, here[0]), np.where(over, y, here[1])
    number = np.where(over, number, here[2])
    fringe = smoothstep(0.0, 0.28, 1.55 - 0.55 * fx**2 - y)
    barb = 0.5 + 0.5 * np.cos(40.0 * (0.5 * y + 0.45 * np.abs(fx)))
    quill = smoothstep(0.10, 0.03, np.abs(fx))
    tone = (0.55 + 0.30 * y) * (0.78 + 0.22 * fringe) * (0.94 + 0.06 * barb) * (1 - 0.12 * quill)
    tone = tone * (0.92 + 0.14 * per_cell(number, rng)) + 0.03 * noise(n, rng, 30, 256, 0.0)
    return Relief(tone, 0.2 + 0.5 * y * fringe, 0.95)


@texture(mean=(0.90, 0.89, 0.88), depth=0.006)
def peel(n: int, rng: Random) -> Relief:
    """The skin of a fruit: dimples and speckles; 4 cm."""
    u, v = grid(n)
    dents = cells(u, v, rng, 26, 26, 0.9)
    dimple = smoothstep(0.42, 0.0, dents.near)
    blush = noise(n, rng, 1, 8, 1.2)
    speck = smoothstep(0.88, 1.0, per_cell(dents.number, rng)) * smoothstep(0.2, 0.05, dents.near)
    tone = 0.94 - 0.05 * dimple + 0.03 * blush + 0.10 * speck
    return Relief(tone, -dimple, 0.9 + 0.1 * dimple)


@texture(mean=(0.88, 0.88, 0.88), depth=0.03)
def pebbled(n: int, rng: Random) -> Relief:
    """Small round bumps: a basketball, the grain of plastics; 2.5 to 5 cm."""
    u, v = grid(n)
    bumps = cells(u, v, rng, 16, 16, 0.55)
    dome = np.sqrt(np.clip(1.0 - (bumps.near / 0.48) ** 2, 0.0, 1.0))
    fine = noise(n, rng, 60, 256, 0.0)
    return Relief(0.80 + 0.18 * dome + 0.015 * fine, dome, 0.85 + 0.15 * (1.0 - dome))


@texture(mean=(0.90, 0.90, 0.90), depth=0.006)
def rubber(n: int, rng: Random) -> Relief:
    """Moulded rubber: a matt fine grain and dust; 8 cm."""
    grain, dust = noise(n, rng, 40, 256, 0.2), noise(n, rng, 1, 30, 1.0)
    tone = 0.88 + 0.035 * grain + 0.04 * dust
    return Relief(tone, grain, 0.92 + 0.05 * dust)
