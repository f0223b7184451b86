"""How the scene is filmed, measured on the camera's way and its picture of what is filmed."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
import math

import numpy as np

from esg.filming.sight import clear_share
from esg.filming.subjects import poses_at, subject_of
from esg.filming.ways import Way, way_of
from esg.graph.filming import shot_of
from esg.graph.models import Filming, Predicate
from esg.metrics.binding import Binding
from esg.metrics.models import SuiteStatement
from esg.metrics.replay import Floats, Replay
from esg.metrics.statements.query import Kept
from esg.thresholds import (
    FILMED_ABOVE_DEG,
    FILMED_ACROSS,
    FILMED_AERIAL_DEG,
    FILMED_ALONG,
    FILMED_ASPECT,
    FILMED_AWAY_RATIO,
    FILMED_CLEAR_SHARE,
    FILMED_CLOSE,
    FILMED_EXTREME,
    FILMED_FAST,
    FILMED_GROWTH,
    FILMED_HIGH_DEG,
    FILMED_INSIDE_SHARE,
    FILMED_LEVEL_DEG,
    FILMED_LOW_DEG,
    FILMED_MEDIUM,
    FILMED_ORBIT_DEG,
    FILMED_OWN_DEG,
    FILMED_SHAKE_DEG,
    FILMED_SIDE_DEG,
    FILMED_SLOW,
    FILMED_STILL_DEG,
    FILMED_STILL_M,
    FILMED_TURN_DEG,
    FILMED_WIDE,
)
from esg.units import quat_rotate

VIEWERS = frozenset({"left", "right", "front", "back"})
"""Directions that are the viewer's."""
SIDES = frozenset({Predicate.LEFT_OF, Predicate.RIGHT_OF, Predicate.IN_FRONT_OF, Predicate.BEHIND})


def planned(
    statements: Sequence[SuiteStatement], bindings: Mapping[str, Binding], replay: Replay
) -> Way | None:
    """The way of the camera that all statements of a scene tell together; None if none does.

    Args:
        statements: Of the scene.
        bindings: Of their phrases.
        replay: What happened.
    """
    told: list[tuple[Filming, tuple[int, ...]]] = [
        (s.filming, bindings.get(s.object or "", Binding("")).bodies)
        for s in statements
        if s.says is Predicate.FILMED and s.filming is not None
    ]
    sided = any(s.direction in VIEWERS or s.says in SIDES for s in statements)
    shot = shot_of(told, sided=sided)
    if shot is None or not replay.valid:
        return None
    return way_of(
        shot, replay.scene, replay.time, replay.position, replay.quaternion, FILMED_ASPECT
    )


@dataclass(frozen=True)
class Looked:
    """A camera's way beside what it films, at K instants.

    Args:
        replay: What happened.
        way: Of the camera.
        bodies: What is filmed.
    """

    replay: Replay
    way: Way
    bodies: tuple[int, ...]

    @cached_property
    def frames(self) -> list[int]:
        """Frames of the replay."""
        return [self.replay.frame_at(float(t)) for t in self.way.time_s]

    @cached_property
    def corners(self) -> Floats:
        """Of the boxes of what is filmed [m], shape [K, n, 3]."""
        signs = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (0, 2)], float)
        out: list[Floats] = []
        for i in self.bodies:
            b = self.replay.scene.bodies[i]
            local = signs * b.half_extents + np.asarray(b.origin_offset)
            turned = quat_rotate(
                np.repeat(self.replay.quaternion[self.frames, i][:, None], 8, axis=1),
                np.repeat(local[None], len(self.frames), axis=0),
            )
            out.append(self.replay.position[self.frames, i][:, None] + turned)
        return np.concatenate(out, axis=1)

    @cached_property
    def middle(self) -> Floats:
        """Of what is filmed [m], shape [K, 3]."""
        return 0.5 * (self.corners.min(axis=1) + self.corners.max(axis=1))

    @cached_property
    def look(self) -> Floats:
        """Where the camera looks, unit, shape [K, 3]."""
        way = self.way.target - self.way.eye
        return way / np.linalg.norm(way, axis=1, keepdims=True)

    @cached_property
    def right(self) -> Floats:
        """The camera's right, unit and level, shape [K, 3]."""
        side = np.stack([self.look[:, 1], -self.look[:, 0], np.zeros(len(self.look))], axis=1)
        return side / np.maximum(np.linalg.norm(side, axis=1, keepdims=True), 1e-9)

    @cached_property
    def rectangle(self) -> tuple[Floats, Floats]:
        """Corners around it in halves of the picture from the middle, shapes [K, 2]; NaN behind."""
        local = self.corners - self.way.eye[:, None]
        up = np.cross(self.right, self.look)
        x, y, z = (np.einsum("kni,ki->kn", local, axis) for axis in (self.right, up, self.look))
        z = np.where(z > 1e-3, z, np.nan)
        tan = math.tan(self.way.fov / 2)
        seen = np.stack([x / (z * tan * FILMED_ASPECT), y / (z * tan)], axis=-1)
        return seen.min(axis=1), seen.max(axis=1)

    @cached_property
    def inside(self) -> Floats:
        """Whether half of it is in the picture, or it takes half of that; shape [K]."""
        low, high = self.rectangle
        whole = np.nan_to_num(0.25 * (high - low).prod(axis=1), nan=np.inf)
        part = self.shares.prod(axis=1)
        large = (part > 0.0) & (self.shares.max(axis=1) >= 0.5)
        return ((part >= 0.5 * whole) | large).astype(float)

    @cached_property
    def shares(self) -> Floats:
        """Shares of the picture's width and height that it takes, 1 at most, shape [K, 2]."""
        low, high = self.rectangle
        cut = np.clip(high, -1.0, 1.0) - np.clip(low, -1.0, 1.0)
        return np.nan_to_num(0.5 * cut)

    @cached_property
    def away(self) -> Floats:
        """Distance from the eye to the middle of it [m], shape [K]."""
        return np.linalg.norm(self.way.eye - self.middle, axis=1)

    @cached_property
    def elevation(self) -> Floats:
        """By how much the camera looks down [deg], shape [K]."""
        return -np.degrees(np.arcsin(np.clip(self.look[:, 2], -1.0, 1.0)))

    @property
    def yaw(self) -> float:
        """How far the camera turns to the left [deg]."""
        turned = np.unwrap(np.arctan2(self.look[:, 1], self.look[:, 0]))
        return math.degrees(turned[-1] - turned[0])

    @property
    def pitch(self) -> float:
        """How far the camera turns up [deg]."""
        risen = np.arcsin(np.clip(self.look[:, 2], -1.0, 1.0))
        return math.degrees(risen[-1] - risen[0])

    def travel(self, axis: Floats) -> float:
        """How far the eye goes along an axis, in its distances at first."""
        moved = self.way.eye[-1] - self.way.eye[0]
        return float(moved @ axis / max(self.away[0], 1e-9))

    @property
    def path_m(self) -> float:
        """Length of the eye's way [m]."""
        return float(np.linalg.norm(np.diff(self.way.eye, axis=0), axis=1).sum())

    @cached_property
    def front(self) -> Floats:
        """Where it heads over the ground, unit, shape [K, 2]: by its way, or its own front."""
        b, body = self.replay.scene.bodies[self.bodies[0]], self.bodies[0]
        own = quat_rotate(
            self.replay.quaternion[self.frames, body],
            np.tile((1.0, 0.0, 0.0), (len(self.frames), 1)),
        )[:, :2]
        way = np.gradient(self.middle[:, :2], self.way.time_s, axis=0)
        pace = np.linalg.norm(way, axis=1, keepdims=True)
        travel = float(np.ptp(self.middle[:, :2], axis=0).max())
        size = float(np.ptp(self.corners[0], axis=0).max())
        if b.wheeled or travel < 0.5 * size:
            return own / np.maximum(np.linalg.norm(own, axis=1, keepdims=True), 1e-9)
        # Where it is slow its direction is not told.
        return np.where(pace > 0.3 * pace.max(), way / np.maximum(pace, 1e-9), np.nan)

    def bearing(self, vector: Floats) -> Floats:
        """Angles between its heading and vectors over the ground [deg], shape [K]."""
        flat = vector[:, :2] / np.maximum(
            np.linalg.norm(vector[:, :2], axis=1, keepdims=True), 1e-9
        )
        return np.degrees(np.arccos(np.clip((self.front * flat).sum(axis=1), -1.0, 1.0)))


Measure = Callable[[Looked], Kept]


def measure(replay: Replay, way: Way | None, s: SuiteStatement, bodies: tuple[int, ...]) -> Kept:
    """Whether the camera's way keeps a statement.

    Args:
        replay: What happened.
        way: Of the camera.
        s: The statement.
        bodies: What it is said of; empty for the scene.
    """
    if way is None or s.filming is None:
        return Kept(False, reason="there is nothing to film")
    if s.filming in ("slow_motion", "time_lapse"):
        return _rate(way, slow=s.filming == "slow_motion")
    moving = np.ptp(replay.position, axis=0).max(axis=1) > FILMED_STILL_M
    chosen = bodies or tuple(i for i in range(len(moving)) if moving[i])
    chosen = chosen or tuple(range(len(replay.scene.bodies)))
    looked = Looked(replay, way, chosen)
    if s.filming not in _UNSEEN and bodies:
        share = float(looked.inside.mean())
        if share < FILMED_INSIDE_SHARE:
            limit = f"limit {100 * FILMED_INSIDE_SHARE:.0f}%"
            reason = f"is in the picture for {100 * share:.0f}% of the time, {limit}"
            return Kept(False, {"inside_share": share}, reason)
        clear = _clear(replay, way, chosen)
        if clear < FILMED_CLEAR_SHARE:
            reason = f"is hidden for {100 * (1 - clear):.0f}% of the time, by what stands before it"
            return Kept(False, {"clear_share": clear}, reason)
    return _MEASURES[s.filming](looked)


def _clear(replay: Replay, way: Way, bodies: tuple[int, ...]) -> float:
    """Share of the lines of sight from the camera that nothing crosses."""
    step = float(way.time_s[1] - way.time_s[0])
    poses = poses_at(replay.scene, replay.time, replay.position, replay.quaternion, step)
    subject = subject_of(poses, bodies)
    return 1.0 if subject is None else clear_share(poses, subject, way.eye)


def _rate(way: Way, *, slow: bool) -> Kept:
    holds = way.rate <= FILMED_SLOW if slow else way.rate >= FILMED_FAST
    limit = FILMED_SLOW if slow else FILMED_FAST
    reason = f"{way.rate:.2f} s of the scene pass in a second of film; limit {limit:g} s"
    return Kept.when(holds, reason, rate=way.rate)


def _elevation(low: float, high: float) -> Measure:
    def within(v: Looked) -> Kept:
        angle = float(np.median(v.elevation))
        reason = f"the camera looks down by {angle:.0f} degrees; {low:g} to {high:g} asked"
        return Kept.when(low <= angle <= high, reason, elevation_deg=angle)

    return within


def _side(wanted: float) -> Measure:
    def stands(v: Looked) -> Kept:
        off = np.abs(v.bearing(v.way.eye - v.middle) - wanted)
        angle = float(np.nanmedian(off)) if np.isfinite(off).any() else math.nan
        reason = f"the camera stands {angle:.0f} degrees off that side; limit {FILMED_SIDE_DEG:g}"
        return Kept.when(angle <= FILMED_SIDE_DEG, reason, off_deg=angle)

    return stands


def _larger(least: float, most: float = 1.0) -> Measure:
    def fills(v: Looked) -> Kept:
        # By what it comes to where the camera comes nearer.
        share = float(np.quantile(v.shares.max(axis=1), 0.75))
        limits = f"{100 * least:.0f} to {100 * most:.0f}% asked"
        reason = f"it takes {100 * share:.0f}% of the picture; {limits}"
        return Kept.when(least <= share <= most, reason, picture_share=share)

    return fills


def _wide(v: Looked) -> Kept:
    share = float(np.median(np.sqrt(v.shares.prod(axis=1))))
    reason = f"it takes {100 * share:.0f}% of the picture; limit {100 * FILMED_WIDE:.0f}%"
    return Kept.when(share <= FILMED_WIDE, reason, picture_share=share)


def _in_view(v: Looked) -> Kept:
    share = float(v.inside.mean())
    reason = f"it is in the picture for {100 * share:.0f}% of the time"
    return Kept.when(share >= FILMED_INSIDE_SHARE, reason, inside_share=share)


def _follows(v: Looked) -> Kept:
    """It stays about as far off, and moves as what is filmed moves."""
    ratio = float(v.away.max() / max(v.away.min(), 1e-9))
    reason = f"its distance changes by {ratio:.1f} times; limit {FILMED_AWAY_RATIO:g}"
    if ratio > FILMED_AWAY_RATIO:
        return Kept(False, {"away_ratio": ratio}, reason)
    went = v.middle[-1] - v.middle[0]
    long = float(np.linalg.norm(went))
    if long < float(np.ptp(v.corners[0], axis=0).max()):
        return Kept(True, {"away_ratio": ratio})  # it hardly leaves its place
    share = v.path_m / long
    reason = f"the camera goes {100 * share:.0f}% as far; limit {100 * FILMED_ALONG:.0f}%"
    return Kept.when(share >= FILMED_ALONG, reason, away_ratio=ratio, along_share=share)


def _grows(sign: float) -> Measure:
    def zooms(v: Looked) -> Kept:
        low, high = v.rectangle
        size = np.linalg.norm(high - low, axis=1)
        growth = float((size[-1] / size[0]) ** sign)
        word = "grows" if sign > 0 else "shrinks"
        reason = f"it {word} {growth:.2f} times in the picture; limit {FILMED_GROWTH:g}"
        return Kept.when(growth >= FILMED_GROWTH, reason, growth=growth)

    return zooms


def _travels(axis: Callable[[Looked], Floats], nearing: float = 0.0) -> Measure:
    def goes(v: Looked) -> Kept:
        nearer = nearing * float(1.0 - v.away[-1] / max(v.away[0], 1e-9))
        way = max(v.travel(axis(v)), nearer if nearing else -math.inf)
        reason = f"the camera goes {way:.2f} of its distance that way; limit {FILMED_ACROSS:g}"
        return Kept.when(way >= FILMED_ACROSS, reason, travel=way)

    return goes


def _turns(sign: float, *, upward: bool) -> Measure:
    def turned(v: Looked) -> Kept:
        angle = sign * (v.pitch if upward else v.yaw)
        reason = f"the camera turns {angle:.0f} degrees that way; limit {FILMED_TURN_DEG:g}"
        return Kept.when(angle >= FILMED_TURN_DEG, reason, turned_deg=angle)

    return turned


def _orbits(v: Looked) -> Kept:
    arm = v.way.eye - v.middle
    around = np.unwrap(np.arctan2(arm[:, 1], arm[:, 0]))
    turned = abs(float(around[-1] - around[0]))
    # What passes a standing camera is not gone around.
    angle = math.degrees(
        min(turned, 2.0 * v.path_m / max(float(np.hypot(arm[:, 0], arm[:, 1]).mean()), 1e-9))
    )
    reason = f"the camera goes {angle:.0f} degrees around it; limit {FILMED_ORBIT_DEG:g}"
    return Kept.when(angle >= FILMED_ORBIT_DEG, reason, around_deg=angle)


def _still(v: Looked) -> Kept:
    moved = float(np.ptp(v.way.eye, axis=0).max())
    turned = float(np.degrees(np.arccos(np.clip(v.look @ v.look[0], -1.0, 1.0)).max()))
    reason = f"the camera moves {moved:.2f} m and turns {turned:.1f} degrees"
    holds = moved <= FILMED_STILL_M and turned <= FILMED_STILL_DEG
    return Kept.when(holds, reason, moved_m=moved, turned_deg=turned)


def _shakes(v: Looked) -> Kept:
    """What is left of its turning when the calm part of it is taken off."""
    low, high = FILMED_SHAKE_DEG
    kernel = np.ones(9) / 9.0
    calm = np.stack([np.convolve(c, kernel, "valid") for c in v.look.T], axis=1)
    off = v.look[4:-4] - calm if len(v.look) > 8 else v.look - v.look.mean(axis=0)
    shake = float(np.degrees(np.sqrt((off**2).sum(axis=1).mean())))
    reason = f"the camera shakes by {shake:.2f} degrees; {low:g} to {high:g} asked"
    return Kept.when(low <= shake <= high, reason, shake_deg=shake)


def _first_person(v: Looked) -> Kept:
    """The eye goes along at its head and looks where it heads."""
    size = np.ptp(v.corners, axis=1)
    near = np.linalg.norm((v.way.eye - v.middle)[:, :2], axis=1) / size.max(axis=1)
    bottom, top = v.corners[..., 2].min(axis=1), v.corners[..., 2].max(axis=1)
    height = float(np.median((v.way.eye[:, 2] - bottom) / np.maximum(top - bottom, 1e-9)))
    off = float(np.nanmedian(v.bearing(v.look)))
    reason = (
        f"the eye is {float(np.median(near)):.1f} sizes from its middle, at {100 * height:.0f}% "
        f"of its height, and looks {off:.0f} degrees off where it heads"
    )
    holds = float(np.median(near)) <= 0.75 and 0.5 <= height <= 1.5 and off <= FILMED_OWN_DEG
    return Kept.when(holds, reason, height_share=height, off_deg=off)


def _over_shoulder(v: Looked) -> Kept:
    """The eye goes along behind it, over its middle, near."""
    behind = _side(180.0)(v)
    away = float(np.median(v.away / np.ptp(v.corners, axis=1).max(axis=1)))
    higher = bool(np.median(v.elevation) > 0.0)
    if not behind.kept:
        return behind
    reason = f"the camera is {away:.1f} sizes away"
    return Kept.when(higher and away <= 3.0, reason, **behind.measured, sizes_away=away)


_UP = np.array([0.0, 0.0, 1.0])
_UNSEEN = frozenset({"first_person"})
"""Who sees is not seen."""
_MEASURES: dict[str, Measure] = {
    "overhead": _elevation(FILMED_ABOVE_DEG, 90.0),
    "aerial": _elevation(FILMED_AERIAL_DEG, 90.0),
    "high_angle": _elevation(FILMED_HIGH_DEG, 90.0),
    "low_angle": _elevation(-90.0, FILMED_LOW_DEG),
    "eye_level": _elevation(-FILMED_LEVEL_DEG, FILMED_LEVEL_DEG),
    "from_front": _side(0.0),
    "from_behind": _side(180.0),
    "from_side": _side(90.0),
    "first_person": _first_person,
    "over_shoulder": _over_shoulder,
    "extreme_close_up": _larger(FILMED_EXTREME),
    "close_up": _larger(FILMED_CLOSE),
    "medium": _larger(*FILMED_MEDIUM),
    "wide": _wide,
    "in_view": _in_view,
    "follows": _follows,
    "zooms_in": _grows(1.0),
    "zooms_out": _grows(-1.0),
    "moves_forward": _travels(lambda v: v.look.mean(axis=0), 1.0),
    "moves_backward": _travels(lambda v: -v.look.mean(axis=0), -1.0),
    "moves_left": _travels(lambda v: -v.right.mean(axis=0)),
    "moves_right": _travels(lambda v: v.right.mean(axis=0)),
    "moves_up": _travels(lambda _: _UP),
    "moves_down": _travels(lambda _: -_UP),
    "pans_left": _turns(1.0, upward=False),
    "pans_right": _turns(-1.0, upward=False),
    "tilts_up": _turns(1.0, upward=True),
    "tilts_down": _turns(-1.0, upward=True),
    "orbits": _orbits,
    "static": _still,
    "handheld": _shakes,
}
"""How each way to film is measured."""
