"""Stage 1: an English prompt becomes an ESG draft (docs/drafting.md)."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument

DRAFTERS = ("rules", "llm", "auto")


def draft(prompt: str, *, seed: int = 0, drafter: str = "rules") -> EsgDocument:
    """Drafts the ESG document of a prompt.

    Args:
        prompt: English description of a scene, up to 20,000 characters.
        seed: Enters the scene id and provenance.
        drafter: "rules" (embedded default), "llm" (needs a configured model) or "auto" (the model
            if one is configured and answers, else the rules).

    Returns:
        The document with assets required, spatial graph, timeline (None if nothing moves) and the
        coverage record; pose, asset and dynamics fields are empty.

    Raises:
        UserError: If the prompt cannot be drafted, with what to change.
    """
    if drafter == "rules":
        from esg.draft.rules import draft_rules as run
    elif drafter == "llm":
        from esg.draft.llm.drafter import draft_llm as run
    elif drafter == "auto":
        from esg.draft.llm.auto import draft_auto as run
    else:
        from esg.outcomes import UserError

        raise UserError(f"Unknown drafter {drafter!r}; use one of {', '.join(DRAFTERS)}.")
    from esg.draft.said import recorded

    return recorded(run(prompt, seed=seed))
