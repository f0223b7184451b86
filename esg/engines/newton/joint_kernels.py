"""Warp kernels of jointed worlds: what programs ask of linked bodies, springs, axes, ropes.

Nothing here runs in a model whose scenes have no joints.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.program import Column

CLOSING_M = wp.constant(5e-3)
"""A rope that is too long is shortened by no more than this in a step."""

FAST_RAD = wp.constant(0.1)
"""Turn of a ball joint in a step from which on it is braked, by the share of what is beyond."""


@wp.struct
class End:
    """One end of a rope or spring; `turning` is what its body's turning accelerates it by."""

    at: wp.vec3
    v: wp.vec3
    turning: wp.vec3
    arm: wp.vec3


@wp.func
def _end(
    body: int,
    point: wp.vec3,
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    pull: wp.vec3,
):
    end = End()
    end.at = point
    if body >= 0:
        w = wp.spatial_bottom(body_qd[body])
        end.arm = wp.quat_rotate(wp.transform_get_rotation(body_q[body]), point)
        end.at = wp.transform_get_translation(body_q[body]) + end.arm
        spin = wp.cross(w, end.arm)
        end.v = wp.spatial_top(body_qd[body]) + spin + pull
        end.turning = wp.cross(w, spin)
    return end


@wp.func
def _lightness(
    body: int,
    arm: wp.vec3,
    n: wp.vec3,
    body_q: wp.array(dtype=wp.transform),
    inverse_mass: wp.array(dtype=float),
    inverse_inertia: wp.array(dtype=wp.mat33),
) -> float:
    """Velocity along n that a unit impulse along n at a point of a free body gives it [1/kg]."""
    if body < 0:
        return 0.0
    turn = wp.quat_rotate_inv(wp.transform_get_rotation(body_q[body]), wp.cross(arm, n))
    return inverse_mass[body] + wp.dot(turn, inverse_inertia[body] * turn)


@wp.func
def _kick(stiffness: float, damping: float, inertia: float, x: float, v: float, dt: float) -> float:
    """Impulse of what draws back and damps (`esg.engines.joint_rules.kick`) [N s or N m s]."""
    keep = wp.exp(-damping * dt / inertia)
    half = 0.5 * damping / inertia
    square = wp.min(stiffness / inertia, 1.0 / (dt * dt)) - half * half
    # 1 + keep - 2 sqrt(keep) cos(phase) without the loss of digits of a small phase.
    root = wp.sqrt(keep)
    if square >= 0.0:
        turn = wp.sin(0.5 * dt * wp.sqrt(square))
    else:
        turn = wp.sinh(0.5 * dt * wp.sqrt(-square))
    swing = 4.0 * root * turn * turn * wp.sign(square) + (1.0 - root) * (1.0 - root)
    return -inertia * (swing / dt * x + (1.0 - keep) * v)


@wp.kernel(enable_backward=False)
def ask_links(
    linked: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    kept: wp.array(dtype=wp.spatial_vector),
    mass: wp.array(dtype=float),
    inertia: wp.array(dtype=wp.mat33),
    linear_damping: wp.array(dtype=float),
    angular_damping: wp.array(dtype=float),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    body_f: wp.array(dtype=wp.spatial_vector),
):
    """One thread per link turns the velocity that a program asks of it into a force.

    The force gives a free body that velocity within the step. What hangs on others gets what its
    joints leave of it, as in engines that know joints as constraints.
    """
    body = linked[wp.tid()]
    dt = float(grid[0])
    asked = body_qd[body]
    old = kept[body]
    v = wp.spatial_top(asked) * wp.max(0.0, 1.0 - linear_damping[body] * dt)
    w = wp.spatial_bottom(asked) * wp.max(0.0, 1.0 - angular_damping[body] * dt)
    turn = wp.transform_get_rotation(body_q[body])
    change = wp.quat_rotate_inv(turn, w - wp.spatial_bottom(old))
    torque = wp.quat_rotate(turn, inertia[body] * change)
    push = mass[body] * (v - wp.spatial_top(old))
    body_f[body] = body_f[body] + wp.spatial_vector(push / dt, torque / dt)
    body_qd[body] = old


@wp.kernel(enable_backward=False)
def damp_free(
    free: wp.array(dtype=int),
    source: wp.array(dtype=float),
    target: wp.array(dtype=float),
):
    """Hands the damping of what is in no tree to the solver, which would damp roots of trees."""
    body = free[wp.tid()]
    target[body] = source[body]


@wp.kernel(enable_backward=False)
def pull_springs(
    first: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    body_a: wp.array(dtype=int),
    body_b: wp.array(dtype=int),
    point_a: wp.array(dtype=wp.vec3),
    point_b: wp.array(dtype=wp.vec3),
    rest: wp.array(dtype=float),
    stiffness: wp.array(dtype=float),
    damping: wp.array(dtype=float),
    inverse_mass: wp.array(dtype=float),
    inverse_inertia: wp.array(dtype=wp.mat33),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    body_f: wp.array(dtype=wp.spatial_vector),
):
    """One thread per world lets its springs pull."""
    world = wp.tid()
    dt = float(grid[0])
    none = wp.vec3(0.0, 0.0, 0.0)
    for i in range(first[world], first[world + 1]):
        a = body_a[i]
        b = body_b[i]
        one = _end(a, point_a[i], body_q, body_qd, none)
        two = _end(b, point_b[i], body_q, body_qd, none)
        off = two.at - one.at
        length = wp.length(off)
        if length > 1.0e-6:
            n = off / length
            rate = wp.dot(n, two.v - one.v)
            light = _lightness(a, one.arm, n, body_q, inverse_mass, inverse_inertia)
            light += _lightness(b, two.arm, n, body_q, inverse_mass, inverse_inertia)
            x = length - rest[i]
            force = -_kick(stiffness[i], damping[i], 1.0 / light, x, rate, dt) / dt
            if a >= 0:
                body_f[a] = body_f[a] + wp.spatial_vector(force * n, wp.cross(one.arm, force * n))
            if b >= 0:
                body_f[b] = body_f[b] - wp.spatial_vector(force * n, wp.cross(two.arm, force * n))


@wp.kernel(enable_backward=False)
def run_drives(
    clock: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    primitives: wp.array(dtype=int),
    axis: wp.array2d(dtype=int),
    table: wp.array3d(dtype=wp.float64),
    done: wp.array2d(dtype=int),
    dof: wp.array(dtype=int),
    sign: wp.array(dtype=float),
    friction: wp.array(dtype=float),
    gain: float,
    speed: wp.array(dtype=float),
    place: wp.array(dtype=float),
    effort: wp.array(dtype=float),
    damping: wp.array(dtype=float),
):
    """One thread per world gives joints the motors that its program has for them by now."""
    world = wp.tid()
    now = (wp.float64(clock[0]) + wp.float64(0.5)) * grid[0]
    for k in range(primitives[world]):
        i = axis[world, k]
        if i < 0 or done[world, k] != 0 or table[world, k, Column.START] > now:
            continue
        done[world, k] = 1
        pace = float(table[world, k, Column.MOTOR_SPEED])
        goal = float(table[world, k, Column.MOTOR_POSITION])
        most = friction[i]
        if not (wp.isnan(pace) and wp.isnan(goal)):
            most = float(table[world, k, Column.MOTOR_LIMIT])
        if wp.isnan(pace):
            pace = 0.0
        speed[i] = sign[i] * pace
        place[i] = sign[i] * goal
        effort[dof[i]] = most
        damping[dof[i]] = wp.where(most > 0.0, gain, 0.0)


@wp.kernel(enable_backward=False)
def drive_axes(
    grid: wp.array(dtype=wp.float64),
    coordinate: wp.array(dtype=int),
    dof: wp.array(dtype=int),
    stiffness: wp.array(dtype=float),
    damping: wp.array(dtype=float),
    inertia: wp.array(dtype=float),
    speed: wp.array(dtype=float),
    place: wp.array(dtype=float),
    rate: float,
    joint_q: wp.array(dtype=float),
    joint_qd: wp.array(dtype=float),
    joint_f: wp.array(dtype=float),
    target: wp.array(dtype=float),
):
    """One thread per hinge or slider: what draws it back, what damps it, where its motor goes.

    As `esg.engines.joint_rules` has it (`drive_of`).
    """
    i = wp.tid()
    dt = float(grid[0])
    q = joint_q[coordinate[i]]
    qd = joint_qd[dof[i]]
    joint_f[dof[i]] = _kick(stiffness[i], damping[i], inertia[i], q, qd, dt) / dt
    goal = speed[i]
    if not wp.isnan(place[i]):
        goal = wp.min(rate, 1.0 / dt) * (place[i] - q)
        if speed[i] != 0.0:
            goal = wp.clamp(goal, -wp.abs(speed[i]), wp.abs(speed[i]))
    target[dof[i]] = goal


@wp.kernel(enable_backward=False)
def brake_balls(
    first: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    body_a: wp.array(dtype=int),
    body_b: wp.array(dtype=int),
    group: wp.array(dtype=int),
    broken: wp.array(dtype=int),
    damping: wp.array(dtype=float),
    friction: wp.array(dtype=float),
    inertia: wp.array(dtype=wp.mat33),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    body_f: wp.array(dtype=wp.spatial_vector),
):
    """One thread per world brakes its ball joints: by no more than stops the child in a step."""
    world = wp.tid()
    dt = float(grid[0])
    for i in range(first[world], first[world + 1]):
        gone = int(0)  # noqa: UP018, RUF046  # a variable to Warp, not a constant
        if group[i] >= 0:
            gone = broken[group[i]]
        if gone != 0:
            continue
        a = body_a[i]
        b = body_b[i]
        w = wp.spatial_bottom(body_qd[b])
        if a >= 0:
            w -= wp.spatial_bottom(body_qd[a])
        speed = wp.length(w)
        if speed > 1.0e-9:
            n = w / speed
            local = wp.quat_rotate_inv(wp.transform_get_rotation(body_q[b]), n)
            most = wp.dot(local, inertia[b] * local) * speed / dt
            fast = wp.max(speed * dt - FAST_RAD, 0.0)
            torque = wp.min(damping[i] * speed + friction[i] + fast * most, most) * n
            body_f[b] = body_f[b] - wp.spatial_vector(wp.vec3(0.0, 0.0, 0.0), torque)
            if a >= 0:
                body_f[a] = body_f[a] + wp.spatial_vector(wp.vec3(0.0, 0.0, 0.0), torque)


@wp.kernel(enable_backward=False)
def count_solid(count: wp.array(dtype=int), solid: wp.array(dtype=int)):
    """Notes how many contacts are of shapes, before ropes are added to them."""
    solid[0] = count[0]


@wp.kernel(enable_backward=False)
def part_joined(
    solid: wp.array(dtype=int),
    first_group: wp.array(dtype=int),
    apart: wp.array2d(dtype=int),
    broken: wp.array(dtype=int),
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    contact_shape0: wp.array(dtype=int),
    contact_shape1: wp.array(dtype=int),
):
    """One thread per contact drops it if a joint that has not broken keeps its bodies apart."""
    i = wp.tid()
    if i >= solid[0]:
        return
    s0 = contact_shape0[i]
    s1 = contact_shape1[i]
    if s0 < 0 or s1 < 0:
        return
    world = shape_world[s0]
    a = shape_body[s0]
    b = shape_body[s1]
    for g in range(first_group[world], first_group[world + 1]):
        same = apart[g, 0] == a and apart[g, 1] == b
        if broken[g] == 0 and (same or (apart[g, 0] == b and apart[g, 1] == a)):
            contact_shape0[i] = -1
            contact_shape1[i] = -1


@wp.func
def _left_of_rope(one: End, two: End, n: wp.vec3, length: float, longest: float, dt: float):
    """What a rope has left at the end of a step if nothing pulls [m]."""
    v = two.v - one.v
    across = v - wp.dot(v, n) * n
    leaving = 0.5 * dt * dt * wp.dot(n, two.turning - one.turning)
    if length > 1.0e-6:
        leaving += 0.5 * dt * dt * wp.dot(across, across) / length
    return wp.max(longest - length, -CLOSING_M) - leaving


@wp.kernel(enable_backward=False)
def hold_ties(
    solid: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    gravity: wp.array(dtype=wp.vec3),
    share: float,
    world: wp.array(dtype=int),
    group: wp.array(dtype=int),
    body_a: wp.array(dtype=int),
    body_b: wp.array(dtype=int),
    mark_a: wp.array(dtype=int),
    mark_b: wp.array(dtype=int),
    point_a: wp.array(dtype=wp.vec3),
    point_b: wp.array(dtype=wp.vec3),
    direction: wp.array(dtype=wp.vec3),
    longest: wp.array(dtype=float),
    broken: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    count: wp.array(dtype=int),
    contact_shape0: wp.array(dtype=int),
    contact_shape1: wp.array(dtype=int),
    contact_point0: wp.array(dtype=wp.vec3),
    contact_point1: wp.array(dtype=wp.vec3),
    contact_normal: wp.array(dtype=wp.vec3),
    contact_margin0: wp.array(dtype=float),
    contact_margin1: wp.array(dtype=float),
):
    """One thread per tie tells the solver of it as of a contact without friction.

    The normal of a rope leads from the child back to the parent, and its gap is what the rope has
    left at the end of the step if nothing pulls: points that move across it, or on bodies that
    turn, leave it on a curve. So a taut rope ends every step as long as it is (SHAKE: Ryckaert,
    Ciccotti and Berendsen, J. Comput. Phys. 23, 1977), and a pendulum keeps its energy. A tie with
    a direction is one half of a pair that keeps a point of the child where one of the parent is;
    both act on the child's, so that what slides along the parent is held where it is. The solver
    makes up for a `share` of what is missing, so that so much more is told.
    """
    i = wp.tid()
    slot = solid[0] + i
    if i == 0:
        count[0] = solid[0] + world.shape[0]
    if slot >= contact_shape0.shape[0]:
        return
    a = body_a[i]
    b = body_b[i]
    dt = float(grid[0])
    pull = gravity[world[i]] * dt
    one = _end(a, point_a[i], body_q, body_qd, pull)
    two = _end(b, point_b[i], body_q, body_qd, pull)
    off = two.at - one.at
    length = wp.length(off)
    normal = wp.vec3(0.0, 0.0, 1.0)
    here = point_a[i]
    if wp.length_sq(direction[i]) > 0.0:
        normal = direction[i]
        if b >= 0:
            normal = wp.quat_rotate(wp.transform_get_rotation(body_q[b]), normal)
        here = two.at
        if a >= 0:
            here = wp.transform_point(wp.transform_inverse(body_q[a]), two.at)
        left = wp.clamp(wp.dot(normal, off), -CLOSING_M, CLOSING_M)
        left += 0.5 * dt * dt * wp.dot(normal, two.turning - one.turning)
        length = 0.0
    else:
        if length > 1.0e-6:
            normal = -off / length
        left = _left_of_rope(one, two, -normal, length, longest[i], dt)
    if left < 0.0:
        left = left / share
    contact_shape0[slot] = mark_a[i]
    contact_shape1[slot] = mark_b[i]
    if broken[group[i]] != 0:
        contact_shape0[slot] = -1
        contact_shape1[slot] = -1
    contact_point0[slot] = here
    contact_point1[slot] = point_b[i]
    contact_normal[slot] = normal
    contact_margin0[slot] = -length - left
    contact_margin1[slot] = 0.0


@wp.kernel(enable_backward=False)
def break_joints(
    clock: wp.array(dtype=int),
    solid: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    window: float,
    first_tie: wp.array(dtype=int),
    strength: wp.array(dtype=float),
    force: wp.array(dtype=wp.spatial_vector),
    taken: wp.array2d(dtype=wp.vec3),
    broken: wp.array(dtype=int),
):
    """One thread per joint of ties lets it go once it has taken too much within a window [s]."""
    g = wp.tid()
    if not wp.isfinite(strength[g]):
        return
    dt = float(grid[0])
    steps = wp.clamp(int(wp.rint(window / dt)), 1, taken.shape[1])
    now = wp.vec3(0.0, 0.0, 0.0)
    for i in range(first_tie[g], first_tie[g + 1]):
        slot = solid[0] + i
        if slot < force.shape[0]:
            now += wp.spatial_top(force[slot]) * dt
    taken[g, clock[0] % steps] = now
    total = wp.vec3(0.0, 0.0, 0.0)
    for k in range(steps):
        total += taken[g, k]
    if wp.length(total) > strength[g]:
        broken[g] = 1
