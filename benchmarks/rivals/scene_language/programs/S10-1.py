# Answer of an unnamed frontier model, 2026-11-23, to the request S10-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
Two cars moves at the same speed of 5~10m/s, one in front of the other. The front car suddenly brakes, and two cars collide after 1 second.
"""


@register()
def wheel() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.3, 'p0': (0, 0, -0.1), 'p1': (0, 0, 0.1)}, color=(0.1, 0.1, 0.1))


@register()
def car(color: tuple[float, float, float]) -> Shape:
    base = primitive_call('cube', shape_kwargs={'scale': (3, 0.6, 1.4)}, color=color)
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.6, 0.5, 1.2)}, color=color), translation_matrix([0, 0.55, 0]))
    wheels = loop(4, lambda i: transform_shape(
        library_call('wheel'),
        translation_matrix([1.0 if i % 2 == 0 else -1.0, -0.3, 0.7 if i < 2 else -0.7])))
    return concat_shapes(base, top, wheels)


@register()
def road() -> Shape:
    return transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (40, 0.1, 4)}, color=(0.5, 0.5, 0.5)),
        translation_matrix([8, -0.65, 0]))


@register_animation()
def two_cars_animation() -> Generator[Shape, None, None]:
    total_frames = 50
    dt = 0.05
    brake_frame = 15
    speed = 7.0
    front_v, rear_v = speed, speed
    deceleration = 7.0

    rear_car = library_call('car', color=(0, 0, 1))
    front_car = library_call('car', color=(1, 0, 0))
    length = compute_shape_sizes(rear_car)[0]

    # braking for 1 second closes 0.5 * a * t^2 = 3.5 m
    rear_x = -8.0
    front_x = rear_x + length + 0.5 * deceleration
    collided = False

    for frame in range(total_frames):
        yield concat_shapes(
            library_call('road'),
            transform_shape(rear_car, translation_matrix([rear_x, 0, 0])),
            transform_shape(front_car, translation_matrix([front_x, 0, 0])))

        old_front_v = front_v
        if frame >= brake_frame:
            front_v = max(0.0, front_v - deceleration * dt)
        if collided:
            rear_v = max(0.0, rear_v - deceleration * dt)

        front_x += (old_front_v + front_v) / 2 * dt
        rear_x += rear_v * dt

        if not collided and front_x - rear_x <= length + 1e-6:
            collided = True
            rear_x = front_x - length
            # partially elastic: the front car is pushed forward
            total = front_v + rear_v
            front_v, rear_v = 0.65 * total, 0.35 * total
