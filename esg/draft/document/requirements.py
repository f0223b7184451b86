"""What each object needs: environment, size, mass, and the asset requirement."""

from __future__ import annotations

from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity, slug
from esg.draft.discourse.referents.sizes import dimensions_of, mass_of
from esg.draft.discourse.scene import Scene
from esg.graph.models import AssetRequirement

GROUND = "ground_1"
_INDOOR_KINDS = lex.word_set("indoor kinds")
_OUTDOOR_KINDS = lex.word_set("outdoor kinds")
_ICY = lex.word_set("icy")
GROUND_SIZE_CM = (12000.0, 12000.0, 2.0)


def environment(scene: Scene) -> tuple[str, str]:
    """(indoor or outdoor, named preset) from what is in the scene."""
    entities = [e for e in scene.world.entities.values()]
    kinds = [e.noun.kind for e in entities]
    heads = {e.head for e in entities} | {e.noun.name for e in entities}
    if "pin" in kinds or "bowling lane" in heads:
        return "indoor", "bowling_alley"
    if "billiard" in kinds or "billiardtable" in kinds:
        return "indoor", "billiard_hall"
    ground = scene.world.entities.get(GROUND)
    if ground is not None:
        indoor = "indoor" in ground.noun.traits
        if indoor:
            return "indoor", slug(ground.head)
        if ground.head not in ("ground", "earth", "land", "terrain"):
            return "outdoor", slug(ground.head)
    if "picnic table" in heads and "vehicle" not in kinds:
        return "outdoor", "park"
    if "vehicle" in kinds or "road" in heads:
        return "outdoor", "street"
    if any("desk" in h or "office" in h for h in heads):
        return "indoor", "office"
    if any(k in _OUTDOOR_KINDS for k in kinds):
        return "outdoor", "street"
    if any(k in _INDOOR_KINDS for k in kinds):
        return "indoor", "room"
    if "goal" in kinds:
        return "outdoor", "soccer_field"
    return "outdoor", "generic"


def requirement(e: Entity) -> AssetRequirement:
    """What a node needs: category, description, size, mass."""
    size = dimensions_of(e)
    structural = "structural" in e.noun.traits
    movable = e.movable
    material = next(
        (lex.MATERIALS[a][0] for a in e.adjectives if a in lex.MATERIALS), e.noun.material
    )
    if e.noun.kind in ("ground", "water") and _ICY.intersection([*e.adjectives, *e.head.split()]):
        material = "ice"
    modifiers = [
        a
        for a in e.adjectives
        if not a.startswith("@")
        and a not in ("same", "other")
        and not (e.in_group and a in {*lex.ORDINALS, "last", "final"})
    ]
    words = [*modifiers, e.head]
    description = f"{' '.join(dict.fromkeys(words))}: {e.noun.description}"
    synonyms = [s for s in e.noun.synonyms if s != e.head][:4]
    if synonyms:
        description += f" ({', '.join(synonyms)})"
    if material:
        description += f", {material}"
    shape: Any = e.noun.shape or None
    return AssetRequirement(
        asset_category=e.noun.category if e.known else slug(e.head),
        asset_description=description,
        expected_dimensions_cm=size,
        expected_mass_kg=mass_of(e, size) if not structural else e.noun.mass_kg,
        is_movable=movable,
        mass_is_prescribed=e.mass_prescribed,
        dimensions_are_prescribed=e.dimensions_prescribed,
        material=material or None,
        color=e.color,
        shape=shape,
    )
