"""The slots of the scene grammar: what fills them, and what else could (docs/dataset.md)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from esg.dataset.vocabulary import Noun

if TYPE_CHECKING:
    import numpy as np

    from esg.dataset.distribution import Distribution

Values = dict[str, Any]


@dataclass(frozen=True)
class Slot:
    """A place to fill.

    Args:
        name: mover, target, speed, mass, time, count or wording.
        draw: Value for the values drawn before it, None if nothing fits.
        other: A different value for a finished scene, None if there is none.
        optional: Whether sentences may leave it out.
    """

    name: str
    draw: Callable[[np.random.Generator, Values, Distribution], Any]
    other: Callable[[np.random.Generator, Values], Any]
    optional: bool = False


def _pick(rng: np.random.Generator, items: Any) -> Any:
    return items[int(rng.integers(len(items)))]


def mover_slot(nouns: tuple[Noun, ...]) -> Slot:
    """The noun that moves."""

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> Noun:
        allowed = [n for n in nouns if not given.movers or n.name in given.movers]
        return _pick(rng, allowed)

    return Slot("mover", draw, lambda rng, values: None)


def noun_slot(name: str, nouns: tuple[Noun, ...]) -> Slot:
    """A noun that shares no head with the nouns before it: two crates could not be told apart."""

    def fitting(values: Values) -> list[Noun]:
        taken = {v.name.split()[-1] for k, v in values.items() if isinstance(v, Noun) and k != name}
        return [n for n in nouns if n.name.split()[-1] not in taken]

    def other(rng: np.random.Generator, values: Values) -> Noun | None:
        left = [n for n in fitting(values) if n != values[name]]
        return _pick(rng, left) if left else None

    return Slot(name, lambda rng, values, given: _pick(rng, fitting(values)), other)


def adjective_slot(name: str, nouns: tuple[Noun, ...]) -> Slot:
    """A noun whose adjective tells it apart: balls of other colours."""

    def other(rng: np.random.Generator, values: Values) -> Noun | None:
        return _pick(rng, [n for n in nouns if n != values[name]])

    return Slot(name, lambda rng, values, given: _pick(rng, nouns), other)


def speed_slot(optional: bool = True) -> Slot:
    """A speed of the mover in half metres a second."""

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float | None:
        limits = values["mover"].speeds_mps
        if limits is None:
            return None
        thirds = ("slow", "medium", "fast")
        shares = [given.speeds.get(t, 0.0) for t in thirds]
        third = int(rng.choice(3, p=[s / sum(shares) for s in shares]))
        low, high = limits
        return _half(low + (high - low) * (third + rng.random()) / 3)

    def other(rng: np.random.Generator, values: Values) -> float | None:
        """A speed at least a third of the range away."""
        low, high = values["mover"].speeds_mps
        now, step = values["speed"], (high - low) / 3
        options = [
            v for v in (0.5 * k for k in range(round(2 * low), round(2 * high) + 1))
            if abs(v - now) >= step
        ]  # fmt: skip
        return _pick(rng, options) if options else None

    return Slot("speed", draw, other, optional)


def mass_slot() -> Slot:
    """A mass of the mover."""

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float | None:
        masses = values["mover"].masses_kg
        return _pick(rng, masses) if masses else None

    def other(rng: np.random.Generator, values: Values) -> float | None:
        left = [m for m in values["mover"].masses_kg if m != values["mass"]]
        return _pick(rng, left) if left else None

    return Slot("mass", draw, other, optional=True)


def time_slot(low: float, high: float, optional: bool = True) -> Slot:
    """A time in half seconds, or tenths if the range is short."""
    step = 0.5 if high - low >= 1.0 else 0.1

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> float:
        return round(low + step * int(rng.integers(round((high - low) / step) + 1)), 3)

    return Slot("time", draw, lambda rng, values: None, optional)


def choice_slot(name: str, *options: Any) -> Slot:
    """One of some values; never changed."""
    return Slot(name, lambda rng, values, given: _pick(rng, options), lambda rng, values: None)


def count_slot(*options: int) -> Slot:
    """A number of objects."""

    def draw(rng: np.random.Generator, values: Values, given: Distribution) -> int:
        return _pick(rng, [n for n in options if n <= given.max_count] or options[:1])

    return Slot("count", draw, lambda rng, values: None)


def _half(value: float) -> float:
    return round(2 * value) / 2
