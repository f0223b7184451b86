"""A break is found in a recording with fragments, and expected of a blow in one without."""

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.dynamics.losses.breaking import broke
from esg.dynamics.losses.recording import Recording
from esg.engines import get_engine
from esg.engines.breaking import unbroken
from esg.engines.breaking.pieces import broken
from esg.engines.program import Program, batch_programs
from esg.engines.scene import Body, Shape, SimScene
from esg.graph.models import TimelineNode

UNIT = ((0.02, 0.0, 0.0), (0.0, 0.02, 0.0), (0.0, 0.0, 0.02))
POT = Body("pot", False, 2.0, UNIT, (Shape("box", (0.1, 0.1, 0.1)),), (0.0, 0.0, 0.9))
NODE = TimelineNode(id="e", event="Break", participants=("pot",), window=(0.0, 9.0))


class NoStory:
    def expand(self, name):
        return (name,)


def found(bears: float, *, fragments: bool, since: float = 0.0) -> tuple[float, float, float]:
    whole, pieces = broken(replace(POT, break_impulse=bears), 6)
    scene = SimScene("s", (whole, *pieces))
    scene = scene if fragments else unbroken(scene)
    out = get_engine("rapier").rollout(
        scene, batch_programs([Program((), 0.8)], scene.names), dt=1 / 240, record_every=2
    )
    terms: dict[str, np.ndarray] = {}
    rec = Recording(scene, NoStory(), out, [{}])  # type: ignore[arg-type]
    result = broke(rec, NODE, np.full(1, since), terms.__setitem__)
    return float(result.time[0]), float(result.far[0]), float(terms["e/weak"][0])


@pytest.mark.parametrize("fragments", [True, False])
def test_it_breaks_when_it_lands_and_a_harder_blow_is_nearer(fragments: bool) -> None:
    landing = math.sqrt(2.0 * 0.8 / 9.81)
    time, _, weak = found(4.0, fragments=fragments)
    assert time == pytest.approx(landing, abs=0.03)
    assert weak == 0.0
    misses = [found(bears, fragments=fragments) for bears in (12.0, 40.0)]
    assert all(math.isinf(time) for time, _, _ in misses)
    assert misses[0][1] < misses[1][1]


def test_the_harder_a_blow_that_breaks_it_too_early_the_farther() -> None:
    """A push off a table must not break what is to break on the floor."""
    gentle, hard = (found(bears, fragments=False, since=0.7) for bears in (6.0, 3.0))
    assert math.isinf(gentle[0]) and math.isinf(hard[0])
    assert 1.0 < gentle[1] < hard[1]


def test_what_does_not_break_never_does() -> None:
    scene = SimScene("s", (POT,))
    out = get_engine("rapier").rollout(
        scene, batch_programs([Program((), 0.2)], scene.names), dt=1 / 240
    )
    rec = Recording(scene, NoStory(), out, [{}])  # type: ignore[arg-type]
    assert math.isinf(float(broke(rec, NODE, np.zeros(1), lambda *_: None).time[0]))
