# Answer of an unnamed frontier model, 2026-11-23, to the request S7-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are three balls on the ground. Ball A moves and hits ball B, giving ball B an initial speed at 2m/s, then ball B hits ball C.
"""


def travel(v0: float, decel: float, t: float) -> float:
    """distance covered in time t from speed v0 under constant deceleration"""
    t = min(max(t, 0.0), v0 / decel)
    return v0 * t - 0.5 * decel * t * t


def time_to_cover(v0: float, decel: float, distance: float) -> float:
    return (v0 - math.sqrt(v0 ** 2 - 2 * decel * distance)) / decel


@register()
def ground() -> Shape:
    lawn = transform_shape(primitive_call('cube', shape_kwargs={'scale': (8, 0.1, 3)}, color=(0.3, 0.55, 0.3)), translation_matrix((0, -0.05, 0)))
    # one mark each meter
    marks = loop(7, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.03, 0.01, 3)}, color=(0.9, 0.9, 0.9)),
        translation_matrix((i - 3, 0.005, 0))))
    return concat_shapes(lawn, marks)


@register()
def ball(color: tuple[float, float, float], radius: float) -> Shape:
    spots = loop(4, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': radius * 0.25}, color=(1, 1, 1)),
        rotation_matrix(i * math.pi / 2, (0, 0, 1), (0, 0, 0)) @ translation_matrix((radius * 0.8, 0, 0))))
    return concat_shapes(primitive_call('sphere', shape_kwargs={'radius': radius}, color=color), spots)


@register()
def placed_ball(color: tuple[float, float, float], radius: float, start: float, moved: float) -> Shape:
    roll = rotation_matrix(-moved / radius, (0, 0, 1), (0, 0, 0))
    return transform_shape(
        library_call('ball', color=color, radius=radius),
        translation_matrix((start + moved, radius, 0)) @ roll)


@register_animation()
def rolling_relay() -> Generator[Shape, None, None]:
    fps, total_frames = 30, 120
    r, decel = 0.2, 0.5
    xa, xb, xc = -3.0, -1.0, 0.6
    va, vb = 2.8, 2.0

    gap_ab = xb - xa - 2 * r
    gap_bc = xc - xb - 2 * r
    t1 = time_to_cover(va, decel, gap_ab)
    t2 = t1 + time_to_cover(vb, decel, gap_bc)
    va_after = max(va - decel * t1 - vb, 0.05)
    vb_hit = vb - decel * (t2 - t1)
    vc, vb_after = 0.92 * vb_hit, 0.08 * vb_hit

    for frame in range(total_frames):
        t = frame / fps
        moved_a = travel(va, decel, t) if t < t1 else gap_ab + travel(va_after, decel, t - t1)
        moved_b = travel(vb, decel, t - t1) if t < t2 else gap_bc + travel(vb_after, decel, t - t2)
        moved_c = travel(vc, decel, t - t2)
        yield concat_shapes(
            library_call('ground'),
            library_call('placed_ball', color=(0.85, 0.15, 0.15), radius=r, start=xa, moved=moved_a),
            library_call('placed_ball', color=(0.95, 0.6, 0.1), radius=r, start=xb, moved=moved_b),
            library_call('placed_ball', color=(0.2, 0.35, 0.9), radius=r, start=xc, moved=moved_c))
