"""The director: every event is in view, unobscured and large enough, and cameras move smoothly."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

from esg.draft import draft
from esg.view import scenery as sceneries
from esg.view.camera import Camera
from esg.view.cameras import Takes, directed
from esg.view.capture import capture
from esg.view.containers import read_capture
from esg.view.director.acting import AFTER_S
from esg.view.director.lens import FILL_LEAST, FILL_MOST, SAFE, extent, framed
from esg.view.director.lens import View as LensView
from esg.view.director.paths import (
    KINDS,
    SPEED_JERK,
    TURN_JERK,
    TURN_MOST,
    is_smooth,
    knots,
    motion_of,
)
from esg.view.director.review import BEFORE, IN_VIEW, UNOBSCURED
from esg.view.director.staging import azimuth_of, direct
from esg.view.director.takes import Take, standing
from esg.view.film.shooting import shots_of
from esg.view.framing import told_side
from esg.view.seeing.wanted import Settings
from esg.view.truth import Pinhole, flow
from tests.view.plays import (
    CAR,
    PLAYS,
    Play,
    Thing,
    action_of,
    at,
    document_of,
    finder_of,
    parts_of,
    rollout_of,
    scene_of,
    until,
    verdict_of,
)

NAMED = {play.name: play for play in PLAYS}
BOX = np.array([[x, y, z] for x in (-2, 2) for y in (-1, 1) for z in (0, 1.5)], float)


@pytest.mark.parametrize("play", PLAYS, ids=lambda p: p.name)
def test_every_event_is_in_view_unobscured_and_large_enough(play: Play) -> None:
    """In the film's own shots; cameras are smooth, above ground and inside of nothing."""
    finder = finder_of(play)
    shots = shots_of(finder)
    seen = [one for shot in shots for one in finder.review(shot.take)]
    assert [s.beat.event for s in seen] == [f"e{k}" for k in range(1, len(play.events) + 1)]
    for one in seen:
        assert one.inside >= IN_VIEW
        assert one.unobscured >= UNOBSCURED
        assert FILL_LEAST <= one.fill <= FILL_MOST
    for shot in shots:
        turn, gain, rush = motion_of(shot.take)
        assert turn <= TURN_MOST and gain <= TURN_JERK and rush <= SPEED_JERK
        assert shot.take.eye[:, 2].min() >= 0.1
        assert finder.clear(shot.take, looks=8)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_seeds_change_the_camera_and_keep_the_rules(seed: int) -> None:
    """Another seed, another picture; the same seed, the same one."""
    finder = finder_of(NAMED["head_on"])
    one, again, first = (direct(finder, 0.5, 2.0, seed=s) for s in (seed, seed, 0))
    assert (one.eye == again.eye).all() and (one.target == again.target).all()
    assert one.fov != first.fov or abs(azimuth_of(one) - azimuth_of(first)) > 0.02
    assert all(s.good for s in finder.review(one))


def test_a_wall_between_viewer_and_action_is_walked_around() -> None:
    """From the viewer's side at eye height it would hide the hit."""
    finder = finder_of(NAMED["behind_a_wall"])
    beat = finder.action.beats[0]
    points = finder.action.acting(beat.time_s, beat)
    hidden = Camera((0.0, 6.0, 1.0), tuple(points.mean(axis=0)), 0.6)  # type: ignore[arg-type]
    assert finder.seen(beat, hidden).unobscured < 0.2
    assert all(s.unobscured > 0.95 for s in finder.review(direct(finder, 0.0, 1.8)))


def test_what_is_too_close_or_crosses_a_wall_is_not_clear() -> None:
    """An eye inside of a wall, one that rides through it, and one beside it."""
    finder = finder_of(NAMED["behind_a_wall"])
    times = knots(0.0, 1.0)
    along = np.linspace(0.0, 3.0, len(times))
    eye = np.stack([0 * along, 3.5 - along, 0 * along + 1.0], axis=1)
    through = Take("dolly", times, eye, np.tile((0.0, 0.0, 0.2), (len(times), 1)), 0.6)
    assert not finder.clear(through)
    assert not finder.clear(standing(Camera((-1.0, 1.6, 1.0), (0.0, 0.0, 0.2)), times))
    assert finder.clear(standing(Camera((-1.0, -4.0, 1.6), (0.0, 0.0, 0.2)), times))


@pytest.mark.parametrize("kind", [k for k in KINDS if k != "dash"])
@pytest.mark.parametrize("name", ["ball_and_box", "head_on", "chain"])
def test_every_kind_keeps_the_events_in_view(kind: str, name: str) -> None:
    """Static cameras do not move, the others do."""
    play = NAMED[name]
    finder = finder_of(play)
    take = direct(finder, 0.2, play.events[-1][1] + 0.6, kinds=(kind,))
    assert take.kind == kind
    assert all(s.inside >= IN_VIEW and s.unobscured >= UNOBSCURED for s in finder.review(take))
    way = float(np.ptp(take.eye, axis=0).max())
    assert way == 0.0 if kind == "static" else way > 0.05
    assert is_smooth(take)


def test_a_scene_without_vehicles_has_no_dash() -> None:
    """Something else films it."""
    assert direct(finder_of(NAMED["drop"]), 0.0, 1.0, kinds=("dash",)).kind in (
        "static",
        "tracking",
    )


def test_eye_height_and_thirds() -> None:
    """Beside cars one stands at 1.6 m; what moves to the right has room on the right."""
    action = action_of(NAMED["brakes"])
    points = action.acting(0.5)
    for azimuth, lead in ((-math.pi / 2, 1.0), (math.pi / 2, -1.0)):
        camera = framed(points, LensView(azimuth, None, 0.65, 16 / 9, lead))
        assert 1.3 < camera.eye[2] < 1.9
        found = extent(camera, points, 16 / 9)
        middle = 0.5 * (found.low[0] + found.high[0])
        assert math.copysign(1.0, middle) == -lead and 0.05 < abs(middle) < 0.5
        assert 0.5 * (found.low[1] + found.high[1]) < -0.05
        assert found.overflow <= SAFE + 1e-6
        assert FILL_LEAST <= found.fill <= FILL_MOST


@pytest.mark.parametrize("fov", [0.35, 0.62, 0.9])
@pytest.mark.parametrize("wanted", [0.2, 0.4])
def test_framed_points_have_the_wanted_fill(fov: float, wanted: float) -> None:
    """Whatever the lens; measured on the projected corners."""
    camera = framed(BOX, LensView(0.7, 0.3, fov, 16 / 9), wanted)
    pixels, ahead = camera.project(BOX, 1600, 900)
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    assert ahead.all()
    shares = (high - low) / (1600, 900)
    assert math.sqrt(shares[0] * shares[1]) == pytest.approx(wanted, rel=0.12)
    assert extent(camera, BOX, 16 / 9).fill == pytest.approx(math.sqrt(shares[0] * shares[1]))


def test_fill_counts_what_is_inside_the_picture() -> None:
    """A box of which half is outside fills half as much of that direction; one behind nothing."""
    camera = Camera((0.0, -10.0, 0.0), (0.0, 0.0, 0.0), 2 * math.atan(0.5))
    square = np.array([[x, 0.0, z] for x in (-1, 1) for z in (-1, 1)], float)
    assert extent(camera, square, 1.0).fill == pytest.approx(0.2)
    beside = extent(camera, np.add(square, (5.0, 0, 0)), 1.0)
    assert beside.fill == pytest.approx(0.2 / math.sqrt(2)) and beside.inside == pytest.approx(0.5)
    assert extent(camera, square - (0, 20.0, 0), 1.0).fill == 0.0


def test_who_acts_changes_with_the_beats() -> None:
    """First the car with the bin it comes near, then the bin with the sign."""
    action = action_of(NAMED["chain"])
    car_hits, bin_hits = action.beats
    assert [action.scene.bodies[i].name for i in car_hits.participants] == ["car", "bin"]
    assert [action.scene.bodies[i].name for i in bin_hits.leads] == ["bin"]
    assert action.beat_at(car_hits.time_s + AFTER_S - 0.01) is car_hits
    assert action.beat_at(car_hits.time_s + AFTER_S + 0.01) is bin_hits
    alone = action.acting(0.1)
    assert np.ptp(alone[:, 0]) == pytest.approx(4.4)  # the bin is far away still
    assert np.ptp(action.acting(1.2)[:, 0]) > 4.9


def test_intrinsics_and_extrinsics_put_points_where_the_camera_does() -> None:
    """Of every frame of a moving camera; a still one has one matrix."""
    take = direct(finder_of(NAMED["head_on"]), 0.5, 2.0, kinds=("tracking",))
    record = take.record((640, 360))
    assert len(record["world_to_camera_by_frame"]) == len(take)
    for k in (0, len(take) - 1):
        local = np.c_[BOX, np.ones(8)] @ np.array(record["world_to_camera_by_frame"][k]).T
        pixels = local[:, :3] @ np.array(record["intrinsics_px"]).T
        wanted, _ = take.camera(k).project(BOX, 640, 360)
        assert pixels[:, :2] / pixels[:, 2:] == pytest.approx(wanted, abs=1e-6)
    assert record["lens_mm"] == pytest.approx(35.0)
    still = standing(take.camera(0), take.time_s).record((640, 360))
    assert np.shape(still["world_to_camera"]) == (4, 4)
    assert "world_to_camera_by_frame" not in still


def test_several_cameras_stand_apart() -> None:
    """Every one keeps the rules."""
    finder = finder_of(NAMED["ball_and_box"])
    takes: Takes = directed(finder, ("static",), 3, seed=0)
    angles = [azimuth_of(take) for take in takes]
    for a in range(3):
        assert all(s.good for s in finder.review(takes[a]))
        for b in range(a):
            assert math.cos(angles[a] - angles[b]) < math.cos(math.radians(20))


def test_flow_of_a_camera_that_moves() -> None:
    """A wall 5 m ahead shifts by focal length x way / depth, whether a body or the world."""
    size = (64, 48)
    first = Camera((0.0, -5.0, 0.0), (0.0, 0.0, 0.0), 0.8)
    later = Camera((0.25, -5.0, 0.0), (0.25, 0.0, 0.0), 0.8)
    one, two = Pinhole.of(first, size), Pinhole.of(later, size)
    depth = np.full((48, 64), 5.0)
    body = np.full((48, 64), -1)
    body[:, :32] = 0
    rest = (np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]]))
    shift = flow(one, depth, body, rest, rest, two)
    assert shift[..., 0] == pytest.approx(
        np.full((48, 64), -one.matrix[0, 0] * 0.25 / 5.0), abs=1e-4
    )
    assert shift[..., 1] == pytest.approx(np.zeros((48, 64)), abs=1e-4)
    assert (flow(one, depth, body, rest, rest) == 0.0).all()


def test_ground_truth_by_the_director(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every camera has its kind, lens and extrinsics of every frame, and masks fit them."""
    play = NAMED["ball_and_box"]
    monkeypatch.setattr("esg.view.seeing.witness.scene_parts", lambda *_: parts_of(play))
    monkeypatch.setattr(sceneries, "body_parts", lambda *_: parts_of(play)[1:])
    settings = Settings(("segmentation",), (96, 54), 4.0, 2, camera="tracking")
    world = (scene_of(play), rollout_of(play), verdict_of(play), document_of(play))
    folder = capture(*world, tmp_path / "shots", settings)
    manifest = json.loads((folder / "manifest.json").read_bytes())
    action = action_of(play)
    assert [c["kind"] for c in manifest["cameras"]] == ["tracking", "tracking"]
    rows = {(r["camera"], r["frame"]): r for r in read_capture(folder)}
    frame = manifest["time_s"].index(1.0)
    for number, camera in enumerate(manifest["cameras"]):
        assert len(camera["world_to_camera_by_frame"]) == manifest["frames"]
        ball = action.corners(action.frame(1.0), (0,))[0].mean(axis=0)
        local = np.array(camera["world_to_camera_by_frame"][frame]) @ (*ball, 1.0)
        x, y, z = np.array(camera["intrinsics_px"]) @ local[:3]
        assert rows[number, frame]["segmentation"][int(y / z), int(x / z)] == 2


@pytest.mark.parametrize("seed", range(3))
def test_who_comes_from_afar_and_rolls_away_is_in_every_picture(seed: int) -> None:
    """Clips last from the first picture to the last, long after the last event."""
    play = Play(
        "away",
        (
            Thing("ball", (0.11,) * 3, until(2.0, (-4.0, 0, 0.11), (2.0, 0, 0), -1.5)),
            Thing("wall", (0.1, 2.0, 1.0), at(0.21, 0, 1.0), static=True),
        ),
        (("collision", 2.0, ("ball", "wall")),),
        7.0,
    )
    finder = finder_of(play)
    (take,) = directed(finder, ("static", "tracking"), 1, seed=seed)
    ball = finder.action.scene.index("ball")
    for k, time in enumerate(take.time_s):
        box = finder.action.corners(finder.action.frame(float(time)), (ball,)).reshape(-1, 3)
        assert extent(take.camera(k), box, finder.aspect).inside > 0.8
    # It is followed when all is over, not approached.
    away = np.linalg.norm(take.eye - take.target, axis=1)
    late = take.time_s > 2.0 + AFTER_S
    assert away[late].min() > 0.8 * away[late][0]


def test_motions_that_begin_at_once_are_one_beat() -> None:
    """Two that set off together are seen together, a third later."""
    play = Play(
        "convoy",
        (
            Thing("car", (2.2, 0.9, 0.7), lambda t: (5 * t, 0, 0.7)),
            Thing("van", (2.7, 1.0, 1.1), lambda t: (5 * t, 4, 1.1)),
            Thing("bus", (4.0, 1.2, 1.4), lambda t: (5 * max(0.0, t - 2), 8, 1.4)),
        ),
        (("moves", 0.0, ("car",)), ("moves", 0.1, ("van",)), ("moves", 2.0, ("bus",))),
        4.0,
    )
    beats = action_of(play).beats
    assert [b.leads for b in beats] == [(0, 1), (2,)]


def test_what_a_verb_implies_tells_no_side() -> None:
    """A relation "behind" is the viewer's where the prompt says so."""
    sides = []
    for prompt in ("A car stands behind a van.", "A car overtakes a van."):
        sides.append(told_side(draft(prompt)))
    assert sides[0] == pytest.approx(math.pi / 2) and sides[1] is None


def test_a_crowd_before_the_action_is_not_good() -> None:
    """Bodies that cover much of a picture and are nearer than who acts are walked around."""
    play = Play(
        "legs",
        (
            Thing("egg", (0.03,) * 3, lambda t: (0.0, 0.0, max(0.03, 1.0 - 4.9 * t * t))),
            Thing("pan", (0.15, 0.15, 0.02), lambda t: (0.0, 0.0, 0.02)),
            Thing("leg", (0.1, 0.1, 0.8), lambda t: (0.0, 0.45, 0.8)),
        ),
        (("collision", 0.44, ("egg", "pan")),),
        2.0,
    )
    finder = finder_of(play)
    (beat,) = finder.action.beats
    behind = Camera((0.25, 1.0, 0.5), (0.0, 0.0, 0.05), math.radians(45))
    assert finder.seen(beat, behind).before > BEFORE
    (seen,) = finder.review(direct(finder, 0.0, 1.0))
    assert seen.before <= BEFORE


def test_a_cloud_behind_what_drives_off_is_not_looked_at_from_ahead() -> None:
    """Walls hide the street from both sides: from ahead nothing but the car would be seen."""
    walls = [
        Thing(f"wall{k}", (30.0, 0.3, 5.0), at(0.0, y, 5.0)) for k, y in enumerate((-3.5, 3.5))
    ]
    car = Thing("car", CAR, until(9.0, (6.0, 0.0, 0.7), (-6.0, 0.0, 0.0)))
    finder = finder_of(Play("drives_off", (car, *walls), (("reach", 1.5, ("car",)),)))
    assert not finder.action.trails
    before = -math.cos(azimuth_of(direct(finder, 0.0, 2.0)))
    finder.action.trails = True
    after = -math.cos(azimuth_of(direct(finder, 0.0, 2.0)))
    assert before > 0.6 > after
