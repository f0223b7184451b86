"""Things that roll on their rim: standing up, with one cylinder about a horizontal axis.

A tyre, a coin, a barrel or a log lies or stands as it is drawn. Where a story rolls it, or the size
asked for is that of a thing on its rim, it is turned so that its axis is Y and its front +X is the
way it rolls, and it collides as one analytic cylinder: the parts it is drawn with would bump.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import math
from typing import Any

from esg.assets.geometry.massprops import mass_properties
from esg.assets.geometry.rotations import ALONG, IDENTITY, turn
from esg.assets.geometry.sketch import Sketch
from esg.assets.library.catalogue import Entry
from esg.graph.models import AssetRequirement, EsgDocument, Predicate, Proxy, ProxyKind, Quat, Vec3
from esg.units import quat_multiply

FLAGS = {"rim": 2, "axle": 0, "across": 1}
"""In the catalogue: drawn with its axis upright (rim), lying along X (axle) or along Y (across):
the index of that axis."""
_THIN = 0.8
_ROUND = 1.25
_OFF_CENTRE = 0.02
"""Share of radius and half length by which the centre of mass may lie beside axis and middle."""


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
    """Assets of which some node rolls in the story, by itself or because it is pushed."""
    nodes = doc.spatial_relation_graph.nodes
    told = (s for s in doc.statements or () if s.predicate is Predicate.ROLLS)
    pushed = {nodes[i].asset_id for s in told for i in s.object if i in nodes}
    return _spun(doc, "roll") | pushed


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
    """Extents [cm] of the rolling form of a thing drawn at `size`.

    What is not quite round, as a pencil, becomes as wide as high: its volume stays.
    """
    (flag,) = entry.flags & FLAGS.keys()
    around = math.sqrt(math.prod(size) / size[FLAGS[flag]])
    return (around, size[FLAGS[flag]], around)


def drawn_size(entry: Entry, size: Vec3) -> Vec3:
    """Extents [cm] at which a thing is drawn whose rolling form has these."""
    (flag,) = entry.flags & FLAGS.keys()
    around, long, _ = size
    one, other = (d for k, d in enumerate(entry.dimensions_cm) if k != FLAGS[flag])
    uneven = math.sqrt(one / other)
    across = [around * uneven, around / uneven]
    across.insert(FLAGS[flag], long)
    length, width, height = across
    return (length, width, height)


def rolling(entry: Entry, sketch: Sketch, size: Vec3) -> Sketch:
    """The rolling form of a sketch.

    Args:
        entry: Flagged with one of `FLAGS`.
        sketch: As drawn.
        size: Extents of the sketch [cm].

    Returns:
        A sketch with its axis along Y, one cylinder proxy of the largest radius (what tapers rolls
        on its wider rim, its axis level), and the turned original proxies as what is weighed: a
        hoop keeps the inertia of a ring.
    """
    (flag,) = entry.flags & FLAGS.keys()
    around, long, _ = turned_size(entry, size)
    radius, half = around / 2, long / 2
    quat = {"rim": turn("x", -90.0), "axle": turn("z", 90.0), "across": IDENTITY}[flag]
    middle = size[2] / 2  # of what is drawn

    def at(v: Any) -> Vec3:
        x, y, z = (float(c) for c in v)
        if flag == "rim":  # Rx(-90): z goes to y, y to -z; then the rim is set on the ground
            return (x, z - middle, radius - y)
        return (-y, x, z - middle + radius) if flag == "axle" else (x, y, z - middle + radius)

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
    weighed = [placed(p) for p in sketch.weighed or sketch.proxies]
    densities = list(sketch.densities)
    (x, y, z), _ = mass_properties(weighed, 1.0, densities)
    if math.hypot(x, z - radius) > _OFF_CENTRE * radius or abs(y) > _OFF_CENTRE * half:
        # Drawn with a flat to lie on it would limp; heavier at one end, roll to that side.
        weighed, densities = [cylinder], [1.0]
    return Sketch(
        # The whole of it turns: nothing on it turns by itself any more.
        parts=[replace(p, mesh=moved(p.mesh), axle=None) for p in sketch.parts],
        proxies=[cylinder],
        densities=densities,
        weighed=weighed,
    )


def is_rolling_form(entry: Entry, rolls: bool) -> bool:
    """Whether a configuration of an entry is its rolling form."""
    return rolls and bool(entry.flags & FLAGS.keys())
