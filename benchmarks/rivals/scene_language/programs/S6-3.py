# Answer of an unnamed frontier model, 2026-11-23, to the request S6-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car collide with a trashbin, knocking the trashbin to collide with a picnic table by the street side.
"""


@register()
def box(size: P, center: P, color: tuple[float, float, float]) -> Shape:
    return transform_shape(primitive_call('cube', shape_kwargs={'scale': size}, color=color), translation_matrix(center))


@register()
def street() -> Shape:
    return concat_shapes(
        library_call('box', size=(16, 0.1, 24), center=(0, -0.06, 0), color=(0.35, 0.6, 0.3)),
        library_call('box', size=(5, 0.1, 24), center=(-2, -0.05, 0), color=(0.3, 0.3, 0.3)),
        library_call('box', size=(0.3, 0.25, 24), center=(0.65, 0.05, 0), color=(0.75, 0.75, 0.75)),
        loop(6, lambda i: library_call('box', size=(0.15, 0.02, 1.6), center=(-2, 0.01, -10 + 4 * i), color=(0.95, 0.9, 0.4))))


@register()
def car(color: tuple[float, float, float]) -> Shape:
    # the car is facing -z (away from the camera)
    return concat_shapes(
        library_call('box', size=(1.7, 0.6, 3.8), center=(0, 0.65, 0), color=color),
        library_call('box', size=(1.5, 0.55, 1.9), center=(0, 1.2, 0.2), color=(0.6, 0.8, 0.95)),
        library_call('box', size=(1.6, 0.06, 1.8), center=(0, 1.5, 0.2), color=color),
        library_call('car_wheels'))


@register()
def car_wheels() -> Shape:
    def one(i: int) -> Shape:
        sx = -1 if i % 2 == 0 else 1
        sz = -1 if i < 2 else 1
        return primitive_call('cylinder', shape_kwargs={
            'radius': 0.36, 'p0': (sx * 0.7, 0.36, sz * 1.2), 'p1': (sx * 0.9, 0.36, sz * 1.2)}, color=(0.08, 0.08, 0.08))
    return loop(4, one)


@register()
def trashbin() -> Shape:
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.38, 'p0': (0, -0.5, 0), 'p1': (0, 0.45, 0)}, color=(0.1, 0.4, 0.6)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.42, 'p0': (0, 0.45, 0), 'p1': (0, 0.52, 0)}, color=(0.05, 0.2, 0.3)),
        primitive_call('sphere', shape_kwargs={'radius': 0.1}, color=(0.05, 0.2, 0.3)))


@register()
def picnic_table() -> Shape:
    wood, dark = (0.65, 0.45, 0.25), (0.45, 0.3, 0.15)
    return concat_shapes(
        library_call('box', size=(2.4, 0.1, 1.0), center=(0, 0.8, 0), color=wood),
        library_call('box', size=(2.4, 0.08, 0.35), center=(0, 0.45, 0.9), color=wood),
        library_call('box', size=(2.4, 0.08, 0.35), center=(0, 0.45, -0.9), color=wood),
        loop(2, lambda i: library_call('box', size=(0.1, 0.08, 2.0), center=(-0.9 + 1.8 * i, 0.38, 0), color=dark)),
        loop(2, lambda i: library_call('box', size=(0.12, 0.78, 0.3), center=(-0.9 + 1.8 * i, 0.39, 0), color=dark)))


@register()
def frame_at(t: float) -> Shape:
    """t in seconds: 0-1 approach, 1-1.6 bin flies, 1.6-2.5 table slides"""
    # phase parameters, each clamped to [0, 1]
    approach = min(t / 1.0, 1.0)
    fly = min(max((t - 1.0) / 0.6, 0.0), 1.0)
    slide = min(max((t - 1.6) / 0.6, 0.0), 1.0)
    brake = min(max((t - 1.0) / 0.8, 0.0), 1.0)
    smooth = 1 - (1 - slide) ** 2

    bin_start = np.array([0.3, 0.5, 0.0])
    bin_end = np.array([2.2, 0.6, -2.2])
    car_hit = np.array([-0.4, 0.0, 2.3])

    car_pos = car_hit + np.array([0, 0, 7.0]) * (1 - approach) + np.array([0, 0, -2.4]) * (2 * brake - brake ** 2) * 0.7
    bin_pos = bin_start + (bin_end - bin_start) * fly + np.array([0, 0.9 * 4 * fly * (1 - fly), 0])
    bin_pos = bin_pos + np.array([-0.5, -0.2, 0.5]) * smooth
    table_pos = np.array([3.4, 0, -3.4]) + np.array([0.5, 0, -0.5]) * smooth

    spin = rotation_matrix(-1.5 * math.pi * fly, (1, 0, 1), (0, 0, 0))
    if slide > 0:
        spin = rotation_matrix(math.pi / 2, (1, 0, 1), (0, 0, 0))

    return concat_shapes(
        library_call('street'),
        transform_shape(library_call('car', color=(0.75, 0.1, 0.15)), translation_matrix(car_pos)),
        transform_shape(library_call('trashbin'), translation_matrix(bin_pos) @ spin),
        transform_shape(library_call('picnic_table'), translation_matrix(table_pos) @ rotation_matrix(-0.3 * smooth, (0, 1, 0), (0, 0, 0))))


@register_animation()
def street_side_crash() -> Generator[Shape, None, None]:
    total_frames = 50
    for frame in range(total_frames):
        yield library_call('frame_at', t=2.5 * frame / (total_frames - 1))
