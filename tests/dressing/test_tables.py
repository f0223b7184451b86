"""The tables of places name what there is, and every place can be furnished from them."""

from __future__ import annotations

import pytest

from esg.assets.library.catalogue import entries_by_name
from esg.assets.materials import MATERIALS
from esg.dressing.builders import BUILDERS
from esg.lexicon.places import drawn, places, skies, standing, surfaces, things

WHERE = {"rail", "run", "ring", "water", "wall", "against", "hung"}
SIDES = {"all", "long", "ends", "front", "back", "rest", "+x", "-x", "+y", "-y"}


def test_every_thing_has_somebody_who_draws_it() -> None:
    for name in things():
        assert (name in BUILDERS) != (name in entries_by_name()), name


def test_no_builder_is_forgotten() -> None:
    assert set(BUILDERS) <= things()


def test_every_surface_is_a_material() -> None:
    for surface in surfaces().values():
        assert surface.material in MATERIALS, surface.name


@pytest.mark.parametrize("name", places())
def test_a_place_has_a_ground_and_things_of_known_surfaces(name: str) -> None:
    place, rows = places()[name], standing(name)
    assert place.surface in surfaces()
    assert len(rows) >= 4
    for row in rows:
        assert row.where in WHERE and row.sides in SIDES, row.item
        assert set(row.surfaces) <= set(surfaces())
        assert 0.0 < row.chance <= 1.0
        assert row.away_m[0] <= row.away_m[1] and row.count[0] <= row.count[1]
    for line in drawn(name):
        assert line.surface in surfaces()


@pytest.mark.parametrize("name", [p.name for p in places().values() if p.setting == "indoor"])
def test_a_room_has_walls_on_all_sides(name: str) -> None:
    covered = {
        "all": "+x -x +y -y", "long": "+y -y", "ends": "+x -x", "rest": "", "back": "+y -y +x -x",
        "front": "",
    }  # fmt: skip
    sides = {
        s
        for r in standing(name)
        if r.where == "wall"
        for s in covered.get(r.sides, r.sides).split()
    }
    assert sides == {"+x", "-x", "+y", "-y"}
    assert places()[name].height_m >= 2.5 and min(places()[name].least_m) >= 4.0


def test_sixteen_kinds_of_place_that_prompts_speak_of_are_there() -> None:
    wanted = (
        "street park car_park warehouse kitchen living_room office gym bowling_alley billiard_hall "
        "pitch beach ice_rink workshop playground harbour"
    )
    assert set(wanted.split()) <= set(places())


def test_there_is_light_for_every_place_and_at_night() -> None:
    for setting in ("indoor", "outdoor"):
        rows = [s for s in skies().values() if s.setting == setting]
        assert sum(s.weight for s in rows) > 0
        assert any("night" in s.said_as for s in rows)
        for row in rows:
            assert 0 < row.elevation_deg[0] <= row.elevation_deg[1] < 90
