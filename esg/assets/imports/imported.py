"""Configurations and meshes of imported assets."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.assets.configuration import finish
from esg.assets.geometry.rotations import GLTF_FROM_LOCAL
from esg.assets.geometry.sketch import Sketch
from esg.assets.geometry.stretch import scaled
from esg.assets.imports.store import find_record
from esg.assets.library.proposal import choose_dimensions, choose_mass
from esg.assets.library.retrieve import Decision
from esg.assets.materials import MATERIALS, find_material
from esg.graph.models import AssetConfiguration, AssetRequirement, Mount, Proxy, SupportSurface
from esg.outcomes import UserError
from esg.units import quat_rotate

if TYPE_CHECKING:
    import trimesh


def configure_imported(
    key: str, requirement: AssetRequirement, decision: Decision
) -> AssetConfiguration:
    """Configuration of an imported asset: its fitted proxies, scaled to the requirement."""
    entry = decision.entry
    assert entry is not None
    found = find_record(f"{entry.library}/{entry.name}")
    if found is None:
        raise UserError(f"asset {entry.library}/{entry.name} has left its library; import it again")
    _, record = found
    if "inertia_kg_cm2" in record:
        return _as_modelled(key, requirement, decision, record)
    dimensions = choose_dimensions(entry, requirement)
    factor = math.prod(b / a for a, b in zip(entry.dimensions_cm, dimensions, strict=True)) ** (
        1 / 3
    )
    proxies = tuple(Proxy.model_validate(p) for p in record["proxies"])
    sketch = Sketch(
        proxies=list(proxies),
        densities=[1.0] * len(proxies),
        surfaces=[SupportSurface.model_validate(s) for s in record["surfaces"]],
    )
    material = find_material(requirement.material) or MATERIALS[entry.material]
    mass = choose_mass(entry, requirement, dimensions, 1.0)
    return finish(
        key, entry, requirement, scaled(sketch, factor), dimensions, mass, material,
        entry.color_rgb, decision, "library",
    )  # fmt: skip


def _as_modelled(
    key: str, requirement: AssetRequirement, decision: Decision, record: dict[str, Any]
) -> AssetConfiguration:
    """A part of a model with joints: as large and as heavy as its description says.

    Only a mass that the prompt prescribes is taken instead.
    """
    entry = decision.entry
    assert entry is not None
    proxies = [Proxy.model_validate(p) for p in record["proxies"]]
    sketch = Sketch(
        proxies=proxies,
        densities=[1.0] * len(proxies),
        surfaces=[SupportSurface.model_validate(s) for s in record["surfaces"]],
        mounts=[Mount.model_validate(m) for m in record["mounts"]],
    )
    mass = requirement.expected_mass_kg if requirement.mass_is_prescribed else entry.mass_kg
    config = finish(
        key, entry, requirement, sketch, entry.dimensions_cm, mass, MATERIALS[entry.material],
        entry.color_rgb, decision, "library",
    )  # fmt: skip
    inertia = tuple(v * mass / entry.mass_kg for v in record["inertia_kg_cm2"])
    center = tuple(record["center_of_mass_cm"])
    return config.model_copy(update={"center_of_mass_cm": center, "inertia_kg_cm2": inertia})


def _load(path: Any) -> trimesh.Scene:
    import trimesh

    scene = trimesh.load_scene(path, file_type="glb", process=False)
    scene.apply_transform(np.linalg.inv(GLTF_FROM_LOCAL))
    return scene


def load_imported(config: AssetConfiguration) -> trimesh.Scene:
    """The textured mesh of an imported asset [cm], local frame, at the configured scale.

    Raises:
        UserError: If the asset is in no library on this machine.
    """
    found = find_record(config.asset_name)
    if found is None:
        raise UserError(
            f"asset {config.asset_name!r} is in no library here; import its library with "
            "`esg assets import`, or set ESG_ASSET_LIBRARY to the folder that holds it"
        )
    folder, record = found
    scene = _load(folder / "meshes" / f"{record['mesh_sha256']}.glb")
    factor = np.eye(4)
    factor[:3, :3] *= config.scale[0]
    scene.apply_transform(factor)
    if config.lying is not None:
        turn = np.eye(4)
        turn[:3, :3] = quat_rotate(config.lying.turned_xyzw, np.eye(3)).T
        turn[:3, 3] = config.lying.moved_cm
        scene.apply_transform(turn)
    return scene
