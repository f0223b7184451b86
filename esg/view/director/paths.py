"""What each kind of camera does during a take."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.units import quat_rotate
from esg.view.camera import Camera
from esg.view.director.acting import AFTER_S, Action, Beat
from esg.view.director.lens import (
    LOWEST_M,
    SAFE,
    View,
    extent,
    framed,
)
from esg.view.director.takes import Take, standing

Floats = NDArray[np.float64]
Path = Callable[[Action, Floats, View], "Take | None"]

KNOT_S = 1.0 / 12.0
FINE_HZ = 96.0
SOFT_S = (0.25, 0.4, 0.65, 1.0)
"""A camera that follows is slowed by a bell so wide [s]; a wider one where it would jerk."""
KEPT_S = ((0.7, 0.5), (0.4, 0.4), (0.2, 0.25), (0.08, 0.1), (0.0, 0.0))
"""A standing camera keeps in view what acts so long before and after every beat: as long as it can
be large enough."""
FILL_STANDING = 0.3
"""As large as who acts should be at every beat where the camera stands still."""
PUSH = 1.35
"""A dolly starts so many times as far away as it ends."""
SWING_RAD = math.radians(26)
"""An orbit turns so far to either side."""
TURN_MOST, TURN_JERK = math.radians(75), math.radians(260)
"""A camera turns at most so fast [rad/s], and gains at most so much of it a second [rad/s^2]."""
SPEED_JERK = 8.0
"""It gains at most so many distances to what it films a second, a second [1/s^2]."""


def static(action: Action, times: Floats, view: View) -> Take | None:
    """Stands still and keeps the action in view, as long of it as is large enough."""
    beats = beats_in(action, times)
    best: Camera | None = None
    for before, after in KEPT_S:
        camera = framed(_kept(action, beats, times, before, after), view)
        best = camera
        fills = [extent(camera, action.acting(b.time_s, b), view.aspect).fill for b in beats]
        if min(fills) >= FILL_STANDING:
            break
    return standing(best, times) if best is not None else None


def tracking(action: Action, times: Floats, view: View) -> Take | None:
    """Moves along with who acts, from one side."""
    cameras = [framed(action.acting(float(t)), view) for t in times]
    middle = np.array([action.acting(float(t)).mean(axis=0) for t in times])
    eye, target = np.array([c.eye for c in cameras]), np.array([c.target for c in cameras])
    arm, aim = eye - middle, target - middle
    away = np.linalg.norm(arm, axis=1)
    # Who rolls on after the last event is followed, not approached.
    over = times > action.beats[-1].time_s + AFTER_S
    if over.any() and not over.all():
        scale = np.where(over, np.maximum(away[~over][-1] / away, 1.0), 1.0)[:, None]
        arm, aim, away = arm * scale, aim * scale, away * scale[:, 0]
    for soft in SOFT_S:
        take = _followed(times, middle, arm, aim, away, soft, view)
        take = _contained(action, take, view)
        if is_smooth(take):
            return take
    return None


def dolly(action: Action, times: Floats, view: View) -> Take | None:
    """Comes closer in a straight line while the action unfolds."""
    take = static(action, times, view)
    if take is None:
        return None
    share = _eased(times)[:, None]
    arm = take.eye - take.target
    eye = take.target + arm * (PUSH + (1.0 - PUSH) * share)
    return replace(take, kind="dolly", eye=_above(eye))


def orbit(action: Action, times: Floats, view: View) -> Take | None:
    """Swings around the middle of the action."""
    take = static(action, times, view)
    if take is None:
        return None
    middle = _kept(action, beats_in(action, times), times, *KEPT_S[1]).mean(axis=0)
    angle = SWING_RAD * (2.0 * _eased(times) - 1.0)
    cos, sin = np.cos(angle), np.sin(angle)

    def swung(points: Floats) -> Floats:
        x, y = points[:, 0] - middle[0], points[:, 1] - middle[1]
        return np.stack(
            [middle[0] + cos * x - sin * y, middle[1] + sin * x + cos * y, points[:, 2]], axis=1
        )

    # On a rail around the middle, so that turning does not push anything out of the picture.
    take = replace(take, kind="orbit", eye=swung(take.eye), target=swung(take.target))
    return _contained(action, take, view)


def dash(action: Action, times: Floats, view: View) -> Take | None:
    """Rides on a vehicle and looks ahead; None where no vehicle drives."""
    scene, rollout = action.scene, action.rollout
    span = (action.time >= times[0]) & (action.time <= times[-1])
    way = np.nan_to_num(rollout.linear_velocity[0, span]).astype(float)
    driven = np.linalg.norm(way, axis=-1).mean(axis=0)
    vehicles = [i for i, b in enumerate(scene.bodies) if b.wheels and driven[i] > 0.5]
    if not vehicles:
        return None
    body = max(vehicles, key=lambda i: float(driven[i]))
    frames = [action.frame(float(t)) for t in times]
    p = rollout.position[0, frames, body].astype(float)
    q = rollout.quaternion[0, frames, body].astype(float)
    b = scene.bodies[body]
    # Above the roof, where nothing of the vehicle hides the road.
    seat = np.add(b.origin_offset, (0.25 * b.half_extents[0], 0, 2.0 * b.half_extents[2] + 0.3))
    knots = max((times[-1] - times[0]) / max(len(times) - 1, 1), 1e-6)
    eye = _soft(p + quat_rotate(q, np.tile(seat, (len(p), 1))), 0.12 / knots)
    ahead = quat_rotate(q, np.tile((1.0, 0.0, 0.0), (len(p), 1)))
    ahead = _soft(ahead * (1, 1, 0), 0.3 / knots)
    ahead = ahead / np.maximum(np.linalg.norm(ahead, axis=1, keepdims=True), 1e-6)
    target = eye + 12.0 * ahead - np.array([0.0, 0.0, 2.2])
    return Take("dash", times, _above(eye), target, max(view.fov, math.radians(52)))


KINDS: dict[str, Path] = {
    "static": static,
    "tracking": tracking,
    "dolly": dolly,
    "orbit": orbit,
    "dash": dash,
}
"""All ways to film, by name."""


def beats_in(action: Action, times: Floats) -> list[Beat]:
    """The beats between the first and the last of some times; the one whose turn it is if none."""
    found = [b for b in action.beats if times[0] - 1e-6 <= b.time_s <= times[-1] + 1e-6]
    return found or [action.beat_at(float(times[len(times) // 2]))]


def knots(start: float, end: float) -> Floats:
    """Instants at which a take is planned [s]."""
    return np.linspace(start, end, max(2, 1 + math.ceil((end - start) / KNOT_S)))


def is_smooth(take: Take) -> bool:
    """Whether a take keeps the bounds on turning and on gaining speed."""
    # Between the knots, too: slow motion shows what is there.
    steps = max(2, 1 + round((take.time_s[-1] - take.time_s[0]) * FINE_HZ))
    fine = take.at(np.linspace(take.time_s[0], take.time_s[-1], steps))
    turn, gain, speed = motion_of(fine)
    return turn <= TURN_MOST and gain <= TURN_JERK and speed <= SPEED_JERK


def motion_of(take: Take) -> tuple[float, float, float]:
    """How roughly a camera moves.

    Returns:
        Its fastest turn [rad/s], the most that it gains of it [rad/s^2], and the most speed that
        the eye gains in distances to its target [1/s^2].
    """
    if len(take) < 3:
        return 0.0, 0.0, 0.0
    step = np.diff(take.time_s)
    look = take.target - take.eye
    away = np.linalg.norm(look, axis=1)
    look = look / away[:, None]
    turn = np.diff(look, axis=0) / step[:, None]
    speed = np.diff(take.eye, axis=0) / step[:, None]
    pause = 0.5 * (step[1:] + step[:-1])
    gain = np.linalg.norm(np.diff(turn, axis=0), axis=1) / pause
    rush = np.linalg.norm(np.diff(speed, axis=0), axis=1) / pause / away[1:-1]
    return float(np.linalg.norm(turn, axis=1).max()), float(gain.max()), float(rush.max())


def _kept(action: Action, beats: list[Beat], times: Floats, before: float, after: float) -> Floats:
    """What acts around the beats, within the take [m], shape [n, 3]."""
    out: list[Floats] = []
    for beat in beats:
        steps = max(1, round((before + after) / 0.1))
        for time in np.linspace(beat.time_s - before, beat.time_s + after, steps + 1):
            out.append(action.acting(float(np.clip(time, times[0], times[-1])), beat))
    return np.concatenate(out)


def _followed(
    times: Floats, middle: Floats, arm: Floats, aim: Floats, away: Floats, soft: float, view: View
) -> Take:
    """A camera on an arm from the smoothed middle; the arm is as long as the longest nearby."""
    width = soft / max(float(times[1] - times[0]), 1e-6)
    longest = _most(away, width)
    scale = _soft(longest, width) / away
    center = _soft(middle, width)
    eye = center + _soft(arm * scale[:, None], width)
    target = center + _soft(aim * scale[:, None], width)
    return Take("tracking", times, _above(eye), target, view.fov)


def _contained(action: Action, take: Take, view: View) -> Take:
    """The same take from so much farther away that who acts stays inside at every instant."""
    for _ in range(3):
        over = np.array(
            [
                extent(take.camera(k), action.acting(float(t)), view.aspect).overflow / SAFE
                for k, t in enumerate(take.time_s)
            ]
        )
        over = np.clip(np.nan_to_num(over, posinf=4.0), 1.0, 4.0)
        if float(over.max()) <= 1.0 + 1e-3:
            break
        width = 0.25 / max(float(take.time_s[1] - take.time_s[0]), 1e-6)
        away = _soft(_most(over, 3 * width), width)
        eye = take.target + (take.eye - take.target) * away[:, None]
        take = replace(take, eye=_above(eye))
    return take


def _most(values: Floats, width: float) -> Floats:
    # Imported where a film is directed: who only makes a sheet needs no scipy for it.
    from scipy.ndimage import maximum_filter1d

    return maximum_filter1d(values, max(1, round(width)), mode="nearest")


def _soft(values: Floats, width: float) -> Floats:
    from scipy.ndimage import gaussian_filter1d

    return gaussian_filter1d(values, max(width, 1e-3), axis=0, mode="nearest")


def _eased(times: Floats) -> Floats:
    share = (times - times[0]) / max(float(times[-1] - times[0]), 1e-9)
    return share * share * (3.0 - 2.0 * share)


def _above(eye: Floats) -> Floats:
    return np.concatenate([eye[:, :2], np.maximum(eye[:, 2:], LOWEST_M)], axis=1)
