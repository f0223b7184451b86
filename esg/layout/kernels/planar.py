"""The batch as the kernels see it, and planar geometry: poses, separations, footprints.

Arrays of all scenes of a batch are concatenated; node, unit, edge and pair indices are global.
"""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

from __future__ import annotations

import warp as wp

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})

TOUCH_CM = wp.constant(0.2)
"""Vertical overlap below which two shapes only touch (an object and its support)."""
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
