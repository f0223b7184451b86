"""What can happen between two participants of the story: `MEETINGS` is the table of contents.

Each meeting says when it applies and solves it in closed form: where the two start, when they meet
and how fast. The first one that applies takes place. Then `_afterwards` tells what follows from it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math

from esg.dynamics.choreography import (
    approaches,
    bounces,
    encounters,
    flights,
    overtaking,
    sweeps,
    swings,
)
from esg.dynamics.choreography.courses import chutes
from esg.dynamics.choreography.courses.tops import go_past
from esg.dynamics.choreography.falling import falls, throws
from esg.dynamics.choreography.hits import impacts
from esg.dynamics.choreography.hits.caroms import carom, is_carom
from esg.dynamics.choreography.moves import plain
from esg.dynamics.choreography.stage import Encounter, Stage
from esg.graph.models import NodeEvent, TimelineNode


@dataclass(frozen=True)
class Meeting:
    """One way in which two participants come together.

    Args:
        what: It in one sentence.
        applies: Whether it is what happens; changes nothing.
        solve: Gives both a place and the event a time.
    """

    what: str
    applies: Callable[[Stage, Encounter], bool]
    solve: Callable[[Stage, Encounter], None]


OVERTAKING = Meeting(
    "a drives past b, which drives the same way at a lower speed",
    overtaking.overtakes,
    overtaking.overtake,
)
AMONG_ACTORS = (
    Meeting(
        "a is let go over b, which ran into an obstacle and is there",
        encounters.drops_onto_waiting,
        encounters.drop_onto_waiting,
    ),
    Meeting(
        "a runs into the back of b, which ran into an obstacle and is there",
        encounters.runs_into_waiting,
        encounters.run_into_waiting,
    ),
    Meeting(
        "both are let go, one above the other, which meets it as it bounces back",
        encounters.both_are_dropped,
        encounters.drop_together,
    ),
    Meeting(
        "one is let go over the place that the other one has come to by then",
        encounters.one_is_dropped,
        encounters.drop_onto_moving,
    ),
    Meeting(
        "who overtook before comes in before the other one, slows down and is run into",
        encounters.cuts_in,
        encounters.cut_in,
    ),
    Meeting(
        "one runs into the back of the other one, which brakes or is slower",
        encounters.runs_into_rear,
        encounters.run_into_rear,
    ),
    Meeting(
        "one runs into the side of the other one, which goes across its way",
        encounters.drives_across,
        encounters.meet_across,
    ),
    Meeting(
        "they run, or are thrown, at each other",
        encounters.head_on,
        encounters.meet_head_on,
    ),
)
WITH_WHAT_WAITS = (
    Meeting(
        "a left its support and comes down on, in or beside b",
        falls.lands,
        falls.land,
    ),
    Meeting(
        "a tips over where it stands, and b is within its reach",
        falls.tips_onto,
        falls.tip_onto,
    ),
    Meeting(
        "a flies on from its last event, and b is where it comes down",
        flights.flies_on,
        flights.fly_on,
    ),
    Meeting(
        "a is thrown at the board of b, and from there into the hoop before it",
        flights.banks,
        flights.bank,
    ),
    Meeting(
        "a comes down on the top of b, and bounces on to something else",
        bounces.bounces_on,
        bounces.bounce_on,
    ),
    Meeting(
        "a hangs drawn back, is let go, and swings into b",
        swings.swings_in,
        swings.swing_in,
    ),
    Meeting(
        "a turns about an upright axle, and b stands in its sweep",
        sweeps.sweeps_in,
        sweeps.sweep_in,
    ),
    Meeting(
        "a slides out on its joint, and b stands in its way",
        swings.slides_in,
        swings.slide_in,
    ),
    Meeting(
        "a is let go over b",
        throws.is_let_go,
        throws.drop,
    ),
    Meeting(
        "a comes down a chute, and falls into b below its lip",
        chutes.falls_in,
        chutes.fall_in,
    ),
    Meeting(
        "a comes down a ramp, and b waits at its foot",
        approaches.comes_down,
        approaches.come_down,
    ),
    Meeting(
        "a brakes, and still gets to b",
        approaches.brakes,
        approaches.brake,
    ),
    Meeting(
        "a was pushed, and slides to b",
        approaches.slides,
        approaches.slide_in,
    ),
    Meeting(
        "a drives, walks, rolls, flies or is thrown straight at b",
        lambda stage, e: True,
        approaches.come,
    ),
)
RUNNING_ON = Meeting(
    "a was set in motion by an earlier hit, and runs on into b",
    lambda stage, e: e.phase is None,
    impacts.chain,
)
MEETINGS = (OVERTAKING, *AMONG_ACTORS, RUNNING_ON, *WITH_WHAT_WAITS)
"""Everything that can happen between two, tried in this order."""


def _take_place(stage: Stage, e: Encounter, meetings: tuple[Meeting, ...]) -> Meeting:
    """Solves the first meeting that applies."""
    found = next(m for m in meetings if m.applies(stage, e))
    found.solve(stage, e)
    return found


def collision(stage: Stage, node: TimelineNode) -> None:
    """Collision, Reach, Miss: who is on the way to whom decides how they come together."""
    if len(node.participants) < 2:
        plain(stage, node)
        return
    if node.id in stage.time:
        return  # planned with what led there
    a, b = stage.key(node.participants[0]), stage.key(node.participants[1])
    incoming = dict(stage.incoming(node))
    if a not in incoming and b in incoming:
        a, b = b, a
    e = Encounter(node, a, b, incoming.get(a), incoming.get(b))
    if not OVERTAKING.applies(stage, e):
        e = encounters.who_comes_to_whom(stage, e)
    fresh = e.phase is not None and e.b not in stage.places
    if _take_place(stage, e, MEETINGS) is not OVERTAKING:
        _afterwards(stage, e, fresh=fresh)
        go_past(stage, e)


def _afterwards(stage: Stage, e: Encounter, *, fresh: bool) -> None:
    """What follows from a meeting: how a goes on, and what it sets in motion.

    Args:
        stage: The stage.
        e: The meeting.
        fresh: It is the first one of b, which waited for it.
    """
    node, a, b = e.node, e.a, e.b
    if stage.met.get(a, b) != b and node.id in stage.time:
        return  # it goes on from there already
    if e.phase is not None and stage.story.flies(a) and node.event is NodeEvent.COLLISION:
        flights.leaves(stage, node, a, b)
    if flights.banked_into(stage, node, a, b) is not None:
        pass  # off the board it goes where it was aimed
    elif fresh and is_carom(stage, node, a, b):
        carom(stage, node, a, b)
    else:
        impacts.impact(stage, node, a, b)
    stage.met[a] = b


def enters(stage: Stage, node: TimelineNode) -> None:
    """The target region's owner is put in the way, its opening towards the mover."""
    mover = stage.key(node.participants[0])
    owner = (node.region or "/").split("/")[0]
    e = Encounter(node, mover, owner, dict(stage.incoming(node)).get(mover))
    if owner not in stage.doc.spatial_relation_graph.nodes:
        return
    if e.phase is not None:
        if node.id in stage.time and owner in stage.places:
            return
        if flights.flies_on(stage, e):
            flights.fly_on(stage, e)
            return
        if node.id in stage.time:
            return
        _take_place(stage, e, WITH_WHAT_WAITS)
    elif mover in stage.moving:
        RUNNING_ON.solve(stage, e)
    if owner in stage.places:
        _open_towards(stage, e)
    stage.time.setdefault(node.id, 1.0)


def _open_towards(stage: Stage, e: Encounter) -> None:
    """Turns what a enters towards it."""
    x, y, _ = stage.places[e.b]
    track = stage.moving.get(e.a) or stage.tracks.get(e.a)
    heading = 0.0
    if track:
        heading = track.heading + (stage.frames[e.a].angle if e.a in stage.frames else 0.0)
    stage.places[e.b] = (x, y, heading + math.pi)
    stage.time[e.node.id] = track.time if track else 1.0
    if e.phase is not None and stage.story.flies(e.a) and throws.is_lobbed(stage, e.node):
        flights.leaves(stage, e.node, e.a, e.b)
        stage.met[e.a] = e.b
