# Answer of an unnamed frontier model, 2026-11-23, to the request S6-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car collide with a trashbin, knocking the trashbin to collide with a picnic table by the street side.
"""


@register()
def street_scene() -> Shape:
    road = transform_shape(primitive_call('cube', shape_kwargs={'scale': (20, 0.1, 4)}, color=(0.35, 0.35, 0.35)), translation_matrix([0, -0.05, 0]))
    lawn = transform_shape(primitive_call('cube', shape_kwargs={'scale': (20, 0.1, 4)}, color=(0.4, 0.7, 0.35)), translation_matrix([0, -0.05, -4]))
    return concat_shapes(road, lawn)


@register()
def car() -> Shape:
    chassis = primitive_call('cube', shape_kwargs={'scale': (3, 0.6, 1.4)}, color=(0.9, 0.6, 0.1))
    roof = transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.5, 0.5, 1.2)}, color=(0.2, 0.2, 0.3)),
        translation_matrix([-0.1, 0.55, 0]))
    wheels = loop(4, lambda i: transform_shape(
        library_call('car_wheel'),
        translation_matrix([(-1) ** i * 0.95, -0.3, 0.7 if i < 2 else -0.7])))
    whole = concat_shapes(chassis, roof, wheels)
    # put the car on the ground
    return transform_shape(whole, translation_matrix([0, -compute_shape_min(whole)[1], 0]))


@register()
def car_wheel() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.3, 'p0': (0, 0, -0.1), 'p1': (0, 0, 0.1)}, color=(0, 0, 0))


@register()
def trashbin() -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.3, 'p0': (0, 0, 0), 'p1': (0, 0.9, 0)}, color=(0.5, 0.5, 0.55)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.34, 'p0': (0, 0.85, 0), 'p1': (0, 0.92, 0)}, color=(0.3, 0.3, 0.35)))


@register()
def picnic_table() -> Shape:
    brown = (0.5, 0.3, 0.1)
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.1, 1)}, color=brown), translation_matrix([0, 0.8, 0]))
    bench = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.8, 0.1, 0.3)}, color=brown),
        translation_matrix([0, 0.4, 0.8 - 1.6 * i])))
    legs = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, 0.8, 1.2)}, color=brown),
        translation_matrix([-0.7 + 1.4 * i, 0.4, 0])))
    return concat_shapes(top, bench, legs)


@register_animation()
def collision_chain() -> Generator[Shape, None, None]:
    total_frames = 40
    dt = 0.05
    mu_g = 4.0

    # positions and velocities along x (all objects aligned along the curb)
    z = -1.8
    x_car, v_car = -6.0, 8.0
    x_bin, v_bin = 0.0, 0.0
    x_table, v_table = 3.0, 0.0
    m_car, m_bin, m_table = 10.0, 1.0, 4.0
    bin_tilt, omega = 0.0, 0.0

    half_car = compute_shape_sizes(library_call('car'))[0] / 2
    half_bin = compute_shape_sizes(library_call('trashbin'))[0] / 2
    half_table = compute_shape_sizes(library_call('picnic_table'))[0] / 2

    for frame in range(total_frames):
        # collide car with bin
        if x_car + half_car >= x_bin - half_bin and v_car > v_bin:
            rel = v_car - v_bin
            j = 1.4 * rel * m_car * m_bin / (m_car + m_bin)
            v_car -= j / m_car
            v_bin += j / m_bin
            omega = -3.0
        # collide bin with table
        if x_bin + half_bin >= x_table - half_table and v_bin > v_table:
            rel = v_bin - v_table
            j = 1.2 * rel * m_bin * m_table / (m_bin + m_table)
            v_bin -= j / m_bin
            v_table += j / m_table
            omega = -2.0

        bin_tilt = max(bin_tilt + omega * dt, -math.pi / 2)
        bin_pose = translation_matrix([x_bin, half_bin * math.sin(-bin_tilt), z]) @ rotation_matrix(bin_tilt, (0, 0, 1), (0, 0, 0))

        yield concat_shapes(
            library_call('street_scene'),
            transform_shape(library_call('car'), translation_matrix([x_car, 0, z + 0.2])),
            transform_shape(library_call('trashbin'), bin_pose),
            transform_shape(library_call('picnic_table'), translation_matrix([x_table, 0, z])))

        # integrate with friction; the driver brakes after the impact
        x_car += v_car * dt
        x_bin += v_bin * dt
        x_table += v_table * dt
        if omega != 0.0:
            v_car = max(0.0, v_car - 12.0 * dt)
        v_bin = math.copysign(max(0.0, abs(v_bin) - mu_g * dt), v_bin)
        v_table = max(0.0, v_table - mu_g * dt)
