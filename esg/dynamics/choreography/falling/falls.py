"""Leaving a support: pushed or rolled over the edge, tipped over, landing on or in something."""

from __future__ import annotations

from dataclasses import dataclass
import math

from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.slabs import REACH, are_slabs, down_first
from esg.dynamics.story.stagecraft import Prop, coasting_drag, lies_on, support_of, top_surface
from esg.dynamics.story.story import Phase, bounds
from esg.graph.models import NodeEvent, TimelineNode
from esg.units import GRAVITY_MPS2

CLEAR_OF_EDGE_M = 0.04
EDGE_SPEED_MPS = 0.6
"""Least speed over an edge: slower bodies tip and tumble close to it."""
CLEAN = 0.7
"""The same for a long body, over sqrt(g l / 2): it tips as long as half of it is over the edge."""
COUNTS_AS_FALL = 0.75
"""Share of its height by which a body has to come down for its fall to be one."""
FALLEN, PAST_HALF, NEAR = 0.82, 1.4, 0.3
"""How far from the foot of what tips over something stands, over the one's height, over its own and
at least over the one's: it is met well after half of the fall, which is when that counts as one."""
ROLLS_ON = 0.3
"""What is to stay on something comes down so far before its middle, over half of its length: it
rolls or slides on."""
MEETINGS = (NodeEvent.COLLISION, NodeEvent.REACH, NodeEvent.ENTER_REGION)


@dataclass(frozen=True)
class Flight:
    """What left its support.

    Args:
        speed: Horizontal speed at the edge [m/s].
        height: Height of its bottom at the edge [m].
    """

    speed: float
    height: float

    def time_to(self, height: float) -> float:
        """Free fall down to a height [s]."""
        return math.sqrt(2.0 * max(self.height - height, 0.0) / GRAVITY_MPS2)


def goes_over_edge(stage: Stage, actor: str, node: TimelineNode) -> bool:
    """Whether an actor on a table or shelf shall fall off it by its own motion."""
    return (
        node.event is NodeEvent.FALL
        and stage.anchor is not None
        and not stage.story.flies(actor)
        and support_of(stage.doc, actor) == stage.anchor
    )


def over_edge(stage: Stage, actor: str, phase: Phase, node: TimelineNode) -> None:
    """The actor starts near the edge and leaves it fast enough to come down where it shall."""
    track, body = stage.tracks[actor], stage.prop(actor)
    height = surface_height(stage)
    run = edge_run(stage, body)
    low, high, fixed = bounds(phase.edge.params.speed, (10.0, 400.0))
    drag = coasting_drag(body)
    speed = max(edge_speed(body), landing_speed(stage, actor, node, height))
    launch = math.sqrt(speed * speed + 2.0 * drag * run)
    if fixed:
        launch = low / 100.0
        run = min(run, 0.5 * launch * launch / max(drag, 1e-3))
        speed = math.sqrt(max(launch * launch - 2.0 * drag * run, 0.04))
    elif phase.edge.speed_is_prescribed:
        launch = min(max(launch, low / 100.0), high / 100.0)
        speed = math.sqrt(max(launch * launch - 2.0 * drag * run, 0.04))
    stage.edge_run = run
    stage.nominal[f"{phase.edge.id}/speed"] = launch
    track.straight(run, 2.0 * run / (launch + speed), speed)
    stage.airborne[actor] = Flight(speed, height)
    stage.time[node.id] = track.time + math.sqrt(2.0 * 1.1 * body.height / GRAVITY_MPS2)


def land(stage: Stage, e: Encounter) -> None:
    """Puts b where a comes down."""
    node, a, b = e.node, e.a, e.b
    flight, track = stage.airborne[a], stage.tracks[a]
    pb = stage.prop(b)
    into = node.event is NodeEvent.ENTER_REGION
    beside = not into and flight.height - pb.height < COUNTS_AS_FALL * stage.prop(a).height
    duration = flight.time_to(0.0 if beside else pb.height)
    track.straight(flight.speed * duration, duration, flight.speed)
    frame = stage.frames.setdefault(a, Frame())
    ax, ay = frame.apply(0.0, 0.0)
    stage.places[a] = (ax, ay, frame.angle)
    heading = track.heading + frame.angle
    x, y = frame.apply(track.x, track.y)
    # What is hardly lower would stop its fall: it is met from the side, on the ground.
    reach = stage.prop(a).half_length + pb.half_length if beside else 0.0
    if lies_on(stage.doc, stage.member(a), stage.member(b)):
        reach += ROLLS_ON * pb.half_length
    x, y = x + reach * math.cos(heading), y + reach * math.sin(heading)
    stage.places[b] = (x, y, heading + math.pi)
    stage.time[node.id] = track.time


def lands(stage: Stage, e: Encounter) -> bool:
    """Whether a left its support and b waits below it."""
    flight, b, name = stage.airborne.get(e.a), e.b, stage.member(e.b)
    if flight is None or b in stage.places or b == stage.anchor:
        return False
    if stage.doc.spatial_relation_graph.nodes[name].is_structural:
        return False
    return support_of(stage.doc, name) is None and flight.height > 0.05


def landing_speed(stage: Stage, actor: str, node: TimelineNode, height: float) -> float:
    """Speed [m/s] at the edge with which the actor comes down clear of its own support."""
    for later in stage.story.after(node.id):
        if later.event not in MEETINGS or actor not in later.participants:
            continue
        others = [p for p in later.participants if p != actor]
        if later.region:
            others.insert(0, later.region.split("/")[0])
        if not others or others[0] not in stage.doc.spatial_relation_graph.nodes:
            continue
        target = stage.prop(others[0])
        time = math.sqrt(2.0 * max(height - target.height, 0.05) / GRAVITY_MPS2)
        return (target.half_length + CLEAR_OF_EDGE_M) / time
    return 0.0


def edge_speed(body: Prop) -> float:
    """Least speed [m/s] with which a body goes over an edge before it has tipped far."""
    if body.rolls:
        return EDGE_SPEED_MPS
    return max(EDGE_SPEED_MPS, CLEAN * math.sqrt(GRAVITY_MPS2 * body.half_length))


def edge_run(stage: Stage, body: Prop) -> float:
    """Run [m] from the start of a body to the edge."""
    least = 0.6 * body.half_length + 0.05
    assert stage.anchor is not None
    room = 0.5 * stage.prop(stage.anchor).half_length
    return max(least, min(0.35 if body.rolls or body.wheeled else 0.15, room))


def surface_height(stage: Stage) -> float:
    """Height [m] of the highest surface of the anchor."""
    assert stage.anchor is not None
    return top_surface(stage.doc, stage.anchor).center_cm[2] / 100.0


def tipping_speed(length: float, height: float) -> float:
    """Speed [m/s] of the centre that tips a box over its front edge, with a margin of a third.

    Energy: the centre rises from h/2 to half the diagonal; the box turns about its edge with
    I = m (l^2 + h^2) / 3 while the centre moves at omega times half the diagonal.
    """
    diagonal = math.hypot(length, height)
    rise = 0.5 * (diagonal - height)
    omega = math.sqrt(2.0 * GRAVITY_MPS2 * rise * 3.0) / diagonal
    return 1.33 * omega * 0.5 * height


def tip_over(stage: Stage, actor: str, phase: Phase, node: TimelineNode) -> None:
    """The actor is pushed at its top and falls forward on the spot."""
    track, body = stage.tracks[actor], stage.prop(actor)
    first = phase is stage.story.phases[actor][0]
    base = body.length if first else min(body.length, body.width)
    vigour = 1.0 if first else 1.7
    stage.nominal[f"{phase.edge.id}/speed"] = vigour * tipping_speed(base, body.height)
    track.straight(0.0, 3.0 * math.sqrt(body.height / GRAVITY_MPS2), 0.0)
    stage.time[node.id] = track.time
    stage.tipped.add(actor)


def tips_onto(stage: Stage, e: Encounter) -> bool:
    """Whether a fell over where it stood."""
    return e.a in stage.tipped


def tip_onto(stage: Stage, e: Encounter) -> None:
    """Puts b within the reach of a, which falls towards it."""
    node, a, b = e.node, e.a, e.b
    track, pa, pb = stage.tracks[a], stage.prop(a), stage.prop(b)
    frame = stage.frames.setdefault(a, Frame())
    ax, ay = frame.apply(0.0, 0.0)
    stage.places[a] = (ax, ay, frame.angle)
    stage.time[node.id] = track.time
    if b in stage.places:
        return
    heading = track.heading + frame.angle
    reach = pa.half_length + pb.half_length
    if are_slabs(pa, pb) and down_first(pa.height, knocked=False):
        reach += REACH * pa.height
    else:
        reach += min(FALLEN * pa.height, max(PAST_HALF * pb.height, NEAR * pa.height))
    stage.places[b] = (ax + reach * math.cos(heading), ay + reach * math.sin(heading), heading)
