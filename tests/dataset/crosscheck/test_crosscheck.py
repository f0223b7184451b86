"""Checks of ground truth: exact truth passes, every kind of fault is found by what it breaks."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

from esg.dataset.clips.records import ClipRecord
from esg.dataset.crosscheck import check_clips
from esg.dataset.crosscheck.checks import CHECKS
from esg.dataset.crosscheck.contacts import Hull, contact_gaps, gap, hull_of
from esg.dataset.crosscheck.running import sampled
from tests.dataset.crosscheck import analytic


def checked(out: Path, made: ClipRecord, found: dict[str, Any]) -> dict[str, dict[str, Any]]:
    clip = analytic.written(out, made, found)
    return {row["check_name"]: row for row in check_clips([clip], {}, {})}


def test_exact_truth_passes_every_check(tmp_path: Path) -> None:
    rows = checked(tmp_path, analytic.clip_record(), analytic.clip_values())
    assert set(rows) == set(CHECKS)
    for name, row in rows.items():
        assert row["ok"], (name, row)
        assert row["samples"] >= 4 and row["p50"] <= row["p90"] <= row["p99"] <= row["worst"]
    assert rows["flow"]["worst"] < 0.02
    assert rows["object_coordinates"]["worst"] < 0.002


Fault = Callable[[ClipRecord, dict[str, Any]], ClipRecord]


def _shifted_flow(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    found["flow"] = found["flow"] + (0.3, 0.0)
    return made


def _flow_in_one_object(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    """As if the object had stood still: only the camera's own motion is left."""
    body = found["segmentation"] == 2
    found["flow"][body] = 0.0
    return made


def _late_poses(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    late = np.concatenate([made.object_position_m[:1], made.object_position_m[:-1]])
    return replace(made, object_position_m=late)


def _late_camera(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    eyes = made.camera_position_m
    return replace(made, camera_position_m=np.concatenate([eyes[:1], eyes[:-1]]))


def _backward_is_forward(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    found["backward_flow"] = -found["backward_flow"]
    return made


def _depth_in_ray_length(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    width, height = analytic.SIZE
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    k = made.intrinsics
    found["depth"] = found["depth"] * np.sqrt(
        1 + ((x - k.cx) / k.fx) ** 2 + ((y - k.cy) / k.fy) ** 2
    )
    return made


def _wide_box(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(made, boxes2d=tuple({**b, "x1": b["x1"] + 1} for b in made.boxes2d))


def _no_box(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(made, boxes2d=made.boxes2d[1:])


def _small_box(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(
        made, boxes3d=tuple({**b, "half_x_m": 0.8 * b["half_x_m"]} for b in made.boxes3d)
    )


def _tracks_half_a_pixel_off(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(made, track_xy_px=made.track_xy_px + np.float32(0.5))


def _all_tracks_visible(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(made, track_visible=np.ones_like(made.track_visible))


def _wrong_bounds(made: ClipRecord, found: dict[str, Any]) -> ClipRecord:
    return replace(made, object_bounds_m=made.object_bounds_m * np.float32(1.1))


@pytest.mark.parametrize(
    ("fault", "by"),
    [
        (_shifted_flow, {"flow", "there_and_back"}),
        (_flow_in_one_object, {"flow", "there_and_back"}),
        (_late_poses, {"flow", "backward_flow", "tracks", "object_coordinates"}),
        (_late_camera, {"flow", "backward_flow", "tracks", "object_coordinates"}),
        (_backward_is_forward, {"backward_flow", "there_and_back"}),
        (_depth_in_ray_length, {"object_coordinates", "boxes3d"}),
        (_wide_box, {"boxes2d"}),
        (_no_box, {"boxes2d"}),
        (_small_box, {"boxes3d"}),
        (_tracks_half_a_pixel_off, {"tracks"}),
        (_all_tracks_visible, {"track_depth"}),
        (_wrong_bounds, {"object_coordinates"}),
    ],
    ids=lambda value: getattr(value, "__name__", ""),
)
def test_every_fault_is_found(tmp_path: Path, fault: Fault, by: set[str]) -> None:
    found = analytic.clip_values()
    rows = checked(tmp_path, fault(analytic.clip_record(), found), found)
    assert by <= {name for name, row in rows.items() if row["ok"] is False}


def test_what_turns_on_a_body_is_left_out(tmp_path: Path) -> None:
    """Pixels within a wheel do not move with the body; the manifest says where wheels are."""
    found = analytic.clip_values()
    view = [analytic.seen(k) for k in range(analytic.FRAMES)]
    for k in range(analytic.FRAMES):
        inside = view[k]["inside"]
        wheel = (view[k]["ids"] == 2) & (np.hypot(inside[..., 0] - 0.3, inside[..., 2]) < 0.25)
        found["flow"][k][wheel] += 5.0
        found["backward_flow"][k][wheel] -= 5.0
    clip = analytic.written(tmp_path, analytic.clip_record(), found)
    key = clip.record.scene_key
    plain = {r["check_name"]: r for r in check_clips([clip], {}, {})}
    body = {"name": "box_1", "wheels": [{"axle": [0.3, -0.2, 0.0], "radius": 0.25}], "shapes": []}
    scenes = {key: {"manifest": f'{{"bodies": [{str(body).replace(chr(39), chr(34))}]}}'}}
    known = {r["check_name"]: r for r in check_clips([clip], scenes, {})}
    assert not plain["flow"]["ok"] and known["flow"]["ok"] and known["there_and_back"]["ok"]


def test_only_what_a_clip_has_is_checked(tmp_path: Path) -> None:
    made = replace(analytic.clip_record(), channels=("rgb", "segmentation"), boxes3d=(),
                   track_ids=np.zeros(0, np.int32))  # fmt: skip
    found = {k: v for k, v in analytic.clip_values().items() if k in ("rgb", "segmentation")}
    assert set(checked(tmp_path, made, found)) == {"boxes2d"}


def test_the_same_scenes_are_drawn_whoever_asks() -> None:
    keys = [f"run/{k}" for k in range(40)]
    assert sampled(keys) == sampled(reversed(keys)) and len(sampled(keys)) == 2
    assert sampled(keys[:3]) and sampled([]) == []


@pytest.mark.parametrize(
    ("away", "expected"),
    [((3.0, 0.0, 0.0), 2.0), ((2.0, 2.0, 0.0), np.sqrt(2)), ((0.5, 0.2, 0.1), 0.0),
     ((4.0, 5.0, 6.0), np.linalg.norm([3, 4, 5]))],
)  # fmt: skip
def test_the_gap_between_two_cubes(away: tuple[float, ...], expected: float) -> None:
    cube = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    assert gap(cube, cube + np.array(away)) == pytest.approx(expected, abs=2e-4)


def test_the_gap_of_a_slanted_edge_to_a_face() -> None:
    turn, _ = analytic.turned((0, 0, 1), np.pi / 4)
    cube = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    other = cube @ turn.T + (2.0, 0.1, 0.2)
    assert gap(cube, other) == pytest.approx(1.5 - np.sqrt(0.5), abs=2e-4)


def test_shapes_of_a_manifest() -> None:
    base = {"position": [0, 0, 1], "quaternion": [0, 0, 0, 1], "vertices": []}
    ball = hull_of({**base, "kind": "sphere", "size": [0.2, 0.2, 0.2]})
    assert (ball.radius, ball.points.tolist()) == (0.2, [[0, 0, 1]])
    rod = hull_of({**base, "kind": "capsule", "size": [0.1, 0.1, 0.5]})
    assert np.ptp(rod.points[:, 2]) == 1.0
    drum = hull_of({**base, "kind": "cylinder", "size": [0.3, 0.3, 0.5]})
    assert np.abs(drum.points[:, :2]).max() == pytest.approx(0.3)
    assert isinstance(ball, Hull)


def rolling(at_hit: float = 0.6) -> tuple[dict[str, Any], dict[str, Any]]:
    """A ball of 0.2 m that rolls at 3 m/s into a wall and back; the hit is between two frames."""
    time = np.arange(31) / 60.0
    hit = 0.255
    x = np.where(time < hit, at_hit - 0.2 - 3.0 * (hit - time), at_hit - 0.2 - 2.0 * (time - hit))
    v = np.where(time < hit, 3.0, -2.0)
    place = np.zeros((31, 2, 3))
    place[:, 0] = np.stack([x, 0 * x, 0.2 + 0 * x], -1)
    place[:, 1] = (0.7, 0.0, 0.5)
    speed = np.zeros_like(place)
    speed[:, 0, 0] = v
    still = np.tile([0.0, 0.0, 0.0, 1.0], (31, 2, 1))
    row = {
        "bodies": ["ball", "wall"], "n_frames": 31, "time_s": time, "position_m": place.ravel(),
        "quaternion_xyzw": still.ravel(), "linear_velocity_mps": speed.ravel(),
        "angular_velocity_radps": np.zeros(31 * 6), "contact_time_s": [0.1, hit],
        "contact_a": [0, 0], "contact_b": [-1, 1],
    }  # fmt: skip
    base = {"position": [0, 0, 0], "quaternion": [0, 0, 0, 1], "vertices": []}
    manifest = {
        "bodies": [
            {"name": "ball", "shapes": [{**base, "kind": "sphere", "size": [0.2, 0.2, 0.2]}]},
            {"name": "wall", "shapes": [{**base, "kind": "box", "size": [0.1, 1.0, 0.5]}]},
        ]
    }
    return row, manifest


def test_contacts_are_where_the_shapes_meet() -> None:
    rng = np.random.default_rng(0)
    assert contact_gaps(*rolling(), rng).values == pytest.approx([0.0, 0.0], abs=1e-3)
    # A hit that is told 10 cm before the wall.
    assert contact_gaps(*rolling(0.5), rng).values == pytest.approx([0.0, 0.1], abs=1e-3)


def test_what_made_the_truth_is_not_asked() -> None:
    """The checks would agree with a fault that they share."""
    code = (
        "import sys, esg.dataset.crosscheck.checks, esg.dataset.crosscheck.contacts;"
        "sys.exit(any(m in sys.modules for m in ('esg.view.truth', 'esg.view.capture', "
        "'esg.view.seeing')))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
