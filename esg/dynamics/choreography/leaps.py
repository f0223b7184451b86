"""Leaps that end somewhere else: onto what is higher, down from what carries the jumper, across."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

from esg.dynamics.choreography.falling.falls import (
    CLEAR_OF_EDGE_M,
    Flight,
    landing_speed,
    surface_height,
)
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.kinematics import Frame, frame_mapping
from esg.dynamics.story.stagecraft import Prop, support_of, top_surface
from esg.dynamics.story.story import Phase
from esg.graph.models import EdgeEvent, NodeEvent, RegionType, TimelineNode
from esg.units import GRAVITY_MPS2

CROUCHES_S = 0.3
"""How long who stands at first goes on standing before it leaps."""
TAKES_OFF_M = 0.3
"""Gap that a jumper at least leaves to what it jumps onto from the ground."""
ACROSS_M = 0.1
"""Gap between two things of which one jumps from one to the other."""
CLEARS = 1.25
"""How much later than it must a jumper's front comes over the edge of what is higher."""
STEEPEST = 0.8
"""Largest share of a leap's time that may pass before that."""
LANDS_M = 0.08
"""How far behind the edge of what it jumps onto a jumper's back comes down."""
STEEPER_M = 0.15
"""How much higher it leaps, and so the slower, onto what is not longer than itself."""
ASIDE_M = 0.15
"""Gap between two that come down on the same thing."""
BEFORE_IT_M = 0.3
"""How far before its support a jumper's back comes down where nothing says on what."""


@dataclass(frozen=True)
class Landing:
    """What comes of a leap in the story.

    Args:
        down: What else tells that it comes down: a Fall, the end of its motion.
        met: The Collision with what it comes down on.
        on: The key of that.
    """

    down: TimelineNode | None = None
    met: TimelineNode | None = None
    on: str | None = None


def landing(stage: Stage, actor: str, phase: Phase) -> Landing | None:
    """Where a leap leads: None where it ends on what it began on.

    Args:
        stage: What is placed so far.
        actor: Who jumps.
        phase: The leap.
    """
    phases = stage.story.phases[actor]
    goal = Landing()
    for later in phases[phases.index(phase) + 1 :]:
        node = later.end
        others = [p for p in node.participants if p != actor]
        if not _coasts(later):
            break
        if node.event is NodeEvent.COLLISION and others:
            return replace(goal, met=node, on=stage.key(others[0]))
        if node.event not in (NodeEvent.FALL, NodeEvent.TRIGGER, NodeEvent.ENTER_REGION) or others:
            break
        if node.event is NodeEvent.ENTER_REGION or goal.down is not None:
            return goal  # what takes it up is put where it comes down (`falls.land`)
        goal = replace(goal, down=node)
    return None if goal.down is None else goal


def _coasts(phase: Phase) -> bool:
    """Whether nothing new is done to its actor."""
    params = phase.edge.params
    return phase.edge.event is EdgeEvent.TOWARD and params.speed is None


def leap_to(
    stage: Stage, actor: str, phase: Phase, node: TimelineNode, goal: Landing, rise_m: float
) -> None:
    """Tells a leap up to its landing: speeds, times, and where what it ends on stands.

    Args:
        stage: What is placed so far.
        actor: Who jumps.
        phase: The leap.
        node: The Jump.
        goal: Where it leads.
        rise_m: How high it leaps from level ground.
    """
    body, track = stage.prop(actor), stage.tracks[actor]
    anchored = stage.anchor is not None and support_of(stage.doc, actor) == stage.anchor
    walls = _walls(stage, actor) if anchored else None
    low = surface_height(stage) if anchored and walls is None else 0.0
    run = _run(stage, body) if anchored and walls is None else None
    deck = _deck(stage, goal.on)
    depth = body.half_length
    if deck is not None and deck.half_depth < body.half_length < deck.half_width:
        # It comes down along what is too shallow for it.
        depth = body.half_width
        stage.nominal[f"{phase.edge.id}/turn"] = 0.5 * math.pi
    top = 0.0 if deck is None else deck.height
    rise = max(rise_m, top - low + max(0.25 * body.height, 0.15)) if deck is not None else rise_m
    steep = deck is not None and deck.half_depth < body.half_length
    rise += STEEPER_M if steep else 0.0
    rise = rise if walls is None else max(rise, walls.height + max(0.25 * body.height, 0.15))
    up = math.sqrt(2.0 * GRAVITY_MPS2 * rise)
    rising = up / GRAVITY_MPS2
    aloft = rising + math.sqrt(2.0 * (low + rise - top) / GRAVITY_MPS2)
    if deck is None:
        near = way = (run or 0.0) + body.half_length + BEFORE_IT_M
        way = max(way, landing_speed(stage, actor, node, low + rise) * aloft)
    else:
        near, way = _way(body, depth, deck, run, top - low, up, aloft)
    if walls is not None:
        # Its back has passed the wall when it comes down behind it.
        over = rising + math.sqrt(2.0 * (rise - walls.height) / GRAVITY_MPS2)
        way = (walls.half_length + body.half_length + CLEAR_OF_EDGE_M) * aloft / over
    if run is not None and top < low:
        # Its back has passed the edge when it comes down past it.
        needed = (run + body.half_length + CLEAR_OF_EDGE_M) * aloft / (2.0 * rising)
        near, way = near + max(needed - way, 0.0), max(way, needed)
    speed = way / aloft
    stage.nominal[f"{phase.edge.id}/rise"] = up
    stage.nominal[f"{phase.edge.id}/speed"] = speed
    stage.nominal[f"{phase.edge.id}/aloft"] = aloft
    crouch(stage, actor, phase)
    begin = track.time
    stage.time[node.id] = begin + rising
    if goal.down is not None:
        stage.time[goal.down.id] = begin + rising + 0.6 * (aloft - rising)
    if goal.met is not None:
        stage.time[goal.met.id] = begin + aloft
    _put(stage, actor, goal.on, deck, near, body.half_length + body.half_width - depth)
    if anchored:
        stage.edge_run = run if walls is None else walls.half_length
        stage.airborne[actor] = Flight(speed, low + rise)
    if deck is None:
        track.straight(speed * rising, rising, speed)
    else:
        track.straight(way, aloft, 0.0)


def _run(stage: Stage, body: Prop) -> float:
    """From who stands on the anchor to the edge that it leaps from, all its feet on it [m]."""
    assert stage.anchor is not None
    half_depth = top_surface(stage.doc, stage.anchor).half_extents_cm[0] / 100.0
    return min(0.6 * body.half_length + 0.05, half_depth)


def _walls(stage: Stage, actor: str) -> Prop | None:
    """The vessel that an actor is in at the start; None for who stands on something."""
    graph = stage.doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[stage.member(actor)].semantic_region or "")
    inside = region is not None and region.region_type is RegionType.STORAGE
    return stage.prop(region.parent_object) if region is not None and inside else None


def crouch(stage: Stage, actor: str, phase: Phase) -> None:
    """Lets an actor stand before its first leap, so that it is seen where it stands."""
    if phase is stage.story.phases[actor][0]:
        stage.nominal[f"{phase.edge.id}/crouch"] = CROUCHES_S
        stage.tracks[actor].time += CROUCHES_S


@dataclass(frozen=True)
class _Deck:
    """The surface that somebody comes down on.

    Args:
        height: Over the ground [m].
        half_depth, half_width: Half of it along the leap and across [m].
        behind: How far its middle lies behind the origin of what has it, along the leap [m].
    """

    height: float
    half_depth: float
    half_width: float
    behind: float


def _deck(stage: Stage, key: str | None) -> _Deck | None:
    """The highest surface of something that faces who comes, or its whole top."""
    if key is None:
        return None
    name = stage.member(key)
    body = stage.prop(key)
    asset = stage.doc.spatial_relation_graph.nodes[name].asset_id
    if not stage.doc.asset_configurations[asset].support_surfaces:
        return _Deck(body.height, body.half_length, body.half_width, 0.0)
    surface = top_surface(stage.doc, name)
    return _Deck(
        surface.center_cm[2] / 100.0,
        surface.half_extents_cm[0] / 100.0,
        surface.half_extents_cm[1] / 100.0,
        surface.center_cm[0] / 100.0,
    )


def _way(
    body: Prop,
    depth: float,
    deck: _Deck,
    run: float | None,
    higher: float,
    up: float,
    aloft: float,
) -> tuple[float, float]:
    """From the start of who jumps to the edge of a surface, and to where its middle comes down [m].

    Args:
        body: Who jumps.
        depth: Half of it along the leap when it comes down [m].
        deck: What it jumps onto.
        run: From its start to the edge of what carries it; None on the ground [m].
        higher: How much higher the surface is [m].
        up: Vertical speed at the start [m/s].
        aloft: How long it is in the air [s].
    """
    inset = min(deck.half_depth, depth + LANDS_M)
    near = body.half_length + TAKES_OFF_M
    if run is not None:
        near = max(run, body.half_length) + ACROSS_M
    if higher > 0.0:
        # Its front comes over the edge when it is above it.
        early = (up - math.sqrt(max(up * up - 2.0 * GRAVITY_MPS2 * higher, 0.0))) / GRAVITY_MPS2
        share = min(CLEARS * early / aloft, STEEPEST)
        near = max(near, (body.half_length + share * inset) / (1.0 - share))
    return near, near + inset


def _put(
    stage: Stage, actor: str, on: str | None, deck: _Deck | None, near: float, half_width: float
) -> None:
    """Gives the jumper a start, and what it comes down on its place before it.

    Args:
        stage: What is placed so far.
        actor: Who jumps.
        on: The key of what it comes down on.
        deck: Its surface.
        near: From the start to the edge of that [m].
        half_width: Half of the jumper across the leap when it comes down [m].
    """
    track = stage.tracks[actor]
    middle = near + (deck.half_depth + deck.behind if deck is not None else 0.0)
    if on is not None and on in stage.places and actor not in stage.frames:
        bx, by, yaw = stage.places[on]
        heading = (yaw or 0.0) + math.pi
        # Beside who jumps there, too.
        others = stage.landed.get(on, 0)
        aside = (2 * (others % 2) - 1) * ((others + 1) // 2) * (2.0 * half_width + ASIDE_M)
        end = (
            bx - middle * math.cos(heading) - aside * math.sin(heading),
            by - middle * math.sin(heading) + aside * math.cos(heading),
        )
        stage.frames[actor] = frame_mapping((track.x, track.y), track.heading, end, heading)
    frame = stage.frames.setdefault(actor, Frame() if not stage.places else stage.free_frame(actor))
    if on is not None:
        heading = track.heading + frame.angle
        x, y = frame.apply(track.x, track.y)
        x, y = x + middle * math.cos(heading), y + middle * math.sin(heading)
        stage.places.setdefault(on, (x, y, heading + math.pi))
        stage.landed[on] = stage.landed.get(on, 0) + 1
    x, y = frame.apply(0.0, 0.0)
    stage.places[actor] = (x, y, frame.angle)
