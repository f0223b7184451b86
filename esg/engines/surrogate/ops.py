"""From the trace of a rollout to a list of arithmetic operations with a place for every result.

Reverse-mode differentiation needs every intermediate value. Here each change of a velocity or pose
gets a new place ("version") in a flat array, and all decisions (which contacts press, how many
sweeps, what the program does) are read from the trace, so that the replay is plain arithmetic.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
from enum import IntEnum, IntFlag

import warp as wp

from esg.engines.program import Action, Column
from esg.engines.surrogate.features import Features, describe
from esg.engines.surrogate.types import Contacts, Fired, Model, Trace

wp.set_module_options({"enable_backward": False})


class Operation(IntEnum):
    """What an operation of the replay computes."""

    ACT = 0
    """What the program does to a body."""
    FORCES = 1
    """Gravity, damping and inertia in world axes of a body."""
    PREPARE = 2
    """What a contact asks for."""
    SOLVE = 3
    """A contact's impulse in one sweep."""
    DELAY = 4
    """Adds when a contact pressed to the mean moment of its bodies."""
    MOVE = 5
    """A body by its new velocity."""
    GROUND = 6
    """What brakes and tyres take of a body's velocities."""


class Act(IntFlag):
    """Which step of a primitive an ACT is."""

    FIRST = 1
    LAST = 2
    """Of a hold that ends by its time."""


class Change(IntEnum):
    """Why a body's acceleration changes; CHANGES k + change stands for primitive k."""

    FORCE = 0
    """New damping or an impulse."""
    HOLD_ENDS = 1
    VELOCITY = 2


CHANGES = wp.constant(3)


class Cursor(IntEnum):
    """What `Versions.next` counts: the next free place of each kind."""

    OPERATION = 0
    CONTACT = 1
    VELOCITY = 2
    POSE = 3
    IMPULSE = 4


@wp.struct
class Ops:
    """Operations of all worlds, flat; world w owns first[w] .. first[w + 1] - 1."""

    first: wp.array(dtype=int)
    kind: wp.array(dtype=int)
    step: wp.array(dtype=int)
    a: wp.array(dtype=int)
    b: wp.array(dtype=int)
    """Bodies; for ACT and GROUND `b` is the primitive. A body that impulses do not move is -1."""
    in_a: wp.array(dtype=int)
    in_b: wp.array(dtype=int)
    out_a: wp.array(dtype=int)
    out_b: wp.array(dtype=int)
    """Versions of velocities."""
    pose_a: wp.array(dtype=int)
    pose_b: wp.array(dtype=int)
    """Versions of poses; MOVE writes `pose_b`. After a hit in the step before, its `b` is the pose
    of that step, and `contact`, `impulse_in`, `out_b` are the velocities at the start of that step,
    of the one before it, and of this one. After a change of control `b` is -2 - its number
    (`Change`) and `impulse_out` the velocity after it."""
    contact: wp.array(dtype=int)
    """Of a contact; for ACT a sum of `Act`; for GROUND as in the trace; for FORCES the primitive
    that set the angular damping."""
    impulse_in: wp.array(dtype=int)
    impulse_out: wp.array(dtype=int)


@wp.struct
class Versions:
    """First version of each world and the current ones while linking."""

    next: wp.array2d(dtype=int)
    """Next free places by `Cursor`, [W, 5]."""
    velocity: wp.array(dtype=int)
    pose: wp.array(dtype=int)
    impulse: wp.array(dtype=int)
    now_v: wp.array2d(dtype=int)
    now_x: wp.array2d(dtype=int)
    free_v: wp.array2d(dtype=int)
    """Of the velocity before the contacts of the step, [W, B]."""
    set_v: wp.array2d(dtype=int)
    """Of the velocity after the program's actions of the step, [W, B]."""
    last_i: wp.array2d(dtype=int)
    """Latest impulse version of a contact of the step, [W, C]."""
    number: wp.array2d(dtype=int)
    """Flat index of a contact of the step, [W, C]."""
    acted: wp.array2d(dtype=int)
    kick: wp.array2d(dtype=int)
    """Pose version of a body that was hit within the last step, else -1, [W, B]."""
    hit: wp.array2d(dtype=int)
    """Number of the step after a body's last hit, [W, B]."""
    velocity_at: wp.array3d(dtype=int)
    late: wp.array(dtype=float)
    """By pose version, the mean delay of the impulses of the step from there."""
    pose_at: wp.array3d(dtype=int)
    """Versions at the start of every step, [W, steps + 1, B]."""


@wp.func
def _acts(model: Model, trace: Trace, w: int, step: int, i: int, holds: int) -> bool:
    """Whether the program sets a body's velocity in a step; `holds` 1 counts holds too."""
    for k in range(model.n_primitives):
        kind = model.action[k]
        sets = kind == Action.SET_VELOCITY or kind == Action.APPLY_IMPULSE
        lasts = kind == Action.HOLD or kind == Action.GUIDE
        sets = sets or (holds == 1 and lasts)
        if model.target[k] == i and sets and trace.fired[w, step, k] != 0:
            return True
    return False


@wp.func
def _unset(model: Model, trace: Trace, w: int, step: int, i: int) -> bool:
    """Whether the program set no velocity in this step and the one before it."""
    if step == 0:
        return False
    return not _acts(model, trace, w, step, i, 0) and not _acts(model, trace, w, step - 1, i, 0)


@wp.func
def _steady(model: Model, trace: Trace, ver: Versions, w: int, step: int, i: int) -> bool:
    """Whether a body's velocity did not jump from the last step to this one by program."""
    if step == 0:
        return False
    if trace.awake[w, step - 1, i] == 0 or ver.hit[w, i] == step:
        return False
    return _unset(model, trace, w, step, i)


@wp.func
def _speeding(
    model: Model, trace: Trace, ver: Versions, w: int, step: int, a: int, b: int
) -> wp.vec4i:
    zero = ver.velocity[w]
    out = wp.vec4i(zero, zero, zero, zero)
    if _steady(model, trace, ver, w, step, a):
        out[0] = ver.velocity_at[w, step, a]
        out[1] = ver.velocity_at[w, step - 1, a]
    if b < 0:
        return out
    if _steady(model, trace, ver, w, step, b):
        out[2] = ver.velocity_at[w, step, b]
        out[3] = ver.velocity_at[w, step - 1, b]
    return out


@wp.func
def _control_change(model: Model, trace: Trace, w: int, step: int, i: int) -> int:
    """Number (`Change`) of what changes a body's acceleration from this step on, or -1."""
    out = int(-1)  # noqa: RUF046, UP018  # a variable to Warp
    if step == 0:
        return out
    for k in range(model.n_primitives):
        if model.target[k] == i:
            kind = model.action[k]
            fires = trace.fired[w, step, k] != 0
            lasts = kind == Action.HOLD or kind == Action.GUIDE
            if lasts and fires:
                return -1
            if lasts and trace.fired[w, step - 1, k] == Fired.LAST:
                out = CHANGES * k + Change.HOLD_ENDS
            if kind == Action.SET_VELOCITY and fires:
                out = CHANGES * k + Change.VELOCITY
            other = kind == Action.APPLY_IMPULSE or kind == Action.ADJUST
            if other and fires and out < 0:
                out = CHANGES * k + Change.FORCE
    return out


@wp.func
def _kicks(model: Model, con: Contacts, trace: Trace, ver: Versions, w: int, step: int, i: int):
    """Whether a body is hit within the step; its mean delay goes to `late`."""
    weight = float(0.0)  # noqa: UP018
    total = float(0.0)  # noqa: UP018
    for k in range(con.count[w, step]):
        slot = con.base * step + k
        if con.a[w, slot] == i or con.b[w, slot] == i:
            push = con.impulse[w, slot][0]
            weight += push * con.delay[w, slot]
            total += push
    if weight > 0.0 and trace.awake[w, step, i] != 0:
        ver.late[ver.now_x[w, i]] = weight / total
        return True
    return False


@wp.func
def _take(ver: Versions, w: int, which: int) -> int:
    """The next free place of a kind."""
    place = ver.next[w, which]
    ver.next[w, which] = place + 1
    return place


@wp.func
def _op(ops: Ops, ver: Versions, w: int, kind: int, step: int, i: int) -> int:
    """A new operation on a body."""
    q = _take(ver, w, Cursor.OPERATION)
    ops.kind[q] = kind
    ops.step[q] = step
    ops.a[q] = i
    ops.pose_a[q] = ver.now_x[w, i]
    return q


@wp.func
def _velocity(ver: Versions, w: int, i: int) -> int:
    """A new version of a body's velocity."""
    place = _take(ver, w, Cursor.VELOCITY)
    ver.now_v[w, i] = place
    return place


@wp.func
def _begin(model: Model, ver: Versions, ops: Ops, feat: Features, w: int):
    """The versions that a world starts with, and where its new ones go."""
    zero_v = ver.velocity[w]
    ver.next[w, Cursor.OPERATION] = ops.first[w]
    ver.next[w, Cursor.CONTACT] = feat.first[w]
    ver.next[w, Cursor.VELOCITY] = zero_v + 1 + model.n_bodies
    # The pose after those of the bodies is the ground's.
    ver.next[w, Cursor.POSE] = ver.pose[w] + model.n_bodies + 1
    ver.next[w, Cursor.IMPULSE] = ver.impulse[w] + 1
    for i in range(model.n_bodies):
        ver.now_v[w, i] = zero_v + 1 + i
        ver.now_x[w, i] = ver.pose[w] + i
        ver.kick[w, i] = -1
        ver.velocity_at[w, 0, i] = ver.now_v[w, i]
        ver.pose_at[w, 0, i] = ver.now_x[w, i]


@wp.func
def _link_program(model: Model, trace: Trace, ops: Ops, ver: Versions, w: int, step: int):
    """What the program does before the step."""
    for k in range(model.n_primitives):
        how = trace.fired[w, step, k]
        if how == Fired.NOTHING:
            continue
        i = model.target[k]
        q = _op(ops, ver, w, Operation.ACT, step, i)
        ops.b[q] = k
        ops.in_a[q] = ver.now_v[w, i]
        ops.out_a[q] = _velocity(ver, w, i)
        first = wp.where(ver.acted[w, k] == 0, int(Act.FIRST), 0)
        ops.contact[q] = wp.where(how == Fired.LAST, int(Act.LAST), 0) + first
        ver.acted[w, k] = 1


@wp.func
def _link_ground(model: Model, ops: Ops, ver: Versions, w: int, step: int, i: int, how: int):
    """Tyres of a body, and its brakes as the last primitive that set them has it, or none (-1)."""
    q = _op(ops, ver, w, Operation.GROUND, step, i)
    ops.b[q] = -1
    ops.contact[q] = how
    for k in range(model.n_primitives):
        adjusts = model.action[k] == Action.ADJUST and ver.acted[w, k] != 0
        adjusts = adjusts and model.target[k] == i
        if adjusts and not wp.isnan(model.table[w, k, Column.BRAKING]):
            ops.b[q] = k
    ops.in_a[q] = ver.now_v[w, i]
    ops.out_a[q] = _velocity(ver, w, i)


@wp.func
def _link_forces(model: Model, trace: Trace, ops: Ops, ver: Versions, w: int, step: int):
    """Brakes, tyres, gravity and damping of what is awake."""
    for i in range(model.n_bodies):
        ver.set_v[w, i] = ver.now_v[w, i]
        if model.dynamic[i] == 0 or trace.awake[w, step, i] == 0:
            continue
        if trace.grounded[w, step, i] != 0:
            _link_ground(model, ops, ver, w, step, i, trace.grounded[w, step, i])
        damper = int(-1)  # noqa: RUF046, UP018  # a variable to Warp
        spin_damper = int(-1)  # noqa: RUF046, UP018  # a variable to Warp
        for k in range(model.n_primitives):
            adjusts = model.action[k] == Action.ADJUST and ver.acted[w, k] != 0
            if adjusts and model.target[k] == i:
                if not wp.isnan(model.table[w, k, Column.LINEAR_DAMPING]):
                    damper = k
                if not wp.isnan(model.table[w, k, Column.ANGULAR_DAMPING]):
                    spin_damper = k
        q = _op(ops, ver, w, Operation.FORCES, step, i)
        ops.b[q] = damper
        ops.contact[q] = spin_damper
        ops.in_a[q] = ver.now_v[w, i]
        ops.out_a[q] = _velocity(ver, w, i)
        ver.free_v[w, i] = ver.now_v[w, i]


@wp.func
def _link_contacts(
    model: Model,
    con: Contacts,
    trace: Trace,
    ops: Ops,
    feat: Features,
    ver: Versions,
    w: int,
    step: int,
):
    """The contacts that press, all their sweeps, and the moments they press at."""
    n_contacts = con.count[w, step]
    for k in range(n_contacts):
        slot = con.base * step + k
        if con.used[w, slot] != 0:
            c = _take(ver, w, Cursor.CONTACT)
            describe(model, con, feat, w, slot, c, step)
            feat.speeding[c] = _speeding(model, trace, ver, w, step, con.a[w, slot], con.b[w, slot])
            ver.number[w, k] = c
            ver.last_i[w, k] = ver.impulse[w]
            _contact_op(model, con, trace, ops, ver, w, step, k, Operation.PREPARE)
    for _sweep in range(trace.sweeps[w, step]):
        for k in range(n_contacts):
            if con.used[w, con.base * step + k] != 0:
                q = _contact_op(model, con, trace, ops, ver, w, step, k, Operation.SOLVE)
                ops.impulse_in[q] = ver.last_i[w, k]
                ver.last_i[w, k] = _take(ver, w, Cursor.IMPULSE)
                ops.impulse_out[q] = ver.last_i[w, k]
                if ops.a[q] >= 0:
                    ops.out_a[q] = _velocity(ver, w, ops.a[q])
                if ops.b[q] >= 0:
                    ops.out_b[q] = _velocity(ver, w, ops.b[q])
    for k in range(n_contacts):
        if con.used[w, con.base * step + k] != 0:
            q = _contact_op(model, con, trace, ops, ver, w, step, k, Operation.DELAY)
            ops.impulse_in[q] = ver.last_i[w, k]


@wp.func
def _contact_op(
    model: Model,
    con: Contacts,
    trace: Trace,
    ops: Ops,
    ver: Versions,
    w: int,
    step: int,
    k: int,
    kind: int,
) -> int:
    """A new operation on contact k of the step."""
    slot = con.base * step + k
    a = con.a[w, slot]
    b = con.b[w, slot]
    q = _op(ops, ver, w, kind, step, a)
    ops.contact[q] = ver.number[w, k]
    ops.a[q] = -1
    ops.b[q] = -1
    ops.in_a[q] = ver.velocity[w]
    ops.in_b[q] = ver.velocity[w]
    ops.pose_b[q] = ver.pose[w] + model.n_bodies
    if model.dynamic[a] != 0 and trace.awake[w, step, a] != 0:
        ops.a[q] = a
        ops.in_a[q] = ver.now_v[w, a]
    if b >= 0:
        ops.pose_b[q] = ver.now_x[w, b]
        if model.dynamic[b] != 0 and trace.awake[w, step, b] != 0:
            ops.b[q] = b
            ops.in_b[q] = ver.now_v[w, b]
    return q


@wp.func
def _link_move(
    model: Model, con: Contacts, trace: Trace, ops: Ops, ver: Versions, w: int, step: int, i: int
):
    """The motion of a body, with what gives it the derivative of true moments."""
    q = _op(ops, ver, w, Operation.MOVE, step, i)
    ops.in_a[q] = ver.now_v[w, i]
    ops.in_b[q] = ver.free_v[w, i]
    hit = _kicks(model, con, trace, ver, w, step, i)
    ops.b[q] = -1
    if ver.kick[w, i] >= 0 and not hit and not _acts(model, trace, w, step, i, 1):
        ops.b[q] = ver.kick[w, i]
        ops.contact[q] = ver.velocity_at[w, step - 1, i]
        ops.impulse_in[q] = ver.velocity_at[w, wp.max(step - 2, 0), i]
        ops.out_b[q] = ver.velocity_at[w, step, i]
    change = _control_change(model, trace, w, step, i)
    if ops.b[q] == -1 and change >= 0 and not hit:
        ops.b[q] = -2 - change
        ops.contact[q] = ver.velocity_at[w, step, i]
        ops.impulse_in[q] = ver.velocity_at[w, step - 1, i]
        ops.impulse_out[q] = ver.set_v[w, i]
    ver.kick[w, i] = -1
    if hit and _unset(model, trace, w, step, i) and ver.hit[w, i] != step:
        ver.kick[w, i] = ver.now_x[w, i]
    if hit:
        ver.hit[w, i] = step + 1
    ops.out_a[q] = _velocity(ver, w, i)
    ver.now_x[w, i] = _take(ver, w, Cursor.POSE)
    ops.pose_b[q] = ver.now_x[w, i]


@wp.kernel(enable_backward=False)
def link(
    model: Model,
    con: Contacts,
    trace: Trace,
    steps: wp.array(dtype=int),
    ops: Ops,
    feat: Features,
    ver: Versions,
):
    """Writes the operations of one world per thread, up to step `steps[w]`."""
    w = wp.tid()
    _begin(model, ver, ops, feat, w)
    for step in range(steps[w]):
        _link_program(model, trace, ops, ver, w, step)
        _link_forces(model, trace, ops, ver, w, step)
        _link_contacts(model, con, trace, ops, feat, ver, w, step)
        for i in range(model.n_bodies):
            if model.dynamic[i] != 0 and trace.awake[w, step, i] != 0:
                _link_move(model, con, trace, ops, ver, w, step, i)
        for i in range(model.n_bodies):
            if step + 1 < trace.awake.shape[1]:
                rests = trace.awake[w, step + 1, i] == 0
                if model.dynamic[i] != 0 and rests:
                    ver.now_v[w, i] = ver.velocity[w]
            ver.velocity_at[w, step + 1, i] = ver.now_v[w, i]
            ver.pose_at[w, step + 1, i] = ver.now_x[w, i]
