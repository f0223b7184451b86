"""The ground that is said, and ice under what slides on it, and only there."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.assets.materials import MATERIALS
from esg.draft import draft, said
from esg.dynamics.casting import fitted
from esg.dynamics.casting.surfaces import ICE
from esg.dynamics.story.paces import grip
from esg.dynamics.story.stagecraft import ground_friction, prop
from esg.lexicon.grounds import grounds
from esg.units import GRAVITY_MPS2


@pytest.mark.parametrize(
    ("prompt", "thing", "icy"),
    [
        ("A box slides across the ice and bumps into a barrel.", "box_1", True),
        ("A hockey puck slides into a goal.", "hockey_puck_1", True),
        ("A crate slides over the frozen lake and hits a sledge.", "crate_1", True),
        ("A skater glides over the ice into a bench.", "skater_1", True),
        ("A child on the ice bumps into a penguin.", "penguin_1", True),
        ("Two skaters collide on the frozen lake.", "skater_1", True),
        ("A skater glides across the floor into a bench.", "skater_1", False),
        ("A crate slides across the floor and hits a wall.", "crate_1", False),
        ("A ball rolls over the ice and hits a bottle.", "ball_1", False),
        ("A crate slides into an ice cream stand.", "crate_1", False),
    ],
)
def test_what_slides_on_ice_has_its_friction(prompt: str, thing: str, icy: bool) -> None:
    doc = fitted(resolve(draft(prompt)))
    assert (ground_friction(doc) == ICE) is icy
    assert (prop(doc, thing).friction == ICE) is icy


def test_curling_stones_that_are_struck_slide_on_as_well() -> None:
    doc = fitted(resolve(draft("A curling stone slides into two other curling stones.")))
    stones = [n for n in doc.spatial_relation_graph.nodes if "curling" in n]
    assert len(stones) == 3
    assert all(prop(doc, n).friction == ICE for n in stones)


@pytest.mark.parametrize("text", ["slides on an ice cube", "over the ice cream", "by the rink"])
def test_ice_that_is_no_ground_is_no_ice(text: str) -> None:
    assert not said.ICE.search(text)


@pytest.mark.parametrize(
    ("prompt", "snowy"),
    [
        ("A skier goes down the slope and hits a gate pole.", True),
        ("A snowboarder slides down the hill into a snowman.", True),
        ("A sled slides down the hill and hits a tree.", True),
        ("A sled slides over the sand and hits a box.", False),
        ("A crate slides down the ramp and hits a pole.", False),
    ],
)
def test_what_glides_goes_on_snow_unless_another_ground_is_named(prompt: str, snowy: bool) -> None:
    doc = fitted(resolve(draft(prompt)))
    assert (ground_friction(doc) <= MATERIALS["snow"].friction) is snowy


@pytest.mark.parametrize(
    ("prompt", "mover", "name"),
    [
        ("A car brakes on a wet road.", "car_1", "wet"),
        ("A van brakes on a snowy street.", "van_1", "snow"),
        ("A truck brakes on a gravel road.", "truck_1", "gravel"),
        ("A motorcycle brakes on a muddy track.", "motorcycle_1", "mud"),
        ("A jeep brakes on the sand.", "jeep_1", "sand"),
    ],
)
def test_a_ground_that_is_said_rubs_and_holds_so(prompt: str, mover: str, name: str) -> None:
    doc = fitted(resolve(draft(prompt)))
    assert ground_friction(doc) == grounds()[name].friction
    assert grip(doc, mover) == pytest.approx(grounds()[name].grip * GRAVITY_MPS2)


def test_who_walks_on_snow_slides_on_no_ice() -> None:
    doc = fitted(resolve(draft("A man walks across the snow and kicks a box.")))
    assert prop(doc, "man_1").friction == pytest.approx(0.22)


@pytest.mark.parametrize("name", ["wet", "snow", "mud", "sand", "gravel"])
def test_soles_rub_on_a_ground_as_it_grips(name: str) -> None:
    """A dog that tumbles on slows down no faster than the check of braking allows."""
    ground = {"wet": "wet floor", "mud": "muddy field"}.get(name, name)
    doc = fitted(resolve(draft(f"A dog runs across the {ground} and knocks over a bucket.")))
    pair = 0.5 * (prop(doc, "dog_1").friction + ground_friction(doc))
    assert pair <= 0.8 * grounds()[name].grip + 1e-9
