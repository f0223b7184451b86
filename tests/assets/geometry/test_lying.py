"""Things turned: footprint, rest height, drawing and mass agree, and they stay as they lie."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets import build_mesh
from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.draft import draft
from esg.dynamics.casting.changes import resized
from esg.dynamics.plan.build import make_body
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import AssetConfiguration, Node, Pose
from esg.lexicon.lying import poses, ups
from esg.units import quat_rotate
from tests.assets.worlds import EMPTY, requirement

LAIN = [
    ("bottle", "on its side"),
    ("mug", "upside down"),
    ("mug", "on its side"),
    ("bucket", "on its side"),
    ("car", "on its roof"),
    ("car", "on its side"),
    ("chair", "upside down"),
    ("chair", "tipped over"),
    ("coin", "on its edge"),
    ("book", "upright"),
    ("bicycle", "flat"),
    ("traffic_cone", "tipped over"),
    ("trash_bin", "overturned"),
    ("shopping_cart", "tipped over"),
    ("table", "upside down"),
]


def lain(name: str, pose: str) -> AssetConfiguration:
    wanted = requirement(entries_by_name()[name]).model_copy(update={"lies": pose})
    return configure(name, wanted)


@pytest.mark.parametrize(("name", "pose"), LAIN)
def test_a_turned_asset_is_a_whole_one(name: str, pose: str) -> None:
    config = lain(name, pose)
    lying = config.lying
    assert lying is not None and not config.is_wheeled and config.wheels is None
    own = quat_rotate(lying.turned_xyzw, np.eye(3))
    off = min(
        np.degrees(np.arccos(np.clip(sign * own[axis, 2], -1.0, 1.0)))
        for axis, sign in ups(pose, lying.drawn_cm)
    )
    assert off <= poses()[pose].within_deg
    low, high = build_mesh(config).bounds
    assert low[2] == pytest.approx(0.0, abs=1e-6)
    assert high[2] == pytest.approx(config.dimensions_cm[2], rel=0.15, abs=0.5)
    assert np.allclose(low[:2], -high[:2], atol=0.08 * max(config.dimensions_cm) + 0.5)
    assert 0.0 < config.center_of_mass_cm[2] < config.dimensions_cm[2]


@pytest.mark.parametrize("engine", ["physx", "rapier", "newton"])
def test_what_lies_stays_as_it_lies(engine: str) -> None:
    bodies = []
    for k, (name, pose) in enumerate(LAIN):
        config = lain(name, pose)
        at = Pose(position_cm=(1500.0 * (k % 4), 1500.0 * (k // 4), 0.01))
        body = make_body(EMPTY, f"{name}_{k}", Node(asset_id=name), config, at, active=False)
        assert body.turned == config.lying.turned_xyzw  # type: ignore[union-attr]
        bodies.append(body)
    scene = SimScene("s", tuple(bodies))
    batch = batch_programs([Program((), 3.0)], scene.names)
    rollout = get_engine(engine).rollout(scene, batch, dt=1 / 240, ground_contacts=True)
    moved = np.linalg.norm(rollout.position[0, -1] - rollout.position[0, 0], axis=1)
    same = np.abs((rollout.quaternion[0, -1] * rollout.quaternion[0, 0]).sum(axis=1))
    turned = 2 * np.degrees(np.arccos(np.clip(same, 0.0, 1.0)))
    for (name, pose), by, off in zip(LAIN, moved, turned, strict=True):
        assert by < 0.02 and off < 8.0, (name, pose, by, off)


def test_a_lying_thing_grows_as_it_lies() -> None:
    doc = draft("A ball hits a bottle that is lying on its side.")
    (key,) = (k for k, r in doc.asset_requirement.items() if r.lies)
    config = configure(key, doc.asset_requirement[key])
    twice = resized(doc, key, config, 2.0)
    assert twice.lying is not None
    assert np.allclose(twice.dimensions_cm, 2 * np.asarray(config.dimensions_cm), rtol=0.02)


def test_the_bucket_on_its_side_is_open_to_its_front() -> None:
    config = lain("bucket", "on its side")
    (inside,) = (r for r in config.regions if r.kind == "inside")
    # It is heavier at its bottom, which looks back.
    assert config.center_of_mass_cm[0] < -1.0
    assert inside.half_extents_cm[0] > max(inside.half_extents_cm[1:])


def test_manifests_say_how_a_model_is_turned() -> None:
    pose = Pose(position_cm=(0.0, 0.0, 0.0))
    config = lain("bottle", "on its side")
    body = make_body(EMPTY, "b", Node(asset_id="b"), config, pose, active=False)
    other = make_body(EMPTY, "c", Node(asset_id="b"), lain("bottle", "upright"), pose, active=False)
    told = manifest_to_json(SimScene("s", (body, other)), Program((), 1.0), dt=1 / 240)
    assert "turned" not in told["bodies"][1]
    read = manifest_from_json(told).scene.bodies
    assert read[0].turned == body.turned and read[1].turned is None
