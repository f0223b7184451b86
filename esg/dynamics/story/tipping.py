"""Whether and how fast a hit tips a standing body over: its centre of mass, its base, the height.

A planar impact of two rigid bodies, of which the struck one stands on the ground. Its state after
the hit are the speed of its centre and its turning rate about the edge that stays on the ground;
that edge slides against Coulomb friction, or holds where friction suffices. A hit above the centre
of mass tips a body over its far edge; one well below kicks its base away, so that it tips
back over its near edge, while friction slows the base down and rights it again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.story.stagecraft import Prop
from esg.graph.models import AssetConfiguration, Proxy, ProxyKind
from esg.thresholds import SAFE_TOPPLED_DEG
from esg.units import GRAVITY_MPS2, quat_rotate

MARGIN = 1.3
"""Over the speed of the closed form."""
TOPPLED_RAD = math.radians(SAFE_TOPPLED_DEG)
"""Tilt that counts as toppled, where a broad base would still fall back."""
FLIES_AT = 0.7
"""Share of its height at which something thrown hits a body."""
RIGHTING = 0.5
"""Share of the way back over the near edge during which friction rights a body."""
TRIPS = 2.0
"""How much faster than against a kerb a body must be for friction alone to trip it."""
UNSURE = 0.04
"""How much lower than in the closed form a touch may be, as a share of the body's height."""
LEAST_KEPT = 0.2
"""Least share of its speed that a ball keeps when it hops over a rim."""
HOPS = 0.6
"""Share of a ball's height up to which it may meet a body."""
ROLLS = 2.0 / 7.0
"""Share of a ball's mass that a push along its surface has to turn."""
NEVER = 1e4
"""Speed [m/s] that stands for a hit that tips nothing over."""
FLAT_M = 0.003
"""Surfaces this close to the first touch take part in it."""
HEIGHTS, SIDES = 160, 24
FOOT = 0.03
"""Share of its height up to which a body stands on the ground."""

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Stand:
    """How a body stands, seen across the path of what hits it (SI).

    Args:
        height: Of its centre of mass [m].
        far: From the centre of mass to the far edge of its base [m].
        near: To the near edge [m].
        gyration: Inertia about the centre per mass [m^2].
        outlines: Per part, corners (way along the path from the centre, height) [m], shape [n, 2].
        top: Its height [m].
    """

    height: float
    far: float
    near: float
    gyration: float
    outlines: tuple[Floats, ...]
    top: float

    def scaled(self, factor: float) -> Stand:
        """The same body at another size."""
        return Stand(
            factor * self.height,
            factor * self.far,
            factor * self.near,
            factor**2 * self.gyration,
            tuple(factor * o for o in self.outlines),
            factor * self.top,
        )


@dataclass(frozen=True)
class Touch:
    """Where something first meets a standing body.

    Args:
        height: Over the ground [m].
        along: Way from the body's centre [m].
        normal: Into the body (along, up).
        push: Impulse per impulse along the normal, friction included: what rolls presses down.
    """

    height: float
    along: float
    normal: tuple[float, float]
    push: tuple[float, float] | None = None

    @property
    def impulse(self) -> tuple[float, float]:
        return self.push or self.normal


def stand_of(body: Prop) -> Stand:
    """How a body stands that is met as a target is placed: broadside, else from its front."""
    config = body.config
    if config is None or not config.proxies:
        half = 0.5 * min(body.length, body.width)
        box = np.array([[x, z] for x in (-half, half) for z in (0.0, body.height)])
        gyration = (4.0 * half * half + body.height**2) / 12.0
        return Stand(0.5 * body.height, half, half, gyration, (box,), body.height)
    broadside = body.length > 1.15 * body.width
    way = np.array([0.0, 1.0]) if broadside else np.array([-1.0, 0.0])
    com = np.array(config.center_of_mass_cm) / 100.0
    ixx, iyy = config.inertia_kg_cm2[:2]
    gyration = 1e-4 * (ixx if broadside else iyy) / max(config.mass_kg, 1e-9)
    parts = [_outline(p, way) for p in config.proxies]
    shift = np.array([float(way @ com[:2]), 0.0])
    parts = [p - shift for p in parts]
    corners = np.concatenate(parts)
    top = float(corners[:, 1].max())
    feet = corners[corners[:, 1] <= corners[:, 1].min() + FOOT * top, 0]
    return Stand(
        max(float(com[2]), 1e-3),
        max(float(feet.max()), 1e-3),
        max(-float(feet.min()), 1e-3),
        max(gyration, 1e-6),
        tuple(parts),
        top,
    )


def _outline(proxy: Proxy, way: Floats) -> Floats:
    """Points of a collision shape (along `way`, height) [m], shape [n, 2]."""
    a, b, c = proxy.size_cm
    turns = 2.0 * math.pi * np.arange(SIDES) / SIDES
    ring = np.stack([np.cos(turns), np.sin(turns), np.zeros(SIDES)], axis=1)
    if proxy.vertices_cm:
        local = np.array(proxy.vertices_cm, float)
    elif proxy.kind is ProxyKind.BOX:
        signs = np.array([[i, j, k] for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)], float)
        local = signs * np.array([a, b, c])
    elif proxy.kind is ProxyKind.CYLINDER:
        local = np.concatenate([a * ring + [0.0, 0.0, s * c] for s in (-1, 1)])
    else:
        latitude = math.pi * (np.arange(9) / 8.0 - 0.5)
        cap = 0.0 if proxy.kind is ProxyKind.SPHERE else c
        local = np.concatenate(
            [
                a * math.cos(t) * ring + [0.0, 0.0, a * math.sin(t) + math.copysign(cap, t)]
                for t in latitude
            ]
        )
    points = quat_rotate(np.array(proxy.orientation_xyzw), local) + np.array(proxy.position_cm)
    return np.stack([points[:, :2] @ way, points[:, 2]], axis=1) / 100.0


def _side(outlines: tuple[Floats, ...], heights: Floats, *, front: bool) -> Floats:
    """Outermost way at every height, of the front or the near side; without a part there, inf."""
    sign = -1.0 if front else 1.0
    best = np.full(len(heights), np.inf)
    for part in outlines:
        s, z = sign * part[:, 0], part[:, 1]
        i, j = np.nonzero(z[:, None] < z[None, :] - 1e-9)
        level, rise = z[i][:, None], (z[j] - z[i])[:, None]
        share = (heights[None, :] - level) / rise
        at = s[i][:, None] + share * (s[j] - s[i])[:, None]
        best = np.minimum(best, np.where((share >= 0.0) & (share <= 1.0), at, np.inf).min(axis=0))
    return best


def first_touch(mover: Prop, target: Prop, stand: Stand, *, flies: bool) -> Touch | None:
    """Where a mover on the ground, or something thrown, meets a standing body; None if nowhere."""
    if flies:
        return Touch(FLIES_AT * stand.top, -stand.near, (1.0, 0.0))
    reach = min(mover.height + mover.lift, stand.top)
    heights = (np.arange(HEIGHTS) + 0.5) * reach / HEIGHTS
    rear = _side(stand.outlines, heights, front=False)
    radius = 0.5 * mover.height
    if mover.rolls:
        nose = np.sqrt(np.maximum(radius**2 - (heights - radius) ** 2, 0.0))
    else:
        nose = _nose(mover.config, heights - mover.lift)
    gap = rear - nose
    if not np.isfinite(gap).any():
        return None
    close = np.flatnonzero(gap <= gap.min() + FLAT_M)
    k = int(close[len(close) // 2])
    if mover.lift > 0.0:
        # A leaf lies along it: where it can turn neither way, it does not.
        k = int(close[np.argmin(np.abs(heights[close] - stand.height))])
    z, x = float(heights[k]), float(rear[k])
    if mover.rolls:
        k = int(np.argmin(gap))
        z, x = float(heights[k]), float(rear[k])
        sine = (z - radius) / radius
        nx, nz = math.sqrt(max(1.0 - sine * sine, 0.0)), sine
        drag = _drag(mover, target)
        return Touch(z, x, (nx, nz), (nx + drag * nz, nz - drag * nx))
    return Touch(z, x, (1.0, 0.0))


def _drag(mover: Prop, target: Prop) -> float:
    """Downward impulse of friction per normal impulse of a rolling ball, whose front goes down.

    Coulomb's limit, or what ends its slip: 2/7 of a ball's mass is felt at its surface.
    """
    gain = 1.0 + 0.5 * (mover.restitution + target.restitution)
    ends = ROLLS * (1.0 + mover.mass / target.mass) / gain
    return min(0.5 * (mover.friction + target.friction), ends)


def _nose(config: AssetConfiguration | None, heights: Floats) -> Floats:
    """Foremost way at every height of a body that drives ahead; -inf where it has no part."""
    if config is None or not config.proxies:
        return np.zeros(len(heights))
    way = np.array([1.0, 0.0])
    parts = tuple(_outline(p, way) for p in config.proxies)
    return -_side(parts, heights, front=True)


def tip_speed(mover: Prop, target: Prop, stand: Stand, touch: Touch) -> float:
    """Least speed [m/s] of a hit that tips a body over, without a margin; `NEVER` if none does."""
    friction = 0.5 * (target.friction + target.ground)
    best = NEVER
    for w, sign in ((stand.far, 1.0), (stand.near, -1.0)):
        if sign < 0.0 and mover.lift > 0.0:
            continue  # not back onto a leaf that goes on
        grip = sign * friction * stand.height
        ahead, rate = _pushed(target.mass, stand, touch, w, sign, grip)
        held = sign > 0.0 and ahead < rate * stand.height
        if not held:
            rise = 0.0 if sign > 0.0 else RIGHTING * friction * stand.height
            best = min(best, _speed(mover, target, stand, touch, w, sign, rise, (ahead, rate)))
        if held or grip > w:
            # The edge holds, or the body slides until friction trips it over its base.
            inertia = target.mass * (stand.gyration + w * w + stand.height**2)
            dx, dz = touch.impulse
            rate = (touch.height * dx + (w - touch.along) * dz) / inertia
            motion = rate * stand.height, rate
            speed = _speed(mover, target, stand, touch, w, sign, 0.0, motion, held=True)
            best = min(best, speed if held else TRIPS * speed)
    return best


def _pushed(
    mass: float, stand: Stand, touch: Touch, w: float, sign: float, grip: float
) -> tuple[float, float]:
    """Speed and turning rate after a unit impulse along the normal, the edge at `w` sliding.

    The ground answers there with V = mass w rate - dz upwards and friction mu V.
    """
    dx, dz = touch.impulse
    slide = mass * (stand.gyration + w * (w - grip))
    if slide <= 1e-12:
        return dx / mass, 0.0
    torque = sign * ((touch.height - stand.height) * dx - touch.along * dz)
    rate = (torque + (w - grip) * dz) / slide
    pressed = max(mass * w * rate - dz, 0.0)
    return (dx - abs(grip) / stand.height * pressed) / mass, rate


def _speed(
    mover: Prop,
    target: Prop,
    stand: Stand,
    touch: Touch,
    w: float,
    sign: float,
    righting: float,
    motion: tuple[float, float],
    *,
    held: bool = False,
) -> float:
    """Speed [m/s] at which the turning that a hit causes lifts the centre over the edge at `w`.

    Args:
        righting: Work of friction against it per weight and angle [m].
        motion: Speed and turning rate of a unit impulse.
        held: Whether the edge does not slide.
    """
    ahead, rate = motion
    if rate <= 1e-9:
        return NEVER
    nx, nz = touch.normal
    c, mass = stand.height, target.mass
    inertia = mass * (stand.gyration + w * w + (c * c if held else 0.0))
    angle = min(math.atan2(w, c), TOPPLED_RAD)
    rise = w * math.sin(angle) + c * math.cos(angle) - c + righting * angle
    lift = touch.height - c
    answer = nx * (ahead + sign * rate * lift) + nz * rate * (w - sign * touch.along)
    gain = 1.0 + 0.5 * (mover.restitution + target.restitution)
    impulse = gain * nx / (1.0 / mover.mass + max(answer, 0.0))
    return math.sqrt(2.0 * mass * GRAVITY_MPS2 * rise / inertia) / max(impulse * rate, 1e-9)


def topple_speed(mover: Prop, target: Prop, *, flies: bool, stand: Stand | None = None) -> float:
    """Speed [m/s] of a hit that surely tips a resting body over; 0 for what cannot be tipped.

    Engines differ in the height of a touch, which matters close to the centre of mass.
    """
    if target.fixed or target.rolls:
        return 0.0
    stand = stand or stand_of(target)
    touch = first_touch(mover, target, stand, flies=flies)
    if touch is None:
        return NEVER
    low = 0.0 if flies else UNSURE * stand.top
    touches = (touch, replace(touch, height=max(touch.height - low, 0.0)))
    return MARGIN * max(tip_speed(mover, target, stand, t) for t in touches)


def topples_by_push(mover: Prop, target: Prop) -> bool:
    """Whether what is driven on against a standing body tips it over, however slowly: a boom.

    Its foot holds where friction times the height of the touch is more than from its middle to the
    far edge of its base, and is not pushed along where nothing of the mover follows below.
    """
    if target.fixed or target.rolls:
        return False
    stand = stand_of(target)
    touch = first_touch(mover, target, stand, flies=False)
    grip = 0.5 * (target.friction + target.ground)
    if touch is None or grip * (touch.height - UNSURE * stand.top) < MARGIN * stand.far:
        return False
    low = (np.arange(HEIGHTS) + 0.5) * 0.5 * touch.height / HEIGHTS
    gap = _side(stand.outlines, low, front=False)
    gap -= _nose(mover.config, low - mover.lift)
    recess = float((gap[np.isfinite(gap)] + stand.top).min(initial=np.inf)) - stand.top
    first = touch.along - float(_nose(mover.config, np.array([touch.height - mover.lift]))[0])
    leans = touch.height * math.sin(math.atan2(stand.far, stand.height))
    return recess - first > leans


def least_topple_speed(mover: Prop, target: Prop, *, flies: bool) -> float:
    """Speed [m/s] below which no hit tips a resting body over, wherever the mover reaches it.

    A ball may hop over the rim of a base and meet the body a little above its own centre; what
    the rim took of its speed is gone.
    """
    if target.fixed or target.rolls:
        return 0.0
    stand = stand_of(target)
    touch = first_touch(mover, target, stand, flies=flies)
    if touch is None:
        return 0.0
    reach = HOPS * mover.height if mover.rolls else mover.height
    top = stand.top if flies else min(reach, stand.top)
    keeps = max(1.0 - touch.normal[0] ** 2, LEAST_KEPT) if mover.rolls and not flies else 1.0
    touch = replace(touch, push=None)
    best = tip_speed(mover, target, stand, touch)
    for z in np.linspace(touch.height, max(top, touch.height), 8):
        level = Touch(float(z), touch.along, (1.0, 0.0))
        best = min(best, tip_speed(mover, target, stand, level) / keeps)
    for share in (-0.1, 0.1):
        near = replace(touch, height=max(touch.height + share * stand.top, 0.0))
        best = min(best, tip_speed(mover, target, stand, near))
    return best
