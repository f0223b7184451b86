# Answer of an unnamed frontier model, 2026-11-23, to the request S6-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car collide with a trashbin, knocking the trashbin to collide with a picnic table by the street side.
"""


@register()
def wheel(radius: float, width: float) -> Shape:
    tire = primitive_call('cylinder', shape_kwargs={'radius': radius, 'p0': (0, 0, -width / 2), 'p1': (0, 0, width / 2)}, color=(0.1, 0.1, 0.1))
    hub = primitive_call('cylinder', shape_kwargs={'radius': radius * 0.5, 'p0': (0, 0, -width * 0.55), 'p1': (0, 0, width * 0.55)}, color=(0.7, 0.7, 0.7))
    return concat_shapes(tire, hub)


@register()
def car(wheel_angle: float = 0.0) -> Shape:
    # faces +x, sits on y = 0
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.0, 0.7, 1.8)}, color=(0.8, 0.1, 0.1)), translation_matrix((0, 0.7, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.0, 0.6, 1.6)}, color=(0.5, 0.7, 0.9)), translation_matrix((-0.2, 1.35, 0)))

    def place_wheel(i: int) -> Shape:
        x = 1.25 if i % 2 == 0 else -1.25
        z = 0.85 if i < 2 else -0.85
        w = transform_shape(library_call('wheel', radius=0.38, width=0.25), rotation_matrix(wheel_angle, (0, 0, 1), (0, 0, 0)))
        return transform_shape(w, translation_matrix((x, 0.38, z)))

    return concat_shapes(body, cabin, loop(4, place_wheel))


@register()
def trashbin() -> Shape:
    can = primitive_call('cylinder', shape_kwargs={'radius': 0.35, 'p0': (0, 0, 0), 'p1': (0, 1.0, 0)}, color=(0.2, 0.45, 0.25))
    lid = primitive_call('cylinder', shape_kwargs={'radius': 0.4, 'p0': (0, 1.0, 0), 'p1': (0, 1.1, 0)}, color=(0.1, 0.3, 0.15))
    return concat_shapes(can, lid)


@register()
def picnic_table() -> Shape:
    wood = (0.6, 0.4, 0.2)
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.0, 0.08, 2.2)}, color=wood), translation_matrix((0, 0.8, 0)))
    benches = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.35, 0.06, 2.2)}, color=wood),
        translation_matrix((-0.85 + 1.7 * i, 0.45, 0))))
    beams = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (2.0, 0.06, 0.1)}, color=wood),
        translation_matrix((0, 0.4, -0.7 + 1.4 * i))))
    legs = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.05,
        'p0': ((-0.6 if i % 2 == 0 else 0.6), 0, (-0.7 if i < 2 else 0.7)),
        'p1': ((-0.3 if i % 2 == 0 else 0.3), 0.78, (-0.7 if i < 2 else 0.7))}, color=wood))
    return concat_shapes(top, benches, beams, legs)


@register()
def street() -> Shape:
    road = transform_shape(primitive_call('cube', shape_kwargs={'scale': (24, 0.1, 5)}, color=(0.3, 0.3, 0.3)), translation_matrix((0, -0.05, 0.5)))
    grass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (24, 0.1, 5)}, color=(0.3, 0.6, 0.3)), translation_matrix((0, -0.05, -4.5)))
    dashes = loop(8, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.4, 0.02, 0.12)}, color=(1, 1, 1)),
        translation_matrix((-10.5 + 3 * i, 0.01, 1.2))))
    return concat_shapes(road, grass, dashes)


@register_animation()
def car_trashbin_table_animation() -> Generator[Shape, None, None]:
    total_frames = 60
    fps = 20
    car_start, car_speed, car_decel = -8.0, 7.0, 5.0
    bin_start, bin_z = 0.0, -1.6
    table_start, table_z = 4.0, -1.6
    lane_z = -1.2

    # contact happens when the car's nose meets the bin
    t_hit = (bin_start - 0.35 - 2.0 - car_start) / car_speed
    bin_speed = 8.0
    # contact of the bin with the table's near bench
    t_table = t_hit + (table_start - 1.05 - 0.9 - bin_start) / bin_speed

    for frame in range(total_frames):
        t = frame / fps
        # car: constant speed, then braking after impact
        if t < t_hit:
            car_x = car_start + car_speed * t
        else:
            v = 3.5
            dt = min(t - t_hit, v / car_decel)
            car_x = car_start + car_speed * t_hit + v * dt - 0.5 * car_decel * dt ** 2

        # bin: at rest, then flying and tipping, then bouncing off the table
        bin_x, bin_y, tilt = bin_start, 0.0, 0.0
        if t >= t_hit:
            dt = min(t, t_table) - t_hit
            progress = dt / (t_table - t_hit)
            bin_x += bin_speed * dt
            tilt = -math.pi / 2 * progress
            bin_y = 0.4 * progress + 0.5 * math.sin(math.pi * progress)
        if t >= t_table:
            after = min(t - t_table, 0.4)
            bin_x -= 0.6 * after

        # table: slides after being struck
        table_x, table_yaw = table_start, 0.0
        if t >= t_table:
            dt = min(t - t_table, 0.6)
            table_x += 2.0 * dt - 0.5 * (2.0 / 0.6) * dt ** 2
            table_yaw = 0.25 * (dt / 0.6)

        moving_car = transform_shape(library_call('car', wheel_angle=-(car_x - car_start) / 0.38), translation_matrix((car_x, 0, lane_z)))
        moving_bin = transform_shape(library_call('trashbin'), translation_matrix((bin_x, bin_y, bin_z)) @ rotation_matrix(tilt, (0, 0, 1), (0, 0, 0)))
        table = transform_shape(library_call('picnic_table'), translation_matrix((table_x, 0, table_z)) @ rotation_matrix(table_yaw, (0, 1, 0), (0, 0, 0)))
        yield concat_shapes(library_call('street'), moving_car, moving_bin, table)
