"""A liquid bears up what is lighter than it and lets sink what is not, alike in every engine."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import BuoyUp, Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from tests.engines.lab import ball, box

ENGINES = ("physx", "rapier", "newton")
LEVEL = 0.5
BASIN = {"center": (0.0, 0.0, LEVEL), "basin": (1.0, 0.5, 0.25), "heading": 0.3}
DRAG = {"linear_drag": 4.0, "quadratic_drag": 10.0, "turning_drag": 5.0}
G = 9.81


def pool() -> tuple[SimScene, Program]:
    """A light box, a heavy one and a light ball over a basin, and a box beside it."""
    half = (0.05, 0.05, 0.04)
    wood, iron = (
        box(name, half, mass, (x, 0.0, 0.7), restitution=0.0)
        for name, x, mass in (("wood", -0.4, 0.4), ("iron", 0.0, 3.0))
    )
    sphere = ball("ball", 0.05, 0.1, (0.4, 0.0, 0.7))
    aside = box("aside", half, 0.4, (0.0, 2.0, 0.3), restitution=0.0)
    scene = SimScene("pool", (wood, iron, sphere, aside))
    lift = {"wood": 2.0, "aside": 2.0, "iron": 0.25, "ball": 4.0}
    out = tuple(
        BuoyUp(
            b.name, 0.0, math.inf, extents=b.shapes[0].size, lift=lift[b.name] * G,
            round=b.name == "ball", **BASIN, **DRAG,
        )
        for b in scene.bodies
    )  # fmt: skip
    return scene, Program(out, 6.0)


@pytest.mark.parametrize("name", (*ENGINES, "surrogate"))
def test_what_is_light_floats_at_its_waterline_and_what_is_heavy_sinks(name: str) -> None:
    scene, program = pool()
    r = get_engine(name).rollout(scene, batch_programs([program], scene.names), dt=1 / 240)
    end, speed = r.position[0, -1, :, 2], np.linalg.norm(r.linear_velocity[0], axis=-1)
    # Half of the box is in the liquid, a quarter of the ball's volume: u^2 (3 - 2u) = 1/4.
    assert end[0] == pytest.approx(LEVEL, abs=0.002)
    assert end[2] == pytest.approx(LEVEL + 0.05 * (1.0 - 2.0 * 0.32635), abs=0.002)
    assert end[1] == pytest.approx(0.04, abs=0.003)
    assert end[3] == pytest.approx(0.04, abs=0.003)
    assert speed[-1].max() < 0.03
    # What falls in is slower there than it was when it came: 0.41 m/s is its last speed.
    sinking = r.position[0, :, 1, 2] < 0.2
    assert speed[sinking, 1].max() < 0.8
    assert speed[:, 1].max() > 1.5


def test_the_engines_agree_on_it() -> None:
    scene, program = pool()
    batch = batch_programs([program], scene.names)
    found = [get_engine(n).rollout(scene, batch, dt=1 / 240).position[0] for n in ENGINES]
    for other in found[1:]:
        assert np.abs(other - found[0]).max() < 0.015


def test_a_manifest_keeps_it_and_says_what_it_means() -> None:
    scene, program = pool()
    data = json.loads(json.dumps(manifest_to_json(scene, program, dt=1 / 240)))
    assert "buoy" in data["conventions"]
    assert manifest_from_json(data).program == program


def test_a_basin_without_size_is_refused() -> None:
    with pytest.raises(ValueError, match="must be greater than 0"):
        BuoyUp("a", 0.0, 1.0, (0.0, 0.0, 0.0), (1.0, 0.0, 1.0), (1.0, 1.0, 1.0), 2.0)
