"""Impulses and motion of one step of the fused surrogate, as Warp functions.

Sequential impulses with Coulomb friction and Newton's law of restitution. A body that is hit within
the step moves with its old velocity up to the moment of touch and with its new one from there on
(the mean moment, weighted by impulse, if there are several). This makes the path after a bounce
independent of where in the step it happens, and differentiable.
"""

from __future__ import annotations

# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
import warp as wp

from esg.engines.surrogate_contacts import free, point_velocity, tangent, turned
from esg.engines.surrogate_types import Contacts, Model, State

wp.set_module_options({"enable_backward": False})

ITERATIONS = wp.constant(10)
CONVERGED_MPS = wp.constant(3.0e-4)
"""Sweeps end when no contact's velocity changes by more than this."""
ASLEEP_MPS = wp.constant(0.01)
ASLEEP_S = wp.constant(0.25)


@wp.func
def _push(model: Model, state: State, w: int, i: int, arm: wp.vec3, impulse: wp.vec3):
    if free(model, state, w, i):
        state.v[w, i] = state.v[w, i] + impulse / model.mass[w, i]
        state.o[w, i] = state.o[w, i] + state.inverse[w, i] @ wp.cross(arm, impulse)


@wp.func
def solve(model: Model, state: State, con: Contacts, w: int, step: int) -> int:
    """Sweeps over the contacts until their impulses agree; returns the number of sweeps."""
    row = wp.min(step, con.count.shape[1] - 1)
    n_contacts = con.count[w, row]
    for sweep in range(ITERATIONS):
        change = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
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
            t1 = tangent(n)
            t2 = wp.cross(n, t1)
            along = wp.max(0.0, old[0] + share[0] * (con.wanted[w, slot] - wp.dot(n, u)))
            p1 = old[1] - share[1] * wp.dot(t1, u)
            p2 = old[2] - share[2] * wp.dot(t2, u)
            size = wp.sqrt(p1 * p1 + p2 * p2)
            most = con.friction[w, slot] * along
            if size > most:
                p1 = p1 * most / size
                p2 = p2 * most / size
            new = wp.vec3(along, p1, p2)
            con.impulse[w, slot] = new
            if along > 0.0:
                con.used[w, slot] = 1
            d = new - old
            change = wp.max(change, wp.abs(d[0]) / share[0])
            change = wp.max(change, wp.max(wp.abs(d[1]) / share[1], wp.abs(d[2]) / share[2]))
            p = n * d[0] + t1 * d[1] + t2 * d[2]
            _push(model, state, w, a, arm_a, p)
            _push(model, state, w, b, arm_b, -p)
        if change < CONVERGED_MPS:
            return sweep + 1
    return ITERATIONS


@wp.func
def _delay(model: Model, state: State, w: int, i: int, impulse: float, delay: float):
    if free(model, state, w, i):
        state.delay[w, i] = state.delay[w, i] + wp.vec2(impulse * delay, impulse)


@wp.func
def move(model: Model, state: State, con: Contacts, w: int, step: int, dt: float, may_sleep: bool):
    """Moves everything awake by its new velocity and puts to sleep what rests."""
    row = wp.min(step, con.count.shape[1] - 1)
    for k in range(con.count[w, row]):
        slot = con.base * row + k
        impulse = con.impulse[w, slot][0]
        _delay(model, state, w, con.a[w, slot], impulse, con.delay[w, slot])
        _delay(model, state, w, con.b[w, slot], impulse, con.delay[w, slot])
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
