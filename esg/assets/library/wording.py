"""What was said, where a requirement's category stands for more than one noun.

A drafter that knows fewer nouns than the library files a wolf under foxes and a wheelie bin under
trash bins, and keeps the words themselves before the colon of the description. Where those words
name an entry of the library, that entry is meant.
"""

from __future__ import annotations

import math

from esg.assets.geometry.rolling import as_drawn
from esg.assets.library.catalogue import Entry, normalize, parts, policy
from esg.assets.library.lookup import exact, head_match
from esg.assets.library.proposal import SIZED, guessed, is_own_name, is_toy, misfit, residual
from esg.graph.models import AssetRequirement

_SAME_SIZE = 1.5
"""Up to this factor a category's expectation says nothing about the size of the noun itself."""

_OTHER_THING = 4.0
"""Beyond this factor of size a compound's last word names another thing than its category."""

_HOLE = "golf_hole"
_SLOPES = ("ramp", "slide")
"""Builders of what something rolls or slides down."""
_OWN_SHAPE = 1.2
"""Extents that differ by no more than this after scaling are those of the noun itself."""


def said_entry(requirement: AssetRequirement) -> Entry | None:
    """The entry that the words name, if it is another and no broader one than the category's."""
    words, colon, _ = requirement.asset_description.partition(":")
    if not colon or requirement.asset_category in parts():
        return None
    said, filed = head_match(words), exact(requirement.asset_category.replace("_", " "))
    if said is None or "decal" in said.flags:
        return None
    whole = normalize(words) == normalize(said.name)
    if said is filed:
        # A category that siblings share ("lamp") is settled by the sibling's own name.
        return said if whole and not is_own_name(said, requirement) else None
    if not whole and exact(words) is not said and _far_off(said, filed, requirement):
        return None  # a remote control car is no car, a propane tank is no tank
    if filed is not None and filed.name == "tunnel" and said.name != _HOLE:
        return None  # a "cup" that a ball rolls into is no tableware
    if filed is not None and (said.name in filed.parents or "decal" in filed.flags):
        return None
    if filed is not None and filed.builder in _SLOPES and said.builder not in _SLOPES:
        return None  # a shelf set aslant is a slope, and no shelf
    return said if normalize(words) != normalize(requirement.asset_category) else None


def _far_off(said: Entry, filed: Entry | None, requirement: AssetRequirement) -> bool:
    """Whether an entry that only the last word names is of another size than the category."""
    if guessed(requirement):
        return False
    size = requirement.expected_dimensions_cm if filed is None else filed.dimensions_cm
    ratio = (math.prod(said.dimensions_cm) / math.prod(size)) ** (1 / 3)
    return not 1 / _OTHER_THING <= ratio <= _OTHER_THING


def _resized(requirement: AssetRequirement, said: Entry) -> bool:
    """Whether a word besides the entry's own name makes it larger or smaller."""
    words = requirement.asset_description.partition(":")[0]
    names = {normalize(n) for n in (said.name, *said.synonyms)}
    return normalize(words) not in names and SIZED.search(words) is not None


def dressed(one: Entry, other: Entry) -> bool:
    """Whether two entries are one body in different clothes."""
    same = one.builder == other.builder and one.dimensions_cm == other.dimensions_cm
    return same and any(key == "dress" for key, _ in (*one.params, *other.params))


def restated(requirement: AssetRequirement) -> AssetRequirement:
    """The requirement for the entry that the words name; unchanged if they name no other.

    Size and mass that are not prescribed become those of the entry, larger or smaller as the
    expectation was than what its category usually is ("giant wolf").
    """
    said = said_entry(requirement)
    if said is None:
        return requirement
    filed = exact(requirement.asset_category.replace("_", " "))
    if filed is not None and filed.name in said.parents and policy(said) == "free":
        # A kind of the category that takes any size ("brick wall"): the expectation holds.
        return requirement.model_copy(update={"asset_category": said.name})
    if filed is not None and dressed(said, filed):
        # The same body in other clothes: nothing is said about size and mass.
        return requirement.model_copy(update={"asset_category": said.name})
    if filed is None and "any_size" in said.flags and not guessed(requirement):
        # A box of cereal is a box, of the size that was expected of it.
        return requirement.model_copy(update={"asset_category": said.name, "shape": None})
    if is_toy(requirement):
        # A toy soldier is a soldier of a toy's size and mass.
        return requirement.model_copy(update={"asset_category": said.name, "shape": None})
    factor = 1.0
    shape = residual(said, as_drawn(said, requirement))
    if shape <= _OWN_SHAPE and filed is not None and misfit(filed, requirement, named=True):
        # The category is another thing of that name: a hula hoop is no basketball hoop.
        return requirement.model_copy(update={"asset_category": said.name})
    if filed is not None and filed is not said and _resized(requirement, said):
        ratio = math.prod(requirement.expected_dimensions_cm) / math.prod(filed.dimensions_cm)
        factor = ratio ** (1 / 3)
        own = (math.prod(requirement.expected_dimensions_cm) / math.prod(said.dimensions_cm)) ** (
            1 / 3
        )
        known = shape <= _OWN_SHAPE < residual(filed, requirement)
        if 1 / _SAME_SIZE <= factor <= _SAME_SIZE or (
            known and 1 / _SAME_SIZE <= own <= _SAME_SIZE
        ):
            factor = 1.0  # nothing was said about the size, or it is the noun's own already
    if said.name == _HOLE:
        # Filed under tunnels, whose width leaves the ball room on both sides.
        factor = max(1.0, requirement.expected_dimensions_cm[1] / (1.6 * said.dimensions_cm[1]))
    update: dict[str, object] = {"asset_category": said.name, "shape": None}
    if not requirement.dimensions_are_prescribed:
        update["expected_dimensions_cm"] = tuple(factor * d for d in said.dimensions_cm)
    if not requirement.mass_is_prescribed:
        update["expected_mass_kg"] = said.mass_kg * factor**3
    return requirement.model_copy(update=update)
