"""What people build with: bricks, tiles, stone, concrete, plaster."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from esg.assets.textures.noise import (
    Field,
    Random,
    grid,
    noise,
    per_cell,
    smoothstep,
)
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
    tone = per_cell(number, rng)
    red = mixed((0.30, 0.085, 0.05), (0.44, 0.16, 0.09), tone)
    burnt = smoothstep(0.82, 1.0, per_cell(number, rng))[..., None]
    red = red * (1.0 - 0.55 * burnt) * (1.0 + 0.10 * grain + 0.10 * noise(n, rng, 8, 60))[..., None]
    mortar = np.array([0.42, 0.40, 0.36], np.float32) * (1.0 + 0.08 * grain)[..., None]
    color = mortar + (red - mortar) * stone[..., None]
    height = stone * (1.0 + 0.06 * grain) + 0.05 * grain
    return Relief(color, height, 0.94 + 0.06 * stone)
