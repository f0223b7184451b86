"""Arrangements of groups: pins, rack, row, column, queue, stack, scatter.

A pattern's own frame has its first member at the origin and the others towards +X.
"""

from __future__ import annotations

import math

import numpy as np

from esg.layout.problem.poses import Pose2

PIN_SPACING_OVER_DIAMETER = 30.48 / 12.1
"""Regulation: pins of 12.1 cm stand 30.48 cm apart."""
RACK_GAP_CM = 0.2
DOMINO_PITCH_OVER_HEIGHT = 0.5
"""A falling domino must reach its neighbour well above the middle: 0.4-0.6 of its height."""


def is_domino_like(length: float, width: float, height: float) -> bool:
    """Thin, upright slabs that topple one another."""
    return length <= 0.5 * width and height >= 1.3 * width


def _triangle(count: int, dx: float, dy: float) -> list[Pose2]:
    out: list[Pose2] = []
    row = 0
    while len(out) < count:
        left = min(row + 1, count - len(out))
        out += [(row * dx, (k - 0.5 * (left - 1)) * dy, 0.0) for k in range(left)]
        row += 1
    return out


def arrange(
    pattern: str,
    sizes: list[tuple[float, float, float]],
    rng: np.random.Generator,
    gap: float | None = None,
) -> list[Pose2]:
    """Places the members of one group in the pattern's frame.

    Args:
        pattern: Name of the pattern.
        sizes: Length, width, height of each member [cm].
        rng: Source of the scatter pattern.
        gap: Surface gap between neighbours [cm]; None takes the pattern's own.

    Returns:
        (x, y, yaw) per member [cm, rad].
    """
    n = len(sizes)
    if n == 0:
        return []
    widest = max(max(s[0], s[1]) for s in sizes)
    if pattern == "pins":
        d = PIN_SPACING_OVER_DIAMETER * widest if gap is None else widest + gap
        return _triangle(n, d * math.sqrt(3) / 2, d)
    if pattern == "rack":
        d = widest + (RACK_GAP_CM if gap is None else gap)
        # 0.1% more across a row absorbs rounding, so that no two members touch
        return _triangle(n, d * math.sqrt(3) / 2 * 1.001, d)
    if pattern == "stack":
        return [(0.0, 0.0, 0.0)] * n
    if pattern == "row" and n > 1 and all(is_domino_like(*s) for s in sizes):
        pattern = "queue"  # a row of dominoes stands face to face
    if pattern == "row":
        out, y = [], 0.0
        for k, s in enumerate(sizes):
            if k:
                y += 0.5 * (sizes[k - 1][1] + s[1]) + (
                    max(1.0, 0.25 * min(sizes[k - 1][1], s[1])) if gap is None else gap
                )
            out.append((0.0, y, 0.0))
        return out
    if pattern in ("column", "queue"):
        out, x = [], 0.0
        for k, s in enumerate(sizes):
            if k:
                p = sizes[k - 1]
                room = max(1.0, 0.5 * min(p[0], s[0]))
                step = 0.5 * (p[0] + s[0]) + (room if gap is None else gap)
                if gap is None and is_domino_like(*p) and is_domino_like(*s):
                    step = max(DOMINO_PITCH_OVER_HEIGHT * min(p[2], s[2]), 0.55 * (p[0] + s[0]))
                x += step
            out.append((x, 0.0, 0.0))
        return out
    return scatter(sizes, rng, gap)


def scatter(
    sizes: list[tuple[float, float, float]], rng: np.random.Generator, gap: float | None = None
) -> list[Pose2]:
    """Dart throwing in a disc that grows until everybody fits."""
    radii = [0.5 * math.hypot(s[0], s[1]) + 0.5 * (2.0 if gap is None else gap) for s in sizes]
    extent = 1.6 * math.sqrt(sum(r * r for r in radii))
    out: list[Pose2] = [(0.0, 0.0, 0.0)]
    for k in range(1, len(sizes)):
        tries = 0
        while True:
            tries += 1
            if tries % 40 == 0:
                extent *= 1.15
            x, y = rng.uniform(0, 2 * extent), rng.uniform(-extent, extent)
            if all(
                math.hypot(x - a[0], y - a[1]) >= radii[k] + radii[j] for j, a in enumerate(out)
            ):
                out.append((float(x), float(y), float(rng.uniform(0, 2 * math.pi))))
                break
    return out
