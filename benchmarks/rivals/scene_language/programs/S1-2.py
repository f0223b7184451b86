# Answer of an unnamed frontier model, 2026-11-23, to the request S1-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A bowling ball rolls toward a set of bowling pins and hits them.
"""


@register()
def floor() -> Shape:
    slab = primitive_call('cube', shape_kwargs={'scale': (3, 0.2, 12)}, color=(0.76, 0.57, 0.34))
    return transform_shape(slab, translation_matrix((0, -0.1, 0)))


@register()
def ball(color) -> Shape:
    main = primitive_call('sphere', shape_kwargs={'radius': 0.35}, color=color)
    hole = lambda dx, dz: transform_shape(
        primitive_call('cylinder', shape_kwargs={'radius': 0.045, 'p0': (0, 0.25, 0), 'p1': (0, 0.352, 0)}, color=(0, 0, 0)),
        translation_matrix((dx, 0, dz)))
    return concat_shapes(main, hole(-0.07, 0), hole(0.07, 0), hole(0, 0.1))


@register()
def pin() -> Shape:
    white = (1, 1, 1)
    lower = primitive_call('cylinder', shape_kwargs={'radius': 0.14, 'p0': (0, 0, 0), 'p1': (0, 0.5, 0)}, color=white)
    belly = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.17}, color=white), translation_matrix((0, 0.3, 0)))
    neck = primitive_call('cylinder', shape_kwargs={'radius': 0.07, 'p0': (0, 0.5, 0), 'p1': (0, 0.75, 0)}, color=(0.9, 0.1, 0.1))
    top = transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.11}, color=white), translation_matrix((0, 0.82, 0)))
    return concat_shapes(lower, belly, neck, top)


@register()
def pin_flying(x: float, z: float, progress: float, spin: float) -> Shape:
    """progress runs from 0 (standing) to 1 (lying on the floor)."""
    base = library_call('pin')
    angle = -math.pi / 2 * min(1.0, progress * 1.3)
    tilt = rotation_matrix(angle, (1, 0, 0), (0, 0, 0))
    yaw = rotation_matrix(spin * progress, (0, 1, 0), (0, 0, 0))
    lying = transform_shape(base, yaw @ tilt)
    arc = 0.9 * math.sin(math.pi * progress)
    ground = -compute_shape_min(lying)[1]
    offset = (x * (1 + 1.2 * progress), ground + arc, z - 1.3 * progress)
    return transform_shape(lying, translation_matrix(offset))


@register()
def pins(time_since_hit: float) -> Shape:
    def row(r):
        def one(c):
            delay = 0.12 * r + 0.05 * abs(c - r / 2)
            progress = min(1.0, max(0.0, (time_since_hit - delay) / 0.8))
            return library_call('pin_flying', x=(c - r / 2) * 0.55, z=-3 - 0.48 * r,
                                progress=progress, spin=(c - r / 2) * 1.4 + 0.3 * (-1) ** r)
        return loop(r + 1, one)
    return loop(4, row)


@register_animation()
def bowling() -> Generator[Shape, None, None]:
    fps = 24
    total_frames = 3 * fps
    hit_time = 1.5
    start_z, hit_z = 5.0, -3 + 0.35 + 0.14
    speed = (start_z - hit_z) / hit_time
    for frame in range(total_frames):
        t = frame / fps
        if t < hit_time:
            z = start_z - speed * t
        else:
            z = max(hit_z - 0.75 * speed * (t - hit_time), -5.6)
        rolling = rotation_matrix(-(start_z - z) / 0.35, (1, 0, 0), (0, 0, 0))
        ball_shape = transform_shape(library_call('ball', color=(0.45, 0.05, 0.55)),
                                     translation_matrix((0, 0.35, z)) @ rolling)
        yield concat_shapes(library_call('floor'), ball_shape, library_call('pins', time_since_hit=t - hit_time))
