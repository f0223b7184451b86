"""The resolve stage: sizes, masses, materials, fallbacks, purity."""

from __future__ import annotations

import math

import pytest

from esg.assets import resolve
from esg.assets.library.catalogue import entries_by_name
from esg.assets.stage import configure
from esg.graph.models import AssetRequirement
from tests.assets.worlds import EMPTY, requirement


def need(category: str, **changes: object) -> AssetRequirement:
    values: dict[str, object] = {
        "asset_category": category,
        "asset_description": category,
        "expected_dimensions_cm": (40, 40, 40),
        "expected_mass_kg": 5.0,
    }
    return AssetRequirement.model_validate(values | changes)


def known(name: str, **changes: object) -> AssetRequirement:
    return requirement(entries_by_name()[name], **changes)


def test_stage_is_pure_and_repeatable() -> None:
    doc = EMPTY.model_copy(
        update={"asset_requirement": {"a": known("car"), "b": need("flux capacitor")}}
    )
    before = doc.model_dump_json()
    one, two = resolve(doc, seed=3), resolve(doc, seed=3)
    assert doc.model_dump_json() == before
    assert one.model_dump_json() == two.model_dump_json()
    assert set(one.asset_configurations) == {"a", "b"}
    assert [p.stage for p in one.provenance] == ["resolve"]
    assert resolve(one, seed=3).model_dump_json() == one.model_dump_json()


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("car", "car"),
        ("trash bin", "trash_bin"),
        ("trash-bin", "trash_bin"),
        ("trashbin", "trash_bin"),
        ("Bowling_Pins", "bowling_pin"),
        ("pool table", "billiard_table"),
        ("sidewalk", "pavement"),
    ],
)
def test_names_and_synonyms_decide_at_once(text: str, name: str) -> None:
    config = configure("x", known(name, asset_category=text))
    assert config.asset_name == name
    assert config.confidence == 1.0
    assert config.source == "parametric"


def test_unknown_noun_becomes_a_plain_body_of_the_asked_size() -> None:
    config = configure(
        "x", need("vorpal", expected_dimensions_cm=(300, 120, 200), expected_mass_kg=900)
    )
    assert config.source == "fallback"
    assert config.dimensions_cm == (300, 120, 200)
    assert config.mass_kg == 900
    assert config.proxies
    assert config.runners_up
    assert config.confidence < 0.65


def test_unknown_round_noun_rolls() -> None:
    config = configure("x", need("zorbball", shape="sphere", expected_dimensions_cm=(30, 30, 30)))
    assert config.rolls and config.proxies[0].kind.value == "sphere"


def test_prescribed_mass_and_size_win() -> None:
    ball = configure("x", known("basketball", expected_mass_kg=10, mass_is_prescribed=True))
    assert ball.mass_kg == 10
    r = ball.dimensions_cm[2] / 2
    assert ball.inertia_kg_cm2[0] == pytest.approx(0.4 * 10 * r * r)
    table = configure(
        "x", known("table", expected_dimensions_cm=(100, 300, 90), dimensions_are_prescribed=True)
    )
    assert table.dimensions_cm == (100, 300, 90)
    assert max(s.center_cm[2] for s in table.support_surfaces) == 90
    big = configure(
        "x", known("ball", expected_dimensions_cm=(100, 100, 100), dimensions_are_prescribed=True)
    )
    assert big.dimensions_cm == pytest.approx((100, 100, 100))
    assert big.proxies[0].size_cm[0] == pytest.approx(50)


def test_length_and_width_may_be_swapped_in_an_expectation() -> None:
    assert configure("x", known("desk", expected_dimensions_cm=(140, 70, 75))).dimensions_cm == (
        70,
        140,
        75,
    )


def test_material_changes_mass_friction_and_look_of_a_solid() -> None:
    wood = configure("x", known("block"))
    steel = configure("x", known("block", material="steel", expected_mass_kg=7.8))
    assert steel.mass_kg == pytest.approx(7.8)
    assert steel.color_rgb != wood.color_rgb
    assert steel.friction != wood.friction


def test_naming_the_usual_material_changes_nothing() -> None:
    assert configure("x", known("soccer_ball", material="leather")).mass_kg == pytest.approx(0.43)
    assert configure("x", known("car", material="steel")).friction == 0.1


def test_implausible_expectations_are_bracketed_by_the_sourced_mass() -> None:
    usual = entries_by_name()["car"].mass_kg
    assert usual == pytest.approx(1450, rel=0.05)
    assert configure("x", known("car", expected_mass_kg=1.0)).mass_kg == pytest.approx(usual / 2)
    assert configure("x", known("car", expected_mass_kg=1800)).mass_kg == 1800


def test_vehicles_are_wheeled_and_structures_fixed() -> None:
    car = configure("x", known("car"))
    assert car.is_wheeled and car.is_movable and car.friction == 0.1
    assert 45 <= car.center_of_mass_cm[2] <= 70
    for name in ("billiard_table", "road", "wall", "stairs"):
        assert not configure("x", known(name)).is_movable
    assert not configure("x", known("road")).proxies


def test_color_words_reach_the_configuration() -> None:
    r, g, b = configure("x", known("car", color="dark blue")).color_rgb
    assert b > r and b > g


def test_billiard_table_has_six_pockets_on_the_right_sides() -> None:
    table = configure("x", known("billiard_table"))
    pockets = {r.name: r.center_cm for r in table.regions if r.kind == "pocket"}
    assert set(pockets) == {
        f"{end} {side} pocket" for end in ("top", "middle", "bottom") for side in ("left", "right")
    }
    for name, (x, y, _) in pockets.items():
        assert (y > 0) == ("left" in name)
        assert (x > 50) == ("top" in name) and (x < -50) == ("bottom" in name)
    bed = next(s for s in table.support_surfaces if s.name == "bed")
    assert bed.center_cm[2] == pytest.approx(77)


def test_goal_is_hollow_towards_its_front() -> None:
    goal = configure("x", known("goal"))
    region = next(r for r in goal.regions if r.name == "inside")
    assert region.half_extents_cm[1] * 2 > 700
    front = goal.dimensions_cm[0] / 2
    for proxy in goal.proxies:
        blocks_mouth = proxy.size_cm[1] > 300 and abs(proxy.position_cm[0] - front) < 20
        assert not blocks_mouth or proxy.position_cm[2] > 200


def test_open_containers_have_an_inside_that_no_proxy_fills() -> None:
    for name in ("open_box", "bucket", "basket", "bowl", "mug", "dumpster"):
        config = configure("x", known(name))
        region = next(r for r in config.regions if r.name == "inside")
        for proxy in config.proxies:
            gap = math.dist(proxy.position_cm, region.center_cm)
            assert gap > 0.2 * region.half_extents_cm[0], name


def test_twenty_known_objects_need_no_embedding(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise AssertionError("the model was loaded for a known noun")

    monkeypatch.setattr("esg.assets.library.embed._session", refuse)
    for name in list(entries_by_name())[:20]:
        assert configure("x", known(name)).asset_name == name
