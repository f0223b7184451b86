"""The table of materials: physics and look in one row, and every part of every asset in it."""

from __future__ import annotations

import csv
import hashlib
from pathlib import Path

import pytest

from esg.assets.builders.common import shade
from esg.assets.geometry.mesh import configured_sketch
from esg.assets.geometry.sketch import finish
from esg.assets.library.catalogue import Entry, entries_by_name, finishes
from esg.assets.materials import MATERIALS, TABLE, find_material, look_of, visible
from esg.assets.stage import configure
from esg.assets.textures import linear, recipes
from tests.assets.worlds import requirement

ENTRIES = list(entries_by_name().values())
PHYSICAL = 46
"""Rows that were there before materials had a look; their figures are part of scenes."""


def test_every_row_is_whole() -> None:
    with TABLE.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({r["name"] for r in rows}) == len(rows) >= 80
    for name, m in MATERIALS.items():
        assert 10 < m.density < 20000 and 0 <= m.friction < 1 and 0 <= m.restitution < 1, name
        assert m.source, name
        assert all(0 <= c <= 1 for c in (*m.color, m.roughness, m.metalness, m.alpha)), name
        assert m.texture is None or (m.texture in recipes() and 0.01 < m.tile_m < 5), name
        assert m.coat is None or (MATERIALS[m.coat].coat is None and m.coat != name), name
        assert m.stands_for <= MATERIALS.keys(), name
    assert {m.texture for m in MATERIALS.values()} - {None} == recipes().keys()


def test_figures_of_contact_are_what_they_were() -> None:
    """A look must not change how anything slides, bounces or weighs: a digest of those figures."""
    rows = list(MATERIALS.values())[:PHYSICAL]
    text = ";".join(f"{m.name},{m.density},{m.friction},{m.restitution}" for m in rows)
    assert hashlib.sha256(text.encode()).hexdigest()[:16] == "34bac0c42cba410d"


def test_words_name_one_material_and_looks_add_none() -> None:
    words = [w for m in MATERIALS.values() for w in m.words]
    assert len(words) == len(set(words))
    assert not any(m.words for m in list(MATERIALS.values())[PHYSICAL:])
    for word, name in (("oak", "wood"), ("Stainless-Steel", "steel"), ("felt", "textile")):
        found = find_material(word)
        assert found is not None and found.name == name
    assert find_material("sand") is None and find_material("chrome") is None


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.name)
def test_every_part_names_a_material(entry: Entry) -> None:
    config = configure(entry.name, requirement(entry))
    for part in configured_sketch(entry, config).parts:
        assert part.material in MATERIALS, part.name
        assert part.name and not part.name.startswith("part_")
        assert look_of(part.material, part.color).material in MATERIALS


def test_finishes_are_of_kinds_and_materials_and_differ_from_the_surface() -> None:
    entries = entries_by_name()
    for kind, material in finishes().items():
        assert material in MATERIALS and entries[kind].material != material, kind


def test_metal_in_another_colour_is_painted() -> None:
    assert visible("steel", None).name == visible("steel", (0.55, 0.56, 0.6)).name == "steel"
    assert visible("steel", (0.8, 0.1, 0.1)).name == "paint"
    assert look_of("steel", (0.8, 0.1, 0.1)).metalness == 0.0
    assert visible("wood", (0.8, 0.1, 0.1)).name == "wood"


@pytest.mark.parametrize("name", ["oak", "textile", "asphalt", "paint", "concrete"])
def test_a_surface_has_its_colour_on_average(name: str) -> None:
    """Factor times the texture's mean is the colour, in linear light."""
    color = (0.42, 0.31, 0.27)
    look = look_of(name, color)
    mean = linear(recipes()[look.texture].mean) if look.texture else 1.0
    assert linear(look.color) * mean == pytest.approx(linear(color), abs=2e-4)


def test_a_tone_keeps_its_material() -> None:
    tone = shade(finish("oak"), 0.5)
    assert getattr(tone, "material", "") == "oak"
    assert tuple(tone) == pytest.approx([0.5 * c for c in MATERIALS["oak"].color])


def test_a_sheet_shows_them_all(tmp_path: Path) -> None:
    from PIL import Image

    from esg.assets.swatches import materials_sheet

    path = tmp_path / "sheet.png"
    assert materials_sheet(path, columns=16, size=24) == len(MATERIALS)
    with Image.open(path) as image:
        assert image.width == 16 * 24
        assert len(image.getcolors(1 << 20) or ()) > 500


def test_a_stated_material_is_seen() -> None:
    """A wooden ball is of wood, and one of which nobody said so of rubber."""
    from esg.assets import build_mesh, resolve
    from esg.assets.appearances import appearances
    from esg.draft import draft

    def seen(prompt: str) -> set[str]:
        doc = resolve(draft(prompt))
        (name,) = (n for n, node in doc.spatial_relation_graph.nodes.items() if "ball" in n)
        config = doc.asset_configurations[doc.spatial_relation_graph.nodes[name].asset_id]
        scene = build_mesh(config, appearances(doc)[name])
        return {mesh.metadata["look"].material for mesh in scene.geometry.values()}

    assert "wood" in seen("A wooden ball rolls into a crate.")
    assert "rubber" in seen("A ball rolls into a crate.")
