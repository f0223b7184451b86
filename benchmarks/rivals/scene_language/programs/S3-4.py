# Answer of an unnamed frontier model, 2026-11-23, to the request S3-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car move towards a jeep and collide with it after 3 seconds.
"""


@register()
def sports_car(color, wheel_angle: float) -> Shape:
    base = primitive_call('cube', shape_kwargs={'scale': (4.2, 0.4, 1.8)}, color=color)
    hood = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.3, 0.2, 1.6)}, color=color), translation_matrix((1.3, 0.3, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.7, 0.5, 1.5)}, color=(0.1, 0.1, 0.15)), translation_matrix((-0.4, 0.45, 0)))
    spoiler = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.3, 0.06, 1.8)}, color=(0.1, 0.1, 0.1)), translation_matrix((-1.95, 0.55, 0)))
    posts = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.04, 'p0': (-1.95, 0.2, -0.6 + 1.2 * i), 'p1': (-1.95, 0.55, -0.6 + 1.2 * i)}, color=(0.1, 0.1, 0.1)))
    body = transform_shape(concat_shapes(base, hood, cabin, spoiler, posts), translation_matrix((0, 0.55, 0)))
    return concat_shapes(body, library_call('wheel_set', half_base=1.35, half_track=0.9, radius=0.38, angle=wheel_angle))


@register()
def offroad_jeep(color, wheel_angle: float) -> Shape:
    chassis = primitive_call('cube', shape_kwargs={'scale': (3.8, 0.7, 1.9)}, color=color)
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.2, 0.85, 1.8)}, color=color), translation_matrix((-0.6, 0.75, 0)))
    glass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.24, 0.45, 1.6)}, color=(0.55, 0.75, 0.85)), translation_matrix((-0.6, 0.85, 0)))
    bumper = primitive_call('cylinder', shape_kwargs={'radius': 0.12, 'p0': (2.0, -0.2, -0.9), 'p1': (2.0, -0.2, 0.9)}, color=(0.2, 0.2, 0.2))
    eyes = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.15, 'p0': (1.88, 0.1, -0.65 + 1.3 * i), 'p1': (1.95, 0.1, -0.65 + 1.3 * i)}, color=(1, 1, 0.8)))
    body = transform_shape(concat_shapes(chassis, cabin, glass, bumper, eyes), translation_matrix((0, 1.1, 0)))
    return concat_shapes(body, library_call('wheel_set', half_base=1.2, half_track=0.95, radius=0.52, angle=wheel_angle))


@register()
def wheel_set(half_base: float, half_track: float, radius: float, angle: float) -> Shape:
    def w(i):
        sx, sz = (1 if i % 2 else -1), (1 if i // 2 else -1)
        rim = primitive_call('cube', shape_kwargs={'scale': (radius * 1.3, radius * 0.25, 0.3)}, color=(0.8, 0.8, 0.8))
        tyre = primitive_call('cylinder', shape_kwargs={'radius': radius, 'p0': (0, 0, -0.14), 'p1': (0, 0, 0.14)}, color=(0.07, 0.07, 0.07))
        turned = transform_shape(concat_shapes(rim, tyre), rotation_matrix(angle, (0, 0, 1), (0, 0, 0)))
        return transform_shape(turned, translation_matrix((sx * half_base, radius, sz * half_track)))
    return loop(4, w)


@register()
def environment() -> Shape:
    road = transform_shape(primitive_call('cube', shape_kwargs={'scale': (32, 0.2, 6)}, color=(0.28, 0.28, 0.3)), translation_matrix((0, -0.1, 0)))
    curb = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (32, 0.3, 0.4)}, color=(0.7, 0.7, 0.7)), translation_matrix((0, 0.0, -3.2 + 6.4 * i))))
    trees = loop(5, lambda i: transform_shape(concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.2, 'p0': (0, 0, 0), 'p1': (0, 1.6, 0)}, color=(0.4, 0.25, 0.1)),
        transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.9}, color=(0.15, 0.5, 0.2)), translation_matrix((0, 2.2, 0)))),
        translation_matrix((-12 + 6 * i, 0, -5))))
    return concat_shapes(road, curb, trees)


def motion(t, t_hit, car_start, jeep_start, car_v, jeep_v):
    """Positions of both vehicles; both drive at each other until t_hit."""
    if t <= t_hit:
        return car_start + car_v * t, jeep_start - jeep_v * t
    d = t - t_hit
    damp = (1 - math.exp(-2.2 * d)) / 2.2
    return (car_start + car_v * t_hit - 0.7 * damp, jeep_start - jeep_v * t_hit + 1.8 * damp)


@register_animation()
def collision_after_three_seconds() -> Generator[Shape, None, None]:
    fps, t_hit, total = 12, 3.0, 5.0
    car_half, jeep_half = 2.1, 2.12
    car_v, jeep_v = 3.2, 0.0
    jeep_start = 4.0
    car_start = jeep_start - jeep_half - car_half - car_v * t_hit
    for frame in range(int(fps * total)):
        t = frame / fps
        cx, jx = motion(t, t_hit, car_start, jeep_start, car_v, jeep_v)
        d = max(0.0, t - t_hit)
        bounce = 0.2 * abs(math.sin(6 * d)) * math.exp(-3 * d)
        nose = 0.15 * math.sin(min(math.pi, 7 * d))
        car = library_call('sports_car', color=(0.95, 0.35, 0.0), wheel_angle=-cx / 0.38)
        car = transform_shape(car, rotation_matrix(-nose, (0, 0, 1), (1.35, 0.38, 0)))
        car = transform_shape(car, translation_matrix((cx, 0.5 * bounce, 0)))
        jeep = library_call('offroad_jeep', color=(0.3, 0.4, 0.25), wheel_angle=(jx - jeep_start) / 0.52)
        jeep = transform_shape(jeep, rotation_matrix(math.pi + 0.35 * (1 - math.exp(-2.5 * d)), (0, 1, 0), (0, 0, 0)))
        jeep = transform_shape(jeep, translation_matrix((jx, bounce, -0.3 * (1 - math.exp(-2.5 * d)))))
        yield concat_shapes(library_call('environment'), car, jeep)
