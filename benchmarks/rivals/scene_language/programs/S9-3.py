# Answer of an unnamed frontier model, 2026-11-23, to the request S9-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car moves along the street and turns left at a cross. It brakes hard after entering the new lane, but still hits a bicycle stopped in the middle of the road.
"""


@register()
def cross_street() -> Shape:
    road_a = primitive_call('cube', shape_kwargs={'scale': (4, 0.1, 24)}, color=(0.3, 0.3, 0.3))
    road_b = primitive_call('cube', shape_kwargs={'scale': (24, 0.1, 4)}, color=(0.3, 0.3, 0.3))
    corners = loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (10, 0.2, 10)}, color=(0.5, 0.75, 0.5)),
        rotation_matrix(i * math.pi / 2, (0, 1, 0), (0, 0, 0)) @ translation_matrix([7, 0, 7])))
    return transform_shape(concat_shapes(road_a, road_b, corners), translation_matrix([0, -0.05, 0]))


@register()
def car() -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.9, 0.4, 2.0)}, color=(1, 0.8, 0)), translation_matrix([0, 0.4, 0]))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.8, 0.35, 1.0)}, color=(0.2, 0.2, 0.2)), translation_matrix([0, 0.75, 0.1]))
    wheels = loop(4, lambda i: transform_shape(
        primitive_call('cylinder', shape_kwargs={'radius': 0.2, 'p0': (-0.06, 0, 0), 'p1': (0.06, 0, 0)}, color=(0, 0, 0)),
        translation_matrix([0.45 * (-1) ** i, 0.2, 0.65 if i < 2 else -0.65])))
    return concat_shapes(body, cabin, wheels)


@register()
def bicycle() -> Shape:
    wheels = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.22, 'p0': (-0.02, 0.22, -0.32 + 0.64 * i), 'p1': (0.02, 0.22, -0.32 + 0.64 * i)}, color=(0.1, 0.1, 0.1)))
    bar = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0.5, -0.25), 'p1': (0, 0.5, 0.2)}, color=(0, 0.4, 0.8))
    fork = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0.22, -0.32), 'p1': (0, 0.62, -0.22)}, color=(0, 0.4, 0.8))
    seat_tube = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0.22, 0.32), 'p1': (0, 0.55, 0.18)}, color=(0, 0.4, 0.8))
    handle = primitive_call('cylinder', shape_kwargs={'radius': 0.02, 'p0': (-0.18, 0.62, -0.22), 'p1': (0.18, 0.62, -0.22)}, color=(0.5, 0.5, 0.5))
    seat = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.07}, color=(0.2, 0.1, 0.1)), translation_matrix([0, 0.58, 0.18]))
    return concat_shapes(wheels, bar, fork, seat_tube, handle, seat)


@register_animation()
def car_bicycle_animation() -> Generator[Shape, None, None]:
    total_frames = 40
    for frame in range(total_frames):
        bike_x, bike_fall = -6.0, 0.0

        if frame < 14:
            # drive straight toward the cross
            car_x, car_z, yaw = 1.0, 10.0 - 0.6 * frame, 0.0
        elif frame < 22:
            # quarter circle to the left
            yaw = (frame - 14) / 8 * math.pi / 2
            car_x = 1.0 - 2.6 * (1 - math.cos(yaw))
            car_z = 1.6 - 2.6 * math.sin(yaw)
        else:
            # brake hard in the new lane
            yaw = math.pi / 2
            k = min(frame - 22, 12)
            car_x = -1.6 - (0.6 * k - 0.025 * k ** 2)
            car_z = -1.0
            front = car_x - 1.0
            if front < bike_x + 0.1:
                contact = bike_x + 0.1 - front
                bike_x -= contact
                bike_fall = min(contact * 2.0, math.pi / 2 - 0.05)

        car = transform_shape(library_call('car'), translation_matrix([car_x, 0, car_z]) @ rotation_matrix(yaw, (0, 1, 0), (0, 0, 0)))
        bike = transform_shape(library_call('bicycle'), translation_matrix([bike_x, 0, -0.8]) @ rotation_matrix(bike_fall, (0, 0, 1), (0, 0, 0)))
        yield concat_shapes(library_call('cross_street'), car, bike)
