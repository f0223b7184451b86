"""What goes about on a table gets nowhere off it."""

from __future__ import annotations

import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics.casting.stage import cast
from esg.dynamics.story.stagecraft import broadest_surface
from esg.graph.casting import effective
from esg.graph.models import EsgDocument


def _told(prompt: str) -> EsgDocument:
    return effective(cast(resolve(draft(prompt)), seed=0))


@pytest.mark.parametrize(
    "prompt",
    [
        "A toy car drives past a vase on a table.",
        "A toy train drives around a lamp on a table.",
        "A wind-up mouse drives in circles on a table.",
        "A cat walks past a flowerpot on a windowsill.",
        "On a desk, a marble rolls past a stapler.",
        "A puck slides between two mugs on a bar counter.",
    ],
)
def test_ways_on_a_table_are_told_to_fit_on_it(prompt: str) -> None:
    """Nothing fitted, so that the layout put it anywhere and it drove off."""
    doc = _told(prompt)
    assert doc.choreography is not None
    (told,) = doc.choreography.constellations
    assert told.anchor is not None
    surface = broadest_surface(doc, told.anchor)
    for p in told.placements:
        for at, middle, half in zip(
            (p.x_cm, p.y_cm), surface.center_cm[:2], surface.half_extents_cm, strict=True
        ):
            assert abs(at - middle) < half
    nominal = doc.choreography.nominal
    limits = [v for k, v in nominal.items() if k.endswith(("/at_most", "/most"))]
    assert limits and max(limits) < 3.0


@pytest.mark.parametrize(
    ("prompt", "top"),
    [
        ("A cat walks past a flowerpot on a windowsill.", "windowsill_1"),
        ("A toy boat slides along a shelf past a globe.", "shelf_1"),
        ("A toy train drives around a lamp on a table.", "table_1"),
    ],
)
def test_tops_grow_where_there_is_no_room_to_pass(prompt: str, top: str) -> None:
    """The cat ran into the flowerpot: the two are wider than the sill."""
    plain, doc = resolve(draft(prompt)), _told(prompt)
    width, deep = (min(broadest_surface(d, top).half_extents_cm) for d in (plain, doc))
    assert width < deep <= 2.0 * width + 1.0


def test_two_that_race_on_a_table_have_a_lane_each() -> None:
    """Both constellations were centred on it, one car within the other."""
    doc = _told("Two toy cars race across a table.")
    assert doc.choreography is not None
    spots = [(p.x_cm, p.y_cm) for c in doc.choreography.constellations for p in c.placements]
    assert len(spots) == 2
    assert abs(spots[0][0] - spots[1][0]) > 12.0 or abs(spots[0][1] - spots[1][1]) > 12.0
