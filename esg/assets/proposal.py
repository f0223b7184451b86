"""Sizes and masses: what a requirement and a library entry agree on."""

from __future__ import annotations

import math

from esg.assets.library import Entry, policy
from esg.graph.models import AssetRequirement, Vec3

_PLAUSIBLE = (0.5, 2.0)
_NEAR = 1.12
"""Ratios up to this are the same size: the library's sourced figures then win."""


def _oriented(usual: Vec3, wanted: Vec3) -> Vec3:
    """Swaps length and width of the request where that agrees much better with the library."""
    l, w, h = wanted  # noqa: E741
    straight = abs(math.log(l / usual[0])) + abs(math.log(w / usual[1]))
    swapped = abs(math.log(w / usual[0])) + abs(math.log(l / usual[1]))
    return (w, l, h) if swapped < 0.6 * straight and straight > 0.3 else (l, w, h)


def choose_dimensions(entry: Entry, requirement: AssetRequirement) -> Vec3:
    """Extents [cm] at which an entry is built for a requirement.

    Prescribed extents are met exactly by builders that can, and by the most distinctive ratio where
    the proportions are fixed. Other expectations are followed within a factor of two; structures
    (roads, walls, lanes) follow theirs at any size.
    """
    usual = entry.dimensions_cm
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
    if all(1 / _NEAR <= r <= _NEAR for r in ratios):
        return usual
    if free and ("decal" in entry.flags or "structure" in entry.parents):
        height = wanted[2] if "decal" not in entry.flags else usual[2]
        return (wanted[0], wanted[1], height)
    plausible = all(_PLAUSIBLE[0] <= r <= _PLAUSIBLE[1] for r in ratios)
    if free and plausible:
        return wanted
    factor = math.prod(ratios) ** (1 / 3)
    if not plausible and not _PLAUSIBLE[0] <= factor <= _PLAUSIBLE[1]:
        factor = 1.0
    if 1 / _NEAR <= factor <= _NEAR:
        factor = 1.0
    return (usual[0] * factor, usual[1] * factor, usual[2] * factor)


def choose_mass(
    entry: Entry, requirement: AssetRequirement, dimensions: Vec3, density_ratio: float
) -> float:
    """Mass [kg]: prescribed, or the entry's scaled by volume and material.

    An expectation within a factor of two of that is followed, since it carries adjectives ("heavy")
    that the library does not know.
    """
    if requirement.mass_is_prescribed:
        return requirement.expected_mass_kg
    volume = math.prod(b / a for a, b in zip(entry.dimensions_cm, dimensions, strict=True))
    mass = entry.mass_kg * volume * density_ratio
    expected = requirement.expected_mass_kg
    return expected if 0.5 * mass <= expected <= 2.0 * mass else mass
