"""A climb as a program: guides along the surface, and spins that turn the nose up and down."""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np

from esg.dynamics.choreography.courses.climbs import (
    pace_of,
    poses_of,
    seen_along,
)
from esg.dynamics.plan.cast import Cast
from esg.dynamics.story.climbing import Climber, Pose, stands_on_top, times, velocities
from esg.dynamics.story.outlines import Floats, clouds_of_body
from esg.dynamics.story.story import Phase, is_climb
from esg.engines.program import MAX_KNOTS, GuideAlong, HoldSpin, Primitive, Vec
from esg.units import quat_from_euler_deg, quat_multiply, quat_rotate, yaw_from_quat


@dataclass(frozen=True)
class Climb:
    """A climb in the world.

    Args:
        heading: Of the climber [rad].
        tilts: Of its nose in each of its poses [rad].
        points: Where its centre of mass is then [m].
        speeds: How fast it moves then [m/s].
        times: When, since the start [s].
        holds: Whether it holds on at the end, whatever comes of it if it is let go.
    """

    heading: float
    tilts: tuple[float, ...]
    points: tuple[Vec, ...]
    speeds: tuple[Vec, ...]
    times: tuple[float, ...]
    holds: bool = False

    @property
    def start(self) -> tuple[Floats, Floats]:
        """Its first pose: position [m], shape [3], and quaternion (x, y, z, w), shape [4]."""
        yaw = quat_from_euler_deg(math.degrees(self.heading))
        half = -0.5 * self.tilts[0]  # the nose is turned up about the climber's right
        up = np.array([0.0, math.sin(half), 0.0, math.cos(half)])
        return np.array(self.points[0]), quat_multiply(yaw, up)

    def program(self, actor: str, start: float, until: float) -> list[Primitive]:
        """The primitives that lead along it.

        Args:
            actor: Who climbs.
            start: When it sets off [s].
            until: How long it holds on at the end [s]: it is let go at once if that is not later.
        """
        at, points, speeds = [*self.times], [*self.points], [*self.speeds]
        if until > start + at[-1]:
            at, points = [*at, until - start], [*points, points[-1]]
            speeds = [*speeds, (0.0, 0.0, 0.0)]
        out: list[Primitive] = []
        for k in range(0, len(at) - 1, MAX_KNOTS - 1):
            part = slice(k, k + MAX_KNOTS)
            since = tuple(t - at[k] for t in at[part])
            out.append(GuideAlong(actor, start + at[k], since, tuple(points[part]),
                                  tuple(speeds[part])))  # fmt: skip
        axis = (math.sin(self.heading), -math.cos(self.heading), 0.0)
        legs = zip(self.times, self.times[1:], self.tilts, self.tilts[1:], strict=False)
        for a, b, before, after in legs:
            if abs(after - before) > 1e-6:
                rate = (after - before) / (b - a)
                out.append(HoldSpin(actor, start + a, start + b, rate, axis))
        return out


def climb_of(cast: Cast, phase: Phase, before: tuple[Phase, ...]) -> Climb | None:
    """The climb of a phase; None where it is none, or there is nothing to climb.

    Args:
        cast: Who takes part.
        phase: A phase.
        before: What its actor does before it: who has climbed already goes on from there.
    """
    target = phase.edge.target
    if not is_climb(phase) or target not in cast.scene.names or any(map(is_climb, before)):
        return None
    body, thing = cast.scene.body(phase.edge.actor), cast.scene.body(target)
    heading = float(yaw_from_quat(body.quaternion))
    turned = np.array(thing.quaternion)
    around = [quat_rotate(turned, c) for c in clouds_of_body(thing)]
    middle = np.array([*thing.position[:2], 0.0])
    ahead = np.array([math.cos(heading), math.sin(heading), 0.0])
    left = np.array([-ahead[1], ahead[0], 0.0])
    aside = float((np.array(body.position) - middle) @ left)
    lifted = [c + np.array([0.0, 0.0, thing.position[2]]) for c in around]
    seen = [c - np.array([0.0, aside, 0.0]) for c in seen_along(lifted, heading)]
    size = 2.0 * max(body.half_extents)
    who = Climber(tuple(clouds_of_body(body)), pace_of(phase, size))
    poses = poses_of(phase, who, seen)
    if poses is None:
        return None
    at = times(poses, who.speed)
    speeds = velocities(poses, at)

    def world(p: Pose) -> Vec:
        x, y, _ = middle + p.u * ahead + aside * left
        return (float(x), float(y), p.z)

    return Climb(
        heading,
        tuple(p.tilt for p in poses),
        tuple(world(p) for p in poses),
        tuple((float(u * ahead[0]), float(u * ahead[1]), float(z)) for u, z in speeds),
        tuple(at),
        phase.edge.params.climbs == "onto" and not stands_on_top(who, seen),
    )


def climbs(cast: Cast) -> dict[str, Climb]:
    """All climbs of a story, by the id of their segment."""
    out: dict[str, Climb] = {}
    for phases in cast.story.phases.values():
        for k, phase in enumerate(phases):
            found = climb_of(cast, phase, phases[:k])
            if found is not None:
                out[phase.edge.id] = found
    return out
