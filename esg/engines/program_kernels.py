"""What the program's numbers mean inside kernels, as Warp functions (`esg.engines.program`)."""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.program import GUIDE_RATE, KNOT_FIELDS, Column
from esg.engines.traction import (
    BLOW_MPS,
    FALLING,
    LEAST_LEAN_RAD_S,
    LEAST_TILT,
    ON_WHEELS,
    Feature,
)

_RATE, _WIDTH = wp.constant(GUIDE_RATE), wp.constant(KNOT_FIELDS)
_FALLING, _ON_WHEELS = wp.constant(FALLING), wp.constant(ON_WHEELS)
_BLOW = wp.constant(BLOW_MPS)
_LEAST_LEAN, _LEAST_TILT = wp.constant(LEAST_LEAN_RAD_S), wp.constant(LEAST_TILT)


@wp.func
def vector(table: wp.array3d(dtype=wp.float64), w: int, k: int, column: int) -> wp.vec3:
    """Three numbers of a primitive, from a column on."""
    return wp.vec3(
        float(table[w, k, column]), float(table[w, k, column + 1]), float(table[w, k, column + 2])
    )


@wp.func
def approached(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    speed: float,
    heading: float,
    v: wp.vec3,
    dt: float,
) -> wp.vec3:
    """Horizontal velocity that a hold gives what moves at `v`, nearer to what it asks for."""
    gains = float(table[w, k, Column.GAINS]) * dt
    loses = float(table[w, k, Column.LOSES]) * dt
    ahead = wp.vec3(wp.cos(heading), wp.sin(heading), 0.0)
    aside = wp.vec3(-ahead[1], ahead[0], 0.0)
    before = heading - float(table[w, k, Column.TURN_RATE]) * dt
    along = wp.cos(before) * v[0] + wp.sin(before) * v[1]
    across = wp.cos(before) * v[1] - wp.sin(before) * v[0]
    along = along + wp.clamp(speed - along, -loses, gains)
    across = across - wp.clamp(across, -loses, loses)
    return ahead * along + aside * across


@wp.func
def held_velocity(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    t: wp.float64,
    dt: wp.float64,
    v: wp.vec3,
    pull: float,
) -> wp.vec3:
    """Velocity that a hold asks for before the step from time `t`.

    `v` is what the body has, and `pull` what gravity adds to it in the step.
    """
    s = t - table[w, k, Column.START]
    acceleration = table[w, k, Column.ACCELERATION]
    speed = wp.max(wp.float64(0.0), table[w, k, Column.SPEED] + acceleration * s)
    if acceleration > wp.float64(0.0):
        speed = wp.min(speed, table[w, k, Column.MAX_SPEED])
    heading = table[w, k, Column.HEADING] + table[w, k, Column.TURN_RATE] * s
    up = float(v[2])
    if not wp.isnan(table[w, k, Column.CLIMB]):
        up = float(table[w, k, Column.CLIMB]) - pull
    if not wp.isnan(table[w, k, Column.GAINS]):
        near = approached(table, w, k, float(speed), float(heading), v, float(dt))
        return wp.vec3(near[0], near[1], up)
    return wp.vec3(float(speed * wp.cos(heading)), float(speed * wp.sin(heading)), up)


@wp.func
def held_spin(table: wp.array3d(dtype=wp.float64), w: int, k: int, v: wp.vec3) -> wp.vec3:
    """Angular velocity that goes with the velocity of a hold: what rolls does not slip."""
    radius = float(table[w, k, Column.ROLL_RADIUS])
    if radius != 0.0 and wp.isnan(table[w, k, Column.CLIMB]):
        return wp.vec3(-v[1] / radius, v[0] / radius, 0.0)
    return wp.vec3(0.0, 0.0, float(table[w, k, Column.TURN_RATE]))


@wp.func
def falls(before: float, rise: float, pull: float) -> bool:
    """Whether nothing carries a body, which is not said of NaN `before` the first step.

    `before` is the vertical velocity it began the last step with, `rise` the one it has, `pull`
    what gravity adds in a step.
    """
    return before - rise > -_FALLING * pull


@wp.func
def grounded(
    features: wp.array2d(dtype=float),
    i: int,
    loss: float,
    weight: float,
    v: wp.vec3,
    o: wp.vec3,
    turn: wp.quat,
) -> wp.spatial_vector:
    """Velocities of body `i` of `features` after brakes and tyres (`esg.engines.traction`).

    `loss` is what the brakes take at most, `weight` what gravity gives in a step times the factor
    on friction [m/s].
    """
    up = wp.quat_rotate(turn, wp.vec3(0.0, 0.0, 1.0))
    level = wp.vec3(v[0], v[1], 0.0)
    if features[i, Feature.DROP] > 0.0 and up[2] > _ON_WHEELS:
        ahead = wp.quat_rotate(turn, wp.vec3(1.0, 0.0, 0.0))
        f = wp.normalize(wp.vec3(ahead[0], ahead[1], 0.0))
        level = f * wp.dot(f, v)
    speed = wp.sqrt(level[0] * level[0] + level[1] * level[1])
    taken = wp.min(loss, speed)
    slow = v
    spin = o
    if taken > 0.0:
        lost = taken / speed
        slow = v - level * lost
        if features[i, Feature.ROUND] > 0.0:
            spin = wp.vec3(o[0] * (1.0 - lost), o[1] * (1.0 - lost), o[2])
    limit = features[i, Feature.GRIP] * weight
    if limit <= taken or up[2] <= _ON_WHEELS:
        return wp.spatial_vector(slow, spin)
    if taken > 0.0:
        limit = wp.sqrt(limit * limit - taken * taken)
    return _gripped(features, i, limit, slow, spin, turn)


@wp.func
def struck(before: wp.vec3, v: wp.vec3) -> bool:
    """Whether a blow has changed a horizontal velocity; not said of NaN `before` the first step."""
    return wp.length(wp.vec2(v[0] - before[0], v[1] - before[1])) > _BLOW


@wp.func
def tipped(
    features: wp.array2d(dtype=float), i: int, v: wp.vec3, o: wp.vec3, turn: wp.quat
) -> wp.spatial_vector:
    """Velocities of body `i` that has lost its balance (`esg.engines.traction.tipped`)."""
    up = wp.quat_rotate(turn, wp.vec3(0.0, 0.0, 1.0))
    ahead = wp.quat_rotate(turn, wp.vec3(1.0, 0.0, 0.0))
    f = wp.normalize(wp.vec3(ahead[0], ahead[1], 0.0))
    lean = wp.dot(f, o)
    more = features[i, Feature.TIP]
    foot = features[i, Feature.FOOT]
    if up[2] <= _ON_WHEELS or wp.abs(lean) >= more:
        return wp.spatial_vector(v, o)
    left = f[1] * up[0] - f[0] * up[1] < -_LEAST_TILT
    if wp.abs(lean) > _LEAST_LEAN:
        left = lean < 0.0
    if left:
        more = -more
        foot = -foot
    more = more - lean
    arm = wp.quat_rotate(turn, wp.vec3(0.0, foot, features[i, Feature.DROP]))
    return wp.spatial_vector(v + wp.cross(f, arm) * more, o + f * more)


@wp.func
def _gripped(
    features: wp.array2d(dtype=float), i: int, limit: float, v: wp.vec3, o: wp.vec3, turn: wp.quat
) -> wp.spatial_vector:
    axle = features[i, Feature.AXLE]
    ahead = wp.quat_rotate(turn, wp.vec3(1.0, 0.0, 0.0))
    up = wp.quat_rotate(turn, wp.vec3(0.0, 0.0, 1.0))
    f = wp.normalize(wp.vec3(ahead[0], ahead[1], 0.0))
    s = wp.vec3(-f[1], f[0], 0.0)
    height = features[i, Feature.DROP] * up[2] + features[i, Feature.FOOT] * wp.abs(wp.dot(s, up))
    lean = features[i, Feature.LEAN] * height
    slip = (wp.dot(s, v) + height * wp.dot(f, o)) / (1.0 + height * lean)
    yaw = axle * o[2]
    front = wp.clamp(slip + yaw, -limit, limit)
    rear = wp.clamp(slip - yaw, -limit, limit)
    side = 0.5 * (front + rear)
    back = wp.vec3(0.0, 0.0, 0.5 * (front - rear) / axle)
    return wp.spatial_vector(v - s * side, o - f * (lean * side) - back)


@wp.func
def path_knot(table: wp.array3d(dtype=wp.float64), w: int, k: int, s: wp.float64) -> int:
    """The point of a guided path from which the piece at time `s` starts; -1 before the first."""
    count = int(table[w, k, Column.KNOTS])
    found = int(-1)  # noqa: RUF046, UP018  # a variable to Warp
    for j in range(count):
        if table[w, k, Column.KNOT + _WIDTH * j] < s:
            found = j
    return found


@wp.func
def _knot_vector(table: wp.array3d(dtype=wp.float64), w: int, k: int, column: int) -> wp.vec3d:
    return wp.vec3d(table[w, k, column], table[w, k, column + 1], table[w, k, column + 2])


@wp.func
def path_point(
    table: wp.array3d(dtype=wp.float64), w: int, k: int, j: int, s: wp.float64
) -> wp.vec3d:
    """A guided path at time `s` [m], in the piece that starts at point j (`path_knot`)."""
    one = Column.KNOT + _WIDTH * wp.max(j, 0)
    p = _knot_vector(table, w, k, one + 1)
    v = _knot_vector(table, w, k, one + 4)
    late = s - table[w, k, one]
    if j < 0 or j + 1 >= int(table[w, k, Column.KNOTS]):
        return p + v * late
    two = one + _WIDTH
    h = table[w, k, two] - table[w, k, one]
    u = late / h
    a = u * u * (wp.float64(3.0) - wp.float64(2.0) * u)
    b = h * u * (wp.float64(1.0) - u)
    q = _knot_vector(table, w, k, two + 1)
    out = p + (q - p) * a + v * (b * (wp.float64(1.0) - u))
    return out - _knot_vector(table, w, k, two + 4) * (b * u)


@wp.func
def path_velocity(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    here: int,
    there: int,
    s: wp.float64,
    dt: wp.float64,
) -> wp.vec3:
    """Mean velocity along a guided path from time `s` on [m/s].

    `here` and `there` are the pieces at s and at s + dt.
    """
    v = (path_point(table, w, k, there, s + dt) - path_point(table, w, k, here, s)) / dt
    return wp.vec3(float(v[0]), float(v[1]), float(v[2]))


@wp.func
def guided_velocity(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    here: int,
    there: int,
    s: wp.float64,
    dt: wp.float64,
    x: wp.vec3,
) -> wp.vec3:
    """Velocity of a guided body at `x` once gravity has acted, `s` after the start of its path."""
    p = path_point(table, w, k, here, s)
    lag = wp.vec3(float(p[0]), float(p[1]), float(p[2])) - x
    return path_velocity(table, w, k, here, there, s, dt) + lag * _RATE


@wp.func
def guide(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    t: wp.float64,
    dt: wp.float64,
    x: wp.vec3,
    pull: float,
) -> wp.vec3:
    """Velocity that a guide asks for before the step from time `t`, against the pull of gravity."""
    s = t - table[w, k, Column.START]
    here = path_knot(table, w, k, s)
    there = path_knot(table, w, k, s + dt)
    return guided_velocity(table, w, k, here, there, s, dt, x) - wp.vec3(0.0, 0.0, pull)


@wp.func
def buoyed(
    table: wp.array3d(dtype=wp.float64),
    w: int,
    k: int,
    dt: float,
    x: wp.vec3,
    turn: wp.quat,
    v: wp.vec3,
    o: wp.vec3,
) -> wp.spatial_vector:
    """Velocities of a body that a liquid bears up (`esg.engines.program.buoyed`)."""
    heading = float(table[w, k, Column.BASIN_HEADING])
    off = x - vector(table, w, k, Column.LEVEL)
    basin = vector(table, w, k, Column.BASIN)
    extents = vector(table, w, k, Column.EXTENTS)
    along = wp.abs(wp.cos(heading) * off[0] + wp.sin(heading) * off[1])
    across = wp.abs(wp.cos(heading) * off[1] - wp.sin(heading) * off[0])
    up = wp.quat_rotate_inv(turn, wp.vec3(0.0, 0.0, 1.0))
    half = wp.abs(up[0]) * extents[0] + wp.abs(up[1]) * extents[1] + wp.abs(up[2]) * extents[2]
    share = wp.min(1.0, 0.5 * (half - off[2]) / half)
    if along > basin[0] or across > basin[1] or share <= 0.0 or off[2] < -2.0 * basin[2]:
        return wp.spatial_vector(v, o)
    if table[w, k, Column.ROUND] > wp.float64(0.0):
        share = share * share * (3.0 - 2.0 * share)
    wet = share * dt
    quadratic = float(table[w, k, Column.QUADRATIC_DRAG]) * wp.length(v)
    kept = 1.0 / (1.0 + wet * (float(table[w, k, Column.LINEAR_DRAG]) + quadratic))
    turned = 1.0 / (1.0 + wet * float(table[w, k, Column.TURNING_DRAG]))
    lifted = v * kept + wp.vec3(0.0, 0.0, wet * float(table[w, k, Column.LIFT]))
    return wp.spatial_vector(lifted, o * turned)
