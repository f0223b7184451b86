"""Brakes slow what stands on something, alike in every engine."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.engines import ENGINES, get_engine
from esg.engines.executor import Executor
from esg.engines.manifest import manifest_from_json, manifest_to_json
from esg.engines.program import (
    AdjustProperties,
    HoldVelocity,
    Program,
    SetVelocity,
    batch_programs,
    program_from_json,
    program_to_json,
)
from esg.engines.scene import SimScene
from esg.engines.traction import features
from tests.engines.lab import ball, box
from tests.engines.test_program import Points

EVERYWHERE = (*ENGINES, "surrogate")
DT = 1.0 / 240.0


def braking() -> tuple[SimScene, Program]:
    """A sledge and a ball brake after a second, a stone in the air does not; one is let go."""
    scene = SimScene(
        "brakes",
        (
            box("sledge", (0.5, 0.4, 0.2), 30.0, (0.0, 0.0, 0.2), friction=0.0, restitution=0.0),
            ball("ball", 0.2, 3.0, (0.0, 4.0, 0.2), friction=0.6, restitution=0.0),
            ball("stone", 0.1, 1.0, (0.0, 8.0, 30.0)),
            box("driven", (0.5, 0.4, 0.2), 30.0, (0.0, 12.0, 0.2), friction=0.0, restitution=0.0),
        ),
        ground_friction=0.0,
    )
    program = Program(
        (
            SetVelocity("sledge", 0.0, (3.0, 4.0, 0.0)),
            SetVelocity("ball", 0.0, (2.0, 0.0, 0.0), (0.0, 10.0, 0.0)),
            SetVelocity("stone", 0.0, (5.0, 0.0, 0.0)),
            HoldVelocity("driven", 0.0, 1.0, 4.0, 0.0),
            AdjustProperties("driven", 0.5, braking=6.0),
            AdjustProperties("sledge", 1.0, braking=4.0),
            AdjustProperties("ball", 1.0, braking=1.5),
            AdjustProperties("stone", 1.0, braking=4.0),
            AdjustProperties("sledge", 1.5, braking=0.0),
        ),
        2.0,
    )
    return scene, program


@pytest.mark.parametrize("dt", [1 / 240, 1 / 120])
@pytest.mark.parametrize("name", EVERYWHERE)
def test_brakes_slow_what_is_carried_at_their_rate(name: str, dt: float) -> None:
    scene, program = braking()
    r = get_engine(name).rollout(scene, batch_programs([program], scene.names), dt=dt)
    v, spin = r.linear_velocity[0], r.angular_velocity[0]
    at = [round(t / dt) for t in (1.0, 1.25, 1.5, 2.0)]
    sledge = np.hypot(v[:, 0, 0], v[:, 0, 1])
    # Against where it goes, and no more once the brakes are off.
    np.testing.assert_allclose(sledge[at], (5.0, 4.0, 3.0, 3.0), atol=4.0 * dt + 0.01)
    np.testing.assert_allclose(v[at, 0, 1] / sledge[at], 0.8, atol=2e-3)
    # A ball that brakes goes on rolling.
    np.testing.assert_allclose(v[at, 1, 0], (2.0, 1.625, 1.25, 0.5), atol=0.02)
    np.testing.assert_allclose(spin[at, 1, 1] * 0.2, v[at, 1, 0], atol=0.02)
    np.testing.assert_allclose(v[at, 2, 0], 5.0, atol=1e-3)
    # Who drives does not brake; afterwards it stops for good.
    np.testing.assert_allclose(v[at, 3, 0], (4.0, 2.5, 1.0, 0.0), atol=6.0 * dt + 0.01)
    stopped = r.position[0, round(1.7 / dt) :, 3, 0]
    assert stopped[-1] == pytest.approx(4.0 + 16.0 / 12.0, abs=0.03)
    assert np.ptp(stopped) < 1e-4


def test_a_body_that_falls_is_not_braked_until_it_lands() -> None:
    program = Program((AdjustProperties("a", 0.0, braking=2.0),), 1.0)
    points, executor = Points([1.0] * 3), Executor(batch_programs([program], ("a",)), 0, -9.81)
    kept = []
    for step, rise in enumerate((0.0, 0.0, -9.81 * DT, -2 * 9.81 * DT, 0.0)):
        points.v[0] = (1.0, 0.0, rise)
        executor.before_step(step * DT, DT, (), points)
        kept.append(points.v[0, 0])
    slow = 1.0 - 2.0 * DT
    np.testing.assert_allclose(kept, (slow, slow, 1.0, 1.0, slow))


def test_only_programs_that_brake_speak_of_it() -> None:
    scene, program = braking()
    assert program_from_json(program_to_json(program)) == program
    data = manifest_to_json(scene, program, dt=DT)
    assert "braking" in data["conventions"]
    assert manifest_from_json(data).program == program
    plain = Program((AdjustProperties("ball", 0.5, 1.0, None, 0.3),), 1.0)
    data = manifest_to_json(scene, plain, dt=DT)
    assert "braking" not in data["conventions"]
    assert "braking" not in data["program"]["primitives"][0]


def test_what_stays_put_has_no_features() -> None:
    scene, _ = braking()
    rows = features(scene)
    assert rows[:, 0].tolist() == [0.0, 1.0, 1.0, 0.0]
    wall = replace(box("wall", (1, 1, 1), 1.0, (0, 0, 1)), static=True)
    fixed = SimScene("fixed", (wall,))
    assert math.isnan(features(fixed)[0, 0])
    brake = Program((AdjustProperties("wall", 0.0, braking=1.0),), 0.1)
    for name in ENGINES:
        assert get_engine(name).rollout(fixed, batch_programs([brake], fixed.names)).valid.all()
