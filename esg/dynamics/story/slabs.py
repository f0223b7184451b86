"""Upright slabs that fall onto their equals: how far off the next one stands, and when one is down.

Two events of which one follows the other lie a tenth of a second apart. Between 45 degrees, from
where on a body counts as toppled, and the touch of its equal at a distance of 0.95 of its height
(72 degrees) a slab that tips over by itself takes 0.15 s sqrt(h / 1 m), one that its equal knocked
over 0.10 s sqrt(h / 1 m) (PhysX and Rapier at 240 Hz, slabs of 0.2 to 1 m, 0.16 as thick as high,
friction 0.4).
"""

from __future__ import annotations

import math

from esg.dynamics.story.stagecraft import Prop
from esg.layout.problem.patterns import is_domino_like

BY_ITSELF_S, KNOCKED_S = 0.15, 0.10
"""From 45 degrees to the touch of what stands at `REACH` of its height, for a slab of a metre."""
REACH = 0.95
"""How far off what a slab falls onto stands, over its height, if the slab is to be down first."""
ORDER_S = 0.13
"""Time between the two: a tenth of a second, and what another engine may take off it."""
ALIKE = 0.6
"""Least height of the lower one of two slabs, over that of the higher one, that stand in a row."""


def are_slabs(a: Prop, b: Prop) -> bool:
    """Whether two bodies are upright slabs of about the same height."""
    alike = ALIKE * max(a.height, b.height) <= min(a.height, b.height)
    return alike and all(is_domino_like(p.length, p.width, p.height) for p in (a, b))


def down_first(height_m: float, *, knocked: bool) -> bool:
    """Whether a slab of a height [m] is down a tenth of a second before it touches its equal."""
    takes = KNOCKED_S if knocked else BY_ITSELF_S
    return takes * math.sqrt(height_m) > 0.75 * ORDER_S
