"""Warp functions that propose poses: candidates of one unit, and the way back into its region."""

# Warp reads annotations and operators as its own language.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportOperatorIssue=false

# ruff: noqa: RUF046, SIM108, SIM109, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.kernels.energy import (
    E_BAND,
    E_BETWEEN,
    E_CENTER,
    E_DIRECTION,
    E_FACE,
    E_LERP,
    E_REGION,
    E_SLOT,
    E_UNDER,
    spread,
    unit_energy,
)
from esg.layout.kernels.planar import PI, Problem, compose, relu, separation, turn, world_half

# no adjoint code (gradients are central differences) and no unrolling: both only cost compile time
wp.set_module_options({"enable_backward": False, "max_unroll": 1})


@wp.struct
class Settings:
    candidates: wp.int32
    iterations: wp.int32
    sample: wp.int32
    preference: wp.float32
    tolerance: wp.float32  # relative decrease over 20 steps below which a start is finished
    soft: wp.float32  # weight of what makes directional relations tidy


@wp.func
def hiding(p: Problem, w: wp.array(dtype=wp.vec3), off: int, u: int):
    """How deep footprints reach under or over those of units placed before [cm]."""
    e = float(0.0)
    for k in range(p.up_off[u], p.up_off[u + 1]):
        i = p.up[k]
        n = p.pair[i]
        if p.pair_avoid[i] > 0.0 and p.node_unit[n[0]] <= u and p.node_unit[n[1]] <= u:
            a = n[0]
            b = n[1]
            d = separation(
                1 - p.node_round[a],
                w[a + off],
                p.node_half[a],
                1 - p.node_round[b],
                w[b + off],
                p.node_half[b],
            )
            e += relu(-d)
    return e


@wp.func
def project(p: Problem, x: wp.vec3, u: int):
    """Shifts a unit into the regions of its own nodes that are given in its parent's frame."""
    low = wp.vec2(-1.0e9, -1.0e9)
    high = wp.vec2(1.0e9, 1.0e9)
    for k in range(p.ue_off[u], p.ue_off[u + 1]):
        i = p.ue[k]
        if p.edge_kind[i] == E_REGION:
            n = p.edge_node[i]
            if p.node_unit[n[0]] == u and n[1] == p.unit_parent[u]:
                q = compose(x, p.node_rel[n[0]])
                h = world_half(p, n[0], q[2])
                low = wp.vec2(
                    wp.max(low[0], p.edge_p[i, 0] + h[0] - q[0]),
                    wp.max(low[1], p.edge_p[i, 1] + h[1] - q[1]),
                )
                high = wp.vec2(
                    wp.min(high[0], p.edge_p[i, 2] - h[0] - q[0]),
                    wp.min(high[1], p.edge_p[i, 3] - h[1] - q[1]),
                )
    f = p.unit_free[u]
    sx = wp.clamp(0.0, low[0], high[0])
    sy = wp.clamp(0.0, low[1], high[1])
    if low[0] > high[0]:
        sx = 0.5 * (low[0] + high[0])
    if low[1] > high[1]:
        sy = 0.5 * (low[1] + high[1])
    return wp.vec3(x[0] + sx * f[0], x[1] + sy * f[1], x[2])


@wp.func
def reach_along(p: Problem, n: int, yaw: float, dir: wp.vec2):
    h = p.node_half[n]
    if p.node_round[n] == 1:
        return h[0]
    q = turn(dir, -yaw)
    # distance from the centre to the rectangle's edge along the ray
    return wp.min(h[0] / wp.max(wp.abs(q[0]), 1.0e-3), h[1] / wp.max(wp.abs(q[1]), 1.0e-3))


@wp.func
def propose_point(
    p: Problem, w: wp.array(dtype=wp.vec3), off: int, e: int, first: int, yaw: float, rng: wp.uint32
):
    """A world position for the edge's first (or second) node that tends to satisfy the edge."""
    kind = p.edge_kind[e]
    n = p.edge_node[e]
    me = n[0]
    other = n[1]
    if first == 0:
        me = n[1]
        other = n[0]
    po = w[other + off]
    base = wp.vec2(po[0], po[1])
    out = base
    if kind == E_BAND:
        a = wp.randf(rng) * 2.0 * PI
        if wp.randf(rng) < 0.5:
            a = wp.floor(wp.randf(rng) * 4.0) * 0.5 * PI + po[2]
        dir = wp.vec2(wp.cos(a), wp.sin(a))
        high = wp.min(p.edge_p[e, 1], p.edge_p[e, 0] + 300.0)
        gap = p.edge_p[e, 0] + (high - p.edge_p[e, 0]) * wp.randf(rng)
        out = base + dir * (reach_along(p, other, po[2], dir) + reach_along(p, me, yaw, dir) + gap)
    elif kind == E_DIRECTION:
        ha = world_half(p, me, yaw)
        hb = world_half(p, other, po[2])
        s = p.edge_p[e, 1]
        if first == 0:
            s = -s
        ahead = wp.randf(rng)
        ahead = ahead * ahead * p.edge_p[e, 2]
        lat = (wp.randf(rng) * 2.0 - 1.0) * p.edge_p[e, 3]
        if wp.randf(rng) < 0.4:
            lat = 0.0
        if p.edge_p[e, 0] < 0.5:
            out = base + wp.vec2(s * (ha[0] + hb[0] + p.edge_p[e, 5] + ahead), lat)
        else:
            out = base + wp.vec2(lat, s * (ha[1] + hb[1] + p.edge_p[e, 5] + ahead))
    elif kind == E_CENTER or kind == E_SLOT:
        t = turn(wp.vec2(p.edge_p[e, 1], p.edge_p[e, 2]), po[2])
        if first == 1:
            out = base + t
        else:
            out = base - t
    elif kind == E_UNDER:
        h = p.node_half[n[1]]
        q = wp.vec2((wp.randf(rng) * 2.0 - 1.0) * h[0], (wp.randf(rng) * 2.0 - 1.0) * h[1])
        out = base + turn(q, po[2])
    elif kind == E_BETWEEN or kind == E_LERP:
        pc = w[n[2] + off]
        frac = p.edge_p[e, 1]
        out = wp.vec2(po[0] + frac * (pc[0] - po[0]), po[1] + frac * (pc[1] - po[1]))
    return out


@wp.func
def role_in(p: Problem, i: int, u: int):
    """Whether edge i can place unit u: 1 by its first node, 0 by its second, -1 not at all."""
    n = p.edge_node[i]
    kind = p.edge_kind[i]
    role = int(-1)
    if kind != E_REGION and kind != E_FACE and n[1] >= 0:
        ua = p.node_unit[n[0]]
        ub = p.node_unit[n[1]]
        uc = int(-1)
        if n[2] >= 0:
            uc = p.node_unit[n[2]]
        if ua == u and ub < u and uc < u:
            role = int(1)
        elif ub == u and ua < u and uc < 0:
            role = int(0)
    return role


@wp.func
def turned_to(
    p: Problem,
    w: wp.array(dtype=wp.vec3),
    off: int,
    u: int,
    parent: wp.vec3,
    x: wp.vec2,
    yaw: float,
):
    """The yaw at which unit u faces what it must, if it stands at x; `yaw` if it need not."""
    out = yaw
    for j in range(p.ue_off[u], p.ue_off[u + 1]):
        i = p.ue[j]
        n = p.edge_node[i]
        if p.edge_kind[i] == E_FACE and p.node_unit[n[0]] == u:
            rel = p.node_rel[n[0]]
            if p.edge_p[i, 0] > 0.5:
                out = p.edge_p[i, 1] - parent[2] - rel[2]
            elif p.node_unit[n[1]] < u:
                here = compose(parent, compose(wp.vec3(x[0], x[1], out), rel))
                pt = w[n[1] + off]
                out = wp.atan2(pt[1] - here[1], pt[0] - here[0]) - parent[2] - rel[2]
    return out


@wp.func
def propose(
    p: Problem, w: wp.array(dtype=wp.vec3), off: int, u: int, k: int, s: Settings, rng: wp.uint32
):
    """A candidate pose of unit u in its parent's frame."""
    free = p.unit_free[u]
    pref = p.unit_pose[u]
    box = p.unit_box[u]
    parent = wp.vec3(0.0, 0.0, 0.0)
    if p.unit_parent[u] >= 0:
        parent = w[p.unit_parent[u] + off]
    yaw = pref[2]
    if free[2] > 0.5:
        r = wp.randf(rng)
        if r > 0.6 and k > 0:
            yaw = pref[2] + wp.floor(wp.randf(rng) * 4.0) * 0.5 * PI
        if r > 0.92 and k > 0:
            yaw = wp.randf(rng) * 2.0 * PI
    x = wp.vec2(
        box[0] + box[2] * (wp.randf(rng) * 2.0 - 1.0), box[1] + box[3] * (wp.randf(rng) * 2.0 - 1.0)
    )
    # one usable edge chosen uniformly (reservoir of size one)
    chosen = int(-1)
    seen = float(0.0)
    mine = int(1)
    for j in range(p.ue_off[u], p.ue_off[u + 1]):
        i = p.ue[j]
        role = role_in(p, i, u)
        if role >= 0:
            seen += 1.0
            if wp.randf(rng) * seen <= 1.0:
                chosen = i
                mine = role
    if chosen >= 0 and wp.randf(rng) >= 0.8:
        chosen = int(-1)
    if chosen >= 0:
        n = p.edge_node[chosen]
        me = n[0]
        if mine == 0:
            me = n[1]
        rel = p.node_rel[me]
        t = propose_point(p, w, off, chosen, mine, parent[2] + yaw + rel[2], rng)
        q = turn(wp.vec2(t[0] - parent[0], t[1] - parent[1]), -parent[2])
        x = q - turn(wp.vec2(rel[0], rel[1]), yaw)
    elif k == 0:
        a = p.unit_anchor[u]
        x = wp.vec2(a[0], a[1])
    if free[2] > 0.5 and wp.randf(rng) < 0.85:
        yaw = turned_to(p, w, off, u, parent, x, yaw)
    if chosen < 0:
        x = x - turn(p.unit_center[u], yaw)
    out = wp.vec3(x[0], x[1], yaw)
    if free[0] < 0.5:
        out = wp.vec3(pref[0], out[1], out[2])
    if free[1] < 0.5:
        out = wp.vec3(out[0], pref[1], out[2])
    if free[2] < 0.5:
        out = wp.vec3(out[0], out[1], pref[2])
    return project(p, out, u)


@wp.func
def candidate(
    p: Problem, w: wp.array(dtype=wp.vec3), off: int, u: int, k: int, s: Settings, rng: wp.uint32
):
    """Candidate k of unit u: proposed, or anywhere in its box without sampling initialization."""
    c = propose(p, w, off, u, k, s, rng)
    if s.sample == 0:
        fr = p.unit_free[u]
        box = p.unit_box[u]
        cx = c[0]
        cy = c[1]
        mid = turn(p.unit_center[u], c[2])
        if fr[0] > 0.5:
            cx = box[0] + box[2] * (wp.randf(rng) * 2.0 - 1.0) - mid[0]
        if fr[1] > 0.5:
            cy = box[1] + box[3] * (wp.randf(rng) * 2.0 - 1.0) - mid[1]
        c = project(p, wp.vec3(cx, cy, c[2]), u)
    return c


@wp.func
def candidate_energy(
    p: Problem,
    w: wp.array(dtype=wp.vec3),
    x: wp.array(dtype=wp.vec3),
    off: int,
    uoff: int,
    u: int,
    c: wp.vec3,
    s: Settings,
):
    """Energy that unit u adds at pose c to the units before it, and its preference."""
    x[u + uoff] = c
    spread(p, w, x, off, uoff, u, u)
    e = unit_energy(p, w, off, u, u, s.soft)
    a = p.unit_anchor[u]
    mid = turn(p.unit_center[u], c[2])
    dx = c[0] + mid[0] - a[0]
    dy = c[1] + mid[1] - a[1]
    e += s.preference * (
        a[2] * wp.sqrt(dx * dx + dy * dy) + a[3] * (1.0 - wp.cos(c[2] - p.unit_pose[u][2]))
    )
    e += s.preference * 20.0 * hiding(p, w, off, u)
    return e


@wp.func
def candidate_count(p: Problem, u: int, s: Settings):
    """One for a fixed unit and without sampling initialization."""
    fr = p.unit_free[u]
    if s.sample == 0 or fr[0] + fr[1] + fr[2] < 0.5:
        return 1
    return s.candidates
