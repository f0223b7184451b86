"""What is recorded of a scene's work with a model, and what a stage is told."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass
from typing import Literal

from esg.graph.models import EsgDocument
from esg.graph.rules_events import MAX_SPEED_CM_S, TIME_S
from esg.graph.rules_scene import MASS_KG
from esg.graph.violations import Violation
from esg.outcomes import Outcome

Variant = Literal["full", "no_validation", "single_shot"]
VARIANTS: tuple[Variant, ...] = ("full", "no_validation", "single_shot")
"""The paper's ablation: hierarchical with validation, hierarchical without, one reply."""

STAGES = ("scene", "timeline")
"""The requests of a scene: what is there and where, then what happens."""
UNREADABLE = "UNREADABLE"
MAX_TOLD = 25
"""Violations told to the model at a time."""
_OF_TIMELINE = ("/timeline_system", "/statements")


@dataclass(frozen=True)
class CallRecord:
    """One reply as it came: stage, raw text, tokens, the model's own name, what was sent.

    Tokens are 0 where nobody counted them; `characters_in` are those of instructions, messages and
    schema.
    """

    stage: str
    text: str
    input_tokens: int
    output_tokens: int
    model: str = ""
    characters_in: int = 0


@dataclass(frozen=True)
class LlmDraft:
    """What became of one prompt; there is always an outcome.

    Args:
        prompt: The user's text.
        outcome: SOLVED when the document holds every rule, else INVALID_DRAFT.
        reason: Why there is no valid document; "" if there is one.
        document: The last draft that fits the schema, valid or not; None without any.
        violations: Of that draft.
        rounds: Revisions that were asked for.
        repairs: What code corrected in the replies.
        calls: Raw replies in order.
        input_tokens, output_tokens: Sums over the calls, cached replies included.
        cost_usd: None when the settings name no prices.
        requests: Requests sent to the server, repetitions included.
        waiting: Whether it waits for an answer to a request file.
        told: Codes of what was wrong, told to the model round by round; UNREADABLE for a reply that
            could not be read.
    """

    prompt: str
    outcome: Outcome
    reason: str
    document: EsgDocument | None
    violations: tuple[Violation, ...] = ()
    rounds: int = 0
    repairs: tuple[str, ...] = ()
    calls: tuple[CallRecord, ...] = ()
    input_tokens: int = 0
    output_tokens: int = 0
    cost_usd: float | None = None
    requests: int = 0
    waiting: bool = False
    told: tuple[tuple[str, ...], ...] = ()


def impossible(prompt: str) -> list[str]:
    """Quantities that no scene can have, in words; a model would quietly make them possible."""
    from esg.draft.text.quantities import find_amounts

    problems: list[str] = []
    for a in find_amounts(prompt):
        if a.dimension in ("mass", "length", "time") and a.low < 0.0:
            problems.append(f'"{a.text}" is negative')
        elif a.dimension == "mass" and a.high > MASS_KG[1]:
            problems.append(f'"{a.text}" is more than {MASS_KG[1]:g} kg')
        elif a.dimension == "speed" and a.high > MAX_SPEED_CM_S:
            problems.append(f'"{a.text}" is more than {MAX_SPEED_CM_S / 100:g} m/s')
        elif a.dimension == "time" and a.high > TIME_S[1]:
            problems.append(f'"{a.text}" is more than {TIME_S[1]:g} s')
    return problems


def complaints(violations: tuple[Violation, ...], answered: Container[str]) -> dict[str, str]:
    """What each stage that broke a rule is told, in the order of the stages.

    Args:
        violations: Of the last draft.
        answered: Stages that have answered; a missing timeline is the scene's doing.
    """
    grouped: dict[str, list[Violation]] = {}
    for v in violations:
        late = v.pointer.startswith(_OF_TIMELINE) and "timeline" in answered
        grouped.setdefault("timeline" if late else "scene", []).append(v)
    return {stage: _told(grouped[stage]) for stage in STAGES if stage in grouped}


def _told(violations: list[Violation]) -> str:
    """The complaint about some violations: place, what is wrong, what would satisfy the rule."""
    lines = [f"- {v.pointer}: {v.message} {v.remedy} ({v.code})" for v in violations[:MAX_TOLD]]
    hidden = len(violations) - len(lines)
    more = f"\n- and {hidden} more of the same kind" if hidden > 0 else ""
    return (
        "The document made of your answer breaks these rules (places are of the document):\n"
        + "\n".join(lines)
        + more
        + "\nAnswer again with the whole corrected JSON object."
    )
