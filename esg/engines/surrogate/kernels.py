"""The fused kernel: a whole rollout of one world in one thread."""

from __future__ import annotations

# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
import warp as wp

from esg.engines.surrogate.contacts import find_contacts, prepare_bodies, wake
from esg.engines.surrogate.solver import move, solve
from esg.engines.surrogate.types import Contacts, Log, Model, Raw, State, Trace

wp.set_module_options({"enable_backward": False})

MAX_SPEED_MPS = wp.constant(500.0)


@wp.func
def _rouse(state: State, w: int, i: int):
    state.awake[w, i] = 1
    state.idle[w, i] = 0


@wp.func
def _fire(model: Model, state: State, w: int, k: int):
    """Executes a primitive that acts once."""
    i = model.target[k]
    kind = model.action[k]
    a = wp.vec3(
        float(model.table[w, k, 2]), float(model.table[w, k, 3]), float(model.table[w, k, 4])
    )
    if kind == 2:
        d = state.damping[w, i]
        if not wp.isnan(a[0]):
            d[0] = a[0]
        if not wp.isnan(a[1]):
            d[1] = a[1]
        state.damping[w, i] = d
        if not wp.isnan(a[2]):
            state.friction[w, i] = a[2] * model.friction_scale[w]
        return
    _rouse(state, w, i)
    if kind == 0:
        state.v[w, i] = a
        if not wp.isnan(model.table[w, k, 5]):
            state.o[w, i] = wp.vec3(
                float(model.table[w, k, 5]),
                float(model.table[w, k, 6]),
                float(model.table[w, k, 7]),
            )
    else:
        state.v[w, i] = state.v[w, i] + a / model.mass[w, i]


@wp.func
def _hold(model: Model, state: State, w: int, k: int, t: wp.float64, dt: wp.float64):
    """Sets the velocity of a body that moves under its own power."""
    i = model.target[k]
    s = t - model.table[w, k, 0]
    speed = wp.max(wp.float64(0.0), model.table[w, k, 2] + model.table[w, k, 4] * s)
    if model.table[w, k, 4] > wp.float64(0.0):
        speed = wp.min(speed, model.table[w, k, 5])
    heading = model.table[w, k, 3] + model.table[w, k, 6] * s
    vx = float(speed * wp.cos(heading))
    vy = float(speed * wp.sin(heading))
    _rouse(state, w, i)
    vz = state.v[w, i][2]
    radius = float(model.table[w, k, 7])
    if not wp.isnan(model.table[w, k, 8]):
        vz = float(model.table[w, k, 8]) - model.gravity[2] * float(dt)
        radius = 0.0
    state.v[w, i] = wp.vec3(vx, vy, vz)
    if radius != 0.0:
        state.o[w, i] = wp.vec3(-vy / radius, vx / radius, 0.0)
    else:
        state.o[w, i] = wp.vec3(0.0, 0.0, float(model.table[w, k, 6]))


@wp.func
def run_program(model: Model, state: State, trace: Trace, w: int, step: int, dt: wp.float64):
    """What the program does before a step (`esg.engines.program`)."""
    t = wp.float64(step) * dt
    now = t + wp.float64(0.5) * dt
    for k in range(model.n_primitives):
        if state.done[w, k] != 0:
            continue
        if model.action[k] == 3:
            if state.active[w, k] != 0:
                for other in range(model.n_bodies):
                    touched = state.touched[w, model.target[k], other] == step
                    if model.until[k, other] != 0 and touched:
                        state.done[w, k] = 1
            if now > model.table[w, k, 1]:
                state.done[w, k] = 1
            if state.done[w, k] == 0 and model.table[w, k, 0] <= now:
                state.active[w, k] = 1
                _hold(model, state, w, k, t, dt)
                if trace.steps > 0:
                    trace.fired[w, step, k] = wp.where(now + dt > model.table[w, k, 1], 2, 1)
        elif model.table[w, k, 0] <= now:
            state.done[w, k] = 1
            _fire(model, state, w, k)
            if trace.steps > 0:
                trace.fired[w, step, k] = 1


@wp.func
def write_log(state: State, con: Contacts, log: Log, w: int, step: int, frame: int):
    """Adds the impulses of a step to the rows of the frame it belongs to."""
    at = wp.min(step, con.count.shape[1] - 1)
    for k in range(con.count[w, at]):
        slot = con.base * at + k
        impulse = con.impulse[w, slot][0]
        if not (impulse > 0.0):
            continue
        a = con.a[w, slot]
        b = con.b[w, slot]
        if b >= 0:
            state.touched[w, a, b] = step + 1
            state.touched[w, b, a] = step + 1
        elif log.ground == 0:
            continue
        row = log.row[w, a + 1, b + 1]
        fresh = row < 0
        if not fresh:
            fresh = log.frame[w, row] != frame
        if fresh:
            row = log.count[w]
            log.count[w] = row + 1
            if row >= log.frame.shape[1]:
                continue
            log.row[w, a + 1, b + 1] = row
            log.frame[w, row] = frame
            log.a[w, row] = a
            log.b[w, row] = b
            log.step[w, row] = step
            log.impulse[w, row] = 0.0
            log.depth[w, row] = 0.0
            log.point[w, row] = wp.vec3()
            log.normal[w, row] = wp.vec3()
        n = con.normal[w, slot]
        x = state.x[w, a] + con.arm_a[w, slot] - n * (0.5 * con.gap[w, slot])
        log.impulse[w, row] = log.impulse[w, row] + impulse
        log.depth[w, row] = wp.max(log.depth[w, row], -con.gap[w, slot])
        log.point[w, row] = log.point[w, row] + x * impulse
        log.normal[w, row] = log.normal[w, row] + n * impulse


@wp.func
def _sound(model: Model, state: State, w: int) -> bool:
    """Whether every body is finite and slower than the limit."""
    for i in range(model.n_bodies):
        if model.dynamic[i] != 0:
            v = state.v[w, i]
            x = state.x[w, i]
            r = state.r[w, i]
            total = x[0] + x[1] + x[2] + r[0] + r[1] + r[2] + r[3]
            total = total + wp.length(state.o[w, i])
            if not (wp.length(v) <= MAX_SPEED_MPS) or not wp.isfinite(total):
                return False
    return True


@wp.func
def write_frame(
    model: Model,
    state: State,
    w: int,
    frame: int,
    out_x: wp.array3d(dtype=wp.vec3),
    out_r: wp.array3d(dtype=wp.quat),
    out_v: wp.array3d(dtype=wp.vec3),
    out_o: wp.array3d(dtype=wp.vec3),
):
    """Keeps the states of all moving bodies as a frame."""
    for i in range(model.n_bodies):
        if model.dynamic[i] != 0:
            out_x[w, frame, i] = state.x[w, i]
            out_r[w, frame, i] = state.r[w, i]
            out_v[w, frame, i] = state.v[w, i]
            out_o[w, frame, i] = state.o[w, i]


@wp.kernel(enable_backward=False)
def roll(
    model: Model,
    state: State,
    raw_point: wp.array2d(dtype=wp.vec3),
    raw_normal: wp.array2d(dtype=wp.vec3),
    raw_distance: wp.array2d(dtype=float),
    raw_count: wp.array(dtype=int),
    con: Contacts,
    log: Log,
    dt: wp.float64,
    n_steps: int,
    record_every: int,
    first_world: int,
    trace: Trace,
    deepest: wp.array(dtype=float),
    end: wp.array(dtype=int),
    out_x: wp.array3d(dtype=wp.vec3),
    out_r: wp.array3d(dtype=wp.quat),
    out_v: wp.array3d(dtype=wp.vec3),
    out_o: wp.array3d(dtype=wp.vec3),
):
    """Simulates one world per thread.

    `end` receives the first frame that is not sound, or the number of frames.
    """
    w = wp.tid() + first_world
    h = float(dt)
    raw = Raw()
    raw.world = w
    raw.count = raw_count
    raw.point = raw_point
    raw.normal = raw_normal
    raw.distance = raw_distance
    for step in range(n_steps):
        run_program(model, state, trace, w, step, dt)
        prepare_bodies(model, state, w, h)
        wake(model, state, w, h)
        find_contacts(model, state, raw, con, w, step, h)
        n = solve(model, state, con, w, step)
        if trace.steps > 0:
            trace.sweeps[w, step] = n
            for i in range(model.n_bodies):
                trace.awake[w, step, i] = state.awake[w, i]
        write_log(state, con, log, w, step, step / record_every + 1)
        at = wp.min(step, con.count.shape[1] - 1)
        for k in range(con.count[w, at]):
            deepest[w] = wp.max(deepest[w], -con.gap[w, con.base * at + k])
        # A log that is to show the weight of what rests needs it awake.
        move(model, state, con, w, step, h, log.ground == 0)
        if (step + 1) % record_every == 0:
            frame = (step + 1) / record_every
            if not _sound(model, state, w):
                end[w] = frame
                return
            write_frame(model, state, w, frame, out_x, out_r, out_v, out_o)
    end[w] = out_x.shape[1]
