"""Bounces off a top: a ball comes down on a table or a trampoline and goes on to something else.

What is dropped straight down comes straight up again. It is let go with the little speed along the
ground of which the bounce leaves enough to carry it over the edge, and comes down near that edge.
"""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.dynamics.choreography.falling.throws import (
    asked_height,
    is_dropped,
    region_of,
    stated_height,
)
from esg.dynamics.choreography.flights import CLEAR_M, LOW_M, mouth_height
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.kinematics import Frame, half_along, rubbed
from esg.dynamics.story.stagecraft import Prop, prop, top_surface
from esg.dynamics.story.story import Phase, Story, read_story
from esg.graph.models import AssetConfiguration, EdgeEvent, EsgDocument, NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

LIVELY = 0.85
"""Restitution of a top that something bounces off to go on."""
LETS_GO_M = 1.0
"""Height over a top from which something is let go, where the prompt states none."""
FROM_EDGE_M = 0.12
"""From the edge to where the ball comes down, at most."""
BEFORE_M = 0.25
"""Least way along the ground from the start to the middle of the top."""
DROPPED_CM_S = 250.0
"""Fastest along the ground that still passes for a drop."""


def _next_phase(story: Story, actor: str, node: TimelineNode) -> Phase | None:
    """Where a thrown body coasts to after an event, without a push of its own."""
    for phase in story.phases.get(actor, ()):
        coasts = phase.edge.event is EdgeEvent.TOWARD and phase.edge.params.speed is None
        hits = phase.end.event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
        if phase.start.id == node.id and coasts and hits:
            return phase
    return None


def _next_body(phase: Phase, actor: str) -> str | None:
    if phase.end.region:
        return phase.end.region.split("/")[0]
    return next((p for p in phase.end.participants if p != actor), None)


def _bounces(doc: EsgDocument, story: Story) -> list[tuple[Phase, str]]:
    """Flights that end on a top and go on from there to another body: phase, what is under it."""
    out: list[tuple[Phase, str]] = []
    nodes = doc.spatial_relation_graph.nodes
    for actor, phases in story.phases.items():
        for phase in phases:
            under = next((p for p in phase.end.participants if p != actor), None)
            if phase.end.event is not NodeEvent.COLLISION or under not in nodes:
                continue
            follows = _next_phase(story, actor, phase.end)
            onto = _next_body(follows, actor) if follows is not None else None
            if onto is None or onto == under or onto not in nodes or not story.flies(actor):
                continue
            if nodes[under].is_structural or not prop(doc, actor).rolls:
                continue
            if _from_above(phase) or prop(doc, under).height < LOW_M:
                out.append((phase, under))
    return out


def _from_above(phase: Phase) -> bool:
    """Whether a flight may begin straight down: what is dropped."""
    angle = phase.edge.params.elevation_deg
    low = angle[0] if isinstance(angle, tuple) else angle
    return phase.edge.event is EdgeEvent.TOWARD and low is not None and low <= -90.0


def let_go_sideways(doc: EsgDocument) -> EsgDocument:
    """The document in which what is dropped onto something, to go on, may drift a little.

    Args:
        doc: A document with assets.

    Returns:
        It, with the speed and elevation of such drops opened.
    """
    system = doc.timeline_system
    if system is None:
        return doc
    story = read_story(doc)
    drifts = {p.edge.id for p, _ in _bounces(doc, story) if is_dropped(p)}
    if not drifts:
        return doc
    opened = {"speed": (0.0, DROPPED_CM_S), "elevation_deg": (-90.0, 20.0)}
    edges = tuple(
        e.model_copy(update={"params": e.params.model_copy(update=opened)}) if e.id in drifts else e
        for e in system.sequence_graph.edges
    )
    graph = system.sequence_graph.model_copy(update={"edges": edges})
    return doc.model_copy(
        update={"timeline_system": system.model_copy(update={"sequence_graph": graph})}
    )


def lively_tops(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Tops that throw a ball up again which shall go on: assets that change, by key."""
    out: dict[str, AssetConfiguration] = {}
    for _, under in _bounces(doc, story):
        key = doc.spatial_relation_graph.nodes[under].asset_id
        config = doc.asset_configurations[key]
        if config.proxies and config.restitution < LIVELY:
            out[key] = config.model_copy(update={"restitution": LIVELY})
    return out


def apex_after(doc: EsgDocument, story: Story, node: TimelineNode, thing: str) -> float | None:
    """Height [m] to which a thing rises off the top before an event; None if it comes off none."""
    for phase, under in _bounces(doc, story):
        if phase.edge.actor == thing and phase.end.id in story.ancestors(node.id):
            top = top_surface(doc, under).center_cm[2] / 100.0
            stated = stated_height(story, phase.end, thing)
            above = LETS_GO_M if stated is None else stated - top if stated > top else stated
            lively = max(prop(doc, under).restitution, LIVELY)
            return top + (0.5 * (prop(doc, thing).restitution + lively)) ** 2 * above
    return None


@dataclass(frozen=True)
class Bounce:
    """A flight off a top.

    Args:
        follows: The phase after the bounce.
        onto: What it leads to.
        top: Height of the top [m].
        above: Height over it from which the body is let go [m].
        falls: Time until it comes down on the top [s].
        middle: Height of its centre then [m].
        lasts: Time from there to what comes next [s].
        back: From the place where it comes down to the middle of what comes next [m].
        restitution, friction: Of the bounce.
    """

    follows: Phase
    onto: str
    top: float
    above: float
    falls: float
    middle: float
    lasts: float
    back: float
    restitution: float
    friction: float


def bounces_on(stage: Stage, e: Encounter) -> bool:
    """Whether a comes down on the top of b, to go on from there to something that has no place."""
    return _bounce_of(stage, e) is not None


def _bounce_of(stage: Stage, e: Encounter) -> Bounce | None:
    """How a bounces off b, None where that is not what is told, or cannot be."""
    node, a, b, phase = e.node, e.a, e.b, e.coming
    if all(p.edge.id != phase.edge.id for p, _ in _bounces(stage.doc, stage.story)):
        return None
    follows = _next_phase(stage.story, phase.edge.actor, node)
    onto = stage.key(_next_body(follows, phase.edge.actor) or "") if follows is not None else ""
    if follows is None or not onto or onto in stage.places or b in stage.places or stage.anchor:
        return None
    pa, pb, pc = stage.prop(a), stage.prop(b), stage.prop(onto)
    top = top_surface(stage.doc, stage.member(b)).center_cm[2] / 100.0
    stated = asked_height(stage, node, a)
    above = LETS_GO_M if stated is None else stated - top if stated > top else stated
    if above <= 0.0:
        return None
    falls = math.sqrt(2.0 * above / GRAVITY_MPS2)
    restitution = 0.5 * (pa.restitution + pb.restitution)
    up = restitution * GRAVITY_MPS2 * falls
    back, height = _meets(stage, follows, pa, pc)
    middle = top + 0.5 * pa.height
    under = up * up + 2.0 * GRAVITY_MPS2 * (middle - height)
    if under <= 0.0:
        return None
    lasts = (up + math.sqrt(under)) / GRAVITY_MPS2
    friction = 0.5 * (pa.friction + pb.friction)
    return Bounce(
        follows, onto, top, above, falls, middle, lasts, back, restitution, friction
    )  # fmt: skip


def bounce_on(stage: Stage, e: Encounter) -> None:
    """Plans a flight onto the top of b and on to the next body, which is placed with it."""
    bounce = _bounce_of(stage, e)
    assert bounce is not None
    node, a, b, onto = e.node, e.a, e.b, bounce.onto
    pb, pc = stage.prop(b), stage.prop(onto)
    along, across = (v / 100.0 for v in top_surface(stage.doc, stage.member(b)).half_extents_cm)
    reach, yaw = (along, 0.0) if along <= across else (across, math.pi / 2)
    falls, lasts, back = bounce.falls, bounce.lasts, bounce.back
    inside = min(FROM_EDGE_M, 0.5 * reach)
    half = 0.5 * max(pb.length, pb.width) if pb.rolls else half_along(pb.length, pb.width, yaw)
    way = inside + (half - reach) + CLEAR_M + 0.5 * pc.length + back
    # Its line points at the middle of the top, which it has to start before.
    hit = GRAVITY_MPS2 * falls
    # What does not slip loses most; what slips, a fixed speed.
    slower = min(2.0 / 5.0 * way / lasts, bounce.friction * (1.0 + bounce.restitution) * hit)
    speed = max(way / lasts + slower, (reach - inside + BEFORE_M) / falls)
    left = (1.0 - rubbed(bounce.friction, bounce.restitution, hit, speed)) * speed
    way = left * lasts
    start = -speed * falls
    stage.places[a] = (start, 0.0, 0.0)
    stage.frames[a] = Frame(start, 0.0, 0.0)
    stage.places[b] = (inside - reach, 0.0, yaw)
    stage.places[onto] = (way - back, 0.0, math.pi)
    stage.heights[a] = bounce.top + bounce.above
    track = stage.tracks[a]
    name = f"{e.coming.edge.id}/"
    stage.nominal[f"{name}flight_time"] = falls
    stage.nominal[f"{name}speed"] = speed
    stage.nominal[f"{name}goal_beyond"] = reach - inside
    stage.nominal[f"{name}goal_above"] = bounce.middle
    track.straight(speed * falls, falls, speed)
    stage.time[node.id] = track.time
    track.straight(way, lasts, left)
    stage.time[bounce.follows.end.id] = track.time
    stage.met[a] = onto


def _meets(stage: Stage, phase: Phase, body: Prop, met: Prop) -> tuple[float, float]:
    """Offset of the place to come down from the middle of what is met, and its height [m]."""
    region = region_of(stage, phase.end)
    if region is not None:
        return -region.center_cm[0] / 100.0, mouth_height(stage, phase.end, region)
    return 0.0, (met.height if met.height < LOW_M else 0.6 * met.height) + 0.5 * body.height
