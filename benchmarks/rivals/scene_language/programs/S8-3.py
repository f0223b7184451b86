# Answer of an unnamed frontier model, 2026-11-23, to the request S8-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A black car is moving at 10 m/s down the road. The driver starts braking, letting the car to stop in 2~3 seconds.
"""


def car_distance(t: float, v0: float, t_brake: float, stop_time: float) -> float:
    """Cruise, then brake with a smoothly rising pedal: v = v0 * (1 - s^2) with s = braking progress."""
    if t <= t_brake:
        return v0 * t
    s = min((t - t_brake) / stop_time, 1.0)
    return v0 * t_brake + v0 * stop_time * (s - s ** 3 / 3)


@register()
def car_part(scale: P, offset: P, color: tuple[float, float, float]) -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': scale}, color=color), translation_matrix(offset))


@register()
def car() -> Shape:
    # the car drives toward -x
    wheels = loop(2, lambda i: loop(2, lambda j: primitive_call('cylinder', shape_kwargs={
        'radius': 0.33,
        'p0': (-1.3 + 2.6 * i, 0.33, -0.95 + 1.7 * j),
        'p1': (-1.3 + 2.6 * i, 0.33, -0.75 + 1.7 * j)}, color=(0.2, 0.2, 0.2))))
    return concat_shapes(
        library_call('car_part', scale=(4.2, 0.55, 1.8), offset=(0, 0.65, 0), color=(0, 0, 0)),
        library_call('car_part', scale=(2.1, 0.5, 1.5), offset=(0.25, 1.15, 0), color=(0.05, 0.05, 0.05)),
        library_call('car_part', scale=(0.05, 0.35, 1.3), offset=(-0.82, 1.15, 0), color=(0.6, 0.75, 0.85)),
        loop(2, lambda i: library_call('car_part', scale=(0.08, 0.15, 0.35), offset=(-2.1, 0.7, -0.65 + 1.3 * i), color=(1, 1, 0.8))),
        wheels)


@register()
def brake_lights() -> Shape:
    return loop(2, lambda i: library_call('car_part', scale=(0.08, 0.16, 0.35), offset=(2.1, 0.75, -0.65 + 1.3 * i), color=(1, 0, 0)))


@register()
def skid_marks(length: float) -> Shape:
    return loop(2, lambda i: library_call(
        'car_part', scale=(length, 0.01, 0.2), offset=(length / 2, 0.01, -0.85 + 1.7 * i), color=(0.1, 0.1, 0.1)))


@register()
def road() -> Shape:
    return concat_shapes(
        library_call('car_part', scale=(48, 0.1, 8), offset=(0, -0.05, 0), color=(0.45, 0.45, 0.45)),
        loop(12, lambda i: library_call('car_part', scale=(2, 0.02, 0.15), offset=(-22 + 4 * i, 0.005, 0), color=(1, 1, 1))))


@register_animation()
def car_stops() -> Generator[Shape, None, None]:
    fps, seconds = 15, 4
    v0, t_brake, stop_time = 10.0, 0.7, 2.4
    start = 16.0
    brake_x = start - v0 * t_brake

    for frame in range(fps * seconds + 1):
        t = frame / fps
        x = start - car_distance(t, v0, t_brake, stop_time)
        pose = translation_matrix((x, 0, -2))
        shapes = [library_call('road'), transform_shape(library_call('car'), pose)]
        if t > t_brake:
            shapes.append(transform_shape(library_call('brake_lights'), pose))
            shapes.append(transform_shape(library_call('skid_marks', length=max(brake_x - x, 0.01)), translation_matrix((x + 1.3, 0, -2))))
        yield concat_shapes(*shapes)
