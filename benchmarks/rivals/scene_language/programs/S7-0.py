# Answer of an unnamed frontier model, 2026-11-23, to the request S7-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are three balls on the ground. Ball A moves and hits ball B, giving ball B an initial speed at 2m/s, then ball B hits ball C.
"""


@register()
def ground() -> Shape:
    slab = primitive_call('cube', shape_kwargs={'scale': (10, 0.1, 4)}, color=(0.6, 0.6, 0.6))
    return transform_shape(slab, translation_matrix((1, -0.05, 0)))


@register()
def ball(radius: float, color: tuple[float, float, float]) -> Shape:
    sphere = primitive_call('sphere', shape_kwargs={'radius': radius}, color=color)
    return transform_shape(sphere, translation_matrix((0, radius, 0)))


@register_animation()
def three_balls_animation() -> Generator[Shape, None, None]:
    fps = 24
    duration = 3.0
    radius = 0.25
    speed = 2.0  # m/s, transferred at each (equal-mass, elastic) impact

    a0, b0, c0 = -2.0, 0.0, 2.0
    t_ab = (b0 - a0 - 2 * radius) / speed
    t_bc = t_ab + (c0 - b0 - 2 * radius) / speed

    for frame in range(int(fps * duration)):
        t = frame / fps
        a_x = a0 + speed * min(t, t_ab)
        b_x = b0 + speed * (min(max(t, t_ab), t_bc) - t_ab)
        c_x = c0 + speed * (max(t, t_bc) - t_bc)

        ball_a = transform_shape(library_call('ball', radius=radius, color=(0.9, 0.2, 0.2)), translation_matrix((a_x, 0, 0)))
        ball_b = transform_shape(library_call('ball', radius=radius, color=(0.2, 0.8, 0.2)), translation_matrix((b_x, 0, 0)))
        ball_c = transform_shape(library_call('ball', radius=radius, color=(0.2, 0.3, 0.9)), translation_matrix((c_x, 0, 0)))
        yield concat_shapes(library_call('ground'), ball_a, ball_b, ball_c)
