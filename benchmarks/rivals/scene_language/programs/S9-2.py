# Answer of an unnamed frontier model, 2026-11-23, to the request S9-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car moves along the street and turns left at a cross. It brakes hard after entering the new lane, but still hits a bicycle stopped in the middle of the road.
"""


@register()
def road_segment(length: float, width: float) -> Shape:
    surface = transform_shape(primitive_call('cube', shape_kwargs={'scale': (length, 0.1, width)}, color=(0.3, 0.3, 0.3)), translation_matrix((0, -0.05, 0)))
    count = int(length // 2)
    marks = loop(count, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.0, 0.02, 0.1)}, color=(0.9, 0.8, 0.2)),
        translation_matrix((-length / 2 + 1 + 2 * i, 0.005, 0))))
    return concat_shapes(surface, marks)


@register()
def crossing() -> Shape:
    arm = transform_shape(library_call('road_segment', length=16, width=6), translation_matrix((11, 0, 0)))
    arms = loop(4, lambda i: transform_shape(arm, rotation_matrix(i * math.pi / 2, (0, 1, 0), (0, 0, 0))))
    middle = transform_shape(primitive_call('cube', shape_kwargs={'scale': (6, 0.1, 6)}, color=(0.3, 0.3, 0.3)), translation_matrix((0, -0.05, 0)))
    return concat_shapes(arms, middle)


@register()
def car(braking: bool) -> Shape:
    shell = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.8, 0.6, 1.7)}, color=(0.9, 0.9, 0.92)), translation_matrix((0, 0.6, 0)))
    cab = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.9, 0.5, 1.5)}, color=(0.15, 0.2, 0.25)), translation_matrix((-0.2, 1.15, 0)))
    tail = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.06, 0.15, 0.35)}, color=(1, 0, 0) if braking else (0.3, 0, 0)),
        translation_matrix((-1.92, 0.7, -0.6 + 1.2 * i))))
    tires = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.33,
        'p0': ((1.2, -1.2)[i % 2], 0.33, (0.72, -0.72)[i // 2]),
        'p1': ((1.2, -1.2)[i % 2], 0.33, (0.92, -0.92)[i // 2])}, color=(0.05, 0.05, 0.05)))
    return concat_shapes(shell, cab, tail, tires)


@register()
def bike_wheel() -> Shape:
    rim = loop(12, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.025,
        'p0': (0.34 * math.cos(i * math.pi / 6), 0.34 * math.sin(i * math.pi / 6), 0),
        'p1': (0.34 * math.cos((i + 1) * math.pi / 6), 0.34 * math.sin((i + 1) * math.pi / 6), 0)}, color=(0.1, 0.1, 0.1)))
    spokes = loop(3, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.008,
        'p0': (0.34 * math.cos(i * math.pi / 3), 0.34 * math.sin(i * math.pi / 3), 0),
        'p1': (-0.34 * math.cos(i * math.pi / 3), -0.34 * math.sin(i * math.pi / 3), 0)}, color=(0.7, 0.7, 0.7)))
    return concat_shapes(rim, spokes)


@register()
def bicycle() -> Shape:
    def tube(p0: P, p1: P) -> Shape:
        return primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': p0, 'p1': p1}, color=(0.1, 0.4, 0.9))

    return concat_shapes(
        loop(2, lambda i: transform_shape(library_call('bike_wheel'), translation_matrix((-0.52 + 1.04 * i, 0.36, 0)))),
        tube((-0.52, 0.36, 0), (-0.05, 0.36, 0)),
        tube((-0.05, 0.36, 0), (-0.2, 0.9, 0)),
        tube((-0.52, 0.36, 0), (-0.17, 0.8, 0)),
        tube((-0.17, 0.8, 0), (0.38, 0.82, 0)),
        tube((-0.05, 0.36, 0), (0.38, 0.75, 0)),
        tube((0.52, 0.36, 0), (0.36, 1.0, 0)),
        tube((0.36, 1.0, -0.25), (0.36, 1.0, 0.25)),
        transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.28, 0.06, 0.15)}, color=(0, 0, 0)), translation_matrix((-0.2, 0.93, 0))))


@register_animation()
def intersection_accident() -> Generator[Shape, None, None]:
    # Simulate the car as a point with heading; "left" increases the yaw about +y.
    dt, total_frames = 0.05, 100
    x, z, heading, v = -15.0, 1.5, 0.0, 7.0
    r = 4.5
    bx, bz, bike_v, bike_fall = 1.2, -9.5, 0.0, 0.0
    hit, braking = False, False

    for frame in range(total_frames):
        car = transform_shape(
            library_call('car', braking=braking),
            translation_matrix((x, 0, z)) @ rotation_matrix(heading, (0, 1, 0), (0, 0, 0)))
        bike = transform_shape(
            library_call('bicycle'),
            translation_matrix((bx, 0, bz)) @ rotation_matrix(-bike_fall, (1, 0, 0), (0, 0, 0)))
        yield concat_shapes(library_call('crossing'), car, bike)

        # steering: start the arc so that it ends in the lane x = 1.5
        if x >= 1.5 - r and heading < math.pi / 2:
            heading = min(heading + v / r * dt, math.pi / 2)
        # brake hard once the turn is complete
        braking = heading >= math.pi / 2
        if braking:
            v = max(0.0, v - 6.0 * dt)
        x += v * math.cos(heading) * dt
        z -= v * math.sin(heading) * dt

        # impact with the bicycle
        if not hit and braking and z - 1.9 <= bz + 0.2:
            hit = True
            bike_v = 1.1 * v
            v *= 0.8
        if hit:
            bz -= bike_v * dt
            bike_v = max(0.0, bike_v - 4.0 * dt)
            bike_fall = min(bike_fall + 3.5 * dt, math.pi / 2)
