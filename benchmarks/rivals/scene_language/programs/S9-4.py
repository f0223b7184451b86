# Answer of an unnamed frontier model, 2026-11-23, to the request S9-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car moves along the street and turns left at a cross. It brakes hard after entering the new lane, but still hits a bicycle stopped in the middle of the road.
"""


@register()
def crosswalk(width: float) -> Shape:
    n = int(width / 0.8)
    return loop(n, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.6, 0.02, 0.4)}, color=(0.95, 0.95, 0.95)),
        translation_matrix((0, 0.01, (i - (n - 1) / 2) * 0.8))))


@register()
def traffic_light() -> Shape:
    pole = primitive_call('cylinder', shape_kwargs={'radius': 0.08, 'p0': (0, 0, 0), 'p1': (0, 3, 0)}, color=(0.3, 0.3, 0.3))
    case = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.4, 1.0, 0.3)}, color=(0.1, 0.1, 0.1)), translation_matrix((0, 3.3, 0)))
    colors = [(0.3, 0, 0), (0.3, 0.3, 0), (0, 1, 0)]
    lamps = loop(3, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.12}, color=colors[i]), translation_matrix((0, 3.6 - 0.3 * i, 0.15))))
    return concat_shapes(pole, case, lamps)


@register()
def intersection() -> Shape:
    def slab(size: P, y: float, color: tuple) -> Shape:
        return transform_shape(primitive_call('cube', shape_kwargs={'scale': size}, color=color), translation_matrix((0, y, 0)))

    walks = loop(4, lambda i: transform_shape(
        transform_shape(library_call('crosswalk', width=7.0), translation_matrix((5.0, 0, 0))),
        rotation_matrix(i * math.pi / 2, (0, 1, 0), (0, 0, 0))))
    lights = loop(2, lambda i: transform_shape(library_call('traffic_light'), translation_matrix((-4.6 + 9.2 * i, 0, -4.6))))
    return concat_shapes(
        slab((44, 0.1, 44), -0.1, (0.6, 0.6, 0.55)),
        slab((44, 0.1, 8), -0.05, (0.33, 0.33, 0.35)),
        slab((8, 0.1, 44), -0.049, (0.33, 0.33, 0.35)),
        walks, lights)


@register()
def car() -> Shape:
    # front toward -z
    green = (0.1, 0.5, 0.35)
    low = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.75, 0.55, 4.1)}, color=green), translation_matrix((0, 0.62, 0)))
    high = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.55, 2.1)}, color=(0.75, 0.88, 0.95)), translation_matrix((0, 1.15, 0.25)))
    front = loop(2, lambda i: transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.14}, color=(1, 1, 0.8)), translation_matrix((-0.6 + 1.2 * i, 0.65, -2.03))))
    axle = concat_shapes(*[primitive_call('cylinder', shape_kwargs={'radius': 0.34, 'p0': (s * 0.72, 0.34, 0), 'p1': (s * 0.92, 0.34, 0)}, color=(0.06, 0.06, 0.06)) for s in (-1, 1)])
    wheels = loop(2, lambda i: transform_shape(axle, translation_matrix((0, 0, -1.3 + 2.6 * i))))
    return concat_shapes(low, high, front, wheels)


@register()
def bicycle() -> Shape:
    wheel = primitive_call('cylinder', shape_kwargs={'radius': 0.34, 'p0': (-0.02, 0, 0), 'p1': (0.02, 0, 0)}, color=(0.12, 0.12, 0.12))
    wheels = loop(2, lambda i: transform_shape(wheel, translation_matrix((0, 0.34, -0.52 + 1.04 * i))))
    points = [((0, 0.34, 0.52), (0, 0.8, 0.2)), ((0, 0.8, 0.2), (0, 0.82, -0.38)), ((0, 0.82, -0.38), (0, 0.34, 0.02)),
              ((0, 0.34, 0.02), (0, 0.92, 0.24)), ((0, 0.34, 0.02), (0, 0.34, 0.52)), ((0, 0.34, -0.52), (0, 1.0, -0.34)),
              ((-0.26, 1.0, -0.34), (0.26, 1.0, -0.34))]
    tubes = loop(len(points), lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.028, 'p0': points[i][0], 'p1': points[i][1]}, color=(0.85, 0.15, 0.5)))
    seat = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.16, 0.05, 0.28)}, color=(0.05, 0.05, 0.05)), translation_matrix((0, 0.95, 0.24)))
    return concat_shapes(wheels, tubes, seat)


def path(s: float) -> tuple:
    """arc-length path of the car: north (-z), left quarter circle, then west (-x)"""
    r, lead = 5.5, 12.0
    quarter = r * math.pi / 2
    if s <= lead:
        return (2.0, 3.5 + lead - s, 0.0)
    if s <= lead + quarter:
        a = (s - lead) / r
        return (2.0 - r * (1 - math.cos(a)), 3.5 - r * math.sin(a), a)
    return (2.0 - r - (s - lead - quarter), 3.5 - r, math.pi / 2)


def traveled(t: float, v: float, t_brake: float, decel: float) -> float:
    tb = min(max(t - t_brake, 0.0), v / decel)
    return v * min(t, t_brake) + v * tb - 0.5 * decel * tb ** 2


@register_animation()
def hard_brake_after_turn() -> Generator[Shape, None, None]:
    fps, seconds = 15, 5.0
    v, decel = 8.0, 6.5
    entry = 12.0 + 5.5 * math.pi / 2       # path length at which the new lane begins
    t_brake = entry / v
    bike_x, bike_z = -8.6, -1.8

    # time when the front of the car (2.05 m ahead) meets the bike's side
    gap = (2.0 - 5.5) - 2.05 - (bike_x + 0.1)
    t_hit = t_brake + (v - math.sqrt(v * v - 2 * decel * gap)) / decel
    v_hit = v - decel * (t_hit - t_brake)

    for frame in range(int(fps * seconds)):
        t = frame / fps
        x, z, yaw = path(traveled(t, v, t_brake, decel))
        car = transform_shape(library_call('car'), translation_matrix((x, 0, z)) @ rotation_matrix(yaw, (0, 1, 0), (0, 0, 0)))

        since = max(t - t_hit, 0.0)
        slide_t = min(since, v_hit / 4.0)
        slide = v_hit * slide_t - 2.0 * slide_t ** 2
        fall = min(since / 0.5, 1.0) ** 2 * math.pi / 2
        spin = 0.5 * min(since, 1.0)
        bike_pose = (translation_matrix((bike_x - slide, 0.03, bike_z))
                     @ rotation_matrix(spin, (0, 1, 0), (0, 0, 0))
                     @ rotation_matrix(fall, (0, 0, 1), (0, 0, 0)))
        bike = transform_shape(library_call('bicycle'), bike_pose)
        yield concat_shapes(library_call('intersection'), car, bike)
