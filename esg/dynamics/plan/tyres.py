"""Which bodies of a document stand on tyres, and how well these hold them to their way."""

from __future__ import annotations

from dataclasses import replace

from esg.dynamics.story.stagecraft import support_of
from esg.engines.scene import Body, SimScene
from esg.graph.models import EsgDocument
from esg.metrics.plausibility.limits import motion_of

_WONG = "Wong, Theory of Ground Vehicles, table 1.2 (peak and sliding friction of tyres)"
GRIPS: tuple[tuple[float, float, str], ...] = (
    (0.0, 0.15, f"{_WONG}: snow and ice 0.07-0.2"),
    (0.15, 0.5, f"{_WONG}: wet asphalt 0.45-0.7, earth and gravel 0.55-0.68"),
    (0.36, 0.8, f"{_WONG}: dry asphalt and concrete 0.75-0.9"),
)
"""Friction of a box on the ground from which on a row holds, friction of tyres there, source."""

SINGLE_TRACK = frozenset({"bicycle", "motorcycle", "moped", "kick_scooter", "scooter", "unicycle"})
"""They have their wheels in a line and fall over when these are pushed aside under them."""


def with_tyres(doc: EsgDocument, scene: SimScene) -> SimScene:
    """A scene whose wheeled bodies have the tyres of their kind.

    Wheels that turn the way they are pushed have none, by the table that a replay is judged by.
    What stands on something that may move has none either: tyres hold a body to the ground, and
    its load is held to a truck by friction.

    Args:
        doc: The document that the scene was built from.
        scene: Without tyres.
    """
    wording = doc.scene_definition.wording
    icy = wording is not None and wording.surface == "ice"
    ground = 0.0 if icy else scene.ground_friction
    grip = next(mu for least, mu, _ in reversed(GRIPS) if ground >= least)
    return scene.with_bodies(tuple(_shod(doc, scene, b, grip) for b in scene.bodies))


def _shod(doc: EsgDocument, scene: SimScene, body: Body, grip: float) -> Body:
    nodes = doc.spatial_relation_graph.nodes
    config = doc.asset_configurations[nodes[body.name].asset_id]
    kinds = {config.category, config.asset_name.rsplit("/", 1)[-1]}
    casters = motion_of(body.label, body.category).moves == "casters"
    if not body.wheeled or body.static or casters:
        return body
    below = support_of(doc, body.name)
    if below is not None and not scene.body(below).static:
        return body
    rolling = 0.5 * (body.friction + scene.vehicle_ground_friction)
    drop = max(0.0, -body.origin_offset[2]) if kinds & SINGLE_TRACK else 0.0
    return replace(body, tyre_friction=max(0.0, grip - rolling), tyre_drop=drop)
