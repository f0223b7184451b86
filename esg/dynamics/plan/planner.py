"""From the timeline and theta to the control program: variables with bounds and mask, SI units."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.choreography import choreography_of
from esg.dynamics.plan.cast import Cast
from esg.dynamics.plan.guides import times_of, ways
from esg.dynamics.plan.liquids import liquids
from esg.dynamics.plan.postures import first_postures
from esg.dynamics.plan.programs import Composer, Values, supports
from esg.dynamics.plan.variables import Declarations, Variable
from esg.dynamics.story.story import Story
from esg.engines.program import Primitive, Program
from esg.engines.scene import SimScene
from esg.graph.joints import towed_by
from esg.graph.models import EsgDocument
from esg.lexicon.gestures import EASE_S
from esg.units import quat_inverse, quat_multiply, quat_rotate

AFTERMATH_S = 1.5
GESTURE_S = 2.0
"""So much longer plays a scene with a gesture, or in which something begins to smoke [s]."""
MAX_DURATION_S = 14.5


Start = tuple[NDArray[np.float64], NDArray[np.float64]]
"""A pose: position [m], shape [3], and quaternion (x, y, z, w), shape [4]."""


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
        latest: When the choreography expects the last event [s].
    """

    variables: tuple[Variable, ...]
    scene: SimScene
    story: Story
    compile: Callable[[NDArray[np.float64]], Program]
    starts: Callable[[NDArray[np.float64]], dict[str, Start]]
    duration: float
    latest: float = math.inf

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


def make_plan(doc: EsgDocument, scene: SimScene, *, seed: int = 0, look_ahead: bool = True) -> Plan:
    """Reads the timeline of a laid-out document into variables and a program compiler.

    Args:
        doc: The document, its casting applied.
        scene: Its physical scene.
        seed: Of the choreography, where the document holds none.
        look_ahead: Aim with what comes after the first hit in mind; False aims straight at the
            centre of the first target.
    """
    cast = Cast(doc, scene, choreography_of(doc, seed=seed).nominal, look_ahead)
    carried = ways(cast)
    cast.nominal.update(times_of(cast, carried))
    declared, composer = Declarations(cast), Composer(cast, carried)
    latest = _latest(cast, declared.variables)
    after = AFTERMATH_S + _seen(scene)
    duration = min(MAX_DURATION_S, math.ceil(10.0 * (1.15 * latest + after)) / 10.0)

    borne = (*first_postures(doc, scene), *liquids(doc, scene))

    def values(theta: NDArray[np.float64]) -> Values:
        out = dict(zip(declared.variables, map(float, theta), strict=True))
        return out | {k: out[v] for k, v in declared.tied.items()}

    def compile_theta(theta: NDArray[np.float64]) -> Program:
        v = values(theta)
        out: list[Primitive] = [*borne]
        for actor, phases in cast.story.phases.items():
            out += composer.primitives(actor, phases, v, duration)
        return Program(tuple(out), duration)

    def starts(theta: NDArray[np.float64]) -> dict[str, Start]:
        v = values(theta)
        driven = {a: composer.start_pose(a, v) for a in cast.story.phases if cast.drives(a)}
        driven |= {a: way.start for a, way in composer.set_off_climbing.items()}
        return driven | _seated(cast.doc, scene, driven)

    variables = tuple(declared.variables.values())
    return Plan(variables, scene, cast.story, compile_theta, starts, duration, latest)


def _seated(doc: EsgDocument, scene: SimScene, driven: dict[str, Start]) -> dict[str, Start]:
    """Start poses of those who are joined to what is re-aimed, drawn along by it, or lie on it: a
    rider turns with his bicycle, a wheel with its wagon, a load with its cart.
    """
    out: dict[str, Start] = {}
    pairs = [(j.parent, j.child) for j in scene.joints if not j.flexible]
    pairs += [(a, node) for a in driven for node in towed_by(doc, a)]
    loose = [n for n, x in doc.spatial_relation_graph.nodes.items() if not x.is_structural]
    pairs += [(a, n) for n in loose if n in scene.names for a in supports(doc, n)]
    for parent, child in pairs:
        if parent not in driven or child in driven:
            continue
        mount, rider = scene.body(parent), scene.body(child)
        at, turned = driven[parent]
        back = quat_inverse(np.array(mount.quaternion))
        ahead = quat_rotate(back, np.array(rider.position) - np.array(mount.position))
        facing = quat_multiply(back, np.array(rider.quaternion))
        out[child] = (at + quat_rotate(turned, ahead), quat_multiply(turned, facing))
    return out


def _seen(scene: SimScene) -> float:
    """How much longer a scene plays for what is only drawn in it [s]."""
    made = [g for b in scene.bodies for g in b.gestures]
    turns = [2.0 * EASE_S + g.period_s * max(1, g.times) for g in made]
    begins = any(g.begins for b in scene.bodies for g in b.gives_off)
    return max([*turns, GESTURE_S * bool(made or begins)])


def _latest(cast: Cast, variables: dict[str, Variable]) -> float:
    """When the last event is expected [s], at least 1."""
    latest = 1.0
    for name, variable in variables.items():
        if name.endswith(("/time", "/flight_time")):
            latest = max(latest, variable.initial)
    times = [t for k, t in cast.nominal.items() if k.endswith("/event_time")]
    latest = max([latest, *times])
    for node in cast.story.nodes.values():
        if node.time_is_prescribed:
            prescribed = (
                node.timestamp if node.timestamp is not None else (node.window or (0, 0))[1]
            )
            latest = max(latest, prescribed)
    return float(latest)
