# Answer of an unnamed frontier model, 2026-11-23, to the request S6-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car collide with a trashbin, knocking the trashbin to collide with a picnic table by the street side.
"""


@register()
def car() -> Shape:
    body = primitive_call('cube', shape_kwargs={'scale': (2.0, 0.5, 1.0)}, color=(0.2, 0.5, 0.9))
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.0, 0.4, 0.9)}, color=(0.8, 0.9, 1.0)), translation_matrix([0, 0.45, 0]))
    wheels = concat_shapes(
        loop(2, lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.22, 'p0': (-0.6 + 1.2 * i, -0.25, 0.4), 'p1': (-0.6 + 1.2 * i, -0.25, 0.55)}, color=(0.1, 0.1, 0.1))),
        loop(2, lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.22, 'p0': (-0.6 + 1.2 * i, -0.25, -0.55), 'p1': (-0.6 + 1.2 * i, -0.25, -0.4)}, color=(0.1, 0.1, 0.1))))
    return transform_shape(concat_shapes(body, top, wheels), translation_matrix([0, 0.47, 0]))


@register()
def trashbin() -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.25, 'p0': (0, 0, 0), 'p1': (0, 0.7, 0)}, color=(0.3, 0.3, 0.3)),
        transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.25}, color=(0.4, 0.4, 0.4)), translation_matrix([0, 0.65, 0])))


@register()
def picnic_table() -> Shape:
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.0, 0.06, 1.4)}, color=(0.7, 0.5, 0.3)), translation_matrix([0, 0.6, 0]))
    seats = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.25, 0.06, 1.4)}, color=(0.6, 0.4, 0.2)),
        translation_matrix([-0.75 + 1.5 * i, 0.33, 0])))
    legs = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.04,
        'p0': ((i % 2) * 1.5 - 0.75, 0, (i // 2) * 1.0 - 0.5),
        'p1': ((i % 2) * 0.6 - 0.3, 0.6, (i // 2) * 1.0 - 0.5)}, color=(0.5, 0.3, 0.15)))
    return concat_shapes(top, seats, legs)


@register()
def street() -> Shape:
    road = transform_shape(primitive_call('cube', shape_kwargs={'scale': (14, 0.05, 3)}, color=(0.4, 0.4, 0.4)), translation_matrix([0, -0.025, 0.6]))
    side = transform_shape(primitive_call('cube', shape_kwargs={'scale': (14, 0.05, 2.4)}, color=(0.8, 0.8, 0.75)), translation_matrix([0, -0.025, -2.1]))
    return concat_shapes(road, side)


@register_animation()
def car_hits_trashbin_animation() -> Generator[Shape, None, None]:
    total_frames = 30
    first_hit = 10
    second_hit = 18
    lane = -1.0

    for frame in range(total_frames):
        # Phase 1: the car approaches the bin
        car_x = -5.0 + 3.75 * min(frame, first_hit) / first_hit
        bin_x, bin_tilt = 0.0, 0.0
        table_x, table_tilt = 3.4, 0.0

        # Phase 2: the bin is knocked away, the car slows
        if frame > first_hit:
            p = min((frame - first_hit) / (second_hit - first_hit), 1.0)
            car_x += 1.0 * (1 - (1 - p) ** 2)
            bin_x = 1.7 * p
            bin_tilt = -math.pi / 2 * p

        # Phase 3: the table is pushed by the bin
        if frame > second_hit:
            q = (frame - second_hit) / (total_frames - 1 - second_hit)
            e = 1 - (1 - q) ** 2
            table_x += 0.6 * e
            table_tilt = -0.15 * math.sin(math.pi * q)
            bin_x += 0.25 * e

        car = transform_shape(library_call('car'), translation_matrix([car_x, 0, lane]))
        trash = transform_shape(
            library_call('trashbin'),
            translation_matrix([bin_x, 0, lane]) @ rotation_matrix(bin_tilt, (0, 0, 1), (0.25, 0, 0)))
        table = transform_shape(
            library_call('picnic_table'),
            translation_matrix([table_x, 0, lane]) @ rotation_matrix(table_tilt, (0, 0, 1), (0.85, 0, 0)))

        yield concat_shapes(library_call('street'), car, trash, table)
