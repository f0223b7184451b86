"""Everyday knowledge the choreography draws on: sizes, usual speeds, distances, surfaces, shots."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
import math

import numpy as np

from esg.dynamics.story.kinematics import half_along, impact_speed
from esg.graph.joints import KINDS_OF_JOINT, start_frames
from esg.graph.models import (
    AssetConfiguration,
    EdgeEvent,
    EsgDocument,
    NamedRegion,
    Predicate,
    SupportSurface,
)
from esg.units import GRAVITY_MPS2

GROUND_FRICTION, GROUND_RESTITUTION = 0.7, 0.3
"""Of the ground, where nothing else is known."""
SLICK = 0.35
"""Friction below which the ground counts as ice."""
LONGEST_CLIMBER_M = 1.2
"""What is longer does not get up on a table."""
LIGHTEST_LANDING_KG = 0.04
"""What is lighter comes down too softly for a hit (0.1 N s) at 3 m/s: it has to be thrown hard."""
LONGEST_SLIDE_S = 1.3
"""Longest time of a slide nobody gave a time for."""
TO_EDGE_M = 0.15
"""Way of what is knocked off a table to its edge."""


@dataclass(frozen=True)
class Prop:
    """Planar view of one body: extents [m], mass [kg], contact behaviour and damping [1/s].

    `lift` is how high a joint holds its underside above the ground [m].
    """

    length: float
    width: float
    height: float
    mass: float
    friction: float
    restitution: float
    rolls: bool
    wheeled: bool
    fixed: bool
    grouped: bool = False
    damping: float = 0.0
    config: AssetConfiguration | None = field(default=None, compare=False, repr=False)
    ground: float = GROUND_FRICTION
    lift: float = 0.0

    @property
    def rough(self) -> float:
        """Friction of the ground on the safe side: of what is to slide far enough."""
        return max(self.ground, GROUND_FRICTION) if self.ground > SLICK else self.ground

    @property
    def half_length(self) -> float:
        return 0.5 * self.length

    @property
    def half_width(self) -> float:
        return 0.5 * self.width

    def half_lateral(self, relative: float) -> float:
        """Half extent across a path that meets the body's length at angle `relative`."""
        return half_along(self.length, self.width, relative + math.pi / 2)


def thrown_back(mover: Prop, target: Prop) -> float:
    """Change of speed along the normal of a hit over the speed before it: 1 without rebound."""
    return 1.0 + 0.5 * (mover.restitution + target.restitution)


def prop(doc: EsgDocument, name: str) -> Prop:
    """The planar view of one node's asset."""
    node = doc.spatial_relation_graph.nodes[name]
    config = doc.asset_configurations[node.asset_id]
    length, width, height = (d / 100.0 for d in config.dimensions_cm)
    return Prop(
        length=length,
        width=width,
        height=height,
        mass=config.mass_kg,
        friction=config.friction,
        restitution=config.restitution,
        rolls=config.rolls,
        wheeled=config.is_wheeled,
        fixed=node.is_structural or node.is_static or not config.is_movable,
        damping=config.linear_damping,
        config=config,
        ground=ground_friction(doc),
        lift=_lift(doc, name),
    )


def _lift(doc: EsgDocument, name: str) -> float:
    """How high a hinge or a slider holds the underside of what it moves [m]."""
    joints = doc.spatial_relation_graph.joints or ()
    if not any(j.child == name and j.kind in KINDS_OF_JOINT[EdgeEvent.DRIVE] for j in joints):
        return 0.0
    found = start_frames(doc).get(name)
    return 0.0 if found is None else max(float(found[1].position[2]) / 100.0, 0.0)


def ground_friction(doc: EsgDocument) -> float:
    """Friction of the ground bodies slide and roll on."""
    ground = _ground(doc)
    return GROUND_FRICTION if ground is None else ground.friction


def ground_restitution(doc: EsgDocument) -> float:
    """Restitution of the ground bodies land on."""
    ground = _ground(doc)
    return GROUND_RESTITUTION if ground is None else ground.restitution


def _ground(doc: EsgDocument) -> AssetConfiguration | None:
    nodes = doc.spatial_relation_graph.nodes
    grounds = (doc.asset_configurations[n.asset_id] for n in nodes.values() if n.is_structural)
    return next((c for c in grounds if not c.proxies), None)


def default_speed(body: Prop) -> float:
    """A usual speed [m/s] of such a body: cars about 8, balls a few, small things less."""
    if body.wheeled:
        return 8.0 if body.length > 2.5 else 4.0 if body.length > 1.0 else 2.0
    if body.rolls:
        return 2.0 if body.width < 0.09 else 4.0
    return 1.5 if body.height > 1.0 else 3.0


def approach_distance(body: Prop, speed: float, rng: np.random.Generator) -> float:
    """Free run [m] before a meeting nobody gave a time for."""
    usual = 1.4 * speed if body.wheeled else 1.0 * speed
    low, high = (4.0, 16.0) if body.length > 1.0 else (0.8, 4.0)
    if body.width < 0.09:
        low, high = 0.35, 0.9
    return float(min(max(usual, low), high) * rng.uniform(0.9, 1.1))


def min_hit_speed(mover: Prop, target: Prop) -> float:
    """Speed [m/s] at which a hit passes a clearly measurable impulse (0.5 N s)."""
    mass = mover.mass if target.fixed else mover.mass * target.mass / (mover.mass + target.mass)
    return 0.5 / (mass * thrown_back(mover, target))


def passed_on(mover: Prop, target: Prop) -> float:
    """Speed of a resting body after a central hit, over the mover's."""
    restitution = 0.5 * (mover.restitution + target.restitution)
    return impact_speed(mover.mass, target.mass, 1.0, restitution)


def fall_speed(mover: Prop, target: Prop) -> float:
    """Speed [m/s] of a hit that slides a resting target over the edge it stands beside."""
    if target.rolls or target.fixed:
        return 0.0
    needed = math.sqrt(2.0 * coasting_drag(target) * TO_EDGE_M)
    gain = thrown_back(mover, target) * mover.mass
    return 1.2 * needed * (mover.mass + target.mass) / gain


def coasting_drag(body: Prop) -> float:
    """Deceleration [m/s^2] of a body that coasts: tyres roll on the low-friction vehicle ground."""
    if body.rolls:
        return 0.0
    other = 0.0 if body.wheeled else body.rough
    return 0.5 * (body.friction + other) * GRAVITY_MPS2


def push_speed(mover: Prop, target: Prop) -> float:
    """Speed [m/s] that sends a resting target half a metre on, 15 m/s at most.

    A round target rolls on by itself.
    """
    if target.rolls or target.fixed:
        return 0.0
    needed = math.sqrt(2.0 * coasting_drag(target) * 0.5)
    gain = thrown_back(mover, target) * mover.mass
    return min(needed * (mover.mass + target.mass) / gain, 15.0)


def slide(
    body: Prop, speed: float, duration: float | None, rng: np.random.Generator, *, adjustable: bool
) -> tuple[float, float, float, float]:
    """A push after which friction brakes the body until it meets something.

    Returns:
        Launch speed [m/s], distance [m], duration [s] and speed left at the meeting [m/s].
    """
    deceleration = max(coasting_drag(body), 0.02 * GRAVITY_MPS2)
    if duration is None:
        duration = min(float(rng.uniform(0.35, 0.5)) * speed / deceleration, LONGEST_SLIDE_S)
    elif adjustable:
        speed = max(speed, 1.5 * deceleration * duration)
    left = max(speed - deceleration * duration, 0.3)
    return speed, 0.5 * (speed + left) * duration, duration, left


def release_height(thrown: Prop, target: Prop) -> float:
    """Height [m] of a thrown body's bottom at release: a hand's, or a little above the target."""
    return max(1.0, min(1.6, target.height + 0.3)) - 0.5 * thrown.height


def has_foot(body: Prop) -> bool:
    """Whether a body slopes down towards its front: its top is behind its middle."""
    if body.config is None or not body.config.support_surfaces:
        return False
    top = max(body.config.support_surfaces, key=lambda s: s.center_cm[2])
    return top.center_cm[0] < -20.0 * body.length and top.center_cm[2] > 90.0 * body.height


def target_yaw(
    body: Prop, heading: float, rng: np.random.Generator, mover: Prop | None = None
) -> float:
    """Yaw [rad] at which a waiting body is met: broadside, the larger and steadier mark.

    A ramp is met at its foot. A vehicle waits or parks along the way of other vehicles, not across.
    """
    if body.rolls or body.grouped:
        return heading
    if has_foot(body):
        return heading + math.pi
    side = float(rng.choice([-1.0, 1.0]))
    if mover is not None and mover.wheeled and body.wheeled:
        return heading
    if body.length > 1.15 * body.width:
        return heading + side * math.pi / 2
    return heading + math.pi


def support_of(doc: EsgDocument, name: str) -> str | None:
    """The table or shelf a node stands on; None for the ground and for structural decals."""
    graph = doc.spatial_relation_graph
    region = graph.nodes[name].semantic_region
    if region is None or region not in graph.semantic_regions:
        return None
    parent = graph.semantic_regions[region].parent_object
    if parent not in graph.nodes:
        return None
    config = doc.asset_configurations.get(graph.nodes[parent].asset_id)
    return None if config is None or not config.proxies else parent


def stacked_with(doc: EsgDocument, name: str) -> list[str]:
    """The members of the stack that a node belongs to; none if it lies in no stack."""
    nodes = doc.spatial_relation_graph.nodes
    group = nodes[name].group
    if group is None or nodes[name].group_pattern != "stack":
        return []
    return [n for n, v in nodes.items() if v.group == group]


def top_surface(doc: EsgDocument, name: str) -> SupportSurface:
    """The highest surface things stand on; of a body that names none, the middle of its top."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    if config.support_surfaces:
        return max(config.support_surfaces, key=lambda s: s.center_cm[2])
    length, width, height = config.dimensions_cm
    return SupportSurface(
        name="top", center_cm=(0.0, 0.0, height), half_extents_cm=(0.35 * length, 0.35 * width)
    )


def climb_height(doc: EsgDocument, body: Prop, support: str) -> float | None:
    """Height [m] of a table or shelf too high to be reached from below, on which a body has room.

    None where it is within reach, or no place for such a body: a head, a post.
    """
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[support].asset_id]
    if not config.support_surfaces or body.length > LONGEST_CLIMBER_M:
        return None
    surface = top_surface(doc, support)
    height = surface.center_cm[2] / 100.0
    room = max(surface.half_extents_cm[:2]) / 50.0
    return height if height > body.height and body.length < 0.7 * room else None


def lies_on(doc: EsgDocument, thing: str, host: str) -> bool:
    """Whether a thing that comes down on a host is said to stay there, and can be felt to land."""
    nodes = doc.spatial_relation_graph.nodes
    if host not in nodes or nodes[host].is_structural:
        return False
    if doc.asset_configurations[nodes[thing].asset_id].mass_kg < LIGHTEST_LANDING_KG:
        return False
    return any(
        s.predicate is Predicate.ENDS_ON and thing in s.object and host in s.target
        for s in doc.statements or ()
    )


ON_TABLE, TABLE_S = 2.5, 0.1
"""Damping [1/s] of what rolls along a table and stays there, as on a cloth, and from when [s]."""


def stays_on(doc: EsgDocument, thing: str) -> str | None:
    """The table or shelf that a thing moves on and does not leave, None if nobody says so."""
    host = support_of(doc, thing)
    said = (s for s in doc.statements or () if s.predicate is Predicate.SUPPORTED_BY)
    to_the_end = (s for s in said if s.when in ("throughout", "end"))
    stays = any(thing in s.object and host in s.target for s in to_the_end)
    return host if stays else None


def broadest_surface(doc: EsgDocument, name: str) -> SupportSurface:
    """The largest surface of a table or shelf."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    surfaces = config.support_surfaces or (top_surface(doc, name),)
    return max(surfaces, key=lambda s: s.half_extents_cm[0] * s.half_extents_cm[1])


def fit_to_surface(
    doc: EsgDocument,
    anchor: str,
    places: dict[str, tuple[float, float, float | None]],
    reached: Sequence[tuple[str, float, float, float]] = (),
    lane: tuple[int, int] = (0, 1),
) -> bool:
    """Centres a choreography on its support's surface, along its longer side; False if too large.

    Args:
        doc: The document.
        anchor: Supporting node.
        places: Positions [m] and yaws [rad] by key, changed in place on success.
        reached: Where those get that stay on it: key, x, y [m], heading [rad].
        lane: Which lane it takes, of how many along the longer side.
    """
    surface = broadest_surface(doc, anchor)
    half = np.array(surface.half_extents_cm) / 100.0
    center = np.array(surface.center_cm[:2]) / 100.0
    turn = half[1] > half[0]
    room = half[::-1].copy() if turn else half.copy()
    room[1] /= lane[1]
    points: list[tuple[float, float]] = []
    for key, x, y, yaw in [*((k, *at[:2], at[2] or 0.0) for k, at in places.items()), *reached]:
        body = prop(doc, _one_of(doc, key))
        along, across = half_along(body.length, body.width, yaw), body.half_lateral(yaw)
        points += [(x - along, y - across), (x + along, y + across)]
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    if np.any(high - low > 2.0 * room - 0.04):
        return False
    shift = -0.5 * (low + high)
    shift[1] += (2 * lane[0] + 1 - lane[1]) * room[1]
    for key, (x, y, yaw) in places.items():
        x, y = x + shift[0], y + shift[1]
        if turn:
            x, y, yaw = -y, x, None if yaw is None else yaw + math.pi / 2
        places[key] = (float(center[0] + x), float(center[1] + y), yaw)
    return True


def _one_of(doc: EsgDocument, key: str) -> str:
    """A node of what is placed under a key ("group:name" for a pattern)."""
    nodes = doc.spatial_relation_graph.nodes
    name = key[6:] if key.startswith("group:") else key
    return name if name in nodes else next(n for n, v in nodes.items() if v.group == name)


OFF_TABLE = 0.1
"""Cost from which a shot does not fit on its table (a centimetre outside)."""


def pocket_shot(
    doc: EsgDocument,
    anchor: str,
    region: str,
    chain: list[str],
    rng: np.random.Generator,
    runs: dict[str, tuple[float, float] | None],
) -> dict[str, tuple[float, float, float]]:
    """Start positions of a shot that ends in a pocket, planned backwards from it.

    The last ball lies on a clear line to the pocket; each ball before it lies behind the ghost
    position that sends the next one along its line, at a small cut angle.

    Args:
        doc: The document.
        anchor: The table.
        region: "table/pocket name".
        chain: Bodies from the one that enters back to the active one.
        rng: Source of variety.
        runs: Least and greatest distance [m] that a ball rolls until it hits the next, where the
            prompt's times and speeds fix it.

    Returns:
        (x, y, yaw) in the table's frame [m, rad]; yaw is the direction of travel.
    """
    nodes = doc.spatial_relation_graph.nodes
    config = doc.asset_configurations[nodes[anchor].asset_id]
    surface = broadest_surface(doc, anchor)
    center = np.array(surface.center_cm[:2]) / 100.0
    half = np.array(surface.half_extents_cm) / 100.0
    pocket = _region(config.regions, region)
    goal = np.array(pocket.center_cm[:2]) / 100.0
    radius = [0.5 * prop(doc, n).width for n in chain]
    best: dict[str, tuple[float, float, float]] = {}
    best_cost = math.inf
    # A long run may need the table's diagonal, which few draws find.
    wide, draws, enough = (0.9, 4000, 0.06) if any(runs.values()) else (0.5, 400, 0.02)
    for _ in range(draws):
        aim, spots, cost = goal, {}, 0.0
        inward = math.atan2(*(center - goal)[::-1])
        direction = inward + float(rng.uniform(-wide, wide))
        for k, name in enumerate(chain):
            near = 0.35 if k == 0 else 0.3
            run = float(rng.uniform(near, near + 0.35)) * min(1.0, float(half.max()) / 0.9)
            wanted = runs.get(name)
            if wanted is not None:
                run = float(rng.uniform(*wanted))
            spot = aim + run * np.array([math.cos(direction), math.sin(direction)])
            room = half - 1.6 * radius[k] - 0.03
            outside = np.maximum(np.abs(spot - center) - room, 0.0).sum()
            cost += 10.0 * float(outside) + 0.02 * abs(direction - inward)
            spots[name] = (float(spot[0]), float(spot[1]), direction + math.pi)
            if k + 1 < len(chain):
                unit = np.array([math.cos(direction), math.sin(direction)])
                aim = spot + (radius[k] + radius[k + 1]) * unit
                direction += float(rng.uniform(-0.3, 0.3))
        if cost < best_cost:
            best, best_cost = spots, cost
        if cost < enough:
            break
    if best_cost > OFF_TABLE and any(runs.values()):
        return pocket_shot(doc, anchor, region, chain, rng, {})
    return best


def _region(regions: tuple[NamedRegion, ...], name: str) -> NamedRegion:
    wanted = name.split("/", 1)[-1]
    for region in regions:
        if region.name == wanted:
            return region
    words = set(wanted.lower().split())
    ranked = sorted(regions, key=lambda r: -len(words & set(r.name.lower().split())))
    return ranked[0]
