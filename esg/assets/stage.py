"""Stage 2: an asset configuration for every requirement of a document."""

from __future__ import annotations

from dataclasses import replace
import math
from typing import TYPE_CHECKING, Any

from esg.assets.colors import find_color
from esg.assets.configuration import category_of, finish, plain_entry, stated_material
from esg.assets.contents import filled, is_open
from esg.assets.geometry.rolling import (
    FLAGS,
    as_drawn,
    lying_assets,
    on_its_rim,
    rolled_assets,
    rolling,
    turned_size,
)
from esg.assets.library.catalogue import Entry, build_sketch
from esg.assets.library.proposal import choose_dimensions, choose_mass
from esg.assets.library.retrieve import Decision, closest, decide
from esg.assets.materials import MATERIALS, Material, find_material, is_usual
from esg.graph.models import (
    AssetConfiguration,
    AssetRequirement,
    EsgDocument,
    Provenance,
)

if TYPE_CHECKING:
    from esg.assets.imports.providers import Generator

VERSION = "1"
ROLLING_RESTITUTION = 0.2
"""At most: on its rim a prism (PhysX) would hop from edge to edge."""


def resolve(doc: EsgDocument, *, seed: int = 0, retrieval_only: bool = False) -> EsgDocument:
    """Fills `asset_configurations` for every requirement.

    Args:
        doc: A drafted document.
        seed: Recorded, and given to a generator; the stage itself draws no random numbers.
        retrieval_only: Take the closest asset of the library for everything, whatever it is, and
            make nothing (the paper's ablation).

    Returns:
        The document with configurations and one more provenance entry, which names the generator
        and what it failed at (those requirements get a plain body).
    """
    from esg.assets.imports.models.joining import with_parts
    from esg.assets.imports.providers import chosen_generator

    generator = None if retrieval_only else chosen_generator()
    failures: dict[str, str] = {}
    rolled, lying = rolled_assets(doc), lying_assets(doc)
    configurations = {
        key: configure(
            key,
            requirement,
            generator=generator,
            seed=seed,
            failures=failures,
            rolled=True if key in rolled else False if key in lying else None,
            retrieval_only=retrieval_only,
        )
        for key, requirement in doc.asset_requirement.items()
    }
    state: dict[str, Any] = _library_state()
    if generator is not None:
        state |= {"generator": generator.name, "generator_failures": failures}
    entry = Provenance(stage="resolve", version=VERSION, seed=seed, config=state)
    resolved = doc.model_copy(
        update={
            "asset_configurations": configurations,
            "provenance": (*(p for p in doc.provenance if p.stage != "resolve"), entry),
        }
    )
    return with_parts(resolved)


def _library_state() -> dict[str, str]:
    from esg.assets.imports.store import active_index

    return {"library": active_index().fingerprint}


def configure(
    key: str,
    requirement: AssetRequirement,
    *,
    generator: Generator | None = None,
    seed: int = 0,
    failures: dict[str, str] | None = None,
    rolled: bool | None = None,
    retrieval_only: bool = False,
) -> AssetConfiguration:
    """The configuration of one requirement, filled with what shall be in it.

    Args:
        key: Asset id in the document; names the mesh file.
        requirement: What is needed.
        generator: Asked where the library holds nothing.
        seed: Given to the generator.
        failures: Receives why the generator gave nothing, by asset id.
        rolled: Whether the story rolls it on its rim; None lets the size decide.
        retrieval_only: Take the closest asset of the library, whatever it is.
    """
    empty = _empty(key, requirement, generator, seed, failures, rolled, retrieval_only)
    if empty.lying is not None:
        return empty  # what was in it has run out
    if requirement.contents is not None and not is_open(empty):
        empty = _open(key, requirement, empty)
    return filled(empty, requirement)


def _open(
    key: str, requirement: AssetRequirement, closed: AssetConfiguration
) -> AssetConfiguration:
    """An open vessel as large, for one that is drawn closed or full: barrels, aquariums."""
    size, shape = closed.dimensions_cm, "open box"
    if requirement.shape == "cylinder":
        size, shape = (math.prod(size) ** (1.0 / 3.0),) * 3, "bucket"
    said = requirement.model_copy(
        update={
            "asset_category": shape,
            "asset_description": shape,
            "expected_dimensions_cm": size,
            "expected_mass_kg": closed.mass_kg,
            "dimensions_are_prescribed": True,
        }
    )
    made = build_configuration(key, said, decide(said))
    made = made.model_copy(update={"category": category_of(requirement)})
    return made if is_open(made) else closed


def _empty(
    key: str,
    requirement: AssetRequirement,
    generator: Generator | None,
    seed: int,
    failures: dict[str, str] | None,
    rolled: bool | None,
    retrieval_only: bool,
) -> AssetConfiguration:
    from esg.assets.imports.models.joining import named_model
    from esg.assets.library.nearest import nearest, usual_size
    from esg.assets.library.wording import restated

    model = named_model(requirement)
    if model is not None:
        return build_configuration(key, requirement, Decision(model, 1.0, ()))
    said = restated(requirement)
    if said is not requirement:
        made = build_configuration(key, said, decide(said), rolled)
        return made.model_copy(update={"category": category_of(requirement)})
    requirement = usual_size(requirement)
    decision = decide(requirement)
    if retrieval_only:
        return build_configuration(key, requirement, closest(decision), rolled)
    if decision.entry is None and generator is not None:
        from esg.assets.imports.generated import generate_asset
        from esg.assets.imports.providers import GenerationError

        try:
            return generate_asset(key, requirement, decision, generator, seed)
        except GenerationError as error:
            if failures is not None:
                failures[key] = str(error)
    if decision.entry is None:
        requirement, decision = nearest(requirement, decision) or (requirement, decision)
    return build_configuration(key, requirement, decision, rolled)


def build_configuration(
    key: str, requirement: AssetRequirement, decision: Decision, rolled: bool | None = None
) -> AssetConfiguration:
    """The configuration that a decision leads to."""
    if decision.entry is None:
        return _fallback(key, requirement, decision, rolled)
    if decision.entry.library != "parametric":
        from esg.assets.imports.imported import configure_imported

        return configure_imported(key, requirement, decision)
    return _parametric(key, requirement, decision.entry, decision, rolled)


def _surface_material(entry: Entry, requirement: AssetRequirement) -> tuple[Material, float]:
    """Contact material and the ratio of its density to the entry's own."""
    own = MATERIALS[entry.material]
    asked = find_material(requirement.material)
    if asked is None or is_usual(asked, own.name):
        return own, 1.0
    if "decal" in entry.flags or "wheeled" in entry.flags or "hollow" in entry.flags:
        return asked, 1.0
    # Shells and frames do not follow density one to one: a steel chair is not 13 times heavier.
    ratio = asked.density / own.density
    return asked, ratio if _is_solid(entry) else ratio ** (1 / 3)


def _is_solid(entry: Entry) -> bool:
    """Whether the usual mass is that of a body filled with its material."""
    volume_m3 = math.prod(entry.dimensions_cm) * 1e-6
    fill = {"rolls": math.pi / 6}.get("rolls" if "rolls" in entry.flags else "", 1.0)
    return entry.mass_kg / (volume_m3 * fill) > 0.3 * MATERIALS[entry.material].density


def _parametric(
    key: str,
    requirement: AssetRequirement,
    entry: Entry,
    decision: Decision,
    rolled: bool | None = None,
) -> AssetConfiguration:
    if rolled is None:
        stands = "rim" in entry.flags and on_its_rim(requirement)
        rolled = stands and requirement.lies is None
    rolled = rolled and bool(entry.flags & FLAGS.keys())
    requirement = as_drawn(entry, requirement)
    dimensions = choose_dimensions(entry, requirement)
    material, ratio = _surface_material(entry, requirement)
    mass = choose_mass(entry, requirement, dimensions, ratio)
    color = find_color(requirement.color) or _material_color(requirement, entry)
    sketch = build_sketch(entry, dimensions, color)
    if rolled:
        sketch = rolling(entry, sketch, dimensions)
        dimensions = turned_size(entry, dimensions)
        entry = replace(entry, flags=entry.flags | {"rolls"})
        material = replace(material, restitution=min(material.restitution, ROLLING_RESTITUTION))
    source = "fallback" if decision.reason else "parametric"
    return finish(
        key, entry, requirement, sketch, dimensions, mass, material, color, decision, source
    )


def _material_color(requirement: AssetRequirement, entry: Entry) -> tuple[float, float, float]:
    from esg.assets.geometry.sketch import BRASS, CARDBOARD, CONCRETE, DARK, GLASS, STEEL, WOOD

    asked = stated_material(entry, requirement)
    if asked is None:
        return entry.color_rgb
    table = {
        "wood": WOOD,
        "steel": STEEL,
        "cast_iron": DARK,
        "brass": BRASS,
        "concrete": CONCRETE,
        "stone": (0.55, 0.53, 0.5),
        "glass": (0.75, 0.85, 0.88),
        "cardboard": CARDBOARD,
        "gold": (0.81, 0.65, 0.24),
        "rubber": GLASS,
        "ice": (0.8, 0.9, 0.95),
    }
    return table.get(asked.name, entry.color_rgb)


def _fallback(
    key: str, requirement: AssetRequirement, decision: Decision, rolled: bool | None = None
) -> AssetConfiguration:
    """A plain body of the requested size for a noun that the library does not hold."""
    shape = decision.shape or "box"
    material = find_material(requirement.material) or MATERIALS["plastic_hard"]
    dimensions = requirement.expected_dimensions_cm
    if shape in ("sphere", "capsule", "cylinder"):
        a, b, c = dimensions
        if shape == "sphere":
            dimensions = ((a * b * c) ** (1 / 3),) * 3
        elif shape == "cylinder":
            dimensions = (math.sqrt(a * b), math.sqrt(a * b), c)
        else:
            width = math.sqrt(min(a, b) * c)
            dimensions = (max(a, b, width), width, width)
    color = find_color(requirement.color) or (0.55, 0.58, 0.62)
    entry = plain_entry(shape, dimensions, requirement.expected_mass_kg, material.name, color)
    sketch = build_sketch(entry, dimensions, color)
    if rolled and entry.flags & FLAGS.keys():
        sketch, dimensions = rolling(entry, sketch, dimensions), turned_size(entry, dimensions)
        entry = replace(entry, flags=entry.flags | {"rolls"})
    return finish(
        key,
        entry,
        requirement,
        sketch,
        dimensions,
        requirement.expected_mass_kg,
        material,
        color,
        decision,
        "fallback",
    )
