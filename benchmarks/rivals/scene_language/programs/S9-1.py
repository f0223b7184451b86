# Answer of an unnamed frontier model, 2026-11-23, to the request S9-1 of
# `python -m benchmarks.rivals.scene_language.requests` (Scene Language's own
# prompts, published/); unchanged.
from helper import *

"""
A car moves along the street and turns left at a cross. It brakes hard after entering the new lane, but still hits a bicycle stopped in the middle of the road.
"""


@register()
def streets() -> Shape:
    gray = (0.4, 0.4, 0.4)
    east_west = primitive_call('cube', shape_kwargs={'scale': (40, 0.1, 6)}, color=gray)
    north_south = primitive_call('cube', shape_kwargs={'scale': (6, 0.1, 40)}, color=gray)
    return transform_shape(concat_shapes(east_west, north_south), translation_matrix([0, -0.05, 0]))


@register()
def building(width: float, height: float, color: tuple[float, float, float]) -> Shape:
    block = primitive_call('cube', shape_kwargs={'scale': (width, height, width)}, color=color)
    return transform_shape(block, translation_matrix([0, height / 2, 0]))


@register()
def city() -> Shape:
    return loop(4, lambda i: transform_shape(
        library_call('building', width=6, height=3 + i, color=(0.7 - 0.1 * i, 0.6, 0.5 + 0.1 * i)),
        translation_matrix([(-9 if i % 2 == 0 else 9), 0, (-9 if i < 2 else 9)])))


@register()
def car() -> Shape:
    # heading +x
    red = (0.85, 0.1, 0.1)
    body = transform_shape(primitive_call('cube', shape_kwargs={'scale': (3.6, 0.6, 1.6)}, color=red), translation_matrix([0, 0.6, 0]))
    top = transform_shape(primitive_call('cube', shape_kwargs={'scale': (1.8, 0.5, 1.4)}, color=(0.3, 0.3, 0.4)), translation_matrix([-0.2, 1.15, 0]))
    wheel_pairs = loop(2, lambda i: concat_shapes(
        primitive_call('cylinder', shape_kwargs={'radius': 0.32, 'p0': (-1.1 + 2.2 * i, 0.32, 0.7), 'p1': (-1.1 + 2.2 * i, 0.32, 0.88)}, color=(0, 0, 0)),
        primitive_call('cylinder', shape_kwargs={'radius': 0.32, 'p0': (-1.1 + 2.2 * i, 0.32, -0.88), 'p1': (-1.1 + 2.2 * i, 0.32, -0.7)}, color=(0, 0, 0))))
    return concat_shapes(body, top, wheel_pairs)


@register()
def bicycle() -> Shape:
    # heading +x, crosswise to the car's final direction
    wheels = loop(2, lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.35, 'p0': (-0.5 + i, 0.35, -0.025), 'p1': (-0.5 + i, 0.35, 0.025)}, color=(0.1, 0.1, 0.1)))
    joints = [(-0.5, 0.35, 0), (0, 0.35, 0), (-0.15, 0.8, 0), (0.4, 0.8, 0), (0.5, 0.35, 0)]
    links = [(0, 1), (1, 2), (0, 2), (2, 3), (1, 3), (3, 4)]
    tubes = loop(len(links), lambda i: primitive_call('cylinder', shape_kwargs={
        'radius': 0.03, 'p0': joints[links[i][0]], 'p1': joints[links[i][1]]}, color=(0.1, 0.7, 0.3)))
    handle = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0.4, 0.95, -0.25), 'p1': (0.4, 0.95, 0.25)}, color=(0.2, 0.2, 0.2))
    stem = primitive_call('cylinder', shape_kwargs={'radius': 0.025, 'p0': (0.4, 0.8, 0), 'p1': (0.4, 0.95, 0)}, color=(0.2, 0.2, 0.2))
    saddle = transform_shape(primitive_call('cube', shape_kwargs={'scale': (0.28, 0.06, 0.14)}, color=(0.2, 0.1, 0.05)), translation_matrix([-0.15, 0.85, 0]))
    return concat_shapes(wheels, tubes, handle, stem, saddle)


@register_animation()
def turn_left_and_hit_bicycle() -> Generator[Shape, None, None]:
    approach_frames, turn_frames, brake_frames, after_frames = 20, 15, 10, 12
    total = approach_frames + turn_frames + brake_frames + after_frames
    r = 4.5
    lane = 1.5          # right-hand lane: z = +1.5 heading +x, x = +1.5 heading -z
    turn_start_x = lane - r
    turn_end_z = lane - r
    bike_start = np.array([lane - 0.2, 0.0, -9.0])

    for frame in range(total):
        yaw = 0.0
        bike_pose = translation_matrix(bike_start)
        if frame < approach_frames:
            u = frame / approach_frames
            pos = np.array([-15 + (turn_start_x + 15) * u, 0, lane])
        elif frame < approach_frames + turn_frames:
            yaw = math.pi / 2 * (frame - approach_frames) / turn_frames
            pos = np.array([turn_start_x + r * math.sin(yaw), 0, lane - r * (1 - math.cos(yaw))])
        else:
            yaw = math.pi / 2
            k = frame - approach_frames - turn_frames
            n = brake_frames + after_frames
            u = k / n
            # quadratic ease-out = constant deceleration to a full stop
            travel = 6.5 * (1 - (1 - u) ** 2)
            pos = np.array([lane, 0, turn_end_z - travel])
            nose = pos[2] - 1.8
            overlap = (bike_start[2] + 0.1) - nose
            if overlap > 0:
                # the car's nose pushes the bicycle and topples it
                fall = min(overlap / 0.8, 1.0) * math.pi / 2
                pushed = bike_start + np.array([0, 0.05, -overlap * 1.3])
                bike_pose = translation_matrix(pushed) @ rotation_matrix(-fall, (1, 0, 0), (0, 0, 0))

        car = transform_shape(library_call('car'), translation_matrix(pos) @ rotation_matrix(yaw, (0, 1, 0), (0, 0, 0)))
        bike = transform_shape(library_call('bicycle'), bike_pose)
        yield concat_shapes(library_call('streets'), library_call('city'), car, bike)
