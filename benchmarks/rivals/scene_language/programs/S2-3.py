# Answer of an unnamed frontier model, 2026-11-23, to the request S2-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A soccer ball hits a tidy office desk.
"""

DESK_Y = 0.9
G = 9.8


@register()
def desk() -> Shape:
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.4, 0.08, 1.2)}, color=(0.5, 0.3, 0.15)), translation_matrix((0, DESK_Y - 0.04, 0)))
    panels = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.08, DESK_Y - 0.08, 1.1)}, color=(0.4, 0.24, 0.12)),
        translation_matrix(((2 * i - 1) * 1.1, (DESK_Y - 0.08) / 2, 0))))
    back = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.2, 0.5, 0.04)}, color=(0.4, 0.24, 0.12)), translation_matrix((0, 0.55, -0.5)))
    return concat_shapes(top, panels, back)


@register()
def monitor() -> Shape:
    a = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.35, 0.03, 0.22)}, color=(0.3, 0.3, 0.3)), translation_matrix((0, 0.015, 0)))
    b = primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': (0, 0.03, 0), 'p1': (0, 0.25, 0)}, color=(0.3, 0.3, 0.3))
    c = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.85, 0.5, 0.05)}, color=(0.05, 0.05, 0.05)), translation_matrix((0, 0.48, 0)))
    d = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.78, 0.43, 0.01)}, color=(0.1, 0.4, 0.6)), translation_matrix((0, 0.48, 0.03)))
    return concat_shapes(a, b, c, d)


@register()
def keyboard() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.65, 0.03, 0.2)}, color=(0.2, 0.2, 0.22)), translation_matrix((0, 0.015, 0)))


@register()
def mouse() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.08, 0.04, 0.12)}, color=(0.2, 0.2, 0.22)), translation_matrix((0, 0.02, 0)))


@register()
def coffee_cup() -> Shape:
    cup = primitive_call('cylinder', shape_kwargs={'radius': 0.06, 'p0': (0, 0, 0), 'p1': (0, 0.15, 0)}, color=(1, 1, 1))
    coffee = primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (0, 0.145, 0), 'p1': (0, 0.153, 0)}, color=(0.25, 0.13, 0.05))
    return concat_shapes(cup, coffee)


@register()
def books() -> Shape:
    colors = [(0.6, 0.1, 0.15), (0.1, 0.4, 0.3), (0.2, 0.25, 0.6), (0.85, 0.65, 0.1)]
    return loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.06, 0.3 - 0.02 * (i % 2), 0.22)}, color=colors[i]),
        translation_matrix((0.065 * i - 0.1, 0.15 - 0.01 * (i % 2), 0))))


@register()
def soccer_ball() -> Shape:
    r = 0.2
    shell = primitive_call('sphere', shape_kwargs={'radius': r}, color=(0.98, 0.98, 0.98))
    spots = loop(12, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.3 * r}, color=(0.02, 0.02, 0.02)),
        rotation_matrix(i * 2.39996, (0, 1, 0), (0, 0, 0)) @ translation_matrix((
            0.76 * r * math.sqrt(max(0.0, 1 - ((i + 0.5) / 6 - 1) ** 2)), 0.76 * r * ((i + 0.5) / 6 - 1), 0))))
    return concat_shapes(shell, spots)


def make_bodies():
    specs = [
        ('monitor', (0.0, DESK_Y, -0.25), 0.4, 1.0), ('keyboard', (0.0, DESK_Y, 0.2), 0.3, 0.5),
        ('mouse', (0.5, DESK_Y, 0.2), 0.1, 0.2), ('coffee_cup', (-0.6, DESK_Y, 0.25), 0.1, 0.3),
        ('books', (0.8, DESK_Y, -0.2), 0.2, 0.8)]
    return [{'name': n, 'p': np.array(p), 'v': np.zeros(3), 'r': r, 'm': m, 'angle': 0.0, 'w': 0.0, 'axis': (1, 0, 0), 'live': False}
            for n, p, r, m in specs]


def surface(p):
    return DESK_Y if abs(p[0]) < 1.2 and abs(p[2]) < 0.6 else 0.0


def simulate(ball, bodies, dt):
    ball['v'][1] -= G * dt
    ball['p'] = ball['p'] + ball['v'] * dt
    floor = surface(ball['p']) + 0.2
    if ball['p'][1] < floor and ball['v'][1] < 0:
        ball['p'][1] = floor
        ball['v'] = ball['v'] * np.array([0.9, -0.6, 0.9])
    for b in bodies:
        c = b['p'] + np.array([0, min(b['r'], 0.35), 0])
        d = c - ball['p']
        dist = np.linalg.norm(d)
        if dist < b['r'] * 0.7 + 0.2 and not b['live']:
            n = d / dist
            rel = max(0.0, float(np.dot(ball['v'], n)))
            b['v'] = n * rel * 0.9 / (0.5 + b['m']) + np.array([0, 0.8, 0])
            ball['v'] = ball['v'] - n * rel * 1.5 * b['m'] / (0.5 + b['m'])
            b['axis'] = (n[2], 0.1, -n[0])
            b['w'], b['live'] = 1.2 + rel * 0.6, True
        if b['live']:
            b['v'][1] -= G * dt
            b['p'] = b['p'] + b['v'] * dt
            b['angle'] = min(math.pi / 2, b['angle'] + b['w'] * dt)
            if b['p'][1] < surface(b['p']):
                b['p'][1] = surface(b['p'])
                b['v'] = b['v'] * np.array([0.8, 0.0, 0.8])


@register()
def desk_object(name: str, p: P, angle: float, axis: P) -> Shape:
    obj = transform_shape(library_call(name), rotation_matrix(angle, axis, (0, 0, 0)))
    lift = -compute_shape_min(obj)[1]
    return transform_shape(obj, translation_matrix((p[0], p[1] + lift, p[2])))


@register_animation()
def soccer_desk() -> Generator[Shape, None, None]:
    ball = {'p': np.array([-4.5, 0.6, 1.2]), 'v': np.array([5.2, 4.8, -1.5])}
    bodies = make_bodies()
    for frame in range(56):
        shot = transform_shape(library_call('soccer_ball'), translation_matrix(ball['p']) @ rotation_matrix(-0.3 * frame, (0.3, 0, 1), (0, 0, 0)))
        things = loop(len(bodies), lambda i: library_call('desk_object', name=bodies[i]['name'], p=bodies[i]['p'], angle=bodies[i]['angle'], axis=bodies[i]['axis']))
        yield concat_shapes(library_call('desk'), things, shot)
        for _ in range(4):
            simulate(ball, bodies, 1 / 96)
