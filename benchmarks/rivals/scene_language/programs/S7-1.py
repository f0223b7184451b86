# Answer of an unnamed frontier model, 2026-11-23, to the request S7-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are three balls on the ground. Ball A moves and hits ball B, giving ball B an initial speed at 2m/s, then ball B hits ball C.
"""


@register()
def floor() -> Shape:
    def tile(i: int) -> Shape:
        row, col = i // 12, i % 12
        shade = 0.85 if (row + col) % 2 == 0 else 0.55
        return transform_shape(
            primitive_call('cube', shape_kwargs={'scale': (1, 0.1, 1)}, color=(shade, shade, shade)),
            translation_matrix((col - 5.5, -0.05, row - 1.5)))
    return loop(48, tile)


@register()
def striped_ball(radius: float, color: tuple[float, float, float]) -> Shape:
    core = primitive_call('sphere', shape_kwargs={'radius': radius}, color=color)
    # a thin band lets the rolling be seen
    band = primitive_call('cylinder', shape_kwargs={
        'radius': radius * 1.01, 'p0': (-radius * 0.08, 0, 0), 'p1': (radius * 0.08, 0, 0)}, color=(1, 1, 1))
    return concat_shapes(core, band)


@register()
def rolling_ball(x: float, x_start: float, radius: float, color: tuple[float, float, float]) -> Shape:
    angle = -(x - x_start) / radius
    pose = translation_matrix((x, radius, 0)) @ rotation_matrix(angle, (0, 0, 1), (0, 0, 0))
    return transform_shape(library_call('striped_ball', radius=radius, color=color), pose)


@register_animation()
def chain_collision() -> Generator[Shape, None, None]:
    dt = 1 / 30
    total_frames = 105
    r = 0.3
    friction = 0.35  # deceleration, m/s^2
    e = 0.9  # coefficient of restitution

    start = [-3.5, -0.5, 1.6]
    x = list(start)
    colors = [(0.9, 0.1, 0.1), (0.95, 0.8, 0.1), (0.1, 0.3, 0.9)]
    # Ball A must arrive with v so that B leaves with (1 + e) / 2 * v = 2 m/s
    v_contact = 2.0 * 2 / (1 + e)
    run_up = start[1] - start[0] - 2 * r
    v = [math.sqrt(v_contact ** 2 + 2 * friction * run_up), 0.0, 0.0]

    for frame in range(total_frames):
        yield concat_shapes(
            library_call('floor'),
            loop(3, lambda i: library_call('rolling_ball', x=x[i], x_start=start[i], radius=r, color=colors[i])))

        # integrate
        for i in range(3):
            x[i] += v[i] * dt
            v[i] = max(0.0, v[i] - friction * dt)
        # resolve equal-mass collisions between neighbors
        for i in range(2):
            if x[i + 1] - x[i] <= 2 * r and v[i] > v[i + 1]:
                x[i] = x[i + 1] - 2 * r
                total, rel = v[i] + v[i + 1], v[i] - v[i + 1]
                v[i], v[i + 1] = (total - e * rel) / 2, (total + e * rel) / 2
                if i == 0:
                    v[1] = 2.0
