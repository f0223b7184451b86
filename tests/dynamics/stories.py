"""Timelines of every kind for the dynamics tests."""

from __future__ import annotations

from esg.assets import resolve
from esg.draft import draft
from esg.dynamics.casting import fitted
from esg.graph.models import Actor, EsgDocument, EventConstraint, TimelineEdge, TimelineNode
from tests.dynamics.stage import BALL, BIN, CAR, TABLE, asset, document

N, E = TimelineNode, TimelineEdge


def cast(prompt: str, seed: int = 0) -> EsgDocument:
    """The document of a prompt with its assets resolved and fitted to its story."""
    return fitted(resolve(draft(prompt, seed=seed), seed=seed))


def car_bin_table() -> EsgDocument:
    return document(
        "car bin table",
        dict(car_1=CAR, bin_1=BIN, table_1=TABLE),
        {
            "car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
            "bin_1": Actor(role="passive"),
            "table_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("car_1", "bin_1"), window=(1, 2)),
            N(id="e2", event="Collision", participants=("bin_1", "table_1"), window=(2.2, 4)),
        ],
        [
            E(
                **{
                    "id": "drive",
                    "from": "start",
                    "to": "e1",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "target": "bin_1",
                    "params": {"speed": (300, 1500)},
                }
            ),
            E(
                **{
                    "id": "fly",
                    "from": "e1",
                    "to": "e2",
                    "event": "InertialConnector",
                    "actor": "bin_1",
                    "target": "table_1",
                }
            ),
        ],
    )


def three_balls() -> EsgDocument:
    b = BALL
    return document(
        "three balls",
        dict(ball_a=b, ball_b=b, ball_c=b),
        {
            "ball_a": Actor(role="active", force_direction="HORIZONTAL_PLANE"),
            "ball_b": Actor(role="passive"),
            "ball_c": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(
                id="e1",
                event="Collision",
                participants=("ball_a", "ball_b"),
                window=(0.3, 2),
                constraints=(
                    EventConstraint(quantity="speed_after", object="ball_b", value=200.0),
                ),
            ),
            N(id="e2", event="Collision", participants=("ball_b", "ball_c"), window=(2.2, 4)),
        ],
        [
            E(
                **{
                    "id": "roll",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "ball_a",
                    "target": "ball_b",
                    "params": {"speed": (100, 800), "spin": "roll"},
                }
            ),
            E(
                **{
                    "id": "fly",
                    "from": "e1",
                    "to": "e2",
                    "event": "InertialConnector",
                    "actor": "ball_b",
                    "target": "ball_c",
                }
            ),
        ],
    )


def car_hits_jeep_at_3s() -> EsgDocument:
    return document(
        "car jeep",
        dict(car_1=CAR, jeep_1=CAR),
        {
            "car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
            "jeep_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(
                id="e1",
                event="Collision",
                participants=("car_1", "jeep_1"),
                timestamp=3.0,
                time_is_prescribed=True,
            ),
        ],
        [
            E(
                **{
                    "id": "drive",
                    "from": "start",
                    "to": "e1",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "target": "jeep_1",
                    "params": {"speed": (300, 2000)},
                }
            )
        ],
    )


def throw_hits_table_at_1s() -> EsgDocument:
    b = asset("basketball", (24, 24, 24), 10, "sphere", restitution=0.7)
    return document(
        "throw",
        dict(b_1=b, table_1=TABLE),
        {"b_1": Actor(role="active", force_direction="ANY_3D"), "table_1": Actor(role="passive")},
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(
                id="e1",
                event="Collision",
                participants=("b_1", "table_1"),
                timestamp=1.0,
                time_is_prescribed=True,
            ),
        ],
        [
            E(
                **{
                    "id": "drive",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "b_1",
                    "target": "table_1",
                    "params": {"speed": (300, 2000), "elevation_deg": (0, 60)},
                }
            )
        ],
    )


def car_brakes_to_stop() -> EsgDocument:
    return document(
        "car brake",
        dict(car_1=CAR),
        {"car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY")},
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="t1", event="Trigger", participants=("car_1",), window=(1, 2)),
            N(
                id="e2",
                event="Stop",
                participants=("car_1",),
                window=(3, 5),
                constraints=(
                    EventConstraint(quantity="time_to_stop", object="car_1", value=(2.0, 3.0)),
                ),
            ),
        ],
        [
            E(
                **{
                    "id": "drive",
                    "from": "start",
                    "to": "t1",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "params": {"speed": 1000},
                    "speed_is_prescribed": True,
                }
            ),
            E(
                **{
                    "id": "brake",
                    "from": "t1",
                    "to": "e2",
                    "event": "Brake",
                    "actor": "car_1",
                    "params": {"damping": (0.3, 6.0)},
                }
            ),
        ],
    )


def turn_brake_hit() -> EsgDocument:
    bike = asset("bicycle", (170, 20, 100), 14)
    return document(
        "turn brake",
        dict(car_1=CAR, bike_1=bike),
        {
            "car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
            "bike_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="t0", event="Trigger", participants=("car_1",), window=(1, 2)),
            N(
                id="h",
                event="HeadingReached",
                participants=("car_1",),
                window=(2.5, 4),
                turn_direction="left",
                turn_degrees=90,
            ),
            N(id="t1", event="Trigger", participants=("car_1",), window=(4.5, 5)),
            N(id="e", event="Collision", participants=("car_1", "bike_1"), window=(5.5, 8)),
        ],
        [
            E(
                **{
                    "id": "drive",
                    "from": "start",
                    "to": "t0",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "params": {"speed": (300, 1200)},
                }
            ),
            E(
                **{
                    "id": "turn",
                    "from": "t0",
                    "to": "h",
                    "event": "Turn",
                    "actor": "car_1",
                    "params": {"turn_rate_deg_s": (25, 70)},
                }
            ),
            E(
                **{
                    "id": "drive2",
                    "from": "h",
                    "to": "t1",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "params": {"speed": (300, 1200)},
                }
            ),
            E(
                **{
                    "id": "brake",
                    "from": "t1",
                    "to": "e",
                    "event": "Brake",
                    "actor": "car_1",
                    "target": "bike_1",
                    "params": {"damping": (0.3, 6.0)},
                }
            ),
        ],
    )


def rear_end() -> EsgDocument:
    return document(
        "two cars",
        dict(front=CAR, rear=CAR),
        {
            "front": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
            "rear": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="t1", event="Trigger", participants=("front",), window=(1, 2)),
            N(
                id="e",
                event="Collision",
                participants=("rear", "front"),
                window=(2.5, 4),
                constraints=(
                    EventConstraint(quantity="time_since", object="rear", value=1.0, since="t1"),
                ),
            ),
        ],
        [
            E(
                **{
                    "id": "d1",
                    "from": "start",
                    "to": "t1",
                    "event": "UniformMotion",
                    "actor": "front",
                    "params": {"speed": (500, 1000)},
                    "speed_is_prescribed": True,
                }
            ),
            E(
                **{
                    "id": "d2",
                    "from": "start",
                    "to": "e",
                    "event": "UniformMotion",
                    "actor": "rear",
                    "target": "front",
                    "params": {"speed": (500, 1000)},
                    "speed_is_prescribed": True,
                }
            ),
            E(
                **{
                    "id": "brake",
                    "from": "t1",
                    "to": "e",
                    "event": "Brake",
                    "actor": "front",
                    "params": {"damping": (0.3, 6.0)},
                }
            ),
        ],
    )


def head_on() -> EsgDocument:
    return document(
        "two cars head-on",
        {"car_1": CAR, "car_2": CAR},
        {
            "car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
            "car_2": Actor(role="active", force_direction="ALONG_FORWARD_ONLY"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e", event="Collision", participants=("car_1", "car_2"), window=(1, 4)),
        ],
        [
            E(
                **{
                    "id": "d1",
                    "from": "start",
                    "to": "e",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "target": "car_2",
                    "params": {"speed": (400, 1000)},
                }
            ),
            E(
                **{
                    "id": "d2",
                    "from": "start",
                    "to": "e",
                    "event": "UniformMotion",
                    "actor": "car_2",
                    "target": "car_1",
                    "params": {"speed": (400, 1000)},
                }
            ),
        ],
    )


def impossible_transfer() -> EsgDocument:
    """A light ball shall give a heavy one more than its own speed."""
    heavy = asset("heavy ball", (22, 22, 22), 9.0, "sphere", restitution=0.7)
    return document(
        "light ball hits heavy ball",
        {"light": BALL, "heavy": heavy},
        {
            "light": Actor(role="active", force_direction="HORIZONTAL_PLANE"),
            "heavy": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(
                id="e",
                event="Collision",
                participants=("light", "heavy"),
                window=(0.3, 2),
                constraints=(EventConstraint(quantity="speed_after", object="heavy", value=300.0),),
            ),
        ],
        [
            E(
                **{
                    "id": "roll",
                    "from": "start",
                    "to": "e",
                    "event": "Toward",
                    "actor": "light",
                    "target": "heavy",
                    "params": {"speed": 300.0, "spin": "roll"},
                    "speed_is_prescribed": True,
                }
            ),
        ],
    )


def miss() -> EsgDocument:
    return document(
        "the car misses the bin",
        {"car_1": CAR, "bin_1": BIN},
        {"car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY")},
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e", event="Miss", participants=("car_1", "bin_1"), window=(0.5, 4)),
        ],
        [
            E(
                **{
                    "id": "d",
                    "from": "start",
                    "to": "e",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "params": {"speed": (400, 1000)},
                }
            ),
        ],
    )


def reach() -> EsgDocument:
    return document(
        "the car stops before the bin",
        {"car_1": CAR, "bin_1": BIN},
        {"car_1": Actor(role="active", force_direction="ALONG_FORWARD_ONLY")},
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e", event="Reach", participants=("car_1", "bin_1"), window=(0.5, 4)),
        ],
        [
            E(
                **{
                    "id": "d",
                    "from": "start",
                    "to": "e",
                    "event": "UniformMotion",
                    "actor": "car_1",
                    "target": "bin_1",
                    "params": {"speed": (200, 500)},
                }
            ),
        ],
    )


def falls_off_table() -> EsgDocument:
    table = asset("table", (160, 80, 75), 30, surface=True)
    ball = asset("ball", (10, 10, 10), 0.3, "sphere", restitution=0.5)
    cup = asset("cup", (8, 8, 10), 0.3, "cylinder")
    return document(
        "a ball knocks a cup off the table",
        {"table_1": table, "ball_1": ball, "cup_1": cup},
        {
            "ball_1": Actor(role="active", force_direction="HORIZONTAL_PLANE"),
            "cup_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("ball_1", "cup_1"), window=(0.2, 2)),
            N(id="e2", event="Fall", participants=("cup_1",), window=(0.5, 4)),
        ],
        [
            E(
                **{
                    "id": "roll",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "ball_1",
                    "target": "cup_1",
                    "params": {"speed": (50, 500), "spin": "roll"},
                }
            ),
            E(
                **{
                    "id": "c",
                    "from": "e1",
                    "to": "e2",
                    "event": "InertialConnector",
                    "actor": "cup_1",
                }
            ),
        ],
        on={"ball_1": "table_1", "cup_1": "table_1"},
    )


def topple() -> EsgDocument:
    pillar = asset("pillar", (15, 15, 90), 3.0, friction=0.6)
    return document(
        "a ball knocks a pillar over",
        {"ball_1": BALL, "pillar_1": pillar},
        {
            "ball_1": Actor(role="active", force_direction="ANY_3D"),
            "pillar_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("ball_1", "pillar_1"), window=(0.2, 2)),
            N(id="e2", event="Topple", participants=("pillar_1",), window=(0.5, 4)),
        ],
        [
            E(
                **{
                    "id": "throw",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "ball_1",
                    "target": "pillar_1",
                    "params": {"speed": (200, 1200)},
                }
            ),
            E(
                **{
                    "id": "c",
                    "from": "e1",
                    "to": "e2",
                    "event": "InertialConnector",
                    "actor": "pillar_1",
                }
            ),
        ],
    )


def drop() -> EsgDocument:
    crate = asset("crate", (60, 60, 60), 20)
    return document(
        "a ball is dropped onto a crate",
        {"ball_1": BALL, "crate_1": crate},
        {
            "ball_1": Actor(role="active", force_direction="ANY_3D"),
            "crate_1": Actor(role="passive"),
        },
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(id="e1", event="Collision", participants=("ball_1", "crate_1"), window=(0.2, 2)),
        ],
        [
            E(
                **{
                    "id": "drop",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "ball_1",
                    "target": "crate_1",
                    "params": {"speed": 0.0, "elevation_deg": -90.0},
                }
            ),
        ],
    )


def scores_goal() -> EsgDocument:
    from esg.graph.models import NamedRegion, Proxy

    post = {"kind": "box", "size_cm": (5, 5, 60)}
    goal = asset("goal", (80, 250, 120), 40, movable=False).model_copy(
        update={
            "proxies": (
                Proxy(**post, position_cm=(35, 120, 60)),
                Proxy(**post, position_cm=(35, -120, 60)),
                Proxy(kind="box", size_cm=(2, 120, 60), position_cm=(-38, 0, 60)),
            ),
            "regions": (
                NamedRegion(
                    name="inside", center_cm=(0, 0, 55), half_extents_cm=(35, 110, 55), kind="goal"
                ),
            ),
        }
    )
    return document(
        "a ball is kicked into the goal",
        {"ball_1": BALL, "goal_1": goal},
        {"ball_1": Actor(role="active", force_direction="HORIZONTAL_PLANE")},
        [
            N(id="start", event="SceneStart", timestamp=0),
            N(
                id="e1",
                event="EnterRegion",
                participants=("ball_1",),
                region="goal_1/inside",
                window=(0.2, 3),
            ),
        ],
        [
            E(
                **{
                    "id": "kick",
                    "from": "start",
                    "to": "e1",
                    "event": "Toward",
                    "actor": "ball_1",
                    "target": "goal_1",
                    "params": {"speed": (200, 1500)},
                }
            ),
        ],
    )


EVERY = (
    car_hits_jeep_at_3s, throw_hits_table_at_1s, car_bin_table, three_balls, car_brakes_to_stop,
    turn_brake_hit, rear_end, head_on, miss, reach, falls_off_table, topple, drop, scores_goal,
)  # fmt: skip
