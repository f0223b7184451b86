"""Warp functions of the collision energy: proxies, bounding boxes, sampled signed distances."""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: RUF046, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.planar import (
    PI,
    TOUCH_CM,
    Problem,
    compose,
    separation,
    smooth,
    turn,
    world_half,
)

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})

SAMPLES = wp.constant(16)
COLLISION_WEIGHT = wp.constant(8.0)


@wp.func
def box_overlap_energy(p: Problem, a: int, b: int, pa: wp.vec3, pb: wp.vec3, m: float):
    """The paper's AABB term; heights are constants here, so only x and y can resolve an overlap."""
    ha = world_half(p, a, pa[2])
    hb = world_half(p, b, pb[2])
    ox = ha[0] + hb[0] + m - wp.abs(pa[0] - pb[0])
    oy = ha[1] + hb[1] + m - wp.abs(pa[1] - pb[1])
    oz = wp.min(p.node_z[a] + p.node_height[a], p.node_z[b] + p.node_height[b]) - wp.max(
        p.node_z[a], p.node_z[b]
    )
    if ox > 0.0 and oy > 0.0 and oz > TOUCH_CM:
        q = wp.min(ox, oy)
        return COLLISION_WEIGHT * (0.1 * q * q + q)
    return 0.0


@wp.func
def rim(kind: int, pose: wp.vec3, half: wp.vec2, k: int):
    """Sample k of SAMPLES on the outline of a footprint."""
    t = (float(k) + 0.5) / float(SAMPLES)
    q = wp.vec2(wp.cos(2.0 * PI * t), wp.sin(2.0 * PI * t)) * half[0]
    if kind == 1:
        side = wp.floor(4.0 * t)
        f = 2.0 * (4.0 * t - side) - 1.0
        q = wp.vec2(half[0], f * half[1])
        if side == 1.0:
            q = wp.vec2(-f * half[0], half[1])
        if side == 2.0:
            q = wp.vec2(-half[0], -f * half[1])
        if side == 3.0:
            q = wp.vec2(f * half[0], -half[1])
    r = turn(q, pose[2])
    return wp.vec3(pose[0] + r[0], pose[1] + r[1], 0.0)


@wp.func
def sampled_penetration(
    p: Problem, a: int, b: int, pa: wp.vec3, pb: wp.vec3, m: float, b_is_box: int
):
    """Sum of squared penetrations of a's samples into b, and how many penetrate."""
    sums = wp.vec2(0.0, 0.0)
    ground = wp.vec2(0.0, 0.0)
    for i in range(p.prim_off[a], p.prim_off[a + 1]):
        qa = compose(pa, p.prim_pose[i])
        z0 = p.prim_z[i][0] + p.node_z[a]
        z1 = p.prim_z[i][1] + p.node_z[a]
        count = int(SAMPLES)
        for k in range(count):
            x = rim(p.prim_kind[i], qa, p.prim_half[i], k)
            least = float(1.0e9)
            if b_is_box == 1:
                if wp.min(z1, p.node_z[b] + p.node_height[b]) - wp.max(z0, p.node_z[b]) > TOUCH_CM:
                    # the box of the large side is its world-aligned box, as in the paper
                    least = separation(
                        1, wp.vec3(pb[0], pb[1], 0.0), world_half(p, b, pb[2]), 0, x, ground
                    )
            else:
                for j in range(p.prim_off[b], p.prim_off[b + 1]):
                    zb = p.prim_z[j]
                    if wp.min(z1, zb[1] + p.node_z[b]) - wp.max(z0, zb[0] + p.node_z[b]) > TOUCH_CM:
                        least = wp.min(
                            least,
                            separation(
                                p.prim_kind[j],
                                compose(pb, p.prim_pose[j]),
                                p.prim_half[j],
                                0,
                                x,
                                ground,
                            ),
                        )
            depth = m - least
            if depth > 0.0:
                sums += wp.vec2(depth * depth, 1.0)
    return sums


@wp.func
def pair_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, k: int):
    ab = p.pair[k]
    a = ab[0]
    b = ab[1]
    m = p.pair_margin[k]
    mode = p.pair_mode[k]
    pa = w[a + off]
    pb = w[b + off]
    dx = pa[0] - pb[0]
    dy = pa[1] - pb[1]
    reach = p.node_radius[a] + p.node_radius[b] + m
    e = float(0.0)
    if dx * dx + dy * dy > reach * reach:
        return e
    if mode == 1:
        return box_overlap_energy(p, a, b, pa, pb, m)
    if mode >= 2:  # 2: SDF on both sides, 3: a is large, 4: b is large
        large_a = int(0)
        large_b = int(0)
        if mode == 3:
            large_a = int(1)
        if mode == 4:
            large_b = int(1)
        sums = sampled_penetration(p, a, b, pa, pb, m, large_b) + sampled_penetration(
            p, b, a, pb, pa, m, large_a
        )
        if sums[1] > 0.0:
            e = COLLISION_WEIGHT * sums[0] / sums[1]
        return e
    for i in range(p.prim_off[a], p.prim_off[a + 1]):
        qa = compose(pa, p.prim_pose[i])
        za = p.prim_z[i]
        for j in range(p.prim_off[b], p.prim_off[b + 1]):
            zb = p.prim_z[j]
            oz = wp.min(za[1] + p.node_z[a], zb[1] + p.node_z[b]) - wp.max(
                za[0] + p.node_z[a], zb[0] + p.node_z[b]
            )
            if oz > TOUCH_CM:
                s = m - separation(
                    p.prim_kind[i],
                    qa,
                    p.prim_half[i],
                    p.prim_kind[j],
                    compose(pb, p.prim_pose[j]),
                    p.prim_half[j],
                )
                if s > 0.0:
                    e += COLLISION_WEIGHT * (0.1 * s * s + smooth(s))
    return e
