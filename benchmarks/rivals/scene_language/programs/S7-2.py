# Answer of an unnamed frontier model, 2026-11-23, to the request S7-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
There are three balls on the ground. Ball A moves and hits ball B, giving ball B an initial speed at 2m/s, then ball B hits ball C.
"""


@register()
def ball(name: str) -> Shape:
    palette = {'A': (1.0, 0.3, 0.2), 'B': (0.3, 1.0, 0.4), 'C': (0.3, 0.4, 1.0)}
    return primitive_call('sphere', shape_kwargs={'radius': 0.5}, color=palette[name])


@register()
def ground() -> Shape:
    return primitive_call('cube', shape_kwargs={'scale': (14, 0.2, 6)}, color=(0.45, 0.65, 0.4))


@register()
def scene(pos_a: P, pos_b: P, pos_c: P) -> Shape:
    ground = library_call('ground')
    top = compute_shape_max(ground)[1]

    def on_ground(name: str, pos: P) -> Shape:
        b = library_call('ball', name=name)
        lift = top - compute_shape_min(b)[1]
        return transform_shape(b, translation_matrix((pos[0], lift, pos[1])))

    return concat_shapes(ground, on_ground('A', pos_a), on_ground('B', pos_b), on_ground('C', pos_c))


@register_animation()
def oblique_hits() -> Generator[Shape, None, None]:
    # B strikes C off-center, so that they part at an angle in the ground plane (x, z)
    fps, seconds = 20, 4
    diameter = 1.0
    v_a = np.array([2.2, 0.0])
    a_start = np.array([-4.5, 0.0])
    b_start = np.array([-1.0, 0.0])
    offset = 0.4
    c_start = np.array([2.0, offset])

    t1 = (b_start[0] - a_start[0] - diameter) / v_a[0]
    v_a_after = np.array([0.2, 0.0])
    v_b = np.array([2.0, 0.0])  # B's initial speed is 2 m/s

    # B stops traveling freely when it is one diameter from C
    reach = c_start[0] - math.sqrt(diameter ** 2 - offset ** 2) - b_start[0]
    t2 = t1 + reach / v_b[0]
    b_hit = b_start + v_b * (t2 - t1)
    n = (c_start - b_hit) / diameter
    v_c_after = n * float(np.dot(v_b, n))
    v_b_after = v_b - v_c_after

    for frame in range(fps * seconds):
        t = frame / fps
        pa = a_start + v_a * min(t, t1) + v_a_after * max(t - t1, 0)
        pb = b_start + v_b * max(min(t, t2) - t1, 0) + v_b_after * max(t - t2, 0)
        pc = c_start + v_c_after * max(t - t2, 0)
        yield library_call('scene', pos_a=tuple(pa), pos_b=tuple(pb), pos_c=tuple(pc))
