"""The right word said of the right thing: who acts, what sense a word has, how many take part."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph.models import EsgDocument, NodeEvent, Predicate, TimelineNode
from tests.draft.told import drawn, events, owned, stated


def acting(doc: EsgDocument) -> set[str]:
    """The things that a timeline moves."""
    assert doc.timeline_system is not None
    return {e.actor for e in doc.timeline_system.sequence_graph.edges}


def kinds(doc: EsgDocument) -> set[str]:
    """The events of a timeline."""
    assert doc.timeline_system is not None
    return {n.event.value for n in doc.timeline_system.sequence_graph.nodes}


def related(doc: EsgDocument) -> set[tuple[str, str, str]]:
    """The relations of two things, but for which way they face."""
    told = doc.spatial_relation_graph.edges.binary_relations
    return {(r.from_, r.relation_type.value, r.to) for r in told if r.relation_type.value != "face"}


def held(doc: EsgDocument) -> dict[str, str]:
    """What carries or holds a thing."""
    graph = doc.spatial_relation_graph
    regions = {
        n: graph.semantic_regions.get(x.semantic_region or "") for n, x in graph.nodes.items()
    }
    hosts = {n: r.parent_object for n, r in regions.items() if r is not None}
    return {n: h for n, h in hosts.items() if not graph.nodes[h].is_structural}


def headed(doc: EsgDocument) -> set[tuple[str, str | None]]:
    """Who is stated to move which way."""
    return {(i, s.direction) for s in stated(doc, Predicate.MOVES) for i in s.object}


@pytest.mark.parametrize(
    "prompt",
    ["Two men walk left.", "A boy runs left across the yard.", "A truck driving left hits a barrel.",
     "A kitten follows a cat, both walking left."],
)  # fmt: skip
def test_left_after_a_verb_of_going_is_where_it_goes(prompt: str) -> None:
    doc = draft(prompt)
    assert "HeadingReached" not in kinds(doc)
    assert {way for _, way in headed(doc)} >= {"left"}


@pytest.mark.parametrize(
    "prompt",
    ["A man walks forward and then walks left.", "A car drives left at the junction.",
     "A car drives along a road and turns left."],
)  # fmt: skip
def test_left_of_what_goes_already_is_a_turn(prompt: str) -> None:
    assert "HeadingReached" in kinds(draft(prompt))


@pytest.mark.parametrize(
    "prompt",
    ["A wheel turns on a table.", "A globe is turning on a desk.", "A big disc turns faster.",
     "A plate is turning on a stick."],
)  # fmt: skip
def test_what_drives_nowhere_turns_where_it_is(prompt: str) -> None:
    assert kinds(draft(prompt)) & {"Spin", "HeadingReached"} == {"Spin"}


@pytest.mark.parametrize(
    ("prompt", "things"),
    [("A green car hits an orange one.", {"green_car_1", "orange_car_1"}),
     ("A blue mug stands next to a lime one.", {"blue_mug_1", "lime_mug_1"}),
     ("A green bottle stands between two brown ones.",
      {"green_bottle_1", "brown_bottle_1", "brown_bottle_2"}),
     ("A woman with a red umbrella passes a man with a blue one.",
      {"woman_1", "man_1", "red_umbrella_1", "blue_umbrella_1"}),
     ("A man eats an orange.", {"man_1", "orange_1"})],
)  # fmt: skip
def test_a_colour_before_one_is_no_thing(prompt: str, things: set[str]) -> None:
    assert drawn(draft(prompt)) == things


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [("A flat stone skips across a lake.", "stone_1"), ("A flat rock skips across a pond.", "rock_1"),
     ("Three birds sit on a fence; the one in the middle flies off.", "middle_bird_1"),
     ("Two blocks of ice slide down a ramp.", "block_of_ice_2"),
     ("A toaster stands by two slices of toast and one slides off.", "toast_1")],
)  # fmt: skip
def test_a_verb_is_no_noun(prompt: str, thing: str) -> None:
    assert thing in acting(draft(prompt))


def test_little_before_a_noun_is_a_size() -> None:
    doc = draft("A ball pushes a little wooden ball over the edge of a table.")
    assert "ball_2" in drawn(doc)
    assert "a little" not in owned(doc)
    assert "slightly" not in {s.text for s in doc.statements or ()}


@pytest.mark.parametrize(
    ("prompt", "who"),
    [("A car waits for a train to pass.", "train_1"),
     ("A van stops for a duck to cross the road.", "duck_1"),
     ("A sedan waits for a lorry to drive past.", "lorry_1")],
)  # fmt: skip
def test_who_is_waited_for_acts(prompt: str, who: str) -> None:
    assert who in acting(draft(prompt))


@pytest.mark.parametrize(
    ("prompt", "event"),
    [("Someone pulls the white block out sideways and the lamp falls over.", ("Topple", "lamp_1")),
     ("One bucket is full and the other, standing next to it, is tipped over by a goat.",
      ("Topple", "bucket_2")),
     ("A skier passes a man who has fallen and stops beside him.", ("Stop", "skier_1"))],
)  # fmt: skip
def test_the_subject_of_a_later_verb(prompt: str, event: tuple[str, str]) -> None:
    told = events(prompt)
    assert event in told
    assert [e for e in told if e[0] == event[0]] == [event]


def test_a_third_one_acts_and_not_the_two() -> None:
    doc = draft("Two zebras stand behind a fence and a third one, smaller than they are, walks by.")
    assert acting(doc) == {"third_zebra_1"}


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [("A tent with a flag behind it and a pot in front of it.", ("pot_1", "in_front_of", "tent_1")),
     ("A box with a ball in it and a doll beside it.", ("doll_1", "adjacent", "box_1")),
     ("A clock hangs above a mirror, with a lamp to the right of both.",
      ("lamp_1", "right_of", "clock_1")),
     ("A clock hangs above a mirror, with a lamp to the right of both.",
      ("lamp_1", "right_of", "mirror_1"))],
)  # fmt: skip
def test_what_goes_with_a_thing_has_its_own_place(
    prompt: str, relation: tuple[str, str, str]
) -> None:
    assert relation in related(draft(prompt))


def test_what_stands_beside_a_pot_is_not_in_it() -> None:
    assert held(draft("A pot with a spoon to its right and a lemon in front of them.")) == {}


def test_one_is_on_each() -> None:
    assert held(draft("Two cups on two plates slide.")) == {"cup_1": "plate_1", "cup_2": "plate_2"}


def test_on_its_roof_is_on_the_owner() -> None:
    doc = draft("A car with two bikes on its roof stops.")
    assert held(doc) == {"bike_1": "car_1", "bike_2": "car_1"}


@pytest.mark.parametrize(
    "prompt",
    ["The camera is fixed. A dog runs.", "The camera is completely static as a car drives by.",
     "The camera stays still and a dog walks past."],
)  # fmt: skip
def test_how_it_is_filmed_is_no_body(prompt: str) -> None:
    doc = draft(prompt)
    assert "camera_1" not in drawn(doc)
    assert [s.filming for s in doc.statements or () if s.filming] == ["static"]


def test_a_camera_that_is_acted_on_is_a_body() -> None:
    assert "camera_1" in drawn(draft("The camera is hit by a ball."))


def test_it_may_be_the_camera() -> None:
    doc = draft("A truck drives towards the camera as a motorcycle drives away from it.")
    assert related(doc) == set()
    assert owned(doc) == ["it"]


@pytest.mark.parametrize(
    ("prompt", "things"),
    [("The manipulator reaches for the mug. The robot stops.", {"manipulator_1", "mug_1"}),
     ("The excavator lifts a rock. The machine then drives off.", {"excavator_1", "rock_1"}),
     ("A drone lifts a parcel. The aircraft flies off.", {"drone_1", "parcel_1"}),
     ("A drone meets an aircraft.", {"drone_1", "aircraft_1"})],
)  # fmt: skip
def test_a_wider_word_names_what_is_there(prompt: str, things: set[str]) -> None:
    assert drawn(draft(prompt)) == things


@pytest.mark.parametrize(
    ("prompt", "words"),
    [("A lorry loses one of its barrels.", "one of its barrels"),
     ("Two cyclists ride along a road; a car overtakes them.", "overtakes"),
     ("Two dice are thrown onto a table.", "are thrown"),
     ("The arm tries to push the peg into the hole and misses it.", "tries to push"),
     ("A dog tries to jump over a fence.", "tries to jump"),
     ("The lid of a pot falls off the table.", "falls"),
     ("A man hits a drum with two quick blows.", "with two quick blows"),
     ("A hammer drives a nail into a beam.", "drives"),
     ("A bus stops. A cat runs across the road in front of it.", "")],
)  # fmt: skip
def test_fewer_parts_and_attempts_are_owned_up_to(prompt: str, words: str) -> None:
    assert (words in owned(draft(prompt))) is bool(words)


@pytest.mark.parametrize(
    "prompt",
    ["One of three cups falls off the shelf.", "The striker tries to kick the ball but misses it.",
     "Three balls hit a wall."],
)  # fmt: skip
def test_what_is_shown_of_several_is_not_owned_up_to(prompt: str) -> None:
    assert owned(draft(prompt)) == []


def test_a_nail_is_hit_and_not_the_board() -> None:
    assert events("A hammer drives a nail into a beam.")[0] == ("Collision", "hammer_1", "nail_1")


def test_dice_that_tumble_on_do_not_fall() -> None:
    assert NodeEvent.FALL.value not in kinds(draft("A die is thrown onto a table, tumbling."))


@pytest.mark.parametrize(
    ("prompt", "ground"),
    [("A bus stops. A child runs over the street in front of it.", "street_1"),
     ("A cup slides along the table to the left.", "table_1")],
)  # fmt: skip
def test_a_place_is_no_name(prompt: str, ground: str) -> None:
    assert ground in drawn(draft(prompt))


def test_all_move_that_are_chased() -> None:
    doc = draft("A dog chases two cats.")
    assert acting(doc) == {"dog_1", "cat_1", "cat_2"}
    assert headed(doc) == {("dog_1", "toward")}


def test_who_follows_at_the_end_of_a_sentence() -> None:
    assert ("gull_1", "behind", "boat_1") in related(draft("A boat sails by, a gull following it."))


@pytest.mark.parametrize(
    ("prompt", "things"),
    [("The left robot hands a box to the right one.", {"left_robot_1", "right_robot_1", "box_1"}),
     ("The left lamp falls and the right one stands. The left one rolls.",
      {"left_lamp_1", "right_lamp_1"}),
     ("A plank lies on a log; a bear steps onto one end and the other goes up.",
      {"plank_1", "log_1", "bear_1"}),
     ("An orange cat sleeps on a grey sofa and a black cat on an orange one.",
      {"orange_cat_1", "black_cat_1", "grey_sofa_1", "orange_sofa_1"}),
     ("A forklift lifts a crate, and it slips off its forks.", {"forklift_1", "crate_1"}),
     ("A truck with a broken headlight follows a bus.", {"truck_1", "bus_1"}),
     ("Three sheets of paper lie on a desk.",
      {"sheet_of_paper_1", "sheet_of_paper_2", "sheet_of_paper_3", "desk_1"})],
)  # fmt: skip
def test_what_is_drawn_is_what_is_named(prompt: str, things: set[str]) -> None:
    assert drawn(draft(prompt)) == things


def test_a_gapped_place_is_of_its_own_thing() -> None:
    doc = draft("A spoon lies in a red cup and a fork next to a blue cup.")
    assert related(doc) == {("fork_1", "adjacent", "blue_cup_1")}
    assert held(doc) == {"spoon_1": "red_cup_1"}


def test_a_driver_who_walks_is_a_person() -> None:
    doc = draft("A truck tows a car while its driver walks beside it.")
    assert "driver_1" in acting(doc)
    assert "car_1" not in acting(doc)


def test_one_of_a_plural_subject() -> None:
    doc = draft("Three kids on sledges race down a hill and the one on the red sledge falls.")
    assert "hill_1" not in held(doc)
    assert [n.participants for n in _told(doc, "Fall")] == [("kid_1",)]


def _told(doc: EsgDocument, kind: str) -> list[TimelineNode]:
    assert doc.timeline_system is not None
    return [n for n in doc.timeline_system.sequence_graph.nodes if n.event.value == kind]


@pytest.mark.parametrize(
    ("prompt", "event"),
    [("Not one of the bowling pins is touched by the ball.", "Miss"),
     ("The ball hits not one of the cones.", "Miss")],
)  # fmt: skip
def test_not_one_of_them_is_hit(prompt: str, event: str) -> None:
    assert kinds(draft(prompt)) & {"Miss", "Collision"} == {event}


def test_a_ball_that_drops_on_her_side_does_not_topple() -> None:
    assert "Topple" not in kinds(draft("A ball hits the net and drops on her side."))


def test_what_stands_by_a_thing_does_not_go_with_it() -> None:
    doc = draft("A cup is above a ball. The cup slides along a table and the ball goes with it.")
    assert "with it" in owned(doc)


def test_who_tries_is_listed_in_order() -> None:
    """The same bytes whatever the order of sets in a process."""
    doc = draft("A barrel is rolling down a street. People try to stop it.")
    told = [s for s in doc.statements or () if s.text == "try to stop"]
    assert [s.object for s in told] == [("person_1", "person_2", "person_3")]
