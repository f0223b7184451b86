"""What a prompt says and does not assert, tells twice, or says of each of several things."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.draft.document.coverage import NOTHING_HAPPENS
from esg.graph import verify
from esg.graph.models import EsgDocument, TimelineNode
from esg.outcomes import UserError


def clean(prompt: str) -> EsgDocument:
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc


def points(doc: EsgDocument) -> list[TimelineNode]:
    return list(doc.timeline_system.sequence_graph.nodes) if doc.timeline_system else []


def story(prompt: str) -> list[str]:
    """Point events of a prompt, triggers left out, with numbers of nodes dropped."""
    skip = ("SceneStart", "Trigger")
    return [
        " ".join([n.event.value, *(p.removesuffix("_1") for p in n.participants)])
        for n in points(clean(prompt))
        if n.event not in skip
    ]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("The goalkeeper wants to stop the ball but it rolls on.", []),
        ("A train should stop, but it hits the buffer.", ["Collision train buffer"]),
        ("The snowball would crush the hut, but it hits a rock.", ["Collision snowball rock"]),
        ("A cart rolls toward a car but a man stops it before it can hit the car.", ["Stop cart"]),
        ("A ball is about to roll off a table when a hand stops it.", ["Stop ball"]),
        ("People try to stop a barrel. It hits a fountain.", ["Collision barrel fountain"]),
        ("The truck stops before it reaches the barrier.", ["Stop truck"]),
        ("A book falls off a shelf and almost hits a cat.", ["Fall book", "Miss book cat"]),
        ("Two cars nearly collide.", ["Miss car car_2"]),
        ("A box slides down a ramp. It never touches the vase.", ["Miss box vase"]),
        ("A van drives past a cat and a dog. It hits neither.", None),
        ("He aims at the bottle with a stone but hits the jug.", ["Collision stone jug"]),
        ("A bike is overtaking a bus when the bus turns left.", ["HeadingReached bus"]),
        ("The camera follows a marble that hits a bell.", ["Collision marble bell"]),
    ],
)
def test_what_does_not_happen_is_no_event(prompt: str, expected: list[str] | None) -> None:
    """Leave out wishes, attempts, conditions and near misses; a denied hit is a miss."""
    found = story(prompt)
    if expected is None:
        assert found == ["Miss van cat", "Miss van dog"]
    else:
        assert found == expected


def test_i_want_is_what_happens() -> None:
    """Take what the user asks for as told, unlike what a thing in the scene wants."""
    assert story("I want a ball to hit a box.") == ["Collision ball box"]
    assert story("I would like a ball to hit a box.") == ["Collision ball box"]


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        (
            "An apple falls onto a sheep. The sheep, hit by the apple, runs into a fence.",
            ["Collision apple sheep", "Collision sheep fence"],
        ),
        (
            "A hammer on a ladder slips off. It falls on a bucket.",
            ["Fall hammer", "Collision hammer bucket"],
        ),
        (
            "A chair tips over. In falling, it hits a lamp.",
            ["Topple chair", "Collision chair lamp"],
        ),
        (
            "A car bumps a shelf, and because of that bump a carton falls from the shelf.",
            ["Collision car shelf", "Fall carton"],
        ),
        ("A ball hits a box. The ball hits the box again.", ["Collision ball box"] * 2),
        (
            "A boxer hits a bag; the bag swings back and hits him.",
            ["Collision boxer bag", "Collision bag boxer"],
        ),
    ],
)
def test_an_event_told_twice_is_one(prompt: str, expected: list[str]) -> None:
    """Refer back to what was told, unless it happens again or the other way round."""
    assert story(prompt) == expected


def test_a_time_may_be_told_with_the_second_mention() -> None:
    """Give the event the time that a later clause states of it."""
    doc = clean("The collision between a bike and a dog happens at 3 s.")
    hit = next(n for n in points(doc) if n.event == "Collision")
    assert hit.participants == ("bike_1", "dog_1")
    assert hit.timestamp == 3.0 and hit.time_is_prescribed


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("Two taxis race and one taxi hits the other.", ["Collision taxi taxi_2"]),
        ("A duck walks to a pond and jumps in.", ["EnterRegion duck"]),
        ("A dog named Rex hits a fence. Rex stops.", ["Collision dog_rex fence", "Stop dog_rex"]),
        ('A man called "O\'Brien" is hit by a ball.', ["Collision ball man_o_brien"]),
        ("A mug stands on a desk. The mug ends up on the floor.", ["Fall mug"]),
        ("A car leaves the road and ends in a pond.", ["EnterRegion car"]),
        ("The brick lands on a car.", ["Collision brick car"]),
        ("A girl on a skateboard waves. She hits a hydrant.", ["Collision skateboard hydrant"]),
        ("A car changes lanes and hits a van.", ["Collision car van"]),
        ("A man falls.", ["Topple man"]),
    ],
)
def test_readings(prompt: str, expected: list[str]) -> None:
    """Read names, places, members and where things end."""
    assert story(prompt) == expected


def test_each_member_has_its_own_time() -> None:
    """ "The cars brake after 2 s and 3 s": the second counts from the start as well."""
    doc = clean("The cars brake after 2 s and 3 s.")
    brakes = [n for n in points(doc) if n.event == "Trigger" and n.time_is_prescribed]
    assert [(n.participants[0], n.timestamp) for n in brakes] == [("car_1", 2.0), ("car_2", 3.0)]


def test_a_rate_of_braking_is_a_time_to_stop() -> None:
    """9 m/s at 3 m/s^2 take 3 s."""
    doc = clean("A cart brakes at 3 m/s² from 9 m/s and stops.")
    found: list[Any] = [
        c.value for n in points(doc) for c in n.constraints if c.quantity == "time_to_stop"
    ]
    assert found == [pytest.approx(3.0)]


def test_lines_are_sentences() -> None:
    """Read a list by lines, and headings as no objects."""
    prompt = "Scene:\n- a red ball rolls at 2 m/s\n- it hits a box\n- the box falls off the table"
    assert story(prompt) == ["Collision red_ball box", "Fall box"]
    assert "scene_1" not in clean(prompt).spatial_relation_graph.nodes


def test_order_words_are_accounted_for() -> None:
    """ "Afterwards" and its like are in the coverage record."""
    doc = clean("A ball hits a box. Afterwards it slowly rolls into a wall.")
    items = {i.text.lower(): i for i in doc.coverage.items}
    assert items["afterwards"].status == "used" and items["slowly"].status == "ignored"


def test_a_prompt_without_understood_events_says_so() -> None:
    """Warn first if no verb was understood, so that an empty scene does not look right."""
    assert clean("The flumph glorbs the snark.").coverage.warnings[0].startswith(NOTHING_HAPPENS)
    told = clean("The ball glorbs and hits a wall.").coverage.warnings
    assert not any(w.startswith(NOTHING_HAPPENS) for w in told)


def test_motion_and_rest_contradict_each_other() -> None:
    """Refuse a thing that never moves and moves; a wait at first is no contradiction."""
    with pytest.raises(UserError, match="not to move"):
        draft("A ball never moves. It rolls to the left and hits a wall.")
    assert story("A ball does not move at first. It rolls and hits a wall.") == [
        "Collision ball wall"
    ]


def test_senses_that_name_each_other_end() -> None:
    """ "A fridge falls out of a truck" was read as toppling and falling without end."""
    assert story("A fridge falls out of a moving truck.") == ["Fall fridge"]


@pytest.mark.parametrize(
    "prompt",
    [
        "The scaffold decelerates from 64 km/h to 59 km/h over 3 seconds.",
        "A truck loaded with barrels brakes and a barrel rolls off. The harpoon spins at the first "
        "bend, the second car avoids it on the left, and the third car hits it broadside.",
    ],
)
def test_odd_references_are_drafted(prompt: str) -> None:
    clean(prompt)
