"""Where to aim: the solid part of a target within reach, and ghost positions for chains."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.story.story import Phase, Story
from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import NodeEvent
from esg.units import quat_rotate

Floats = NDArray[np.float64]

AIM_CLEAR_M = 0.05
"""What is thrown passes what stands beside the point it is aimed at by as much."""


def shape_bounds(body: Body, shape: Shape) -> tuple[Floats, Floats]:
    """World axis-aligned bounds of one shape [m], each of shape [3]."""
    if shape.kind == "convex" and shape.vertices:
        local = np.array(shape.vertices)
    else:
        half = np.array(shape.size, float)
        if shape.kind == "capsule":
            half[2] += half[0]
        signs = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)], float)
        local = signs * half
    points = quat_rotate(np.array(shape.quaternion), local) + np.array(shape.position)
    world = quat_rotate(np.array(body.quaternion), points) + np.array(body.position)
    return world.min(axis=0), world.max(axis=0)


def body_bounds(body: Body) -> tuple[Floats, Floats]:
    """World axis-aligned bounds of a body [m]."""
    boxes = [shape_bounds(body, s) for s in body.shapes]
    if not boxes:
        p = np.array(body.position)
        return p, p
    return np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)


def aim_point(mover: Body, target: Body) -> Floats:
    """A point on the target that the mover can meet: its broadest solid part at the mover's height.

    Args:
        mover: The body that moves.
        target: The body it shall meet.

    Returns:
        World point [m], shape [3].
    """
    low, high = body_bounds(mover)
    grounded = low[2] < 0.5
    position = np.array(mover.position)
    best, best_score = np.array(target.position), -math.inf
    toward = np.array(target.position)[:2] - position[:2]
    toward = toward / max(float(np.linalg.norm(toward)), 1e-9)
    side = np.array([-toward[1], toward[0]])
    for shape in target.shapes:
        a, b = shape_bounds(target, shape)
        center = 0.5 * (a + b)
        overlap = min(b[2], high[2]) - max(a[2], low[2])
        if grounded and mover.roll_radius and overlap < 0.35 * (high[2] - low[2]):
            continue
        if grounded and overlap <= 0.01:
            continue
        lateral = float(np.abs(side) @ (b - a)[:2])
        off_axis = abs(float(side @ (center[:2] - np.array(target.position)[:2])))
        score = lateral * (1.0 if grounded else (b - a)[2]) - 0.1 * off_axis
        if not grounded:
            score = float(np.prod(b - a) ** (1 / 3)) + 0.2 * lateral
        if score > best_score:
            best, best_score = center, score
    return best


def region_center(scene: SimScene, name: str) -> Floats | None:
    """World centre of a named region [m], or None."""
    for region in scene.regions:
        if region.name == name:
            parent = scene.body(region.parent)
            offset = quat_rotate(np.array(parent.quaternion), np.array(region.center))
            return np.array(parent.position) + offset
    return None


def rim_point(scene: SimScene, mover: Body, target: str) -> Floats | None:
    """The near side [m] of a hoop's rim: what is thrown at a hoop is not thrown at its post.

    Args:
        scene: The scene.
        mover: What is thrown.
        target: What it is thrown at.
    """
    region = next((r for r in scene.regions if r.name == f"{target}/hoop"), None)
    center = None if region is None else region_center(scene, region.name)
    if region is None or center is None:
        return None
    toward = np.array(mover.position)[:2] - center[:2]
    toward *= region.half_extents[0] / max(float(np.linalg.norm(toward)), 1e-9)
    return center + np.array([*toward, region.half_extents[2]])


def aim_heading(scene: SimScene, story: Story, mover: Body, phase: Phase, target: str) -> float:
    """Heading [rad] that starts the chain of events behind this phase.

    A round mover aims at the ghost position that sends a round target on towards the next one;
    anything else straight at the target.
    """
    position = np.array(mover.position)[:2]
    body = scene.body(target)
    goal = aim_point(mover, body)[:2]
    if phase.end.region:
        center = region_center(scene, phase.end.region)
        goal = goal if center is None else center[:2]
    if phase.end.event is NodeEvent.MISS:
        low, high = body_bounds(body)
        toward = np.array(body.position)[:2] - position
        clear = 0.5 * float(np.linalg.norm((high - low)[:2])) + float(mover.half_extents[1]) + 0.2
        return math.atan2(toward[1], toward[0]) + math.atan2(clear, float(np.linalg.norm(toward)))
    beyond = next_goal(scene, story, phase.end.id, target)
    if beyond is not None and not body.static:
        onward = beyond[:2] - np.array(body.position)[:2]
        distance = float(np.linalg.norm(onward))
        if distance > 1e-6:
            unit = onward / distance
            if mover.roll_radius and body.roll_radius:
                goal = np.array(body.position)[:2] - (mover.roll_radius + body.roll_radius) * unit
    elif phase.end.event is NodeEvent.COLLISION and story.flies(mover.name):
        goal = goal + _past_what_stands_on(scene, story, mover, body, goal)
    return math.atan2(goal[1] - position[1], goal[0] - position[0])


def _past_what_stands_on(
    scene: SimScene, story: Story, mover: Body, target: Body, goal: Floats
) -> Floats:
    """How far beside a point on a target to aim so that nothing that stands on it is in the way.

    Args:
        scene: All bodies.
        story: What it speaks of is never avoided.
        mover: Thrown at the target.
        target: It may carry other bodies.
        goal: World point [m], shape [2].

    Returns:
        The shortest way across the throw [m], shape [2]; none if the target is too crowded.
    """
    named = {name for node in story.nodes.values() for p in node.participants
             for name in story.expand(p)}  # fmt: skip
    low, high = body_bounds(target)
    toward = goal - np.array(mover.position)[:2]
    toward = toward / max(float(np.linalg.norm(toward)), 1e-9)
    side = np.array([-toward[1], toward[0]])
    reach = float(max(mover.half_extents)) + AIM_CLEAR_M
    taken: list[tuple[float, float]] = []
    for body in scene.bodies:
        if body.name in named or body.name in (mover.name, target.name) or not body.collides:
            continue
        foot, _ = body_bounds(body)
        middle = np.array(body.position)[:2]
        on_it = (low[:2] <= middle).all() and (middle <= high[:2]).all()
        if on_it and foot[2] > 0.5 * (low[2] + high[2]):
            at = float(side @ (middle - goal))
            wide = float(np.hypot(*body.half_extents[:2])) + reach
            taken.append((at - wide, at + wide))
    if not taken or not side.any():
        # Room for it, or straight above: there is no across.
        return np.zeros(2)
    room = max(0.0, _to_the_edge(target, goal, side) - reach)
    tries = sorted([0.0, *(end for pair in taken for end in pair)], key=lambda d: (abs(d), d))
    free = [d for d in tries if abs(d) <= room and not any(a < d < b for a, b in taken)]
    return (free[0] if free else 0.0) * side


def _to_the_edge(body: Body, point: Floats, along: Floats) -> float:
    """Way [m] from a point over a body to the nearer edge of its box, along a line both ways.

    Args:
        body: It stands upright.
        point: World point [m], shape [2].
        along: Unit vector in the plane, shape [2].
    """
    turn = np.array(body.quaternion) * (-1.0, -1.0, -1.0, 1.0)
    to_body = np.array([*point, body.position[2]]) - np.array(body.position)
    at = (quat_rotate(turn, to_body) - np.array(body.origin_offset))[:2]
    way = quat_rotate(turn, np.array([*along, 0.0]))[:2]
    ends = [
        (half - abs(p)) / abs(w)
        for half, p, w in zip(body.half_extents, at, way, strict=False)
        if abs(w) > 1e-6
    ]
    return float(min(ends))


def next_goal(scene: SimScene, story: Story, node_id: str, body: str) -> Floats | None:
    """Where `body` has to go after event `node_id`, or None if nothing more is said of it."""
    for node in story.nodes.values():
        if node_id not in story.ancestors(node.id) or body not in node.participants:
            continue
        if node.event is NodeEvent.ENTER_REGION and node.region:
            return region_center(scene, node.region)
        if node.event in (NodeEvent.COLLISION, NodeEvent.REACH):
            others = [p for p in node.participants if p != body]
            if others and others[0] in scene.names:
                return np.array(scene.body(others[0]).position)
    return None
