# Answer of an unnamed frontier model, 2026-11-23, to the request S5-3 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are several billiards on the billiard table. The cue ball strikes the black ball, sending it cleanly into the bottom pocket.
"""


@register()
def pool_table(width: float, length: float) -> Shape:
    green = primitive_call('cube', shape_kwargs={'scale': (width, 0.2, length)}, color=(0.1, 0.55, 0.3))
    green = transform_shape(green, translation_matrix((0, -0.1, 0)))
    lo, hi = compute_shape_min(green), compute_shape_max(green)
    rail_x = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.3, 0.4, length + 0.6)}, color=(0.5, 0.3, 0.15)),
        translation_matrix((lo[0] - 0.15 if i == 0 else hi[0] + 0.15, -0.02, 0))))
    rail_z = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (width, 0.4, 0.3)}, color=(0.5, 0.3, 0.15)),
        translation_matrix((0, -0.02, lo[2] - 0.15 if i == 0 else hi[2] + 0.15))))
    return concat_shapes(green, rail_x, rail_z)


@register()
def pocket() -> Shape:
    hole = primitive_call('cylinder', shape_kwargs={'radius': 0.24, 'p0': (0, -0.22, 0), 'p1': (0, 0.01, 0)}, color=(0, 0, 0))
    rim = primitive_call('cylinder', shape_kwargs={'radius': 0.28, 'p0': (0, -0.22, 0), 'p1': (0, 0.005, 0)}, color=(0.7, 0.6, 0.3))
    return concat_shapes(rim, hole)


@register()
def six_pockets(width: float, length: float) -> Shape:
    return loop(6, lambda i: transform_shape(
        library_call('pocket'),
        translation_matrix(((i % 2 - 0.5) * (width - 0.3), 0, (i // 2 - 1) * (length - 0.3) / 2))))


@register()
def ball(color, radius: float) -> Shape:
    return transform_shape(primitive_call('sphere', shape_kwargs={'radius': radius}, color=color), translation_matrix((0, radius, 0)))


@register()
def eight_ball(radius: float, roll: float, axis: P) -> Shape:
    black = primitive_call('sphere', shape_kwargs={'radius': radius}, color=(0, 0, 0))
    patch = transform_shape(primitive_call('sphere', shape_kwargs={'radius': radius * 0.45}, color=(1, 1, 1)), translation_matrix((0, radius * 0.6, 0)))
    rolled = transform_shape(concat_shapes(black, patch), rotation_matrix(roll, axis, (0, 0, 0)))
    return transform_shape(rolled, translation_matrix((0, radius, 0)))


@register()
def scattered_balls(radius: float) -> Shape:
    layout = [((-1.0, -1.5), (1, 0.9, 0.1)), ((0.9, -2.0), (0.1, 0.1, 0.8)), ((1.1, -0.2), (0.9, 0.1, 0.1)),
              ((-1.1, 0.9), (0.5, 0.0, 0.5)), ((0.2, -1.8), (1, 0.5, 0.0)), ((1.0, 1.6), (0.0, 0.5, 0.1)), ((-0.9, -0.3), (0.5, 0.1, 0.1))]
    return loop(len(layout), lambda i: transform_shape(
        library_call('ball', color=layout[i][1], radius=radius), translation_matrix((layout[i][0][0], 0, layout[i][0][1]))))


def ease_out(s):
    return 1 - (1 - s) ** 2


@register_animation()
def black_ball_potted() -> Generator[Shape, None, None]:
    width, length, r = 3.2, 6.0, 0.15
    phases = {'wait': 5, 'approach': 15, 'pot': 18, 'drop': 6, 'rest': 6}
    pocket_pos = np.array([-(width - 0.3) / 2, 0, (length - 0.3) / 2])
    black_start = np.array([-0.3, 0, 1.0])
    direction = (pocket_pos - black_start) / np.linalg.norm(pocket_pos - black_start)
    contact = black_start - direction * 2 * r
    cue_start = contact - direction * 1.9
    path = float(np.linalg.norm(pocket_pos - black_start))
    total_frames = sum(phases.values())
    a = phases['wait']
    b = a + phases['approach']
    c = b + phases['pot']
    d = c + phases['drop']
    for frame in range(total_frames):
        s_cue = min(1.0, max(0.0, (frame - a) / (b - a)))
        s_black = min(1.0, max(0.0, (frame - b) / (c - b)))
        s_drop = min(1.0, max(0.0, (frame - c) / (d - c)))
        cue_pos = cue_start + (contact - cue_start) * s_cue + direction * 0.35 * ease_out(s_black)
        travelled = path * (0.6 * s_black + 0.4 * ease_out(s_black))
        black_pos = black_start + direction * travelled + np.array([0, -0.7 * s_drop ** 2, 0])
        cue = transform_shape(library_call('ball', color=(1, 1, 1), radius=r), translation_matrix(cue_pos))
        black = transform_shape(library_call('eight_ball', radius=r, roll=travelled / r, axis=(direction[2], 0, -direction[0])), translation_matrix(black_pos))
        yield concat_shapes(library_call('pool_table', width=width, length=length),
                            library_call('six_pockets', width=width, length=length),
                            library_call('scattered_balls', radius=r), cue, black)
