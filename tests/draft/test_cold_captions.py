"""What captions that were written cold lost or invented, each as one general way of telling."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def mentioned(doc: EsgDocument) -> set[str]:
    """The things that the prompt names, without the ground."""
    nodes = doc.spatial_relation_graph.nodes
    return {name for name, node in nodes.items() if node.mentioned and name != "ground_1"}


def told(doc: EsgDocument) -> list[tuple[str, ...]]:
    """Point events but for the scaffolding."""
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    scaffolding = ("SceneStart", "Trigger")
    return [(n.event.value, *n.participants) for n in nodes if n.event.value not in scaffolding]


def stated(doc: EsgDocument) -> set[tuple[str, str | None, tuple[str, ...], tuple[str, ...]]]:
    """Predicate, direction, who and what of every statement that is held."""
    kept = (s for s in doc.statements or () if s.predicate is not Predicate.NOT_REPRESENTED)
    return {(s.predicate.value, s.direction, (*s.object,), (*s.target,)) for s in kept}


def lost(doc: EsgDocument) -> list[str]:
    """Words that the draft owns up to by statements."""
    return [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]


def region(doc: EsgDocument, node: str) -> str | None:
    return doc.spatial_relation_graph.nodes[node].semantic_region


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A cart leaps over a box with the grace of a dancer.", {"cart_1", "box_1"}),
        ("A crate slides off the bed of a truck.", {"crate_1", "truck_1"}),
        ("A van brakes hard, tyres squealing.", {"van_1"}),
        ("A taxi drives past, the wheels spinning.", {"taxi_1"}),
        ("A statue of a horse stands beside a gate.", {"statue_1", "gate_1"}),
        ("A dog runs past a bench, oil painting.", {"dog_1", "bench_1"}),
        ("A dog runs past a bench, black and white.", {"dog_1", "bench_1"}),
        ("A baker cuts a loaf in half, and one half falls.", {"baker_1", "loaf_1"}),
        ("A toy train goes around a sharp curve.", {"toy_train_1"}),
        ("A cook splashes water on a plate.", {"cook_1", "plate_1"}),
        ("A sailor waves at the coast of Norway.", {"sailor_1"}),
        ("A maid wipes a mirror with a cloth.", {"maid_1", "mirror_1", "cloth_1"}),
        ("The lid falls off a pot.", {"lid_1", "pot_1"}),
        ("Three red tops are spinning.", {"red_top_1", "red_top_2", "red_top_3"}),
        ("A koala chewing leaves in a zoo.", {"koala_1"}),
        ("Happy team with a trophy.", {"person_1", "person_2", "person_3", "person_4", "trophy_1"}),
    ],
)  # fmt: skip
def test_only_things_are_drawn(prompt: str, things: set[str]) -> None:
    assert mentioned(draft(prompt)) >= things
    extra = mentioned(draft(prompt)) - things
    assert not extra - {"leaf_1", "leaf_2", "leaf_3"}, extra


def test_a_number_follows_a_verb_and_no_noun() -> None:
    doc = draft("A ball knocks over six pins and leaves two standing.")
    assert not any("leaf" in name for name in mentioned(doc))


@pytest.mark.parametrize(
    "prompt",
    [
        "lift the cup from the shelf and drop it into the box",
        "grasp the cup and drop it in the box",
    ],
)
def test_a_command_drops_what_it_lifts(prompt: str) -> None:
    doc = draft(prompt)
    assert told(doc) == [("PickedUp", "cup_1"), ("EnterRegion", "cup_1")]
    assert "inside" not in (region(doc, "cup_1") or "")
    assert not verify(doc)


def test_what_is_dropped_in_a_bowl_is_not_there_before() -> None:
    doc = draft("A girl drops a marble in a bowl.")
    assert region(doc, "marble_1") == "ground_area_1"
    assert ("EnterRegion", "marble_1") in told(doc)


def test_each_rides_one() -> None:
    doc = draft("Two women riding horses along a fence.")
    assert {n for n in mentioned(doc) if "horse" in n} == {"horse_1", "horse_2"}
    for rider, mount in (("woman_1", "horse_1"), ("woman_2", "horse_2")):
        assert region(doc, rider) == f"{mount}_surface"
        assert ("supported_by", None, (rider,), (mount,)) in stated(doc)


@pytest.mark.parametrize(
    ("prompt", "who", "host"),
    [
        ("Two men sit in a canoe.", "man_1", "canoe_1"),
        ("A parrot sits on the back of a donkey.", "parrot_1", "donkey_1"),
        ("A crow flies from a roof to a pole.", "crow_1", "roof_1"),
    ],
)
def test_who_is_carried_is_on_it(prompt: str, who: str, host: str) -> None:
    assert region(draft(prompt), who) == f"{host}_surface"


def test_who_is_in_a_boat_moves_with_it() -> None:
    doc = draft("A boy in a canoe passes a buoy.")
    assert told(doc) == [("Miss", "canoe_1", "buoy_1")]


def test_an_unknown_verb_with_an_object_moves_nobody() -> None:
    doc = draft("A cook ladles soup into a bowl.")
    assert told(doc) == []


def test_passengers_are_no_vehicle() -> None:
    doc = draft("A tram stops at a kiosk and two passengers get off.")
    assert {"passenger_1", "passenger_2"} <= mentioned(doc)


def test_what_moves_apart_is_stated_away_from_each_other() -> None:
    doc = draft("Two pucks hit each other and slide apart.")
    assert ("moves", "away_from", ("puck_1",), ("puck_2",)) in stated(doc)
    assert lost(draft("Two pucks lie 2 m apart.")) == []


def test_what_moves_toward_each_other_aims_at_each_other() -> None:
    timeline = draft("Two sheep walk toward each other.").timeline_system
    assert timeline is not None
    aims = {(e.actor, e.target) for e in timeline.sequence_graph.edges}
    assert aims == {("sheep_1", "sheep_2"), ("sheep_2", "sheep_1")}


def test_where_something_starts_is_kept() -> None:
    doc = draft("A goat runs from a hut to a fence.")
    relations = doc.spatial_relation_graph.edges.binary_relations
    assert ("goat_1", "near", "hut_1") in {
        (r.from_, r.relation_type.value, r.to) for r in relations
    }
    assert lost(doc) == []
    assert lost(draft("A drone rises from the ground.")) == []


def test_a_place_behind_somebody_is_his() -> None:
    doc = draft("A man throws a coin onto a table behind him.")
    relations = doc.spatial_relation_graph.edges.binary_relations
    assert ("table_1", "behind", "man_1") in {
        (r.from_, r.relation_type.value, r.to) for r in relations
    }


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A spinning carousel stands beside a tree.", "spinning"),
        ("Four books are stacked; a ball hits the bottom one, which shoots out.", "out"),
        ("Five joggers run in single file; the second one stops.", "in single file"),
        ("A cat walks behind a sofa and comes out.", "out"),
        ("Two balls roll under a table, and only one comes out.", "only"),
    ],
)
def test_what_nothing_shows_is_owned_up_to(prompt: str, words: str) -> None:
    assert words in lost(draft(prompt))


def test_nothing_happens_to_what_is_drawn_as_a_joint() -> None:
    doc = draft("A crate hangs from a crane by a rope. A gull flies against the rope.")
    assert not verify(doc)
    assert "flies" in lost(doc)


@pytest.mark.parametrize(
    "prompt",
    [
        "A lamp hanging from the ceiling sways after a basketball hits it.",
        "A punching bag hanging from the ceiling swings when a robot hits it.",
        "A chandelier that hangs from the ceiling falls onto a table.",
    ],
)
def test_what_hangs_from_the_ceiling_is_told(prompt: str) -> None:
    doc = draft(prompt)
    assert "from the ceiling" not in lost(doc)
    assert any(s.predicate == "hangs_from" for s in doc.statements)


@pytest.mark.parametrize(
    ("prompt", "seconds"),
    [("At 09:15 a ball rolls into a wall.", "555.0"), ("A car hits a cone at 14:30.", "870.0")],
)
def test_a_time_of_day_is_no_moment_of_the_scene(prompt: str, seconds: str) -> None:
    timeline = draft(prompt).timeline_system
    assert timeline is not None and seconds not in timeline.model_dump_json()
