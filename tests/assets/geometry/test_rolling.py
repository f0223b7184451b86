"""Things on their rim: they stand up when they roll, are one cylinder, and roll straight."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets import build_mesh, resolve
from esg.assets.geometry.rolling import FLAGS
from esg.assets.library.catalogue import catalogue, entries_by_name
from esg.assets.stage import configure
from esg.draft import draft
from esg.dynamics.plan.build import make_body
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import AssetConfiguration, EsgDocument, Node, Pose
from esg.units import quat_rotate
from tests.assets.worlds import EMPTY, requirement

KINDS = [e.name for e in catalogue() if e.flags & FLAGS.keys()]


def rolled(name: str) -> AssetConfiguration:
    return configure(name, requirement(entries_by_name()[name]), rolled=True)


@pytest.mark.parametrize("name", KINDS)
def test_rolling_form_is_one_cylinder_about_the_horizontal_axis(name: str) -> None:
    lying, config = configure(name, requirement(entries_by_name()[name])), rolled(name)
    assert not lying.rolls and config.rolls
    (proxy,) = config.proxies
    assert proxy.kind.value == "cylinder"
    axis = quat_rotate(proxy.orientation_xyzw, np.array([0.0, 0.0, 1.0]))
    assert abs(axis[1]) == pytest.approx(1.0)
    length, width, height = config.dimensions_cm
    assert length == pytest.approx(height)
    drawn = lying.dimensions_cm
    (flag,) = entries_by_name()[name].flags & FLAGS.keys()
    assert width == pytest.approx(drawn[FLAGS[flag]])
    assert math.prod(config.dimensions_cm) == pytest.approx(math.prod(drawn))
    # What is not quite round, as a pencil with its six sides, rolls on a radius between.
    across = [d for k, d in enumerate(drawn) if k != FLAGS[flag]]
    assert min(across) <= height * 1.000001 and height <= max(across) * 1.000001
    slack = 0.03 + max(across) / min(across) - 1.0
    assert proxy.size_cm == pytest.approx((height / 2, height / 2, width / 2))
    assert proxy.position_cm == pytest.approx((0, 0, height / 2))
    assert config.center_of_mass_cm[2] == pytest.approx(height / 2, rel=0.02)
    low, high = build_mesh(config).bounds
    assert np.asarray(high - low) == pytest.approx(config.dimensions_cm, rel=slack, abs=0.05)
    assert low[2] == pytest.approx(0, abs=slack * height)


def test_hoop_keeps_the_inertia_of_a_ring() -> None:
    config = rolled("hula_hoop")
    radius = config.dimensions_cm[2] / 2
    assert config.inertia_kg_cm2[1] > 0.85 * config.mass_kg * radius**2
    assert config.inertia_kg_cm2[1] == pytest.approx(2 * config.inertia_kg_cm2[0], rel=0.05)


def test_size_asked_for_says_how_it_stands() -> None:
    tire = entries_by_name()["tire"]
    on_rim = configure("x", requirement(tire, expected_dimensions_cm=(65, 22, 65)))
    flat = configure("x", requirement(tire, expected_dimensions_cm=(65, 65, 22)))
    assert on_rim.dimensions_cm[1] < 0.5 * on_rim.dimensions_cm[2] and on_rim.rolls
    assert flat.dimensions_cm[2] < 0.5 * flat.dimensions_cm[1] and not flat.rolls


def only(doc: EsgDocument, category: str) -> AssetConfiguration:
    key = next(k for k, r in doc.asset_requirement.items() if category in r.asset_description)
    return resolve(doc).asset_configurations[key]


def test_story_decides_over_the_size() -> None:
    rolls = draft("A tire rolls into a traffic cone.")
    assert only(rolls, "tire").rolls
    stacked = draft("A ball hits a stack of tires.")
    assert not only(stacked, "tire").rolls
    log = only(draft("A log rolls into a car."), "log")
    assert log.rolls and log.dimensions_cm[1] == max(log.dimensions_cm)
    pushed = draft("A worker pushes a barrel and it rolls into a crate.")
    assert only(pushed, "barrel").rolls and not only(draft("A car hits a barrel."), "barrel").rolls


@pytest.mark.parametrize("yaw", [0.0, -90.0, 37.0])
@pytest.mark.parametrize(
    ("name", "speed", "engine"),
    [
        ("tire", 4.0, "physx"),
        ("hula_hoop", 2.0, "physx"),
        ("barrel", 2.0, "physx"),
        ("cheese_wheel", 2.0, "physx"),
        ("wheel", 4.0, "rapier"),
        ("log", 2.0, "rapier"),
        ("bottle", 2.0, "physx"),
        ("trash_bin", 3.0, "physx"),
        ("cup", 3.0, "physx"),
        ("round_bale", 2.0, "physx"),
        ("dumbbell", 1.5, "physx"),
    ],
)
def test_rolls_straight_and_smoothly(name: str, speed: float, engine: str, yaw: float) -> None:
    config = rolled(name)
    pose = Pose(position_cm=(0, 0, 0), yaw_deg=yaw)
    body = make_body(EMPTY, name, Node(asset_id=name), config, pose, active=True)
    c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
    spin = speed / body.roll_radius
    launch = SetVelocity(name, 0.0, (speed * c, speed * s, 0.0), (-spin * s, spin * c, 0.0))
    scene = SimScene(scene_id="roll", bodies=(body,))
    rollout = get_engine(engine).rollout(
        scene, batch_programs([Program((launch,), 2.0)], scene.names), record_every=4
    )
    way = rollout.position[0, :, 0] - rollout.position[0, 0, 0]
    along, aside = way[:, 0] * c + way[:, 1] * s, way[:, 1] * c - way[:, 0] * s
    assert along[-1] > 1.2 * speed
    assert np.abs(aside).max() < 0.02 * along[-1]
    assert np.abs(way[:, 2]).max() < 0.05 * body.roll_radius
    axes = np.array(
        [quat_rotate(q, np.array([0.0, 1.0, 0.0])) for q in rollout.quaternion[0, :, 0]]
    )
    assert np.degrees(np.arcsin(np.abs(axes[:, 2]).max())) < 4
