"""Nouns outside the library: the nearest kind stands in, at a sane size, and stands still."""

from __future__ import annotations

from dataclasses import replace
import math

import pytest

from esg.assets.library.catalogue import Entry, entries_by_name, normalize
from esg.assets.library.hypernyms import kin
from esg.assets.library.proposal import guessed
from esg.assets.library.retrieve import GATE
from esg.assets.stage import configure
from esg.draft.discourse.referents.entities import UNKNOWN_MASS_KG, nameless
from esg.graph.models import AssetRequirement
from esg.lexicon.hypernyms import TABLE, hypernyms
from tests.assets.worlds import faults, settle_configs

NAMES = [
    ("narwhal", "fish"),
    ("samovar", "vase"),
    ("zamboni", "truck"),
    ("gondola", "canoe"),
    ("jukebox", "vending_machine"),
    ("accordion", "suitcase"),
    ("armadillo", "turtle"),
    ("platypus", "duck"),
    ("walrus", "seal"),
    ("woodpecker", "bird"),
    ("centipede", "snake"),
    ("orangutan", "monkey"),
    ("sloth", "monkey"),
    ("hyena", "dog"),
    ("jellyfish", "mushroom"),
    ("catamaran", "sailboat"),
    ("typewriter", "printer"),
    ("hourglass", "vase"),
    ("telescope", "tripod"),
    ("microscope", "desk_lamp"),
    ("sextant", "camera"),
    ("abacus", "picture"),
    ("gramophone", "vase"),
    ("obelisk", "column"),
    ("yurt", "round_bale"),
    ("pagoda", "lighthouse"),
    ("croissant", "bread"),
    ("pretzel", "donut"),
    ("lectern", "side_table"),
    ("birdcage", "crate"),
    ("birdbath", "fountain"),
    ("weathervane", "road_sign"),
    ("gargoyle", "bust"),
    ("nutcracker", "scissors"),
    ("musket", "hockey_stick"),
    ("crown", "hat"),
    ("bagpipes", "gym_bag"),
    ("tambourine", "disc"),
    ("mandolin", "guitar"),
    ("colander", "bowl"),
    ("stethoscope", "ring"),
    ("router", "book"),
    ("satellite", "drone"),
    ("oscilloscope", "microwave"),
    ("forceps", "scissors"),
    ("clarinet", "walking_stick"),
    ("lynx", "cat"),
    ("warthog", "pig"),
    ("manatee", "fish"),
    ("stingray", "fish"),
    ("newt", "crocodile"),
    ("vulture", "bird"),
    ("turnstile", "barrier"),
    ("sarcophagus", "chest"),
    ("juggler", "person"),
    ("papaya", "apple"),
    ("artichoke", "carrot"),
    ("lollipop", "ice_cream"),
    ("breastplate", "shield"),
    ("plow", "wheelbarrow"),
    ("theremin", "desk_lamp"),
]


def asked(noun: str, **changes: object) -> AssetRequirement:
    """What the rule drafter asks of a noun of which it knows nothing."""
    stand_in = nameless(noun)
    values: dict[str, object] = {
        "asset_category": noun.replace(" ", "_"),
        "asset_description": f"{noun}: {stand_in.description}, {stand_in.material}",
        "expected_dimensions_cm": stand_in.dimensions_cm,
        "expected_mass_kg": UNKNOWN_MASS_KG,
        "shape": stand_in.shape,
        "material": stand_in.material,
        "linear_damping": 0.0,
    }
    return AssetRequirement.model_validate(values | changes)


@pytest.mark.parametrize(("noun", "kind"), NAMES)
def test_nearest_kind_stands_in_and_says_so(noun: str, kind: str) -> None:
    config = configure("x", asked(noun))
    assert (config.asset_name, config.source) == (kind, "fallback")
    assert config.category == noun
    assert config.confidence < GATE
    assert config.reason and str(GATE) in config.reason and kind.replace("_", " ") in config.reason
    assert config.runners_up[0].asset_name == kind and len(config.runners_up) > 2
    assert len({c.asset_name for c in config.runners_up}) == len(config.runners_up)
    assert config.proxies
    volume_m3 = math.prod(config.dimensions_cm) * 1e-6
    assert 1 < config.mass_kg / volume_m3 < 8000
    assert 0.5 < max(config.dimensions_cm) <= 1500


def test_stand_ins_stand_still() -> None:
    configs = [configure(noun, asked(noun)) for noun, _ in NAMES]
    names = entries_by_name()
    entries: list[Entry] = [
        replace(names[c.asset_name], name=noun, dimensions_cm=c.dimensions_cm)
        for (noun, _), c in zip(NAMES, configs, strict=True)
    ]
    assert faults(settle_configs("physx", configs), entries) == []


def test_size_that_was_asked_for_is_kept() -> None:
    need = asked(
        "narwhal",
        asset_description="a plush narwhal",
        expected_dimensions_cm=(60, 20, 22),
        expected_mass_kg=0.7,
    )
    config = configure("x", need)
    assert config.asset_name == "fish"
    assert config.dimensions_cm[0] == pytest.approx(60, rel=0.1)
    assert config.mass_kg == pytest.approx(0.7)


def test_adjectives_scale_what_was_guessed() -> None:
    plain = configure("x", asked("samovar"))
    giant = configure(
        "x",
        asked("samovar", expected_dimensions_cm=(80, 80, 80), expected_mass_kg=8 * UNKNOWN_MASS_KG),
    )
    assert giant.dimensions_cm[2] == pytest.approx(2 * plain.dimensions_cm[2])
    assert giant.mass_kg == pytest.approx(8 * plain.mass_kg)
    heavy = configure("x", asked("samovar", expected_mass_kg=3 * UNKNOWN_MASS_KG))
    assert heavy.mass_kg == pytest.approx(3 * plain.mass_kg)
    assert heavy.dimensions_cm == plain.dimensions_cm


def test_prescribed_size_and_mass_win() -> None:
    config = configure(
        "x",
        asked(
            "samovar",
            expected_dimensions_cm=(30, 30, 60),
            dimensions_are_prescribed=True,
            expected_mass_kg=9,
            mass_is_prescribed=True,
        ),
    )
    assert config.asset_name == "vase"
    assert config.dimensions_cm[2] == pytest.approx(60, rel=0.1)
    assert config.mass_kg == 9


def test_synonym_keeps_its_kind_and_its_own_size() -> None:
    sword = configure("x", asked("sword"))
    assert (sword.asset_name, sword.source) == ("knife", "parametric")
    assert 80 < max(sword.dimensions_cm) < 130
    trebuchet = configure("x", asked("trebuchet"))
    assert trebuchet.asset_name == "catapult" and max(trebuchet.dimensions_cm) > 150


def test_small_stand_in_of_a_rooted_kind_can_move() -> None:
    figure = asked(
        "pagoda", asset_description="souvenir", expected_dimensions_cm=(12, 12, 30),
        expected_mass_kg=0.8,
    )  # fmt: skip
    assert configure("x", figure).is_movable
    assert not configure("x", asked("pagoda")).is_movable


def test_other_shape_than_the_nearest_kind_becomes_plain() -> None:
    pole = asked(
        "narwhal", asset_description="narwhal tusk", expected_dimensions_cm=(300, 2, 2),
        expected_mass_kg=3, shape=None,
    )  # fmt: skip
    config = configure("x", pole)
    assert config.asset_name.startswith("plain_") and config.reason is None


@pytest.mark.parametrize("noun", ["flibbertigibbet", "democracy", "blorft", "xyzzy", "zeitgeist"])
def test_where_nothing_is_near_a_plain_body_is_left(noun: str) -> None:
    config = configure("x", asked(noun))
    assert config.asset_name == "plain_box" and config.source == "fallback"
    assert config.dimensions_cm == (40, 40, 40) and config.mass_kg == 5


def test_guess_is_what_the_drafter_says_of_unknown_nouns() -> None:
    assert guessed(asked("widget")) == (1, 1, 1)
    assert guessed(asked("widget", asset_description="widget: a small lever")) is None
    assert guessed(asked("widget", dimensions_are_prescribed=True)) is None
    assert guessed(asked("widget", expected_dimensions_cm=(30, 18, 20))) is None


def test_table_names_kinds_that_exist_and_bodies_that_collide() -> None:
    nouns = hypernyms()
    assert len(nouns) > 20_000
    kinds = entries_by_name()
    for wider in set(nouns.values()):
        assert wider.kind in kinds, wider
        assert all(figure is None or figure > 0 for figure in (wider.longest_cm, wider.mass_kg))
    words = [
        w for line in TABLE.read_text("utf-8").splitlines() for w in line.split("\t")[4].split(";")
    ]
    assert all(w == normalize(w) for w in words)


def test_kin_takes_the_longest_ending_of_the_phrase_before_a_preposition() -> None:
    copper = kin("old copper samovar of tea")
    assert copper is not None and copper.noun == "samovar" and copper.kind == "vase"
    assert kin("old copper samovar", whole=True) is None
    assert kin("") is None


def test_words_decide_over_what_they_were_filed_under() -> None:
    cliff = asked(
        "treehouse", asset_description="cliff: raised ledge platform", is_movable=False,
        expected_dimensions_cm=(400, 300, 300), expected_mass_kg=20000,
    )  # fmt: skip
    config = configure("x", cliff)
    assert config.asset_name == "cliff" and config.support_surfaces
    assert config.dimensions_cm == (400, 300, 300) and not config.is_movable


@pytest.mark.parametrize(
    ("words", "filed", "kind"),
    [
        ("beanbag", "rocking_chair", "bean_bag"),
        ("harp", "shelf", "harp"),
        ("shield", "dartboard", "shield"),
        ("eight ball", "billiard_ball", "eight_ball"),
        ("jar", "vase", "jar"),
    ],
)
def test_a_kind_of_its_own_is_not_what_it_was_filed_under(
    words: str, filed: str, kind: str
) -> None:
    need = asked(filed, asset_description=f"{words}: something, as the table says")
    assert configure("x", need).asset_name == kind


def test_rooted_heavy_thing_is_no_toy() -> None:
    need = asked(
        "scarab", asset_description="scarab", is_movable=False,
        expected_dimensions_cm=(400, 300, 200), expected_mass_kg=20000,
    )  # fmt: skip
    assert configure("x", need).asset_name.startswith("plain_")


def test_a_size_that_is_already_the_nouns_own_is_not_scaled_again() -> None:
    """A jar of 10 x 10 x 15 cm filed under open boxes is no box made small."""
    need = asked(
        "open box", asset_description="jar: open box without a lid", material="glass",
        expected_dimensions_cm=(10, 10, 15), expected_mass_kg=0.5,
    )  # fmt: skip
    config = configure("x", need)
    assert config.asset_name == "jar" and config.dimensions_cm == (11, 11, 17)
