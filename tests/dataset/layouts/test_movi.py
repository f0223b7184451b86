"""MOVi's fields, checked against what Kubric says of them and its own formulas."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from esg.dataset.layouts.movi import fields
from esg.dataset.layouts.source import Source
from tests.dataset.layouts.sets import FRAMES, SIZE

WIDTH, HEIGHT = SIZE

SHAPES = {  # challenges/movi/movi_e.py of Kubric; s frames, k instances, c collisions
    "video": ("uint8", "s h w 3"), "segmentations": ("uint8", "s h w 1"),
    "depth": ("uint16", "s h w 1"), "forward_flow": ("uint16", "s h w 2"),
    "backward_flow": ("uint16", "s h w 2"), "normal": ("uint16", "s h w 3"),
    "object_coordinates": ("uint16", "s h w 3"),
    "metadata/depth_range": ("float32", "2"), "metadata/forward_flow_range": ("float32", "2"),
    "metadata/backward_flow_range": ("float32", "2"), "metadata/width": ("int32", ""),
    "metadata/height": ("int32", ""), "metadata/num_frames": ("int32", ""),
    "metadata/num_instances": ("uint16", ""),
    "camera/focal_length": ("float32", ""), "camera/sensor_width": ("float32", ""),
    "camera/field_of_view": ("float32", ""), "camera/positions": ("float32", "s 3"),
    "camera/quaternions": ("float32", "s 4"),
    "instances/mass": ("float32", "k"), "instances/friction": ("float32", "k"),
    "instances/restitution": ("float32", "k"), "instances/positions": ("float32", "k s 3"),
    "instances/quaternions": ("float32", "k s 4"), "instances/velocities": ("float32", "k s 3"),
    "instances/angular_velocities": ("float32", "k s 3"),
    "instances/bboxes_3d": ("float32", "k s 8 3"),
    "instances/image_positions": ("float32", "k s 2"),
    "instances/visibility": ("uint16", "k s"), "instances/is_dynamic": ("bool", "k"),
    "events/collisions/instances": ("uint16", "c 2"), "events/collisions/frame": ("int32", "c"),
    "events/collisions/force": ("float32", "c"), "events/collisions/position": ("float32", "c 3"),
    "events/collisions/image_position": ("float32", "c 2"),
    "events/collisions/contact_normal": ("float32", "c 3"),
}  # fmt: skip


@pytest.fixture
def first(whole: Path) -> dict[str, np.ndarray]:
    path = whole / "layouts" / "movi" / "train" / "0000000_camera_0.npz"
    with np.load(path, allow_pickle=False) as archive:
        return dict(archive)


@pytest.fixture
def sample(whole: Path):
    return next(Source(whole).samples("train", ("trajectories",)))


def test_fields_have_movis_names_types_and_shapes(first):
    collisions = len(first["events/collisions/frame"])
    size = {"s": FRAMES, "h": HEIGHT, "w": WIDTH, "k": 3, "c": collisions}
    for name, (kind, shape) in SHAPES.items():
        array = first[name]
        assert str(array.dtype) == kind, name
        assert array.shape == tuple(size[n] if n in size else int(n) for n in shape.split()), name


def test_every_clip_has_an_archive_in_its_split(whole):
    folder = whole / "layouts" / "movi"
    counts = {s: len(list((folder / s).glob("*.npz"))) for s in ("train", "validation", "test")}
    assert counts == {"train": 6, "validation": 2, "test": 2}
    assert json.loads((folder / "layout.json").read_text())["splits"] == counts


def test_ranges_give_the_values_back(first, sample):
    """MOVi: code / 65535 * (max - min) + min; flow is (row, column)."""

    def meant(name: str) -> np.ndarray:
        low, high = first[f"metadata/{name}_range"].astype(float)
        return first[name] / 65535 * (high - low) + low

    for name, channel in (("forward_flow", "flow"), ("backward_flow", "backward_flow")):
        own = np.nan_to_num(sample.clip.frames(channel))
        step = float(np.ptp(first[f"metadata/{name}_range"])) / 65535
        assert meant(name)[..., 0] == pytest.approx(own[..., 1], abs=step)
        assert meant(name)[..., 1] == pytest.approx(own[..., 0], abs=step)
    k, own = sample.clip.record.intrinsics, sample.clip.frames("depth")
    row, column = 10, 7
    ray = np.hypot(1.0, np.hypot((column + 0.5 - k.cx) / k.fx, (row + 0.5 - k.cy) / k.fy))
    step = float(np.ptp(first["metadata/depth_range"])) / 65535
    assert meant("depth")[:, row, column, 0] == pytest.approx(own[:, row, column] * ray, abs=step)


def test_instances_are_bodies_and_the_ground_is_none(first, sample):
    ids = sample.clip.frames("segmentation")
    assert np.array_equal(first["segmentations"][..., 0] == 1, ids == 2)
    assert not first["segmentations"][ids < 2].any()
    assert list(first["instances/name"]) == ["ball_1", "ball_2", "ball_3"]
    assert first["instances/bbox_frames"][0].tolist() == list(range(FRAMES))
    assert first["instances/bboxes"][0, 1] == pytest.approx([8 / 24, 6 / 32, 16 / 24, 14 / 32])
    assert (first["instances/bbox_frames"][1:] == -1).all()
    assert first["instances/visibility"].tolist() == [[64] * FRAMES, [0] * FRAMES, [0] * FRAMES]


def kubric_projects(first, point: np.ndarray, frame: int) -> np.ndarray:
    """`Camera.project_point` of Kubric: its quaternions, its camera axes, its intrinsics."""
    w, x, y, z = first["camera/quaternions"][frame].astype(float)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    local = turn.T @ (point - first["camera/positions"][frame])
    sensor = float(first["camera/sensor_width"])
    fx = float(first["camera/focal_length"]) / sensor
    fy = float(first["camera/focal_length"]) / (sensor / WIDTH * HEIGHT)
    projected = np.array([[fx, 0, -0.5], [0, -fy, -0.5], [0, 0, -1]]) @ local
    return projected[:2] / projected[2]


def test_kubrics_camera_sees_bodies_where_they_are_said_to_be(first):
    for k in range(3):
        for frame in (0, FRAMES - 1):
            place = first["instances/positions"][k, frame].astype(float)
            seen = kubric_projects(first, place, frame)
            assert first["instances/image_positions"][k, frame] == pytest.approx(seen, abs=1e-4)


def test_boxes_surround_bodies(first):
    corners, center = first["instances/bboxes_3d"], first["instances/positions"]
    assert corners.mean(axis=2) == pytest.approx(center, abs=1e-5)
    assert np.ptp(corners, axis=2) == pytest.approx(np.full((3, FRAMES, 3), 0.2), abs=1e-5)


def test_collisions_while_the_camera_films(whole, sample):
    """The clip ends before the balls hit; a longer one has both hits."""
    from dataclasses import replace

    record = sample.clip.record
    later = replace(
        record, time_s=(0.37 + np.arange(FRAMES) / 10.0).astype(np.float32), fps=10.0,
    )  # fmt: skip
    found = fields(replace(sample, clip=replace(sample.clip, record=later)))
    assert found["events/collisions/instances"].tolist() == [[0, 1], [1, 2]]
    assert found["events/collisions/frame"].tolist() == [0, 4]
    assert found["events/collisions/force"] == pytest.approx([240.0, 240.0], rel=1e-3)
    row = dict(sample.more["trajectories"][0])
    row |= {
        "contact_point_m": [1.0, 0.0, 3.0, 2.0, 0.0, 3.0],
        "contact_normal": [0.0, 0.0, 1.0] * 2,
    }
    told = replace(sample, clip=replace(sample.clip, record=later), more={"trajectories": [row]})
    found = fields(told)
    assert found["events/collisions/position"].tolist() == [[1.0, 0.0, 3.0], [2.0, 0.0, 3.0]]
    assert found["events/collisions/contact_normal"].tolist() == [[0.0, 0.0, 1.0]] * 2
    # The camera stands at (0, -3, 1) and looks along z with y down: 1 right, 3 below, 2 ahead.
    k = record.intrinsics
    at = [(k.fx / 2 + k.cx) / WIDTH, (3 * k.fy / 2 + k.cy) / HEIGHT]
    assert found["events/collisions/image_position"][0] == pytest.approx(at)
    old = {**row, "contact_point_m": None, "contact_normal": None}
    found = fields(replace(told, more={"trajectories": [old]}))
    assert np.isnan(found["events/collisions/position"]).all()
    short = fields(sample)
    assert len(short["events/collisions/frame"]) == 0
