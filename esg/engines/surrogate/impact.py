"""What a contact asks for, as differentiable Warp functions of the poses and velocities."""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.surrogate.features import Features, Normal
from esg.engines.surrogate.types import Model

wp.set_module_options({"enable_backward": True})

_RESTITUTION_THRESHOLD = wp.constant(0.2)
_SLOP = wp.constant(0.0005)
_PUSH = wp.constant(0.1)
_PUSH_MPS = wp.constant(0.5)


@wp.func
def turned(inertia: wp.mat33, r: wp.quat) -> wp.mat33:
    m = wp.quat_to_matrix(r)
    return m @ inertia @ wp.transpose(m)


@wp.func
def tangent(n: wp.vec3) -> wp.vec3:
    steep = wp.abs(n[0]) > 0.7
    t = wp.where(steep, wp.vec3(n[1], -n[0], 0.0), wp.vec3(0.0, -n[2], n[1]))
    return wp.normalize(t)


@wp.func
def _yields(mass: float, inverse: wp.mat33, arm: wp.vec3, n: wp.vec3) -> float:
    c = wp.cross(arm, n)
    return 1.0 / mass + wp.dot(c, inverse @ c)


@wp.func
def ahead_of(r: wp.quat, turn: wp.vec3) -> wp.quat:
    """An orientation after a small turn."""
    angle2 = wp.dot(turn, turn)
    half = float(0.5)  # noqa: UP018
    cosine = float(1.0)  # noqa: UP018
    if angle2 > 1.0e-12:
        angle = wp.sqrt(angle2)
        half = wp.sin(0.5 * angle) / angle
        cosine = wp.cos(0.5 * angle)
    return wp.normalize(wp.quat(turn[0] * half, turn[1] * half, turn[2] * half, cosine) * r)


@wp.func
def _measure(feat: Features, c: int, xa: wp.vec3, ra: wp.quat, xb: wp.vec3, rb: wp.quat) -> wp.vec4:
    """Normal and gap of a contact at two poses."""
    at_a = xa + wp.quat_rotate(ra, feat.core_a[c])
    at_b = xb + wp.quat_rotate(rb, feat.core_b[c])
    radius = feat.radius[c]
    n = feat.normal[c]
    if feat.mode[c] == Normal.BETWEEN:
        line = wp.quat_rotate(rb, feat.along[c])
        across = at_a - at_b
        n = wp.normalize(across - line * wp.dot(line, across))
    elif feat.mode[c] == Normal.FROZEN_IN_A:
        n = wp.quat_rotate(ra, feat.normal[c])
    elif feat.body_b[c] >= 0:
        n = wp.quat_rotate(rb, feat.normal[c])
    gap = wp.dot(n, at_a - at_b) - radius[0] - radius[1]
    return wp.vec4(n[0], n[1], n[2], gap)


@wp.func
def prepare(
    model: Model,
    feat: Features,
    w: int,
    c: int,
    a: int,
    b: int,
    va: int,
    vb: int,
    pa: int,
    pb: int,
    dt: float,
    V: wp.array(dtype=wp.vec3),
    O: wp.array(dtype=wp.vec3),  # noqa: E741
    X: wp.array(dtype=wp.vec3),
    R: wp.array(dtype=wp.quat),
    inverse: wp.array(dtype=wp.mat33),
    normal: wp.array(dtype=wp.vec3),
    arm_a: wp.array(dtype=wp.vec3),
    arm_b: wp.array(dtype=wp.vec3),
    wanted: wp.array(dtype=float),
    delay: wp.array(dtype=float),
    share: wp.array(dtype=wp.vec3),
):
    # Contacts that hit within the step are measured where they touch. When that is follows from the
    # gap at the moment the rollout found, which is nearly zero, and the speed of closing.
    early = feat.early[c]
    era = ahead_of(R[pa], O[va] * early)
    erb = ahead_of(R[pb], O[vb] * early)
    before = _measure(feat, c, X[pa] + V[va] * early, era, X[pb] + V[vb] * early, erb)
    closing = wp.vec3(before[0], before[1], before[2])
    first = wp.quat_rotate(era, feat.core_a[c])
    other = wp.quat_rotate(erb, feat.core_b[c])
    u0 = V[va] + wp.cross(O[va], first) - V[vb] - wp.cross(O[vb], other)
    ahead = feat.early[c]
    if feat.early[c] > 0.0 and feat.delay[c] > 0.0:
        ahead = early - before[3] / wp.min(wp.dot(closing, u0), -0.1)
    ra = ahead_of(R[pa], O[va] * ahead)
    rb = ahead_of(R[pb], O[vb] * ahead)
    found = _measure(feat, c, X[pa] + V[va] * ahead, ra, X[pb] + V[vb] * ahead, rb)
    n = wp.vec3(found[0], found[1], found[2])
    gap = found[3]
    radius = feat.radius[c]
    one = wp.quat_rotate(ra, feat.core_a[c]) - n * radius[0]
    two = wp.quat_rotate(rb, feat.core_b[c]) + n * radius[1]
    restitution = model.restitution[w, feat.body_a[c]]
    if feat.body_b[c] >= 0:
        restitution = 0.5 * (restitution + model.restitution[w, feat.body_b[c]])
    else:
        restitution = 0.5 * (restitution + model.ground[w][2])
    u = V[va] + wp.cross(O[va], one) - V[vb] - wp.cross(O[vb], two)
    approach = wp.dot(n, u)
    normal[c] = n
    arm_a[c] = one
    arm_b[c] = two
    if feat.delay[c] > 0.0:
        late = ahead - gap / approach
        # What is hit later has been accelerated for longer: zero, but for its derivative.
        pace = feat.speeding[c]
        gained = V[pace[0]] - V[pace[1]] - V[pace[2]] + V[pace[3]]
        more = wp.dot(n, gained) * ((late - feat.delay[c]) / dt)
        wanted[c] = -restitution * approach - (1.0 + restitution) * more
        delay[c] = late
    elif approach < -_RESTITUTION_THRESHOLD and gap + approach * (dt - ahead) < 0.0:
        push = wp.min(_PUSH * wp.max(-gap - _SLOP, 0.0) / dt, _PUSH_MPS)
        wanted[c] = wp.max(-restitution * approach, push)
    elif gap < 0.0:
        wanted[c] = wp.min(_PUSH * wp.max(-gap - _SLOP, 0.0) / dt, _PUSH_MPS)
    else:
        wanted[c] = -gap / dt
    t1 = tangent(n)
    t2 = wp.cross(n, t1)
    if a >= 0 and b >= 0:
        share[c] = wp.vec3(
            1.0 / (_yields(model.mass[w, a], inverse[pa], one, n)
                   + _yields(model.mass[w, b], inverse[pb], two, n)),
            1.0 / (_yields(model.mass[w, a], inverse[pa], one, t1)
                   + _yields(model.mass[w, b], inverse[pb], two, t1)),
            1.0 / (_yields(model.mass[w, a], inverse[pa], one, t2)
                   + _yields(model.mass[w, b], inverse[pb], two, t2)),
        )  # fmt: skip
    elif a >= 0:
        share[c] = wp.vec3(
            1.0 / _yields(model.mass[w, a], inverse[pa], one, n),
            1.0 / _yields(model.mass[w, a], inverse[pa], one, t1),
            1.0 / _yields(model.mass[w, a], inverse[pa], one, t2),
        )
    else:
        share[c] = wp.vec3(
            1.0 / _yields(model.mass[w, b], inverse[pb], two, n),
            1.0 / _yields(model.mass[w, b], inverse[pb], two, t1),
            1.0 / _yields(model.mass[w, b], inverse[pb], two, t2),
        )
