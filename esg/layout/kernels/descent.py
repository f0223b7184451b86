"""Warp functions of the refinement: one unit's gradient and one Adam step."""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: RUF046, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.energy import spread, unit_energy
from esg.layout.kernels.planar import PI, Problem
from esg.layout.kernels.proposals import Settings, project

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})


@wp.func
def gradient(
    p: Problem,
    w: wp.array(dtype=wp.vec3),
    x: wp.array(dtype=wp.vec3),
    off: int,
    uoff: int,
    u: int,
    soft: float,
):
    """Central differences of all terms that unit u influences; x and w end as they were."""
    last = int(1 << 30)
    fr = p.unit_free[u]
    x0 = x[u + uoff]
    g = wp.vec3(0.0, 0.0, 0.0)
    # probe 0 is the pose itself: all terms are non-negative, so a unit without energy
    # has no gradient; then one probe to either side of every axis
    probes = int(7)
    if fr[0] + fr[1] + fr[2] < 0.5:
        probes = int(0)
    for k in range(probes):
        axis = (k + 1) / 2 - 1
        if k == 0 or (probes == 7 and fr[axis] > 0.5):
            h = float(0.05)
            if axis == 2:
                h = 0.003
            if k % 2 == 0:
                h = -h
            if k > 0:
                dv = wp.vec3(0.0, 0.0, 0.0)
                dv[axis] = h
                x[u + uoff] = x0 + dv
                spread(p, w, x, off, uoff, u, last)
            e = unit_energy(p, w, off, u, last, soft)
            if k == 0:
                if e < 1.0e-6:
                    probes = int(1)
            else:
                g[axis] = g[axis] + 0.5 * e / h
    x[u + uoff] = x0
    spread(p, w, x, off, uoff, u, last)
    return g


@wp.func
def adam(
    p: Problem,
    x: wp.array(dtype=wp.vec3),
    m1: wp.array(dtype=wp.vec3),
    m2: wp.array(dtype=wp.vec3),
    grad: wp.array(dtype=wp.vec3),
    uoff: int,
    u0: int,
    u1: int,
    it: int,
    s: Settings,
):
    """Clipped, decaying step of all units, each projected into its regions."""
    frac = float(it) / float(s.iterations)
    rate = 0.5 * (1.0 + wp.cos(PI * frac)) + 0.02
    b1 = 1.0 - wp.pow(0.8, float(it + 1))
    b2 = 1.0 - wp.pow(0.95, float(it + 1))
    for u in range(u0, u1):
        g = grad[u + uoff]
        g = wp.vec3(
            wp.clamp(g[0], -50.0, 50.0),
            wp.clamp(g[1], -50.0, 50.0),
            wp.clamp(g[2], -5000.0, 5000.0),
        )
        a1 = 0.8 * m1[u + uoff] + 0.2 * g
        a2 = 0.95 * m2[u + uoff] + 0.05 * wp.cw_mul(g, g)
        m1[u + uoff] = a1
        m2[u + uoff] = a2
        step = p.unit_step[u] * rate
        yaw_step = 0.06 * rate
        d = wp.vec3(
            step * (a1[0] / b1) / (wp.sqrt(a2[0] / b2) + 1.0e-3),
            step * (a1[1] / b1) / (wp.sqrt(a2[1] / b2) + 1.0e-3),
            yaw_step * (a1[2] / b1) / (wp.sqrt(a2[2] / b2) + 1.0e-2),
        )
        x[u + uoff] = project(p, x[u + uoff] - d, u)
