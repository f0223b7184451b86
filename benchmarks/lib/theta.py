"""What the benchmarks of the search share: laid-out scenes, cold starts and PhysX as the judge."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
import time
from typing import Any

import numpy as np

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.engines.base import VERIFY_DT_S
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Variation
from esg.graph.models import EsgDocument
from esg.layout import solve
from esg.metrics import judge, load_suite
from esg.metrics.models import SuiteScene

PAPER = Path("data/suites/paper.yaml")


@dataclass(frozen=True)
class Case:
    """A scene of a suite, laid out, and the plan of its timeline."""

    scene: SuiteScene
    doc: EsgDocument
    plan: Plan


def case(scene: SuiteScene, seed: int) -> Case:
    """Drafts, resolves and lays out one scene."""
    doc = fitted(resolve(draft(scene.prompt, seed=seed), seed=seed))
    doc = solve(doc, seed=seed, hints=start_hints(doc, seed=seed))
    return Case(scene, doc, make_plan(doc, build_scene(doc), seed=seed))


def suite_scene(name: str, suite: Path = PAPER) -> SuiteScene:
    return next(s for s in load_suite(suite).scenes if s.id == name)


def cold(plan: Plan, rng: np.random.Generator) -> Plan:
    """The plan with a start drawn uniformly between the bounds: nothing known from choreography."""
    variables = tuple(
        v if v.fixed else replace(v, initial=float(rng.uniform(v.lower, v.upper)))
        for v in plan.variables
    )
    return replace(plan, variables=variables)


def completed(case: Case, theta: np.ndarray, engine: str = "physx") -> list[bool]:
    """Events of the suite that theta completes in an engine at 240 steps a second."""
    plan = case.plan
    program = plan.compile(theta)
    position = np.array([b.position for b in plan.scene.bodies])[None].copy()
    quaternion = np.array([b.quaternion for b in plan.scene.bodies])[None].copy()
    bodies = list(plan.scene.bodies)
    for name, (p, q) in plan.starts(theta).items():
        i = plan.scene.index(name)
        position[0, i], quaternion[0, i] = p, q
        bodies[i] = replace(bodies[i], position=tuple(p), quaternion=tuple(q))
    rollout = get_engine(engine).rollout(
        plan.scene,
        batch_programs([program], plan.scene.names),
        dt=VERIFY_DT_S,
        variation=Variation(position=position, quaternion=quaternion),
    )
    moved = replace(plan.scene, bodies=tuple(bodies))
    verdict = judge(moved, program, rollout, case.scene)
    return [bool(e.completed) for e in verdict.events]


def panel(plan: Plan, device: str = "cpu") -> Panel:
    return Panel(plan, device, dt=REFERENCE_DT_S)


class Stopwatch:
    """Wall and processor seconds of a block."""

    def __enter__(self) -> Stopwatch:
        self._start, self._cpu = time.perf_counter(), time.process_time()
        return self

    def __exit__(self, *_: Any) -> None:
        self.seconds = time.perf_counter() - self._start
        self.cpu = time.process_time() - self._cpu
