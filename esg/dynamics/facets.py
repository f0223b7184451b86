"""The same scene with other collision shapes: how much does an outcome depend on round sides?"""

from __future__ import annotations

from dataclasses import replace
import math

from esg.engines.scene import Shape, SimScene

SIDES = 16


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
