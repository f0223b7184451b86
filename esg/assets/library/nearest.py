"""What stands in for a noun that the library does not hold and nobody generates.

In order: the kind that WordNet puts above the noun; an entry that the noun names but whose shape
was asked for otherwise; the first candidate of a gate that closed by a hair. Each is drawn at the
size asked for, and the decision says why. Only where nothing is near a plain body is used.
"""

from __future__ import annotations

from dataclasses import replace
import math

from esg.assets.imports.store import active_index
from esg.assets.library.catalogue import Entry, policy
from esg.assets.library.hypernyms import Kin, kin
from esg.assets.library.lookup import exact
from esg.assets.library.proposal import guessed, guessed_mass_factor, is_own_name, residual
from esg.assets.library.retrieve import GATE, Decision, candidate_of, is_foreign, qualified
from esg.graph.models import AssetRequirement

_BY_A_HAIR = GATE - 0.07
_OTHER_SHAPE = 4.0
"""Extents further apart than this after scaling are no longer recognizable."""
_LONGEST_CM = 1500.0
_ROOTED_KG = 500.0
"""Heavier things that were asked for as immovable are no furniture and no toys."""
_FIXED_KG = 150.0
"""Lighter stand-ins of rooted kinds (a pagoda of 30 cm on a table) can move."""


def nearest(
    requirement: AssetRequirement, decision: Decision
) -> tuple[AssetRequirement, Decision] | None:
    """The requirement and the decision with the nearest kind in place of nothing.

    Args:
        requirement: What is needed.
        decision: A closed gate.

    Returns:
        The requirement restated for the kind, and a decision with its entry, the candidates with
        that kind first, and the reason; None if nothing is near.
    """
    text = requirement.asset_category.replace("_", " ")
    relative = said_kin(requirement)
    if relative is not None and _fits(relative.entry, requirement):
        asked = _usual(requirement, relative, relative.entry)
        above = "" if relative.concept == relative.noun else f" ({relative.concept})"
        return asked, _chosen(decision, relative.entry, asked, relative.noun + above)
    named = exact(text)
    if named is not None:
        if not _fits(named, requirement):
            return None
        return requirement, _chosen(decision, named, requirement, f"{text} of another shape")
    if relative is None and decision.confidence >= _BY_A_HAIR and not is_foreign(text):
        best = decision.runners_up[0].asset_name
        entry = next(e for e in active_index().entries if qualified(e) == best)
        if _fits(entry, requirement):
            return requirement, _chosen(decision, entry, requirement, f"{text}, by meaning")
    return None


def said_kin(requirement: AssetRequirement) -> Kin | None:
    """What the noun is: as the description begins ("cliff"), else as it was filed ("treehouse")."""
    words, colon, _ = requirement.asset_description.partition(":")
    said = kin(words) if colon else None
    return said or kin(requirement.asset_category.replace("_", " "))


def _fits(entry: Entry, requirement: AssetRequirement) -> bool:
    """Whether it can stand in: it has a body, and about the proportions that were asked for."""
    if "decal" in entry.flags:
        return False
    if not requirement.is_movable and requirement.expected_mass_kg > _ROOTED_KG and entry.movable:
        return False
    if guessed(requirement) or (policy(entry) == "free" and entry.library == "parametric"):
        return True
    return residual(entry, requirement) <= _OTHER_SHAPE


def usual_size(requirement: AssetRequirement) -> AssetRequirement:
    """The requirement with the noun's own size, where it was a guess and a synonym decides.

    A sword is drawn as a knife, and is a metre long all the same.
    """
    text = requirement.asset_category.replace("_", " ")
    entry = exact(text)
    if entry is None or is_own_name(entry, requirement) or not guessed(requirement):
        return requirement
    own = kin(text, whole=True)
    return requirement if own is None else _usual(requirement, own, entry)


def _usual(requirement: AssetRequirement, relative: Kin, entry: Entry) -> AssetRequirement:
    """With size and mass usual for the concept, where the expectation was a guess."""
    update: dict[str, object] = {
        "shape": None,
        "asset_description": f"{relative.noun}: {entry.description}",
    }
    factors = guessed(requirement)
    if factors:
        longest = max(entry.dimensions_cm)
        usual = min(relative.longest_cm or longest, max(_LONGEST_CM, longest))
        scale = usual / longest
        size = [d * scale * f for d, f in zip(entry.dimensions_cm, factors, strict=True)]
        grown = (usual / (relative.longest_cm or longest)) ** 3 * math.prod(factors)
        mass = (relative.mass_kg or entry.mass_kg * scale**3) * grown
        update["expected_dimensions_cm"] = tuple(size)
        if not requirement.mass_is_prescribed:
            update["expected_mass_kg"] = mass * guessed_mass_factor(requirement, factors)
    return requirement.model_copy(update=update)


def _chosen(decision: Decision, entry: Entry, requirement: AssetRequirement, why: str) -> Decision:
    name = qualified(entry)
    others = tuple(c for c in decision.runners_up if c.asset_name != name)
    first = candidate_of(entry, requirement)
    if requirement.expected_mass_kg < _FIXED_KG:
        entry = replace(entry, flags=entry.flags - {"fixed"})
    reason = (
        f"gate closed (confidence {decision.confidence:.2f}, gate {GATE}); "
        f"{why} is drawn as the nearest kind, {name.replace('_', ' ')}"
    )
    return Decision(
        entry, decision.confidence, (first, *others)[: len(decision.runners_up) or 1], None, reason
    )
