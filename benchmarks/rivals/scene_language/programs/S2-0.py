# Answer of an unnamed frontier model, 2026-11-23, to the request S2-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A soccer ball hits a tidy office desk.
"""

TOP = 1.0


@register()
def desk() -> Shape:
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3, 0.1, 1.5)}, color=(0.55, 0.36, 0.2)), translation_matrix((0, TOP - 0.05, 0)))
    legs = loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, TOP - 0.1, 0.1)}, color=(0.3, 0.3, 0.3)),
        translation_matrix(((i % 2) * 2.8 - 1.4, (TOP - 0.1) / 2, (i // 2) * 1.3 - 0.65))))
    return concat_shapes(top, legs)


@register()
def monitor() -> Shape:
    base = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.5, 0.04, 0.3)}, color=(0.2, 0.2, 0.2)), translation_matrix((0, 0.02, 0)))
    stand = primitive_call('cylinder', shape_kwargs={'radius': 0.04, 'p0': (0, 0.04, 0), 'p1': (0, 0.3, 0)}, color=(0.2, 0.2, 0.2))
    frame = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.1, 0.65, 0.06)}, color=(0.1, 0.1, 0.1)), translation_matrix((0, 0.6, 0)))
    screen = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.02, 0.57, 0.02)}, color=(0.3, 0.6, 0.9)), translation_matrix((0, 0.6, 0.03)))
    return concat_shapes(base, stand, frame, screen)


@register()
def keyboard() -> Shape:
    board = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.9, 0.04, 0.3)}, color=(0.15, 0.15, 0.15)), translation_matrix((0, 0.02, 0)))
    keys = loop(3, lambda r: loop(10, lambda c: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.07, 0.02, 0.07)}, color=(0.9, 0.9, 0.9)),
        translation_matrix((-0.38 + 0.085 * c, 0.05, -0.09 + 0.09 * r)))))
    return concat_shapes(board, keys)


@register()
def mug() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.09, 'p0': (0, 0, 0), 'p1': (0, 0.22, 0)}, color=(0.9, 0.2, 0.2))


@register()
def pen_holder() -> Shape:
    cup = primitive_call('cylinder', shape_kwargs={'radius': 0.08, 'p0': (0, 0, 0), 'p1': (0, 0.2, 0)}, color=(0.3, 0.3, 0.35))
    colors = [(0.1, 0.2, 0.9), (0.9, 0.7, 0.1), (0.1, 0.7, 0.2)]
    pens = loop(3, lambda i: primitive_call('cylinder', shape_kwargs={'radius': 0.015, 'p0': (0.03 * (i - 1), 0.1, 0), 'p1': (0.06 * (i - 1), 0.36, 0.02 * i)}, color=colors[i]))
    return concat_shapes(cup, pens)


@register()
def soccer_ball(radius: float) -> Shape:
    white = primitive_call('sphere', shape_kwargs={'radius': radius}, color=(1, 1, 1))
    g = (1 + math.sqrt(5)) / 2
    dirs = [np.array(d) / math.sqrt(1 + g * g) for s in (1, -1) for q in (g, -g) for d in ((0, s, q), (s, q, 0), (q, 0, s))]
    spots = loop(12, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': radius * 0.3}, color=(0.05, 0.05, 0.05)),
        translation_matrix(dirs[i] * radius * 0.76)))
    return concat_shapes(white, spots)


def ball_position(t):
    # flies in from the left, hits monitor at t = 1, then bounces back and drops
    if t < 1.0:
        return (-5 + 4.1 * t, 1.2 + 2.0 * t - 1.6 * t * t, 1.0 - 0.8 * t)
    d = t - 1.0
    return (-0.9 - 1.3 * d, max(0.25, 1.6 + 0.6 * d - 4.9 * d * d), 0.2 + 1.4 * d)


@register()
def desk_items(d: float) -> Shape:
    """d: seconds since impact"""
    fall = min(1.0, d / 0.6) ** 2
    mon = library_call('monitor')
    mon = transform_shape(mon, rotation_matrix(-fall * math.pi / 2, (0, 0, 1), (0.25, 0, 0)))
    mon = transform_shape(mon, translation_matrix((-0.2 + 0.25 * fall, TOP, -0.35)))
    kb = transform_shape(library_call('keyboard'), rotation_matrix(-0.5 * fall, (0, 1, 0), (0, 0, 0)))
    kb = transform_shape(kb, translation_matrix((-0.2 + 0.3 * fall, TOP, 0.35)))
    cup = transform_shape(library_call('mug'), rotation_matrix(-fall * math.pi / 2, (0, 0, 1), (0.09, 0, 0)))
    cup = transform_shape(cup, translation_matrix((0.7 + 0.35 * fall, TOP, 0.3)))
    late = min(1.0, max(0.0, d - 0.3) / 0.4)
    pens = transform_shape(library_call('pen_holder'), rotation_matrix(-late * math.pi / 2, (0, 0, 1), (0.08, 0, 0)))
    pens = transform_shape(pens, translation_matrix((1.0 + 0.1 * late, TOP, -0.3)))
    return concat_shapes(mon, kb, cup, pens)


@register_animation()
def ball_hits_desk() -> Generator[Shape, None, None]:
    total_frames, fps = 60, 24
    for frame in range(total_frames):
        t = frame / fps
        ball = transform_shape(library_call('soccer_ball', radius=0.25), rotation_matrix(-6 * t, (0, 0.2, 1), (0, 0, 0)))
        ball = transform_shape(ball, translation_matrix(ball_position(t)))
        yield concat_shapes(library_call('desk'), library_call('desk_items', d=max(0.0, t - 1.0)), ball)
