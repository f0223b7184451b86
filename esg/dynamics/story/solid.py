"""Where a body is solid at the height of what comes towards it: a table is four legs to a ball."""

from __future__ import annotations

import numpy as np

from esg.dynamics.story.proxies import corners
from esg.dynamics.story.stagecraft import Prop
from esg.graph.models import Proxy

MET = 0.35
"""Least share of its height with which something low meets a part."""
NARROW = 0.35
"""Share of its half width by which something may be met off its middle."""


def beside_the_middle(mover: Prop, target: Prop, relative: float) -> float:
    """How far a target's solid part lies off the middle of a path, to the left [m].

    0 where the path meets something solid in the middle, or nothing at that height at all.

    Args:
        mover: What comes along the ground.
        target: What it shall meet.
        relative: Heading of the path from the target's own X axis [rad].
    """
    if target.config is None or target.rolls:
        return 0.0
    across = np.array([-np.sin(relative), np.cos(relative)])
    parts = [
        span
        for proxy in target.config.proxies
        if (span := _span(proxy, across, mover.height)) is not None
    ]
    slack = NARROW * mover.half_width
    if not parts or any(low <= slack and high >= -slack for low, high in parts):
        return 0.0
    return min((0.5 * (low + high) for low, high in parts), key=abs)


def _span(proxy: Proxy, across: np.ndarray, height: float) -> tuple[float, float] | None:
    """Extent of a collision shape across a path [m], None where it is above what comes."""
    points = corners(proxy) / 100.0
    overlap = min(points[:, 2].max(), height) - max(points[:, 2].min(), 0.0)
    if overlap < MET * height:
        return None
    at = points[:, :2] @ across
    return float(at.min()), float(at.max())
