"""Toys and models: their size and mass, whatever the thing itself is."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft


def asset(phrase: str):
    doc = resolve(draft(f"There is {phrase} beside a chair."))
    nodes = doc.spatial_relation_graph.nodes
    name = next(n for n in nodes if not n.startswith(("ground", "floor", "chair")))
    return doc.asset_configurations[nodes[name].asset_id]


@pytest.mark.parametrize(
    "phrase",
    [
        "a toy fire engine",
        "a model ship",
        "a toy crane",
        "a toy piano",
        "a toy airliner",
        "a miniature castle",
        "a toy soldier",
        "a toy horse",
        "a toy house",
        "a toy elephant",
        "a model bridge",
        "a wooden toy tractor",
    ],
)
def test_a_toy_of_a_large_thing_is_small_light_and_loose(phrase: str):
    config = asset(phrase)
    assert 15 <= max(config.dimensions_cm) <= 40, config.dimensions_cm
    assert 0.05 <= config.mass_kg <= 3.0
    assert config.is_movable


def test_what_the_prompt_says_of_a_toy_holds():
    assert asset("a 5 kg toy tractor").mass_kg == 5.0
    assert max(asset("a toy truck 1 m long").dimensions_cm) == pytest.approx(100.0)
    assert max(asset("a giant toy tractor").dimensions_cm) > max(
        asset("a toy tractor").dimensions_cm
    )


def test_a_toy_dog_is_light():
    assert asset("a toy dog").mass_kg < 0.6


def test_a_toy_vehicle_is_driven_like_a_toy():
    doc = draft("A toy tractor drives into a toy bus.")
    edges = doc.timeline_system.sequence_graph.edges
    speeds = [e.params.speed for e in edges if e.params.speed is not None]
    fastest = max(s if isinstance(s, float) else s[1] for s in speeds)
    assert fastest <= 300.0


@pytest.mark.parametrize(
    ("phrase", "name", "longest", "mass"),
    [
        ("a Rubik's cube", "rubiks_cube", (5, 7), (0.05, 0.2)),
        ("a rocking horse", "rocking_horse", (70, 110), (4, 15)),
        ("a wheel of cheese", "cheese_wheel", (20, 40), (4, 15)),
        ("a deck of cards", "card_deck", (8, 10), (0.05, 0.2)),
        ("an iron", "clothes_iron", (25, 32), (1, 2)),
        ("a bar of chocolate", "chocolate_bar", (12, 20), (0.05, 0.2)),
        ("a bar of soap", "bar_of_soap", (7, 10), (0.05, 0.2)),
        ("a doll's house", "dollhouse", (40, 80), (3, 10)),
        ("a jump starter", "jump_starter", (25, 35), (3, 10)),
        ("a baby", "child", (50, 85), (4, 12)),
        ("a steel girder", "girder", (200, 500), (40, 200)),
    ],
)
def test_everyday_nouns_are_what_they_say(phrase, name, longest, mass):
    config = asset(phrase)
    assert config.asset_name == name
    assert longest[0] <= max(config.dimensions_cm) <= longest[1]
    assert mass[0] <= config.mass_kg <= mass[1]


def test_iron_before_a_noun_is_what_it_is_made_of():
    doc = draft("An iron ball hits an iron gate.")
    assert [n.rsplit("_", 1)[0] for n in doc.spatial_relation_graph.nodes][-2:] == [
        "iron_ball",
        "iron_gate",
    ] or not any(n.startswith("iron_1") for n in doc.spatial_relation_graph.nodes)


def test_a_rink_is_slippery_and_boats_have_room_on_a_lake():
    from esg.dynamics import build_scene
    from esg.layout import solve

    scene = build_scene(solve(resolve(draft("A puck slides across the ice rink."))))
    assert scene.ground_friction <= 0.06
    assert build_scene(solve(resolve(draft("A car drives on a road.")))).ground_friction > 0.3
    assert min(asset("a lake").dimensions_cm[:2]) >= 3000
    post = asset("a goalpost")
    assert max(post.dimensions_cm[:2]) < 20
    assert not post.is_movable
