"""Ground truth against geometry one can do on paper: planes, boxes, known motions."""

from __future__ import annotations

from dataclasses import replace
import io
import json
import math
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from PIL import Image
import pytest
import trimesh

from esg.assets.looks import Look
from esg.outcomes import UserError
from esg.view import capture as capturing
from esg.view import png16, truth
from esg.view.camera import Camera
from esg.view.capture import capture, decode_flow
from esg.view.containers import read_capture
from esg.view.pieces import Part
from esg.view.seeing import codes
from esg.view.seeing.wanted import CHANNELS, Settings, parse_channels, parse_size
from esg.view.surroundings import Sky, Surroundings
from esg.view.truth import Pinhole
from esg.view.truth_sheet import truth_sheet
from esg.view.worlds import GROUND, NOTHING, WorldRenderer
from tests.report.folders import rollout, scene

SIZE = (120, 90)
BOX = trimesh.creation.box((1.0, 1.0, 1.0))
PLANE = (np.array([[-50, -50, 0], [50, -50, 0], [50, 50, 0], [-50, 50, 0.0]]),
         np.array([[0, 1, 2], [0, 2, 3]]))  # fmt: skip
PARTS = [
    Part(0, np.asarray(BOX.vertices), np.asarray(BOX.faces), (0.9, 0.1, 0.1)),
    Part(-1, *PLANE, (0.4, 0.5, 0.4)),
]
UPRIGHT = np.array([0.0, 0.0, 0.0, 1.0])
FRONT = Camera((0.0, -6.0, 2.0), (0.0, 0.0, 2.0))
"""Looks along +Y, level, at a height of 2 m."""
FOCAL = 0.5 * SIZE[1] / math.tan(FRONT.fov / 2)


@pytest.fixture(scope="module")
def renderer() -> WorldRenderer:
    """Two worlds with one box each over a common ground."""
    return WorldRenderer(PARTS, 1, 2, SIZE)


def see(renderer: WorldRenderer, first: Any, second: Any, camera: Camera = FRONT) -> Any:
    renderer.pose(np.array([[first], [second]], float), np.tile(UPRIGHT, (2, 1, 1)))
    renderer.draw([camera, camera])
    return renderer.read()


def pixel_centres() -> tuple[Any, Any]:
    return np.meshgrid(np.arange(SIZE[0]) + 0.5, np.arange(SIZE[1]) + 0.5)


def test_depth_of_a_known_plane(renderer: WorldRenderer) -> None:
    """Of a level camera at height h, row v sees the ground at depth f h / (v - c)."""
    views = see(renderer, (0.0, -90.0, 2.0), (0.0, -90.0, 2.0))
    _, y = pixel_centres()
    below = y - SIZE[1] / 2
    expected = FOCAL * 2.0 / np.where(below > 0, below, np.inf)
    ground = (below > 0) & (expected < 40)
    assert ground.sum() > 3000
    assert np.abs(views.depth[0] - expected)[ground].max() < 1e-3
    assert (views.body[0][ground] == GROUND).all()
    sky = below < 0
    assert (views.depth[0][sky] == 0).all()
    assert (views.body[0][sky] == NOTHING).all()


def test_mask_depth_and_normal_of_a_known_box(renderer: WorldRenderer) -> None:
    """Its front face, 5.5 m away, covers exactly the pixels whose centres lie in a rectangle."""
    views = see(renderer, (0.3, 0.0, 2.1), (40.0, 0.0, 2.0))
    x, y = pixel_centres()
    depth = 5.5
    left, right = (SIZE[0] / 2 + FOCAL * s / depth for s in (-0.2, 0.8))
    top, bottom = (SIZE[1] / 2 - FOCAL * s / depth for s in (0.6, -0.4))
    inside = (x > left) & (x < right) & (y > top) & (y < bottom)
    mask = views.body[0] == 0
    assert (mask == inside).all()
    assert np.abs(views.depth[0][mask] - depth).max() < 1e-4
    assert np.allclose(views.normal[0][mask], [0, -1, 0], atol=1e-5)
    assert not (views.body[1] == 0).any()
    (box,) = truth.boxes_2d(views.body[0])
    columns, rows = np.nonzero(inside.any(axis=0))[0], np.nonzero(inside.any(axis=1))[0]
    assert box["box_px"] == [columns[0], rows[0], columns[-1] + 1, rows[-1] + 1]
    assert box["visible_px"] == inside.sum()


def test_worlds_of_a_batch_do_not_see_each_other(renderer: WorldRenderer) -> None:
    """Each view is that of its own world, the same as drawn with another neighbour."""
    both = see(renderer, (0.0, 0.0, 2.0), (1.0, 2.0, 1.0))
    swapped = see(renderer, (1.0, 2.0, 1.0), (0.0, 0.0, 2.0))
    for name in ("rgb", "depth", "normal", "body"):
        a, b = getattr(both, name).astype(float), getattr(swapped, name).astype(float)
        slack = 1.0 if name == "rgb" else 1e-5
        assert np.allclose(a[0], b[1], atol=slack), name
        assert np.allclose(a[1], b[0], atol=slack), name
        assert np.abs(a[0] - a[1]).max() > 0.5, name


def test_flow_of_a_known_shift(renderer: WorldRenderer) -> None:
    """A box that goes 0.2 m to the right and 0.1 m up at 5.5 m shifts by f d / z, all of it."""
    views = see(renderer, (0.0, 0.0, 2.0), (0.2, 0.0, 2.1))
    now = (np.array([[0.0, 0.0, 2.0]]), UPRIGHT[None])
    later = (np.array([[0.2, 0.0, 2.1]]), UPRIGHT[None])
    pinhole = Pinhole.of(FRONT, SIZE)
    shift = truth.flow(pinhole, views.depth[0], views.body[0], now, later)
    mask = views.body[0] == 0
    assert np.allclose(shift[mask], [FOCAL * 0.2 / 5.5, -FOCAL * 0.1 / 5.5], atol=2e-3)
    assert (shift[~mask] == 0).all()


def test_flow_of_a_known_turn_and_approach() -> None:
    """A point seen at a pixel lands where its turned and moved place projects."""
    camera = Pinhole.of(Camera((3.0, -5.0, 2.5), (0.2, 0.1, 0.9)), SIZE)
    half = math.radians(20) / 2
    turned = np.array([0.0, 0.0, math.sin(half), math.cos(half)])
    depth = np.full(SIZE[::-1], 5.0)
    body = np.zeros(SIZE[::-1], np.int32)
    origin = np.array([[0.2, 0.1, 0.9]])
    now, later = (origin, UPRIGHT[None]), (origin + np.array([0.3, -0.2, 0.1]), turned[None])
    shift = truth.flow(camera, depth, body, now, later)
    world = camera.unproject(depth)[20, 30]
    c, s = math.cos(math.radians(20)), math.sin(math.radians(20))
    local = world - origin[0]
    moved = np.array([c * local[0] - s * local[1], s * local[0] + c * local[1], local[2]])
    after, _ = camera.project(moved + origin[0] + [0.3, -0.2, 0.1])
    assert np.allclose(shift[20, 30], after - [30.5, 20.5], atol=1e-4)


def test_projection_is_that_of_the_camera_and_back() -> None:
    """K and the extrinsics say the same as the camera; unprojecting undoes projecting."""
    camera = Camera((4.0, -3.0, 2.0), (0.5, 0.2, 0.7))
    pinhole = Pinhole.of(camera, SIZE)
    points = np.random.default_rng(0).uniform(-1, 1, (50, 3))
    pixels, depth = pinhole.project(points)
    expected, _ = camera.project(points, *SIZE)
    assert np.allclose(pixels, expected)
    assert np.allclose(np.linalg.inv(pinhole.world_to_camera)[:3, 3], camera.eye)
    assert np.isclose(np.linalg.det(pinhole.world_to_camera[:3, :3]), 1.0)
    centre = pinhole.unproject(np.full(SIZE[::-1], 3.0))[10, 20]
    back, ahead = pinhole.project(centre)
    assert np.allclose(back, [20.5, 10.5])
    assert np.isclose(ahead, 3.0)
    assert (depth > 0).all()


def test_boxes_in_space_project_to_their_corners(renderer: WorldRenderer) -> None:
    """The corners of the box in the middle: the near face is larger than the far one."""
    half, offset = np.full((1, 3), 0.5), np.array([[0.0, 0.0, -0.5]])
    position, turn = np.array([[0.0, 0.0, 2.0]]), UPRIGHT[None]
    (box,) = truth.boxes_3d(Pinhole.of(FRONT, SIZE), half, offset, position, turn)
    assert box["center_m"] == [0.0, 0.0, 2.0]
    corners = np.array(box["corners_px"])
    near, far = FOCAL * 0.5 / 5.5, FOCAL * 0.5 / 6.5
    assert np.isclose(corners[:, 0].max(), SIZE[0] / 2 + near, atol=0.01)
    assert np.isclose(sorted(np.abs(corners[:, 0] - 60))[0], far, atol=0.01)
    behind = Pinhole.of(Camera((0.0, 0.2, 2.0), (0.0, 9.0, 2.0)), SIZE)
    assert truth.boxes_3d(behind, half, offset, position, turn)[0]["corners_px"] == []


def test_tracks_know_what_hides_them(renderer: WorldRenderer) -> None:
    """Points of the front face are visible, those of the back are not, outside is not."""
    views = see(renderer, (0.0, 0.0, 2.0), (0.0, 0.0, 2.0))
    points = np.array([[0.1, -0.5, 0.2], [0.1, 0.5, 0.2], [0.0, -0.5, 90.0]])
    pixels, seen = truth.track(
        Pinhole.of(FRONT, SIZE),
        views.depth[0],
        views.body[0],
        np.zeros(3, int),
        points,
        np.array([[0.0, 0.0, 2.0]]),
        UPRIGHT[None],
    )
    assert seen.tolist() == [True, False, False]
    assert np.allclose(pixels[0], [60 + FOCAL * 0.1 / 5.5, 45 - FOCAL * 0.2 / 5.5])


def test_sampled_points_lie_on_the_surface() -> None:
    """All of them, spread over all sides by area, the same for one seed."""
    vertices, faces = np.asarray(BOX.vertices), np.asarray(BOX.faces)
    points = truth.sample_points(vertices, faces, 600, np.random.default_rng(2))
    assert np.allclose(np.abs(points).max(axis=1), 0.5)
    sides = [np.isclose(points[:, k], s).sum() for k in range(3) for s in (-0.5, 0.5)]
    assert min(sides) > 60
    again = truth.sample_points(vertices, faces, 600, np.random.default_rng(2))
    assert np.array_equal(points, again)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
@pytest.mark.parametrize("shape", [(7, 5), (7, 5, 3)])
def test_png_keeps_every_bit(kind: type, shape: tuple[int, ...]) -> None:
    """Our reader gives back what was written; Pillow agrees where it can read the kind."""
    image = np.random.default_rng(3).integers(0, np.iinfo(kind).max, shape).astype(kind)
    data = png16.encode(image)
    assert np.array_equal(png16.decode(data), image)
    if kind is np.uint8 or len(shape) == 2:
        assert np.array_equal(np.asarray(Image.open(io.BytesIO(data))), image)
    with pytest.raises(ValueError, match="cannot write"):
        png16.encode(image.astype(float))


def test_encodings_say_what_their_text_says() -> None:
    """Depth is never cut off; flow and normals come back."""
    metres = np.array([[0.0, 1.2344, 65.534, 300.0, 1900.0]])
    found, offset, scale = codes.depth_codes(metres)
    assert found[0, 0] == 0 and found[0, 1:].min() >= 1
    back = np.exp(float(offset) + float(scale) * found[0, 1:].astype(float))
    assert np.abs(back / metres[0, 1:] - 1).max() < math.log(1900 / 1.2344) / 2 / 65000
    shift = np.array([[[1.25, -3.5], [600.0, 0.0], [np.nan, np.nan]]])
    back, known = decode_flow(capturing.encode_flow(shift))
    assert known.tolist() == [[True, False, False]]
    assert np.allclose(back[0, 0], [1.25, -3.5])
    normal = codes.normal_codes(np.array([[[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]]))
    assert normal.tolist() == [[[32767, 32767, 65534], [0, 0, 0]]]


@pytest.fixture
def staged(monkeypatch: pytest.MonkeyPatch) -> Any:
    """A falling ball and a box with simple meshes, instead of assets."""
    ball = trimesh.creation.icosphere(subdivisions=1, radius=0.2)
    parts = [
        Part(0, np.asarray(ball.vertices), np.asarray(ball.faces), (0.9, 0.1, 0.1)),
        Part(1, np.asarray(BOX.vertices) * [1, 1, 0.5], np.asarray(BOX.faces), (0.2, 0.3, 0.9)),
    ]
    around = Surroundings(Sky(), Look("", (0.4, 0.4, 0.4)))
    monkeypatch.setattr("esg.view.scenery.body_parts", lambda *_: parts)
    monkeypatch.setattr("esg.view.scenery.surroundings_of", lambda *_: around)
    definition = SimpleNamespace(original_description="A ball falls.")
    return SimpleNamespace(
        scene_definition=definition,
        statements=None,
        casting=None,
        spatial_relation_graph=SimpleNamespace(nodes={}),
    )


def test_both_containers_hold_the_same(tmp_path: Path, staged: Any) -> None:
    """Every channel of every frame and camera, in order, with times and cameras in the manifest."""
    settings = Settings(CHANNELS, (48, 36), fps=8.0)
    cameras = [Camera((0.0, -6.0, 1.5), (0.0, 0.0, 1.0)), Camera((5.0, 1.0, 3.0), (0, 0, 1.0))]
    found = []
    for container in ("png", "parquet"):
        chosen = replace(settings, container=container)  # type: ignore[arg-type]
        folder = capture(
            scene(), rollout(), None, staged, tmp_path / container, chosen, cameras=cameras
        )
        found.append(list(read_capture(folder)))
    assert [(r["camera"], r["frame"]) for r in found[0]] == [
        (c, f) for c in (0, 1) for f in range(9)
    ]
    for a, b in zip(*found, strict=True):
        assert a.keys() == b.keys()
        for name in a:
            if isinstance(a[name], np.ndarray):
                assert np.array_equal(a[name], b[name]), name
            else:
                assert a[name] == pytest.approx(b[name]) if name == "time_s" else a[name] == b[name]
    manifest = json.loads((tmp_path / "png" / "manifest.json").read_bytes())
    assert manifest["time_s"][:3] == [0.0, 0.125, 0.25]
    assert len(manifest["cameras"]) == 2
    drawn = manifest["renderer"]
    assert (drawn["name"], drawn["samples"], drawn["shutter_open_s"]) == ("raster", 4, 0.0)
    assert [b["id"] for b in manifest["bodies"]] == [2, 3]
    first, last = found[0][0], found[0][8]
    assert set(np.unique(first["segmentation"])) == {0, 1, 2, 3}
    assert last["flow"][..., 2].max() == 0
    shift, known = decode_flow(found[0][2]["flow"])
    assert known.all()
    ball = found[0][2]["segmentation"] == 2
    # The ball is 6 m away and falls from 0.25 s to 0.375 s.
    fall = 0.5 * 9.81 * (0.375**2 - 0.25**2)
    pixels = 0.5 * 36 / math.tan(cameras[0].fov / 2) * fall / 6.0
    assert shift[ball][:, 1].mean() == pytest.approx(pixels, rel=0.05)
    sheet = truth_sheet(tmp_path / "png", tmp_path / "sheet.png", 0.25)
    with Image.open(sheet) as picture:
        assert picture.width > 3 * 48


def test_a_capture_replaces_only_a_capture(tmp_path: Path, staged: Any) -> None:
    """The same bytes again; a folder of the user's stays."""
    settings = Settings(("rgb", "tracks"), (24, 16), fps=2.0)
    cameras = [FRONT]
    folder = capture(scene(), rollout(), None, staged, tmp_path / "c", settings, cameras=cameras)
    before = {p.name: p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    capture(scene(), rollout(), None, staged, folder, settings, cameras=cameras)
    assert {p.name: p.read_bytes() for p in folder.rglob("*") if p.is_file()} == before
    mine = tmp_path / "mine"
    mine.mkdir()
    with pytest.raises(UserError, match="holds no capture"):
        capture(scene(), rollout(), None, staged, mine, settings, cameras=cameras)
    assert list(tmp_path.glob("*.tmp")) == []


def test_options_are_checked_all_at_once() -> None:
    """Every unknown channel is named, sizes say what they take."""
    assert parse_channels("rgb, depth,rgb") == ("rgb", "depth")
    assert parse_channels("all") == CHANNELS
    with pytest.raises(UserError, match="'rbg', 'dept'"):
        parse_channels("rbg,dept,flow")
    with pytest.raises(UserError, match="no channel"):
        parse_channels(" , ")
    assert parse_size("640X480") == (640, 480)
    for text in ("640", "0x9", "axb", "99999x9", "-5x20"):
        with pytest.raises(UserError, match="256x256"):
            parse_size(text)
