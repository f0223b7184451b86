# Answer of an unnamed frontier model, 2026-11-23, to the request S1-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A bowling ball rolls toward a set of bowling pins and hits them.
"""

BALL_R = 0.4
PIN_R = 0.15


@register()
def bowling_pin() -> Shape:
    profile = [(0.0, 0.11), (0.15, 0.15), (0.3, 0.15), (0.45, 0.11), (0.6, 0.075), (0.7, 0.07)]
    body = loop(len(profile), lambda i: primitive_call(
        'cylinder',
        shape_kwargs={'radius': profile[i][1], 'p0': (0, profile[i][0], 0), 'p1': (0, profile[i][0] + 0.15, 0)},
        color=(0.9, 0.1, 0.1) if i == 4 else (0.97, 0.97, 0.94)))
    head = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.1}, color=(0.97, 0.97, 0.94)),
                           translation_matrix((0, 0.9, 0)))
    return concat_shapes(body, head)


@register()
def bowling_ball() -> Shape:
    sphere = primitive_call('sphere', shape_kwargs={'radius': BALL_R}, color=(0.05, 0.05, 0.08))
    holes = loop(3, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': 0.05}, color=(0.8, 0.8, 0.8)),
        translation_matrix(([-0.08, 0.08, 0.0][i], BALL_R * 0.94, [0.06, 0.06, -0.1][i]))))
    return concat_shapes(sphere, holes)


@register()
def alley() -> Shape:
    boards = loop(8, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (16, 0.1, 0.3)},
                       color=(0.8, 0.6, 0.35) if i % 2 == 0 else (0.75, 0.54, 0.3)),
        translation_matrix((0, -0.05, -1.05 + 0.3 * i))))
    back = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.1, 2, 3)}, color=(0.2, 0.2, 0.25)),
                           translation_matrix((8, 0.95, 0)))
    return concat_shapes(boards, back)


def initial_state():
    pins = []
    for row in range(4):
        for k in range(row + 1):
            pins.append({'p': np.array([4.0 + 0.5 * row, 0.0, (k - row / 2) * 0.55]),
                         'v': np.zeros(3), 'angle': 0.0, 'hit': False})
    ball = {'p': np.array([-6.0, BALL_R, 0.06]), 'v': np.array([5.0, 0.0, 0.0])}
    return ball, pins


def hit(a_p, a_v, b, dist, gain):
    d = b['p'] - a_p
    d[1] = 0
    n = np.linalg.norm(d)
    if 1e-6 < n < dist:
        d = d / n
        rel = float(np.dot(a_v - b['v'], d))
        if rel > 0:
            b['v'] = b['v'] + d * rel * gain
            b['hit'] = True
            return d * rel
    return np.zeros(3)


def step(ball, pins, dt):
    ball['p'] = ball['p'] + ball['v'] * dt
    for pin in pins:
        ball['v'] = ball['v'] - 0.15 * hit(ball['p'], ball['v'], pin, BALL_R + PIN_R, 1.0)
    for a in pins:
        for b in pins:
            if a is not b and a['hit']:
                a['v'] = a['v'] - 0.5 * hit(a['p'], a['v'], b, 2 * PIN_R + 0.12, 0.7)
    for pin in pins:
        pin['p'] = pin['p'] + pin['v'] * dt
        if pin['hit']:
            pin['angle'] = min(math.pi / 2, pin['angle'] + 5.0 * dt)
            pin['v'] = pin['v'] * (1 - 1.2 * dt)
    if ball['p'][0] > 7.5:
        ball['v'] = np.zeros(3)


@register()
def posed_pin(pos: P, vel: P, angle: float) -> Shape:
    axis = (vel[2], 0, -vel[0]) if np.linalg.norm(vel) > 1e-6 else (0, 0, -1)
    tipped = transform_shape(library_call('bowling_pin'), rotation_matrix(angle, axis, (0, 0, 0)))
    lift = max(0.0, -compute_shape_min(tipped)[1])
    return transform_shape(tipped, translation_matrix((pos[0], lift, pos[2])))


@register_animation()
def strike() -> Generator[Shape, None, None]:
    ball, pins = initial_state()
    total_frames, substeps, dt = 72, 4, 1 / 96
    for frame in range(total_frames):
        roll = rotation_matrix(-(ball['p'][0] + 6.0) / BALL_R, (0, 0, 1), (0, 0, 0))
        ball_shape = transform_shape(library_call('bowling_ball'), translation_matrix(ball['p']) @ roll)
        pin_shapes = loop(len(pins), lambda i: library_call('posed_pin', pos=pins[i]['p'], vel=pins[i]['v'], angle=pins[i]['angle']))
        yield concat_shapes(library_call('alley'), ball_shape, pin_shapes)
        for _ in range(substeps):
            step(ball, pins, dt)
