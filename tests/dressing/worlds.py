"""Documents and replays of bodies on made-up ways, for dressing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from esg.engines.scene import Body, ContactLog, Rollout, Shape, SimScene
from esg.graph import EsgDocument
from esg.graph.models import (
    AssetConfiguration,
    LayoutResult,
    Node,
    Pose,
    Proxy,
    ProxyKind,
    SceneDefinition,
    SceneParameters,
    SpatialRelationGraph,
)

UNIT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
FRAMES = 121


def body(
    category: str,
    size: tuple[float, float, float],
    at: tuple[float, float] = (0.0, 0.0),
    *,
    yaw: float = 0.0,
    static: bool = False,
    flat: bool = False,
    mentioned: bool = True,
    name: str = "",
) -> Body:
    """A box [m] that stands at a point of the ground; its frame lies in its middle."""
    half = (0.5 * size[0], 0.5 * size[1], 0.5 * size[2])
    return Body(
        name or f"{category}_1",
        static or flat,
        1.0,
        UNIT,
        () if flat else (Shape("box", half),),
        (*at, half[2]),
        (0.0, 0.0, float(np.sin(yaw / 2)), float(np.cos(yaw / 2))),
        half_extents=half,
        origin_offset=(0.0, 0.0, -half[2]),
        category=category,
        mentioned=mentioned,
    )


def scene_of(*bodies: Body) -> SimScene:
    return SimScene("s", bodies)


def rollout_of(scene: SimScene, ways: dict[str, np.ndarray] | None = None, turns: float = 0.0) -> Rollout:  # fmt: skip
    """Bodies at rest but those with a way [m], shape [FRAMES, 3], added to where they start.

    Args:
        scene: The bodies.
        ways: By name.
        turns: How far those that move turn about Z over the time [rad].
    """
    count = len(scene.bodies)
    p = np.tile(np.array([b.position for b in scene.bodies]), (1, FRAMES, 1, 1))
    q = np.tile(np.array([b.quaternion for b in scene.bodies]), (1, FRAMES, 1, 1))
    half = 0.5 * np.linspace(0.0, turns, FRAMES)
    for name, way in (ways or {}).items():
        i = scene.index(name)
        p[0, :, i] += way
        z, w = scene.bodies[i].quaternion[2:]
        q[0, :, i, 2] = z * np.cos(half) + w * np.sin(half)
        q[0, :, i, 3] = w * np.cos(half) - z * np.sin(half)
    still = np.zeros((1, FRAMES, count, 3), np.float32)
    return Rollout(
        "test", 1 / 60, np.arange(FRAMES) / 60, p.astype(np.float32), q.astype(np.float32),
        still, still, ContactLog.empty(), np.ones(1, bool),
    )  # fmt: skip


def straight(dx: float, dy: float = 0.0, dz: float = 0.0) -> np.ndarray:
    """A way along a line [m]."""
    return np.linspace(0, 1, FRAMES)[:, None] * np.array([dx, dy, dz])


def document(
    scene: SimScene,
    prompt: str = "A thing moves.",
    *,
    setting: str = "outdoor",
    environment: str = "generic",
    more: bool = True,
) -> EsgDocument:
    """What the pipeline would have written of a scene, as far as dressing reads it."""
    configurations = {b.name: _configuration(b) for b in scene.bodies}
    poses = {
        b.name: Pose(position_cm=(100 * b.position[0], 100 * b.position[1], 0.0))
        for b in scene.bodies
    }
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id="s",
            original_description=prompt,
            scene_parameters=SceneParameters(
                is_dynamic=True,
                scene_type="indoor" if setting == "indoor" else "outdoor",
                environment=environment,
                allow_supplementary=more,
            ),
        ),
        asset_configurations=configurations,
        spatial_relation_graph=SpatialRelationGraph(
            nodes={b.name: Node(asset_id=b.name) for b in scene.bodies}
        ),
        layout_result=LayoutResult(poses=poses, energy=0.0),
    )


def _configuration(item: Body) -> AssetConfiguration:
    size = tuple(200.0 * h for h in item.half_extents)
    proxy = Proxy(kind=ProxyKind.BOX, size_cm=tuple(s / 2 for s in size))  # type: ignore[arg-type]
    return AssetConfiguration(
        asset_name=item.category,
        source="parametric",
        category=item.category,
        mesh_path="meshes/x.glb",
        dimensions_cm=size,  # type: ignore[arg-type]
        proxies=(proxy,) if item.collides else (),
        mass_kg=1.0,
        is_movable=not item.static,
        friction=0.5,
        restitution=0.2,
    )


def road(length: float = 60.0, at: tuple[float, float] = (0.0, 0.0), yaw: float = 0.0) -> Body:
    return body("road", (length, 8.0, 0.01), at, yaw=yaw, flat=True)


def ground(side: float = 120.0) -> Body:
    return body("ground", (side, side, 0.01), flat=True, name="ground_1")


CATEGORIES: Sequence[tuple[str, tuple[float, float, float]]] = (
    ("car", (4.5, 1.8, 1.5)),
    ("ball", (0.22, 0.22, 0.22)),
    ("dog", (1.0, 0.3, 0.7)),
    ("plank", (2.0, 0.2, 0.04)),
    ("box", (0.5, 0.4, 0.4)),
    ("forklift", (3.3, 1.2, 2.1)),
    ("cup", (0.1, 0.1, 0.1)),
    ("horse", (2.4, 0.6, 1.9)),
    ("train", (18.0, 2.8, 3.9)),
    ("drone", (0.4, 0.4, 0.1)),
)
PLACES = (
    ("outdoor", "street", "A thing moves along the street at night."),
    ("outdoor", "park", "A thing moves through the park."),
    ("outdoor", "generic", "A thing moves."),
    ("indoor", "warehouse", "A thing moves across the warehouse."),
    ("indoor", "kitchen", "A thing moves in the kitchen."),
    ("indoor", "room", "A thing moves."),
    ("outdoor", "beach", "A thing moves on the beach."),
    ("outdoor", "ice_rink", "A thing moves over the ice rink."),
    ("outdoor", "parking_lot", "A thing moves in the car park."),
    ("outdoor", "harbour", "A thing moves in the harbour."),
)


def some_world(number: int) -> tuple[EsgDocument, SimScene, Rollout]:
    """One of many scenes: a few bodies, some of which move on curved ways, in one of ten places."""
    rng = np.random.default_rng(number)
    setting, environment, prompt = PLACES[number % len(PLACES)]
    bodies: list[Body] = [ground()]
    ways: dict[str, np.ndarray] = {}
    yaw = float(rng.uniform(-np.pi, np.pi))
    if environment == "street":
        bodies.append(road(60.0, yaw=yaw))
    for k in range(int(rng.integers(1, 5))):
        category, size = CATEGORIES[int(rng.integers(len(CATEGORIES)))]
        at = (float(rng.uniform(-4, 4)), float(rng.uniform(-4, 4)))
        turned = float(rng.uniform(-np.pi, np.pi))
        bodies.append(body(category, size, at, yaw=turned, name=f"{category}_{k}"))
        if rng.random() < 0.7:
            t = np.linspace(0, 1, FRAMES)
            reach, bend = float(rng.uniform(0.5, 14)), float(rng.uniform(-2, 2))
            heading = yaw + bend * t
            step = reach / FRAMES * np.stack([np.cos(heading), np.sin(heading), 0 * t], axis=1)
            ways[f"{category}_{k}"] = np.cumsum(step, axis=0)
    scene = scene_of(*bodies)
    rollout = rollout_of(scene, ways, turns=float(rng.uniform(-3, 3)))
    return document(scene, prompt, setting=setting, environment=environment), scene, rollout
