"""Poses, liveries and colours are chosen from what the document says, and from its seed."""

from __future__ import annotations

from pathlib import Path

import pytest

from esg.assets import build_mesh, resolve, write_meshes
from esg.assets.appearance import Appearance
from esg.assets.appearances import appearances, pose_of
from esg.assets.configuration import node_mesh_path
from esg.assets.library.catalogue import parse_hex
from esg.compile.assets import mesh_file
from esg.draft import draft
from esg.graph.models import Dressing


def looks(prompt: str, seed: int = 0) -> dict[str, Appearance]:
    return appearances(resolve(draft(prompt), seed=seed))


@pytest.mark.parametrize(
    ("prompt", "node", "pose"),
    [
        ("A man kicks a soccer ball into the goal.", "man_1", "kick"),
        ("A ball is kicked by a girl.", "girl_1", "kick"),
        ("A boy throws a ball at three bottles.", "boy_1", "throw"),
        ("A basketball player shoots the ball into the hoop.", "player_1", "throw"),
        ("A hockey player shoots the puck into the net.", "hockey_player_1", "swing"),
        ("A tennis player serves the ball over the net.", "player_1", "swing"),
        ("A boy shoots a soccer ball into the goal.", "boy_1", "kick"),
        ("A worker pushes a cart.", "worker_1", "push"),
        ("A man carries a box to the table.", "man_1", "bear"),
        ("A woman sits on a bench.", "woman_1", "sit"),
        ("A boy hops off a bench.", "boy_1", "run"),
        ("A kid jumps on a bed three times.", "kid_1", "run"),
        ("Three people walk across the road.", "person_3", "walk"),
        ("A man stands next to a car.", "man_1", ""),
        ("A man rides a bicycle.", "man_1", "ride"),
        ("A girl rides a horse.", "girl_1", "astride"),
        ("A boy rides a skateboard.", "boy_1", "balance"),
        ("A motorcycle drives down the road.", "motorcycle_1", "ridden"),
        ("A bicycle hits a trash can.", "bicycle_1", "ridden"),
        ("A man rides a bicycle.", "bicycle_1", ""),
        ("A riderless motorcycle rolls into a wall.", "motorcycle_1", ""),
        ("A car hits a parked motorcycle.", "motorcycle_1", ""),
        ("A horse gallops across a field.", "horse_1", "run"),
        ("A cat walks to a bowl.", "cat_1", "walk"),
        ("A ball hits a dog.", "dog_1", ""),
        ("A bird is perched on a fence, then it flies off to the tree.", "bird_1", "fly"),
        ("A duck flies over a pond.", "duck_1", "fly"),
        ("A seagull flies past a lighthouse.", "seagull_1", "fly"),
        ("A chicken walks to a bowl.", "chicken_1", ""),
    ],
)
def test_a_person_is_posed_by_what_he_does(prompt: str, node: str, pose: str) -> None:
    assert looks(prompt)[node].pose == pose


@pytest.mark.parametrize(
    ("word", "pose"),
    [
        ("kicks", "kick"),
        ("threw", "throw"),
        ("running", "run"),
        ("pushed", "push"),
        ("batting", "swing"),
        ("falls", None),
        ("bowling", "throw"),
    ],
)
def test_forms_of_verbs(word: str, pose: str | None) -> None:
    assert pose_of(word) == pose


def test_things_of_a_kind_differ_and_stated_colours_stay() -> None:
    found = looks("A red car passes three people and a motorcycle.")
    people = [found[f"person_{k}"].color for k in (1, 2, 3)]
    assert None not in people and len(set(people)) == 3
    assert found["red_car_1"].color is None
    red, green, blue = found["motorcycle_1"].color or (1, 0, 0)
    assert not (red > 0.5 and max(green, blue) < 0.3)


def test_the_same_seed_looks_the_same_and_another_does_not() -> None:
    prompt = "A truck hits a van next to a tree."
    assert looks(prompt, 1) == looks(prompt, 1)
    assert looks(prompt, 1) != looks(prompt, 2)


def test_pins_of_one_asset_are_alike() -> None:
    found = looks("A bowling ball hits six bowling pins.")
    assert len({found[f"bowling_pin_{k}"] for k in range(1, 7)}) == 1


def test_police_cars_and_taxis_are_told_apart() -> None:
    found = looks("A police car chases a taxi.")
    assert (found["police_car_1"].livery, found["taxi_1"].livery) == ("police_car", "taxi")
    assert found["police_car_1"].color != found["taxi_1"].color


def test_nodes_that_differ_have_files_of_their_own(tmp_path: Path) -> None:
    doc = resolve(draft("Three people walk across the road."), seed=1)
    write_meshes(doc, tmp_path)
    mesh = doc.asset_configurations["person_01"].mesh_path
    first, second = (mesh_file(tmp_path, mesh, f"person_{k}") for k in (1, 2))
    assert first == tmp_path / mesh
    assert second == tmp_path / node_mesh_path(mesh, "person_2")
    assert first is not None and second is not None
    assert first.read_bytes() != second.read_bytes()


@pytest.mark.parametrize(
    ("prompt", "node", "color"),
    [
        ("A lemon rolls off the table.", "lemon_1", "#f2d13c"),
        ("A school bus stops at the light.", "school_bus_1", "#f5a81c"),
        ("A crow lands on a fence.", "crow_1", "#1d1d20"),
    ],
)
def test_what_a_kind_stands_for_has_its_own_colour(prompt: str, node: str, color: str) -> None:
    assert looks(prompt)[node].color == parse_hex(color)


def test_a_stated_colour_is_kept_by_what_has_a_usual_one() -> None:
    assert looks("A green lemon rolls off the table.")["green_lemon_1"].color is None


@pytest.mark.parametrize("pose", ["walk", "run"])
def test_legs_that_are_not_bent_reach_the_ground_in_every_gait(pose: str) -> None:
    config = resolve(draft("A horse gallops across a field."))
    horse = next(c for c in config.asset_configurations.values() if c.asset_name == "horse")
    scene = build_mesh(horse, Appearance(pose=pose))
    hooves = {n: g for n, g in scene.geometry.items() if "horn" in n}
    assert hooves
    low = min(float(g.bounds[0][2]) for g in hooves.values())
    assert abs(low) < 1.0
    assert scene.bounds[0][2] > -1.0


@pytest.mark.parametrize(("ground", "material"), [("snow", "snow"), ("asphalt", "")])
def test_a_slope_is_of_the_land_around_it(ground: str, material: str) -> None:
    doc = resolve(draft("A skier goes down the slope."))
    around = Dressing(
        place="snowfield", sky="clear", sun_azimuth_deg=0, sun_elevation_deg=40, ground=ground
    )
    doc = doc.model_copy(update={"dressing": around})
    slope = next(n for n in doc.spatial_relation_graph.nodes if "slope" in n or "ramp" in n)
    assert appearances(doc)[slope].material == material
