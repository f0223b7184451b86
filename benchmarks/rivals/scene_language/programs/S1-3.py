# Answer of an unnamed frontier model, 2026-11-23, to the request S1-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A bowling ball rolls toward a set of bowling pins and hits them.
"""


@register()
def bowling_lane(length: float, width: float) -> Shape:
    lane = primitive_call('cube', shape_kwargs={'scale': (length, 0.1, width)}, color=(0.87, 0.72, 0.5))
    lane = transform_shape(lane, translation_matrix((0, -0.05, 0)))
    arrows = loop(5, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.4, 0.01, 0.06)}, color=(0.4, 0.2, 0.1)),
        translation_matrix((-1.5 - 0.2 * abs(i - 2), 0.005, (i - 2) * 0.3))))
    rails = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (length, 0.2, 0.1)}, color=(0.3, 0.3, 0.35)),
        translation_matrix((0, 0.05, (i * 2 - 1) * (width / 2 + 0.05)))))
    return concat_shapes(lane, arrows, rails)


@register()
def bowling_ball() -> Shape:
    body = primitive_call('sphere', shape_kwargs={'radius': 0.3}, color=(0.9, 0.3, 0.05))
    holes = loop(3, lambda i: transform_shape(
        transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.04}, color=(0.05, 0.05, 0.05)), translation_matrix((0, 0.28, 0))),
        rotation_matrix(0.3, (math.cos(2.1 * i), 0, math.sin(2.1 * i)), (0, 0, 0))))
    return concat_shapes(body, holes)


@register()
def bowling_pin() -> Shape:
    radii = [0.08, 0.11, 0.12, 0.11, 0.085, 0.06, 0.05, 0.06, 0.065]
    h = 0.085
    stack = loop(len(radii), lambda i: primitive_call(
        'cylinder', shape_kwargs={'radius': radii[i], 'p0': (0, i * h, 0), 'p1': (0, (i + 1) * h, 0)},
        color=(0.8, 0.05, 0.05) if i == 6 else (1, 1, 0.97)))
    cap = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.065}, color=(1, 1, 0.97)),
                          translation_matrix((0, compute_shape_max(stack)[1], 0)))
    return concat_shapes(stack, cap)


# (row, slot, tipping direction in degrees around y, travel distance, delay in seconds)
PIN_MOTION = [
    (0, 0, 5, 1.9, 0.00),
    (1, 0, -28, 1.4, 0.08), (1, 1, 32, 1.5, 0.07),
    (2, 0, -45, 1.2, 0.17), (2, 1, 8, 1.3, 0.15), (2, 2, 40, 1.0, 0.18),
    (3, 0, -60, 0.7, 0.27), (3, 1, -15, 1.0, 0.24), (3, 2, 20, 0.9, 0.25), (3, 3, 55, 0.8, 0.30),
]


@register()
def falling_pin(index: int, elapsed: float) -> Shape:
    row, slot, heading, travel, delay = PIN_MOTION[index]
    s = min(1.0, max(0.0, (elapsed - delay) / 0.7))
    ease = 1 - (1 - s) ** 2
    a = math.radians(heading)
    dx, dz = math.cos(a), math.sin(a)
    tipped = transform_shape(library_call('bowling_pin'), rotation_matrix(math.pi / 2 * ease, (dz, 0, -dx), (0, 0, 0)))
    y = -compute_shape_min(tipped)[1] + 0.35 * s * (1 - s) * 4 * travel / 2
    base = (3 + row * 0.4, y, (slot - row / 2) * 0.44)
    return transform_shape(tipped, translation_matrix((base[0] + dx * travel * ease, base[1], base[2] + dz * travel * ease)))


@register_animation()
def bowling_strike() -> Generator[Shape, None, None]:
    total_frames = 50
    impact_frame = 25
    start_x, impact_x = -5.0, 2.58
    for frame in range(total_frames):
        if frame <= impact_frame:
            x = start_x + (impact_x - start_x) * frame / impact_frame
        else:
            x = impact_x + 0.2 * (frame - impact_frame) * (1 - 0.012 * (frame - impact_frame))
        elapsed = (frame - impact_frame) / 20
        ball = transform_shape(library_call('bowling_ball'), rotation_matrix(-(x - start_x) / 0.3, (0, 0, 1), (0, 0, 0)))
        ball = transform_shape(ball, translation_matrix((x, 0.3, 0)))
        pins = loop(10, lambda i: library_call('falling_pin', index=i, elapsed=elapsed))
        yield concat_shapes(library_call('bowling_lane', length=14, width=2.2), ball, pins)
