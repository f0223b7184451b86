"""Warp kernels of the Newton engine: program execution, contacts, recording, sorting.

Worlds may be of different scenes: bodies and shapes are numbered through all worlds, pairs of
bodies from `first_pair` of a world on. All kernels are launched inside a captured graph, so
everything that changes between calls is read from device arrays: `clock` holds (step, steps per
frame, first frame of the chunk, frames in the chunk), `grid` the step length [s] in double
precision.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.newton.setup import FIXED_POINT
from esg.engines.program import Action, Column
from esg.engines.program_kernels import (
    buoyed,
    falls,
    grounded,
    guide,
    held_spin,
    held_velocity,
    struck,
    tipped,
    vector,
)
from esg.engines.traction import Feature


@wp.func
def _set_linear(
    body: int,
    v: wp.vec3,
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
    first: wp.array(dtype=int),
):
    """Sets a velocity; what is linked to others has none of its own (first -1), only asks."""
    w = wp.spatial_bottom(body_qd[body])
    body_qd[body] = wp.spatial_vector(v, w)
    if first[body] >= 0:
        for k in range(3):
            joint_qd[first[body] + k] = v[k]


@wp.func
def _set_angular(
    body: int,
    w: wp.vec3,
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
    first: wp.array(dtype=int),
):
    v = wp.spatial_top(body_qd[body])
    body_qd[body] = wp.spatial_vector(v, w)
    if first[body] >= 0:
        for k in range(3):
            joint_qd[first[body] + 3 + k] = w[k]


@wp.func
def _kept_up(
    table: wp.array3d(dtype=wp.float64),
    kind: int,
    world: int,
    k: int,
    t: wp.float64,
    dt: wp.float64,
    pose: wp.transform,
    moves: wp.spatial_vector,
    pull: float,
) -> wp.spatial_vector:
    """Linear and angular velocity that a primitive that lasts gives a body that has `moves`."""
    x = wp.transform_get_translation(pose)
    v = wp.spatial_top(moves)
    if kind == Action.HOLD:
        held = held_velocity(table, world, k, t, dt, v, pull)
        return wp.spatial_vector(held, held_spin(table, world, k, held))
    if kind == Action.GUIDE:
        rate = wp.vec3(0.0, 0.0, float(table[world, k, Column.GUIDE_TURN_RATE]))
        return wp.spatial_vector(guide(table, world, k, t, dt, x, pull), rate)
    if kind == Action.BUOY:
        turn = wp.transform_get_rotation(pose)
        return buoyed(table, world, k, float(dt), x, turn, v, wp.spatial_bottom(moves))
    return wp.spatial_vector(v, vector(table, world, k, Column.SPIN))


@wp.func
def _met(
    world: int,
    k: int,
    b: int,
    step: int,
    until: wp.array3d(dtype=int),
    touched: wp.array3d(dtype=int),
) -> bool:
    """Whether a body has touched in the last step what ends a primitive."""
    found = bool(False)  # noqa: UP018  # a variable to Warp
    for other in range(until.shape[2]):
        if until[world, k, other] != 0 and touched[world, b, other] == step:
            found = True
    return found


@wp.func
def _adjust(
    target: int,
    to: wp.vec3,
    brakes: wp.float64,
    linear_damping: wp.array(dtype=float),
    angular_damping: wp.array(dtype=float),
    braking: wp.array(dtype=float),
):
    """Changes the dampings and the brakes of a body; NaN leaves one as it is."""
    if not wp.isnan(to[0]):
        linear_damping[target] = to[0]
    if not wp.isnan(to[1]):
        angular_damping[target] = to[1]
    if not wp.isnan(brakes):
        braking[target] = float(brakes)


@wp.func
def _roughen(
    world: int,
    body: int,
    mu: float,
    first_shape: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    shape_mu: wp.array(dtype=float),
):
    """Changes the friction of a body's shapes."""
    for shape in range(first_shape[world], first_shape[world + 1]):
        if shape_body[shape] == body:
            shape_mu[shape] = mu


@wp.func
def _feel(
    world: int,
    step: int,
    pull: float,
    dynamic: wp.array2d(dtype=int),
    features: wp.array2d(dtype=float),
    before: wp.array(dtype=wp.vec3),
    driven: wp.array(dtype=int),
    tips: wp.array(dtype=int),
    body_qd: wp.array(dtype=wp.spatial_vector),
):
    """Which bodies nothing carries in this step, and which two-wheelers a blow unbalances."""
    for b in range(dynamic.shape[1]):
        target = dynamic[world, b]
        if target >= 0:
            u = wp.spatial_top(body_qd[target])
            if falls(before[target][2], u[2], pull):
                # It is left alone, as what is driven.
                driven[target] = step + 1
            if features[target, Feature.DROP] > 0.0 and struck(before[target], u):
                tips[target] = 1


@wp.func
def _stand(
    world: int,
    step: int,
    pull: float,
    dt: float,
    scale: float,
    dynamic: wp.array2d(dtype=int),
    features: wp.array2d(dtype=float),
    braking: wp.array(dtype=float),
    driven: wp.array(dtype=int),
    before: wp.array(dtype=wp.vec3),
    tips: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
    first: wp.array(dtype=int),
):
    """Lets brakes and tyres act on what is not driven, and notes how fast all of it goes then."""
    for b in range(dynamic.shape[1]):
        target = dynamic[world, b]
        if target >= 0:
            acts = braking[target] > 0.0 or features[target, Feature.GRIP] > 0.0
            if acts and driven[target] != step + 1:
                turn = wp.transform_get_rotation(body_q[target])
                loss = braking[target] * dt
                _slow(target, features, loss, -pull * scale, turn, tips, body_qd, joint_qd, first)
            before[target] = wp.spatial_top(body_qd[target])


@wp.func
def _slow(
    target: int,
    features: wp.array2d(dtype=float),
    loss: float,
    weight: float,
    turn: wp.quat,
    tips: wp.array(dtype=int),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
    first: wp.array(dtype=int),
):
    """What brakes and tyres do to a body in a step."""
    v = wp.spatial_top(body_qd[target])
    omega = wp.spatial_bottom(body_qd[target])
    kept = grounded(features, target, loss, weight, v, omega, turn)
    if tips[target] != 0:
        tips[target] = 0
        kept = tipped(features, target, wp.spatial_top(kept), wp.spatial_bottom(kept), turn)
    _set_linear(target, wp.spatial_top(kept), body_qd, joint_qd, first)
    _set_angular(target, wp.spatial_bottom(kept), body_qd, joint_qd, first)


@wp.kernel(enable_backward=False)
def run_programs(
    clock: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    primitives: wp.array(dtype=int),
    kind: wp.array2d(dtype=int),
    body: wp.array2d(dtype=int),
    until: wp.array3d(dtype=int),
    table: wp.array3d(dtype=wp.float64),
    dynamic: wp.array2d(dtype=int),
    first_shape: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    friction_scale: wp.array(dtype=float),
    touched: wp.array3d(dtype=int),
    done: wp.array2d(dtype=int),
    active: wp.array2d(dtype=int),
    body_mass: wp.array(dtype=float),
    linear_damping: wp.array(dtype=float),
    angular_damping: wp.array(dtype=float),
    shape_mu: wp.array(dtype=float),
    gravity: wp.array(dtype=wp.vec3),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
    first: wp.array(dtype=int),
    features: wp.array2d(dtype=float),
    braking: wp.array(dtype=float),
    driven: wp.array(dtype=int),
    before: wp.array(dtype=wp.vec3),
    tips: wp.array(dtype=int),
):
    """One thread per world executes its program before a step (`esg.engines.program`)."""
    world = wp.tid()
    step, dt = clock[0], grid[0]
    t = wp.float64(step) * dt
    now, pull = t + wp.float64(0.5) * dt, gravity[world][2] * float(dt)
    _feel(world, step, pull, dynamic, features, before, driven, tips, body_qd)
    for k in range(primitives[world]):
        if done[world, k] != 0 or kind[world, k] == Action.DRIVE:
            continue
        b = body[world, k]
        target = dynamic[world, b]
        if target < 0 and kind[world, k] != Action.ADJUST:
            continue
        start = table[world, k, Column.START]
        if kind[world, k] >= Action.HOLD:
            met = active[world, k] != 0 and _met(world, k, b, step, until, touched)
            if met or now > table[world, k, Column.END]:
                done[world, k] = 1
            if done[world, k] == 0 and start <= now:
                active[world, k] = 1
                kept = _kept_up(table, kind[world, k], world, k, t, dt, body_q[target],
                                body_qd[target], pull)  # fmt: skip
                _set_linear(target, wp.spatial_top(kept), body_qd, joint_qd, first)
                _set_angular(target, wp.spatial_bottom(kept), body_qd, joint_qd, first)
                if kind[world, k] < Action.SPIN:
                    driven[target] = step + 1
                    tips[target] = 0
        elif start <= now:
            done[world, k] = 1
            if kind[world, k] == Action.SET_VELOCITY:
                linear = vector(table, world, k, Column.LINEAR)
                _set_linear(target, linear, body_qd, joint_qd, first)
                omega = vector(table, world, k, Column.ANGULAR)
                if not wp.isnan(omega[0]):
                    _set_angular(target, omega, body_qd, joint_qd, first)
            elif kind[world, k] == Action.APPLY_IMPULSE:
                impulse = vector(table, world, k, Column.IMPULSE)
                v = wp.spatial_top(body_qd[target]) + impulse / body_mass[target]
                _set_linear(target, v, body_qd, joint_qd, first)
            else:
                to = vector(table, world, k, Column.LINEAR_DAMPING)
                if target >= 0:
                    _adjust(target, to, table[world, k, Column.BRAKING], linear_damping,
                            angular_damping, braking)  # fmt: skip
                if not wp.isnan(to[2]):
                    mu = to[2] * friction_scale[world]
                    _roughen(world, b, mu, first_shape, shape_body, shape_mu)
    _stand(world, step, pull, float(dt), friction_scale[world], dynamic, features, braking, driven,
           before, tips, body_q, body_qd, joint_qd, first)  # fmt: skip


@wp.kernel(enable_backward=False)
def touch_movers(
    count: wp.array(dtype=int),
    shape0: wp.array(dtype=int),
    shape1: wp.array(dtype=int),
    normal: wp.array(dtype=wp.vec3),
    margin0: wp.array(dtype=float),
    margin1: wp.array(dtype=float),
    model_shape_body: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    point0: wp.array(dtype=wp.vec3),
    point1: wp.array(dtype=wp.vec3),
):
    """One thread per contact that is solved ahead of touching moves it to where it will be felt.

    The solver's friction acts half-way between the two surfaces. Of a ball that comes down on the
    ground with 4 m/s that is up to 8 mm below it, and its spin after the bounce 8% too large. Both
    points are shifted along the normal, which changes neither their gap nor the normal's moment,
    so that half-way is the surface of what moves.
    """
    i = wp.tid()
    if i >= count[0]:
        return
    s0 = shape0[i]
    s1 = shape1[i]
    if s0 < 0 or s1 < 0:
        return
    body0 = model_shape_body[s0]
    body1 = model_shape_body[s1]
    if (body0 < 0) == (body1 < 0):
        return
    n = normal[i]
    if body0 >= 0:
        x = wp.transform_point(body_q[body0], point0[i])
        gap = wp.dot(n, point1[i] - x) - (margin0[i] + margin1[i])
        if gap > 0.0:
            shift = -0.5 * gap * n
            point1[i] = point1[i] + shift
            point0[i] = point0[i] + wp.quat_rotate_inv(
                wp.transform_get_rotation(body_q[body0]), shift
            )
    else:
        x = wp.transform_point(body_q[body1], point1[i])
        gap = wp.dot(n, x - point0[i]) - (margin0[i] + margin1[i])
        if gap > 0.0:
            shift = 0.5 * gap * n
            point0[i] = point0[i] + shift
            point1[i] = point1[i] + wp.quat_rotate_inv(
                wp.transform_get_rotation(body_q[body1]), shift
            )


@wp.kernel(enable_backward=False)
def accumulate_contacts(
    clock: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    count: wp.array(dtype=int),
    shape0: wp.array(dtype=int),
    shape1: wp.array(dtype=int),
    point0: wp.array(dtype=wp.vec3),
    point1: wp.array(dtype=wp.vec3),
    normal: wp.array(dtype=wp.vec3),
    margin0: wp.array(dtype=float),
    margin1: wp.array(dtype=float),
    force: wp.array(dtype=wp.spatial_vector),
    model_shape_body: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    first_pair: wp.array(dtype=int),
    pair: wp.array3d(dtype=int),
    touched: wp.array3d(dtype=int),
    impulse: wp.array2d(dtype=wp.int64),
    first: wp.array2d(dtype=int),
    depth: wp.array2d(dtype=float),
    moments: wp.array3d(dtype=wp.int64),
):
    """One thread per contact point adds the step's normal impulse to its pair of bodies."""
    i = wp.tid()
    if i >= count[0]:
        return
    s0 = shape0[i]
    s1 = shape1[i]
    if s0 < 0 or s1 < 0:
        return
    n = normal[i]
    # Newton reports the force on shape 0; the normal points from shape 0 to shape 1.
    magnitude = -wp.dot(wp.spatial_top(force[i]), n) * float(grid[0])
    if not (magnitude > 0.0) or not wp.isfinite(magnitude):
        return
    world = shape_world[s0]
    a = shape_body[s0]
    b = shape_body[s1]
    step = clock[0]
    if a >= 0 and b >= 0:
        touched[world, a, b] = step + 1
        touched[world, b, a] = step + 1
    p = pair[world, a + 1, b + 1]
    slot = step / clock[1] - clock[2]
    if p < 0 or slot < 0 or slot >= clock[3]:
        return
    p = p + first_pair[world]
    x0 = point0[i]
    x1 = point1[i]
    body0 = model_shape_body[s0]
    body1 = model_shape_body[s1]
    if body0 >= 0:
        x0 = wp.transform_point(body_q[body0], x0)
    if body1 >= 0:
        x1 = wp.transform_point(body_q[body1], x1)
    gap = wp.dot(n, x1 - x0) - (margin0[i] + margin1[i])
    x = 0.5 * (x0 + n * margin0[i] + x1 - n * margin1[i])
    # The log's normal points from the pair's second body to its first.
    direction = -n
    if (b >= 0 and b < a) or a < 0:
        direction = n
    weight = wp.float64(magnitude) * wp.float64(FIXED_POINT)
    wp.atomic_add(impulse, slot, p, wp.int64(weight))
    wp.atomic_min(first, slot, p, step)
    wp.atomic_max(depth, slot, p, -gap)
    for k in range(3):
        wp.atomic_add(moments, slot, p, k, wp.int64(weight * wp.float64(x[k])))
        wp.atomic_add(moments, slot, p, 3 + k, wp.int64(weight * wp.float64(direction[k])))


@wp.kernel(enable_backward=False)
def record_frames(
    clock: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    out_q: wp.array2d(dtype=wp.transform),
    out_qd: wp.array2d(dtype=wp.spatial_vector),
):
    """One thread per body stores the state after a step that ends a frame."""
    i = wp.tid()
    after = clock[0] + 1
    if after % clock[1] != 0:
        return
    slot = after / clock[1] - 1
    if slot >= 0 and slot < out_q.shape[0]:
        out_q[slot, i] = body_q[i]
        out_qd[slot, i] = body_qd[i]


@wp.kernel(enable_backward=False)
def advance(clock: wp.array(dtype=int)):
    """Counts the step."""
    clock[0] = clock[0] + 1


@wp.kernel(enable_backward=False)
def pack_pairs(
    frame: int,
    impulse: wp.array2d(dtype=wp.int64),
    first: wp.array2d(dtype=int),
    depth: wp.array2d(dtype=float),
    moments: wp.array3d(dtype=wp.int64),
    count: wp.array(dtype=int),
    ints: wp.array2d(dtype=int),
    depths: wp.array(dtype=float),
    sums: wp.array2d(dtype=wp.int64),
):
    """Appends the pairs that touched in a chunk to a list, in any order, and clears the chunk."""
    slot, p = wp.tid()
    weight = impulse[slot, p]
    if weight > wp.int64(0):
        row = wp.atomic_add(count, 0, 1)
        if row < depths.shape[0]:
            ints[row, 0] = frame + slot
            ints[row, 1] = p
            ints[row, 2] = first[slot, p]
            depths[row] = depth[slot, p]
            sums[row, 0] = weight
            for k in range(6):
                sums[row, 1 + k] = moments[slot, p, k]
    impulse[slot, p] = wp.int64(0)
    first[slot, p] = 2147483647
    depth[slot, p] = 0.0
    for k in range(6):
        moments[slot, p, k] = wp.int64(0)


@wp.kernel(enable_backward=False)
def begin_chunk(clock: wp.array(dtype=int), first: int, frames: int):
    """Tells the kernels of a step which frames the sums of pairs are for."""
    clock[2] = first
    clock[3] = frames


@wp.func
def _insert(first: int, stop: int, keys: wp.array(dtype=wp.int64), values: wp.array(dtype=int)):
    """Sorts pairs first .. stop - 1."""
    for i in range(first + 1, stop):
        key = keys[i]
        value = values[i]
        k = int(i)  # a variable to Warp, not another name
        while k > first and keys[k - 1] > key:
            keys[k] = keys[k - 1]
            values[k] = values[k - 1]
            k -= 1
        keys[k] = key
        values[k] = value


@wp.func
def _merge(
    far: int,
    first: int,
    middle: int,
    stop: int,
    keys: wp.array(dtype=wp.int64),
    values: wp.array(dtype=int),
):
    """Merges two sorted runs; only the left one has to leave its place, by `far`."""
    if keys[middle - 1] <= keys[middle]:
        return
    for i in range(first, middle):
        keys[far + i] = keys[i]
        values[far + i] = values[i]
    left = int(first)
    right = int(middle)
    k = int(first)
    while left < middle:
        if right < stop and keys[right] < keys[far + left]:
            keys[k] = keys[right]
            values[k] = values[right]
            right += 1
        else:
            keys[k] = keys[far + left]
            values[k] = values[far + left]
            left += 1
        k += 1


RUN = wp.constant(8)
"""Pairs that are sorted by insertion."""


@wp.kernel(enable_backward=False)
def sort_pairs(
    count: wp.array(dtype=int),
    limit: int,
    keys: wp.array(dtype=wp.int64),
    values: wp.array(dtype=int),
):
    """One thread sorts the first count[0] (at most `limit`) pairs by key, equal keys in order.

    Both arrays have room for 2 `limit`.
    """
    n = wp.min(count[0], limit)
    for k in range((n + RUN - 1) / RUN):
        _insert(k * RUN, wp.min((k + 1) * RUN, n), keys, values)
    width = int(RUN)
    while width < n:
        for k in range((n + width - 1) / (2 * width)):
            middle = (2 * k + 1) * width
            _merge(limit, middle - width, middle, wp.min(middle + width, n), keys, values)
        width *= 2
