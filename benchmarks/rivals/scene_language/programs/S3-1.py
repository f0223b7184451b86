# Answer of an unnamed frontier model, 2026-11-23, to the request S3-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car move towards a jeep and collide with it after 3 seconds.
"""


def block(scale, center, color):
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': scale}, color=color), translation_matrix(center))


def axle_wheels(xs, half_track, r):
    def one(i):
        x, z = xs[i % 2], half_track * (1 if i < 2 else -1)
        return concat_shapes(
            primitive_call('cylinder', shape_kwargs={'radius': r, 'p0': (x, r, z - 0.12), 'p1': (x, r, z + 0.12)}, color=(0.05, 0.05, 0.05)),
            primitive_call('cylinder', shape_kwargs={'radius': r * 0.45, 'p0': (x, r, z - 0.13), 'p1': (x, r, z + 0.13)}, color=(0.75, 0.75, 0.78)))
    return loop(4, one)


@register()
def sedan() -> Shape:
    blue = (0.1, 0.3, 0.85)
    return concat_shapes(
        block((4.0, 0.55, 1.7), (0, 0.65, 0), blue),
        block((2.0, 0.5, 1.5), (-0.2, 1.15, 0), (0.55, 0.7, 0.8)),
        block((1.9, 0.08, 1.52), (-0.2, 1.43, 0), blue),
        block((0.1, 0.18, 1.6), (2.02, 0.5, 0), (0.3, 0.3, 0.3)),
        block((0.05, 0.14, 0.35), (2.01, 0.78, 0.6), (1, 1, 0.7)),
        block((0.05, 0.14, 0.35), (2.01, 0.78, -0.6), (1, 1, 0.7)),
        block((0.05, 0.14, 0.35), (-2.01, 0.78, 0.6), (0.8, 0, 0)),
        block((0.05, 0.14, 0.35), (-2.01, 0.78, -0.6), (0.8, 0, 0)),
        axle_wheels((-1.3, 1.3), 0.8, 0.36))


@register()
def jeep() -> Shape:
    tan = (0.62, 0.52, 0.3)
    return concat_shapes(
        block((3.6, 0.75, 1.8), (0, 1.05, 0), tan),
        block((1.9, 0.8, 1.7), (-0.6, 1.8, 0), (0.35, 0.3, 0.2)),
        block((0.06, 0.6, 1.5), (0.38, 1.8, 0), (0.6, 0.75, 0.85)),
        block((0.12, 0.25, 1.9), (1.86, 0.8, 0), (0.2, 0.2, 0.2)),
        block((0.06, 0.1, 1.2), (-0.6, 2.25, 0.4), (0.1, 0.1, 0.1)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.45, 'p0': (-2.05, 1.3, 0), 'p1': (-1.8, 1.3, 0)}, color=(0.05, 0.05, 0.05)),
        axle_wheels((-1.15, 1.15), 0.9, 0.5))


@register()
def ground() -> Shape:
    grass = block((30, 0.1, 14), (0, -0.1, 0), (0.3, 0.55, 0.25))
    road = block((30, 0.1, 5), (0, -0.05, 0), (0.3, 0.3, 0.32))
    marks = loop(10, lambda i: block((1.4, 0.02, 0.15), (-13.5 + 3 * i, 0.01, 0), (0.95, 0.85, 0.2)))
    return concat_shapes(grass, road, marks)


@register()
def smoke(t: float) -> Shape:
    return loop(6, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.12 + 0.25 * min(t, 1.2)}, color=(0.6, 0.6, 0.6)),
        translation_matrix((0.4 * math.cos(i * 1.05) * (0.5 + t), 1.0 + t * (0.6 + 0.12 * i), 0.4 * math.sin(i * 1.05) * (0.5 + t)))))


@register_animation()
def crash() -> Generator[Shape, None, None]:
    fps = 10
    t_hit = 3.0
    sedan_shape = library_call('sedan')
    # the jeep faces the car
    jeep_shape = transform_shape(library_call('jeep'), rotation_matrix(math.pi, (0, 1, 0), (0, 0, 0)))
    jeep_x = 3.5
    jeep_front = jeep_x + compute_shape_min(jeep_shape)[0]
    sedan_hit_x = jeep_front - compute_shape_max(sedan_shape)[0]
    v = 3.6
    m_car, m_jeep, e = 1.2, 1.8, 0.25
    v_car = v * (m_car - e * m_jeep) / (m_car + m_jeep)
    v_jeep = v * m_car * (1 + e) / (m_car + m_jeep)
    for frame in range(50):
        t = frame / fps
        d = max(0.0, t - t_hit)
        glide = (1 - math.exp(-1.6 * d)) / 1.6
        car_x = sedan_hit_x + v * min(0.0, t - t_hit) + v_car * glide
        turn = 0.22 * (1 - math.exp(-2 * d))
        lift = 0.1 * math.exp(-4 * d) * math.sin(min(math.pi, 8 * d))
        car_pose = translation_matrix((car_x, 0, 0)) @ rotation_matrix(-turn * 0.5, (0, 1, 0), (0, 0, 0)) @ rotation_matrix(-lift, (0, 0, 1), (1.3, 0, 0))
        jeep_pose = translation_matrix((jeep_x + v_jeep * glide, 0, 0)) @ rotation_matrix(turn, (0, 1, 0), (0, 0, 0)) @ rotation_matrix(-lift, (0, 0, 1), (1.15, 0, 0))
        frame_shape = concat_shapes(library_call('ground'), transform_shape(sedan_shape, car_pose), transform_shape(jeep_shape, jeep_pose))
        if d > 0:
            frame_shape = concat_shapes(frame_shape, transform_shape(library_call('smoke', t=d), translation_matrix((jeep_front + v_car * glide, 0, 0))))
        yield frame_shape
