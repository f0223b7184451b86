"""Throws and drops: from where, and into which opening."""

from __future__ import annotations

from collections.abc import Sequence
import math

from esg.dynamics.choreography.falling.drops import POURED_M, due, room_of, several, share_out
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.dynamics.story.driving import QUICKLY_S
from esg.dynamics.story.kinematics import Frame
from esg.dynamics.story.stagecraft import (
    Prop,
    lies_on,
    prop,
    release_height,
    support_of,
    top_surface,
)
from esg.dynamics.story.story import Phase, Story, bounds
from esg.dynamics.story.suspension import landing_place
from esg.dynamics.story.tipping import FLIES_AT
from esg.engines.scene import Region
from esg.graph.models import EdgeEvent, NamedRegion, NodeEvent, RelationType, TimelineNode
from esg.units import GRAVITY_MPS2

HIGHEST_HAND_M = 1.7
"""Height up to which a throw starts level with its target."""
LOW_DROP_M = 0.2
"""What is dropped from a height starts at least this far above its target."""
IN_AFTER_S = 0.15
"""From when a lid is open to when what drops past it is there."""
SHORTEST_FALL_S, LONGEST_FALL_S = 0.2, 2.0
"""Of a drop whose height is open."""
BY_THE_EAR, ARMS_UP = 1.0, 1.25
"""Height of a hand that throws, and of one that shoots or tosses up, over the body's height."""
ARM_M = 0.1
"""From a body to what its hand lets go."""
HELD_AT, HELD_OUT = 0.65, 0.4
"""Height of a hand that holds something, and how far it reaches out, over the body's height."""
BESIDE_M = 0.05
"""From who drops something to the table that it falls on."""
LOW_M = 0.6
"""What is lower is hit from above by a hand's throw."""
SWUNG = 3.0
"""Length over width and height from which on something is swung."""
TOSS_M = 0.35
"""Height over a low container from which something is tossed into it."""


def level_height(target: Prop, thrown: Prop, duration: float, share: float = FLIES_AT) -> float:
    """Height [m] of the bottom at release of what, let go level, hits a body well above its middle.

    A slow throw that comes from higher up falls onto its target instead of knocking it over.

    Args:
        target: What is hit.
        thrown: What hits it.
        duration: Of the flight [s].
        share: Of its height at which the target is hit.
    """
    drop = 0.5 * GRAVITY_MPS2 * duration * duration
    return max(share * target.height + drop - 0.5 * thrown.height, 0.05)


def sends_on(stage: Stage, node: TimelineNode, b: str) -> bool:
    """Whether something low on the ground shall go on to the next thing after being thrown at.

    From above it would be pressed to the ground instead.
    """
    body = stage.prop(b)
    if node.event is not NodeEvent.COLLISION or b in stage.tracks or body.fixed:
        return False
    if body.height > LOW_M or support_of(stage.doc, stage.member(b)) is not None:
        return False
    return any(
        n.event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
        and b in map(stage.key, n.participants)
        for n in stage.story.after(node.id)
    )


def is_swung(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether something long comes broadside to what it sends on: a bat or a club meets a ball."""
    body = stage.prop(a)
    long = body.length > SWUNG * max(body.width, body.height) and not body.wheeled
    return long and stage.story.flies(a) and sends_on(stage, node, b)


def putts(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether a sends a ball into something by flying at it: gently, or it jumps over."""
    if not stage.prop(b).rolls or not (stage.story.flies(a) and sends_on(stage, node, b)):
        return False
    on = [n for n in stage.story.after(node.id) if b in map(stage.key, n.participants)]
    return bool(on) and on[0].event is NodeEvent.ENTER_REGION


def hand_height(stage: Stage, node: TimelineNode, b: str, thrown: Prop, target: Prop) -> float:
    """Height [m] of a thrown body's bottom at release: what goes in somewhere low is tossed in."""
    usual = release_height(thrown, target)
    support = support_of(stage.doc, stage.member(b))
    if support is not None:
        raised = top_surface(stage.doc, support).center_cm[2] / 100.0 + 0.5 * target.height
        usual = max(usual, min(raised, HIGHEST_HAND_M) - 0.5 * thrown.height)
    if node.event is not NodeEvent.ENTER_REGION:
        return usual
    if not is_lobbed(stage, node):
        region = region_of(stage, node)
        middle = usual if region is None else region.center_cm[2] / 100.0
        return max(min(usual, middle), 0.05)
    return min(usual, max(target.height + TOSS_M, 0.6))


def thrower_of(stage: Stage, thrown: str) -> str | None:
    """Who throws, kicks or strikes something: stands beside it, faces it and does nothing else."""
    edges = stage.doc.spatial_relation_graph.edges.binary_relations
    name = stage.member(thrown)
    beside = {e.from_ for e in edges if e.to == name and e.relation_type is RelationType.NEAR}
    facing = {e.from_ for e in edges if e.to == name and e.relation_type is RelationType.FACE}
    acting = {p for n in stage.story.nodes.values() for p in n.participants}
    return min((beside & facing) - acting - set(stage.story.phases), default=None)


def within_reach(stage: Stage, node: TimelineNode, thrown: str, height: float) -> float:
    """A height [m] of release that the hand of who throws reaches; as it is where nobody does."""
    who = thrower_of(stage, thrown)
    if who is None:
        return height
    reach = ARMS_UP if node.event is NodeEvent.ENTER_REGION else BY_THE_EAR
    highest = reach * stage.prop(who).height - 0.5 * stage.prop(thrown).height
    return min(height, max(highest, 0.05))


def stand_behind(stage: Stage) -> None:
    """Sets who throws, kicks or strikes something behind it, at arm's length or less."""
    for thrown in [a for a in stage.tracks if a in stage.places]:
        who = thrower_of(stage, thrown)
        first = next(iter(stage.story.phases[thrown]), None)
        if who is None or first is None or first.edge.event is not EdgeEvent.TOWARD:
            continue
        if support_of(stage.doc, who) is not None or support_of(stage.doc, stage.member(thrown)):
            continue
        if is_dropped(first) and stand_in_front(stage, who, thrown, first):
            continue
        x, y, _ = stage.places[thrown]
        heading = stage.frames[thrown].angle if thrown in stage.frames else 0.0
        back = 0.5 * (stage.prop(who).length + stage.prop(thrown).length) + ARM_M
        stage.places[who] = (x - back * math.cos(heading), y - back * math.sin(heading), heading)


def stand_in_front(stage: Stage, who: str, thrown: str, phase: Phase) -> bool:
    """Sets who drops something onto a table or a bench before it, and the drop within his reach.

    Args:
        stage: Where everything is put.
        who: Who drops it.
        thrown: What falls.
        phase: Its fall.

    Returns:
        Whether something is in his way if he stands where he otherwise would.
    """
    owner = (phase.end.region or "").partition("/")[0]
    named = [owner] if owner else phase.end.participants
    below = [k for p in named if (k := stage.key(p)) != thrown]
    if not below or below[0] not in stage.places or below[0] in stage.tracks:
        return False
    body, target, b = stage.prop(who), stage.prop(below[0]), below[0]
    if target.config is None or not target.config.proxies:
        return False
    carrier = support_of(stage.doc, stage.member(b))
    across = max(target.length, 0.0 if carrier is None else prop(stage.doc, carrier).length)
    clear = 0.5 * (body.length + across) + BESIDE_M
    if clear <= 0.5 * (body.length + stage.prop(thrown).length) + ARM_M:
        return False
    bx, by, angle = stage.places[b]
    frame = Frame(bx, by, angle or 0.0)
    along = min(max(clear - HELD_OUT * body.height, 0.0), 0.5 * target.length)
    if along and region_of(stage, phase.end) is None:
        x, y = frame.apply(along, 0.0)
        stage.places[thrown] = (x, y, stage.places[thrown][2])
        stage.frames[thrown] = Frame(x, y, 0.0)
    x, y = frame.apply(clear, 0.0)
    stage.places[who] = (x, y, frame.angle + math.pi)
    return True


def region_of(stage: Stage, node: TimelineNode) -> NamedRegion | None:
    """The region an event is about."""
    owner, _, name = (node.region or "").partition("/")
    nodes = stage.doc.spatial_relation_graph.nodes
    if owner not in nodes:
        return None
    regions = stage.doc.asset_configurations[nodes[owner].asset_id].regions
    return next((r for r in regions if r.name == name), None)


def opens_upwards(regions: Sequence[NamedRegion | Region], name: str) -> bool:
    """Whether a region is entered from above: a bucket or a hoop, not a goal or a pocket.

    Args:
        regions: All regions of its owner.
        name: Its own name.
    """
    region = next((r for r in regions if r.name == name), None)
    if region is None:
        return True
    if name.rpartition("/")[2] == "hoop":
        return True
    sideways = any(r.kind == "goal" and r.name.rpartition("/")[2] == "goal" for r in regions)
    return not sideways and region.kind != "goal"


def is_lobbed(stage: Stage, node: TimelineNode) -> bool:
    """Whether what is thrown into the region of an event has to come down into it."""
    owner, _, name = (node.region or "").partition("/")
    nodes = stage.doc.spatial_relation_graph.nodes
    if node.event is not NodeEvent.ENTER_REGION or owner not in nodes:
        return False
    return opens_upwards(stage.doc.asset_configurations[nodes[owner].asset_id].regions, name)


def comes_to_lie(stage: Stage, node: TimelineNode, a: str, b: str) -> bool:
    """Whether what is thrown at something comes down on its top, where it is said to stay."""
    flies = stage.story.flies(a) and not stage.story.soars(a)
    hits = node.event is NodeEvent.COLLISION
    return flies and hits and lies_on(stage.doc, stage.member(a), stage.member(b))


def slowest_passage(stage: Stage, node: TimelineNode) -> float:
    """Way [m] through the region of an event at floor level; large where it does not matter."""
    region = region_of(stage, node)
    if region is None or region.kind not in ("inside", "hole"):
        return 100.0
    return 0.02 * region.half_extents_cm[0]


def is_dropped(phase: Phase) -> bool:
    """Whether a phase lets something go with no speed of its own."""
    speed = phase.edge.params.speed
    if phase.edge.event is not EdgeEvent.TOWARD or speed is None:
        return False
    return bounds(speed, (0.0, 0.0))[1] <= 1.0


def stated_height(story: Story, node: TimelineNode, thing: str) -> float | None:
    """The height [m] at which the prompt has a body start, None if it states none."""
    stated = [c for n in (node, *story.nodes.values()) for c in n.constraints]
    return next(
        (
            sum(bounds(c.value, (1, 1))[:2]) / 200.0
            for c in stated
            if c.quantity == "height" and c.object == thing
        ),
        None,
    )


def asked_height(stage: Stage, node: TimelineNode, a: str) -> float | None:
    """`stated_height` of a body, by its key on the stage."""
    return stated_height(stage.story, node, stage.member(a))


def is_let_go(stage: Stage, e: Encounter) -> bool:
    """Whether a falls without a speed of its own, or falls on after it was dropped."""
    first = stage.story.phases[e.a][0]
    released = is_dropped(first) or first.edge.event is EdgeEvent.GUIDE
    on = e.coming.edge.params.speed is None and released
    return is_dropped(e.coming) or on


def drop(stage: Stage, e: Encounter) -> None:
    """A body let go above its target, at the prescribed height, or as high as its time asks."""
    node, a, b = e.node, e.a, e.b
    pb = stage.prop(b)
    region = region_of(stage, node)
    if a in stage.places and b not in stage.places:
        # It fell through something: what is below catches it.
        stage.places[b] = (*stage.places[a][:2], 0.0)
        stage.tracks[a].time += 0.4
        stage.time[node.id] = stage.tracks[a].time
        return
    stage.places.setdefault(b, (0.0, 0.0, 0.0 if region is None else math.pi))
    x, y, yaw = stage.places[b]
    if region is not None:
        # Into the hoop, not onto its post.
        cx, cy, _ = region.center_cm
        x, y = Frame(x, y, yaw or 0.0).apply(cx / 100.0, cy / 100.0)
    along, top = landing_place(stage.doc, stage.member(b)) or (0.0, pb.height)
    x, y = Frame(x, y, yaw or 0.0).apply(along, 0.0) if along else (x, y)
    height = max(drop_height(stage, node, a, pb), _past_the_lid(stage, node, a))
    dx, dy, up = share_out(stage, a, b, room_of(stage, b, region), round_=region is not None)
    x, y = Frame(x, y, yaw or 0.0).apply(dx, dy)
    height += up
    stage.places[a] = (x, y, 0.0)
    stage.frames[a] = Frame(x, y, 0.0)
    stage.heights[a] = top + height
    stage.tracks[a].time += math.sqrt(2.0 * height / GRAVITY_MPS2)


def _past_the_lid(stage: Stage, node: TimelineNode, a: str) -> float:
    """Height [m] from which a drop takes until what it falls into has opened; 0 if it is open.

    It is let go at the start: nothing would hold it in the air.
    """
    owner = (node.region or "").partition("/")[0]
    if stage.prescribed_time(node) is not None or asked_height(stage, node, a) is not None:
        return 0.0
    told = [*stage.story.nodes.values()]
    opens = [n for n in told[: told.index(node)] if n.event is NodeEvent.OPEN]
    lids = {j.child for j in stage.doc.spatial_relation_graph.joints or () if j.parent == owner}
    opened = [stage.time.get(n.id, QUICKLY_S) for n in opens if lids & {*n.participants}]
    return fallen(max(opened) + IN_AFTER_S - stage.tracks[a].time) if opened else 0.0


def fallen(duration: float) -> float:
    """Way [m] of a free fall in a given time, which a drop of more than 20 m is not given."""
    return 0.5 * GRAVITY_MPS2 * min(max(duration, SHORTEST_FALL_S), LONGEST_FALL_S) ** 2


def held_height(stage: Stage, a: str, target: Prop) -> float:
    """Height [m] over its target from which a hand lets something go; a metre without a hand."""
    who = thrower_of(stage, a)
    tall = 0.0 if who is None else stage.prop(who).height
    if target.height + LOW_DROP_M > BY_THE_EAR * tall:
        return 1.0
    return min(1.0, max(HELD_AT * tall - target.height, LOW_DROP_M))


def drop_height(stage: Stage, node: TimelineNode, a: str, target: Prop) -> float:
    """Height [m] over its target from which a body is let go.

    As the prompt states it, else what its time to the hit takes, else that of the hand that holds
    it, at most a metre.
    """
    stated = asked_height(stage, node, a)
    if stated is None:
        time = stage.prescribed_time(node) or due(stage, node)
        if time is None:
            held = held_height(stage, a, target)
            return min(held, POURED_M) if several(stage, node) else held
        # What enters something does so with its middle.
        deep = 0.5 * stage.prop(a).height if node.event is NodeEvent.ENTER_REGION else 0.0
        return fallen(time - stage.tracks[a].time) - deep
    # A height is above the ground, if it can be.
    return stated - target.height if stated > target.height + LOW_DROP_M else stated
