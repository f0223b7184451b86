"""One constellation being choreographed: what is known so far of starts, paths and times."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math
from typing import TYPE_CHECKING

import numpy as np

from esg.dynamics.story.edges import edge_of
from esg.dynamics.story.kinematics import Frame, Track, wrap_angle
from esg.dynamics.story.paces import (
    EVERYDAY,
    on_foot,
    pace,
    stated_speeds,
    top_speed,
    usual_halt,
)
from esg.dynamics.story.sides import stated_turn
from esg.dynamics.story.stagecraft import (
    Prop,
    climb_height,
    default_speed,
    ground_friction,
    prop,
    stays_on,
    support_of,
    top_surface,
)
from esg.dynamics.story.story import CRUISES, UNDISTURBED, Phase, Story, bounds, stranded
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, Predicate, TimelineNode
from esg.layout.problem.hints import Constellation, Corridor, Placement

if TYPE_CHECKING:
    from esg.dynamics.choreography.falling.falls import Flight
    from esg.dynamics.choreography.flights import Arc

CLEARANCE_M = 0.35
RUN_OUT_M = 1.0
HIT_ON_TOP = 1.25
"""Speed of a hit on a table over the least one that will do."""
SEEN_MPS = 0.32
"""What moves on a short table is no slower than what is surely seen to move."""
APART_M, BESIDE = 4.0, 1.5
"""Between two paths of which none knows the other; of those who go side by side so many times the
size of one of them, if that is less."""
FLAT_M = 0.05
"""What is fixed and no higher is ground."""
ON_TOP_M, LEAST_GAP_M = 0.14, 0.05
"""Gap to what is passed, gone round or gone to on a table, and the least one."""
FASTEST_MPS = 22.0
"""A guessed speed is raised up to here where an event needs it."""


@dataclass(frozen=True)
class Encounter:
    """An event of two participants.

    Args:
        node: The event.
        a: Who comes: by itself, or as what was hit before.
        b: What it comes to.
        phase: The segment of a that ends there, None where it has none.
        other: The segment of b that ends there, None where it waits.
    """

    node: TimelineNode
    a: str
    b: str
    phase: Phase | None
    other: Phase | None = None

    @property
    def coming(self) -> Phase:
        """The segment of a, where there is one."""
        assert self.phase is not None
        return self.phase

    def turned(self) -> Encounter:
        """The same with the roles exchanged."""
        return Encounter(self.node, self.b, self.a, self.other, self.phase)


class Stage:
    """Participants whose motions touch each other; metres and radians, in a frame of their own.

    The handlers of the events (`telling.HANDLERS`) and `pockets` fill it in the story's order.

    Attributes:
        nominal: Control parameters found so far ("edge id/speed" -> SI value).
        time: Time of each event told so far, by node id [s].
        places: Start position [m] and yaw [rad] (None: any) by key; see `key`.
        heights: Height of the bottom at the start [m], of those that do not start on a support.
        tracks: Path of each active body, in the body's own frame.
        frames: From an active body's own frame to the constellation's, once known.
        moving: Path of each passive body that was set in motion, in the constellation's frame.
        elsewhere: Times of events of other constellations, which this one's may be timed from.
        yaw: World yaw [rad] of the constellation's frame, where the prompt states a course.
        tight: Factor on free distances and times; below 1 where space is short.
        anchor: The table or shelf it all takes place on, None for the ground.
        airborne: Actors that left their support (`falls.Flight`).
        arcs: Flights of thrown actors after their last event (`flights.Arc`).
        tipped: Actors that fell over where they stood.
        thrown_back: Actors that bounced off something.
        way_back: Least way [m] from there to what an actor meets next behind its start.
        struck: Speed that a hit gave to what goes on under its own power [m/s].
        met: What each actor met last.
        overtaken: Who was overtaken, by whom, when [s] and where on that one's way [m].
        landed: How many have leapt onto something.
        let_go: What is let go over something, in the order told.
        lifted: An actor without a place of its own that starts on the anchor beside its target.
        goes_down: Whether the lead is let go at the top of a ramp and meets nothing there.
        edge_run: Distance [m] from the lead's start to the anchor's edge, None if it does not
            matter.
    """

    def __init__(
        self,
        doc: EsgDocument,
        story: Story,
        names: set[str],
        rng: np.random.Generator,
        tight: float = 1.0,
        elsewhere: dict[str, float] | None = None,
    ) -> None:
        self.doc, self.story, self.names, self.rng = doc, story, names, rng
        self.elsewhere = elsewhere or {}
        self.nominal: dict[str, float] = {}
        self.time: dict[str, float] = {}
        self.places: dict[str, tuple[float, float, float | None]] = {}
        self.heights: dict[str, float] = {}
        self.tracks = {a: Track() for a in story.phases if a in names}
        self.frames: dict[str, Frame] = {}
        self.moving: dict[str, Track] = {}
        self.airborne: dict[str, Flight] = {}
        self.arcs: dict[str, Arc] = {}
        self.tipped: set[str] = set()
        self.edge_run: float | None = None
        self.goes_down = False
        self.thrown_back: set[str] = set()
        self.way_back: dict[str, float] = {}
        self.struck: dict[str, float] = {}
        self.met: dict[str, str] = {}
        self.overtaken: dict[str, tuple[str, float, tuple[float, float]]] = {}
        self._next_phase = {a: 0 for a in self.tracks}
        self.yaw: float | None = None
        self.tight = tight
        actors = sorted(
            self.tracks, key=lambda a: list(story.nodes).index(story.phases[a][0].start.id)
        )
        self.lead = actors[0]
        self.landed: dict[str, int] = {}
        self.let_go: dict[str, list[str]] = {}
        self.lifted: str | None = None
        self.anchor = None if self.story.flies(self.lead) else support_of(doc, self.lead)
        if self.anchor is None and not self.story.flies(self.lead):
            self._climb()

    def _climb(self) -> None:
        """Puts the lead where its first target stands, if that is out of its reach from below.

        A cat that knocks a glass off a shelf is on the shelf.
        """
        first = self.story.phases[self.lead][0]
        end = first.end
        if first.edge.event is EdgeEvent.DRIVE:
            return  # where its joint holds it
        if end.event is NodeEvent.MISS:
            return  # who only passes a thing goes past what carries it
        body = self.prop(self.lead)
        for name in end.participants:
            support = None if name == self.lead else support_of(self.doc, name)
            if support is None:
                continue
            height = climb_height(self.doc, body, support)
            if height is not None:
                self.anchor, self.lifted = support, self.lead
                self.heights[self.lead] = height

    def tighter(self) -> Stage:
        """An empty stage for the same participants with less room, drawing on from this one's."""
        tight = self.tight * 0.7
        return Stage(self.doc, self.story, self.names, self.rng, tight, self.elsewhere)

    def leaves_its_support(self) -> bool:
        """Whether what starts on the anchor shall meet something that stands elsewhere."""
        if self.airborne or self.goes_down:
            return True
        members = [self.member(k) for k in self.places]
        own = {self.anchor, self.lifted}
        return any(m not in own and support_of(self.doc, m) != self.anchor for m in members)

    def start_at_edge(self, lane: tuple[int, int] = (0, 1)) -> bool:
        """Moves everything so that what leaves the anchor first stands at its edge, facing off it.

        That is the lead, or what stands before it on the anchor: a block that is pushed off a
        table waits at the edge, and what pushes it starts behind it on the table.

        Args:
            lane: Which lane along the edge it takes, of how many.

        Returns:
            Whether what starts on the anchor has room behind the edge; nothing moves otherwise.
        """
        assert self.anchor is not None
        surface = top_surface(self.doc, self.anchor)
        edge = edge_of(self.doc, self.anchor)
        on_it = [k for k in self.places if self._starts_on_anchor(k)]
        first = max(on_it or [self.lead], key=lambda k: (self.places[k][0], k == self.lead))
        body = self.prop(first)
        inset = 0.6 * body.half_length + 0.05
        if first == self.lead:
            inset = self.inset(first)
        x, y, _ = self.places[self.lead]
        dx, dy = edge.at - inset - self.places[first][0], surface.center_cm[1] / 100.0 - y
        dy += (2 * lane[0] + 1 - lane[1]) / lane[1] * surface.half_extents_cm[1] / 100.0
        if first != self.lead:
            room = surface.half_extents_cm[0] / 50.0
            if edge.at - (x + dx - self.prop(self.lead).half_length) > room:
                return False
        self.places = {k: (px + dx, py + dy, yaw) for k, (px, py, yaw) in self.places.items()}
        self.frames = {a: Frame(f.x + dx, f.y + dy, f.angle) for a, f in self.frames.items()}
        for track in self.moving.values():
            track.points = [(px + dx, py + dy) for px, py in track.points]
        if edge.backwards:
            self._turn_round()
        return True

    def inset(self, lead: str) -> float:
        """Distance [m] from the anchor's edge at which what leaves it by itself starts."""
        assert self.anchor is not None
        body, surface = self.prop(lead), top_surface(self.doc, self.anchor)
        inset = self.edge_run or 0.6 * body.half_length + 0.05
        if body.wheeled and 2.0 * body.half_length < surface.half_extents_cm[0] / 50.0:
            inset = max(inset, body.half_length)
        return inset

    def _starts_on_anchor(self, key: str) -> bool:
        """Whether what is placed under a key starts on the anchor, not above or beside it."""
        name = self.member(key)
        if name in self.heights and name != self.lifted:
            return False
        return name == self.lifted or support_of(self.doc, name) == self.anchor

    def _turn_round(self) -> None:
        """Turns everything by half a turn about the anchor's origin."""
        turn = Frame(angle=math.pi)
        self.places = {
            k: (*turn.apply(x, y), None if yaw is None else yaw + math.pi)
            for k, (x, y, yaw) in self.places.items()
        }
        self.frames = {
            a: Frame(*turn.apply(f.x, f.y), f.angle + math.pi) for a, f in self.frames.items()
        }
        for track in self.moving.values():
            track.points = [turn.apply(*p) for p in track.points]
            track.x, track.y = turn.apply(track.x, track.y)
            track.heading += math.pi

    # -- who is who --------------------------------------------------------------------------

    def key(self, name: str) -> str:
        """What is placed for a node: the node, or "group:name" for a pattern it belongs to."""
        group = self.story.group_of.get(name)
        patterned = group and self.doc.spatial_relation_graph.nodes[name].group_pattern
        return f"group:{group}" if group and patterned else name

    def member(self, key: str) -> str:
        """One node of what is placed under a key."""
        return self.story.groups[key[6:]][0] if key.startswith("group:") else key

    def prop(self, key: str) -> Prop:
        found = prop(self.doc, self.member(key))
        return replace(found, grouped=True) if key.startswith("group:") else found

    def ground_friction(self) -> float:
        """Friction of what it all takes place on."""
        if self.anchor is not None:
            return self.prop(self.anchor).friction
        return ground_friction(self.doc)

    def concerns(self, node: TimelineNode) -> bool:
        """Whether an event has a participant on this stage."""
        return bool(set(node.participants) & self.names)

    # -- phases, speeds and times ------------------------------------------------------------

    def incoming(self, node: TimelineNode) -> list[tuple[str, Phase]]:
        """Actors and phases that end in this event; phases that already ended are passed over."""
        out: list[tuple[str, Phase]] = []
        for actor in self.tracks:
            phases = self.story.phases[actor]
            k = self._next_phase[actor]
            while k < len(phases) and phases[k].end.id != node.id and phases[k].end.id in self.time:
                k += 1
            if k < len(phases) and phases[k].end.id == node.id:
                self._next_phase[actor] = k + 1
                if self.strands(phases[k]):
                    continue
                track = self.tracks[actor]
                track.time = max(track.time, self.time.get(phases[k].start.id, 0.0))
                out.append((actor, phases[k]))
        return out

    def strands(self, phase: Phase) -> bool:
        """Whether an actor stays where it ran into something fixed until another one comes."""
        return stranded(self.story, phase, lambda name: self.prop(self.key(name)).fixed)

    def keeps_to_its_top(self, actor: str) -> bool:
        """Whether it moves on the table that carries all of this, and shall not leave it."""
        name = self.member(actor)
        return self.anchor is not None and stays_on(self.doc, name) == self.anchor

    def gap(self, actor: str, usual: float) -> float:
        """Gap [m] from an actor's way to what stands beside it: less on a table."""
        if self.anchor is None:
            return usual
        most = min(usual, ON_TOP_M) if self.keeps_to_its_top(actor) else usual
        return max(most * self.tight, LEAST_GAP_M)

    def speed(self, actor: str, phase: Phase, least: float = 0.0, needed: float = 0.0) -> float:
        """A plausible speed [m/s] of at least `least` within the segment's bounds.

        Guessed bounds give way to `needed`, without which an event cannot happen; on a table that
        is short it is slower.
        """
        speed = self._speed(actor, phase, least, needed)
        if phase.edge.speed_is_prescribed or not self.keeps_to_its_top(actor):
            return speed
        last = not self.story.after(phase.end.id)
        if phase.end.event is NodeEvent.COLLISION and last:  # no harder than it has to: it stays
            speed = min(speed, max(HIT_ON_TOP * max(least, needed), SEEN_MPS))
        if self.tight >= 1.0:
            return speed
        said = {i for s in self.doc.statements or () if s.predicate is Predicate.FASTER_THAN
                for i in s.object}  # fmt: skip
        low = bounds(phase.edge.params.speed, (0.0, 0.0))[0] if self.member(actor) in said else 0.0
        return min(speed, max(speed * self.tight, SEEN_MPS, 0.01 * low, least, needed))

    def _speed(self, actor: str, phase: Phase, least: float, needed: float) -> float:
        """That speed where there is room enough."""
        who, backward = self.member(actor), phase.edge.params.backward is True
        top = top_speed(self.doc, who, backward)
        usual = min(default_speed(self.prop(actor)), EVERYDAY * top)
        usual = min(usual, pace(self.doc, who).reverses) if backward else usual
        preferred = min(max(self._cruises(actor, phase) or usual, least), top)
        if phase.edge.params.speed is None:
            return self.tracks[actor].speed or preferred
        low, high, fixed = bounds(stated_speeds(self.doc, who, phase.edge), (100.0, 1000.0))
        if fixed:
            return low / 100.0
        inner = 0.1 * (high - low)
        speed = min(max(preferred, (low + inner) / 100.0), (high - inner) / 100.0)
        if not phase.edge.speed_is_prescribed and not low <= 100.0 * usual <= high:
            speed = max(0.005 * (low + high), least)  # a word of pace, not the kind, sets it
        if not phase.edge.speed_is_prescribed:
            speed = min(max(speed, min(needed, FASTEST_MPS)), top)
        return speed

    def slowly(self, actor: str, phase: Phase) -> float | None:
        """The most [m/s] that a word of pace ("creeps") leaves of a speed; None without one."""
        _, high, stated = bounds(phase.edge.params.speed, (0.0, 100.0 * FASTEST_MPS))
        usual = default_speed(self.prop(actor))
        open_ = phase.edge.params.speed is not None and not phase.edge.speed_is_prescribed
        return 0.01 * high if open_ and not stated and 0.01 * high < usual else None

    def _cruises(self, actor: str, phase: Phase) -> float | None:
        """Speed [m/s] of the segment before, where nothing has changed it since."""
        phases = self.story.phases[actor]
        before = phases[phases.index(phase) - 1] if phase is not phases[0] else None
        if before is None or before.end.event not in UNDISTURBED:
            return None
        return self.nominal.get(f"{before.edge.id}/speed") if before.edge.event in CRUISES else None

    def held(self, actor: str) -> bool:
        """Whether an actor is on its feet or wings, so that it slows down step by step.

        Its soles alone would stop it in their own time.
        """
        powered = self.story.phases[actor][0].edge.event is not EdgeEvent.TOWARD
        return self.story.soars(actor) or (powered and on_foot(self.prop(actor)))

    def halt(self, actor: str, speed: float) -> float:
        """The rate [m/s^2] at which an actor usually comes to rest from a speed [m/s]."""
        return usual_halt(self.doc, self.member(actor), speed, held=self.held(actor))

    def prescribed_time(self, node: TimelineNode) -> float | None:
        """Absolute time [s] the prompt asks for, or None."""
        for c in node.constraints:
            since = {**self.elsewhere, **self.time}.get(c.since or "")
            if c.quantity == "time_since" and since is not None:
                low, high, _ = bounds(c.value, (1.0, 1.0))
                return since + 0.5 * (low + high)
        if node.time_is_prescribed and node.timestamp is not None:
            return node.timestamp
        if node.time_is_prescribed and node.window is not None:
            return 0.5 * (node.window[0] + node.window[1])
        return None

    def stated_turn(self, node: TimelineNode, struck: str, by: str) -> float | None:
        """How the prompt has what is hit turned from what comes [rad]; None where that is open."""
        one, other = self.member(struck), self.member(by)
        return stated_turn(self.doc, node.id, one, other, self.rng)

    # -- room --------------------------------------------------------------------------------

    def reverse_yaw(self, actor: str) -> float:
        """Yaw added for a body that drives backwards."""
        return math.pi if self.story.reverses(actor) else 0.0

    def free_frame(self, actor: str) -> Frame:
        """A start beside everything placed so far, for an unrelated second path.

        As far off as the two are large on a table, and where all that stands there goes by itself,
        so that small things that go together are seen together.
        """
        if self.anchor is not None:
            wide = max((self.prop(a).width for a in self.tracks), default=0.0)
            apart = 2.0 * wide + LEAST_GAP_M
            return Frame(0.0, max(y for _, y, _ in self.places.values()) + apart, 0.0)
        far = max(y for _, y, _ in self.places.values()) + APART_M
        own = self.prop(actor)
        span, side = max(own.length, own.width), -math.inf
        for key, (_, y, _) in self.places.items():
            there = self.prop(key)
            if there.fixed and there.height < FLAT_M:
                continue
            if key not in self.tracks:
                return Frame(0.0, far, 0.0)
            side = max(side, y + 0.5 * max(there.length, there.width))
        beside = side + (0.5 + BESIDE) * span + CLEARANCE_M
        return Frame(0.0, min(far, beside) if side > -math.inf else far, 0.0)

    def free_heading(self, x: float, y: float) -> float:
        """An approach direction towards (x, y) far from those already in use."""
        used = [
            math.atan2(y - f.apply(0, 0)[1], x - f.apply(0, 0)[0]) for f in self.frames.values()
        ]
        used += [t.heading for t in self.moving.values()]
        used += [t.heading + math.pi for t in self.moving.values()]
        options = [math.pi, math.pi / 2, -math.pi / 2, 0.75 * math.pi, -0.75 * math.pi, 0.0]
        return max(options, key=lambda o: min([abs(wrap_angle(o - u)) for u in used], default=1.0))

    # -- result ------------------------------------------------------------------------------

    def constellation(self) -> Constellation:
        """Placements and the corridors to keep free, in centimetres and degrees."""
        placements = tuple(
            Placement(
                node=key,
                x_cm=100.0 * x,
                y_cm=100.0 * y,
                yaw_deg=None if yaw is None else math.degrees(yaw),
                z_cm=100.0 * self.heights[key] if key in self.heights else None,
            )
            for key, (x, y, yaw) in self.places.items()
        )
        everyone = tuple(self.places)
        corridors: list[Corridor] = []
        for name, track in {**self.tracks, **self.moving}.items():
            frame = self.frames.get(name, Frame()) if name in self.tracks else Frame()
            points = [frame.apply(*p) for p in track.points]
            end = track.heading + frame.angle
            run_out = RUN_OUT_M * self.tight
            points.append(
                (points[-1][0] + run_out * math.cos(end), points[-1][1] + run_out * math.sin(end))
            )
            width = self.prop(name).half_width + CLEARANCE_M * self.tight
            corridors.append(
                Corridor(tuple((100.0 * x, 100.0 * y) for x, y in points), 100.0 * width, everyone)
            )
        yaw_deg = None if self.yaw is None or self.anchor is not None else math.degrees(self.yaw)
        return Constellation(placements, tuple(corridors), anchor=self.anchor, yaw_deg=yaw_deg)


def speed_is_fixed(phase: Phase) -> bool:
    """Whether the document leaves no choice of the segment's speed."""
    return bounds(phase.edge.params.speed, (1.0, 2.0))[2]
