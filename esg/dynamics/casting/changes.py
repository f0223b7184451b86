"""The ways in which casting may change a scene: bodies larger, heavier or other, actors thrown."""

from __future__ import annotations

from esg.graph.models import AssetConfiguration, AssetRequirement, EsgDocument, ForceDirection

Configs = dict[str, AssetConfiguration]
"""Configurations that take the place of others, by asset."""


def with_assets(doc: EsgDocument, changed: dict[str, AssetConfiguration]) -> EsgDocument:
    """The document with some of its assets changed."""
    if not changed:
        return doc
    return doc.model_copy(update={"asset_configurations": {**doc.asset_configurations, **changed}})


def resized(
    doc: EsgDocument,
    key: str,
    config: AssetConfiguration,
    factor: float,
    kind: AssetRequirement | None = None,
    *,
    dimensions: tuple[float, float, float] | None = None,
) -> AssetConfiguration:
    """The same thing larger or smaller; its mass follows unless it is prescribed.

    `dimensions` [cm] make it so long, wide and high where that kind of thing comes in such
    proportions, else the factor must say how large.
    """
    from esg.assets.configuration import parametric_entry
    from esg.assets.geometry import lying
    from esg.assets.geometry.rolling import drawn_size, is_rolling_form
    from esg.assets.stage import configure

    wanted = kind or doc.asset_requirement[key]
    length, width, height = config.dimensions_cm
    size = dimensions or (factor * length, factor * width, factor * height)
    entry = parametric_entry(config)
    rolled = None
    if config.lying is not None:
        size = lying.drawn_size(config.lying, size)
    elif entry is not None and is_rolling_form(entry, config.rolls):
        # Asked for is the size as it is drawn; what rolls goes on rolling.
        size, rolled = drawn_size(entry, size), True
    mass = config.mass_kg if wanted.mass_is_prescribed else factor**3 * config.mass_kg
    made = configure(
        key,
        wanted.model_copy(
            update={
                "expected_dimensions_cm": size,
                "expected_mass_kg": mass,
                "dimensions_are_prescribed": True,
                "mass_is_prescribed": True,
            }
        ),
        rolled=rolled,
    )
    kept: dict[str, object] = {"is_movable": config.is_movable}
    if kind is None:
        # Feet that do not slip and the like were chosen before.
        kept |= {"friction": config.friction, "restitution": config.restitution}
    return made.model_copy(update=kept)


def scaled(config: AssetConfiguration, factor: float) -> AssetConfiguration:
    """The same thing lighter or heavier."""
    return config.model_copy(
        update={
            "mass_kg": config.mass_kg * factor,
            "inertia_kg_cm2": tuple(v * factor for v in config.inertia_kg_cm2),
        }
    )


def weighing(config: AssetConfiguration, mass: float) -> AssetConfiguration:
    """The same thing with a mass [kg]."""
    share = mass / config.mass_kg
    inertia = tuple(v * share for v in config.inertia_kg_cm2)
    return config.model_copy(update={"mass_kg": mass, "inertia_kg_cm2": inertia})


def thrown(doc: EsgDocument, actor: str) -> EsgDocument:
    """The document in which an actor may go in any direction: it is thrown."""
    assert doc.timeline_system is not None
    actors = dict(doc.timeline_system.actors)
    actors[actor] = actors[actor].model_copy(update={"force_direction": ForceDirection.ANY_3D})
    timeline = doc.timeline_system.model_copy(update={"actors": actors})
    return doc.model_copy(update={"timeline_system": timeline})
