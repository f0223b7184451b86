"""What is carried, let go, spun, bounced and jumped is planned so that it happens everywhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from esg.dynamics.losses.kinds import kind_of
from esg.dynamics.losses.recording import Recording
from esg.dynamics.plan import make_plan
from esg.dynamics.plan.build import build_scene
from esg.engines import get_engine
from esg.engines.program import GuideAlong, HoldSpin, batch_programs
from esg.graph.models import Actor, EsgDocument, NamedRegion, Pose, TimelineEdge, TimelineNode
from tests.dynamics.stage import BALL, TABLE, asset, document, lay_out

N = TimelineNode
START = N(id="start", event="SceneStart", timestamp=0)
MUG = asset("mug", (10, 10, 12), 0.4, "cylinder")
WALL = asset("wall", (10, 120, 90), 60, movable=False)
DOG = asset("dog", (90, 30, 60), 25)
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
    node = N(id="jumped", event="Jump", participants=who, window=(0.3, 4), times=None if over else 3)
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
    "bounce": bouncing,
    "up": lambda: bouncing(thrown=True),
}


def played(name: str, engine: str):
    """The story under its nominal parameters: plan, rollout and when each event happened."""
    doc = STORIES[name]()
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
