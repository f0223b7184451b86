"""What sampled scenes are like: declared shares, checked (docs/dataset/variety.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
import re
from typing import Any

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    SerializerFunctionWrapHandler,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_serializer,
    model_validator,
)

from esg.dataset.rules import RULES
from esg.dataset.variety import tables
from esg.dataset.variety.tables import UNSAID
from esg.outcomes import UserError
from esg.strangers.yamlfile import read_yaml

LEVELS = ("single", "chain", "multi_phase")
MOST_OBJECTS = 30
"""Of a scene, bystanders and all."""
MOST_BYSTANDERS = 28


class Distribution(BaseModel):
    """What sampled scenes are like; shares need not add up to one.

    Args:
        levels: Share of every level; a level that is not named does not occur.
        rules: Weight of rules within their level, by name; the others keep theirs.
        quantified: Probability that an optional number is stated.
        speeds: Which third of a noun's range of speeds, by share: slow, medium, fast.
        movers: Only these movers, where a rule has one of them.
        max_count: Largest number of objects of a set (pins, balls in a chain).
        places: Share of every place that a sentence names; `unsaid` names none.
        lights: The same of the time of day and the weather.
        colors, materials, sizes: The same of what is said of the things that act.
        variants: Probability that a thing is another one of its sort: an armchair, not a chair.
        bystanders: Share of every number (`4`) or range (`5-12`) of things that stand around.
        bystander_kinds: Weight of what they are; default all kinds alike.
        cameras: Share of every way to film a scene; a rendered dataset follows it.
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
    places: dict[str, float] = Field(default_factory=dict)
    lights: dict[str, float] = Field(default_factory=dict)
    colors: dict[str, float] = Field(default_factory=dict)
    materials: dict[str, float] = Field(default_factory=dict)
    sizes: dict[str, float] = Field(default_factory=dict)
    variants: float = Field(default=0.0, ge=0.0, le=1.0)
    bystanders: dict[str, float] = Field(default_factory=dict)
    bystander_kinds: dict[str, float] = Field(default_factory=dict)
    cameras: dict[str, float] = Field(default_factory=dict)

    @field_validator("bystanders", mode="before")
    @classmethod
    def _numbers_are_texts(cls, value: Any) -> Any:
        return {str(k): v for k, v in value.items()} if isinstance(value, Mapping) else value

    @field_validator(
        "levels", "rules", "speeds", "places", "lights", "colors", "materials", "sizes",
        "bystander_kinds", "cameras",
    )  # fmt: skip
    @classmethod
    def _shares_are_shares(cls, value: dict[str, float], info: ValidationInfo) -> dict[str, float]:
        field = str(info.field_name)
        known = _KNOWN[field]()
        unknown = sorted(set(value) - set(known))
        problems = [f"{unknown} are unknown; choose from {', '.join(known)}"] if unknown else []
        problems += _share_problems(
            value, zero_ok=field == "rules" or not (value or field in _NEEDED)
        )
        if problems:
            raise ValueError("; ".join(problems))
        return value

    @field_validator("bystanders")
    @classmethod
    def _numbers_are_few(cls, value: dict[str, float]) -> dict[str, float]:
        wrong = [text for text in value if not _range(text)]
        problems = [
            f"{wrong} are no numbers or ranges from 0 to {MOST_BYSTANDERS}, such as 4 or 5-12"
        ] * bool(wrong)
        problems += _share_problems(value, zero_ok=not value)
        if problems:
            raise ValueError("; ".join(problems))
        return value

    @field_validator("movers")
    @classmethod
    def _movers_are_known(cls, value: tuple[str, ...]) -> tuple[str, ...]:
        known = sorted({n.name for r in RULES for n in r.movers})
        unknown = sorted(set(value) - set(known))
        if unknown:
            raise ValueError(f"{unknown} are unknown; choose from {', '.join(known)}")
        return value

    @model_validator(mode="after")
    def _every_level_has_a_rule(self) -> Distribution:
        for level, share in self.levels.items():
            if share > 0 and not self.weights(level):
                raise ValueError(f"no rule of level {level!r} is left")
        return self

    @model_serializer(mode="wrap")
    def _without_what_is_not_asked(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Variety that nobody asks for leaves no trace in plans, names and hashes."""
        return {k: v for k, v in handler(self).items() if v or k not in VARIETY}

    def weights(self, level: str) -> dict[str, float]:
        """Weight of every rule of a level that may occur, by name."""
        out: dict[str, float] = {}
        for rule in RULES:
            weight = self.rules.get(rule.name, rule.weight)
            usable = not self.movers or any(n.name in self.movers for n in rule.movers)
            if rule.level == level and weight > 0 and usable:
                out[rule.name] = weight
        return out

    @property
    def crowds(self) -> dict[tuple[int, int], float]:
        """Share of every range of bystanders, ends included."""
        return {_range(text): share for text, share in self.bystanders.items()}  # type: ignore[misc]  # checked above


VARIETY = (
    "places", "lights", "colors", "materials", "sizes", "variants", "bystanders",
    "bystander_kinds", "cameras",
)  # fmt: skip
"""Fields that ask for nothing by default."""

_KNOWN: dict[str, Callable[[], Sequence[str]]] = {
    "levels": lambda: LEVELS,
    "rules": lambda: sorted(r.name for r in RULES),
    "speeds": lambda: ("slow", "medium", "fast"),
    "places": lambda: (*tables.settings(), UNSAID),
    "lights": lambda: (*tables.lights(), UNSAID),
    "colors": lambda: (*tables.COLORS, UNSAID),
    "materials": lambda: (*tables.materials(), UNSAID),
    "sizes": lambda: (*tables.SIZES, UNSAID),
    "bystander_kinds": lambda: tuple(tables.bystanders()),
    "cameras": lambda: tables.CAMERAS,
}
"""Names that a field knows."""
_NEEDED = ("levels", "speeds")
"""Shares without which nothing can be drawn."""


def _share_problems(shares: Mapping[str, float], *, zero_ok: bool) -> list[str]:
    problems: list[str] = []
    negative = sorted(name for name, share in shares.items() if share < 0)
    if negative:
        problems.append(f"shares must not be negative: {negative}")
    elif not zero_ok and sum(shares.values()) <= 0:
        problems.append("one share must be positive")
    return problems


def _range(text: str) -> tuple[int, int] | None:
    found = re.fullmatch(r"(\d{1,2})(?:\s*-\s*(\d{1,2}))?", text.strip())
    if found is None:
        return None
    low = int(found[1])
    high = int(found[2] or low)
    return (low, high) if low <= high <= MOST_BYSTANDERS else None


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
            f"  {'.'.join(map(str, e['loc'])) or 'distribution'}: "
            f"{e['msg'].removeprefix('Value error, ')} (got {e['input']!r:.200})"
            for e in error.errors(include_url=False)
        ]
        count = "1 problem" if len(lines) == 1 else f"{len(lines)} problems"
        raise UserError("\n".join([f"{name}: {count}", *lines])) from None
