"""What a first hit owes to the end of its chain, and how light what stands there is made."""

from __future__ import annotations

import math

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import fit_assets
from esg.dynamics.choreography import choreograph
from esg.dynamics.demands import FELT_NS, felt, passed_on, thrown_back_share
from esg.dynamics.impacts import FARTHEST_AHEAD
from esg.dynamics.stagecraft import prop
from esg.dynamics.story import read_story
from esg.dynamics.tipping import topple_speed
from esg.dynamics.toppling import carried, fastest
from esg.graph.models import EsgDocument, NodeEvent
from esg.units import GRAVITY_MPS2


def cast(prompt: str) -> EsgDocument:
    return fit_assets(resolve(draft(prompt)))


def nominal(doc: EsgDocument, actor: str) -> float:
    told = choreograph(doc).nominal
    return next(v for k, v in told.items() if k.startswith(actor) and k.endswith("/speed"))


def test_a_wall_keeps_less_of_a_rolling_ball() -> None:
    assert thrown_back_share(0.8, rolling=False) == pytest.approx(0.8)
    assert thrown_back_share(0.8, rolling=True) == pytest.approx(2.0 / 7.0)


@pytest.mark.parametrize(
    ("prompt", "mover", "passes", "last"),
    [
        ("A ball hits another ball, which knocks over a chair.", "ball_1", "ball_2", "chair_1"),
        ("A crate is hit by a cart and knocks over a lamp.", "cart_1", "crate_1", "lamp_1"),
    ],
)
def test_a_first_hit_is_fast_enough_for_the_topple_behind_it(
    prompt: str, mover: str, passes: str, last: str
) -> None:
    doc = cast(prompt)
    a, b, c = (prop(doc, n) for n in (mover, passes, last))
    arrives = passed_on(a, b) * nominal(doc, mover)
    assert arrives > topple_speed(b, c, flies=False)


def test_a_ball_that_comes_back_from_a_wall_is_fast_enough_for_its_topple() -> None:
    doc = cast("A basketball bounces off a wall and knocks over a vase.")
    ball, wall, vase = (prop(doc, n) for n in ("basketball_1", "wall_1", "vase_1"))
    share = thrown_back_share(0.5 * (ball.restitution + wall.restitution), rolling=True)
    assert share * nominal(doc, "basketball_1") > topple_speed(ball, vase, flies=False)


def test_what_is_struck_arrives_as_fast_as_masses_pass_on() -> None:
    prompt = (
        "Ball A with a mass of {} kg moves at 3 m/s and hits ball B; ball B knocks over a vase."
    )
    light, heavy = (resolve(draft(prompt.format(m))) for m in (0.2, 5))
    speeds = []
    for doc in (light, heavy):
        story = read_story(doc)
        hit = next(
            n
            for n in story.nodes.values()
            if n.event is NodeEvent.COLLISION and "vase_1" in n.participants
        )
        speeds.append(carried(doc, story, "ball_b", hit))
    assert speeds[0] < 0.6 * speeds[1] < 3.0


@pytest.mark.parametrize(
    "prompt",
    [
        "Ball A with a mass of 2 kg moves at 3 m/s and hits ball B at rest; ball B then knocks over "
        "a cone.",
        "A ball hits another ball, which knocks over a traffic cone.",
        "A crate slides into a traffic cone and knocks it over.",
    ],
)
def test_what_is_made_easy_to_tip_still_feels_the_hit(prompt: str) -> None:
    doc = cast(prompt)
    story = read_story(doc)
    hit = [n for n in story.nodes.values() if n.event is NodeEvent.COLLISION][-1]
    mover, target = hit.participants[:2]
    limit = fastest(story, mover, hit.id)
    if not story.is_active(mover):
        limit = carried(doc, story, mover, hit)
    a, b = prop(doc, mover), prop(doc, target)
    assert topple_speed(a, b, flies=False) <= limit
    assert felt(a, b) * limit >= 0.99 * FELT_NS


def test_a_target_has_something_to_spare_where_its_mass_is_open() -> None:
    open_mass = cast("A skateboard knocks over a trash can.")
    stated = cast("A skateboard knocks over a trash can of 6 kg.")
    speeds = [
        topple_speed(prop(d, "skateboard_1"), prop(d, "trash_can_1"), flies=False)
        for d in (open_mass, stated)
    ]
    assert speeds[0] < 0.72 * 8.0
    assert prop(stated, "trash_can_1").mass == pytest.approx(6.0)


def test_what_is_made_smaller_keeps_the_feet_that_it_was_given() -> None:
    doc = cast("A wheel rolls into a bin after 2 seconds and knocks it over.")
    usual = resolve(draft("A bin stands here."))
    wheel, bin_ = prop(doc, "wheel_1"), prop(doc, "bin_1")
    assert bin_.height < prop(usual, "bin_1").height
    assert bin_.friction > 0.6
    assert topple_speed(wheel, bin_, flies=False) < 10.0


def test_what_is_hit_below_its_centre_has_room_to_tip_back_while_its_base_runs_ahead() -> None:
    doc = cast("A skateboard hits a trash can, and the trash can falls over and hits a bench.")
    [places] = choreograph(doc).hints.constellations
    at = {p.node: p.x_cm / 100.0 for p in places.placements}
    board, can, bench = (prop(doc, n) for n in ("skateboard_1", "trash_can_1", "bench_1"))
    gap = at["bench_1"] - at["trash_can_1"] - can.half_length - min(bench.length, bench.width) / 2
    speed = passed_on(board, can) * nominal(doc, "skateboard_1")
    ahead = math.sqrt(can.height / GRAVITY_MPS2) * speed
    assert gap > 0.95 * min(ahead, FARTHEST_AHEAD * can.height) > 0.86 * can.height
