# Answer of an unnamed frontier model, 2026-11-23, to the request S3-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car move towards a jeep and collide with it after 3 seconds.
"""


@register()
def tire(r: float) -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': r, 'p0': (-0.1, 0, 0), 'p1': (0.1, 0, 0)}, color=(0.1, 0.1, 0.1)),
        loop(3, lambda i: transform_shape(
            primitive_call('cube', shape_kwargs={'scale': (0.23, 1.5 * r, 0.06)}, color=(0.7, 0.7, 0.7)),
            rotation_matrix(i * math.pi / 3, (1, 0, 0), (0, 0, 0)))))


@register()
def four_tires(dx: float, dz: float, r: float, spin: float) -> Shape:
    t = transform_shape(library_call('tire', r=r), rotation_matrix(spin, (1, 0, 0), (0, 0, 0)))
    return loop(4, lambda i: transform_shape(t, translation_matrix((dx if i % 2 else -dx, r, dz if i < 2 else -dz))))


@register()
def car(spin: float) -> Shape:
    """faces -z"""
    paint = (0.95, 0.75, 0.05)
    chassis = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.5, 3.4)}, color=paint), translation_matrix((0, 0.6, 0)))
    cab = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.3, 0.5, 1.7)}, color=(0.2, 0.25, 0.3)), translation_matrix((0, 1.1, 0.2)))
    roof = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.32, 0.06, 1.6)}, color=paint), translation_matrix((0, 1.37, 0.2)))
    heads = loop(2, lambda i: transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.13}, color=(1, 1, 0.8)), translation_matrix((i - 0.5, 0.65, -1.68))))
    tails = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.3, 0.12, 0.05)}, color=(0.9, 0, 0)), translation_matrix((i - 0.5, 0.7, 1.71))))
    return concat_shapes(chassis, cab, roof, heads, tails, library_call('four_tires', dx=0.75, dz=1.05, r=0.33, spin=spin))


@register()
def jeep(spin: float) -> Shape:
    paint = (0.2, 0.35, 0.15)
    tub = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.7, 0.7, 3.2)}, color=paint), translation_matrix((0, 0.95, 0)))
    frame_bars = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.05, 'p0': ((i % 2 - 0.5) * 1.5, 1.3, 0.5 if i < 2 else -1.4), 'p1': ((i % 2 - 0.5) * 1.5, 2.1, 0.3 if i < 2 else -1.4)}, color=(0.1, 0.1, 0.1)))
    canvas = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.65, 0.1, 1.9)}, color=(0.45, 0.4, 0.25)), translation_matrix((0, 2.13, -0.55)))
    glass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.6, 0.04)}, color=(0.6, 0.8, 0.9)), translation_matrix((0, 1.65, 0.45)))
    slots = loop(7, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.07, 0.4, 0.03)}, color=(0, 0, 0)), translation_matrix((-0.36 + 0.12 * i, 1.0, 1.61))))
    lamps = loop(2, lambda i: transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.14}, color=(1, 1, 0.85)), translation_matrix((-0.62 + 1.24 * i, 1.05, 1.6))))
    return concat_shapes(tub, frame_bars, canvas, glass, slots, lamps, library_call('four_tires', dx=0.88, dz=1.0, r=0.45, spin=spin))


@register()
def street() -> Shape:
    strip = transform_shape(primitive_call('cube', shape_kwargs={'scale': (6, 0.1, 26)}, color=(0.3, 0.3, 0.3)), translation_matrix((0, -0.05, 0)))
    lines = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.12, 0.02, 26)}, color=(1, 1, 1)), translation_matrix((-2.6 + 5.2 * i, 0.01, 0))))
    return concat_shapes(strip, lines)


@register_animation()
def head_on() -> Generator[Shape, None, None]:
    fps, impact = 16, 3.0
    start_z, jeep_z = 9.0, -3.0
    hit_z = jeep_z + 1.75 + 1.8
    speed = (start_z - hit_z) / impact
    for frame in range(int(fps * 4.5)):
        t = frame / fps
        if t <= impact:
            car_z, jeep_back, yaw, pitch = start_z - speed * t, 0.0, 0.0, 0.0
        else:
            d = t - impact
            car_z = hit_z + 0.5 * (1 - math.exp(-4 * d))
            jeep_back = 1.1 * (1 - math.exp(-2.5 * d))
            yaw = 0.3 * (1 - math.exp(-3 * d))
            pitch = 0.18 * math.sin(min(d * 6, math.pi))
        a = library_call('car', spin=-(start_z - car_z) / 0.33)
        a = transform_shape(a, translation_matrix((0.15, 0, car_z)) @ rotation_matrix(yaw, (0, 1, 0), (0, 0, 0)) @ rotation_matrix(-pitch, (1, 0, 0), (0, 0, -1.05)))
        b = library_call('jeep', spin=-jeep_back / 0.45)
        b = transform_shape(b, translation_matrix((0, 0, jeep_z - jeep_back)) @ rotation_matrix(yaw * 0.6, (0, 1, 0), (0, 0, 0)) @ rotation_matrix(-pitch, (1, 0, 0), (0, 0, -1.0)))
        yield concat_shapes(library_call('street'), a, b)
