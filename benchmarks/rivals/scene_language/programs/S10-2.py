# Answer of an unnamed frontier model, 2026-11-23, to the request S10-2 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
Two cars moves at the same speed of 5~10m/s, one in front of the other. The front car suddenly brakes, and two cars collide after 1 second.
"""


@register()
def highway(length: float) -> Shape:
    # along -z
    deck = transform_shape(primitive_call('cube', shape_kwargs={'scale': (8, 0.1, length)}, color=(0.28, 0.28, 0.3)), translation_matrix((0, -0.05, -length / 2)))
    stripes = loop(int(length // 3), lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.15, 0.02, 1.4)}, color=(1, 1, 1)),
        translation_matrix((0, 0.01, -1.5 - 3 * i))))
    rails = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.1, 0.3, length)}, color=(0.7, 0.7, 0.7)),
        translation_matrix((-4.2 + 8.4 * i, 0.5, -length / 2))))
    return concat_shapes(deck, stripes, rails)


@register()
def car_hood(color: tuple[float, float, float], crumple: float) -> Shape:
    # the hood shortens and buckles upward as it is crushed
    size = 1.2 - 0.35 * crumple
    panel = primitive_call('cube', shape_kwargs={'scale': (1.75, 0.5, size)}, color=color)
    return transform_shape(panel, translation_matrix((0, 0.65 + 0.08 * crumple, -0.9 - size / 2)) @ rotation_matrix(0.12 * crumple, (1, 0, 0), (0, 0, 0)))


@register()
def car(color: tuple[float, float, float], brake_on: bool, crumple: float, roll: float) -> Shape:
    center = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.6, 1.9)}, color=color), translation_matrix((0, 0.65, 0.05)))
    trunk = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.75, 0.55, 1.0)}, color=color), translation_matrix((0, 0.65, 1.5)))
    glass = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.5, 1.8)}, color=(0.55, 0.7, 0.8)), translation_matrix((0, 1.2, 0.15)))
    lamps = loop(2, lambda i: transform_shape(
        primitive_call('cube', shape_kwargs={'scale': (0.4, 0.14, 0.04)}, color=(1, 0.05, 0.05) if brake_on else (0.35, 0.05, 0.05)),
        translation_matrix((-0.6 + 1.2 * i, 0.75, 2.01))))

    def wheel_at(i: int) -> Shape:
        w = concat_shapes(
            primitive_call('cylinder', shape_kwargs={'radius': 0.33, 'p0': (-0.1, 0, 0), 'p1': (0.1, 0, 0)}, color=(0.07, 0.07, 0.07)),
            primitive_call('cube', shape_kwargs={'scale': (0.22, 0.4, 0.07)}, color=(0.75, 0.75, 0.75)))
        pos = (-0.85 if i % 2 else 0.85, 0.33, -1.2 if i < 2 else 1.3)
        return transform_shape(w, translation_matrix(pos) @ rotation_matrix(roll, (1, 0, 0), (0, 0, 0)))

    return concat_shapes(center, trunk, glass, lamps, library_call('car_hood', color=color, crumple=crumple), loop(4, wheel_at))


@register_animation()
def sudden_brake_collision() -> Generator[Shape, None, None]:
    fps = 24
    dt = 1 / fps
    v0, brake = 9.0, 7.0
    t_brake, t_collide = 0.75, 1.75
    car_len = 4.1

    rear, front = 0.0, car_len + 0.5 * brake * 1.0 ** 2
    v_rear, v_front = v0, v0
    crumple, hit = 0.0, False

    for frame in range(int(3.6 * fps)):
        t = frame * dt
        yield concat_shapes(
            library_call('highway', length=42.0),
            transform_shape(
                library_call('car', color=(0.95, 0.75, 0.1), brake_on=hit, crumple=crumple, roll=-rear / 0.33),
                translation_matrix((2, 0, -3 - rear))),
            transform_shape(
                library_call('car', color=(0.2, 0.6, 0.35), brake_on=t >= t_brake, crumple=0.0, roll=-front / 0.33),
                translation_matrix((2, 0, -3 - front))))

        if not hit and t + dt >= t_collide:
            # perfectly inelastic hit between equal masses, with the rear car's hood crushed
            hit = True
            v_rear = v_front = (v_rear + v_front) / 2
        nf = max(0.0, v_front - brake * dt) if t >= t_brake else v_front
        nr = max(0.0, v_rear - brake * dt) if hit else v_rear
        front += (v_front + nf) / 2 * dt
        rear += (v_rear + nr) / 2 * dt
        v_front, v_rear = nf, nr
        if hit:
            grow = min(1.0, crumple + 0.25) - crumple
            crumple += grow
            rear += 0.35 * grow
