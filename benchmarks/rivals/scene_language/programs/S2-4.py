# Answer of an unnamed frontier model, 2026-11-23, to the request S2-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A soccer ball hits a tidy office desk.
"""


@register()
def tabletop_desk() -> Shape:
    top = primitive_call('cube', shape_kwargs={'scale': (4, 0.15, 2)}, color=(0.6, 0.4, 0.2))
    legs = loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.15, 1.5, 0.15)}, color=(0.45, 0.3, 0.15)),
        translation_matrix((-1.85 + 3.7 * (i % 2), -0.82, -0.85 + 1.7 * (i // 2)))))
    return concat_shapes(top, legs)


@register()
def screen() -> Shape:
    stand = primitive_call('cylinder', shape_kwargs={'radius': 0.06, 'p0': (0, 0, 0), 'p1': (0, 0.4, 0)}, color=(0.3, 0.3, 0.3))
    disc = primitive_call('cylinder', shape_kwargs={'radius': 0.25, 'p0': (0, 0, 0), 'p1': (0, 0.03, 0)}, color=(0.3, 0.3, 0.3))
    panel = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.4, 0.8, 0.08)}, color=(0.1, 0.1, 0.1)), translation_matrix((0, 0.75, 0)))
    display = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.3, 0.7, 0.02)}, color=(0.2, 0.5, 0.9)), translation_matrix((0, 0.75, 0.04)))
    return concat_shapes(stand, disc, panel, display)


@register()
def keyboard() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.1, 0.05, 0.35)}, color=(0.85, 0.85, 0.85)), translation_matrix((0, 0.025, 0)))


@register()
def cup() -> Shape:
    body = primitive_call('cylinder', shape_kwargs={'radius': 0.13, 'p0': (0, 0, 0), 'p1': (0, 0.3, 0)}, color=(0.2, 0.7, 0.5))
    handle = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.1, 0.16, 0.04)}, color=(0.2, 0.7, 0.5)), translation_matrix((0.17, 0.15, 0)))
    return concat_shapes(body, handle)


@register()
def notebook() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.5, 0.06, 0.7)}, color=(0.8, 0.2, 0.25)), translation_matrix((0, 0.03, 0)))


@register()
def football() -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': 0.35}, color=(1, 1, 1))
    faces = [(1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1), (-1, -1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, -1)]
    black = loop(8, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.12}, color=(0, 0, 0)),
        translation_matrix(np.array(faces[i]) / math.sqrt(3) * 0.255)))
    return concat_shapes(ball, black)


@register()
def arrangement(k: float) -> Shape:
    """Items on the desk. k = 0 tidy, k = 1 fully scattered."""
    y = 0.075
    s = transform_shape(library_call('screen'), rotation_matrix(-k * k * math.pi / 2, (1, 0, 0), (0, 0, 0)))
    s = transform_shape(s, translation_matrix((0, y + 0.12 * k - min(0, 0), -0.4 - 0.25 * k)))
    kb = transform_shape(library_call('keyboard'), rotation_matrix(0.6 * k, (0, 1, 0), (0, 0, 0)))
    kb = transform_shape(kb, translation_matrix((0.2 * k, y + 0.5 * k * (1 - k), 0.4 - 0.3 * k)))
    c = transform_shape(library_call('cup'), rotation_matrix(-k * math.pi / 2, (0, 0, 1), (0, 0, 0)))
    c = transform_shape(c, translation_matrix((1.1 + 0.6 * k, y + 0.13 * k + 1.2 * k * (1 - k), 0.3)))
    n = transform_shape(library_call('notebook'), rotation_matrix(-0.9 * k, (0, 1, 0), (0, 0, 0)))
    n = transform_shape(n, translation_matrix((-1.3 - 0.4 * k, y + 0.8 * k * (1 - k), 0.2 - 0.2 * k)))
    return concat_shapes(s, kb, c, n)


@register_animation()
def impact_animation() -> Generator[Shape, None, None]:
    total_frames, impact = 40, 16
    start, target = np.array([1.0, 0.3, 7.0]), np.array([0.1, 0.85, 0.0])
    for frame in range(total_frames):
        if frame <= impact:
            a = frame / impact
            pos = start + (target - start) * a + np.array([0, 1.6 * a * (1 - a), 0])
            k = 0.0
        else:
            b = (frame - impact) / (total_frames - impact - 1)
            k = 1 - (1 - b) ** 3
            pos = target + np.array([-0.6 * b, 0.6 * b - 2.6 * b * b, 3.2 * b])
            if pos[2] < 1.3:
                pos[1] = max(pos[1], 0.425)
            pos[1] = max(pos[1], -1.22)
        ball = transform_shape(library_call('football'), rotation_matrix(-0.4 * frame, (1, 0, 0.2), (0, 0, 0)))
        ball = transform_shape(ball, translation_matrix(pos))
        yield concat_shapes(library_call('tabletop_desk'), library_call('arrangement', k=k), ball)
