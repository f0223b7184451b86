# Answer of an unnamed frontier model, 2026-11-23, to the request S8-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A black car is moving at 10 m/s down the road. The driver starts braking, letting the car to stop in 2~3 seconds.
"""


@register()
def driver() -> Shape:
    torso = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.3, 0.5, 0.45)}, color=(0.2, 0.4, 0.8)), translation_matrix((0, 0.25, 0)))
    head = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.16}, color=(0.9, 0.75, 0.6)), translation_matrix((0.02, 0.66, 0)))
    return concat_shapes(torso, head)


@register()
def convertible(lean: float) -> Shape:
    # an open black car facing +x, so that the driver is visible
    black = (0.01, 0.01, 0.01)
    base = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.0, 0.3, 1.7)}, color=black), translation_matrix((0, 0.5, 0)))
    hood = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.4, 0.3, 1.7)}, color=black), translation_matrix((1.3, 0.8, 0)))
    trunk = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.9, 0.3, 1.7)}, color=black), translation_matrix((-1.55, 0.8, 0)))
    doors = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.8, 0.3, 0.1)}, color=black),
        translation_matrix((-0.25, 0.8, -0.8 + 1.6 * i))))
    windshield = transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.05, 0.5, 1.5)}, color=(0.7, 0.85, 0.95)),
        translation_matrix((0.65, 1.15, 0)) @ rotation_matrix(0.4, (0, 0, 1), (0, 0, 0)))
    person = transform_shape(library_call('driver'), translation_matrix((-0.2, 0.65, -0.35)) @ rotation_matrix(-lean, (0, 0, 1), (0, 0, 0)))
    wheels = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.36,
        'p0': (1.25 if i % 2 else -1.25, 0.36, 0.75 if i < 2 else -0.75),
        'p1': (1.25 if i % 2 else -1.25, 0.36, 0.95 if i < 2 else -0.95)}, color=(0.15, 0.15, 0.15)))
    return concat_shapes(base, hood, trunk, doors, windshield, person, wheels)


@register()
def road() -> Shape:
    lane = transform_shape(primitive_call('cube', shape_kwargs={'scale': (45, 0.1, 5)}, color=(0.4, 0.4, 0.42)), translation_matrix((12, -0.05, 0)))
    posts = loop(10, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.07, 'p0': (-9 + 4.5 * i, 0, -2.8), 'p1': (-9 + 4.5 * i, 0.9, -2.8)}, color=(1, 0.5, 0)))
    return concat_shapes(lane, posts)


@register_animation()
def driver_brakes() -> Generator[Shape, None, None]:
    frames_cruise, frames_brake, frames_rest = 10, 25, 5
    dt = 0.1                        # 25 braking frames last 2.5 s
    speed = 10.0
    decel = speed / (frames_brake * dt)
    x = -8.0

    for frame in range(frames_cruise + frames_brake + frames_rest):
        braking = frames_cruise <= frame < frames_cruise + frames_brake
        car = library_call('convertible', lean=0.2 if braking else 0.0)
        yield concat_shapes(library_call('road'), transform_shape(car, translation_matrix((x, 0, 0))))

        next_speed = speed - decel * dt if braking else speed
        next_speed = max(next_speed, 0.0)
        x += (speed + next_speed) / 2 * dt
        speed = next_speed
