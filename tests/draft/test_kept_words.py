"""Words of captions and commands that were lost without a word, by the way in which they were."""

from __future__ import annotations

import pytest

from esg.draft import draft
from esg.graph import verify
from esg.graph.models import EsgDocument, Predicate


def said(doc: EsgDocument) -> set[tuple[str, str | None, str]]:
    """Predicate, direction and words of every statement."""
    return {(s.predicate.value, s.direction, s.text) for s in doc.statements or ()}


def lost(doc: EsgDocument) -> list[str]:
    """Words that the draft owns up to, in warnings, too."""
    words = [s.text for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    return words + [w.split('"')[1] for w in doc.coverage.warnings if '"' in w]


def told(doc: EsgDocument) -> list[tuple[str, ...]]:
    """Point events but for the scaffolding."""
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    return [
        (n.event.value, *n.participants)
        for n in nodes
        if n.event.value not in ("SceneStart", "Trigger")
    ]


def drawn(doc: EsgDocument) -> set[str]:
    """Nodes that the prompt names and that are no ground."""
    nodes = doc.spatial_relation_graph.nodes
    return {n for n, node in nodes.items() if node.mentioned and not node.is_structural}


def held_by(doc: EsgDocument, node: str) -> tuple[str, str]:
    """What carries or contains a node, and which of the two."""
    graph = doc.spatial_relation_graph
    region = graph.semantic_regions[graph.nodes[node].semantic_region or ""]
    return region.parent_object, region.region_type.value


@pytest.mark.parametrize(
    ("prompt", "way"),
    [
        ("A red car drives from left to right.", "right"),
        ("A ball rolls from right to left.", "left"),
        ("A boat sails left to right.", "right"),
    ],
)
def test_from_one_side_to_the_other_is_a_course(prompt, way):
    doc = draft(prompt)
    assert ("moves", way) in {(p, d) for p, d, _ in said(doc)}
    assert lost(doc) == []


def test_things_from_left_to_right_stand_in_a_row():
    nodes = draft("Three boxes stand from left to right.").spatial_relation_graph.nodes
    assert [nodes[f"box_{k}"].group_pattern for k in (1, 2, 3)] == ["row"] * 3


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("The elevator doors slide open and a man walks out.", "out"),
        ("A truck dumps gravel onto the road.", "dumps"),
        ("A farmer throws hay into the barn.", "throws"),
        ("He throws it at a wall.", "throws"),
        ("Two children ride a seesaw in the playground.", "ride"),
        ("A person is sliding down a pole.", "down a pole"),
        ("A panda rolls down a hill.", "rolls"),
        ("A person is sitting down.", "is sitting"),
        ("A man is pushing a car.", "is pushing"),
        ("A man throws knives at a board.", "throws"),
        ("A spinning coin slows down and falls over.", "spinning"),
        ("The woman puts the cake into the oven.", "into the oven"),
        ("A man hangs a coat on a hook.", "hangs"),
        ("A gymnast does a backflip on a mat.", "a backflip"),
        ("Store the block in the cabinet.", "Store"),
        ("A garbage truck lifts a bin and empties it.", "empties"),
        ("One person hands a cup to another person.", "hands"),
        ("A crate swings into a box.", "swings"),
        ("A crate lands on the seesaw and lifts a box.", "lifts"),
        ("A kite is stuck in a tree.", "in a tree"),
    ],
)
def test_what_nothing_stands_for_is_owned_up_to(prompt, words):
    doc = draft(prompt)
    assert words in lost(doc)
    assert verify(doc) == ()


def test_who_throws_stuff_does_not_fly_himself():
    assert told(draft("A farmer throws hay into the barn.")) == []
    assert told(draft("A boy is flying a kite.")) == []
    assert ("airborne", None, "is flying") in said(draft("A boy is flying a kite."))


@pytest.mark.parametrize(
    ("prompt", "things"),
    [
        ("A garbage truck lifts a bin and empties it.", {"garbage_truck_1", "bin_1"}),
        ("Store the block in the cabinet.", {"block_1", "cabinet_1"}),
        ("A gymnast does a backflip on a mat.", {"gymnast_1", "mat_1"}),
        ("Tourists walk across the bridge in Prague.", {"tourist_1", "tourist_2", "tourist_3"}),
        ("Two people are shaking hands.", {"person_1", "person_2"}),
        ("A forklift raises its forks.", {"forklift_1"}),
        ("A surfer rides a huge wave.", {"surfer_1"}),
        ("A person is turning off the light.", {"person_1"}),
        ("The quarterback throws the football downfield.", {"quarterback_1", "football_1"}),
    ],
)
def test_no_thing_is_drawn_for_acts_places_weather_and_parts(prompt, things):
    assert drawn(draft(prompt)) == things


@pytest.mark.parametrize(
    ("prompt", "node", "host", "how"),
    [
        ("pick up the red block from the table", "red_block_1", "table_1", "SUPPORT_SURFACE"),
        ("lift the blue block from the drawer", "blue_block_1", "drawer_1", "STORAGE"),
        ("take the red cube out of the drawer", "red_cube_1", "drawer_1", "STORAGE"),
        ("A person takes a book from the shelf.", "book_1", "shelf_1", "SUPPORT_SURFACE"),
        ("A forklift lifts a pallet of boxes.", "box_1", "pallet_1", "SUPPORT_SURFACE"),
        ("A waiter carries a tray of glasses.", "glass_2", "tray_1", "SUPPORT_SURFACE"),
        ("Two people push a cart of laundry.", "laundry_1", "cart_1", "SUPPORT_SURFACE"),
    ],
)
def test_it_starts_where_it_is_taken_from(prompt, node, host, how):
    assert held_by(draft(prompt), node) == (host, how)


def test_next_to_and_between_are_relations():
    edges = draft("The ball is next to the box.").spatial_relation_graph.edges
    assert [r.relation_type.value for r in edges.binary_relations if r.to == "box_1"] == [
        "adjacent"
    ]
    doc = draft("pick up the bowl between the plate and the cup and place it on the plate")
    (between,) = doc.spatial_relation_graph.edges.multi_relations
    assert (between.subjects, set(between.targets)) == (("bowl_1",), {"plate_1", "cup_1"})
    assert told(doc) == [("PickedUp", "bowl_1"), ("Placed", "bowl_1", "plate_1")]


@pytest.mark.parametrize("vessel", ["bag", "backpack", "tin", "caddy", "pond", "tray", "suitcase"])
def test_what_is_put_into_something_open_is_in_it(vessel):
    doc = draft(f"put the block in the {vessel}")
    assert told(doc)[-1][0] == "EnterRegion"
    assert lost(doc) == []


def test_all_that_was_picked_up_is_put_down():
    doc = draft("pick up the two cookies and place them in the basket")
    assert [t[0] for t in told(doc)] == ["PickedUp", "PickedUp", "EnterRegion", "EnterRegion"]


def test_a_walk_that_becomes_a_run_gains_speed():
    doc = draft("A person is walking, then suddenly starts running.")
    assert doc.timeline_system is not None
    kinds = [e.event.value for e in doc.timeline_system.sequence_graph.edges]
    assert kinds == ["UniformMotion", "AcceleratedMotion"]
    assert ("faster_than", None, "starts running") in said(doc)


def test_birds_and_drones_land_and_take_off_by_themselves():
    doc = draft("A bird takes off from a branch.")
    assert ("moves", "up", "takes off") in said(doc)
    doc = draft("A drone lands on a table.")
    assert doc.timeline_system is not None
    assert doc.timeline_system.sequence_graph.edges[0].event.value == "UniformMotion"
    assert {("moves", "down", "lands"), ("ends_on", None, "on a table")} <= said(doc)


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("A man kicks a punching bag.", ("Swing", "punching_bag_1")),
        ("A boy pushes a swing.", ("Swing", "swing_1")),
        ("A walker pushes a turnstile.", ("Spin", "turnstile_1")),
    ],
)
def test_what_hangs_or_turns_is_touched_and_moves(prompt, event):
    doc = draft(prompt)
    assert [t[0] for t in told(doc)] == ["Collision", event[0]]
    assert told(doc)[-1] == event
    assert verify(doc) == ()


@pytest.mark.parametrize(
    "prompt",
    [
        "A delivery van brakes hard behind a parked bus.",
        "A car stops behind a truck.",
        "A taxi halts behind a van.",
    ],
)
def test_behind_another_vehicle_is_along_its_way(prompt):
    doc = draft(prompt)
    assert "behind" not in {p for p, _, _ in said(doc)}
    assert {("moves", "toward"), ("ends_near", None)} <= {(p, d) for p, d, _ in said(doc)}
    assert lost(doc) == []


def test_behind_a_tree_stays_the_viewers_word():
    assert "behind" in {p for p, _, _ in said(draft("A dog runs behind a tree."))}


def test_what_is_kicked_into_the_air_starts_at_the_foot():
    timeline = draft("A kid kicks a ball at a punching bag.").timeline_system
    assert timeline is not None
    (height,) = timeline.sequence_graph.nodes[0].constraints
    assert (height.quantity, height.object, height.value) == ("height", "ball_1", (0.0, 6.0))
    thrown = draft("A kid throws a ball at a punching bag.").timeline_system
    assert thrown is not None
    assert thrown.sequence_graph.nodes[0].constraints == ()


def test_a_taxi_is_yellow_unless_it_is_said_otherwise():
    colors = {
        p: {a.color for n, a in draft(p).asset_requirement.items() if "taxi" in n}
        for p in ("A taxi hits a bin.", "A blue taxi hits a bin.")
    }
    assert list(colors.values()) == [{"yellow"}, {"blue"}]


def _on(prompt: str) -> dict[str, str]:
    """What everything mentioned stands on, but for the ground."""
    graph = draft(prompt).spatial_relation_graph
    regions = graph.semantic_regions
    at = {i: regions[n.semantic_region] for i, n in graph.nodes.items() if n.semantic_region}
    return {i: r.parent_object for i, r in at.items() if not r.parent_object.startswith("ground")}


@pytest.mark.parametrize(
    ("prompt", "on"),
    [
        ("A girl stacks two cubes on a box.", {"cube_1": "box_1", "cube_2": "box_1"}),
        ("A boy balances a ball on a box.", {"ball_1": "box_1"}),
        ("A man loads a cart with two sacks.", {"sack_1": "cart_1", "sack_2": "cart_1"}),
        ("A crane lowers a container onto a truck.", {}),
        ("A woman leans a broom against a wall.", {}),
    ],
)
def test_who_puts_a_thing_somewhere_is_not_there_too(prompt: str, on: dict[str, str]) -> None:
    """Place what a transitive verb of posture acts on, and not who acts."""
    assert _on(prompt) == on


@pytest.mark.parametrize(
    ("prompt", "placed"),
    [
        ("A girl stacks a red cube on top of a blue cube.", ("red_cube_1", "blue_cube_1")),
        ("A worker loads a crate onto a truck.", ("crate_1", "truck_1")),
        ("A man lifts a box and puts it down.", ("box_1", "ground_1")),
        ("A robot picks up a cup from a table and sets it down again.", ("cup_1", "table_1")),
    ],
)
def test_what_is_put_somewhere_ends_there(prompt: str, placed: tuple[str, str]) -> None:
    """Guide what is stacked, loaded or set down again, and own up to nothing."""
    doc = draft(prompt)
    assert doc.timeline_system is not None
    last = doc.timeline_system.sequence_graph.nodes[-1]
    assert (last.event.value, last.participants) == ("Placed", placed)
    assert not [s for s in doc.statements or () if s.predicate.value == "not_represented"]


def _told(prompt: str) -> list[tuple[str, ...]]:
    """Point events of a verifier-clean draft, ends of motions left out."""
    doc = draft(prompt)
    assert verify(doc) == () and doc.timeline_system is not None
    nodes = doc.timeline_system.sequence_graph.nodes
    return [(n.event.value, *n.participants) for n in nodes if n.event.value not in _SCAFFOLDING]


_SCAFFOLDING = {"SceneStart", "Trigger"}


@pytest.mark.parametrize(
    ("prompt", "event"),
    [
        ("A ball is released above a table and bounces twice.", ("Bounce", "ball_1", "table_1")),
        ("An egg is dropped above a bowl.", ("Collision", "egg_1", "bowl_1")),
        ("A ball is dropped from above a table onto the floor.", ("Fall", "ball_1")),
    ],
)
def test_what_is_let_go_above_a_thing_meets_it(prompt: str, event: tuple[str, ...]) -> None:
    """Let what is released above a thing come down on it, unless it is told where it lands."""
    assert _told(prompt) == [event]


@pytest.mark.parametrize(
    ("prompt", "on"),
    [
        ("A wooden block slides to a stop on a table.", {"wooden_block_1": "table_1"}),
        ("A bottle tips over on a shelf.", {"bottle_1": "shelf_1"}),
        ("A ball rolls from one end of a table to the other.", {"ball_1": "table_1"}),
        ("A mouse runs from one end of a shelf to the other end.", {"mouse_1": "shelf_1"}),
        ("A book slides from the edge of a shelf to the floor.", {"book_1": "shelf_1"}),
        ("A ball rolls into a box on the floor.", {}),
    ],
)
def test_what_ends_on_a_thing_that_it_rolls_on_starts_on_it(
    prompt: str, on: dict[str, str]
) -> None:
    """Start on a thing what slides to a stop on it, tips over on it, or crosses it."""
    assert {k: v for k, v in _on(prompt).items() if not v.startswith("floor")} == on


def test_each_of_two_or_three_that_are_overtaken_is() -> None:
    """Pass every one of a small number, one after the other."""
    passed = [("Miss", "car_1", "truck_1"), ("Miss", "car_1", "truck_2")]
    assert _told("A car overtakes two trucks.") == passed


def test_who_runs_after_a_thing_goes_toward_it() -> None:
    """State where a pursuit leads, and both sides of what is passed between."""
    doc = draft("A boy throws a stick and a dog runs after it.")
    assert [s.target for s in doc.statements or () if s.direction == "toward"] == [("stick_1",)]
    doc = draft("A cube stands left of a cone. A ball rolls between them.")
    ways = [s.target for s in doc.statements or () if s.direction == "between"]
    assert ways == [("cube_1", "cone_1")]
