# Answer of an unnamed frontier model, 2026-11-23, to the request S1-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A bowling ball rolls toward a set of bowling pins and hits them.
"""


@register("wooden lane with two gutters")
def lane() -> Shape:
    wood = primitive_call('cube', shape_kwargs={'scale': (2.0, 0.1, 14.0)}, color=(0.85, 0.65, 0.4))
    wood = transform_shape(wood, translation_matrix((0, -0.05, -3)))
    gutters = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.3, 0.06, 14.0)}, color=(0.25, 0.25, 0.28)),
        translation_matrix((-1.15 + 2.3 * i, -0.08, -3))))
    return concat_shapes(wood, gutters)


@register("a single pin standing on y=0")
def pin() -> Shape:
    body = primitive_call('cylinder', shape_kwargs={'radius': 0.11, 'p0': (0, 0, 0), 'p1': (0, 0.4, 0)}, color=(1, 1, 1))
    neck = primitive_call('cylinder', shape_kwargs={'radius': 0.06, 'p0': (0, 0.4, 0), 'p1': (0, 0.58, 0)}, color=(1, 1, 1))
    stripe = primitive_call('cylinder', shape_kwargs={'radius': 0.065, 'p0': (0, 0.46, 0), 'p1': (0, 0.5, 0)}, color=(0.85, 0.1, 0.1))
    head = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.085}, color=(1, 1, 1)), translation_matrix((0, 0.62, 0)))
    return concat_shapes(body, neck, stripe, head)


@register("bowling ball with three finger holes")
def bowling_ball(radius: float) -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': radius}, color=(0.1, 0.15, 0.6))
    holes = loop(3, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': radius * 0.14}, color=(0, 0, 0)),
        translation_matrix((radius * 0.22 * math.cos(2 * math.pi * i / 3), radius * 0.93, radius * 0.22 * math.sin(2 * math.pi * i / 3)))))
    return concat_shapes(ball, holes)


def pin_positions():
    return [((c - r / 2) * 0.45, -7.0 - 0.4 * r) for r in range(4) for c in range(r + 1)]


def ball_z(t):
    return 3.0 - 5.0 * t


@register("all pins at time t, toppling after the ball reaches them")
def pin_rack(t: float, radius: float) -> Shape:
    spots = pin_positions()

    def place(i):
        x, z = spots[i]
        t_hit = (3.0 - (z + radius + 0.1)) / 5.0 + 0.04 * abs(x)
        dt = max(0.0, t - t_hit)
        angle = min(math.pi / 2, 4.5 * dt)
        side = x if abs(x) > 0.01 else 0.12
        d = np.array([side * 1.5, 0, -1.0])
        d = d / np.linalg.norm(d)
        axis = (d[2], 0, -d[0])
        slide = d * 1.1 * (1 - math.exp(-2.0 * dt))
        hop = max(0.0, 1.2 * dt - 2.5 * dt * dt) + 0.11 * math.sin(angle)
        p = transform_shape(library_call('pin'), rotation_matrix(angle, axis, (0, 0, 0)))
        return transform_shape(p, translation_matrix((x + slide[0], hop, z + slide[2])))

    return loop(len(spots), place)


@register_animation()
def bowling_animation() -> Generator[Shape, None, None]:
    total_frames, duration, radius = 60, 3.0, 0.3
    for frame in range(total_frames):
        t = duration * frame / (total_frames - 1)
        z = max(ball_z(t), -9.6)
        ball = library_call('bowling_ball', radius=radius)
        ball = transform_shape(ball, rotation_matrix((z - 3.0) / radius, (1, 0, 0), compute_shape_center(ball)))
        ball = transform_shape(ball, translation_matrix((0, radius, z)))
        yield concat_shapes(library_call('lane'), ball, library_call('pin_rack', t=t, radius=radius))
