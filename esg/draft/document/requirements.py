"""What each object needs: environment, size, mass, and the asset requirement."""

from __future__ import annotations

from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity, is_toy, slug
from esg.draft.discourse.referents.sizes import dimensions_of, mass_of
from esg.draft.discourse.scene import GROUND, Scene
from esg.graph.models import AssetRequirement

GROUND_SIZE_CM = (12000.0, 12000.0, 2.0)
_OFFICE = frozenset({"desk", "office"})
_ICY = lex.word_set("icy")
_ENVIRONMENTS = (
    ({"pin", "bowling lane"}, "indoor", "bowling_alley"),
    ({"billiard", "billiardtable"}, "indoor", "billiard_hall"),
    (set[str](), "", "ground"),
    ({"vehicle", "road"}, "outdoor", "street"),
    (_OFFICE, "indoor", "office"),
    (lex.word_set("outdoor kinds"), "outdoor", "street"),
    (lex.word_set("indoor kinds"), "indoor", "room"),
    ({"goal"}, "outdoor", "soccer_field"),
)
"""Kinds and names of things, and where there are such; where the ground is told of, what it is."""
_OPENINGS = (
    (("cart", "mine cart"), (), "shopping_cart", "shopping cart: open wire cart with castors"),
    (("trailer", "container"), ("generic",), "open_box", "open box without a lid"),
    (("pot", "barrel"), (), "bucket", "{}: open pot without a lid, bucket"),
    (("cup", "glass"), (), "", ""),
    (("cabinet", "crib", "well"), ("box", "bottle", "rock"), "open_box",
     "{}: open box without a lid"),
    (tuple(lex.word_set("open vessels")), (), "open_box", "{}: open box without a lid"),
    ((), ("hole",), "tunnel", "{}: small low tunnel that a ball rolls into"),
)  # fmt: skip
"""Names and kinds of things, the category and the description of what others enter instead."""
_HOLE_CM, _GOLF_HOLE_CM = (30.0, 40.0, 30.0), (30.0, 30.0, 15.0)


def environment(scene: Scene) -> tuple[str, str]:
    """(indoor or outdoor, named preset) from what is in the scene."""
    entities = scene.world.entities
    told = [e for e in entities.values() if not is_toy(e)]  # toy boats float in a bathtub
    found = {word for e in told for word in (e.noun.kind, e.head, e.noun.name)}
    found |= {word for e in told for word in e.head.split() if word in _OFFICE}
    ground = entities.get(GROUND)
    for kinds, place, preset in _ENVIRONMENTS:
        if preset == "ground" and ground is not None:
            if "indoor" in ground.noun.traits:
                return "indoor", slug(ground.head)
            if ground.head not in ("ground", "earth", "land", "terrain"):
                return "outdoor", slug(ground.head)
        elif kinds & found:
            return place, preset
    return "outdoor", "generic"


def requirement(e: Entity) -> AssetRequirement:
    """What a node needs: category, description, size, mass."""
    size = dimensions_of(e)
    material = lex.MATERIALS[e.material][0] if e.material is not None else e.noun.material
    if e.noun.kind in ("ground", "water") and _ICY.intersection([*e.adjectives, *e.head.split()]):
        material = "ice"
    said = {"same", "other"} | ({*lex.ORDINALS, "last", "final"} if e.in_group else set[str]())
    words = [a for a in e.adjectives if not a.startswith("@") and a not in said]
    head = e.noun.name if e.part else e.head
    description = f"{' '.join(dict.fromkeys([*words, head]))}: {e.noun.description}"
    synonyms = [s for s in e.noun.synonyms if s != e.head][:4]
    if synonyms:
        description += f" ({', '.join(synonyms)})"
    if material:
        description += f", {material}"
    shape: Any = e.noun.shape or None
    return AssetRequirement(
        asset_category=e.noun.category if e.known or e.part else slug(e.head),
        asset_description=description,
        expected_dimensions_cm=size,
        expected_mass_kg=e.noun.mass_kg if "structural" in e.noun.traits else mass_of(e, size),
        is_movable=e.movable,
        mass_is_prescribed=e.mass_prescribed,
        dimensions_are_prescribed=e.dimensions_prescribed,
        material=material or None,
        color=e.color or _known_by(e),
        shape=shape,
        lies=e.lies,
    )


def _known_by(e: Entity) -> str | None:
    """The colour that a kind of vehicle is known by: taxis are yellow, fire engines red."""
    first = e.noun.description.partition(" ")[0]
    return first if e.noun.kind == "vehicle" and e.known and first in lex.COLORS else None


def opened(e: Entity, required: AssetRequirement, golf: bool) -> AssetRequirement:
    """Something enters it: an open box instead of a closed one.

    The ground is a half-space, so a hole is a low opening on it, as wide as stated: a ball that
    rolls gets over no rim.
    """
    for names, kinds, category, text in _OPENINGS:
        named = {e.noun.name, e.head.rpartition(" ")[2]} & {*names}
        if not named and e.noun.kind not in kinds:
            continue
        if not category:
            break
        size = required.expected_dimensions_cm
        if category == "tunnel" and not e.dimensions_prescribed:
            size = _GOLF_HOLE_CM if golf else _HOLE_CM
        told = {"asset_category": category, "asset_description": text.format(e.head)}
        return required.model_copy(update=told | {"expected_dimensions_cm": size, "shape": None})
    return required
