"""Where the camera is at every instant: a closed form of the poses and of what is said."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
import itertools
import math

import numpy as np
from numpy.typing import NDArray

from esg.engines.scene import SimScene
from esg.filming.sight import clear_share
from esg.filming.subjects import Poses, Subject, movers, poses_at, soft, subject_of
from esg.graph.filming import Shot, rows

Floats = NDArray[np.float64]

STEP_S = 1.0 / 12.0
"""A way is planned at such steps; pictures lie between them."""
FOV_RAD, OWN_FOV_RAD = 2 * math.atan(12.0 / 35.0), 2 * math.atan(12.0 / 24.0)
"""Of 35 mm on film of 36 x 24 mm; of somebody's own eyes 24 mm."""
FILL, FOLLOWED_FILL = 0.62, 0.45
"""How far what is filmed reaches to the edge of the picture, where nothing is said; less of what is
followed, so that one sees what it meets."""
INSIDE, CUT = 0.92, 1.2
"""Nothing reaches farther, but a close-up, which may cut its edges."""
LOWEST_M = 0.12
"""Of an eye above the ground; of what is smaller than that, half its size."""
HUMAN_M = 1.0
"""Beside what is larger people stand, over what is smaller they bend."""
STANDING_DEG: dict[bool, tuple[float, ...]] = {True: (10.0, 20.0, 35.0), False: (26.0, 38.0, 52.0)}
TURNS_DEG = (0, 28, -28, 55, -55, 90, -90, 125, -125, 180)
NEAR_TURNS_DEG = (0, 12, -12, 24, -24)
"""Turns that are tried from the usual side, and where words say the side."""
SIGHT = 2.0
"""Worth of full sight, beside costs of turns from the usual side."""
OTHER_SIDE = 0.3
"""Cost of the other side than the usual one: only where little is seen from that."""
LONG_WAY, SOME_WAY = 3.0, 1.5
"""What travels so many times its own size is followed where nothing else is said; less where the
camera comes nearer or goes away, which would else be its own coming and going."""
SOFT_S, STRAY = (0.25, 0.15, 0.08, 0.03, 0.0), 0.12
"""A camera that follows is slowed by a bell so wide: the widest from which what is filmed strays by
no more than this part of its size."""
STANDING_FILL = 0.8
"""How far the whole way of what moves reaches, where the camera does not follow it."""
CLOSE_SHARE = 0.6
"""A close-up is as close as it can be for so much of the time."""
COMPANY = 0.5
"""What moves is held in the picture, too, as near as this part of the size of what is filmed."""
MATES, MATES_M = 2.0, 0.5
"""What is met is held in the picture while it is within so many sizes of what is followed, of a
large thing within so much [m] of its surface."""
ABREAST = 1.3
"""A camera that turns along with what goes by stands so many halves of its way off."""
CLOSER = 1.7
"""What comes closer starts so many times as far away as it ends."""
SHIFT, SHIFT_TARGET = 0.3, 0.5
"""A camera that moves sideways or up goes so far to either side, in its distances, and looks so
far along with it."""
PAN_RAD, TILT_RAD = math.radians(8), math.radians(7)
"""It turns so far to either side."""
ORBIT_RAD, ORBIT_RAD_S = math.radians(140), math.radians(50)
ORBIT_LEAST_RAD = math.radians(70)
"""It goes round so far, at most so fast, and at least so far in short scenes."""
SHAKE_RAD, SHAKE_HZ = math.radians(0.35), ((0.9, 1.7), (1.3, 2.3))
"""A hand shakes by so much, at such frequencies across and upright."""
HEAD, BUST = 0.92, 0.35
"""Where the eyes of who stands upright are, and the part of it that a close-up shows."""
UPRIGHT = 1.5
"""Who is so many times as high as long and wide has a head and shoulders."""


@dataclass(frozen=True)
class Way:
    """Where a camera is at K instants.

    Args:
        time_s: Of the scene, ascending [s], shape [K].
        eye: Positions [m], shape [K, 3].
        target: Points in the middle of the picture [m], shape [K, 3].
        fov: Vertical field of view [rad].
        rate: Seconds of the scene in a second of film.
    """

    time_s: Floats
    eye: Floats
    target: Floats
    fov: float
    rate: float = 1.0


def way_of(
    shot: Shot, scene: SimScene, time: Floats, p: Floats, q: Floats, aspect: float
) -> Way | None:
    """The camera's way through a replay; None in a scene without bodies.

    Args:
        shot: What is said.
        scene: B bodies.
        time: Of the replay [s], shape [T].
        p: Centres of mass [m], shape [T, B, 3].
        q: Orientations (x, y, z, w), shape [T, B, 4].
        aspect: Width over height of the pictures.
    """
    poses = poses_at(scene, np.asarray(time, float), p, q, STEP_S)
    subject = subject_of(poses, shot.subjects)
    if subject is None:
        return None
    if shot.says("first_person"):
        return replace(_first_person(poses, subject), rate=shot.rate)
    if shot.says("over_shoulder"):
        way = _over_shoulder(poses, subject)
    else:
        way = _best(shot, poses, subject, aspect)
    if shot.says("handheld"):
        way = _shaken(way)
    return replace(way, rate=shot.rate)


@dataclass(frozen=True)
class _Frame:
    """What is held in the picture: a middle that moves and half of its sides.

    Args:
        middle: [m], shape [K, 3].
        half: [m], shape [3].
        fill: How far it reaches to the edge of the picture.
        follows: Whether the camera goes along with it.
        anchor: What the camera stands off from, while it turns along with the middle [m], shape
            [3]; None: the middle.
        least_m: The camera stands at least so far off [m].
    """

    middle: Floats
    half: Floats
    fill: float
    follows: bool
    anchor: Floats | None = None
    least_m: float = 0.0

    @property
    def box(self) -> Floats:
        """Its corners from its middle [m], shape [8, 3]."""
        return np.array(list(itertools.product((-1, 1), repeat=3)), float) * self.half


def _frame(shot: Shot, poses: Poses, subject: Subject) -> _Frame:
    table = rows()
    fills = [f for word in shot.words if (f := table[word].fill) is not None]
    along = _turns_along(shot, subject)
    follows = along is None and _follows(shot, subject)
    usual = FOLLOWED_FILL if follows else FILL
    fill = min(fills) if shot.says("wide") else max(fills, default=usual)
    low, high = subject.low, subject.high
    if shot.says("close_up", "extreme_close_up") and _has_bust(subject):
        low = np.concatenate([low[:, :2], (high - BUST * subject.size)[:, 2:]], axis=1)
    bottom, top = low.min(axis=0), high.max(axis=0)
    whole = 0.5 * (bottom + top)
    if along is not None or follows:
        calm = _calm(0.5 * (low + high), high - low, float(poses.time_s[1] - poses.time_s[0]))
        # What falls over is not the larger for a close-up because it was high before.
        usual_size = CLOSE_SHARE if shot.says("close_up", "extreme_close_up") else 1.0
        sides = np.quantile(np.maximum(high - calm, calm - low), usual_size, axis=0)
        half = np.maximum(sides, 1e-3)
        if along is not None:
            way = subject.middle[-1] - subject.middle[0]
            least = ABREAST * 0.5 * float(np.linalg.norm(way))
            return _Frame(calm, half, fill, follows=False, anchor=along, least_m=least)
        mates = half
        if not shot.says("close_up", "extreme_close_up", "medium", "wide"):
            mates = _with_mates(poses, subject, calm, half)
        fill = max(fill, FILL) if np.any(mates > 1.2 * half) else fill
        return _Frame(calm, mates, fill, follows=True)
    if not shot.says("close_up", "extreme_close_up", "medium"):
        bottom, top = _with_company(poses, subject, bottom, top)
        whole = 0.5 * (bottom + top)
    if float(subject.sweep.max()) > SOME_WAY * float(subject.size.max()):
        fill = max(fill, STANDING_FILL)
    still = np.tile(whole, (len(low), 1))
    return _Frame(still, np.maximum(0.5 * (top - bottom), 1e-3), fill, follows=False)


def _with_company(
    poses: Poses, subject: Subject, bottom: Floats, top: Floats
) -> tuple[Floats, Floats]:
    """Corners of a box with what moves near by, too: the ball that rolls past a car."""
    reach = COMPANY * float(subject.size.max())
    low, high = bottom - reach, top + reach
    for body in movers(poses):
        if body in subject.bodies:
            continue
        corners = poses.corners((body,)).reshape(-1, 3)
        a, b = np.maximum(corners.min(axis=0), low), np.minimum(corners.max(axis=0), high)
        if np.all(a <= b):
            bottom, top = np.minimum(bottom, a), np.maximum(top, b)
    return bottom, top


def _with_mates(poses: Poses, subject: Subject, calm: Floats, half: Floats) -> Floats:
    """Half of the sides that hold what it meets, too: the ball that is hit, the box rolled into."""
    size = float(subject.size.max())
    reach = min(MATES * size, 0.75 * size + MATES_M)
    for body, b in enumerate(poses.scene.bodies):
        if body in subject.bodies or not b.shapes or max(b.half_extents) > reach:
            continue
        away = np.abs(poses.corners((body,))[:, 0] - calm[:, None])
        near = (away <= reach).all(axis=(1, 2))
        if near.any():
            half = np.maximum(half, away[near].max(axis=(0, 1)))
    return half


def _calm(middle: Floats, sides: Floats, step: float) -> Floats:
    """A middle that moves smoothly [m], shape [K, 3]."""
    for width in SOFT_S:
        calm = soft(middle, width / step)
        if float(np.abs(calm - middle).max()) <= STRAY * float(sides.max()):
            return calm
    return middle


_FACING = ("from_front", "from_behind")
_NOT_ALONG = (
    "follows", "medium", "close_up", "extreme_close_up", "overhead", "aerial", "from_front",
    "from_behind", "orbits",
)  # fmt: skip
"""Words that a camera keeps better which does not turn along with what goes by."""


def _turns_along(shot: Shot, subject: Subject) -> Floats | None:
    """What a camera stands off from that turns along with what goes by, or up [m], shape [3]."""
    if shot.says(*_NOT_ALONG):
        return None
    far = LONG_WAY * float(subject.size.max())
    middle = 0.5 * (subject.low.min(axis=0) + subject.high.max(axis=0))
    if shot.says("pans_left", "pans_right") and not shot.sided:
        return middle if float(np.linalg.norm(subject.way)) > far else None
    rise = float(subject.middle[-1, 2] - subject.middle[0, 2])
    if (shot.says("tilts_up") and rise > far) or (shot.says("tilts_down") and -rise > far):
        middle[2] = min(subject.middle[0, 2], subject.middle[-1, 2])
        return middle
    return None


def _has_bust(subject: Subject) -> bool:
    x, y, z = subject.size
    return len(subject.bodies) == 1 and z > UPRIGHT * max(x, y) and z > HUMAN_M / 2


def _follows(shot: Shot, subject: Subject) -> bool:
    if shot.says("static"):
        return False
    if shot.says("follows", "medium", "close_up", "extreme_close_up"):
        return True
    if shot.says("pans_left", "pans_right", "tilts_up", "tilts_down"):
        return False
    nearing = shot.says("zooms_in", "zooms_out", "moves_forward", "moves_backward")
    far = SOME_WAY if nearing else LONG_WAY
    return float(subject.sweep.max()) > far * float(subject.size.max())


def _best(shot: Shot, poses: Poses, subject: Subject, aspect: float) -> Way:
    """Of the places that the words allow the one from which most of it is seen."""
    frame = _frame(shot, poses, subject)
    best, most = None, -math.inf
    for cost, azimuth, elevation in _places(shot, subject, frame):
        if SIGHT - cost <= most + 1e-9:
            continue  # full sight would be worth no more
        way = _moved(shot, poses, frame, azimuth, elevation, aspect)
        worth = SIGHT * clear_share(poses, subject, way.eye) - cost
        if worth > most + 1e-9:
            best, most = way, worth
    assert best is not None
    return best


def _places(
    shot: Shot, subject: Subject, frame: _Frame
) -> Iterator[tuple[float, Floats | float, float]]:
    """Costs, azimuths [rad] and elevations [rad] of places to stand, the usual one first."""
    table = rows()
    told = [e for word in shot.words for e in table[word].elevations_deg]
    high = [e for e in told if e > 50]
    rises = tuple(high or told)
    if shot.says("overhead"):
        rises = table["overhead"].elevations_deg
    rises = rises or STANDING_DEG[float(subject.size.max()) >= HUMAN_M]
    sides, turns = _sides(shot, subject, frame)
    for (k, side), turn, rise in itertools.product(enumerate(sides), turns, rises):
        cost = 0.0016 * abs(turn) + 0.004 * abs(rise - rises[0]) + OTHER_SIDE * k
        yield cost, side + math.radians(turn), math.radians(rise)


def _sides(
    shot: Shot, subject: Subject, frame: _Frame
) -> tuple[tuple[Floats | float, ...], tuple[int, ...]]:
    """Azimuths of the side that is said, and turns from it; from beside its way if none is."""
    front: Floats | float
    if frame.follows:
        front = np.unwrap(np.arctan2(subject.front[:, 1], subject.front[:, 0]))
    else:
        mean = subject.front.mean(axis=0)
        front = math.atan2(mean[1], mean[0])
    if frame.anchor is not None and shot.says("pans_left", "pans_right"):
        # From there it goes by to the side that the camera turns to.
        way = math.atan2(subject.way[1], subject.way[0])
        side = 1.0 if shot.says("pans_left") else -1.0
        return (way + side * math.pi / 2, way - side * math.pi / 2), NEAR_TURNS_DEG
    if shot.says("moves_left", "moves_right") and frame.follows and not shot.says(*_FACING):
        # What it goes along with moves to that side of the picture.
        way = math.atan2(subject.way[1], subject.way[0])
        side = -1.0 if shot.says("moves_right") else 1.0
        return (way + side * math.pi / 2, way - side * math.pi / 2), NEAR_TURNS_DEG
    if shot.says("from_front"):
        return (front,), NEAR_TURNS_DEG
    if shot.says("from_behind"):
        return (front + math.pi,), NEAR_TURNS_DEG
    if shot.says("from_side"):
        mean = math.atan2(*subject.front.mean(axis=0)[::-1])
        first = 1.0 if math.cos(mean) >= 0.0 else -1.0  # the viewer's (+Y) side
        return (front + first * math.pi / 2, front - first * math.pi / 2), NEAR_TURNS_DEG
    if shot.sided:
        return (math.pi / 2,), TURNS_DEG[:3]
    return (_beside(subject),), TURNS_DEG


def _beside(subject: Subject) -> float:
    """Azimuth beside its way, on the viewer's (+Y) side [rad]."""
    way = subject.way
    if float(np.linalg.norm(way)) < 0.2:
        way = subject.front[0]
    side = math.atan2(way[1], way[0]) + math.pi / 2
    return side + math.pi if math.sin(side) < -1e-6 else side


def _moved(
    shot: Shot,
    poses: Poses,
    frame: _Frame,
    azimuth: Floats | float,
    elevation: float,
    aspect: float,
) -> Way:
    """A way from a side: from so far away that it stays inside whatever the camera does."""
    whole = not shot.says("extreme_close_up")
    most = CUT if shot.says("close_up") else INSIDE
    away = _distance(frame, azimuth, elevation, aspect)
    way = _at(shot, poses, frame, azimuth, elevation, away)
    for _ in range(4):
        over = _overflow(way, frame, aspect) / most
        if not whole or over <= 1.0 + 1e-3:
            break
        away *= min(over, 2.0)
        way = _at(shot, poses, frame, azimuth, elevation, away)
    return way


def _distance(frame: _Frame, azimuth: Floats | float, elevation: float, aspect: float) -> float:
    """From where its box has the wanted fill [m]."""
    angles = np.atleast_1d(np.asarray(azimuth, float))
    first = angles[:: max(1, len(angles) // 8)]
    tan = math.tan(FOV_RAD / 2)
    away = 0.0
    for angle in first:
        right, up, back = _axes(float(angle), elevation)
        x, y, z = (np.abs(frame.box @ axis).max() for axis in (right, up, back))
        # The near face is what reaches farthest.
        away = max(away, z + max(x / (tan * aspect), y / tan) / frame.fill)
    return max(float(away), frame.least_m)


def _axes(azimuth: float, elevation: float) -> tuple[Floats, Floats, Floats]:
    c, s, ce, se = math.cos(azimuth), math.sin(azimuth), math.cos(elevation), math.sin(elevation)
    back = np.array([ce * c, ce * s, se])
    right = np.array([-s, c, 0.0])
    return right, np.cross(back, right), back


def _at(
    shot: Shot, poses: Poses, frame: _Frame, azimuth: Floats | float, elevation: float, away: float
) -> Way:
    """The way at a distance [m], with all moves that are said."""
    time, middle = poses.time_s, frame.middle
    foot = middle if frame.anchor is None else np.tile(frame.anchor, (len(time), 1))
    share = _eased(time)
    swing = 2.0 * share - 1.0
    angle = np.broadcast_to(np.asarray(azimuth, float), time.shape).copy()
    if shot.says("orbits"):
        lasts = float(time[-1] - time[0])
        # As it turns or moves, where that is said, too.
        sense = -1.0 if shot.says("pans_right", "moves_left") else 1.0
        turn = sense * max(min(ORBIT_RAD, ORBIT_RAD_S * lasts), ORBIT_LEAST_RAD)
        angle += turn * (np.linspace(0.0, 1.0, len(time)) - 0.5)
    reach = np.full(len(time), away)
    if shot.says("zooms_in", "moves_forward"):
        reach = away * (CLOSER + (1.0 - CLOSER) * share)
    if shot.says("zooms_out", "moves_backward"):
        reach = away * (1.0 + (CLOSER - 1.0) * share)
    arm = np.stack(
        [
            math.cos(elevation) * np.cos(angle),
            math.cos(elevation) * np.sin(angle),
            np.full(len(time), math.sin(elevation)),
        ],
        axis=1,
    )
    eye, target = foot + reach[:, None] * arm, middle.copy()
    right = np.stack([-np.sin(angle), np.cos(angle), np.zeros(len(time))], axis=1)
    for word, side in (("moves_right", 1.0), ("moves_left", -1.0)):
        if shot.says(word):
            shift = side * SHIFT * away * swing[:, None] * right
            turned = shot.says("pans_left", "pans_right")  # else one would undo the other
            eye, target = eye + shift, target + (1.0 if turned else SHIFT_TARGET) * shift
    for word, up in (("moves_up", share), ("moves_down", 1.0 - share)):
        if shot.says(word):
            eye = eye + np.outer(2.0 * SHIFT * away * up, (0.0, 0.0, 1.0))
    eye = _above(eye, frame)
    target = _turned(shot, eye, target, swing, along=frame.anchor is not None)
    return Way(time, eye, target, FOV_RAD)


def _turned(shot: Shot, eye: Floats, target: Floats, swing: Floats, *, along: bool) -> Floats:
    """The target of a camera that turns where it stands."""
    look = target - eye
    flat = np.linalg.norm(look[:, :2], axis=1)
    yaw, pitch = np.arctan2(look[:, 1], look[:, 0]), np.arctan2(look[:, 2], flat)
    away = np.linalg.norm(look, axis=1)
    for word, turn in (("pans_left", 1.0), ("pans_right", -1.0)):
        if shot.says(word) and not along:
            # Straight down a turn about the upright only rolls the picture.
            yaw = yaw + turn * PAN_RAD * swing / np.maximum(np.cos(pitch), 0.35)
    for word, turn in (("tilts_up", 1.0), ("tilts_down", -1.0)):
        if shot.says(word) and (not along or shot.says("pans_left", "pans_right")):
            pitch = np.clip(pitch + turn * TILT_RAD * swing, -1.5, 1.5)
    level = away * np.cos(pitch)
    return eye + np.stack([level * np.cos(yaw), level * np.sin(yaw), away * np.sin(pitch)], axis=1)


def _overflow(way: Way, frame: _Frame, aspect: float) -> float:
    """How far its box reaches from the middle of the picture at any instant; 1 is the edge."""
    look = way.target - way.eye
    back = -look / np.linalg.norm(look, axis=1, keepdims=True)
    right = np.stack([-back[:, 1], back[:, 0], np.zeros(len(back))], axis=1)
    right /= np.maximum(np.linalg.norm(right, axis=1, keepdims=True), 1e-9)
    up = np.cross(back, right)
    points = frame.middle[:, None] + frame.box[None] - way.eye[:, None]
    x, y, z = (np.einsum("kni,ki->kn", points, axis) for axis in (right, up, -back))
    if float(z.min()) < 1e-3:
        return 2.0
    tan = math.tan(way.fov / 2)
    return float(max((np.abs(x) / (z * tan * aspect)).max(), (np.abs(y) / (z * tan)).max()))


def _first_person(poses: Poses, subject: Subject) -> Way:
    """From the eyes of who acts, or above the roof of what drives, looking where it heads."""
    step = float(poses.time_s[1] - poses.time_s[0])
    front = soft(subject.front, SOFT_S[0] / step)
    front = front / np.maximum(np.linalg.norm(front, axis=1, keepdims=True), 1e-9)
    sides = subject.high - subject.low
    eye = subject.middle.copy()
    if poses.scene.bodies[subject.bodies[0]].wheeled:
        eye[:, 2] = subject.high[:, 2] + 0.12 * subject.size[2]
    else:
        # Before the face, or one would see the head from inside.
        reach = 0.5 * np.abs(front * sides[:, :2]).sum(axis=1) + 0.02
        eye[:, :2] += reach[:, None] * front
        eye[:, 2] = subject.low[:, 2] + HEAD * sides[:, 2]
    eye = soft(eye, SOFT_S[1] / step, goes_on=True)
    ahead = max(4.0, 4.0 * float(subject.size.max()))
    drop = 0.12 * ahead
    target = eye + np.concatenate([ahead * front, np.full((len(eye), 1), -drop)], axis=1)
    return Way(poses.time_s, eye, target, OWN_FOV_RAD)


def _over_shoulder(poses: Poses, subject: Subject) -> Way:
    """From behind and above one shoulder, looking where it heads."""
    step = float(poses.time_s[1] - poses.time_s[0])
    front = soft(subject.front, SOFT_S[0] / step)
    front = front / np.maximum(np.linalg.norm(front, axis=1, keepdims=True), 1e-9)
    right = np.stack([front[:, 1], -front[:, 0]], axis=1)
    size = float(subject.size.max())
    middle = _calm(subject.middle, subject.high - subject.low, step)
    level = middle[:, :2] - 1.1 * size * front + 0.3 * size * right
    height = middle[:, 2:] + 0.5 * float(subject.size[2]) + 0.1 * size
    eye = np.concatenate([level, height], axis=1)
    away = np.concatenate([middle[:, :2] + 2.0 * size * front, middle[:, 2:]], axis=1)
    return Way(poses.time_s, eye, away, FOV_RAD)


def _shaken(way: Way) -> Way:
    """The same from a hand: sums of sines that never agree, of the same size in every scene."""
    look = way.target - way.eye
    away = np.linalg.norm(look, axis=1)
    right = np.stack([look[:, 1], -look[:, 0], np.zeros(len(look))], axis=1)
    right /= np.maximum(np.linalg.norm(right, axis=1, keepdims=True), 1e-9)
    across, upright = (
        sum(np.sin(2 * math.pi * hz * way.time_s + k) for k, hz in enumerate(pair))
        for pair in SHAKE_HZ
    )
    shift = SHAKE_RAD * away[:, None] * (np.outer(across, (1, 1, 1)) * right)
    shift[:, 2] += SHAKE_RAD * away * upright
    return replace(way, target=way.target + shift)


def _above(eye: Floats, frame: _Frame) -> Floats:
    lowest = min(LOWEST_M, float(frame.half.max()))
    return np.concatenate([eye[:, :2], np.maximum(eye[:, 2:], lowest)], axis=1)


def _eased(times: Floats) -> Floats:
    share = (times - times[0]) / max(float(times[-1] - times[0]), 1e-9)
    return share * share * (3.0 - 2.0 * share)
