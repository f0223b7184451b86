"""Small scenes with known motions for cameras and films: boxes that move on paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import trimesh

from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene
from esg.graph.models import (
    EsgDocument,
    Node,
    SceneDefinition,
    SceneParameters,
    SpatialRelationGraph,
)
from esg.metrics.models import EventVerdict, LayoutVerdict, SceneVerdict
from esg.view.director.acting import Action
from esg.view.director.review import Viewfinder
from esg.view.film.shooting import viewfinder
from esg.view.pieces import Part

Way = Callable[[float], tuple[float, float, float]]
HZ = 120


@dataclass(frozen=True)
class Thing:
    """A box: half extents [m] and where its middle is at a time [s]."""

    name: str
    half: tuple[float, float, float]
    way: Way
    static: bool = False


@dataclass(frozen=True)
class Play:
    """A scene: things, events as (type, time [s], names), and how long it lasts [s]."""

    name: str
    things: tuple[Thing, ...]
    events: tuple[tuple[str, float, tuple[str, ...]], ...]
    lasts: float = 3.0


def at(x: float, y: float, z: float) -> Way:
    """Stands still."""
    return lambda _: (x, y, z)


def until(
    time: float, start: tuple[float, ...], speed: tuple[float, ...], after: float = 0.0
) -> Way:
    """Moves evenly to a time, then at a share of that speed."""

    def way(t: float) -> tuple[float, float, float]:
        s = min(t, time) + after * max(0.0, t - time)
        x, y, z = (a + s * v for a, v in zip(start, speed, strict=True))
        return x, y, z

    return way


def struck(time: float, start: tuple[float, ...], speed: tuple[float, ...]) -> Way:
    """Stands until a time, then moves and comes to rest within a second."""

    def way(t: float) -> tuple[float, float, float]:
        s = float(np.clip(t - time, 0.0, 1.0))
        x, y, z = (a + (s - 0.5 * s * s) * v for a, v in zip(start, speed, strict=True))
        return x, y, z

    return way


def falling(start: tuple[float, ...], speed: float, edge_s: float) -> Way:
    """Slides along X, and falls from a time on, to the ground."""

    def way(t: float) -> tuple[float, float, float]:
        s = max(0.0, t - edge_s)
        return start[0] + speed * min(t, edge_s + 0.4), start[1], max(0.08, start[2] - 4.9 * s * s)

    return way


CAR, BIN, BALL = (2.2, 0.9, 0.7), (0.3, 0.3, 0.5), (0.11, 0.11, 0.11)
HIT = ("ball", "box")
PLAYS = (
    Play(
        "ball_and_box",
        (
            Thing("ball", BALL, until(1.0, (-3.0, 0, 0.11), (2.6, 0, 0), -0.2)),
            Thing("box", (0.3, 0.3, 0.3), struck(1.0, (0.0, 0, 0.3), (0.4, 0, 0))),
        ),
        (("collision", 1.0, HIT),),
    ),
    Play(
        "head_on",
        (
            Thing("car", CAR, until(1.5, (-17.2, 0, 0.7), (10, 0, 0))),
            Thing("other", CAR, until(1.5, (17.2, 0.2, 0.7), (-10, 0, 0))),
        ),
        (("collision", 1.5, ("car", "other")),),
    ),
    Play(
        "fast_ball",
        (
            Thing("ball", (0.035,) * 3, until(0.6, (-9.2, 0.5, 0.4), (15, 0, 0), -0.1)),
            Thing("box", (0.25, 0.2, 0.2), struck(0.6, (0.1, 0.5, 0.2), (0.5, 0, 0))),
        ),
        (("collision", 0.6, HIT),),
    ),
    Play(
        "off_the_table",
        (
            Thing("cup", (0.04, 0.04, 0.05), falling((0.1, 0.0, 0.82), 0.8, 0.6)),
            Thing("table", (0.6, 0.4, 0.385), at(0.0, 0.0, 0.385), static=True),
        ),
        (("falls", 0.75, ("cup",)),),
    ),
    Play(
        "drop",
        (
            Thing("ball", BALL, lambda t: (0.0, 0.0, max(0.71, 2.0 - 4.9 * t * t))),
            Thing("crate", (0.3, 0.3, 0.3), at(0, 0, 0.3), static=True),
        ),
        (("collision", 0.51, ("ball", "crate")),),
    ),
    Play(
        "behind_a_wall",
        (
            Thing("ball", BALL, until(1.0, (-2.6, 0, 0.11), (2.2, 0, 0), -0.2)),
            Thing("box", (0.3, 0.3, 0.3), struck(1.0, (0.0, 0, 0.3), (0.4, 0, 0))),
            Thing("wall", (4.0, 0.1, 1.2), at(-1.0, 1.6, 1.2), static=True),
        ),
        (("collision", 1.0, HIT),),
    ),
    Play(
        "chain",
        (
            Thing("car", CAR, until(1.2, (-12.5, 0, 0.7), (8, 0, 0), 0.2)),
            Thing("bin", BIN, lambda t: (-0.4 + 7 * float(np.clip(t - 1.2, 0, 0.3)), 0, 0.5)),
            Thing("sign", (0.05, 0.3, 1.0), struck(1.5, (2.06, 0, 1.0), (0.8, 0, 0))),
        ),
        (("collision", 1.2, ("car", "bin")), ("collision", 1.5, ("bin", "sign"))),
    ),
    Play(
        "brakes",
        (
            Thing("van", (2.7, 1.0, 1.1), lambda t: (9 * t - 0.9 * t * t, 0, 1.1)),
            Thing("pole", (0.1, 0.1, 2.0), at(8.0, 3.0, 2.0), static=True),
        ),
        (("moves", 0.0, ("van",)), ("stops", 5.0, ("van",))),
        6.0,
    ),
    Play(
        "dominoes",
        (
            Thing("marble", (0.012,) * 3, until(0.3, (-0.45, 0, 0.05), (1.4, 0, 0), 0.1)),
            *(Thing(f"domino_{k}", (0.008, 0.025, 0.05), at(0.04 * k, 0, 0.05)) for k in range(8)),
        ),
        (("collision", 0.3, ("marble", "domino_0")),),
    ),
    Play(
        "room",
        (
            Thing("ball", BALL, until(0.8, (-1.6, 0, 0.11), (1.6, 0, 0), -0.3)),
            Thing("box", (0.2, 0.2, 0.2), struck(0.8, (0.0, 0, 0.2), (0.3, 0, 0))),
            Thing("north", (2.6, 0.1, 1.4), at(0, 2.5, 1.4), static=True),
            Thing("south", (2.6, 0.1, 1.4), at(0, -2.5, 1.4), static=True),
            Thing("east", (0.1, 2.6, 1.4), at(2.5, 0, 1.4), static=True),
            Thing("west", (0.1, 2.6, 1.4), at(-2.5, 0, 1.4), static=True),
        ),
        (("collision", 0.8, HIT),),
    ),
)


def scene_of(play: Play) -> SimScene:
    """Its bodies."""
    return SimScene(
        play.name,
        tuple(
            Body(
                t.name,
                t.static,
                1.0,
                ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)),
                (Shape("box", t.half),),
                t.way(0.0),
                origin_offset=(0.0, 0.0, -t.half[2]),
                half_extents=t.half,
            )
            for t in play.things
        ),
    )


def rollout_of(play: Play) -> Rollout:
    """Their motion."""
    time = np.arange(round(play.lasts * HZ) + 1) / HZ
    position = np.array([[t.way(float(s)) for t in play.things] for s in time])[None]
    quaternion = np.zeros((*position.shape[:3], 4), np.float32)
    quaternion[..., 3] = 1.0
    velocity = np.gradient(position, 1 / HZ, axis=1).astype(np.float32)
    return Rollout(
        "physx",
        1 / HZ,
        time,
        position.astype(np.float32),
        quaternion,
        velocity,
        np.zeros_like(velocity),
        ContactLog.empty(),
        np.ones(1, bool),
    )


def verdict_of(play: Play) -> SceneVerdict:
    """Its events, all completed."""
    events = tuple(
        EventVerdict(id=f"e{k}", type=kind, completed=True, time_s=time, bodies=names)
        for k, (kind, time, names) in enumerate(play.events, 1)
    )
    return SceneVerdict(
        scene_id=play.name,
        suite_scene=play.name,
        engine="physx",
        dt_s=1 / HZ,
        events=events,
        constraints=(),
        layout=LayoutVerdict(valid=True),
    )


def document_of(play: Play) -> EsgDocument:
    """A document that names its things."""
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id=play.name,
            original_description=play.name,
            scene_parameters=SceneParameters(is_dynamic=True, scene_type="outdoor"),
        ),
        spatial_relation_graph=SpatialRelationGraph(
            nodes={t.name: Node(asset_id=f"{t.name}_a") for t in play.things}
        ),
    )


def parts_of(play: Play) -> list[Part]:
    """Boxes on a floor."""
    floor = np.array([[-90, -90, 0], [90, -90, 0], [90, 90, 0], [-90, 90, 0.0]])
    out = [Part(-1, floor, np.array([[0, 1, 2], [0, 2, 3]]), (0.5, 0.5, 0.5))]
    for k, thing in enumerate(play.things):
        box = trimesh.creation.box(2 * np.array(thing.half))
        color = (0.2 + 0.1 * (k % 7), 0.7 - 0.08 * (k % 7), 0.4)
        out.append(Part(k, np.asarray(box.vertices), np.asarray(box.faces), color))
    return out


def action_of(play: Play) -> Action:
    """What a director knows of it."""
    return Action(scene_of(play), rollout_of(play), verdict_of(play), document_of(play))


def finder_of(play: Play, size: tuple[int, int] = (240, 135)) -> Viewfinder:
    """A viewfinder onto it."""
    finder = viewfinder(action_of(play), document_of(play), parts_of(play))
    finder.size = size
    return finder
