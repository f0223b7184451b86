"""What flies under its own power stays in the air until its last hold ends."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics import build_scene, start_hints
from esg.dynamics.casting import fitted
from esg.dynamics.choreography.telling import choreograph
from esg.dynamics.plan.planner import make_plan
from esg.engines.program import HoldVelocity, batch_programs
from esg.engines.registry import get_engine
from esg.graph.models import Actor, EsgDocument, TimelineEdge, TimelineNode
from esg.layout import solve
from tests.dynamics.stage import asset, document, lay_out

DRONE = asset("drone", (40, 40, 15), 1.2)


def flight(
    target: tuple[float, float, float],
    *,
    end: str = "Collision",
    motion: str = "UniformMotion",
    falls: bool = False,
) -> EsgDocument:
    nodes = [
        TimelineNode(id="start", event="SceneStart", timestamp=0),
        TimelineNode(id="end", event=end, participants=("drone_1", "thing_1"), window=(1, 4)),
    ]
    more = {"elevation_deg": (-10.0, 60.0)} if motion == "Toward" else {}
    edges = [_edge("fly", "start", "end", motion, {"speed": 300.0, **more})]
    if falls:
        nodes.append(TimelineNode(id="fall", event="Fall", participants=("drone_1",)))
        edges.append(_edge("down", "end", "fall", motion, {"speed": 300.0}))
    return document(
        "a drone flies",
        {"drone_1": DRONE, "thing_1": asset("thing", target, 900, movable=False)},
        {"drone_1": Actor(role="active", force_direction="ANY_3D"), "thing_1": Actor(role="passive")},
        nodes,
        edges,
    )  # fmt: skip


def _edge(name: str, start: str, end: str, event: str, params: dict[str, object]) -> TimelineEdge:
    return TimelineEdge(
        **{
            "id": name, "from": start, "to": end, "event": event, "actor": "drone_1",
            "target": "thing_1", "params": params,
        }
    )  # fmt: skip


def played(doc: EsgDocument):
    laid = lay_out(doc)
    scene = build_scene(laid)
    plan = make_plan(laid, scene)
    program = plan.compile(plan.initial())
    batch = batch_programs([program], scene.names)
    return scene, program, get_engine("physx").rollout(scene, batch, duration=6.0)


def height_of(doc: EsgDocument) -> float:
    (constellation,) = start_hints(doc).constellations
    return next(p.z_cm for p in constellation.placements if p.node == "drone_1")


@pytest.mark.parametrize(
    ("target", "low", "high"),
    [
        ((300, 300, 3000), 100, 450),  # a tower: at a usual height, not at its top
        ((60, 60, 200), 100, 185),
        ((60, 60, 110), 80, 105),  # low: still within it
    ],
)
def test_it_flies_level_with_its_target_and_clear_of_the_ground(target, low, high):
    assert low <= height_of(flight(target)) <= high


def test_it_hits_at_its_height_and_falls_afterwards():
    scene, program, rollout = played(flight((200, 200, 300), falls=True))
    (hold,) = (p for p in program.primitives if isinstance(p, HoldVelocity))
    assert hold.climb == 0.0 and hold.until_contact == ("thing_1",)
    i, j = scene.index("drone_1"), scene.index("thing_1")
    log = rollout.contacts
    hit = log.time[((log.a == i) & (log.b == j)) | ((log.a == j) & (log.b == i))][0]
    before = rollout.time < hit - 0.01
    z = rollout.position[0, :, i, 2]
    np.testing.assert_allclose(z[before], z[0], atol=1e-3)
    assert z[-1] < 0.5 < z[0]


def test_it_comes_down_onto_what_is_flat():
    scene, program, rollout = played(flight((300, 300, 4)))
    (hold,) = (p for p in program.primitives if isinstance(p, HoldVelocity))
    assert hold.climb is not None and hold.climb < 0.0
    i = scene.index("drone_1")
    assert rollout.position[0, 0, i, 2] > 1.0
    assert len(rollout.contacts.time) and rollout.position[0, -1, i, 2] < 0.3


def test_it_stays_in_the_air_where_it_arrives():
    scene, _, rollout = played(flight((60, 60, 200), end="Reach"))
    i = scene.index("drone_1")
    assert rollout.position[0, -1, i, 2] == pytest.approx(rollout.position[0, 0, i, 2], abs=1e-3)
    assert float(np.linalg.norm(rollout.linear_velocity[0, -1, i])) < 0.05


def test_it_flies_on_past_what_it_does_not_touch():
    scene, program, rollout = played(flight((60, 60, 200), end="Miss"))
    (hold,) = (p for p in program.primitives if isinstance(p, HoldVelocity))
    assert math.isinf(hold.end)
    i = scene.index("drone_1")
    assert rollout.position[0, -1, i, 2] == pytest.approx(rollout.position[0, 0, i, 2], abs=1e-3)


def test_what_is_thrown_is_not_held_up():
    _, program, _ = played(flight((60, 60, 200), motion="Toward"))
    assert not any(isinstance(p, HoldVelocity) for p in program.primitives)


def test_what_turns_last_flies_straight_on_at_its_height():
    doc = fitted(resolve(draft("A drone flies forward for 2 seconds and turns left.")))
    laid = solve(doc, hints=start_hints(doc))
    scene = build_scene(laid)
    plan = make_plan(laid, scene)
    batch = batch_programs([plan.compile(plan.initial())], scene.names)
    rollout = get_engine("physx").rollout(scene, batch, duration=8.0)
    i = scene.index("drone_1")
    assert rollout.position[0, -1, i, 2] == pytest.approx(rollout.position[0, 0, i, 2], abs=1e-3)
    moved = rollout.position[0, -1, i] - rollout.position[0, -241, i]
    assert float(np.linalg.norm(moved)) > 1.0


@pytest.mark.parametrize(
    ("prompt", "name", "steep"),
    [
        ("A balloon rises.", "balloon_1", 90.0),
        ("A drone floats upward.", "drone_1", 90.0),
        ("A bird flies up into the sky.", "bird_1", 60.0),
        ("A helicopter descends.", "helicopter_1", -90.0),
    ],
)
def test_what_flies_by_itself_goes_up_and_down(prompt: str, name: str, steep: float):
    doc = fitted(resolve(draft(prompt), seed=0))
    laid = solve(doc, seed=0, hints=start_hints(doc))
    scene = build_scene(laid)
    program = make_plan(laid, scene).compile(make_plan(laid, scene).initial())
    rollout = get_engine("physx").rollout(
        scene, batch_programs([program], scene.names), duration=2.0
    )
    way = np.ptp(rollout.position[0, [0, -1], scene.index(name)], axis=0)
    rise = float(np.diff(rollout.position[0, [0, -1], scene.index(name), 2])[0])
    assert rise * math.copysign(1.0, steep) > 0.5
    assert math.degrees(math.atan2(rise, math.hypot(*way[:2]))) == pytest.approx(steep, abs=3.0)
    assert rollout.position[0, -1, scene.index(name), 2] > 0.2, "it is in the air in the end"


def test_an_aeroplane_does_not_go_straight_up():
    doc = draft("A plane takes off.")
    assert doc.timeline_system is not None
    assert all(e.params.elevation_deg is None for e in doc.timeline_system.sequence_graph.edges)


def test_a_flight_from_a_perch_leads_up_or_down_to_its_goal() -> None:
    up = choreograph(fitted(resolve(draft("A butterfly flies from a flower to a fence post."))))
    down = choreograph(fitted(resolve(draft("A pigeon flies from a wall to a car."))))
    (rises,) = [v for name, v in up.nominal.items() if name.endswith("/slope")]
    (sinks,) = [v for name, v in down.nominal.items() if name.endswith("/slope")]
    assert rises > 0.0 > sinks


def test_who_only_comes_near_is_no_faster_than_his_kind() -> None:
    """A hit of half a gram would have to be as fast as it can fly to be felt."""
    near = choreograph(fitted(resolve(draft("A butterfly flies to a fence post.")))).nominal
    assert near["butterfly_1_drive/speed"] < 4.0
