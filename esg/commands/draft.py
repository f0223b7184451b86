"""`esg draft`: stage 1 alone."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from esg.commands.drafting import RULES, Drafting
from esg.fidelity import NOT_REPRESENTED

if TYPE_CHECKING:
    from esg.graph.models import EsgDocument, EventConstraint


def draft(
    prompt: str | None = None,
    *,
    prompts: Path | None = None,
    out: Path = Path("drafts"),
    seed: int = 0,
    drafting: Drafting = RULES,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Draft the scene graph of a prompt: the ESG, what became of every word, all violations.

    Args:
        prompt: English description of the scene.
        prompts: File of prompts, as of esg dataset: drafts all of them into --out.
        out: Folder that receives the documents of --prompts, and drafts.jsonl about them.
        seed: Of every random choice.
        json: Print one JSON document: esg, coverage, statements, not_kept, violations.
    """
    from esg.api.inputs import check_seed, checked, clean_prompt
    from esg.commands.drafting import (
        draft_many,
        from_answers,
        tell_waiting,
    )
    from esg.draft import draft as run
    from esg.outcomes import UserError

    if (prompt is None) == (prompts is None):
        raise UserError("give either a prompt or --prompts FILE")
    checked(lambda: check_seed(seed), drafting.check)
    if prompts is not None:
        return draft_many(prompts, out, seed, drafting, json)
    text = clean_prompt(prompt or "")
    found = drafting.gathered([text], [seed])
    if found is not None and found.waiting:
        return tell_waiting(found, json)
    with from_answers(found):
        return _tell(run(text, seed=seed, drafter=drafting.drafter), json)


_ANY_WAY = 0.5
"""Confidence of the heading of what nothing is told of."""
_UNITS = {
    "speed_after": "cm/s", "speed_before": "cm/s", "time_since": "s", "time_to_stop": "s",
    "distance": "cm", "height": "cm", "angle": "degrees",
}  # fmt: skip
"""Units of what point events are to measure."""
_LISTED = 3
"""So many alike things are listed by name, of more the first and the last."""
_SIDES = {"+X": "left", "-X": "right", "+Y": "to the front", "-Y": "to the back"}


def _looks(doc: EsgDocument) -> Iterator[str]:
    """What things are called, what they are drawn as, their colours and materials."""
    alike: dict[str, list[str]] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        if node.is_structural and not node.mentioned:
            continue
        asset = doc.asset_requirement[node.asset_id]
        kind = asset.asset_category.replace("_", " ")
        drawn = kind if kind not in node.label.lower() else None
        told = [f'"{node.label}"', *filter(None, (drawn, asset.color, asset.material))]
        alike.setdefault(", ".join(told), []).append(name)
    for said, names in alike.items():
        who = names if len(names) <= _LISTED else [names[0], "...", names[-1], f"({len(names)})"]
        yield f"object:    {' '.join(who)}  {said}"


def _statements(doc: EsgDocument) -> Iterator[str]:
    """What is stated: of what, toward what, which way, how much, when, by which words."""
    for s in doc.statements or ():
        if s.predicate.value == NOT_REPRESENTED:
            continue  # the block of what is lost has it
        about = ", ".join(filter(None, (" ".join(s.object), " ".join(s.target), s.noun)))
        amount = f"{s.value} {s.quantity or ''}".strip() if s.value is not None else None
        when = s.when if s.when != "throughout" else None
        more = [f" {word}" for word in (s.direction, s.side, amount, when) if word is not None]
        yield f'statement: {s.id}  {s.predicate.value}({about}){"".join(more)}  "{s.text}"'


def _at_the_start(doc: EsgDocument) -> Iterator[str]:
    """What things rest on, how large they are where words say so, and where they head."""
    from esg.draft.lexicon import RANKS, SIZES, STRETCHES, WEIGHTS

    graph = doc.spatial_relation_graph
    sized = {*RANKS, *SIZES, *STRETCHES, *WEIGHTS}
    for name, node in graph.nodes.items():
        region = graph.semantic_regions.get(node.semantic_region or "")
        host = graph.nodes[region.parent_object] if region is not None else None
        if region is not None and host is not None and not host.is_structural:
            inside = "in" if region.region_type.value.startswith("STORAGE") else "on"
            yield f"support:   {name} {inside} {region.parent_object}"
        asset = doc.asset_requirement[node.asset_id]
        said = {*asset.asset_description.split(":")[0].lower().split()} & sized
        stated = asset.dimensions_are_prescribed or asset.mass_is_prescribed
        if said or stated or node.size_is_stated:
            size = " x ".join(f"{x:g}" for x in asset.expected_dimensions_cm)
            yield f"size:      {name} {size} cm, {asset.expected_mass_kg:g} kg"
    for edge in graph.edges.binary_relations:
        if edge.relation_type.value == "face" and edge.confidence > _ANY_WAY:
            way = _SIDES[edge.cardinal] if edge.cardinal else f"to {edge.to}"
            yield f"heading:   {edge.from_} {way}"


def _asked(c: EventConstraint) -> str:
    """What a point event is to measure: "distance to gate_1 20 to 120 cm"."""
    low, high = c.value if isinstance(c.value, tuple) else (c.value, c.value)
    value = f"{low:g}" if low == high else f"{low:g} to {high:g}"
    to = f" to {c.to}" if c.to else f" since {c.since}" if c.since else ""
    return f"{c.quantity}{to} {value} {_UNITS[c.quantity]}"


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
    for line in (*_looks(doc), *_at_the_start(doc)):
        print(line)
    for edge in graph.edges.binary_relations:
        if edge.relation_type.value != "face":
            print(f"relation:  {edge.from_} {edge.relation_type.value} {edge.to}")
    timeline = doc.timeline_system
    for node in timeline.sequence_graph.nodes if timeline else ():
        when = f"at {node.timestamp} s" if node.timestamp is not None else f"in {node.window} s"
        when += "".join(f", {_asked(c)}" for c in node.constraints)
        print(f"event:     {node.id}  {node.event.value}({', '.join(node.participants)}) {when}")
    for segment in timeline.sequence_graph.edges if timeline else ():
        aim = f" to {segment.target}" if segment.target else ""
        print(f"motion:    {segment.id}  {segment.actor} {segment.event.value}{aim}")
    if timeline is None:
        print("no timeline: a static scene")
    rows = [[i.text, i.kind, i.status, i.pointer or i.note] for i in doc.coverage.items]
    if rows:
        print("\n" + table(["words", "kind", "status", "became"], rows))
    for line in _statements(doc):
        print(line)
    print("".join(f"{line}\n" for line in block(lost, "draft")), end="")
    for warning in doc.coverage.warnings:
        print(f"warning:   {warning}")
    for violation in violations:
        print(f"violation: {violation}")
    return 3 if violations else 0
