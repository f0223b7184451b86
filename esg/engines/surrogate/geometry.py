"""Contact points between two shapes and between a shape and the ground, as Warp functions.

Spheres and the ground use Newton's closed forms. All other pairs of convex shapes use the
narrow phase of Newton itself (portal refinement, distance by GJK, manifold of up to five points),
so that the surrogate and the reference engine see the same contacts. Newton keeps these functions
in a private module; the version is pinned and `tests/engines/test_surrogate_geometry.py` measures
what they must return.
"""

from __future__ import annotations

# Kernels are typed by Warp's compiler, in a language of its own.
# pyright: basic, reportGeneralTypeIssues=false, reportInvalidTypeForm=false
# pyright: reportArgumentType=false, reportCallIssue=false, reportIndexIssue=false
# pyright: reportOperatorIssue=false, reportReturnType=false, reportAssignmentType=false
from newton import GeoType
from newton._src.geometry.collision_convex import create_solve_convex_multi_contact
from newton._src.geometry.contact_data import ContactData
from newton._src.geometry.support_function import (
    GenericShapeData,
    SupportMapDataProvider,
    support_map,
    unpack_mesh_ptr,
)
from newton.geometry import (
    collide_capsule_capsule,
    collide_plane_box,
    collide_plane_cylinder,
    collide_sphere_box,
    collide_sphere_capsule,
    collide_sphere_cylinder,
    collide_sphere_sphere,
)
import warp as wp

from esg.engines.surrogate.types import Model, Raw

wp.set_module_options({"enable_backward": False})

SPHERE = wp.constant(int(GeoType.SPHERE))
BOX = wp.constant(int(GeoType.BOX))
CAPSULE = wp.constant(int(GeoType.CAPSULE))
CYLINDER = wp.constant(int(GeoType.CYLINDER))
CONVEX = wp.constant(int(GeoType.CONVEX_MESH))

POINTS = 8
"""Most contact points of one pair of shapes."""
_FAR = wp.constant(1.0e5)
ROUNDING_M = wp.constant(1.0e-6)


@wp.func
def _write(contact: ContactData, raw: Raw, index: int):
    add_point(
        raw,
        contact.contact_point_center,
        contact.contact_normal_a_to_b,
        contact.contact_distance,
    )


@wp.func
def _as_is(
    contact: ContactData,
    geom_a: GenericShapeData,
    position_a: wp.vec3,
    orientation_a: wp.quat,
    geom_b: GenericShapeData,
    position_b: wp.vec3,
    orientation_b: wp.quat,
):
    return contact


_solve_convex = create_solve_convex_multi_contact(support_map, _write, _as_is)


@wp.func
def add_point(raw: Raw, point: wp.vec3, normal: wp.vec3, distance: float):
    """Appends a point half way between two surfaces; the normal leads from first to second."""
    w = raw.world
    k = raw.count[w]
    if k < POINTS and distance < _FAR:
        raw.point[w, k] = point
        raw.normal[w, k] = normal
        raw.distance[w, k] = distance
        raw.count[w] = k + 1


@wp.func
def _shape_data(model: Model, s: int) -> GenericShapeData:
    out = GenericShapeData()
    out.shape_type = model.kind[s]
    out.scale = model.scale[s]
    out.auxiliary = model.mesh[s]
    out.center = wp.vec3(0.0, 0.0, 0.0)
    out.bounds_half = model.half[s]
    out.shape_index = -1
    return out


@wp.func
def _axis(r: wp.quat) -> wp.vec3:
    return wp.quat_rotate(r, wp.vec3(0.0, 0.0, 1.0))


@wp.func
def _sphere_and(
    model: Model, raw: Raw, s: int, xs: wp.vec3, q: int, xq: wp.vec3, rq: wp.quat, sign: float
):
    """Sphere `s` against the analytic shape `q`; `sign` -1 turns the normal of swapped shapes."""
    radius = model.scale[s][0]
    size = model.scale[q]
    kind = model.kind[q]
    distance = float(1.0e6)  # noqa: UP018  # a variable to Warp, not a constant
    point = wp.vec3()
    normal = wp.vec3()
    if kind == SPHERE:
        distance, point, normal = collide_sphere_sphere(xs, radius, xq, size[0])
    elif kind == BOX:
        distance, point, normal = collide_sphere_box(xs, radius, xq, wp.quat_to_matrix(rq), size)
    elif kind == CAPSULE:
        distance, point, normal = collide_sphere_capsule(
            xs, radius, xq, _axis(rq), size[0], size[1]
        )
    else:
        distance, point, normal = collide_sphere_cylinder(
            xs, radius, xq, _axis(rq), size[0], size[1]
        )
    add_point(raw, point, sign * normal, distance)


@wp.func
def near(
    model: Model,
    s: int,
    xs: wp.vec3,
    rs: wp.quat,
    q: int,
    xq: wp.vec3,
    rq: wp.quat,
    margin: float,
) -> bool:
    """Whether the bounds of two shapes are closer than `margin`."""
    offset = xq - xs
    reach = model.radius[s] + model.radius[q] + margin
    if wp.length_sq(offset) > reach * reach:
        return False
    # Separating axes of the two boxes' faces; no box reaches farther than the sphere around it.
    half_s = model.half[s]
    half_q = model.half[q]
    turn = wp.quat_to_matrix(wp.quat_inverse(rs) * rq)
    in_s = wp.quat_rotate_inv(rs, offset)
    for k in range(3):
        wide = (
            wp.abs(turn[k, 0]) * half_q[0]
            + wp.abs(turn[k, 1]) * half_q[1]
            + wp.abs(turn[k, 2]) * half_q[2]
        )
        if wp.abs(in_s[k]) > half_s[k] + wp.min(wide, model.radius[q]) + margin + ROUNDING_M:
            return False
    in_q = wp.quat_rotate_inv(rq, offset)
    for k in range(3):
        wide = (
            wp.abs(turn[0, k]) * half_s[0]
            + wp.abs(turn[1, k]) * half_s[1]
            + wp.abs(turn[2, k]) * half_s[2]
        )
        if wp.abs(in_q[k]) > half_q[k] + wp.min(wide, model.radius[s]) + margin + ROUNDING_M:
            return False
    return True


@wp.func
def collide_shapes(
    model: Model,
    raw: Raw,
    s: int,
    xs: wp.vec3,
    rs: wp.quat,
    q: int,
    xq: wp.vec3,
    rq: wp.quat,
    margin: float,
):
    """Fills `raw` with the contact points of two shapes closer than `margin`."""
    raw.count[raw.world] = 0
    a = model.kind[s]
    b = model.kind[q]
    if a == SPHERE and b != CONVEX:
        _sphere_and(model, raw, s, xs, q, xq, rq, 1.0)
    elif b == SPHERE and a != CONVEX:
        _sphere_and(model, raw, q, xq, s, xs, rs, -1.0)
    elif a == CAPSULE and b == CAPSULE:
        one = model.scale[s]
        two = model.scale[q]
        distances, points, normal = collide_capsule_capsule(
            xs, _axis(rs), one[0], one[1], xq, _axis(rq), two[0], two[1]
        )
        for k in range(2):
            add_point(raw, points[k], normal, distances[k])
    else:
        none = SupportMapDataProvider()
        template = ContactData()
        template.margin_a = 0.0
        template.margin_b = 0.0
        _solve_convex(
            _shape_data(model, s),
            _shape_data(model, q),
            rs,
            rq,
            xs,
            xq,
            none,
            margin,
            False,
            raw,
            template,
        )


@wp.func
def collide_ground(model: Model, raw: Raw, s: int, x: wp.vec3, r: wp.quat, margin: float):
    """Fills `raw` with the points of a shape closer to z = 0 than `margin`; normals point down."""
    raw.count[raw.world] = 0
    kind = model.kind[s]
    size = model.scale[s]
    up = wp.vec3(0.0, 0.0, 1.0)
    origin = wp.vec3(0.0, 0.0, 0.0)
    if kind == SPHERE:
        gap = x[2] - size[0]
        add_point(raw, wp.vec3(x[0], x[1], 0.5 * gap), -up, gap)
    elif kind == BOX:
        box_gaps, box_points, _n = collide_plane_box(
            up, origin, x, wp.quat_to_matrix(r), size, margin
        )
        for k in range(4):
            add_point(raw, wp.vec3(box_points[k, 0], box_points[k, 1], box_points[k, 2]), -up,
                      box_gaps[k])  # fmt: skip
    elif kind == CAPSULE:
        for k in range(2):
            end = x + _axis(r) * (size[1] * (2.0 * float(k) - 1.0))
            gap = end[2] - size[0]
            add_point(raw, wp.vec3(end[0], end[1], 0.5 * gap), -up, gap)
    elif kind == CYLINDER:
        gaps, points, _m = collide_plane_cylinder(up, origin, x, _axis(r), size[0], size[1])
        for k in range(4):
            add_point(raw, wp.vec3(points[k, 0], points[k, 1], points[k, 2]), -up, gaps[k])
    else:
        mesh = wp.mesh_get(unpack_mesh_ptr(model.mesh[s]))
        for k in range(mesh.points.shape[0]):
            p = x + wp.quat_rotate(r, mesh.points[k])
            if p[2] < margin:
                add_point(raw, wp.vec3(p[0], p[1], 0.5 * p[2]), -up, p[2])
