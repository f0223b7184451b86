# Answer of an unnamed frontier model, 2026-11-23, to the request S10-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
Two cars moves at the same speed of 5~10m/s, one in front of the other. The front car suddenly brakes, and two cars collide after 1 second.
"""


@register()
def car(body_color: tuple[float, float, float]) -> Shape:
    dims = [
        ((4.0, 0.5, 1.8), (0.0, 0.6, 0.0), body_color),
        ((1.8, 0.5, 1.6), (-0.1, 1.1, 0.0), (0.3, 0.35, 0.4)),
        ((0.1, 0.15, 1.8), (1.98, 0.45, 0.0), (0.2, 0.2, 0.2)),
        ((0.1, 0.15, 1.8), (-1.98, 0.45, 0.0), (0.2, 0.2, 0.2)),
    ]
    boxes = loop(len(dims), lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': dims[i][0]}, color=dims[i][2]), translation_matrix(dims[i][1])))
    right_wheels = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.35, 'p0': (-1.2 + 2.4 * i, 0.35, 0.75), 'p1': (-1.2 + 2.4 * i, 0.35, 0.95)}, color=(0.08, 0.08, 0.08)))
    left_wheels = transform_shape(right_wheels, reflection_matrix((0, 0, 0), (0, 0, 1)))
    return concat_shapes(boxes, right_wheels, left_wheels)


@register()
def road() -> Shape:
    asphalt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (60, 0.1, 5)}, color=(0.4, 0.4, 0.4)), translation_matrix((10, -0.05, 0)))
    grass = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (60, 0.1, 3)}, color=(0.35, 0.6, 0.3)), translation_matrix((10, -0.05, -4 + 8 * i))))
    return concat_shapes(asphalt, grass)


@register()
def impact_flash(size: float) -> Shape:
    return loop(5, lambda i: transform_shape(
        primitive_call('sphere', shape_kwargs={'radius': size * 0.2}, color=(1.0, 0.5 + 0.1 * i, 0.0)),
        rotation_matrix(2 * math.pi * i / 5, (1, 0, 0), (0, 0, 0)) @ translation_matrix((0, size * 0.5, 0))))


@register_animation()
def brake_and_crash() -> Generator[Shape, None, None]:
    fps = 10
    cruise_frames, brake_frames, crash_frames = 10, 10, 15   # 10 braking frames = 1 second
    v = 10.0
    rear_start = -10.0

    front_car = library_call('car', body_color=(0.85, 0.85, 0.2))
    rear_car = library_call('car', body_color=(0.6, 0.1, 0.6))
    half = compute_shape_sizes(front_car)[0] / 2

    # with an 8 m/s^2 brake, the gap of 4 m vanishes in exactly 1 s
    decel = 8.0
    front_start = rear_start + 2 * half + 0.5 * decel

    for frame in range(cruise_frames + brake_frames + crash_frames):
        t = frame / fps
        flash = []
        pitch = 0.0
        if frame <= cruise_frames:
            rear_x, front_x = rear_start + v * t, front_start + v * t
        else:
            t0 = cruise_frames / fps
            tb = min(t - t0, brake_frames / fps)
            rear_x = rear_start + v * (t0 + tb)
            front_x = front_start + v * (t0 + tb) - 0.5 * decel * tb ** 2
            if frame < cruise_frames + brake_frames:
                pitch = -0.03     # the front car dives on its brakes

        if frame >= cruise_frames + brake_frames:
            k = (frame - cruise_frames - brake_frames) / (crash_frames - 1)
            ease = 1 - (1 - k) ** 2
            if k < 0.3:
                flash = library_call('impact_flash', size=0.5 + 2 * k)
                flash = transform_shape(flash, translation_matrix((rear_x + half, 0.7, 0)))
            front_x += 4.0 * ease   # knocked ahead
            rear_x += 2.2 * ease    # carried on a little, then stops

        front = transform_shape(front_car, translation_matrix((front_x, 0, 0)) @ rotation_matrix(pitch, (0, 0, 1), (0, 0.35, 0)))
        rear = transform_shape(rear_car, translation_matrix((rear_x, 0, 0)))
        yield concat_shapes(library_call('road'), front, rear, flash)
