"""Doors, gates, booms: what they swing into stands in their sweep, clear of where they start."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.choreography import choreograph
from esg.dynamics.story.driving import leaf_of
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import read_story
from tests.dynamics.stories import cast


@pytest.mark.parametrize(
    ("prompt", "leaf_name", "met"),
    [
        ("A door swings open and knocks over a vase.", "door_1", "vase_1"),
        ("The gate swings shut and hits the bucket.", "gate_1", "bucket_1"),
        ("The fridge door swings open and bumps a chair.", "door_1", "chair_1"),
        ("The swinging boom knocks the lamp over.", "swinging_boom_1", "lamp_1"),
    ],
)
def test_what_a_leaf_meets_stands_in_its_sweep(prompt: str, leaf_name: str, met: str) -> None:
    doc = cast(prompt)
    leaf, story = leaf_of(doc, leaf_name), read_story(doc)
    assert leaf is not None
    assert met not in story.phases  # the leaf moves, not what it hits
    places = {p.node: p for c in choreograph(doc).hints.constellations for p in c.placements}
    own, other = places[leaf_name], places[met]
    yaw = math.radians(own.yaw_deg or 0.0)
    c, s = math.cos(yaw), math.sin(yaw)
    x, y = ((other.x_cm - own.x_cm) / 100.0, (other.y_cm - own.y_cm) / 100.0)
    x, y = c * x + s * y - leaf.axle[0], -s * x + c * y - leaf.axle[1]
    body = prop(doc, met)
    turned = (math.atan2(y, x) - leaf.arm) * leaf.sense
    opens = leaf.limits.upper if leaf.limits.upper is not None else math.pi
    assert math.hypot(x, y) - max(body.half_length, body.half_width) < leaf.reach
    assert -opens <= leaf.here + math.remainder(turned, 2.0 * math.pi) <= opens
    # beside the leaf as it stands at the start, and not in it
    aside = abs(x * -math.sin(leaf.arm) + y * math.cos(leaf.arm))
    assert aside > leaf.thick + min(body.half_length, body.half_width)


def test_a_door_that_slams_shut_meets_what_is_in_its_way_before_it_is_shut() -> None:
    story = read_story(cast("The door slams shut and knocks a lamp over."))
    told = [n.event.value for n in story.nodes.values()]
    assert told.index("Collision") < told.index("Close")


def test_a_leaf_turns_on_at_one_rate_through_what_it_opens_and_what_it_meets() -> None:
    doc = cast("A door swings open and knocks over a vase.")
    nominal = choreograph(doc).nominal
    first, second = (nominal[f"door_1_moved{n}/duration"] for n in ("", "_2"))
    opened, on = math.radians(42.0), math.radians(75.0 - 42.0)
    assert opened / first == pytest.approx(on / second, rel=1e-3)


@pytest.mark.parametrize(
    ("prompt", "mover", "front"),
    [
        ("A tricycle pushes the open bathroom door shut.", "tricycle_1", False),
        ("A beach ball rolls into the open door of a cupboard and swings it shut.", "beach_ball_1",
         True),
    ],
)  # fmt: skip
def test_a_leaf_is_pushed_shut_from_the_side_to_which_it_opens(
    prompt: str, mover: str, front: bool
) -> None:
    doc = cast(prompt)
    places = {p.node: p for c in choreograph(doc).hints.constellations for p in c.placements}
    door, comes = places["door_1"], places[mover]
    yaw = math.radians(door.yaw_deg or 0.0)
    x, y = comes.x_cm - door.x_cm, comes.y_cm - door.y_cm
    ahead = x * math.cos(yaw) + y * math.sin(yaw)
    assert (ahead > 0.0) is front
    assert abs(ahead) > 0.9 * math.hypot(x, y)
