"""Configurations: what stage 2 leaves of an asset, the same record whatever its source."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.assets.contents import content_of
from esg.assets.geometry.lying import lain, turned
from esg.assets.geometry.massprops import mass_properties
from esg.assets.geometry.sketch import Color, Sketch
from esg.assets.geometry.wheels import wheels_of
from esg.assets.library.catalogue import Entry, entries_by_name, uniform_factor
from esg.assets.library.proposal import is_toy
from esg.assets.library.retrieve import Decision
from esg.assets.materials import Material, find_material, is_usual
from esg.graph.models import AssetConfiguration, AssetRequirement, Vec3

WHEELED_FRICTION = 0.1
"""Averages with the vehicle ground's 0 to a rolling resistance of 0.05."""
ROLLING_DAMPING = 0.1


PLAIN_ROLLS = {"sphere": ("rolls",), "cylinder": ("rim",), "capsule": ("axle",)}
"""How plain bodies roll, as flags of the catalogue."""


def mesh_path(key: str) -> str:
    """Path of an asset's GLB inside the scene folder."""
    return f"meshes/{re.sub(r'[^A-Za-z0-9_.-]+', '_', key) or 'asset'}.glb"


def node_mesh_path(path: str, node: str) -> str:
    """Path of the GLB of one node that looks unlike the first with the same asset."""
    return f"{path.removesuffix('.glb')}.{re.sub(r'[^A-Za-z0-9_-]+', '_', node)}.glb"


def finish(
    key: str,
    entry: Entry,
    requirement: AssetRequirement,
    sketch: Sketch,
    dimensions: Vec3,
    mass: float,
    material: Material,
    color: Color,
    decision: Decision,
    source: str,
) -> AssetConfiguration:
    """Assembles a configuration; the same schema whatever the source of the geometry.

    What lies or stands otherwise than it is drawn is turned here, `sketch` and `dimensions` are as
    it is drawn.
    """
    lying = None
    if requirement.lies is not None and "rolls" not in entry.flags:
        lying = lain(sketch, requirement.lies, dimensions)
    factor = uniform_factor(entry.dimensions_cm, dimensions)
    if lying is not None:
        sketch, dimensions = turned(sketch, lying), lying.dimensions_cm
    com, inertia = mass_properties(sketch.weighed or sketch.proxies, mass, sketch.densities)
    rolls = "rolls" in entry.flags
    wheeled = "wheeled" in entry.flags and lying is None
    return AssetConfiguration(
        asset_name=entry.name if entry.library == "parametric" else f"{entry.library}/{entry.name}",
        source=source,  # type: ignore[arg-type]
        category=category_of(requirement),
        mesh_path=mesh_path(key),
        dimensions_cm=dimensions,
        scale=(factor, factor, factor),
        proxies=tuple(sketch.proxies),
        support_surfaces=tuple(sketch.surfaces),
        regions=tuple(sketch.regions),
        mass_kg=mass,
        is_movable=(entry.movable or is_toy(requirement)) and requirement.is_movable,
        center_of_mass_cm=com,
        inertia_kg_cm2=inertia,
        friction=WHEELED_FRICTION if wheeled else material.friction,
        restitution=material.restitution,
        linear_damping=requirement.linear_damping,
        angular_damping=ROLLING_DAMPING if rolls else requirement.linear_damping,
        is_wheeled=wheeled,
        rolls=rolls,
        wheels=wheels_of(sketch),
        mounts=tuple(sketch.mounts) or None,
        lying=lying,
        color_rgb=color,
        license=entry.license,
        attribution=entry.attribution,
        confidence=decision.confidence,
        runners_up=decision.runners_up,
        reason=decision.reason,
    )


def stated_material(entry: Entry, requirement: AssetRequirement) -> Material | None:
    """The material that somebody asked for and an entry is not made of anyway, or None."""
    asked = find_material(requirement.material)
    words, colon, _ = requirement.asset_description.partition(":")
    if asked is None or is_usual(asked, entry.material):
        return None
    if colon and not any(find_material(word) is asked for word in words.split()):
        # What such things are made of, and nobody said: bowling pins are wood and white.
        return None
    return asked


def category_of(requirement: AssetRequirement) -> str:
    return "_".join(re.findall(r"[a-z0-9]+", requirement.asset_category.lower()))


def plain_entry(
    shape: str, dimensions_cm: Vec3, mass_kg: float, material: str, color: Color
) -> Entry:
    """A plain body of a size, for a noun that no library holds."""
    return Entry(
        name=f"plain_{shape}",
        parents=(),
        builder=shape,
        params=(),
        dimensions_cm=dimensions_cm,
        mass_kg=mass_kg,
        material=material,
        color_rgb=color,
        flags=frozenset(PLAIN_ROLLS.get(shape, ())),
        synonyms=(),
        description="",
    )


def parametric_entry(config: AssetConfiguration) -> Entry | None:
    """The entry behind a configuration: of the library, or a plain body; None if imported."""
    known = entries_by_name().get(config.asset_name)
    level = content_of(config)
    if known is not None and level is not None and config.contents is not None:
        return replace(known, contents=(level, config.contents))
    if known is not None or not config.asset_name.startswith("plain_"):
        return known
    shape = config.asset_name.removeprefix("plain_")
    size = config.dimensions_cm if config.lying is None else config.lying.drawn_cm
    return plain_entry(shape, size, config.mass_kg, "plastic_hard", config.color_rgb)
