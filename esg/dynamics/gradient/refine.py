"""Search on simple proxies and its refinement by signed distance fields (the paper's two stages).

`proxy` searches with one sphere or bounding box a body. `sdf` takes the theta found so as a warm
start for a further pass in which the bodies of the timeline's events meet by voxel signed distance
fields. Neither sees the collision parts during the search; the result is judged with them.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.gradient.descent import descend_from
from esg.dynamics.plan import Plan, make_plan
from esg.dynamics.search import REFERENCE_DT_S, Panel
from esg.dynamics.search.fields import RESOLUTION, body_fields
from esg.dynamics.story.proxies import coarse
from esg.dynamics.story.story import Story
from esg.engines.base import Engine
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument, SearchStep

Floats = NDArray[np.float64]

COLLISIONS = ("exact", "proxy", "sdf")
"""What bodies collide with during a search: their parts, one primitive, or that and then fields."""
REFINE_STEPS = 30
"""Adam steps of the pass, as in the paper."""
GRADIENT_STRATEGIES = ("ad", "fd", "hybrid")

Run = Callable[[Plan, Panel], Floats]
"""Searches a plan with a panel and returns the best theta."""


@dataclass
class Staged:
    """What a search with simple proxies found, refined or not.

    Args:
        plan: The plan with the scene's true parts.
        theta: Shape [n].
        steps: Record of the search.
        evaluations: Rollouts of the reference engine (with proxies).
        explored: Rollouts of the surrogates.
        refined: Bodies that had a field; empty if nothing was refined.
    """

    plan: Plan
    theta: Floats
    steps: list[SearchStep]
    evaluations: int
    explored: int
    refined: tuple[str, ...] = ()


def refined_bodies(scene: SimScene, story: Story) -> tuple[str, ...]:
    """Bodies of the timeline's events that are no balls, in the scene's order.

    A sphere is its own exact proxy. What has an inside (a bin, a table with pockets) keeps its
    parts: walls and openings are smaller than a cell.
    """
    from esg.engines.surrogate import is_ball

    told = {m for n in story.outcomes for p in n.participants for m in story.expand(p)}
    hollow = {r.parent for r in scene.regions}
    return tuple(
        b.name
        for b in scene.bodies
        if b.name in told and b.name not in hollow and b.collides and not is_ball(b)
    )


def proxy_plan(doc: EsgDocument, scene: SimScene, *, seed: int, kind: str = "box") -> Plan:
    """The plan that knows nothing but simple proxies: its aim, its losses and its contacts."""
    return make_plan(doc, coarse(scene, kind), seed=seed)


def staged_search(
    doc: EsgDocument,
    scene: SimScene,
    collision: str,
    run: Run,
    *,
    seed: int,
    strategy: str,
    device: str,
    engines: Callable[[str, str], Engine],
) -> Staged:
    """Searches with proxies and, for `sdf`, refines.

    Args:
        doc: The document.
        scene: Its scene with true parts.
        collision: proxy or sdf.
        run: The search.
        seed: Of the choreography.
        strategy: The search's name; the gradient strategies refine by Adam.
        device: Where the engines run.
        engines: Name and device -> engine.
    """
    plan = proxy_plan(doc, scene, seed=seed)
    true = replace(plan, scene=scene)
    if not plan.variables:
        return Staged(true, plan.initial(), [], 0, 0)
    panel = Panel(plan, device, dt=REFERENCE_DT_S, engines=engines)
    out = Staged(true, run(plan, panel), list(panel.steps), panel.evaluations, panel.explored)
    return refine(doc, out, run, strategy=strategy, device=device) if collision == "sdf" else out


def refine(
    doc: EsgDocument,
    found: Staged,
    run: Run,
    *,
    strategy: str,
    device: str,
    source: str = "parts",
    resolution: int = RESOLUTION,
    cache: Path | None = None,
) -> Staged:
    """The further pass with contacts from signed distance fields, starting from a theta.

    Gradient strategies take up to 30 Adam steps on central differences of the surrogate with
    fields; `batched` samples around the warm start in it. Nothing is done where all bodies of the
    events are balls.

    Args:
        doc: The document.
        found: What the search with proxies found.
        run: The search.
        strategy: The search's name.
        device: Where the surrogate runs.
        source: Surface the fields are made of (`fields.body_fields`).
        resolution: Cells along a body's longest side.
        cache: Folder of computed fields.
    """
    plan = found.plan
    names = refined_bodies(plan.scene, plan.story)
    if not names:
        return found
    from esg.engines.surrogate import SdfSurrogateEngine

    fields = body_fields(doc, plan.scene, names, resolution=resolution, cache=cache, source=source)
    engine = SdfSurrogateEngine(fields, device)
    warm = tuple(
        replace(v, initial=float(t)) for v, t in zip(plan.variables, found.theta, strict=True)
    )
    plan = replace(plan, variables=warm)
    panel = Panel(plan, device, dt=REFERENCE_DT_S, engines=lambda name, where: engine)
    if strategy in GRADIENT_STRATEGIES:
        theta = descend_from(plan, panel, found.theta, engine.name, REFINE_STEPS).theta
    else:
        theta = run(plan, panel)
    steps = [
        s.model_copy(update={"phase": f"refine {s.phase}", "engine": engine.name})
        for s in panel.steps
    ]
    return Staged(
        found.plan,
        theta,
        found.steps + steps,
        found.evaluations,
        found.explored + panel.evaluations + panel.explored,
        names,
    )
