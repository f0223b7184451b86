"""The surrogate's kernel for worlds of different scenes.

A thread first picks the arrays of its scene; the functions are those of single scenes.
"""

from __future__ import annotations

# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
import warp as wp

from esg.engines.surrogate.contacts import find_contacts, prepare_bodies, wake
from esg.engines.surrogate.kernels import _sound, run_program, write_log
from esg.engines.surrogate.solver import move, solve
from esg.engines.surrogate.types import Contacts, Log, Model, Raw, State, Trace

wp.set_module_options({"enable_backward": False})


@wp.struct
class Out:
    """What a rollout of W worlds leaves: states of moving bodies, [W, T, D], and per world [W]."""

    x: wp.array3d(dtype=wp.vec3)
    r: wp.array3d(dtype=wp.quat)
    v: wp.array3d(dtype=wp.vec3)
    o: wp.array3d(dtype=wp.vec3)
    deepest: wp.array(dtype=float)
    end: wp.array(dtype=int)


@wp.kernel(enable_backward=False)
def roll_many(
    models: wp.array(dtype=Model),
    states: wp.array(dtype=State),
    raws: wp.array(dtype=Raw),
    cons: wp.array(dtype=Contacts),
    logs: wp.array(dtype=Log),
    outs: wp.array(dtype=Out),
    trace: Trace,
    scene_of: wp.array(dtype=int),
    world_of: wp.array(dtype=int),
    dts: wp.array(dtype=wp.float64),
    steps: wp.array(dtype=int),
    every: wp.array(dtype=int),
    spread: int,
):
    """Simulates a world in every `spread`-th thread; `out.x` begins with frame 1.

    The worlds of a warp wait for each other where their paths differ: while there are few worlds,
    each does better with a warp of its own.
    """
    thread = wp.tid()
    i = thread / spread
    if thread != i * spread:
        return
    s = scene_of[i]
    w = world_of[i]
    model = models[s]
    state = states[s]
    raw = raws[s]
    con = cons[s]
    log = logs[s]
    out = outs[s]
    raw.world = w
    dt = dts[s]
    h = float(dt)
    record_every = every[s]
    for step in range(steps[s]):
        run_program(model, state, trace, w, step, dt)
        prepare_bodies(model, state, w, h)
        wake(model, state, w, h)
        find_contacts(model, state, raw, con, w, step, h)
        solve(model, state, con, w, step)
        write_log(state, con, log, w, step, step / record_every + 1)
        for k in range(con.count[w, 0]):
            out.deepest[w] = wp.max(out.deepest[w], -con.gap[w, k])
        move(model, state, con, w, step, h, log.ground == 0)
        if (step + 1) % record_every == 0:
            frame = (step + 1) / record_every
            if not _sound(model, state, w):
                out.end[w] = frame
                return
            slot = int(0)  # noqa: UP018, RUF046  # a variable to Warp, not a constant
            for b in range(model.n_bodies):
                if model.dynamic[b] != 0:
                    out.x[w, frame - 1, slot] = state.x[w, b]
                    out.r[w, frame - 1, slot] = state.r[w, b]
                    out.v[w, frame - 1, slot] = state.v[w, b]
                    out.o[w, frame - 1, slot] = state.o[w, b]
                    slot = slot + 1
    out.end[w] = out.x.shape[1] + 1


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
