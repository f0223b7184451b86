"""Long rows: what is hit sends the next thing on, from hit to hit."""

from __future__ import annotations

from dataclasses import replace
import itertools

import numpy as np
import pytest

from esg.dynamics.casting.chains import HEAVIEST, POLISHED, SOLID_KG_M3
from esg.dynamics.choreography.hits.rows import ROUGHER, ROW_S, asked_of_first, rows
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.losses import Assessment
from esg.dynamics.search.panel import Found
from esg.dynamics.story.stagecraft import prop
from esg.dynamics.story.story import read_story
from esg.thresholds import MIN_EVENT_GAP_S, SAFE_IMPULSE_NS
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def row(thing: str, hits: int) -> str:
    pairs = itertools.pairwise("ABCDEFGHIJKLM"[: hits + 1])
    told = ", then ".join(f"{thing} {a} hits {thing} {b}" for a, b in pairs)
    return told[0].upper() + told[1:] + "."


@pytest.mark.parametrize("hits", [7, 10])
def test_balls_of_a_long_row_go_calmly_and_still_feel_the_last_hit(hits: int) -> None:
    doc = cast(row("ball", hits))
    (names,) = rows(doc, read_story(doc))
    assert len(names) == hits + 1
    balls = [prop(doc, n) for n in names]
    told = choreograph(doc)
    speed = next(v for k, v in told.nominal.items() if k.endswith("/speed"))
    # One hit sends on (1 + e) / 2, and of that a ball that slides until it rolls keeps five
    # sevenths: what its back spin takes and how it coasts cost a little more.
    kept = 0.5 * (1.0 + balls[0].restitution) * 5.0 / 7.0
    assert balls[0].mass * speed * kept ** (hits - 1) > SAFE_IMPULSE_NS
    spots = {p.node: p for c in told.hints.constellations for p in c.placements}
    x = [spots[n].x_cm / 100.0 for n in names]
    gaps = [b - a - balls[0].width for a, b in itertools.pairwise(x[1:])]
    assert max(gaps) < 1.7 * balls[0].width
    assert all(later <= sooner + 0.02 for sooner, later in itertools.pairwise(gaps))


def test_a_row_of_sliding_things_is_reckoned_from_its_end() -> None:
    """Equal and perfectly springy, each takes over all of the speed and loses friction's share."""
    doc = cast(row("crate", 4))
    thing = replace(prop(doc, "crate_a"), restitution=1.0, friction=0.2, ground=0.8, mass=10.0)
    slowed = ROUGHER * 0.5 * GRAVITY_MPS2 * ROW_S[1]
    last = 0.5 * slowed
    assert asked_of_first([thing] * 5) == pytest.approx(last + 3.0 * slowed)
    assert asked_of_first([thing] * 5, last=3.0) == pytest.approx(3.0 + 3.0 * slowed)


def test_hits_of_a_row_of_crates_lie_a_little_over_the_least_time_apart() -> None:
    doc = cast(row("crate", 7))
    told = choreograph(doc).nominal
    times = [told[f"crate_{a}_crate_{b}_collision/event_time"]
             for a, b in itertools.pairwise("abcdefgh")]  # fmt: skip
    assert all(MIN_EVENT_GAP_S < b - a < 0.2 for a, b in itertools.pairwise(times))


def test_only_balls_of_any_kind_may_be_solid() -> None:
    ball = cast(row("ball", 10)).asset_configurations["ball_01"]
    volume = np.pi / 6.0 * (0.01 * ball.dimensions_cm[0]) ** 3
    assert HEAVIEST * 0.5 < ball.mass_kg <= SOLID_KG_M3 * volume
    assert ball.friction == POLISHED
    football = cast(row("soccer ball", 10)).asset_configurations["soccer_ball_01"]
    assert football.mass_kg == pytest.approx(HEAVIEST * 0.43)
    stated = cast(row("ball", 10)[:-1] + ". The balls weigh 2 kg.")
    assert all(c.mass_kg in (0.5, 2.0) for c in stated.asset_configurations.values() if c.rolls)


def test_a_guessed_window_is_no_reason_to_search_on() -> None:
    """Long after the time that the draft guessed, everything happens in all members."""
    terms = {"e/task": np.zeros(8), "e/window": np.full(8, 3.0)}
    done = {"e": np.ones(8, bool)}
    guessed = Assessment(np.full(8, 3.0), done, terms=terms, guessed={"e/window"})
    # Of a prescribed time the same loss tells that it is missed.
    missed = {"e/time/e": np.full(8, 2.0)}
    prescribed = Assessment(np.full(8, 3.0), done, terms=terms, error=missed, measured=missed)
    for ensemble, good in ((guessed, True), (prescribed, False)):
        found = Found(np.zeros(1), 3.0, ensemble.worlds(slice(0, 1)), ensemble)
        assert found.good() is good
