"""How fast something may turn with what stands on it: by friction, and by tipping outwards."""

from __future__ import annotations

import math

from esg.dynamics.story.stagecraft import Prop, support_of
from esg.dynamics.story.tipping import stand_of
from esg.graph.models import EsgDocument
from esg.units import GRAVITY_MPS2

SPARE = 0.35
"""Share of what would just carry a standing body that is used: the search may turn it 1.4 times as
fast, which doubles the pull outwards."""
STARTS_WITH = 0.25
"""Share of it that getting up to speed takes."""
RIM_MPS = 1.5
"""No faster at the rim with anybody on it (EN 1176-5: at most 5 m/s)."""


def standing_on(doc: EsgDocument, name: str) -> list[str]:
    """What stands or lies on a node."""
    nodes = doc.spatial_relation_graph.nodes
    return [n for n in nodes if n != name and support_of(doc, n) == name]


def carried_rate(bodies: list[Prop], reach: float) -> tuple[float, float]:
    """Rate of turning at which bodies stay upright where they stand, and how fast it is gained.

    Outwards pulls m w^2 r, which friction holds up to mu m g, and over the edge of the base, b from
    the centre of mass at height h, up to m g b / h.

    Args:
        bodies: What stands there.
        reach: Farthest from the axle at which one may stand [m].

    Returns:
        Rate [rad/s] and gain [rad/s^2].
    """
    held: list[float] = []
    for body in bodies:
        stand = stand_of(body)
        held.append(min(body.friction, min(stand.far, stand.near) / stand.height))
    pull = GRAVITY_MPS2 * min(held)
    rate = min(math.sqrt(SPARE * pull / reach), RIM_MPS / reach)
    return rate, STARTS_WITH * pull / reach
