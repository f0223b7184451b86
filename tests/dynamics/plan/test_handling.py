"""What is carried, let go, spun, bounced and jumped is planned so that it happens everywhere."""

from __future__ import annotations

import numpy as np
import pytest

from esg.assets import resolve
from esg.compile import compile_scene, replay_class
from esg.dynamics import cast, optimize
from esg.dynamics.losses.handling import jump
from esg.dynamics.losses.kinds import kind_of
from esg.dynamics.losses.recording import Recording
from esg.dynamics.plan import make_plan
from esg.dynamics.plan.aim import body_bounds
from esg.dynamics.plan.build import build_scene
from esg.dynamics.story.stagecraft import top_surface
from esg.engines import get_engine
from esg.engines.manifest import load_manifest
from esg.engines.program import GuideAlong, HoldSpin, batch_programs
from esg.graph import effective, verify
from esg.graph.models import (
    Actor,
    EsgDocument,
    NamedRegion,
    Pose,
    SemanticRegion,
    Statement,
    TimelineEdge,
    TimelineNode,
)
from esg.layout import solve, stored_hints
from esg.metrics import expectations_from_timeline, judge
from tests.dynamics.stage import BALL, CAR, TABLE, asset, document, lay_out
from tests.graph import builders as graph

N = TimelineNode
START = N(id="start", event="SceneStart", timestamp=0)
MUG = asset("mug", (10, 10, 12), 0.4, "cylinder")
WALL = asset("wall", (10, 120, 90), 60, movable=False)
DOG = asset("dog", (90, 30, 60), 25)
PODIUM = asset("podium", (160, 160, 70), 200, movable=False, surface=True)
FENCE = asset("fence", (10, 150, 40), 60)
TOP = asset("top", (10, 10, 12), 0.3, "cylinder")


def edge(name, start, end, event, actor, **more) -> TimelineEdge:
    raw = {"id": name, "from": start, "to": end, "event": event, "actor": actor, **more}
    return TimelineEdge.model_validate(raw)


def moves(direction="ANY_3D") -> Actor:
    return Actor(role="active", force_direction=direction)


def at(doc: EsgDocument, **places: tuple[float, float, float]) -> EsgDocument:
    """The document laid out, with some things at places of their own [cm]."""
    out = lay_out(doc)
    assert out.layout_result is not None
    poses = dict(out.layout_result.poses)
    poses.update({n: Pose(position_cm=p) for n, p in places.items()})
    layout = out.layout_result.model_copy(update={"poses": poses})
    return out.model_copy(update={"layout_result": layout})


def put_on_table() -> EsgDocument:
    """A mug is taken from the floor, over a wall, onto a table on which another one stands."""
    doc = document(
        "put",
        {"mug_1": MUG, "mug_2": MUG, "wall_1": WALL, "table_1": TABLE},
        {"mug_1": moves()},
        [
            START,
            N(id="lifted", event="PickedUp", participants=("mug_1",), window=(0.2, 3)),
            N(id="put", event="Placed", participants=("mug_1", "table_1"), window=(3, 9)),
        ],
        [
            edge("lift", "start", "lifted", "Guide", "mug_1"),
            edge("carry", "lifted", "put", "Guide", "mug_1", target="table_1"),
        ],
    )
    places = {"mug_1": (0, 0, 0), "wall_1": (70, 0, 0), "table_1": (200, 0, 0)}
    return at(doc, mug_2=(200, 0, 75), **places)


def put_beside(predicate: str, on: str = "table_1") -> EsgDocument:
    """A mug is taken from the floor and put beside another one, on a table or on the floor."""
    doc = document(
        "beside",
        {"mug_1": MUG, "mug_2": MUG, "table_1": TABLE},
        {"mug_1": moves()},
        [START, N(id="put", event="Placed", participants=("mug_1", on), window=(1, 9))],
        [edge("carry", "start", "put", "Guide", "mug_1", target=on)],
    )
    told = Statement(
        id="s1", predicate=predicate, object=("mug_1",), target=("mug_2",), when="end",
        text="beside", start=0, end=6,
    )  # fmt: skip
    stands = {"mug_2": (200, 20, 75)} if on == "table_1" else {"mug_2": (80, 60, 0)}
    doc = at(doc, mug_1=(0, 0, 0), table_1=(200, 0, 0), **stands)
    return doc.model_copy(update={"statements": (told,)})


@pytest.mark.parametrize("on", ["table_1", "ground_1"])
@pytest.mark.parametrize(
    ("predicate", "side"),
    [
        ("left_of", (1, 0)),
        ("right_of", (-1, 0)),
        ("in_front_of", (0, 1)),
        ("behind", (0, -1)),
        ("ends_near", None),
    ],
)
def test_what_is_put_beside_something_is_let_go_there(
    predicate: str, side: tuple[int, int] | None, on: str
) -> None:
    """On the side that is told, a hand's breadth away, on what carries the other."""
    doc = put_beside(predicate, on)
    scene = build_scene(doc)
    way = make_plan(doc, scene).compile(make_plan(doc, scene).initial())
    guided = next(p for p in way.primitives if isinstance(p, GuideAlong))
    gap = np.array(guided.points[-1]) - np.array(scene.body("mug_2").position)
    assert 0.1 < np.linalg.norm(gap[:2]) < 0.25
    assert abs(gap[2]) < 0.02
    if side is not None:
        assert gap[0] * side[0] + gap[1] * side[1] > 0.1


def test_what_finds_no_room_beside_something_is_put_elsewhere_on_the_table() -> None:
    """Mugs at the edge of a table: none is let go in the air beside it."""
    doc = put_beside("left_of")
    assert doc.layout_result is not None
    edge_of_table = {**doc.layout_result.poses, "mug_2": Pose(position_cm=(255, 0, 75))}
    layout = doc.layout_result.model_copy(update={"poses": edge_of_table})
    doc = doc.model_copy(update={"layout_result": layout})
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    guided = next(p for p in plan.compile(plan.initial()).primitives if isinstance(p, GuideAlong))
    low, high = body_bounds(scene.body("table_1"))
    end = np.array(guided.points[-1])
    assert (end[:2] > low[:2]).all() and (end[:2] < high[:2]).all()


def lowered_into_bin() -> EsgDocument:
    """A block is lifted over the rim of a bin and let go at its floor."""
    inside = NamedRegion(
        name="inside", center_cm=(0, 0, 25), half_extents_cm=(24, 24, 22), kind="inside"
    )
    sides = [asset("side", s, 5) for s in ((50, 2, 50), (2, 46, 50), (50, 50, 2))]
    long, cross, floor = (s.proxies[0] for s in sides)
    walls = tuple(
        p.model_copy(update={"position_cm": c})
        for p, c in (
            (long, (0, 24, 25)), (long, (0, -24, 25)), (cross, (24, 0, 25)), (cross, (-24, 0, 25)),
            (floor, (0, 0, 1)),
        )
    )  # fmt: skip
    bin_ = asset("bin", (50, 50, 50), 20, regions=(inside,)).model_copy(update={"proxies": walls})
    doc = document(
        "lower",
        {"block_1": asset("block", (20, 20, 20), 3), "bin_1": bin_},
        {"block_1": moves()},
        [
            START,
            N(id="in", event="EnterRegion", participants=("block_1",), window=(1, 9),
              region="bin_1/inside"),
        ],
        [edge("lower", "start", "in", "Guide", "block_1", target="bin_1")],
    )  # fmt: skip
    return at(doc, block_1=(0, 0, 0), bin_1=(120, 0, 0))


def held_and_released() -> EsgDocument:
    return lay_out(
        document(
            "held",
            {"ball_1": BALL, "box_1": asset("box", (60, 60, 40), 10)},
            {"ball_1": moves(), "box_1": Actor(role="passive")},
            [
                START,
                N(id="let_go", event="Trigger", participants=("ball_1",), window=(0.5, 2)),
                N(id="hit", event="Collision", participants=("ball_1", "box_1"), window=(1, 4)),
            ],
            [
                edge("hold", "start", "let_go", "Guide", "ball_1", target="box_1"),
                edge("drop", "let_go", "hit", "Toward", "ball_1"),
            ],
        )
    )


def spinning() -> EsgDocument:
    return lay_out(
        document(
            "spin",
            {"top_1": TOP},
            {"top_1": moves("HORIZONTAL_PLANE")},
            [START, N(id="turned", event="Spin", participants=("top_1",), window=(0.5, 6),
                      turn_degrees=720)],
            [edge("spin", "start", "turned", "Spin", "top_1", params={"turn_rate_deg_s": 400})],
        )
    )  # fmt: skip


def jumping(over: bool = True) -> EsgDocument:
    who = ("dog_1", "fence_1") if over else ("dog_1",)
    node = N(
        id="jumped", event="Jump", participants=who, window=(0.3, 4), times=None if over else 3
    )
    target = {"target": "fence_1"} if over else {}
    return lay_out(
        document(
            "jump",
            {"dog_1": DOG, **({"fence_1": FENCE} if over else {})},
            {"dog_1": moves("ALONG_FORWARD_ONLY")},
            [START, node],
            [edge("jump", "start", "jumped", "Toward", "dog_1", **target)],
        )
    )


def leaping(start: str | None, end: str | None) -> EsgDocument:
    """A dog leaps from the ground or from something, onto something or down to the ground."""
    names = [n for n in (start, end) if n]
    met = N(id="met", event="Collision", participants=("dog_1", end or ""), window=(0.1, 4))
    fell = N(id="met", event="Fall", participants=("dog_1",), window=(0.1, 4))
    doc = document(
        "leap",
        {"dog_1": DOG, **{n: PODIUM for n in names}},
        {"dog_1": moves("ALONG_FORWARD_ONLY")},
        [START, N(id="jumped", event="Jump", participants=("dog_1",), window=(0.1, 4)),
         met if end else fell],
        [edge("jump", "start", "jumped", "Toward", "dog_1"),
         edge("coast", "jumped", "met", "Toward", "dog_1", **({"target": end} if end else {}))],
        on={"dog_1": start} if start else {},
    )  # fmt: skip
    if end is None:
        return lay_out(doc)
    layout = lay_out(doc).layout_result
    assert layout is not None
    x, y, _ = layout.poses[end].position_cm
    return at(doc, **{end: (x, y, 0.0)})


def bouncing(thrown: bool = False) -> EsgDocument:
    up = {"speed": (300, 400), "elevation_deg": 90}
    return lay_out(
        document(
            "bounce",
            {"ball_1": BALL},
            {"ball_1": moves()},
            [START, N(id="bounced", event="Bounce", participants=("ball_1", "ground_1"),
                      window=(0.3, 6), times=1 if thrown else 3)],
            [edge("drop", "start", "bounced", "Toward", "ball_1", target="ground_1",
                  params=up if thrown else {"speed": 0.0})],
        )
    )  # fmt: skip


STORIES = {
    "put": put_on_table,
    "lower": lowered_into_bin,
    "held": held_and_released,
    "spin": spinning,
    "over": jumping,
    "hop": lambda: jumping(over=False),
    "onto": lambda: leaping(None, "box_1"),
    "down": lambda: leaping("box_2", None),
    "across": lambda: leaping("box_2", "box_1"),
    "bounce": bouncing,
    "up": lambda: bouncing(thrown=True),
}


def played(name: str, engine: str):
    """The story under its nominal parameters: plan, rollout and when each event happened."""
    return played_of(STORIES[name](), engine)


def played_of(doc: EsgDocument, engine: str):
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    program = plan.compile(plan.initial())
    batch = batch_programs([program], scene.names)
    dt = 1 / 120 if engine == "newton" else 1 / 240
    rollout = get_engine(engine).rollout(scene, batch, dt=dt, duration=plan.duration)
    theta = dict(zip([v.name for v in plan.variables], plan.initial(), strict=True))
    own = {n: theta[f"{n}/time"] for n in plan.story.nodes if f"{n}/time" in theta}
    rec = Recording(scene, plan.story, rollout, [own])
    times, before = {}, np.zeros(1)
    for node in plan.story.nodes.values():
        measure = kind_of(node).measure
        if measure is not None:
            times[node.id] = float(measure(rec, node, before, lambda *_: None).time[0])
            before = np.array([times[node.id]])
    return plan, rollout, times


@pytest.mark.parametrize("engine", ["newton", "physx", "rapier"])
@pytest.mark.parametrize("name", STORIES)
def test_a_handled_thing_does_what_is_said(name, engine):
    plan, rollout, times = played(name, engine)
    assert rollout.valid.all()
    assert times and all(np.isfinite(t) for t in times.values()), times
    assert max(times.values()) < plan.duration


MORE = {
    "put": ("put", {"participants": ("mug_2", "table_1")}),
    "held": ("let_go", {"event": "PickedUp"}),
    "spin": ("turned", {"turn_degrees": 1440.0}),
    "bounce": ("bounced", {"times": 15}),
    "hop": ("jumped", {"times": 4}),
}
"""Events that do not happen: one thing stands still, one only falls, others happen less often."""


@pytest.mark.parametrize("name", MORE)
def test_what_does_not_happen_is_not_detected(name):
    plan, rollout, _ = played(name, "physx")
    rec = Recording(plan.scene, plan.story, rollout, [{}])
    event, change = MORE[name]
    node = N.model_validate(plan.story.nodes[event].model_dump() | change)
    measure = kind_of(node).measure
    assert measure is not None
    found = measure(rec, node, np.zeros(1), lambda *_: None)
    assert not np.isfinite(found.time[0]) and found.far[0] > 0.0


def way(rollout, plan, name):
    return rollout.position[0, :, plan.scene.index(name)].astype(float)


def test_what_is_put_down_passes_over_what_is_in_between_and_beside_what_stands_there():
    plan, rollout, times = played("put", "physx")
    mug, wall, other = (way(rollout, plan, n) for n in ("mug_1", "wall_1", "mug_2"))
    over = np.abs(mug[:, 0] - wall[0, 0]) < 0.1
    assert over.any() and mug[over, 2].min() - 0.06 > 0.9
    np.testing.assert_allclose(mug[-1, 2], 0.75 + 0.06, atol=0.005)
    assert np.linalg.norm(mug[-1, :2] - other[-1, :2]) > 0.1
    np.testing.assert_allclose(other[-1], other[0], atol=0.005)
    assert times["lifted"] < 1.0 < times["put"]


def test_what_is_held_on_is_not_placed():
    raw = put_on_table().model_dump(by_alias=True)
    raw["timeline_system"]["sequence_graph"]["edges"][1]["params"]["release"] = False
    plan, rollout, times = played_of(EsgDocument.model_validate(raw), "physx")
    assert np.isfinite(times["lifted"]) and not np.isfinite(times["put"])
    np.testing.assert_allclose(way(rollout, plan, "mug_1")[-1, 2], 0.75 + 0.06 + 0.004, atol=1e-3)


def test_what_is_lowered_into_a_bin_touches_neither_rim_nor_wall_on_its_way():
    plan, rollout, _ = played("lower", "physx")
    block, bin_ = way(rollout, plan, "block_1"), way(rollout, plan, "bin_1")
    np.testing.assert_allclose(block[-1], (*bin_[-1, :2], 0.12), atol=0.02)
    np.testing.assert_allclose(bin_[-1], bin_[0], atol=0.005)


def taken_from(roofed: bool) -> EsgDocument:
    """A block in the bin is picked up; roofed: the bin lies on its side, its mouth in front."""
    doc = lowered_into_bin()
    graph, timeline = doc.spatial_relation_graph, doc.timeline_system
    assert timeline is not None
    held = SemanticRegion.model_validate(
        {"parent_object": "bin_1", "region_type": "STORAGE", "region_description": "inside"}
    )
    nodes = dict(graph.nodes)
    nodes["block_1"] = nodes["block_1"].model_copy(update={"semantic_region": "bin_1_inside"})
    graph = graph.model_copy(
        update={
            "nodes": nodes,
            "semantic_regions": {**graph.semantic_regions, "bin_1_inside": held},
        }
    )
    told = timeline.sequence_graph.model_copy(
        update={
            "nodes": (START, N(id="in", event="PickedUp", participants=("block_1",))),
            "edges": (edge("lower", "start", "in", "Guide", "block_1"),),
        }
    )
    timeline = timeline.model_copy(update={"sequence_graph": told})
    configs = dict(doc.asset_configurations)
    if roofed:
        key = graph.nodes["bin_1"].asset_id
        bin_ = configs[key]
        long, *_ = bin_.proxies
        roof = long.model_copy(update={"position_cm": (0, 0, 49), "size_cm": (25, 25, 1)})
        kept = [p for p in bin_.proxies if p.position_cm[0] < 20]
        configs[key] = bin_.model_copy(update={"proxies": (*kept, roof)})
    doc = doc.model_copy(
        update={
            "spatial_relation_graph": graph,
            "timeline_system": timeline,
            "asset_configurations": configs,
        }
    )
    return at(doc, block_1=(120, 0, 2), bin_1=(120, 0, 0))


@pytest.mark.parametrize("roofed", [False, True])
def test_what_is_taken_out_of_a_vessel_leaves_by_its_mouth_or_its_open_side(roofed: bool) -> None:
    doc = taken_from(roofed)
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    guided = next(p for p in plan.compile(plan.initial()).primitives if isinstance(p, GuideAlong))
    moved = np.array(guided.points[-1]) - np.array(scene.body("block_1").position)
    if roofed:
        assert moved[0] > 0.35
        assert abs(moved[1]) < 1e-6
    else:
        assert moved[2] > 0.48
        np.testing.assert_allclose(moved[:2], 0.0, atol=1e-6)


def test_what_is_held_stays_until_it_is_released():
    plan, rollout, times = played("held", "physx")
    ball = way(rollout, plan, "ball_1")
    release = next(v.initial for v in plan.variables if v.name == "let_go/time")
    held = rollout.time < release - 0.05
    np.testing.assert_allclose(ball[held], ball[:1].repeat(held.sum(), axis=0), atol=1e-3)
    fall = np.sqrt(2.0 * (ball[0, 2] - 0.4 - 0.11) / 9.81)
    assert times["hit"] - release == pytest.approx(fall, abs=0.03)


def test_a_jump_has_the_height_and_time_of_its_leap():
    plan, rollout, times = played("over", "physx")
    dog, fence = way(rollout, plan, "dog_1"), way(rollout, plan, "fence_1")
    rise, speed = (next(v.initial for v in plan.variables if v.name == f"jump/{n}")
                   for n in ("rise", "speed"))  # fmt: skip
    assert dog[:, 2].max() - dog[0, 2] == pytest.approx(rise**2 / (2 * 9.81), rel=0.03)
    assert times["jumped"] == pytest.approx(2 * rise / 9.81, abs=0.05)
    assert dog[0, 0] < fence[0, 0] < dog[-1, 0] and speed > 1.0
    # Back on the ground it runs out from what the landing has left it, and is not sped up again.
    v = np.hypot(*np.diff(dog[:, :2], axis=0).T) * 240.0
    lands = round((times["jumped"] + 0.02) * 240)
    assert (v[lands + 12 :] - v[lands:-12]).max() / 0.05 < 10.0
    np.testing.assert_allclose(dog[-1, 2], dog[0, 2], atol=0.01)  # on its feet
    np.testing.assert_allclose(fence[-1], fence[0], atol=1e-3)


def test_a_leap_ends_on_what_it_leads_onto_and_beside_what_it_leads_from():
    for name, height in (("onto", 0.7), ("across", 0.7), ("down", 0.0)):
        plan, rollout, times = played(name, "physx")
        dog = way(rollout, plan, "dog_1")
        base = 0.0 if name == "onto" else 0.7
        np.testing.assert_allclose(dog[0, 2], base + 0.3, atol=0.01)
        np.testing.assert_allclose(dog[-1, 2], height + 0.3, atol=0.01)
        # It stands before it leaps, and does not graze the edge of what is higher.
        still = rollout.time < 0.25
        np.testing.assert_allclose(dog[still], dog[:1].repeat(still.sum(), axis=0), atol=0.01)
        assert 0.3 < times["jumped"] <= times["met"]
        assert dog[:, 2].max() > max(base, height) + 0.3 + 0.1


def test_a_jump_against_what_it_leads_over_is_none():
    """Without a fence in its way it is over; with one that is met it is not."""
    doc = jumping()
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    low = plan.initial() * np.where([v.name == "jump/rise" for v in plan.variables], 0.75, 1.0)
    rollout = get_engine("physx").rollout(
        scene, batch_programs([plan.compile(low)], scene.names), dt=1 / 240, duration=plan.duration
    )
    rec = Recording(scene, plan.story, rollout, [{}])
    node = plan.story.nodes["jumped"]
    found = jump(rec, node, np.zeros(1), lambda *_: None)
    assert not np.isfinite(found.time[0]) and found.far[0] > 1.0
    alone = node.model_copy(update={"participants": ("dog_1",)})
    assert np.isfinite(jump(rec, alone, np.zeros(1), lambda *_: None).time[0])


def test_one_that_runs_jumps_where_the_obstacle_is():
    doc = lay_out(
        document(
            "run",
            {"dog_1": DOG, "fence_1": FENCE},
            {"dog_1": moves("ALONG_FORWARD_ONLY")},
            [
                START,
                N(id="off", event="Trigger", participants=("dog_1",), window=(0.5, 2)),
                N(id="jumped", event="Jump", participants=("dog_1", "fence_1"), window=(2, 6)),
            ],
            [
                edge("run", "start", "off", "UniformMotion", "dog_1",
                     params={"speed": (200, 400)}),
                edge("jump", "off", "jumped", "Toward", "dog_1", target="fence_1"),
            ],
        )
    )  # fmt: skip
    result = optimize(doc).dynamics_result
    assert result is not None and result.outcome == "solved"
    kinds = [p["kind"] for p in result.program["primitives"]]
    assert kinds == ["HoldVelocity", "SetVelocity", "HoldVelocity"]


def test_what_spins_turns_as_often_as_is_said_and_stays():
    plan, rollout, times = played("spin", "rapier")
    top = way(rollout, plan, "top_1")
    np.testing.assert_allclose(top[-1], top[0], atol=0.01)
    assert times["turned"] == pytest.approx(720.0 / 400.0, abs=0.05)


def test_what_moves_keeps_moving_while_it_spins():
    doc = lay_out(
        document(
            "ice",
            {"car_1": CAR},
            {"car_1": moves("ALONG_FORWARD_ONLY")},
            [
                START,
                N(id="loses_grip", event="Trigger", participants=("car_1",), window=(0.5, 2)),
                N(id="turned", event="Spin", participants=("car_1",), window=(1, 6)),
            ],
            [
                edge("drive", "start", "loses_grip", "UniformMotion", "car_1",
                     params={"speed": (400, 600)}),
                edge("spin", "loses_grip", "turned", "Spin", "car_1"),
            ],
        )
    )  # fmt: skip
    scene = build_scene(doc)
    plan = make_plan(doc, scene)
    drive, spin = plan.compile(plan.initial()).primitives
    assert isinstance(spin, HoldSpin) and drive.end == spin.start
    program = plan.compile(plan.initial())
    rollout = get_engine("physx").rollout(scene, batch_programs([program], scene.names))
    car, turn = way(rollout, plan, "car_1"), rollout.angular_velocity[0, :, 1, 2]
    after = rollout.time > spin.start + 0.1
    assert np.linalg.norm(car[-1] - car[after][0]) > 1.0
    assert turn[(rollout.time > spin.start + 0.02) & (rollout.time < spin.end)].min() > 1.0


def staged(raw, folder):
    """A document as a drafter writes it through every stage: the result and its class in PhysX."""
    assert verify(raw) == ()
    doc = cast(resolve(EsgDocument.model_validate(raw)))
    assert doc.choreography is not None
    doc = optimize(solve(doc, hints=stored_hints(doc.choreography)))
    assert verify(doc) == ()
    assert doc.dynamics_result is not None and doc.dynamics_result.outcome == "solved"
    compile_scene(doc, folder)
    return doc, replay_class(folder, dt=1 / 240)


def test_the_judge_sees_an_apple_put_into_a_basket_and_a_ball_let_go_above_a_box(tmp_path):
    """Events that the judge knew before are brought about by guides, as it sees them."""
    raw = graph.document(
        "apple",
        "An apple is put into the basket. A ball is held above a box and released.",
        {
            "apple": graph.asset("apple", (8, 8, 8), 0.2, shape="sphere"),
            "basket": graph.asset("basket", (40, 40, 30), 1.5),
            "ball": graph.BALL,
            "box": graph.BOX,
        },
        {n: graph.node(n[:-2]) for n in ("apple_1", "basket_1", "ball_1", "box_1")},
        [
            graph.rel("apple_1", "near", "basket_1"),
            graph.rel("basket_1", "face", "ground_1", cardinal="+Y"),
        ],
        graph.timeline(
            {
                "apple_1": graph.active("ANY_3D"),
                "ball_1": graph.active("ANY_3D"),
                "box_1": graph.PASSIVE,
            },
            [
                graph.event("in", "EnterRegion", ["apple_1"], window=[1, 9],
                            region="basket_1/inside"),
                graph.event("let_go", "Trigger", ["ball_1"], window=[0.5, 1.9]),
                graph.event("hit", "Collision", ["ball_1", "box_1"], window=[2, 5]),
            ],
            [
                graph.edge("put", "scene_start", "in", "Guide", "apple_1", target="basket_1"),
                graph.edge("hold", "scene_start", "let_go", "Guide", "ball_1", target="box_1"),
                graph.edge("drop", "let_go", "hit", "Toward", "ball_1"),
            ],
        ),
    )  # fmt: skip
    doc, replay = staged(raw, tmp_path)
    told = load_manifest(tmp_path / "manifest.json")
    verdict = judge(told.scene, told.program, replay.rollout, expectations_from_timeline(doc))
    assert [(e.type, e.completed) for e in verdict.events] == [
        ("enters", True),
        ("collision", True),
    ]


def test_a_mug_is_put_on_the_shelf_from_prompt_document_to_replay(tmp_path):
    """A document as a drafter writes it, through every stage to the class in PhysX."""
    raw = graph.document(
        "mug",
        "The mug is picked up and put on the shelf.",
        {
            "mug": graph.asset("mug", (12, 9, 10), 0.35),
            "shelf": graph.asset("shelf", (80, 30, 120), 20),
            "table": graph.asset("table", (120, 80, 75), 30),
        },
        {
            "shelf_1": graph.node("shelf"),
            "table_1": graph.node("table"),
            "mug_1": graph.node("mug", "table_top"),
        },
        [
            graph.rel("mug_1", "on", "table_1"),
            graph.rel("shelf_1", "near", "table_1"),
            *(graph.rel(n, "face", "ground_1", cardinal="+Y")
              for n in ("shelf_1", "table_1", "mug_1")),
        ],
        graph.timeline(
            {"mug_1": graph.active("ANY_3D")},
            [
                graph.event("lifted", "PickedUp", ["mug_1"], window=[0.2, 3]),
                graph.event("put", "Placed", ["mug_1", "shelf_1"], window=[3.1, 12]),
            ],
            [
                graph.edge("lift", "scene_start", "lifted", "Guide", "mug_1"),
                graph.edge("carry", "lifted", "put", "Guide", "mug_1", target="shelf_1"),
            ],
        ),
        {"table_top": graph.region("table_1")},
    )  # fmt: skip
    doc, replay = staged(raw, tmp_path)
    names = replay.scene.names
    mug, shelf = names.index("mug_1"), replay.scene.body("shelf_1")
    end, speed = replay.rollout.position[0, -1, mug], replay.rollout.linear_velocity[0, -1, mug]
    low, high = body_bounds(shelf)
    assert np.linalg.norm(speed) < 0.02
    assert (low[:2] < end[:2]).all() and (end[:2] < high[:2]).all()
    surface = top_surface(effective(doc), "shelf_1").center_cm[2] / 100.0
    bottom = end[2] + replay.scene.body("mug_1").origin_offset[2]
    assert bottom == pytest.approx(surface, abs=0.01)
