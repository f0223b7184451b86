"""Gradients of the event losses by theta: reverse mode through the fused surrogate (`wp.Tape`).

One rollout with a trace gives the losses, one pass back the derivatives by the numbers of the
program and by the start poses; theta enters both through arithmetic without physics, which central
differences resolve exactly. `ad_valid` says for which events this gradient can be trusted, from the
dependency graph alone; the measurements behind it are in docs/surrogate.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from esg.dynamics.losses import kind_of
from esg.dynamics.losses.residuals import members
from esg.dynamics.losses.smooth import EventLosses
from esg.dynamics.plan import Plan
from esg.dynamics.search.simulate import NOMINAL, Perturbation, program_times
from esg.engines.base import VERIFY_DT_S
from esg.engines.program import batch_programs
from esg.engines.scene import Variation
from esg.engines.surrogate import TapedRollout

Floats = NDArray[np.float64]

_RELATIVE_STEP = 1e-4


class Regime(StrEnum):
    """What lies between theta and an event.

    DIRECT: no contact before it. ONE_CONTACT: the event follows one collision that the actor brings
    about itself. CHAIN: more contacts, or one that does not end smoothly (topple, fall). NONE: no
    smooth residual exists.
    """

    DIRECT = "direct"
    ONE_CONTACT = "one_contact"
    CHAIN = "chain"
    NONE = "none"


AD_REGIMES = (Regime.DIRECT, Regime.ONE_CONTACT)
"""Where the gradient is the derivative of what the surrogate does (docs/surrogate.md)."""


@dataclass(frozen=True)
class Gradient:
    """Losses and gradients of W candidates.

    Args:
        loss: Shape [W].
        gradient: By theta in SI units, zero for fixed entries and in worlds that diverged, [W, n].
        residual: Per "event/quantity", SI, NaN where it has none, shape [W].
        done: Per event, whether it happened, shape [W].
        valid: False for worlds that diverged or whose gradient is not finite, shape [W].
        trusted: Valid, and nothing hit anything before the last event but what the timeline says:
            a ball that knocks over bottles on its way to the table has no useful gradient, [W].
    """

    loss: Floats
    gradient: Floats
    residual: dict[str, Floats]
    done: dict[str, NDArray[np.bool_]]
    valid: NDArray[np.bool_]
    trusted: NDArray[np.bool_]


@dataclass(frozen=True)
class GradientCheck:
    """Gradients by `wp.Tape` and by central differences of the same surrogate.

    Args:
        tape, differences: Shape [n], in loss per spread of each variable.
        cosine: Of the angle between them; 1 if both vanish.
        error: Norm of the difference over the norm of `differences`.
        smooth: Whether the same events happen at all points of the difference; where they do not,
            the loss jumps and `differences` is no derivative.
        trusted: `Gradient.trusted` at theta.
    """

    tape: Floats
    differences: Floats
    cosine: float
    error: float
    smooth: bool
    trusted: bool


def regimes(plan: Plan) -> dict[str, Regime]:
    """The regime of every event that physics brings about, from the dependency graph."""
    story = plan.story
    out: dict[str, Regime] = {}
    for node in story.outcomes:
        earlier = [story.nodes[i] for i in story.ancestors(node.id)]
        contacts = [n for n in earlier if kind_of(n).contact]
        if kind_of(node).smooth is None:
            out[node.id] = Regime.NONE
        elif not contacts:
            out[node.id] = Regime.DIRECT
        elif len(contacts) == 1 and kind_of(contacts[0]).sends:
            out[node.id] = Regime.ONE_CONTACT
        else:
            out[node.id] = Regime.CHAIN
    return out


def ad_valid(plan: Plan) -> bool:
    """Whether the gradient of every event may be taken by reverse mode."""
    return all(r in AD_REGIMES for r in regimes(plan).values())


def gradient(
    plan: Plan,
    thetas: Floats,
    *,
    device: str = "cpu",
    dt: float = VERIFY_DT_S,
    perturbations: list[Perturbation] | None = None,
    with_gradient: bool = True,
) -> Gradient:
    """Losses of candidates and their gradients by theta.

    Args:
        plan: Variables, scene and timeline.
        thetas: Shape [W, n].
        device: Warp device.
        dt: Physics step [s].
        perturbations: One per world; nominal if None.
        with_gradient: False computes the losses only.
    """
    members = perturbations or [NOMINAL] * len(thetas)
    moved = np.array(thetas, float)
    aims = [i for i, v in enumerate(plan.variables) if v.name.endswith("/aim")]
    for w, member in enumerate(members):
        moved[w, aims] += member.aim
    position, quaternion = starts(plan, moved)
    taped = TapedRollout(
        plan.scene,
        batch_programs([plan.compile(t) for t in moved], plan.scene.names),
        dt=dt,
        variation=_variation(plan, members, position, quaternion),
        device=device,
    )
    losses = EventLosses(plan, taped, [program_times(plan, t) for t in moved])
    slopes = np.zeros_like(moved)
    if with_gradient:
        slopes = _pull_back(plan, moved, taped, losses)
    finite = np.isfinite(slopes).all(axis=1) & taped.valid
    return Gradient(
        losses.loss,
        np.where(finite[:, None], np.nan_to_num(slopes), 0.0),
        losses.residual,
        losses.done,
        finite,
        finite & ~_incidental(plan, taped, losses),
    )


def _incidental(plan: Plan, taped: TapedRollout, losses: EventLosses) -> NDArray[np.bool_]:
    """Whether bodies hit each other, before the last step that matters, that no event names."""
    told: set[tuple[int, int]] = set()
    for node in plan.story.outcomes:
        if kind_of(node).contact:
            one, two = members(plan, node)
            told |= {(min(a, b), max(a, b)) for a in one for b in two}
    horizon = np.where(losses.horizon > 0, losses.horizon, taped.frames.n_steps)
    return np.array([any(p[0] >= 0 and p not in told for p in h) for h in taped.hits(horizon)])


def check_gradient(
    plan: Plan,
    theta: Floats,
    *,
    device: str = "cpu",
    dt: float = VERIFY_DT_S,
    width: float = 0.2,
) -> GradientCheck:
    """Compares `gradient` at one theta with central differences of the same losses.

    Args:
        plan: Variables, scene and timeline.
        theta: Shape [n].
        device: Warp device.
        dt: Physics step [s].
        width: Half width of the difference in spreads; times are moved by whole steps. Narrow
            differences measure at which phase of a step a hit falls.
    """
    free = np.flatnonzero(plan.free())
    spread = np.array([max(v.spread, 1e-9) for v in plan.variables])
    half = width * spread
    times = _times(plan)
    half[times] = np.maximum(np.rint(half[times] / dt), 1.0) * dt
    probes = np.repeat(np.asarray(theta, float)[None], 2 * len(free), axis=0)
    for k, i in enumerate(free):
        probes[2 * k, i] += half[i]
        probes[2 * k + 1, i] -= half[i]
    found = gradient(plan, np.asarray(theta, float)[None], device=device, dt=dt)
    probed = gradient(plan, probes, device=device, dt=dt, with_gradient=False)
    losses = probed.loss
    differences = np.zeros(len(theta))
    differences[free] = (losses[0::2] - losses[1::2]) / (2.0 * half[free]) * spread[free]
    tape = np.where(plan.free(), found.gradient[0] * spread, 0.0)
    one, two = float(np.linalg.norm(tape)), float(np.linalg.norm(differences))
    both = one > 1e-9 and two > 1e-9
    cosine = float(tape @ differences) / (one * two) if both else float(one < 1e-6 and two < 1e-6)
    error = float(np.linalg.norm(tape - differences)) / max(two, 1e-9)
    smooth = all((d == found.done[k][0]).all() for k, d in probed.done.items())
    return GradientCheck(
        tape,
        differences,
        cosine,
        error,
        bool(smooth and probed.valid.all()),
        bool(found.trusted[0]),
    )


def _times(plan: Plan) -> NDArray[np.int64]:
    return np.array([i for i, v in enumerate(plan.variables) if v.name.endswith("/time")], int)


def _pull_back(plan: Plan, thetas: Floats, taped: TapedRollout, losses: EventLosses) -> Floats:
    pulled = taped.pull(losses.seeds, losses.horizon)
    out = np.zeros_like(thetas)
    spread = np.array([max(v.spread, 1e-6) for v in plan.variables])
    for i in np.flatnonzero(plan.free()):
        half = _RELATIVE_STEP * spread[i]
        ends = [thetas.copy(), thetas.copy()]
        ends[0][:, i] += half
        ends[1][:, i] -= half
        tables = [
            batch_programs([plan.compile(t) for t in e], plan.scene.names).table for e in ends
        ]
        with np.errstate(invalid="ignore"):
            change = np.nan_to_num(tables[0] - tables[1], nan=0.0, posinf=0.0, neginf=0.0)
        poses = [starts(plan, e) for e in ends]
        total = (change * pulled.table).sum(axis=(1, 2))
        total += ((poses[0][0] - poses[1][0]) * pulled.position).sum(axis=(1, 2))
        total += ((poses[0][1] - poses[1][1]) * pulled.quaternion).sum(axis=(1, 2))
        for (w, node), slope in losses.clock.items():
            later, sooner = (program_times(plan, e[w]).get(node, 0.0) for e in ends)
            total[w] += slope * (later - sooner)
        out[:, i] = total / (2.0 * half)
    return out


def starts(plan: Plan, thetas: Floats) -> tuple[Floats, Floats]:
    """Start poses of all bodies, shapes [W, B, 3] and [W, B, 4]."""
    bodies = plan.scene.bodies
    position = np.tile(np.array([b.position for b in bodies]), (len(thetas), 1, 1))
    quaternion = np.tile(np.array([b.quaternion for b in bodies]), (len(thetas), 1, 1))
    for w, theta in enumerate(thetas):
        for name, (p, q) in plan.starts(theta).items():
            i = plan.scene.index(name)
            position[w, i], quaternion[w, i] = p, q
    return position, quaternion


def _variation(
    plan: Plan, members: list[Perturbation], position: Floats, quaternion: Floats
) -> Variation:
    actors = [plan.scene.index(a) for a in plan.story.phases]
    mass = np.array([[1.0 / m.mass] * len(plan.scene.bodies) for m in members])
    for w, member in enumerate(members):
        mass[w, actors] = member.mass
    return Variation(
        position=position,
        quaternion=quaternion,
        mass_scale=mass,
        friction_scale=np.array([m.friction for m in members]),
        restitution_offset=np.array([m.restitution for m in members]),
    )
