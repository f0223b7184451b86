"""Postures in scenes from a prompt: bodies of their size, when they change, and where they end."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import optimize
from esg.dynamics.plan import build_scene
from esg.engines.program import ChangeBody, Program, program_from_json
from esg.engines.scene import SimScene
from esg.layout import solve


def _made(prompt: str) -> tuple[SimScene, Program]:
    doc = optimize(solve(resolve(draft(prompt))), strategy="none")
    assert doc.dynamics_result is not None
    return build_scene(doc), program_from_json(doc.dynamics_result.program)


def _changes(program: Program) -> list[ChangeBody]:
    return [p for p in program.primitives if isinstance(p, ChangeBody)]


def test_who_sits_at_first_does_so_from_the_first_frame_on() -> None:
    scene, program = _made("A dog sits quietly.")
    (change,) = _changes(program)
    assert (change.body, change.time, change.into) == ("dog_1", 0.0, "dog_1_sits")
    dog, sits = scene.body("dog_1"), scene.body("dog_1_sits")
    assert sits.mass == dog.mass
    low = [b.position[2] + b.origin_offset[2] for b in (dog, sits)]
    assert low == pytest.approx([0.0, 0.0], abs=0.005)


def test_who_lies_down_comes_to_a_halt_first() -> None:
    scene, program = _made("A dog runs, then it stops and lies down.")
    (change,) = _changes(program)
    brakes = [p.time for p in program.primitives if getattr(p, "braking", None)]
    assert brakes and max(brakes) < change.time
    assert scene.body("dog_1_lies").half_extents[2] < 0.6 * scene.body("dog_1").half_extents[2]


def test_who_gets_up_from_a_chair_stands_before_it() -> None:
    scene, program = _made("A man is sitting in a chair, then he stands up.")
    first, up = _changes(program)
    assert (first.into, up.into) == ("man_1_sits_on", "man_1")
    assert up.position is not None
    man, chair = scene.body("man_1"), scene.body("chair_1")
    away = [abs(a - b) for a, b in zip(up.position[:2], chair.position[:2], strict=True)]
    assert max(away) > max(chair.half_extents[:2])
    assert up.position[2] + man.origin_offset[2] == pytest.approx(0.0, abs=1e-6)
