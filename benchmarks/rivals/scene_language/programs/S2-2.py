# Answer of an unnamed frontier model, 2026-11-23, to the request S2-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A soccer ball hits a tidy office desk.
"""


@register()
def desk(width: float, height: float, depth: float) -> Shape:
    top = primitive_call('cube', shape_kwargs={'scale': (width, 0.08, depth)}, color=(0.9, 0.88, 0.82))
    top = transform_shape(top, translation_matrix((0, height - 0.04, 0)))
    leg = lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.05,
        'p0': ((-1) ** i * (width / 2 - 0.1), 0, (-1) ** (i // 2) * (depth / 2 - 0.1)),
        'p1': ((-1) ** i * (width / 2 - 0.1), height - 0.08, (-1) ** (i // 2) * (depth / 2 - 0.1))}, color=(0.2, 0.2, 0.22))
    return concat_shapes(top, loop(4, leg))


@register()
def computer() -> Shape:
    black = (0.08, 0.08, 0.1)
    foot = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.4, 0.03, 0.25)}, color=black), translation_matrix((0, 0.015, 0)))
    neck = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.06, 0.3, 0.04)}, color=black), translation_matrix((0, 0.17, -0.05)))
    panel = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.0, 0.6, 0.05)}, color=black), translation_matrix((0, 0.55, 0)))
    glow = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.94, 0.54, 0.01)}, color=(0.5, 0.8, 0.95)), translation_matrix((0, 0.55, 0.03)))
    return concat_shapes(foot, neck, panel, glow)


@register()
def paper_stack(n: int) -> Shape:
    return loop(n, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.3, 0.015, 0.42)}, color=(1, 1, 1 - 0.03 * (i % 3))),
        translation_matrix((0, 0.008 + 0.016 * i, 0))))


@register()
def paper_storm(n: int, t: float) -> Shape:
    def sheet(i):
        s = primitive_call('cube', shape_kwargs={'scale': (0.3, 0.015, 0.42)}, color=(1, 1, 1 - 0.03 * (i % 3)))
        a = i * 2.4
        rot = rotation_matrix(t * (2 + i % 4), (math.sin(a), 0.4, math.cos(a)), (0, 0, 0))
        y = 0.008 + 0.016 * i + (1.4 + 0.1 * i) * t - 1.5 * t * t
        return transform_shape(s, translation_matrix((0.7 * math.cos(a) * t + 0.5 * t, max(-0.99, y), 0.7 * math.sin(a) * t)) @ rot)
    return loop(n, sheet)


@register()
def pencil_cup() -> Shape:
    cup = primitive_call('cylinder', shape_kwargs={'radius': 0.09, 'p0': (0, 0, 0), 'p1': (0, 0.22, 0)}, color=(0.2, 0.45, 0.75))
    pencils = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.014, 'p0': (0.03 * math.cos(i * 1.57), 0.1, 0.03 * math.sin(i * 1.57)),
        'p1': (0.07 * math.cos(i * 1.57), 0.38, 0.07 * math.sin(i * 1.57))}, color=(0.95, 0.75, 0.1)))
    return concat_shapes(cup, pencils)


@register()
def plant() -> Shape:
    pot = primitive_call('cylinder', shape_kwargs={'radius': 0.13, 'p0': (0, 0, 0), 'p1': (0, 0.2, 0)}, color=(0.7, 0.35, 0.2))
    leaves = loop(5, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.12}, color=(0.15, 0.5 + 0.05 * i, 0.2)),
        translation_matrix((0.1 * math.cos(i * 1.256), 0.3 + 0.04 * (i % 2), 0.1 * math.sin(i * 1.256)))))
    return concat_shapes(pot, leaves)


@register()
def soccer_ball(radius: float) -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': radius}, color=(1, 1, 1))
    def ring(lat, n, off):
        return loop(n, lambda i: transform_shape(
            primitive_call('sphere', shape_kwargs={'radius': 0.28 * radius}, color=(0, 0, 0)),
            translation_matrix((0.78 * radius * math.cos(lat) * math.cos(6.283 * i / n + off), 0.78 * radius * math.sin(lat), 0.78 * radius * math.cos(lat) * math.sin(6.283 * i / n + off)))))
    return concat_shapes(ball, ring(1.57, 1, 0), ring(0.46, 5, 0), ring(-0.46, 5, 0.628), ring(-1.57, 1, 0))


def tipped(shape, amount, axis, pos):
    """tips a shape about its base edge, then sets it at pos"""
    s = transform_shape(shape, rotation_matrix(amount * math.pi / 2, axis, (0, 0, 0)))
    return transform_shape(s, translation_matrix((pos[0], pos[1] - compute_shape_min(s)[1], pos[2])))


@register_animation()
def scene() -> Generator[Shape, None, None]:
    H = 1.0
    total, hit = 48, 20
    for f in range(total):
        t = (f - hit) / 20
        d = max(0.0, t)
        k = min(1.0, d / 0.5)
        table = library_call('desk', width=3, height=H, depth=1.5)
        # the desk itself jolts a little
        jolt = translation_matrix((0.12 * (1 - math.exp(-6 * d)) + 0.03 * math.exp(-4 * d) * math.sin(30 * d), 0, 0))
        screen = tipped(library_call('computer'), -k ** 2, (0.2, 0, 1), (0.2 + 0.3 * k, H, -0.3))
        papers = transform_shape(library_call('paper_storm', n=8, t=d) if d > 0 else library_call('paper_stack', n=8), translation_matrix((-0.8, H, 0.25)))
        cup = tipped(library_call('pencil_cup'), -min(1.0, d / 0.35), (0, 0, 1), (-0.3 + 0.5 * k, H, 0.4))
        green = tipped(library_call('plant'), -min(1.0, max(0.0, d - 0.4) / 0.5), (0.3, 0, 1), (1.15, H, -0.2))
        if t < 0:
            pos = (-1.0 + 5 * t, 1.35 - 0.5 * t * (t + 1) * 3, 0.2)
        else:
            pos = (-1.0 + 0.5 * min(d, 0.3) - 2.0 * max(0, d - 0.3), max(0.22, 1.35 + 0.9 * d - 3.5 * d * d) if d > 0.3 else 1.35 + 0.1 * d, 0.2 + 0.3 * d)
        ball = transform_shape(library_call('soccer_ball', radius=0.22), translation_matrix(pos) @ rotation_matrix(-0.35 * f, (0, 0, 1), (0, 0, 0)))
        yield concat_shapes(transform_shape(concat_shapes(table, screen, cup, green), jolt), papers, ball)
