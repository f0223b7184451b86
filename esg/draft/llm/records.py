"""What is recorded of a scene's work with a model, and what a stage is told."""

from __future__ import annotations

from collections.abc import Container
from dataclasses import dataclass
from importlib import resources
from typing import Literal

from esg.graph.models import EsgDocument
from esg.graph.rules_events import MAX_SPEED_CM_S, TIME_S
from esg.graph.rules_scene import MASS_KG
from esg.graph.violations import Violation
from esg.outcomes import Outcome

Variant = Literal["full", "no_validation", "single_shot"]
VARIANTS: tuple[Variant, ...] = ("full", "no_validation", "single_shot")
"""The paper's ablation: hierarchical with validation, hierarchical without, one reply."""

STAGES = ("expansion", "assets", "spatial", "timeline")
MAX_TOLD = 25
"""Violations told to the model at a time."""

_OWNERS = (
    ("/asset_requirement", "assets"),
    ("/spatial_relation_graph/nodes", "assets"),
    ("/spatial_relation_graph", "spatial"),
    ("/timeline_system", "timeline"),
    ("/scene_definition", "expansion"),
)
_SPATIAL_CODES = ("REGION_MISSING", "REF_REGION", "FACE_MISSING", "REGION_CYCLE")


@dataclass(frozen=True)
class CallRecord:
    """One reply as it came: stage, raw text, tokens."""

    stage: str
    text: str
    input_tokens: int
    output_tokens: int


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


def instructions(stage: str) -> str:
    """Instructions of a stage: the shared part and the stage's own."""
    folder = resources.files("esg.draft") / "prompts"
    shared = (folder / "shared.md").read_text(encoding="utf-8")
    if stage == "single_shot":
        parts = [(folder / f"{s}.md").read_text(encoding="utf-8") for s in STAGES]
        own = (folder / "single_shot.md").read_text(encoding="utf-8")
        return "\n\n".join([shared, own, *parts])
    return shared + "\n\n" + (folder / f"{stage}.md").read_text(encoding="utf-8")


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
        answered: Stages that have answered; a missing timeline is the expansion's doing.
    """
    grouped: dict[str, list[Violation]] = {}
    for v in violations:
        owner = next((s for prefix, s in _OWNERS if v.pointer.startswith(prefix)), "spatial")
        if v.code in _SPATIAL_CODES:
            owner = "spatial"
        if owner == "timeline" and "timeline" not in answered:
            owner = "expansion"
        grouped.setdefault(owner, []).append(v)
    out: dict[str, str] = {}
    for stage in STAGES:
        if stage not in grouped:
            continue
        lines = [f"- {v.message} {v.remedy} ({v.code})" for v in grouped[stage][:MAX_TOLD]]
        hidden = len(grouped[stage]) - len(lines)
        more = f"\n- and {hidden} more of the same kind" if hidden > 0 else ""
        out[stage] = (
            "Your answer breaks these rules:\n"
            + "\n".join(lines)
            + more
            + "\nAnswer again with the whole corrected JSON object."
        )
    return out
