# Answer of an unnamed frontier model, 2026-11-23, to the request S9-0 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car moves along the street and turns left at a cross. It brakes hard after entering the new lane, but still hits a bicycle stopped in the middle of the road.
"""


@register()
def crossroad() -> Shape:
    asphalt = (0.35, 0.35, 0.35)
    ground = transform_shape(primitive_call('cube', shape_kwargs={'scale': (50, 0.1, 50)}, color=(0.4, 0.6, 0.35)), translation_matrix((0, -0.1, 0)))
    street_z = transform_shape(primitive_call('cube', shape_kwargs={'scale': (8, 0.1, 50)}, color=asphalt), translation_matrix((0, -0.05, 0)))
    street_x = transform_shape(primitive_call('cube', shape_kwargs={'scale': (50, 0.1, 8)}, color=asphalt), translation_matrix((0, -0.05, 0)))

    def dash_pair(i: int) -> Shape:
        d = 6 + 3 * (i % 7)
        s = 1 if i < 7 else -1
        return concat_shapes(
            transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.15, 0.02, 1.5)}, color=(1, 1, 1)), translation_matrix((0, 0.01, s * d))),
            transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.5, 0.02, 0.15)}, color=(1, 1, 1)), translation_matrix((s * d, 0.01, 0))))

    return concat_shapes(ground, street_z, street_x, loop(14, dash_pair))


@register()
def car() -> Shape:
    # faces -z
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.6, 4.0)}, color=(0.1, 0.2, 0.7)), translation_matrix((0, 0.65, 0)))
    cabin = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.6, 0.55, 2.0)}, color=(0.7, 0.8, 0.9)), translation_matrix((0, 1.22, 0.2)))
    wheels = loop(4, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.35,
        'p0': (-0.95 + 1.7 * (i % 2), 0.35, -1.25 + 2.5 * (i // 2)),
        'p1': (-0.75 + 1.7 * (i % 2), 0.35, -1.25 + 2.5 * (i // 2))}, color=(0.05, 0.05, 0.05)))
    return concat_shapes(body, cabin, wheels)


@register()
def bicycle() -> Shape:
    # lies along z, stands on y = 0
    frame_color = (0.9, 0.2, 0.1)

    def rod(p0: P, p1: P) -> Shape:
        return primitive_call('cylinder', shape_kwargs={'radius': 0.03, 'p0': p0, 'p1': p1}, color=frame_color)

    wheels = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.33, 'p0': (-0.02, 0.33, -0.5 + i), 'p1': (0.02, 0.33, -0.5 + i)}, color=(0.1, 0.1, 0.1)))
    return concat_shapes(
        wheels,
        rod((0, 0.33, 0.5), (0, 0.35, 0.05)), rod((0, 0.35, 0.05), (0, 0.85, 0.2)),
        rod((0, 0.75, 0.18), (0, 0.8, -0.35)), rod((0, 0.35, 0.05), (0, 0.75, -0.35)),
        rod((0, 0.33, 0.5), (0, 0.75, 0.18)), rod((0, 0.33, -0.5), (0, 0.95, -0.35)),
        rod((-0.25, 0.95, -0.35), (0.25, 0.95, -0.35)),
        transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.12, 0.06, 0.25)}, color=(0, 0, 0)), translation_matrix((0, 0.88, 0.2))))


def car_pose_at(s: float, straight: float, radius: float) -> tuple:
    """position (x, z) and yaw after traveling s meters: straight along -z, left arc, straight along -x"""
    arc = radius * math.pi / 2
    x0, z_turn = 2.0, 4.0
    if s < straight:
        return x0, z_turn + straight - s, 0.0
    if s < straight + arc:
        a = (s - straight) / radius
        return x0 - radius + radius * math.cos(a), z_turn - radius * math.sin(a), a
    return x0 - radius - (s - straight - arc), z_turn - radius, math.pi / 2


@register_animation()
def left_turn_crash() -> Generator[Shape, None, None]:
    fps = 20
    total_frames = 110
    straight, radius = 14.0, 6.0
    arc = radius * math.pi / 2
    cruise, decel = 8.0, 6.0
    bike_x, bike_z = -8.5, -2.0

    s, v = 0.0, cruise
    bike_shift, bike_v, bike_tilt = 0.0, 0.0, 0.0
    hit = False
    for frame in range(total_frames):
        x, z, yaw = car_pose_at(s, straight, radius)
        car_shape = transform_shape(library_call('car'), translation_matrix((x, 0, z)) @ rotation_matrix(yaw, (0, 1, 0), (0, 0, 0)))
        # the bicycle falls away from the car, toward -x
        bike = transform_shape(
            library_call('bicycle'),
            translation_matrix((bike_x - bike_shift, 0, bike_z)) @ rotation_matrix(bike_tilt, (0, 0, 1), (0, 0, 0)))
        yield concat_shapes(library_call('crossroad'), car_shape, bike)

        # motion
        dt = 1 / fps
        if s >= straight + arc + 0.3:
            v = max(0.0, v - decel * dt)      # hard braking in the new lane
        s += v * dt
        if not hit and compute_shape_min(car_shape)[0] - v * dt <= bike_x + 0.3 and s > straight + arc:
            hit = True
            bike_v = v * 0.9
            v *= 0.7
        if hit:
            bike_shift += bike_v * dt
            bike_v = max(0.0, bike_v - 3.5 * dt)
            bike_tilt = min(bike_tilt + 4.0 * dt, math.pi / 2 * 0.97)
