# Answer of an unnamed frontier model, 2026-11-23, to the request S4-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A tailor-made basketball weigh 10kg is thrown toward a picnic table with many bottles on it, and hit after 1 seconds.
"""


@register()
def picnic_table() -> Shape:
    c = (0.65, 0.45, 0.25)
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.4, 0.1, 1.2)}, color=c), translation_matrix((0, 0.95, 0)))
    seat = lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (2.4, 0.08, 0.35)}, color=c), translation_matrix((0, 0.5, 0.95 * (2 * i - 1))))
    def trestle(i):
        x = 0.9 * (2 * i - 1)
        return concat_shapes(
            primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (x, 0, 0.7), 'p1': (x, 0.9, 0.2)}, color=(0.5, 0.33, 0.18)),
            primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (x, 0, -0.7), 'p1': (x, 0.9, -0.2)}, color=(0.5, 0.33, 0.18)),
            primitive_call('cylinder', shape_kwargs={'radius': 0.05, 'p0': (x, 0.45, -1.1), 'p1': (x, 0.45, 1.1)}, color=(0.5, 0.33, 0.18)))
    return concat_shapes(top, loop(2, seat), loop(2, trestle))


@register()
def bottle(color) -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.07, 'p0': (0, 0, 0), 'p1': (0, 0.25, 0)}, color=color),
        transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.07}, color=color), translation_matrix((0, 0.25, 0))),
        primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': (0, 0.3, 0), 'p1': (0, 0.42, 0)}, color=color),
        primitive_call('cylinder', shape_kwargs={'radius': 0.035, 'p0': (0, 0.42, 0), 'p1': (0, 0.45, 0)}, color=(0.9, 0.1, 0.1)))


@register()
def basketball(radius: float) -> Shape:
    orange = primitive_call('sphere', shape_kwargs={'radius': radius}, color=(0.93, 0.5, 0.13))
    line = primitive_call('cylinder', shape_kwargs={'radius': radius * 1.01, 'p0': (0, 0, -0.006), 'p1': (0, 0, 0.006)}, color=(0, 0, 0))
    lines = loop(4, lambda i: transform_shape(line, rotation_matrix(i * math.pi / 4, (0, 1, 0), (0, 0, 0))))
    ring = primitive_call('cylinder', shape_kwargs={'radius': radius * 1.01, 'p0': (0, -0.006, 0), 'p1': (0, 0.006, 0)}, color=(0, 0, 0))
    return concat_shapes(orange, lines, ring)


@register()
def lawn() -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': (8, 0.1, 14)}, color=(0.35, 0.65, 0.3)), translation_matrix((0, -0.05, 0)))


@register()
def bottle_group(t: float) -> Shape:
    """t: seconds since the ball reached the bottles"""
    palette = [(0.1, 0.55, 0.25), (0.55, 0.3, 0.1), (0.8, 0.85, 0.9), (0.2, 0.35, 0.8)]

    def place(k):
        i, j = k % 5, k // 5
        x, z = (i - 2) * 0.4, 0.4 - 0.25 * j
        dist = math.hypot(x, 0.4 - z)
        tau = max(0.0, t - 0.06 * j - 0.08 * abs(i - 2))
        power = 4.5 / (1 + 1.5 * dist)
        vx, vy, vz = x * 2.5 * power / 2 + 0.1 * (k % 3 - 1), 0.6 * power, -0.9 * power
        spin = min(tau, 1.0) * (3 + power)
        y_free = 1.0 + vy * tau - 4.9 * tau * tau
        px, pz = x + vx * tau, z + vz * tau
        inside = abs(px) < 1.2 and abs(pz) < 0.6
        if inside and y_free <= 1.0:
            y, spin = 1.0, min(spin, math.pi / 2)
        elif y_free < 0:
            t_land = (vy + math.sqrt(vy * vy + 19.6)) / 9.8
            px, pz, y, spin = x + vx * t_land, z + vz * t_land, 0.0, math.pi / 2
        else:
            y = y_free
        b = transform_shape(library_call('bottle', color=palette[k % 4]), rotation_matrix(spin, (vz, 0, -vx), (0, 0.2, 0)))
        if y in (0.0, 1.0):
            y = y - compute_shape_min(b)[1]
        return transform_shape(b, translation_matrix((px, y, pz)))

    return loop(20, place)


@register_animation()
def heavy_throw() -> Generator[Shape, None, None]:
    fps, r = 20, 0.24
    start, hit = np.array([0.3, 1.5, 6.5]), np.array([0.0, 1.26, 0.7])
    v = hit - start + np.array([0, 4.9, 0])  # reaches `hit` at exactly t = 1s
    for frame in range(45):
        t = frame / fps
        if t <= 1.0:
            pos = start + v * t - np.array([0, 4.9 * t * t, 0])
        else:
            d = t - 1.0
            # 10 kg ball ploughs through, barely slowed, and then falls behind the table
            z = hit[2] - 4.2 * d + 0.6 * d * d
            edge = 0.33
            y = 1.0 + r if d < edge else max(r, 1.0 + r - 4.9 * (d - edge) ** 2)
            pos = np.array([0.0, y, z])
        ball = transform_shape(library_call('basketball', radius=r), translation_matrix(pos) @ rotation_matrix(-5 * t, (1, 0, 0), (0, 0, 0)))
        jolt = 0.15 * (1 - math.exp(-5 * max(0.0, t - 1.0)))
        table = transform_shape(library_call('picnic_table'), translation_matrix((0, 0, -jolt)))
        yield concat_shapes(library_call('lawn'), table, library_call('bottle_group', t=t - 1.0), ball)
