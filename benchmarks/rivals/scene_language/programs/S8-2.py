# Answer of an unnamed frontier model, 2026-11-23, to the request S8-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A black car is moving at 10 m/s down the road. The driver starts braking, letting the car to stop in 2~3 seconds.
"""


@register()
def roadside_tree(height: float) -> Shape:
    trunk = primitive_call('cylinder', shape_kwargs={'radius': 0.15, 'p0': (0, 0, 0), 'p1': (0, height * 0.6, 0)}, color=(0.4, 0.25, 0.1))
    crown = transform_shape(primitive_call('sphere', shape_kwargs={'radius': height * 0.3}, color=(0.15, 0.5, 0.2)), translation_matrix((0, height * 0.75, 0)))
    return concat_shapes(trunk, crown)


@register()
def road(length: float) -> Shape:
    # runs along -z, away from the camera
    asphalt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (7, 0.1, length)}, color=(0.3, 0.3, 0.32)), translation_matrix((0, -0.05, -length / 2)))
    edges = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.12, 0.02, length)}, color=(0.95, 0.95, 0.95)),
        translation_matrix((-3.2 + 6.4 * i, 0.01, -length / 2))))
    n = int(length // 4)
    center = loop(n, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.15, 0.02, 2)}, color=(0.95, 0.8, 0.2)),
        translation_matrix((0, 0.01, -2 - 4 * i))))
    trees = loop(n // 2, lambda i: transform_shape(
        library_call('roadside_tree', height=3.0 + 0.5 * math.sin(i * 2.0)),
        translation_matrix((5 if i % 2 == 0 else -5, 0, -4 - 8 * i))))
    return concat_shapes(asphalt, edges, center, trees)


@register()
def tail_lights(on: bool) -> Shape:
    color = (1.0, 0.1, 0.1) if on else (0.35, 0.05, 0.05)
    return loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.4, 0.15, 0.05)}, color=color),
        translation_matrix((-0.65 + 1.3 * i, 0.75, 2.1))))


@register()
def car_body(brake_on: bool) -> Shape:
    black = (0.03, 0.03, 0.03)
    hull = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.55, 4.2)}, color=black), translation_matrix((0, 0.7, 0)))
    glass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.45, 2.0)}, color=(0.25, 0.3, 0.35)), translation_matrix((0, 1.2, 0.2)))
    roof = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.06, 1.8)}, color=black), translation_matrix((0, 1.45, 0.2)))
    return concat_shapes(hull, glass, roof, library_call('tail_lights', on=brake_on))


@register()
def wheels(angle: float) -> Shape:
    def one(i: int) -> Shape:
        x = -0.85 if i % 2 == 0 else 0.85
        z = -1.3 if i < 2 else 1.3
        tire = primitive_call('cylinder', shape_kwargs={'radius': 0.34, 'p0': (-0.1, 0, 0), 'p1': (0.1, 0, 0)}, color=(0.1, 0.1, 0.1))
        rim = primitive_call('cube', shape_kwargs={'scale': (0.22, 0.4, 0.06)}, color=(0.7, 0.7, 0.7))
        return transform_shape(concat_shapes(tire, rim), translation_matrix((x, 0.34, z)) @ rotation_matrix(angle, (1, 0, 0), (0, 0, 0)))
    return loop(4, one)


@register()
def car(distance: float, brake_on: bool, pitch: float) -> Shape:
    # the nose dips while braking
    body = transform_shape(library_call('car_body', brake_on=brake_on), rotation_matrix(-pitch, (1, 0, 0), (0, 0.4, 0)))
    return concat_shapes(body, library_call('wheels', angle=-distance / 0.34))


@register_animation()
def brake_to_a_stop() -> Generator[Shape, None, None]:
    dt = 1 / 24
    v0, decel = 10.0, 4.0     # stops in 2.5 s
    cruise_time, hold_time = 0.8, 0.6
    total_frames = int((cruise_time + v0 / decel + hold_time) / dt)

    distance, speed, pitch = 0.0, v0, 0.0
    for frame in range(total_frames):
        t = frame * dt
        brake_on = t >= cruise_time
        target = 0.04 if brake_on and speed > 0 else 0.0
        pitch += (target - pitch) * 0.25

        moving = library_call('car', distance=distance, brake_on=brake_on, pitch=pitch)
        yield concat_shapes(
            library_call('road', length=44.0),
            transform_shape(moving, translation_matrix((1.7, 0, -4 - distance))))

        new_speed = max(0.0, speed - decel * dt) if brake_on else speed
        distance += 0.5 * (speed + new_speed) * dt
        speed = new_speed
