"""A topple is measured from the initial pose, as the judge does."""

from __future__ import annotations

import numpy as np
import pytest

from esg.dynamics.losses.measures import Detected, topple
from esg.dynamics.story.story import Story
from esg.graph.models import NodeEvent, TimelineNode
from esg.units import quat_from_euler_deg
from tests.dynamics.recordings import FPS, recording, rollout

NODE = TimelineNode(id="e", event=NodeEvent.TOPPLE, participants=("a",), window=(0.0, 3.0))


def tipped(earliest: list[float]) -> Detected:
    """One body falls over by 90 degrees from 0.5 to 1.5 s in worlds that ask for it later or not."""
    rolled = rollout([[] for _ in earliest])
    t = np.arange(rolled.position.shape[1]) / FPS
    pitch = 90.0 * np.clip(t - 0.5, 0.0, 1.0)
    rolled.quaternion[:, :, 0] = np.array([quat_from_euler_deg(0.0, p) for p in pitch])
    rec = recording(rolled)
    rec.story = Story({"e": NODE}, {"e": ()}, {}, {}, {}, {})
    return topple(rec, NODE, np.array(earliest), lambda *_: None)


def test_what_tilts_already_topples_at_the_same_angle_and_only_once() -> None:
    """30 degrees at 0.83 s leave 17 to go; who lies at 69 degrees at 1.27 s has toppled before."""
    found = tipped([0.0, 0.83, 1.27])
    assert found.time[:2] == pytest.approx(0.5 + 47.0 / 90.0, abs=2.0 / FPS)
    assert np.isinf(found.time[2])


def test_a_topple_that_came_too_early_costs_the_more_the_earlier_it_came() -> None:
    far = tipped([0.0, 1.1, 1.2]).far
    assert 0.5 < far[1] < far[2]
