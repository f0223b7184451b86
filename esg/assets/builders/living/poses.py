"""How people stand, walk, kick and ride: angles of joints, and the skeleton that follows."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.lexicon.gestures import told_by

Point = NDArray[np.float64]
PIVOT = np.array([-1.5, 0.0, 96.0])
"""Where a trunk bends [cm]."""
NECK = np.array([-2.5, 0.0, 146.0])
"""Where a head nods [cm], before the trunk bends."""
SEAT = 81.0
"""Height of what one sits on above the ground of a standing body [cm]."""
THIGH, SHANK, UPPER_ARM, FOREARM = 42.0, 39.5, 27.0, 24.0


@dataclass(frozen=True)
class Limb:
    """Angles of an arm or leg [deg].

    Args:
        swing: Forwards, at shoulder or hip.
        out: Sideways, away from the body.
        bend: Of elbow (forwards) or knee (backwards).
        turn: Forearm towards the middle, or toes down.
    """

    swing: float = 0.0
    out: float = 0.0
    bend: float = 0.0
    turn: float = 0.0


@dataclass(frozen=True)
class Pose:
    """A posture; left is +Y.

    Args:
        arms, legs: Left and right.
        lean: Of the trunk, forwards [deg].
        twist: Of the trunk to its left [deg].
        nod: Of the head against the trunk, forwards [deg].
        turn: Of the head to its left [deg].
        grip: Whether hands are closed.
        seated: Whether it is the seat that z = 0 is, not the ground.
        lies: Whether all of it lies on its back, head ahead.
    """

    arms: tuple[Limb, Limb]
    legs: tuple[Limb, Limb]
    lean: float = 0.0
    twist: float = 0.0
    nod: float = 0.0
    turn: float = 0.0
    grip: bool = False
    seated: bool = False
    lies: bool = False

    @property
    def gathers(self) -> bool:
        """Whether what hangs is drawn up over the thighs: of who sits, on a seat or the ground."""
        return self.seated or min(leg.swing for leg in self.legs) > _THIGHS_UP


_THIGHS_UP = 60.0
"""Swing of both legs [deg] of who squats or sits on the ground."""


def _both(limb: Limb) -> tuple[Limb, Limb]:
    return (limb, limb)


_EASY = Limb(2, 7.4, 14, 3)
_STRAIGHT = Limb(-2, 1.5, 1.5)
POSES: dict[str, Pose] = {
    "stand": Pose(_both(_EASY), _both(_STRAIGHT)),
    "laden": Pose(_both(Limb(-6, 7.4, 10, 3)), _both(Limb(-3.4, 1.5, 1.5))),
    "play": Pose(_both(Limb(4, 20, 33, 10)), (Limb(0, 3, 2), Limb(-4, 3, 2))),
    "walk": Pose(
        (Limb(-20, 6, 16, 4), Limb(24, 6, 26, 6)), (Limb(24, 1, 6, -12), Limb(-16, 1, 20, 28)), 4
    ),
    "run": Pose(
        (Limb(-42, 10, 82, 10), Limb(38, 8, 92, 18)),
        (Limb(58, 1, 92, 8), Limb(-20, 1, 22, 46)),
        12,
        nod=-8,
        grip=True,
    ),
    "kick": Pose(
        (Limb(28, 46, 22, 0), Limb(-30, 36, 30, 0)),
        (Limb(-4, 3, 16, 0), Limb(46, 3, 14, 18)),
        -9,
        twist=-10,
        nod=16,
    ),
    "throw": Pose(
        (Limb(62, 14, 16, 0), Limb(30, 96, 110, 62)),
        (Limb(28, 3, 16, 0), Limb(-20, 4, 18, 26)),
        4,
        twist=-16,
    ),
    "push": Pose(
        _both(Limb(4, 14, 84, 10)), (Limb(30, 2, 40, 0), Limb(-18, 2, 10, 30)), 16, nod=-10
    ),
    "hold": Pose(_both(Limb(18, 10, 74, 16)), _both(_STRAIGHT), 2),
    "bear": Pose(_both(Limb(112, 44, 66, 46)), (Limb(16, 1, 6, -8), Limb(-10, 1, 12, 18))),
    "swing": Pose(
        (Limb(62, -6, 20, 26), Limb(48, 4, 40, 34)),
        (Limb(14, 9, 16, 0), Limb(8, 9, 14, 8)),
        14,
        twist=12,
        nod=-4,
        grip=True,
    ),
    "sit": Pose(_both(Limb(28, 8, 52, 10)), _both(Limb(86, 5, 84, 0)), 2, seated=True),
    "floor": Pose(_both(Limb(6, 12, 20, 6)), _both(Limb(128, 7, 94, 6)), 8, nod=-4),
    "lie": Pose(_both(Limb(4, 12, 8, 4)), _both(Limb(0, 3, 2, 40)), lies=True),
    "kneel": Pose(_both(Limb(16, 8, 30, 10)), _both(Limb(2, 4, 92, 150)), 2, nod=6),
    "crouch": Pose(_both(Limb(66, 12, 40, 16)), _both(Limb(112, 10, 128, 14)), 34, nod=-20),
    "bend": Pose(_both(Limb(78, 6, 10, 4)), _both(Limb(10, 2, 18, 0)), 68, nod=-8),
    "ride": Pose(
        _both(Limb(62, 4, 16, 2)),
        (Limb(84, 2, 86, 4), Limb(42, 2, 46, 12)),
        34,
        nod=-24,
        grip=True,
        seated=True,
    ),
    "straddle": Pose(
        _both(Limb(58, 14, 24, 4)),
        _both(Limb(66, 13, 84, 6)),
        14,
        nod=-8,
        grip=True,
        seated=True,
    ),
    "astride": Pose(
        _both(Limb(58, 10, 24, 4)),
        _both(Limb(52, 34, 70, 6)),
        10,
        nod=-6,
        grip=True,
        seated=True,
    ),
    "balance": Pose(
        (Limb(14, 48, 24, 0), Limb(-12, 42, 26, 0)), (Limb(24, 4, 34, 0), Limb(-4, 8, 30, 0)), 12
    ),
    "board": Pose(
        (Limb(20, 26, 22, 0), Limb(8, 22, 34, 0)),
        (Limb(20, 15, 36, 0), Limb(20, 15, 36, 0)),
        10,
        twist=32,
        nod=-4,
    ),
    "ski": Pose(
        _both(Limb(24, 20, 62, 6)),
        _both(Limb(34, 0, 58, -2)),
        24,
        nod=-18,
        grip=True,
    ),
    "skate": Pose(
        (Limb(-34, 16, 30, 0), Limb(40, 16, 46, 10)),
        _both(Limb(26, 1, 44, 0)),
        22,
        nod=-14,
    ),
}


def pose_of(name: str) -> Pose:
    """A pose by its name, with what its gesture makes of it (`esg.lexicon.gestures.posed`)."""
    own, gesture, state = told_by(name, "people")
    pose = POSES[own]
    if gesture is None:
        return pose
    arms = [
        Limb(
            *(
                gesture.angles(state, f"arm_{side}.{angle}", getattr(arm, angle))
                for angle in ("swing", "out", "bend", "turn")
            )
        )
        for side, arm in zip(("left", "right"), pose.arms, strict=True)
    ]
    trunk = {
        j: gesture.angles(state, j, getattr(pose, j)) for j in ("lean", "twist", "nod", "turn")
    }
    return replace(pose, arms=(arms[0], arms[1]), **trunk)


def _down(swing: float, out: float, side: int) -> Point:
    """A unit vector that hangs down, swung forwards and outwards [deg]."""
    f, o = math.radians(swing), math.radians(out)
    return np.array([math.sin(f) * math.cos(o), side * math.sin(o), -math.cos(f) * math.cos(o)])


def turned_about(points: Point, at: Point, pitch: float, yaw: float = 0.0) -> Point:
    """Points turned about an upright axis, then about Y, through `at` [deg]; forwards is +."""
    p, w = math.radians(pitch), math.radians(yaw)
    about_z = np.array([[math.cos(w), -math.sin(w), 0], [math.sin(w), math.cos(w), 0], [0, 0, 1]])
    about_y = np.array([[math.cos(p), 0, math.sin(p)], [0, 1, 0], [-math.sin(p), 0, math.cos(p)]])
    return (points - at) @ (about_y @ about_z).T + at


@dataclass(frozen=True)
class Skeleton:
    """Joints of a posed body [cm], left and right.

    Args:
        pose: What it follows.
        arms: Shoulder, elbow and wrist, shape [3, 3] each.
        legs: Hip, knee and ankle, shape [3, 3] each.
        feet: Pitch of each foot, toes down [deg].
        lift: What everything is moved by to stand on the origin, or sit on it [cm], shape [3].
        head_size: Of the head against that of an adult.
    """

    pose: Pose
    arms: tuple[Point, Point]
    legs: tuple[Point, Point]
    feet: tuple[float, float]
    lift: Point
    head_size: float = 1.0

    @property
    def spine(self) -> Point:
        """Where the trunk bends, the neck and the crown [cm], shape [3, 3]."""
        crown = NECK + np.array((0.0, 0.0, 26.0))
        above = turned_about(np.array([NECK, crown]), PIVOT, self.pose.lean, self.pose.twist)
        return np.array([PIVOT, *above])

    def trunk(self, points: Point) -> Point:
        """Where the trunk's leaning takes points of a straight one: the waist bends smoothly."""
        share = np.clip((points[:, 2] - (PIVOT[2] - 6)) / 26, 0, 1)
        share = share * share * (3 - 2 * share)
        out = points.copy()
        for k in np.unique(np.round(share, 2)):
            here = np.abs(share - k) <= 0.0051
            out[here] = turned_about(
                points[here], PIVOT, self.pose.lean * float(k), self.pose.twist * float(k)
            )
        return out

    def head(self, points: Point) -> Point:
        """Where trunk and neck take points of an upright head."""
        grown = NECK + self.head_size * (points - NECK)
        nodded = turned_about(grown, NECK, self.pose.nod, self.pose.turn - 0.6 * self.pose.twist)
        return turned_about(nodded, PIVOT, self.pose.lean, self.pose.twist)


def skeleton(pose: Pose, head_size: float = 1.0) -> Skeleton:
    """The joints of a pose."""
    arms, legs, feet = [], [], []
    for side, arm, leg in zip((1, -1), pose.arms, pose.legs, strict=True):
        shoulder = np.array([-2.0, side * 16.4, 134.6])
        elbow = shoulder + UPPER_ARM * _down(arm.swing, arm.out, side)
        wrist = elbow + FOREARM * _down(arm.swing + arm.bend, arm.out - arm.turn, side)
        arms.append(turned_about(np.array([shoulder, elbow, wrist]), PIVOT, pose.lean, pose.twist))
        hip = np.array([-1.5, side * 8.4, 91.0])
        knee = hip + THIGH * _down(leg.swing, leg.out, side)
        ankle = knee + SHANK * _down(leg.swing - leg.bend, 0.3 * leg.out, side)
        legs.append(np.array([hip, knee, ankle]))
        feet.append(leg.turn)
    soles = []
    for leg, pitch in zip(legs, feet, strict=True):
        sole = np.array([[-8.9, 0, -9.2], [20.0, 0, -9.2], [8.0, 0, -9.2]])
        soles.append(turned_about(sole, np.zeros(3), pitch) + leg[2])
        # Who sits or kneels on the ground has his seat or his knees there.
        soles.append(np.array([leg[1] - [0, 0, 7.0], leg[0] - [0, 0, 11.0]]))
    under = np.concatenate(soles)
    lift = np.array([-0.5 * float(under[:, 0].min() + under[:, 0].max()), 0.0, -under[:, 2].min()])
    if pose.seated:
        lift = np.array([0.0, 0.0, -SEAT])
    return Skeleton(
        pose, (arms[0], arms[1]), (legs[0], legs[1]), (feet[0], feet[1]), lift, head_size
    )
