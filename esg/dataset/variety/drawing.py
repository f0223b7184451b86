"""What is drawn for a scene besides its action: one draw a unit, apart from the slots' own.

Places, lights, crowds and cameras are dealt by additive recurrences of their own, as levels and
rules are (esg.dataset.grammar): the square roots of primes are rationally independent, so that all
shares hold together, and each within the others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from esg.dataset.variety import tables
from esg.dataset.variety.tables import UNSAID
from esg.dataset.vocabulary import VEHICLES, Noun

if TYPE_CHECKING:
    from esg.dataset.distribution import Distribution

_STEPS = {"places": 3, "lights": 7, "crowds": 11, "cameras": 13}
_OFFSETS, _LOOKS, _CROWDS = 1 << 41, 1 << 42, 1 << 43
"""Keep the generators of different draws apart."""
ROLES = ("mover", "middle", "item", "target")
"""Slots that hold things."""
_ONLY_COLORS = ("middle", "item")
"""What passes a push on keeps its mass: heavier, it would stop it."""
MOST_KINDS = 3
"""Of bystanders in one scene."""


@dataclass(frozen=True)
class Look:
    """What is said of a thing; empty fields are not said.

    Args:
        variant: The thing that takes its place.
        size, color, material: Adjectives.
    """

    variant: str = ""
    size: str = ""
    color: str = ""
    material: str = ""

    def noun(self, noun: Noun) -> Noun:
        """The noun with its adjectives, in their English order."""
        row = tables.looks().get(noun.name)
        name = self.variant or noun.name
        if self.material and row is not None:
            name = f"{self.material} {row.head}"
        words = [w for w in (self.size, self.color) if w]
        return Noun(" ".join([*words, name]), noun.speeds_mps, noun.masses_kg)


@dataclass(frozen=True)
class Drawn:
    """What was drawn for the scenes of a unit.

    Args:
        place: Row of the table of settings; empty: not said.
        light: Row of the table of lights; empty: not said.
        crowd: Kind and number of bystanders.
        camera: How to film it; empty: as the dataset is filmed.
        looks: By slot.
    """

    place: str = ""
    light: str = ""
    crowd: tuple[tuple[str, int], ...] = ()
    camera: str = ""
    looks: Mapping[str, Look] = field(default_factory=dict)


NOTHING = Drawn()


def dealt(shares: Mapping[Any, float], place: float) -> Any:
    """The key at a place in [0, 1) of the cumulated shares."""
    left = place * sum(shares.values())
    for name, share in shares.items():
        if left < share:
            return name
        left -= share
    return next(name for name in reversed(list(shares)) if shares[name] > 0)


def draw_variety(
    seed: int, unit: int, given: Distribution, where: str, sides: Sequence[Mapping[str, Any]]
) -> Drawn:
    """What a unit's scenes say and show beside their action.

    Args:
        seed: Of the dataset.
        unit: Number of the unit.
        given: The distribution.
        where: What the rule needs of a place (`esg.dataset.rules.Rule`).
        sides: Slots of its scenes, two for a counterfactual pair.
    """
    place = _place(seed, unit, given, where)
    under = tables.settings()[place].under if place else _UNDER[where]
    return Drawn(
        place=place,
        light=_light(seed, unit, given, under),
        crowd=_crowd(seed, unit, given, under, sides),
        camera=_camera(seed, unit, given, sides),
        looks=_looks(seed, unit, given, sides),
    )


_UNDER = {
    "street": "outdoor", "vehicles": "outdoor", "floor": "either", "table": "either",
    "indoors": "indoor", "hall": "indoor",
}  # fmt: skip
"""Where a rule is whose place is not said: `either` has the lights of both, as the place is chosen
by what is there."""


def _spot(seed: int, unit: int, what: str) -> float:
    """Where the unit is in [0, 1) of some shares."""
    prime = _STEPS[what]
    offset = float(np.random.default_rng([seed, _OFFSETS, prime]).random())
    return (offset + unit * math.sqrt(prime)) % 1.0


def _place(seed: int, unit: int, given: Distribution, where: str) -> str:
    rows = tables.settings()
    fitting = {
        name: share
        for name, share in given.places.items()
        if share > 0 and (name == UNSAID or where in rows[name].suits)
    }
    return _said(fitting, _spot(seed, unit, "places"))


def _light(seed: int, unit: int, given: Distribution, under: str) -> str:
    rows = tables.lights()
    fitting = {
        name: share
        for name, share in given.lights.items()
        if share > 0
        and (
            name == UNSAID
            or under in rows[name].under
            or (under == "either" and len(rows[name].under) == 2)
        )
    }
    return _said(fitting, _spot(seed, unit, "lights"))


def _said(shares: Mapping[str, float], spot: float) -> str:
    name = dealt(shares, spot) if shares else UNSAID
    return "" if name == UNSAID else name


def _camera(seed: int, unit: int, given: Distribution, sides: Sequence[Mapping[str, Any]]) -> str:
    """A way to film; nobody rides on what is no vehicle."""
    driven = sides[0]["mover"] in VEHICLES
    shares = {k: v for k, v in given.cameras.items() if v > 0 and (driven or k != "dash")}
    return dealt(shares, _spot(seed, unit, "cameras")) if shares else ""


def _heads(sides: Sequence[Mapping[str, Any]]) -> set[str]:
    nouns = [v.name for values in sides for v in values.values() if isinstance(v, Noun)]
    nouns += [v for n in nouns if n in tables.looks() for v in tables.looks()[n].variants]
    return {name.split()[-1] for name in nouns}


def _crowd(
    seed: int, unit: int, given: Distribution, under: str, sides: Sequence[Mapping[str, Any]]
) -> tuple[tuple[str, int], ...]:
    """Kinds and numbers of bystanders; none is of the kind of what acts."""
    from esg.dataset.distribution import MOST_OBJECTS

    if not given.crowds:
        return ()
    low, high = dealt(given.crowds, _spot(seed, unit, "crowds"))
    rng = np.random.default_rng([seed, unit, _CROWDS])
    acting = max(_acting(values) for values in sides)
    count = min(int(rng.integers(low, high + 1)), MOST_OBJECTS - acting)
    taken = _heads(sides)
    weights = {
        row.kind: weight
        for row in tables.bystanders().values()
        if ("outdoor" if under == "either" else under) in row.suits
        and not any(row.kind.endswith(head) or head.endswith(row.kind) for head in taken)
        and (weight := given.bystander_kinds.get(row.kind, 0.0 if given.bystander_kinds else 1.0))
    }
    if count <= 0 or not weights:
        return ()
    kinds = min(count, len(weights), 1 + int(rng.integers(MOST_KINDS)))
    total = sum(weights.values())
    chosen = rng.choice(
        sorted(weights), kinds, replace=False, p=[weights[k] / total for k in sorted(weights)]
    )
    parts = 1 + rng.multinomial(count - kinds, [1 / kinds] * kinds)
    return tuple((str(kind), int(n)) for kind, n in zip(chosen, parts, strict=True))


def _acting(values: Mapping[str, Any]) -> int:
    """How many things a filled rule names at most: rules with two of a kind have one noun."""
    return 1 + sum(isinstance(v, Noun) for v in values.values()) + int(values.get("count", 0))


def _looks(
    seed: int, unit: int, given: Distribution, sides: Sequence[Mapping[str, Any]]
) -> dict[str, Look]:
    """Looks by slot, drawn before they are known to suit: of a pair both sides draw the same."""
    if not (given.colors or given.materials or given.sizes or given.variants):
        return {}
    out: dict[str, Look] = {}
    for number, role in enumerate(ROLES):
        if role not in sides[0]:
            continue
        rng = np.random.default_rng([seed, unit, _LOOKS, number])
        pick = rng.random(5)
        nouns = [values[role].name for values in sides]
        out[role] = Look(
            variant=_variant(nouns, given.variants, pick[:2], _heads(sides)),
            size=_said(given.sizes, pick[2]),
            color=_said(given.colors, pick[3]),
            material=_said(given.materials, pick[4]),
        )
    return out


def _variant(nouns: Sequence[str], share: float, pick: Any, taken: set[str]) -> str:
    row = tables.looks().get(nouns[0])
    if row is None or not row.variants or pick[0] >= share or len(set(nouns)) > 1:
        return ""
    own = set(row.variants) | set(nouns)
    others = taken - {name.split()[-1] for name in own}
    free = [v for v in row.variants if v.split()[-1] not in others]
    return free[int(pick[1] * len(free))] if free else ""


def suited(role: str, noun: Noun, look: Look, *, colored: bool) -> Look:
    """What of a look can be said of a noun.

    Args:
        role: Its slot.
        noun: The noun.
        look: What was drawn.
        colored: Whether the sentence has a word for its colour already.
    """
    row = tables.looks().get(noun.name)
    if row is None:
        return Look()
    passes_on = role in _ONLY_COLORS
    return Look(
        variant="" if passes_on else look.variant,
        size=look.size if row.sizes and not passes_on else "",
        color=look.color if row.colors and not colored else "",
        material=(
            look.material
            if look.material in row.materials and not passes_on and not look.variant
            else ""
        ),
    )
