"""Nouns as a drafter files them: what stands in the scene has the size of the noun itself."""

from __future__ import annotations

import math

import pytest

from esg.assets.library.wording import restated
from esg.assets.stage import configure
from esg.graph.models import AssetRequirement


def asked(words: str, category: str, size: tuple[float, float, float], mass: float) -> object:
    return configure(
        "a",
        AssetRequirement(
            asset_category=category,
            asset_description=f"{words}: {category.replace('_', ' ')}",
            expected_dimensions_cm=size,
            expected_mass_kg=mass,
        ),
    )


@pytest.mark.parametrize(
    ("words", "category", "size", "mass", "longest", "weight"),
    [
        # The last word of a compound names a far larger thing.
        ("remote control car", "toy_car", (20, 9, 7), 0.4, (10, 30), (0.1, 2)),
        ("propane tank", "canister", (30, 30, 60), 15, (40, 80), (5, 30)),
        ("dog house", "kennel", (100, 70, 80), 25, (70, 130), (10, 50)),
        # A category drawn at any size keeps the size that was expected.
        ("box of cereal", "cereal_packet", (19, 7, 28), 0.5, (25, 30), (0.3, 0.8)),
        # A category of another thing of that name says nothing about the size.
        ("life ring", "hula_hoop", (90, 3, 90), 0.5, (60, 95), (0.3, 3)),
        ("manhole cover", "well", (120, 120, 80), 900, (50, 75), (20, 90)),
        # The sibling that the words name, not the nearest in size.
        ("floor lamp", "lamp", (25, 25, 50), 2.5, (120, 180), (3, 10)),
        # Young animals and small breeds are no adults.
        ("puppy", "dog", (75, 25, 55), 20, (25, 60), (2, 10)),
        ("moose", "deer", (170, 45, 130), 90, (200, 300), (300, 600)),
        ("ostrich", "giraffe", (250, 80, 350), 800, (150, 250), (80, 150)),
        # Words of size count once, whatever the usual size.
        ("toy robot", "robot", (15, 12, 25), 0.6, (15, 40), (0.1, 2)),
        ("giant robot", "robot", (168, 168, 333), 540, (250, 350), (200, 1500)),
        ("giant wolf", "fox", (180, 60, 90), 120, (180, 320), (100, 500)),
    ],
)
def test_size_and_mass_are_those_of_the_noun(
    words: str,
    category: str,
    size: tuple[float, float, float],
    mass: float,
    longest: tuple[float, float],
    weight: tuple[float, float],
) -> None:
    config = asked(words, category, size, mass)
    assert longest[0] <= max(config.dimensions_cm) <= longest[1], config.dimensions_cm
    assert weight[0] <= config.mass_kg <= weight[1]


@pytest.mark.parametrize(
    ("noun", "longest", "weight"),
    [
        ("dollhouse", (40, 90), (2, 12)),
        ("greenhouse", (200, 500), (200, 3000)),
        ("car jack", (25, 60), (5, 30)),
        ("jack-in-the-box", (10, 30), (0.2, 2)),
        ("cooler", (40, 80), (2, 10)),
        ("tuk-tuk", (200, 320), (250, 700)),
        ("foal", (90, 160), (40, 100)),
        ("crowbar", (60, 110), (2, 6)),
        ("chihuahua", (25, 45), (2, 6)),
    ],
)
def test_nouns_unknown_to_the_drafter_have_their_own_size(
    noun: str, longest: tuple[float, float], weight: tuple[float, float]
) -> None:
    """Such a noun comes as a cube of 40 cm and 5 kg that repeats itself."""
    requirement = AssetRequirement(
        asset_category=noun.replace(" ", "_"),
        asset_description=f"{noun}: {noun}",
        expected_dimensions_cm=(40, 40, 40),
        expected_mass_kg=5,
        shape="box",
    )
    config = configure("a", requirement)
    assert longest[0] <= max(config.dimensions_cm) <= longest[1], config.dimensions_cm
    assert weight[0] <= config.mass_kg <= weight[1]


def test_scaled_copies_are_drawn_in_the_proportions_of_their_model() -> None:
    horse, foal = (
        configure(
            "a",
            AssetRequirement(
                asset_category=name,
                asset_description=name,
                expected_dimensions_cm=size,
                expected_mass_kg=100,
            ),
        )
        for name, size in (("horse", (238.7, 58.8, 193.8)), ("foal", (131.3, 32.3, 106.6)))
    )
    ratio = [a / b for a, b in zip(foal.dimensions_cm, horse.dimensions_cm, strict=True)]
    assert all(math.isclose(r, 0.55, rel_tol=0.01) for r in ratio)
    assert len(foal.proxies) == len(horse.proxies)


def test_what_is_named_by_its_category_alone_is_left_as_it_was_asked() -> None:
    requirement = AssetRequirement(
        asset_category="trash_bin",
        asset_description="trash bin: outdoor bin",
        expected_dimensions_cm=(55, 55, 95),
        expected_mass_kg=12,
    )
    assert restated(requirement) is requirement


@pytest.mark.parametrize(("words", "white"), [("pin", True), ("wooden bowling pin", False)])
def test_a_kind_keeps_its_colour_unless_the_words_name_the_material(
    words: str, white: bool
) -> None:
    """Bowling pins are made of wood and white; who asks for a wooden one sees wood."""
    requirement = AssetRequirement(
        asset_category="bowling_pin",
        asset_description=f"{words}: white bowling pin with red stripes, wood",
        expected_dimensions_cm=(12.1, 12.1, 38.0),
        expected_mass_kg=1.5,
        material="wood",
    )
    assert (min(configure("a", requirement).color_rgb) > 0.85) is white
