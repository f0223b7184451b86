# Answer of an unnamed frontier model, 2026-11-23, to the request S8-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A black car is moving at 10 m/s down the road. The driver starts braking, letting the car to stop in 2~3 seconds.
"""


@register()
def road() -> Shape:
    asphalt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (50, 0.1, 7)}, color=(0.35, 0.35, 0.35)), translation_matrix((15, -0.05, 0)))
    dashes = loop(16, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.5, 0.02, 0.15)}, color=(1, 1, 1)),
        translation_matrix((-8.5 + 3 * i, 0.01, 0))))
    return concat_shapes(asphalt, dashes)


@register()
def wheel() -> Shape:
    tire = primitive_call('cylinder', shape_kwargs={'radius': 0.35, 'p0': (0, 0, -0.12), 'p1': (0, 0, 0.12)}, color=(0.15, 0.15, 0.15))
    spoke = primitive_call('cube', shape_kwargs={'scale': (0.5, 0.08, 0.26)}, color=(0.8, 0.8, 0.8))
    return concat_shapes(tire, spoke)


@register()
def black_car(wheel_angle: float, braking: bool) -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.4, 0.65, 1.8)}, color=(0.02, 0.02, 0.02)), translation_matrix((0, 0.7, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.2, 0.55, 1.6)}, color=(0.08, 0.08, 0.1)), translation_matrix((-0.2, 1.3, 0)))
    light_color = (1.0, 0.0, 0.0) if braking else (0.4, 0.0, 0.0)
    lights = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.06, 0.18, 0.4)}, color=light_color),
        translation_matrix((-2.22, 0.8, -0.6 + 1.2 * i))))
    wheels = loop(4, lambda i: transform_shape(
        library_call('wheel'),
        translation_matrix((1.4 - 2.8 * (i % 2), 0.35, -0.85 + 1.7 * (i // 2))) @ rotation_matrix(wheel_angle, (0, 0, 1), (0, 0, 0))))
    return concat_shapes(body, cabin, lights, wheels)


@register_animation()
def braking_animation() -> Generator[Shape, None, None]:
    fps = 20
    v0 = 10.0        # m/s
    t_brake = 1.0    # s, cruising before the brakes
    t_stop = 2.5     # s, braking time
    decel = v0 / t_stop
    total_frames = int((t_brake + t_stop + 0.5) * fps)

    for frame in range(total_frames):
        t = frame / fps
        if t < t_brake:
            x = v0 * t
        else:
            tb = min(t - t_brake, t_stop)
            x = v0 * t_brake + v0 * tb - 0.5 * decel * tb ** 2
        car = library_call('black_car', wheel_angle=-x / 0.35, braking=t >= t_brake)
        yield concat_shapes(library_call('road'), transform_shape(car, translation_matrix((x, 0, 1.75))))
