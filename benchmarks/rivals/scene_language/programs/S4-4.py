# Answer of an unnamed frontier model, 2026-11-23, to the request S4-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A tailor-made basketball weigh 10kg is thrown toward a picnic table with many bottles on it, and hit after 1 seconds.
"""

BALL = {'radius': 0.22, 'mass': 10.0}
GRAVITY = np.array([0.0, -9.8, 0.0])


@register()
def custom_basketball() -> Shape:
    r = BALL['radius']
    leather = primitive_call('sphere', shape_kwargs={'radius': r}, color=(0.8, 0.38, 0.12))
    def seam(axis):
        a = np.array(axis, dtype=float)
        return primitive_call('cylinder', shape_kwargs={'radius': r * 1.008, 'p0': tuple(-0.007 * a), 'p1': tuple(0.007 * a)}, color=(0.1, 0.1, 0.1))
    gold_cap = transform_shape(primitive_call('sphere', shape_kwargs={'radius': r * 0.35}, color=(0.9, 0.75, 0.2)), translation_matrix((0, 0, r * 0.7)))
    return concat_shapes(leather, seam((1, 0, 0)), seam((0, 1, 0)), seam((0, 0, 1)), gold_cap)


@register()
def wine_bottle() -> Shape:
    g = (0.1, 0.35, 0.15)
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.06, 'p0': (0, 0, 0), 'p1': (0, 0.25, 0)}, color=g),
        primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0.25, 0), 'p1': (0, 0.4, 0)}, color=g),
        primitive_call('cylinder', shape_kwargs={'radius': 0.062, 'p0': (0, 0.08, 0), 'p1': (0, 0.18, 0)}, color=(0.95, 0.92, 0.8)))


@register()
def soda_bottle() -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.07, 'p0': (0, 0, 0), 'p1': (0, 0.22, 0)}, color=(0.75, 0.1, 0.1)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': (0, 0.22, 0), 'p1': (0, 0.3, 0)}, color=(0.9, 0.9, 0.9)))


@register()
def water_bottle() -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.055, 'p0': (0, 0, 0), 'p1': (0, 0.24, 0)}, color=(0.6, 0.8, 0.95)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': (0, 0.24, 0), 'p1': (0, 0.28, 0)}, color=(0.1, 0.3, 0.8)))


@register()
def picnic_table() -> Shape:
    wood, dark = (0.72, 0.5, 0.3), (0.5, 0.32, 0.18)
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.0, 0.08, 2.6)}, color=wood), translation_matrix((0, 0.86, 0)))
    cloth = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.9, 0.01, 2.4)}, color=(0.9, 0.9, 0.95)), translation_matrix((0, 0.9, 0)))
    benches = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.32, 0.06, 2.6)}, color=wood), translation_matrix((-0.85 + 1.7 * i, 0.48, 0))))
    def frame(i):
        z = -1.0 + 2.0 * i
        return concat_shapes(
            primitive_call('cylinder', shape_kwargs={'radius': 0.045, 'p0': (-0.7, 0, z), 'p1': (0.3, 0.82, z)}, color=dark),
            primitive_call('cylinder', shape_kwargs={'radius': 0.045, 'p0': (0.7, 0, z), 'p1': (-0.3, 0.82, z)}, color=dark),
            primitive_call('cylinder', shape_kwargs={'radius': 0.045, 'p0': (-0.95, 0.42, z), 'p1': (0.95, 0.42, z)}, color=dark))
    return concat_shapes(top, cloth, benches, loop(2, frame))


def ballistic(p0, v0, t, floor):
    """free flight stopped at the floor height"""
    p = p0 + v0 * t + 0.5 * GRAVITY * t * t
    if p[1] < floor:
        disc = math.sqrt(max(0.0, v0[1] ** 2 + 2 * 9.8 * (p0[1] - floor)))
        tl = (v0[1] + disc) / 9.8
        p = p0 + v0 * tl + 0.5 * GRAVITY * tl * tl
    return p


@register()
def scattered_bottles(hit_pos: P, hit_vel: P, elapsed: float) -> Shape:
    kinds = ['wine_bottle', 'soda_bottle', 'water_bottle']
    speed = float(np.linalg.norm(hit_vel))

    def one(k):
        base = np.array([-0.3 + 0.2 * (k % 4), 0.905, -0.9 + 0.36 * (k // 4)])
        away = base - np.array(hit_pos)
        away[1] = 0
        dist = float(np.linalg.norm(away)) + 0.1
        # momentum transfer from the 10 kg ball: nearly 2x speed for a light bottle, fading with distance
        gain = 2 * BALL['mass'] / (BALL['mass'] + 0.5) * math.exp(-1.6 * dist)
        v = away / dist * speed * 0.35 * gain + np.array([hit_vel[0] * 0.25 * gain, 0.35 * speed * gain, 0])
        tau = max(0.0, elapsed - dist * 0.1)
        p = ballistic(base, v, tau, 0.0 if np.linalg.norm(v) > 1.2 else 0.905)
        angle = min(math.pi / 2 + (math.pi if gain > 0.8 else 0.0), tau * (3 + 4 * gain))
        b = transform_shape(library_call(kinds[k % 3]), rotation_matrix(angle, (v[2], 0.05, -v[0] - 0.01), (0, 0, 0)))
        return transform_shape(b, translation_matrix((p[0], p[1] - compute_shape_min(b)[1], p[2])))

    return loop(24, one)


@register_animation()
def basketball_vs_bottles() -> Generator[Shape, None, None]:
    fps, hit_time = 24, 1.0
    start, hit = np.array([-5.5, 1.4, 0.3]), np.array([-0.45, 1.13, 0.0])
    v0 = (hit - start - 0.5 * GRAVITY * hit_time ** 2) / hit_time
    v_hit = v0 + GRAVITY * hit_time
    lawn = transform_shape(primitive_call('cube', shape_kwargs={'scale': (14, 0.1, 9)}, color=(0.35, 0.6, 0.25)), translation_matrix((0, -0.05, 0)))
    for frame in range(60):
        t = frame / fps
        if t < hit_time:
            pos = start + v0 * t + 0.5 * GRAVITY * t * t
        else:
            pos = ballistic(hit, np.array([0.8 * v_hit[0], 0.25 * abs(v_hit[1]), 0.8 * v_hit[2]]), t - hit_time, BALL['radius'])
        ball = transform_shape(library_call('custom_basketball'), translation_matrix(pos) @ rotation_matrix(-5 * t, (0, 0, 1), (0, 0, 0)))
        yield concat_shapes(lawn, library_call('picnic_table'),
                            library_call('scattered_bottles', hit_pos=hit, hit_vel=v_hit, elapsed=max(0.0, t - hit_time)), ball)
