# Answer of an unnamed frontier model, 2026-11-23, to the request S7-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are three balls on the ground. Ball A moves and hits ball B, giving ball B an initial speed at 2m/s, then ball B hits ball C.
"""


@register()
def ball_a() -> Shape:
    return primitive_call('sphere', shape_kwargs={'radius': 0.5}, color=(1, 0, 0))


@register()
def ball_b() -> Shape:
    return primitive_call('sphere', shape_kwargs={'radius': 0.5}, color=(0, 1, 0))


@register()
def ball_c() -> Shape:
    return primitive_call('sphere', shape_kwargs={'radius': 0.5}, color=(0, 0, 1))


@register()
def ground() -> Shape:
    return transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (20, 0.1, 5)}, color=(0.5, 0.5, 0.5)),
        translation_matrix([0, -0.55, 0]))


@register_animation()
def balls_animation() -> Generator[Shape, None, None]:
    total_frames = 40
    dt = 0.1  # seconds per frame

    a_x, b_x, c_x = -4.0, 0.0, 3.0
    a_v, b_v, c_v = 3.0, 0.0, 0.0

    for frame in range(total_frames):
        balls = concat_shapes(
            transform_shape(library_call('ball_a'), translation_matrix([a_x, 0, 0])),
            transform_shape(library_call('ball_b'), translation_matrix([b_x, 0, 0])),
            transform_shape(library_call('ball_c'), translation_matrix([c_x, 0, 0])))
        yield concat_shapes(library_call('ground'), balls)

        # Move the balls
        a_x += a_v * dt
        b_x += b_v * dt
        c_x += c_v * dt

        # A hits B: B starts with 2 m/s, A keeps the rest of the momentum
        if b_v == 0.0 and c_v == 0.0 and a_x >= b_x - 1.0:
            a_x = b_x - 1.0
            a_v, b_v = 1.0, 2.0
        # B hits C
        if c_v == 0.0 and b_x >= c_x - 1.0:
            b_x = c_x - 1.0
            b_v, c_v = 0.5, 1.5
            a_v = 0.4
