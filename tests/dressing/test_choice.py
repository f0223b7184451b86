"""Which place a scene is in: what its words say, what its environment is, what is at home where."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dressing.choice import Choice, choose
from esg.graph.models import EsgDocument, Wording
from tests.dressing.worlds import body, document, ground, road, scene_of

BALL, CAR = ("ball", (0.2, 0.2, 0.2)), ("car", (4.5, 1.8, 1.5))


def chosen(
    prompt: str,
    *things: tuple[str, tuple[float, float, float]],
    setting: str = "outdoor",
    environment: str = "generic",
    extent: float = 4.0,
    streets: bool = False,
    seed: int = 0,
) -> Choice:
    bodies = [body(name, size, name=f"{name}_{k}") for k, (name, size) in enumerate(things)]
    scene = scene_of(ground(), *([road()] if streets else []), *bodies)
    doc = document(scene, prompt, setting=setting, environment=environment)
    return choose(doc, scene, extent, np.random.default_rng(seed))


@pytest.mark.parametrize(
    ("prompt", "setting", "environment", "place"),
    [
        ("A ball rolls through the park.", "outdoor", "park", "park"),
        ("A cup falls off the table in the kitchen.", "indoor", "kitchen", "kitchen"),
        ("A box slides across the warehouse floor.", "indoor", "warehouse", "warehouse"),
        ("In the workshop a hammer falls.", "indoor", "workshop", "workshop"),
        ("A ball rolls across the living room.", "indoor", "living_room", "living_room"),
        ("A crate falls off a truck at the harbour.", "outdoor", "street", "harbour"),
        ("A puck slides over the ice rink.", "outdoor", "ice_rink", "ice_rink"),
        ("Children play on the playground.", "outdoor", "playground", "playground"),
        ("A ball rolls along the beach.", "outdoor", "beach", "beach"),
        ("A ball flies over the city.", "outdoor", "generic", "square"),
        ("A ball rolls through the village.", "outdoor", "generic", "square"),
        ("A plane taxis to the runway.", "outdoor", "street", "airfield"),
        ("A medicine ball is thrown in the gym.", "indoor", "gym", "gym"),
        ("A car reverses in the car park.", "outdoor", "street", "car_park"),
    ],
)
def test_words_say_where_it_is(prompt: str, setting: str, environment: str, place: str) -> None:
    for seed in range(8):
        found = chosen(prompt, BALL, setting=setting, environment=environment, seed=seed)
        assert found.place.name == place, found.reasons


def test_a_things_name_is_hardly_a_place() -> None:
    """A garden chair may stand anywhere; who says that it is in the park is believed."""
    chair = ("box", (1.0, 1.0, 1.0))
    somewhere = {chosen("It hits a garden chair.", chair, seed=s).place.name for s in range(20)}
    assert len(somewhere) > 2
    for seed in range(8):
        there = chosen("In the park it hits a garden chair.", chair, seed=seed)
        assert there.place.name == "park"


def test_a_car_park_is_no_park() -> None:
    for seed in range(8):
        assert chosen("A ball rolls in the car park.", BALL, seed=seed).place.name == "car_park"
        assert chosen("A ball rolls in the park.", BALL, seed=seed).place.name == "park"


@pytest.mark.parametrize(
    ("things", "place"),
    [
        ((("hockey_puck", (0.1, 0.1, 0.03)),), "ice_rink"),
        ((("stove", (0.6, 0.6, 0.9)), ("frying_pan", (0.4, 0.3, 0.1))), "kitchen"),
        ((("boat", (4, 1.5, 1)), ("buoy", (1, 1, 1.5))), "water"),
        ((("excavator", (6, 2, 3)),), "site"),
        ((("tent", (2, 2, 1)), ("campfire", (1, 1, 0.5)), ("log", (2, 0.3, 0.3))), "forest"),
    ],
)
def test_things_are_at_home_somewhere(
    things: tuple[tuple[str, tuple[float, float, float]], ...], place: str
) -> None:
    for seed in range(8):
        assert chosen("They move.", *things, seed=seed).place.name == place


def test_no_street_without_a_road() -> None:
    for seed in range(20):
        without = chosen("A car hits a bin.", CAR, environment="street", extent=20.0, seed=seed)
        assert without.place.name not in ("street", "highway", "country_road")
    with_one = chosen("A car hits a bin.", CAR, environment="street", streets=True)
    assert with_one.place.name == "street"


def test_a_yard_that_is_called_a_road_is_no_street() -> None:
    """Drafts lay one of 60 by 50 m under a forklift that turns."""
    yard = body("road", (60.0, 50.0, 0.01), flat=True)
    scene = scene_of(ground(), yard, body(*CAR))
    doc = document(scene, "A car turns.", environment="street")
    names = {choose(doc, scene, 20.0, np.random.default_rng(s)).place.name for s in range(20)}
    assert names.isdisjoint({"street", "highway", "country_road"})


def test_a_small_room_is_not_built_around_a_long_way() -> None:
    marble = ("marble", (0.02, 0.02, 0.02)), ("domino", (0.05, 0.02, 0.1))
    near = {
        chosen("A marble hits a domino.", *marble, extent=3.0, seed=s).place.name for s in range(8)
    }
    far = {
        chosen("A marble hits a domino.", *marble, extent=40.0, seed=s).place.name for s in range(8)
    }
    assert near == {"living_room"}
    assert "living_room" not in far


@pytest.mark.parametrize(
    ("prompt", "sky"),
    [
        ("At night a car hits a bin.", "night"),
        ("A car stops at dusk.", "dusk"),
        ("In the morning a dog runs.", "morning"),
        ("A ball bounces in the rain.", "overcast"),
        ("A snowy day, a sled slides.", "overcast"),
        ("On a sunny day a ball rolls.", "clear"),
    ],
)
def test_words_say_what_light_there_is(prompt: str, sky: str) -> None:
    assert chosen(prompt, BALL).sky.name == sky


def test_a_knight_brings_no_night() -> None:
    skies = {chosen("A knight hits a dummy.", BALL, seed=s).sky.name for s in range(20)}
    assert "clear" in skies and skies <= {"clear", "cloudy", "morning"}


def test_a_wet_ground_is_the_same_ground_and_darker() -> None:
    scene = scene_of(ground(), body(*CAR))
    doc = document(scene, "A car parks in the car park.", environment="car_park")
    looks = [choose(d, scene, 4.0, np.random.default_rng(0)).ground for d in (doc, _wet(doc))]
    assert looks == ["asphalt", "wet_asphalt"]


def _wet(doc: EsgDocument) -> EsgDocument:
    told = doc.scene_definition.model_copy(update={"wording": Wording(surface="wet")})
    return doc.model_copy(update={"scene_definition": told})


def test_the_ground_is_what_words_say() -> None:
    assert chosen("On a snowy day a sled slides.", ("sled", (1, 0.5, 0.3))).ground == "snow"
    assert chosen("A ball rolls over the sand.", BALL).ground == "sand"
    assert chosen("A box slides over ice.", BALL, environment="ice").ground == "ice"


def test_what_one_runs_into_is_not_the_ground() -> None:
    prompt = "A puck slides across the rink into the boards."
    puck, board = ("puck", (0.1, 0.1, 0.1)), ("board", (3.0, 0.1, 1.0))
    assert chosen(prompt, puck).ground == "boards"
    assert chosen(prompt, puck, board).ground == "ice"
    assert chosen("A ball rolls through the park.", BALL, environment="park").ground == "grass"


def test_a_room_keeps_its_floor_although_sand_is_spoken_of() -> None:
    found = chosen("A bag falls on the sand in the gym.", BALL, setting="indoor", environment="gym")
    assert found.ground == "lane_wood"


def test_toys_are_in_no_street_and_on_no_lake() -> None:
    """Take no place from what is a quarter as long as such things are."""
    boat, bath = ("boat", (0.2, 0.08, 0.05)), ("bathtub", (1.7, 0.75, 0.6))
    for seed in range(8):
        found = chosen("Three toy boats float in a bathtub.", boat, bath, seed=seed)
        assert found.place.name == "room", found.reasons
    large = ("boat", (4.0, 1.5, 1.0))
    assert chosen("A boat drifts.", large, setting="outdoor").place.name == "water"


def test_who_walks_beside_a_river_of_the_scene_is_on_land() -> None:
    """The lake or river is a thing of the scene there, and not all of the ground."""
    from esg.assets import resolve
    from esg.draft import draft

    for prompt in ("An elephant pushes a log into the river.", "A man throws a stone into a lake."):
        doc = resolve(draft(prompt))
        kinds = {
            n: doc.asset_configurations[v.asset_id]
            for n, v in doc.spatial_relation_graph.nodes.items()
        }
        bodies = [
            body(c.category, (1.0, 1.0, 1.0), name=n) for n, c in kinds.items() if n != "ground_1"
        ]
        flat = [replace(b, shapes=()) if b.category in ("pool", "pond") else b for b in bodies]
        scene = scene_of(ground(), *flat)
        found = choose(doc, scene, 4.0, np.random.default_rng(0))
        assert found.place.name != "water" and found.ground != "water"
