"""Every change touches its variable and nothing else; what cannot be changed says why."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
import math
from typing import Any

import numpy as np
import pytest

from esg.dataset.whatifs.amounts import VARIABLES, amounts, picked
from esg.dataset.whatifs.replaying import play
from esg.dataset.whatifs.worlds import (
    NotApplicable,
    Part,
    World,
    changed,
    changed_by,
    start_speeds,
    unchanged,
)
from esg.engines.manifest import manifest_to_json
from esg.engines.program import (
    AdjustProperties,
    GuideAlong,
    HoldVelocity,
    Primitive,
    Program,
    SetVelocity,
)
from esg.engines.scene import Region, SimScene
from tests.metrics.worlds import DT, ball, body

ROLL = SetVelocity("ball_1", 0.0, (2.0, 0.0, 0.0), (0.0, 20.0, 0.0))
BRAKE = AdjustProperties("ball_2", 0.5, braking=4.0)


def part(*primitives: Primitive, seed: str = "s/0") -> Part:
    """A ball that rolls at another, beside a bin with a region."""
    bodies = (
        ball("ball_1", position=(0.0, 0.0, 0.1)),
        ball("ball_2", position=(0.6, 0.0, 0.1)),
        body("bin_1", position=(2.0, 0.0, 0.1), static=True),
    )
    region = Region("bin_1/inside", "bin_1", (0.0, 0.0, 0.0), (0.1, 0.1, 0.1), "inside")
    scene = SimScene("s", bodies, (region,))
    program = Program(primitives or (ROLL, BRAKE), 1.0)
    return Part(scene, program, ("ball_1", "ball_2"), seed)


def differences(a: Any, b: Any, at: str = "") -> list[str]:
    """Places in which two JSON values differ."""
    if isinstance(a, dict) and isinstance(b, dict):
        keys = sorted({*a, *b})
        return [d for k in keys for d in differences(a.get(k), b.get(k), f"{at}/{k}")]
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        return [d for k, (x, y) in enumerate(zip(a, b, strict=True))
                for d in differences(x, y, f"{at}/{k}")]  # fmt: skip
    same = a == b or (isinstance(a, float) and isinstance(b, float) and math.isclose(a, b))
    return [] if same else [at]


def manifest(world: World) -> dict[str, Any]:
    return manifest_to_json(world.scene, world.program, dt=DT)


def changes(world: World, of: Part) -> set[str]:
    return set(differences(manifest(unchanged(of.scene, of.program)), manifest(world)))


def test_every_amount_has_words_and_a_source() -> None:
    assert tuple(amounts()) == VARIABLES
    assert all(row.words and row.source for found in amounts().values() for row in found)


@pytest.mark.parametrize("amount", amounts()["mass"], ids=lambda a: a.amount)
def test_mass_is_a_factor_of_one_body_alone(amount: Any) -> None:
    world = changed_by(part(), amount)
    assert changes(world, part()) == set() and world.friction_scale == 1.0
    assert world.after == world.mass_scale * (world.before or 0.0) and world.unit == "kg"


def test_friction_is_everybodys_and_the_brakes() -> None:
    world = changed_by(part(), amounts()["friction"][0])
    assert world.friction_scale == 0.25 and world.mass_scale == 1.0
    assert changes(world, part()) == {"/program/primitives/1/braking"}
    assert world.program.primitives[1].braking == 1.0  # type: ignore[union-attr]


def test_gravity_is_gravity_and_the_brakes() -> None:
    moon = next(a for a in amounts()["gravity"] if a.amount == "Moon")
    world = changed_by(part(), moon)
    assert changes(world, part()) == {"/gravity/2", "/program/primitives/1/braking"}
    assert world.scene.gravity[2] == -1.6


def test_speed_is_that_of_one_body_with_its_roll() -> None:
    half = amounts()["speed"][0]
    world = changed_by(part(), half)
    assert world.body == "ball_1" and (world.before, world.after) == (2.0, 1.0)
    assert changes(world, part()) == {
        "/program/primitives/0/linear/0", "/program/primitives/0/angular/1"
    }  # fmt: skip
    assert world.duration == 2.0  # there is time for what comes later


def test_a_guided_path_at_half_the_speed_is_the_same_path() -> None:
    guide = GuideAlong("ball_1", 0.0, (0.0, 1.0), ((0.0, 0.0, 0.1), (1.0, 0.0, 0.1)),
                       ((1.0, 0.0, 0.0), (1.0, 0.0, 0.0)))  # fmt: skip
    world = changed_by(part(guide), amounts()["speed"][0])
    (slow,) = world.program.primitives
    assert isinstance(slow, GuideAlong) and slow.points == guide.points
    assert slow.at(1.0) == pytest.approx(guide.at(0.5))


def test_direction_turns_the_start_of_one_body() -> None:
    left = amounts()["direction"][0]
    world = changed_by(part(), left)
    first = world.program.primitives[0]
    assert isinstance(first, SetVelocity) and first.angular is not None
    assert first.linear == pytest.approx((0.0, 2.0, 0.0))
    # It rolls on: the spin turns with the way.
    assert first.angular == pytest.approx((-20.0, 0.0, 0.0))
    found = {d.rsplit("/", 1)[0] for d in changes(world, part())}
    assert found == {
        "/bodies/0/quaternion", "/program/primitives/0/linear", "/program/primitives/0/angular"
    }  # fmt: skip
    assert (world.before, world.after) == (0.0, 90.0)


def test_a_removed_body_keeps_its_number_and_touches_nothing() -> None:
    world = changed(part(ROLL), "remove")
    assert world.body == "ball_2" and world.scene.names == part().scene.names
    taken = world.scene.body("ball_2")
    assert not taken.collides and taken.position == part().scene.body("ball_2").position
    assert changes(world, part(ROLL)) - {"/effective_pairs"} == {
        "/bodies/1/shapes", "/bodies/1/static"
    }  # fmt: skip


def test_what_is_driven_is_not_removed_nor_what_takes_no_part() -> None:
    with pytest.raises(NotApplicable, match="moves by itself"):
        changed(part(), "remove")  # both balls are in the program
    assert changed(replace(part(ROLL), part=("ball_1", "bin_1")), "remove").body == "bin_1"
    assert not changed(replace(part(ROLL), part=("bin_1",)), "remove").scene.regions


def test_what_has_no_speed_and_what_needs_its_grip_say_so() -> None:
    still = SetVelocity("ball_1", 0.0, (0.0, 0.0, 0.0))
    for variable in ("speed", "direction"):
        with pytest.raises(NotApplicable):
            changed(part(still), variable)  # type: ignore[arg-type]
    turning = HoldVelocity("ball_1", 0.0, 1.0, 2.0, 0.0, turn_rate=0.5)
    with pytest.raises(NotApplicable, match="grip"):
        changed_by(part(turning), amounts()["friction"][0])
    jupiter = next(a for a in amounts()["gravity"] if a.amount == "Jupiter")
    assert changed_by(part(turning), jupiter).after == 23.1


def test_start_speeds_are_those_of_the_program() -> None:
    hold = HoldVelocity("ball_2", 0.0, 1.0, 3.0, math.pi / 2)
    found = start_speeds(part().scene, Program((ROLL, hold), 1.0))
    assert found["ball_1"] == (2.0, 0.0, 0.0)
    assert found["ball_2"] == pytest.approx((0.0, 3.0, 0.0))


def test_choices_are_the_seeds() -> None:
    drawn = Counter(changed(part(seed=f"s{k}/0"), "mass").amount for k in range(40))
    assert set(drawn) == {"four times", "a quarter"}
    assert picked("abc", "x", 1) == picked("abc", "x", 1)


@pytest.mark.parametrize("engine", ["physx", "rapier"])
def test_no_world_sees_the_others(engine: str) -> None:
    """The unchanged scene is the same alone and in company, and equals the changed one undone."""
    base = unchanged(part().scene, part().program)
    names = ("mass", "friction", "speed", "gravity", "direction")
    others = [changed(part(), name) for name in names]  # type: ignore[arg-type]
    together, alone = play([base, *others], engine, DT), play([base], engine, DT)
    assert all(p.sound for p in together)
    one, two = together[0].rollout, alone[0].rollout
    assert one is not None and two is not None
    assert np.array_equal(one.position[together[0].number], two.position[0])
    heavy = together[1].rollout
    assert heavy is not None
    assert not np.array_equal(heavy.position[together[1].number, -1], two.position[0, -1])


def test_an_engine_that_refuses_costs_its_own_rows(monkeypatch: pytest.MonkeyPatch) -> None:
    class Refusing:
        def rollout(self, *args: object, **more: object) -> None:
            raise ValueError("no joints here")

    monkeypatch.setattr("esg.dataset.whatifs.replaying.get_engine", lambda name: Refusing())
    (found,) = play([unchanged(part().scene, part().program)], "physx", DT)
    assert found.rollout is None and not found.sound and "no joints here" in found.reason
