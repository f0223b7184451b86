"""Which bodies of a document stand on tyres, and how well these hold them to their way."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from esg.dynamics.story.paces import grip
from esg.dynamics.story.stagecraft import support_of
from esg.engines.rest import bounds_of
from esg.engines.scene import Body, SimScene
from esg.graph.models import EsgDocument
from esg.metrics.plausibility.limits import motion_of
from esg.thresholds import BRAKING_DRY_G
from esg.units import GRAVITY_MPS2

SINGLE_TRACK = frozenset({"bicycle", "motorcycle", "moped", "kick_scooter", "scooter", "unicycle"})
"""They have their wheels in a line and fall over when these are pushed aside under them."""
UPRIGHT = (0.0, 0.0, 0.0, 1.0)
LEVEL_M = 0.01
"""Parts whose bottoms differ by less stand on the same ground."""


def with_tyres(doc: EsgDocument, scene: SimScene) -> SimScene:
    """A scene whose wheeled bodies have the tyres of their kind: they hold as brakes do.

    Wheels that turn the way they are pushed have none, by the table that a replay is judged by.
    What stands on something that may move has none either: tyres hold a body to the ground, and
    its load is held to a truck by friction.

    Args:
        doc: The document that the scene was built from.
        scene: Without tyres.
    """
    return scene.with_bodies(tuple(_shod(doc, scene, b) for b in scene.bodies))


def _shod(doc: EsgDocument, scene: SimScene, body: Body) -> Body:
    nodes = doc.spatial_relation_graph.nodes
    config = doc.asset_configurations[nodes[body.name].asset_id]
    kinds = {config.category, config.asset_name.rsplit("/", 1)[-1]}
    motion = motion_of(body.label, body.category)
    if not body.wheeled or body.static or motion.moves == "casters":
        return body
    below = support_of(doc, body.name)
    if below is not None and not scene.body(below).static:
        return body
    # The grip of what flies is its wings'.
    most = BRAKING_DRY_G if motion.flies else grip(doc, body.name) / GRAVITY_MPS2
    rolling = 0.5 * (body.friction + scene.vehicle_ground_friction)
    shod = replace(body, tyre_friction=max(0.0, most - rolling))
    if not kinds & SINGLE_TRACK:
        return shod
    drop = max(0.0, -body.origin_offset[2])
    return replace(shod, tyre_drop=drop, tyre_foot=_half_track(body))


def _half_track(body: Body) -> float:
    """How far to the side a body's shapes reach where it stands [m]."""
    low, high = bounds_of(replace(body, position=(0.0, 0.0, 0.0), quaternion=UPRIGHT))
    foot = low[:, 2] < low[:, 2].min() + LEVEL_M
    return float(np.maximum(-low[foot, 1], high[foot, 1]).max())
