"""Forces, waking and contacts of one step of the fused surrogate, as Warp functions.

A contact that closes within the step is measured at the moment of touch.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.surrogate.geometry import collide_ground, collide_shapes, near
from esg.engines.surrogate.types import Contacts, Model, Raw, State

wp.set_module_options({"enable_backward": False})

RESTITUTION_THRESHOLD_MPS = wp.constant(0.2)
GAP_M = wp.constant(0.002)
"""Contacts this close are kept even if they do not close."""
LOOK_AHEAD_M = wp.constant(0.25)
WAKE_STEPS = wp.constant(8.0)
"""How far ahead what sleeps is woken: stacks have to settle before they are hit. With one step the
impulse of a hit is off by 13%, with eight by 3%, as if nothing had slept."""
TIE_M = wp.constant(1.0e-5)
"""What closes to within this by the end of a step hits in it: the points of a face hit together."""
SLOP_M = wp.constant(0.0005)
PUSH = wp.constant(0.1)
"""Share of the overlap beyond the slop that a step removes."""
PUSH_MPS = wp.constant(0.5)


@wp.func
def turned(inertia: wp.mat33, r: wp.quat) -> wp.mat33:
    """A tensor in body axes, in world axes."""
    m = wp.quat_to_matrix(r)
    return m @ inertia @ wp.transpose(m)


@wp.func
def tangent(n: wp.vec3) -> wp.vec3:
    """A unit vector orthogonal to `n`."""
    t = wp.vec3(0.0, -n[2], n[1])
    if wp.abs(n[0]) > 0.7:
        t = wp.vec3(n[1], -n[0], 0.0)
    return wp.normalize(t)


@wp.func
def prepare_bodies(model: Model, state: State, w: int, dt: float):
    """Gravity, damping and inertia in world axes of everything that is awake."""
    for i in range(model.n_bodies):
        state.delay[w, i] = wp.vec2()
        state.light[w, i] = 0.0
        if model.dynamic[i] != 0 and state.awake[w, i] != 0:
            state.light[w, i] = 1.0 / model.mass[w, i]
            damping = state.damping[w, i]
            v = state.v[w, i] + model.gravity * dt
            state.v[w, i] = v * wp.max(0.0, 1.0 - damping[0] * dt)
            state.o[w, i] = state.o[w, i] * wp.max(0.0, 1.0 - damping[1] * dt)
            state.inverse[w, i] = turned(
                model.inverse_inertia[i] * (1.0 / model.factor[w, i]), state.r[w, i]
            )


@wp.func
def _margin(model: Model, state: State, w: int, i: int, j: int, dt: float) -> float:
    # Not the relative speed: a third body may stop one of the two within the step.
    fast = wp.length(state.v[w, i]) + wp.length(state.v[w, j])
    fast = fast + wp.length(state.o[w, i]) * model.reach[i]
    fast = fast + wp.length(state.o[w, j]) * model.reach[j]
    return wp.min(GAP_M + fast * dt, LOOK_AHEAD_M)


@wp.func
def _far(model: Model, state: State, w: int, i: int, j: int) -> bool:
    """Whether two bodies are too far apart for any margin."""
    return not _bodies_near(model, state, w, i, j, LOOK_AHEAD_M)


@wp.func
def _bodies_near(model: Model, state: State, w: int, i: int, j: int, margin: float) -> bool:
    limit = model.reach[i] + model.reach[j] + margin
    return wp.length_sq(state.x[w, i] - state.x[w, j]) < limit * limit


@wp.func
def _shapes_near(model: Model, state: State, w: int, i: int, j: int, margin: float) -> bool:
    for s in range(model.first[i], model.first[i + 1]):
        rs = state.r[w, i] * model.rotation[s]
        xs = state.x[w, i] + wp.quat_rotate(state.r[w, i], model.position[s])
        for q in range(model.first[j], model.first[j + 1]):
            rq = state.r[w, j] * model.rotation[q]
            xq = state.x[w, j] + wp.quat_rotate(state.r[w, j], model.position[q])
            if near(model, s, xs, rs, q, xq, rq, margin):
                return True
    return False


@wp.func
def wake(model: Model, state: State, w: int, dt: float):
    """Wakes sleeping bodies that something awake comes close to."""
    for i in range(model.n_bodies):
        if model.dynamic[i] != 0 and state.awake[w, i] != 0 and state.idle[w, i] == 0:
            for j in range(model.n_bodies):
                if model.dynamic[j] == 0 or state.awake[w, j] != 0:
                    continue
                if _far(model, state, w, i, j):
                    continue
                margin = _margin(model, state, w, i, j, WAKE_STEPS * dt)
                if not _bodies_near(model, state, w, i, j, margin):
                    continue
                if _shapes_near(model, state, w, i, j, margin):
                    state.awake[w, j] = 1
                    state.idle[w, j] = 0
                    state.light[w, j] = 1.0 / model.mass[w, j]
                    state.inverse[w, j] = turned(
                        model.inverse_inertia[j] * (1.0 / model.factor[w, j]), state.r[w, j]
                    )
                    drag = wp.max(0.0, 1.0 - state.damping[w, j][0] * dt)
                    state.v[w, j] = model.gravity * dt * drag


@wp.func
def point_velocity(state: State, w: int, i: int, arm: wp.vec3) -> wp.vec3:
    """Velocity of a point of a body; the ground rests."""
    if i < 0:
        return wp.vec3()
    return state.v[w, i] + wp.cross(state.o[w, i], arm)


@wp.func
def lightness(state: State, w: int, i: int) -> float:
    """Inverse mass [1/kg] of a body; 0 for the ground and what is static or asleep."""
    if i < 0:
        return 0.0
    return state.light[w, i]


@wp.func
def _yields(state: State, w: int, i: int, arm: wp.vec3, n: wp.vec3) -> float:
    """How much a unit impulse along `n` changes the velocity of a point along `n` [1/kg]."""
    light = lightness(state, w, i)
    if light == 0.0:
        return 0.0
    c = wp.cross(arm, n)
    return light + wp.dot(c, state.inverse[w, i] @ c)


@wp.func
def _shares(
    state: State, w: int, a: int, arm_a: wp.vec3, b: int, arm_b: wp.vec3, n: wp.vec3, t1: wp.vec3
) -> wp.vec3:
    """Impulses that change the velocity of a contact by 1 m/s along its axes [kg]."""
    t2 = wp.cross(n, t1)
    share = wp.vec3()
    for d in range(3):
        direction = n
        if d == 1:
            direction = t1
        if d == 2:
            direction = t2
        share[d] = 1.0 / (
            _yields(state, w, a, arm_a, direction) + _yields(state, w, b, arm_b, direction)
        )
    return share


@wp.func
def _place(state: State, w: int, i: int, ahead: float) -> wp.vec3:
    """Where a body's centre is some time into the step."""
    return state.x[w, i] + state.v[w, i] * ahead


@wp.func
def facing(state: State, w: int, i: int, ahead: float) -> wp.quat:
    """A body's orientation some time into the step."""
    turn = state.o[w, i] * ahead
    angle = wp.length(turn)
    if angle < 1.0e-9:
        return state.r[w, i]
    return wp.normalize(wp.quat_from_axis_angle(turn / angle, angle) * state.r[w, i])


@wp.func
def _first_touch(state: State, raw: Raw, w: int, a: int, b: int, dt: float) -> float:
    """When within the step the first of the points in `raw` closes at speed; 0 if none does."""
    first = float(1.0e6)  # noqa: UP018  # a variable to Warp, not a constant
    for k in range(raw.count[w]):
        n = -raw.normal[w, k]
        gap = raw.distance[w, k]
        arm_a = raw.point[w, k] - state.x[w, a]
        arm_b = raw.point[w, k] - state.x[w, b]
        u = point_velocity(state, w, a, arm_a) - point_velocity(state, w, b, arm_b)
        approach = wp.dot(n, u)
        closes = gap > 0.0 and gap + approach * dt < TIE_M
        if closes and approach < -RESTITUTION_THRESHOLD_MPS:
            first = wp.min(first, -gap / approach)
    if first > 2.0 * dt:
        return 0.0
    return wp.min(first, dt)


@wp.func
def _pair(
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    i: int,
    j: int,
    s: int,
    q: int,
    margin: float,
    dt: float,
):
    """Contacts of two shapes, measured at the moment of touch if they hit within the step."""
    early = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
    for attempt in range(2):
        ri = facing(state, w, i, early)
        rj = facing(state, w, j, early)
        xs = _place(state, w, i, early) + wp.quat_rotate(ri, model.position[s])
        xq = _place(state, w, j, early) + wp.quat_rotate(rj, model.position[q])
        collide_shapes(model, raw, s, xs, ri * model.rotation[s], q, xq, rj * model.rotation[q],
                       margin)  # fmt: skip
        if attempt == 0:
            early = _first_touch(state, raw, w, i, j, dt)
            if early <= 0.0:
                break
    _add_contacts(model, state, raw, con, w, step, i, j, s, q, margin, early, dt)


@wp.func
def _add_contacts(
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    a: int,
    b: int,
    shape_a: int,
    shape_b: int,
    margin: float,
    early: float,
    dt: float,
):
    """Turns the points in `raw` into contacts if they touch or will touch within the step."""
    row = wp.min(step, con.count.shape[1] - 1)
    limit = con.a.shape[1]
    room = limit
    if con.base > 0:
        room = wp.min(limit, con.base * (row + 1))
    for k in range(raw.count[w]):
        n = -raw.normal[w, k]
        gap = raw.distance[w, k]
        arm_a = raw.point[w, k] + n * (0.5 * gap) - _place(state, w, a, early)
        arm_b = raw.point[w, k] - n * (0.5 * gap)
        if b >= 0:
            arm_b = arm_b - _place(state, w, b, early)
        approach = wp.dot(
            n, point_velocity(state, w, a, arm_a) - point_velocity(state, w, b, arm_b)
        )
        if gap > margin and gap + wp.min(approach, 0.0) * (dt - early) > GAP_M:
            continue
        slot = con.base * row + con.count[w, row]
        if slot >= room:
            con.dropped[w] = con.dropped[w] + 1
            continue
        con.count[w, row] = con.count[w, row] + 1
        restitution = model.restitution[w, a]
        if b >= 0:
            restitution = 0.5 * (restitution + model.restitution[w, b])
            con.friction[w, slot] = 0.5 * (state.friction[w, a] + state.friction[w, b])
        else:
            restitution = 0.5 * (restitution + model.ground[w][2])
            con.friction[w, slot] = 0.5 * (
                state.friction[w, a] + model.ground[w][wp.min(1, model.wheeled[a])]
            )
        wanted = -gap / dt
        delay = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
        if gap < 0.0:
            wanted = wp.min(PUSH * wp.max(-gap - SLOP_M, 0.0) / dt, PUSH_MPS)
        if approach < -RESTITUTION_THRESHOLD_MPS and gap + approach * (dt - early) < TIE_M:
            wanted = wp.max(-restitution * approach, wp.min(wanted, PUSH_MPS))
            if gap > 0.0 or early > 0.0:
                wanted = -restitution * approach
                delay = wp.max(early - gap / approach, 1.0e-6)
        t1 = tangent(n)
        con.a[w, slot] = a
        con.b[w, slot] = b
        con.shape_a[w, slot] = shape_a
        con.shape_b[w, slot] = shape_b
        con.normal[w, slot] = n
        con.side[w, slot] = t1
        con.arm_a[w, slot] = arm_a
        con.arm_b[w, slot] = arm_b
        con.gap[w, slot] = gap
        con.wanted[w, slot] = wanted
        con.delay[w, slot] = delay
        con.share[w, slot] = _shares(state, w, a, arm_a, b, arm_b, n, t1)
        con.impulse[w, slot] = wp.vec3()
        con.used[w, slot] = 0
        con.early[w, slot] = early
        con.turn_a[w, slot] = facing(state, w, a, early)
        if b >= 0:
            con.turn_b[w, slot] = facing(state, w, b, early)


@wp.func
def meet(
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    i: int,
    j: int,
    margin: float,
    dt: float,
):
    """Contacts of two bodies, shape by shape."""
    for s in range(model.first[i], model.first[i + 1]):
        rs = state.r[w, i] * model.rotation[s]
        xs = state.x[w, i] + wp.quat_rotate(state.r[w, i], model.position[s])
        for q in range(model.first[j], model.first[j + 1]):
            rq = state.r[w, j] * model.rotation[q]
            xq = state.x[w, j] + wp.quat_rotate(state.r[w, j], model.position[q])
            if near(model, s, xs, rs, q, xq, rq, margin):
                _pair(model, state, raw, con, w, step, i, j, s, q, margin, dt)


@wp.func
def meet_ground(
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    i: int,
    margin: float,
    dt: float,
):
    """Contacts of a body's shapes with the ground."""
    for s in range(model.first[i], model.first[i + 1]):
        rs = state.r[w, i] * model.rotation[s]
        xs = state.x[w, i] + wp.quat_rotate(state.r[w, i], model.position[s])
        if xs[2] < model.radius[s] + margin:
            collide_ground(model, raw, s, xs, rs, margin)
            _add_contacts(model, state, raw, con, w, step, i, -1, s, -1, 0.0, 0.0, dt)


@wp.func
def find_contacts(
    model: Model, state: State, raw: Raw, con: Contacts, w: int, step: int, dt: float
):
    """Collects the contacts of the step that starts now."""
    for i in range(model.n_bodies):
        state.before_v[w, i] = state.v[w, i]
        state.before_o[w, i] = state.o[w, i]
    con.count[w, wp.min(step, con.count.shape[1] - 1)] = 0
    for i in range(model.n_bodies):
        moves = model.dynamic[i] != 0 and state.awake[w, i] != 0
        if moves:
            margin = (
                GAP_M + (wp.length(state.v[w, i]) + wp.length(state.o[w, i]) * model.reach[i]) * dt
            )
            if state.x[w, i][2] < model.reach[i] + margin:
                meet_ground(model, state, raw, con, w, step, i, margin, dt)
        for j in range(i + 1, model.n_bodies):
            other = model.dynamic[j] != 0 and state.awake[w, j] != 0
            if not moves and not other:
                continue
            if model.first[i] == model.first[i + 1] or model.first[j] == model.first[j + 1]:
                continue
            if _far(model, state, w, i, j):
                continue
            margin = _margin(model, state, w, i, j, dt)
            if not _bodies_near(model, state, w, i, j, margin):
                continue
            meet(model, state, raw, con, w, step, i, j, margin, dt)
