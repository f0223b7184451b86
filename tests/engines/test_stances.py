"""Bodies that change their posture: which one is there, where, and under whose name."""

from __future__ import annotations

import numpy as np
import pytest

from esg.engines import get_engine
from esg.engines.breaking import hidden
from esg.engines.breaking.stances import stance_problems
from esg.engines.program import (
    AdjustProperties,
    ChangeBody,
    HoldVelocity,
    Program,
    batch_programs,
    redirected,
)
from esg.engines.scene import FRAGMENT, Body, Rollout, Shape, SimScene

HEIGHTS = {"dog": 0.6, "dog_lies": 0.24}
INERTIA = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _box(name: str, height: float, postures: tuple[str, ...] = ()) -> Body:
    half = (0.4, 0.15, 0.5 * height)
    return Body(
        name=name,
        static=False,
        mass=20.0,
        inertia=INERTIA,
        shapes=(Shape("box", half),),
        position=(0.0, 0.0, 0.5 * height),
        half_extents=half,
        postures=postures,
        category=FRAGMENT if name != "dog" else "dog",
    )


def _scene() -> SimScene:
    wall = Body(
        name="wall",
        static=True,
        mass=1.0,
        inertia=INERTIA,
        shapes=(Shape("box", (0.1, 1.0, 0.5)),),
        position=(2.5, 0.0, 0.5),
        half_extents=(0.1, 1.0, 0.5),
    )
    return SimScene("s", (_box("dog", 0.6, ("dog_lies",)), wall, _box("dog_lies", 0.24)))


def _program(again: float = 2.0) -> Program:
    """Runs for 0.5 s, brakes, lies down at 1.2 s, gets up at 2 s and runs into the wall."""
    return Program(
        (
            HoldVelocity("dog", 0.0, 0.5, 1.0, 0.0),
            AdjustProperties("dog", 0.5, braking=4.0),
            ChangeBody("dog", 1.2, "dog_lies"),
            ChangeBody("dog", again, "dog"),
            HoldVelocity("dog", 2.1, 4.0, 2.0, 0.0, until_contact=("wall",)),
        ),
        4.0,
    )


def _played(engine: str) -> tuple[SimScene, Rollout]:
    scene = _scene()
    batch = batch_programs([_program()], scene.names)
    return scene, get_engine(engine).rollout(scene, batch, dt=1 / 240, ground_contacts=True)


@pytest.mark.parametrize("engine", ["physx", "rapier", "newton"])
def test_who_lies_down_is_low_and_keeps_his_name(engine: str) -> None:
    scene, rollout = _played(engine)
    there = ~hidden(scene, rollout.position[0], rollout.quaternion[0])
    assert (there[:, [0, 2]].sum(axis=1) == 1).all()
    lies = (rollout.time > 1.21) & (rollout.time < 1.99)
    assert there[lies, 2].all() and there[~lies & (rollout.time != 2.0), 0][:100].all()
    for k, name in ((0, "dog"), (2, "dog_lies")):
        heights = rollout.position[0, there[:, k], k, 2]
        assert np.abs(heights - 0.5 * HEIGHTS[name]).max() < 0.01
    # Its way goes on without a jump, under its own name.
    steps = np.abs(np.diff(rollout.position[0, :, 0], axis=0)).max()
    assert steps < 0.02
    assert 0.5 < rollout.position[0, lies, 0, 0].mean() < 0.8
    hits = [(int(a), int(b)) for a, b in zip(rollout.contacts.a, rollout.contacts.b, strict=True)]
    assert (0, 1) in hits and not any(2 in pair for pair in hits)
    assert rollout.time[-1] == pytest.approx(4.0)
    assert rollout.position[0, -1, 0, 0] == pytest.approx(2.0, abs=0.05)


def test_engines_agree_on_who_is_there() -> None:
    ways = [_played(engine)[1].position[0, :, 0] for engine in ("physx", "rapier", "newton")]
    for other in ways[1:]:
        assert np.abs(other[:450] - ways[0][:450]).max() < 0.01


def test_what_a_body_is_asked_later_is_asked_of_who_is_there() -> None:
    program = Program((*_program(3.0).primitives,), 4.0)
    held = [p for p in redirected(program, _scene().names) if isinstance(p, HoldVelocity)]
    assert [p.body for p in held] == ["dog", "dog_lies"]
    assert [p.body for p in redirected(program, ("dog", "wall"))] == ["dog"] * 3


def test_a_fixed_body_keeps_its_posture() -> None:
    scene = _scene()
    told = SimScene("s", (_box("dog", 0.6, ("wall", "nobody")), *scene.bodies[1:]))
    assert stance_problems(told) == [
        "/bodies/0/postures: ['nobody', 'wall'] cannot be; name bodies that move and collide"
    ]
