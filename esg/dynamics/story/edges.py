"""Where a support ends, as seen by what goes over its edge."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.story.proxies import corners
from esg.dynamics.story.stagecraft import top_surface
from esg.graph.models import EsgDocument, Proxy, ProxyKind

LEVEL_CM = 3.0
"""Parts whose top is within this of a surface belong to it."""
RIM_CM = 6.0
"""How far a support may reach beyond the surface that things stand on without being more of it."""


@dataclass(frozen=True)
class Edge:
    """The edge that something leaves a support over.

    Args:
        at: Distance from the support's origin [m].
        backwards: Whether it lies behind the origin (-X), not before it.
    """

    at: float
    backwards: bool = False


def edge_of(doc: EsgDocument, name: str) -> Edge:
    """The end of a support's highest surface, in front unless only the way down behind it is free.

    The roof of a truck ends later than the part of it on which things are put, and before it
    there is the cab.

    Args:
        doc: A document with assets.
        name: The support.
    """
    surface = top_surface(doc, name)
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    usual = Edge((surface.center_cm[0] + surface.half_extents_cm[0]) / 100.0)
    if not config.proxies:
        return usual
    bounds = np.array([_along(p) for p in config.proxies])
    level = np.abs(bounds[:, 2] - surface.center_cm[2]) < LEVEL_CM
    if not level.any() or any(
        p.kind is ProxyKind.CONVEX for p, on in zip(config.proxies, level, strict=True) if on
    ):
        return usual
    ends = bounds[level, 1].max(), -bounds[level, 0].min()
    juts = bounds[:, 1].max() - ends[0], -bounds[:, 0].min() - ends[1]
    if juts[0] > RIM_CM and juts[1] < juts[0]:
        return Edge(ends[1] / 100.0, backwards=True)
    if ends[0] > 100.0 * usual.at + RIM_CM:
        return Edge(ends[0] / 100.0)
    return usual


def _along(proxy: Proxy) -> NDArray[np.float64]:
    """Least and greatest X and greatest Z of a collision shape [cm], shape [3]."""
    points = corners(proxy)
    return np.array([points[:, 0].min(), points[:, 0].max(), points[:, 2].max()])
