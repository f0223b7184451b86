"""Impulses and motion of one step of the fused surrogate, as Warp functions.

Sequential impulses with Coulomb friction and Newton's law of restitution. A body that is hit within
the step moves with its old velocity up to the moment of touch and with its new one from there on
(the mean moment, weighted by impulse, if there are several). This makes the path after a bounce
independent of where in the step it happens, and differentiable.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.surrogate.contacts import lightness, point_velocity, turned
from esg.engines.surrogate.types import Contacts, Model, State

wp.set_module_options({"enable_backward": False})

ITERATIONS = wp.constant(10)
CONVERGED_MPS = wp.constant(3.0e-4)
"""Sweeps end when no contact's velocity changes by more than this."""
ASLEEP_MPS = wp.constant(0.01)
ASLEEP_S = wp.constant(0.25)


@wp.func
def _push(state: State, w: int, i: int, light: float, arm: wp.vec3, impulse: wp.vec3):
    if light > 0.0:
        state.v[w, i] = state.v[w, i] + impulse * light
        state.o[w, i] = state.o[w, i] + state.inverse[w, i] @ wp.cross(arm, impulse)


@wp.func
def solve(model: Model, state: State, con: Contacts, w: int, step: int) -> int:
    """Sweeps over the contacts until their impulses agree; returns the number of sweeps."""
    row = wp.min(step, con.count.shape[1] - 1)
    n_contacts = con.count[w, row]
    # A loop over a constant range would be unrolled.
    most_sweeps = int(ITERATIONS)
    for sweep in range(most_sweeps):
        settled = int(1)  # noqa: UP018, RUF046  # a variable to Warp, not a constant
        for k in range(n_contacts):
            slot = con.base * row + k
            a = con.a[w, slot]
            b = con.b[w, slot]
            n = con.normal[w, slot]
            arm_a = con.arm_a[w, slot]
            arm_b = con.arm_b[w, slot]
            share = con.share[w, slot]
            old = con.impulse[w, slot]
            u = point_velocity(state, w, a, arm_a) - point_velocity(state, w, b, arm_b)
            along = wp.max(0.0, old[0] + share[0] * (con.wanted[w, slot] - wp.dot(n, u)))
            if along == 0.0 and old[0] == 0.0:
                # What neither presses nor pressed has no friction either.
                continue
            t1 = con.side[w, slot]
            t2 = wp.cross(n, t1)
            p1 = old[1] - share[1] * wp.dot(t1, u)
            p2 = old[2] - share[2] * wp.dot(t2, u)
            size2 = p1 * p1 + p2 * p2
            most = con.friction[w, slot] * along
            if size2 > most * most:
                less = most / wp.sqrt(size2)
                p1 = p1 * less
                p2 = p2 * less
            con.impulse[w, slot] = wp.vec3(along, p1, p2)
            if along > 0.0:
                con.used[w, slot] = 1
            dn = along - old[0]
            d1 = p1 - old[1]
            d2 = p2 - old[2]
            if (
                wp.abs(dn) >= CONVERGED_MPS * share[0]
                or wp.abs(d1) >= CONVERGED_MPS * share[1]
                or wp.abs(d2) >= CONVERGED_MPS * share[2]
            ):
                settled = 0
            p = n * dn + t1 * d1 + t2 * d2
            _push(state, w, a, state.light[w, a], arm_a, p)
            _push(state, w, b, lightness(state, w, b), arm_b, -p)
        if settled != 0:
            return sweep + 1
    return ITERATIONS


@wp.func
def _delay(state: State, w: int, i: int, impulse: float, delay: float):
    if lightness(state, w, i) > 0.0:
        state.delay[w, i] = state.delay[w, i] + wp.vec2(impulse * delay, impulse)


@wp.func
def move(model: Model, state: State, con: Contacts, w: int, step: int, dt: float, may_sleep: bool):
    """Moves everything awake by its new velocity and puts to sleep what rests."""
    row = wp.min(step, con.count.shape[1] - 1)
    for k in range(con.count[w, row]):
        slot = con.base * row + k
        impulse = con.impulse[w, slot][0]
        _delay(state, w, con.a[w, slot], impulse, con.delay[w, slot])
        _delay(state, w, con.b[w, slot], impulse, con.delay[w, slot])
    for i in range(model.n_bodies):
        if model.dynamic[i] != 0 and state.awake[w, i] != 0:
            r = state.r[w, i]
            o = state.o[w, i]
            late = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
            if state.delay[w, i][1] > 0.0:
                late = state.delay[w, i][0] / state.delay[w, i][1]
            state.x[w, i] = (
                state.x[w, i] + state.v[w, i] * (dt - late) + state.before_v[w, i] * late
            )
            turn = o * (dt - late) + state.before_o[w, i] * late
            angle = wp.length(turn)
            if angle > 1.0e-9:
                # The angular momentum stays when the body turns, so the velocity changes.
                spin = turned(model.inertia[i], r) @ o
                r = wp.normalize(wp.quat_from_axis_angle(turn / angle, angle) * r)
                state.r[w, i] = r
                state.o[w, i] = turned(model.inverse_inertia[i], r) @ spin
            slow = wp.length(state.v[w, i]) < ASLEEP_MPS
            if slow and wp.length(state.o[w, i]) * model.reach[i] < ASLEEP_MPS:
                state.idle[w, i] = state.idle[w, i] + 1
                if may_sleep and float(state.idle[w, i]) * dt > ASLEEP_S:
                    state.awake[w, i] = 0
                    state.v[w, i] = wp.vec3()
                    state.o[w, i] = wp.vec3()
            else:
                state.idle[w, i] = 0
