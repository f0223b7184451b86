"""Who climbs stands at the foot of what it climbs, or where it comes down from."""

from __future__ import annotations

from collections.abc import Sequence
import math
from typing import cast

import numpy as np

from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.climbing import (
    WALKED_DEG,
    Climber,
    Course,
    Pose,
    climb,
    slope_deg,
    times,
    walk_down,
)
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.outlines import Floats, clouds_of_asset
from esg.dynamics.story.stagecraft import Prop
from esg.dynamics.story.story import Phase, bounds, is_climb
from esg.graph.models import AssetConfiguration, EdgeEvent, TimelineNode

SPEEDS_MPS = (0.18, 0.75)
"""Of climbers whose segment says nothing of it: 1.8 of their lengths a second within these."""
LENGTHS_S = 1.8
PEAK = 1.5
"""Largest speed over the mean one of who sets off from rest and comes to rest again."""
WIDE = 2.0
"""A thing so much wider than deep is climbed across its width: walls, fences."""
FOOT_M = 0.5
"""Height up to which a thing's width at its foot is taken."""
ASIDE_M = 0.15
"""Gap between two that climb side by side."""


def pushes_off(before: Phase, phase: Phase) -> bool:
    """Whether a phase leads off what its actor has climbed, to which it has its face."""
    held = is_climb(before) and before.edge.params.climbs == "up"
    return held and phase.edge.event is EdgeEvent.TOWARD


def pace_of(phase: Phase, length: float) -> float:
    """Speed along the surface [m/s].

    Args:
        phase: The climb.
        length: The longest side of who climbs [m].
    """
    usual = min(max(LENGTHS_S * length, SPEEDS_MPS[0]), SPEEDS_MPS[1])
    low, high, _ = bounds(phase.edge.params.speed, (100.0 * usual, 100.0 * usual))
    return 0.005 * (low + high) / PEAK


def facing(config: AssetConfiguration) -> float:
    """The side of a thing that is climbed: its direction from the thing's middle [rad]."""
    long, wide, _ = config.dimensions_cm
    if is_walked(seen_along(clouds_of_asset(config), math.pi)):
        return 0.0
    return 0.5 * math.pi if long > WIDE * wide else 0.0


def seen_along(clouds: Sequence[Floats], heading: float) -> list[Floats]:
    """Points [m] in axes along a heading [rad], to its left, and up."""
    cos, sin = math.cos(heading), math.sin(heading)
    turn = np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return [c @ turn.T for c in clouds]


def poses_of(phase: Phase, who: Climber, thing: Sequence[Floats]) -> list[Pose] | None:
    """The poses of a climb; None where there is nothing to climb.

    Args:
        phase: The climb.
        who: Who climbs.
        thing: What is climbed [m]: along the way, across, up; the ground at 0.
    """
    params = phase.edge.params
    rise = None
    if params.height_cm is not None:
        low, high, _ = bounds(params.height_cm, (0.0, 0.0))
        rise = 0.005 * (low + high)
    course = cast(Course, params.climbs)
    return walk_down(who, thing) if goes_forward(phase, thing) else climb(who, thing, course, rise)


def goes_forward(phase: Phase, thing: Sequence[Floats]) -> bool:
    """Whether a climb goes down face forward, as stairs are walked down."""
    turned = [c * np.array([-1.0, 1.0, 1.0]) for c in thing]
    return phase.edge.params.climbs == "down" and is_walked(turned)


def is_walked(thing: Sequence[Floats]) -> bool:
    """Whether a side is so flat that it is walked and not climbed, as stairs are."""
    return slope_deg(thing) < WALKED_DEG


def climbed(stage: Stage, node: TimelineNode, actor: str, phase: Phase) -> None:
    """Places who climbs and what it climbs, and tells when it has got there.

    Args:
        stage: What is placed so far.
        node: The event at the end of the climb.
        actor: Who climbs.
        phase: The climb.
    """
    track, other = stage.tracks[actor], phase.edge.target or ""
    body, thing = stage.prop(actor), stage.prop(stage.key(other))
    if body.config is None or thing.config is None:
        track.straight(0.0, 1.0, 0.0)
        return
    com = np.array(body.config.center_of_mass_cm) / 100.0
    clouds = tuple(c - com for c in clouds_of_asset(body.config))
    who = Climber(clouds, pace_of(phase, max(body.length, body.height)))
    front = facing(thing.config)
    around = clouds_of_asset(thing.config)
    met = seen_along(around, front + math.pi)
    forward = phase.edge.params.climbs == "down" and is_walked(met)
    heading = front if forward else front + math.pi
    poses = poses_of(phase, who, seen_along(around, heading))
    if poses is None:
        track.straight(0.0, 1.0, 0.0)
        return
    first, last = poses[0], poses[-1]
    lasts = times(poses, who.speed)[-1]
    _put(stage, actor, stage.key(other), first.u - float(com[0]), heading)
    bottom = first.z - who.foot
    if bottom > 0.05:
        stage.heights[actor] = bottom
    stage.nominal[f"{phase.edge.id}/climb"] = lasts
    track.straight(last.u - first.u, lasts, 0.0)


def _put(stage: Stage, actor: str, other: str, along: float, heading: float) -> None:
    """Gives the climber a start, and the thing its place before it.

    Args:
        stage: What is placed so far.
        actor: Who climbs.
        other: The key of what is climbed.
        along: From the middle of that to the climber's, along the way [m].
        heading: Of the way in the thing's own frame [rad].
    """
    if other in stage.places:
        bx, by, yaw = stage.places[other]
        way = (yaw or 0.0) + heading
        others = stage.landed.get(other, 0)
        step = 2.0 * stage.prop(actor).half_width + ASIDE_M
        if _foot_width(stage.prop(other), heading) < 2.0 * step:  # from another side
            way, others = way + 0.5 * math.pi * others, 0
        aside = (2 * (others % 2) - 1) * ((others + 1) // 2) * step
        x = bx + along * math.cos(way) - aside * math.sin(way)
        y = by + along * math.sin(way) + aside * math.cos(way)
        stage.frames.setdefault(actor, Frame(x, y, way))
    frame = stage.frames.setdefault(actor, Frame() if not stage.places else stage.free_frame(actor))
    x, y = frame.apply(-along, 0.0)
    stage.places.setdefault(other, (x, y, frame.angle - heading))
    stage.landed[other] = stage.landed.get(other, 0) + 1
    stage.places[actor] = (*frame.apply(0.0, 0.0), frame.angle)


def _foot_width(thing: Prop, heading: float) -> float:
    """How wide a thing is at its foot, across a way in its own frame [m]."""
    assert thing.config is not None
    clouds = seen_along(clouds_of_asset(thing.config), heading)
    low = [c for c in clouds if c[:, 2].min() < FOOT_M]
    return max((float(c[:, 1].max() - c[:, 1].min()) for c in low), default=0.0)
