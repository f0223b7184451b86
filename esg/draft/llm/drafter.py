"""The llm drafter: the paper's layered construction with any OpenAI-compatible model.

Stages: expansion, assets, relations and regions, timeline. Code repairs references, the verifier
checks the whole, and each stage that broke a rule is told so and revises, until every rule holds or
the rounds are spent (docs/drafting_llm.md).
"""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine, Sequence
from dataclasses import replace
import threading
from typing import Any, TypeVar

from esg.draft.llm.client import (
    Call,
    Client,
    EndpointClient,
    ModelFailure,
    PatientClient,
    Reply,
    import_pydantic_ai,
)
from esg.draft.llm.instructions import instructions
from esg.draft.llm.records import STAGES, VARIANTS, CallRecord, LlmDraft, Variant
from esg.draft.llm.session import Session
from esg.draft.llm.settings import LlmSettings, load_settings, require_endpoint
from esg.draft.llm.store import CachingClient, CassetteClient
from esg.draft.said import recorded
from esg.graph.models import EsgDocument
from esg.outcomes import Outcome, UserError

_T = TypeVar("_T")


class _Nobody:
    """Stands for the server when replies only come from a recording."""

    async def complete(self, call: Call) -> Reply:
        raise ModelFailure("refused", f"nobody answers {call.stage}", retryable=False)


def draft_llm(
    prompt: str, *, seed: int = 0, settings: LlmSettings | None = None, variant: Variant = "full"
) -> EsgDocument:
    """Drafts a document with a language model.

    Args:
        prompt: English description of a scene.
        seed: Sent to the model; enters the scene id and the provenance.
        settings: Default: from the environment (ESG_LLM_…).
        variant: "full"; the ablations "no_validation" and "single_shot" return what they got, valid
            or not.

    Returns:
        The document; its provenance records model, rounds, repairs, tokens and cost.

    Raises:
        UserError: If no model is configured or installed, if it cannot be reached (exit code 1), or
            if no draft held the rules.
    """
    result = draft_llm_batch([prompt], seed=seed, settings=settings, variant=variant)[0]
    usable = result.outcome is Outcome.SOLVED or variant != "full"
    if result.document is not None and usable:
        return result.document
    raise UserError(f"The llm drafter has no draft: {result.reason}", 2 if result.calls else 1)


def draft_llm_batch(
    prompts: Sequence[str],
    *,
    seed: int | Sequence[int] = 0,
    settings: LlmSettings | None = None,
    variant: Variant = "full",
    client: Client | None = None,
) -> tuple[LlmDraft, ...]:
    """Drafts many prompts, at most `settings.concurrency` at a time.

    Args:
        prompts: English descriptions.
        seed: As in `draft_llm`; one for all, or one a prompt.
        settings: As in `draft_llm`.
        variant: As in `draft_llm`.
        client: Asked instead of the configured server (tests, other transports).

    Returns:
        One result a prompt, in order, whatever happened to it.

    Raises:
        UserError: If no model is configured or installed.
    """
    if variant not in VARIANTS:
        raise UserError(f"Unknown variant {variant!r}; use one of {', '.join(VARIANTS)}.")
    config = settings or load_settings()
    if client is None and not (config.cassette and config.cassette_mode == "replay"):
        require_endpoint(config)
        import_pydantic_ai()
    seeds = [seed] * len(prompts) if isinstance(seed, int) else seed
    asked = list(zip(prompts, seeds, strict=True))
    return _run(_batch(asked, config, variant, client))


async def _batch(
    asked: list[tuple[str, int]], settings: LlmSettings, variant: Variant, client: Client | None
) -> tuple[LlmDraft, ...]:
    replaying = settings.cassette is not None and settings.cassette_mode == "replay"
    endpoint = EndpointClient(settings) if client is None and not replaying else None
    server: Client = client or endpoint or _Nobody()
    gate = asyncio.Semaphore(settings.concurrency)
    patient = PatientClient(server, settings)
    stack: Client = patient
    if settings.cassette is not None:
        stack = CassetteClient(stack, settings.cassette, settings.cassette_mode, settings.secret)
    if settings.cache is not None:
        stack = CachingClient(stack, settings.cache, settings.secret)

    async def one(prompt: str, seed: int) -> LlmDraft:
        async with gate:
            result = await Session(prompt, seed, settings, variant, stack, patient).run()
        made = result.document
        return result if made is None else replace(result, document=recorded(made))

    try:
        return tuple(await asyncio.gather(*(one(*a) for a in asked)))
    finally:
        if endpoint is not None:
            await endpoint.aclose()


def _run(work: Coroutine[Any, Any, _T]) -> _T:
    """Runs a coroutine to its end, also when the caller is inside an event loop."""
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(work)
    box: list[_T] = []
    errors: list[BaseException] = []

    def target() -> None:
        try:
            box.append(asyncio.run(work))
        except BaseException as error:
            errors.append(error)

    thread = threading.Thread(target=target, name="llm-drafter")
    thread.start()
    thread.join()
    if errors:
        raise errors[0]
    return box[0]


__all__ = [
    "STAGES",
    "VARIANTS",
    "CallRecord",
    "LlmDraft",
    "Variant",
    "draft_llm",
    "draft_llm_batch",
    "instructions",
]
