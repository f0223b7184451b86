"""The surrogate's kernel for bodies that collide by voxel signed distance fields, in Warp.

Some bodies carry a field and samples of their surface. Two of them touch where the samples of one
lie in the field of the other, both ways; the normal is the field's gradient. The nearest sample of
every octant of a body is kept, so that a face rests on more than one point. A ball meets a field
with its centre. All other pairs, and everything else of a step (program, impulses, motion), are
those of `kernels`.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.surrogate.contacts import (
    GAP_M,
    _add_contacts,
    _bodies_near,
    _first_touch,
    _margin,
    _place,
    facing,
    meet,
    meet_ground,
)
from esg.engines.surrogate.kernels import make_roll
from esg.engines.surrogate.types import Contacts, Fields, Model, Raw, State

wp.set_module_options({"enable_backward": False})

SLOTS = 16
"""Contact points of one pair: the octants of one body, then those of the other."""
SLACK_M = wp.constant(0.002)
"""Of the points of a pair those are kept that are this much farther than the nearest."""
_FAR = wp.constant(1.0e4)


@wp.func
def distance(fields: Fields, f: int, p: wp.vec3, enough: float) -> float:
    """Distance of a point in the body's frame; only a lower bound if it exceeds `enough`."""
    size = fields.cell[f]
    u = (p - fields.origin[f]) / size - wp.vec3(0.5, 0.5, 0.5)
    last = float(fields.n - 1)
    inner = wp.vec3(wp.clamp(u[0], 0.0, last), wp.clamp(u[1], 0.0, last), wp.clamp(u[2], 0.0, last))
    outside = wp.length(u - inner) * size
    if outside > enough:
        return outside
    i = wp.min(int(inner[0]), fields.n - 2)
    j = wp.min(int(inner[1]), fields.n - 2)
    k = wp.min(int(inner[2]), fields.n - 2)
    x = inner[0] - float(i)
    y = inner[1] - float(j)
    z = inner[2] - float(k)
    low = wp.lerp(
        wp.lerp(fields.values[f, i, j, k], fields.values[f, i + 1, j, k], x),
        wp.lerp(fields.values[f, i, j + 1, k], fields.values[f, i + 1, j + 1, k], x),
        y,
    )
    high = wp.lerp(
        wp.lerp(fields.values[f, i, j, k + 1], fields.values[f, i + 1, j, k + 1], x),
        wp.lerp(fields.values[f, i, j + 1, k + 1], fields.values[f, i + 1, j + 1, k + 1], x),
        y,
    )
    return wp.lerp(low, high, z) + outside


@wp.func
def outward(fields: Fields, f: int, p: wp.vec3) -> wp.vec3:
    """Direction in which the distance grows, by central differences over a cell."""
    h = 0.5 * fields.cell[f]
    g = wp.vec3()
    for k in range(3):
        e = wp.vec3()
        e[k] = h
        g[k] = distance(fields, f, p + e, _FAR) - distance(fields, f, p - e, _FAR)
    length = wp.length(g)
    if length < 1.0e-9:
        return wp.vec3(0.0, 0.0, 1.0)
    return g / length


@wp.func
def _octant(p: wp.vec3) -> int:
    out = int(0)  # noqa: RUF046, UP018  # a variable to Warp, not a constant
    for k in range(3):
        if p[k] > 0.0:
            out = out + (1 << k)
    return out


@wp.func
def _probe(
    fields: Fields,
    raw: Raw,
    fi: int,
    xi: wp.vec3,
    ri: wp.quat,
    fj: int,
    xj: wp.vec3,
    rj: wp.quat,
    margin: float,
    slot: int,
):
    """The nearest samples of field fi to field fj, octant by octant of fi, from `slot` on."""
    w = raw.world
    for s in range(fields.first[fi], fields.first[fi + 1]):
        local = fields.sample[s]
        p = xi + wp.quat_rotate(ri, local)
        d = distance(fields, fj, wp.quat_rotate_inv(rj, p - xj), margin)
        at = slot + _octant(local)
        if d < margin and d < raw.distance[w, at]:
            raw.distance[w, at] = d
            raw.point[w, at] = p


@wp.func
def collide_fields(
    fields: Fields,
    model: Model,
    raw: Raw,
    i: int,
    xi: wp.vec3,
    ri: wp.quat,
    j: int,
    xj: wp.vec3,
    rj: wp.quat,
    margin: float,
):
    """Fills `raw` with the contact points of two bodies, at least one of which has a field."""
    w = raw.world
    fi = fields.of_body[i]
    fj = fields.of_body[j]
    for k in range(SLOTS):
        raw.distance[w, k] = _FAR
    radius = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
    if fi >= 0 and fj >= 0:
        _probe(fields, raw, fi, xi, ri, fj, xj, rj, margin, 0)
        _probe(fields, raw, fj, xj, rj, fi, xi, ri, margin, 8)
    elif fi < 0:
        # A sphere is one sample with a radius around it.
        s = model.first[i]
        radius = model.scale[s][0]
        p = xi + wp.quat_rotate(ri, model.position[s])
        q = wp.quat_rotate_inv(rj, p - xj)
        raw.distance[w, 0] = distance(fields, fj, q, margin + radius) - radius
        raw.point[w, 0] = p
    else:
        s = model.first[j]
        radius = model.scale[s][0]
        p = xj + wp.quat_rotate(rj, model.position[s])
        q = wp.quat_rotate_inv(ri, p - xi)
        raw.distance[w, 8] = distance(fields, fi, q, margin + radius) - radius
        raw.point[w, 8] = p
    # Where an edge meets a round side, points beside it would bounce along their own normals.
    nearest = float(margin)
    for k in range(SLOTS):
        nearest = wp.min(nearest, raw.distance[w, k])
    limit = wp.min(margin, wp.max(nearest, 0.0) + SLACK_M)
    n = int(0)  # noqa: RUF046, UP018  # a variable to Warp, not a constant
    for k in range(SLOTS):
        gap = raw.distance[w, k]
        if gap < limit:
            p = raw.point[w, k]
            # Samples of i lie before j's surface and the other way round.
            up = wp.vec3()
            sign = float(-1.0)  # noqa: UP018
            if k < 8:
                up = wp.quat_rotate(rj, outward(fields, fj, wp.quat_rotate_inv(rj, p - xj)))
            else:
                up = wp.quat_rotate(ri, outward(fields, fi, wp.quat_rotate_inv(ri, p - xi)))
                sign = 1.0
            raw.point[w, n] = p - up * (radius + 0.5 * gap)
            raw.normal[w, n] = up * sign
            raw.distance[w, n] = gap
            n = n + 1
    raw.count[w] = n


@wp.func
def collide_field_ground(fields: Fields, raw: Raw, f: int, x: wp.vec3, r: wp.quat, margin: float):
    """Fills `raw` with the lowest samples of every octant closer to z = 0 than `margin`."""
    w = raw.world
    for k in range(8):
        raw.distance[w, k] = _FAR
    for s in range(fields.first[f], fields.first[f + 1]):
        local = fields.sample[s]
        p = x + wp.quat_rotate(r, local)
        at = _octant(local)
        if p[2] < margin and p[2] < raw.distance[w, at]:
            raw.distance[w, at] = p[2]
            raw.point[w, at] = p
    n = int(0)  # noqa: RUF046, UP018  # a variable to Warp, not a constant
    for k in range(8):
        gap = raw.distance[w, k]
        if gap < margin:
            p = raw.point[w, k]
            raw.point[w, n] = wp.vec3(p[0], p[1], 0.5 * gap)
            raw.normal[w, n] = wp.vec3(0.0, 0.0, -1.0)
            raw.distance[w, n] = gap
            n = n + 1
    raw.count[w] = n


@wp.func
def _pair_of_bodies(
    fields: Fields,
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    i: int,
    j: int,
    margin: float,
    dt: float,
):
    """Contacts of two bodies, measured at the moment of touch if they hit within the step."""
    early = float(0.0)  # noqa: UP018  # a variable to Warp, not a constant
    for attempt in range(2):
        collide_fields(
            fields, model, raw, i, _place(state, w, i, early), facing(state, w, i, early), j,
            _place(state, w, j, early), facing(state, w, j, early), margin,
        )  # fmt: skip
        if attempt == 0:
            early = _first_touch(state, raw, w, i, j, dt)
            if early <= 0.0:
                break
    _add_contacts(model, state, raw, con, w, step, i, j, 0, 0, margin, early, dt)


@wp.func
def _by_field(fields: Fields, i: int, j: int) -> bool:
    """Whether two bodies collide by their fields."""
    one = fields.of_body[i] >= 0
    two = fields.of_body[j] >= 0
    return (one and (two or fields.ball[j] != 0)) or (two and fields.ball[i] != 0)


@wp.func
def _find_contacts(
    all_fields: wp.array(dtype=Fields),
    scene: int,
    model: Model,
    state: State,
    raw: Raw,
    con: Contacts,
    w: int,
    step: int,
    dt: float,
):
    """Collects the contacts of the step that starts now, by fields where bodies have them."""
    fields = all_fields[scene]
    for i in range(model.n_bodies):
        state.before_v[w, i] = state.v[w, i]
        state.before_o[w, i] = state.o[w, i]
    con.count[w, wp.min(step, con.count.shape[1] - 1)] = 0
    for i in range(model.n_bodies):
        moves = model.dynamic[i] != 0 and state.awake[w, i] != 0
        if moves:
            fast = wp.length(state.v[w, i]) + wp.length(state.o[w, i]) * model.reach[i]
            near_ground = GAP_M + fast * dt
            if state.x[w, i][2] < model.reach[i] + near_ground:
                if fields.of_body[i] >= 0:
                    collide_field_ground(
                        fields, raw, fields.of_body[i], state.x[w, i], state.r[w, i], near_ground
                    )
                    _add_contacts(model, state, raw, con, w, step, i, -1, 0, -1, 0.0, 0.0, dt)
                else:
                    meet_ground(model, state, raw, con, w, step, i, near_ground, dt)
        for j in range(i + 1, model.n_bodies):
            other = model.dynamic[j] != 0 and state.awake[w, j] != 0
            if not moves and not other:
                continue
            if model.first[i] == model.first[i + 1] or model.first[j] == model.first[j + 1]:
                continue
            margin = _margin(model, state, w, i, j, dt)
            if not _bodies_near(model, state, w, i, j, margin):
                continue
            if _by_field(fields, i, j):
                _pair_of_bodies(fields, model, state, raw, con, w, step, i, j, margin, dt)
                continue
            meet(model, state, raw, con, w, step, i, j, margin, dt)


roll = make_roll(_find_contacts, __name__)
