# Answer of an unnamed frontier model, 2026-11-23, to the request S5-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are several billiards on the billiard table. The cue ball strikes the black ball, sending it cleanly into the bottom pocket.
"""

BALL_R = 0.11
HALF_X, HALF_Z = 1.3, 2.6
POCKET_R = 0.2
POCKETS = [(sx * HALF_X, sz * HALF_Z) for sz in (-1, 0, 1) for sx in (-1, 1)]


@register()
def table() -> Shape:
    bed = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2 * HALF_X + 0.2, 0.15, 2 * HALF_Z + 0.2)}, color=(0.1, 0.5, 0.25)), translation_matrix((0, -0.075, 0)))
    sides = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.2, 0.3, 2 * HALF_Z + 0.7)}, color=(0.35, 0.18, 0.08)),
                                              translation_matrix(((2 * i - 1) * (HALF_X + 0.25), 0, 0))))
    ends = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (2 * HALF_X + 0.7, 0.3, 0.2)}, color=(0.35, 0.18, 0.08)),
                                             translation_matrix((0, 0, (2 * i - 1) * (HALF_Z + 0.25)))))
    holes = loop(6, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': POCKET_R, 'p0': (POCKETS[i][0], -0.1, POCKETS[i][1]), 'p1': (POCKETS[i][0], 0.006, POCKETS[i][1])}, color=(0, 0, 0)))
    return concat_shapes(bed, sides, ends, holes)


@register()
def billiard(color, mark: bool) -> Shape:
    s = primitive_call('sphere', shape_kwargs={'radius': BALL_R}, color=color)
    if mark:
        s = concat_shapes(s, loop(2, lambda i: transform_shape(
            primitive_call('sphere', shape_kwargs={'radius': BALL_R * 0.45}, color=(1, 1, 1)),
            translation_matrix((0, (2 * i - 1) * BALL_R * 0.62, 0)))))
    return s


def setup():
    """the list of balls: cue ball first, black second"""
    black, pocket = np.array([0.45, 1.3]), np.array([HALF_X, HALF_Z])
    n = (pocket - black) / np.linalg.norm(pocket - black)
    ghost = black - n * 2 * BALL_R
    cue = np.array([-0.35, -0.6])
    u = (ghost - cue) / np.linalg.norm(ghost - cue)
    mk = lambda p, c, v: {'p': np.array(p, dtype=float), 'v': np.array(v, dtype=float), 'y': BALL_R, 'color': c, 'sunk': False, 'rot': identity_matrix()}
    balls = [mk(cue, (1, 1, 0.96), u * 3.4), mk(black, (0.02, 0.02, 0.02), (0, 0))]
    others = [((-0.9, -1.9), (0.95, 0.8, 0.1)), ((0.6, -1.7), (0.1, 0.25, 0.8)), ((0.9, -0.5), (0.85, 0.15, 0.1)),
              ((-0.8, 0.4), (0.45, 0.15, 0.55)), ((-0.6, 1.8), (0.95, 0.5, 0.1)), ((-1.0, 2.0), (0.1, 0.55, 0.3))]
    return balls + [mk(p, c, (0, 0)) for p, c in others]


def step(balls, dt):
    for b in balls:
        if b['sunk']:
            b['y'] = max(-0.5, b['y'] - 2.0 * dt)
            continue
        sp = np.linalg.norm(b['v'])
        if sp > 1e-4:
            move = b['v'] * dt
            b['p'] = b['p'] + move
            b['rot'] = rotation_matrix(np.linalg.norm(move) / BALL_R, (b['v'][1], 0, -b['v'][0]), (0, 0, 0)) @ b['rot']
            b['v'] = b['v'] * max(0.0, 1 - 0.5 * dt / sp)
        for px, pz in POCKETS:
            if np.linalg.norm(b['p'] - np.array([px, pz])) < POCKET_R * 0.6:
                b['sunk'], b['p'] = True, np.array([px, pz])
        if not b['sunk'] and min(np.linalg.norm(b['p'] - np.array(q)) for q in POCKETS) > 1.4 * POCKET_R:
            for k, lim in enumerate((HALF_X, HALF_Z)):
                if abs(b['p'][k]) > lim - BALL_R and b['v'][k] * b['p'][k] > 0:
                    b['v'][k] *= -0.75
    for i in range(len(balls)):
        for j in range(i + 1, len(balls)):
            a, b = balls[i], balls[j]
            d = b['p'] - a['p']
            dist = np.linalg.norm(d)
            if not a['sunk'] and not b['sunk'] and 0 < dist < 2 * BALL_R:
                n = d / dist
                rel = float(np.dot(a['v'] - b['v'], n))
                if rel > 0:
                    a['v'] = a['v'] - n * rel * 0.97
                    b['v'] = b['v'] + n * rel * 0.97


@register()
def all_balls(balls) -> Shape:
    def one(i):
        b = balls[i]
        return transform_shape(library_call('billiard', color=b['color'], mark=i > 0),
                               translation_matrix((b['p'][0], b['y'], b['p'][1])) @ b['rot'])
    return loop(len(balls), one)


@register_animation()
def billiard_simulation() -> Generator[Shape, None, None]:
    balls = setup()
    for frame in range(64):
        yield concat_shapes(library_call('table'), library_call('all_balls', balls=balls))
        for _ in range(20):
            step(balls, 1 / 480)
