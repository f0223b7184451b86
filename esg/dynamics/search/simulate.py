"""Candidates in, losses out: theta batches simulated as parallel worlds of the reference engine."""

from __future__ import annotations

from dataclasses import dataclass, replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import Assessment, assess
from esg.dynamics.losses.horizon import told_by
from esg.dynamics.plan import Plan
from esg.dynamics.search.bystanders import bystanders, held, touched
from esg.dynamics.story.story import turn_of
from esg.engines.base import Engine
from esg.engines.program import batch_programs
from esg.engines.scene import Rollout, SimScene, Variation
from esg.graph.models import EdgeEvent

FPS = 60.0
PLAY_ON_STEPS = 2
"""How many steps in one are taken to see when all has come to rest, which decides nothing else."""


@dataclass(frozen=True)
class Perturbation:
    """One member of the robustness ensemble, as factors on the nominal scene.

    Args:
        friction: Factor on every friction coefficient.
        restitution: Added to every restitution.
        mass: Factor on the mass of active bodies (its inverse on passive ones).
        aim: Error of every active body's heading [rad].
    """

    friction: float = 1.0
    restitution: float = 0.0
    mass: float = 1.0
    aim: float = 0.0


NOMINAL = Perturbation()
ENSEMBLE = (
    NOMINAL,
    Perturbation(friction=0.8, restitution=0.05, mass=0.95),
    Perturbation(friction=1.2, restitution=-0.05, mass=1.05),
    Perturbation(friction=0.8, restitution=-0.1, aim=0.002),
    Perturbation(friction=1.2, restitution=0.1, aim=-0.002),
    Perturbation(mass=1.05, aim=0.003),
    Perturbation(mass=0.95, aim=-0.003),
    Perturbation(restitution=0.05, aim=0.001),
)


class Simulator:
    """Runs a plan's candidates in one engine and counts what that costs.

    Args:
        plan: What is searched.
        engine: Plays it.
        dt: Its step [s].
        bias: Of the targets (`losses.assessment`).
        hold: Whether bodies that no event is about are held still until something touches them
            (`bystanders`).
    """

    def __init__(
        self,
        plan: Plan,
        engine: Engine,
        *,
        dt: float,
        bias: dict[str, float] | None = None,
        hold: bool = False,
    ) -> None:
        self.plan, self.engine, self.dt, self.bias = plan, engine, dt, bias
        self.evaluations = 0
        self._still = np.zeros(len(plan.scene.bodies), bool)
        if hold and getattr(engine, "holds", True):
            self._still = bystanders(plan)
        self._held = held(plan.scene, self._still) if self._still.any() else None
        self._actors = [plan.scene.index(a) for a in plan.story.phases]
        self._every = max(1, round(1.0 / (FPS * dt)))
        self._aims = [i for i, v in enumerate(plan.variables) if v.name.endswith("/aim")]

    def assess(
        self,
        thetas: NDArray[np.float64],
        perturbations: list[Perturbation] | None = None,
        *,
        whole: bool = False,
        until: float = math.inf,
    ) -> Assessment:
        """Losses of candidates.

        Args:
            thetas: Shape [W, n].
            perturbations: One per world; nominal if None.
            whole: Hold no body still.
            until: By when everything should have happened [s]: what has not told all by then is
                played again to its end.
        """
        members = perturbations or [NOMINAL] * len(thetas)
        found = self._assess(thetas, members, whole, until)
        if until < self.plan.duration:
            late = np.flatnonzero(told_by(self.plan.story, found) > until)
            if len(late):
                known = [members[w] for w in late]
                _put(found, late, self._assess(thetas[late], known, whole, math.inf))
        return found

    def _assess(
        self,
        thetas: NDArray[np.float64],
        members: list[Perturbation],
        whole: bool,
        until: float,
    ) -> Assessment:
        if self._held is None or whole:
            return self._play(self.plan.scene, thetas, members, until)[1]
        rollout, found = self._play(self._held, thetas, members, until)
        again = np.flatnonzero(touched(rollout, self._still))
        if len(again):
            known = [members[w] for w in again]
            _put(found, again, self._play(self.plan.scene, thetas[again], known, until)[1])
        return found

    def play_on(self, theta: NDArray[np.float64], duration: float) -> Rollout:
        """One unperturbed candidate with all its bodies, for longer than events need.

        Nothing is judged: it is no evaluation, and steps are longer where frames allow it.

        Args:
            theta: Shape [n].
            duration: [s].
        """
        batch = batch_programs([self.plan.compile(theta)], self.plan.scene.names)
        longer = math.gcd(self._every, PLAY_ON_STEPS)
        return self.engine.rollout(
            self.plan.scene,
            replace(batch, duration=duration),
            dt=longer * self.dt,
            record_every=self._every // longer,
            variation=self._variation(theta[None], [NOMINAL]),
        )

    @property
    def holds(self) -> bool:
        """Whether some bodies are held still."""
        return self._held is not None

    def release(self) -> None:
        """Holds no body still any more."""
        self._held = None

    def _play(
        self,
        scene: SimScene,
        thetas: NDArray[np.float64],
        members: list[Perturbation],
        until: float = math.inf,
    ) -> tuple[Rollout, Assessment]:
        moved = thetas.copy()
        for w, member in enumerate(members):
            moved[w, self._aims] += member.aim
        programs = [self.plan.compile(theta) for theta in moved]
        batch = batch_programs(programs, self.plan.scene.names)
        if until < self.plan.duration:
            batch = replace(batch, duration=math.ceil(FPS * until) / FPS)
        rollout = self.engine.rollout(
            scene,
            batch,
            dt=self.dt,
            record_every=self._every,
            variation=self._variation(moved, members),
        )
        self.evaluations += len(thetas)
        times = [program_times(self.plan, theta) for theta in moved]
        return rollout, assess(self.plan.scene, self.plan.story, rollout, times, self.bias)

    def _variation(self, thetas: NDArray[np.float64], members: list[Perturbation]) -> Variation:
        bodies = self.plan.scene.bodies
        n = len(thetas)
        position = np.tile(np.array([b.position for b in bodies]), (n, 1, 1))
        quaternion = np.tile(np.array([b.quaternion for b in bodies]), (n, 1, 1))
        for w, theta in enumerate(thetas):
            for name, (p, q) in self.plan.starts(theta).items():
                i = self.plan.scene.index(name)
                position[w, i], quaternion[w, i] = p, q
        mass = np.array([[1.0 / m.mass] * len(bodies) for m in members])
        for w, member in enumerate(members):
            mass[w, self._actors] = member.mass
        return Variation(
            position=position,
            quaternion=quaternion,
            mass_scale=mass,
            friction_scale=np.array([m.friction for m in members]),
            restitution_offset=np.array([m.restitution for m in members]),
        )


def _put(found: Assessment, worlds: NDArray[np.int64], other: Assessment) -> None:
    """Replaces some of the worlds by those of another assessment of the same timeline."""
    found.total[worlds] = other.total
    for name in ("completed", "time", "measured", "error", "terms"):
        for key, values in getattr(found, name).items():
            values[worlds] = getattr(other, name)[key]


def program_times(plan: Plan, theta: NDArray[np.float64]) -> dict[str, float]:
    """Times the program itself sets: triggers and the ends of turns, by node id [s].

    The start of a turn is under "node id/begin".
    """
    values = dict(zip((v.name for v in plan.variables), map(float, theta), strict=True))
    out: dict[str, float] = {}
    for node in plan.story.nodes.values():
        name = f"{node.id}/time"
        if name in values:
            out[node.id] = values[name]
    for phases in plan.story.phases.values():
        for phase in phases:
            if phase.edge.event is EdgeEvent.TURN:
                begin = out.get(phase.start.id, 0.0)
                degrees, _ = turn_of(phase)
                rate = values[f"{phase.edge.id}/turn_rate"]
                out[f"{phase.end.id}/begin"] = begin
                out[phase.end.id] = begin + math.radians(degrees) / rate
    return out
