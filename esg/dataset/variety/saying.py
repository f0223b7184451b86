"""Sentences that say what was drawn beside the action, and what they then mean."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from esg.dataset.variety import tables
from esg.dataset.variety.drawing import Drawn, Look, suited
from esg.dataset.vocabulary import Noun
from esg.graph.models import Predicate
from esg.metrics.models import SuiteConstraint, SuiteEvent, SuiteStatement

if TYPE_CHECKING:
    from esg.dataset.rules import Rule
    from esg.dataset.slots import Values

_ONES = (
    "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
    "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen",
    "nineteen", "twenty",
)  # fmt: skip


@dataclass(frozen=True)
class Told:
    """A whole prompt and its meaning.

    Args:
        prompt: The text.
        events, constraints, statements: What must happen and hold.
        parameters: What was drawn beside the slots, and is said or shown.
    """

    prompt: str
    events: tuple[SuiteEvent, ...]
    constraints: tuple[SuiteConstraint, ...]
    statements: tuple[SuiteStatement, ...]
    parameters: Mapping[str, Any]


def told(rule: Rule, values: Values, drawn: Drawn) -> Told:
    """The prompt of a filled rule with all that was drawn for it."""
    values = dict(values)
    own_color = "color" in values
    if own_color and (color := drawn.looks.get("mover", Look()).color):
        values["color"] = color
    nouns: dict[str, tuple[Noun, Look]] = {}
    for role, look in drawn.looks.items():
        noun = values[role]
        fit = suited(role, noun, look, colored=own_color and role == "mover")
        values[role] = fit.noun(noun)
        nouns[role] = (values[role], fit)
    said = rule.render(values)
    parameters: dict[str, Any] = {}
    if own_color and values["color"]:
        parameters["color"] = values["color"]
    for role, (noun, look) in nouns.items():
        if noun.name in said.prompt:  # some rules have names of their own for what acts
            parameters |= {f"{role}_{k}": v for k, v in vars(look).items() if v}
    count = sum(n for _, n in drawn.crowd)
    parameters |= {k: v for k, v in (("place", drawn.place), ("light", drawn.light)) if v}
    if drawn.camera:
        parameters["camera"] = drawn.camera
    if count:
        parameters["n_bystanders"] = count
        parameters["bystanders"] = ", ".join(f"{n} {kind}" for kind, n in drawn.crowd)
    return Told(
        prompt=_where(drawn) + _begun(said.prompt, drawn) + _around(drawn.crowd),
        events=said.events,
        constraints=said.constraints,
        statements=_counts(drawn.crowd),
        parameters=parameters,
    )


def _where(drawn: Drawn) -> str:
    """When and where it happens, before the sentence."""
    rows, lights = tables.settings(), tables.lights()
    phrases = [lights[drawn.light].phrase] if drawn.light else []
    phrases += [rows[drawn.place].phrase] if drawn.place else []
    text = " ".join(phrases)
    return f"{text[0].upper()}{text[1:]}, " if text else ""


def _begun(prompt: str, drawn: Drawn) -> str:
    return prompt[0].lower() + prompt[1:] if drawn.place or drawn.light else prompt


def _around(crowd: Sequence[tuple[str, int]]) -> str:
    """The sentence about who and what stands around."""
    if not crowd:
        return ""
    groups = [_counted(kind, n) for kind, n in crowd]
    listed = groups[0] if len(groups) == 1 else f"{', '.join(groups[:-1])} and {groups[-1]}"
    verb = "stands" if crowd == ((crowd[0][0], 1),) else "stand"
    return f" {listed[0].upper()}{listed[1:]} {verb} around."


def _counted(kind: str, count: int) -> str:
    if count == 1:
        return Noun(kind).phrase
    word = _ONES[count] if count <= 20 else f"twenty-{_ONES[count - 20]}"
    return f"{word} {tables.bystanders()[kind].plural}"


def _counts(crowd: Sequence[tuple[str, int]]) -> tuple[SuiteStatement, ...]:
    """That so many of each kind are there."""
    return tuple(
        SuiteStatement(
            id=f"s{i}", says=Predicate.COUNT, noun=kind, value=float(count), when="start"
        )
        for i, (kind, count) in enumerate(crowd, start=1)
    )
