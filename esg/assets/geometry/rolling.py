"""Things that roll on their rim: standing up, with one cylinder about a horizontal axis.

A tyre, a coin, a barrel or a log lies or stands as it is drawn. Where a story rolls it, or the size
asked for is that of a thing on its rim, it is turned so that its axis is Y and its front +X is the
way it rolls, and it collides as one analytic cylinder: the parts it is drawn with would bump.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from esg.assets.geometry.rotations import ALONG, turn
from esg.assets.geometry.sketch import Sketch
from esg.assets.library.catalogue import Entry
from esg.graph.models import AssetRequirement, EsgDocument, Proxy, ProxyKind, Quat, Vec3
from esg.units import quat_multiply

FLAGS = frozenset({"rim", "axle"})
"""In the catalogue: drawn with its axis upright (rim), or lying along X (axle)."""
_THIN = 0.8
_ROUND = 1.25


def _spun(doc: EsgDocument, spin: str) -> frozenset[str]:
    if doc.timeline_system is None:
        return frozenset()
    nodes = doc.spatial_relation_graph.nodes
    return frozenset(
        nodes[edge.actor].asset_id
        for edge in doc.timeline_system.sequence_graph.edges
        if edge.params.spin == spin and edge.actor in nodes
    )


def rolled_assets(doc: EsgDocument) -> frozenset[str]:
    """Assets of which some node rolls in the story."""
    return _spun(doc, "roll")


def lying_assets(doc: EsgDocument) -> frozenset[str]:
    """Assets that are stacked, dropped or thrown: those keep lying."""
    nodes = doc.spatial_relation_graph.nodes.values()
    stacked = frozenset(n.asset_id for n in nodes if n.group_pattern == "stack")
    return (stacked | _spun(doc, "none")) - rolled_assets(doc)


def on_its_rim(requirement: AssetRequirement) -> bool:
    """Whether the size asked for is that of a round thing standing on its rim."""
    length, width, height = requirement.expected_dimensions_cm
    return (
        width < _THIN * min(length, height)
        and max(length, height) <= _ROUND * min(length, height)
    )  # fmt: skip


def as_drawn(entry: Entry, requirement: AssetRequirement) -> AssetRequirement:
    """The requirement for the entry as it is drawn: a wheel of 65 x 22 x 65 cm lying."""
    if "rim" not in entry.flags or not on_its_rim(requirement):
        return requirement
    length, width, height = requirement.expected_dimensions_cm
    size = (max(length, height), max(length, height), width)
    return requirement.model_copy(update={"expected_dimensions_cm": size})


def turned_size(entry: Entry, size: Vec3) -> Vec3:
    """Extents [cm] of the rolling form of a thing drawn at `size`, and back."""
    if "rim" in entry.flags:
        return (size[0], size[2], size[1])
    return (size[1], size[0], size[2])


def rolling(entry: Entry, sketch: Sketch, size: Vec3) -> Sketch:
    """The rolling form of a sketch.

    Args:
        entry: Flagged `rim` or `axle`.
        sketch: As drawn.
        size: Extents of the sketch [cm].

    Returns:
        A sketch with its axis along Y, one cylinder proxy, and the turned original proxies as what
        is weighed: a hoop keeps the inertia of a ring.
    """
    upright = "rim" in entry.flags
    quat = turn("x", -90.0) if upright else turn("z", 90.0)
    radius = max(size[0], size[1]) / 2 if upright else max(size[1], size[2]) / 2
    half = (size[2] if upright else size[0]) / 2

    def at(v: Any) -> Vec3:
        x, y, z = (float(c) for c in v)
        if upright:  # Rx(-90): z goes to y, y to -z; then the rim is set on the ground
            return (x, z - half, radius - y)
        return (-y, x, z)

    def moved(make: Callable[[], Any]) -> Callable[[], Any]:
        def mesh() -> Any:
            out = make()
            out.vertices = [at(v) for v in out.vertices]
            return out

        return mesh

    def placed(p: Proxy) -> Proxy:
        x, y, z, w = (float(c) for c in quat_multiply(quat, p.orientation_xyzw))
        orientation: Quat = (x, y, z, w)
        return p.model_copy(
            update={"position_cm": at(p.position_cm), "orientation_xyzw": orientation}
        )

    cylinder = Proxy(
        kind=ProxyKind.CYLINDER,
        size_cm=(radius, radius, half),
        position_cm=(0.0, 0.0, radius),
        orientation_xyzw=ALONG["y"],
    )
    return Sketch(
        parts=[replace(p, mesh=moved(p.mesh)) for p in sketch.parts],
        proxies=[cylinder],
        densities=list(sketch.densities),
        weighed=[placed(p) for p in sketch.weighed or sketch.proxies],
    )


def is_rolling_form(entry: Entry, rolls: bool) -> bool:
    """Whether a configuration of an entry is its rolling form."""
    return rolls and bool(entry.flags & FLAGS)
