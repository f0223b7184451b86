"""The same scene with other collision shapes: what does an outcome owe to their detail?"""

from __future__ import annotations

from dataclasses import replace
import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import Body, Shape, SimScene
from esg.graph.casting import effective
from esg.graph.models import AssetConfiguration, EsgDocument, Proxy, ProxyKind
from esg.units import quat_rotate

Extents = tuple[float, float, float]

SIDES = 16
COMPACT = 1.6
"""Bodies whose longest side is at most this often the shortest become spheres."""


def corners(proxy: Proxy) -> NDArray[np.float64]:
    """Corners of a collision shape, or of the box around it, in its asset's frame [cm] [n, 3]."""
    half = np.array(proxy.size_cm, float)
    if proxy.kind is ProxyKind.CAPSULE:
        half[2] += half[0]
    signs = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)], float)
    local = np.array(proxy.vertices_cm) if proxy.vertices_cm else signs * half
    return quat_rotate(np.array(proxy.orientation_xyzw), local) + np.array(proxy.position_cm)


def faceted(scene: SimScene) -> SimScene:
    """The scene with cylinders as convex prisms of 16 sides, itself if it has none.

    A mesh or an engine without cylinders represents them so. Corners lie on the cylinder's surface.
    """
    if not any(s.kind == "cylinder" for b in scene.bodies for s in b.shapes):
        return scene
    bodies = tuple(
        replace(b, shapes=tuple(_prism(s) if s.kind == "cylinder" else s for s in b.shapes))
        for b in scene.bodies
    )
    return replace(scene, bodies=bodies)


def _prism(shape: Shape) -> Shape:
    radius, half = shape.size[0], shape.size[2]
    corners = [
        (radius * math.cos(a), radius * math.sin(a), z)
        for z in (-half, half)
        for a in (2.0 * math.pi * (k + 0.5) / SIDES for k in range(SIDES))
    ]
    return replace(shape, kind="convex", size=(radius, radius, half), vertices=tuple(corners))


def coarse(scene: SimScene, kind: str = "box") -> SimScene:
    """The scene with one sphere or bounding box a body (the paper's simple proxies).

    Static bodies and balls keep their shapes: something has to carry what stands on a table.

    Args:
        scene: The scene.
        kind: "box" makes spheres of compact bodies, as wide as they are, and bounding boxes of the
            others; "sphere" makes spheres of all, as wide as the body's longest side.
    """
    return replace(scene, bodies=tuple(_simple(b, kind) for b in scene.bodies))


def _simple(body: Body, kind: str) -> Body:
    if body.static or not body.shapes or body.roll_radius > 0.0:
        return body
    half, (x, y, bottom) = body.half_extents, body.origin_offset
    shape, size = _primitive(half, kind)
    return replace(body, shapes=(Shape(shape, size, position=(x, y, bottom + size[2])),))


def _primitive(half: Extents, kind: str) -> tuple[Literal["sphere", "box"], Extents]:
    """Kind and size of the proxy of a body with these half extents, any unit."""
    if kind != "sphere" and max(half) > COMPACT * min(half):
        return "box", half
    radius = max(half[0], half[1]) if kind == "box" else max(half)
    return "sphere", (radius, radius, radius)


def simple_document(doc: EsgDocument, kind: str = "box") -> EsgDocument:
    """The document as a system sees it that knows its assets by simple proxies only.

    Choreography and layout read extents and proxies from the asset configurations: those of a
    sphere are as large as the sphere. Assets of static nodes and balls stay as they are.

    Args:
        doc: A document with assets resolved.
        kind: As of `coarse`.
    """
    doc = effective(doc)
    nodes = doc.spatial_relation_graph.nodes.values()
    kept = {n.asset_id for n in nodes if n.is_structural or n.is_static}
    configs = {
        name: config
        if name in kept or not config.is_movable or config.rolls or not config.proxies
        else _simple_asset(config, kind)
        for name, config in doc.asset_configurations.items()
    }
    return doc.model_copy(update={"asset_configurations": configs})


def _simple_asset(config: AssetConfiguration, kind: str) -> AssetConfiguration:
    x, y, z = config.dimensions_cm
    shape, size = _primitive((x / 2, y / 2, z / 2), kind)
    proxy = Proxy(kind=ProxyKind(shape), size_cm=size, position_cm=(0.0, 0.0, size[2]))
    extents = (2 * size[0], 2 * size[1], 2 * size[2])
    return config.model_copy(update={"proxies": (proxy,), "dimensions_cm": extents})
