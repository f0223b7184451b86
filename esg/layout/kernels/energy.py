"""Warp functions of the layout energy: relations and regions, and sums over a unit and a scene.

Everything rests on its support by construction (heights are constants of the problem), which leaves
x, y [cm] and yaw [rad] of each unit in the frame of its parent node.
"""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: SIM109, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.collide import pair_energy
from esg.layout.kernels.planar import (
    Problem,
    compose,
    relu,
    smooth,
    surface_distance,
    turn,
    world_half,
)
from esg.layout.problem import terms

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})

E_BAND = wp.constant(terms.BAND)
E_DIRECTION = wp.constant(terms.DIRECTION)
E_FACE = wp.constant(terms.FACE)
E_CENTER = wp.constant(terms.CENTER)
E_UNDER = wp.constant(terms.UNDER)
E_REGION = wp.constant(terms.REGION)
E_SLOT = wp.constant(terms.SLOT)
E_BETWEEN = wp.constant(terms.BETWEEN)
E_LERP = wp.constant(terms.LERP)
REGION_WEIGHT = wp.constant(8.0)
FACE_SCALE_CM = wp.constant(60.0)


@wp.func
def region_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, e: int):
    """Rectangle p0..p3 = min x, min y, max x, max y in b's frame holds a's footprint."""
    n = p.edge_node[e]
    pa = w[n[0] + off]
    q = wp.vec2(pa[0], pa[1])
    yaw = pa[2]
    if n[1] >= 0:
        pb = w[n[1] + off]
        q = turn(wp.vec2(pa[0] - pb[0], pa[1] - pb[1]), -pb[2])
        yaw = pa[2] - pb[2]
    h = world_half(p, n[0], yaw)
    vx = relu(p.edge_p[e, 0] - q[0] + h[0]) + relu(q[0] + h[0] - p.edge_p[e, 2])
    vy = relu(p.edge_p[e, 1] - q[1] + h[1]) + relu(q[1] + h[1] - p.edge_p[e, 3])
    return REGION_WEIGHT * (vx * vx + vy * vy + smooth(vx) + smooth(vy)) * p.edge_w[e]


@wp.func
def direction_energy(p: Problem, e: int, ha: wp.vec2, hb: wp.vec2, d: wp.vec2, soft: float):
    """Axis p0, sign p1, extra range p2, lateral tolerance p3, scale p4, least gap p5."""
    along = d[0]
    across = wp.abs(d[1])
    ea = ha[0] + hb[0]
    if p.edge_p[e, 0] > 0.5:
        along = d[1]
        across = wp.abs(d[0])
        ea = ha[1] + hb[1]
    along = along * p.edge_p[e, 1]
    low = ea + p.edge_p[e, 5]
    high = low + p.edge_p[e, 2]
    # what makes the relation true has full weight; clearing the footprints, the upper range and
    # lateral alignment make it tidy
    v = (
        smooth(relu(2.0 - along))
        + soft * smooth(relu(low - along))
        + soft * 0.3 * smooth(relu(along - high))
    )
    lat = relu(across - p.edge_p[e, 3])
    # the quadratic of the paper, continued linearly: one far object must not drown the rest
    c = p.edge_p[e, 4]
    if lat < 0.5 * c:
        v += soft * 0.5 * lat * lat / c
    else:
        v += soft * (0.5 * lat - 0.125 * c)
    return v


@wp.func
def edge_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, e: int, soft: float):
    kind = p.edge_kind[e]
    n = p.edge_node[e]
    a = n[0]
    b = n[1]
    pa = w[a + off]
    if kind == E_REGION:
        return region_energy(p, w, off, e)
    if kind == E_FACE:  # p0: 1 = towards the fixed direction p1 [rad], p2: angular tolerance
        target = p.edge_p[e, 1]
        if p.edge_p[e, 0] < 0.5:
            pt = w[b + off]
            target = wp.atan2(pt[1] - pa[1], pt[0] - pa[0])
        turned = wp.cos(pa[2] - target)
        # the angle itself keeps a slope where the cosine is flat
        return (
            p.edge_w[e]
            * FACE_SCALE_CM
            * (1.0 - turned + 0.5 * relu(wp.acos(wp.clamp(turned, -1.0, 1.0)) - 0.1))
        )
    pb = w[b + off]
    d = wp.vec2(pa[0] - pb[0], pa[1] - pb[1])
    v = float(0.0)
    if kind == E_BAND:  # surface distance between p0 and p1
        s = surface_distance(p, a, b, pa, pb)
        v = smooth(relu(s - p.edge_p[e, 1])) + smooth(relu(p.edge_p[e, 0] - s))
    elif kind == E_DIRECTION:
        v = direction_energy(p, e, world_half(p, a, pa[2]), world_half(p, b, pb[2]), d, soft)
    elif kind == E_CENTER or kind == E_SLOT:  # within p0 of b's point (p1, p2)
        t = turn(wp.vec2(p.edge_p[e, 1], p.edge_p[e, 2]), pb[2])
        v = smooth(relu(wp.length(d - t) - p.edge_p[e, 0]))
    elif kind == E_UNDER:  # a's centre within b's footprint shrunk by p0
        q = turn(d, -pb[2])
        hb = p.node_half[b]
        v = smooth(relu(wp.abs(q[0]) - relu(hb[0] - p.edge_p[e, 0]))) + smooth(
            relu(wp.abs(q[1]) - relu(hb[1] - p.edge_p[e, 0]))
        )
    else:  # BETWEEN and LERP: within p0 of the point at fraction p1 from b to c
        pc = w[n[2] + off]
        frac = p.edge_p[e, 1]
        v = smooth(
            relu(
                wp.length(
                    wp.vec2(
                        pa[0] - pb[0] - frac * (pc[0] - pb[0]),
                        pa[1] - pb[1] - frac * (pc[1] - pb[1]),
                    )
                )
                - p.edge_p[e, 0]
            )
        )
    return p.edge_w[e] * v


@wp.func
def spread(
    p: Problem,
    w: wp.array(dtype=wp.vec3),
    x: wp.array(dtype=wp.vec3),
    off: int,
    uoff: int,
    u: int,
    limit: int,
):
    """Writes the world poses of the nodes that unit u moves, up to unit `limit`."""
    for k in range(p.aff_off[u], p.aff_off[u + 1]):
        n = p.aff[k]
        v = p.node_unit[n]
        if v <= limit:
            q = compose(x[v + uoff], p.node_rel[n])
            if p.unit_parent[v] >= 0:
                q = compose(w[p.unit_parent[v] + off], q)
            w[n + off] = q


@wp.func
def unit_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, u: int, limit: int, soft: float):
    """Sum of all terms that unit u influences, among units up to `limit`."""
    e = float(0.0)
    for k in range(p.ue_off[u], p.ue_off[u + 1]):
        i = p.ue[k]
        n = p.edge_node[i]
        ready = p.node_unit[n[0]] <= limit
        if n[1] >= 0:
            ready = ready and p.node_unit[n[1]] <= limit
        if n[2] >= 0:
            ready = ready and p.node_unit[n[2]] <= limit
        if ready:
            e += edge_energy(p, w, off, i, soft)
    for k in range(p.up_off[u], p.up_off[u + 1]):
        i = p.up[k]
        ab = p.pair[i]
        if p.node_unit[ab[0]] <= limit and p.node_unit[ab[1]] <= limit:
            e += pair_energy(p, w, off, i)
    return e


@wp.func
def total_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, scene: int, soft: float):
    rel = float(0.0)
    reg = float(0.0)
    col = float(0.0)
    for i in range(p.scene_edge[scene], p.scene_edge[scene + 1]):
        e = edge_energy(p, w, off, i, soft)
        if p.edge_kind[i] == E_REGION:
            reg += e
        else:
            rel += e
    for i in range(p.scene_pair[scene], p.scene_pair[scene + 1]):
        col += pair_energy(p, w, off, i)
    return wp.vec3(rel, col, reg)
