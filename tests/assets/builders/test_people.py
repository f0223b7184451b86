"""People are dressed by what they are, and fall alike."""

from __future__ import annotations

import pytest

from esg.assets import build_mesh, catalogue
from esg.assets.library.catalogue import Entry, entries_by_name
from esg.assets.stage import configure
from esg.graph.models import AssetRequirement
from tests.assets.worlds import requirement

PEOPLE = [e for e in catalogue() if e.builder == "figure"]


def drafted(words: str, **changes: object) -> AssetRequirement:
    """A person as a drafter files one."""
    values: dict[str, object] = {
        "asset_category": "person",
        "asset_description": f"{words}: standing adult person, cloth",
        "expected_dimensions_cm": (35, 50, 172),
        "expected_mass_kg": 70.0,
    }
    return AssetRequirement.model_validate(values | changes)


def colours(words: str) -> set[tuple[int, ...]]:
    scene = build_mesh(configure("a", drafted(words)))
    return {tuple(g.visual.material.baseColorFactor) for g in scene.geometry.values()}


@pytest.mark.parametrize("entry", PEOPLE, ids=lambda e: e.name)
def test_clothes_change_nothing_physical(entry: Entry) -> None:
    """The same hulls, mass, centre of mass and inertia as a person in plain clothes."""
    plain = entries_by_name()["person"]
    one, other = (configure("a", requirement(e)) for e in (plain, entry))
    for name in ("proxies", "mass_kg", "center_of_mass_cm", "inertia_kg_cm2", "dimensions_cm"):
        assert getattr(one, name) == getattr(other, name), name


@pytest.mark.parametrize(
    ("words", "kind"),
    [
        ("chef", "chef"),
        ("construction worker", "worker"),
        ("policewoman", "police_officer"),
        ("nurse", "doctor"),
        ("goalkeeper", "athlete"),
        ("queen", "woman"),
        ("pedestrian", "person"),
    ],
)
def test_a_noun_is_dressed_and_keeps_what_was_expected_of_it(words: str, kind: str) -> None:
    """Size and mass that a drafter expects are not replaced by those of the clothes."""
    config = configure("a", drafted(words))
    assert (config.asset_name, config.category) == (kind, "person")
    tall = {"expected_dimensions_cm": (35, 58, 200), "expected_mass_kg": 95.0}
    one, other = (configure("a", drafted(w, **tall)) for w in (words, "man"))
    assert (one.dimensions_cm, one.mass_kg) == (other.dimensions_cm, other.mass_kg)


def test_jobs_do_not_look_alike() -> None:
    """Pairwise different sets of colours."""
    jobs = ("chef", "builder", "policeman", "firefighter", "knight", "clown", "king", "cowboy")
    seen = [frozenset(colours(j)) for j in jobs]
    assert len(set(seen)) == len(jobs)
