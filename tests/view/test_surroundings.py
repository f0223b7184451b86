"""What surrounds a scene: its dressing, without what is in a camera's way, or a checkerboard."""

from __future__ import annotations

import numpy as np
import pytest

from esg.dressing import dress
from esg.view.camera import Camera
from esg.view.parts import body_parts, scene_parts
from esg.view.pieces import Part
from esg.view.surroundings import (
    Surroundings,
    before_the_picture,
    in_the_way,
    surroundings_of,
    thing_of,
)
from tests.dressing.worlds import body, document, ground, rollout_of, scene_of, straight


def wall(name: str, x: float) -> Part:
    """A sheet of 4 by 3 m across the X axis."""
    corners = np.array([[x, -2, 0], [x, 2, 0], [x, 2, 3], [x, -2, 3]], float)
    return Part(-1, corners, np.array([[0, 1, 2], [0, 2, 3]]), (1, 1, 1), name=f"{name}/plaster")


ACTION = np.array([[0.0, 0.0, 0.5]])


def test_a_wall_between_camera_and_action_is_in_the_way_and_no_other() -> None:
    parts = (wall("near", 2.0), wall("behind", -2.0), wall("beyond", 8.0))
    assert in_the_way(parts, np.array([[5.0, 0.0, 1.5]]), ACTION) == {"near"}
    assert in_the_way(parts, np.array([[12.0, 0.0, 1.5]]), ACTION) == {"near", "beyond"}
    assert in_the_way(parts, np.array([[-5.0, 0.3, 1.5]]), ACTION) == {"behind"}


def test_a_camera_that_looks_past_a_wall_leaves_it_standing() -> None:
    parts = (wall("near", 2.0),)
    assert not in_the_way(parts, np.array([[5.0, 0.0, 12.0]]), ACTION)
    assert not in_the_way(parts, np.array([[2.5, 8.0, 1.5]]), ACTION)


def test_what_a_camera_stands_in_is_left_out_whole() -> None:
    trunk, crown = wall("tree", 5.0), wall("tree", 5.2)
    other = wall("bench", -9.0)
    around = Surroundings(*_plain(), parts=(trunk, crown, other))
    camera = Camera((5.1, 0.0, 1.5), (9.0, 0.0, 1.0))
    seen = around.seen_from([camera], np.array([[9.0, 0.0, 1.0]]))
    assert [thing_of(p) for p in seen.parts] == ["bench"]


def test_all_eyes_of_a_shot_count() -> None:
    parts = (wall("a", 2.0), wall("b", -2.0))
    eyes = np.array([[5.0, 0.0, 1.5], [-5.0, 0.0, 1.5]])
    assert in_the_way(parts, eyes, ACTION) == {"a", "b"}


def test_what_is_drawn_on_the_ground_hides_nothing() -> None:
    flat = Part(-1, np.array([[-9, -9, 0], [9, -9, 0], [0, 9, 0]], float), np.array([[0, 1, 2]]),
                (1, 1, 1), name="ground/paving_1")  # fmt: skip
    assert not in_the_way((flat,), np.array([[0.0, 0.0, 0.1]]), np.array([[0.0, 0.0, -1.0]]))


def _plain() -> tuple:  # type: ignore[type-arg]
    scene = scene_of(ground(), body("ball", (0.2, 0.2, 0.2)))
    around = surroundings_of(document(scene), scene, rollout_of(scene))
    return around.sky, around.ground


def test_without_a_dressing_there_is_a_checkerboard_under_a_plain_sky() -> None:
    scene = scene_of(ground(), body("ball", (0.2, 0.2, 0.2)))
    rollout = rollout_of(scene, {"ball_1": straight(3.0)})
    around = surroundings_of(document(scene), scene, rollout)
    assert around.sky.kind == "plain"
    (tiles,) = around.parts
    assert tiles.name == "ground/tiles"
    assert float(np.abs(tiles.vertices[:, 2]).max()) == 0.0
    assert float(tiles.vertices[:, 0].max()) > 3.0


@pytest.mark.parametrize("number", range(3))
def test_a_room_is_open_towards_whoever_looks_in(number: int) -> None:
    """From outside one wall is gone and three stand; from inside all four do."""
    floor = body("floor", (20.0, 20.0, 0.01), flat=True)
    scene = scene_of(floor, body("cup", (0.1, 0.1, 0.1)))
    rollout = rollout_of(scene, {"cup_1": straight(1.0)})
    doc = document(scene, "A cup moves in the kitchen.", setting="indoor", environment="kitchen")
    doc = dress(doc, scene, rollout, seed=number)
    around = surroundings_of(doc, scene, rollout)
    points = np.array([[0.0, 0.0, 0.1], [1.0, 0.0, 0.1]])

    def walls(eye: tuple[float, float, float]) -> int:
        seen = around.seen_from([Camera(eye, (0.5, 0.0, 0.1))], points)
        return len({thing_of(p) for p in seen.parts if "room_wall" in p.name})

    assert walls((0.5, 2.0, 1.5)) == 4
    assert walls((0.5, 30.0, 1.5)) == 3
    assert walls((0.5, -30.0, 1.5)) == 3


def test_the_ground_of_a_place_takes_the_place_of_a_floor_and_of_a_road_in_it() -> None:
    floor = body("floor", (20.0, 20.0, 0.01), flat=True)
    yard = body("road", (60.0, 50.0, 0.01), flat=True, mentioned=False)
    scene = scene_of(floor, yard, body("box", (0.5, 0.4, 0.4)))
    rollout = rollout_of(scene)
    doc = document(
        scene, "A box falls in the warehouse.", setting="indoor", environment="warehouse"
    )
    plain = {scene.bodies[p.body].category for p in body_parts(scene, doc)}
    assert "floor" in plain and "box" in plain
    dressed = dress(doc, scene, rollout)
    assert {scene.bodies[p.body].category for p in body_parts(scene, dressed)} == {"box"}
    flat = [p for p in scene_parts(scene, rollout, dressed) if p.body < 0]
    assert {thing_of(p) for p in flat} == {"ground"}


def test_what_stands_at_a_wall_goes_with_it() -> None:
    """A radiator floated in front of the camera whose wall had been left out."""
    scene = scene_of(body("cup", (0.1, 0.1, 0.1)))
    rollout = rollout_of(scene, {"cup_1": straight(1.0)})
    doc = document(scene, "A cup moves in the office.", setting="indoor", environment="office")
    doc = dress(doc, scene, rollout)
    assert doc.dressing is not None
    around = surroundings_of(doc, scene, rollout)
    points = np.array([[0.5, 0.0, 0.1]])
    walls = [i for i in doc.dressing.items if i.kind.startswith("room_wall")]
    at = [i for i in doc.dressing.items if i.wall is not None]
    assert len(at) >= 4 and {i.wall for i in at} <= {w.id for w in walls}
    for wall in walls:
        eye = 30.0 * np.array(wall.position_cm) / np.linalg.norm(wall.position_cm) + (0, 0, 1.5)
        camera = Camera((eye[0], eye[1], eye[2]), (0.0, 0.0, 0.1))
        seen = {p.name for p in around.seen_from([camera], points).parts}
        assert not any(f"{i.id}_" in name for name in seen for i in at if i.wall == wall.id)
        others = [i for i in at if i.wall != wall.id]
        assert others and all(any(f"{i.id}_" in name for name in seen) for i in others)


def test_what_fills_the_edge_of_a_picture_from_nearby_is_left_out() -> None:
    """A corner of a house that no line of sight to the action meets, and one behind the action."""
    camera = Camera((8.0, 0.0, 1.5), (0.0, 0.0, 0.5))
    corner = wall("corner", 4.0)
    beside = Part(
        -1, corner.vertices + np.array([0.0, 3.4, 0.0]), corner.faces, (1, 1, 1), name="corner/x"
    )
    assert not in_the_way((beside,), np.array([camera.eye]), ACTION)
    assert before_the_picture((beside,), [camera]) == {"corner"}
    assert not before_the_picture((wall("behind", -2.0),), [camera])
    outside = Part(
        -1, corner.vertices + np.array([0.0, 9.0, 0.0]), corner.faces, (1, 1, 1), name="out/x"
    )
    assert not before_the_picture((outside,), [camera])


def test_a_fence_of_wires_hides_as_the_plane_it_lies_in() -> None:
    camera = Camera((8.0, 0.0, 1.5), (0.0, 0.0, 0.5))
    wires = [[[4.0, y, 0.0], [4.0, y + 0.002, 0.0], [4.0, y, 3.0]] for y in np.linspace(-2, 2, 9)]
    corners = np.array(wires).reshape(-1, 3)
    fence = Part(-1, corners, np.arange(27).reshape(-1, 3), (1, 1, 1), name="fence/wire")
    assert not in_the_way((fence,), np.array([camera.eye]), ACTION + np.array([0.0, 0.25, 0.0]))
    assert before_the_picture((fence,), [camera]) == {"fence"}
