"""Coverage of a prompt by a document that a language model drafted.

The model's word for what it covered is not taken: the shallow analysis of the rules drafter says
which nouns, events and quantities the prompt has, and the document is searched for each of them.
"""

from __future__ import annotations

from functools import lru_cache
import re

from esg.draft.llm.names import slug
from esg.draft.llm.words.unheld import heads
from esg.draft.rules import draft_rules
from esg.graph.models import Coverage, CoverageItem, EsgDocument, Predicate, Quantity
from esg.graph.violations import pointer
from esg.lexicon.morphology import singular
from esg.outcomes import UserError

TOLERANCE = 0.02
_PRONOUNS = frozenset(
    ("it", "they", "them", "he", "him", "she", "her", "this", "that", "these", "those", "one",
     "ones", "both")
)  # fmt: skip


@lru_cache(maxsize=16)
def read_by_rules(prompt: str) -> EsgDocument | None:
    """The rules drafter's document of a prompt; None where it gives up."""
    try:
        return draft_rules(prompt)
    except UserError:
        return None


def cover(prompt: str, doc: EsgDocument) -> Coverage:
    """Where each noun, event and quantity of the prompt went; a warning for each that is absent."""
    rules = read_by_rules(prompt)
    items = [*_objects(prompt, doc, rules), *_quantities(prompt, doc)]
    items += _events(prompt, doc, rules) if rules is not None else []
    items = [_owned(i, doc) for i in items]
    items.sort(key=lambda i: (i.start, i.end, i.kind))
    missed = [i for i in items if i.status == "not_understood"]
    warnings = [f'The {i.kind} "{i.text}" is not in the draft.' for i in missed]
    return Coverage(items=tuple(items), warnings=tuple(dict.fromkeys(warnings)))


def _owned(item: CoverageItem, doc: EsgDocument) -> CoverageItem:
    """An absent word as ignored, where a statement says of it that it is not represented."""
    if item.status != "not_understood":
        return item
    for s in doc.statements or ():
        if s.predicate is Predicate.NOT_REPRESENTED and s.start <= item.start and item.end <= s.end:
            return item.model_copy(update={"status": "ignored", "note": s.note})
    return item


def _item(prompt: str, start: int, end: int, kind: str, where: str) -> CoverageItem:
    return CoverageItem.model_validate(
        {
            "text": prompt[start:end],
            "start": start,
            "end": end,
            "kind": kind,
            "status": "used" if where else "not_understood",
            "pointer": where,
        }
    )


def _objects(prompt: str, doc: EsgDocument, rules: EsgDocument | None) -> list[CoverageItem]:
    """Finds each mentioned node by its label, category or name; a phrase is counted once."""
    found: dict[tuple[int, int], str] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        asset = doc.asset_requirement.get(node.asset_id)
        texts = [node.label, re.sub(r"_\d+$", "", name), asset.asset_category if asset else ""]
        for text in texts:
            words = [w for w in slug(text).split("_") if w and text]
            if not words:
                continue
            pattern = r"[\s\-]*".join(map(re.escape, words))
            match = re.search(rf"\b{pattern}(?:e?s)?\b", prompt, re.IGNORECASE)
            if match is None and len(words) > 1:
                match = re.search(rf"\b{re.escape(words[-1])}(?:e?s)?\b", prompt, re.IGNORECASE)
            if match is not None:
                where = pointer("spatial_relation_graph", "nodes", name)
                found.setdefault(match.span(), where)
                break
    items = [_item(prompt, *span, "object", where) for span, where in found.items()]
    called = heads(doc)
    for i in _rules_objects(rules) if rules is not None else ():
        if any(a < i.end and i.start < b for a, b in found):
            continue
        words = prompt[i.start : i.end].lower().split()
        if words[-1] in _PRONOUNS:
            continue  # it stands for something that is told by its name
        again = (w for (a, b), w in found.items() if prompt[a:b].lower().split()[-1] == words[-1])
        named = (n for n, nouns in called.items() if singular(words[-1].strip(".,;:!?")) in nouns)
        meant = (pointer("spatial_relation_graph", "nodes", n) for n in named)
        items.append(_item(prompt, i.start, i.end, "object", next(again, "") or next(meant, "")))
    return items


def _rules_objects(rules: EsgDocument) -> list[CoverageItem]:
    """Nouns that the rules drafter recognizes, but for those that it owns up to: see `unheld`."""
    lost = [s for s in rules.statements or () if s.predicate is Predicate.NOT_REPRESENTED]
    return [
        i
        for i in rules.coverage.items
        if i.kind == "object"
        and i.status in ("used", "not_understood")
        and not any(s.start <= i.start and i.end <= s.end for s in lost)
    ]


_SEGMENTS = {
    "motion": frozenset(
        {"UniformMotion", "Toward", "AcceleratedMotion", "Turn", "Guide", "Release"}
    ),
    "acceleration": frozenset({"AcceleratedMotion"}),
    "braking": frozenset({"Brake"}),
}
"""Segments by what the rules drafter notes of a verb that became no point event."""


def _events(prompt: str, doc: EsgDocument, rules: EsgDocument) -> list[CoverageItem]:
    """Compares the kinds of events that the rules drafter reads with those of the document."""
    graph = doc.timeline_system.sequence_graph if doc.timeline_system else None
    items: list[CoverageItem] = []
    for i in rules.coverage.items:
        if i.kind != "event" or i.status == "not_understood":
            continue  # a verb that the rules drafter does not know says nothing here
        kinds = _kinds_of(rules, i.note)
        if not kinds:
            continue
        where = ""
        for part in ("nodes", "edges") if graph is not None else ():
            for k, candidate in enumerate(getattr(graph, part)):
                if not where and candidate.event.value in kinds:
                    where = pointer("timeline_system", "sequence_graph", part, k)
        items.append(_item(prompt, i.start, i.end, "event", where))
    return items


def _kinds_of(doc: EsgDocument, note: str) -> frozenset[str]:
    """The kinds of events or segments that the rules drafter made of a verb; none for a state."""
    nodes = doc.timeline_system.sequence_graph.nodes if doc.timeline_system else ()
    kind = next((n.event.value for n in nodes if n.id == note), "")
    return frozenset({kind}) if kind else _SEGMENTS.get(note, frozenset())


def _quantities(prompt: str, doc: EsgDocument) -> list[CoverageItem]:
    """Searches the document for every physical quantity of the prompt, in document units."""
    from esg.draft.text.quantities import find_amounts

    values = list(_values(doc))
    items: list[CoverageItem] = []
    for amount in find_amounts(prompt):
        where = next(
            (
                at
                for dimension, value, at in values
                if dimension == amount.dimension and _same(value, (amount.low, amount.high))
            ),
            "",
        )
        items.append(_item(prompt, amount.start, amount.end, "quantity", where))
    return items


def _same(value: Quantity, wanted: tuple[float, float]) -> bool:
    low, high = value if isinstance(value, tuple) else (value, value)
    return all(
        abs(a - b) <= TOLERANCE * max(abs(b), 1e-9)
        for a, b in zip((low, high), wanted, strict=True)
    )


def _values(doc: EsgDocument) -> list[tuple[str, Quantity, str]]:
    """(dimension, value, pointer) of every number that a prompt may state."""
    out: list[tuple[str, Quantity, str]] = []
    for name, asset in doc.asset_requirement.items():
        base = pointer("asset_requirement", name)
        out.append(("mass", asset.expected_mass_kg, f"{base}/expected_mass_kg"))
        for k, size in enumerate(asset.expected_dimensions_cm):
            out.append(("length", size, f"{base}/expected_dimensions_cm/{k}"))
    for k, edge in enumerate(doc.spatial_relation_graph.edges.binary_relations):
        if edge.distance_cm is not None:
            base = pointer("spatial_relation_graph", "edges", "binary_relations", k, "distance_cm")
            out.append(("length", edge.distance_cm, base))
    if doc.timeline_system is None:
        return out
    graph = doc.timeline_system.sequence_graph
    kinds = {"speed": "speed", "time": "time", "distance": "length", "height": "length"}
    for k, node in enumerate(graph.nodes):
        base = pointer("timeline_system", "sequence_graph", "nodes", k)
        if node.timestamp is not None:
            out.append(("time", node.timestamp, f"{base}/timestamp"))
        if node.window is not None:
            out.append(("time", node.window, f"{base}/window"))
        if node.turn_degrees is not None:
            out.append(("angle", node.turn_degrees, f"{base}/turn_degrees"))
        for j, c in enumerate(node.constraints):
            dimension = kinds.get(c.quantity.partition("_")[0], "angle")
            out.append((dimension, c.value, f"{base}/constraints/{j}"))
    for k, edge in enumerate(graph.edges):
        base = pointer("timeline_system", "sequence_graph", "edges", k, "params")
        for name, dimension in (
            ("speed", "speed"),
            ("acceleration", "acceleration"),
            ("duration", "time"),
            ("turn_degrees", "angle"),
            ("elevation_deg", "angle"),
        ):
            value = getattr(edge.params, name)
            if value is not None:
                out.append((dimension, value, f"{base}/{name}"))
    return out
