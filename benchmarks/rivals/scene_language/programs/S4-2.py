# Answer of an unnamed frontier model, 2026-11-23, to the request S4-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A tailor-made basketball weigh 10kg is thrown toward a picnic table with many bottles on it, and hit after 1 seconds.
"""

H = 0.8


def cube(scale, pos, color):
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': scale}, color=color), translation_matrix(pos))


@register()
def table_half(side: int) -> Shape:
    """half a picnic table; side = -1 left, +1 right"""
    top = loop(4, lambda i: cube((1.2, 0.07, 0.26), (side * 0.6, H - 0.035, -0.42 + 0.28 * i), (0.66, 0.46, 0.26)))
    leg = loop(2, lambda i: cube((0.1, H - 0.07, 0.1), (side * 1.05, (H - 0.07) / 2, -0.4 + 0.8 * i), (0.5, 0.34, 0.2)))
    bench = loop(2, lambda i: cube((1.2, 0.06, 0.3), (side * 0.6, 0.42, -0.95 + 1.9 * i), (0.66, 0.46, 0.26)))
    brace = cube((0.08, 0.08, 2.1), (side * 1.05, 0.36, 0), (0.5, 0.34, 0.2))
    return concat_shapes(top, leg, bench, brace)


@register()
def picnic_table(collapse: float) -> Shape:
    """collapse 0..1: the heavy ball breaks the table in the middle"""
    def half(i):
        side = 2 * i - 1
        return transform_shape(library_call('table_half', side=side), rotation_matrix(side * 0.35 * collapse, (0, 0, 1), (side * 1.1, 0.1, 0)))
    return loop(2, half)


@register()
def bottle(color) -> Shape:
    body = primitive_call('cylinder', shape_kwargs={'radius': 0.055, 'p0': (0, 0, 0), 'p1': (0, 0.2, 0)}, color=color)
    neck = primitive_call('cylinder', shape_kwargs={'radius': 0.022, 'p0': (0, 0.2, 0), 'p1': (0, 0.31, 0)}, color=color)
    cap = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.028}, color=(0.95, 0.85, 0.1)), translation_matrix((0, 0.31, 0)))
    return concat_shapes(body, neck, cap)


@register()
def basketball() -> Shape:
    s = primitive_call('sphere', shape_kwargs={'radius': 0.2}, color=(0.85, 0.4, 0.08))
    hoops = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.202, 'p0': (-0.005 * (1 - i), 0, -0.005 * i), 'p1': (0.005 * (1 - i), 0, 0.005 * i)}, color=(0, 0, 0)))
    equator = primitive_call('cylinder', shape_kwargs={'radius': 0.202, 'p0': (0, -0.005, 0), 'p1': (0, 0.005, 0)}, color=(0, 0, 0))
    badge = cube((0.12, 0.06, 0.02), (0.06, 0.07, 0.18), (1, 0.9, 0.3))
    return concat_shapes(s, hoops, equator, badge)


def bottle_layout():
    pts = []
    for i in range(8):
        for j in range(3):
            pts.append((-1.0 + 2.0 * i / 7, -0.3 + 0.3 * j))
    return pts


@register()
def bottles(d: float) -> Shape:
    layout = bottle_layout()

    def one(k):
        x, z = layout[k]
        r = math.hypot(x, z) + 0.15
        e = max(0.0, d - 0.12 * r)
        vx, vz = 1.1 * x / r + 0.5, 0.9 * z / r + 0.15 * ((k % 3) - 1)
        vy = 2.6 / (0.6 + r)
        y = H + vy * e - 4.9 * e * e
        flight = (vy + math.sqrt(vy * vy + 19.6 * H)) / 9.8
        e2 = min(e, flight)
        y = max(0.0, H + vy * e2 - 4.9 * e2 * e2)
        roll = max(0.0, e - flight)
        slide = 0.3 * (1 - math.exp(-2 * roll))
        angle = (math.pi / 2) * min(1.0, 1.2 * e2 / flight) if e > 0 else 0.0
        b = transform_shape(library_call('bottle', color=(0.1 + 0.25 * (k % 3), 0.55 - 0.1 * (k % 4), 0.2 + 0.2 * (k % 2))),
                            rotation_matrix(angle, (vz, 0.0, -vx), (0, 0, 0)))
        return transform_shape(b, translation_matrix((x + vx * (e2 + slide), y + 0.055 * math.sin(angle), z + vz * (e2 + slide))))

    return loop(len(layout), one)


@register_animation()
def basketball_smash() -> Generator[Shape, None, None]:
    fps, total = 24, 54
    start, end = np.array([-5.0, 1.0, 0.0]), np.array([0.0, H + 0.2, 0.0])
    ground = cube((12, 0.1, 6), (0, -0.05, 0), (0.4, 0.65, 0.3))
    for frame in range(total):
        t = frame / fps
        if t <= 1.0:
            pos = start + (end - start) * t + np.array([0, 4.9 * t * (1 - t), 0])
            d = 0.0
        else:
            d = t - 1.0
            pos = end + np.array([0.5 * (1 - math.exp(-2 * d)), 0, 0])
            pos[1] = max(0.45, end[1] - 4.0 * d * d)
        collapse = min(1.0, (d / 0.35) ** 2) if d > 0 else 0.0
        ball = transform_shape(library_call('basketball'), rotation_matrix(-4 * min(t, 1.3), (0, 0, 1), (0, 0, 0)))
        ball = transform_shape(ball, translation_matrix(pos))
        yield concat_shapes(ground, library_call('picnic_table', collapse=collapse), library_call('bottles', d=d), ball)
