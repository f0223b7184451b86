"""Whole drafts are classed by all that their prompts state, and every check of it can fail."""

from __future__ import annotations

from collections.abc import Callable
import json
from pathlib import Path
from typing import Any

import pytest

from benchmarks.drafting import __main__ as command
from benchmarks.drafting import corpus, score_document, score_row
from benchmarks.drafting.events import compare
from benchmarks.drafting.statements import holds
from benchmarks.drafting.whole import Outcome, Verdict, owned_up, summary
from esg.draft import draft
from esg.graph.models import EsgDocument
from esg.outcomes import UserError

Json = dict[str, Any]

FALL = "A ball rolls off a table and hits a vase."
FALL_LABEL: Json = {
    "prompt": FALL,
    "objects": [{"phrase": "ball"}, {"phrase": "table"}, {"phrase": "vase"}],
    "events": [
        {"id": "e1", "type": "falls", "object": "ball"},
        {"id": "e2", "type": "collision", "a": "ball", "b": "vase"},
    ],
    "statements": [{"says": "supported_by", "object": "ball", "target": "table", "when": "start"}],
}


def _row(label: Json = FALL_LABEL, **changes: Any) -> Json:
    base: Json = {"id": "pub-1", "band": "chain", "split": "public", "constraints": []}
    return base | {"statements": [], "events": []} | label | changes


def _with(doc: EsgDocument, *statements: Json) -> EsgDocument:
    """A draft that states more."""
    raw = doc.model_dump(mode="json", by_alias=True)
    words = {"text": "words", "start": 0, "end": 5}
    raw["statements"] = [{"id": f"s{n}"} | words | s for n, s in enumerate(statements)]
    return EsgDocument.model_validate(raw)


def _edited(doc: EsgDocument, change: Callable[[Json], None]) -> EsgDocument:
    raw = doc.model_dump(mode="json", by_alias=True)
    change(raw)
    return EsgDocument.model_validate(raw)


def _verdict(doc: EsgDocument | None, reason: str = "", **changes: Any) -> Verdict:
    (verdict,) = score_document(_row(**changes), doc, reason).verdicts
    return verdict


def _kinds(verdict: Verdict) -> set[str]:
    return {f.kind for f in verdict.faults}


OWNS_UP: dict[str, str] = {"predicate": "not_represented", "note": "manner is not simulated"}
SLOWLY: Json = {"statements": [{"says": "slower_than", "object": "ball"}]}
MORE: Json = {"events": [*FALL_LABEL["events"], {"type": "topples", "object": "vase"}]}


@pytest.mark.parametrize(
    ("changes", "owns_up", "outcome"),
    [
        ({}, False, Outcome.FULLY_RIGHT),
        ({}, True, Outcome.FULLY_RIGHT),
        (SLOWLY, True, Outcome.MAIN_RIGHT),
        (SLOWLY, False, Outcome.SILENT),
        (MORE, True, Outcome.SAID),
        (MORE, False, Outcome.SILENT),
        ({"unsayable": ["hits a vase"]}, True, Outcome.MAIN_RIGHT),
        ({"unsayable": ["hits a vase"]}, False, Outcome.SILENT),
    ],
)
def test_a_draft_is_in_the_class_of_its_worst_fault_and_its_honesty(
    changes: Json, owns_up: bool, outcome: Outcome
) -> None:
    doc = _with(draft(FALL), OWNS_UP) if owns_up else draft(FALL)
    verdict = _verdict(doc, **changes)
    assert verdict.outcome is outcome and verdict.says is owns_up


def test_an_event_that_nobody_can_represent_is_no_main_event_that_is_right() -> None:
    """Water that pours has no labelled event; a still scene has none to get wrong."""
    prompt = "A jug stands near a glass."
    doc = _with(draft(prompt), OWNS_UP)
    label: Json = {"prompt": prompt, "objects": [{"phrase": "jug"}, {"phrase": "glass"}]}
    pours = _row(label, unsayable=["pours water"])
    (moving,) = score_document(pours, doc).verdicts
    (still,) = score_document(pours | {"static": True}, doc).verdicts
    assert (moving.outcome, still.outcome) == (Outcome.SAID, Outcome.MAIN_RIGHT)


@pytest.mark.parametrize(
    ("kind", "changes"),
    [
        ("object", {"objects": [*FALL_LABEL["objects"], {"phrase": "lamp"}]}),
        ("object", {"objects": [{"phrase": "ball", "count": 2}, *FALL_LABEL["objects"][1:]]}),
        ("spurious", {"objects": FALL_LABEL["objects"][:2]}),
        ("absent", {"absent": ["vase"]}),
        ("missing", MORE),
        ("invented", {"events": FALL_LABEL["events"][:1]}),
        ("invented", {"static": True}),
        ("quantity", {"constraints": [{"quantity": "mass", "object": "ball", "value": 2.0}]}),
        ("statement", SLOWLY),
        ("unsayable", {"unsayable": ["rolls"]}),
    ],
)
def test_each_fault_is_seen_alone(kind: str, changes: Json) -> None:
    verdict = _verdict(draft(FALL), **changes)
    assert _kinds(verdict) == {kind} and verdict.outcome is Outcome.SILENT


def test_an_unusable_draft_is_not_right() -> None:
    ghost = {"predicate": "rolls", "object": ["ghost_1"]}
    assert _kinds(_verdict(_with(draft(FALL), ghost))) == {"unusable"}


def test_what_is_implied_or_added_by_expansion_is_not_spurious() -> None:
    few = FALL_LABEL["objects"][:2]
    assert not _verdict(draft(FALL), objects=few, implied=["vase"]).faults

    def unmention(raw: Json) -> None:
        raw["spatial_relation_graph"]["nodes"]["vase_1"]["mentioned"] = False

    assert not _verdict(_edited(draft(FALL), unmention), objects=few).faults


def test_a_thing_that_is_drawn_twice_is_a_fault_unless_a_plural_says_no_number() -> None:
    doc = draft("Two balls lie on a table.")
    one: Json = {"prompt": "", "objects": [{"phrase": "ball"}, {"phrase": "table"}]}
    plural = one | {"objects": [{"phrase": "balls"}, {"phrase": "table"}]}
    two = one | {"objects": [{"phrase": "ball", "count": 2}, {"phrase": "table"}]}
    told = one | {"prompt": "Balls lie on a table."}
    seen = [_kinds(score_document(_row(x), doc).verdicts[0]) for x in (one, plural, told, two)]
    assert seen == [{"twice"}, set(), set(), set()]


def test_every_phrase_gets_a_node_of_its_own() -> None:
    """ "Table" can mean the table lamp, too; with no table there the table is missing."""
    label: Json = {"prompt": "", "objects": [{"phrase": "table"}, {"phrase": "table lamp"}]}
    both = score_document(_row(label), draft("A table lamp stands on a table."))
    lamp = score_document(_row(label), draft("A table lamp stands on the floor."))
    assert not both.verdicts[0].faults
    assert _kinds(lamp.verdicts[0]) == {"object"}


def test_a_verb_read_as_a_thing_is_seen_by_its_head() -> None:
    """The corpus' own example: "can" as a drink can; an opener of cans is none."""
    raw: Json = {"prompt": "", "objects": [{"phrase": "boy"}], "absent": ["can"]}

    def drawn(label: str) -> set[str]:
        def rename(doc: Json) -> None:
            doc["spatial_relation_graph"]["nodes"]["boy_1"]["label"] = label

        doc = _edited(draft("A boy stands on the ground."), rename)
        return _kinds(score_document(_row(raw), doc).verdicts[0])

    assert drawn("boy can") == {"absent"}
    assert not drawn("can boy")


def _still(says: str, target: str, when: str = "throughout") -> Json:
    return {"says": says, "object": "ball", "target": target, "when": when}


@pytest.mark.parametrize(
    ("prompt", "label", "held"),
    [
        ("A ball lies on a table.", _still("supported_by", "table"), True),
        ("A ball lies on a table.", _still("supported_by", "table", "end"), False),
        ("A ball lies on the floor near a table.", _still("on", "table", "start"), False),
        ("A ball lies in a box.", _still("inside", "box"), True),
        ("A ball lies on a box.", _still("inside", "box"), False),
        ("A ball lies to the left of a box.", _still("left_of", "box"), True),
        ("A box lies to the right of a ball.", _still("left_of", "box"), True),
        ("A ball lies to the right of a box.", _still("left_of", "box"), False),
        ("A ball falls into a basket.", _still("ends_in", "basket"), True),
        ("A ball hits a basket.", _still("ends_in", "basket"), False),
        ("A ball misses a box.", _still("never_touches", "box"), True),
        ("A ball hits a box.", _still("never_touches", "box"), False),
        ("A ball hits a box.", _still("touches", "box"), True),
        ("A ball hits a box.", {"says": "moves", "object": "ball", "direction": "toward box"}, True),
        ("A ball hits a box.", {"says": "moves", "object": "ball", "direction": "left"}, False),
        ("A ball hits a box.", {"says": "moves", "object": "box", "direction": "toward ball"}, False),
        ("A ball hits a box.", {"says": "rolls", "object": "ball"}, False),
        ("A ball hits a box.", {"says": "absent", "noun": "tray"}, True),
        ("A ball hits a box.", {"says": "absent", "noun": "box"}, False),
        ("Two balls lie on a box.", {"says": "count", "noun": "balls", "value": 2}, True),
        ("Two balls lie on a box.", {"says": "count", "noun": "balls", "value": 3}, False),
    ],
)  # fmt: skip
def test_what_the_judge_sees_anyway_needs_no_statement(
    prompt: str, label: Json, held: bool
) -> None:
    assert holds(draft(prompt), label, {}) is held


MOVES: Json = {"predicate": "moves", "object": ["ball_1"], "direction": "left"}
OFF: Json = {"predicate": "ends_on", "object": ["ball_1"], "target": ["table_1"]}


@pytest.mark.parametrize(
    ("stated", "label", "held"),
    [
        (MOVES, {"says": "moves", "object": "ball", "direction": "left"}, True),
        (MOVES, {"says": "moves", "object": "ball", "direction": "right"}, False),
        (MOVES, {"says": "moves", "object": "vase", "direction": "left"}, False),
        (MOVES, {"says": "moves", "object": "lamp", "direction": "left"}, False),
        (MOVES, {"says": "moves", "object": "ball", "direction": "left", "when": "end"}, False),
        (MOVES, {"says": "rolls", "object": "ball"}, False),
        (MOVES | {"when": "start..FALL"},
         {"says": "moves", "object": "ball", "direction": "left", "when": "start..e1"}, True),
        (MOVES | {"when": "start..HIT"},
         {"says": "moves", "object": "ball", "direction": "left", "when": "start..e1"}, False),
        (MOVES | {"direction": "past", "target": ["vase_1"]},
         {"says": "moves", "object": "ball", "direction": "past", "target": "vase"}, True),
        (MOVES | {"direction": "past", "target": ["vase_1"]},
         {"says": "moves", "object": "ball", "direction": "past table"}, False),
        (OFF, {"says": "ends_on", "object": "ball", "target": "table"}, True),
        (OFF, {"says": "ends_on", "object": "ball", "target": "vase"}, False),
        (OFF, {"says": "on", "object": "ball", "target": "table", "when": "end"}, True),
        ({"predicate": "same_time", "object": ["HIT", "FALL"]},
         {"says": "same_time", "a": "e1", "b": "e2"}, True),
        (MOVES, {"says": "same_time", "a": "e1", "b": "e2"}, False),
        (MOVES, {"says": "before", "a": "e1", "b": "e2"}, True),
        (MOVES, {"says": "before", "a": "e2", "b": "e1"}, False),
        (MOVES, {"says": "before", "a": "e2", "b": "e9"}, False),
    ],
)  # fmt: skip
def test_a_statement_is_held_by_one_of_the_same_meaning(
    stated: Json, label: Json, held: bool
) -> None:
    """FALL and HIT stand for the ids of the two events in the draft."""
    doc = draft(FALL)
    told = compare(doc, _row())
    ids = json.dumps(stated).replace("FALL", told.found["e1"].id).replace(
        "HIT", told.found["e2"].id
    )  # fmt: skip
    assert holds(_with(doc, json.loads(ids)), label, told.found) is held


def _renamed(event: str, doc: EsgDocument) -> EsgDocument:
    """A draft one of whose collisions is an event that the document's types do not have yet."""
    timeline = doc.timeline_system
    assert timeline
    nodes = tuple(
        n.model_copy(update={"event": type("Event", (), {"value": event})()})
        if n.event.value == "Collision"
        else n
        for n in timeline.sequence_graph.nodes
    )
    graph = timeline.sequence_graph.model_copy(update={"nodes": nodes})
    return doc.model_copy(
        update={"timeline_system": timeline.model_copy(update={"sequence_graph": graph})}
    )


@pytest.mark.parametrize(
    ("event", "type_", "found"),
    [
        ("Bounce", "bounces", True),
        ("PickedUp", "picked_up", True),
        ("Placed", "placed", True),
        ("Open", "opens", True),
        ("Spin", "bounces", False),
        ("Collision", "jumps", False),
    ],
)
def test_new_types_are_found_by_the_beginning_of_their_names(
    event: str, type_: str, found: bool
) -> None:
    doc = _renamed(event, draft("A ball hits a box."))
    label: Json = {"type": type_, "object": "ball", "target": "box"}
    told = compare(doc, _row(events=[label]))
    assert bool(told.found) is found and bool(told.missing) is not found
    elsewhere = compare(doc, _row(events=[label | {"target": "lamp"}]))
    assert not elsewhere.found and elsewhere.invented


def test_new_types_are_inventions_only_where_labels_know_them() -> None:
    doc = _renamed("Bounce", draft("A ball hits a box."))
    row = _row(events=[])
    old = {k: v for k, v in row.items() if k != "statements"}
    assert len(compare(doc, row).invented) == 1 and not compare(doc, old).drafted


def test_the_hit_of_a_bounce_is_no_invention_but_missing_the_bounce_is() -> None:
    label: Json = {"type": "bounces", "object": "ball", "target": "box"}
    told = compare(draft("A ball hits a box."), _row(events=[label]))
    assert not told.invented and told.missing == (label,)


NOTHING = "nothing in the scene stands for it"


def test_notes_warnings_and_lost_events_own_up() -> None:
    assert owned_up(draft(FALL)) == []
    assert owned_up(_with(draft(FALL), OWNS_UP)) == [(OWNS_UP["note"], "words")]
    told = 'The word "…" was not understood.'
    assert owned_up(draft("The can has a dent.")) == [(NOTHING, "dent"), (told, "dent")]

    def lose(raw: Json) -> None:
        item = {"text": "Rolls", "start": 7, "end": 12, "kind": "event"}
        raw["coverage"]["items"] = [item | {"status": "not_understood"}]

    assert owned_up(_edited(draft(FALL), lose)) == [("an event that was not understood", "rolls")]


@pytest.mark.parametrize(
    ("error", "outcome"), [(UserError("no"), Outcome.SAID), (ValueError("?"), Outcome.SILENT)]
)
def test_a_refusal_is_said_and_a_crash_is_not(error: Exception, outcome: Outcome) -> None:
    def fail(prompt: str) -> EsgDocument:
        raise error

    (verdict,) = score_row(_row(), fail).verdicts
    assert verdict.outcome is outcome and not verdict.statements[0][1]


def test_the_classes_add_up_and_unsayable_words_are_looked_for() -> None:
    doc, honest = draft(FALL), _with(draft(FALL), OWNS_UP | {"text": "rolls off"})
    verdicts = [
        _verdict(doc),
        _verdict(honest, unsayable=["rolls", "shining"]),
        _verdict(doc, **MORE),
        _verdict(doc, absent=["vase"], **SLOWLY),
    ]
    out = summary(verdicts)
    assert out["classes"] == {
        "fully_right": 25.0, "main_event_right": 25.0, "wrong_but_said": 0.0, "silent_wrong": 50.0,
    }  # fmt: skip
    assert out["silent_but_main_event_right"] == 25.0
    assert out["owns_up_to_stand_ins_alone"] == 0.0
    stood_in = _verdict(draft("A ball rolls off a table and hits a zorble."))
    assert summary([stood_in])["owns_up_to_stand_ins_alone"] == 100.0
    assert out["spurious"] == {
        "prompts": 25.0,
        "absent": 25.0,
        "unlabelled": 0.0,
        "by_class": {"fully_right": 0.0, "main_event_right": 0.0, "silent_wrong": 50.0},
    }
    assert out["unsayable_named"] == 50.0 and out["statement_recall"] == 75.0
    assert out["statements"]["slower_than"] == {"labelled": 1, "recall": 0.0}


@pytest.fixture
def public(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A corpus of one opened and one held-out prompt."""
    rows = [
        _row(id="pub-001", objects=FALL_LABEL["objects"][:2]),
        _row(
            {
                "prompt": "A cup has a dent.",
                "objects": [{"phrase": "cup"}],
                "statements": [{"says": "rolls", "object": "cup"}],
            },
            id="pub-002",
            split="public_blind",
        ),
    ]
    text = "".join(json.dumps(r) + "\n" for r in rows)
    (tmp_path / "public.jsonl").write_text(text, encoding="utf-8")
    monkeypatch.setattr(corpus, "PROMPTS", tmp_path)
    return tmp_path


def test_the_opened_half_is_shown_and_the_other_only_counted(
    public: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    opened = ["--split", "public", "--no-ablation", "--show", "--json", str(public / "out.json")]
    assert command.main(opened) == 0
    printed = capsys.readouterr().out
    assert "pub-001 silent_wrong |" in printed and 'pub-001 spurious vase_1 "vase" |' in printed
    assert "pub-002" not in printed
    written = json.loads((public / "out.json").read_text(encoding="utf-8"))
    assert written["whole"]["classes"]["silent_wrong"] == 100.0
    assert command.main(["--split", "public_blind", "--no-ablation"]) == 0
    closed = capsys.readouterr().out
    assert "rolls" in closed and "pub-0" not in closed and "dent" not in closed


def test_what_is_still_unsaid_is_listed_by_note(
    public: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ["--split", "public_blind", "--open-held-out", "--no-ablation", "--unsaid", "5"]
    assert command.main([*asked, "--json", str(public / "out.json")]) == 0
    assert '1  The word "…" was not understood.: dent (1)' in capsys.readouterr().out
    written = json.loads((public / "out.json").read_text(encoding="utf-8"))
    assert written["unsaid"][0]["words"] == {"dent": 1}
