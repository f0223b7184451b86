"""The scene grammar: English prompts with known expectations, drawn with controlled distributions.

A rule (esg.dataset.rules) has slots (mover, target, speed, mass, time, count, wording) and says
what the filled sentence means: the events that must happen and the numbers that were stated. That
meaning is written as a suite scene, so that a sampled scene is judged by what its sentence says,
never by what the pipeline read into it.

Sampling is by unit: unit u of seed s is the same whatever the size of the dataset, so a larger
dataset begins with the smaller one. Levels and rules are dealt out by low-discrepancy sequences
(additive recurrences), so that their shares hold to within a scene or two at any size; the slots of
a unit come from its own random generator.

A counterfactual pair is a unit rendered twice with one slot changed (mass, speed or target): same
wording, same seed, same family, and so the same split.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from esg.dataset.rules import RULES, Rule
from esg.dataset.sentences import Rendered
from esg.dataset.slots import Values
from esg.metrics.models import SuiteScene
from esg.outcomes import UserError
from esg.strangers.yamlfile import read_yaml

GRAMMAR_VERSION = 1
LEVELS = ("single", "chain", "multi_phase")
CHANGEABLE = ("mass", "speed", "target")
"""Slots that a counterfactual changes."""

_GOLDEN = 0.6180339887498949
_SILVER = 0.41421356237309515
_MAX_SEED = 2**31 - 1


class Distribution(BaseModel):
    """What sampled scenes are like; shares need not add up to one.

    Args:
        levels: Share of every level; a level that is not named does not occur.
        rules: Weight of rules within their level, by name; the others keep theirs.
        quantified: Probability that an optional number is stated.
        speeds: Which third of a noun's range of speeds, by share: slow, medium, fast.
        movers: Only these movers, where a rule has one of them.
        max_count: Largest number of objects of a set (pins, balls in a chain).
    """

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    levels: dict[str, float] = Field(
        default_factory=lambda: {"single": 0.5, "chain": 0.3, "multi_phase": 0.2}
    )
    rules: dict[str, float] = Field(default_factory=dict)
    quantified: float = Field(default=0.4, ge=0.0, le=1.0)
    speeds: dict[str, float] = Field(
        default_factory=lambda: {"slow": 1.0, "medium": 1.0, "fast": 1.0}
    )
    movers: tuple[str, ...] = ()
    max_count: int = Field(default=10, ge=3, le=20)

    @model_validator(mode="after")
    def _names_are_known(self) -> Distribution:
        known_rules = {r.name for r in RULES}
        _check_shares("levels", self.levels, LEVELS)
        _check_shares("speeds", self.speeds, ("slow", "medium", "fast"))
        _check_shares("rules", self.rules, sorted(known_rules), zero_ok=True)
        movers = {n.name for r in RULES for n in r.movers}
        unknown = sorted(set(self.movers) - movers)
        if unknown:
            raise ValueError(
                f"movers {unknown} are unknown; choose from {', '.join(sorted(movers))}"
            )
        for level, share in self.levels.items():
            if share > 0 and not self.weights(level):
                raise ValueError(f"no rule of level {level!r} is left")
        return self

    def weights(self, level: str) -> dict[str, float]:
        """Weight of every rule of a level that may occur, by name."""
        out: dict[str, float] = {}
        for rule in RULES:
            weight = self.rules.get(rule.name, rule.weight)
            usable = not self.movers or any(n.name in self.movers for n in rule.movers)
            if rule.level == level and weight > 0 and usable:
                out[rule.name] = weight
        return out


def _check_shares(
    field: str, shares: Mapping[str, float], known: Sequence[str], zero_ok: bool = False
) -> None:
    unknown = sorted(set(shares) - set(known))
    if unknown:
        raise ValueError(f"{field}: {unknown} are unknown; choose from {', '.join(known)}")
    if any(v < 0 for v in shares.values()) or (not zero_ok and sum(shares.values()) <= 0):
        raise ValueError(f"{field}: shares must not be negative, and one must be positive")


def load_distribution(text: str, name: str = "distribution") -> Distribution:
    """Reads a distribution from YAML (or JSON).

    Raises:
        UserError: Listing every problem.
    """
    data, mistakes = read_yaml(text)
    if mistakes:
        lines = [f"  {m.place}: {m.what}; {m.remedy}" for m in mistakes]
        raise UserError("\n".join([f"{name} cannot be read:", *lines]))
    if not isinstance(data, dict):
        raise UserError(f"{name} must hold a mapping: {', '.join(Distribution.model_fields)}")
    try:
        return Distribution.model_validate(data)
    except ValidationError as error:
        lines = [
            f"  {'.'.join(map(str, e['loc'])) or 'distribution'}: {e['msg']} (got {e['input']!r})"
            for e in error.errors(include_url=False)
        ]
        raise UserError("\n".join([f"{name}: {len(lines)} problems", *lines])) from None


@dataclass(frozen=True)
class SampledScene:
    """One sentence of the grammar and what it means.

    Args:
        prompt: The sentence.
        seed: Seed of the scene; both scenes of a pair have the same.
        rule: Name of the rule.
        level: single, chain or multi_phase.
        family: Rule and mover: what a counterfactual never changes. Splits go by it.
        values: The slots, as text or numbers.
        expectation: What must happen, without an id.
        unit: Number of the unit; both scenes of a pair have the same.
        changed: Slot that this scene changes of its base; empty for a base.
    """

    prompt: str
    seed: int
    rule: str
    level: str
    family: str
    values: Mapping[str, Any]
    expectation: SuiteScene
    unit: int
    changed: str = ""


def sample_scenes(
    n: int,
    seed: int,
    distribution: Distribution | None = None,
    *,
    counterfactual: bool = False,
) -> Iterator[SampledScene]:
    """The first `n` scenes of a seed.

    Args:
        n: Number of scenes.
        seed: Non-negative.
        distribution: What they are like.
        counterfactual: Every unit gives two scenes: a base and one with one slot changed.

    Returns:
        Scenes in order; of a pair the base comes first.
    """
    chosen = distribution or Distribution()
    unit = given = 0
    while given < n:
        for scene in _unit(unit, seed, chosen, counterfactual):
            if given < n:
                yield scene
                given += 1
        unit += 1


def _unit(unit: int, seed: int, given: Distribution, pair: bool) -> list[SampledScene]:
    offset = np.random.default_rng([seed, 1 << 40]).random(2)
    level = _dealt(given.levels, (offset[0] + unit * _GOLDEN) % 1.0)
    by_name = given.weights(level)
    rule = next(r for r in RULES if r.name == _dealt(by_name, (offset[1] + unit * _SILVER) % 1.0))
    rng = np.random.default_rng([seed, unit])
    scene_seed = int(rng.integers(_MAX_SEED))
    values = draw(rule, rng, given, must_change=pair)
    out = [_scene(rule, values, scene_seed, unit, "")]
    if pair:
        slot, other = changed(rule, values, rng)
        out.append(_scene(rule, other, scene_seed, unit, slot))
    return out


def _dealt(shares: Mapping[str, float], place: float) -> str:
    """The key at a place in [0, 1) of the cumulated shares."""
    left = place * sum(shares.values())
    for name, share in shares.items():
        if left < share:
            return name
        left -= share
    return next(name for name in reversed(list(shares)) if shares[name] > 0)


def draw(
    rule: Rule, rng: np.random.Generator, given: Distribution, *, must_change: bool = False
) -> Values:
    """Fills the slots of a rule.

    Args:
        rule: The rule.
        rng: Of this unit.
        given: The distribution.
        must_change: Whether at least one changeable slot has to be filled.
    """
    values: Values = {}
    for slot in rule.slots:
        if slot.optional and rng.random() >= given.quantified:
            continue
        value = slot.draw(rng, values, given)
        if value is not None:
            values[slot.name] = value
    if must_change and not any(s in values for s in CHANGEABLE):
        for slot in rule.slots:
            if slot.name in CHANGEABLE:
                value = slot.draw(rng, values, given)
                if value is not None:
                    values[slot.name] = value
                    break
    return values


def changed(rule: Rule, values: Values, rng: np.random.Generator) -> tuple[str, Values]:
    """The same values with one changeable slot changed, chosen at random, and the slot's name."""
    slots = {s.name: s for s in rule.slots}
    order = [s for s in CHANGEABLE if s in values]
    rng.shuffle(order)
    for name in order:
        other = slots[name].other(rng, values)
        if other is not None:
            return name, {**values, name: other}
    raise ValueError(f"rule {rule.name!r} has no slot that can change")


def _scene(rule: Rule, values: Values, seed: int, unit: int, slot: str) -> SampledScene:
    said: Rendered = rule.render(values)
    return SampledScene(
        prompt=said.prompt,
        seed=seed,
        rule=rule.name,
        level=rule.level,
        family=f"{rule.name}: {values['mover'].name}",
        values={k: getattr(v, "name", v) for k, v in values.items()},
        expectation=SuiteScene(
            id="scene",
            prompt=said.prompt,
            level=rule.level,
            events=said.events,
            constraints=said.constraints,
        ),
        unit=unit,
        changed=slot,
    )
