# Answer of an unnamed frontier model, 2026-11-23, to the request S4-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A tailor-made basketball weigh 10kg is thrown toward a picnic table with many bottles on it, and hit after 1 seconds.
"""


@register()
def basketball() -> Shape:
    body = primitive_call('sphere', shape_kwargs={'radius': 0.3}, color=(1.0, 0.5, 0.1))
    stripe = lambda a, ax: transform_shape(
        primitive_call('cylinder', shape_kwargs={'radius': 0.303, 'p0': (0, -0.01, 0), 'p1': (0, 0.01, 0)}, color=(0.1, 0.05, 0)),
        rotation_matrix(a, ax, (0, 0, 0)))
    return concat_shapes(body, stripe(0, (1, 0, 0)), stripe(math.pi / 2, (1, 0, 0)), stripe(math.pi / 2, (0, 0, 1)))


@register()
def bottle(hue: int) -> Shape:
    color = [(0.0, 0.5, 0.1), (0.6, 0.35, 0.1), (0.1, 0.4, 0.8), (0.8, 0.1, 0.2)][hue % 4]
    body = primitive_call('cylinder', shape_kwargs={'radius': 0.1, 'p0': (0, 0, 0), 'p1': (0, 0.35, 0)}, color=color)
    h = compute_shape_max(body)[1]
    neck = primitive_call('cylinder', shape_kwargs={'radius': 0.04, 'p0': (0, h, 0), 'p1': (0, h + 0.18, 0)}, color=color)
    cap = primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (0, h + 0.18, 0), 'p1': (0, h + 0.22, 0)}, color=(1, 1, 1))
    return concat_shapes(body, neck, cap)


@register()
def picnic_table() -> Shape:
    plank = primitive_call('cube', shape_kwargs={'scale': (4, 0.1, 0.35)}, color=(0.7, 0.5, 0.3))
    top = loop(4, lambda i: transform_shape(plank, translation_matrix((0, 1.45, -0.57 + 0.38 * i))))
    benches = loop(2, lambda i: transform_shape(plank, translation_matrix((0, 0.8, -1.4 + 2.8 * i))))
    leg = primitive_call('cube', shape_kwargs={'scale': (0.12, 1.7, 0.12)}, color=(0.55, 0.38, 0.2))
    legs = loop(4, lambda i: transform_shape(leg, translation_matrix((-1.5 + 3 * (i % 2), 0.7, 0.6 if i < 2 else -0.6))
                                             @ rotation_matrix(-0.5 if i < 2 else 0.5, (1, 0, 0), (0, 0, 0))))
    supports = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, 0.1, 3.1)}, color=(0.55, 0.38, 0.2)), translation_matrix((-1.5 + 3 * i, 0.7, 0))))
    return concat_shapes(top, benches, legs, supports)


@register()
def bottle_rows(n: int, m: int, progress) -> Shape:
    """progress: function (i, j) -> amount of fall in [0, 1]"""
    def one(i, j):
        k = progress(i, j)
        x, z = -1.2 + 0.4 * i, -0.45 + 0.45 * j
        b = library_call('bottle', hue=i + j)
        fan = (j - (m - 1) / 2) * 0.6
        b = transform_shape(b, rotation_matrix(-k * math.pi / 2, (math.sin(-fan), 0, math.cos(fan)), (0.1, 0, 0)))
        lift = 1.5 - min(0.0, compute_shape_min(b)[1])
        far = 1.9 * k * (1 - 0.08 * i)
        px, pz = x + far * math.cos(fan) * 0.8, z + far * math.sin(fan)
        y = lift + 1.6 * k * (1 - k)
        over = max(0.0, px - 1.9) + max(0.0, abs(pz) - 0.7)
        y = max(0.1, y - 3.5 * over) if over > 0 else y
        return transform_shape(b, translation_matrix((px, y, pz)))
    return loop(n, lambda i: loop(m, lambda j: one(i, j)))


@register_animation()
def thrown_basketball() -> Generator[Shape, None, None]:
    frames_per_second = 20
    total_frames = 50
    n, m = 7, 3
    start = np.array([-7.0, 1.0, 0.0])
    impact = np.array([-1.6, 1.8, 0.0])
    after_speed = 3.6
    grass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (18, 0.1, 10)}, color=(0.3, 0.6, 0.3)), translation_matrix((0, -0.05, 0)))
    for frame in range(total_frames):
        t = frame / frames_per_second
        if t < 1:
            pos = start * (1 - t) + impact * t
            pos[1] += 4.9 * t * (1 - t)
        else:
            x = impact[0] + after_speed * (t - 1)
            fall = max(0.0, (x - 2.0) / after_speed)
            pos = np.array([x, max(0.3, 1.8 - 4.9 * fall ** 2), 0.0])

        def progress(i, j):
            reach = 1.0 + 0.4 * i / after_speed + (0.03 if j != 1 else 0.0)
            return min(1.0, max(0.0, (t - reach) / 0.7))

        ball = transform_shape(library_call('basketball'), translation_matrix(pos) @ rotation_matrix(-6 * t, (0, 0, 1), (0, 0, 0)))
        yield concat_shapes(grass, library_call('picnic_table'), library_call('bottle_rows', n=n, m=m, progress=progress), ball)
