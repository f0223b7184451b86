"""The search for theta: strategies behind one interface.

`batched` (ours): candidates around the choreographed start are parallel worlds of one model of the
reference engine; the best are replayed under an ensemble of perturbed materials, masses and aims,
and the one with the best worst case wins; a cross-entropy update continues where that is not yet
good enough. `fd` is Adam on finite differences of the same engine (the paper's FD-only). `none`
plays the draft's heuristic values unchanged (the paper's w/o Opt.).
"""

from __future__ import annotations

from dataclasses import dataclass
import zlib

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.build import build_scene
from esg.dynamics.gradient import descend
from esg.dynamics.losses import MISSED, TOLERANCE, Assessment
from esg.dynamics.plan import Plan, make_plan
from esg.dynamics.simulate import ENSEMBLE, Simulator
from esg.engines.base import get_engine
from esg.engines.program import Program, program_to_json
from esg.graph.canonical import document_hash
from esg.graph.models import (
    DynamicsResult,
    EsgDocument,
    Parameter,
    Pose,
    Provenance,
    RelaxedConstraint,
)
from esg.outcomes import Outcome, UserError
from esg.units import quat_rotate, yaw_from_quat

STAGE_VERSION = "1"
STRATEGIES = ("batched", "fd", "none")
PLANNED = ("ad", "hybrid")
"""Named on the command line; they need the differentiable surrogate, which is not built yet."""
REFERENCE_DT_S = 1.0 / 240.0
WORLDS = 32
MAX_ROUNDS = 12
ELITES = 6
FINALISTS = 4
PATIENCE = 3
"""Rounds without progress after which a search whose events all happen gives up on the rest."""
GOOD_LOSS = 0.35
"""Worst-case loss at which the search stops early: all events happen, residuals are small."""
CENTRED_LOSS = 0.15
STATIC_DURATION_S = 1.0

Floats = NDArray[np.float64]


@dataclass
class Found:
    """The best theta so far and how it fared."""

    theta: Floats
    worst: float
    nominal: Assessment
    ensemble: Assessment
    rounds: int
    history: list[float]


def optimize(
    doc: EsgDocument,
    *,
    seed: int = 0,
    strategy: str = "batched",
    device: str = "cpu",
    max_rounds: int = MAX_ROUNDS,
) -> EsgDocument:
    """Grounds the timeline: finds theta and writes `dynamics_result`.

    Args:
        doc: A document with assets and layout.
        seed: Of all random draws.
        strategy: batched, fd or none.
        device: Where the reference engine runs.
        max_rounds: Batches of candidates after which the search gives up.

    Returns:
        The document with `dynamics_result` and provenance; never raises for a timeline it cannot
        satisfy: `dynamics_result.outcome` says how it ended.

    Raises:
        UserError: For an unknown strategy.
    """
    if strategy in PLANNED:
        raise UserError(
            f"strategy {strategy!r} needs the differentiable surrogate, which this version lacks; "
            f"choose one of {', '.join(STRATEGIES)}"
        )
    if strategy not in STRATEGIES:
        raise UserError(f"unknown strategy {strategy!r}; choose one of {', '.join(STRATEGIES)}")
    scene = build_scene(doc)
    if doc.timeline_system is None:
        return _write(doc, _static_result(strategy), seed, strategy)
    plan = make_plan(doc, scene, seed=seed, look_ahead=strategy != "none")
    if not plan.variables:
        return _write(doc, _static_result(strategy), seed, strategy)
    simulator = Simulator(plan, get_engine("newton", device), dt=REFERENCE_DT_S)
    if strategy == "none":
        found = _play(plan, simulator)
    else:
        search = _search if strategy == "batched" else _descend
        entropy = [seed, zlib.crc32(doc.scene_definition.original_description.encode())]
        found = search(plan, simulator, np.random.default_rng(entropy), max_rounds)
    return _write(doc, _result(doc, plan, simulator, found, strategy), seed, strategy)


def _play(plan: Plan, simulator: Simulator) -> Found:
    theta = plan.heuristic()
    nominal = simulator.assess(theta[None])
    return Found(theta, float(nominal.total[0]), nominal, nominal, 1, [float(nominal.total[0])])


def _descend(plan: Plan, simulator: Simulator, rng: np.random.Generator, max_rounds: int) -> Found:
    """Finite-difference Adam, judged by the same ensemble as everything else."""
    descent = descend(plan, simulator, rng, max_steps=3 * max_rounds)
    history = [_rounded(x) for x in descent.history]
    return _worst_case(plan, simulator, descent.theta[None], len(history), history)


def _search(plan: Plan, simulator: Simulator, rng: np.random.Generator, max_rounds: int) -> Found:
    """Cross-entropy search over the free variables with a robust choice among the elites."""
    low, high, free = plan.lower(), plan.upper(), plan.free()
    mean = plan.initial()
    scale = np.array([v.spread for v in plan.variables]) * free
    spread = scale
    elites: Floats = np.zeros((0, len(mean)))
    kept: Floats = np.zeros(0)
    # Most choreographed starts already hold: try a few under the whole ensemble first.
    first = np.clip(mean + spread * rng.standard_normal((FINALISTS, len(mean))), low, high)
    first[0] = np.clip(mean, low, high)
    history: list[float] = []
    best = _worst_case(plan, simulator, first, 1, history)
    history.append(_rounded(best.worst))
    if _good(best):
        return best
    for round_ in range(max_rounds):
        thetas = np.clip(mean + spread * rng.standard_normal((WORLDS, len(mean))), low, high)
        thetas[0] = np.clip(mean, low, high)
        losses = simulator.assess(thetas).total + _prior(plan, thetas)
        pool = np.concatenate([elites, thetas])
        scores = np.concatenate([kept, losses])
        order = np.argsort(scores, kind="stable")
        history.append(_rounded(float(scores[order[0]])))
        found = _worst_case(plan, simulator, pool[order[:FINALISTS]], round_ + 2, history)
        if found.worst < best.worst:
            best = found
        best.rounds, best.history = round_ + 2, history
        if _good(best) or _stalled(best, history):
            break
        elites, kept = pool[order[:ELITES]], scores[order[:ELITES]]
        center = np.concatenate([elites, best.theta[None]]) if best.worst < MISSED else elites
        mean = center.mean(axis=0)
        spread = np.maximum(1.3 * elites.std(axis=0), 0.35 * 0.8**round_ * scale)
        if kept[0] > 0.8 * MISSED:
            # An event never happened yet: look further afield instead of closing in.
            spread = np.maximum(spread, 1.6 * scale)
    return best


def _good(best: Found) -> bool:
    """A small worst case; or everything holds in the whole ensemble and the nominal is centred.

    The perturbations themselves move a prescribed speed or time, so that some worst cases cannot
    become small.
    """
    if best.worst < GOOD_LOSS:
        return True
    holds = best.ensemble.all_completed().all() and best.ensemble.within_tolerance().all()
    return bool(holds) and float(best.nominal.total[0]) < CENTRED_LOSS


def _stalled(best: Found, history: list[float]) -> bool:
    """The last rounds gained nothing although every event already happens."""
    if len(history) < PATIENCE + 2 or not bool(best.nominal.all_completed().all()):
        return False
    earlier, now = min(history[:-PATIENCE]), min(history)
    return earlier - now < max(0.02, 0.02 * earlier)


def _worst_case(
    plan: Plan, simulator: Simulator, thetas: Floats, round_: int, history: list[float]
) -> Found:
    """Replays thetas under the ensemble and keeps the one with the least worst loss."""
    members = [m for _ in thetas for m in ENSEMBLE]
    assessed = simulator.assess(np.repeat(thetas, len(ENSEMBLE), axis=0), members)
    table = assessed.total.reshape(len(thetas), len(ENSEMBLE))
    value = 0.7 * table.max(axis=1) + 0.3 * table.mean(axis=1) + _prior(plan, thetas)
    k = int(np.argmin(value))
    span = slice(k * len(ENSEMBLE), (k + 1) * len(ENSEMBLE))
    ensemble = _slice(assessed, span)
    return Found(
        thetas[k], float(value[k]), _slice(ensemble, slice(0, 1)), ensemble, round_, history
    )


def _slice(a: Assessment, span: slice) -> Assessment:
    return Assessment(
        a.total[span],
        {k: v[span] for k, v in a.completed.items()},
        {k: v[span] for k, v in a.time.items()},
        {k: v[span] for k, v in a.measured.items()},
        {k: v[span] for k, v in a.error.items()},
        {k: v[span] for k, v in a.terms.items()},
    )


def _prior(plan: Plan, thetas: Floats) -> Floats:
    """Normalized l2 distance from the initial theta (paper, L_p), at a small weight."""
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    deviation = np.where(plan.free(), (thetas - plan.initial()) / (6.0 * spread), 0.0)
    return 0.01 * (deviation**2).sum(axis=1)


# -- results ---------------------------------------------------------------------------------


def _result(
    doc: EsgDocument, plan: Plan, simulator: Simulator, found: Found, strategy: str
) -> DynamicsResult:
    nominal = found.nominal
    happened = bool(nominal.all_completed()[0])
    relaxed = _relaxed(doc, nominal) if happened else ()
    outcome = (
        Outcome.NOT_CONVERGED
        if not happened
        else Outcome.NEAREST_FEASIBLE
        if relaxed
        else Outcome.SOLVED
    )
    missing = [k for k, v in nominal.completed.items() if not v[0]]
    reason = f"events not reached in the reference engine: {', '.join(missing)}" if missing else ""
    if relaxed:
        reason = "; ".join(
            f"{r.event}: {r.quantity} {r.achieved:.3g} {r.unit} instead of {r.requested}"
            for r in relaxed
        )
    return DynamicsResult(
        strategy=strategy,
        parameters=tuple(
            Parameter(
                name=v.name,
                value=_rounded(float(t)),
                lower=_rounded(v.lower),
                upper=_rounded(v.upper),
                initial=_rounded(v.initial),
                fixed=v.fixed,
                unit=v.unit,
            )
            for v, t in zip(plan.variables, found.theta, strict=True)
        ),
        start_poses=_start_poses(doc, plan, found.theta),
        program=program_to_json(plan.compile(found.theta)),
        duration_s=plan.duration,
        outcome=outcome.value,
        reason=reason,
        loss=_rounded(float(nominal.total[0])),
        margins=_margins(found.ensemble),
        relaxed=relaxed,
        evaluations=simulator.evaluations,
        history=tuple(found.history),
        engine="newton",
        dt_s=simulator.dt,
    )


def _start_poses(doc: EsgDocument, plan: Plan, theta: Floats) -> dict[str, Pose]:
    """Re-aimed start poses in the document's units, of the asset's origin."""
    out: dict[str, Pose] = {}
    for name, (position, quaternion) in plan.starts(theta).items():
        offset = np.array(plan.scene.body(name).origin_offset)
        origin = 100.0 * (position + quat_rotate(quaternion, offset))
        out[name] = Pose(
            position_cm=(float(origin[0]), float(origin[1]), float(origin[2])),
            yaw_deg=float(np.degrees(yaw_from_quat(quaternion))),
        )
    return out


def _margins(ensemble: Assessment) -> dict[str, float]:
    """Share of the ensemble in which each event happens, and slack of each quantity."""
    out = {k: _rounded(float(v.mean())) for k, v in ensemble.completed.items()}
    for name, error in ensemble.error.items():
        tolerance = TOLERANCE[name.split("/")[1]]
        out[name] = _rounded(float(np.clip(tolerance - np.abs(error).max(), -1e3, 1e3)))
    return out


def _relaxed(doc: EsgDocument, nominal: Assessment) -> tuple[RelaxedConstraint, ...]:
    """Prescribed quantities that could not be met, with what was reached instead."""
    assert doc.timeline_system is not None
    nodes = {n.id: n for n in doc.timeline_system.sequence_graph.nodes}
    out: list[RelaxedConstraint] = []
    for name, error in nominal.error.items():
        event, quantity, obj = name.split("/")
        if abs(float(error[0])) <= TOLERANCE[quantity]:
            continue
        node = nodes[event]
        requested = next(
            (c.value for c in node.constraints if c.quantity == quantity and c.object == obj),
            node.timestamp if node.timestamp is not None else (node.window or 0.0),
        )
        speeds = quantity in ("speed_after", "speed_before", "distance", "height")
        achieved = float(nominal.measured[name][0]) * (100.0 if speeds else 1.0)
        unit = "cm/s" if quantity.startswith("speed") else "cm" if speeds else "s"
        out.append(
            RelaxedConstraint(
                event=event,
                quantity=quantity,
                requested=requested,
                achieved=_rounded(achieved),
                unit="deg" if quantity == "angle" else unit,
            )
        )
    return tuple(out)


def _rounded(value: float) -> float:
    return float(np.round(np.nan_to_num(value, nan=0.0, posinf=1e9, neginf=-1e9), 9))


def _static_result(strategy: str) -> DynamicsResult:
    program = Program((), STATIC_DURATION_S)
    return DynamicsResult(
        strategy=strategy,
        program=program_to_json(program),
        duration_s=STATIC_DURATION_S,
        outcome=Outcome.SOLVED.value,
    )


def _write(doc: EsgDocument, result: DynamicsResult, seed: int, strategy: str) -> EsgDocument:
    provenance = Provenance(
        stage="optimize",
        version=STAGE_VERSION,
        seed=seed,
        config={"strategy": strategy},
        input_hash=document_hash(doc),
    )
    return doc.model_copy(
        update={"dynamics_result": result, "provenance": (*doc.provenance, provenance)}
    )
