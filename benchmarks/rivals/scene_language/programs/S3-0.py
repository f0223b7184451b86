# Answer of an unnamed frontier model, 2026-11-23, to the request S3-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car move towards a jeep and collide with it after 3 seconds.
"""

FPS = 12


@register()
def wheel(radius: float, width: float) -> Shape:
    tire = primitive_call('cylinder', shape_kwargs={'radius': radius, 'p0': (0, 0, -width / 2), 'p1': (0, 0, width / 2)}, color=(0.08, 0.08, 0.08))
    hub = primitive_call('cylinder', shape_kwargs={'radius': radius * 0.5, 'p0': (0, 0, -width / 2 - 0.01), 'p1': (0, 0, width / 2 + 0.01)}, color=(0.7, 0.7, 0.7))
    bar = primitive_call('cube', shape_kwargs={'scale': (radius * 1.6, radius * 0.2, width + 0.04)}, color=(0.4, 0.4, 0.4))
    return concat_shapes(tire, hub, bar)


@register()
def wheels(base: float, track: float, radius: float, roll: float) -> Shape:
    return loop(4, lambda i: transform_shape(
        library_call('wheel', radius=radius, width=0.25),
        translation_matrix(((i % 2 - 0.5) * base, radius, (i // 2 - 0.5) * track)) @ rotation_matrix(roll, (0, 0, 1), (0, 0, 0))))


@register()
def car(roll: float, crush: float) -> Shape:
    red = (0.85, 0.1, 0.1)
    length = 3.6 - crush
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (length, 0.6, 1.6)}, color=red), translation_matrix((-crush / 2, 0.7, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.55, 1.4)}, color=(0.6, 0.8, 0.9)), translation_matrix((-0.2, 1.25, 0)))
    roof = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.7, 0.06, 1.42)}, color=red), translation_matrix((-0.2, 1.55, 0)))
    lights = loop(2, lambda i: transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.12}, color=(1, 1, 0.6)),
                                               translation_matrix((1.8 - crush, 0.75, -0.55 + 1.1 * i))))
    return concat_shapes(body, cabin, roof, lights, library_call('wheels', base=2.2, track=1.6, radius=0.35, roll=roll))


@register()
def jeep(roll: float) -> Shape:
    green = (0.25, 0.38, 0.2)
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.4, 0.8, 1.8)}, color=green), translation_matrix((0, 1.0, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.0, 0.8, 1.7)}, color=(0.18, 0.28, 0.15)), translation_matrix((0.5, 1.8, 0)))
    window = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.05, 0.55, 1.5)}, color=(0.6, 0.8, 0.9)), translation_matrix((-0.51, 1.8, 0)))
    spare = transform_shape(library_call('wheel', radius=0.42, width=0.2), translation_matrix((1.8, 1.3, 0)) @ rotation_matrix(math.pi / 2, (0, 1, 0), (0, 0, 0)))
    grille = loop(7, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.04, 0.4, 0.06)}, color=(0.05, 0.05, 0.05)),
                                               translation_matrix((-1.71, 1.05, -0.36 + 0.12 * i))))
    lamps = loop(2, lambda i: transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.14}, color=(1, 1, 0.8)),
                                              translation_matrix((-1.7, 1.1, -0.65 + 1.3 * i))))
    return concat_shapes(body, cabin, window, spare, grille, lamps, library_call('wheels', base=2.2, track=1.8, radius=0.48, roll=roll))


@register()
def road() -> Shape:
    asphalt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (26, 0.1, 5)}, color=(0.25, 0.25, 0.27)), translation_matrix((0, -0.05, 0)))
    dashes = loop(12, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (1, 0.02, 0.12)}, color=(1, 1, 1)),
                                                translation_matrix((-12 + 2.1 * i, 0.01, 2.0))))
    return concat_shapes(asphalt, dashes)


@register()
def debris(t: float) -> Shape:
    return loop(12, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, 0.06, 0.08)}, color=(0.8, 0.2 + 0.04 * i, 0.1)),
        translation_matrix(((i % 5 - 2) * 0.9 * t, max(0.05, 0.8 + (2 + 0.2 * i) * t - 4.9 * t * t), 1.4 * math.sin(2.4 * i) * t))
        @ rotation_matrix(6 * t + i, (1, i % 3, 1), (0, 0, 0))))


@register_animation()
def collision() -> Generator[Shape, None, None]:
    hit_time, total_time = 3.0, 5.0
    jeep_x = 4.0
    contact = jeep_x - 1.75 - 1.85
    start = -9.0
    speed = (contact - start) / hit_time
    for frame in range(int(total_time * FPS)):
        t = frame / FPS
        d = max(0.0, t - hit_time)
        push = 1.3 * (1 - math.exp(-2.0 * d))
        x = start + speed * t if t < hit_time else contact + push + 0.4 * (1 - math.exp(-10 * d)) - 0.25 * (1 - math.exp(-3 * d))
        crush = 0.4 * (1 - math.exp(-10 * d))
        rock = 0.12 * math.exp(-3 * d) * math.sin(9 * d)
        car_shape = transform_shape(library_call('car', roll=-(x - start) / 0.35, crush=crush), rotation_matrix(-rock, (0, 0, 1), (1.1, 0, 0)))
        car_shape = transform_shape(car_shape, translation_matrix((x, 0, 0)))
        jeep_shape = transform_shape(library_call('jeep', roll=-push / 0.48), rotation_matrix(-rock * 0.8, (0, 0, 1), (1.1, 0, 0)))
        jeep_shape = transform_shape(jeep_shape, translation_matrix((jeep_x + push, 0, 0)))
        scene = concat_shapes(library_call('road'), car_shape, jeep_shape)
        if d > 0:
            scene = concat_shapes(scene, transform_shape(library_call('debris', t=d), translation_matrix((contact + 1.8, 0, 0))))
        yield scene
