"""Liquids in vessels bear up what is in them, as primitives of the control program.

Where a vessel moves or is met by something, its liquid does nothing: nothing that sloshes is
simulated, and a basin that stayed behind would bear things up in the air.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.story.stagecraft import support_of
from esg.engines.program import BuoyUp
from esg.engines.scene import Region, SimScene
from esg.graph.casting import effective
from esg.graph.floating import afloat
from esg.graph.models import EsgDocument, NodeEvent
from esg.lexicon.contents import CONTENT, contents
from esg.units import quat_rotate, yaw_from_quat

_RESTS = frozenset({NodeEvent.SCENE_START, NodeEvent.ENTER_REGION, NodeEvent.TRIGGER})
"""Events that leave a vessel standing that takes part in them."""
_BESIDE = 1.0
"""Least width of a body over that of a basin that it cannot be in."""


def liquids(doc: EsgDocument, scene: SimScene) -> tuple[BuoyUp, ...]:
    """What every liquid of a scene does to every body that may be in it."""
    basins = [r for r in scene.regions if r.kind == CONTENT]
    if not basins:
        return ()
    doc = effective(doc)
    still = [r for r in basins if _stands(doc, scene, r.parent)]
    return tuple(p for region in still for p in _of_basin(doc, scene, region))


def waterline(doc: EsgDocument, scene: SimScene, vessel: str, body: str) -> float:
    """Height of the lowest point of a body that lies in the liquid of a vessel as it floats, or
    just under its level if it sinks; -inf where the vessel has none [m]."""
    nodes = doc.spatial_relation_graph.nodes
    for region in scene.regions:
        row = contents().get(region.name.rpartition("/")[2]) if region.kind == CONTENT else None
        if region.parent == vessel and row is not None and row.liquid and body in nodes:
            share = afloat(doc.asset_configurations[nodes[body].asset_id], row).share
            level = float(_level(scene, region)[2])
            return level - 2.0 * share * scene.body(body).half_extents[2]
    return -math.inf


def _level(scene: SimScene, region: Region) -> NDArray[np.float64]:
    """Middle of the level of a content [m]."""
    vessel = scene.body(region.parent)
    x, y, z = region.center
    top = np.array([x, y, z + region.half_extents[2]])
    level: NDArray[np.float64] = np.array(vessel.position)
    return level + quat_rotate(np.array(vessel.quaternion), top)


def _stands(doc: EsgDocument, scene: SimScene, vessel: str) -> bool:
    """Whether nothing of the story moves a vessel or what it stands on."""
    if doc.timeline_system is None:
        return True
    graph = doc.timeline_system.sequence_graph
    under, below = [vessel], support_of(doc, vessel)
    while below is not None and below not in under:
        under.append(below)
        below = support_of(doc, below)
    moved = {e.actor for e in graph.edges}
    met = {
        p
        for n in graph.nodes
        if n.event not in _RESTS
        for p in n.participants[: 1 if n.event is NodeEvent.PLACED else None]
    }
    loose = {p for p in under if p in scene.names and not scene.body(p).static}
    return not loose & (moved | met)


def _of_basin(doc: EsgDocument, scene: SimScene, region: Region) -> list[BuoyUp]:
    row = contents()[region.name.rpartition("/")[2]]
    if not row.liquid:
        return []
    vessel = scene.body(region.parent)
    level = _level(scene, region)
    nodes = doc.spatial_relation_graph.nodes
    out: list[BuoyUp] = []
    for body in scene.bodies:
        free = body.collides and not body.static
        if not free or body.name == vessel.name or body.name not in nodes:
            continue
        if sorted(body.half_extents)[1] > _BESIDE * min(region.half_extents[:2]):
            continue
        # Its extents are about the middle of its box, over its centre of mass as it stands.
        over = body.origin_offset[2] + body.half_extents[2]
        does = afloat(doc.asset_configurations[nodes[body.name].asset_id], row)
        out.append(
            BuoyUp(
                body=body.name,
                start=0.0,
                end=math.inf,
                center=_rounded(level - np.array([0.0, 0.0, over])),
                basin=_rounded(region.half_extents),
                extents=_rounded(body.half_extents),
                lift=round(does.lift, 6),
                linear_drag=round(does.linear, 6),
                quadratic_drag=round(does.quadratic, 6),
                turning_drag=round(does.turning, 6),
                heading=round(float(yaw_from_quat(vessel.quaternion)), 9),
                round=does.ball,
            )
        )
    return out


def _rounded(values: object) -> tuple[float, float, float]:
    x, y, z = np.round(np.asarray(values, float), 9).tolist()
    return x, y, z
