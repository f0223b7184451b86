"""The exported USD in NVIDIA's PhysX, played by docs/play_usd.py: the nightly job runs this.

`ovphysx` asks for other versions than the tests do, so it has an environment of its own:

    python -m venv ov && ov/bin/pip install -e '.[ovphysx]'
    ESG_OVPHYSX_PYTHON=ov/bin/python pytest -m slow tests/compile/test_ovphysx.py
"""

from __future__ import annotations

from dataclasses import replace
import importlib.util
import math
import os
from pathlib import Path
import subprocess
import sys

import numpy as np
import pytest
import scenes
from usd import PLAYER, usd_of

from esg.engines.program import (
    AdjustProperties,
    ApplyImpulse,
    GuideAlong,
    HoldSpin,
    HoldVelocity,
    Program,
    SetVelocity,
    batch_programs,
)
from esg.engines.registry import get_engine
from esg.engines.rollout_file import load_rollout
from esg.engines.scene import Rollout, SimScene

PYTHON = os.environ.get("ESG_OVPHYSX_PYTHON", "")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        not PYTHON and importlib.util.find_spec("ovphysx") is None,
        reason="no ovphysx: ESG_OVPHYSX_PYTHON names the interpreter that has it",
    ),
]
LYING = (0.5, 0.5, 0.5, 0.5)


def played(usd: Path, *flags: str) -> Rollout:
    record = usd.with_suffix(".npz")
    subprocess.run(
        [PYTHON or sys.executable, str(PLAYER), str(usd), "--record", str(record), *flags],
        check=True, capture_output=True,
    )  # fmt: skip
    return load_rollout(record)


def free(name: str, y: float, **more: object) -> object:
    """A box high above the ground that nothing touches."""
    more = {"quaternion": LYING, "linear_damping": 0.2, "angular_damping": 0.3} | more
    return replace(scenes.box(name, (0.0, y, 40.0), (0.3, 0.2, 0.1), 4.0), **more)  # type: ignore[arg-type]


def test_a_lying_body_starts_as_it_does_everywhere_because_the_file_says_local(
    tmp_path: Path,
) -> None:
    scene = SimScene("flag", (free("box", 0.0, linear_damping=0.0, angular_damping=0.0),))
    program = Program((SetVelocity("box", 0.0, (3.0, -1.0, 2.0), (0.5, 1.0, -2.0)),), 0.1)
    usd = usd_of(tmp_path, scene, program)
    start = played(usd, "--no-program")
    np.testing.assert_allclose(start.linear_velocity[0, 0, 0], (3.0, -1.0, 2.0), atol=1e-5)
    np.testing.assert_allclose(start.angular_velocity[0, 0, 0], (0.5, 1.0, -2.0), atol=1e-5)
    unsaid = tmp_path / "unsaid.usda"
    text = usd.read_text()
    assert text.count("bool localSpaceVelocities = 1") == 1
    unsaid.write_text(text.replace("bool localSpaceVelocities = 1", ""))
    wrong = played(unsaid, "--no-program").linear_velocity[0, 0, 0]
    assert np.abs(wrong - (3.0, -1.0, 2.0)).max() > 1.0


def test_every_command_moves_a_free_body_as_in_physx(tmp_path: Path) -> None:
    """What no contact disturbs is within a millimetre of the engine that proves the scenes."""
    path = ((0.0, 15.0, 40.0), (1.0, 15.5, 40.5), (2.0, 15.0, 41.0))
    program = Program(
        (
            SetVelocity("set", 0.0, (3.0, -1.0, 2.0), (0.5, 1.0, -2.0)),
            SetVelocity("set", 0.3, (-1.0, 1.0, 0.0)),
            ApplyImpulse("pushed", 0.2, (4.0, 8.0, -2.0)),
            SetVelocity("damped", 0.0, (5.0, 0.0, 0.0), (0.0, 3.0, 0.0)),
            AdjustProperties("damped", 0.4, linear_damping=4.0, angular_damping=2.0, friction=0.9),
            HoldVelocity("flown", 0.1, 0.8, 3.0, 0.5, 1.0, 5.0, 0.4, climb=0.5),
            GuideAlong("guided", 0.1, (0.0, 0.4, 0.9), path, ((1.0, 0.0, 1.0),) * 3, 0.3),
            HoldSpin("spun", 0.1, 0.7, 5.0, (0.0, 1.0, 2.0)),
        ),
        1.0,
    )
    names = ("set", "pushed", "damped", "flown", "guided", "spun")
    scene = SimScene("free", tuple(free(n, 3.0 * i) for i, n in enumerate(names)))
    rollout = played(usd_of(tmp_path, scene, program))
    batch = batch_programs([program], scene.names)
    ours = get_engine("physx").rollout(scene, batch, dt=1 / 240)
    assert np.abs(rollout.position - ours.position).max() < 1e-3
    assert np.abs(rollout.linear_velocity[0, 1:] - ours.linear_velocity[0, 1:]).max() < 5e-3
    turned = np.abs(np.einsum("tbi,tbi->tb", rollout.quaternion[0], ours.quaternion[0]))
    assert np.degrees(2.0 * np.arccos(np.minimum(turned, 1.0))).max() < 0.5


def test_brakes_and_wheels_stop_where_the_formulas_say(tmp_path: Path) -> None:
    """v^2 / (2 b) with brakes; a coasting car sees the vehicles' ground and not the bodies'."""
    sledge = replace(scenes.box("sledge", (0.0, 0.0, 0.1), (0.3, 0.2, 0.1), 4.0), friction=0.0)
    car = replace(
        scenes.box("car", (0.0, 5.0, 0.5), (2.0, 0.8, 0.5), 900.0), friction=0.1, wheeled=True
    )
    crate = replace(scenes.box("crate", (0.0, 10.0, 0.1), (0.3, 0.2, 0.1), 4.0), friction=0.3)
    program = Program(
        (
            SetVelocity("sledge", 0.0, (4.0, 0.0, 0.0)),
            AdjustProperties("sledge", 0.0, braking=8.0),
            SetVelocity("car", 0.0, (4.0, 0.0, 0.0)),
            SetVelocity("crate", 0.0, (4.0, 0.0, 0.0)),
        ),
        2.0,
    )
    scene = SimScene("stop", (sledge, car, crate), ground_friction=0.0, vehicle_ground_friction=0.0)
    assert played(usd_of(tmp_path, scene, program)).position[0, -1, 0, 0] == pytest.approx(
        1.0, abs=0.02
    )
    rough = replace(scene, ground_friction=0.7)
    rollout = played(usd_of(tmp_path, rough, program))
    slid = rollout.position[0, -1, 2, 0]
    assert slid == pytest.approx(16.0 / (2 * 0.5 * 9.81), rel=0.03)
    coasts = 4.0 - 0.05 * 9.81 * 2.0
    assert rollout.linear_velocity[0, -1, 1, 0] == pytest.approx(coasts, abs=0.05)


def test_tyres_and_brakes_act_as_in_physx(tmp_path: Path) -> None:
    """A car and a motorcycle thrown sideways, a ball that brakes: within a centimetre after 1.5 s."""
    car = scenes.box("car", (0.0, 0.0, 0.5), (2.0, 0.8, 0.5), 900.0, 0.3)
    cycle = scenes.box("cycle", (0.0, 8.0, 0.5), (1.0, 0.2, 0.5), 80.0, 0.3)
    grip = {"friction": 0.1, "wheeled": True, "tyre_friction": 0.8}
    bodies = (
        replace(car, **grip),
        replace(cycle, **grip, tyre_drop=0.4),
        scenes.ball("ball", (0.0, 16.0, 0.1), 0.1, 1.0),
    )
    program = Program(
        (
            SetVelocity("car", 0.0, (3.0, 5.0, 0.0), (0.0, 0.0, 1.0)),
            SetVelocity("cycle", 0.0, (3.0, 2.0, 0.0)),
            SetVelocity("ball", 0.0, (3.0, 0.0, 0.0), (0.0, 30.0, 0.0)),
            AdjustProperties("car", 0.4, braking=5.0),
            AdjustProperties("ball", 0.2, braking=2.0),
        ),
        1.5,
    )
    scene = SimScene("tyres", bodies, vehicle_ground_friction=0.0)
    rollout = played(usd_of(tmp_path, scene, program))
    batch = batch_programs([program], scene.names)
    ours = get_engine("physx").rollout(scene, batch, dt=1 / 240)
    assert np.abs(rollout.position - ours.position).max() < 0.01
    loose = played(usd_of(tmp_path, scene, program), "--no-program").position[0, -1, 0, 1]
    assert loose > ours.position[0, -1, 0, 1] + 2.0


def test_oblique_bounces_have_the_friction_of_the_formula(tmp_path: Path) -> None:
    """Tangential: mu (1 + e) v_n, or 2/7 of the speed where the ball grips."""
    rng = np.random.default_rng(0)
    balls, throws = [], []
    for i in range(24):
        speed, down = rng.uniform(2.0, 12.0), math.radians(rng.uniform(20.0, 60.0))
        ball = scenes.ball(f"ball {i}", (0.0, 3.0 * i, rng.uniform(0.3, 1.5)), 0.1, 1.0)
        mu, e = rng.uniform(0.1, 0.6), rng.uniform(0.2, 0.8)
        balls.append(
            replace(ball, friction=mu, restitution=e, linear_damping=0.0, angular_damping=0.0)
        )
        throws.append(
            SetVelocity(ball.name, 0.0, (speed * math.cos(down), 0.0, -speed * math.sin(down)))
        )
    scene = SimScene("bounce", tuple(balls))
    v = played(usd_of(tmp_path, scene, Program(tuple(throws), 1.0))).linear_velocity[0]
    for i, ball in enumerate(balls):
        k = int(np.argmax(v[1:, i, 2] > v[:-1, i, 2] + 0.3))
        before, after = v[k, i].astype(float), v[k + 2, i].astype(float)
        mu = (ball.friction + scene.ground_friction) / 2
        e = (ball.restitution + scene.ground_restitution) / 2
        lost = min(mu * (1 + e) * -before[2], before[0] * 2 / 7)
        assert before[0] - after[0] == pytest.approx(lost, rel=0.02)
        assert after[2] + 9.81 / 240 == pytest.approx(-e * (before[2] - 9.81 / 240), rel=0.03)


def test_the_papers_scenes_happen(tmp_path: Path) -> None:
    """With their program as often as in the engine that proved them; without it all that needs none."""
    from benchmarks.usd_player import measure
    from esg.metrics import load_suite

    root = Path(__file__).parents[2]
    suite = root / "data" / "suites" / "paper.yaml"
    subprocess.run(
        [sys.executable, "-m", "esg", "bench", str(suite), "--runs", "1", "--out", str(tmp_path)],
        check=True, cwd=root, capture_output=True,
    )  # fmt: skip
    found = measure(tmp_path, load_suite(suite), PYTHON or sys.executable)
    assert len(found) == 10 and sum(len(s.reference) for s in found) == 18
    for scene in found:
        assert scene.program == dict.fromkeys(scene.reference, True), scene.scene
        free = [i for i, needs in scene.needs_command.items() if not needs]
        assert all(scene.still[i] for i in free), scene.scene
