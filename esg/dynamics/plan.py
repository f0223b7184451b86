"""From the timeline and theta to the control program: variables with bounds and mask, SI units.

Every variable has two starting values: `initial`, from the choreography and the geometry that the
layout found, and `heuristic`, the middle of the interval the draft wrote down. The strategy `none`
plays the heuristic values unchanged.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.aim import aim_heading, aim_point, region_center
from esg.dynamics.choreography import choreograph
from esg.dynamics.kinematics import ballistic_velocity, wrap_angle
from esg.dynamics.story import (
    REACH_BRAKE_DAMPING,
    Phase,
    Story,
    bounds,
    middle,
    read_story,
    turn_of,
)
from esg.engines.program import (
    AdjustProperties,
    HoldVelocity,
    Primitive,
    Program,
    SetVelocity,
)
from esg.engines.scene import Body, SimScene
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    ForceDirection,
    NodeEvent,
    TimelineNode,
)
from esg.units import GRAVITY_MPS2, quat_from_euler_deg, yaw_from_quat

AFTERMATH_S = 1.5
AFTER_HIT_DAMPING = 4.0
"""Linear damping [1/s] of a driver who brakes after the hit that was asked for."""
MAX_DURATION_S = 14.5


@dataclass(frozen=True)
class Variable:
    """One entry of theta (SI).

    Args:
        name: "edge id/param", "node id/time" or "actor/aim".
        lower, upper: Bounds.
        initial: Where the search starts.
        heuristic: The draft's own guess, played by strategy `none`.
        spread: Standard deviation of the first samples.
        fixed: Prescribed by the prompt: masked out of the search.
        unit: SI unit.
    """

    name: str
    lower: float
    upper: float
    initial: float
    heuristic: float
    spread: float
    fixed: bool
    unit: str


Values = dict[str, float]


@dataclass(frozen=True)
class Plan:
    """Variables and the function that compiles theta to a program.

    Args:
        variables: Entries of theta in order.
        scene: The physical scene at its layout poses.
        story: The timeline in causal order.
        compile: theta [n] -> Program.
        starts: theta [n] -> poses (position [3], quaternion [4]) of re-aimed actors by name.
        duration: How long the scene plays [s].
    """

    variables: tuple[Variable, ...]
    scene: SimScene
    story: Story
    compile: Callable[[NDArray[np.float64]], Program]
    starts: Callable[
        [NDArray[np.float64]], dict[str, tuple[NDArray[np.float64], NDArray[np.float64]]]
    ]
    duration: float

    def initial(self) -> NDArray[np.float64]:
        return np.array([v.initial for v in self.variables])

    def heuristic(self) -> NDArray[np.float64]:
        return np.array([v.heuristic for v in self.variables])

    def lower(self) -> NDArray[np.float64]:
        return np.array([v.lower for v in self.variables])

    def upper(self) -> NDArray[np.float64]:
        return np.array([v.upper for v in self.variables])

    def free(self) -> NDArray[np.bool_]:
        return np.array([not v.fixed for v in self.variables], bool)

    def with_starts(self, theta: NDArray[np.float64]) -> SimScene:
        """The scene with re-aimed actors at their start poses."""
        starts = self.starts(theta)
        from dataclasses import replace

        bodies = tuple(
            replace(
                b,
                position=tuple(map(float, starts[b.name][0])),
                quaternion=tuple(map(float, starts[b.name][1])),
            )
            if b.name in starts
            else b
            for b in self.scene.bodies
        )
        return self.scene.with_bodies(bodies)


def make_plan(doc: EsgDocument, scene: SimScene, *, seed: int = 0, look_ahead: bool = True) -> Plan:
    """Reads the timeline of a laid-out document into variables and a program compiler.

    Args:
        doc: The document.
        scene: Its physical scene.
        seed: Of the choreography.
        look_ahead: Aim with what comes after the first hit in mind; False aims straight at the
            centre of the first target.
    """
    return _Planner(doc, scene, seed, look_ahead).plan()


class _Planner:
    def __init__(self, doc: EsgDocument, scene: SimScene, seed: int, look_ahead: bool) -> None:
        self.doc, self.scene, self.look_ahead = doc, scene, look_ahead
        self.story = read_story(doc)
        self.nominal = choreograph(doc, seed=seed).nominal
        self.variables: dict[str, Variable] = {}
        self.tied: dict[str, str] = {}

    def plan(self) -> Plan:
        for actor, phases in self.story.phases.items():
            self._declare(actor, phases)
        names = list(self.variables)
        variables = tuple(self.variables.values())
        duration = self._duration()

        def values(theta: NDArray[np.float64]) -> Values:
            out = dict(zip(names, map(float, theta), strict=True))
            return out | {k: out[v] for k, v in self.tied.items()}

        def compile_theta(theta: NDArray[np.float64]) -> Program:
            v = values(theta)
            out: list[Primitive] = []
            for actor, phases in self.story.phases.items():
                out += self._primitives(actor, phases, v, duration)
            return Program(tuple(out), duration)

        def starts(
            theta: NDArray[np.float64],
        ) -> dict[str, tuple[NDArray[np.float64], NDArray[np.float64]]]:
            v = values(theta)
            return {a: self._start(a, v) for a in self.story.phases if self._drives(a)}

        return Plan(variables, self.scene, self.story, compile_theta, starts, duration)

    # -- variables ---------------------------------------------------------------------------

    def _add(
        self,
        name: str,
        low: float,
        high: float,
        initial: float,
        heuristic: float,
        spread: float,
        unit: str,
        *,
        fixed: bool = False,
    ) -> None:
        low, high = min(low, high), max(low, high)
        self.variables[name] = Variable(
            name,
            low,
            high,
            min(max(initial, low), high),
            min(max(heuristic, low), high),
            spread,
            fixed or high - low < 1e-12,
            unit,
        )

    def _drives(self, actor: str) -> bool:
        """Under its own power on the ground: its body points where it goes."""
        first = self.story.phases[actor][0].edge.event
        return first is not EdgeEvent.TOWARD and self.scene.body(actor).roll_radius == 0.0

    def _declare(self, actor: str, phases: tuple[Phase, ...]) -> None:
        body = self.scene.body(actor)
        first = phases[0]
        limit = 3.0 if self._drives(actor) else 14.0
        if self.scene.body(actor).roll_radius and body.half_extents[0] < 0.05:
            limit = 20.0
        self._add(
            f"{actor}/aim",
            -math.radians(limit),
            math.radians(limit),
            0.0,
            0.0,
            math.radians(limit / 6.0),
            "rad",
        )
        if self._drives(actor):
            self._add(f"{actor}/lateral", -0.25, 0.25, 0.0, 0.0, 0.06, "m")
        for phase in phases:
            self._declare_phase(actor, body, phase)
        if first.edge.params.heading_deg is not None and first.edge.event is EdgeEvent.TOWARD:
            low, high, fixed = bounds(first.edge.params.heading_deg, (0.0, 0.0))
            self._add(
                f"{first.edge.id}/heading",
                math.radians(low),
                math.radians(high),
                math.radians(0.5 * (low + high)),
                math.radians(0.5 * (low + high)),
                math.radians(max(high - low, 1.0) / 6.0),
                "rad",
                fixed=fixed,
            )

    def _declare_phase(self, actor: str, body: Body, phase: Phase) -> None:
        edge, params = phase.edge, phase.edge.params
        nominal = self.nominal
        if self._coasts(phase):
            return
        if edge.event is EdgeEvent.TOWARD and self._flies(actor, phase):
            self._declare_throw(actor, body, phase)
        elif edge.event in (
            EdgeEvent.UNIFORM_MOTION,
            EdgeEvent.TOWARD,
            EdgeEvent.TURN,
            EdgeEvent.ACCELERATED_MOTION,
        ) and (edge.event is not EdgeEvent.TURN or params.speed is not None):
            self._declare_speed(actor, phase)
        if edge.event is EdgeEvent.ACCELERATED_MOTION:
            low, high, fixed = bounds(params.acceleration, (50.0, 500.0))
            start = nominal.get(f"{edge.id}/acceleration", 0.005 * (low + high))
            self._add(
                f"{edge.id}/acceleration",
                low / 100,
                high / 100,
                start,
                0.005 * (low + high),
                0.1 * (high - low) / 100,
                "m/s^2",
                fixed=fixed,
            )
        if edge.event is EdgeEvent.BRAKE:
            low, high, fixed = bounds(params.damping, (0.3, 8.0))
            start = nominal.get(f"{edge.id}/damping", 1.5)
            if not fixed:
                high = max(high, 1.3 * start)
            self._add(
                f"{edge.id}/damping",
                low,
                high,
                start,
                0.5 * (low + high),
                0.15 * start,
                "1/s",
                fixed=fixed,
            )
        if edge.event is EdgeEvent.TURN:
            low, high, fixed = bounds(params.turn_rate_deg_s, (20.0, 80.0))
            start = nominal.get(f"{edge.id}/turn_rate", math.radians(45.0))
            self._add(
                f"{edge.id}/turn_rate",
                math.radians(low),
                math.radians(high),
                start,
                math.radians(0.5 * (low + high)),
                0.08,
                "rad/s",
                fixed=fixed,
            )
        for node in (phase.start, phase.end):
            self._declare_time(phase, node)

    def _declare_time(self, phase: Phase, node: TimelineNode) -> None:
        """Times the program sets: triggers, and starts of phases that follow an outcome."""
        name = f"{node.id}/time"
        starts_here = any(p.start.id == node.id for ps in self.story.phases.values() for p in ps)
        controlled = node.event is NodeEvent.TRIGGER
        brakes_at_reach = node.event is NodeEvent.REACH and phase.end.id == node.id
        plain_stop = (
            node.event is NodeEvent.STOP
            and phase.end.id == node.id
            and phase.edge.event is not EdgeEvent.BRAKE
        )
        follows_outcome = starts_here and node.event not in (
            NodeEvent.SCENE_START,
            NodeEvent.HEADING_REACHED,
            NodeEvent.TRIGGER,
        )
        if name in self.variables or not (
            controlled or brakes_at_reach or follows_outcome or plain_stop
        ):
            return
        window = node.window or (0.3, 12.0)
        nominal = self.nominal.get(name, 0.5 * (window[0] + window[1]))
        if node.timestamp is not None and node.time_is_prescribed:
            self._add(
                name,
                node.timestamp,
                node.timestamp,
                node.timestamp,
                node.timestamp,
                0.0,
                "s",
                fixed=True,
            )
            return
        low, high = window if node.time_is_prescribed else (0.3 * nominal, 2.5 * nominal + 1.0)
        self._add(name, low, high, nominal, 0.5 * (window[0] + window[1]), 0.12, "s")

    def _declare_speed(self, actor: str, phase: Phase) -> None:
        edge, params = phase.edge, phase.edge.params
        name = f"{edge.id}/speed"
        low, high, fixed = bounds(params.speed, (50.0, 1500.0))
        nominal = self.nominal.get(name, middle(low, high) / 100.0)
        tie = self._same_speed_as(phase)
        if tie is not None:
            self.tied[name] = tie
            return
        after = self._speed_for_transfer(actor, phase)
        if phase.end.time_is_prescribed:
            nominal *= math.sqrt(self._damping_loss(actor, phase))
        self._add(
            name,
            low / 100.0,
            high / 100.0,
            after or nominal,
            0.005 * (low + high),
            max(0.08 * nominal, 0.05),
            "m/s",
            fixed=fixed,
        )

    def _same_speed_as(self, phase: Phase) -> str | None:
        """Actors that start together at one prescribed speed interval share one variable."""
        if not phase.edge.speed_is_prescribed or phase.edge.params.speed is None:
            return None
        for phases in self.story.phases.values():
            for other in phases:
                if other is phase:
                    return None
                name = f"{other.edge.id}/speed"
                if (
                    name in self.variables
                    and other.start.id == phase.start.id
                    and other.edge.speed_is_prescribed
                    and other.edge.params.speed == phase.edge.params.speed
                    and other.edge.actor != phase.edge.actor
                ):
                    return name
        return None

    def _speed_for_transfer(self, actor: str, phase: Phase) -> float | None:
        """Speed that gives the target its prescribed speed in a central impact."""
        for c in phase.end.constraints:
            if c.quantity != "speed_after" or c.object == actor:
                continue
            if phase.end.event is NodeEvent.COLLISION and c.object in phase.end.participants:
                low, high, _ = bounds(c.value, (0.0, 0.0))
                a, b = self.scene.body(actor), self.scene.body(c.object)
                gain = (1 + 0.5 * (a.restitution + b.restitution)) * a.mass / (a.mass + b.mass)
                return 0.005 * (low + high) / gain * self._damping_loss(actor, phase)
        return None

    def _damping_loss(self, actor: str, phase: Phase) -> float:
        """Factor by which a freely rolling body must start faster to arrive as planned."""
        body = self.scene.body(actor)
        if phase.edge.event is not EdgeEvent.TOWARD or body.linear_damping <= 0.0:
            return 1.0
        duration = self.nominal.get(f"{phase.end.id}/event_time", 1.0)
        return float(min(math.exp(body.linear_damping * duration), 3.0))

    def _declare_throw(self, actor: str, body: Body, phase: Phase) -> None:
        edge, params = phase.edge, phase.edge.params
        low, high, fixed = bounds(params.speed, (100.0, 2500.0))
        if fixed:
            self._add(
                f"{edge.id}/speed",
                low / 100,
                low / 100,
                low / 100,
                low / 100,
                0.0,
                "m/s",
                fixed=True,
            )
            e_low, e_high, e_fixed = bounds(params.elevation_deg, (-30.0, 75.0))
            start = self._elevation_for(actor, phase, low / 100.0)
            self._add(
                f"{edge.id}/elevation",
                math.radians(e_low),
                math.radians(e_high),
                start,
                math.radians(0.5 * (e_low + e_high)),
                0.05,
                "rad",
                fixed=e_fixed,
            )
            return
        target = self._target(phase)
        offset = self._throw_goal(actor, phase)
        flight = self.nominal.get(f"{edge.id}/flight_time", 1.0)
        if offset is not None:
            span = float(np.linalg.norm(offset[:2] - np.array(body.position)[:2]))
            fastest = max(span / (high / 100.0), 0.15)
            self._add(
                f"{edge.id}/flight_time",
                fastest,
                max(2.5, 1.5 * flight),
                flight,
                span / max(0.005 * (low + high), 0.5),
                0.06 * flight,
                "s",
            )
            height = self.scene.body(target).half_extents[2] if target else 0.3
            self._add(
                f"{edge.id}/aim_height",
                -0.8 * height,
                0.8 * height,
                0.45 * height if self._shall_topple(target) else 0.0,
                0.0,
                0.2 * height,
                "m",
            )
            return
        speed = middle(max(low, 1.0), high) / 100.0
        self._add(
            f"{edge.id}/speed",
            low / 100,
            high / 100,
            speed,
            0.005 * (low + high),
            0.1 * speed,
            "m/s",
        )
        e_low, e_high, e_fixed = bounds(params.elevation_deg, (0.0, 60.0))
        self._add(
            f"{edge.id}/elevation",
            math.radians(e_low),
            math.radians(e_high),
            math.radians(0.5 * (e_low + e_high)),
            math.radians(0.5 * (e_low + e_high)),
            0.1,
            "rad",
            fixed=e_fixed,
        )

    def _throw_goal(self, actor: str, phase: Phase) -> NDArray[np.float64] | None:
        """The point a throw is aimed at: the region to enter, or the target's broadest part."""
        if phase.end.region:
            center = region_center(self.scene, phase.end.region)
            if center is not None:
                return center
        target = self._target(phase)
        body = self.scene.body(actor)
        return aim_point(body, self.scene.body(target), self.scene) if target else None

    def _coasts(self, phase: Phase) -> bool:
        """A launched body that is already on its way: nothing new is done to it."""
        nothing = phase.edge.params.speed is None and phase.edge.params.elevation_deg is None
        first = self.story.phases[phase.edge.actor][0]
        return phase.edge.event is EdgeEvent.TOWARD and nothing and phase is not first

    def _shall_topple(self, name: str | None) -> bool:
        """Whether the story tips a body over: it is then hit above its middle."""
        return any(
            n.event is NodeEvent.TOPPLE and name in n.participants
            for n in self.story.nodes.values()
        )

    def _elevation_for(self, actor: str, phase: Phase, speed: float) -> float:
        """Low-arc launch angle that reaches the target at a given speed."""
        target = self._target(phase)
        body = self.scene.body(actor)
        if target is None:
            return math.radians(20.0)
        d = aim_point(body, self.scene.body(target), self.scene) - np.array(body.position)
        x, z, g = float(np.hypot(d[0], d[1])), float(d[2]), GRAVITY_MPS2
        if speed < 0.5 or x < 0.05:
            return math.radians(-90.0) if x < 0.05 else 0.0
        root = speed**4 - g * (g * x * x + 2.0 * z * speed * speed)
        if root < 0.0:
            return math.radians(45.0)
        return math.atan2(speed * speed - math.sqrt(root), g * x)

    def _target(self, phase: Phase) -> str | None:
        """The body a phase is directed at."""
        names = [p for p in phase.end.participants if p != phase.edge.actor]
        if phase.end.region:
            names.append(phase.end.region.split("/")[0])
        if phase.edge.target:
            names.append(phase.edge.target)
        return next((n for n in names if n in self.scene.names), None)

    def _flies(self, actor: str, phase: Phase) -> bool:
        _ = phase
        return self.story.force[actor] is ForceDirection.ANY_3D

    # -- program -----------------------------------------------------------------------------

    def _base_heading(self, actor: str) -> float:
        body = self.scene.body(actor)
        first = self.story.phases[actor][0]
        target = self._target(first)
        straight = first.end.event not in (NodeEvent.TRIGGER, NodeEvent.HEADING_REACHED)
        yaw = float(yaw_from_quat(body.quaternion))
        if self._drives(actor) and not straight:
            return yaw
        if target is not None and straight and not self.look_ahead:
            offset = np.array(self.scene.body(target).position) - np.array(body.position)
            return math.atan2(offset[1], offset[0])
        if target is None or (self._drives(actor) and first.end.event is NodeEvent.MISS):
            return yaw
        heading = aim_heading(self.scene, self.story, body, first, target)
        if self._drives(actor) and abs(wrap_angle(heading - yaw)) > math.radians(12.0):
            return yaw
        return heading

    def _start(self, actor: str, v: Values) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Start pose of a driven body: turned by its aim and shifted sideways."""
        body = self.scene.body(actor)
        heading = self._base_heading(actor) + v[f"{actor}/aim"]
        side = np.array([-math.sin(heading), math.cos(heading), 0.0])
        yaw = heading + (math.pi if self._reverses(actor) else 0.0)
        return (
            np.array(body.position) + v[f"{actor}/lateral"] * side,
            quat_from_euler_deg(math.degrees(yaw)),
        )

    def _reverses(self, actor: str) -> bool:
        speed = self.story.phases[actor][0].edge.params.speed
        return isinstance(speed, (int, float)) and speed < 0

    def _node_time(self, node: TimelineNode, v: Values, clock: float) -> float:
        if node.event is NodeEvent.SCENE_START:
            return 0.0
        return v.get(f"{node.id}/time", node.timestamp if node.timestamp is not None else clock)

    def _primitives(
        self, actor: str, phases: tuple[Phase, ...], v: Values, duration: float
    ) -> list[Primitive]:
        body = self.scene.body(actor)
        heading = self._base_heading(actor) + v[f"{actor}/aim"]
        speed, clock = 0.0, 0.0
        out: list[Primitive] = []
        for k, phase in enumerate(phases):
            edge = phase.edge
            start = max(clock, self._node_time(phase.start, v, clock))
            end = self._phase_end(phase, v, start, duration)
            last = k + 1 == len(phases)
            if self._coasts(phase):
                continue
            if edge.event is EdgeEvent.TOWARD:
                out.append(self._launch(actor, body, phase, v, start, heading))
                clock = start
                continue
            if edge.event is EdgeEvent.BRAKE:
                damping = v[f"{edge.id}/damping"]
                out.append(AdjustProperties(actor, start, linear_damping=damping))
                speed *= math.exp(-damping * max(end - start, 0.0))
                clock = end
                if not last:
                    out.append(AdjustProperties(actor, end, linear_damping=body.linear_damping))
                continue
            speed = v.get(f"{edge.id}/speed", speed)
            rate, turn_end = 0.0, end
            if edge.event is EdgeEvent.TURN:
                degrees, sign = turn_of(phase)
                rate = sign * v[f"{edge.id}/turn_rate"]
                turn_end = start + math.radians(degrees) / abs(rate)
                end = turn_end
            acceleration = v.get(f"{edge.id}/acceleration", 0.0)
            until = self._contacts(phase)
            out.append(
                HoldVelocity(
                    actor,
                    start,
                    end,
                    speed=abs(speed),
                    heading=heading,
                    acceleration=acceleration,
                    turn_rate=rate,
                    roll_radius=body.roll_radius,
                    until_contact=until,
                )
            )
            heading += rate * (end - start) if edge.event is EdgeEvent.TURN else 0.0
            speed = max(0.0, speed + acceleration * (min(end, duration) - start))
            clock = end
            if last and self._leaves_to_others(actor, phase):
                hit = self.nominal.get(f"{phase.end.id}/event_time", duration)
                out.append(AdjustProperties(actor, hit, linear_damping=AFTER_HIT_DAMPING))
            if last and phase.end.event in (NodeEvent.REACH, NodeEvent.STOP):
                out.append(AdjustProperties(actor, end, linear_damping=REACH_BRAKE_DAMPING))
        return out

    def _leaves_to_others(self, actor: str, phase: Phase) -> bool:
        """A driven body whose part ends with a hit that others carry on brakes there.

        Otherwise it would run into the back of what it has just sent on its way, and crush it
        against the next target.
        """
        if phase.end.event is not NodeEvent.COLLISION or self.scene.body(actor).roll_radius:
            return False
        after = [n for n in self.story.nodes.values() if phase.end.id in self.story.ancestors(n.id)]
        return bool(after) and not any(actor in n.participants for n in after)

    def _phase_end(self, phase: Phase, v: Values, start: float, duration: float) -> float:
        name = f"{phase.end.id}/time"
        if phase.end.event is NodeEvent.TRIGGER and name in v:
            return max(start + 0.05, v[name])
        if phase.end.event in (NodeEvent.REACH, NodeEvent.STOP) and name in v:
            return max(start + 0.05, v[name])
        if phase.end.event is NodeEvent.POSITION_AT and phase.end.timestamp is not None:
            return max(start + 0.05, phase.end.timestamp)
        return duration + 1.0

    def _contacts(self, phase: Phase) -> tuple[str, ...]:
        """A hold ends at the touch of the target, or of any other member of its group."""
        names: list[str] = []
        for p in phase.end.participants:
            if p != phase.edge.actor and phase.end.event is not NodeEvent.SCENE_START:
                names += self.story.expand(p)
        if phase.edge.target and phase.edge.target in self.scene.names:
            names += self.story.expand(phase.edge.target)
        seen = dict.fromkeys(
            n for n in names if n != phase.edge.actor and self.scene.body(n).shapes
        )
        return tuple(seen)

    def _launch(
        self, actor: str, body: Body, phase: Phase, v: Values, time: float, heading: float
    ) -> SetVelocity:
        edge = phase.edge
        if f"{edge.id}/heading" in v:
            heading = v[f"{edge.id}/heading"] + v[f"{actor}/aim"]
        flat = np.array([math.cos(heading), math.sin(heading), 0.0])
        if f"{edge.id}/flight_time" in v:
            goal = self._throw_goal(actor, phase)
            assert goal is not None
            goal = goal + np.array([0.0, 0.0, v[f"{edge.id}/aim_height"]])
            offset = goal - np.array(body.position)
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
        if body.roll_radius > 0.0 and not self._flies(actor, phase) and edge.params.spin != "slide":
            spin = (-velocity[1] / body.roll_radius, velocity[0] / body.roll_radius, 0.0)
        return SetVelocity(actor, time, _vec(velocity), spin)

    def _duration(self) -> float:
        """Long enough for the last event and what follows it."""
        latest = 1.0
        for name, variable in self.variables.items():
            if name.endswith(("/time", "/flight_time")):
                latest = max(latest, variable.initial)
        times = [t for k, t in self.nominal.items() if k.endswith("/event_time")]
        latest = max([latest, *times])
        for node in self.story.nodes.values():
            if node.time_is_prescribed:
                prescribed = (
                    node.timestamp if node.timestamp is not None else (node.window or (0, 0))[1]
                )
                latest = max(latest, prescribed)
        return float(min(MAX_DURATION_S, math.ceil(2.0 * (1.15 * latest + AFTERMATH_S)) / 2.0))


def _vec(v: NDArray[np.float64]) -> tuple[float, float, float]:
    return (float(v[0]), float(v[1]), float(v[2]))
