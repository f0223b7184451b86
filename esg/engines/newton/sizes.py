"""Sizes of problems on a GPU: few of them, since the solver compiles a kernel for each.

A kernel there holds how many rows and coordinates a world has room for. It loops over the rows that
there are, and lanes of coordinates that a world lacks add zero: more room costs memory and changes
no result.
"""

from __future__ import annotations

from itertools import pairwise

LEAST, MOST = 32, 1024
"""Lanes that work together anyway, and the room above which the memory they share is scarce."""
DOFS = 6
"""Coordinates of a body."""
COMMON_DOFS = (32, 64, 128, 256)
"""Of worlds that searches play: up to 42 bodies."""


def rung(size: int) -> int:
    """The room for so many points, rows or coordinates of a world on a GPU."""
    if size <= MOST:
        return max(LEAST, 1 << max(0, size - 1).bit_length())
    return rounded(size)


def rounded(points: int) -> int:
    """The next power of two, or three quarters of it."""
    size = 1 << max(4, (points - 1).bit_length())
    return size * 3 // 4 if points <= size * 3 // 4 else size


def common(world: int, shape: int) -> list[tuple[int, int]]:
    """Bodies of a world and its room for contact points, one of each size that set-up compiles.

    Args:
        world, shape: Room for points of a world and of each moving shape (`Points`): a body has at
            least one.
    """
    points = [LEAST << k for k in range((MOST // LEAST).bit_length())]
    out: list[tuple[int, int]] = []
    for below, dofs in pairwise((0, *COMMON_DOFS)):
        fewest = below // DOFS + 1
        least = rung(world + shape * fewest)
        out += [(dofs // DOFS, p) for p in points if p >= least]
    return out
