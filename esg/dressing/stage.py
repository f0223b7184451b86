"""Stage dress: the place around a finished scene, from its document and its replay."""

from __future__ import annotations

import math

import numpy as np

from esg.dressing.arrange import Ban, Site, arrange, room_of
from esg.dressing.choice import STREETLIKE, Choice, choose
from esg.dressing.clearance import Box, Clearance, Frame, clearance
from esg.engines.scene import Body, Rollout, SimScene
from esg.graph.canonical import entropy
from esg.graph.casting import effective
from esg.graph.models import Dressing, EsgDocument, Predicate, Provenance
from esg.units import quat_rotate

VERSION = "1"
APART_M, APART_FIXED_M = 12.0, 4.0
"""So far from a body that may move, or is fixed, nothing stands that could be taken for it."""
MOST_CORE_M = 60.0
"""The action's rectangle outdoors is no longer; walls and streets are."""
SHOULDER_RAD = math.radians(42)
"""The sun stands so far to the right of one who looks at the action (esg.view.render)."""
SUNS = 9


def dress(doc: EsgDocument, scene: SimScene, rollout: Rollout, *, seed: int = 0) -> EsgDocument:
    """Fills `dressing`; no other field but the provenance changes.

    Args:
        doc: A document with its layout, and with its dynamics if it has any.
        scene: Its bodies.
        rollout: Its replay, by which nothing is in anybody's way.
        seed: Of every choice.

    Returns:
        The document; one that allows no further objects stays as it is.
    """
    if not doc.scene_definition.scene_parameters.allow_supplementary:
        return doc
    entry = Provenance(stage="dress", version=VERSION, seed=seed)
    made = dressing_of(effective(doc), scene, rollout, seed=seed)
    kept = tuple(p for p in doc.provenance if p.stage != "dress")
    return doc.model_copy(update={"dressing": made, "provenance": (*kept, entry)})


def dressing_of(doc: EsgDocument, scene: SimScene, rollout: Rollout, *, seed: int) -> Dressing:
    """The place around a scene.

    Args:
        doc: With its casting applied.
        scene, rollout, seed: As of `dress`.
    """
    rng = np.random.default_rng([seed, entropy(doc), 24])
    extent = max(clearance(scene, rollout, Frame(0.0), indoor=True).reach.size)
    choice = choose(doc, scene, extent, rng)
    axis = _axis(scene, choice.place.axis)
    frame = Frame(0.0 if axis is None else _heading(axis, scene, rollout))
    indoor = choice.place.setting == "indoor"
    clear = clearance(scene, rollout, frame, indoor=indoor)
    toward = _viewer(scene, rollout, axis, frame)
    viewer = frame.into(np.array(toward))
    at = (float(viewer[0]), float(viewer[1]))
    if indoor:
        rect, height = room_of(choice.place, _with_axis(clear, scene, axis, frame), at)
    else:
        rect, height = _rectangle(choice, clear, scene, axis, frame), 0.0
    own = None if axis is None else _own_box(axis, frame)
    site = Site(choice.place, clear, rect, height, at, own, _ban(doc, scene), rng)
    markings, items = arrange(site)
    azimuth, elevation = _sun(choice, site, toward)
    return Dressing(
        place=choice.place.name,
        reasons=choice.reasons,
        sky=choice.sky.name,
        sun_azimuth_deg=azimuth,
        sun_elevation_deg=elevation,
        ground=choice.ground,
        markings=markings,
        items=items,
    )


def _axis(scene: SimScene, category: str) -> Body | None:
    """The thing along which a place is laid out: the longest of its category."""
    found = [b for b in scene.bodies if category and b.category == category]
    if category == "road":
        found = [b for b in found if b.half_extents[0] >= STREETLIKE * b.half_extents[1]]
    return max(found, key=lambda b: (b.half_extents[0], b.name)) if found else None


def _heading(body: Body, scene: SimScene, rollout: Rollout) -> float:
    """Yaw of a body's front axis at the start [rad]."""
    index = [b.name for b in scene.bodies].index(body.name)
    q = np.asarray(rollout.quaternion[0, 0, index], float)
    front = quat_rotate(q, np.array([1.0, 0.0, 0.0]))
    return math.atan2(float(front[1]), float(front[0]))


def _spot(body: Body, frame: Frame) -> tuple[float, float]:
    x, y = (float(v) for v in frame.into(np.array(body.position)))
    return x, y


def _own_box(body: Body, frame: Frame) -> Box:
    """Of the thing along which the frame lies."""
    a, b = body.half_extents[:2]
    return Box.around(_spot(body, frame), (2 * a, 2 * b))


def _with_axis(clear: Clearance, scene: SimScene, axis: Body | None, frame: Frame) -> Clearance:
    """What a room goes around: also the lane on which nothing may have come to its end."""
    if axis is None or axis.collides:
        return clear
    own = _own_box(axis, frame)
    return Clearance(
        frame,
        np.concatenate([clear.swept, [own.row()]]),
        np.append(clear.of_body, len(scene.bodies)),
        clear.decals,
        clear.core,
        clear.top,
    )


def _rectangle(
    choice: Choice, clear: Clearance, scene: SimScene, axis: Body | None, frame: Frame
) -> Box:
    """What things stand around outdoors: the street, or where the action is most of the time."""
    if axis is not None and axis.category in choice.place.needs:
        return _own_box(axis, frame)
    box = clear.core.at_least(choice.place.least_m)
    if axis is not None and not axis.collides:
        box = box.union(_own_box(axis, frame))
    a, b = (min(side, MOST_CORE_M) for side in box.size)
    return Box.around(box.middle, (a, b))


def _viewer(
    scene: SimScene, rollout: Rollout, axis: Body | None, frame: Frame
) -> tuple[float, float]:
    """Unit vector from the action to the viewer: beside the motion, on the +Y side."""
    best, way = (0.0, 0.0), 0.05
    for index, body in enumerate(scene.bodies):
        p = np.asarray(rollout.position[0, :, index, :2], float)
        p = p[np.isfinite(p).all(axis=1)]
        if body.static or len(p) < 2:
            continue
        span = p[-1] - p[0]
        if float(np.linalg.norm(span)) > way:
            way = float(np.linalg.norm(span))
            best = (float(span[0]), float(span[1]))
    if best == (0.0, 0.0):
        return (0.0, 1.0)
    x, y = -best[1] / way, best[0] / way
    return (x, y) if y >= 0 else (-x, -y)


def _ban(doc: EsgDocument, scene: SimScene) -> Ban:
    """What would be taken for a thing that the prompt tells of, or counts, or denies."""
    near: dict[str, float] = {}
    for body in scene.bodies:
        node = doc.spatial_relation_graph.nodes.get(body.name)
        if node is None or not body.collides:
            continue
        config = doc.asset_configurations.get(node.asset_id)
        names = {body.category} | ({config.asset_name} if config is not None else set())
        apart = APART_FIXED_M if body.static else APART_M
        for name in names:
            near[name] = max(apart, near.get(name, 0.0))
    counted = {
        s.noun.replace(" ", "_").rstrip("s")
        for s in doc.statements or ()
        if s.noun and s.predicate in (Predicate.ABSENT, Predicate.COUNT)
    }
    return Ban(frozenset(counted), near)


def _sun(choice: Choice, site: Site, viewer: tuple[float, float]) -> tuple[float, float]:
    """Azimuth and elevation [deg] of a sun that leaves the action in its light.

    Of some directions about the viewer's right shoulder the one with the fewest things between
    the sun and the action.
    """
    low, high = choice.sky.elevation_deg
    elevation = float(site.rng.uniform(low, high))
    behind = math.atan2(viewer[1], viewer[0]) - SHOULDER_RAD
    jitter = float(site.rng.uniform(-0.25, 0.25))
    reach = site.clear.core.grown(1.0)
    corners = [(x, y) for x in (reach.x0, reach.x1) for y in (reach.y0, reach.y1)]
    points = [*corners, reach.middle]
    blocks = [
        (np.array(site.clear.frame.into(np.array(item.position_cm[:2]) / 100.0)), item)
        for item in site.items
        if item.size_cm[2] > 200.0
    ]

    def shade(azimuth: float) -> float:
        turned = azimuth - site.clear.frame.yaw
        toward = np.array([math.cos(turned), math.sin(turned)])
        hidden = 0.0
        for middle, item in blocks:
            radius = 0.5 * math.hypot(item.size_cm[0], item.size_cm[1]) / 100.0
            long = item.size_cm[2] / 100.0 / math.tan(math.radians(elevation))
            for point in points:
                off = middle - np.array(point)
                ahead = float(off @ toward)
                aside = abs(float(off[0] * toward[1] - off[1] * toward[0]))
                hidden += 1.0 if 0 < ahead < long + radius and aside < radius else 0.0
        return hidden

    turns = sorted(
        (k * math.pi / 7 * sign for k in range(SUNS // 2 + 1) for sign in (1, -1)), key=abs
    )
    best = min(
        dict.fromkeys(turns), key=lambda t: (shade(behind + jitter + t) + 1.5 * abs(t), abs(t))
    )
    azimuth = math.degrees(behind + jitter + best)
    return round((azimuth + 180.0) % 360.0 - 180.0, 2), round(elevation, 2)
