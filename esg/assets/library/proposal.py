"""Sizes and masses: what a requirement and a library entry agree on."""

from __future__ import annotations

import math
import re

from esg.assets.library.catalogue import Entry, normalize, policy
from esg.graph.models import AssetRequirement, Vec3
from esg.lexicon.kinds import NEAR

_PLAUSIBLE = (0.5, 2.0)
"""Range of uniform scales of an entry asked for by its own name."""
SIZED = re.compile(
    r"\b(toy|model|miniature|mini|tiny|little|small|short|giant|huge|gigantic|enormous|colossal|"
    r"massive|oversized|large|big|tall|long|wide)\b",
    re.IGNORECASE,
)
"""Words that make a thing larger or smaller than it usually is."""
TOY = re.compile(r"\b(toy|miniature|scale model|model(?=\s+[a-z]{3,}))\b", re.IGNORECASE)
"""Words that make a toy: "model car", not "fashion model" or "Model T"."""
"""A toy of something has the size and mass that are expected of it, however large the thing is."""
_STRETCH = (0.04, 25.0)
"""Range for another noun that the entry stands for (a pebble for a rock)."""
_MISFIT = 2.2
"""Extents that differ by more than this after scaling are another shape."""
_NAMED_MISFIT = 3.0
"""The same for an entry that the noun names: a lamp post may or may not have its arm counted."""
_DENSITY = (2e-6, 0.022)
"""Plausible mass per volume of the bounding box [kg/cm^3]: a balloon, a gold bar."""


_GUESS_CM, _GUESS_KG = 40.0, 5.0
"""What a drafter expects of a noun that it has never heard of: it says so by repeating the noun."""
_LONG_MISFIT = 4.0
"""Beyond this ratio the longest extent alone gives the scale."""


def guessed(requirement: AssetRequirement) -> Vec3 | None:
    """Factors on the size where the expectation is only a stand-in; None where it was meant.

    A noun unknown to the drafter comes as a cube of 40 cm and 5 kg with no description but itself;
    adjectives ("giant", "heavy") have scaled it.
    """
    if requirement.dimensions_are_prescribed or requirement.shape != "box":
        return None
    if len(set(requirement.expected_dimensions_cm)) > 1:
        return None
    _, colon, told = requirement.asset_description.partition(": ")
    if not colon or normalize(told.split(",")[0]) != normalize(requirement.asset_category):
        return None
    l, w, h = (d / _GUESS_CM for d in requirement.expected_dimensions_cm)  # noqa: E741
    return (l, w, h)


def guessed_mass_factor(requirement: AssetRequirement, factors: Vec3) -> float:
    """What adjectives ("heavy", "steel") did to the mass besides the size."""
    return requirement.expected_mass_kg / (_GUESS_KG * math.prod(factors))


def is_own_name(entry: Entry, requirement: AssetRequirement) -> bool:
    """Whether the requirement names the entry itself, not something like it."""
    return normalize(entry.name) == normalize(requirement.asset_category)


def is_toy(requirement: AssetRequirement) -> bool:
    """Whether the words make the thing a toy or a model."""
    return TOY.search(requirement.asset_description.partition(":")[0]) is not None


def residual(entry: Entry, requirement: AssetRequirement) -> float:
    """Largest ratio of extents, whichever way round, left after scaling as a whole."""
    own, wanted = sorted(entry.dimensions_cm), sorted(requirement.expected_dimensions_cm)
    factor = math.prod(b / a for a, b in zip(own, wanted, strict=True)) ** (1 / 3)
    return max(max(b / (a * factor), a * factor / b) for a, b in zip(own, wanted, strict=True))


def misfit(entry: Entry, requirement: AssetRequirement, *, named: bool = False) -> bool:
    """Whether the entry, scaled as a whole, cannot pass for what is required.

    Builders that take any extents always fit.

    Args:
        entry: Candidate.
        requirement: What is needed.
        named: Whether the noun is one of the entry's names, not only near in meaning.
    """
    if policy(entry) == "free" and entry.library == "parametric":
        return False
    if guessed(requirement):
        return False
    if residual(entry, requirement) <= (_NAMED_MISFIT if named else _MISFIT):
        return False
    heavier = requirement.expected_mass_kg / entry.mass_kg
    return not is_own_name(entry, requirement) or not 1 / 8 <= heavier <= 8


def _oriented(usual: Vec3, wanted: Vec3) -> Vec3:
    """Swaps length and width of the request where that agrees much better with the library."""
    l, w, h = wanted  # noqa: E741
    straight = abs(math.log(l / usual[0])) + abs(math.log(w / usual[1]))
    swapped = abs(math.log(w / usual[0])) + abs(math.log(l / usual[1]))
    return (w, l, h) if swapped < 0.6 * straight and straight > 0.3 else (l, w, h)


def choose_dimensions(entry: Entry, requirement: AssetRequirement) -> Vec3:
    """Extents [cm] at which an entry is built for a requirement.

    Prescribed extents are met exactly by builders that can, and by the most distinctive ratio where
    the proportions are fixed. Other expectations are followed within a factor of two
    for an entry asked for by its own name and freely for a noun it stands for; structures (roads,
    walls, lanes) follow theirs at any size.
    """
    usual = entry.dimensions_cm
    factors = guessed(requirement)
    if factors:
        if policy(entry) == "free" and entry.library == "parametric":
            l, w, h = (d * f for d, f in zip(usual, factors, strict=True))  # noqa: E741
            return (l, w, h)
        scale = math.prod(factors) ** (1 / 3)
        return (usual[0] * scale, usual[1] * scale, usual[2] * scale)
    wanted = _oriented(usual, requirement.expected_dimensions_cm)
    ratios = [b / a for a, b in zip(usual, wanted, strict=True)]
    free = policy(entry) == "free"
    if requirement.dimensions_are_prescribed:
        if free:
            return wanted
        factor = max(ratios, key=lambda r: abs(math.log(r)))
        if "rolls" in entry.flags:
            factor = ratios[2]
        return (usual[0] * factor, usual[1] * factor, usual[2] * factor)
    if all(1 / NEAR <= r <= NEAR for r in ratios):
        return usual
    if free and ("decal" in entry.flags or "structure" in entry.parents):
        height = wanted[2] if "decal" not in entry.flags else usual[2]
        return (wanted[0], wanted[1], height)
    return _followed(entry, requirement, wanted, ratios, free)


def _followed(
    entry: Entry, requirement: AssetRequirement, wanted: Vec3, ratios: list[float], free: bool
) -> Vec3:
    """Extents [cm] that follow an expectation as far as it can be meant of the entry."""
    usual = entry.dimensions_cm
    strict = is_own_name(entry, requirement) and "any_size" not in entry.flags
    strict = strict and not SIZED.search(requirement.asset_description.partition(":")[0])
    low, high = _PLAUSIBLE if strict else _STRETCH
    plausible = all(low <= r <= high for r in ratios)
    if free and plausible:
        return wanted
    factor = math.prod(ratios) ** (1 / 3)
    if is_toy(requirement):
        factor = max(wanted) / max(usual)
        return (usual[0] * factor, usual[1] * factor, usual[2] * factor)
    if not strict and residual(entry, requirement) > _MISFIT:
        # One extent was counted differently (with or without an arm, a base): follow the others.
        factor = sorted(ratios)[1]
    if not strict and residual(entry, requirement) > _LONG_MISFIT:
        factor = max(wanted) / max(usual)
    if not plausible and not low <= factor <= high:
        factor = 1.0
    if 1 / NEAR <= factor <= NEAR:
        factor = 1.0
    return (usual[0] * factor, usual[1] * factor, usual[2] * factor)


def choose_mass(
    entry: Entry, requirement: AssetRequirement, dimensions: Vec3, density_ratio: float
) -> float:
    """Mass [kg]: prescribed, or expected as far as the library's figures allow.

    The library's mass is scaled by volume and bracketed by the material's density; an expectation
    within a factor of two of the bracket is followed, since it carries adjectives ("heavy") that
    the library does not know. For a noun that the entry only stands for, the expectation counts as
    long as its density is one of matter.
    """
    expected = requirement.expected_mass_kg
    if requirement.mass_is_prescribed:
        return expected
    factors = guessed(requirement)
    if factors:
        scale = math.prod(b / a for a, b in zip(entry.dimensions_cm, dimensions, strict=True))
        return entry.mass_kg * scale * guessed_mass_factor(requirement, factors)
    volume = math.prod(b / a for a, b in zip(entry.dimensions_cm, dimensions, strict=True))
    mass = entry.mass_kg * volume
    bracket = sorted((mass, mass * density_ratio))
    if not is_own_name(entry, requirement) or is_toy(requirement):
        packed = expected / math.prod(dimensions)
        if _DENSITY[0] <= packed <= _DENSITY[1]:
            return expected
    return min(max(expected, 0.5 * bracket[0]), 2.0 * bracket[1])
