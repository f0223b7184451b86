"""The ablation of drafting: what a language model's drafts are worth with less around it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast, get_args

from esg.ablations.tables import NOT_RUN, Table
from esg.ablations.variants import Ablation
from esg.draft.llm.records import Variant
from esg.graph import EsgDocument, canonical_json
from esg.graph.verifier import verify
from esg.metrics.models import Suite
from esg.outcomes import UserError
from esg.pipeline import SceneRequest, SceneState, run_stage

TITLES = {
    "single_shot": "Single-shot prompt",
    "no_validation": "w/o Validation",
    "full": "Hierarchical + Validation",
}
_UNTIL_LAYOUT = ("draft", "resolve", "cast", "layout")


def draft_table(ablation: Ablation, suite: Suite, seed: int) -> Table:
    """The table of drafting over the prompts of a suite: the model's variants, then the rules.

    Args:
        ablation: The one called draft.
        suite: The suite.
        seed: Of every draft.
    """
    prompts = [scene.prompt for scene in suite.scenes]
    rows: list[tuple[str, ...]] = []
    for variant in TITLES:
        said = ablation.paper[variant]
        rows.append((TITLES[variant], *_of_model(prompts, seed, variant), *said))
    rules = [_ruled(prompt, seed) for prompt in prompts]
    blank = (NOT_RUN,) * len(ablation.paper_columns)
    rows.append(("Rules (no model)", *_rates(rules, seed), "measured", *blank))
    columns = (
        "variant",
        "usability %",
        "high-quality | usable %",
        "model",
        *ablation.paper_columns,
    )
    note = f"{len(prompts)} prompts of {suite.suite}; {ablation.note}"
    return Table(ablation.key, ablation.title, columns, tuple(rows), note)


def _of_model(prompts: Sequence[str], seed: int, variant: str) -> tuple[str, str, str]:
    """Usability, quality and the model's name; why there are none where no model answers."""
    from esg.draft.llm.drafter import draft_llm_batch
    from esg.draft.llm.settings import load_settings

    assert variant in get_args(Variant)
    settings = load_settings()
    if settings.base_url is None and settings.cassette is None:
        return NOT_RUN, NOT_RUN, "needs a language model: none is configured (ESG_LLM_BASE_URL)"
    try:
        drafts = draft_llm_batch(
            prompts, seed=seed, settings=settings, variant=cast("Variant", variant)
        )
    except UserError as error:
        return NOT_RUN, NOT_RUN, str(error).splitlines()[0]
    usability, quality = _rates([draft.document for draft in drafts], seed)
    return usability, quality, settings.model or "as recorded"


def _ruled(prompt: str, seed: int) -> EsgDocument | None:
    from esg.draft import draft

    try:
        return draft(prompt, seed=seed)
    except UserError:
        return None


def _rates(documents: Sequence[EsgDocument | None], seed: int) -> tuple[str, str]:
    """Drafts without a violation, and of those the ones with a layout that keeps everything [%]."""
    usable = [doc for doc in documents if doc is not None and not verify(doc)]
    if not usable:
        return f"{0.0:.1f}", NOT_RUN
    good = sum(_lies_well(doc, seed) for doc in usable)
    return f"{100 * len(usable) / len(documents):.1f}", f"{100 * good / len(usable):.1f}"


def _lies_well(doc: EsgDocument, seed: int) -> bool:
    """Whether a draft has a layout that is feasible with every relation true."""
    from esg.ablations.tables import layout_of

    request = SceneRequest(
        doc.scene_definition.original_description,
        seed,
        document=canonical_json(doc).decode(),
    )
    state = SceneState(request)
    for stage in _UNTIL_LAYOUT:
        state = run_stage(stage, state)
    layout = layout_of(state)
    return bool(layout and layout.feasible and all(r.satisfied for r in layout.relations))
