# Answer of an unnamed frontier model, 2026-11-23, to the request S3-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car move towards a jeep and collide with it after 3 seconds.
"""

FPS = 8
HIT_SECONDS = 3


@register()
def wheel_pair(x: float, radius: float, half_width: float) -> Shape:
    return loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': radius,
        'p0': (x, radius, (2 * i - 1) * half_width - 0.1),
        'p1': (x, radius, (2 * i - 1) * half_width + 0.1)}, color=(0.1, 0.1, 0.1)))


@register()
def car() -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3, 0.5, 1.4)}, color=(0.9, 0.2, 0.1)), translation_matrix((0, 0.55, 0)))
    top_y = compute_shape_max(body)[1]
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.45, 1.2)}, color=(0.95, 0.4, 0.3)), translation_matrix((-0.1, top_y + 0.225, 0)))
    windows = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.6, 0.3, 1.24)}, color=(0.7, 0.9, 1)),
        translation_matrix((-0.45 + 0.7 * i, top_y + 0.22, 0))))
    return concat_shapes(body, cabin, windows,
                         library_call('wheel_pair', x=-0.9, radius=0.3, half_width=0.7),
                         library_call('wheel_pair', x=0.9, radius=0.3, half_width=0.7))


@register()
def jeep() -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3, 0.8, 1.6)}, color=(0.2, 0.4, 0.2)), translation_matrix((0, 0.9, 0)))
    top_y = compute_shape_max(body)[1]
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.9, 0.7, 1.5)}, color=(0.15, 0.3, 0.15)), translation_matrix((0.45, top_y + 0.35, 0)))
    windows = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.7, 0.4, 1.54)}, color=(0.7, 0.9, 1)),
        translation_matrix((0.05 + 0.85 * i, top_y + 0.38, 0))))
    rack = loop(3, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.08, 0.08, 1.5)}, color=(0.05, 0.05, 0.05)),
        translation_matrix((-0.2 + 0.65 * i, top_y + 0.74, 0))))
    spare = primitive_call('cylinder', shape_kwargs={'radius': 0.4, 'p0': (1.5, 1.1, 0), 'p1': (1.7, 1.1, 0)}, color=(0.1, 0.1, 0.1))
    return concat_shapes(body, cabin, windows, rack, spare,
                         library_call('wheel_pair', x=-0.95, radius=0.45, half_width=0.8),
                         library_call('wheel_pair', x=0.95, radius=0.45, half_width=0.8))


@register()
def road() -> Shape:
    return concat_shapes(
        transform_shape(primitive_call('cube', shape_kwargs={'scale': (24, 0.1, 4)}, color=(0.35, 0.35, 0.35)), translation_matrix((-1, -0.05, 0))),
        loop(8, lambda i: transform_shape(
            primitive_call('cube', shape_kwargs={'scale': (1.2, 0.01, 0.1)}, color=(1, 1, 1)),
            translation_matrix((-12 + 3 * i, 0.01, 0)))))


@register()
def sparks(age: int) -> Shape:
    return loop(10, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.08}, color=(1, 0.8 - 0.05 * i, 0.1)),
        translation_matrix((0.18 * age * math.cos(i * 0.63), 0.8 + 0.2 * age * abs(math.sin(i * 1.3)) - 0.02 * age * age, 0.18 * age * math.sin(i * 0.63)))))


@register_animation()
def car_hits_jeep() -> Generator[Shape, None, None]:
    car_shape, jeep_shape = library_call('car'), library_call('jeep')
    jeep_x = 3.0
    end_x = jeep_x + compute_shape_min(jeep_shape)[0] - compute_shape_max(car_shape)[0]
    start_x = end_x - 9.0
    hit_frame = FPS * HIT_SECONDS
    for frame in range(hit_frame + 14):
        if frame <= hit_frame:
            car_pose = translation_matrix((start_x + 9.0 * frame / hit_frame, 0, 0))
            jeep_pose = translation_matrix((jeep_x, 0, 0))
            extra = []
        else:
            n = frame - hit_frame
            s = 1 - 0.8 ** n
            tilt = 0.15 * 0.75 ** n * min(1, n / 2)
            car_pose = translation_matrix((end_x - 0.5 * s, 0, 0)) @ rotation_matrix(-tilt, (0, 0, 1), (0.9, 0, 0))
            jeep_pose = translation_matrix((jeep_x + 1.4 * s, 0, 0)) @ rotation_matrix(-0.25 * s, (0, 1, 0), (0.95, 0, 0)) @ rotation_matrix(-tilt, (0, 0, 1), (0.95, 0, 0))
            extra = transform_shape(library_call('sparks', age=n), translation_matrix((end_x + 1.5, 0, 0))) if n < 8 else []
        yield concat_shapes(library_call('road'), transform_shape(car_shape, car_pose), transform_shape(jeep_shape, jeep_pose), extra)
