"""The same scene with other collision shapes: what does an outcome owe to their detail?"""

from __future__ import annotations

from dataclasses import replace
import math

from esg.engines.scene import Body, Shape, SimScene

SIDES = 16
COMPACT = 1.6
"""Bodies whose longest side is at most this often the shortest become spheres."""


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


def coarse(scene: SimScene) -> SimScene:
    """The scene with one sphere or bounding box a body (the paper's simple proxies).

    Compact bodies become spheres as wide as they are, the others their bounding boxes; static
    bodies and balls keep their shapes.
    """
    return replace(scene, bodies=tuple(_simple(b) for b in scene.bodies))


def _simple(body: Body) -> Body:
    if body.static or not body.shapes or body.roll_radius > 0.0:
        return body
    half, (x, y, bottom) = body.half_extents, body.origin_offset
    if max(half) <= COMPACT * min(half):
        radius = max(half[0], half[1])
        place = (x, y, bottom + radius)
        return replace(body, shapes=(Shape("sphere", (radius, radius, radius), position=place),))
    return replace(body, shapes=(Shape("box", half, position=(x, y, bottom + half[2])),))
