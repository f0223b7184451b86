"""What is in an open vessel: its region, its weight, and what carries if it is firm."""

from __future__ import annotations

import math
from typing import Any

from esg.assets.geometry.massprops import mass_properties
from esg.graph.floating import ROUND, is_round
from esg.graph.models import AssetConfiguration, AssetRequirement, NamedRegion, Proxy, ProxyKind
from esg.lexicon.contents import CONTENT, contents


def content_of(config: AssetConfiguration) -> NamedRegion | None:
    """The region that what is in a vessel takes up, None of an empty one."""
    return next((r for r in config.regions if r.kind == CONTENT), None)


def is_open(config: AssetConfiguration) -> bool:
    """Whether something can be in it."""
    return any(r.kind == "inside" for r in config.regions)


def filled(config: AssetConfiguration, requirement: AssetRequirement) -> AssetConfiguration:
    """The configuration of a vessel with what the requirement says is in it.

    What it weighs is added where no mass is prescribed. What is loose carries: a proxy reaches up
    to its level, and the vessel is open above it. A vessel without an inside stays empty.
    """
    told = requirement.contents
    mouth = next((r for r in config.regions if r.kind == "inside"), None)
    if told is None or mouth is None or content_of(config) is not None:
        return config
    row = contents()[told.name]
    (x, y, z), (hx, hy, hz) = mouth.center_cm, mouth.half_extents_cm
    bottom, depth = z - hz, 2.0 * hz * told.share
    wide = tuple(
        min(ROUND * h, 0.5 * d) for h, d in zip((hx, hy), config.dimensions_cm[:2], strict=True)
    )
    level = NamedRegion(
        name=told.name,
        kind=CONTENT,
        center_cm=(x, y, bottom + 0.5 * depth),
        half_extents_cm=(wide[0], wide[1], 0.5 * depth),
    )
    body = _body(level, is_round(config, mouth), mouth)
    regions = [r for r in config.regions if r is not mouth]
    changes: dict[str, Any] = {"contents": told}
    low = bottom if row.liquid else bottom + depth
    high = bottom + 2.0 * hz + min(hx, hy)  # what floats or lies in it looks out over the rim
    mouth = mouth.model_copy(
        update={
            "center_cm": (x, y, 0.5 * (low + high)),
            "half_extents_cm": (hx, hy, 0.5 * (high - low)),
        }
    )
    if not row.liquid:
        changes["proxies"] = (*config.proxies, body)
    changes["regions"] = (mouth, *regions, level)
    if not requirement.mass_is_prescribed:
        changes |= _weighed(config, body, row.density)
    return config.model_copy(update=changes)


def _body(level: NamedRegion, turned: bool, mouth: NamedRegion) -> Proxy:
    hx, hy, _ = mouth.half_extents_cm
    hz = level.half_extents_cm[2]
    if turned:
        radius = ROUND * min(hx, hy)
        return Proxy(
            kind=ProxyKind.CYLINDER, size_cm=(radius, radius, hz), position_cm=level.center_cm
        )
    return Proxy(kind=ProxyKind.BOX, size_cm=(hx, hy, hz), position_cm=level.center_cm)


def _weighed(config: AssetConfiguration, body: Proxy, density: float) -> dict[str, Any]:
    """Mass, centre of mass and inertia of a vessel with what is in it."""
    a, b, c = body.size_cm
    volume = 2.0 * c * (math.pi * a * a if body.kind is ProxyKind.CYLINDER else 4.0 * a * b)
    mass = density * 1e-6 * volume
    com, inertia = mass_properties([body], mass)
    whole = config.mass_kg + mass
    middle = tuple(
        (config.mass_kg * p + mass * q) / whole
        for p, q in zip(config.center_of_mass_cm, com, strict=True)
    )
    parts = (
        (config.mass_kg, config.center_of_mass_cm, config.inertia_kg_cm2),
        (mass, com, inertia),
    )
    total = [0.0] * 6
    for m, at, own in parts:
        x, y, z = (p - q for p, q in zip(at, middle, strict=True))
        shift = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
        total = [t + o + m * s for t, o, s in zip(total, own, shift, strict=True)]
    return {
        "mass_kg": whole,
        "center_of_mass_cm": middle,
        "inertia_kg_cm2": tuple(total),
    }
