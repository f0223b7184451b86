"""What the program's numbers mean inside kernels, as Warp functions (`esg.engines.program`)."""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
import warp as wp

from esg.engines.program import Column


@wp.func
def vector(table: wp.array3d(dtype=wp.float64), w: int, k: int, column: int) -> wp.vec3:
    """Three numbers of a primitive, from a column on."""
    return wp.vec3(
        float(table[w, k, column]), float(table[w, k, column + 1]), float(table[w, k, column + 2])
    )


@wp.func
def held_velocity(
    table: wp.array3d(dtype=wp.float64), w: int, k: int, t: wp.float64, vertical: float, pull: float
) -> wp.vec3:
    """Velocity that a hold asks for before the step from time `t`.

    `vertical` is what the body has, and `pull` what gravity adds to it in the step.
    """
    s = t - table[w, k, Column.START]
    acceleration = table[w, k, Column.ACCELERATION]
    speed = wp.max(wp.float64(0.0), table[w, k, Column.SPEED] + acceleration * s)
    if acceleration > wp.float64(0.0):
        speed = wp.min(speed, table[w, k, Column.MAX_SPEED])
    heading = table[w, k, Column.HEADING] + table[w, k, Column.TURN_RATE] * s
    up = float(vertical)
    if not wp.isnan(table[w, k, Column.CLIMB]):
        up = float(table[w, k, Column.CLIMB]) - pull
    return wp.vec3(float(speed * wp.cos(heading)), float(speed * wp.sin(heading)), up)


@wp.func
def held_spin(table: wp.array3d(dtype=wp.float64), w: int, k: int, v: wp.vec3) -> wp.vec3:
    """Angular velocity that goes with the velocity of a hold: what rolls does not slip."""
    radius = float(table[w, k, Column.ROLL_RADIUS])
    if radius != 0.0 and wp.isnan(table[w, k, Column.CLIMB]):
        return wp.vec3(-v[1] / radius, v[0] / radius, 0.0)
    return wp.vec3(0.0, 0.0, float(table[w, k, Column.TURN_RATE]))
