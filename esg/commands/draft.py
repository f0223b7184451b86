"""`esg draft`: stage 1 alone."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument


def draft(
    prompt: str | None = None,
    *,
    prompts: Path | None = None,
    out: Path = Path("drafts"),
    seed: int = 0,
    drafter: Literal["rules", "llm", "auto"] = "rules",
    llm_batch: Path | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Draft the scene graph of a prompt: the ESG, what became of every word, all violations.

    Args:
        prompt: English description of the scene.
        prompts: File of prompts, as of esg dataset: drafts all of them into --out.
        out: Folder that receives the documents of --prompts, and drafts.jsonl about them.
        seed: Of every random choice.
        drafter: rules needs nothing; llm needs an OpenAI-compatible endpoint; auto asks the model
            if one is configured and answers, else the rules.
        llm_batch: Folder of request files: write what a model is to be asked, end with exit code
            3, go on with the answers that are put beside it (docs/drafting_llm.md).
        json: Print one JSON document: esg, coverage, statements, not_kept, violations.
    """
    from esg.api.inputs import check_seed, checked, clean_prompt
    from esg.commands.drafting import check_batch, draft_many, gathered, tell_problems, tell_waiting
    from esg.draft import draft as run
    from esg.outcomes import UserError

    if (prompt is None) == (prompts is None):
        raise UserError("give either a prompt or --prompts FILE")
    checked(lambda: check_seed(seed), lambda: check_batch(drafter, llm_batch))
    if prompts is not None:
        return draft_many(prompts, out, seed, drafter, llm_batch, json)
    text = clean_prompt(prompt or "")
    found = gathered(drafter, llm_batch, [text], [seed])
    if found is None:
        return _tell(run(text, seed=seed, drafter=drafter), json)
    if found.waiting:
        return tell_waiting(found, json)
    from esg.draft.llm.gathering import replaying

    tell_problems(found)
    with replaying(found.folder):
        return _tell(run(text, seed=seed, drafter=drafter), json)


def _tell(doc: EsgDocument, json: bool) -> int:
    """Prints a draft; returns the exit code."""
    from esg.commands.console import emit, table
    from esg.fidelity import block, shortfalls, statement_rows
    from esg.graph import canonical_json, verify

    violations = verify(doc)
    data = doc.model_dump(mode="json", by_alias=True)
    statements = statement_rows(data)
    lost = shortfalls(data, statements)
    if json:
        import json as codec

        esg = codec.loads(canonical_json(doc))
        emit(
            {
                "esg": esg,
                "coverage": data["coverage"],
                "statements": statements,
                "not_kept": lost,
                "violations": [v.to_json() for v in violations],
            }
        )
        return 3 if violations else 0
    graph = doc.spatial_relation_graph
    print(f"scene {doc.scene_definition.scene_id}")
    print("objects:   " + ", ".join(graph.nodes))
    for edge in graph.edges.binary_relations:
        print(f"relation:  {edge.from_} {edge.relation_type.value} {edge.to}")
    timeline = doc.timeline_system
    for node in timeline.sequence_graph.nodes if timeline else ():
        when = f"at {node.timestamp} s" if node.timestamp is not None else f"in {node.window} s"
        print(f"event:     {node.id}  {node.event.value}({', '.join(node.participants)}) {when}")
    for segment in timeline.sequence_graph.edges if timeline else ():
        print(f"motion:    {segment.id}  {segment.actor} {segment.event.value}")
    if timeline is None:
        print("no timeline: a static scene")
    rows = [[i.text, i.kind, i.status, i.pointer or i.note] for i in doc.coverage.items]
    if rows:
        print("\n" + table(["words", "kind", "status", "became"], rows))
    for row in statements:
        print(f'statement: {row["id"]}  {row["says"]}  "{row["words"]}"')
    print("".join(f"{line}\n" for line in block(lost, "draft")), end="")
    for warning in doc.coverage.warnings:
        print(f"warning:   {warning}")
    for violation in violations:
        print(f"violation: {violation}")
    return 3 if violations else 0
