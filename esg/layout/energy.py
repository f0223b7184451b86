"""Warp functions of the layout energy: relations, collisions and regions of planar units.

Everything rests on its support by construction (heights are constants of the problem), which leaves
x, y [cm] and yaw [rad] of each unit in the frame of its parent node. Arrays of all scenes of a batch
are concatenated; node, unit, edge and pair indices are global.
"""

# ruff: noqa: E501, RUF046, SIM109, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout import terms

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
TOUCH_CM = wp.constant(0.2)
"""Vertical overlap below which two shapes only touch (an object and its support)."""
SAMPLES = wp.constant(16)
COLLISION_WEIGHT = wp.constant(8.0)
REGION_WEIGHT = wp.constant(8.0)
FACE_SCALE_CM = wp.constant(60.0)
PI = wp.constant(3.14159265358979)


@wp.struct
class Problem:
    node_unit: wp.array(dtype=wp.int32)
    node_rel: wp.array(dtype=wp.vec3)  # pose in the unit's frame (x, y, yaw)
    node_z: wp.array(dtype=wp.float32)  # height of the origin
    node_half: wp.array(dtype=wp.vec2)  # footprint half extents
    node_round: wp.array(dtype=wp.int32)
    node_height: wp.array(dtype=wp.float32)
    node_radius: wp.array(dtype=wp.float32)  # of the circle about the origin that holds all shapes
    prim_off: wp.array(dtype=wp.int32)
    prim_kind: wp.array(dtype=wp.int32)  # 0 circle, 1 rectangle
    prim_pose: wp.array(dtype=wp.vec3)
    prim_half: wp.array(dtype=wp.vec2)
    prim_z: wp.array(dtype=wp.vec2)
    unit_parent: wp.array(dtype=wp.int32)  # node, -1 is the world
    unit_free: wp.array(dtype=wp.vec3)  # 1 where x, y, yaw may change
    unit_pose: wp.array(dtype=wp.vec3)  # where fixed, else preferred
    unit_box: wp.array(dtype=wp.vec4)  # sampling box in the parent's frame: centre, half extents
    unit_anchor: wp.array(dtype=wp.vec4)  # preferred x, y, weight, weight of the preferred yaw
    unit_center: wp.array(dtype=wp.vec2)  # point of the unit that box and anchor refer to
    unit_step: wp.array(dtype=wp.float32)  # length scale of a step [cm]
    aff_off: wp.array(dtype=wp.int32)  # nodes moved by a unit, parents first
    aff: wp.array(dtype=wp.int32)
    own_off: wp.array(dtype=wp.int32)  # nodes of the unit itself come first in aff
    ue_off: wp.array(dtype=wp.int32)
    ue: wp.array(dtype=wp.int32)  # edges that a unit influences
    up_off: wp.array(dtype=wp.int32)
    up: wp.array(dtype=wp.int32)  # collision pairs that a unit influences
    edge_kind: wp.array(dtype=wp.int32)
    edge_node: wp.array(dtype=wp.vec3i)
    edge_w: wp.array(dtype=wp.float32)
    edge_p: wp.array2d(dtype=wp.float32)
    pair: wp.array(dtype=wp.vec2i)
    pair_margin: wp.array(dtype=wp.float32)
    pair_avoid: wp.array(dtype=wp.float32)  # 1 where neither should hide under the other
    pair_mode: wp.array(
        dtype=wp.int32
    )  # 0 proxies, 1 boxes, 2 SDF, 3 and 4 SDF with the box of a, b
    scene_node: wp.array(dtype=wp.int32)  # first node, unit, edge, pair of each scene, [scenes + 1]
    scene_unit: wp.array(dtype=wp.int32)
    scene_edge: wp.array(dtype=wp.int32)
    scene_pair: wp.array(dtype=wp.int32)


@wp.func
def turn(v: wp.vec2, a: float):
    c = wp.cos(a)
    s = wp.sin(a)
    return wp.vec2(c * v[0] - s * v[1], s * v[0] + c * v[1])


@wp.func
def compose(p: wp.vec3, q: wp.vec3):
    d = turn(wp.vec2(q[0], q[1]), p[2])
    return wp.vec3(p[0] + d[0], p[1] + d[1], p[2] + q[2])


@wp.func
def gap_in_frame(d: wp.vec2, ha: wp.vec2, hb: wp.vec2, rel: float):
    c = wp.abs(wp.cos(rel))
    s = wp.abs(wp.sin(rel))
    gx = wp.abs(d[0]) - ha[0] - hb[0] * c - hb[1] * s
    gy = wp.abs(d[1]) - ha[1] - hb[0] * s - hb[1] * c
    if gx > 0.0 and gy > 0.0:
        return wp.sqrt(gx * gx + gy * gy)
    return wp.max(gx, gy)


@wp.func
def separation(ka: int, pa: wp.vec3, ha: wp.vec2, kb: int, pb: wp.vec3, hb: wp.vec2):
    """Signed planar distance of two footprints [cm]; negative is the penetration depth."""
    d = wp.vec2(pb[0] - pa[0], pb[1] - pa[1])
    if ka == 0 and kb == 0:
        return wp.length(d) - ha[0] - hb[0]
    if ka == 1 and kb == 1:
        ga = gap_in_frame(turn(d, -pa[2]), ha, hb, pb[2] - pa[2])
        gb = gap_in_frame(turn(d, -pb[2]), hb, ha, pb[2] - pa[2])
        return wp.max(ga, gb)
    q = turn(d, -pa[2])
    h = ha
    r = hb[0]
    if ka == 0:
        q = turn(d, -pb[2])
        h = hb
        r = ha[0]
    qx = wp.abs(q[0]) - h[0]
    qy = wp.abs(q[1]) - h[1]
    if qx > 0.0 and qy > 0.0:
        return wp.sqrt(qx * qx + qy * qy) - r
    return wp.max(qx, qy) - r


@wp.func
def world_half(p: Problem, node: int, yaw: float):
    h = p.node_half[node]
    if p.node_round[node] == 1:
        return h
    c = wp.abs(wp.cos(yaw))
    s = wp.abs(wp.sin(yaw))
    return wp.vec2(h[0] * c + h[1] * s, h[0] * s + h[1] * c)


@wp.func
def surface_distance(p: Problem, a: int, b: int, pa: wp.vec3, pb: wp.vec3):
    d = separation(1 - p.node_round[a], pa, p.node_half[a], 1 - p.node_round[b], pb, p.node_half[b])
    zg = wp.max(
        p.node_z[a] - p.node_z[b] - p.node_height[b], p.node_z[b] - p.node_z[a] - p.node_height[a]
    )
    if zg > 0.0:
        return wp.sqrt(wp.max(d, 0.0) * wp.max(d, 0.0) + zg * zg)
    return d


@wp.func
def relu(v: float):
    return wp.max(v, 0.0)


@wp.func
def smooth(v: float):
    """Quadratic below 1 cm and linear above, so that gradients fade out at the optimum."""
    if v < 1.0:
        return 0.5 * v * v
    return v - 0.5


@wp.func
def edge_energy(p: Problem, w: wp.array(dtype=wp.vec3), off: int, e: int, soft: float):
    kind = p.edge_kind[e]
    n = p.edge_node[e]
    a = n[0]
    b = n[1]
    pa = w[a + off]
    if (
        kind == E_REGION
    ):  # rectangle p0..p3 = min x, min y, max x, max y in b's frame holds a's footprint
        q = wp.vec2(pa[0], pa[1])
        yaw = pa[2]
        if b >= 0:
            pb = w[b + off]
            q = turn(wp.vec2(pa[0] - pb[0], pa[1] - pb[1]), -pb[2])
            yaw = pa[2] - pb[2]
        h = world_half(p, a, yaw)
        vx = relu(p.edge_p[e, 0] - q[0] + h[0]) + relu(q[0] + h[0] - p.edge_p[e, 2])
        vy = relu(p.edge_p[e, 1] - q[1] + h[1]) + relu(q[1] + h[1] - p.edge_p[e, 3])
        return REGION_WEIGHT * (vx * vx + vy * vy + smooth(vx) + smooth(vy)) * p.edge_w[e]
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
    elif (
        kind == E_DIRECTION
    ):  # axis p0, sign p1, extra range p2, lateral tolerance p3, scale p4, least gap p5
        ha = world_half(p, a, pa[2])
        hb = world_half(p, b, pb[2])
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
