"""Moving a jointed body along its joint, and holding one drawn back until it is let go."""

from __future__ import annotations

import math

import numpy as np

from esg.dynamics.story.story import Phase, bounds
from esg.engines.joints import Joint, start_position
from esg.engines.program import GuideAlong, HoldSpin, Primitive
from esg.engines.scene import Body, SimScene
from esg.graph.joints import KINDS_OF_JOINT
from esg.graph.models import EdgeEvent, NodeEvent
from esg.metrics.models import EVENT_DEGREES
from esg.thresholds import OPEN_SHARE
from esg.units import quat_rotate

OPENS_RAD = math.radians(75.0)
"""What has no limit, or a wider one, is opened so far."""
OPENS_M = 0.3
SURELY = 1.4
"""Of what is asked, an opening that states no position goes so many times as far."""


def held_at(body: Body, until: float) -> Primitive:
    """Keeps a body where it is until it is let go [s]."""
    still = (0.0, 0.0, 0.0)
    return GuideAlong(body.name, 0.0, (0.0, until), (body.position, body.position), (still, still))


def joint_of(scene: SimScene, name: str) -> Joint | None:
    """The hinge or slider of which a body is the child."""
    able = KINDS_OF_JOINT[EdgeEvent.DRIVE]
    return next((j for j in scene.joints if j.child == name and j.kind in able), None)


def goal_of(joint: Joint, phase: Phase, here: float, goes_on: bool = False) -> float:
    """Where a joint is driven to [rad or m].

    Args:
        joint: Hinge or slider.
        phase: A Drive.
        here: Where it is before [rad or m].
        goes_on: Whether it is driven on from there, into something.
    """
    hinge = joint.kind == "hinge"
    low, high, _ = bounds(phase.edge.params.opening, (math.nan, math.nan))
    if not math.isnan(low):
        stated = 0.5 * (low + high)
        return math.radians(stated) if hinge else stated / 100.0
    if phase.end.event is NodeEvent.CLOSE:
        return 0.0
    if phase.end.event is NodeEvent.SPIN:
        return here + SURELY * math.radians(phase.end.turn_degrees or 360.0)
    usual = OPENS_RAD if hinge else OPENS_M
    ends = [e for e in (joint.lower, joint.upper) if e is not None and abs(e) > 1e-6]
    far = max(ends, key=lambda e: abs(e - here), default=usual)
    asked = math.radians(phase.end.turn_degrees or EVENT_DEGREES["opens"])
    if not hinge:
        asked = OPEN_SHARE * abs(far)
    way = min(SURELY * asked if goes_on else max(usual, SURELY * asked), abs(far))
    return math.copysign(way, far)


def driven(
    scene: SimScene, joint: Joint, start: float, here: float, goal: float, lasts: float
) -> Primitive:
    """The primitive that moves a joint's child from one position to another.

    Args:
        scene: Its scene; bodies as they start.
        joint: Hinge or slider.
        start: [s].
        here, goal: Positions of the joint [rad or m].
        lasts: How long it takes [s].
    """
    body = scene.body(joint.child)
    turned = quat_rotate(np.asarray(joint.child_rotation, float), np.array([1.0, 0.0, 0.0]))
    axis = quat_rotate(np.asarray(body.quaternion, float), turned)
    if joint.kind == "hinge":
        return HoldSpin(body.name, start, start + lasts, (goal - here) / lasts, _vec(axis))
    first = np.asarray(body.position, float) + (here - start_position(scene, joint)) * axis
    rest = (0.0, 0.0, 0.0)
    points = (_vec(first), _vec(first + (goal - here) * axis))
    return GuideAlong(body.name, start, (0.0, lasts), points, (rest, rest))


def _vec(v: np.ndarray) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])
