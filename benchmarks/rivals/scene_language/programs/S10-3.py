# Answer of an unnamed frontier model, 2026-11-23, to the request S10-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
Two cars moves at the same speed of 5~10m/s, one in front of the other. The front car suddenly brakes, and two cars collide after 1 second.
"""


def front_position(t: float, x0: float, v: float, t_brake: float, a: float) -> float:
    tb = min(max(t - t_brake, 0.0), v / a)
    return x0 + v * min(t, t_brake) + v * tb - 0.5 * a * tb ** 2


@register()
def sedan() -> Shape:
    # drives toward -x
    paint = (0.8, 0.8, 0.85)
    hull = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.0, 0.55, 1.7)}, color=paint), translation_matrix((0, 0.6, 0)))
    roof = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.9, 0.5, 1.5)}, color=(0.2, 0.25, 0.3)), translation_matrix((0.2, 1.1, 0)))
    return concat_shapes(hull, roof, library_call('four_wheels', base=2.5, track=1.6, radius=0.33))


@register()
def van() -> Shape:
    # drives toward -x
    cargo = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.2, 1.6, 1.9)}, color=(0.9, 0.5, 0.1)), translation_matrix((0.6, 1.25, 0)))
    nose = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.2, 0.9, 1.9)}, color=(0.9, 0.5, 0.1)), translation_matrix((-1.6, 0.9, 0)))
    glass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.06, 0.5, 1.6)}, color=(0.6, 0.8, 0.9)), translation_matrix((-1.02, 1.7, 0)))
    return concat_shapes(cargo, nose, glass, library_call('four_wheels', base=2.8, track=1.8, radius=0.4))


@register()
def four_wheels(base: float, track: float, radius: float) -> Shape:
    def w(i: int) -> Shape:
        x = base / 2 if i % 2 else -base / 2
        s = 1 if i < 2 else -1
        return primitive_call('cylinder', shape_kwargs={
            'radius': radius, 'p0': (x, radius, s * (track / 2 - 0.1)), 'p1': (x, radius, s * (track / 2 + 0.1))}, color=(0.05, 0.05, 0.05))
    return loop(4, w)


@register()
def debris(progress: float) -> Shape:
    # small fragments thrown out of the point of impact
    def piece(i: int) -> Shape:
        a = 2 * math.pi * i / 8
        reach = 1.6 * progress
        y = max(0.05, 0.7 + 1.5 * progress - 2.3 * progress ** 2)
        return transform_shape(
            primitive_call('cube', shape_kwargs={'scale': (0.12, 0.06, 0.12)}, color=(0.6, 0.1, 0.1)),
            translation_matrix((0.4 * reach * math.cos(a), y, reach * math.sin(a))) @ rotation_matrix(6 * progress + i, (1, 1, 0), (0, 0, 0)))
    return loop(8, piece)


@register()
def road() -> Shape:
    asphalt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (44, 0.1, 6)}, color=(0.33, 0.33, 0.33)), translation_matrix((0, -0.05, 0)))
    border = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (44, 0.02, 0.12)}, color=(1, 1, 1)), translation_matrix((0, 0.01, -2.7 + 5.4 * i))))
    return concat_shapes(asphalt, border)


@register_animation()
def van_rear_ends_sedan() -> Generator[Shape, None, None]:
    fps, seconds = 20, 3.5
    v, a, t_brake = 6.0, 5.0, 0.8
    t_hit = t_brake + 1.0
    sedan_len = compute_shape_sizes(library_call('sedan'))[0]
    van_min, van_center = compute_shape_min(library_call('van'))[0], 0.0
    start_rear = 0.0
    # distance traveled is positive toward -x
    start_front = start_rear - van_min + sedan_len / 2 + 0.5 * a

    v_front = v - a * 1.0
    m_van, m_sedan = 2.0, 1.3
    v_after = (m_van * v + m_sedan * v_front) / (m_van + m_sedan)
    stop = v_after / 4.5

    for frame in range(int(fps * seconds)):
        t = frame / fps
        tc = min(t, t_hit)
        d_rear = start_rear + v * tc
        d_front = front_position(tc, start_front, v, t_brake, a)
        k = min(max(t - t_hit, 0.0), stop)
        slide = v_after * k - 0.5 * 4.5 * k ** 2
        origin = 12.0
        parts = [
            library_call('road'),
            transform_shape(library_call('van'), translation_matrix((origin - d_rear - slide, 0, 0))),
            transform_shape(library_call('sedan'), translation_matrix((origin - d_front - slide, 0, 0)))]
        if t >= t_hit:
            contact_x = origin - (start_rear + v * t_hit) + van_min
            parts.append(transform_shape(library_call('debris', progress=min(t - t_hit, 1.0)), translation_matrix((contact_x, 0, 0))))
        yield concat_shapes(*parts)
