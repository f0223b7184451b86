"""Closed-form motion used to choreograph a scene before it is simulated (SI, planar).

Sources: linear damping v' = -c v gives s = v/c (1 - exp(-c t)); head-on impact with restitution e
gives v_b = (1 + e) m_a / (m_a + m_b) v_a; Coulomb sliding stops after v^2 / (2 mu g).
"""

from __future__ import annotations

from dataclasses import dataclass, field
import math

import numpy as np

from esg.units import GRAVITY_MPS2


@dataclass(frozen=True)
class Ride:
    """Motion that gains or loses speed evenly down or up to one that it keeps.

    Args:
        first: Speed at the start [m/s].
        rate: At which it gains speed [m/s^2], negative for what slows down; infinite for what is
            under way.
        speed: In the end [m/s].
    """

    first: float
    rate: float
    speed: float

    @staticmethod
    def under_way(speed: float) -> Ride:
        """Motion at one speed [m/s]."""
        return Ride(speed, math.inf, speed)

    @property
    def gaining(self) -> float:
        """How long it gains or loses speed [s]."""
        return (self.speed - self.first) / self.rate

    def left(self, duration: float) -> float:
        """Speed [m/s] after a time [s]."""
        return self.speed if duration >= self.gaining else self.first + self.rate * duration

    def way(self, duration: float) -> float:
        """Way [m] in a time [s]."""
        part = min(duration, self.gaining)
        return 0.5 * (self.first + self.left(part)) * part + self.speed * (duration - part)

    def lasts(self, way: float) -> float:
        """Time [s] that a way [m] takes."""
        whole = self.way(self.gaining)
        if way >= whole:
            return self.gaining + (way - whole) / max(self.speed, 1e-6)
        return (math.sqrt(self.first**2 + 2.0 * self.rate * way) - self.first) / self.rate

    def until(self, speed: float) -> float:
        """Way [m] on which it gains a speed [m/s]."""
        return max(min(speed, self.speed) ** 2 - self.first**2, 0.0) / (2.0 * self.rate)


@dataclass
class Track:
    """State of one body along its planned path, in its own frame.

    Attributes:
        x, y: Position [m].
        heading: [rad].
        speed: [m/s].
        time: [s].
        points: Corners of the path so far [m].
        spin: Surface speed of its back spin [m/s].
    """

    x: float = 0.0
    y: float = 0.0
    heading: float = 0.0
    speed: float = 0.0
    time: float = 0.0
    spin: float = 0.0
    points: list[tuple[float, float]] = field(default_factory=lambda: [(0.0, 0.0)])

    def straight(self, distance: float, duration: float, speed: float) -> None:
        """Moves straight on and leaves with `speed`."""
        self.x += distance * math.cos(self.heading)
        self.y += distance * math.sin(self.heading)
        self.time += duration
        self.speed = speed
        self.points.append((self.x, self.y))

    def arc(self, angle: float, turn_rate: float, ride: Ride) -> None:
        """Turns by `angle` [rad] (positive left) at `turn_rate` > 0 [rad/s]."""
        steps = max(2, int(abs(angle) / 0.25))
        duration = abs(angle) / turn_rate / steps
        for k in range(steps):
            half = angle / steps / 2.0
            way = ride.way((k + 1) * duration) - ride.way(k * duration)
            chord = way * (math.sin(half) / half if abs(half) > 1e-9 else 1.0)
            self.heading += half
            self.x += chord * math.cos(self.heading)
            self.y += chord * math.sin(self.heading)
            self.heading += half
            self.points.append((self.x, self.y))
        self.time += abs(angle) / turn_rate
        self.speed = ride.left(abs(angle) / turn_rate)


@dataclass(frozen=True)
class Frame:
    """A planar rigid transform: rotation [rad], then translation [m]."""

    x: float = 0.0
    y: float = 0.0
    angle: float = 0.0

    def apply(self, x: float, y: float) -> tuple[float, float]:
        c, s = math.cos(self.angle), math.sin(self.angle)
        return self.x + c * x - s * y, self.y + s * x + c * y


def frame_mapping(
    point: tuple[float, float], heading: float, to: tuple[float, float], to_heading: float
) -> Frame:
    """The transform that takes `point` and `heading` to `to` and `to_heading`."""
    angle = to_heading - heading
    x, y = Frame(angle=angle).apply(*point)
    return Frame(to[0] - x, to[1] - y, angle)


def braked(speed: float, deceleration: float, duration: float) -> tuple[float, float]:
    """Way [m] and speed left [m/s] after a time [s] of constant deceleration [m/s^2]."""
    return (
        sliding_travel(speed, deceleration, duration),
        max(0.0, speed - deceleration * duration),
    )


def braking_distance(speed: float, damping: float, duration: float) -> float:
    """Distance travelled in `duration` under linear damping [m]."""
    if damping < 1e-9:
        return speed * duration
    return speed / damping * (1.0 - math.exp(-damping * duration))


def slowing(speed: float, damping: float, drag: float, duration: float) -> tuple[float, float]:
    """Way [m] and speed left [m/s] after `duration` of linear damping and Coulomb deceleration.

    v(t) = (v0 + a/c) exp(-c t) - a/c, until it rests.
    """
    if drag < 1e-6:
        return braking_distance(speed, damping, duration), speed * math.exp(-damping * duration)
    if damping < 1e-6:
        return sliding_travel(speed, drag, duration), max(0.0, speed - drag * duration)
    duration = min(duration, stopping_way(speed, damping, drag)[1])
    ends, fades = drag / damping, math.exp(-damping * duration)
    way = (speed + ends) * (1.0 - fades) / damping - ends * duration
    return way, max(0.0, (speed + ends) * fades - ends)


def stopping_way(speed: float, damping: float, drag: float) -> tuple[float, float]:
    """Distance [m] and time [s] to rest under linear damping and a Coulomb deceleration > 0."""
    if damping < 1e-6:
        return speed * speed / (2.0 * drag), speed / drag
    lasts = math.log1p(damping * speed / drag) / damping
    return speed / damping - drag / damping * lasts, lasts


def impact_speed(mass_a: float, mass_b: float, speed: float, restitution: float) -> float:
    """Speed of a resting body b after a central impact by a [m/s]."""
    return (1.0 + restitution) * mass_a / (mass_a + mass_b) * speed


def back_spin(mass_a: float, mass_b: float, speed: float, friction: float, hit: float) -> float:
    """Surface speed [m/s] against its way that a ball struck by a rolling ball gets.

    The rolling surface of a rubs downwards over b until both keep up or mu J is spent; on a
    uniform sphere a force at the surface turns 5/2 as fast as it moves.

    Args:
        mass_a: Of the rolling ball [kg].
        mass_b: Of the struck ball [kg].
        speed: Of the rolling ball [m/s].
        friction: Between them.
        hit: Speed of the struck ball after the hit [m/s].
    """
    keeps_up = speed / (3.5 * (1.0 / mass_a + 1.0 / mass_b))
    return 2.5 * min(friction * mass_b * hit, keeps_up) / mass_b


def rubbed(friction: float, restitution: float, hit: float, along: float) -> float:
    """Share of its speed along a surface that a solid ball without spin loses in a bounce.

    Friction takes mu (1 + e) of the speed of the hit, and no more than ends the slip: two sevenths.

    Args:
        friction: Between the two.
        restitution: Of the hit.
        hit: Speed towards the surface [m/s].
        along: Speed along the surface [m/s].
    """
    return min(friction * (1.0 + restitution) * hit / max(along, 1e-9), 2.0 / 7.0)


def off_a_wall(
    restitution: float, friction: float, tilt: float = 0.0, *, rolling: bool
) -> tuple[float, float]:
    """Shares of its speed with which a ball that hits a wall goes on away from it and along it.

    The front of a rolling ball rubs down the wall, which takes from its spin. What is left of that
    still rolls it forward: two sevenths, once the ground has turned it.

    Args:
        restitution: Of the hit.
        friction: Between the ball and the wall.
        tilt: Angle between its way and the wall's normal [rad].
        rolling: Whether it rolls; otherwise it has no spin.

    Returns:
        Away from the wall, negative if its spin presses it on, and along it.
    """
    hit, along = math.cos(tilt), math.sin(tilt)
    lost = rubbed(friction, restitution, hit, 1.0 if rolling else along)
    away, kept = restitution * hit, (1.0 - lost) * along
    if not rolling:
        return away, kept
    spin = (1.0 - 2.5 * lost) * hit
    return (5.0 * away - 2.0 * spin) / 7.0, (5.0 * kept + 2.0 * along) / 7.0


def sliding_travel(speed: float, drag: float, duration: float) -> float:
    """Distance [m] of what slides with a deceleration `drag` [m/s^2], if need be until it rests."""
    lasts = min(duration, speed / max(drag, 1e-6))
    return speed * lasts - 0.5 * drag * lasts * lasts


def rolling_travel(
    speed: float, friction: float, duration: float, spin: float = 0.0
) -> tuple[float, float]:
    """Distance [m] and speed [m/s] of a struck ball that slides at first, then rolls at 5/7.

    Args:
        speed: After the hit [m/s].
        friction: Of ball and ground.
        duration: [s].
        spin: Surface speed of its back spin [m/s], which costs another 2/7 of itself.
    """
    slows = friction * GRAVITY_MPS2
    until = min(duration, 2.0 / 7.0 * (speed + spin) / max(slows, 1e-6))
    left = speed - slows * until
    return (speed + left) * 0.5 * until + left * (duration - until), left


def sliding_distance(speed: float, friction: float) -> float:
    """Distance a body slides on level ground [m]."""
    return speed * speed / (2.0 * max(friction, 0.02) * GRAVITY_MPS2)


def ballistic_velocity(offset: np.ndarray, duration: float, damping: float = 0.0) -> np.ndarray:
    """Launch velocity [m/s] that covers `offset` [m] in `duration` [s] under gravity, shape [3].

    With linear damping c the velocity is v(t) = (v0 + g/c) exp(-c t) - g/c.
    """
    gravity = np.array([0.0, 0.0, -GRAVITY_MPS2])
    if damping < 1e-6:
        return np.asarray(offset, float) / duration - 0.5 * gravity * duration
    travel = braking_distance(1.0, damping, duration)
    return (np.asarray(offset, float) - gravity / damping * (duration - travel)) / travel


LOB_S = 0.6
"""Least flight time of a throw into an open container."""
LOB_STEEPNESS = 2.0
"""Fall per way on arrival of a throw into an open container, about 63 degrees."""


def lob_time(distance: float, drop: float = 0.0) -> float:
    """Flight time [s] of a throw that comes down steeply.

    On arrival it falls at g T / 2 + drop / T and travels at distance / T.

    Args:
        distance: Horizontal way [m].
        drop: Height lost on the way [m]; negative where it comes down higher than it started.
    """
    rest = max(LOB_STEEPNESS * distance - drop, 0.0)
    return max(LOB_S, math.sqrt(2.0 * rest / GRAVITY_MPS2))


def half_along(length: float, width: float, relative: float) -> float:
    """Half extent of an l x w rectangle along a direction at angle `relative` to its length."""
    return 0.5 * (abs(math.cos(relative)) * length + abs(math.sin(relative)) * width)


def wrap_angle(angle: float) -> float:
    """The angle [rad] within [-pi, pi)."""
    return (angle + math.pi) % (2.0 * math.pi) - math.pi
