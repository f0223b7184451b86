"""The drafter `auto`: the model where one is configured and answers, the rules otherwise.

Where both have a draft the rules verify: whoever hits whom by one reading only is named in a
warning of the coverage. A model that fails never fails a scene.
"""

from __future__ import annotations

from esg.draft.llm.client import import_pydantic_ai
from esg.draft.llm.drafter import draft_llm
from esg.draft.llm.settings import LlmSettings, load_settings, require_endpoint
from esg.draft.rules import draft_rules
from esg.graph.models import EsgDocument, NodeEvent
from esg.lexicon.morphology import singular
from esg.outcomes import UserError

_HITS = (NodeEvent.COLLISION,)


def chosen(settings: LlmSettings | None = None) -> tuple[str, str]:
    """Which drafter `auto` asks, and why: ("llm", the model) or ("rules", what is missing).

    Args:
        settings: Default: from the environment.
    """
    try:
        config = settings or load_settings()
        if config.cassette is not None and config.cassette_mode == "replay":
            return "llm", f"recorded replies in {config.cassette}"
        require_endpoint(config)
        import_pydantic_ai()
    except UserError as error:
        return "rules", str(error)
    return "llm", f"{config.model} at {config.place}"


def draft_auto(prompt: str, *, seed: int = 0) -> EsgDocument:
    """Drafts a document with the model if there is one, else by the rules.

    Args:
        prompt: English description of a scene.
        seed: As of the drafter that is asked.

    Returns:
        The document; its provenance names the drafter, its warnings a failure of the model and
        whatever the two readings disagree on.

    Raises:
        UserError: If the model has no draft and the rules refuse the prompt.
    """
    if chosen()[0] == "rules":
        return draft_rules(prompt, seed=seed)
    try:
        doc = draft_llm(prompt, seed=seed)
    except UserError as error:
        told = f"The language model gave no draft, the rules did: {error}"
        return _warned(draft_rules(prompt, seed=seed), (told,))
    return compared(doc, seed=seed)


def compared(doc: EsgDocument, *, seed: int = 0) -> EsgDocument:
    """A model's draft with a warning for each hit that only it or only the rules read.

    Args:
        doc: The model's draft.
        seed: As of the draft.
    """
    try:
        other = draft_rules(doc.scene_definition.original_description, seed=seed)
    except UserError:
        return doc
    return _warned(doc, disagreements(doc, other))


def disagreements(doc: EsgDocument, rules: EsgDocument) -> tuple[str, ...]:
    """Who hits whom by one of two readings of a prompt only, in words.

    Args:
        doc: The model's draft.
        rules: The rules drafter's.
    """
    ours, theirs = _hits(doc), _hits(rules)
    out = [f"The rules read a hit of {_pair(p)}; the model has none." for p in theirs - ours]
    out += [f"The model has a hit of {_pair(p)}; the rules read none." for p in ours - theirs]
    return tuple(sorted(out))


def _pair(names: frozenset[str]) -> str:
    ordered = sorted(names)
    return " and ".join(f'"{n}"' for n in ordered) if len(ordered) == 2 else f'two "{ordered[0]}"'


def _hits(doc: EsgDocument) -> set[frozenset[str]]:
    """Pairs of nouns that meet: the two drafts name their nodes differently."""
    timeline = doc.timeline_system
    points = timeline.sequence_graph.nodes if timeline is not None else ()
    return {
        frozenset(_noun(doc, p) for p in n.participants)
        for n in points
        if n.event in _HITS and len(n.participants) == 2
    }


def _noun(doc: EsgDocument, name: str) -> str:
    node = doc.spatial_relation_graph.nodes.get(name)
    words = (node.label if node is not None else "").lower().split() or name.split("_")
    return next((singular(w) for w in reversed(words) if len(w) > 1 and w.isalpha()), name)


def _warned(doc: EsgDocument, warnings: tuple[str, ...]) -> EsgDocument:
    coverage = doc.coverage.model_copy(update={"warnings": (*doc.coverage.warnings, *warnings)})
    return doc.model_copy(update={"coverage": coverage}) if warnings else doc
