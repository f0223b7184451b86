"""What turns with something on it turns so slowly that this stays there, upright."""

from __future__ import annotations

import math

import pytest

from esg.dynamics.choreography import choreograph
from esg.dynamics.story.riding import RIM_MPS, carried_rate
from esg.dynamics.story.stagecraft import Prop
from esg.units import GRAVITY_MPS2
from tests.dynamics.stories import cast


def box(width: float, height: float, friction: float) -> Prop:
    return Prop(width, width, height, 1.0, friction, 0.2, False, False, False)


@pytest.mark.parametrize(
    ("body", "limit"),
    [
        (box(0.5, 0.2, 0.3), 0.3),  # it would slide first
        (box(0.1, 0.5, 0.9), 0.05 / 0.25),  # it would tip first
    ],
)
def test_the_pull_outwards_stays_below_what_friction_and_the_base_hold(
    body: Prop, limit: float
) -> None:
    reach = 0.3
    rate, gain = carried_rate([body], reach)
    assert 1.4**2 * rate**2 * reach < limit * GRAVITY_MPS2  # as fast as the search may turn it
    assert gain * reach < limit * GRAVITY_MPS2
    assert rate * reach <= RIM_MPS


def test_a_turntable_is_turned_gently_with_a_vase_on_it_and_not_without() -> None:
    loaded = choreograph(cast("A vase stands on a turntable that makes one full turn.")).nominal
    empty = choreograph(cast("A turntable makes one full turn.")).nominal
    assert loaded["turntable_1_moved/ramp"] > 0.0
    assert loaded["turntable_1_moved/duration"] > 2.0 * math.pi
    assert "turntable_1_moved/ramp" not in empty
