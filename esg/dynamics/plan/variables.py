"""The entries of theta: one variable per free or prescribed parameter of the timeline (SI).

Every variable has two starting values: `initial`, from the choreography and the geometry that the
layout found, and `heuristic`, the middle of the interval the draft wrote down. The strategy `none`
plays the heuristic values unchanged.
"""

from __future__ import annotations

from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography.falling.throws import opens_upwards
from esg.dynamics.choreography.flights import flown_to
from esg.dynamics.choreography.handling import TURN_RATE_DEG_S
from esg.dynamics.plan.aim import aim_point
from esg.dynamics.plan.cast import Cast
from esg.dynamics.story.paces import (
    hardest_brake,
    slows_by,
    stated_rate,
    stated_speeds,
    top_speed,
    usual_brake,
)
from esg.dynamics.story.story import (
    CRUISES,
    ON_THE_SPOT,
    UNDISTURBED,
    Phase,
    bounds,
    is_climb,
    is_posture,
    middle,
)
from esg.dynamics.story.suspension import joint_of
from esg.dynamics.story.tipping import FLIES_AT
from esg.engines.scene import Body, Region
from esg.graph.models import EdgeEvent, NodeEvent, TimelineEdge, TimelineNode
from esg.units import GRAVITY_MPS2

SLOWER = 0.8
"""Least speed of what is to stay on a table, over the one that brings it near its edge."""
SOFTLY = 0.6
"""Share of the blow that breaks it at which what is to fall first is pushed at most: with a
restitution of a half it takes nine tenths."""
BESIDE_M = 0.05
"""What stands on the same thing stands so level: the cat on a sideboard, not the boy before it."""
FASTEST_THROW_CM_S = 2500.0
"""A hard kick or throw; guessed speeds stay below it."""

OVER_MOUTH = 1.25
"""Height over the middle of a container at which a throw is aimed, in half heights of it."""
CHAIN_PRECISION = 0.4
"""Factor on the first spread of the aim for every ball that a struck ball shall hit."""
ASIDE_M = 0.25
"""Most that a driven body starts aside of its line; what is narrow at most half its width."""
SOFTEST_BRAKE_MPS2 = 0.5
"""Nothing that is said to brake does so more gently."""
TIGHTER = 0.97, 1.1
"""Rates of a turn on a table, over the one that was planned for."""
AFTER_EVENT_S = 0.12
"""What follows an outcome is planned for this long after it."""


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
Floats = NDArray[np.float64]


class Declarations:
    """Declares the variables of every actor's phases, with bounds, starts and mask.

    Args:
        cast: Who takes part, and how.

    Attributes:
        variables: Entries of theta by name, in order.
        tied: Names that share the variable of another one.
    """

    def __init__(self, cast: Cast) -> None:
        self.cast, self.scene, self.story, self.nominal = (
            cast, cast.scene, cast.story, cast.nominal
        )  # fmt: skip
        self.variables: dict[str, Variable] = {}
        self.tied: dict[str, str] = {}
        for actor, phases in self.story.phases.items():
            self.declare(actor, phases)

    def add(
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

    def declare(self, actor: str, phases: tuple[Phase, ...]) -> None:
        body = self.scene.body(actor)
        first = phases[0]
        if first.edge.event in ON_THE_SPOT:
            for phase in phases:
                self.declare_phase(actor, body, phase)
            return
        limit = 3.0 if self.cast.drives(actor) else 14.0
        if self.scene.body(actor).roll_radius and body.half_extents[0] < 0.05:
            limit = 20.0
        delicate = max(self.cast.balls_after(first), int(f"{actor}/aim" in self.nominal))
        self.add(
            f"{actor}/aim",
            -math.radians(limit),
            math.radians(limit),
            self.nominal.get(f"{actor}/aim", 0.0),
            0.0,
            math.radians(limit / 6.0) * CHAIN_PRECISION**delicate,
            "rad",
        )
        if self.cast.drives(actor):
            aside = min(ASIDE_M, min(body.half_extents[:2]))
            self.add(f"{actor}/lateral", -aside, aside, 0.0, 0.0, 0.24 * aside, "m")
        for phase in phases:
            self.declare_phase(actor, body, phase)
        if first.edge.params.heading_deg is not None and first.edge.event is EdgeEvent.TOWARD:
            low, high, fixed = bounds(first.edge.params.heading_deg, (0.0, 0.0))
            self.add(
                f"{first.edge.id}/heading",
                math.radians(low),
                math.radians(high),
                math.radians(0.5 * (low + high)),
                math.radians(0.5 * (low + high)),
                math.radians(max(high - low, 1.0) / 6.0),
                "rad",
                fixed=fixed,
            )

    def declare_phase(self, actor: str, body: Body, phase: Phase) -> None:
        edge, params = phase.edge, phase.edge.params
        nominal = self.nominal
        if self.cast.coasts(phase):
            return
        if is_climb(phase) or is_posture(phase):
            self.declare_climb(phase)
        elif phase.end.event is NodeEvent.JUMP:
            self.declare_jump(phase)
        elif edge.event in (EdgeEvent.GUIDE, EdgeEvent.DRIVE):
            self.declare_way(phase)
        elif edge.event is EdgeEvent.RELEASE:
            joint = joint_of(self.cast.doc, actor)
            angle = math.radians(joint.position if joint is not None else 0.0)
            self.add(f"{edge.id}/angle", angle, angle, angle, angle, 0.0, "rad", fixed=True)
        elif edge.event is EdgeEvent.TOWARD and self.story.flies(actor):
            self.declare_throw(actor, body, phase)
        elif edge.event in (
            EdgeEvent.UNIFORM_MOTION,
            EdgeEvent.TOWARD,
            EdgeEvent.TURN,
            EdgeEvent.ACCELERATED_MOTION,
        ) and (edge.event is not EdgeEvent.TURN or params.speed is not None):
            self.declare_speed(actor, phase)
        if edge.event is EdgeEvent.ACCELERATED_MOTION:
            low, high, fixed = bounds(params.acceleration, (50.0, 500.0))
            start = nominal.get(f"{edge.id}/acceleration", 0.005 * (low + high))
            if not fixed:
                low, high = max(low, 70.0 * start), min(high, 130.0 * start)
            self.add(
                f"{edge.id}/acceleration",
                low / 100,
                high / 100,
                start,
                0.005 * (low + high),
                0.1 * (high - low) / 100,
                "m/s^2",
                fixed=fixed,
            )
        stopping = nominal.get(f"{edge.id}/stopping")
        if stopping is not None:
            self.add(
                f"{edge.id}/stopping",
                0.5 * stopping,
                2.0 * stopping,
                stopping,
                stopping,
                0.05 * stopping,
                "s",
            )
        elif edge.event is EdgeEvent.BRAKE and f"{edge.id}/leaves" not in nominal:
            self.declare_brake(actor, phase)
        if edge.event in (EdgeEvent.TURN, EdgeEvent.SPIN):
            usual = TURN_RATE_DEG_S if edge.event is EdgeEvent.SPIN else (20.0, 80.0)
            low, high, fixed = bounds(params.turn_rate_deg_s, usual)
            start = nominal.get(f"{edge.id}/turn_rate", math.radians(45.0))
            if not fixed and f"{edge.id}/at_most" in nominal:  # as wide as its table allows
                told = math.degrees(start)
                low, high = max(low, TIGHTER[0] * told), min(high, TIGHTER[1] * told)
            self.add(
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
            self.declare_time(phase, node)

    def declare_brake(self, actor: str, phase: Phase) -> None:
        """How hard it brakes: as the ground allows, or by a damping that the document states."""
        edge = phase.edge
        damping, _, stated = bounds(edge.params.damping, (0.0, 0.0))
        if stated:
            name = f"{edge.id}/damping"
            self.add(name, damping, damping, damping, damping, 0.0, "1/s", fixed=True)
            return
        speed = self.nominal.get(f"{edge.id}/brakes_from", 0.0)
        usual = usual_brake(self.cast.doc, actor, speed)
        start = self.nominal.get(f"{edge.id}/braking", usual)
        low, high = min(SOFTEST_BRAKE_MPS2, 0.5 * start), hardest_brake(self.cast.doc, actor, speed)
        rate = stated_rate(edge)
        if rate is not None:
            by_itself, most = slows_by(self.cast.doc, actor, speed), high
            low, high = (max(r - by_itself, 0.0) for r in rate)
            if low < high:  # "brakes hard": as hard as it can
                low, high = min(low, 0.99 * most), min(high, most)
        self.add(f"{edge.id}/braking", low, high, start, max(usual, low), 0.12 * start, "m/s^2")

    def declare_jump(self, phase: Phase) -> None:
        """Vertical and horizontal speed of a jump."""
        for part in ("rise", "speed"):
            name = f"{phase.edge.id}/{part}"
            told = self.nominal.get(name, 2.0 if part == "rise" else 0.0)
            fixed = told == 0.0
            # What comes down somewhere else has hardly a choice.
            ends = f"{phase.edge.id}/aloft" in self.nominal
            low, high = (0.96, 1.06) if ends else (0.8, 1.4)
            self.add(name, low * told, high * told, told, told, 0.04 * told, "m/s", fixed=fixed)

    def declare_climb(self, phase: Phase) -> None:
        """When it has got there: its way and its pace leave no choice."""
        told = self.nominal.get(f"{phase.end.id}/event_time", 1.0)
        self.add(f"{phase.end.id}/time", told, told, told, told, 0.0, "s", fixed=True)

    def declare_way(self, phase: Phase) -> None:
        """How long something is carried; a Trigger at its end has a time of its own."""
        if phase.end.event is NodeEvent.TRIGGER:
            return
        name = f"{phase.edge.id}/duration"
        usual = self.nominal.get(name, 2.0)
        low, high, fixed = bounds(phase.edge.params.duration, (0.7 * usual, 2.0 * usual))
        self.add(name, low, high, usual, 0.5 * (low + high), 0.05 * usual, "s", fixed=fixed)

    def declare_time(self, phase: Phase, node: TimelineNode) -> None:
        """Times the program sets: triggers, and starts of phases that follow an outcome."""
        name = f"{node.id}/time"
        starts_here = any(
            p.start.id == node.id and not self.cast.coasts(p)
            for ps in self.story.phases.values()
            for p in ps
        )
        controlled = node.event is NodeEvent.TRIGGER
        brakes_at_reach = node.event is NodeEvent.REACH and phase.end.id == node.id
        plain_stop = (
            node.event is NodeEvent.STOP
            and phase.end.id == node.id
            and phase.edge.event is not EdgeEvent.BRAKE
        )
        follows_outcome = starts_here and node.event not in (
            NodeEvent.SCENE_START,
            NodeEvent.PICKED_UP,
            NodeEvent.HEADING_REACHED,
            NodeEvent.TRIGGER,
        )
        if name in self.variables or not (
            controlled or brakes_at_reach or follows_outcome or plain_stop
        ):
            return
        window = node.window or (0.3, 12.0)
        told = self.nominal.get(f"{node.id}/event_time", 0.5 * (window[0] + window[1]))
        nominal = self.nominal.get(name, told + (AFTER_EVENT_S if follows_outcome else 0.0))
        # It comes to rest then; its brakes set in before.
        brakes = (brakes_at_reach or plain_stop) and f"{node.id}/time" in self.nominal
        if node.timestamp is not None and node.time_is_prescribed and not brakes:
            self.add(
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
        prescribed = node.time_is_prescribed and not brakes
        low, high = window if prescribed else (0.3 * nominal, 2.5 * nominal + 1.0)
        self.add(name, low, high, nominal, 0.5 * (window[0] + window[1]), 0.12, "s")

    def declare_speed(self, actor: str, phase: Phase) -> None:
        edge, params = phase.edge, phase.edge.params
        name = f"{edge.id}/speed"
        told = stated_speeds(self.cast.doc, actor, edge)
        low, high, fixed = bounds(told, (50.0, 1500.0))
        nominal = self.nominal.get(name, middle(low, high) / 100.0)
        if not (fixed or edge.speed_is_prescribed):
            # A guessed interval gives way to what the choreography needs.
            low, high = min(low, 60.0 * nominal), max(high, 160.0 * nominal)
            backward = params.backward is True
            top = 100.0 * top_speed(self.cast.doc, actor, backward)
            high = max(min(high, top), low) if not backward else top
        high = max(min(high, 100.0 * self.nominal.get(f"{edge.id}/at_most", math.inf)), low)
        if self.story.tips(phase):
            low, high = 50.0 * nominal, 400.0 * nominal
        most = self.nominal.get(f"{edge.id}/most")
        if most is not None:
            high = 100.0 * most
            low = SLOWER * high
        borne = self.unbroken_until_it_falls(actor, phase)
        if borne is not None and not (fixed or edge.speed_is_prescribed):
            high = min(high, 100.0 * SOFTLY * borne)
            low, nominal = min(low, 0.5 * high), min(nominal, 0.01 * high)
        tie = self.same_speed_as(phase) or self.keeps_speed(phase)
        if tie is not None:
            self.tied[name] = tie
            return
        after = self.speed_for_transfer(actor, phase)
        if phase.end.time_is_prescribed:
            nominal *= math.sqrt(self.damping_loss(actor, phase))
        self.add(
            name,
            low / 100.0,
            high / 100.0,
            after or nominal,
            0.005 * (low + high),
            max(0.08 * nominal, 0.05),
            "m/s",
            fixed=fixed,
        )

    def unbroken_until_it_falls(self, actor: str, phase: Phase) -> float | None:
        """Blow [m/s] that breaks what stands beside an actor, if that is to fall before it does."""
        target, system = phase.edge.target, self.cast.doc.timeline_system
        if phase.end.event is not NodeEvent.COLLISION or target is None or system is None:
            return None
        events = {n.event for n in system.sequence_graph.nodes if target in n.participants}
        body, feet = self.scene.body(target), self.scene.body(actor)
        foot, base = (b.position[2] + b.origin_offset[2] for b in (feet, body))
        if abs(foot - base) > BESIDE_M:
            return None
        if body.break_impulse is None or not {NodeEvent.FALL, NodeEvent.BREAK} <= events:
            return None
        return body.break_impulse / body.mass

    def same_speed_as(self, phase: Phase) -> str | None:
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

    def keeps_speed(self, phase: Phase) -> str | None:
        """What drives on as before shares the variable of the segment before."""
        phases = self.story.phases[phase.edge.actor]
        k = phases.index(phase)
        if k == 0 or phase.edge.speed_is_prescribed:
            return None
        before = phases[k - 1]
        if before.edge.event not in CRUISES or before.end.event not in UNDISTURBED:
            return None
        name, former = f"{phase.edge.id}/speed", f"{before.edge.id}/speed"
        same = math.isclose(self.nominal.get(name, 0.0), self.nominal.get(former, -1.0))
        former = self.tied.get(former, former)
        return former if same and former in self.variables else None

    def speed_for_transfer(self, actor: str, phase: Phase) -> float | None:
        """Speed that gives the target its prescribed speed in a central impact."""
        for c in phase.end.constraints:
            if c.quantity != "speed_after" or c.object == actor:
                continue
            if phase.end.event is NodeEvent.COLLISION and c.object in phase.end.participants:
                low, high, _ = bounds(c.value, (0.0, 0.0))
                a, b = self.scene.body(actor), self.scene.body(c.object)
                gain = (1 + 0.5 * (a.restitution + b.restitution)) * a.mass / (a.mass + b.mass)
                return 0.005 * (low + high) / gain * self.damping_loss(actor, phase)
        return None

    def damping_loss(self, actor: str, phase: Phase) -> float:
        """Factor by which a freely rolling body must start faster to arrive as planned."""
        body = self.scene.body(actor)
        if phase.edge.event is not EdgeEvent.TOWARD or body.linear_damping <= 0.0:
            return 1.0
        duration = self.nominal.get(f"{phase.end.id}/event_time", 1.0)
        return float(min(math.exp(body.linear_damping * duration), 3.0))

    def declare_throw(self, actor: str, body: Body, phase: Phase) -> None:
        """Speed and elevation of a throw, or its flight time and aim where it has a goal."""
        edge = phase.edge
        phase = flown_to(self.story, phase)
        low, high, fixed = bounds(edge.params.speed, (100.0, FASTEST_THROW_CM_S))
        if not (fixed or edge.speed_is_prescribed):
            high = max(high, FASTEST_THROW_CM_S)
        if fixed:
            speed = low / 100
            name = f"{edge.id}/speed"
            self.add(name, speed, speed, speed, speed, 0.0, "m/s", fixed=True)
            start = self.nominal.get(f"{edge.id}/elevation")
            start = self.elevation_for(actor, phase, low / 100.0) if start is None else start
            self._declare_elevation(edge, (-30.0, 75.0), start, 0.05)
            return
        offset = self._goal_of(actor, edge.id)
        if offset is not None:
            self._declare_flight(body, phase, edge.id, offset, low, high)
            return
        tilt = self.nominal.get(f"{edge.id}/elevation")
        if tilt is not None:
            self._declare_clearing(edge, tilt)
            return
        speed = middle(max(low, 1.0), high) / 100.0
        self.add(
            f"{edge.id}/speed",
            low / 100,
            high / 100,
            speed,
            0.005 * (low + high),
            0.1 * speed,
            "m/s",
        )
        self._declare_elevation(edge, (0.0, 60.0), None, 0.1)

    def _declare_clearing(self, edge: TimelineEdge, tilt: float) -> None:
        """Speed and elevation [rad] of a throw that clears something: no slower, and no flatter."""
        speed = self.nominal[f"{edge.id}/speed"]
        self.add(f"{edge.id}/speed", speed, 1.1 * speed, speed, speed, 0.02 * speed, "m/s")
        self.add(f"{edge.id}/elevation", tilt, tilt + 0.1, tilt, tilt, 0.02, "rad")

    def _declare_elevation(
        self,
        edge: TimelineEdge,
        usual: tuple[float, float],
        start: float | None,
        spread: float,
    ) -> None:
        """Elevation of a throw [rad], from `start` on or from the middle of its bounds."""
        low, high, fixed = bounds(edge.params.elevation_deg, usual)
        mid = math.radians(0.5 * (low + high))
        self.add(
            f"{edge.id}/elevation",
            math.radians(low),
            math.radians(high),
            mid if start is None else start,
            mid,
            spread,
            "rad",
            fixed=fixed,
        )

    def _declare_flight(
        self, body: Body, phase: Phase, edge_id: str, goal: Floats, low: float, high: float
    ) -> None:
        """Flight time and height of the aim of a throw at a goal [m] at speeds [cm/s]."""
        target = self.cast.target(phase)
        flight = self.nominal.get(f"{edge_id}/flight_time", 1.0)
        span = float(np.linalg.norm(goal[:2] - np.array(body.position)[:2]))
        self.add(
            f"{edge_id}/flight_time",
            max(span / (high / 100.0), 0.15),
            max(2.5, 1.5 * flight),
            flight,
            span / max(0.005 * (low + high), 0.5),
            0.06 * flight,
            "s",
        )
        height = self.scene.body(target).half_extents[2] if target else 0.3
        region = self.cast.region(phase)
        mouth = region.half_extents[2] if region and region.kind == "inside" else 0.0
        if region and not opens_upwards(self._siblings(region), region.name):
            mouth = 0.0
        banked = f"{edge_id}/goal_above" in self.nominal
        self.add(
            f"{edge_id}/aim_height",
            -0.8 * height,
            max(0.8 * height, 1.5 * mouth),
            0.45 * height if self.story.topples(target) else OVER_MOUTH * mouth,
            0.0,
            0.05 if banked else 0.2 * height,
            "m",
        )

    def _goal_of(self, actor: str, edge_id: str) -> Floats | None:
        phase = next(p for p in self.story.phases[actor] if p.edge.id == edge_id)
        return self.cast.throw_goal(actor, phase)

    def _siblings(self, region: Region) -> list[Region]:
        return [r for r in self.scene.regions if r.parent == region.parent]

    def elevation_for(self, actor: str, phase: Phase, speed: float) -> float:
        """Low-arc launch angle that reaches the target at a given speed."""
        target = self.cast.target(phase)
        body = self.scene.body(actor)
        if target is None:
            return math.radians(20.0)
        d = aim_point(body, self.scene.body(target)) - np.array(body.position)
        x, z, g = float(np.hypot(d[0], d[1])), float(d[2]), GRAVITY_MPS2
        if self.story.topples(target):
            struck = self.scene.body(target)
            foot = float(struck.position[2] + struck.origin_offset[2])
            z = foot + 2.0 * FLIES_AT * float(struck.half_extents[2]) - float(body.position[2])
            # Where it touches, not in the middle of what it touches.
            x = max(x - body.half_extents[0] - 0.5 * min(struck.half_extents[:2]), 0.1)
        if speed < 0.5 or x < 0.05:
            return math.radians(-90.0) if x < 0.05 else 0.0
        root = speed**4 - g * (g * x * x + 2.0 * z * speed * speed)
        if root < 0.0:
            return math.radians(45.0)
        return math.atan2(speed * speed - math.sqrt(root), g * x)
