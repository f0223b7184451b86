"""Putting what an actor meets where its path leads, with what it stands on."""

from __future__ import annotations

import math

from esg.dynamics.choreography.falling.throws import is_swung
from esg.dynamics.choreography.hovering import cruise
from esg.dynamics.choreography.kerbs import Kerb, kerb_passed, street_crossed
from esg.dynamics.choreography.stage import Stage
from esg.dynamics.story.driving import leaf_of
from esg.dynamics.story.kinematics import (
    Frame,
    frame_mapping,
    half_along,
    rolling_travel,
    sliding_travel,
)
from esg.dynamics.story.solid import beside_the_middle
from esg.dynamics.story.stagecraft import Prop, coasting_drag, support_of, target_yaw
from esg.dynamics.story.story import bounds
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    NodeEvent,
    Predicate,
    RegionType,
    TimelineNode,
)

BESIDE_M, WIDE = 0.3, 1.2
"""Gap between two that come to the same thing side by side, and how much wider than both it is."""
BESIDE_PASSED_M = 0.25
"""Gap to what is passed."""
SHORT_OF_M = 0.15
"""Gap that is left to what is reached."""


def goes_on(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether more is said of the target after this hit."""
    later = stage.story.after(node.id)
    return any(b in map(stage.key, n.participants) for n in later)


def hits_on(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether the target is to hit something else after this hit."""
    return any(
        n.event is NodeEvent.COLLISION and b in map(stage.key, n.participants)
        for n in stage.story.after(node.id)
    )


def rolls_on(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether a target is pushed on to something else on its wheels: it stands along the way.

    Across it its tyres would stop it within v^2 / (2 mu g).
    """
    return stage.prop(b).wheeled and hits_on(stage, node, b)


def shut_along(stage: Stage, node: TimelineNode, b: str) -> float | None:
    """Which way a leaf goes that this event pushes shut, from its yaw [rad]; None for all else."""
    name = stage.member(b)
    closes = any(
        n.event is NodeEvent.CLOSE and name in n.participants for n in stage.story.after(node.id)
    )
    leaf = leaf_of(stage.doc, name) if closes else None
    return None if leaf is None else leaf.arm - math.copysign(0.5 * math.pi, leaf.here * leaf.sense)


def asked_distance(stage: Stage, node: TimelineNode, a: str) -> float | None:
    """Distance [m] the prompt has `a` cover until the event, or None.

    At an event without a hit it is the gap that is left between the two.
    """
    for c in node.constraints:
        if c.quantity == "distance" and c.to is None and c.object == stage.member(a):
            low, high, _ = bounds(c.value, (100.0, 100.0))
            return max(0.005 * (low + high), 0.1)
    return None


def gap_at_start(stage: Stage, a: str, b: str) -> float | None:
    """How far [m] the prompt has two things from each other at the start, or None."""
    pair = {stage.member(a), stage.member(b)}
    for e in stage.doc.spatial_relation_graph.edges.binary_relations:
        if e.distance_cm is not None and {e.from_, e.to} == pair:
            low, high, _ = bounds(e.distance_cm, (100.0, 100.0))
            return max(0.005 * (low + high), 0.1)
    return None


def gap_left(stage: Stage, node: TimelineNode) -> tuple[str, str, float] | None:
    """Who the prompt has end how far from what ("stops 1 m in front of a wall"): a, b, gap [m]."""
    for c in node.constraints:
        if c.quantity == "distance" and c.to is not None:
            low, high, _ = bounds(c.value, (100.0, 100.0))
            return stage.key(c.object), stage.key(c.to), 0.005 * (low + high)
    return None


def join(stage: Stage, a: str, b: str, node: TimelineNode, gap: float = 0.0) -> None:
    """Puts the end of a's track at b's surface, by placing whichever is still free.

    Args:
        stage: What is placed so far.
        a, b: The mover and what it comes to.
        node: The event.
        gap: What is left between the two [m].
    """
    track, pa = stage.tracks[a], stage.prop(a)
    if b not in stage.places:
        frame = stage.frames.setdefault(a, Frame() if not stage.places else stage.free_frame(a))
        x, y = frame.apply(track.x, track.y)
        _place_target(stage, a, b, x, y, track.heading + frame.angle, pa, node, gap)
    elif a not in stage.frames:
        mate = _mate_at(stage, node, a, b)
        if mate is not None:
            _come_beside(stage, a, mate)
            return
        bx, by, byaw = stage.places[b]
        pb = stage.prop(b)
        if _was_struck(stage, node, b):
            # It is met head-on, on the line along which it was sent.
            moved = stage.moving[b]
            heading, wait = moved.heading + math.pi, track.time - moved.time
            way = sent(stage, b, max(wait, 0.0))
            bx, by = bx - way * math.cos(heading), by - way * math.sin(heading)
        else:
            turn = None if byaw is None else stage.stated_turn(node, b, a)
            heading = stage.free_heading(bx, by) if turn is None else (byaw or 0.0) - turn
        reach = pa.half_length + half_along(pb.length, pb.width, heading - (byaw or 0.0)) + gap
        if node.event is NodeEvent.REACH:
            reach += _room_to_stop(stage, node, a)
        end = (bx - reach * math.cos(heading), by - reach * math.sin(heading))
        stage.frames[a] = frame_mapping((track.x, track.y), track.heading, end, heading)
    if node.event is NodeEvent.REACH:
        stage.nominal[f"{node.id}/time"] = track.time
        if stays_there(stage, node, a):
            track.straight(*comes_to_rest(stage, a), 0.0)
    x, y = stage.frames[a].apply(0.0, 0.0)
    turned = math.pi / 2 if is_swung(stage, node, a, b) else stage.reverse_yaw(a)
    stage.places[a] = (x, y, stage.frames[a].angle + turned)


def _mate_at(stage: Stage, node: TimelineNode, a: str, b: str) -> str | None:
    """Who is told to come to b before a does; None where b has no room for both side by side."""
    pb, nodes = stage.prop(b), stage.story.nodes
    wide = max(pb.length, pb.width) > WIDE * (2.0 * stage.prop(a).width + BESIDE_M)
    for s in stage.doc.statements or ():
        if s.predicate is not Predicate.BEFORE or s.object[1:] != (node.id,) or not wide:
            continue
        first = nodes.get(s.object[0])
        keys = [] if first is None else list(map(stage.key, first.participants))
        mate = next((k for k in keys if k in stage.frames and k in stage.tracks and k != a), None)
        if b in keys and mate is not None and pb.fixed:
            return mate
    return None


def _come_beside(stage: Stage, a: str, mate: str) -> None:
    """Lets a come to what a mate has come to, in the lane beside that one's."""
    track, its, frame = stage.tracks[a], stage.tracks[mate], stage.frames[mate]
    aside = stage.prop(a).half_width + stage.prop(mate).half_width + BESIDE_M
    ahead = stage.prop(mate).half_length - stage.prop(a).half_length + its.points[1][0] - track.x
    x, y = frame.apply(ahead, -aside)
    stage.frames[a] = Frame(x, y, frame.angle)
    stage.places[a] = (x, y, frame.angle + stage.reverse_yaw(a))


def enter_beside(stage: Stage, actor: str) -> None:
    """Places an actor that meets nobody beside everything placed so far."""
    frame = stage.free_frame(actor) if stage.places else Frame()
    stage.frames[actor] = frame
    x, y = frame.apply(0.0, 0.0)
    stage.places[actor] = (x, y, frame.angle)
    if stage.story.flies(actor) and not stage.story.takes_off(actor):
        soars = stage.story.soars(actor)
        stage.heights.setdefault(actor, cruise(stage, actor) if soars else 1.0)


def _was_struck(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether b was set in motion by a hit that this event follows."""
    if b not in stage.moving or stage.moving[b].speed <= 0.0:
        return False
    before = stage.story.ancestors(node.id)
    return any(
        n.id in before and n.event is NodeEvent.COLLISION and b in map(stage.key, n.participants)
        for n in stage.story.nodes.values()
    )


def sent(stage: Stage, b: str, wait: float) -> float:
    """How far [m] what was struck gets in a given time."""
    body, moved = stage.prop(b), stage.moving[b]
    if body.rolls:
        rubs = 0.5 * (body.friction + stage.ground_friction())
        return rolling_travel(moved.speed, rubs, wait, moved.spin)[0]
    return sliding_travel(moved.speed, coasting_drag(body), wait)


def struck_again(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether another actor is to run into b after this hit."""
    return any(
        n.event is NodeEvent.COLLISION
        and b in (keys := list(map(stage.key, n.participants)))
        and any(k in stage.tracks and k != a for k in keys)
        for n in stage.story.after(node.id)
    )


def yaw_met(
    stage: Stage,
    node: TimelineNode,
    a: str,
    b: str,
    heading: float,
    turn: float | None,
    *,
    sets_off: bool = False,
) -> float:
    """Yaw [rad] of what is met: as is stated, along the way of what it goes on with, or across.

    Args:
        stage: What is placed so far.
        node: The event.
        a, b: The mover and what it comes to.
        heading: Of the mover [rad].
        turn: From there to b's yaw, where that is stated [rad].
        sets_off: Whether b goes on by itself.
    """
    if turn is not None:
        return heading + turn
    if sets_off or rolls_on(stage, node, b):
        return heading
    shut = shut_along(stage, node, b)
    if shut is not None:
        return heading - shut
    return target_yaw(stage.prop(b), heading, stage.rng, stage.prop(a))


def _place_target(
    stage: Stage,
    a: str,
    b: str,
    x: float,
    y: float,
    heading: float,
    pa: Prop,
    node: TimelineNode,
    ahead: float,
) -> None:
    """Puts b where a arrives: ahead of it, past it for a Miss, short of it for a Reach."""
    pb = stage.prop(b)
    sets_off = _sets_off(stage, node, b)
    turn = stage.stated_turn(node, b, a)
    yaw = yaw_met(stage, node, a, b, heading, turn, sets_off=sets_off)
    if node.event is NodeEvent.ENTER_REGION or (stage.story.flies(a) and _is_hoop(pb)):
        # Its opening towards what comes (`meetings.enters`).
        yaw = heading + math.pi
    lateral = float(stage.rng.uniform(-0.12, 0.12)) * min(
        pb.half_lateral(yaw - heading), pa.half_width
    )
    if node.event is NodeEvent.COLLISION and not stage.story.flies(a):
        off = beside_the_middle(pa, pb, heading - yaw)
        lateral = -off if off else lateral
    front = pa.half_length + half_along(pb.length, pb.width, yaw - heading) + ahead
    passed = node.event is NodeEvent.MISS
    kerb = kerb_passed(stage, a, b) if passed or ahead > 0.0 else None
    if passed:
        gap = asked_distance(stage, node, a) or stage.gap(a, BESIDE_PASSED_M)
        lateral = pa.half_width + pb.half_lateral(yaw - heading) + gap
        front = 0.0
    if kerb is not None:
        asked = asked_distance(stage, node, a) if passed else ahead
        yaw = heading + kerb.turned
        front, lateral = _at_kerb(kerb, pa, pb, asked, passed=passed)
    street = street_crossed(stage, a, b) if passed else None
    if street is not None:  # a crosswalk is passed on it: from kerb to kerb, not beside the road
        lateral, yaw = -0.01 * street.keeps * street.lane, heading + 0.5 * math.pi
    if node.event is NodeEvent.REACH:
        front += _room_to_stop(stage, node, a)
    cx = x + front * math.cos(heading) - lateral * math.sin(heading)
    cy = y + front * math.sin(heading) + lateral * math.cos(heading)
    stage.places[b] = (cx, cy, yaw + stage.reverse_yaw(b) if sets_off else yaw)
    if sets_off:
        stage.frames[b] = Frame(cx, cy, heading if turn is None else yaw)
    bring_support(stage, b, cx, cy, heading)


def _is_hoop(b: Prop) -> bool:
    """Whether it has a hoop, with a board behind it, that things are thrown at from its front."""
    return b.config is not None and any(r.name == "hoop" for r in b.config.regions)


def _at_kerb(
    kerb: Kerb, pa: Prop, pb: Prop, gap: float | None, *, passed: bool
) -> tuple[float, float]:
    """How far [m] ahead of a vehicle and to its left something stands at the kerb.

    Args:
        kerb: The kerb.
        pa, pb: The vehicle, and what stands there.
        gap: Between the two [m], None for the usual one.
        passed: The vehicle drives past it; else it stops beside it, or so far before it.
    """
    aside = kerb.gap_m(pa) if gap is None else gap
    if not passed:
        aside = min(kerb.gap_m(pa), aside)
    lateral = kerb.side * (pa.half_width + pb.half_lateral(kerb.turned) + aside)
    if passed:
        return 0.0, lateral
    before = math.sqrt(max((gap or 0.0) ** 2 - aside**2, 0.0))
    length = half_along(pb.length, pb.width, kerb.turned)
    return pa.half_length + (before + length if before > 0.0 else -length), lateral


def stays_there(stage: Stage, node: TimelineNode, a: str) -> bool:
    """Whether what is told of an actor ends with an event, so that it comes to rest there."""
    return a in stage.tracks and stage.story.phases[a][-1].end.id == node.id


def _room_to_stop(stage: Stage, node: TimelineNode, a: str) -> float:
    """Gap [m] to what is reached when the brakes set in."""
    after = [p for p in stage.story.phases.get(a, ()) if p.start.id == node.id]
    brakes = stays_there(stage, node, a) or any(p.edge.event is EdgeEvent.BRAKE for p in after)
    return SHORT_OF_M + (comes_to_rest(stage, a)[0] if brakes else 0.0)


def comes_to_rest(stage: Stage, a: str) -> tuple[float, float]:
    """Way [m] and time [s] in which an actor usually comes to rest from the speed it has."""
    speed = stage.tracks[a].speed
    rate = stage.halt(a, speed)
    return 0.5 * speed * speed / rate, speed / rate


def _sets_off(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether an actor waits until it is hit and then goes on by itself, along the hit's way."""
    if b not in stage.tracks or b in stage.frames:
        return False
    return stage.story.phases[b][0].start.id == node.id


def bring_support(stage: Stage, b: str, x: float, y: float, heading: float) -> None:
    """A target that stands on a table is met near the table's edge: the table comes along."""
    support = support_of(stage.doc, stage.member(b))
    if support is None or support == stage.anchor or support in stage.places:
        return
    ps = stage.prop(support)
    yaw = target_yaw(ps, heading, stage.rng)
    if hangs_on(stage.doc, stage.member(b)):
        # The wall behind what hangs on it, not under it.
        pb, own = stage.prop(b), stage.places[b][2] or 0.0
        behind = half_along(pb.length, pb.width, own - heading)
        behind += half_along(ps.length, ps.width, yaw - heading)
        c, s = math.cos(heading), math.sin(heading)
        stage.places[support] = (x + behind * c, y + behind * s, yaw)
        return
    inset = max(
        0.0, half_along(ps.length, ps.width, yaw - heading) - stage.prop(b).half_length - 0.08
    )
    nodes = stage.doc.spatial_relation_graph.nodes
    if not stage.doc.asset_configurations[nodes[support].asset_id].support_surfaces:
        # A head, a post: there is only the middle.
        inset = 0.0
    elif stage.story.falls(b):
        # What shall be knocked off stands at the far edge.
        inset = -inset
    stage.places[support] = (x + inset * math.cos(heading), y + inset * math.sin(heading), yaw)


def hangs_on(doc: EsgDocument, name: str) -> bool:
    """Whether a node hangs on a wall's face instead of standing on a surface."""
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions.get(graph.nodes[name].semantic_region or "")
    return region is not None and region.region_type is RegionType.ATTACHED_VERTICAL
