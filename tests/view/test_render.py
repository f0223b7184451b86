"""Rendering: bodies are drawn where they are, and the sheet holds every panel."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image
import pytest
import trimesh

from esg.view.camera import Camera
from esg.view.render import SKY, Part, Renderer
from esg.view.sheet import CAPTION_PX, GAP, Panel, write_sheet

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
    assert tuple(image[2, 48]) == SKY
    renderer.pose(np.array([[1.5, 0, 0], [-1.5, 0, 0]]), upright)
    image = renderer.color(camera)
    assert dominant(image[y0, x0]) == 1
    assert dominant(image[y1, x1]) == 0


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
