"""A climb is one program, and leads along the surface in every engine."""

from __future__ import annotations

from dataclasses import replace
import math

import numpy as np
import pytest

from esg.compile import compile_scene, replay_class
from esg.dynamics.plan import make_plan
from esg.dynamics.plan.build import build_scene
from esg.engines import get_engine
from esg.engines.manifest import load_manifest
from esg.engines.program import GuideAlong, HoldSpin, batch_programs
from esg.graph import verify
from esg.graph.models import Actor, EsgDocument, TimelineEdge, TimelineNode
from esg.units import quat_rotate
from tests.dynamics.stage import asset, document, lay_out

CAT = asset("cat", (50, 14, 30), 4)
MAN = asset("man", (30, 50, 172), 70)
WALL = asset("wall", (20, 300, 200), 2000, movable=False)
CRATE = asset("crate", (80, 80, 50), 300, movable=False, surface=True)
N = TimelineNode


def climbing(who, thing, course: str, *later: tuple[N, TimelineEdge], **params) -> EsgDocument:
    """Somebody climbs something at 0.5 m/s."""
    nodes = [
        N(id="start", event="SceneStart", timestamp=0),
        N(id="there", event="Trigger", participants=("who_1",), window=(0.5, 12)),
        *(n for n, _ in later),
    ]
    edge = TimelineEdge(
        **{"id": "climb", "from": "start", "to": "there", "event": "Guide"},
        actor="who_1",
        target="thing_1",
        params={"climbs": course, "speed": 75.0, **params},
    )
    actor = Actor(role="active", force_direction="ALONG_FORWARD_ONLY")
    doc = document("climb", {"who_1": who, "thing_1": thing}, {"who_1": actor}, nodes,
                   [edge, *(e for _, e in later)])  # fmt: skip
    return lay_out(doc)


def planned(doc: EsgDocument):
    """Plan, program, and the scene with everybody where he starts."""
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    starts = plan.starts(plan.initial())
    bodies = []
    for b in scene.bodies:
        at, turn = starts.get(b.name, (b.position, b.quaternion))
        bodies.append(
            replace(b, position=tuple(map(float, at)), quaternion=tuple(map(float, turn)))
        )
    return plan, plan.compile(plan.initial()), replace(scene, bodies=tuple(bodies))


def played(doc: EsgDocument, engine: str):
    plan, program, scene = planned(doc)
    dt = 1 / 120 if engine == "newton" else 1 / 240
    batch = batch_programs([program], scene.names)
    rollout = get_engine(engine).rollout(scene, batch, dt=dt, duration=plan.duration)
    body = scene.index("who_1")
    return plan, rollout.position[0, :, body].astype(float), rollout.quaternion[0, :, body]


def test_the_document_is_valid_and_a_climb_has_guides_and_spins():
    doc = climbing(CAT, WALL, "up", release=False)
    assert not [v for v in verify(doc) if "timeline" in v.pointer]
    plan, _, _ = played(doc, "surrogate")
    kinds = {type(p) for p in plan.compile(plan.initial()).primitives}
    assert kinds == {GuideAlong, HoldSpin}


@pytest.mark.parametrize("engine", ["newton", "physx", "rapier", "surrogate"])
def test_a_cat_holds_on_to_the_wall_head_up_in_every_engine(engine):
    plan, path, turn = played(climbing(CAT, WALL, "up", release=False), engine)
    nose = quat_rotate(np.array(turn[-1], float), np.array([1.0, 0.0, 0.0]))
    assert math.degrees(math.asin(nose[2])) > 87.0
    assert path[-1, 2] - path[0, 2] > 0.8
    wall = np.array(plan.scene.body("thing_1").position)
    off = np.linalg.norm((path[-1] - wall)[:2]) - 0.1 - 0.15
    assert 0.0 < off < 0.05
    assert np.ptp(path[-60:], axis=0).max() < 0.005


@pytest.mark.parametrize("engine", ["newton", "physx", "rapier"])
def test_who_climbs_onto_a_crate_is_let_go_and_stands_there(engine):
    _, path, turn = played(climbing(MAN, CRATE, "onto"), engine)
    assert path[-1, 2] == pytest.approx(0.5 + 0.86, abs=0.01)
    up = quat_rotate(np.array(turn[-1], float), np.array([0.0, 0.0, 1.0]))
    assert up[2] > 0.999


def test_who_comes_down_starts_where_the_way_begins():
    plan, path, turn = played(climbing(CAT, WALL, "down"), "physx")
    nose = quat_rotate(np.array(turn[0], float), np.array([1.0, 0.0, 0.0]))
    assert nose[2] > 0.99
    assert path[0, 2] - path[-1, 2] > 0.8
    assert plan.duration > 2.0


def test_who_has_climbed_up_jumps_down_away_from_it():
    fall = N(id="fall", event="Fall", participants=("who_1",), window=(1, 14))
    leap = TimelineEdge(
        **{"id": "leap", "from": "there", "to": "fall", "event": "Toward"},
        actor="who_1",
        params={"speed": 100.0},
    )
    plan, path, _ = played(climbing(MAN, WALL, "up", (fall, leap), release=False), "physx")
    wall = np.array(plan.scene.body("thing_1").position)[:2]
    away = np.linalg.norm(path[:, :2] - wall, axis=1)
    top = int(path[:, 2].argmax())
    assert path[top, 2] > 1.5
    assert away[-1] > away[top] + 0.2
    assert path[-1, 2] < 1.0


def test_the_compiled_class_climbs_the_same_way(tmp_path):
    doc = climbing(CAT, WALL, "onto")
    _, path, _ = played(doc, "physx")
    _, program, scene = planned(doc)
    compile_scene(doc, tmp_path, scene=scene, program=program)
    replay = replay_class(tmp_path, dt=1 / 240).rollout
    names = [b.name for b in load_manifest(tmp_path / "manifest.json").scene.bodies]
    end = replay.position[0, -1, names.index("who_1")]
    np.testing.assert_allclose(end, path[-1], atol=0.02)
