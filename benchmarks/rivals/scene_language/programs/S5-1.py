# Answer of an unnamed frontier model, 2026-11-23, to the request S5-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are several billiards on the billiard table. The cue ball strikes the black ball, sending it cleanly into the bottom pocket.
"""

RADIUS = 0.1


@register()
def billiard_table() -> Shape:
    cloth = transform_shape(primitive_call('cube', shape_kwargs={'scale': (4.4, 0.1, 2.4)}, color=(0.0, 0.4, 0.3)), translation_matrix((0, -0.05, 0)))
    wood = (0.45, 0.25, 0.12)
    # rails are split so that the six pockets stay open
    long_rails = loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (1.8, 0.2, 0.2)}, color=wood),
        translation_matrix((-1.05 if i % 2 else 1.05, 0.05, -1.2 if i < 2 else 1.2))))
    short_rails = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.2, 0.2, 1.9)}, color=wood),
        translation_matrix((-2.2 + 4.4 * i, 0.05, 0))))
    legs = loop(4, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.25, 1.0, 0.25)}, color=wood),
        translation_matrix((-2 + 4 * (i % 2), -0.6, -1 + 2 * (i // 2)))))
    return concat_shapes(cloth, long_rails, short_rails, legs)


@register()
def pocket_holes() -> Shape:
    return loop(3, lambda i: loop(2, lambda j: primitive_call('cylinder', shape_kwargs={
        'radius': 0.15, 'p0': (-2.1 + 2.1 * i, -0.12, -1.12 + 2.24 * j), 'p1': (-2.1 + 2.1 * i, 0.004, -1.12 + 2.24 * j)}, color=(0, 0, 0))))


@register()
def ball(color, stripe) -> Shape:
    s = primitive_call('sphere', shape_kwargs={'radius': RADIUS}, color=color)
    if not stripe:
        return s
    band = primitive_call('cylinder', shape_kwargs={'radius': RADIUS * 1.01, 'p0': (0, -0.03, 0), 'p1': (0, 0.03, 0)}, color=(1, 1, 1))
    return concat_shapes(s, band)


@register()
def cue_stick(pull: float) -> Shape:
    """pointing along +z, its tip at the origin, pulled back by `pull`"""
    shaft = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0, 0, -1.8 - pull), 'p1': (0, 0, -0.05 - pull)}, color=(0.85, 0.7, 0.45))
    tip = primitive_call('cylinder', shape_kwargs={'radius': 0.022, 'p0': (0, 0, -0.05 - pull), 'p1': (0, 0, -pull)}, color=(0.2, 0.4, 0.8))
    return concat_shapes(shaft, tip)


@register()
def static_balls() -> Shape:
    data = [(-1.5, -0.5, (1, 0.8, 0), False), (-1.1, 0.6, (0.9, 0.1, 0.1), False), (1.2, -0.3, (0.1, 0.2, 0.7), True),
            (1.6, 0.5, (0.5, 0.1, 0.6), False), (0.9, 0.7, (1, 0.5, 0), True), (-0.7, -0.8, (0.1, 0.6, 0.2), True)]
    return loop(len(data), lambda i: transform_shape(
        library_call('ball', color=data[i][2], stripe=data[i][3]), translation_matrix((data[i][0], RADIUS, data[i][1]))))


@register_animation()
def shot() -> Generator[Shape, None, None]:
    # straight shot along +z into the bottom middle pocket at (0, 1.12)
    cue_start, black_start, pocket_z = -0.7, 0.35, 1.12
    contact = black_start - 2 * RADIUS
    fps, wind_up = 20, 0.8
    speed = 2.0
    t_contact = wind_up + (contact - cue_start) / speed
    t_pocket = t_contact + (pocket_z - black_start) / speed
    for frame in range(60):
        t = frame / fps
        pull = 0.05 + 0.35 * math.sin(math.pi * min(t / wind_up, 1.0)) if t < wind_up else 0.05
        stick = transform_shape(library_call('cue_stick', pull=pull), translation_matrix((0, RADIUS, cue_start - RADIUS)))
        if t < wind_up:
            cue_z = cue_start
        elif t < t_contact:
            cue_z = cue_start + speed * (t - wind_up)
        else:
            cue_z = contact + 0.12 * (1 - math.exp(-3 * (t - t_contact)))
        black_z, black_y = black_start, RADIUS
        if t > t_contact:
            black_z = min(pocket_z, black_start + speed * (t - t_contact))
        if t > t_pocket:
            black_y = max(-0.4, RADIUS - 5 * (t - t_pocket) ** 2)
        cue = transform_shape(library_call('ball', color=(1, 1, 1), stripe=False), translation_matrix((0, RADIUS, cue_z)))
        parts = [library_call('billiard_table'), library_call('pocket_holes'), library_call('static_balls'), stick, cue]
        if black_y > -0.25:
            black = transform_shape(library_call('ball', color=(0.02, 0.02, 0.02), stripe=True), rotation_matrix((black_z - black_start) / RADIUS, (1, 0, 0), (0, 0, 0)))
            parts.append(transform_shape(black, translation_matrix((0, black_y, black_z))))
        yield concat_shapes(*parts)
