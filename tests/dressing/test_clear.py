"""What dresses a place is in nobody's way: neither at the start nor at any other time."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dressing import dress
from esg.dressing.arrange import FLAT_M, MOST_ITEMS
from esg.dressing.builders import BUILDERS
from esg.engines.scene import Region, Rollout, SimScene
from esg.graph import canonical_json, verify
from esg.graph.models import Dressing, DressingItem
from tests.dressing.worlds import (
    body,
    document,
    ground,
    road,
    rollout_of,
    scene_of,
    some_world,
    straight,
)

NUMBERS = range(50)


def corners(x: float, y: float, yaw: float, a: float, b: float) -> np.ndarray:
    """Of a rectangle of half extents `a` and `b`, shape [4, 2]."""
    local = np.array([[a, b], [-a, b], [-a, -b], [a, -b]])
    c, s = math.cos(yaw), math.sin(yaw)
    return local @ np.array([[c, s], [-s, c]]) + (x, y)


def rectangle(item: DressingItem) -> np.ndarray:
    x, y, _ = np.array(item.position_cm) / 100
    a, b = item.size_cm[0] / 200, item.size_cm[1] / 200
    return corners(x, y, math.radians(item.yaw_deg), a, b)


def footprints(scene: SimScene, rollout: Rollout, index: int) -> np.ndarray:
    """Of an upright body in every sixth frame, shape [n, 4, 2]."""
    p, q = rollout.position[0, ::6, index], rollout.quaternion[0, ::6, index]
    a, b = scene.bodies[index].half_extents[:2]
    yaw = 2 * np.arctan2(q[:, 2], q[:, 3])
    return np.array([corners(*p[k, :2], yaw[k], a, b) for k in range(len(p))])


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """Distance of two convex polygons [m]; 0 where they overlap."""
    for p, q in ((one, other), (other, one)):
        edge = np.roll(p, -1, axis=0) - p
        normal = np.stack([edge[:, 1], -edge[:, 0]], axis=1)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        if np.any(((q[None] - p[:, None]) * normal[:, None]).sum(-1).min(axis=1) > 1e-9):
            break
    else:
        return 0.0
    return min(to_edges(one, other), to_edges(other, one))


def to_edges(points: np.ndarray, polygon: np.ndarray) -> float:
    """Least distance from points to the edges of a polygon [m]."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    way = b - a
    t = ((points[:, None] - a) * way).sum(-1) / (way**2).sum(-1)
    near = a + np.clip(t, 0, 1)[..., None] * way
    return float(np.linalg.norm(points[:, None] - near, axis=-1).min())


def dressed(number: int) -> tuple[Dressing, SimScene, Rollout]:
    doc, scene, rollout = some_world(number)
    made = dress(doc, scene, rollout, seed=number).dressing
    assert made is not None
    return made, scene, rollout


@pytest.mark.parametrize("number", NUMBERS)
def test_nothing_stands_within_two_metres_of_any_way(number: int) -> None:
    made, scene, rollout = dressed(number)
    boxes = [rectangle(item) for item in made.items]
    for index, item in enumerate(scene.bodies):
        if not item.collides:
            continue
        for foot in footprints(scene, rollout, index):
            for other, box in zip(made.items, boxes, strict=True):
                assert apart(foot, box) > 2.0 - 1e-3, (other.id, item.name)


def test_the_fifty_places_are_full() -> None:
    """Twenty ways to keep clear by standing nowhere: most places have a dozen things."""
    counts = [len(dressed(n)[0].items) for n in NUMBERS]
    assert np.median(counts) >= 12 and min(counts) >= 4 and max(counts) <= MOST_ITEMS


@pytest.mark.parametrize("number", NUMBERS)
def test_things_do_not_stand_in_each_other_or_on_a_road(number: int) -> None:
    made, scene, _ = dressed(number)
    walls = {"room_wall", "room_wall_door", "room_wall_plain", "hall_wall", "hall_wall_gate"}
    hung = {"wall_picture", "notice_board"}
    solid = [i for i in made.items if i.kind not in walls | hung and i.size_cm[2] > 100 * FLAT_M]
    boxes = [rectangle(item) for item in solid]
    for k, one in enumerate(boxes):
        for other, box in zip(solid[:k], boxes, strict=False):
            assert apart(one, box) > 0.0 or apart(0.98 * one + 0.02 * one.mean(0), box) > 0.0, (
                solid[k].id, other.id,
            )  # fmt: skip
    for flat in (b for b in scene.bodies if b.category == "road"):
        yaw = 2 * math.atan2(flat.quaternion[2], flat.quaternion[3])
        lane = corners(*flat.position[:2], yaw, *flat.half_extents[:2])
        for item, box in zip(solid, boxes, strict=True):
            assert apart(lane, box) > 0.0, item.id


def test_a_body_that_turns_while_it_passes_is_given_room() -> None:
    """A plank of 6 m that turns like a propeller sweeps more than it covers at the start."""
    scene = scene_of(ground(), body("plank", (6.0, 0.3, 0.1)))
    rollout = rollout_of(scene, {"plank_1": straight(0.0)}, turns=math.pi)
    for seed in range(5):
        made = dress(document(scene), scene, rollout, seed=seed).dressing
        assert made is not None
        for item in made.items:
            assert float(np.linalg.norm(rectangle(item), axis=1).min()) > 4.9, item.id


def test_walls_stand_beyond_every_way() -> None:
    """A ball that leaves the table rolls on for nine metres, in the room."""
    scene = scene_of(
        body("floor", (20.0, 20.0, 0.01), flat=True), body("table", (0.8, 1.4, 0.75), static=True),
        body("ball", (0.2, 0.2, 0.2), (0.5, 0.0)),
    )  # fmt: skip
    rollout = rollout_of(scene, {"ball_1": straight(9.0, -3.0)})
    doc = document(
        scene, "In the kitchen a ball rolls away.", setting="indoor", environment="kitchen"
    )
    made = dress(doc, scene, rollout).dressing
    assert made is not None and made.place == "kitchen"
    walls = [i for i in made.items if i.kind.startswith("room_wall")]
    assert len(walls) == 4
    for wall in walls:
        yaw = math.radians(wall.yaw_deg)
        inward = np.array([math.cos(yaw), math.sin(yaw)])
        face = np.array(wall.position_cm[:2]) / 100 + 0.5 * wall.size_cm[0] / 100 * inward
        ahead = (rollout.position[0, :, 2, :2] - face) @ inward
        assert float(ahead.min()) > 2.0
    longest = max(w.size_cm[1] for w in walls) / 100
    assert longest > 9.0 + 2 * 2.0


def test_only_leaves_a_scene_as_it_is() -> None:
    scene = scene_of(ground(), body("ball", (0.2, 0.2, 0.2)), body("box", (0.5, 0.4, 0.4), (2, 0)))
    doc = document(scene, "There is only a ball and a box.", more=False)
    assert dress(doc, scene, rollout_of(scene)) is doc


@pytest.mark.parametrize("number", (0, 3, 4))
def test_equal_seeds_give_equal_bytes_and_others_other_places(number: int) -> None:
    doc, scene, rollout = some_world(number)
    first = canonical_json(dress(doc, scene, rollout, seed=1))
    assert canonical_json(dress(doc, scene, rollout, seed=1)) == first
    assert canonical_json(dress(doc, scene, rollout, seed=2)) != first
    again = dress(dress(doc, scene, rollout, seed=2), scene, rollout, seed=1)
    assert canonical_json(again) == first


def test_dressing_changes_no_other_field() -> None:
    doc, scene, rollout = some_world(1)
    made = dress(doc, scene, rollout)
    assert made.model_copy(update={"dressing": None, "provenance": doc.provenance}) == doc
    assert made.provenance[-1].stage == "dress"


@pytest.mark.parametrize("number", range(10))
def test_the_verifier_accepts_what_the_stage_writes(number: int) -> None:
    doc, scene, rollout = some_world(number)
    found = verify(dress(doc, scene, rollout, seed=number))
    assert not [v for v in found if v.pointer.startswith("/dressing")]


def test_kerbs_lie_along_the_road_that_is_there() -> None:
    yaw = 0.7
    scene = scene_of(ground(), road(60.0, (3.0, -2.0), yaw), body("car", (4.5, 1.8, 1.5), (3.0, -4.0), yaw=yaw))  # fmt: skip
    rollout = rollout_of(scene, {"car_1": straight(10 * math.cos(yaw), 10 * math.sin(yaw))})
    doc = document(scene, "A car drives along the street.", environment="street")
    made = dress(doc, scene, rollout).dressing
    assert made is not None and made.place == "street"
    across = np.array([-math.sin(yaw), math.cos(yaw)])
    kerbs = [i for i in made.items if i.kind == "kerb_run"]
    assert kerbs
    for kerb in kerbs:
        turned = math.radians(kerb.yaw_deg)
        front = np.array([math.cos(turned), math.sin(turned)])
        middle = np.array(kerb.position_cm[:2]) / 100 - (3.0, -2.0)
        edge = middle + 0.5 * kerb.size_cm[0] / 100 * front
        assert abs(abs(float(edge @ across)) - 4.0) < 0.01, "its front is the road's edge"
        assert abs(abs(float(front @ across)) - 1.0) < 1e-3 and float(front @ middle) < 0
    paving = [m for m in made.markings if m.surface == "granite"]
    assert len(paving) == 2
    for strip in paving:
        assert abs(math.radians(strip.yaw_deg) - yaw) < 1e-3
        off = abs(float((np.array(strip.center_cm) / 100 - (3.0, -2.0)) @ across))
        assert abs(off - strip.half_cm[1] / 100 - 4.0) < 0.01


def test_houses_stand_at_the_corners_of_a_crossing_and_on_neither_road() -> None:
    """The square around two roads that cross is mostly free."""
    cross = body("crossroad", (80.0, 80.0, 0.01), flat=True)
    bare = scene_of(
        ground(), road(80.0, (0.0, 0.0), 0.0), cross, body("car", (4.5, 1.8, 1.5), (-20, -2))
    )
    crossing = Region("crossroad_1/crossing", "crossroad_1", (0.0, 0.0, 1.0), (3.5, 3.5, 1.0))
    scene = replace(bare, regions=(crossing,))
    rollout = rollout_of(scene, {"car_1": straight(10.0)})
    doc = document(scene, "A car drives along the street.", environment="street")
    made = dress(doc, scene, rollout).dressing
    assert made is not None
    houses = [i for i in made.items if i.kind.startswith("facade")]
    assert len({tuple(np.sign(i.position_cm[:2])) for i in houses}) == 4, "at every corner"
    for item in (i for i in made.items if i.size_cm[2] > 100 * FLAT_M):
        for a, b in ((40.0, 3.5), (3.5, 40.0)):
            assert apart(corners(0.0, 0.0, 0.0, a, b), rectangle(item)) > 0.0, item.id


def test_what_could_be_taken_for_a_thing_of_the_scene_keeps_away() -> None:
    """Who counts the trees near a car that hits one, finds one."""
    scene = scene_of(
        ground(), body("car", (4.5, 1.8, 1.5), (-4, 0)), body("tree", (3.0, 3.0, 5.0), static=True)
    )
    rollout = rollout_of(scene, {"car_1": straight(2.0)})
    doc = document(scene, "A car hits a tree in the park.", environment="park")
    for seed in range(6):
        made = dress(doc, scene, rollout, seed=seed).dressing
        assert made is not None
        trees = [i for i in made.items if i.kind in BUILDERS and "tree" in BUILDERS[i.kind].like]
        assert trees
        for tree in trees:
            foot = corners(0.0, 0.0, 0.0, 1.5, 1.5)
            assert apart(rectangle(tree), foot) > 4.0 - 1e-3
