"""Warp kernels of the layout search: one thread is one start of one scene.

`initialize` places units in order by sampled candidates, `refine` runs the whole Adam descent of a
start, so that one scene with sixteen starts and ten thousand scenes with one are the same two calls.
"""

# ruff: noqa: E501, RUF046, SIM108, SIM109, UP018  (Warp needs plain statements and int())
from __future__ import annotations

import warp as wp

from esg.layout.energy import (
    E_BAND,
    E_BETWEEN,
    E_CENTER,
    E_DIRECTION,
    E_FACE,
    E_LERP,
    E_REGION,
    E_SLOT,
    E_UNDER,
    PI,
    Problem,
    compose,
    relu,
    separation,
    spread,
    total_energy,
    turn,
    unit_energy,
    world_half,
)

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
        n = p.edge_node[i]
        kd = p.edge_kind[i]
        if kd != E_REGION and kd != E_FACE and n[1] >= 0:
            ua = p.node_unit[n[0]]
            ub = p.node_unit[n[1]]
            uc = int(-1)
            if n[2] >= 0:
                uc = p.node_unit[n[2]]
            if (ua == u and ub < u and uc < u) or (ub == u and ua < u and uc < 0):
                seen += 1.0
                if wp.randf(rng) * seen <= 1.0:
                    chosen = i
                    mine = int(1)
                    if ub == u:
                        mine = 0
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
        # turn to what the unit must face
        for j in range(p.ue_off[u], p.ue_off[u + 1]):
            i = p.ue[j]
            n = p.edge_node[i]
            if p.edge_kind[i] == E_FACE and p.node_unit[n[0]] == u:
                rel = p.node_rel[n[0]]
                if p.edge_p[i, 0] > 0.5:
                    yaw = p.edge_p[i, 1] - parent[2] - rel[2]
                elif p.node_unit[n[1]] < u:
                    here = compose(parent, compose(wp.vec3(x[0], x[1], yaw), rel))
                    pt = w[n[1] + off]
                    yaw = wp.atan2(pt[1] - here[1], pt[0] - here[0]) - parent[2] - rel[2]
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
        count = s.candidates
        fr = p.unit_free[u]
        if s.sample == 0 or fr[0] + fr[1] + fr[2] < 0.5:
            count = int(1)
        for k in range(count):
            c = propose(p, w, off, u, k, s, rng)
            if s.sample == 0:
                box = p.unit_box[u]
                cx = c[0]
                cy = c[1]
                mid = turn(p.unit_center[u], c[2])
                if fr[0] > 0.5:
                    cx = box[0] + box[2] * (wp.randf(rng) * 2.0 - 1.0) - mid[0]
                if fr[1] > 0.5:
                    cy = box[1] + box[3] * (wp.randf(rng) * 2.0 - 1.0) - mid[1]
                c = project(p, wp.vec3(cx, cy, c[2]), u)
            # reading rng in propose advances a copy only: move this one on
            rng = wp.rand_init(thread_seed[t] * 7919 + 13, (u - u0) * 1024 + k + 1)
            e = float(0.0)
            if count > 1:
                x[u + uoff] = c
                spread(p, w, x, off, uoff, u, u)
                e = unit_energy(p, w, off, u, u, s.soft)
                a = p.unit_anchor[u]
                mid = turn(p.unit_center[u], c[2])
                dx = c[0] + mid[0] - a[0]
                dy = c[1] + mid[1] - a[1]
                e += s.preference * (
                    a[2] * wp.sqrt(dx * dx + dy * dy)
                    + a[3] * (1.0 - wp.cos(c[2] - p.unit_pose[u][2]))
                )
                e += s.preference * 20.0 * hiding(p, w, off, u)
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
                        e = unit_energy(p, w, off, u, last, s.soft)
                        if k == 0:
                            if e < 1.0e-6:
                                probes = int(1)
                        else:
                            g[axis] = g[axis] + 0.5 * e / h
                x[u + uoff] = x0
                spread(p, w, x, off, uoff, u, last)
                grad[u + uoff] = g
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
            for u in range(u0, u1):
                spread(p, w, x, off, uoff, u, last)
    for u in range(u0, u1):
        x[u + uoff] = best[u + uoff]
    steps[t] = used


@wp.kernel
def separations(
    kind: wp.array(dtype=wp.vec2i),
    pa: wp.array(dtype=wp.vec3),
    pb: wp.array(dtype=wp.vec3),
    ha: wp.array(dtype=wp.vec2),
    hb: wp.array(dtype=wp.vec2),
    out: wp.array(dtype=wp.float32),
):
    """Signed distances of footprint pairs [cm], shape [n]."""
    i = wp.tid()
    k = kind[i]
    out[i] = separation(k[0], pa[i], ha[i], k[1], pb[i], hb[i])


@wp.kernel
def evaluate(
    p: Problem,
    soft: float,
    x: wp.array(dtype=wp.vec3),
    w: wp.array(dtype=wp.vec3),
    energy: wp.array(dtype=wp.vec3),
):
    """Relation, collision and region energy of one layout per scene: x [units], energy [scenes]."""
    scene = wp.tid()
    for u in range(p.scene_unit[scene], p.scene_unit[scene + 1]):
        spread(p, w, x, 0, 0, u, 1 << 30)
    energy[scene] = total_energy(p, w, 0, scene, soft)
