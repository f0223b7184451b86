"""Things that others enter: open boxes, rims and low tunnels in place of closed bodies."""

from __future__ import annotations

from esg.draft.discourse.referents.entities import Entity
from esg.graph.models import AssetRequirement


def opened(e: Entity, required: AssetRequirement, golf: bool) -> AssetRequirement:
    """Something enters it: an open box instead of a closed one, a rim above the flat ground.

    The ground is a half-space, so a hole is a low opening on it, as wide as stated: a ball that
    rolls gets over no rim.
    """
    if e.noun.name in ("cart", "mine cart"):
        category, text = "shopping_cart", "shopping cart: open wire cart with castors"
    elif e.noun.kind == "generic" or e.noun.name in ("trailer", "container"):
        category, text = "open_box", "open box without a lid"
    elif e.noun.name in ("pot", "barrel"):
        category, text = "bucket", f"{e.head}: open pot without a lid, bucket"
    elif e.noun.name in ("cabinet", "crib", "well") or (
        e.noun.kind in ("box", "bottle", "rock") and e.noun.name not in ("cup", "glass")
    ):
        category, text = "open_box", f"{e.head}: open box without a lid"
    elif e.noun.kind == "hole":
        category, text = "tunnel", f"{e.head}: small low tunnel that a ball rolls into"
    else:
        return required
    size = required.expected_dimensions_cm
    if category == "goal" and not e.dimensions_prescribed:
        size = (200.0, 300.0, 60.0)
    elif category == "tunnel" and not e.dimensions_prescribed:
        size = (30.0, 30.0, 15.0) if golf else (30.0, 40.0, 30.0)
    return required.model_copy(
        update={
            "asset_category": category,
            "asset_description": text,
            "expected_dimensions_cm": size,
            "expected_mass_kg": max(required.expected_mass_kg, 20.0)
            if category == "goal"
            else required.expected_mass_kg,
            "shape": None,
        }
    )
