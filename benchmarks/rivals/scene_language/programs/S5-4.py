# Answer of an unnamed frontier model, 2026-11-23, to the request S5-4 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are several billiards on the billiard table. The cue ball strikes the black ball, sending it cleanly into the bottom pocket.
"""

R = 1.0  # ball radius; the table is measured in balls and laid in the x-y plane, seen from above (+z)
TX, TY = 34.0, 18.0


@register()
def ball(color, number_patch: bool) -> Shape:
    s = primitive_call('sphere', shape_kwargs={'radius': R}, color=color)
    if number_patch:
        s = concat_shapes(s, transform_shape(primitive_call('sphere', shape_kwargs={'radius': 0.45}, color=(1, 1, 1)), translation_matrix((0, 0, 0.62))))
    return s


@register()
def table_surface() -> Shape:
    cloth = transform_shape(primitive_call('cube', shape_kwargs={'scale': (TX, TY, 1)}, color=(0.05, 0.4, 0.35)), translation_matrix((0, 0, -R - 0.5)))
    top_bottom = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (TX + 4, 2, 2.6)}, color=(0.45, 0.22, 0.1)),
                                                   translation_matrix((0, (2 * i - 1) * (TY / 2 + 1), -0.9))))
    left_right = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (2, TY, 2.6)}, color=(0.45, 0.22, 0.1)),
                                                   translation_matrix(((2 * i - 1) * (TX / 2 + 1), 0, -0.9))))
    return concat_shapes(cloth, top_bottom, left_right)


@register()
def pockets() -> Shape:
    return loop(6, lambda i: transform_shape(
        primitive_call('cylinder', shape_kwargs={'radius': 1.7, 'p0': (0, 0, -R - 0.9), 'p1': (0, 0, 0.45)}, color=(0.03, 0.03, 0.03)),
        translation_matrix(((i % 3 - 1) * TX / 2, (i // 3 - 0.5) * TY, 0))))


@register()
def resting_balls() -> Shape:
    rack = [(-12, 4, (1, 0.85, 0.1)), (-7, -5, (0.1, 0.2, 0.8)), (-4, 6, (0.9, 0.15, 0.1)), (7, 5, (0.45, 0.1, 0.5)),
            (11, -3, (1, 0.5, 0.1)), (13, 6, (0.1, 0.5, 0.2)), (6, -6, (0.5, 0.1, 0.15))]
    return loop(len(rack), lambda i: transform_shape(library_call('ball', color=rack[i][2], number_patch=True), translation_matrix((rack[i][0], rack[i][1], 0))))


@register()
def cue_stick(tip: P, direction: P) -> Shape:
    tip, direction = np.array(tip), np.array(direction)
    mid, end = tip - direction * 8, tip - direction * 15
    return concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.2, 'p0': tuple(tip), 'p1': tuple(mid)}, color=(0.9, 0.75, 0.5)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.3, 'p0': tuple(mid), 'p1': tuple(end)}, color=(0.3, 0.12, 0.05)))


@register_animation()
def cue_ball_pots_black() -> Generator[Shape, None, None]:
    pocket = np.array([0.0, -TY / 2, 0.0])          # bottom middle pocket
    black0 = np.array([1.5, -3.0, 0.0])
    line = (pocket - black0) / np.linalg.norm(pocket - black0)
    ghost = black0 - 2 * R * line
    cue0 = np.array([0.5, 6.5, 0.0])
    shot = (ghost - cue0) / np.linalg.norm(ghost - cue0)
    n_aim, n_cue, n_black, n_drop = 10, 14, 14, 8
    tangent = shot - line * float(np.dot(shot, line))
    for frame in range(n_aim + n_cue + n_black + n_drop + 4):
        stroke = min(frame / n_aim, 1.0)
        gap = R + 0.3 + 2.5 * math.sin(math.pi * stroke)
        if frame <= n_aim:
            cue, black = cue0, black0
        elif frame <= n_aim + n_cue:
            s = (frame - n_aim) / n_cue
            cue, black = cue0 + (ghost - cue0) * s, black0
        else:
            k = frame - n_aim - n_cue
            s = min(1.0, k / n_black)
            cue = ghost + (tangent * 8 + shot * 0.6) * (1 - math.exp(-0.12 * k))
            black = black0 + (pocket - black0) * s
            fall = max(0, k - n_black) / n_drop
            black = black - np.array([0, 0, 4.0 * min(1.0, fall) ** 2])
        parts = concat_shapes(
            library_call('table_surface'), library_call('pockets'), library_call('resting_balls'),
            transform_shape(library_call('ball', color=(1, 1, 1), number_patch=False), translation_matrix(cue)),
            transform_shape(library_call('ball', color=(0, 0, 0), number_patch=True),
                            translation_matrix(black) @ rotation_matrix(float(np.linalg.norm(black - black0)) / R, (-line[1], line[0], 0), (0, 0, 0))))
        if frame < n_aim + 6:
            parts = concat_shapes(parts, library_call('cue_stick', tip=cue0 - shot * gap, direction=shot))
        # scale the scene to a convenient size
        yield transform_shape(parts, scale_matrix(0.1, (0, 0, 0)))
