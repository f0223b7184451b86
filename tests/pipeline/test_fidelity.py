"""What a scene keeps of its prompt, by its document and its verdicts alone."""

from __future__ import annotations

from typing import Any

import pytest

from esg.draft import draft
from esg.fidelity import (
    fully_understood,
    lost_in,
    most_unseen,
    sentence,
    share_kept,
    shortfalls,
    stand_ins,
    statement_rows,
    unplaced,
    unsettled,
)

PROMPT = "The ball on the table flies straight up and wags."


def said(words: str, predicate: str = "supported_by", **more: Any) -> dict[str, Any]:
    start = PROMPT.index(words)
    return {
        "id": words.replace(" ", "_"),
        "predicate": predicate,
        "text": words,
        "start": start,
        "end": start + len(words),
        **more,
    }


def verb(words: str, status: str = "not_understood", **more: Any) -> dict[str, Any]:
    place = {k: said(words)[k] for k in ("text", "start", "end")}
    return {**place, "kind": "event", "status": status, **more}


def document(*statements: dict[str, Any], verbs: tuple[dict[str, Any], ...] = ()) -> dict[str, Any]:
    return {"statements": list(statements), "coverage": {"items": list(verbs)}}


def verdict(words: str, kept: bool | None, reason: str = "", **measured: float) -> dict[str, Any]:
    name = words.replace(" ", "_")
    return {"id": name, "says": "supported_by", "kept": kept, "reason": reason,
            "measured": measured}  # fmt: skip


UP = said("straight up", "not_represented", note="no path that rises")
TABLE = said("on the table")


def test_every_statement_has_one_row_whatever_the_judge_returns() -> None:
    doc = document(TABLE, UP)
    assert [r["status"] for r in statement_rows(doc)] == ["not_judged", "not_represented"]
    unmeasured = statement_rows(doc, [])
    assert [r["status"] for r in unmeasured] == ["not_represented", "not_represented"]
    assert unmeasured[0]["reason"] == "nothing measures it"
    rows = statement_rows(doc, [verdict("on the table", True, share=1.0)])
    assert rows[0] == {
        "id": "on_the_table", "says": "supported_by", "words": "on the table", "start": 9,
        "end": 21, "status": "kept", "kept": True, "measured": {"share": 1.0}, "reason": "",
    }  # fmt: skip
    assert rows[1]["kept"] is None and rows[1]["reason"] == "no path that rises"


def test_a_document_without_statements_has_no_rows() -> None:
    assert statement_rows({"statements": None}, []) == statement_rows({}) == []
    assert share_kept([]) is None and fully_understood({})


def test_shortfalls_come_in_the_order_of_the_prompt_with_their_reasons() -> None:
    doc = document(UP, TABLE, verbs=(verb("wags"), verb("flies", "used")))
    rows = statement_rows(doc, [verdict("on the table", False, "0 of 95% of the samples")])
    lost = shortfalls(doc, rows)
    assert [(r["words"], r["status"]) for r in lost] == [
        ("on the table", "broken"), ("straight up", "not_represented"), ("wags", "not_understood"),
    ]  # fmt: skip
    assert sentence(lost) == (
        'not represented: "straight up"; broken: "on the table": 0 of 95% of the samples; '
        'not understood: "wags"'
    )
    assert share_kept(rows) == 0.0


def test_a_verb_inside_lost_words_is_told_once() -> None:
    whole = said("flies straight up", "not_represented")
    doc = document(whole, verbs=(verb("flies"), verb("wags")))
    assert [r["words"] for r in shortfalls(doc, statement_rows(doc, []))] == [
        "flies straight up",
        "wags",
    ]


def test_a_quantity_of_which_nothing_was_made_is_a_shortfall() -> None:
    doc = document(verbs=(verb("wags") | {"kind": "quantity"},))
    assert sentence(shortfalls(doc, [])) == 'not understood: "wags"'
    assert not fully_understood(doc)


def test_a_kept_statement_does_not_excuse_its_dropped_verb() -> None:
    doc = document(said("wags", "stays_still"), verbs=(verb("wags"),))
    rows = statement_rows(doc, [verdict("wags", True)])
    assert [r["status"] for r in shortfalls(doc, rows)] == ["not_understood"]


def test_an_object_that_is_not_understood_is_no_shortfall() -> None:
    """Outcomes ask for verbs and quantities; nouns have their warnings."""
    assert shortfalls(document(verbs=(verb("ball") | {"kind": "object"},)), []) == []


@pytest.mark.parametrize(
    ("doc", "expected"),
    [
        (document(TABLE), True),
        (document(TABLE, UP), False),
        (document(verbs=(verb("wags"),)), False),
        (document(verbs=(verb("wags", "ignored"),)), True),
    ],
)
def test_understood_is_what_the_draft_could_hold(doc: dict[str, Any], expected: bool) -> None:
    assert fully_understood(doc) is expected


def test_what_was_never_judged_is_not_called_broken() -> None:
    doc = document(TABLE, UP)
    assert [r["words"] for r in lost_in(doc, None)] == ["straight up"]
    assert lost_in(doc, {"not_kept": [{"words": "x"}]}) == [{"words": "x"}]
    assert lost_in({}, {}) == []


def test_the_most_frequent_words_count_scenes_not_mentions() -> None:
    def row(words: str, status: str = "not_represented") -> dict[str, Any]:
        return {"words": words, "status": status}

    scenes = [[row("Slowly"), row("slowly")], [row("slowly")], [row("spins", "not_understood")]]
    scenes += [[row("on the table", "broken")]] * 5 + [[row(f"w{k:02d}")] for k in range(20)]
    most = most_unseen(scenes)
    assert most[0] == {"words": "slowly", "status": "not_represented", "scenes": 2}
    assert most[1]["words"] == "spins" and len(most) == 10


def laid_out(prompt: str, *edges: str, note: str = "", off: float = 99.0) -> dict[str, Any]:
    """The draft of a prompt with a layout that breaks relations (three words) and patterns."""
    doc = draft(prompt).model_dump(mode="json", by_alias=True)
    reports = [
        {"edge": e, "relation_type": e.split(" ")[1], "satisfied": False, "violation": off,
         "note": note} for e in edges
    ]  # fmt: skip
    patterns = [r for r in reports if len(r["edge"].split(" ")) == 2]
    kept = {"edge": "a on b", "relation_type": "on", "satisfied": True, "violation": 0, "note": ""}
    relations = [kept, *(r for r in reports if r not in patterns)]
    return {**doc, "layout_result": {"relations": relations, "patterns": patterns or None}}


def words(document: dict[str, Any]) -> list[str]:
    text = document["scene_definition"]["original_description"]
    lost = unplaced(document)
    assert all(text[r["start"] : r["end"]] == r["words"] for r in lost)
    assert all(r["status"] == "broken" and r["reason"] for r in lost)
    return [r["words"] for r in lost]


def test_relations_that_the_layout_did_not_satisfy_are_broken_with_their_words() -> None:
    two = "Two dogs sit to the left of a tree. A ball rolls into the tree."
    said = ["Two dogs sit to the left of a tree"]
    assert words(laid_out(two, "dog_1 left_of tree_1", "dog_2 left_of tree_1")) == said
    assert words(laid_out(two, "ball_1 face tree_1")) == []
    assert words(laid_out(two, "ball_1 near lamp_7")) == [], "nobody named it"
    assert unplaced({}) == unplaced({"layout_result": None}) == []


def test_what_does_not_stay_where_a_still_scene_puts_it_is_broken() -> None:
    document = laid_out("A lizard sits on a rock.")
    fell = {"name": "motion_before", "ok": False, "body": "lizard_1", "measured": 0.286}
    assert unsettled(document, [fell]) == [
        {"words": "A lizard", "start": 0, "end": 8, "status": "broken",
         "reason": "it does not stay where it is put: it moves by 0.29 m"}
    ]  # fmt: skip
    assert unsettled(document, [{**fell, "ok": True}, {**fell, "name": "energy"}]) == []


def test_a_planned_start_may_be_near_by_a_strangers_measure_only() -> None:
    held = "held by the planned start"
    near = "A ball near a wall rolls to the left."
    assert words(laid_out(near, "ball_1 near wall_1", note=held, off=30.0)) == []
    assert words(laid_out(near, "ball_1 near wall_1", note=held, off=80.0)) == [
        "A ball near a wall"
    ]
    behind = "A ball behind a wall rolls to the left."
    assert words(laid_out(behind, "ball_1 behind wall_1", note=held, off=1.0)) == [
        "A ball behind a wall"
    ]
    ramp = "A car drives up a ramp."
    assert words(laid_out(ramp, "car_1 near ramp_1")) == [], "its way is measured on the replay"


@pytest.mark.parametrize(("rear_cm", "lost"), [(900.0, []), (-900.0, ["one behind the other"])])
def test_of_two_that_drive_one_is_behind_along_their_way(rear_cm: float, lost: list[str]) -> None:
    """Both drive toward the viewer, who sees the rear bus beyond the front one, not behind it."""
    text = "Two buses drive one behind the other. The front bus brakes and the rear bus hits it."
    edge = "rear_bus_1 behind front_bus_1"
    document = laid_out(text, edge, note="held by the planned start", off=900.0)
    poses = {"front_bus_1": 0.0, "rear_bus_1": rear_cm}
    document["layout_result"]["poses"] = {
        name: {"position_cm": [0.0, y, 0.0], "yaw_deg": -90.0} for name, y in poses.items()
    }
    assert words(document) == lost


def test_arrangements_break_where_the_prompt_states_them() -> None:
    row = "Five cones stand in a row and a ball rolls into the first cone."
    cones = ",".join(["first_cone_1", *(f"cone_{k}" for k in range(2, 6))])
    stack = "A stack of three boxes stands beside a wall. A ball hits it."
    assert words(laid_out(row, f"{cones} row")) == ["in a row"]
    assert words(laid_out(stack, "box_1,box_2,box_3 stack")) == ["A stack of three boxes"]
    dominoes = "A marble hits the first of four dominoes."
    names = [n for n in draft(dominoes).spatial_relation_graph.nodes if "domino" in n]
    assert len(names) == 4
    assert words(laid_out(dominoes, f"{','.join(names)} row")) == [], "their own arrangement"


def test_what_is_drawn_as_something_else_is_warned_of_once() -> None:
    config = {
        "source": "fallback",
        "asset_name": "plain_cylinder",
        "dimensions_cm": (16.4, 16.4, 90),
    }
    node = {"asset_id": "hook_01", "label": "hook", "mentioned": True}
    doc = {
        "asset_configurations": {"hook_01": config, "ball_01": {"source": "parametric"}},
        "spatial_relation_graph": {
            "nodes": {
                "hook_1": node,
                "hook_2": node,
                "ball_1": {"asset_id": "ball_01", "label": "ball", "mentioned": True},
            }
        },
    }
    warning = (
        'The library has nothing for "hook": drawn as a plain cylinder of 16.4 x 16.4 x 90 cm.'
    )
    assert stand_ins(doc) == [warning]
    told = doc | {"coverage": {"warnings": ['"hook" is not in the lexicon.']}}
    assert stand_ins(told) == []
