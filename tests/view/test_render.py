"""Rendering: bodies are drawn where they are, and the sheet holds every panel."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image
import pytest
import trimesh

from esg.view.camera import Camera
from esg.view.maps import encoded
from esg.view.pieces import Movers, Part
from esg.view.render import Renderer
from esg.view.sheet import CAPTION_PX, GAP, Panel, panel_boxes, write_sheet
from esg.view.surroundings import Sky
from esg.view.tracer.stage import bundles

BOX = trimesh.creation.box((1.0, 1.0, 1.0))
RED, GREEN = (0.9, 0.05, 0.05), (0.05, 0.9, 0.05)


@pytest.fixture(scope="module")
def renderer() -> Renderer:
    parts = [
        Part(k, np.asarray(BOX.vertices), np.asarray(BOX.faces), color)
        for k, color in enumerate((RED, GREEN))
    ]
    return Renderer(parts, 2, 96, 64)


def dominant(pixel: np.ndarray) -> int:
    return int(np.argmax(pixel))


def test_bodies_follow_their_poses(renderer: Renderer) -> None:
    camera = Camera((0.0, -8.0, 0.0), (0.0, 0.0, 0.0))
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
    renderer.pose(np.array([[-1.5, 0, 0], [1.5, 0, 0]]), upright)
    image = renderer.color(camera)
    pixels, _ = camera.project(np.array([[-1.5, -0.5, 0], [1.5, -0.5, 0]]), 96, 64)
    (x0, y0), (x1, y1) = pixels.round().astype(int)
    assert dominant(image[y0, x0]) == 0
    assert dominant(image[y1, x1]) == 1
    assert tuple(image[2, 48]) == tuple(encoded(Sky().zenith))
    renderer.pose(np.array([[1.5, 0, 0], [-1.5, 0, 0]]), upright)
    image = renderer.color(camera)
    assert dominant(image[y0, x0]) == 1
    assert dominant(image[y1, x1]) == 0


def test_a_twin_draws_the_same_scene_in_poses_of_its_own(renderer: Renderer) -> None:
    camera = Camera((0.0, -8.0, 0.0), (0.0, 0.0, 0.0))
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
    places = [np.array([[-x, 0, 0], [x, 0, 0]]) for x in (1.5, -1.5)]
    other = renderer.twin()
    for first, second in ((renderer, other), (other, renderer)):
        first.pose(places[0], upright)
        second.pose(places[1], upright)
        images = [first.color(camera), second.color(camera)]
        assert not np.array_equal(*images)
        first.pose(places[1], upright)
        assert np.array_equal(first.color(camera), images[1])


def test_visible_counts_what_is_not_hidden(renderer: Renderer) -> None:
    camera = Camera((0.0, -8.0, 0.0), (0.0, 0.0, 0.0))
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (2, 1))
    renderer.pose(np.array([[0.0, -2, 0], [0.0, 2, 0]]), upright)
    seen = renderer.visible(camera, (0, 1))
    assert seen[0] > 50
    assert seen[1] == 0


def test_sheet_has_room_for_all_panels(tmp_path: Path) -> None:
    image = np.full((40, 400, 3), 128, np.uint8)
    panels = [Panel(image, f"panel {k} " + "long " * 60, "") for k in range(5)]
    path = write_sheet(tmp_path / "p.png", panels, title="<script>" + " word" * 300, note="n")
    with Image.open(path) as sheet:
        assert sheet.width == 3 * 400 + 4 * GAP
        assert sheet.height > 2 * (40 + CAPTION_PX)


def test_parts_of_a_body_are_one_mesh() -> None:
    """Pieces of one body are one mesh whose faces count their looks; other bodies stay apart."""
    vertices, faces = np.asarray(BOX.vertices), np.asarray(BOX.faces)
    pieces = [
        Part(0, vertices + np.array([dx, 0, 0]), faces, color)
        for dx, color in ((-2.0, RED), (0.0, GREEN), (2.0, RED))
    ]
    made, looks = bundles([*pieces, Part(1, vertices, faces, RED)], Movers(pieces, 2))
    assert [(b.mover, b.clear, len(b.faces)) for b in made] == [(0, False, 36), (1, False, 12)]
    assert [look.color for look in looks] == [RED, GREEN]
    assert made[0].materials.tolist() == [0] * 12 + [1] * 12 + [0] * 12
    assert np.allclose(made[0].vertices[16:], vertices + np.array([2.0, 0, 0]))
    assert made[0].faces[24:].min() == 16


def test_the_sun_stands_behind_the_viewer() -> None:
    """The side one looks at is bright from every side; the sun's side throws no shadow on it."""
    parts = [Part(0, np.asarray(BOX.vertices), np.asarray(BOX.faces), (0.6, 0.6, 0.6))]
    renderer = Renderer(parts, 1, 48, 32)
    renderer.pose(np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]]))
    seen = []
    for azimuth in np.radians([0, 90, 180, 270]):
        renderer.light(azimuth)
        camera = Camera((6 * np.cos(azimuth), 6 * np.sin(azimuth), 0.0), (0.0, 0.0, 0.0))
        seen.append(float(renderer.color(camera)[16, 24].mean()))
    assert np.ptp(seen) < 3
    renderer.light(np.pi)
    assert renderer.color(Camera((6.0, 0.0, 0.0), (0.0, 0.0, 0.0)))[16, 24].mean() < seen[0] - 30


def test_panels_of_a_sheet_are_found_again(tmp_path: Path) -> None:
    """Cropping a box gives the panel's picture; other pictures have none."""
    panels = [Panel(np.full((40, 400, 3), 50 * k, np.uint8), "t", "c") for k in range(1, 5)]
    path = write_sheet(tmp_path / "p.png", panels, title="t")
    with Image.open(path) as sheet:
        boxes = panel_boxes(sheet)
        assert len(boxes) == 4
        for k, box in enumerate(boxes, 1):
            assert (np.asarray(sheet.crop(box)) == 50 * k).all()
    assert panel_boxes(Image.new("RGB", (9, 9))) == []
