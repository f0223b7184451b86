"""A rolling ball that hits a ball and then goes on to something else (a cannon, a carom)."""

from __future__ import annotations

import math

import numpy as np

from esg.dynamics.choreography.placing import goes_on
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Frame, Track, back_spin
from esg.graph.models import EdgeEvent, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

CUT_RAD = math.radians(38.0)
"""Angle between a cannon's way and the line of centres: about half of the ball is met."""
ROLLS_ON = 2.0 / 7.0
"""Share of its old velocity that a rolling ball regains from its spin after a hit."""


def is_carom(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether ball a, on its way by itself, goes on to something else after its hit of ball b."""
    if node.event is not NodeEvent.COLLISION or a not in stage.tracks or b in stage.tracks:
        return False
    if stage.story.flies(a) or not (stage.prop(a).rolls and stage.prop(b).rolls):
        return False
    phases = stage.story.phases[a]
    after = [p for p in phases if p.start.id == node.id]
    if stage.prop(b).fixed or not after or after[0].edge.event is not EdgeEvent.TOWARD:
        return False
    end = after[0].end
    others = [stage.key(p) for p in end.participants if p != a]
    others += [end.region.split("/")[0]] if end.region else []
    return bool(others) and others[0] not in stage.places and others[0] != b


def carom(stage: Stage, node: TimelineNode, a: str, b: str) -> None:
    """Has a meet b off its middle, so that both ways are free, and turns a's way accordingly.

    Along the line of centres they exchange momentum, across it a keeps its speed. Its spin then
    drags it back towards its old direction while it slides (5/7 of the new velocity, 2/7 of the
    old one remain).

    Args:
        stage: The stage, with a at b's surface.
        node: Their hit.
        a: The ball that goes on.
        b: The ball that waits.
    """
    track, frame = stage.tracks[a], stage.frames[a]
    pa, pb = stage.prop(a), stage.prop(b)
    heading = track.heading + frame.angle
    ghost = np.array(frame.apply(*track.points[-1]))
    speed = track.speed
    side = float(stage.rng.choice([-1.0, 1.0]))
    way = _unit(heading)
    normal, across = (
        _unit(heading + side * CUT_RAD),
        _unit(heading + side * (CUT_RAD - math.pi / 2)),
    )
    centre = ghost + (pa.half_width + pb.half_width) * normal
    stage.places[b] = (float(centre[0]), float(centre[1]), heading)
    restitution = 0.5 * (pa.restitution + pb.restitution)
    hit, total = speed * math.cos(CUT_RAD), pa.mass + pb.mass
    struck = (1.0 + restitution) * pa.mass / total * hit
    x, y = float(centre[0]), float(centre[1])
    away = heading + side * CUT_RAD
    rubs = 0.5 * (pa.friction + pb.friction)
    spin = back_spin(pa.mass, pb.mass, hit, rubs, struck)
    stage.moving[b] = Track(x, y, away, struck, track.time, spin, [(x, y)])
    left = (hit - struck * pb.mass / pa.mass) * normal + speed * math.sin(CUT_RAD) * across
    slip = speed * way - left
    slides = max(0.5 * (pa.friction + stage.ground_friction()), 0.02) * GRAVITY_MPS2
    lasts = ROLLS_ON * float(np.linalg.norm(slip)) / slides
    rolls = (1.0 - ROLLS_ON) * left + ROLLS_ON * speed * way
    # The straight line on which it rolls at last, traced back to the moment of the hit.
    start = ghost + 0.5 * lasts * (left + rolls) - lasts * rolls
    new = math.atan2(rolls[1], rolls[0])
    track.heading = new - frame.angle
    track.speed = float(np.linalg.norm(rolls))
    local = Frame(angle=-frame.angle).apply(start[0] - frame.x, start[1] - frame.y)
    track.x, track.y = local
    track.points.append(local)
    stage.thrown_back.add(a)
    stage.time[node.id] = track.time
    if not goes_on(stage, node, b):
        offset = centre - np.array(frame.apply(0.0, 0.0))
        aim = heading - math.atan2(offset[1], offset[0])
        stage.nominal[f"{a}/aim"] = (aim + math.pi) % (2.0 * math.pi) - math.pi


def _unit(angle: float) -> np.ndarray:
    return np.array([math.cos(angle), math.sin(angle)])
