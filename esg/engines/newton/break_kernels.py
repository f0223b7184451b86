"""Warp kernels of bodies that break (`esg.engines.newton.breaking`)."""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.newton.setup import FIXED_POINT

WHOLE = wp.constant(0)
JUST_BROKEN = wp.constant(1)
GONE = wp.constant(2)


@wp.func
def _brittle(
    shape: int,
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    number: wp.array2d(dtype=int),
) -> int:
    """Number of what breaks that a shape is of; -1 for others."""
    if shape < 0:
        return -1
    world = shape_world[shape]
    body = shape_body[shape]
    if world < 0 or body < 0:
        return -1
    return number[world, body]


@wp.kernel(enable_backward=False)
def drop_gone(
    count: wp.array(dtype=int),
    state: wp.array(dtype=int),
    number: wp.array2d(dtype=int),
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    shape0: wp.array(dtype=int),
    shape1: wp.array(dtype=int),
):
    """One thread per contact drops it if one of its bodies is broken."""
    i = wp.tid()
    if i >= count[0]:
        return
    a = _brittle(shape0[i], shape_world, shape_body, number)
    b = _brittle(shape1[i], shape_world, shape_body, number)
    gone = bool(False)  # noqa: UP018  # a variable to Warp
    if a >= 0:
        gone = state[a] != WHOLE
    if b >= 0:
        gone = gone or state[b] != WHOLE
    if gone:
        shape0[i] = -1
        shape1[i] = -1


@wp.func
def _impulse(
    i: int,
    grid: wp.array(dtype=wp.float64),
    normal: wp.array(dtype=wp.vec3),
    force: wp.array(dtype=wp.spatial_vector),
) -> float:
    """Normal impulse of a contact in the step [N s]."""
    magnitude = -wp.dot(wp.spatial_top(force[i]), normal[i]) * float(grid[0])
    if not (magnitude > 0.0) or not wp.isfinite(magnitude):
        return 0.0
    return magnitude


@wp.kernel(enable_backward=False)
def gather_blows(
    count: wp.array(dtype=int),
    shape0: wp.array(dtype=int),
    shape1: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    normal: wp.array(dtype=wp.vec3),
    force: wp.array(dtype=wp.spatial_vector),
    number: wp.array2d(dtype=int),
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    blow: wp.array(dtype=wp.int64),
):
    """One thread per contact adds its impulse to what breaks."""
    i = wp.tid()
    if i >= count[0] or shape0[i] < 0 or shape1[i] < 0:
        return
    magnitude = _impulse(i, grid, normal, force)
    weight = wp.int64(wp.float64(magnitude) * wp.float64(FIXED_POINT))
    a = _brittle(shape0[i], shape_world, shape_body, number)
    b = _brittle(shape1[i], shape_world, shape_body, number)
    if a >= 0:
        wp.atomic_add(blow, a, weight)
    if b >= 0:
        wp.atomic_add(blow, b, weight)


@wp.kernel(enable_backward=False)
def find_broken(
    clock: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    window: float,
    strength: wp.array(dtype=float),
    blow: wp.array(dtype=wp.int64),
    taken: wp.array2d(dtype=float),
    state: wp.array(dtype=int),
    share: wp.array(dtype=float),
):
    """One thread per thing that breaks tells whether it has, and what is too much of the blow."""
    n = wp.tid()
    now = float(wp.float64(blow[n]) / wp.float64(FIXED_POINT))
    blow[n] = wp.int64(0)
    share[n] = 0.0
    if state[n] != WHOLE:
        state[n] = GONE
        return
    steps = wp.clamp(int(wp.rint(window / float(grid[0]))), 1, taken.shape[1])
    taken[n, clock[0] % steps] = now
    total = float(0.0)  # noqa: UP018  # a variable to Warp
    for k in range(steps):
        total += taken[n, k]
    if total > strength[n]:
        state[n] = JUST_BROKEN
        share[n] = wp.min(1.0, (total - strength[n]) / now)


@wp.kernel(enable_backward=False)
def share_out(
    count: wp.array(dtype=int),
    shape0: wp.array(dtype=int),
    shape1: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    normal: wp.array(dtype=wp.vec3),
    force: wp.array(dtype=wp.spatial_vector),
    number: wp.array2d(dtype=int),
    shape_world: wp.array(dtype=int),
    shape_body: wp.array(dtype=int),
    model_shape_body: wp.array(dtype=int),
    share: wp.array(dtype=float),
    back: wp.array(dtype=float),
):
    """One thread per contact tells both bodies what share of the step is taken back."""
    i = wp.tid()
    if i >= count[0] or shape0[i] < 0 or shape1[i] < 0:
        return
    if _impulse(i, grid, normal, force) <= 0.0:
        return
    a = _brittle(shape0[i], shape_world, shape_body, number)
    b = _brittle(shape1[i], shape_world, shape_body, number)
    most = float(0.0)  # noqa: UP018  # a variable to Warp
    if a >= 0:
        most = share[a]
    if b >= 0:
        most = wp.max(most, share[b])
    body0 = model_shape_body[shape0[i]]
    body1 = model_shape_body[shape1[i]]
    if body0 >= 0:
        wp.atomic_max(back, body0, most)
    if body1 >= 0:
        wp.atomic_max(back, body1, most)


@wp.kernel(enable_backward=False)
def take_back(
    grid: wp.array(dtype=wp.float64),
    gravity: wp.array(dtype=wp.vec3),
    back: wp.array(dtype=float),
    before: wp.array(dtype=wp.spatial_vector),
    first_qd: wp.array(dtype=int),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
):
    """One thread per body takes back a share of what the step's contacts did to it."""
    i = wp.tid()
    f = back[i]
    back[i] = 0.0
    if f > 0.0 and first_qd[i] >= 0:
        v = wp.spatial_top(body_qd[i])
        w = wp.spatial_bottom(body_qd[i])
        pull = gravity[0] * float(grid[0])
        v = v - f * (v - wp.spatial_top(before[i]) - pull)
        w = w - f * (w - wp.spatial_bottom(before[i]))
        _move(i, v, w, first_qd, body_qd, joint_qd)


@wp.func
def _move(
    i: int,
    v: wp.vec3,
    w: wp.vec3,
    first_qd: wp.array(dtype=int),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_qd: wp.array(dtype=float),
):
    body_qd[i] = wp.spatial_vector(v, w)
    if first_qd[i] >= 0:
        for k in range(3):
            joint_qd[first_qd[i] + k] = v[k]
            joint_qd[first_qd[i] + 3 + k] = w[k]


@wp.func
def _place(
    i: int,
    pose: wp.transform,
    first_q: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    joint_q: wp.array(dtype=float),
):
    body_q[i] = pose
    p = wp.transform_get_translation(pose)
    q = wp.transform_get_rotation(pose)
    for k in range(3):
        joint_q[first_q[i] + k] = p[k]
    for k in range(4):
        joint_q[first_q[i] + 3 + k] = q[k]


@wp.kernel(enable_backward=False)
def swap_pieces(
    of: wp.array(dtype=int),
    piece: wp.array(dtype=int),
    local: wp.array(dtype=wp.vec3),
    turn: wp.array(dtype=wp.quat),
    parked: wp.array(dtype=wp.vec3),
    whole: wp.array(dtype=int),
    still: wp.array(dtype=wp.transform),
    state: wp.array(dtype=int),
    first_q: wp.array(dtype=int),
    first_qd: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_q: wp.array(dtype=float),
    joint_qd: wp.array(dtype=float),
):
    """One thread per fragment: parks it while its body is whole, and lets it go on as a part of
    what has just broken."""
    m = wp.tid()
    n = of[m]
    i = piece[m]
    if state[n] == WHOLE:
        _place(i, wp.transform(parked[m], wp.quat_identity()), first_q, body_q, joint_q)
        _move(i, wp.vec3(), wp.vec3(), first_qd, body_qd, joint_qd)
    elif state[n] == JUST_BROKEN:
        pose = still[n]
        v = wp.vec3()
        w = wp.vec3()
        if whole[n] >= 0:
            pose = body_q[whole[n]]
            v = wp.spatial_top(body_qd[whole[n]])
            w = wp.spatial_bottom(body_qd[whole[n]])
        q = wp.transform_get_rotation(pose)
        arm = wp.quat_rotate(q, local[m])
        at = wp.transform(wp.transform_get_translation(pose) + arm, wp.normalize(q * turn[m]))
        _place(i, at, first_q, body_q, joint_q)
        _move(i, v + wp.cross(w, arm), w, first_qd, body_qd, joint_qd)


@wp.kernel(enable_backward=False)
def park_wholes(
    whole: wp.array(dtype=int),
    parked: wp.array(dtype=wp.vec3),
    state: wp.array(dtype=int),
    first_q: wp.array(dtype=int),
    first_qd: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_q: wp.array(dtype=float),
    joint_qd: wp.array(dtype=float),
):
    """One thread per thing that breaks puts it away for good, once its fragments are there."""
    n = wp.tid()
    i = whole[n]
    if i >= 0 and state[n] != WHOLE:
        _place(i, wp.transform(parked[n], wp.quat_identity()), first_q, body_q, joint_q)
        _move(i, wp.vec3(), wp.vec3(), first_qd, body_qd, joint_qd)


@wp.kernel(enable_backward=False)
def change_bodies(
    clock: wp.array(dtype=int),
    grid: wp.array(dtype=wp.float64),
    time: wp.array2d(dtype=float),
    into: wp.array2d(dtype=int),
    placed: wp.array2d(dtype=int),
    place: wp.array2d(dtype=wp.transform),
    now: wp.array(dtype=int),
    member: wp.array2d(dtype=int),
    pose: wp.array2d(dtype=wp.transform),
    height: wp.array2d(dtype=float),
    first_q: wp.array(dtype=int),
    first_qd: wp.array(dtype=int),
    body_q: wp.array(dtype=wp.transform),
    body_qd: wp.array(dtype=wp.spatial_vector),
    joint_q: wp.array(dtype=float),
    joint_qd: wp.array(dtype=float),
):
    """One thread per body that changes its posture: lets the one that is due be there."""
    n = wp.tid()
    due = float((wp.float64(clock[0]) + wp.float64(0.5)) * grid[0])
    want = int(0)  # noqa: UP018, RUF046  # a variable to Warp
    last = int(0)  # noqa: UP018, RUF046  # a variable to Warp
    for k in range(time.shape[1]):
        if time[n, k] <= due:
            want = into[n, k]
            last = k
    if want != now[n]:
        i = member[n, now[n]]
        frame = body_q[i] * wp.transform_inverse(pose[n, now[n]])
        v = wp.spatial_top(body_qd[i])
        w = wp.spatial_bottom(body_qd[i])
        if placed[n, last] != 0:
            frame = place[n, last]
            v = wp.vec3()
            w = wp.vec3()
        at = frame * pose[n, want]
        _place(member[n, want], at, first_q, body_q, joint_q)
        _move(member[n, want], v, w, first_qd, body_qd, joint_qd)
        now[n] = want
    for k in range(member.shape[1]):
        if member[n, k] >= 0 and k != want:
            away = wp.transform(wp.vec3(0.0, 0.0, height[n, k]), wp.quat_identity())
            _place(member[n, k], away, first_q, body_q, joint_q)
            _move(member[n, k], wp.vec3(), wp.vec3(), first_qd, body_qd, joint_qd)
