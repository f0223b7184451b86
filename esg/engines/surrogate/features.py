"""Where contacts sit on their bodies, so that the replay can follow them, as Warp functions.

A contact is described by a core point on each body and a radius around it (a sphere's centre, a
cylinder's axis, a box's corner), and by how its normal follows the bodies.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
from enum import IntEnum

import warp as wp

from esg.engines.surrogate.geometry import BOX, CAPSULE, CYLINDER, SPHERE
from esg.engines.surrogate.types import Contacts, Model

wp.set_module_options({"enable_backward": False})


class Normal(IntEnum):
    """How a contact's normal follows the bodies: it turns with one, or leads from core to core."""

    FROZEN_IN_B = 0
    FROZEN_IN_A = 1
    BETWEEN = 2


_FACE = wp.constant(0.9995)
_SIDE = wp.constant(0.003)
_EDGE = wp.constant(0.001)


@wp.struct
class Features:
    """Where used contacts sit on their bodies, flat; world w starts at first[w]."""

    first: wp.array(dtype=int)
    world: wp.array(dtype=int)
    step: wp.array(dtype=int)
    body_a: wp.array(dtype=int)
    body_b: wp.array(dtype=int)
    mode: wp.array(dtype=int)
    """`Normal`."""
    core_a: wp.array(dtype=wp.vec3)
    core_b: wp.array(dtype=wp.vec3)
    radius: wp.array(dtype=wp.vec2)
    normal: wp.array(dtype=wp.vec3)
    along: wp.array(dtype=wp.vec3)
    """With `Normal.BETWEEN`, a line (in b's frame) along which the cores slide freely, or zero."""
    friction: wp.array(dtype=float)
    delay: wp.array(dtype=float)
    early: wp.array(dtype=float)
    speeding: wp.array(dtype=wp.vec4i)
    """Velocity versions of a at this and the last step, then of b: their acceleration."""


@wp.func
def _feature(model: Model, s: int, point: wp.vec3, n: wp.vec3):
    """Core point, radius, whether a flat face touches, and the line along which the core may slide.

    `point` and `n` are in the shape's frame. The line is a cylinder's or capsule's axis or a box's
    edge; it is zero for points.
    """
    kind = model.kind[s]
    size = model.scale[s]
    core = point
    along = wp.vec3(0.0, 0.0, 0.0)
    radius = float(0.0)  # noqa: UP018
    face = int(0)  # noqa: RUF046, UP018  # a variable to Warp
    if kind == SPHERE:
        core = wp.vec3(0.0, 0.0, 0.0)
        radius = size[0]
    elif kind == CAPSULE:
        core = wp.vec3(0.0, 0.0, wp.clamp(point[2], -size[1], size[1]))
        radius = size[0]
        if wp.abs(point[2]) < size[1]:
            along = wp.vec3(0.0, 0.0, 1.0)
    elif kind == CYLINDER:
        if wp.abs(n[2]) > _FACE:
            face = 1
        elif wp.abs(n[2]) < _SIDE:
            core = wp.vec3(0.0, 0.0, point[2])
            radius = size[0]
            along = wp.vec3(0.0, 0.0, 1.0)
    elif kind == BOX:
        if wp.max(wp.abs(n[0]), wp.max(wp.abs(n[1]), wp.abs(n[2]))) > _FACE:
            face = 1
        else:
            for k in range(3):
                # Across an edge the normal has no part along it.
                if wp.abs(n[k]) < _EDGE:
                    along[k] = 1.0
    return core, radius, face, along


@wp.func
def describe(
    model: Model,
    con: Contacts,
    feat: Features,
    w: int,
    slot: int,
    c: int,
    step: int,
):
    a = con.a[w, slot]
    b = con.b[w, slot]
    n = con.normal[w, slot]
    feat.world[c] = w
    feat.step[c] = step
    feat.body_a[c] = a
    feat.body_b[c] = b
    feat.friction[c] = con.friction[w, slot]
    feat.delay[c] = con.delay[w, slot]
    feat.early[c] = con.early[w, slot]
    sa = con.shape_a[w, slot]
    ra = con.turn_a[w, slot]
    frame = ra * model.rotation[sa]
    local = wp.quat_rotate_inv(ra, con.arm_a[w, slot]) - model.position[sa]
    point = wp.quat_rotate_inv(model.rotation[sa], local)
    core, radius_a, face_a, line_a = _feature(model, sa, point, wp.quat_rotate_inv(frame, n))
    along = wp.quat_rotate(frame, line_a)
    feat.core_a[c] = model.position[sa] + wp.quat_rotate(model.rotation[sa], core)
    mode = int(Normal.FROZEN_IN_B)
    normal = n
    radius_b = float(0.0)  # noqa: UP018
    if b < 0:
        feat.core_b[c] = con.arm_b[w, slot]
    else:
        sb = con.shape_b[w, slot]
        rb = con.turn_b[w, slot]
        frame_b = rb * model.rotation[sb]
        local_b = wp.quat_rotate_inv(rb, con.arm_b[w, slot]) - model.position[sb]
        point_b = wp.quat_rotate_inv(model.rotation[sb], local_b)
        core_b, r_b, face_b, line_b = _feature(model, sb, point_b, wp.quat_rotate_inv(frame_b, n))
        radius_b = r_b
        feat.core_b[c] = model.position[sb] + wp.quat_rotate(model.rotation[sb], core_b)
        normal = wp.quat_rotate_inv(rb, n)
        if face_b == 0 and face_a == 1:
            mode = int(Normal.FROZEN_IN_A)
            normal = wp.quat_rotate_inv(ra, n)
        elif face_b == 0 and radius_a + radius_b > 0.0:
            mode = int(Normal.BETWEEN)
            # Of two lines only one can be followed; parallel ones are the common case.
            if wp.length_sq(line_b) > 0.0:
                along = wp.quat_rotate(frame_b, line_b)
            along = wp.quat_rotate_inv(rb, along)
    feat.along[c] = along
    feat.mode[c] = mode
    feat.radius[c] = wp.vec2(radius_a, radius_b)
    feat.normal[c] = normal
