"""Brakes slow what stands on something, and tyres hold it to its way, alike in every engine."""

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
from esg.engines.scene import Body, Rollout, SimScene
from esg.engines.traction import features, grounded
from esg.units import quat_from_euler_deg, quat_rotate
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


GRIP = 0.8


def car(name: str, y: float, **more: object) -> Body:
    body = box(name, (2.2, 0.9, 0.6), 1400.0, (0.0, y, 0.6), friction=0.0, restitution=0.0)
    return replace(body, wheeled=True, tyre_friction=GRIP, **more)


def street() -> tuple[SimScene, Program]:
    """Cars shoved to the side, let roll, hit at a corner, thrown and lying; a motorcycle."""
    lying = tuple(quat_from_euler_deg(0.0, 0.0, 90.0).tolist())
    bike = box("bike", (1.0, 0.06, 0.5), 200.0, (0.0, 120.0, 0.5), friction=0.0, restitution=0.0)
    two_wheels = {"wheeled": True, "tyre_friction": GRIP, "tyre_drop": 0.5, "tyre_foot": 0.06}
    turned = tuple(quat_from_euler_deg(30.0, 0.0, 0.0).tolist())
    bodies = (
        car("at 2", 0.0),
        car("at 4", 20.0),
        replace(car("at 8", 40.0), quaternion=turned),
        car("rolls", 60.0),
        car("corner", 70.0),
        replace(car("lies", 80.0), quaternion=lying, position=(0.0, 80.0, 0.9)),
        replace(car("flies", 100.0), position=(0.0, 100.0, 60.0)),
        replace(bike, **two_wheels),
        replace(car("driven", 140.0)),
        replace(box("wall", (0.1, 2.0, 1.0), 1.0, (4.0, 160.0, 1.0)), static=True),
        *(
            replace(bike, name=n, position=(0.0, y, 0.5), **two_wheels)
            for n, y in (("rider", 160.2), ("taps", 159.0))
        ),
    )  # fmt: skip
    side = np.array(quat_rotate(turned, (0.0, -8.0, 0.0))).tolist()
    program = Program(
        (
            SetVelocity("at 2", 0.1, (0.0, 2.0, 0.0)),
            SetVelocity("at 4", 0.1, (0.0, -4.0, 0.0)),
            SetVelocity("at 8", 0.1, (side[0], side[1], 0.0)),
            SetVelocity("rolls", 0.1, (8.0, 0.0, 0.0)),
            SetVelocity("corner", 0.1, (0.0, 2.0, 0.0), (0.0, 0.0, 2.5)),
            SetVelocity("lies", 0.1, (0.0, 4.0, 0.0)),
            SetVelocity("flies", 0.1, (0.0, 4.0, 0.0)),
            SetVelocity("bike", 0.1, (0.0, 3.0, 0.0)),
            HoldVelocity("driven", 0.0, 2.0, 3.0, 1.2),
            HoldVelocity("rider", 0.0, math.inf, 5.0, 0.0, until_contact=("wall",)),
            SetVelocity("taps", 0.1, (-0.5, 0.0, 0.0)),
        ),
        2.0,
    )
    return SimScene("street", bodies), program


def without_tyres(scene: SimScene) -> SimScene:
    return scene.with_bodies(tuple(replace(b, tyre_friction=0.0) for b in scene.bodies))


def tilts(rollout: Rollout, body: int) -> np.ndarray:
    """Degrees from upright, shape [T]."""
    turned = quat_rotate(rollout.quaternion[0, :, body].astype(float), np.array([0.0, 0.0, 1.0]))
    return np.degrees(np.arccos(np.clip(turned[:, 2], -1.0, 1.0)))


@pytest.fixture(scope="module")
def streets() -> dict[str, tuple[SimScene, Rollout, Rollout]]:
    """The street in every engine, and the same street without tyres."""
    scene, program = street()
    batch = batch_programs([program], scene.names)
    return {
        name: (
            scene,
            get_engine(name).rollout(scene, batch),
            get_engine(name).rollout(without_tyres(scene), batch),
        )
        for name in EVERYWHERE
    }


@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_car_shoved_sideways_stops_as_tyres_stop_it(streets, name: str) -> None:
    scene, held, free = streets[name]
    for body, speed in (("at 2", 2.0), ("at 4", 4.0), ("at 8", 8.0)):
        i = scene.index(body)
        way = np.linalg.norm(held.position[0, -1, i] - held.position[0, 0, i])
        assert way == pytest.approx(speed**2 / (2 * 0.8 * 9.81), rel=0.05), body
        assert np.linalg.norm(held.linear_velocity[0, -1, i]) < 0.02
        assert tilts(held, i).max() < 2.0
        gone = np.linalg.norm(free.position[0, -1, i] - free.position[0, 0, i])
        assert gone == pytest.approx(1.9 * speed, rel=0.01)


@pytest.mark.parametrize("name", EVERYWHERE)
def test_tyres_leave_alone_what_rolls_lies_flies_or_is_driven(streets, name: str) -> None:
    scene, held, free = streets[name]
    for body in ("rolls", "lies", "flies", "driven"):
        i = scene.index(body)
        np.testing.assert_allclose(held.position[0, :, i], free.position[0, :, i], atol=2e-3)
    assert held.position[0, -1, scene.index("driven"), 1] > 140.0 + 5.0


@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_car_hit_at_its_corner_does_not_spin_on(streets, name: str) -> None:
    scene, held, free = streets[name]
    i = scene.index("corner")
    assert np.abs(held.angular_velocity[0, -1, i, 2]) < 0.02
    turn = [
        math.degrees(2 * math.atan2(r.quaternion[0, -1, i, 2], r.quaternion[0, -1, i, 3]))
        for r in (held, free)
    ]
    # Each axle slides at 2 +- 2.5 k; the faster one stops after (2 + 2.5 k) / (mu g).
    assert 15.0 < turn[0] < 60.0 < turn[1]


@pytest.mark.parametrize("name", EVERYWHERE)
def test_what_has_two_wheels_falls_where_a_car_slides(streets, name: str) -> None:
    scene, held, free = streets[name]
    i = scene.index("bike")
    assert tilts(held, i)[-1] > 75.0
    assert tilts(free, i).max() < 5.0


@pytest.mark.parametrize("name", EVERYWHERE)
def test_who_rides_into_a_wall_falls_over(streets, name: str) -> None:
    scene, held, free = streets[name]
    i = scene.index("rider")
    assert tilts(held, i)[-1] > 75.0 and tilts(held, i)[round(0.5 / DT)] < 2.0
    assert tilts(free, i)[-1] < 30.0
    assert tilts(held, scene.index("taps")).max() < 2.0


@pytest.mark.parametrize("name", EVERYWHERE)
def test_who_loses_his_balance_falls_by_himself(name: str) -> None:
    """The blow turns him up to the edge of his foot; from there on he gains what he falls."""
    bike = box("bike", (0.9, 0.13, 0.43), 14.0, (0.0, 0.0, 0.43), friction=0.0, restitution=0.0)
    bike = replace(bike, wheeled=True, tyre_friction=GRIP, tyre_drop=0.43, tyre_foot=0.13)
    wall = box("wall", (0.1, 2.0, 1.0), 1.0, (3.0, 0.3, 1.0), friction=0.0, restitution=0.0)
    wall = replace(wall, static=True)
    drive = HoldVelocity("bike", 0.0, math.inf, 5.0, 0.0, until_contact=("wall",))
    scene = SimScene("blow", (bike, wall))
    r = get_engine(name).rollout(scene, batch_programs([Program((drive,), 2.0)], scene.names))
    v, w = r.linear_velocity[0, :, 0].astype(float), r.angular_velocity[0, :, 0].astype(float)
    inverse = r.quaternion[0, :, 0] * np.array([-1.0, -1.0, -1.0, 1.0])
    w = quat_rotate(inverse.astype(float), w)
    energy = 0.5 * 14.0 * (v**2).sum(axis=1) + 14.0 * 9.81 * r.position[0, :, 0, 2]
    energy += 0.5 * np.einsum("ti,ij,tj->t", w, np.array(bike.inertia), w)
    hit = int(np.argmax(v[:, 0] < 2.5)) + 3
    falls = energy[hit : int(np.argmax(tilts(r, 0) > 45.0))]
    assert tilts(r, 0)[-1] > 75.0
    assert len(falls) > 40 and (falls - np.minimum.accumulate(falls)).max() < 0.05


def test_one_street_is_the_same_in_every_engine(streets) -> None:
    scene, physx, _ = streets["physx"]
    one = [scene.index(n) for n in ("at 2", "at 4", "at 8", "rolls", "corner")]
    for name in EVERYWHERE:
        other = streets[name][1]
        apart = np.abs(other.position[0, -1, one] - physx.position[0, -1, one]).max()
        assert apart < 0.02, name


def test_brakes_and_tyres_together_give_no_more_than_the_tyres() -> None:
    """A circle of friction: what brakes take is not there for the side."""
    row = features(SimScene("one", (car("car", 0.0),)))[0].tolist()
    still = (0.0, 0.0, 0.0, 1.0)
    mu_g_dt = GRIP * 9.81 * DT
    for share in (0.0, 0.3, 0.8, 1.0, 1.5):
        v, _ = grounded(row, share * mu_g_dt, 9.81 * DT, [5.0, 1.0, 0.0], [0.0] * 3, still)
        lost = math.hypot(5.0 - v[0], 1.0 - v[1])
        assert lost <= max(1.0, share) * mu_g_dt * 1.2
    v, o = grounded(row, 0.0, 9.81 * DT, [5.0, 0.01, 0.0], [0.0] * 3, still)
    assert v == pytest.approx([5.0, 0.0, 0.0]) and o == pytest.approx([0.0] * 3)


def test_only_scenes_with_tyres_speak_of_them() -> None:
    scene, program = street()
    data = manifest_to_json(scene, program, dt=DT)
    assert "tyres" in data["conventions"] and data["bodies"][0]["tyre_friction"] == GRIP
    assert manifest_from_json(data).scene.bodies == scene.bodies
    plain = manifest_to_json(without_tyres(scene), program, dt=DT)
    assert "tyres" not in plain["conventions"] and "tyre_friction" not in plain["bodies"][0]


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
