"""What an actor does: its phases and the values of theta as primitives of the control program."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
import math

import numpy as np
from numpy.typing import NDArray

from esg.assets.postures import seat_of
from esg.dynamics.choreography.courses.climbs import pushes_off
from esg.dynamics.choreography.flights import flown_to
from esg.dynamics.choreography.handling import BETWEEN_JUMPS_S
from esg.dynamics.choreography.hovering import climbs_at
from esg.dynamics.choreography.setting_off import SAME_MPS
from esg.dynamics.choreography.slopes import FASTEST_MPS
from esg.dynamics.choreography.ways import arrives
from esg.dynamics.plan.aim import aim_heading
from esg.dynamics.plan.cast import Cast
from esg.dynamics.plan.climbs import Climb, climbs
from esg.dynamics.plan.drives import (
    drawn_to,
    driven,
    held_at,
    joint_of,
    kept_shut,
    let_go,
    reach_of,
)
from esg.dynamics.plan.guides import Way
from esg.dynamics.plan.postures import FIRST_S, HALTED_S, HALTS_MPS2, change
from esg.dynamics.plan.settling import STILL_MPS, comes_to_lie, rolls_out
from esg.dynamics.story.driving import goal_of
from esg.dynamics.story.kinematics import Ride, ballistic_velocity, wrap_angle
from esg.dynamics.story.paces import (
    LASTS_S,
    grip,
    on_foot,
    pace,
    slows_by,
    stated_rate,
    turns_at,
    usual_brake,
    usual_halt,
)
from esg.dynamics.story.stagecraft import coasting_drag, prop, stacked_with, stays_on, support_of
from esg.dynamics.story.story import (
    UNDISTURBED,
    Phase,
    bounds,
    is_climb,
    is_posture,
    turn_of,
    turns_back,
)
from esg.engines.joints import start_position
from esg.engines.program import (
    AdjustProperties,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Primitive,
    SetVelocity,
)
from esg.engines.scene import FRAGMENT, Body
from esg.graph.joints import towed_by
from esg.graph.models import EdgeEvent, EsgDocument, NodeEvent, TimelineEdge, TimelineNode
from esg.metrics.plausibility.told import surface_of
from esg.units import GRAVITY_MPS2, quat_from_euler_deg, yaw_from_quat

STRAIGHT_S = 1.0
"""How long an actor drives on straight after a turn that nothing follows [s]."""
SHAKEN_S = 0.15
"""From the hit of a support until something on it sets off to fall [s]."""
GRIPS = 0.6
"""Share of its grip with which something slows down on a table that is on no feet or wheels."""
LEAST_BRAKE_MPS2 = 0.05
"""What stops on a table brakes as hard at least."""
LEAST_S, LEAST_MPS = 0.05, 0.05
"""Least time and speed of a segment."""
RUN_OUT_MPS2 = 5.0
"""How fast a jumper comes to rest after it has landed."""
HELD_ON_S = 8.0
"""What nothing ends is held on for so long after a search has seen enough: the recording plays on
until the others rest (`search.ending`)."""
LEAST_SHARE = 0.2
"""Of its brakes, which what slows down to a speed after a hit puts on at least."""
STANDING_SLACK, MOVING_SLACK = 1.05, 1.3
"""A spin is kept up so much longer than its turns take: of what moves, friction takes a part."""

TIMED = (NodeEvent.TRIGGER, NodeEvent.REACH, NodeEvent.STOP, NodeEvent.MISS)
"""Events at which a phase ends when theta says so; others end it when they happen."""

Values = dict[str, float]


STANDS_S = 4.0
"""So long who has come to a halt keeps himself upright [s]; scenes end before."""


@dataclass
class _Course:
    """Where the program of an actor stands.

    Attributes:
        actor: Who acts.
        heading: [rad].
        speed: [m/s].
        clock: When the next phase may begin [s].
        held: Whether it is still held then, by what guided it.
        opening: Position of its joint then [rad or m].
        upon: What it sits or lies on that is no ground.
        out: The primitives so far.
    """

    actor: str
    heading: float
    speed: float = 0.0
    clock: float = 0.0
    held: bool = False
    opening: float = 0.0
    upon: str | None = None
    out: list[Primitive] = field(default_factory=list)


@dataclass(frozen=True)
class _Leg:
    """One phase of an actor under the values of theta.

    Args:
        phase: The phase.
        v: Values of all variables by name.
        start, end: [s].
        first, last: Whether it is the actor's first or last one, but for coming down.
        duration: Of the scene [s].
    """

    phase: Phase
    v: Values
    start: float
    end: float
    first: bool
    last: bool
    duration: float


def supports(doc: EsgDocument, name: str) -> list[str]:
    """What a node lies on, and what that lies on."""
    out: list[str] = []
    below = support_of(doc, name)
    while below is not None and below not in out:
        out.append(below)
        below = support_of(doc, below)
    return out


class Composer:
    """Turns phases and values into primitives and start poses.

    Args:
        cast: Who takes part, and how.
        carried: Ways of what is guided, by segment id.
    """

    def __init__(self, cast: Cast, carried: dict[str, Way]) -> None:
        self.carried = carried
        self.cast, self.doc, self.scene = cast, cast.doc, cast.scene
        self.story, self.nominal = cast.story, cast.nominal

    @cached_property
    def _shaken(self) -> dict[str, float]:
        """When what falls off a support that something else hits first sets off [s], by actor."""
        out: dict[str, float] = {}
        nodes = list(self.story.nodes.values())
        for actor, phases in self.story.phases.items():
            fall, support = phases[0].end, support_of(self.doc, actor)
            if support is None or fall.event is not NodeEvent.FALL:
                continue
            under = {support, *stacked_with(self.doc, support)}
            before = nodes[: next(k for k, n in enumerate(nodes) if n.id == fall.id)]
            for node in before:
                told = self.nominal.get(f"{node.id}/event_time")
                hit = node.event is NodeEvent.COLLISION and under & set(node.participants)
                if hit and told is not None and actor not in node.participants:
                    out[actor] = told + SHAKEN_S
                    break
        return out

    @cached_property
    def climbs(self) -> dict[str, Climb]:
        """The ways of all who climb, by segment id."""
        return climbs(self.cast)

    @property
    def set_off_climbing(self) -> dict[str, Climb]:
        """The ways of those whose first motion is a climb, by actor."""
        first = {a: p[0].edge.id for a, p in self.story.phases.items()}
        return {a: self.climbs[i] for a, i in first.items() if i in self.climbs}

    @cached_property
    def _riders(self) -> dict[str, tuple[str, ...]]:
        """What lies on an actor or is joined to it and does not act itself, or is drawn along by
        it: it is under way with it.
        """
        nodes = self.doc.spatial_relation_graph.nodes
        free = [n for n, x in nodes.items() if n not in self.story.phases and not x.is_structural]
        free = [n for n in free if n in self.scene.names and not self.scene.body(n).static]
        on = {j.child: j.parent for j in self.scene.joints if not j.flexible}
        out: dict[str, tuple[str, ...]] = {}
        for a in self.story.phases:
            shared = [n.participants for n in self.story.nodes.values() if a in n.participants]
            met = {p for names in shared for p in names}
            with_it = [n for n in free if n not in met]
            with_it = [n for n in with_it if a in supports(self.doc, n) or on.get(n) == a]
            with_it += [n for n in towed_by(self.doc, a) if n in self.scene.names]
            out[a] = tuple(dict.fromkeys(with_it))
        return out

    @cached_property
    def _headings(self) -> dict[str, float]:
        """Where every actor heads before theta turns it [rad]: the same for all candidates."""
        return {actor: self._heading(actor) for actor in self.story.phases}

    def base_heading(self, actor: str) -> float:
        return self._headings[actor]

    def _heading(self, actor: str) -> float:
        body = self.scene.body(actor)
        first = self.story.phases[actor][0]
        if self.story.flies(actor):
            first = flown_to(self.story, first)
        target = self.cast.target(first)
        straight = first.end.event not in (NodeEvent.TRIGGER, NodeEvent.HEADING_REACHED)
        yaw = float(yaw_from_quat(body.quaternion))
        yaw += math.pi if self.story.reverses(actor) else 0.0
        if self.cast.goes_down(actor, first):
            slope = self.scene.body(support_of(self.doc, actor) or "")
            return float(yaw_from_quat(slope.quaternion))
        if (self.cast.drives(actor) and not straight) or is_climb(first):
            return yaw
        if target is not None and straight and not self.cast.look_ahead:
            offset = np.array(self.scene.body(target).position) - np.array(body.position)
            return math.atan2(offset[1], offset[0])
        passes = self.cast.drives(actor) or self._stays_up(actor)  # beside the way, not ahead
        if target is None or (passes and first.end.event is NodeEvent.MISS):
            return yaw
        heading = aim_heading(self.scene, self.story, body, first, target)
        if self.cast.drives(actor) and abs(wrap_angle(heading - yaw)) > math.radians(12.0):
            return yaw
        return heading

    def start_pose(self, actor: str, v: Values) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Start pose of a driven body: turned by its aim and shifted sideways."""
        body = self.scene.body(actor)
        heading = self.base_heading(actor) + v[f"{actor}/aim"]
        side = np.array([-math.sin(heading), math.cos(heading), 0.0])
        yaw = heading + (math.pi if self.story.reverses(actor) else 0.0)
        return (
            np.array(body.position) + v[f"{actor}/lateral"] * side,
            quat_from_euler_deg(math.degrees(yaw)),
        )

    def node_time(self, node: TimelineNode, v: Values, clock: float) -> float:
        if node.event is NodeEvent.SCENE_START:
            return 0.0
        return v.get(f"{node.id}/time", node.timestamp if node.timestamp is not None else clock)

    def primitives(
        self, actor: str, phases: tuple[Phase, ...], v: Values, duration: float
    ) -> list[Primitive]:
        """The primitives of an actor's phases under the values of theta.

        Args:
            actor: Who acts.
            phases: What it does, in order.
            v: Values of all variables by name.
            duration: Of the scene [s].
        """
        course = _Course(actor, self.base_heading(actor) + v.get(f"{actor}/aim", 0.0))
        course.upon = seat_of(self.doc, actor)
        for k, phase in enumerate(phases):
            start = max(course.clock, self.node_time(phase.start, v, course.clock))
            start = max(start, self._shaken.get(actor, 0.0) if k == 0 else 0.0)
            end = self.phase_end(phase, v, start, duration)
            if k and is_posture(phases[k - 1]) and f"{phase.end.id}/time" in v:
                # Who had to come to a halt first has as long for what comes then.
                told = self.node_time(phase.start, v, start)
                end = max(end, start + v[f"{phase.end.id}/time"] - told)
            if self.cast.coasts(phase):
                continue
            # What it would have done after slowing down, had nothing come first, it does not do.
            course.out = [
                p for p in course.out if not (isinstance(p, HoldVelocity) and p.start > start)
            ]
            jumps = phase.end.event is NodeEvent.JUMP
            if self.story.tips(phase) or (k > 0 and (jumps or self.story.flies(actor))):
                # Nothing may hold it upright or on its course any more.
                course.out = [_until(p, start) for p in course.out]
            if turns_back(self.story, phase, lambda name: self.scene.body(name).static):
                course.heading += math.pi
            last = k + 1 == len(phases) or (jumps and all(map(self.cast.coasts, phases[k + 1 :])))
            if k and pushes_off(phases[k - 1], phase):
                course.heading += math.pi
            leg = _Leg(phase, v, start, end, k == 0, last, duration)
            done = len(course.out)
            self._act(course, leg, phases[k + 1 :])
            if any(p.end.event not in UNDISTURBED for p in phases[:k]):
                course.out[done:] = [self._by_and_by(p) for p in course.out[done:]]
            elif k == 0 and on_foot(prop(self.doc, actor)) and support_of(self.doc, actor):
                course.out[done:] = [q for p in course.out[done:] for q in self._down(p)]
        return [*course.out, *comes_to_lie(self.cast, self.scene.body(actor), course.out)]

    def _act(self, course: _Course, leg: _Leg, later: tuple[Phase, ...]) -> None:
        """Adds what an actor does in one phase, by the kind of its edge."""
        phase, edge = leg.phase, leg.phase.edge
        if is_posture(phase):
            self._change_posture(course, leg)
        elif is_climb(phase):
            self._climb_along(course, leg)
        elif edge.event is EdgeEvent.GUIDE:
            self._guide(course, leg)
        elif edge.event is EdgeEvent.SPIN:
            self._spin(course, leg)
        elif edge.event in (EdgeEvent.DRIVE, EdgeEvent.RELEASE):
            self._along_joint(course, leg)
        elif phase.end.event is NodeEvent.JUMP:
            self._jump(course, leg)
        elif edge.event is EdgeEvent.TOWARD or self.story.tips(phase):
            self._let_go(course, leg)
        elif f"{edge.id}/stopping" in leg.v:
            self._stop_in_time(course, leg)
        elif f"{edge.id}/leaves" in self.nominal:
            self._slow_to(course, leg, later[0])
        elif edge.event is EdgeEvent.BRAKE:
            self._brake(course, leg)
        elif phase.start.event is not NodeEvent.FALL or self.story.soars(course.actor):
            # What has gone over an edge has nothing that it could push itself off from.
            self._drive(course, leg)

    def _down(self, primitive: Primitive) -> list[Primitive]:
        """What runs off a thing lands on its feet, which takes of its speed what friction does."""
        if not isinstance(primitive, HoldVelocity) or primitive.climb is not None:
            return [primitive]
        end = primitive.start + LEAST_S
        if primitive.start > 0.0 or primitive.end <= end:
            return [primitive]
        later = replace(
            primitive,
            start=end,
            speed=max(primitive.speed + primitive.acceleration * LEAST_S, 0.0),
            heading=primitive.heading + primitive.turn_rate * LEAST_S,
        )
        return [replace(primitive, end=end), self._by_and_by(later)]

    def _by_and_by(self, primitive: Primitive) -> Primitive:
        """A hold of what something may have met, at the pace at which its kind comes to a speed.

        How fast a hit has left it only the engine knows. What the ground takes of a body that does
        not roll, its feet make up for.
        """
        if not isinstance(primitive, HoldVelocity):
            return primitive
        usual = pace(self.doc, primitive.body)
        rubs = 0.0 if primitive.climb is not None else coasting_drag(prop(self.doc, primitive.body))
        gains, loses = max(usual.gains, primitive.acceleration), usual.brakes - rubs
        least, room = LEAST_SHARE * usual.brakes, grip(self.doc, primitive.body) - rubs
        if surface_of(self.doc) != "dry" and room > 0.0:  # both hold no better than it grips
            least = min(least, 0.5 * room)
        return replace(primitive, gains=gains + rubs, loses=max(loses, least))

    def _let_go(self, course: _Course, leg: _Leg) -> None:
        """A throw, a kick, a push: its velocity is set once."""
        actor, body = course.actor, self.scene.body(course.actor)
        course.out.append(self.launch(actor, body, leg.phase, leg.v, leg.start, course.heading))
        if leg.last:
            speed = leg.v.get(f"{leg.phase.edge.id}/speed", 0.0)
            course.out += rolls_out(self.cast, body, leg.phase, speed, leg.start, leg.end)
        course.clock = leg.start

    def _guide(self, course: _Course, leg: _Leg) -> None:
        """It is carried along its way, and let go at the end or held on."""
        edge, ends_at, way = leg.phase.edge, leg.phase.end.event, self.carried[leg.phase.edge.id]
        begin = course.clock if course.held else leg.start
        release = edge.params.release
        if release is None:
            release = ends_at is not NodeEvent.PICKED_UP
        if ends_at is NodeEvent.TRIGGER:
            end = leg.end
            way = way.lasting(min(way.times[-1], end - leg.start))
        else:
            way = way.lasting(leg.v[f"{edge.id}/duration"])
            end = leg.start + way.times[-1]
        held_until = leg.duration + HELD_ON_S if leg.last and not release else end
        course.out.append(way.path(course.actor, begin, leg.start - begin, held_until))
        course.clock, course.held = end, not release

    def _change_posture(self, course: _Course, leg: _Leg) -> None:
        """It comes to a halt, and is in its other posture from then on."""
        time = leg.start + (FIRST_S if leg.first else HALTED_S)
        if not leg.first:
            course.out = [_until(p, leg.start) for p in course.out]
            course.out.append(AdjustProperties(course.actor, leg.start, braking=HALTS_MPS2))
            course.out.append(AdjustProperties(course.actor, time, braking=0.0))
        found = change(self.doc, self.scene, leg.phase, time, course.upon)
        if found is not None:
            course.out.append(found)
            course.heading = found.heading if found.position is not None else course.heading
        course.upon = leg.phase.edge.target
        course.clock = leg.start + LASTS_S

    def _climb_along(self, course: _Course, leg: _Leg) -> None:
        """It goes along what it climbs, and is let go at the end, or holds on there."""
        way = self.climbs.get(leg.phase.edge.id)
        if way is None:
            return
        end = leg.start + way.times[-1]
        holds = way.holds or leg.phase.edge.params.release is False
        until = leg.duration + HELD_ON_S if holds and leg.last else end
        course.out += way.program(course.actor, leg.start, until)
        course.clock = end

    def _spin(self, course: _Course, leg: _Leg) -> None:
        """It is kept turning: on the spot where it has stood, else wherever it goes.

        What stands is held where it is until something touches it: on its flat base it would walk
        off in some engines, and friction would slow it in all of them by its own law.
        """
        actor, edge, start = course.actor, leg.phase.edge, leg.start
        rate, end, slack = leg.v[f"{edge.id}/turn_rate"], leg.end, STANDING_SLACK
        if not leg.first:
            slack = MOVING_SLACK
        if leg.phase.end.event is NodeEvent.SPIN:
            asked = math.radians(leg.phase.end.turn_degrees or 360.0)
            end = start + slack * asked / rate
        rate *= -1.0 if edge.params.turn_direction == "right" else 1.0
        if leg.first:
            at, rest = self.scene.body(actor).position, ((0.0, 0.0, 0.0),) * 2
            under = (actor, support_of(self.doc, actor))
            others = tuple(n for n in self._others(actor) if n not in under)
            course.out.append(
                GuideAlong(actor, start, (0.0, end - start), (at, at), rest, rate, others)
            )
        else:
            course.out = [_until(p, start) for p in course.out]
            course.out.append(HoldSpin(actor, start, end, rate))
        course.clock = end

    def _along_joint(self, course: _Course, leg: _Leg) -> None:
        """It is moved along its joint, or hangs drawn back until it is let go."""
        body, edge = self.scene.body(course.actor), leg.phase.edge
        course.out = let_go(course.out, leg.start)
        if edge.event is EdgeEvent.RELEASE:
            if leg.first and leg.start > 0.0:
                course.out.append(held_at(body, leg.start))
            course.clock = leg.start
            return
        joint = joint_of(self.scene, course.actor)
        if joint is None:
            return
        here = course.opening if not leg.first else start_position(self.scene, joint)
        phases = self.story.phases[course.actor]
        following = next(iter(phases[phases.index(leg.phase) + 1 :]), None)
        goal = goal_of(reach_of(joint), leg.phase, here, following)
        lasts = leg.v[f"{edge.id}/duration"]
        if leg.phase.end.event is NodeEvent.SPIN and leg.last:
            # It is turned on and on.
            goal, lasts = here + (goal - here) * HELD_ON_S / lasts, HELD_ON_S
        ramp = self.nominal.get(f"{edge.id}/ramp", 0.0)
        before = phases[: phases.index(leg.phase)]
        if joint.kind == "hinge" and before and before[-1].edge.event is EdgeEvent.TOWARD:
            # A blow has opened it as far as it did.
            course.out += drawn_to(self.scene, joint, leg.start, goal, lasts)
            course.clock, course.opening = leg.start + lasts, goal
            return
        moved = driven(self.scene, joint, leg.start, here, goal, lasts, ramp)
        lasts = lasts + ramp if moved else 0.0
        course.out += moved
        course.clock, course.opening = leg.start + lasts, goal
        if leg.phase.end.event is NodeEvent.CLOSE:
            course.out += kept_shut(self.scene, joint, course.clock)

    def _jump(self, course: _Course, leg: _Leg) -> None:
        """It leaves the ground, once or several times, and does not turn over in the air."""
        edge, count = leg.phase.edge, leg.phase.end.times or 1
        rise, speed = leg.v[f"{edge.id}/rise"], leg.v[f"{edge.id}/speed"]
        velocity = (speed * math.cos(course.heading), speed * math.sin(course.heading), rise)
        turn = self.nominal.get(f"{edge.id}/turn", 0.0)
        aloft = self.nominal.get(f"{edge.id}/aloft", 2.0 * rise / GRAVITY_MPS2)
        period = aloft + BETWEEN_JUMPS_S
        begin = leg.start + self.nominal.get(f"{edge.id}/crouch", 0.0)
        course.out += [
            SetVelocity(course.actor, begin + k * period, velocity, (0.0, 0.0, turn / aloft))
            for k in range(count)
        ]
        course.clock, course.speed = begin + count * period, 0.0
        if leg.last and speed > 0.0 and self.scene.body(course.actor).roll_radius == 0.0:
            # On its feet again it runs out from what the landing leaves it; left to friction it
            # would go head over heels.
            landing = course.clock - BETWEEN_JUMPS_S
            end = landing + speed / RUN_OUT_MPS2
            stands = HoldVelocity(course.actor, landing, end, 0.0, course.heading)
            course.out.append(self._by_and_by(stands))

    def _stop_in_time(self, course: _Course, leg: _Leg) -> None:
        """It slows down step by step, to rest."""
        actor, lasts = course.actor, leg.v[f"{leg.phase.edge.id}/stopping"]
        if stated_rate(leg.phase.edge) is None:
            lasts = max(lasts, abs(course.speed) / grip(self.doc, actor))
        soars = self.story.soars(actor)
        # What flies hovers where it stopped.
        hovers = soars and leg.last and not self.story.falls(actor)
        course.out.append(
            HoldVelocity(
                actor,
                leg.start,
                math.inf if hovers else leg.start + lasts,
                speed=abs(course.speed),
                heading=course.heading,
                acceleration=-abs(course.speed) / lasts,
                roll_radius=self.scene.body(actor).roll_radius,
                until_contact=self._others(actor) if soars else self.cast.contacts(leg.phase),
                climb=0.0 if soars else None,
            )
        )
        course.speed, course.clock = 0.0, leg.start + lasts

    def _slow_to(self, course: _Course, leg: _Leg, after: Phase) -> None:
        """It slows down to the speed with which it goes on, no sooner than the ground allows."""
        share = self.nominal[f"{leg.phase.edge.id}/leaves"]
        left = min(leg.v.get(f"{after.edge.id}/speed", share * course.speed), course.speed)
        lasts = max(
            leg.end - leg.start, (course.speed - left) / grip(self.doc, course.actor), LEAST_S
        )
        soars = self.story.soars(course.actor)
        course.out.append(
            HoldVelocity(
                course.actor,
                leg.start,
                leg.start + lasts,
                course.speed,
                course.heading,
                acceleration=-(course.speed - left) / lasts,
                roll_radius=self.scene.body(course.actor).roll_radius,
                until_contact=self._others(course.actor) if soars else (),
                climb=0.0 if soars else None,
            )
        )
        course.speed, course.clock = left, leg.start + lasts

    def _brake(self, course: _Course, leg: _Leg) -> None:
        """Its brakes are put on, or its damping is raised, until what it does next."""
        actor, name, end = course.actor, leg.phase.edge.id, max(leg.end, leg.start)
        damping = leg.v.get(f"{name}/damping")
        if damping is not None:
            usual = self.scene.body(actor).linear_damping
            course.out.append(AdjustProperties(actor, leg.start, linear_damping=damping))
            lets_go = AdjustProperties(actor, end, linear_damping=usual)
            course.speed *= math.exp(-damping * (end - leg.start))
        else:
            braking = leg.v[f"{name}/braking"]
            rate = braking + slows_by(self.doc, actor, course.speed)
            if leg.phase.end.event is NodeEvent.STOP:
                # It does not go on before it stands.
                end = max(end, leg.start + course.speed / rate)
            course.out.append(AdjustProperties(actor, leg.start, braking=braking))
            lets_go = AdjustProperties(actor, end, braking=0.0)
            course.speed = max(course.speed - rate * (end - leg.start), 0.0)
        course.clock = end
        if not leg.last:
            course.out.append(lets_go)

    def _drive(self, course: _Course, leg: _Leg) -> None:
        """Motion under its own power, straight on or in a curve."""
        actor, phase, edge, v, start = course.actor, leg.phase, leg.phase.edge, leg.v, leg.start
        soars, turns = self.story.soars(actor), edge.event is EdgeEvent.TURN
        roll_radius = self.scene.body(actor).roll_radius
        down = leg.first and self.cast.rolls_down(actor, phase)
        descends = leg.first and self.cast.goes_down(actor, phase)
        before, speed = course.speed, self._speed(course, leg, descends)
        until = self._until(phase)
        rate, end = self._turned(leg, speed) if turns else (0.0, leg.end)
        ride = self._ride(leg, speed, before)
        acceleration = v.get(f"{edge.id}/acceleration", 0.0)
        pushed = self.cast.pushes_off(actor, phase) if leg.last else None
        if pushed is not None:
            end, until = self.nominal.get(f"{pushed.id}/event_time", leg.duration) + 0.3, ()
        steep = climbs_at(edge) if soars else 0.0
        if leg.last and self._holds_on(phase, steep, upright=descends and not down):
            end = math.inf
        if (beyond := self.nominal.get(f"{edge.id}/beyond")) is not None:
            end = min(end, self.told(phase.end, end) + beyond / max(abs(speed), LEAST_MPS))
        ahead = np.array([math.cos(course.heading), math.sin(course.heading), 0.0])
        if leg.first and not acceleration and math.isinf(ride.rate):
            course.out += self._with_riders(actor, start, abs(speed) * ahead)
        if leg.first and (down or self.cast.leaves_support(actor, phase)):
            # Held, it could not tilt with the slope it goes down.
            course.out.append(SetVelocity(actor, start, _vec(abs(speed) * ahead)))
            course.clock = start
            return
        hold = HoldVelocity(
            actor,
            start,
            end,
            speed=abs(speed) * math.cos(steep),
            heading=course.heading,
            acceleration=acceleration,
            turn_rate=rate,
            roll_radius=roll_radius,
            until_contact=until,
            climb=self._climb(edge, abs(speed), steep) if soars else None,
        )
        if self._keeps_its_feet(leg) and not self.cast.leaves_support(actor, phase):
            course.out.append(self._stands(leg, speed))
        course.out += [hold] if steep else _ridden(hold, ride)
        self._while_held(course, leg, end, steep)
        course.heading += rate * (end - start) if turns else 0.0
        lasted = min(end, leg.duration) - start
        course.speed = max(0.0, ride.left(lasted) + acceleration * lasted)
        if leg.last and turns and (soars or not self._stays_up(actor)):
            course.out.append(self._straight_on(course, end, roll_radius))
            end += 0.0 if soars else STRAIGHT_S
        # What follows a hit follows it when it happens, not when the hold would have ended.
        told = v.get(f"{phase.end.id}/time", self.told(phase.end, end))
        course.clock = min(end, max(start, told))
        if leg.last:
            self._end_drive(course, leg, end, pushed is not None)

    def _while_held(self, course: _Course, leg: _Leg, end: float, steep: float) -> None:
        """What stays in the air where it has come down to, and wheels that are steered."""
        if steep < 0.0 and leg.last:
            course.out.append(self._hover(course.actor, end, 0.0, course.heading))
        if leg.phase.edge.event is EdgeEvent.TURN:
            course.out += self._steered(course.actor, leg.start, end)

    def _speed(self, course: _Course, leg: _Leg, descends: bool) -> float:
        """What it drives at [m/s]: as theta says, else as the choreography expects, or on as it is.

        On its way down a slope no faster than what would fly off the crest, unless that is stated.
        """
        edge = leg.phase.edge
        usual = self.nominal.get(f"{edge.id}/reaches", course.speed)
        speed = leg.v.get(f"{edge.id}/speed", usual)
        ranges = isinstance(edge.params.speed, tuple)
        return min(abs(speed), FASTEST_MPS) if descends and ranges else speed

    def _turned(self, leg: _Leg, speed: float) -> tuple[float, float]:
        """The rate of a turn [rad/s] at a speed [m/s], and when it is done [s]."""
        degrees, sign = turn_of(leg.phase)
        rate = sign * self._turn_rate(leg, speed)
        return rate, leg.start + math.radians(degrees) / abs(rate)

    def _stays_up(self, actor: str) -> bool:
        """Whether it moves on a table that it does not leave, so that it stops there."""
        return stays_on(self.doc, actor) is not None and not self.story.soars(actor)

    def _holds_on(self, phase: Phase, steep: float, *, upright: bool) -> bool:
        """Whether what it does last has no end.

        Who stands up is kept upright to the foot of a slope, and beyond. What flies does so past
        what it does not touch, and when all that is told of it is over.
        """
        actor, ends_by = phase.edge.actor, phase.end.event
        if upright or not self.story.soars(actor) or steep < 0.0:
            return upright
        flies_on = ends_by is NodeEvent.TRIGGER and not arrives(self.doc, actor)
        return flies_on or ends_by is NodeEvent.MISS

    def _with_riders(
        self, actor: str, time: float, velocity: NDArray[np.float64]
    ) -> list[Primitive]:
        """Who rides on it sets off with it, at a velocity [m/s]."""
        return [SetVelocity(r, time, _vec(velocity)) for r in self._riders[actor]]

    def _straight_on(self, course: _Course, start: float, roll_radius: float) -> HoldVelocity:
        """What holds it after its last turn.

        Let go while it turns, it would go on turning; what flies would sink.
        """
        actor, soars = course.actor, self.story.soars(course.actor)
        return HoldVelocity(
            actor,
            start,
            math.inf if soars else start + STRAIGHT_S,
            abs(course.speed),
            course.heading,
            roll_radius=roll_radius,
            until_contact=self._others(actor) if soars else (),
            climb=0.0 if soars else None,
        )

    def _climb(self, edge: TimelineEdge, speed: float, steep: float) -> float:
        """Vertical velocity of a powered flight [m/s]: as told, or down onto its target."""
        if steep:
            return speed * math.sin(steep)
        return self.nominal.get(f"{edge.id}/slope", 0.0) * speed

    def _turn_rate(self, leg: _Leg, speed: float) -> float:
        """How fast it turns [rad/s]: as theta says, where its grip bears that at a speed [m/s]."""
        edge = leg.phase.edge
        rate = leg.v[f"{edge.id}/turn_rate"]
        if bounds(edge.params.turn_rate_deg_s, (0.0, 0.0))[2]:
            return rate
        return min(rate, turns_at(self.doc, edge.actor) / max(abs(speed), STILL_MPS))

    def _steered(self, actor: str, start: float, end: float) -> list[Primitive]:
        """Tyres roll round a turn: as feet that rub on the ground they would hold its body back.

        A hold sets the rate of turn before every step, and friction takes its part within it: by
        the end the body would point a degree beside its way, and slide on like that.
        """
        body = self.scene.body(actor)
        if body.tyre_friction <= 0.0 and not self._stays_up(actor):
            return []
        return [
            AdjustProperties(actor, start, friction=0.0),
            AdjustProperties(actor, end, friction=body.friction),
        ]

    def _ride(self, leg: _Leg, speed: float, before: float) -> Ride:
        """How it comes to its speed: at once, or as the choreography has it gain speed.

        Args:
            leg: What it does.
            speed: That it gets to [m/s].
            before: That it has [m/s], where nothing has happened to it.
        """
        name, phases = leg.phase.edge.id, self.story.phases[leg.phase.edge.actor]
        rate = self.nominal.get(f"{name}/gains")
        if not leg.first and phases[phases.index(leg.phase) - 1].end.event in UNDISTURBED:
            usual, more = pace(self.doc, leg.phase.edge.actor), abs(speed) - abs(before)
            gains = leg.phase.edge.event is EdgeEvent.ACCELERATED_MOTION
            if gains or (rate is None and abs(more) < SAME_MPS):
                return Ride.under_way(speed)
            return Ride(abs(before), usual.gains if more >= 0.0 else -usual.brakes, abs(speed))
        if rate is None:
            return Ride.under_way(speed)
        return Ride(min(self.nominal[f"{name}/begins"], abs(speed)), rate, abs(speed))

    def _end_drive(self, course: _Course, leg: _Leg, end: float, pushes: bool) -> None:
        """What a driver does at the end of its part: it brakes, or hovers."""
        actor, node = course.actor, leg.phase.end
        stays = node.event in (NodeEvent.REACH, NodeEvent.STOP) or arrives(self.doc, actor)
        stays = stays or self._stays_up(actor)
        if self.story.soars(actor):
            if stays:
                course.out.append(self._hover(actor, end, course.speed, course.heading))
            return
        if self.cast.brakes_after(actor, leg.phase):
            hit = end if pushes else self.nominal.get(f"{node.id}/event_time", leg.duration)
            course.out.append(AdjustProperties(actor, hit, braking=self._brakes(course)))
        slides = self._stays_up(actor) and not prop(self.doc, actor).wheeled
        if node.event is NodeEvent.COLLISION and stays and not slides:
            hit = self.nominal.get(f"{node.id}/event_time", leg.duration)
            course.out.append(AdjustProperties(actor, hit, braking=self._brakes(course)))
        elif slides and end < leg.duration:
            course.out.append(self._halts(course, end, GRIPS * grip(self.doc, actor)))
        elif on_foot(prop(self.doc, actor)) and (stays or end < leg.duration):
            # Let go on its feet, it would fall over them.
            course.out.append(self._halts(course, end))
        elif stays:
            course.out.append(AdjustProperties(actor, end, braking=self._brakes(course)))

    def _keeps_its_feet(self, leg: _Leg) -> bool:
        """Whether who runs into something on foot has only to stay on his feet after that.

        A later leg comes to its speed by and by: nothing that stands before it is overridden.
        """
        actor, node = leg.phase.edge.actor, leg.phase.end
        if node.event is not NodeEvent.COLLISION or self.story.soars(actor) or not leg.first:
            return False
        if not on_foot(prop(self.doc, actor)):
            return False
        met = self.cast.contacts(leg.phase)
        still = not any(name in self.story.phases for name in met)
        after = self.story.after(node.id)
        return bool(met) and still and leg.last and not any(actor in n.participants for n in after)

    def _stands(self, leg: _Leg, speed: float) -> HoldVelocity:
        """What a drive at a speed [m/s] overrides until it ends: then who came stops, upright."""
        actor, met = leg.phase.edge.actor, self.cast.contacts(leg.phase)
        rate = usual_halt(self.doc, actor, abs(speed), held=True)
        free = (n for n in self._others(actor) if not self.scene.body(n).static)
        return HoldVelocity(
            actor, leg.start, math.inf, 0.0, 0.0,
            until_contact=tuple(n for n in free if n not in met), gains=rate, loses=rate,
        )  # fmt: skip

    def _halts(self, course: _Course, time: float, most: float = math.inf) -> HoldVelocity:
        """It slows down within a step or two, and stands on its feet until something touches it.

        Args:
            course: Where its program stands.
            time: When that begins [s].
            most: Rate at which it slows down at most [m/s^2].
        """
        actor, speed = course.actor, abs(course.speed)
        rate = min(usual_halt(self.doc, actor, speed, held=True), most)
        lasts = max(speed / rate, LEAST_S)
        ends = time + lasts + STANDS_S
        others = tuple(n for n in self._others(actor) if not self.scene.body(n).static)
        return HoldVelocity(
            actor, time, ends, speed, course.heading, acceleration=-speed / lasts,
            until_contact=others,
        )  # fmt: skip

    def _brakes(self, course: _Course) -> float:
        """How hard an actor usually brakes [m/s^2]; what rubs on a table brakes by that, too."""
        usual = usual_brake(self.doc, course.actor, course.speed)
        host = stays_on(self.doc, course.actor)
        if host is None:
            return usual
        body, top = prop(self.doc, course.actor), prop(self.doc, host)
        rubs = 0.5 * (body.friction + top.friction) * GRAVITY_MPS2
        return max(usual + coasting_drag(body) - rubs, LEAST_BRAKE_MPS2)

    def _hover(self, actor: str, time: float, speed: float, heading: float) -> HoldVelocity:
        """Slows down in the air, and stays there."""
        return HoldVelocity(
            actor,
            time,
            math.inf,
            speed=abs(speed),
            heading=heading,
            acceleration=-pace(self.doc, actor).brakes,
            until_contact=self._others(actor),
            climb=0.0,
        )

    def _others(self, actor: str) -> tuple[str, ...]:
        """Everything whose touch ends a flight."""
        others = (b for b in self.scene.bodies if b.name != actor and b.category != FRAGMENT)
        return tuple(b.name for b in others if b.shapes)

    def _until(self, phase: Phase) -> tuple[str, ...]:
        """Whose touch ends a drive: over an edge, all but the ground that it may land on."""
        actor = phase.edge.actor
        if phase.end.event is not NodeEvent.FALL or self.story.soars(actor):
            return self.cast.contacts(phase)
        below = supports(self.doc, actor)
        return tuple(n for n in self._others(actor) if n not in below) if below else ()

    def told(self, node: TimelineNode, otherwise: float) -> float:
        """When the choreography expects an event [s]; a turn is over when it has been driven."""
        if node.event is NodeEvent.HEADING_REACHED:
            return otherwise
        return self.nominal.get(f"{node.id}/event_time", otherwise)

    def phase_end(self, phase: Phase, v: Values, start: float, duration: float) -> float:
        name = f"{phase.end.id}/time"
        if phase.end.event in TIMED and name in v:
            return max(start + LEAST_S, v[name])
        if phase.end.event is NodeEvent.POSITION_AT and phase.end.timestamp is not None:
            return max(start + LEAST_S, phase.end.timestamp)
        return duration + HELD_ON_S

    def _lets_go(
        self, actor: str, body: Body, phase: Phase, flat: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Where a flight begins [m]: at its start, or at the ramp that it takes off from."""
        start = np.array(body.position)
        before = self.story.phases[actor][: self.story.phases[actor].index(phase)]
        ramp = self.cast.target(before[-1]) if before and self.story.takes_off(actor) else None
        if ramp is None or before[-1].end.event is not NodeEvent.COLLISION:
            return start
        met = self.scene.body(ramp)
        way = np.array(met.position)[:2] - start[:2]
        along = float(way @ flat[:2]) - max(met.half_extents[:2]) - max(body.half_extents[:2])
        return start + max(along, 0.0) * flat

    def launch(
        self, actor: str, body: Body, phase: Phase, v: Values, time: float, heading: float
    ) -> SetVelocity:
        edge = phase.edge
        if f"{edge.id}/heading" in v:
            heading = v[f"{edge.id}/heading"] + v[f"{actor}/aim"]
        flat = np.array([math.cos(heading), math.sin(heading), 0.0])
        if f"{edge.id}/flight_time" in v:
            goal = self.cast.throw_goal(actor, phase)
            assert goal is not None
            goal = goal + np.array([0.0, 0.0, v[f"{edge.id}/aim_height"]])
            offset = goal - self._lets_go(actor, body, phase, flat)
            flat_offset = float(np.hypot(offset[0], offset[1])) * flat
            velocity = ballistic_velocity(
                np.array([flat_offset[0], flat_offset[1], offset[2]]),
                v[f"{edge.id}/flight_time"],
                body.linear_damping,
            )
            return SetVelocity(actor, time, _vec(velocity), (0.0, 0.0, 0.0))
        speed = v[f"{edge.id}/speed"]
        elevation = v.get(f"{edge.id}/elevation", 0.0)
        velocity = speed * (math.cos(elevation) * flat + np.array([0, 0, math.sin(elevation)]))
        spin = None
        if self.story.tips(phase):
            # It turns about its lower front edge: the centre moves at omega times its height.
            # What has been on its way goes over the side of its narrower base.
            turn = speed / max(body.half_extents[2], 1e-3)
            first = phase is self.story.phases[actor][0]
            if not first:
                # A wide base rises on its way over the edge; a domino hardly does.
                if body.half_extents[1] < body.half_extents[0]:
                    flat = np.array([-flat[1], flat[0], 0.0])
                rise = turn * min(body.half_extents[:2])
                velocity = speed * flat + np.array([0.0, 0.0, rise])
                spin = (-turn * float(flat[1]), turn * float(flat[0]), 0.0)
                return SetVelocity(actor, time, _vec(velocity), spin)
            return SetVelocity(
                actor,
                time,
                _vec(speed * flat),
                (-turn * float(flat[1]), turn * float(flat[0]), 0.0),
            )
        if body.roll_radius > 0.0 and not self.story.flies(actor) and edge.params.spin != "slide":
            spin = _rolling(velocity, body.roll_radius)
        return SetVelocity(actor, time, _vec(velocity), spin)


def _ridden(hold: HoldVelocity, ride: Ride) -> list[Primitive]:
    """A hold whose speed is that of a ride; what slows down to a speed keeps it in a second one."""
    if math.isinf(ride.rate):
        return [hold]
    if ride.rate > 0.0:
        return [replace(hold, speed=ride.first, acceleration=ride.rate, max_speed=ride.speed)]
    lasts = min(ride.gaining, hold.end - hold.start)
    slower = replace(hold, end=hold.start + lasts, speed=ride.first, acceleration=ride.rate)
    if lasts >= hold.end - hold.start:
        return [slower]
    heading = hold.heading + hold.turn_rate * lasts
    return [slower, replace(hold, start=slower.end, speed=ride.left(lasts), heading=heading)]


def _until(primitive: Primitive, time: float) -> Primitive:
    """The primitive, if it is a hold, ended by `time` at the latest."""
    if isinstance(primitive, HoldVelocity) and primitive.end > time > primitive.start:
        return replace(primitive, end=time)
    return primitive


def _rolling(v: NDArray[np.float64], radius: float) -> tuple[float, float, float]:
    """Angular velocity [rad/s] of a body that rolls along the ground as it moves."""
    return (-float(v[1]) / radius, float(v[0]) / radius, 0.0)


def _vec(v: NDArray[np.float64]) -> tuple[float, float, float]:
    return (float(v[0]), float(v[1]), float(v[2]))
