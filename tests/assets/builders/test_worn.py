"""Whoever wears something is drawn with it, in its colour, and stays the same body."""

from __future__ import annotations

import pytest

from esg.assets.appearance import Appearance, Wear
from esg.assets.appearances import wear_of
from esg.assets.builders.living.headwear import slug
from esg.assets.colors import COLORS, color_word, find_color
from esg.assets.geometry.mesh import configured_sketch
from esg.assets.library.catalogue import entries_by_name
from esg.assets.materials import MATERIALS
from esg.assets.stage import configure
from esg.graph.models import AssetConfiguration
from esg.lexicon.garments import garments, read, wearers
from esg.thresholds import WORN_COLOR
from tests.assets.worlds import requirement

KINDS = {g.kind: g for g in garments().values()}
BLUE = find_color("blue")
_COLORLESS = {"bald head", "bare chest", "bare feet"}
_BY_WEARER = {"people": ("person", "child", "woman"), "beasts": ("dog", "cat", "bird", "owl"),
              "quadrupeds": ("dog", "horse")}  # fmt: skip


def configured(name: str) -> AssetConfiguration:
    return configure("a", requirement(entries_by_name()[name]))


def drawn(
    name: str, wears: tuple[Wear, ...], pose: str = ""
) -> list[tuple[str, tuple[float, float, float]]]:
    """Names and colours of what is drawn of a kind that wears something."""
    look = Appearance(pose=pose, seed=3, wears=wears)
    sketch = configured_sketch(entries_by_name()[name], configured(name), look)
    return [(part.name, part.color) for part in sketch.parts]


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_every_garment_is_drawn_on_all_that_the_table_names(kind: str) -> None:
    for wearer in sorted(KINDS[kind].on):
        for name in _BY_WEARER[wearer]:
            parts = drawn(name, (Wear(kind, BLUE),))
            own = [c for n, c in parts if n == slug(kind) or n.startswith(slug(kind) + "_")]
            assert own, name
            off = min(max(abs(a - b) for a, b in zip(BLUE, c, strict=True)) for c in own)
            assert kind in _COLORLESS or off < WORN_COLOR, name


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_garment_names_a_material_and_a_colour_of_its_own(kind: str) -> None:
    row = KINDS[kind]
    assert row.surface in MATERIALS
    assert row.on <= {*_BY_WEARER}
    assert bool(row.color) or row.looks or kind == "clothes"


@pytest.mark.parametrize(
    ("name", "phrase"),
    [("person", "red coat"), ("child", "yellow helmet"), ("dog", "red sweater"), ("owl", "hat")],
)
def test_clothes_change_nothing_physical(name: str, phrase: str) -> None:
    entry, config = entries_by_name()[name], configured(name)
    wear = wear_of(phrase)
    assert wear is not None
    plain, dressed = (
        configured_sketch(entry, config, Appearance(seed=3, wears=w)) for w in ((), (wear,))
    )
    assert plain.proxies == dressed.proxies
    assert [p.name for p in plain.parts] != [p.name for p in dressed.parts]


def test_meshes_of_what_is_worn_are_sound() -> None:
    look = Appearance(seed=3, pose="walk", wears=tuple(
        Wear(k) for k in ("suit", "scarf", "party hat", "sunglasses", "boots", "gloves", "cape")
    ))  # fmt: skip
    for part in configured_sketch(entries_by_name()["person"], configured("person"), look).parts:
        mesh = part.mesh()
        assert len(mesh.faces) > 0, part.name
        assert abs(mesh.bounds).max() < 260.0, part.name


def test_one_garment_goes_over_another() -> None:
    parts = dict(drawn("person", (Wear("jacket", BLUE), Wear("t-shirt", find_color("red")))))
    assert color_word(parts["jacket"]) == "blue"
    assert color_word(parts["t_shirt"]) == "red"


@pytest.mark.parametrize(
    ("phrase", "kind", "color", "surface", "unread"),
    [
        ("black t-shirt", "t-shirt", "black", "", ()),
        ("dark blue leather jacket", "jacket", "dark blue", "leather", ()),
        ("long red dress", "gown", "red", "", ()),
        ("blue jeans", "jeans", "", "", ()),
        ("long blond hair", "long hair", "#d8b468", "", ()),
        ("dark brown hair", "hair", "#54382a", "", ()),
        ("pink dresses", "dress", "pink", "", ()),
        ("torn red coat", "coat", "red", "", ("torn",)),
        ("red and white scarf", "scarf", "", "", ("red", "white")),
    ],
)
def test_phrases_are_read(
    phrase: str, kind: str, color: str, surface: str, unread: tuple[str, ...]
) -> None:
    worn = read(phrase, COLORS)
    assert worn is not None
    assert (worn.garment.kind, worn.color, worn.surface, worn.unread) == (
        kind, color, surface, unread,
    )  # fmt: skip


def test_a_phrase_that_names_no_garment_is_none() -> None:
    assert read("red sari", COLORS) is None
    assert read("", COLORS) is None


def test_people_and_animals_of_the_lexicon_can_be_dressed() -> None:
    assert wearers()["person"] == {"people"}
    assert wearers()["dog"] == {"beasts", "quadrupeds"}
    assert "snake" not in wearers()
