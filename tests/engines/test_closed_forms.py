"""Textbook motions (`benchmarks.analytic`), and how deep fast bodies are in each other on meeting."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.analytic import HELD_TO_IT, LIMIT, Row, markdown, run, too_far
from esg.engines import get_engine
from esg.engines.physx_substeps import ADVANCE_M, MOST_PARTS, parts
from esg.engines.program import Program, SetVelocity, batch_programs
from esg.engines.scene import Rollout, SimScene
from tests.engines.lab import DT, ball, box


@pytest.mark.parametrize("engine", HELD_TO_IT)
def test_every_closed_form_holds_within_one_percent(engine: str) -> None:
    assert too_far(run((engine,))) == []


def test_what_is_over_the_limit_is_named() -> None:
    row = Row(
        "a fall", "s", (1.0,), {"physx": (1.1,), "rapier": (2.0,)}, {"physx": 0.1, "rapier": 1}
    )
    assert [line.split(" off")[0] for line in too_far([row])] == ["a fall: physx is 10.00%"]
    assert too_far([replace(row, error={"physx": LIMIT})]) == []
    assert len(too_far([replace(row, error={"physx": float("nan")})])) == 1
    assert markdown([row], ("physx",)).splitlines()[-1] == "| a fall | s | 10.00% |"


def play(scene: SimScene, *commands: SetVelocity, duration: float = 1.0) -> Rollout:
    batch = batch_programs([Program(commands, duration)], scene.names)
    return get_engine("physx").rollout(scene, batch, dt=DT)


@pytest.mark.parametrize("speed", [8.0, 15.0, 30.0])
def test_fast_bodies_meet_without_running_into_each_other(speed: float) -> None:
    car = box("car", (2.2, 0.9, 0.7), 1200.0, (-5.0, 0.0, 0.7), wheeled=True, friction=0.1)
    for late in np.linspace(0.0, speed * DT, 4):
        crate = box("crate", (0.3, 0.3, 0.3), 20.0, (float(late), 0.2, 0.3))
        out = play(SimScene("s", (car, crate)), SetVelocity("car", 0.0, (speed, 0.0, 0.0)))
        log = out.contacts
        assert log.depth[log.time == log.time.min()].max() < 1.5 * ADVANCE_M
        assert log.depth.max() < 0.03
        # Restitution 0.2 and friction between them; the crate leaves no slower than the car.
        assert out.linear_velocity[0, -1, 1, 0] > 0.5 * speed


def test_a_small_fast_ball_does_not_pass_through_a_thin_wall() -> None:
    wall = replace(box("wall", (0.02, 3.0, 1.5), 1.0, (2.0, 0.0, 1.5)), static=True)
    scene = SimScene("s", (ball("ball", 0.033, 0.06, (-2.0, 0.0, 1.2)), wall))
    out = play(scene, SetVelocity("ball", 0.0, (40.0, 0.0, 0.0)), duration=0.3)
    assert out.linear_velocity[0, -1, 0, 0] == pytest.approx(-0.2 * 40.0, rel=1e-3)


def test_bodies_that_start_inside_each_other_are_pushed_apart_gently() -> None:
    scene = SimScene(
        "s", tuple(box(n, (0.2, 0.2, 0.2), 5.0, (x, 0, 0.2)) for n, x in (("a", 0.0), ("b", 0.3)))
    )
    out = play(scene)
    assert np.linalg.norm(out.linear_velocity, axis=-1).max() < 4.0


def test_a_step_is_cut_only_where_bodies_would_run_into_each_other() -> None:
    def corners(x: float, z: float = 0.5):
        return (x - 0.5, -0.5, z - 0.5), (x + 0.5, 0.5, z + 0.5)

    def needs(*movers: tuple[float, float, float], at: tuple[float, ...], z: float = 0.5) -> int:
        return parts(list(movers), lambda k: corners(at[k], z), [], DT)

    fast = (24.0, 0.0, 0.0)  # 10 cm a step
    assert needs(fast, (0.0, 0.0, 0.0), at=(0.0, 1.0)) == 10
    assert needs(fast, (0.0, 0.0, 0.0), at=(0.0, 1.05)) == 5
    assert needs(fast, (0.0, 0.0, 0.0), at=(0.0, 1.11)) == 1
    assert needs(fast, fast, at=(0.0, 1.0)) == 1
    assert needs((-24.0, 0.0, 0.0), (0.0, 0.0, 0.0), at=(0.0, 1.0)) == 1
    assert needs((2.0, 0.0, 0.0), (0.0, 0.0, 0.0), at=(0.0, 1.0)) == 1
    # The ground: what falls, not what slides.
    assert needs((0.0, 0.0, -24.0), at=(0.0,)) == 10
    assert needs((24.0, 0.0, 0.0), at=(0.0,)) == 1
    assert needs((0.0, 0.0, -24.0), at=(0.0,), z=0.65) == 1
    assert needs((0.0, 0.0, -4000.0), at=(0.0,)) == MOST_PARTS
    # What is beside a static body along one axis may pass it.
    beside = ((-9.0, 0.5, 0.0), (9.0, 1.0, 1.0))
    assert parts([fast], lambda _: corners(0.0), [beside], DT) == 1
    assert parts([(0.0, 24.0, 0.0)], lambda _: corners(0.0), [beside], DT) == 10
