"""A second reading of the prompt, by a dependency parse, that asks what the draft left out.

The drafter is never sure of what it did not see. Here the sentence is taken apart once more,
without its lexicon and frames; what both readings agree on is kept, and what the parse states and
the document does not account for is owned up to (docs/drafting/audit.md).
"""

from __future__ import annotations

from esg.draft.audit.case import Case, Finding
from esg.draft.audit.checks import audit
from esg.draft.audit.facts import facts_of
from esg.draft.audit.parse import Proposition, nouns, propositions
from esg.draft.text.tagging import parsed
from esg.graph.models import Coverage, EsgDocument, Predicate, Statement


def case_of(
    text: str, doc: EsgDocument, coverage: Coverage, statements: tuple[Statement, ...] | None
) -> Case | None:
    """Both readings of a text; None without a parser.

    Args:
        text: What the drafter read.
        doc: What it made of it.
        coverage: Where the words went, with places in the text.
        statements: What it states, with places in the text.
    """
    tree = parsed(text)
    if tree is None:
        return None
    facts = facts_of(doc, coverage, statements or ())
    used = [(i.start, i.end) for i in coverage.items if i.kind == "event" and i.status == "used"]

    def agreed(p: Proposition) -> bool:
        seen = any(start <= p.start < end or p.start <= start < p.end for start, end in used)
        happens = not (p.negated or p.unreal or p.how == "purpose")
        return seen and happens and not facts.owns_up(p.start, p.end)

    said = tuple(propositions(tree))
    told = tuple(p for p in said if agreed(p))
    return Case(text, facts, told, tuple(nouns(tree)), said)


def owned_up(
    text: str, doc: EsgDocument, coverage: Coverage, statements: tuple[Statement, ...] | None
) -> tuple[Statement, ...]:
    """What the document does not hold, as statements that are not represented.

    Args:
        text: What the drafter read.
        doc: What it made of it.
        coverage: Where the words went, with places in the text.
        statements: What it states, with places in the text.
    """
    case = case_of(text, doc, coverage, statements)
    found = audit(case) if case is not None else []
    first = len(statements or ()) + 1
    return tuple(_statement(text, f, k) for k, f in enumerate(_once(found), first))


def _once(found: list[Finding]) -> list[Finding]:
    """Each of the words once."""
    kept: list[Finding] = []
    for f in found:
        if not any(k.start < f.end and f.start < k.end for k in kept):
            kept.append(f)
    return kept


def _statement(text: str, f: Finding, number: int) -> Statement:
    return Statement(
        id=f"s{number}",
        predicate=Predicate.NOT_REPRESENTED,
        text=text[f.start : f.end],
        start=f.start,
        end=f.end,
        object=f.nodes,
        note=f.missing,
    )
