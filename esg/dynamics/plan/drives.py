"""Moving a jointed body along its joint, and holding one drawn back until it is let go."""

from __future__ import annotations

import math

import numpy as np

from esg.dynamics.story.driving import Reach
from esg.engines.joints import Joint, joint_ends, joint_poses, start_position
from esg.engines.program import DriveJoint, GuideAlong, HoldSpin, Primitive
from esg.engines.scene import Body, SimScene
from esg.graph.joints import KINDS_OF_JOINT
from esg.graph.models import EdgeEvent
from esg.units import quat_rotate

LIFTED_M = 0.005
"""Gravity works against a hinge that raises what it carries by so much on its way."""
LIFTS_BY = 4.0
"""What raises it can hold so many times its weight where that pulls the most."""
PLACES = 13
"""Places along the way of a hinge at which its weight is looked at."""
RAMP_STEPS = 12
"""Steps in which a hinge that carries something gets up to speed."""
STAYS = 1e-6
"""What is there already is not driven on [rad or m]."""
SEEN_SHUT_S = 0.3
"""What drops open is held for so long at least, so that it is seen to be shut."""
SPEEDS_UP_S = 0.2
"""A motor that swings a leaf back has the torque that gets a rod of its mass up to speed in that
time, besides its friction."""
SETTLED_S = 0.5
"""A motor has reached its place so long after it would at an even speed
(`esg.engines.joint_rules.APPROACH_RATE`)."""


def held_at(body: Body, until: float) -> Primitive:
    """Keeps a body where it is until it is let go [s]."""
    still = (0.0, 0.0, 0.0)
    return GuideAlong(body.name, 0.0, (0.0, until), (body.position, body.position), (still, still))


def joint_of(scene: SimScene, name: str) -> Joint | None:
    """The hinge or slider of which a body is the child."""
    able = KINDS_OF_JOINT[EdgeEvent.DRIVE]
    return next((j for j in scene.joints if j.child == name and j.kind in able), None)


def reach_of(joint: Joint) -> Reach:
    """The limits within which a joint is driven."""
    return Reach(joint.kind == "hinge", joint.lower, joint.upper)


def driven(
    scene: SimScene,
    joint: Joint,
    start: float,
    here: float,
    goal: float,
    lasts: float,
    ramp: float = 0.0,
) -> tuple[Primitive, ...]:
    """What moves a joint's child from one position to another.

    A hinge is spun, which gravity slows down by g r m dt / I in every step. One that it would slow
    down on its way up is given a motor instead, which holds it there unless its friction does. One
    that is shut and would drop open by itself is held until then, and let go: a trapdoor.

    Args:
        scene: Its scene; bodies as they start.
        joint: Hinge or slider.
        start: [s].
        here, goal: Positions of the joint [rad or m].
        lasts: How long it takes [s].
        ramp: How long a hinge takes to get up to speed, before that [s].
    """
    if abs(goal - here) < STAYS:
        return ()
    body = scene.body(joint.child)
    axis = _axis(scene, joint)
    if joint.kind == "hinge":
        height, pull = _raised(scene, joint, axis, here, goal)
        drops = math.copysign(1.0, goal - here) * float(pull[0]) > joint.friction
        if drops and abs(here) < STAYS and abs(start_position(scene, joint)) < STAYS:
            return (held_at(body, max(start, SEEN_SHUT_S)),)
        if abs(goal - here) <= math.pi and float(height.max() - height[0]) >= LIFTED_M:
            rate = abs(goal - here) / lasts
            most = joint.friction + LIFTS_BY * float(np.abs(pull).max())
            lifts = DriveJoint(joint.name, start, rate, goal, most)
            rest = DriveJoint(joint.name, start + lasts + SETTLED_S)
            return (lifts, rest) if abs(pull[-1]) < joint.friction else (lifts,)
        rate, step, about = (goal - here) / lasts, ramp / RAMP_STEPS, _vec(axis)
        spins = [(start + k * step, step, rate * k / RAMP_STEPS) for k in range(1, RAMP_STEPS)]
        spins = [*(spins if ramp else ()), (start + ramp, lasts, rate)]
        return tuple(HoldSpin(body.name, t, t + long, r, about) for t, long, r in spins)
    first = np.asarray(body.position, float) + (here - start_position(scene, joint)) * axis
    rest = (0.0, 0.0, 0.0)
    points = (_vec(first), _vec(first + (goal - here) * axis))
    return (GuideAlong(body.name, start, (0.0, lasts), points, (rest, rest)),)


def drawn_to(
    scene: SimScene, joint: Joint, start: float, goal: float, lasts: float
) -> tuple[Primitive, ...]:
    """What moves a joint's child to a position from wherever a blow has left it.

    Args:
        scene: Its scene; bodies as they start.
        joint: Hinge with limits.
        start: [s].
        goal: Position of the joint [rad].
        lasts: How long it takes from the limit that is farther away [s].
    """
    body = scene.body(joint.child)
    ends = [e for e in (joint.lower, joint.upper) if e is not None]
    rate = max((abs(e - goal) for e in ends), default=math.pi) / lasts
    arm = np.asarray(body.position, float) - joint_ends(joint, *joint_poses(scene, joint))[1]
    most = joint.friction + 4.0 / 3.0 * body.mass * float(arm @ arm) * rate / SPEEDS_UP_S
    pulls = DriveJoint(joint.name, start, rate, goal, most)
    return (pulls, DriveJoint(joint.name, start + lasts + SETTLED_S))


def kept_shut(scene: SimScene, joint: Joint, time: float) -> tuple[Primitive, ...]:
    """What keeps a hinge that has come to position 0 there, where no stop does: a gate's latch.

    Args:
        scene: Its scene; bodies as they start.
        joint: Hinge or slider.
        time: When it is there [s].
    """
    stops = any(end is not None and abs(end) < STAYS for end in (joint.lower, joint.upper))
    if joint.kind != "hinge" or stops:
        return ()
    return (HoldSpin(joint.child, time, time + SETTLED_S, 0.0, _vec(_axis(scene, joint))),)


def _axis(scene: SimScene, joint: Joint) -> np.ndarray:
    """Axis of a joint in the world, as its child starts, shape [3]."""
    turned = quat_rotate(np.asarray(joint.child_rotation, float), np.array([1.0, 0.0, 0.0]))
    return quat_rotate(np.asarray(scene.body(joint.child).quaternion, float), turned)


def let_go(before: list[Primitive], time: float) -> list[Primitive]:
    """What has acted on a joint's child, without motors after a time [s], of which it lets go."""
    motors = [p for p in before if isinstance(p, DriveJoint)]
    kept = [p for p in before if not isinstance(p, DriveJoint) or p.time < time]
    return [*kept, DriveJoint(motors[-1].joint, time)] if motors else kept


def _raised(
    scene: SimScene, joint: Joint, axis: np.ndarray, here: float, goal: float
) -> tuple[np.ndarray, np.ndarray]:
    """Height [m] of what a hinge carries over its axle, and torque of its weight about it [N m].

    Args:
        scene: Bodies as they start.
        joint: The hinge.
        axis: Of its child as that starts, in the world, shape [3].
        here, goal: From where to where [rad].

    Returns:
        Both at places evenly along the way, shape [PLACES].
    """
    body = scene.body(joint.child)
    anchor = joint_ends(joint, *joint_poses(scene, joint))[1]
    arm = np.asarray(body.position, float) - anchor
    turn = (np.linspace(here, goal, PLACES) - start_position(scene, joint))[:, None]
    along, across = (arm @ axis) * axis, np.cross(axis, arm)
    out = along + np.cos(turn) * (arm - along) + np.sin(turn) * across
    weight = body.mass * np.asarray(scene.gravity, float)
    return out[:, 2], np.cross(out, weight) @ axis


def _vec(v: np.ndarray) -> tuple[float, float, float]:
    return float(v[0]), float(v[1]), float(v[2])
