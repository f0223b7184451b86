"""From a finished search to the document: theta, start poses, margins and what gave way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import math

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import Assessment
from esg.dynamics.losses.measures import tilt_of
from esg.dynamics.losses.quantities import QUANTITIES, quantity_of
from esg.dynamics.losses.shapes import MISSED
from esg.dynamics.plan import Plan
from esg.dynamics.plan.feasibility import impossible
from esg.dynamics.search.ending import until_rest
from esg.dynamics.search.panel import Found, Panel, rounded
from esg.engines.program import Primitive, Program, program_to_json
from esg.engines.scene import SimScene
from esg.graph.models import (
    ClosedLoop,
    DynamicsResult,
    EsgDocument,
    Parameter,
    Pose,
    RelaxedConstraint,
)
from esg.lexicon.gestures import SEEN_S
from esg.outcomes import Outcome
from esg.thresholds import SAFE_TOPPLED_DEG
from esg.units import quat_rotate, yaw_from_quat

STATIC_DURATION_S = 1.0
LATER, TAIL_S = 1.15, 1.0
"""How much later an event may be in another engine, and what is recorded after the last one."""

Floats = NDArray[np.float64]


def write_result(
    doc: EsgDocument,
    plan: Plan,
    panel: Panel,
    found: Found,
    *,
    strategy: str,
    stopped: str,
    closed: ClosedLoop | None,
) -> DynamicsResult:
    nominal = found.nominal
    happened = bool(nominal.all_completed()[0])
    missing = [k for k, v in nominal.completed.items() if not v[0]]
    barred = {k: why for k, why in impossible(doc, plan.story).items() if k in missing}
    relaxed = _relaxed(doc, nominal) if happened else _given_up(plan, nominal, missing, barred)
    outcome = Outcome.NEAREST_FEASIBLE if relaxed else Outcome.SOLVED
    if missing and not relaxed:
        outcome = Outcome.NOT_CONVERGED
    reason = f"events not reached in the reference engine: {', '.join(missing)}" if missing else ""
    if barred:
        reason = "; ".join([*barred.values(), reason])
    if relaxed and happened:
        reason = "; ".join(
            f"{r.event}: {r.quantity} {r.achieved:.3g} {r.unit} instead of {r.requested}"
            for r in relaxed
        )
    last, least = _ends(plan, found) if happened else (plan.latest, plan.duration)
    duration = until_rest(plan, panel.reference, found.theta, last, least)
    program = replace(plan.compile(found.theta), duration=duration)
    return DynamicsResult(
        strategy=strategy,
        parameters=tuple(
            Parameter(
                name=v.name,
                value=rounded(float(t)),
                lower=rounded(v.lower),
                upper=rounded(v.upper),
                initial=rounded(v.initial),
                fixed=v.fixed,
                unit=v.unit,
            )
            for v, t in zip(plan.variables, found.theta, strict=True)
        ),
        start_poses=_start_poses(doc, plan, found.theta),
        program=program_to_json(program),
        duration_s=duration,
        outcome=outcome.value,
        reason=reason,
        loss=rounded(float(nominal.total[0])),
        margins=_margins(found.ensemble),
        relaxed=relaxed,
        evaluations=panel.evaluations,
        explored=panel.explored,
        history=tuple(s.best for s in panel.steps),
        steps=tuple(panel.steps),
        stopped=stopped,
        closed_loop=closed,
        engine="newton",
        dt_s=panel.reference.dt,
    )


def _ends(plan: Plan, found: Found) -> tuple[float, float]:
    """The last event in the slowest world, and what is worth recording at least: that, a margin and
    a tail [s].
    """
    times = [t[np.isfinite(t)] for t in found.ensemble.time.values()]
    last = max((float(t.max()) for t in times if len(t)), default=plan.duration)
    return last, min(plan.duration, math.ceil(10.0 * (LATER * last + TAIL_S)) / 10.0)


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
    out = {k: rounded(float(v.mean())) for k, v in ensemble.completed.items()}
    for name, error in ensemble.error.items():
        tolerance = quantity_of(name).tolerance
        out[name] = rounded(float(np.clip(tolerance - np.abs(error).max(), -1e3, 1e3)))
    return out


def _relaxed(doc: EsgDocument, nominal: Assessment) -> tuple[RelaxedConstraint, ...]:
    """Prescribed quantities that could not be met, with what was reached instead."""
    assert doc.timeline_system is not None
    nodes = {n.id: n for n in doc.timeline_system.sequence_graph.nodes}
    out: list[RelaxedConstraint] = []
    for name, error in nominal.error.items():
        event, quantity, obj = name.split("/")
        measured = QUANTITIES[quantity]
        if abs(float(error[0])) <= measured.tolerance:
            continue
        node = nodes[event]
        requested = next(
            (c.value for c in node.constraints if c.quantity == quantity and c.object == obj),
            node.timestamp if node.timestamp is not None else (node.window or 0.0),
        )
        out.append(
            RelaxedConstraint(
                event=event,
                quantity=quantity,
                requested=requested,
                achieved=rounded(float(nominal.measured[name][0]) * (1.0 / measured.si)),
                unit=measured.unit,
            )
        )
    return tuple(out)


def _given_up(
    plan: Plan, nominal: Assessment, missing: list[str], barred: dict[str, str]
) -> tuple[RelaxedConstraint, ...]:
    """What gives way where physics rules events out: nothing, unless that explains all others."""
    if not all(k in barred or plan.story.ancestors(k) & set(barred) for k in missing):
        return ()
    return tuple(
        RelaxedConstraint(
            event=k,
            quantity="tilt",
            requested=SAFE_TOPPLED_DEG,
            achieved=rounded(tilt_of(float(nominal.terms[f"{k}/task"][0]) - MISSED)),
            unit="deg",
        )
        for k in barred
    )


def static_result(
    strategy: str, scene: SimScene, primitives: Sequence[Primitive] = ()
) -> DynamicsResult:
    """The result of a scene in which nobody acts: only its liquids do, and gestures are seen."""
    lasts = SEEN_S if any(b.gestures for b in scene.bodies) else STATIC_DURATION_S
    program = Program(tuple(primitives), lasts)
    return DynamicsResult(
        strategy=strategy,
        program=program_to_json(program),
        duration_s=lasts,
        outcome=Outcome.SOLVED.value,
    )
