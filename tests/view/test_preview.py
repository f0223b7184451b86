"""Framing: who is in the picture, from where, and that a whole sheet comes out."""

from __future__ import annotations

from dataclasses import replace
import math
import os
from pathlib import Path

import numpy as np
from PIL import Image
import pytest
import trimesh

from esg.assets import resolve
from esg.assets.looks import Look
from esg.draft import draft
from esg.engines.joints import joint_between
from esg.engines.scene import Body, Rollout, SimScene
from esg.graph.models import (
    EsgDocument,
    Node,
    NodeEvent,
    SceneDefinition,
    SceneParameters,
    SequenceGraph,
    SpatialRelationGraph,
    TimelineNode,
    TimelineSystem,
)
from esg.metrics.models import EventVerdict, LayoutVerdict, SceneVerdict
from esg.units import quat_rotate
from esg.view import preview as previews
from esg.view.camera import Camera, box_corners
from esg.view.cameras import action_cameras
from esg.view.film.encoding import NoFilmError
from esg.view.framing import (
    camera_for,
    camera_of_moment,
    corners_of,
    frame_at,
    points_in_view,
    pose,
    told_side,
    viewpoint,
)
from esg.view.moments import as_seen, failures, moments_of
from esg.view.pieces import Movers, Part
from esg.view.render import Renderer
from esg.view.ropes import rope_parts, ropes_at
from esg.view.sheet import draw_ropes, draw_trail
from esg.view.surroundings import Sky, Surroundings
from tests.report.folders import HIT_S, rollout, scene

DOC = EsgDocument(
    scene_definition=SceneDefinition(
        scene_id="drop",
        original_description="A red ball falls onto a box.",
        scene_parameters=SceneParameters(is_dynamic=True, scene_type="indoor"),
    ),
    spatial_relation_graph=SpatialRelationGraph(
        nodes={n: Node(asset_id=f"{n}_a") for n in ("ball_1", "box_1")}
    ),
)
EVENT = EventVerdict(
    id="e1",
    type="collision",
    completed=True,
    time_s=HIT_S,
    bodies=("ball_1", "box_1"),
    measured={"impulse_ns": 4.9, "depth_m": 0.0},
)


def verdict(*events: EventVerdict) -> SceneVerdict:
    """A verdict about these events."""
    return SceneVerdict(
        scene_id="drop",
        suite_scene="drop",
        engine="physx",
        dt_s=1 / 240,
        events=events,
        constraints=(),
        layout=LayoutVerdict(valid=True),
    )


@pytest.mark.parametrize("count", [1, 3, 8])
@pytest.mark.parametrize("aspect", [1.0, 1.5, 0.6])
def test_fixed_cameras_keep_the_action_in_view(count: int, aspect: float) -> None:
    """Both bodies, at every instant around the hit, from every camera; none from below."""
    cameras = action_cameras(scene(), rollout(), verdict(EVENT), DOC, count, aspect)
    assert len(cameras) == count
    size = (round(600 * aspect), 600)
    motion = rollout()
    for camera in cameras:
        assert camera.eye[2] > 0.3
        for time in np.linspace(0.0, HIT_S + 0.3, 9):
            frame = int(np.argmin(np.abs(motion.time - time)))
            for k, body in enumerate(scene().bodies):
                corners = box_corners(
                    motion.position[0, frame, k],
                    motion.quaternion[0, frame, k],
                    body.half_extents,
                    np.asarray(body.origin_offset),
                )
                pixels, ahead = camera.project(corners, *size)
                assert ahead.all()
                assert (pixels > -0.5).all()
                assert (pixels < np.array(size) + 0.5).all()


def test_cameras_stand_at_different_places() -> None:
    """Eight cameras, eight views."""
    cameras = action_cameras(scene(), rollout(), verdict(EVENT), DOC, 8, 1.0)
    eyes = np.array([c.eye for c in cameras])
    apart = np.linalg.norm(eyes[:, None] - eyes[None], axis=-1) + 9 * np.eye(8)
    assert apart.min() > 0.5


def test_moments_are_before_every_event_and_after() -> None:
    """Captions give time and what was measured; zeros say nothing."""
    found = moments_of(scene(), rollout(), verdict(EVENT), DOC)
    assert [m.title for m in found] == ["start", "1  collision: red ball x box", "after"]
    assert found[1].caption == "t = 0.50 s   impulse 4.9 N s"
    assert found[2].time == 1.0


def test_a_single_body_keeps_room_around_it() -> None:
    """It takes no more than half of the picture's height."""
    alone = EVENT.model_copy(update={"type": "moves", "bodies": ("ball_1",), "time_s": 0.1})
    far = scene()
    far = far.with_bodies((far.bodies[0], replace(far.bodies[1], mentioned=False)))
    moment = moments_of(far, rollout(), verdict(alone), DOC)[1]
    assert moment.focus == (0,)
    frame = frame_at(rollout(), moment.time)
    camera = camera_for(far, rollout(), moment, frame, 1.0, 0.4)
    pixels, _ = camera.project(corners_of(far, rollout(), frame, 0), 480, 320)
    assert np.ptp(pixels[:, 1]) < 160


def test_what_else_the_prompt_names_is_in_the_first_picture() -> None:
    """A box that takes part in no event still shows where the ball is, if it is not too far."""
    alone = EVENT.model_copy(update={"type": "moves", "bodies": ("ball_1",)})
    start = moments_of(scene(), rollout(), verdict(alone), DOC)[0]
    assert start.company == (1,)
    points = points_in_view(scene(), rollout(), start, 0)
    assert len(points) == 16
    close = points_in_view(scene(), rollout(), replace(start, reach=2.0), 0)
    assert len(close) == 8


def test_what_is_entered_is_in_the_first_picture() -> None:
    """A ball that goes into a box far away: the box is no mere company."""
    enters = EVENT.model_copy(update={"type": "enters", "bodies": ("ball_1",)})
    assert moments_of(scene(), rollout(), verdict(enters), DOC)[0].focus == (0,)
    node = TimelineNode(
        id="e1", event=NodeEvent.ENTER_REGION, participants=("ball_1",), region="box_1/inside"
    )
    timeline = TimelineSystem(sequence_graph=SequenceGraph(nodes=(node,), edges=()))
    told = DOC.model_copy(update={"timeline_system": timeline})
    found = moments_of(scene(), rollout(), verdict(enters), told)
    assert [m.focus for m in found] == [(0, 1), (0, 1), (0, 1)]


def test_specks_get_a_ring() -> None:
    """A body of a few pixels is pointed at, one that can be seen is not."""
    blank = np.full((320, 480, 3), 255, np.uint8)
    box = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    camera = Camera((10.0, 0.0, 1.0), (0.0, 0.0, 0.0))
    assert (draw_trail(blank, camera, [], [box]) == blank).all()
    ringed = draw_trail(blank, camera, [], [0.01 * box])
    assert 20 < int((ringed != blank).any(axis=2).sum()) < 800


@pytest.fixture
def simple(monkeypatch: pytest.MonkeyPatch) -> None:
    """Plain meshes instead of assets."""
    ball = trimesh.creation.icosphere(subdivisions=2, radius=0.2)
    box = trimesh.creation.box((1.0, 1.0, 0.5))
    parts = [
        Part(0, np.asarray(ball.vertices), np.asarray(ball.faces), (0.9, 0.1, 0.1)),
        Part(1, np.asarray(box.vertices), np.asarray(box.faces), (0.2, 0.3, 0.9)),
    ]
    around = Surroundings(Sky(), Look("", (0.5, 0.5, 0.5)))
    monkeypatch.setattr("esg.view.scenery.body_parts", lambda *_: parts)
    monkeypatch.setattr("esg.view.scenery.surroundings_of", lambda *_: around)
    monkeypatch.setattr(previews, "PANEL_PX", (96, 64))


@pytest.mark.usefixtures("simple")
def test_sheet_and_film_are_the_same_with_one_thread_and_two(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Which thread draws a picture makes no difference, and films are the same."""
    made = []
    for threads in (1, 2):
        monkeypatch.setattr(previews, "_threads", lambda n=threads: n)
        folder = tmp_path / str(threads)
        folder.mkdir()
        shown = (scene(), rollout(), verdict(EVENT), DOC, folder)
        previews.preview(*shown)
        assert previews.film(*shown) == []
        made.append({p.name: p.read_bytes() for p in folder.iterdir()})
    assert made[0].keys() == {"preview.png", "preview.mp4"}
    assert made[0] == made[1]
    with Image.open(tmp_path / "1" / "preview.png") as sheet:
        picture = np.asarray(sheet.convert("RGB")).astype(int)
    red = (picture[..., 0] > 1.6 * picture[..., 1]) & (picture[..., 0] > 1.6 * picture[..., 2])
    assert red.sum() > 30


def test_workers_draw_with_one_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where every core has its own scene, a scene takes one core."""
    monkeypatch.setitem(os.environ, "OMP_NUM_THREADS", "1")
    assert previews._threads() == 1
    monkeypatch.setitem(os.environ, "OMP_NUM_THREADS", "")
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0, 1, 2, 3}, raising=False)
    assert previews._threads() == 2


def test_an_event_without_bodies_is_named_by_its_id() -> None:
    """What bound to nothing has nobody to name; what failed shows the names people gave."""
    lost = EVENT.model_copy(update={"completed": False, "bodies": (), "reason": "no cone"})
    missed = EVENT.model_copy(update={"completed": False, "reason": "the pair never touches"})
    assert failures(scene(), verdict(lost, missed)) == [
        "collision (e1): not completed (no cone)",
        "collision: red ball x box: not completed (the pair never touches)",
    ]


def test_a_moment_behind_something_is_seen_from_elsewhere() -> None:
    """A wall between the common viewpoint and the bodies hides both; without it nothing changes."""
    replay = rollout()
    moment = moments_of(scene(), replay, verdict(EVENT), DOC)[1]
    frame = frame_at(replay, moment.time)
    view = (np.pi / 2, np.radians(24))
    shared = camera_for(scene(), replay, moment, frame, *view)
    bodies = [
        Part(i, m.vertices, m.faces, (0.6, 0.2, 0.2))
        for i, m in enumerate(
            trimesh.creation.box(2 * np.array(b.half_extents)) for b in scene().bodies
        )
    ]
    middle = 0.5 * (np.array(shared.eye) + np.array(shared.target))
    wall = trimesh.creation.box(
        (2.0, 0.05, 6.0), trimesh.transformations.translation_matrix(middle)
    )
    hidden = [*bodies, Part(-1, wall.vertices, wall.faces, (0.5, 0.5, 0.5))]
    for parts, stays in ((bodies, True), (hidden, False)):
        renderer = Renderer(parts, len(scene().bodies), 96, 64)
        camera = camera_of_moment(scene(), replay, moment, view, renderer)
        assert (camera == shared) is stays
        pose(renderer, replay, frame)
        seen = renderer.visible(camera, moment.focus)
        assert min(seen[i] for i in moment.focus) > 20


def test_what_flies_is_seen_from_its_height_before_the_place() -> None:
    """What is in the air at every moment is not looked down on, or the ground is all one sees."""
    played = rollout()
    high = replace(played, position=played.position + np.array([0.0, 0.0, 5.0]))
    boxes = [trimesh.creation.box(2 * np.array(b.half_extents)) for b in scene().bodies]
    parts = [Part(i, m.vertices, m.faces, (0.6, 0.2, 0.2)) for i, m in enumerate(boxes)]
    elevations: list[float] = []
    for replay in (played, high):
        moments = moments_of(scene(), replay, verdict(EVENT), DOC)
        renderer = Renderer(parts, len(scene().bodies), 96, 64)
        elevations.append(np.degrees(viewpoint(scene(), replay, moments, renderer)[1]))
    assert elevations == pytest.approx([24.0, 6.0])


def hung() -> tuple[SimScene, Rollout]:
    """Two bodies of the usual scene on a rope of the length that is between them at the start."""
    base = scene()
    mover = next(b for b in base.bodies if not b.static)
    other = next(b for b in base.bodies if b.name != mover.name)
    rope = joint_between("rope", "rope", mover, other, at=mover.position, parent_at=other.position)
    apart = float(np.linalg.norm(np.subtract(mover.position, other.position)))
    return replace(base, joints=(replace(rope, upper=apart),)), rollout()


def test_ropes_are_drawn_between_their_ends_while_they_hold():
    jointed, played = hung()
    (ends,) = ropes_at(jointed, played, 0)
    rope = jointed.joints[0]
    assert ends[1] == pytest.approx(played.position[0, 0, jointed.index(rope.child)], abs=1e-5)
    assert ends[0] == pytest.approx(played.position[0, 0, jointed.index(rope.parent)], abs=1e-5)
    torn = replace(jointed, joints=(replace(rope, upper=0.5 * (rope.upper or 0.0)),))
    assert ropes_at(torn, played, 0) == []
    assert ropes_at(scene(), played, 0) == []


def test_pieces_of_a_rope_reach_from_end_to_end_and_are_seen():
    """Of a rope that hangs through, too; what has broken lies below the ground."""
    jointed, played = hung()
    rope = jointed.joints[0]
    parts = rope_parts(jointed, played)
    movers = Movers(parts, len(jointed.bodies))
    at, turn = movers.poses(played.position[0, 0], played.quaternion[0, 0])
    (ends,) = ropes_at(jointed, played, 0)
    seen = [quat_rotate(turn[movers.of(p)], p.vertices) + at[movers.of(p)] for p in parts]
    along = np.concatenate(seen) @ (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0]) ** 2
    start = ends[0] @ (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0]) ** 2
    assert along.min() - start == pytest.approx(0.0, abs=0.01)
    assert along.max() - start == pytest.approx(1.0, abs=0.01)
    assert {movers.bodies[movers.of(p)] for p in parts} == {-1}

    middle, across = ends.mean(axis=0), np.array([0.0, -0.4, 0.0])
    camera = Camera(tuple(middle + across), tuple(middle))
    renderer = Renderer(parts, len(jointed.bodies), 64, 64)
    renderer.pose(played.position[0, 0], played.quaternion[0, 0])
    whole = renderer.color(camera)
    torn = replace(jointed, joints=(replace(rope, upper=0.5 * (rope.upper or 0.0)),))
    parts = [
        replace(p, strand=q.strand) for p, q in zip(parts, rope_parts(torn, played), strict=True)
    ]
    renderer = Renderer(parts, len(jointed.bodies), 64, 64)
    renderer.pose(played.position[0, 0], played.quaternion[0, 0])
    assert np.abs(whole.astype(int) - renderer.color(camera)).max() > 60
    assert rope_parts(scene(), rollout()) == []


def test_a_rope_darkens_the_picture_along_its_line_only():
    blank = np.full((80, 120, 3), 200, np.uint8)
    camera = Camera((0.0, -5.0, 1.0), (0.0, 0.0, 1.0))
    assert draw_ropes(blank, camera, []) is blank
    drawn = draw_ropes(blank, camera, [np.array([[0.0, 0.0, 0.5], [0.0, 0.0, 1.5]])])
    dark = np.argwhere((drawn < 150).any(axis=2))
    assert 5 < len(dark) < 120
    assert np.ptp(dark[:, 1]) <= 3


@pytest.mark.usefixtures("simple")
def test_a_scene_is_recorded_without_its_film(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A film that cannot be written costs the film, not the sheet, which says why."""

    def refuse(*_: object) -> None:
        raise NoFilmError("no space left")

    notes: list[list[str]] = []
    real = previews.write_sheet

    def sheet(*args: object, **more: object) -> object:
        notes.append(list(more["footnotes"]))  # type: ignore[call-overload]
        return real(*args, **more)  # type: ignore[arg-type]

    monkeypatch.setattr(previews, "write_scene_film", refuse)
    monkeypatch.setattr(previews, "write_sheet", sheet)
    shown = (scene(), rollout(), verdict(EVENT), DOC, tmp_path)
    previews.preview(*shown, lost=lambda: previews.film(*shown))
    assert [p.name for p in tmp_path.iterdir()] == ["preview.png"]
    assert notes == [["no film: no space left"]]


def test_a_motion_is_shown_under_way() -> None:
    """Half of what it lasts after its beginning."""
    moves = EVENT.model_copy(update={
        "type": "moves", "bodies": ("ball_1",), "time_s": 0.0, "measured": {"for_s": 1.2},
    })  # fmt: skip
    assert [m.time for m in moments_of(scene(), rollout(), verdict(moves), DOC)] == [0.0, 0.6, 1.0]


def test_a_jump_is_shown_at_its_height() -> None:
    """Half way up and down again: sqrt(2 h / g) after it has begun."""
    rise = 0.5 * 9.81 * 0.25**2
    jump = EVENT.model_copy(update={
        "type": "jumps", "bodies": ("ball_1",), "time_s": 0.1, "measured": {"rise_m": rise},
    })  # fmt: skip
    shown = moments_of(scene(), rollout(), verdict(jump), DOC)[1]
    assert shown.time == pytest.approx(0.35)


def test_who_is_fixed_to_a_participant_is_in_its_picture() -> None:
    played = scene()
    seat = joint_between("seat", "fixed", *played.bodies[:2], at=played.bodies[0].position)
    joined = SimScene(played.scene_id, played.bodies, joints=(seat,))
    alone = EVENT.model_copy(update={"bodies": ("ball_1",)})
    assert moments_of(played, rollout(), verdict(alone), DOC)[1].focus == (0,)
    assert moments_of(joined, rollout(), verdict(alone), DOC)[1].focus == (0, 1)


def test_what_is_very_large_is_shown_where_it_is_met() -> None:
    """Of a wall 90 m long the part around the ball, not all of it."""
    ball, box = scene().bodies
    wide = SimScene("s", (ball, replace(box, half_extents=(45.0, 0.5, 0.25))))
    (hit,) = moments_of(wide, rollout(), verdict(EVENT), DOC)[1:2]
    frame = frame_at(rollout(), hit.time)
    points = points_in_view(wide, rollout(), hit, frame)
    assert float(np.ptp(points, axis=0).max()) < 26.0
    whole = points_in_view(wide, rollout(), replace(hit, at_hand=0.0), frame)
    assert float(np.ptp(whole, axis=0).max()) >= 90.0


def test_boxes_reach_as_far_as_what_is_drawn() -> None:
    """Up to the head of who is drawn on a motorcycle; of who sits, no farther than his own."""
    doc = resolve(draft("A motorcycle drives down the road past a man on a horse."))
    bodies = tuple(
        replace(ball_of(name), half_extents=(1.0, 0.4, 0.56 if name == "motorcycle_1" else 0.86))
        for name in ("motorcycle_1", "man_1", "horse_1")
    )
    seen = as_seen(SimScene("s", bodies), doc)
    heights = {b.name: round(2.0 * b.half_extents[2], 2) for b in seen.bodies}
    assert heights == {"motorcycle_1": 1.85, "man_1": 0.93, "horse_1": 1.72}


def ball_of(name: str) -> Body:
    return replace(scene().bodies[0], name=name)


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("A dog runs toward the camera.", True),
        ("A ball rolls to the left.", True),
        ("A vase stands to the right of a laptop.", True),
        ("A dog runs.", False),
        ("A ball hits a box.", False),
    ],
)
def test_left_and_front_are_seen_from_where_the_viewer_stands(prompt: str, told: bool) -> None:
    """He stands at +Y; of other scenes the side of the motion is as good."""
    assert told_side(draft(prompt)) == (pytest.approx(math.pi / 2) if told else None)
