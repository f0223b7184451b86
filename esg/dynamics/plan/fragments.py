"""Fragments of what a document says breaks: the border of the simulator (SI)."""

from __future__ import annotations

from dataclasses import replace

from esg.engines.breaking.pieces import broken
from esg.engines.scene import Body, SimScene
from esg.graph.models import EsgDocument
from esg.outcomes import UserError
from esg.units import m_from_cm


def with_fragments(doc: EsgDocument, scene: SimScene) -> SimScene:
    """A scene with what its bodies break into that can, at the end of the list.

    Args:
        doc: Whose nodes say how they break.
        scene: With one body of each node.

    Raises:
        UserError: If something cannot be cut into as many pieces.
    """
    nodes = doc.spatial_relation_graph.nodes
    out: list[Body] = []
    fragments: list[Body] = []
    for body in scene.bodies:
        told = nodes[body.name].breaking
        if told is None or not body.shapes:
            out.append(body)
            continue
        impulse = body.mass * m_from_cm(told.speed)
        try:
            whole, pieces = broken(replace(body, break_impulse=impulse), told.pieces)
        except ValueError as error:
            raise UserError(
                f"/spatial_relation_graph/nodes/{body.name}/breaking/pieces: {error}; take fewer"
            ) from None
        out.append(whole)
        fragments += pieces
    return scene.with_bodies((*out, *fragments)) if fragments else scene
