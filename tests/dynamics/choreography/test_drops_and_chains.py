"""Drops whose time is stated, two that are dropped together, and long chains of balls."""

from __future__ import annotations

import itertools
import math

import pytest

from esg.dynamics.casting.chains import LIVELIEST, ball_chains
from esg.dynamics.choreography.approaches import CALM_MPS
from esg.dynamics.choreography.hits.demands import passed_on
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.story.stagecraft import default_speed, ground_restitution, prop
from esg.dynamics.story.story import read_story
from esg.graph.models import EsgDocument
from esg.layout.problem.hints import Placement
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast

SEVEN = "Ball A hits ball B" + "".join(
    f", ball {a} hits ball {b}" for a, b in zip("BCDEF", "CDEFG", strict=True)
)


def places(doc: EsgDocument) -> dict[str, Placement]:
    told = choreograph(doc).hints.constellations
    return {p.node: p for c in told for p in c.placements}


@pytest.mark.parametrize("time", [0.8, 1.0, 1.5])
def test_what_is_dropped_starts_as_high_as_its_time_asks(time: float) -> None:
    doc = cast(f"A stone is dropped and lands on a crate after {time:g} seconds.")
    top = doc.asset_configurations["crate_01"].dimensions_cm[2]
    fall = (places(doc)["stone_1"].z_cm or 0.0) - top
    assert fall == pytest.approx(50.0 * GRAVITY_MPS2 * time**2)


def test_what_falls_into_something_for_long_stays_in_even_if_it_is_livelier_than_thought() -> None:
    doc = cast("A ball is dropped into a bucket and lands in it after 0.9 s.")
    ball, bucket = (doc.asset_configurations[f"{n}_01"] for n in ("ball", "bucket"))
    depth = 0.02 * next(r for r in bucket.regions if r.name == "inside").half_extents_cm[2]
    livelier = 0.5 * (ball.restitution + bucket.restitution) + 0.1
    bounce = livelier**2 * 0.5 * GRAVITY_MPS2 * 0.9**2
    assert bounce <= depth * 1.001


@pytest.mark.parametrize("time", [None, 1.0])
def test_one_of_two_that_are_dropped_meets_the_other_as_it_bounces_back(time: float | None) -> None:
    after = "" if time is None else f" after {time:g} second"
    doc = cast(f"A red ball and a blue ball are dropped and collide with each other{after}.")
    spots = places(doc)
    low, high = sorted(spots, key=lambda n: spots[n].z_cm or 0.0)
    assert (spots[low].x_cm, spots[low].y_cm) == (spots[high].x_cm, spots[high].y_cm)
    ball = prop(doc, low)
    lands = math.sqrt(0.02 * (spots[low].z_cm or 0.0) / GRAVITY_MPS2)
    gap = 0.01 * ((spots[high].z_cm or 0.0) - (spots[low].z_cm or 0.0)) - ball.height
    e = 0.5 * (ball.restitution + ground_restitution(doc))
    meets = lands + gap / ((1.0 + e) * GRAVITY_MPS2 * lands)
    told = choreograph(doc).nominal["red_ball_1_blue_ball_1_collision/event_time"]
    assert told == pytest.approx(meets)
    assert time is None or meets == pytest.approx(time)


def test_balls_of_a_long_chain_are_lively_and_lie_ever_closer() -> None:
    doc = cast(SEVEN + ".")
    assert [len(c) for c in ball_chains(doc, read_story(doc))] == [7]
    assert prop(doc, "ball_a").restitution == LIVELIEST
    spots = places(doc)
    x = [spots[f"ball_{n}"].x_cm for n in "abcdefg"]
    gaps = [b - a - 100.0 * prop(doc, "ball_a").width for a, b in itertools.pairwise(x[1:])]
    assert all(later < 0.9 * sooner for sooner, later in itertools.pairwise(gaps))


def test_balls_of_a_short_chain_stay_as_they_are() -> None:
    doc = cast("Ball A hits ball B, and ball B hits ball C.")
    assert not ball_chains(doc, read_story(doc))
    assert prop(doc, "ball_a").restitution < LIVELIEST


ROW = "A forklift hits a crate, the crate slides into a second crate, and the second crate hits a third crate."


def test_crates_that_slide_from_hit_to_hit_are_smooth_and_start_calmly() -> None:
    doc = cast(ROW)
    first, second, third = (prop(doc, n) for n in ("crate_1", "second_crate_1", "third_crate_1"))
    assert first.friction == second.friction == 0.15
    told = choreograph(doc).nominal
    sent = passed_on(prop(doc, "forklift_1"), first) * told["forklift_1_drive/speed"]
    assert sent >= CALM_MPS
    assert told["forklift_1_drive/speed"] < 0.9 * default_speed(prop(doc, "forklift_1"))
    spots = places(doc)
    gaps = [
        0.01 * (spots[b].x_cm - spots[a].x_cm) - 0.5 * (p.length + q.length)
        for a, b, p, q in (
            ("crate_1", "second_crate_1", first, second),
            ("second_crate_1", "third_crate_1", second, third),
        )
    ]
    times = [
        told["crate_1_second_crate_1_collision/event_time"]
        - told["forklift_1_crate_1_collision/event_time"],
        told["second_crate_1_third_crate_1_collision/event_time"]
        - told["crate_1_second_crate_1_collision/event_time"],
    ]
    assert all(0.1 < g < 1.6 for g in gaps)
    assert all(t > 0.15 for t in times)


def test_what_slides_into_one_thing_only_keeps_its_underside() -> None:
    doc = cast("A forklift hits a crate and the crate slides into a barrel.")
    assert prop(doc, "crate_1").friction > 0.3


@pytest.mark.parametrize(
    ("prompt", "who", "thing", "table"),
    [
        ("A girl drops an apple onto the kitchen counter.", "girl_1", "apple_1", "kitchen_counter"),
        ("A boy drops a ball onto a bench.", "boy_1", "ball_1", "bench"),
        ("A woman drops a book onto a desk.", "woman_1", "book_1", "desk"),
        ("A chef drops an egg into a pan on the stove.", "chef_1", "egg_1", "stove"),
    ],
)
def test_who_drops_something_stands_before_the_table_and_reaches_it(
    prompt: str, who: str, thing: str, table: str
) -> None:
    doc = cast(prompt)
    spots = places(doc)
    below = next(p for n, p in spots.items() if n not in (who, thing))
    apart = math.hypot(spots[who].x_cm - below.x_cm, spots[who].y_cm - below.y_cm)
    carrier, person = (100.0 * prop(doc, n).length for n in (f"{table}_1", who))
    assert apart > 0.5 * (carrier + person)
    reach = math.hypot(spots[who].x_cm - spots[thing].x_cm, spots[who].y_cm - spots[thing].y_cm)
    tall = 100.0 * prop(doc, who).height
    assert reach < 0.5 * tall
    on = 100.0 * prop(doc, f"{table}_1").height if table == "stove" else 0.0
    assert on + (spots[thing].z_cm or 0.0) < 1.25 * tall


def test_what_drops_into_a_chest_comes_after_its_lid_is_open() -> None:
    doc = cast("The lid of a chest swings up. A loaf of bread drops into the chest.")
    lid = choreograph(doc).nominal["chest_1_moved/duration"]
    top = doc.asset_configurations["chest_body_01"].dimensions_cm[2]
    fall = math.sqrt(2.0 * ((places(doc)["loaf_of_bread_1"].z_cm or 0.0) - top) / 100.0
                     / GRAVITY_MPS2)  # fmt: skip
    assert lid < 1.2
    assert fall > lid
    alone = cast("A loaf of bread drops into an open chest.")
    assert (places(alone)["loaf_of_bread_1"].z_cm or 0.0) - top < 150.0


@pytest.mark.parametrize(
    ("prompt", "number"),
    [
        ("Drop six cubes onto a table.", 6),
        ("Four tennis balls fall into a laundry basket.", 4),
        ("Several books fall off a shelf.", 4),
        ("A boy drops three stones into a bucket, one after another.", 3),
    ],
)
def test_several_that_fall_do_not_start_in_each_other(prompt: str, number: int) -> None:
    doc = cast(prompt)
    fallen = {e.actor for e in doc.timeline_system.sequence_graph.edges}
    spots = {n: p for n, p in places(doc).items() if n in fallen}
    assert len(spots) == number
    for a, b in itertools.combinations(spots, 2):
        one, other = spots[a], spots[b]
        size = 100.0 * max(min(prop(doc, n).width, prop(doc, n).height) for n in (a, b))
        apart = math.dist((one.x_cm, one.y_cm), (other.x_cm, other.y_cm))
        assert max(apart, abs((one.z_cm or 0.0) - (other.z_cm or 0.0))) >= size


def test_what_lands_in_turn_falls_from_ever_higher() -> None:
    spots = places(cast("A boy drops three stones into a bucket, one after another."))
    heights = [spots[f"stone_{k}"].z_cm or 0.0 for k in (1, 2, 3)]
    assert heights == sorted(heights)
    assert heights[0] < heights[1] - 10.0 < heights[2] - 20.0


def test_what_is_hit_at_the_end_of_a_shelf_stands_there() -> None:
    doc = cast("A mug stands at the end of a shelf and a toy car drives into it.")
    half = max(doc.asset_configurations["shelf_01"].support_surfaces[0].half_extents_cm)
    spot = places(doc)["mug_1"]
    assert max(abs(spot.x_cm), abs(spot.y_cm)) > 0.7 * half
