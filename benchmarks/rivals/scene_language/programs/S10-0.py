# Answer of an unnamed frontier model, 2026-11-23, to the request S10-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
Two cars moves at the same speed of 5~10m/s, one in front of the other. The front car suddenly brakes, and two cars collide after 1 second.
"""


@register()
def road() -> Shape:
    surface = transform_shape(primitive_call('cube', shape_kwargs={'scale': (50, 0.1, 7)}, color=(0.35, 0.35, 0.35)), translation_matrix((12, -0.05, 0)))
    lines = loop(16, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.5, 0.02, 0.12)}, color=(1, 1, 1)),
        translation_matrix((-11 + 3 * i, 0.01, 0))))
    return concat_shapes(surface, lines)


@register()
def car(color: tuple[float, float, float], braking: bool) -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4, 0.6, 1.8)}, color=color), translation_matrix((0, 0.65, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2, 0.55, 1.6)}, color=(0.6, 0.75, 0.85)), translation_matrix((-0.2, 1.2, 0)))
    lights = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.04, 0.15, 0.35)}, color=(1, 0, 0) if braking else (0.3, 0, 0)),
        translation_matrix((-2.0, 0.75, -0.65 + 1.3 * i))))
    wheels = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.35,
        'p0': (-1.25 + 2.5 * (i % 2), 0.35, -0.95 + 1.7 * (i // 2)),
        'p1': (-1.25 + 2.5 * (i % 2), 0.35, -0.75 + 1.7 * (i // 2))}, color=(0.05, 0.05, 0.05)))
    return concat_shapes(body, cabin, lights, wheels)


@register_animation()
def rear_end_collision() -> Generator[Shape, None, None]:
    fps = 20
    v = 8.0            # both cars, m/s
    decel = 6.0        # front car's braking
    t_brake = 1.0      # when the front car brakes
    t_hit = t_brake + 1.0
    # the gap is closed by 0.5 * decel * 1^2 in one second
    car_length = 4.0
    gap = 0.5 * decel * (t_hit - t_brake) ** 2
    rear0 = -8.0
    front0 = rear0 + car_length + gap

    v_front_hit = v - decel * (t_hit - t_brake)
    v_common = (v + v_front_hit) / 2     # equal masses, they stick together
    slide_decel = 5.0

    for frame in range(int(3.5 * fps)):
        t = frame / fps
        tb = min(max(t - t_brake, 0), t_hit - t_brake)
        after = min(max(t - t_hit, 0), v_common / slide_decel)
        slide = v_common * after - 0.5 * slide_decel * after ** 2

        rear_x = rear0 + v * min(t, t_hit) + slide
        front_x = front0 + v * min(t, t_hit) - 0.5 * decel * tb ** 2 + slide

        rear = transform_shape(library_call('car', color=(0.2, 0.4, 0.9), braking=t > t_hit), translation_matrix((rear_x, 0, 1.75)))
        front = transform_shape(library_call('car', color=(0.9, 0.2, 0.2), braking=t >= t_brake), translation_matrix((front_x, 0, 1.75)))
        yield concat_shapes(library_call('road'), rear, front)
