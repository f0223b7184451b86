"""The search tells the same hits, entries and topples from a rollout as the judge does."""

from __future__ import annotations

from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
import pytest

from esg.dynamics.losses.assessment import assess
from esg.dynamics.losses.hits import first_hit
from esg.dynamics.losses.measures import enter, topple
from esg.dynamics.story.story import Story
from esg.engines.program import Program
from esg.graph.models import NodeEvent, TimelineNode
from esg.metrics import SuiteEvent, SuiteScene, judge
from esg.units import quat_from_euler_deg
from tests.dynamics.recordings import FPS, SCENE, Row, recording, rollout


def touching(begin: float, end: float, impulse: float = 0.2, b: int = 1) -> list[Row]:
    return [(k / FPS, 0, b, impulse) for k in range(round(begin * FPS), round(end * FPS) + 1)]


def test_what_goes_on_touching_does_not_hit_again() -> None:
    rec = recording(rollout([touching(1.0, 2.0), touching(1.2, 2.0)]))
    hits = first_hit(rec, [0], [1], np.array([1.1, 1.1]))
    assert hits.time.tolist() == [np.inf, 1.2]
    assert hits.early[0] == pytest.approx(0.1)
    assert np.isinf(hits.early[1])


def test_after_a_pause_it_hits_again_and_so_does_a_blow_on_what_rests_there() -> None:
    pause = touching(1.0, 1.1) + touching(1.3, 1.5)
    blow = touching(1.0, 2.0, 0.02)
    blow[30] = (1.5, 0, 1, 0.5)
    rec = recording(rollout([pause, blow]))
    hits = first_hit(rec, [0], [1], np.array([1.1, 1.1]))
    assert hits.time.tolist() == [1.3, 1.5]


def test_a_graze_does_not_hide_the_hit_behind_it() -> None:
    rec = recording(rollout([touching(1.0, 1.0, 0.01) + touching(1.5, 1.6)]))
    hits = first_hit(rec, [0], [1], np.zeros(1))
    assert hits.time[0] == 1.5
    assert hits.sound(3.0)[0]


def test_hits_of_two_targets_do_not_add_up() -> None:
    weak = [(1.0, 0, 1, 0.07), (1.0 + 1 / FPS, 0, 2, 0.07)]
    rec = recording(rollout([weak]))
    assert not first_hit(rec, [0], [1, 2], np.zeros(1)).sound(3.0)[0]


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_search_and_judge_tell_the_same_hit(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows: list[Row] = []
    for _ in range(int(rng.integers(1, 6))):
        begin = float(rng.uniform(0.1, 2.2))
        scale = float(rng.choice([0.01, 0.1, 0.5]))
        rows += [
            (t, i, b, float(rng.uniform(0.2, 1.0)) * scale)
            for t, i, b, _ in touching(begin, begin + float(rng.uniform(0.0, 0.6)), b=1)
        ]
    rows = sorted({r[0]: r for r in rows}.values())
    earliest = float(rng.uniform(0.0, 2.0))
    # A hit of a and c at the time before which hits of a and b do not count.
    since = [(earliest, 0, 2, 1.0)]
    rolled = rollout([rows + since])
    hits = first_hit(recording(rolled), [0], [1], np.array([earliest + 0.1]))
    events = (
        SuiteEvent(id="e1", type="collision", a="=a", b="=c"),
        SuiteEvent(id="e2", type="collision", a="=a", b="=b", after=("e1",)),
    )
    suite = SuiteScene(id="S", prompt="x", level="chain", events=events, constraints=())
    verdict = judge(SCENE, Program((), 3.0), rolled, suite)
    found = verdict.events[1]
    assert bool(hits.sound(3.0)[0]) == found.completed
    if found.completed:
        assert hits.time[0] == pytest.approx(found.time_s)


def test_what_is_inside_already_does_not_enter() -> None:
    rolled = rollout([[], []])
    path = np.tile(rolled.position[:1], (2, 1, 1, 1)).copy()
    path[0, 30:, 0] = path[0, 30:, 2]
    path[1, 90:, 0] = path[1, 90:, 2]
    rec = recording(replace(rolled, position=path))
    node = TimelineNode(id="n", event=NodeEvent.ENTER_REGION, participants=("a",),
                        region="c/inside")  # fmt: skip
    time, _ = enter(rec, node, np.array([1.0, 1.0]), lambda *_: None)
    assert time.tolist() == [np.inf, 1.5]


def test_what_lies_already_does_not_topple() -> None:
    rolled = rollout([[], []])
    turned = np.array(rolled.quaternion).copy()
    turned[0, 30:, 0] = quat_from_euler_deg(0.0, 80.0)
    turned[1, 90:, 0] = quat_from_euler_deg(0.0, 80.0)
    rec = recording(replace(rolled, quaternion=turned))
    node = TimelineNode(id="n", event=NodeEvent.TOPPLE, participants=("a",))
    time, _ = topple(rec, node, np.array([1.0, 1.0]), lambda *_: None)
    assert time.tolist() == [np.inf, 1.5]


def test_an_event_waits_for_all_that_it_follows() -> None:
    start = TimelineNode(id="start", event=NodeEvent.SCENE_START, participants=())
    meet = [
        TimelineNode(id=f"{x}{y}", event=NodeEvent.COLLISION, participants=(x, y))
        for x, y in ("ab", "bc", "ac")
    ]
    nodes = {n.id: n for n in (start, *meet)}
    before = {"start": (), "ab": ("start",), "bc": ("start",), "ac": ("ab", "bc")}
    story = Story(nodes, before, {}, {}, {}, {})
    early: list[Row] = [(1.0, 1, 2, 1.0), (1.5, 0, 2, 1.0), (2.0, 0, 1, 1.0)]
    late: list[Row] = [(1.0, 1, 2, 1.0), (2.0, 0, 1, 1.0), (2.3, 0, 2, 1.0)]
    found = assess(SCENE, story, rollout([early, late]), [{}, {}])
    assert found.completed["ac"].tolist() == [False, True]
