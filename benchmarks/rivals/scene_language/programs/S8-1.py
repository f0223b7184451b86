# Answer of an unnamed frontier model, 2026-11-23, to the request S8-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A black car is moving at 10 m/s down the road. The driver starts braking, letting the car to stop in 2~3 seconds.
"""


@register()
def car() -> Shape:
    body = primitive_call('cube', shape_kwargs={'scale': (4, 0.8, 1.8)}, color=(0, 0, 0))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2, 0.7, 1.6)}, color=(0.1, 0.1, 0.1)), translation_matrix([0, 0.75, 0]))
    wheels = loop(4, lambda i: transform_shape(
        library_call('wheel'),
        translation_matrix([-1.3 if i % 2 == 0 else 1.3, -0.4, -0.9 if i < 2 else 0.9])))
    return concat_shapes(body, cabin, wheels)


@register()
def wheel() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.4, 'p0': (0, 0, -0.15), 'p1': (0, 0, 0.15)}, color=(0.2, 0.2, 0.2))


@register()
def road() -> Shape:
    surface = primitive_call('cube', shape_kwargs={'scale': (60, 0.1, 6)}, color=(0.5, 0.5, 0.5))
    lines = loop(15, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (2, 0.02, 0.2)}, color=(1, 1, 0)),
        translation_matrix([-28 + 4 * i, 0.06, 0])))
    return concat_shapes(surface, lines)


@register_animation()
def car_braking_animation() -> Generator[Shape, None, None]:
    initial_speed = 10.0
    stop_time = 2.5
    total_frames = 30
    acceleration = -initial_speed / stop_time

    car = library_call('car')
    road = transform_shape(library_call('road'), translation_matrix([0, compute_shape_min(car)[1] - 0.05, 0]))

    for frame in range(total_frames):
        t = stop_time * frame / (total_frames - 1)
        car_x = -6.0 + initial_speed * t + 0.5 * acceleration * t ** 2
        yield concat_shapes(road, transform_shape(car, translation_matrix([car_x, 0, 0])))
