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
wording, same seed, same family, and so the same split; and the same place, light and bystanders
(esg.dataset.variety).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Any

import numpy as np

from esg.dataset.distribution import Distribution
from esg.dataset.rules import RULES, Rule
from esg.dataset.slots import Values
from esg.dataset.variety.drawing import Drawn, dealt, draw_variety
from esg.dataset.variety.saying import told
from esg.metrics.models import SuiteScene

GRAMMAR_VERSION = 1
CHANGEABLE = ("mass", "speed", "target")
"""Slots that a counterfactual changes."""

_GOLDEN = 0.6180339887498949
_SILVER = 0.41421356237309515
_MAX_SEED = 2**31 - 1


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
        camera: How to film it; empty: as the dataset is filmed.
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
    camera: str = ""


def sample_scenes(
    n: int,
    seed: int,
    distribution: Distribution | None = None,
    *,
    counterfactual: bool = False,
    first: int = 0,
) -> Iterator[SampledScene]:
    """Scenes of a seed; those before the first are not drawn.

    Args:
        n: Number of scenes.
        seed: Non-negative.
        distribution: What they are like.
        counterfactual: Every unit gives two scenes: a base and one with one slot changed.
        first: Number of the first.

    Returns:
        Scenes in order; of a pair the base comes first.
    """
    chosen = distribution or Distribution()
    sides = 2 if counterfactual else 1
    units = range(first // sides, -(-(first + n) // sides))
    drawn = (scene for unit in units for scene in _unit(unit, seed, chosen, counterfactual))
    return islice(drawn, first % sides, first % sides + n)


def _unit(unit: int, seed: int, given: Distribution, pair: bool) -> list[SampledScene]:
    offset = np.random.default_rng([seed, 1 << 40]).random(2)
    level = dealt(given.levels, (offset[0] + unit * _GOLDEN) % 1.0)
    by_name = given.weights(level)
    rule = next(r for r in RULES if r.name == dealt(by_name, (offset[1] + unit * _SILVER) % 1.0))
    rng = np.random.default_rng([seed, unit])
    scene_seed = int(rng.integers(_MAX_SEED))
    values = draw(rule, rng, given, must_change=pair)
    sides = [("", values)]
    if pair:
        sides.append(changed(rule, values, rng))
    drawn = draw_variety(seed, unit, given, rule.where, [v for _, v in sides])
    return [_scene(rule, v, scene_seed, unit, slot, drawn) for slot, v in sides]


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


def _scene(
    rule: Rule, values: Values, seed: int, unit: int, slot: str, drawn: Drawn
) -> SampledScene:
    said = told(rule, values, drawn)
    return SampledScene(
        prompt=said.prompt,
        seed=seed,
        rule=rule.name,
        level=rule.level,
        family=f"{rule.name}: {values['mover'].name}",
        values={**{k: getattr(v, "name", v) for k, v in values.items()}, **said.parameters},
        expectation=SuiteScene(
            id="scene",
            prompt=said.prompt,
            level=rule.level,
            events=said.events,
            constraints=said.constraints,
            statements=said.statements,
        ),
        unit=unit,
        changed=slot,
        camera=drawn.camera,
    )
