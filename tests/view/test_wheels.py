"""Wheels in pictures: they turn on their bodies, and count as parts of them."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

from esg.assets.appearance import USUAL
from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.dynamics.plan.build import make_body
from esg.graph.models import Node, Pose
from esg.units import quat_rotate
from esg.view import parts as module
from esg.view import truth
from esg.view.camera import Camera
from esg.view.pieces import Movers, Part, Turning
from esg.view.render import Renderer
from esg.view.tracer.stage import bundles
from esg.view.truth import Pinhole
from esg.view.worlds import WorldRenderer
from tests.assets.worlds import EMPTY, requirement

RED, GREEN, GREY = (0.9, 0.05, 0.05), (0.05, 0.9, 0.05), (0.4, 0.4, 0.4)
AXLE = (1.0, 0.0, 0.0)
WHEEL = Turning(1, AXLE)
"""Number 1 of the scene's wheels: body 0 has another, of which nothing is drawn."""
SIZE = (96, 64)
CAMERA = Camera((1.0, -6.0, 0.0), (1.0, 0.0, 0.0))


def box(at: tuple[float, float, float], size: tuple[float, float, float]) -> trimesh.Trimesh:
    mesh = trimesh.creation.box(size)
    mesh.apply_translation(at)
    return mesh


def part(mesh: trimesh.Trimesh, color: tuple[float, float, float], wheel: Turning | None) -> Part:
    return Part(0, np.asarray(mesh.vertices), np.asarray(mesh.faces), color, wheel)


HAND = part(box((1.0, 0.0, 0.6), (0.3, 0.3, 0.6)), RED, WHEEL)
"""Above the axle at angle 0."""
HULL = part(box((-1.5, 0.0, 0.0), (0.5, 0.5, 0.5)), GREEN, None)
REST = np.zeros((1, 3)), np.array([[0.0, 0.0, 0.0, 1.0]])


def where(image: np.ndarray) -> tuple[float, float]:
    """Middle of what is red [px]."""
    red = (image[..., 0] > 80) & (image[..., 1] < 60) & (image[..., 2] < 60)
    rows, columns = np.nonzero(red)
    return float(columns.mean()), float(rows.mean())


def test_a_wheel_is_drawn_at_its_angle() -> None:
    """Forward is clockwise for who looks along +Y: a quarter leads from above to ahead (+X)."""
    renderer = Renderer([HAND, HULL], 1, *SIZE)
    renderer.pose(*REST)
    x, y = where(renderer.color(CAMERA))
    assert x == pytest.approx(48, abs=1.5) and y < 25
    renderer.pose(*REST, np.array([0.3, math.pi / 2]))
    x, y = where(renderer.color(CAMERA))
    assert y == pytest.approx(32, abs=1.5) and x > 55
    renderer.pose(*REST, np.array([0.0, -math.pi / 2]))
    assert where(renderer.color(CAMERA))[0] < 41


def test_a_wheel_belongs_to_its_body_and_moves_apart() -> None:
    renderer = WorldRenderer([HAND, HULL], 1, 1, SIZE)
    angles = np.array([[[0.0, 0.0]], [[0.0, 0.2]]])
    now = renderer.movers.poses(REST[0][None], REST[1][None], angles[0])
    later = renderer.movers.poses(REST[0][None], REST[1][None], angles[1])
    renderer.pose(REST[0][None], REST[1][None], angles[0])
    renderer.draw([CAMERA], rgb=False)
    views = renderer.read(rgb=False)
    assert set(np.unique(views.body[0])) == {-2, 0}
    assert set(np.unique(views.mover[0])) == {-2, 0, 1}
    shift = truth.flow(
        Pinhole.of(CAMERA, SIZE),
        views.depth[0],
        views.mover[0],
        (now[0][0], now[1][0]),
        (later[0][0], later[1][0]),
    )
    assert np.abs(shift[views.mover[0] == 0]).max() < 1e-4
    # A hand of 0.6 m at 5.85 m, turned by 0.2 rad.
    pixels = 0.5 * SIZE[1] / math.tan(CAMERA.fov / 2) * 0.6 * math.sin(0.2) / 5.85
    assert shift[views.mover[0] == 1][:, 0].mean() == pytest.approx(pixels, rel=0.1)


def test_wheels_ride_with_their_body() -> None:
    """The pose of a wheel keeps its axle where the body has it, however it is turned."""
    movers = Movers([HAND, HULL], 1)
    assert len(movers) == 2 and movers.of(HULL) == 0 and movers.of(HAND) == 1
    yaw = math.pi / 2
    q = np.array([[0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)]])
    at, turn = movers.poses(np.array([[5.0, 0.0, 1.0]]), q, np.array([0.0, 1.1]))
    axle = at[1] + quat_rotate(turn[1], np.array(AXLE))
    assert axle == pytest.approx([5.0, 1.0, 1.0])


def test_merging_keeps_wheels_apart() -> None:
    other = part(box((0.0, 0.0, 0.0), (0.1, 0.1, 0.1)), RED, None)
    made, _ = bundles([HAND, other, HAND], Movers([HAND, other], 1))
    assert [(b.mover, len(b.faces)) for b in made] == [(0, 12), (1, 24)]


def test_parts_of_a_scene_know_their_wheels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of two cars the second one's wheels are counted on."""
    monkeypatch.setattr("esg.assets.appearances.appearances", lambda _: dict.fromkeys("ab", USUAL))
    config = configure("car", requirement(entries_by_name()["car"]))
    bodies = [
        make_body(
            EMPTY, name, Node(asset_id="car"), config, Pose(position_cm=(0, 0, 0)), active=True
        )
        for name in ("a", "b")
    ]
    doc = SimpleNamespace(
        scene_definition=SimpleNamespace(scene_parameters=SimpleNamespace(scene_type="outdoor")),
        spatial_relation_graph=SimpleNamespace(
            nodes={b.name: SimpleNamespace(asset_id="car") for b in bodies}
        ),
        asset_configurations={"car": config},
        casting=None,
        dressing=None,
        statements=None,
        timeline_system=None,
    )
    rollout = SimpleNamespace(position=np.zeros((1, 2, 2, 3)))
    scene = SimpleNamespace(bodies=bodies, weather=())
    drawn = module.scene_parts(scene, rollout, doc)  # type: ignore[arg-type]
    for body in (0, 1):
        found = {p.wheel.index for p in drawn if p.body == body and p.wheel is not None}
        assert found == {4 * body + k for k in range(4)}
    for p in drawn:
        if p.wheel is not None:
            x, _, z = p.wheel.axle
            reach = np.hypot(p.vertices[:, 0] - x, p.vertices[:, 2] - z)
            assert reach.max() < 0.34
