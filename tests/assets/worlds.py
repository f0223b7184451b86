"""Physical scenes of library assets standing far apart on the ground."""

from __future__ import annotations

import math

import numpy as np

from esg.assets.library.catalogue import Entry, catalogue
from esg.assets.stage import configure
from esg.dynamics.plan.build import make_body
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout, SimScene
from esg.graph.models import (
    AssetConfiguration,
    AssetRequirement,
    EsgDocument,
    Node,
    Pose,
    SceneDefinition,
    SceneParameters,
)

EMPTY = EsgDocument(
    scene_definition=SceneDefinition(
        scene_id="x",
        original_description="x",
        scene_parameters=SceneParameters(is_dynamic=False, scene_type="outdoor"),
    )
)


def requirement(entry: Entry, **changes: object) -> AssetRequirement:
    """What a drafter that knows the usual size would ask for."""
    values: dict[str, object] = {
        "asset_category": entry.name,
        "asset_description": entry.description,
        "expected_dimensions_cm": entry.dimensions_cm,
        "expected_mass_kg": entry.mass_kg,
        "linear_damping": 0.0,
    }
    return AssetRequirement.model_validate(values | changes)


def standing(configs: list[AssetConfiguration]) -> SimScene:
    """Every asset free to move, on a grid wide enough that none touches another."""
    bodies = []
    pitch = max(max(c.dimensions_cm[:2]) for c in configs) * 1.6 + 100
    columns = math.ceil(math.sqrt(len(configs)))
    for i, config in enumerate(configs):
        config = config.model_copy(update={"is_movable": True})
        pose = Pose(position_cm=(pitch * (i % columns), pitch * (i // columns), 0.0))
        name = f"{i}_{config.asset_name}"
        bodies.append(make_body(EMPTY, name, Node(asset_id=name), config, pose, active=False))
    return SimScene(scene_id="standing", bodies=tuple(bodies))


def settle(engine: str, entries: list[Entry], seconds: float = 2.0) -> Rollout:
    """Lets entries stand as a drafter that knows them asks for them."""
    return settle_configs(engine, [configure(e.name, requirement(e)) for e in entries], seconds)


def settle_configs(engine: str, configs: list[AssetConfiguration], seconds: float = 2.0) -> Rollout:
    """Lets assets stand."""
    scene = standing(configs)
    batch = batch_programs([Program((), seconds)], scene.names)
    return get_engine(engine).rollout(scene, batch, record_every=12)


def faults(rollout: Rollout, entries: list[Entry]) -> list[str]:
    """Entries that sank, tipped, wandered or still move, with figures."""
    out = []
    for i, entry in enumerate(entries):
        start, end = rollout.position[0, 0, i], rollout.position[0, -1, i]
        q = rollout.quaternion[0, -1, i].astype(float)
        up = 1 - 2 * (q[0] ** 2 + q[1] ** 2)
        tilt = math.degrees(math.acos(float(np.clip(up, -1, 1))))
        sink = float(start[2] - end[2])
        drift = float(np.linalg.norm((end - start)[:2]))
        speed = float(np.linalg.norm(rollout.linear_velocity[0, -1, i]))
        height = entry.dimensions_cm[2] / 100
        limit = max(0.005, 0.02 * height)
        rolls = "rolls" in entry.flags
        if (
            sink > limit
            or sink < -limit
            or drift > 0.02
            or speed > 0.02
            or (tilt > 2 and not rolls)
        ):
            out.append(
                f"{entry.name}: tilt {tilt:.1f} deg, sank {100 * sink:.2f} cm, "
                f"wandered {100 * drift:.2f} cm, speed {speed:.3f} m/s"
            )
    return out


def solid_entries() -> list[Entry]:
    """Everything that collides."""
    return [e for e in catalogue() if "decal" not in e.flags]
