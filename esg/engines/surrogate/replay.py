"""The replay that is differentiated: one kernel of plain arithmetic, recorded by `wp.Tape`.

Every function mirrors one of `esg.engines.surrogate.solver` with the decisions of the trace. Where
an action snaps to the time step, a term of value zero carries the derivative of its true time
("shift"), so that gradients with respect to times are those of the continuous motion.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.program import Action, Column
from esg.engines.program_kernels import (
    approached,
    grounded,
    guided_velocity,
    path_knot,
    path_velocity,
    tipped,
    vector,
)
from esg.engines.surrogate.features import Features
from esg.engines.surrogate.impact import ahead_of, prepare, tangent, turned
from esg.engines.surrogate.ops import CHANGES, Act, Change, Operation, Ops
from esg.engines.surrogate.types import Model

wp.set_module_options({"enable_backward": True})


@wp.func
def _guided(
    w: int,
    k: int,
    t: wp.float64,
    how: int,
    dt: wp.float64,
    table: wp.array3d(dtype=wp.float64),
    frozen: wp.array3d(dtype=wp.float64),
    x: wp.vec3,
) -> wp.vec3:
    """Velocity of a guided body at `x` once gravity has acted."""
    # Which piece of the path it is on is a decision of the trace.
    here = path_knot(frozen, w, k, t - frozen[w, k, Column.START])
    there = path_knot(frozen, w, k, t + dt - frozen[w, k, Column.START])
    s = t - table[w, k, Column.START]
    guided = guided_velocity(table, w, k, here, there, s, dt, x)
    if (how & Act.LAST) != 0:
        # Let go later, it is as much faster as the path is there, and no farther off it.
        longer = s + table[w, k, Column.END] - frozen[w, k, Column.END]
        faster = path_velocity(table, w, k, here, there, longer, dt)
        return guided + faster - path_velocity(table, w, k, here, there, s, dt)
    return guided


@wp.func
def _act(
    model: Model,
    w: int,
    k: int,
    i: int,
    step: int,
    how: int,
    dt: wp.float64,
    table: wp.array3d(dtype=wp.float64),
    frozen: wp.array3d(dtype=wp.float64),
    vin: int,
    vout: int,
    pose: int,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    X: wp.array(dtype=wp.vec3),
    shift: wp.array(dtype=wp.vec3),
):
    kind = model.action[k]
    late = table[w, k, Column.START] - frozen[w, k, Column.START]
    v = V[vin]
    o = O[vin]
    if kind == Action.ADJUST:
        V[vout] = v
        O[vout] = o
    elif kind == Action.HOLD:
        s = wp.float64(step) * dt - table[w, k, Column.START]
        if (how & Act.LAST) != 0:
            s = s + table[w, k, Column.END] - frozen[w, k, Column.END]
        speed = wp.max(
            wp.float64(0.0), table[w, k, Column.SPEED] + table[w, k, Column.ACCELERATION] * s
        )
        if table[w, k, Column.ACCELERATION] > wp.float64(0.0):
            speed = wp.min(speed, table[w, k, Column.MAX_SPEED])
        heading = table[w, k, Column.HEADING] + table[w, k, Column.TURN_RATE] * s
        vx = float(speed * wp.cos(heading))
        vy = float(speed * wp.sin(heading))
        radius = float(table[w, k, Column.ROLL_RADIUS])
        if not wp.isnan(frozen[w, k, Column.GAINS]):
            near = approached(table, w, k, float(speed), float(heading), v, float(dt))
            vx = near[0]
            vy = near[1]
        flies = not wp.isnan(frozen[w, k, Column.CLIMB])
        if flies:
            # What it flies with once gravity has acted counts for the moment it begins.
            lifted = wp.vec3(vx, vy, float(table[w, k, Column.CLIMB]))
            V[vout] = lifted - wp.vec3(0.0, 0.0, model.gravity[2] * float(dt))
            if (how & Act.FIRST) != 0:
                wp.atomic_add(shift, pose, (v - lifted) * float(late))
        else:
            new = wp.vec3(vx, vy, v[2])
            V[vout] = new
            if (how & Act.FIRST) != 0:
                wp.atomic_add(shift, pose, (v - new) * float(late))
        if radius != 0.0 and not flies:
            O[vout] = wp.vec3(-vy / radius, vx / radius, 0.0)
        else:
            O[vout] = wp.vec3(0.0, 0.0, float(table[w, k, Column.TURN_RATE]))
    elif kind == Action.GUIDE:
        guided = _guided(w, k, wp.float64(step) * dt, how, dt, table, frozen, X[pose])
        V[vout] = guided - wp.vec3(0.0, 0.0, model.gravity[2] * float(dt))
        O[vout] = wp.vec3(0.0, 0.0, float(table[w, k, Column.GUIDE_TURN_RATE]))
        if (how & Act.FIRST) != 0:
            wp.atomic_add(shift, pose, (v - guided) * float(late))
    elif kind == Action.SPIN:
        V[vout] = v
        O[vout] = vector(table, w, k, Column.SPIN)
    else:
        a = vector(table, w, k, Column.LINEAR)
        if kind == Action.SET_VELOCITY:
            V[vout] = a
            if wp.isnan(frozen[w, k, Column.ANGULAR]):
                O[vout] = o
            else:
                O[vout] = vector(table, w, k, Column.ANGULAR)
            wp.atomic_add(shift, pose, (v - a) * float(late))
        else:
            V[vout] = v + a / model.mass[w, i]
            wp.atomic_add(shift, pose, a * (-float(late) / model.mass[w, i]))


@wp.func
def _leaning(model: Model, i: int, kept: wp.spatial_vector, turn: wp.quat, how: int):
    if how == 2:
        return tipped(model.features, i, wp.spatial_top(kept), wp.spatial_bottom(kept), turn)
    return kept


@wp.func
def _stand(
    model: Model,
    w: int,
    i: int,
    brake: int,
    how: int,
    dt: float,
    table: wp.array3d(dtype=wp.float64),
    vin: int,
    vout: int,
    pose: int,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    R: wp.array(dtype=wp.quat),
):
    weight = -model.gravity[2] * dt * model.friction_scale[w]
    if brake >= 0:
        loss = float(table[w, brake, Column.BRAKING]) * dt
        braked = grounded(model.features, i, loss, weight, V[vin], O[vin], R[pose])
        stood = _leaning(model, i, braked, R[pose], how)
        V[vout] = wp.spatial_top(stood)
        O[vout] = wp.spatial_bottom(stood)
    else:
        kept = grounded(model.features, i, 0.0, weight, V[vin], O[vin], R[pose])
        left = _leaning(model, i, kept, R[pose], how)
        V[vout] = wp.spatial_top(left)
        O[vout] = wp.spatial_bottom(left)


@wp.func
def _forces(
    model: Model,
    w: int,
    i: int,
    damper: int,
    spin_damper: int,
    dt: float,
    table: wp.array3d(dtype=wp.float64),
    damping: wp.array2d(dtype=wp.vec2),
    vin: int,
    vout: int,
    pose: int,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    R: wp.array(dtype=wp.quat),
    inverse: wp.array(dtype=wp.mat33),
):
    if damper >= 0:
        V[vout] = (V[vin] + model.gravity * dt) * wp.max(
            0.0, 1.0 - float(table[w, damper, Column.LINEAR_DAMPING]) * dt
        )
    else:
        V[vout] = (V[vin] + model.gravity * dt) * wp.max(0.0, 1.0 - damping[w, i][0] * dt)
    if spin_damper >= 0:
        O[vout] = O[vin] * wp.max(
            0.0, 1.0 - float(table[w, spin_damper, Column.ANGULAR_DAMPING]) * dt
        )
    else:
        O[vout] = O[vin] * wp.max(0.0, 1.0 - damping[w, i][1] * dt)
    inverse[pose] = turned(model.inverse_inertia[i] * (1.0 / model.factor[w, i]), R[pose])


@wp.func
def _solve(
    model: Model,
    feat: Features,
    w: int,
    c: int,
    a: int,
    b: int,
    va: int,
    vb: int,
    out_a: int,
    out_b: int,
    pa: int,
    pb: int,
    jin: int,
    jout: int,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    J: wp.array(dtype=wp.vec3),
    inverse: wp.array(dtype=wp.mat33),
    normal: wp.array(dtype=wp.vec3),
    arm_a: wp.array(dtype=wp.vec3),
    arm_b: wp.array(dtype=wp.vec3),
    wanted: wp.array(dtype=float),
    share: wp.array(dtype=wp.vec3),
):
    n = normal[c]
    one = arm_a[c]
    two = arm_b[c]
    part = share[c]
    old = J[jin]
    u = V[va] + wp.cross(O[va], one) - V[vb] - wp.cross(O[vb], two)
    t1 = tangent(n)
    t2 = wp.cross(n, t1)
    along = wp.max(0.0, old[0] + part[0] * (wanted[c] - wp.dot(n, u)))
    p1 = old[1] - part[1] * wp.dot(t1, u)
    p2 = old[2] - part[2] * wp.dot(t2, u)
    most = feat.friction[c] * along
    size2 = p1 * p1 + p2 * p2
    if size2 > most * most:
        scale = most / wp.sqrt(size2)
        J[jout] = wp.vec3(along, p1 * scale, p2 * scale)
    else:
        J[jout] = wp.vec3(along, p1, p2)
    d = J[jout] - old
    p = n * d[0] + t1 * d[1] + t2 * d[2]
    if a >= 0:
        V[out_a] = V[va] + p / model.mass[w, a]
        O[out_a] = O[va] + inverse[pa] @ wp.cross(one, p)
    if b >= 0:
        V[out_b] = V[vb] - p / model.mass[w, b]
        O[out_b] = O[vb] - inverse[pb] @ wp.cross(two, p)


@wp.func
def _move(
    model: Model,
    i: int,
    dt: float,
    vend: int,
    vfree: int,
    vout: int,
    pin: int,
    pout: int,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    X: wp.array(dtype=wp.vec3),
    R: wp.array(dtype=wp.quat),
    late: wp.array(dtype=wp.vec2),
    shift: wp.array(dtype=wp.vec3),
    kick: int,
    now: int,
    was: int,
    start: int,
    after: int,
    frozen_late: wp.array(dtype=float),
    w: int,
    table: wp.array3d(dtype=wp.float64),
    frozen: wp.array3d(dtype=wp.float64),
):
    sums = late[pin]
    wait = wp.where(sums[1] > 0.0, sums[0] / wp.max(sums[1], 1.0e-20), 0.0)
    X[pout] = X[pin] + V[vend] * (dt - wait) + V[vfree] * wait + shift[pin]
    # After a hit in the step before, or a change of control, the new acceleration acts from the
    # true moment on and the old one up to it: zero, but for the derivative by that moment.
    if kick >= 0:
        more = (late[kick][0] / wp.max(late[kick][1], 1.0e-20) - frozen_late[kick]) / dt
        V[vout] = V[vend] + (V[now] - V[was] - V[vend] + V[start]) * more
    elif kick <= -2:
        k = (-2 - kick) / CHANGES
        what = (-2 - kick) % CHANGES
        column = wp.where(what == Change.HOLD_ENDS, int(Column.END), int(Column.START))
        moved = float(table[w, k, column] - frozen[w, k, column]) / dt
        # `after` is the velocity the program set; what it was before counts if it was kept.
        if what == Change.FORCE:
            V[vout] = V[vend] + (V[now] - V[was] - V[vend] + V[after]) * moved
        else:
            V[vout] = V[vend] + (V[after] - V[vend]) * moved
    else:
        V[vout] = V[vend]
    turn = O[vend] * (dt - wait) + O[vfree] * wait
    R[pout] = ahead_of(R[pin], turn)
    spin = turned(model.inertia[i], R[pin]) @ O[vend]
    if kick >= 0:
        extra = (late[kick][0] / wp.max(late[kick][1], 1.0e-20) - frozen_late[kick]) / dt
        gained = O[now] - O[was] - O[vend] + O[start]
        O[vout] = turned(model.inverse_inertia[i], R[pout]) @ spin + gained * extra
    else:
        O[vout] = turned(model.inverse_inertia[i], R[pout]) @ spin


@wp.kernel
def replay(
    model: Model,
    ops: Ops,
    feat: Features,
    dt: wp.float64,
    table: wp.array3d(dtype=wp.float64),
    frozen: wp.array3d(dtype=wp.float64),
    damping: wp.array2d(dtype=wp.vec2),
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    X: wp.array(dtype=wp.vec3),
    R: wp.array(dtype=wp.quat),
    J: wp.array(dtype=wp.vec3),
    inverse: wp.array(dtype=wp.mat33),
    late: wp.array(dtype=wp.vec2),
    shift: wp.array(dtype=wp.vec3),
    frozen_late: wp.array(dtype=float),
    normal: wp.array(dtype=wp.vec3),
    arm_a: wp.array(dtype=wp.vec3),
    arm_b: wp.array(dtype=wp.vec3),
    wanted: wp.array(dtype=float),
    delay: wp.array(dtype=float),
    share: wp.array(dtype=wp.vec3),
):
    """Executes the operations of one world per thread."""
    w = wp.tid()
    h = float(dt)
    for q in range(ops.first[w], ops.first[w + 1]):
        kind = ops.kind[q]
        a = ops.a[q]
        b = ops.b[q]
        c = ops.contact[q]
        va = ops.in_a[q]
        vb = ops.in_b[q]
        pa = ops.pose_a[q]
        pb = ops.pose_b[q]
        if kind == Operation.SOLVE:
            _solve(
                model, feat, w, c, a, b, va, vb, ops.out_a[q], ops.out_b[q], pa, pb,
                ops.impulse_in[q], ops.impulse_out[q], V, O, J, inverse, normal, arm_a, arm_b,
                wanted, share,
            )  # fmt: skip
        elif kind == Operation.MOVE:
            _move(
                model, a, h, va, vb, ops.out_a[q], pa, pb, V, O, X, R, late, shift, b, c,
                ops.impulse_in[q], ops.out_b[q], ops.impulse_out[q], frozen_late, w, table, frozen,
            )  # fmt: skip
        elif kind == Operation.FORCES:
            _forces(model, w, a, b, c, h, table, damping, va, ops.out_a[q], pa, V, O, R, inverse)
        elif kind == Operation.PREPARE:
            prepare(
                model, feat, w, c, a, b, va, vb, pa, pb, h, V, O, X, R, inverse, normal, arm_a,
                arm_b, wanted, delay, share,
            )  # fmt: skip
        elif kind == Operation.GROUND:
            _stand(model, w, a, b, c, h, table, va, ops.out_a[q], pa, V, O, R)
        elif kind == Operation.DELAY:
            push = J[ops.impulse_in[q]][0]
            weight = wp.vec2(push * delay[c], push)
            if a >= 0:
                wp.atomic_add(late, pa, weight)
            if b >= 0:
                wp.atomic_add(late, pb, weight)
        else:
            _act(
                model, w, b, a, ops.step[q], c, dt, table, frozen, va, ops.out_a[q], pa, V, O,
                X, shift,
            )  # fmt: skip
