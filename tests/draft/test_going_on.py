"""What is hit and then moves: by its own power, or carried along by the hit."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify


def motions(prompt: str, actor: str) -> list[str]:
    """The segments of an actor in a verified draft, in order."""
    doc = draft(prompt)
    assert verify(doc) == ()
    assert doc.timeline_system is not None
    return [e.event.value for e in doc.timeline_system.sequence_graph.edges if e.actor == actor]


@pytest.mark.parametrize(
    ("prompt", "actor", "expected"),
    [
        # it was on its way when it was hit
        ("A ball hits a car; the car then drives on.", "car_1", ["UniformMotion", "UniformMotion"]),
        (
            "A stone strikes a bus, and the bus brakes.",
            "bus_1",
            ["UniformMotion", "UniformMotion", "Brake"],
        ),
        (
            "A snowball hits a cyclist, who then turns left.",
            "cyclist_1",
            ["UniformMotion", "UniformMotion", "Turn"],
        ),
        (
            "A ball hits a runner; he keeps running and hits a hurdle.",
            "runner_1",
            ["UniformMotion", "UniformMotion"],
        ),
        (
            "A donkey is hit by a cart. It walks on for 3 s and bumps into a barrel.",
            "donkey_1",
            ["UniformMotion", "UniformMotion"],
        ),
        # it stood still
        (
            "A ball hits a parked taxi. The taxi then drives off and hits a lamp post.",
            "taxi_1",
            ["UniformMotion"],
        ),
        ("A van is hit by a branch and then drives into a gate.", "van_1", ["UniformMotion"]),
        ("A horse is hit by a ball and runs into a fence.", "horse_1", ["UniformMotion"]),
        # the hit carries it
        (
            "A scooter is hit by a truck and slides into a wall.",
            "scooter_1",
            ["InertialConnector"],
        ),
        ("A lorry hits a van. The van rolls into a lamp post.", "van_1", ["InertialConnector"]),
        ("A pram is hit by a dog and rolls into a pond.", "pram_1", ["InertialConnector"]),
        # what was hit drives faster by itself, a cart does not
        (
            "A can hits a tractor, the tractor accelerates and hits a fence.",
            "tractor_1",
            ["UniformMotion", "AcceleratedMotion"],
        ),
    ],
)
def test_motions_after_a_hit(prompt: str, actor: str, expected: list[str]) -> None:
    assert motions(prompt, actor) == expected


def test_of_two_that_met_the_one_that_drives_speeds_up() -> None:
    assert "AcceleratedMotion" in motions(
        "When a can hits a van, it accelerates to 8 m/s.", "van_1"
    )
    assert motions("When a can hits a van, it accelerates to 8 m/s.", "can_1") == ["Toward"]
