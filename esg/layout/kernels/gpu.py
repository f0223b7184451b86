"""Warp kernels of the layout search on a GPU: many threads share one start of one scene.

The arithmetic is that of `esg.layout.kernels.cpu`: candidates of one unit are independent of one
another, and so are the gradients of all units, because they are taken at the same state. `place`
spreads candidates over lanes, `slope` gives every unit its own thread (with its own copy of the
start's poses), `measure` spreads the terms of the energy over lanes. With one lane the results are
those of the sequential kernels, bit for bit; with more, energies are summed in another order.
"""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: E501, RUF046, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.collide import pair_energy
from esg.layout.kernels.descent import adam, gradient
from esg.layout.kernels.energy import E_REGION, edge_energy, spread
from esg.layout.kernels.planar import Problem
from esg.layout.kernels.proposals import Settings, candidate, candidate_count, candidate_energy

wp.set_module_options({"enable_backward": False, "max_unroll": 1})


@wp.struct
class Starts:
    """One entry per start; node and unit offsets are those of `x` and `w`."""

    scene: wp.array(dtype=wp.int32)
    seed: wp.array(dtype=wp.int32)
    node: wp.array(dtype=wp.int32)
    unit: wp.array(dtype=wp.int32)
    scratch_w: wp.array(dtype=wp.int32)  # first scratch pose of nodes: units x nodes per start
    scratch_x: wp.array(dtype=wp.int32)  # first scratch pose of units: units x units per start
    lowest: wp.array(dtype=wp.float32)
    mark: wp.array(dtype=wp.float32)
    done: wp.array(dtype=wp.int32)
    steps: wp.array(dtype=wp.int32)
    energy: wp.array(dtype=wp.vec3)
    initial: wp.array(dtype=wp.vec3)
    x: wp.array(dtype=wp.vec3)
    w: wp.array(dtype=wp.vec3)
    best: wp.array(dtype=wp.vec3)
    m1: wp.array(dtype=wp.vec3)
    m2: wp.array(dtype=wp.vec3)
    grad: wp.array(dtype=wp.vec3)


@wp.kernel
def place(
    p: Problem,
    s: Settings,
    a: Starts,
    i: int,
    lanes: int,
    xl: wp.array(dtype=wp.vec3),
    wl: wp.array(dtype=wp.vec3),
    found_e: wp.array2d(dtype=wp.float32),
    found_k: wp.array2d(dtype=wp.int32),
    found_x: wp.array2d(dtype=wp.vec3),
):
    """Chooses unit i - 1 among what all lanes found and tries this lane's candidates of unit i.

    Every lane keeps its own copy of the start's poses (xl, wl). What lanes find is kept apart for
    odd and even units, so that no lane overwrites what another still reads: found [2, starts * lanes].
    """
    tid = wp.tid()
    t = tid / lanes
    lane = tid % lanes
    scene = a.scene[t]
    u0 = p.scene_unit[scene]
    u1 = p.scene_unit[scene + 1]
    nodes = p.scene_node[scene + 1] - p.scene_node[scene]
    off = a.node[t] * lanes + lane * nodes - p.scene_node[scene]
    uoff = a.unit[t] * lanes + lane * (u1 - u0) - u0
    u = u0 + i
    if i > 0 and u - 1 < u1:
        least = float(1.0e30)
        at = int(1 << 30)
        pick = p.unit_pose[u - 1]
        row = (i + 1) % 2
        for j in range(lanes):
            e = found_e[row, t * lanes + j]
            k = found_k[row, t * lanes + j]
            if e < least or (e == least and k < at):
                least = e
                at = k
                pick = found_x[row, t * lanes + j]
        xl[u - 1 + uoff] = pick
        spread(p, wl, xl, off, uoff, u - 1, u - 1)
        if lane == 0:
            a.x[u - 1 + a.unit[t] - u0] = pick
            spread(p, a.w, a.x, a.node[t] - p.scene_node[scene], a.unit[t] - u0, u - 1, u - 1)
    if u < u1:
        least = float(1.0e30)
        at = int(1 << 30)
        pick = p.unit_pose[u]
        count = candidate_count(p, u, s)
        k = lane
        while k < count:
            rng = wp.rand_init(a.seed[t] * 7919 + 13, i * 1024 + k)
            if k == 0:
                rng = wp.rand_init(a.seed[t])
                if i > 0:
                    rng = wp.rand_init(
                        a.seed[t] * 7919 + 13, (i - 1) * 1024 + candidate_count(p, u - 1, s)
                    )
            c = candidate(p, wl, off, u, k, s, rng)
            e = float(0.0)
            if count > 1:
                e = candidate_energy(p, wl, xl, off, uoff, u, c, s)
            if e < least:
                least = e
                at = k
                pick = c
            k += lanes
        found_e[i % 2, tid] = least
        found_k[i % 2, tid] = at
        found_x[i % 2, tid] = pick


@wp.kernel
def slope(
    p: Problem,
    s: Settings,
    a: Starts,
    active: wp.array(dtype=wp.int32),
    count: int,
    xs: wp.array(dtype=wp.vec3),
    ws: wp.array(dtype=wp.vec3),
):
    """Gradient of one unit of one active start; neighbouring threads are starts of one scene."""
    tid = wp.tid()
    t = active[tid % count]
    i = tid / count
    scene = a.scene[t]
    u0 = p.scene_unit[scene]
    units = p.scene_unit[scene + 1] - u0
    if i < units and a.done[t] == 0:
        n0 = p.scene_node[scene]
        nodes = p.scene_node[scene + 1] - n0
        own_w = a.scratch_w[t] + i * nodes
        own_x = a.scratch_x[t] + i * units
        for n in range(nodes):
            ws[own_w + n] = a.w[a.node[t] + n]
        for v in range(units):
            xs[own_x + v] = a.x[a.unit[t] + v]
        a.grad[a.unit[t] + i] = gradient(p, ws, xs, own_w - n0, own_x - u0, u0 + i, s.soft)


@wp.kernel
def step(p: Problem, s: Settings, a: Starts, active: wp.array(dtype=wp.int32), it: int):
    """One Adam step of one active start."""
    t = active[wp.tid()]
    if a.done[t] == 0:
        scene = a.scene[t]
        u0 = p.scene_unit[scene]
        u1 = p.scene_unit[scene + 1]
        uoff = a.unit[t] - u0
        adam(p, a.x, a.m1, a.m2, a.grad, uoff, u0, u1, it, s)
        for u in range(u0, u1):
            spread(p, a.w, a.x, a.node[t] - p.scene_node[scene], uoff, u, 1 << 30)


@wp.kernel
def measure(
    p: Problem,
    s: Settings,
    a: Starts,
    active: wp.array(dtype=wp.int32),
    count: int,
    lanes: int,
    part: wp.array2d(dtype=wp.vec3),
):
    """Energy of every lanes-th term of an active start: part [lanes, active]."""
    tid = wp.tid()
    at = tid % count
    lane = tid / count
    t = active[at]
    if a.done[t] == 0:
        scene = a.scene[t]
        off = a.node[t] - p.scene_node[scene]
        rel = float(0.0)
        reg = float(0.0)
        col = float(0.0)
        i = p.scene_edge[scene] + lane
        while i < p.scene_edge[scene + 1]:
            e = edge_energy(p, a.w, off, i, s.soft)
            if p.edge_kind[i] == E_REGION:
                reg += e
            else:
                rel += e
            i += lanes
        i = p.scene_pair[scene] + lane
        while i < p.scene_pair[scene + 1]:
            col += pair_energy(p, a.w, off, i)
            i += lanes
        part[lane, at] = wp.vec3(rel, col, reg)


@wp.kernel
def assess(
    p: Problem,
    s: Settings,
    a: Starts,
    active: wp.array(dtype=wp.int32),
    lanes: int,
    part: wp.array2d(dtype=wp.vec3),
    it: int,
):
    """Keeps the best state seen and decides whether a start is finished after `it` steps."""
    at = wp.tid()
    t = active[at]
    if a.done[t] == 0:
        a.steps[t] = it
        parts = part[0, at]
        for lane in range(1, lanes):
            parts += part[lane, at]
        now = parts[0] + parts[1] + parts[2]
        if it == 0:
            a.initial[t] = parts
            a.lowest[t] = 1.0e30
            a.mark[t] = 1.0e30
        if now < a.lowest[t]:
            a.lowest[t] = now
            a.energy[t] = parts
            scene = a.scene[t]
            for i in range(p.scene_unit[scene + 1] - p.scene_unit[scene]):
                a.best[a.unit[t] + i] = a.x[a.unit[t] + i]
        if it % 20 == 0:
            if a.mark[t] - a.lowest[t] < s.tolerance * a.mark[t]:
                a.done[t] = 1
            a.mark[t] = a.lowest[t]
        if a.lowest[t] < 1.0e-3 or it == s.iterations:
            a.done[t] = 1
