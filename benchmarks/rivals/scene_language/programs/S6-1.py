# Answer of an unnamed frontier model, 2026-11-23, to the request S6-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car collide with a trashbin, knocking the trashbin to collide with a picnic table by the street side.
"""


@register()
def ground() -> Shape:
    asphalt = primitive_call('cube', shape_kwargs={'scale': (30, 0.2, 6)}, color=(0.25, 0.25, 0.27))
    sidewalk = primitive_call('cube', shape_kwargs={'scale': (30, 0.3, 5)}, color=(0.7, 0.7, 0.68))
    return concat_shapes(
        transform_shape(asphalt, translation_matrix((0, -0.1, 0))),
        transform_shape(sidewalk, translation_matrix((0, -0.05, -5.5))))


@register()
def car() -> Shape:
    # the car faces +x, its wheels touch y = 0
    lower = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.2, 0.6, 1.9)}, color=(0.1, 0.3, 0.8)), translation_matrix((0, 0.65, 0)))
    upper = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.2, 0.6, 1.7)}, color=(0.1, 0.25, 0.65)), translation_matrix((-0.3, 1.25, 0)))
    wheels = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.35,
        'p0': ([-1.3, 1.3][i % 2], 0.35, [-0.98, 0.78][i // 2]),
        'p1': ([-1.3, 1.3][i % 2], 0.35, [-0.78, 0.98][i // 2])}, color=(0.05, 0.05, 0.05)))
    lights = loop(2, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.14}, color=(1, 1, 0.7)),
        translation_matrix((2.1, 0.7, -0.65 + 1.3 * i))))
    return concat_shapes(lower, upper, wheels, lights)


@register()
def trashbin() -> Shape:
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.6, 1.0, 0.6)}, color=(0.15, 0.5, 0.2)), translation_matrix((0, 0.5, 0)))
    lid = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.7, 0.1, 0.7)}, color=(0.1, 0.35, 0.1)), translation_matrix((0, 1.05, 0)))
    return concat_shapes(body, lid)


@register()
def plank(length: float, width: float) -> Shape:
    return primitive_call('cube', shape_kwargs={'scale': (length, 0.08, width)}, color=(0.55, 0.35, 0.18))


@register()
def picnic_table() -> Shape:
    top = loop(4, lambda i: transform_shape(library_call('plank', length=2.0, width=0.22), translation_matrix((0, 0.75, -0.36 + 0.24 * i))))
    seats = loop(2, lambda i: transform_shape(library_call('plank', length=2.0, width=0.3), translation_matrix((0, 0.42, -0.8 + 1.6 * i))))
    frames = loop(2, lambda i: concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (-0.75 + 1.5 * i, 0, -0.8), 'p1': (-0.75 + 1.5 * i, 0.75, -0.2)}, color=(0.4, 0.25, 0.12)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (-0.75 + 1.5 * i, 0, 0.8), 'p1': (-0.75 + 1.5 * i, 0.75, 0.2)}, color=(0.4, 0.25, 0.12))))
    return concat_shapes(top, seats, frames)


def ease_out(s: float) -> float:
    s = max(0.0, min(1.0, s))
    return 1 - (1 - s) ** 2


@register_animation()
def swerve_and_hit_animation() -> Generator[Shape, None, None]:
    # The car veers off the road toward the sidewalk, where the bin and table stand in line.
    total_frames = 48
    hit_bin, hit_table = 20, 30
    heading = math.radians(25)  # yaw toward -z
    d = np.array([math.cos(heading), 0, -math.sin(heading)])
    bin_p0 = np.array([0.0, 0.1, -4.0])
    table_p0 = bin_p0 + d * 3.5
    car_sizes = compute_shape_sizes(library_call('car'))
    car_contact = bin_p0 * np.array([1, 0, 1]) - d * (car_sizes[0] / 2 + 0.35)
    bin_contact = table_p0 - d * 1.5

    for frame in range(total_frames):
        if frame < hit_bin:
            car_p = car_contact - d * 0.4 * (hit_bin - frame)
        else:
            car_p = car_contact + d * 1.2 * ease_out((frame - hit_bin) / 12)

        roll = 0.0
        bin_p = bin_p0
        if frame >= hit_bin:
            s = min(1.0, (frame - hit_bin) / (hit_table - hit_bin))
            bin_p = bin_p0 + (bin_contact - bin_p0) * s + np.array([0, 0.6 * math.sin(math.pi * s) + 0.3 * s, 0])
            roll = -math.pi / 2 * s
        if frame > hit_table:
            bin_p = bin_p - d * 0.3 * ease_out((frame - hit_table) / 10)

        push = ease_out((frame - hit_table) / 12) if frame > hit_table else 0.0
        table_p = table_p0 + d * 0.8 * push
        rock = -0.12 * math.sin(math.pi * push)

        yaw = rotation_matrix(heading, (0, 1, 0), (0, 0, 0))
        tip_axis = (math.sin(heading), 0, math.cos(heading))
        car = transform_shape(library_call('car'), translation_matrix(car_p) @ yaw)
        trash = transform_shape(library_call('trashbin'), translation_matrix(bin_p) @ rotation_matrix(roll, tip_axis, (0, 0, 0)) @ yaw)
        table = transform_shape(library_call('picnic_table'), translation_matrix(table_p) @ rotation_matrix(rock, tip_axis, (0, 0, 0)) @ yaw)
        yield concat_shapes(library_call('ground'), car, trash, table)
