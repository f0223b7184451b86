"""What one thing does after another one: held back, and stated for the judge."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, Predicate, Statement
from esg.metrics.expectations import expectations_from_timeline
from esg.metrics.plausibility.told import told_of


def _said(doc: EsgDocument, *says: Predicate) -> list[Statement]:
    return [s for s in doc.statements or () if s.predicate in says]


@pytest.mark.parametrize(
    ("prompt", "who", "event"),
    [
        ("After the bus stops, a dog runs across the street.", "dog_1", "bus_1_stop"),
        ("A vase falls off a shelf, then a ball rolls into a wall.", "ball_1", "vase_1_fall"),
        ("Once the gate closes, a tractor drives off.", "tractor_1", "gate_1_close"),
        (
            "A crate lands on the deck and after that a sailor walks away.",
            "sailor_1",
            "crate_1_deck_1_collision",
        ),
        ("After the bus stops, a dog runs into a ball.", "dog_1", "bus_1_stop"),
        (
            "The ball stops. Then a boy kicks a second ball into the goal.",
            "second_ball_1",
            "ball_1_stop",
        ),
    ],
)
def test_who_comes_later_is_said_to_stand_until_then(prompt: str, who: str, event: str) -> None:
    """State that it stays still until the other one's event, and put its start after it."""
    doc = draft(prompt)
    said = _said(doc, Predicate.STAYS_STILL)
    assert [(s.object, s.when) for s in said] == [((who,), f"start..{event}")]
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    first = next(e for e in graph.edges if e.actor == who)
    trigger = next(n for n in graph.nodes if n.id == first.to)
    assert [(c.quantity, c.since) for c in trigger.constraints] == [("time_since", event)]


@pytest.mark.parametrize(
    ("prompt", "first", "second"),
    [
        (
            "A car brakes and stops; then a cyclist hits the car.",
            "car_1_stop",
            "cyclist_1_car_1_collision",
        ),
        (
            "The gate closes and then a tractor hits it.",
            "gate_1_close",
            "tractor_1_gate_1_collision",
        ),
    ],
)
def test_the_order_of_two_events_is_stated(prompt: str, first: str, second: str) -> None:
    """State an order that no segment between the two tells."""
    assert [s.object for s in _said(draft(prompt), Predicate.BEFORE)] == [(first, second)]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("When the lift arrives, a man walks to the window.", "When"),
        ("After the parade passes, a boy runs across the road.", "After"),
        ("A train leaves the station and then a porter crosses the track.", "then"),
    ],
)
def test_an_order_after_no_event_is_owned_up_to(prompt: str, words: str) -> None:
    """Own up where nothing that is measured ends what comes first."""
    lost = _said(draft(prompt), Predicate.NOT_REPRESENTED)
    assert words in [s.text for s in lost if "order" in s.note]


def test_an_order_along_one_motion_is_not_stated_twice() -> None:
    """Leave an order to the judge of events where segments lead from one to the other."""
    doc = draft("A ball hits a box and then rolls into a wall.")
    assert not _said(doc, Predicate.BEFORE, Predicate.STAYS_STILL)


@pytest.mark.parametrize(
    "prompt",
    [
        "A marble hits the first domino, and the last domino falls.",
        "A hand pushes the first book of a row and the last book topples.",
        "A toy car bumps the first block in a line, and at the end the last block topples.",
        "A ball knocks over the first brick in the row and finally the last brick falls.",
    ],
)
def test_the_last_of_a_row_falls_by_touch(prompt: str) -> None:
    """Give the last member of a row no motion of its own when the first one has been hit."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    graph = doc.timeline_system.sequence_graph
    last = next(n for n in doc.spatial_relation_graph.nodes if n.startswith("last_"))
    ways = [e for e in graph.edges if e.actor == last]
    assert [e.event.value for e in ways] == ["InertialConnector"]
    assert "Topple" in [n.event.value for n in graph.nodes if last in n.participants]


def test_a_member_of_a_row_that_starts_alone_is_owned_up_to() -> None:
    """Say that nothing is passed on to what meets something behind the row."""
    doc = draft("A finger tips the first of six dominoes and the last one hits a bell.")
    lost = [s.text for s in _said(doc, Predicate.NOT_REPRESENTED) if "by itself" in s.note]
    assert lost == ["hits"]


@pytest.mark.parametrize(
    ("prompt", "thing", "host"),
    [
        ("A toddler throws a teddy bear off the bed.", "teddy_bear_1", "bed_1"),
        ("A worker tosses a brick off the scaffold.", "brick_1", "scaffold_1"),
        ("A girl throws her shoe off the balcony.", "shoe_1", "balcony_1"),
    ],
)
def test_what_is_thrown_off_a_thing_falls_from_it(prompt: str, thing: str, host: str) -> None:
    """Start it there, without a flight, and ask the judge for that support."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    edges = doc.timeline_system.sequence_graph.edges
    assert all(e.params.elevation_deg is None for e in edges)
    region = doc.spatial_relation_graph.nodes[thing].semantic_region or ""
    assert doc.spatial_relation_graph.semantic_regions[region].parent_object == host
    falls = next(e for e in expectations_from_timeline(doc).events if e.type == "falls")
    assert falls.from_ == f"={host}"
    assert any("no hand throws" in s.note for s in _said(doc, Predicate.NOT_REPRESENTED))


@pytest.mark.parametrize(
    ("prompt", "nodes"),
    [
        ("A man puts his phone on the phone stand.", {"man_1", "phone_1", "phone_stand_1"}),
        ("A boy kicks over a drum stand.", {"boy_1", "drum_stand_1"}),
        ("A robot rolls past a bike rack.", {"robot_1", "rack_1"}),
        ("A skier sits on the ski lift.", {"skier_1", "ski_lift_1"}),
        ("A bus and a van stop.", {"bus_1", "van_1"}),
        ("A man sees a cat jump off a wall.", {"man_1", "cat_1", "wall_1"}),
        ("A cart collide with a barrel.", {"cart_1", "barrel_1"}),
    ],
)
def test_a_bare_verb_form_behind_one_thing_is_a_noun(prompt: str, nodes: set[str]) -> None:
    """Read what a compound ends in, and leave the verbs of several and of learners."""
    found = {n for n, x in draft(prompt).spatial_relation_graph.nodes.items() if x.mentioned}
    assert found == nodes


@pytest.mark.parametrize(
    ("prompt", "node", "asset"),
    [
        ("The bowler knocks over the stumps.", "stump_1", "cricket stump"),
        ("A block slides down a 30 degree plane.", "plane_1", "ramp"),
        ("A cylinder rolls without slipping down a smooth plane.", "plane_1", "ramp"),
    ],
)
def test_a_noun_means_what_its_scene_makes_of_it(prompt: str, node: str, asset: str) -> None:
    """Take the stumps of cricket for no tree stumps, and a slope for no aircraft."""
    doc = draft(prompt)
    found = doc.asset_requirement[doc.spatial_relation_graph.nodes[node].asset_id]
    assert asset.split()[-1] in str(found)
    assert "tree" not in str(found) and "airplane" not in str(found)


@pytest.mark.parametrize(
    ("prompt", "thing", "host"),
    [
        ("A lamp behind a chair, with a hat on the chair.", "hat_1", "chair_1"),
        ("A cube left of a box, with a cone on top of the box.", "cone_1", "box_1"),
        ("A painter falls from a ladder.", "painter_1", "ladder_1"),
        ("A crate falls from the harbour edge into the water.", "crate_1", "harbour_edge_1"),
    ],
)
def test_what_stands_on_a_thing_is_on_it(prompt: str, thing: str, host: str) -> None:
    """Put on its support what a phrase behind a comma, or a fall, says to be there."""
    graph = draft(prompt).spatial_relation_graph
    region = graph.nodes[thing].semantic_region or ""
    assert graph.semantic_regions[region].parent_object == host


@pytest.mark.parametrize(
    ("prompt", "load", "host"),
    [
        ("A man drops a tray with a cup on it.", "cup_1", "tray_1"),
        ("A man throws a plate with a cake on it.", "cake_1", "plate_1"),
        ("A crane drops a pallet with three barrels on it onto a car.", "barrel_1", "pallet_1"),
    ],
)
def test_what_is_on_a_thing_is_no_place_to_land_on(prompt: str, load: str, host: str) -> None:
    """Put the load on what has it, and let that meet nothing of its own load."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    assert not any(load in n.participants for n in nodes)
    assert told_of(doc).stands_on[load] == host


@pytest.mark.parametrize(
    ("prompt", "load", "host"),
    [
        ("A skateboard with a helmet lying on it rolls into the curb.", "helmet_1", "skateboard_1"),
        ("A cart with a box sitting on it rolls into a wall.", "box_1", "cart_1"),
        ("A wagon with a crate standing on it is hit by a car.", "crate_1", "wagon_1"),
        ("A shelf with a vase on it topples.", "vase_1", "shelf_1"),
        ("A wheelbarrow with a pot in it rolls into a wall.", "pot_1", "wheelbarrow_1"),
        ("A cart with a 40 kg crate in it hits a wall.", "crate_1", "cart_1"),
    ],
)
def test_what_a_thing_has_on_it_is_on_it(prompt: str, load: str, host: str) -> None:
    """Lay it there, whatever verb says how, and ask for no place near it besides."""
    doc = draft(prompt)
    assert told_of(doc).stands_on[load] == host
    edges = doc.spatial_relation_graph.model_dump_json()
    assert '"near"' not in edges and '"NEAR"' not in edges
