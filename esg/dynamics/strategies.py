"""The search for theta: strategies behind one interface.

`batched` (ours) explores in the fused surrogate and decides in the reference engine (`batched`).
`ad`, `fd` and `hybrid` are the paper's gradient descents (`gradient`). `none` plays the draft's
heuristic values unchanged (the paper's w/o Opt.). `random`, `cem` and `cma` are baselines at a
fixed number of rollouts (`baselines`).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from esg.dynamics.gradient import descend
from esg.dynamics.gradient.refine import COLLISIONS, Staged, staged_search
from esg.dynamics.plan import Plan, build_scene, make_plan, ruled_out
from esg.dynamics.plan.liquids import liquids
from esg.dynamics.plan.postures import first_postures
from esg.dynamics.search import REFERENCE_DT_S, Found, Panel
from esg.dynamics.search.baselines import BASELINES, minimize
from esg.dynamics.search.batched import search, with_pieces
from esg.dynamics.search.closedloop import close_loop
from esg.dynamics.search.results import static_result, write_result
from esg.engines.base import Engine
from esg.engines.breaking import unbroken
from esg.engines.program import Primitive
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.canonical import document_hash, entropy
from esg.graph.casting import effective
from esg.graph.models import ClosedLoop, DynamicsResult, EsgDocument, Provenance
from esg.outcomes import UserError

STAGE_VERSION = "2"
STRATEGIES = ("batched", "hybrid", "fd", "ad", "none")
MAX_ROUNDS = 12
STEPS_PER_ROUND = 3
"""Gradient steps that stand for one round of candidates."""
BASELINE_ROLLOUTS = 320


def optimize(
    doc: EsgDocument,
    *,
    seed: int = 0,
    strategy: str = "batched",
    device: str = "cpu",
    max_rounds: int = MAX_ROUNDS,
    rounds_closed: int = 0,
    rollouts: int | None = None,
    collision: str = "exact",
    engines: Callable[[str, str], Engine] = get_engine,
) -> EsgDocument:
    """Grounds the timeline: finds theta and writes `dynamics_result`.

    Args:
        doc: A document with assets and layout.
        seed: Of all random draws.
        strategy: One of `STRATEGIES` or a baseline (random, cem, cma).
        device: Where the engines run.
        max_rounds: Batches of candidates after which the search gives up.
        rounds_closed: Rounds of the closed loop through the verify engine; 0 for none.
        rollouts: Budget of a baseline, 320 if None; of `batched`, unbounded if None.
        collision: What bodies collide with during the search: exact (their parts), proxy (one
            sphere or box each) or sdf (that, then signed distance fields; `refine`).
        engines: Name and device -> engine.

    Returns:
        The document with `dynamics_result` and provenance; never raises for a timeline it cannot
        satisfy: `dynamics_result.outcome` says how it ended.

    Raises:
        UserError: For an unknown strategy or collision model, or one that knows no joints.
    """
    _check(strategy, collision, rounds_closed)
    given, doc = doc, effective(doc)
    scene = _scene_for(doc, strategy, collision)
    if doc.timeline_system is None:
        return _write(given, static_result(strategy, scene, _still(doc, scene)), seed, strategy)
    plan = make_plan(doc, scene, seed=seed, look_ahead=strategy != "none")
    if not plan.variables:
        return _write(given, static_result(strategy, scene, _still(doc, scene)), seed, strategy)
    salt = entropy(doc)

    def run(
        plan: Plan, judges: Panel, round_: int = 0, barred: frozenset[str] = frozenset()
    ) -> tuple[Found, str]:
        rng = np.random.default_rng([seed, salt, *([round_] if round_ else [])])
        return run_strategy(
            plan, judges, rng, strategy, max_rounds=max_rounds, rollouts=rollouts, barred=barred
        )

    if collision != "exact":
        staged = staged_search(
            doc, scene, collision, lambda plan, judges: run(plan, judges)[0].theta,
            seed=seed, strategy=strategy, device=device, engines=engines,
        )  # fmt: skip
        return _write(given, _judge_staged(doc, staged, strategy, device, engines), seed, strategy,
                      collision)  # fmt: skip
    panel = Panel(plan, device, dt=REFERENCE_DT_S, engines=engines)
    barred = ruled_out(doc, plan.story)
    found, stopped = run(plan, panel, 0, barred)
    whole = panel.whole(found)
    if whole is None:
        # A body that was held still does not stay where it stands: search with all of them.
        found, stopped = run(plan, panel, 0, barred)
    else:
        found = whole
    closed: ClosedLoop | None = None
    if rounds_closed and strategy != "none":

        def again(bias: dict[str, float], round_: int) -> Found:
            panel.rebias(bias)
            return run(plan, panel, round_, barred)[0]

        found, closed = close_loop(plan, found, again, rounds_closed)
        panel.rebias({})
    result = write_result(
        doc, plan, panel, found, strategy=strategy, stopped=stopped, closed=closed
    )
    return _write(given, result, seed, strategy)


def _check(strategy: str, collision: str, rounds_closed: int) -> None:
    """Raises what is wrong with a request."""
    if collision not in COLLISIONS:
        raise UserError(
            f"unknown collision model {collision!r}; choose one of {', '.join(COLLISIONS)}"
        )
    if collision != "exact" and (rounds_closed or strategy == "none"):
        raise UserError(
            f"collision model {collision!r} needs a search and no closed loop; "
            "choose another strategy, or collision model exact"
        )
    if strategy not in (*STRATEGIES, *BASELINES):
        raise UserError(f"unknown strategy {strategy!r}; choose one of {', '.join(STRATEGIES)}")


def _still(doc: EsgDocument, scene: SimScene) -> tuple[Primitive, ...]:
    """What is done where nobody acts."""
    return (*first_postures(doc, scene), *liquids(doc, scene))


def _scene_for(doc: EsgDocument, strategy: str, collision: str) -> SimScene:
    """The physical scene; raises what is wrong with a request for one that has joints or
    breaks."""
    scene = build_scene(doc)
    has = [j.name for j in scene.joints] or [b.name for b in scene.bodies if b.fragments]
    if not has:
        return scene
    knows = "knows no joints" if scene.joints else "breaks nothing"
    if strategy in ("ad", "hybrid"):
        raise UserError(
            f"strategy {strategy!r} differentiates the surrogate, which {knows}, and the "
            f"scene has {has}; choose batched, fd or none"
        )
    if collision != "exact":
        raise UserError(
            f"collision model {collision!r} searches in the surrogate, which {knows}, and "
            f"the scene has {has}; choose collision model exact"
        )
    return scene


def _judge_staged(
    doc: EsgDocument,
    staged: Staged,
    strategy: str,
    device: str,
    engines: Callable[[str, str], Engine],
) -> DynamicsResult:
    """What a search with proxies found, played once in the reference engine with true parts."""
    panel = Panel(staged.plan, device, dt=REFERENCE_DT_S, engines=engines)
    found = panel.judge(staged.theta[None])
    panel.steps[:0] = staged.steps
    stopped = "refined" if staged.refined else "proxies only"
    result = write_result(
        doc, staged.plan, panel, found, strategy=strategy, stopped=stopped, closed=None
    )
    return result.model_copy(
        update={
            "evaluations": result.evaluations + staged.evaluations,
            "explored": result.explored + staged.explored,
        }
    )


def run_strategy(
    plan: Plan,
    panel: Panel,
    rng: np.random.Generator,
    strategy: str,
    *,
    max_rounds: int = MAX_ROUNDS,
    rollouts: int | None = None,
    steps: int | None = None,
    barred: frozenset[str] = frozenset(),
) -> tuple[Found, str]:
    """The theta a strategy finds, judged by the ensemble, and why it stopped.

    Args:
        plan: Variables, scene and timeline.
        panel: Engines.
        rng: Source of all draws.
        strategy: As of `optimize`.
        max_rounds: Batches of candidates.
        rollouts: Budget of a baseline, 320 if None; of `batched`, unbounded if None.
        steps: Most gradient steps of a kind; three a round if None.
        barred: Events that physics rules out, for `batched`.
    """
    if strategy == "batched":
        bodies, whole = len(plan.scene.bodies), len(unbroken(plan.scene).bodies)
        most = with_pieces(bodies, whole, rollouts)
        return search(plan, panel, rng, max_rounds, barred, most)
    if strategy == "none":
        theta = plan.heuristic()
        nominal = panel.reference.assess(theta[None])
        panel.note("start", "newton", 1, float(nominal.total[0]))
        return Found(theta, float(nominal.total[0]), nominal, nominal), "not searched"
    if strategy in BASELINES:
        budget = BASELINE_ROLLOUTS if rollouts is None else rollouts
        theta = minimize(plan, panel, rng, strategy, budget)
        return panel.judge(theta[None]), "budget spent"
    most = STEPS_PER_ROUND * max_rounds if steps is None else steps
    descent = descend(plan, panel, rng, strategy, most)
    return panel.judge(descent.theta[None]), descent.stopped


def _write(
    doc: EsgDocument, result: DynamicsResult, seed: int, strategy: str, collision: str = "exact"
) -> EsgDocument:
    config = {"strategy": strategy}
    if collision != "exact":
        config["collision"] = collision
    provenance = Provenance(
        stage="optimize",
        version=STAGE_VERSION,
        seed=seed,
        config=config,
        input_hash=document_hash(doc),
    )
    return doc.model_copy(
        update={"dynamics_result": result, "provenance": (*doc.provenance, provenance)}
    )
