"""When a recording ends: when all has come to rest, played once with the theta that was found.

A search stops to look when the last event has been told (`losses.horizon`). A viewer does not: a
film that is cut while a pin still falls or a ball still rolls looks broken.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.plan import Plan
from esg.dynamics.search.simulate import Simulator
from esg.engines.program import AdjustProperties, Moving
from esg.engines.scene import Rollout
from esg.graph.models import NodeEvent
from esg.metrics.plausibility.grounds import ROADS, beyond, flats
from esg.metrics.plausibility.limits import motion_of
from esg.thresholds import AT_REST_MPS

LONGEST_S = 6.0
"""Nothing is recorded for longer after the last event: what rolls on does so for half a minute."""
STILL_S = 0.3
"""How long the rest is shown; another engine may come to it so much later."""
PASSED_S = 0.4
"""How long one still sees who has left something behind him."""

Floats = NDArray[np.float64]


def until_rest(plan: Plan, reference: Simulator, theta: Floats, last: float, least: float) -> float:
    """How long a scene is worth recording [s], on tenths.

    Args:
        plan: With the program that theta makes.
        reference: Plays it on.
        theta: Shape [n].
        last: Time of the last event [s].
        least: A recording is no shorter [s].

    Returns:
        When every body is slower than `AT_REST_MPS` and stays so, between `least` and `LONGEST_S`
        after the last event. What drives or flies on has no end and is not waited for; nor is what
        rolls off the ground that is drawn, or to the end of the road that it set out on: the
        recording ends before it does.
    """
    longest = last + LONGEST_S
    if longest <= least:
        return least
    rollout = reference.play_on(theta, longest)
    if not rollout.valid[0]:
        return least
    leaves = math.floor(10.0 * (_leaves(plan, rollout) - STILL_S)) / 10.0
    least = max(least, min(_passed(plan, rollout), leaves))
    waits = [
        i
        for i, body in enumerate(plan.scene.bodies)
        if not body.static and body.collides and not _goes_on(plan, theta, rollout, i)
    ]
    if not waits:
        return least
    speed = np.linalg.norm(rollout.linear_velocity[0][:, waits].astype(float), axis=-1)
    moving = np.flatnonzero((speed >= AT_REST_MPS).any(axis=1))
    rest = float(rollout.time[moving[-1]]) if len(moving) else 0.0
    end = math.ceil(10.0 * min(rest + STILL_S, longest)) / 10.0
    return max(least, min(end, leaves))


def _passed(plan: Plan, rollout: Rollout) -> float:
    """When all who overtake or pass something have left it behind them [s], 0 if nobody does.

    Their event is over as soon as one is ahead of the other, which is no sight of it.
    """
    scene, out = plan.scene, 0.0
    for node in plan.story.nodes.values():
        pair = [scene.index(n) for n in node.participants if n in scene.names]
        if node.event is not NodeEvent.MISS or len(pair) != 2:
            continue
        a, b = pair
        apart = (rollout.position[0, :, a] - rollout.position[0, :, b])[:, :2].astype(float)
        pace = rollout.linear_velocity[0, :, a, :2].astype(float)
        ahead = (apart * pace).sum(axis=1) / np.maximum(np.linalg.norm(pace, axis=1), 1e-6)
        size = sum(max(scene.bodies[i].half_extents[:2]) for i in pair)
        by = np.flatnonzero((ahead[1:] >= size) & (ahead[:-1] < size))
        if len(by):
            out = max(out, math.ceil(10.0 * (float(rollout.time[by[0] + 1]) + PASSED_S)) / 10.0)
    return out


def _leaves(plan: Plan, rollout: Rollout) -> float:
    """When the first body leaves the drawn ground, or its road [s], a million if none does."""
    scene = plan.scene
    drawn = flats(scene)
    roads = [k for k in drawn if scene.bodies[k].category in ROADS]
    out: list[NDArray[np.bool_]] = []
    for i, body in enumerate(scene.bodies):
        if body.static or not body.collides:
            continue
        way = rollout.position[0, :, i].astype(float)
        out.append(beyond(scene, way, drawn) > 0.0)
        if roads and motion_of(body.label, body.category).moves == "road":
            off = beyond(scene, way, roads) > 0.0
            out.append(off & (not off[0]))
    frames = np.flatnonzero(np.any(out, axis=0))
    return float(rollout.time[frames[0]]) if len(frames) else 1e6


def _goes_on(plan: Plan, theta: Floats, rollout: Rollout, body: int) -> bool:
    """Whether a body moves by itself to the end: nothing has met it, and nobody brakes it."""
    name = plan.scene.bodies[body].name
    own = [p for p in plan.compile(theta).primitives if p.body == name]
    drives = [p for p in own if isinstance(p, Moving)]
    if not drives:
        return False
    begun = drives[-1].start
    if any(isinstance(p, AdjustProperties) and p.time >= begun for p in own):
        return False
    c = rollout.contacts
    mine = ((c.a == body) | (c.b == body)) & (c.a >= 0) & (c.b >= 0) & (c.impulse > 0)
    return not bool((mine & (c.time >= begun)).any())
