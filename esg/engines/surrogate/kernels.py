"""The fused kernel: a whole rollout of one world in one thread, whatever its scene.

A thread first picks the arrays of its scene, which `esg.engines.surrogate.launch` lays out.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
from typing import Any

import warp as wp

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
from esg.engines.surrogate.contacts import find_contacts, prepare_bodies, wake
from esg.engines.surrogate.solver import move, solve
from esg.engines.surrogate.types import (
    Contacts,
    Fields,
    Fired,
    Log,
    Model,
    Out,
    Raw,
    State,
    Trace,
)
from esg.engines.traction import Feature

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
    if kind == Action.ADJUST:
        to = vector(model.table, w, k, Column.LINEAR_DAMPING)
        d = state.damping[w, i]
        if not wp.isnan(to[0]):
            d[0] = to[0]
        if not wp.isnan(to[1]):
            d[1] = to[1]
        state.damping[w, i] = d
        if not wp.isnan(to[2]):
            state.friction[w, i] = to[2] * model.friction_scale[w]
        if not wp.isnan(model.table[w, k, Column.BRAKING]):
            state.braking[w, i] = float(model.table[w, k, Column.BRAKING])
        return
    _rouse(state, w, i)
    if kind == Action.SET_VELOCITY:
        state.v[w, i] = vector(model.table, w, k, Column.LINEAR)
        if not wp.isnan(model.table[w, k, Column.ANGULAR]):
            state.o[w, i] = vector(model.table, w, k, Column.ANGULAR)
    else:
        impulse = vector(model.table, w, k, Column.IMPULSE)
        state.v[w, i] = state.v[w, i] + impulse / model.mass[w, i]


@wp.func
def _hold(model: Model, state: State, w: int, k: int, step: int, t: wp.float64, dt: wp.float64):
    """Sets what a primitive that lasts keeps up: motion under own power, a guide, a spin."""
    i = model.target[k]
    _rouse(state, w, i)
    pull = model.gravity[2] * float(dt)
    if model.action[k] < Action.SPIN:
        state.driven[w, i] = step + 1
        state.tips[w, i] = 0
    if model.action[k] == Action.HOLD:
        v = held_velocity(model.table, w, k, t, dt, state.v[w, i], pull)
        state.v[w, i] = v
        state.o[w, i] = held_spin(model.table, w, k, v)
    elif model.action[k] == Action.GUIDE:
        state.v[w, i] = guide(model.table, w, k, t, dt, state.x[w, i], pull)
        state.o[w, i] = wp.vec3(0.0, 0.0, float(model.table[w, k, Column.GUIDE_TURN_RATE]))
    elif model.action[k] == Action.BUOY:
        turn = state.r[w, i]
        kept = buoyed(model.table, w, k, float(dt), state.x[w, i], turn, state.v[w, i],
                      state.o[w, i])  # fmt: skip
        state.v[w, i] = wp.spatial_top(kept)
        state.o[w, i] = wp.spatial_bottom(kept)
    else:
        state.o[w, i] = vector(model.table, w, k, Column.SPIN)


@wp.func
def run_program(model: Model, state: State, trace: Trace, w: int, step: int, dt: wp.float64):
    """What the program does before a step (`esg.engines.program`)."""
    t = wp.float64(step) * dt
    now = t + wp.float64(0.5) * dt
    for k in range(model.n_primitives):
        if state.done[w, k] != 0:
            continue
        end = model.table[w, k, Column.END]
        if model.action[k] >= Action.HOLD:
            if state.active[w, k] != 0:
                for other in range(model.n_bodies):
                    touched = state.touched[w, model.target[k], other] == step
                    if model.until[k, other] != 0 and touched:
                        state.done[w, k] = 1
            if now > end:
                state.done[w, k] = 1
            if state.done[w, k] == 0 and model.table[w, k, Column.START] <= now:
                state.active[w, k] = 1
                _hold(model, state, w, k, step, t, dt)
                if trace.steps > 0 and model.action[k] != Action.BUOY:
                    trace.fired[w, step, k] = wp.where(now + dt > end, Fired.LAST, Fired.ACTS)
        elif model.table[w, k, Column.START] <= now:
            state.done[w, k] = 1
            _fire(model, state, w, k)
            if trace.steps > 0:
                trace.fired[w, step, k] = Fired.ACTS


@wp.func
def _look(model: Model, state: State, w: int, step: int, dt: float):
    """What nothing carries is left alone by brakes and tyres, as what is driven."""
    if step == 0:
        return
    for i in range(model.n_bodies):
        if falls(state.start[w, i][2], state.v[w, i][2], model.gravity[2] * dt):
            state.driven[w, i] = step + 1
        if model.features[i, Feature.DROP] > 0.0 and struck(state.start[w, i], state.v[w, i]):
            state.tips[w, i] = 1


@wp.func
def _ground(model: Model, state: State, trace: Trace, w: int, step: int, dt: float):
    """What brakes and tyres do before a step, after what the program sets."""
    for i in range(model.n_bodies):
        if model.dynamic[i] == 0 or state.awake[w, i] == 0:
            continue
        v = state.v[w, i]
        o = state.o[w, i]
        state.start[w, i] = v
        if state.driven[w, i] == step + 1:
            continue
        weight = -model.gravity[2] * dt * model.friction_scale[w]
        loss = state.braking[w, i] * dt
        kept = grounded(model.features, i, loss, weight, v, o, state.r[w, i])
        tips = state.tips[w, i] != 0
        if tips:
            state.tips[w, i] = 0
            slow, spin = wp.spatial_top(kept), wp.spatial_bottom(kept)
            kept = tipped(model.features, i, slow, spin, state.r[w, i])
        state.v[w, i] = wp.spatial_top(kept)
        state.o[w, i] = wp.spatial_bottom(kept)
        state.start[w, i] = state.v[w, i]
        if trace.steps > 0:
            changed = wp.length_sq(state.v[w, i] - v) > 0.0
            changed = changed or wp.length_sq(state.o[w, i] - o) > 0.0
            trace.grounded[w, step, i] = wp.where(changed, wp.where(tips, 2, 1), 0)


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
def _write_frame(model: Model, state: State, out: Out, w: int, frame: int):
    """Keeps the states of all moving bodies as a frame."""
    slot = int(0)  # noqa: UP018, RUF046  # a variable to Warp, not a constant
    for b in range(model.n_bodies):
        if model.dynamic[b] != 0:
            out.x[w, frame - 1, slot] = state.x[w, b]
            out.r[w, frame - 1, slot] = state.r[w, b]
            out.v[w, frame - 1, slot] = state.v[w, b]
            out.o[w, frame - 1, slot] = state.o[w, b]
            slot = slot + 1


@wp.func
def _note(
    model: Model,
    state: State,
    trace: Trace,
    con: Contacts,
    out: Out,
    w: int,
    step: int,
    sweeps: int,
):
    """Keeps the decisions of a step, if there is a trace, and the largest overlap."""
    if trace.steps > 0:
        trace.sweeps[w, step] = sweeps
        for b in range(model.n_bodies):
            trace.awake[w, step, b] = state.awake[w, b]
    at = wp.min(step, con.count.shape[1] - 1)
    for k in range(con.count[w, at]):
        out.deepest[w] = wp.max(out.deepest[w], -con.gap[w, con.base * at + k])


def make_roll(find_contacts: Any, module: str) -> Any:
    """The kernel of whole rollouts, of one scene or of several.

    Args:
        find_contacts: Warp function that collects the contacts of a step.
        module: Name of the module that the kernel is compiled with.
    """

    @wp.kernel(enable_backward=False, module=wp.get_module(module))
    def roll(
        fields: wp.array(dtype=Fields),
        models: wp.array(dtype=Model),
        states: wp.array(dtype=State),
        raws: wp.array(dtype=Raw),
        cons: wp.array(dtype=Contacts),
        logs: wp.array(dtype=Log),
        outs: wp.array(dtype=Out),
        trace: Trace,
        scene_of: wp.array(dtype=int),
        world_of: wp.array(dtype=int),
        first: int,
        spread: int,
    ):
        """Simulates a world, from number `first` on, in every `spread`-th thread.

        The worlds of a warp wait for each other where their paths differ: while there are few
        worlds, each does better with a warp of its own.
        """
        thread = wp.tid()
        i = thread / spread
        if thread != i * spread:
            return
        i = i + first
        s = scene_of[i]
        w = world_of[i]
        model = models[s]
        state = states[s]
        raw = raws[s]
        con = cons[s]
        log = logs[s]
        out = outs[s]
        raw.world = w
        dt = model.dt
        h = float(dt)
        record_every = model.record_every
        for step in range(model.n_steps):
            if model.grounded != 0:
                _look(model, state, w, step, h)
            run_program(model, state, trace, w, step, dt)
            if model.grounded != 0:
                _ground(model, state, trace, w, step, h)
            prepare_bodies(model, state, w, h)
            wake(model, state, w, h)
            find_contacts(fields, s, model, state, raw, con, w, step, h)
            sweeps = solve(model, state, con, w, step)
            _note(model, state, trace, con, out, w, step, sweeps)
            write_log(state, con, log, w, step, step / record_every + 1)
            # A log that is to show the weight of what rests needs it awake.
            move(model, state, con, w, step, h, log.ground == 0)
            if (step + 1) % record_every == 0:
                frame = (step + 1) / record_every
                if not _sound(model, state, w):
                    out.end[w] = frame
                    return
                _write_frame(model, state, out, w, frame)
        out.end[w] = out.x.shape[1] + 1

    return roll


@wp.func
def _find_contacts(
    fields: wp.array(dtype=Fields),
    scene: int,
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    dt: float,
):
    """Contacts of bodies that have no fields."""
    find_contacts(model, state, raw, con, w, step, dt)


roll = make_roll(_find_contacts, __name__)


@wp.kernel(enable_backward=False)
def count_rows(
    cons: wp.array(dtype=Contacts),
    logs: wp.array(dtype=Log),
    scene_of: wp.array(dtype=int),
    world_of: wp.array(dtype=int),
    counts: wp.array2d(dtype=int),
):
    """Rows of every world's log, and contacts that found no room."""
    i = wp.tid()
    w = world_of[i]
    counts[0, i] = logs[scene_of[i]].count[w]
    counts[1, i] = cons[scene_of[i]].dropped[w]


@wp.kernel(enable_backward=False)
def pack_logs(
    logs: wp.array(dtype=Log),
    scene_of: wp.array(dtype=int),
    world_of: wp.array(dtype=int),
    offset: wp.array(dtype=int),
    ints: wp.array2d(dtype=int),
    floats: wp.array2d(dtype=float),
):
    """Gathers the used rows of all logs; `offset` says where a world's rows go."""
    i = wp.tid()
    log = logs[scene_of[i]]
    w = world_of[i]
    at = offset[i]
    for row in range(offset[i + 1] - at):
        ints[at + row, 0] = log.frame[w, row]
        ints[at + row, 1] = log.a[w, row]
        ints[at + row, 2] = log.b[w, row]
        ints[at + row, 3] = log.step[w, row]
        floats[at + row, 0] = log.impulse[w, row]
        floats[at + row, 1] = log.depth[w, row]
        for k in range(3):
            floats[at + row, 2 + k] = log.point[w, row][k]
            floats[at + row, 5 + k] = log.normal[w, row][k]
