"""Down a ramp: what is let go at its top, how fast it arrives at the foot, and what waits there."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.stage import Stage, speed_is_fixed
from esg.dynamics.story.proxies import corners
from esg.dynamics.story.stagecraft import Prop, coasting_drag, prop, support_of, top_surface
from esg.dynamics.story.story import Phase, Story, bounds
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

Floats = NDArray[np.float64]

SAMPLE_M = 0.02
STEEPEST = 2.0
"""Fall per way from which on a descent is a step or a drop, not a slope."""
LIP_M = 0.3
"""A slope ends at most this high over the ground, and below half of its height: a slide's lip."""
STARTS_MPS = 0.8
"""Usual speed at the top: faster bodies fly off the crest."""
FASTEST_MPS = 3.0
"""Highest guessed speed at the top."""
OVER_CREST_MPS = 0.5
"""Speed that something slid along the top has left at the crest."""
BALL, WHEEL = 0.4, 0.5
"""Inertia over m r^2 of what rolls."""
AT_FOOT_M, ROLLS_ON_M = 0.12, 0.25
"""Way on the ground that what comes down has at least behind it, and a round body more."""
STILL_FAST = 0.5
"""Share of its speed at the foot with which something arrives in time."""
FRESH = 0.8
"""The same where the ground may be as slippery as it has to be."""
STEP_S, LONGEST_S = 0.01, 12.0


@dataclass(frozen=True)
class Slope:
    """Side view of a ramp from its crest to its foot, in its own frame.

    Args:
        x: Ways from the ramp's origin [m], ascending, shape [n].
        z: Heights of its surface there [m], shape [n].
    """

    x: Floats
    z: Floats

    @property
    def crest(self) -> float:
        return float(self.x[0])

    @property
    def foot(self) -> float:
        return float(self.x[-1])

    @property
    def height(self) -> float:
        return float(self.z[0])

    @property
    def lip(self) -> float:
        """Height of its foot over the ground."""
        return float(self.z[-1])

    @property
    def steepness(self) -> float:
        """Fall per way from crest to foot."""
        return self.height / max(self.foot - self.crest, 1e-6)

    def scaled(self, factor: float) -> Slope:
        """The same ramp at another size."""
        return Slope(factor * self.x, factor * self.z)


@dataclass(frozen=True)
class Ride:
    """How something comes down a ramp.

    Args:
        roll: Inertia over m r^2 of what rolls, 0 for what slides or has wheels.
        on_slope: Friction on the ramp.
        on_ground: Deceleration on the ground [m/s^2].
        damping: Linear damping [1/s].
    """

    roll: float
    on_slope: float
    on_ground: float
    damping: float


@dataclass(frozen=True)
class Descent:
    """A ride in time; `x` counts from the ramp's origin (SI, each of shape [n])."""

    time: Floats
    x: Floats
    speed: Floats

    def at(self, x: float) -> tuple[float, float]:
        """Time [s] and speed [m/s] at a place; infinity and 0 where it does not get that far."""
        if x > self.x[-1]:
            return math.inf, 0.0
        return float(np.interp(x, self.x, self.time)), float(np.interp(x, self.x, self.speed))

    def when(self, time: float) -> tuple[float, float]:
        """Place [m] and speed [m/s] at a time."""
        return float(np.interp(time, self.time, self.x)), float(
            np.interp(time, self.time, self.speed)
        )


def slope_of(doc: EsgDocument, name: str) -> Slope | None:
    """The way down before a support's highest surface, None if that ends in a step or a drop.

    Args:
        doc: A document with assets.
        name: The support.
    """
    slope = _way_down(doc, name)
    return None if slope is None or slope.lip > min(LIP_M, 0.5 * slope.height) else slope


def chute_of(doc: EsgDocument, name: str) -> Slope | None:
    """The way down before a support's highest surface where that ends in the air, else None.

    Args:
        doc: A document with assets.
        name: The support.
    """
    slope = _way_down(doc, name)
    return slope if slope is not None and slope_of(doc, name) is None else None


def _way_down(doc: EsgDocument, name: str) -> Slope | None:
    """The way down before a support's highest surface, None if there is a step in it."""
    config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
    surface = top_surface(doc, name)
    lane = surface.center_cm[1]
    parts = [c for c in map(corners, config.proxies) if c[:, 1].min() <= lane <= c[:, 1].max()]
    if not parts:
        return None
    start = surface.center_cm[0] + surface.half_extents_cm[0]
    end = max(c[:, 0].max() for c in parts)
    count = int((end - start) / (100.0 * SAMPLE_M))
    if count < 4:
        return None
    x = np.linspace(start + 1e-3, end - 1e-3, count)
    z = np.max([_top(c[:, [0, 2]], x) for c in parts], axis=0)
    if not np.isfinite(z).all():
        return None
    fall = -np.diff(np.concatenate([[surface.center_cm[2]], z]))
    if fall.max() > STEEPEST * (x[1] - x[0]) + 1.0 or fall.min() < -0.5:
        return None
    return Slope(x / 100.0, z / 100.0)


def _top(points: Floats, x: Floats) -> Floats:
    """Height of the upper side of the hull of points (way, height) at given ways; else -inf."""
    (s, z), best = points.T, np.full(len(x), -np.inf)
    i, j = np.nonzero(s[:, None] < s[None, :] - 1e-9)
    share = (x[None, :] - s[i][:, None]) / (s[j] - s[i])[:, None]
    at = z[i][:, None] + share * (z[j] - z[i])[:, None]
    inside = (share >= 0.0) & (share <= 1.0)
    return np.maximum(best, np.where(inside, at, -np.inf).max(axis=0, initial=-np.inf))


def ride_of(body: Prop, ramp: Prop) -> Ride:
    """How a body comes down a ramp."""
    rolls = BALL if abs(body.width - body.height) < 0.1 * body.height else WHEEL
    return Ride(
        roll=rolls if body.rolls else 0.0,
        on_slope=0.0 if body.rolls else 0.5 * (body.friction + ramp.friction),
        on_ground=coasting_drag(body),
        damping=body.damping,
    )


def come_down(slope: Slope, ride: Ride, start: float, speed: float) -> Descent:
    """Plays a ride step by step: over the top, down the slope, and on along the ground.

    Args:
        slope: The ramp.
        ride: How it is ridden.
        start: Where its centre starts [m].
        speed: It is let go with [m/s].
    """
    dx = np.diff(slope.x)
    tilt = np.arctan2(-np.diff(slope.z), dx)
    last = math.cos(float(tilt[-1]))
    time, x, v = [0.0], [start], [speed]
    grounded = False
    while time[-1] < LONGEST_S and v[-1] > 0.0:
        here, now = x[-1], v[-1]
        if here < slope.crest:
            gain, level = -ride.on_slope * GRAVITY_MPS2, 1.0
        elif here < slope.foot:
            angle = float(tilt[min(np.searchsorted(slope.x, here, "right") - 1, len(tilt) - 1)])
            level = math.cos(angle)
            gain = GRAVITY_MPS2 * (math.sin(angle) / (1.0 + ride.roll) - ride.on_slope * level)
        else:
            if not grounded:
                grounded, now = True, last * now
            gain, level = -ride.on_ground, 1.0
        after = max(now + (gain - ride.damping * now) * STEP_S, 0.0)
        x.append(here + 0.5 * (now + after) * level * STEP_S)
        v.append(after)
        time.append(time[-1] + STEP_S)
    return Descent(np.array(time), np.array(x), np.array(v))


def goes_down(stage: Stage, a: str, b: str) -> Slope | None:
    """The slope that a comes down to b, which waits on the ground; None if there is none."""
    support = stage.anchor
    if support is None or a != stage.lead or stage.lifted or stage.story.flies(a):
        return None
    if b in stage.places or a in stage.frames or stage.tracks[a].time > 0.0:
        return None
    name = stage.member(b)
    if name == support or support_of(stage.doc, name) == support:
        return None
    return slope_of(stage.doc, support)


def descend(
    stage: Stage, node: TimelineNode, a: str, phase: Phase, b: str, needed: float
) -> tuple[float, float, float]:
    """Way [m], time [s] and last speed [m/s] from the top of a ramp to what waits at its foot.

    Args:
        stage: The stage; the speed at the top becomes nominal.
        node: Their meeting.
        a: Who comes down.
        phase: Its phase.
        b: What waits.
        needed: Least speed of the meeting [m/s].
    """
    assert stage.anchor is not None
    slope = slope_of(stage.doc, stage.anchor)
    assert slope is not None
    body = stage.prop(a)
    ride = ride_of(body, stage.prop(stage.anchor))
    start = slope.crest - stage.inset(a)
    least = slope.foot + body.half_length + AT_FOOT_M + (ROLLS_ON_M if body.rolls else 0.0)
    prescribed = stage.prescribed_time(node)
    meant = arrival_speed(node, stage.member(a))
    low, high, _ = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
    if speed_is_fixed(phase):
        options = [low / 100.0]
    else:
        first = math.sqrt(2.0 * ride.on_slope * GRAVITY_MPS2 * max(slope.crest - start, 0.0))
        first += OVER_CREST_MPS if ride.roll == 0.0 else 0.3
        top = high / 100.0 if phase.edge.speed_is_prescribed else max(FASTEST_MPS, first + 1.0)
        options = list(np.linspace(min(first, top), top, 24))
    best, found = math.inf, (0.0, 0.0, 0.0, 0.0)
    for speed in options:
        way = come_down(slope, ride, start, float(speed))
        place = least
        if prescribed is not None:
            place = max(way.when(prescribed)[0], least)
        time, left = way.at(place)
        foot = way.at(slope.foot)[1]
        cost = 0.1 * abs(speed - STARTS_MPS)
        if not math.isfinite(time):
            cost, time = cost + 100.0 + place - float(way.x[-1]), float(way.time[-1])
        cost += 10.0 * max(needed - left, 0.0) + 30.0 * max(STILL_FAST * foot - left, 0.0)
        if prescribed is not None:
            cost += 20.0 * abs(time - prescribed)
        if meant is not None:
            cost += 5.0 * abs(left - meant)
        if cost < best:
            best, found = cost, (float(speed), place, time, left)
    speed, place, time, left = found
    if node.time_is_prescribed:
        # The plan adds what damping takes on level ground (`variables.damping_loss`).
        speed /= math.exp(0.5 * ride.damping * time)
    stage.nominal[f"{phase.edge.id}/speed"] = speed
    return place - start, time, max(left, 0.1)


def arrival_speed(node: TimelineNode, name: str) -> float | None:
    """Speed [m/s] that the prompt has something arrive with at an event, None where it is open."""
    for c in node.constraints:
        if c.quantity == "speed_before" and c.object == name:
            low, high, _ = bounds(c.value, (0.0, 0.0))
            return 0.005 * (low + high)
    return None


def rides(doc: EsgDocument, story: Story) -> list[tuple[TimelineNode, str, str, Slope]]:
    """Meetings at the foot of a ramp as (meeting, who comes down, the ramp, its slope)."""
    out: list[tuple[TimelineNode, str, str, Slope]] = []
    for actor, phases in story.phases.items():
        support, end = support_of(doc, actor), phases[0].end
        if support is None or story.flies(actor):
            continue
        if end.event not in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION):
            continue
        others = [p for p in end.participants if p != actor]
        others += [end.region.split("/")[0]] if end.region else []
        slope = slope_of(doc, support)
        if slope is None or support in others:
            continue
        if others and support_of(doc, others[0]) != support:
            out.append((end, actor, support, slope))
    return out


def runs_down(doc: EsgDocument, story: Story) -> list[tuple[str, str, Slope]]:
    """What is let go on a ramp and meets nothing, as (who comes down, the ramp, its slope)."""
    out: list[tuple[str, str, Slope]] = []
    for actor, phases in story.phases.items():
        support, first = support_of(doc, actor), phases[0]
        free = first.end.event in (NodeEvent.TRIGGER, NodeEvent.STOP)
        if support is None or not free or first.edge.event is not EdgeEvent.TOWARD:
            continue
        slope = None if story.flies(actor) else slope_of(doc, support)
        if slope is not None:
            out.append((actor, support, slope))
    return out


def slows_enough(slope: Slope, ride: Ride, start: float, time: float) -> float | None:
    """Friction [over g] on the ground with which what slides down is still fast at a time.

    Args:
        slope: The ramp.
        ride: How it is ridden.
        start: Where it starts [m].
        time: When it is to arrive [s].

    Returns:
        None where it is not long on the ground by then.
    """
    free = replace(ride, on_ground=0.0)
    first = math.sqrt(2.0 * ride.on_slope * GRAVITY_MPS2 * max(slope.crest - start, 0.0))
    at_foot, speed = come_down(slope, free, start, first + OVER_CREST_MPS).at(slope.foot + 0.02)
    left = time - at_foot
    if not math.isfinite(at_foot) or left < 0.2:
        return None
    return (1.0 - FRESH) * speed / (GRAVITY_MPS2 * left)


def fastest_down(doc: EsgDocument, name: str) -> float | None:
    """Speed [m/s] at the foot of the ramp that something stands on, None if it stands on none."""
    support = support_of(doc, name)
    slope = slope_of(doc, support) if support is not None else None
    if support is None or slope is None:
        return None
    body = prop(doc, name)
    ride = ride_of(body, prop(doc, support))
    ride = replace(ride, on_ground=0.0)
    start = slope.crest - 0.6 * body.half_length
    return come_down(slope, ride, start, FASTEST_MPS - 1.0).at(slope.foot + 0.1)[1]
