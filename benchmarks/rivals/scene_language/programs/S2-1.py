# Answer of an unnamed frontier model, 2026-11-23, to the request S2-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A soccer ball hits a tidy office desk.
"""


def box(scale, center, color):
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': scale}, color=color), translation_matrix(center))


@register()
def office_floor() -> Shape:
    return box((12, 0.1, 10), (0, -0.05, 0), (0.6, 0.62, 0.65))


@register()
def office_desk() -> Shape:
    wood = (0.72, 0.53, 0.34)
    top = box((3.2, 0.12, 1.6), (0, 1.14, 0), wood)
    left = box((0.8, 1.08, 1.4), (-1.1, 0.54, 0), (0.6, 0.43, 0.27))
    right = box((0.1, 1.08, 1.4), (1.5, 0.54, 0), (0.6, 0.43, 0.27))
    drawers = loop(3, lambda i: concat_shapes(
        box((0.7, 0.28, 0.04), (-1.1, 0.25 + 0.33 * i, 0.71), wood),
        box((0.2, 0.04, 0.05), (-1.1, 0.25 + 0.33 * i, 0.75), (0.2, 0.2, 0.2))))
    return concat_shapes(top, left, right, drawers)


@register()
def laptop() -> Shape:
    base = box((0.9, 0.04, 0.6), (0, 0.02, 0), (0.6, 0.6, 0.63))
    keys = box((0.78, 0.01, 0.3), (0, 0.045, -0.08), (0.1, 0.1, 0.1))
    lid = concat_shapes(box((0.9, 0.6, 0.03), (0, 0.3, 0), (0.6, 0.6, 0.63)), box((0.82, 0.52, 0.01), (0, 0.3, 0.018), (0.2, 0.35, 0.7)))
    lid = transform_shape(lid, translation_matrix((0, 0.04, -0.3)) @ rotation_matrix(-0.25, (1, 0, 0), (0, 0, 0)))
    return concat_shapes(base, keys, lid)


@register()
def book_stack() -> Shape:
    cols = [(0.7, 0.1, 0.1), (0.1, 0.5, 0.2), (0.1, 0.2, 0.6)]
    return loop(3, lambda i: box((0.5 - 0.03 * i, 0.08, 0.36), (0, 0.04 + 0.08 * i, 0), cols[i]))


@register()
def lamp() -> Shape:
    base = primitive_call('cylinder', shape_kwargs={'radius': 0.18, 'p0': (0, 0, 0), 'p1': (0, 0.04, 0)}, color=(0.1, 0.1, 0.1))
    arm = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0.04, 0), 'p1': (0, 0.7, 0)}, color=(0.1, 0.1, 0.1))
    shade = primitive_call('cylinder', shape_kwargs={'radius': 0.17, 'p0': (0, 0.65, 0), 'p1': (0, 0.85, 0)}, color=(1.0, 0.9, 0.5))
    return concat_shapes(base, arm, shade)


@register()
def mug() -> Shape:
    return primitive_call('cylinder', shape_kwargs={'radius': 0.1, 'p0': (0, 0, 0), 'p1': (0, 0.24, 0)}, color=(0.95, 0.95, 0.9))


@register()
def soccer_ball() -> Shape:
    r = 0.28
    core = primitive_call('sphere', shape_kwargs={'radius': r}, color=(1, 1, 1))
    def patch(theta, phi):
        p = (math.cos(phi) * math.cos(theta), math.sin(phi), math.cos(phi) * math.sin(theta))
        return primitive_call('cylinder', shape_kwargs={'radius': 0.085, 'p0': tuple(0.8 * r * c for c in p), 'p1': tuple(0.985 * r * c for c in p)}, color=(0, 0, 0))
    patches = concat_shapes(
        patch(0, math.pi / 2), patch(0, -math.pi / 2),
        loop(5, lambda i: patch(2 * math.pi * i / 5, 0.46)),
        loop(5, lambda i: patch(2 * math.pi * (i + 0.5) / 5, -0.46)))
    return concat_shapes(core, patches)


# item name, start position, velocity after impact, spin axis, spin rate, impact delay
ITEMS = [
    ('laptop', (-0.1, 1.2, 0.0), (0.3, 1.0, -1.2), (1, 0.2, 0), -3.0, 0.0),
    ('book_stack', (-1.1, 1.2, -0.1), (-0.6, 0.6, -0.6), (0, 1, 0.1), 1.5, 0.05),
    ('lamp', (1.1, 1.2, -0.4), (0.9, 0.5, -0.8), (0.6, 0, -1), 2.4, 0.15),
    ('mug', (0.75, 1.2, 0.3), (1.6, 1.3, -0.3), (0, 0, -1), 5.0, 0.03),
]


@register()
def thrown_item(name: str, start: P, vel: P, axis: P, spin: float, t: float) -> Shape:
    item = library_call(name)
    v = np.array(vel)
    stop = 0.65
    s = min(t, stop)
    item = transform_shape(item, rotation_matrix(spin * s, axis, compute_shape_center(item)))
    p = np.array(start) + v * s + np.array([0, -4.9 * s * s, 0])
    item = transform_shape(item, translation_matrix(p))
    on_desk = abs(p[0]) < 1.6 and abs(p[2]) < 0.8
    low = 1.2 if on_desk else 0.0
    lift = max(0.0, low - compute_shape_min(item)[1])
    return transform_shape(item, translation_matrix((0, lift, 0)))


@register_animation()
def soccer_ball_hits_desk() -> Generator[Shape, None, None]:
    fps, total_frames, hit = 20, 50, 1.0
    p0, ph = np.array([0.5, 0.28, 6.0]), np.array([0.1, 1.55, 0.45])
    v0 = (ph - p0) / hit + np.array([0, 4.9 * hit, 0])
    for frame in range(total_frames):
        t = frame / fps
        if t < hit:
            pos = p0 + v0 * t + np.array([0, -4.9 * t * t, 0])
        else:
            d = t - hit
            pos = ph + np.array([-0.2, 1.2, 2.2]) * d + np.array([0, -4.9 * d * d, 0])
            if pos[1] < 0.28:
                pos[1] = 0.28 + 0.25 * abs(math.sin(5 * d)) * math.exp(-1.5 * d)
        ball = transform_shape(library_call('soccer_ball'), translation_matrix(pos) @ rotation_matrix(-7 * t, (1, 0.3, 0), (0, 0, 0)))
        items = loop(len(ITEMS), lambda i: library_call(
            'thrown_item', name=ITEMS[i][0], start=ITEMS[i][1], vel=ITEMS[i][2], axis=ITEMS[i][3], spin=ITEMS[i][4],
            t=max(0.0, t - hit - ITEMS[i][5])))
        yield concat_shapes(library_call('office_floor'), library_call('office_desk'), items, ball)
