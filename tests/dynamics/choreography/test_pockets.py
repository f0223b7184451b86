"""Shots into pockets: where balls lie follows from the times and speeds that the prompt gives."""

import math

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.choreography.telling import choreograph


def _placed(prompt: str) -> tuple[dict[str, tuple[float, float]], dict[str, float]]:
    doc = fitted(resolve(draft(prompt)))
    spots = {
        p.node: (p.x_cm, p.y_cm) for c in start_hints(doc).constellations for p in c.placements
    }
    return spots, choreograph(doc, seed=0).nominal


def _gap_cm(spots: dict[str, tuple[float, float]], a: str, b: str, diameter: float) -> float:
    return math.dist(spots[a], spots[b]) - diameter


@pytest.mark.parametrize(
    ("speed", "after"),
    [("at 2 m/s ", 0.6), ("at 1 m/s ", 1.0), ("", 1.5), ("", 2.0)],
)
def test_the_way_to_the_hit_fits_its_time(speed: str, after: float) -> None:
    """Let the cue ball start as far away as it rolls until the stated time."""
    spots, nominal = _placed(
        f"The cue ball rolls {speed}and hits the red ball after {after} s; "
        "the red ball drops into the top right pocket."
    )
    gap = _gap_cm(spots, "cue_ball_1", "red_ball_1", 5.715)
    assert 0.01 * gap == pytest.approx(nominal["cue_ball_1_roll/speed"] * after, rel=0.03)
    if speed:
        assert nominal["cue_ball_1_roll/speed"] == pytest.approx(float(speed.split()[1]))
    # Balls lie on the cloth.
    assert all(abs(x) < 118.0 and abs(y) < 118.0 for x, y in spots.values())


def test_a_time_that_no_table_holds_leaves_the_balls_on_it() -> None:
    """Keep the balls on the table where the stated time would need more room than it has."""
    spots, nominal = _placed(
        "The cue ball hits the red ball after 9 s; the red ball drops into the top right pocket."
    )
    assert all(abs(x) < 118.0 and abs(y) < 118.0 for x, y in spots.values())
    assert nominal["cue_ball_1_roll/speed"] > 0.5


def test_balls_that_pass_a_shot_on_lie_close() -> None:
    """A ball that was hit slows down and errors grow: it meets the next one soon."""
    spots, _ = _placed(
        "The cue ball hits the yellow ball, the yellow ball strikes the red ball and the red ball "
        "drops into the top right pocket."
    )
    assert 10.0 < _gap_cm(spots, "yellow_ball_1", "red_ball_1", 5.715) < 31.0
