"""What is dropped into a vessel falls in and stays; the vessel stands and weighs what it did."""

from __future__ import annotations

import math

import numpy as np
import pytest

from esg.assets.geometry.massprops import mass_properties
from esg.assets.library.catalogue import Entry, catalogue, entries_by_name
from esg.assets.stage import configure
from esg.dynamics.plan.build import make_body
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import SimScene
from esg.graph.models import AssetConfiguration, AssetRequirement, Node, Pose
from tests.assets.worlds import EMPTY, requirement

ENTERED_FROM_THE_SIDE = {
    "goal", "hockey_goal", "tunnel", "basketball_hoop", "well", "fountain", "sailboat", "wicket",
    "elevator",
}  # fmt: skip
"""A roof, a net, a pedestal, a bow or a mast is above the middle; the hoop has no floor."""
ASKED_FOR = {
    "trash_bin", "wheelie_bin", "dumpster", "bathtub", "sink", "open_box", "open_crate", "bucket",
    "basket", "mug", "cup", "drinking_glass", "wine_glass", "bowl", "vase", "jar", "tray", "pond",
    "frying_pan", "cooking_pot", "wheelbarrow", "shopping_cart", "pickup", "boat", "canoe", "crib",
    "dump_truck",
}  # fmt: skip


def vessels() -> list[tuple[Entry, AssetConfiguration]]:
    """Kinds with a region `inside` that is open at the top."""
    found = []
    for entry in catalogue():
        config = configure(entry.name, requirement(entry))
        if entry.name in ENTERED_FROM_THE_SIDE:
            continue
        if any(r.name == "inside" and r.kind == "inside" for r in config.regions):
            found.append((entry, config.model_copy(update={"is_movable": True})))
    return found


def test_a_ball_dropped_into_any_vessel_stays_in_and_the_vessel_stands() -> None:
    held = vessels()
    assert {e.name for e, _ in held} >= ASKED_FOR
    bodies = []
    for i, (entry, config) in enumerate(held):
        region = next(r for r in config.regions if r.name == "inside")
        diameter = 0.6 * min(region.half_extents_cm)
        asked = AssetRequirement(
            asset_category="rubber ball",
            asset_description="ball",
            expected_dimensions_cm=(diameter,) * 3,
            dimensions_are_prescribed=True,
            expected_mass_kg=0.02 * entry.mass_kg,
            mass_is_prescribed=True,
            shape="sphere",
            linear_damping=0.1,
        )
        top = max(config.dimensions_cm[2], region.center_cm[2] + region.half_extents_cm[2])
        at = (i * 2500.0, 0.0, 0.0)
        over = (
            at[0] + region.center_cm[0],
            region.center_cm[1],
            top + min(20.0, 3 * diameter),
        )
        node, ball = Node(asset_id="v"), configure("b", asked)
        bodies += [
            make_body(EMPTY, f"v{i}", node, config, Pose(position_cm=at), active=False),
            make_body(EMPTY, f"b{i}", node, ball, Pose(position_cm=over), active=True),
        ]
    scene = SimScene(scene_id="vessels", bodies=tuple(bodies))
    batch = batch_programs([Program((), 3.0)], scene.names)
    rollout = get_engine("physx").rollout(scene, batch, record_every=24)
    wrong = []
    for i, (entry, config) in enumerate(held):
        region = next(r for r in config.regions if r.name == "inside")
        end = rollout.position[0, -1, 2 * i + 1] * 100 - (i * 2500.0, 0.0, 0.0)
        off = np.abs(end - region.center_cm) - region.half_extents_cm
        q = rollout.quaternion[0, -1, 2 * i].astype(float)
        tilt = math.degrees(math.acos(float(np.clip(1 - 2 * (q[0] ** 2 + q[1] ** 2), -1, 1))))
        if (off > 1e-3).any() or tilt > 2:
            wrong.append(f"{entry.name}: ball at {end.round(1)}, tilt {tilt:.1f} deg")
    assert wrong == []


@pytest.mark.parametrize("name", ["trash_bin", "cooking_pot", "vase", "frying_pan", "wheelie_bin"])
@pytest.mark.parametrize("factor", [1.0, 1.6])
def test_opening_a_vessel_left_its_mass_properties(name: str, factor: float) -> None:
    """They are those of the solid shapes that the builder weighs, at any scale."""
    from esg.assets.library.catalogue import build_sketch

    entry = entries_by_name()[name]
    l, w, h = entry.dimensions_cm  # noqa: E741
    sketch = build_sketch(entry, (factor * l, factor * w, factor * h), entry.color_rgb)
    assert sketch.weighed and len(sketch.weighed) == len(sketch.densities) < len(sketch.proxies)
    com, inertia = mass_properties(sketch.weighed, entry.mass_kg, sketch.densities)
    if factor == 1.0:
        config = configure(name, requirement(entry))
        assert config.center_of_mass_cm == pytest.approx(com)
        assert config.inertia_kg_cm2 == pytest.approx(inertia)
    plain = build_sketch(entry, entry.dimensions_cm, entry.color_rgb)
    _, usual = mass_properties(plain.weighed or (), entry.mass_kg, plain.densities)
    assert inertia == pytest.approx(tuple(factor**2 * v for v in usual), abs=1e-6)
