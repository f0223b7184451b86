"""Recordings last until all has come to rest, six seconds after the last event at most."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from esg.dynamics.search.ending import LONGEST_S, PASSED_S, STILL_S, until_rest
from esg.engines.program import AdjustProperties, HoldVelocity, Primitive, Program
from esg.engines.scene import Rollout
from esg.graph.models import NodeEvent
from tests.dynamics.recordings import FPS, SCENE, Row, rollout

DRIVE = HoldVelocity("a", 0.0, 20.0, 2.0, 0.0)
LAST, LEAST = 1.0, 2.2
STORY = SimpleNamespace(nodes={})


def ends(
    until: dict[str, float], *primitives: Primitive, rows: tuple[Row, ...] = (), valid: bool = True
) -> float:
    """Bodies that move at 2 m/s until a time each [s], recorded after an event at `LAST`."""

    def play_on(theta: Any, duration: float) -> Rollout:
        made = rollout([list(rows)], duration)
        t = np.arange(made.position.shape[1]) / FPS
        for name, stop in until.items():
            made.linear_velocity[0, :, SCENE.index(name), 0] = np.where(t < stop, 2.0, 0.049)
        made.valid[:] = valid
        return made

    plan: Any = SimpleNamespace(
        scene=SCENE, story=STORY, compile=lambda theta: Program(primitives, LEAST)
    )
    reference: Any = SimpleNamespace(play_on=play_on)
    return until_rest(plan, reference, np.zeros(0), LAST, LEAST)


@pytest.mark.parametrize(
    ("stops", "expected"),
    [(0.5, LEAST), (3.2, 3.2 + STILL_S), (60.0, LAST + LONGEST_S)],
)
def test_a_recording_lasts_until_the_last_body_rests(stops: float, expected: float) -> None:
    assert ends({"a": 0.4, "b": stops}) == pytest.approx(expected, abs=0.11)


def test_what_drives_on_for_ever_is_not_waited_for() -> None:
    assert ends({"a": 60.0}, DRIVE) == LEAST
    assert ends({"a": 60.0, "b": 3.2}, DRIVE) == pytest.approx(3.2 + STILL_S, abs=0.11)


def test_what_was_hit_or_brakes_is() -> None:
    hit = ((0.9, 0, 1, 5.0),)
    assert ends({"a": 4.0}, DRIVE, rows=hit) == pytest.approx(4.0 + STILL_S, abs=0.11)
    brake = AdjustProperties("a", 1.0, linear_damping=2.0)
    assert ends({"a": 4.0}, DRIVE, brake) == pytest.approx(4.0 + STILL_S, abs=0.11)


def test_who_overtakes_is_recorded_until_he_has_left_the_other_one_behind() -> None:
    """Level after 1 s at half a metre a second more; a whole length of both ahead later."""
    size = sum(max(b.half_extents[:2]) for b in SCENE.bodies[:2])

    def play_on(theta: Any, duration: float) -> Rollout:
        made = rollout([[]], duration)
        t = np.arange(made.position.shape[1]) / FPS
        made.position[0, :, 0, 0], made.position[0, :, 1, 0] = 0.25 * t, 0.1 * (t - 1.0) + 0.25
        made.linear_velocity[0, :, 0, 0] = 0.25
        return made

    node = SimpleNamespace(event=NodeEvent.MISS, participants=[b.name for b in SCENE.bodies[:2]])
    story = SimpleNamespace(nodes={"pass": node})
    plan: Any = SimpleNamespace(scene=SCENE, story=story, compile=lambda theta: Program((), LEAST))
    reference: Any = SimpleNamespace(play_on=play_on)
    drives = replace(DRIVE, body=SCENE.bodies[0].name), replace(DRIVE, body=SCENE.bodies[1].name)
    plan.compile = lambda theta: Program(drives, LEAST)
    found = until_rest(plan, reference, np.zeros(0), LAST, LEAST)
    assert found == pytest.approx(1.0 + size / 0.15 + PASSED_S, abs=0.21)


def test_a_recording_ends_before_something_rolls_off_the_drawn_ground() -> None:
    """Body a goes at 2 m/s from the middle of a floor of 8 m: it would leave it after 2 s."""
    floor = replace(SCENE.bodies[2], name="floor", static=True, shapes=(), position=(0.0, 0.0, 0.0),
                    half_extents=(8.0, 8.0, 0.01))  # fmt: skip
    scene = SCENE.with_bodies((*SCENE.bodies[:2], floor))

    def play_on(theta: Any, duration: float) -> Rollout:
        made = rollout([[]], duration)
        t = np.arange(made.position.shape[1]) / FPS
        made.position[0, :, 0, 0] = 2.0 * t
        made.linear_velocity[0, :, 0, 0] = 2.0
        return made

    plan: Any = SimpleNamespace(scene=scene, story=STORY, compile=lambda theta: Program((), LEAST))
    reference: Any = SimpleNamespace(play_on=play_on)
    found = until_rest(plan, reference, np.zeros(0), LAST, LEAST)
    assert found == pytest.approx(4.0 - STILL_S, abs=0.11)
    road = replace(floor, name="road", category="road", half_extents=(6.0, 2.0, 0.005))
    for kind, leaves in (("car", 3.0), ("ball", 4.0)):
        driver = replace(scene.bodies[0], category=kind, label=kind)
        plan.scene = scene.with_bodies((driver, *scene.bodies[1:], road))
        found = until_rest(plan, reference, np.zeros(0), LAST, LEAST)
        assert found == pytest.approx(leaves - STILL_S, abs=0.11), kind
    assert until_rest(plan, reference, np.zeros(0), LAST, 5.0) == 5.0


def test_what_diverges_is_no_reason_to_record_longer() -> None:
    assert ends({"a": 60.0}, valid=False) == LEAST
