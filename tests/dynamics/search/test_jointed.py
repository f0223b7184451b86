"""Scenes with joints are searched in the reference engine: the surrogate knows no joints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.plan import Plan
from esg.dynamics.plan.build import build_scene
from esg.dynamics.plan.planner import make_plan
from esg.dynamics.search.batched import search
from esg.dynamics.search.bystanders import bystanders
from esg.dynamics.search.panel import REFERENCE_DT_S, Panel
from esg.dynamics.strategies import optimize
from esg.engines.jobs import make_job
from esg.engines.joints import Joint, joint_between
from esg.engines.program import Program, batch_programs
from esg.engines.rest import at_rest
from esg.engines.scene import SimScene
from esg.engines.shapes import SceneShapes
from esg.graph.models import (
    Actor,
    EsgDocument,
    EventConstraint,
    LayoutResult,
    Pose,
    TimelineEdge,
    TimelineNode,
)
from esg.outcomes import UserError
from tests.dynamics.stage import BALL, asset, document

N = TimelineNode
DOOR = asset("door", (90, 4, 200), 20.0)
CRATE = asset("crate", (40, 40, 40), 6.0)
BOB = asset("bob", (20, 20, 20), 4.0, "sphere")


def _edge(name: str, event: str, actor: str, target: str, ends: tuple[str, str], **params):
    keys = {"id": name, "from": ends[0], "to": ends[1], "event": event}
    return TimelineEdge(**keys, actor=actor, target=target, params=params)


def _placed(doc: EsgDocument, **at: tuple[float, float, float]) -> EsgDocument:
    poses = {n: Pose(position_cm=p) for n, p in {"ground_1": (0, 0, 0), **at}.items()}
    return doc.model_copy(update={"layout_result": LayoutResult(poses=poses, energy=0.0)})


def ball_opens_door() -> tuple[EsgDocument, list[Joint]]:
    """A ball is rolled at a hanging door, which swings open against a crate."""
    doc = document(
        "door",
        dict(ball_1=BALL, door_1=DOOR, crate_1=CRATE),
        {
            "ball_1": Actor(role="active", force_direction="HORIZONTAL_PLANE"),
            "door_1": Actor(role="passive"),
            "crate_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("ball_1", "door_1"), window=(0.3, 2)),
            N(id="e2", event="Collision", participants=("door_1", "crate_1"), window=(0.8, 4)),
        ],
        [
            _edge("roll", "Toward", "ball_1", "door_1", ("start", "e1"), speed=(200, 900),
                  spin="roll"),
            _edge("swing", "InertialConnector", "door_1", "crate_1", ("e1", "e2")),
        ],
    )  # fmt: skip
    doc = _placed(doc, door_1=(0, 0, 1), ball_1=(30, -300, 0), crate_1=(20, 40, 0))
    leaf = build_scene(doc).body("door_1")
    hinge = joint_between("hinge", "hinge", leaf, None, at=(-0.45, 0.0, 1.0), axis=(0.0, 0.0, 1.0))
    return doc, [replace(hinge, damping=0.5)]


def bob_hits_crate(speed_after: float) -> tuple[EsgDocument, list[Joint]]:
    """A bob on a rope is pushed into a crate that shall have a certain speed then [cm/s]."""
    wanted = EventConstraint(quantity="speed_after", object="crate_1", value=speed_after)
    doc = document(
        "bob",
        dict(bob_1=BOB, crate_1=CRATE),
        {
            "bob_1": Actor(role="active", force_direction="HORIZONTAL_PLANE"),
            "crate_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("bob_1", "crate_1"), window=(0.2, 2),
              constraints=(wanted,)),
        ],
        [_edge("push", "Toward", "bob_1", "crate_1", ("start", "e1"), speed=(50, 800))],
    )  # fmt: skip
    doc = _placed(doc, bob_1=(0, 0, 10), crate_1=(90, 0, 0))
    bob = build_scene(doc).body("bob_1")
    rope = joint_between("rope", "rope", bob, None, at=bob.position, parent_at=(0.0, 0.0, 2.2))
    return doc, [replace(rope, upper=2.0)]


def jointed(doc: EsgDocument, joints: list[Joint]) -> Plan:
    plan = make_plan(doc, build_scene(doc), seed=0)
    return replace(plan, scene=replace(plan.scene, joints=tuple(joints)))


@pytest.mark.parametrize(
    "story", [ball_opens_door(), bob_hits_crate(150.0)], ids=["ball opens door", "bob hits crate"]
)
def test_search_makes_the_events_of_a_jointed_scene_happen(story) -> None:
    """In all members of the ensemble, as asked, and nothing was played without the joints."""
    plan = jointed(*story)
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    found, _ = search(plan, panel, np.random.default_rng(0), 8)
    assert found.ensemble.all_completed().all(), found.ensemble.completed
    assert found.ensemble.within_tolerance().all(), found.ensemble.error
    assert {s.engine for s in panel.steps} == {"newton"}


def test_the_same_theta_without_joints_tells_another_story() -> None:
    """Off its hinges the leaf falls over."""
    plan = jointed(*ball_opens_door())
    panel = Panel(plan, "cpu", dt=REFERENCE_DT_S)
    hung = panel.reference.play_on(plan.initial(), 3.0)
    loose = Panel(replace(plan, scene=replace(plan.scene, joints=())), "cpu", dt=REFERENCE_DT_S)
    fallen = loose.reference.play_on(plan.initial(), 3.0)
    leaf = plan.scene.index("door_1")
    assert hung.position[0, :, leaf, 2].min() > 0.99
    assert fallen.position[0, -1, leaf, 2] < 0.5


def test_what_is_joined_neither_rests_nor_stands_by() -> None:
    """A leaf that stands on the ground may be pulled by its hinge."""
    doc, _ = ball_opens_door()
    doc = _placed(doc, door_1=(0, 0, 0), ball_1=(30, -300, 0), crate_1=(20, 140, 0))
    scene = build_scene(doc)
    crate = scene.body("crate_1")
    rope = joint_between("r", "rope", crate, None, at=crate.position, parent_at=(2.0, 1.4, 1.0))
    tied = replace(scene, joints=(replace(rope, upper=3.0),))
    index = scene.index("crate_1")
    assert at_rest(scene)[index] and not at_rest(tied)[index]
    assert not bystanders(replace(make_plan(doc, scene), scene=tied))[index]


def test_surrogate_and_what_differentiates_it_refuse_joints(monkeypatch) -> None:
    doc, joints = ball_opens_door()
    scene: SimScene = replace(build_scene(doc), joints=tuple(joints))
    batch = batch_programs([Program((), 0.1)], scene.names)
    with pytest.raises(ValueError, match="has joints, which the surrogate cannot simulate"):
        make_job("surrogate", 0, scene, SceneShapes.of(scene), batch,
                 dt=REFERENCE_DT_S, record_every=1, variation=None)  # fmt: skip
    monkeypatch.setattr("esg.dynamics.strategies.build_scene", lambda _: scene)
    for options in ({"strategy": "ad"}, {"strategy": "hybrid"}, {"collision": "sdf"}):
        with pytest.raises(UserError, match="knows no joints"):
            optimize(doc, **options)
