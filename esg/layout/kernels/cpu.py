"""Warp kernels of the layout search on a CPU: one thread is one start of one scene.

`initialize` places units in order by sampled candidates, `refine` runs the whole Adam descent of a
start. `esg.layout.kernels.gpu` does the same with many threads per start.
"""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: RUF046, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.descent import adam, gradient
from esg.layout.kernels.energy import spread, total_energy
from esg.layout.kernels.planar import Problem
from esg.layout.kernels.proposals import (
    Settings,
    candidate,
    candidate_count,
    candidate_energy,
)

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})


@wp.kernel
def initialize(
    first: int,
    p: Problem,
    s: Settings,
    thread_scene: wp.array(dtype=wp.int32),
    thread_seed: wp.array(dtype=wp.int32),
    thread_node: wp.array(dtype=wp.int32),
    thread_unit: wp.array(dtype=wp.int32),
    x: wp.array(dtype=wp.vec3),
    w: wp.array(dtype=wp.vec3),
):
    """Places the units of a start one after the other, each at its best sampled candidate."""
    t = wp.tid() + first
    scene = thread_scene[t]
    # state index = global index + offset
    off = thread_node[t] - p.scene_node[scene]
    uoff = thread_unit[t] - p.scene_unit[scene]
    u0 = p.scene_unit[scene]
    u1 = p.scene_unit[scene + 1]
    rng = wp.rand_init(thread_seed[t])
    for u in range(u0, u1):
        least = float(1.0e30)
        pick = p.unit_pose[u]
        count = candidate_count(p, u, s)
        for k in range(count):
            c = candidate(p, w, off, u, k, s, rng)
            # reading rng in candidate advances a copy only: move this one on
            rng = wp.rand_init(thread_seed[t] * 7919 + 13, (u - u0) * 1024 + k + 1)
            e = float(0.0)
            if count > 1:
                e = candidate_energy(p, w, x, off, uoff, u, c, s)
            if e < least:
                least = e
                pick = c
        x[u + uoff] = pick
        spread(p, w, x, off, uoff, u, u)


@wp.kernel
def refine(
    first: int,
    p: Problem,
    s: Settings,
    thread_scene: wp.array(dtype=wp.int32),
    thread_node: wp.array(dtype=wp.int32),
    thread_unit: wp.array(dtype=wp.int32),
    x: wp.array(dtype=wp.vec3),
    best: wp.array(dtype=wp.vec3),
    m1: wp.array(dtype=wp.vec3),
    m2: wp.array(dtype=wp.vec3),
    grad: wp.array(dtype=wp.vec3),
    w: wp.array(dtype=wp.vec3),
    energy: wp.array(dtype=wp.vec3),
    initial: wp.array(dtype=wp.vec3),
    steps: wp.array(dtype=wp.int32),
):
    """Adam with clipping and projection on all units of a start; keeps the best state seen."""
    t = wp.tid() + first
    scene = thread_scene[t]
    # state index = global index + offset
    off = thread_node[t] - p.scene_node[scene]
    uoff = thread_unit[t] - p.scene_unit[scene]
    u0 = p.scene_unit[scene]
    u1 = p.scene_unit[scene + 1]
    last = int(1 << 30)
    for u in range(u0, u1):
        m1[u + uoff] = wp.vec3(0.0, 0.0, 0.0)
        m2[u + uoff] = wp.vec3(0.0, 0.0, 0.0)
    lowest = float(1.0e30)
    mark = float(1.0e30)
    used = int(0)
    done = int(0)
    for it in range(s.iterations + 1):
        if done == 0:
            parts = total_energy(p, w, off, scene, s.soft)
            now = parts[0] + parts[1] + parts[2]
            if it == 0:
                initial[t] = parts
            if now < lowest:
                lowest = now
                energy[t] = parts
                for u in range(u0, u1):
                    best[u + uoff] = x[u + uoff]
            if it % 20 == 0:
                if mark - lowest < s.tolerance * mark:
                    done = int(1)
                mark = lowest
            if lowest < 1.0e-3 or it == s.iterations:
                done = int(1)
        if done == 0:
            used = it + 1
            for u in range(u0, u1):
                grad[u + uoff] = gradient(p, w, x, off, uoff, u, s.soft)
            adam(p, x, m1, m2, grad, uoff, u0, u1, it, s)
            for u in range(u0, u1):
                spread(p, w, x, off, uoff, u, last)
    for u in range(u0, u1):
        x[u + uoff] = best[u + uoff]
    steps[t] = used
