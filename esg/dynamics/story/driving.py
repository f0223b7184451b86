"""How far a joint is driven, and what lies in its way: doors, gates, drawers, booms."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.dynamics.story.story import Phase, bounds
from esg.dynamics.story.suspension import joint_of
from esg.graph.joints import KINDS_OF_JOINT, mount_of, placing_joints, start_frames
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent
from esg.metrics.models import EVENT_DEGREES
from esg.thresholds import OPEN_SHARE
from esg.units import quat_rotate

OPENS_RAD = math.radians(75.0)
"""What has no limit, or a wider one, is opened so far."""
OPENS_M = 0.3
QUICKLY_S = 1.05
"""How long a lid takes past which something drops: that is let go at the start, from so high up."""
SURELY = 1.4
"""Of what is asked, an opening that states no position goes so many times as far."""
GOES_ON_RAD = math.radians(30.0)
"""So much further goes what has been opened before and then meets something."""
UPRIGHT = 0.95
"""Least share along the vertical of an axis about which something sweeps over the ground."""


@dataclass(frozen=True)
class Reach:
    """The joint that something is driven along: limits [rad or m], None where there are none."""

    hinge: bool
    lower: float | None
    upper: float | None


@dataclass(frozen=True)
class Leaf:
    """What turns about an upright axle, from above, in its own frame at the start (SI).

    Args:
        axle: Where that is, from its origin [m].
        arm: Direction from there to its centre of mass [rad].
        reach: From the axle to its far end [m].
        thick: Half of its thickness across the arm [m].
        here: Position of its joint at the start [rad].
        sense: 1 if it turns counter-clockwise from above as its position grows, else -1.
        limits: Of its joint.
    """

    axle: tuple[float, float]
    arm: float
    reach: float
    thick: float
    here: float
    sense: float
    limits: Reach


def goal_of(reach: Reach, phase: Phase, here: float, following: Phase | None = None) -> float:
    """Where a joint is driven to [rad or m].

    Args:
        reach: Its limits.
        phase: A Drive.
        here: Where it is before [rad or m].
        following: What the same actor does next.
    """
    low, high, _ = bounds(phase.edge.params.opening, (math.nan, math.nan))
    if not math.isnan(low):
        stated = 0.5 * (low + high)
        return math.radians(stated) if reach.hinge else stated / 100.0
    ends_in = phase.end.event
    if ends_in is NodeEvent.COLLISION and following is not None:
        ends_in = following.end.event  # what it meets on its way does not stop it
    if ends_in is NodeEvent.CLOSE:
        return 0.0
    if ends_in is NodeEvent.SPIN:
        return here + SURELY * math.radians(phase.end.turn_degrees or 360.0)
    usual = OPENS_RAD if reach.hinge else OPENS_M
    ends = [e for e in (reach.lower, reach.upper) if e is not None and abs(e) > 1e-6]
    far = max(ends, key=lambda e: abs(e - here), default=usual)
    asked = math.radians(phase.end.turn_degrees or EVENT_DEGREES["opens"])
    if not reach.hinge:
        asked = OPEN_SHARE * abs(far)
    goes_on = following is not None and following.edge.event is EdgeEvent.DRIVE
    if goes_on and following is not None and following.end.event is NodeEvent.COLLISION:
        # short of its end, if that leaves what it is to meet some way
        way = min(SURELY * asked, 0.5 * (asked + abs(far)))
    else:
        way = max(usual, SURELY * asked)
    if ends_in is NodeEvent.COLLISION:
        way = max(way, abs(here) + (GOES_ON_RAD if reach.hinge else 0.0))
    return math.copysign(min(way, abs(far)), far)


def leaf_of(doc: EsgDocument, name: str) -> Leaf | None:
    """What sweeps over the ground as its hinge is driven; None for all else.

    Args:
        doc: With asset configurations.
        name: The child of a joint.
    """
    joint, found = joint_of(doc, name), start_frames(doc).get(name)
    driven = joint is not None and joint.kind in KINDS_OF_JOINT[EdgeEvent.DRIVE]
    if joint is None or not driven or joint.kind != "hinge" or found is None:
        return None
    asset = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    mount, frame = mount_of(asset, placing_joints(doc)[name].child_mount), found[1]
    if mount is None:
        return None
    axis = quat_rotate(frame.quaternion, np.asarray(mount.axis, float))
    if abs(axis[2]) < UPRIGHT * float(np.linalg.norm(axis)):
        return None
    half = 0.5 * np.asarray(asset.dimensions_cm[:2], float)
    axle = np.asarray(mount.position_cm[:2], float)
    corners = np.array([(x, y) for x in (-half[0], half[0]) for y in (-half[1], half[1])])
    out = np.asarray(asset.center_of_mass_cm[:2], float) - axle
    if float(np.hypot(*out)) < 0.2 * float(half.max()):
        return None  # it turns about its middle: a turnstile
    arm = math.atan2(out[1], out[0])
    along = np.array([math.cos(arm), math.sin(arm)])
    across = np.array([-math.sin(arm), math.cos(arm)])
    return Leaf(
        (float(axle[0]) / 100.0, float(axle[1]) / 100.0),
        arm,
        float(((corners - axle) @ along).max()) / 100.0,
        float(((corners - axle) @ across).max()) / 100.0,
        math.radians(joint.position),
        math.copysign(1.0, float(axis[2])),
        Reach(True, _rad(joint.lower), _rad(joint.upper)),
    )


def _rad(value: float | None) -> float | None:
    return None if value is None else math.radians(value)
