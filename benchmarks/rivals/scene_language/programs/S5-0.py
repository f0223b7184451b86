# Answer of an unnamed frontier model, 2026-11-23, to the request S5-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are several billiards on the billiard table. The cue ball strikes the black ball, sending it cleanly into the bottom pocket.
"""

R = 0.12
W, L = 2.4, 4.8  # playing area: x in [-W/2, W/2], z in [-L/2, L/2]; +z is the bottom of the table


@register()
def table() -> Shape:
    felt = transform_shape(primitive_call('cube', shape_kwargs={'scale': (W + 0.3, 0.2, L + 0.3)}, color=(0.05, 0.45, 0.2)), translation_matrix((0, -0.1, 0)))
    rail_l = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.25, 0.35, L + 0.8)}, color=(0.4, 0.22, 0.1)), translation_matrix(((2 * i - 1) * (W / 2 + 0.275), -0.02, 0))))
    rail_s = loop(2, lambda i: transform_shape(primitive_call('cube', shape_kwargs={'scale': (W + 0.8, 0.35, 0.25)}, color=(0.4, 0.22, 0.1)), translation_matrix((0, -0.02, (2 * i - 1) * (L / 2 + 0.275)))))
    legs = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.15, 'p0': ((i % 2 - 0.5) * W, -1.6, (i // 2 - 0.5) * L), 'p1': ((i % 2 - 0.5) * W, -0.2, (i // 2 - 0.5) * L)}, color=(0.35, 0.2, 0.1)))
    return concat_shapes(felt, rail_l, rail_s, legs)


@register()
def pockets() -> Shape:
    return loop(6, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.19, 'p0': ((i % 2 - 0.5) * W, -0.15, (i // 2 - 1) * L / 2), 'p1': ((i % 2 - 0.5) * W, 0.005, (i // 2 - 1) * L / 2)}, color=(0.02, 0.02, 0.02)))


@register()
def billiard_ball(color) -> Shape:
    ball = primitive_call('sphere', shape_kwargs={'radius': R}, color=color)
    dot = transform_shape(primitive_call('sphere', shape_kwargs={'radius': R * 0.4}, color=(1, 1, 1)), translation_matrix((0, R * 0.65, 0)))
    return concat_shapes(ball, dot)


@register()
def other_balls() -> Shape:
    spots = [(-0.8, -1.8), (0.7, -1.5), (-0.3, -0.9), (0.9, 0.2), (-0.9, 0.6), (0.75, 1.2), (-0.6, -2.1)]
    colors = [(1, 0.85, 0), (0.1, 0.2, 0.8), (0.85, 0.1, 0.1), (0.4, 0.1, 0.5), (1, 0.5, 0.1), (0.1, 0.5, 0.2), (0.5, 0.1, 0.1)]
    return loop(len(spots), lambda i: transform_shape(library_call('billiard_ball', color=colors[i]), translation_matrix((spots[i][0], R, spots[i][1]))))


@register()
def rolling_ball(color, pos: P, direction: P, dist: float) -> Shape:
    axis = (direction[2], 0, -direction[0])
    b = transform_shape(library_call('billiard_ball', color=color), rotation_matrix(dist / R, axis, (0, 0, 0)))
    return transform_shape(b, translation_matrix(pos))


@register_animation()
def pot_the_black() -> Generator[Shape, None, None]:
    pocket = np.array([-W / 2, R, L / 2])
    black0 = np.array([-0.4, R, 1.2])
    aim = (pocket - black0) / np.linalg.norm(pocket - black0)
    ghost = black0 - 2 * R * aim  # cue ball centre at contact
    cue0 = np.array([0.1, R, -1.0])
    cue_dir = (ghost - cue0) / np.linalg.norm(ghost - cue0)
    d_cue, d_black = np.linalg.norm(ghost - cue0), np.linalg.norm(pocket - black0)
    fps, v, still = 24, 2.8, 0.25
    t_hit = still + d_cue / v
    cut = float(np.dot(cue_dir, aim))
    v_black = v * cut
    v_side = cue_dir * v - aim * v_black
    total_frames = int(fps * (t_hit + d_black / v_black + 1.0))
    for frame in range(total_frames):
        t = frame / fps
        if t < t_hit:
            s = max(0.0, t - still) * v
            cue_pos, cue_dist, black_pos, black_dist = cue0 + cue_dir * s, s, black0, 0.0
        else:
            d = t - t_hit
            glide = (1 - math.exp(-1.5 * d)) / 1.5
            cue_pos, cue_dist = ghost + (v_side + 0.05 * v * cue_dir) * glide, d_cue + 0.3 * glide
            black_dist = min(v_black * d, d_black)
            black_pos = black0 + aim * black_dist
            drop = max(0.0, d - d_black / v_black)
            black_pos = black_pos - np.array([0, min(0.6, 4.9 * drop * drop), 0])
        cue = library_call('rolling_ball', color=(1, 1, 0.95), pos=cue_pos, direction=cue_dir, dist=cue_dist)
        black = library_call('rolling_ball', color=(0.03, 0.03, 0.03), pos=black_pos, direction=aim, dist=black_dist)
        yield concat_shapes(library_call('table'), library_call('pockets'), library_call('other_balls'), cue, black)
