"""What the choreography and the casting make possible before anything is searched."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.choreography.falling.falls import tipping_speed
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.edges import edge_of
from esg.dynamics.story.proxies import coarse, faceted
from esg.dynamics.story.stagecraft import Prop
from esg.dynamics.story.tipping import topple_speed
from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import AssetConfiguration, EsgDocument

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def _prop(**changes: float) -> Prop:
    values = {
        "length": 0.5, "width": 0.5, "height": 1.0, "mass": 10.0, "friction": 0.5,
        "restitution": 0.0, "rolls": False, "wheeled": False, "fixed": False,
    }  # fmt: skip
    return Prop(**{**values, **changes})  # type: ignore[arg-type]


def test_topple_speed_grows_with_the_targets_mass() -> None:
    """Linear in the target's mass for a light mover, and zero for what cannot fall."""
    ball = _prop(length=0.22, width=0.22, height=0.22, mass=0.43, rolls=True)
    light, heavy = (topple_speed(ball, _prop(mass=m), flies=True) for m in (5.0, 10.0))
    assert light < heavy < 2.0 * light
    assert topple_speed(ball, _prop(fixed=True), flies=True) == 0.0


def test_tipping_speed_is_the_energy_over_the_edge() -> None:
    """A thin plate of height h tips with almost no speed; a cube needs much more."""
    assert tipping_speed(0.01, 1.0) < 0.1 < tipping_speed(1.0, 1.0)
    rise = 0.5 * (math.sqrt(2.0) - 1.0)
    omega = math.sqrt(2.0 * 9.81 * rise * 3.0 / 2.0)
    assert tipping_speed(1.0, 1.0) == pytest.approx(1.33 * omega * 0.5, rel=0.01)


def test_a_light_ball_gets_a_crate_it_can_knock_over() -> None:
    """Mass and size are open: an empty crate, or a smaller one; a stated mass is never touched."""
    free = resolve(draft("A soccer ball is kicked at a wooden crate and knocks it over."))
    stated = resolve(
        draft("A soccer ball is kicked at a wooden crate weighing 15 kg and knocks it over.")
    )

    def crate(doc: EsgDocument) -> AssetConfiguration:
        node = next(n for n in doc.spatial_relation_graph.nodes if "crate" in n)
        return doc.asset_configurations[doc.spatial_relation_graph.nodes[node].asset_id]

    usual, chosen = crate(free), crate(fitted(free))
    share = (chosen.dimensions_cm[2] / usual.dimensions_cm[2]) ** 3
    assert 0.999 * 0.3 * share * usual.mass_kg <= chosen.mass_kg < usual.mass_kg
    assert 0.5**3 <= share <= 1.0
    assert crate(fitted(stated)) == crate(stated)


def test_what_shall_fall_over_is_not_fixed_to_the_ground() -> None:
    """A fence that a tire knocks down can move; one that is only hit stays fixed."""

    def movable(prompt: str) -> bool:
        doc = fitted(resolve(draft(prompt)))
        node = next(n for n in doc.spatial_relation_graph.nodes if "fence" in n)
        asset = doc.spatial_relation_graph.nodes[node].asset_id
        return doc.asset_configurations[asset].is_movable

    assert movable("A tire rolls along and knocks down a fence.")
    assert not movable("A car crashes into a fence.")


@pytest.mark.parametrize(
    ("prompt", "mover", "target"),
    [
        ("A marble rolls off the table and falls into a mug on the floor.", "marble", "mug"),
        ("A brick falls from a shelf and lands on a laptop.", "brick", "laptop"),
    ],
)
def test_what_leaves_a_table_comes_down_on_its_target(prompt: str, mover: str, target: str) -> None:
    """The target waits where free fall from the edge leads, clear of the support."""
    doc = fitted(resolve(draft(prompt)))
    hints = start_hints(doc)
    stage = next(c for c in hints.constellations if c.anchor)
    places = {p.node.split("_")[0]: p for p in stage.placements}
    assert mover in places and target in places
    gap = places[target].x_cm - places[mover].x_cm
    assert 5.0 < gap < 150.0
    assert abs(places[target].y_cm - places[mover].y_cm) < 5.0


def test_what_falls_off_a_truck_leaves_it_where_nothing_is_in_its_way() -> None:
    """The cab juts out before the roof of the body: a crate comes down behind the truck."""
    doc = fitted(resolve(draft("A crate falls off a truck and hits a bollard.")))
    edge = edge_of(doc, "truck_1")
    truck = doc.asset_configurations[doc.spatial_relation_graph.nodes["truck_1"].asset_id]
    assert edge.backwards
    assert edge.at == pytest.approx(truck.dimensions_cm[0] / 200.0, abs=0.05)
    table = fitted(resolve(draft("A ball rolls off a table and lands on a mat.")))
    assert not edge_of(table, "table_1").backwards
    (constellation,) = start_hints(doc).constellations
    at = {p.node: p.x_cm for p in constellation.placements}
    assert at["bollard_1"] < -0.5 * truck.dimensions_cm[0] < at["crate_1"] < 0.0


def test_a_target_as_high_as_the_support_is_met_on_the_ground() -> None:
    """Onto a crate of almost the table's height nothing falls far: it stands a body's length off."""
    doc = fitted(resolve(draft("A box slides off a table and hits a wardrobe.")))
    (constellation,) = start_hints(doc).constellations
    at = {p.node: p for p in constellation.placements}
    nodes = doc.spatial_relation_graph.nodes
    size = {n: doc.asset_configurations[nodes[n].asset_id].dimensions_cm for n in at}
    gap = at["wardrobe_1"].x_cm - 100.0 * edge_of(doc, "table_1").at
    assert gap > 0.5 * size["wardrobe_1"][0] + 0.5 * size["box_1"][0]


def test_an_event_timed_from_another_constellation_is_told_after_it() -> None:
    """Two cars that never meet: the blue one's hit is 3 s after the red one's, at 2 s."""
    doc = fitted(
        resolve(
            draft(
                "A red car hits a barrel after 2 seconds, and 3 seconds later a blue car hits a crate."
            )
        )
    )
    told = choreograph(doc).nominal
    first, second = (
        next(v for k, v in told.items() if k.endswith("/event_time") and n in k)
        for n in ("barrel", "crate")
    )
    assert first == pytest.approx(2.0, abs=0.05)
    assert second == pytest.approx(5.0, abs=0.05)


def test_what_is_hit_and_drives_on_by_itself_waits_on_the_hits_way() -> None:
    """A cart that is rammed and then rolls on stands in the truck's way, pointing along it."""
    doc = fitted(
        resolve(draft("A pickup truck reverses into a shopping cart, which rolls into a curb."))
    )
    (constellation,) = start_hints(doc).constellations
    at = {p.node: np.array([p.x_cm, p.y_cm]) for p in constellation.placements}
    first = at["shopping_cart_1"] - at["pickup_truck_1"]
    second = at["curb_1"] - at["shopping_cart_1"]
    cosine = first @ second / np.linalg.norm(first) / np.linalg.norm(second)
    assert cosine > 0.97


def test_facets_replace_cylinders_only() -> None:
    """Prisms have the cylinder's radius at their corners; scenes without cylinders are kept."""
    round_ = Body("can", False, 1.0, UNIT, (Shape("cylinder", (0.1, 0.1, 0.2)),), (0, 0, 0.2))
    box = Body("box", False, 1.0, UNIT, (Shape("box", (0.1, 0.1, 0.2)),), (1, 0, 0.2))
    scene = SimScene("s", (round_, box))
    other = faceted(scene)
    prism = other.bodies[0].shapes[0]
    assert prism.kind == "convex" and len(prism.vertices) == 32
    assert all(math.hypot(x, y) == pytest.approx(0.1) for x, y, _ in prism.vertices)
    assert other.bodies[1] == box
    assert faceted(SimScene("s", (box,))).bodies[0] is box


def test_simple_proxies_stand_on_the_ground() -> None:
    """One sphere or box a body, as wide as the body, its lowest point where the body's is."""
    compact = Body(
        "bin", False, 1.0, UNIT, (Shape("cylinder", (0.3, 0.3, 0.4)),), (0, 0, 0.4),
        origin_offset=(0.0, 0.0, -0.4), half_extents=(0.3, 0.3, 0.4),
    )  # fmt: skip
    long = Body(
        "car", False, 1.0, UNIT, (Shape("box", (2.0, 0.9, 0.7)),), (5, 0, 0.7),
        origin_offset=(0.0, 0.0, -0.5), half_extents=(2.0, 0.9, 0.7),
    )  # fmt: skip
    sphere, box = (b.shapes[0] for b in coarse(SimScene("s", (compact, long))).bodies)
    assert sphere.kind == "sphere" and sphere.size[0] == 0.3
    assert sphere.position[2] - sphere.size[0] == pytest.approx(-0.4)
    assert box.kind == "box" and box.position[2] - box.size[2] == pytest.approx(-0.5)
