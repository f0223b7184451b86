# Answer of an unnamed frontier model, 2026-11-23, to the request S4-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A tailor-made basketball weigh 10kg is thrown toward a picnic table with many bottles on it, and hit after 1 seconds.
"""

TABLE_H = 1.0
BALL_R = 0.25
BALL_M, BOTTLE_M = 10.0, 0.6


@register()
def basketball() -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': BALL_R}, color=(0.9, 0.45, 0.1))
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    seams = loop(3, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': BALL_R * 1.005, 'p0': tuple(-0.008 * a for a in axes[i]), 'p1': tuple(0.008 * a for a in axes[i])}, color=(0.05, 0.05, 0.05)))
    return concat_shapes(ball, seams)


@register()
def picnic_table() -> Shape:
    wood = (0.6, 0.4, 0.22)
    planks = loop(5, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (3, 0.08, 0.22)}, color=wood), translation_matrix((0, TABLE_H - 0.04, -0.48 + 0.24 * i))))
    benches = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (3, 0.08, 0.4)}, color=wood), translation_matrix((0, 0.5, -1.1 + 2.2 * i))))
    legs = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.06, 'p0': (-1.2 if i % 2 else 1.2, 0, -1.0 if i < 2 else 1.0), 'p1': (-1.2 if i % 2 else 1.2, TABLE_H - 0.08, -0.3 if i < 2 else 0.3)}, color=(0.45, 0.3, 0.15)))
    beams = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.08, 0.08, 2.4)}, color=(0.45, 0.3, 0.15)), translation_matrix((-1.2 + 2.4 * i, 0.43, 0))))
    return concat_shapes(planks, benches, legs, beams)


@register()
def bottle(color) -> Shape:
    body = primitive_call('cylinder', shape_kwargs={'radius': 0.08, 'p0': (0, 0, 0), 'p1': (0, 0.28, 0)}, color=color)
    neck = primitive_call('cylinder', shape_kwargs={'radius': 0.035, 'p0': (0, 0.28, 0), 'p1': (0, 0.42, 0)}, color=color)
    cap = primitive_call('cylinder', shape_kwargs={'radius': 0.04, 'p0': (0, 0.42, 0), 'p1': (0, 0.45, 0)}, color=(0.9, 0.9, 0.2))
    label = primitive_call('cylinder', shape_kwargs={'radius': 0.083, 'p0': (0, 0.1, 0), 'p1': (0, 0.2, 0)}, color=(1, 1, 1))
    return concat_shapes(body, neck, cap, label)


@register()
def grass() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (14, 0.1, 8)}, color=(0.3, 0.6, 0.25)), translation_matrix((0, -0.05, 0)))


def make_bottles():
    return [{'p': np.array([-0.6 + 0.3 * i, TABLE_H, -0.3 + 0.3 * j]), 'v': np.zeros(3), 'a': 0.0, 'hit': False} for i in range(6) for j in range(3)]


def on_table(p):
    return abs(p[0]) < 1.5 and abs(p[2]) < 0.6


def advance(ball, bottles, dt):
    ball['v'][1] -= 9.8 * dt
    ball['p'] = ball['p'] + ball['v'] * dt
    ground = (TABLE_H if on_table(ball['p']) and ball['p'][1] > TABLE_H - 0.1 else 0.0) + BALL_R
    if ball['p'][1] < ground:
        ball['p'][1] = ground
        ball['v'][1] = -0.25 * ball['v'][1]
    for k, b in enumerate(bottles):
        sources = [(ball['p'], ball['v'], BALL_R + 0.08, BALL_M)] + [(o['p'], o['v'], 0.17, BOTTLE_M) for o in bottles if o['hit'] and o is not b]
        for p, v, reach, mass in sources:
            d = b['p'] - p
            d[1] = 0.0
            n = np.linalg.norm(d)
            if 1e-4 < n < reach and abs(b['p'][1] - p[1]) < 0.5:
                d = d / n
                rel = float(np.dot(v - b['v'], d))
                if rel > 0.2:
                    b['v'] = b['v'] + d * rel * 1.3 * mass / (mass + BOTTLE_M) + np.array([0, 0.15 * rel, 0])
                    b['hit'] = True
                    if mass == BALL_M:
                        ball['v'] = ball['v'] - d * rel * 1.3 * BOTTLE_M / (mass + BOTTLE_M)
        if b['hit']:
            b['v'][1] -= 9.8 * dt
            b['p'] = b['p'] + b['v'] * dt
            b['a'] += 7 * dt
            g = TABLE_H if on_table(b['p']) and b['p'][1] > TABLE_H - 0.15 else 0.0
            if b['p'][1] < g:
                b['p'][1] = g
                b['v'] = b['v'] * np.array([0.85, -0.2, 0.85])
                b['a'] = min(b['a'], math.pi / 2)


@register()
def posed_bottle(index: int, p: P, v: P, a: float) -> Shape:
    colors = [(0.1, 0.5, 0.2), (0.5, 0.3, 0.1), (0.2, 0.4, 0.8)]
    axis = (v[2], 0, -v[0]) if abs(v[0]) + abs(v[2]) > 1e-4 else (0, 0, -1)
    s = transform_shape(library_call('bottle', color=colors[index % 3]), rotation_matrix(a, axis, (0, 0, 0)))
    return transform_shape(s, translation_matrix((p[0], p[1] - compute_shape_min(s)[1], p[2])))


@register_animation()
def throw() -> Generator[Shape, None, None]:
    fps, substeps = 24, 5
    start, target, t_hit = np.array([-6.0, 1.2, 0.05]), np.array([-0.95, 1.3, 0.02]), 1.0
    v0 = (target - start) / t_hit + np.array([0, 0.5 * 9.8 * t_hit, 0])
    ball, bottles = {'p': start, 'v': v0}, make_bottles()
    for frame in range(int(2.5 * fps)):
        b = transform_shape(library_call('basketball'), translation_matrix(ball['p']) @ rotation_matrix(-0.25 * frame, (0.1, 0.2, 1), (0, 0, 0)))
        items = loop(len(bottles), lambda i: library_call('posed_bottle', index=i, p=bottles[i]['p'], v=bottles[i]['v'], a=bottles[i]['a']))
        yield concat_shapes(library_call('grass'), library_call('picnic_table'), items, b)
        for _ in range(substeps):
            advance(ball, bottles, 1 / (fps * substeps))
