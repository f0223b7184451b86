"""The table of nouns that name no thing."""

import pytest

from esg.lexicon.senses import no_things


@pytest.mark.parametrize(
    ("noun", "kind"),
    [
        ("interaction", "nothing"),
        ("rhythm", "nothing"),
        ("dent", "nothing"),
        ("liquid", "substance"),
        ("valley", "place"),
        ("harbor", "place"),
        ("thumb", "body"),
    ],
)
def test_noun_names_no_thing(noun: str, kind: str) -> None:
    assert no_things()[noun] == kind


@pytest.mark.parametrize(
    "noun",
    [
        "cube",
        "disc",
        "pyramid",
        "magnet",
        "rope",
        "obstacle",
        "target",
        "bagel",
        "coin",
        "feather",
        "string",
        "cork",
    ],
)
def test_things_are_not_in_the_table(noun: str) -> None:
    assert noun not in no_things()


def test_table_holds_single_words_of_four_kinds() -> None:
    assert set(no_things().values()) == {"nothing", "substance", "place", "body"}
    assert len(no_things()) > 20_000
    assert all(noun.replace("-", "").isalpha() and noun == noun.lower() for noun in no_things())
