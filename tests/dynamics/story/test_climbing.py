"""Ways along the side of a thing: at its surface, never in it."""

from __future__ import annotations

from itertools import pairwise
import math

import numpy as np
import pytest

from esg.dynamics.story.climbing import (
    Climber,
    Pose,
    climb,
    slope_deg,
    stands_on_top,
    times,
    velocities,
    walk_down,
)
from esg.dynamics.story.outlines import Floats, corners, outline


def box(
    long: float,
    wide: float,
    high: float,
    u: float = 0.0,
    z: float | None = None,
    aside: float = 0.0,
) -> Floats:
    at = (u, aside, 0.5 * high if z is None else z)
    return corners("box", (0.5 * long, 0.5 * wide, 0.5 * high), ()) + np.array(at)


MAN = Climber((box(0.3, 0.5, 1.7, z=0.0),), 0.5)
CAT = Climber((box(0.5, 0.12, 0.3, z=0.0),), 0.5)
WALL, CRATE = [box(0.2, 4.0, 2.5)], [box(0.6, 0.6, 0.4)]
STAIRS = [box(0.3, 1.2, 0.17 * k, u=-1.2 + 0.3 * k) for k in range(1, 5)]
TREE = [
    corners("cylinder", (0.15, 0.15, 1.5), ()) + np.array([0.0, 0.0, 1.5]),
    corners("sphere", (1.2, 1.2, 1.2), ()) + np.array([0.0, 0.0, 4.0]),
]


def turned(who: Climber, pose: Pose) -> Floats:
    """The corners of a climber in a pose: along, across, up."""
    cos, sin = math.cos(pose.tilt), math.sin(pose.tilt)
    turn = np.array([[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]])
    return who.points @ turn.T + np.array([pose.u, 0.0, pose.z])


def between(poses: list[Pose]) -> list[Pose]:
    """Poses on the straight lines of a way, too."""
    out: list[Pose] = []
    for a, b in pairwise(poses):
        for s in np.linspace(0.0, 1.0, 9):
            out.append(
                Pose(*(x + s * (y - x) for x, y in ((a.u, b.u), (a.z, b.z), (a.tilt, b.tilt))))
            )
    return out


def sunk(who: Climber, thing: list[Floats], pose: Pose) -> float:
    """How deep an upright climber's box is in boxes [m]; never less than 0."""
    low, high = turned(who, pose).min(axis=0), turned(who, pose).max(axis=0)
    deep = [np.minimum(high, c.max(axis=0)) - np.maximum(low, c.min(axis=0)) for c in thing]
    return max(0.0, *(float(d.min()) for d in deep))


@pytest.mark.parametrize("thing", [WALL, CRATE, STAIRS])
@pytest.mark.parametrize("course", ["up", "onto", "over"])
def test_who_climbs_upright_is_never_in_what_he_climbs(thing, course):
    poses = climb(MAN, thing, course)
    assert poses is not None
    assert max(sunk(MAN, thing, p) for p in between(poses)) < 0.012
    assert all(p.tilt == 0.0 for p in poses)


def test_stairs_are_walked_step_by_step_to_their_top():
    poses = climb(MAN, STAIRS, "onto")
    assert poses is not None
    feet = [p.z - MAN.foot for p in poses]
    assert feet[0] == pytest.approx(0.002)
    assert feet[-1] == pytest.approx(0.68, abs=0.01)
    for rise in (0.17, 0.34, 0.51):
        assert any(abs(f - rise) < 0.03 for f in feet)
    assert slope_deg(STAIRS) < 45.0 < slope_deg(WALL)


def test_stairs_are_walked_down_face_forward():
    away = [c * np.array([-1.0, 1.0, 1.0]) for c in STAIRS]
    poses = walk_down(MAN, away)
    assert poses is not None
    assert poses[0].z > poses[-1].z + 0.6
    assert poses[-1].u > poses[0].u + 1.0


def test_who_climbs_over_a_wall_ends_on_its_other_side():
    poses = climb(MAN, WALL, "over")
    assert poses is not None
    assert poses[0].u < -0.25 < 0.25 < poses[-1].u
    assert poses[0].z == pytest.approx(poses[-1].z)
    assert max(p.z for p in poses) - MAN.foot > 2.5


def test_who_goes_on_all_fours_turns_its_belly_to_the_wall():
    assert CAT.flat
    assert not MAN.flat
    poses = climb(CAT, WALL, "up")
    assert poses is not None
    assert poses[0].tilt == 0.0
    assert poses[-1].tilt == pytest.approx(0.5 * math.pi, abs=0.02)
    for pose in between(poses):
        points = turned(CAT, pose)
        assert points[:, 0].max() <= -0.1 + 0.01  # the wall's face is at -0.1
        assert points[:, 2].min() >= -0.01
    assert -0.1 - turned(CAT, poses[-1])[:, 0].max() < 0.05


def test_a_cat_comes_down_behind_a_wall_head_first():
    poses = climb(CAT, WALL, "over")
    assert poses is not None
    assert min(p.tilt for p in poses) == pytest.approx(-0.5 * math.pi, abs=0.02)
    assert poses[-1].tilt == 0.0
    assert poses[-1].u > 0.2


def test_nobody_climbs_past_the_crown_of_a_tree():
    poses = climb(CAT, TREE, "up", 9.0)
    assert poses is not None
    assert 1.0 < max(turned(CAT, p)[:, 2].max() for p in poses) < 3.2


def test_a_told_height_is_kept():
    poses = climb(MAN, [box(0.2, 0.2, 4.0)], "up", 1.5)
    assert poses is not None
    assert poses[-1].z - MAN.foot == pytest.approx(1.5, abs=0.02)


def test_the_way_down_is_the_way_up_backwards():
    up, down = climb(MAN, WALL, "up"), climb(MAN, WALL, "down")
    assert up is not None
    assert down == up[::-1]


def test_there_is_nothing_to_climb_where_nothing_stands():
    assert climb(MAN, [box(0.2, 0.2, 1.0, aside=5.0)], "up") is None


def test_a_narrow_top_has_no_room():
    assert stands_on_top(MAN, CRATE)
    assert not stands_on_top(MAN, WALL)


def test_a_climb_takes_its_time_and_rests_at_its_ends():
    poses = climb(MAN, CRATE, "onto")
    assert poses is not None
    at = times(poses, 0.5)
    assert all(a < b for a, b in pairwise(at))
    assert all(abs(60.0 * t - round(60.0 * t)) < 1e-6 for t in at)
    speeds = velocities(poses, at)
    assert speeds[0] == speeds[-1] == (0.0, 0.0)


def test_an_outline_is_exact_for_what_leans():
    leaning = [np.array([[0.0, y, 0.0] for y in (-1, 1)] + [[1.0, y, 2.0] for y in (-1, 1)])]
    sides = outline(leaning, 0.0)
    assert sides.top == pytest.approx(2.0)
    assert sides.near[100] == pytest.approx(0.5, abs=0.01)
