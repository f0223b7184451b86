"""A whole draft against a whole label: four classes, what was drawn needlessly, what was said.

A prompt is in one class: fully right, main event right (and the rest owned up to), wrong but said,
silent wrong (docs/drafting/scoring.md).
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
import enum
import re
from typing import Any

from benchmarks.drafting.corpus import bind, head_of, words_of
from benchmarks.drafting.events import Told
from benchmarks.drafting.statements import holds
from esg.graph.models import EsgDocument, Predicate
from esg.lexicon.morphology import singular
from esg.lexicon.places import sky_words

_FRAME = frozenset({"a", "an", "at", "day", "during", "in", "on", "sky", "the", "time", "under"})
"""Small words around those that name a light."""

_LATER = frozenset(
    {
        Predicate.FILMED,
        Predicate.FILLED_WITH,
        Predicate.FLOATS,
        Predicate.SINKS,
        Predicate.WEARS,
        Predicate.LOOKS,
        Predicate.LIT,
        Predicate.WEATHER,
        Predicate.SWAYS,
        Predicate.LIES,
        Predicate.WOBBLES,
        Predicate.POSTURE,
        Predicate.GESTURES,
        Predicate.FACES,
        Predicate.GIVES_OFF,
    }
)
"""Of what labels call unsayable: documents hold it since."""
_FUNCTION = _FRAME | frozenset(
    {"and", "from", "her", "his", "is", "its", "of", "shot", "their", "view", "wearing", "with"}
)
"""Words that say nothing by themselves of how a scene is filmed or what is worn."""


class Outcome(str, enum.Enum):
    """Class of a draft; the four shares add up to 100%."""

    FULLY_RIGHT = "fully_right"
    MAIN_RIGHT = "main_event_right"
    SAID = "wrong_but_said"
    SILENT = "silent_wrong"


@dataclass(frozen=True)
class Fault:
    """One thing that is wrong with a draft; `kind` is a word of docs/drafting/scoring.md."""

    kind: str
    what: str


@dataclass(frozen=True)
class Verdict:
    """Of one prompt.

    Args:
        outcome: Class.
        main_right: All events found, none invented.
        says: Whether the draft owns up to anything.
        stand_ins_only: Whether it owns up to nothing but things it drew as stand-ins.
        faults: All that keeps it from being fully right.
        statements: Predicate and whether it is held, of every labelled statement.
        unsayable: Of every phrase that no document can hold, whether the draft names it.
    """

    outcome: Outcome
    main_right: bool
    says: bool
    stand_ins_only: bool
    faults: tuple[Fault, ...]
    statements: tuple[tuple[str, bool], ...]
    unsayable: tuple[bool, ...]


def owned_up(doc: EsgDocument) -> list[tuple[str, str]]:
    """What a draft says that it does not represent: the note, and the words of the prompt."""
    out = [
        (s.note, s.text) for s in doc.statements or () if s.predicate is Predicate.NOT_REPRESENTED
    ]
    warnings = doc.coverage.warnings
    out += [(re.sub(r'"[^"]*"', '"…"', w), " ".join(re.findall(r'"([^"]*)"', w))) for w in warnings]
    out += [
        (i.note or "an event that was not understood", i.text)
        for i in doc.coverage.items
        if i.kind == "event"
        and i.status == "not_understood"
        and not any(f'"{i.text}"' in w for w in warnings)
    ]
    return list(dict.fromkeys((note, words.lower()) for note, words in out))


def judge(
    row: dict[str, Any],
    doc: EsgDocument | None,
    told: Told | None,
    faults: Iterable[Fault],
    said: bool = False,
) -> Verdict:
    """The verdict on one draft.

    Args:
        row: Row of the second edition.
        doc: Draft; None where there is none.
        told: Comparison of its events.
        faults: What is wrong with its validity and quantities.
        said: Without a draft: whether the user was told why (a refusal, no crash).
    """
    found = [*faults]
    notes = owned_up(doc) if doc else []
    statements: tuple[tuple[str, bool], ...] = tuple((s["says"], False) for s in row["statements"])
    if doc and told:
        found += _drawn(doc, row) + _events(doc, row, told)
        statements = tuple(
            (s["says"], holds(doc, s, told.found) or _on_somebody(doc, s))
            for s in row["statements"]
        )
    found += [
        Fault("statement", str(label))
        for label, (_, held) in zip(row["statements"], statements, strict=True)
        if not held
    ]
    held = _words_held(doc)
    unsayable = [w for w in row.get("unsayable", ()) if not (_shown(w) or _held(w, held))]
    found += [Fault("unsayable", words) for words in unsayable]
    says = bool(notes) or (doc is None and said)
    hollow = bool(unsayable) and not row["events"] and not row.get("static")
    main = doc is not None and not hollow
    main = main and not any(f.kind in ("missing", "invented") for f in found)
    if not found:
        outcome = Outcome.FULLY_RIGHT
    elif not says:
        outcome = Outcome.SILENT
    else:
        outcome = Outcome.MAIN_RIGHT if main else Outcome.SAID
    named = tuple(_names(notes, words) for words in unsayable)
    stand_ins = bool(notes) and all("stand-in" in note for note, _ in notes)
    return Verdict(outcome, main, says, stand_ins, tuple(found), statements, named)


def _words_held(doc: EsgDocument | None) -> set[str]:
    """Content words of statements for which labels were written before documents had them.

    Each is measured by the judge. Words that the draft owns up to as well are not held.
    """
    statements = (doc.statements or ()) if doc else ()
    lost = {
        w for s in statements if s.predicate is Predicate.NOT_REPRESENTED for w in _content(s.text)
    }
    return {w for s in statements if s.predicate in _LATER for w in _content(s.text)} - lost


def _held(words: str, held: set[str]) -> bool:
    """Whether all content words of a label are held; one of function words alone is not."""
    content = _content(words)
    return bool(content) and content <= held


def _on_somebody(doc: EsgDocument, label: dict[str, Any]) -> bool:
    """Whether a label of what is attached to somebody is about what he wears."""
    return label["says"] == "attached_to" and _worn(doc, str(label.get("object", "")))


def _worn(doc: EsgDocument, phrase: str) -> bool:
    """Whether somebody wears a thing: labels from before that are of an object of its own."""
    worn = {s.text for s in doc.statements or () if s.predicate is Predicate.WEARS}
    return bool(_content(phrase)) and any(_content(phrase) <= _content(text) for text in worn)


def _content(words: str) -> set[str]:
    """Content words of a phrase."""
    return set(words_of(words)) - _FUNCTION


def _shown(words: str) -> bool:
    """Whether a label's words name nothing but a light that stage `dress` shows ("at sunset").

    The corpus was labelled before scenes had skies.
    """
    left = set(re.findall(r"[a-z]+", words.lower())) - _FRAME
    return bool(left) and left <= sky_words("outdoor")[0]


def _names(notes: list[tuple[str, str]], words: str) -> bool:
    """Whether one of the notes is about a content word of some words of the prompt."""
    wanted = {w for w in words_of(words) if len(w) > 3}
    return any(wanted & set(words_of(text)) for _, text in notes)


def _events(doc: EsgDocument, row: dict[str, Any], told: Told) -> list[Fault]:
    out = [Fault("missing", str(event)) for event in told.missing]
    out += [Fault("invented", f"{n.event.value}{n.participants}") for n in told.invented]
    if row.get("static") and doc.timeline_system:
        edges = doc.timeline_system.sequence_graph.edges
        movers = {e.actor for e in edges if e.params.speed != 0.0 and e.params.posture is None}
        out += [Fault("invented", f"motion of {name}") for name in sorted(movers)]
    return out


def _drawn(doc: EsgDocument, row: dict[str, Any]) -> list[Fault]:
    """Labelled objects that are not there or there twice, and things that nothing asks for."""
    nodes = doc.spatial_relation_graph.nodes
    objects = [item for item in row["objects"] if not _worn(doc, item["phrase"])]
    candidates = [bind(doc, item["phrase"]) for item in objects]
    taken = _assigned(doc, objects, candidates)
    out = [
        Fault("object", f"{item} is there {sum(k == n for k, _ in taken)} times")
        for n, item in enumerate(objects)
        if sum(k == n for k, _ in taken) < item.get("count", 1)
    ]
    used = {name for _, name in taken}
    implied = {name for noun in row.get("implied", ()) for name in bind(doc, noun)}
    absent = {words_of(noun)[-1] for noun in row.get("absent", ()) if words_of(noun)}
    for name, node in nodes.items():
        if not node.mentioned or node.is_structural:
            continue
        what = f'{name} "{node.label}"'
        askers = [
            item
            for item, ids in zip(objects, candidates, strict=True)
            if name in ids and name not in used
        ]
        if head_of(doc, name) in absent and name not in implied:
            out.append(Fault("absent", what))
        elif name in used or name in implied or any(_any_number(i, row["prompt"]) for i in askers):
            continue
        else:
            out.append(Fault("twice" if askers else "spurious", what))
    return out


def _any_number(item: dict[str, Any], prompt: str) -> bool:
    """Whether an object without a count is a plural in its phrase or in the prompt."""
    head = words_of(item["phrase"])[-1]
    tokens = re.findall(r"[a-z0-9]+", f"{item['phrase']} {prompt}".lower())
    return "count" not in item and any(
        t != head and head in (singular(t), *words_of(t)) for t in tokens
    )


def _assigned(
    doc: EsgDocument, objects: list[dict[str, Any]], candidates: list[list[str]]
) -> list[tuple[int, str]]:
    """Gives as many labelled objects as possible nodes of their own (augmenting paths).

    Returns:
        Index of the object and name of its node, for every one that it gets.
    """
    labels = {name: words_of(n.label) for name, n in doc.spatial_relation_graph.nodes.items()}
    owner: dict[str, int] = {}
    # A plural takes one member before anybody's second, so that no count starves a neighbour.
    slots = sorted((k, n) for n, item in enumerate(objects) for k in range(item.get("count", 1)))

    def place(n: int, seen: set[str]) -> bool:
        exact = words_of(objects[n]["phrase"])
        for name in sorted(candidates[n], key=lambda c: labels[c] != exact):
            if name in seen:
                continue
            seen.add(name)
            if name not in owner or place(owner[name], seen):
                owner[name] = n
                return True
        return False

    for _, n in slots:
        place(n, set())
    return [(n, name) for name, n in owner.items()]


def summary(verdicts: list[Verdict]) -> dict[str, Any]:
    """Percentages over the prompts of a split."""

    def percent(part: int, whole: int) -> float:
        return round(100.0 * part / whole, 1) if whole else 100.0

    total = len(verdicts)

    def share(which: Iterable[Verdict]) -> float:
        return percent(len(list(which)), total)

    def faulty(kinds: tuple[str, ...], of: Iterable[Verdict]) -> list[Verdict]:
        return [v for v in of if any(f.kind in kinds for f in v.faults)]

    of = {o: [v for v in verdicts if v.outcome is o] for o in Outcome}
    asked = Counter(says for v in verdicts for says, _ in v.statements)
    held = Counter(says for v in verdicts for says, kept in v.statements if kept)
    kinds = sorted({f.kind for v in verdicts for f in v.faults})
    unsayable = [named for v in verdicts for named in v.unsayable]
    return {
        "prompts": total,
        "classes": {o.value: share(of[o]) for o in Outcome},
        "silent_but_main_event_right": share(v for v in of[Outcome.SILENT] if v.main_right),
        "owns_up_to_stand_ins_alone": share(
            v for v in verdicts if v.stand_ins_only and v.outcome is not Outcome.FULLY_RIGHT
        ),
        "fully_right_but_owns_up": share(v for v in of[Outcome.FULLY_RIGHT] if v.says),
        "spurious": {
            "prompts": share(faulty(("absent", "spurious"), verdicts)),
            "absent": share(faulty(("absent",), verdicts)),
            "unlabelled": share(faulty(("spurious",), verdicts)),
            "by_class": {
                o.value: percent(len(faulty(("absent", "spurious"), of[o])), len(of[o]))
                for o in Outcome
                if of[o]
            },
        },
        "faults": {kind: share(faulty((kind,), verdicts)) for kind in kinds},
        "unsayable_named": percent(sum(unsayable), len(unsayable)),
        "statement_recall": percent(held.total(), asked.total()),
        "statements": {
            says: {"labelled": n, "recall": percent(held[says], n)}
            for says, n in asked.most_common()
        },
    }
