"""What a generator of textures leaves, and the table where it is entered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from esg.assets.textures.noise import Field, Random

NEUTRAL = (0.88, 0.88, 0.88)


class Relief(NamedTuple):
    """A tile as a generator draws it.

    Args:
        color: Reflectance (linear), to a factor: shape [n, n, 3], or [n, n] for grey.
        height: Any unit, shape [n, n].
        roughness: Relative to the material's, shape [n, n] or a number.
    """

    color: NDArray[np.floating]
    height: Field
    roughness: Field | float = 1.0


@dataclass(frozen=True)
class Recipe:
    """A set of maps that can be made.

    Args:
        draw: Draws it with n pixels along each side.
        mean: sRGB its colour map has on average.
        depth: How many tiles high a height of 1 is.
        along: It has a grain along u, which runs along the length of a part.
    """

    draw: Callable[[int, Random], Relief]
    mean: tuple[float, float, float]
    depth: float
    along: bool


RECIPES: dict[str, Recipe] = {}


def texture(
    *, mean: tuple[float, float, float] = NEUTRAL, depth: float = 0.01, along: bool = False
) -> Callable[[Callable[[int, Random], Relief]], Callable[[int, Random], Relief]]:
    """Enters a generator under its function's name."""

    def enter(draw: Callable[[int, Random], Relief]) -> Callable[[int, Random], Relief]:
        RECIPES[draw.__name__] = Recipe(draw, mean, depth, along)
        return draw

    return enter


def mixed(
    low: tuple[float, float, float], high: tuple[float, float, float], share: Field
) -> NDArray[np.floating]:
    """Colours between two, shape [n, n, 3]."""
    a, b = np.array(low, np.float32), np.array(high, np.float32)
    return a + (b - a) * share[..., None]
