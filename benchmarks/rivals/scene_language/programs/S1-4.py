# Answer of an unnamed frontier model, 2026-11-23, to the request S1-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A bowling ball rolls toward a set of bowling pins and hits them.
"""


@register()
def pin() -> Shape:
    base = primitive_call('cylinder', shape_kwargs={'radius': 0.12, 'p0': (0, 0, 0), 'p1': (0, 0.45, 0)}, color=(0.95, 0.95, 0.95))
    band = primitive_call('cylinder', shape_kwargs={'radius': 0.075, 'p0': (0, 0.45, 0), 'p1': (0, 0.6, 0)}, color=(0.8, 0, 0))
    head = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.1}, color=(0.95, 0.95, 0.95)), translation_matrix((0, 0.68, 0)))
    return concat_shapes(base, band, head)


@register()
def pin_triangle(falls) -> Shape:
    """falls: function (row, col) -> pose applied to a pin standing at the origin"""
    return loop(4, lambda r: loop(r + 1, lambda c: transform_shape(library_call('pin'), falls(r, c))))


@register()
def bowling_ball(roll: float) -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': 0.32}, color=(0.0, 0.35, 0.3))
    holes = loop(3, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.05}, color=(0, 0, 0)),
        translation_matrix((0.08 * (i - 1), 0.07 * (i % 2), 0.3))))
    return transform_shape(concat_shapes(ball, holes), rotation_matrix(roll, (1, 0, 0), (0, 0, 0)))


@register()
def room() -> Shape:
    lane = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.4, 0.1, 13)}, color=(0.8, 0.62, 0.38)), translation_matrix((0, -0.05, -1)))
    pit = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.2, 1.8, 0.1)}, color=(0.12, 0.12, 0.15)), translation_matrix((0, 0.8, -7.5)))
    sign = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.2, 0.4, 0.12)}, color=(0.2, 0.4, 0.9)), translation_matrix((0, 1.9, -7.5)))
    return concat_shapes(lane, pit, sign)


def falling_pose(r, c, t):
    x0, z0 = (c - r / 2) * 0.5, -4.0 - 0.43 * r
    tau = max(0.0, t - 0.09 * r)
    vx = 1.6 * (c - r / 2) + (0.25 if (r + c) % 2 else -0.25)
    vz = -2.2 + 0.3 * r
    vy = 1.6 - 0.25 * r
    land = 2 * vy / 9.8
    friction = 1 - math.exp(-1.8 * tau)
    y = max(0.0, vy * tau - 4.9 * tau * tau)
    tip = min(math.pi / 2, tau * (math.pi / 2) / (land + 0.2))
    heading = math.atan2(vx, -vz)
    tilt = rotation_matrix(-tip, (1, 0, 0), (0, 0, 0))
    yaw = rotation_matrix(-heading, (0, 1, 0), (0, 0, 0))
    y = y + 0.12 * math.sin(tip)
    return translation_matrix((x0 + vx * friction / 1.8, y, z0 + vz * friction / 1.8)) @ yaw @ tilt


@register_animation()
def bowling_scene() -> Generator[Shape, None, None]:
    fps, seconds, v = 20, 3.5, 4.8
    contact_z = -4.0 + 0.44
    start_z = 4.5
    contact_t = (start_z - contact_z) / v
    for frame in range(int(fps * seconds)):
        t = frame / fps
        after = max(0.0, t - contact_t)
        z = start_z - v * min(t, contact_t) - 0.65 * v * after
        z = max(z, -7.1)
        ball = library_call('bowling_ball', roll=-(start_z - z) / 0.32)
        ball = transform_shape(ball, translation_matrix((0, -compute_shape_min(ball)[1], z)))
        pins = library_call('pin_triangle', falls=lambda r, c: falling_pose(r, c, after))
        yield concat_shapes(library_call('room'), pins, ball)
