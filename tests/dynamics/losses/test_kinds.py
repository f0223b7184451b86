"""Types of events are rows of one table: whoever registers one has it detected and searched for."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics import build_scene
from esg.dynamics.gradient.differentiate import Regime, gradient, regimes
from esg.dynamics.losses import kinds
from esg.dynamics.losses.assessment import Assessment, assess
from esg.dynamics.losses.horizon import told_by
from esg.dynamics.losses.kinds import EventKind, Spacing, kind_of, register
from esg.dynamics.losses.measures import AddTerm, Detected
from esg.dynamics.losses.recording import Floats, Recording
from esg.dynamics.losses.residuals import Signal, Threshold, crossing
from esg.dynamics.losses.shapes import MISSED
from esg.dynamics.plan.planner import Plan, make_plan
from esg.dynamics.story.story import Story
from esg.graph.models import EventConstraint, NodeEvent, TimelineNode
from tests.dynamics import stories
from tests.dynamics.recordings import FPS, SCENE, rollout
from tests.dynamics.stage import lay_out

RISE = "Rise"
LIFT_M = 0.5


def rises(rec: Recording, node: TimelineNode, earliest: Floats, add: AddTerm) -> Detected:
    """The first participant gets `LIFT_M` over its start; fast is better."""
    z = rec.r.position[:, :, rec.members(node.participants[0])[0], 2].astype(float)
    lift = z - z[:, :1]
    late = rec.t[None, :] >= earliest[:, None]
    time = rec.first((lift >= LIFT_M) & late)
    add(f"{node.id}/lazy", np.where(np.isfinite(time), 0.1 * time, 0.0))
    return Detected(time, ((LIFT_M - lift.max(axis=1)) / LIFT_M) ** 2)


@pytest.fixture(autouse=True)
def _own_table(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a test registers is forgotten after it."""
    monkeypatch.setattr(kinds, "KINDS", dict(kinds.KINDS))


def event(node_id: str, kind: str, *names: str, **more: object) -> TimelineNode:
    node = TimelineNode(id=node_id, event=NodeEvent.REACH, participants=names, window=(0.0, 3.0))
    return node.model_copy(update={"event": kind, **more})


def assessed(*nodes: TimelineNode) -> Assessment:
    """Three worlds in which a rises at 0.4, 0.1 and 0.4 m/s, and touches b at 2.0, 2.0 and 1.0 s."""
    start = TimelineNode(id="start", event=NodeEvent.SCENE_START, timestamp=0.0)
    chain = [start, *nodes]
    before = {n.id: (p.id,) for p, n in zip(chain, nodes, strict=False)}
    story = Story({n.id: n for n in chain}, before, {}, {}, {}, {})
    rolled = rollout([[(t, 0, 1, 0.2)] for t in (2.0, 2.0, 1.0)])
    position = rolled.position.copy()
    position[:, :, 0, 2] += np.array([[0.4], [0.1], [0.4]]) * np.arange(position.shape[1]) / FPS
    return assess(SCENE, story, replace(rolled, position=position), [{}] * 3)


def test_an_event_of_an_unknown_type_is_refused_by_name() -> None:
    with pytest.raises(KeyError, match=r"'rise' is of the unknown type 'Rise'.*Collision"):
        assessed(event("rise", RISE, "a"))


def test_a_registered_type_is_detected_and_costs_what_it_says() -> None:
    register(EventKind(RISE, rises, after_s=0.2))
    found = assessed(event("rise", RISE, "a"))
    assert found.completed["rise"].tolist() == [True, False, True]
    assert found.time["rise"][[0, 2]] == pytest.approx(1.25, abs=1.0 / FPS)
    missed = MISSED + ((LIFT_M - 0.3) / LIFT_M) ** 2
    assert found.terms["rise/task"] == pytest.approx([0.0, missed, 0.0], abs=1e-5)
    assert found.terms["rise/lazy"] == pytest.approx([0.125, 0.0, 0.125], abs=0.1 / FPS)
    assert found.total == pytest.approx([0.125, missed, 0.125], abs=0.005)


def test_other_events_follow_it_and_its_quantities_are_measured() -> None:
    register(EventKind(RISE, rises, after_s=0.2))
    height = EventConstraint(quantity="height", object="a", value=50.0)
    rise = event("rise", RISE, "a", constraints=(height,))
    hit = event("hit", NodeEvent.COLLISION, "a", "b")
    found = assessed(rise, hit)
    assert found.completed["hit"].tolist() == [True, False, False]
    assert found.terms["hit/task"][1] == MISSED + 30.0
    # From its start, 0.1 m over the ground, half a metre up.
    assert found.measured["rise/height/a"][0] == pytest.approx(0.6, abs=0.4 / FPS)
    story = Story({n.id: n for n in (rise, hit)}, {}, {}, {}, {}, {})
    end = told_by(story, found)
    assert end[0] == pytest.approx(2.0 + kind_of(hit).after_s) and np.isinf(end[1:]).all()


def test_a_type_says_what_it_costs_to_follow_another_one_closely() -> None:
    register(EventKind(RISE, rises))
    plain = kind_of(event("hit", NodeEvent.COLLISION))
    spacing = Spacing("hasty", lambda late: np.maximum(1.0 - late, 0.0))
    register(replace(plain, spacings={**plain.spacings, RISE: spacing}))
    found = assessed(event("rise", RISE, "a"), event("hit", NodeEvent.COLLISION, "a", "b"))
    late = 2.0 - found.time["rise"][0] - plain.gap_s
    assert found.terms["hit/hasty"] == pytest.approx([1.0 - late, 0.0, 0.0])


def _renamed(plan: Plan, kind: str) -> Plan:
    """The plan with its first hit as an event of another type."""
    nodes = dict(plan.story.nodes)
    first = next(n for n in nodes.values() if n.event is NodeEvent.COLLISION)
    nodes[first.id] = first.model_copy(update={"event": kind})
    return replace(plan, story=replace(plan.story, nodes=nodes))


def test_a_registered_type_has_a_gradient_where_it_has_residuals() -> None:
    """One that happens as `Reach` does pulls on theta as that does, and without residuals nothing."""
    doc = lay_out(stories.three_balls())
    plan = make_plan(doc, build_scene(doc))
    reach = _renamed(plan, NodeEvent.REACH)
    nearness = kind_of(event("near", NodeEvent.REACH))
    assert nearness.smooth is not None

    def apart(plan: Plan, node: TimelineNode) -> Threshold:
        a, b = (plan.scene.index(p) for p in node.participants)

        def value(s: tuple[Floats, Floats, Floats]) -> Floats:
            return np.linalg.norm(s[0][:, a] - s[0][:, b], axis=-1)

        return Threshold(Signal((a, b), value), 0.3, 0.3)

    register(EventKind("Near", nearness.measure, smooth=nearness.smooth))
    register(EventKind("Centred", nearness.measure, smooth=crossing(apart)))
    register(EventKind("Rough", nearness.measure))
    theta = plan.initial()[None]
    expected = gradient(reach, theta)
    found = gradient(_renamed(plan, "Near"), theta)
    assert np.array_equal(found.gradient, expected.gradient)
    assert np.array_equal(found.loss, expected.loss)
    other = gradient(_renamed(plan, "Centred"), theta)
    assert np.isfinite(other.gradient).all() and not np.array_equal(
        other.gradient, expected.gradient
    )
    rough = _renamed(plan, "Rough")
    name = next(n.id for n in rough.story.nodes.values() if n.event == "Rough")
    assert regimes(rough)[name] is Regime.NONE
    assert regimes(_renamed(plan, "Near"))[name] is Regime.DIRECT
