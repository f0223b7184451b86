"""What the prompt states beyond its events: rows of the tables, places in the prompt, and silence."""

from __future__ import annotations

from dataclasses import replace
import json
from pathlib import Path
import re

import pytest

from esg.draft import draft
from esg.draft.discourse.proposition import Row
from esg.draft.document.coverage import stated_in_prompt
from esg.draft.events import stated
from esg.draft.statements import unkept
from esg.graph import canonical_json, verify
from esg.graph.models import (
    EdgeEvent,
    EsgDocument,
    NodeEvent,
    Predicate,
    Statement,
    TimelineEdge,
)

STATED = stated.rows()
UNKEPT = unkept.rows()
WALL = "A car hits a wall. "
DOCS = Path(__file__).parents[2] / "docs"
EXAMPLE = re.compile(r"^\| (?P<prompt>[A-Z][^|]*\.) \| (?P<said>[^|]*) \|", re.MULTILINE)


def statements(prompt: str) -> tuple[Statement, ...]:
    """The statements of a draft that the verifier has nothing against."""
    doc = draft(prompt)
    assert verify(doc) == ()
    return doc.statements or ()


def told(prompt: str) -> list[tuple[str, str]]:
    """Predicate and words of every statement."""
    return [(s.predicate.value, s.text) for s in statements(prompt)]


def edge(prompt: str, actor: str) -> TimelineEdge:
    """The first segment of an actor."""
    timeline = draft(prompt).timeline_system
    assert timeline is not None
    return next(e for e in timeline.sequence_graph.edges if e.actor == actor)


def fastest(doc: EsgDocument) -> float:
    """The upper end of the first segment's range of speeds [cm/s]."""
    assert doc.timeline_system is not None
    speed = doc.timeline_system.sequence_graph.edges[0].params.speed
    assert isinstance(speed, tuple)
    return speed[1]


@pytest.mark.parametrize("row", STATED, ids=[r.example for r in STATED])
def test_a_row_states_what_its_example_says(row: Row) -> None:
    found = [s for s in statements(row.example) if s.predicate is row.states]
    assert row.direction in [s.direction for s in found]
    assert all(row.example[s.start : s.end] == s.text for s in found)


@pytest.mark.parametrize("row", UNKEPT, ids=[r.example for r in UNKEPT])
def test_an_unkept_verb_is_owned_up_to(row: unkept._Row) -> None:
    found = [s for s in statements(row.example) if s.note == row.missing]
    assert [s.predicate for s in found] == [Predicate.NOT_REPRESENTED]
    assert row.example[found[0].start : found[0].end] == found[0].text


@pytest.mark.parametrize("row", STATED, ids=[r.example for r in STATED])
def test_a_statement_of_a_row_comes_of_its_row(row: Row, monkeypatch: pytest.MonkeyPatch) -> None:
    others = tuple(r for r in STATED if r is not row)
    before = {s.text for s in statements(row.example) if s.predicate is row.states}
    monkeypatch.setattr(stated, "rows", lambda: others)
    stated._by_word.cache_clear()
    after = {s.text for s in statements(row.example) if s.predicate is row.states}
    monkeypatch.undo()
    stated._by_word.cache_clear()
    assert after < before


def test_a_word_of_direction_is_one_word_in_a_row(monkeypatch: pytest.MonkeyPatch) -> None:
    prompt = "A car rolls backwardly."
    assert told(prompt) == [("not_represented", "backwardly")]
    row = next(r for r in STATED if "backwards" in r.words)
    more = (*STATED, replace(row, words=frozenset({"backwardly"})))
    monkeypatch.setattr(stated, "rows", lambda: more)
    stated._by_word.cache_clear()
    assert told(prompt) == [("moves", "backwardly")]
    assert edge(prompt, "car_1").params.backward is True
    monkeypatch.undo()
    stated._by_word.cache_clear()


@pytest.mark.parametrize(
    "prompt",
    [
        "A boy runs through a puddle.",
        "A dog runs across a frozen lake.",
        "A boat crosses a lake.",
        "A car runs into a tree.",
        "A deer crosses a stream.",
        "A robot carries a box to a shelf.",
        "A top spins on a table.",
        "A coin rolls off a table.",
    ],
)
def test_ice_shallows_and_tops_are_no_deep_water_nor_coins(prompt: str) -> None:
    why = {r.missing for r in UNKEPT if {"afloat", "flat"} & {*r.voice.split()}}
    why |= {r.missing for r in UNKEPT if "no arm holds it" in r.missing}
    assert len(why) == 3
    assert not [s.text for s in statements(prompt) if s.note in why]


def test_an_unkept_verb_is_one_row(monkeypatch: pytest.MonkeyPatch) -> None:
    prompt = "A plane banks."
    assert told(prompt) == []
    row = replace(UNKEPT[0], sense="turn", lemmas=frozenset({"bank"}), voice="*", missing="why")
    monkeypatch.setattr(unkept, "rows", lambda: (*UNKEPT, row))
    (found,) = statements(prompt)
    assert (found.text, found.note, found.object) == ("banks", "why", ("plane_1",))


@pytest.mark.parametrize("word", ["slowly", "gently", "softly", "lightly", "leisurely"])
def test_slow_words_leave_the_slow_part_of_a_range(word: str) -> None:
    plain, slow = draft("A car drives."), draft(f"A car drives {word}.")
    (said,) = list(slow.statements or ())
    assert said.predicate is Predicate.SLOWER_THAN
    assert isinstance(said.value, float)
    assert fastest(slow) < said.value < 0.5 * fastest(plain)


@pytest.mark.parametrize("word", ["quickly", "fast", "rapidly", "swiftly"])
def test_fast_words_leave_the_fast_part_of_a_range(word: str) -> None:
    plain, fast = draft("A car drives."), draft(f"A car drives {word}.")
    (said,) = list(fast.statements or ())
    assert said.predicate is Predicate.FASTER_THAN
    assert isinstance(said.value, float)
    assert said.value > 0.5 * fastest(plain)
    assert fastest(fast) == fastest(plain)


def test_a_stated_speed_beats_a_word_for_it() -> None:
    prompt = "A car drives slowly at 10 m/s."
    assert told(prompt) == [("not_represented", "slowly")]
    assert edge(prompt, "car_1").params.speed == 1000.0


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("<b>A ball</b> rolls **slowly** to the left.", ["rolls", "slowly", "to the left"]),
        ("1. A ball rolls   quickly.", ["rolls", "quickly"]),
        ("# Scene\nA ball &amp; a cat. The ball rolls quickly.", ["rolls", "quickly"]),
        ("A slowly turning fan. A ball rolls slowly.", ["rolls", "slowly"]),
    ],
)
def test_places_are_those_of_the_prompt_as_typed(prompt: str, words: list[str]) -> None:
    found = [s for s in statements(prompt) if "ball_1" in s.object]
    assert [s.text for s in found] == words
    assert [prompt[s.start : s.end] for s in found] == words
    assert found[-1].start == prompt.rindex(words[-1])


@pytest.mark.parametrize(
    "typed", ["to the *left*", "to the <b>left</b>", "to  the left", "to\nthe left"]
)
def test_markup_may_stand_between_the_words_of_a_place(typed: str) -> None:
    prompt = f"*A ball* rolls {typed}."
    (left,) = [s for s in statements(prompt) if s.direction == "left"]
    assert prompt[left.start : left.end] == typed.rstrip("*").removesuffix("</b>")


def test_a_repeated_word_is_placed_where_it_was_read() -> None:
    said = Statement(id="s1", predicate=Predicate.ROLLS, text="rolls", start=20, end=25)
    typed = "x rolls " + "<i></i>" * 3 + " rolls"
    (moved,) = list(stated_in_prompt((said,), "x rolls " + " " * 12 + "rolls", typed) or ())
    assert (moved.start, moved.end) == (30, 35)
    assert stated_in_prompt(None, "a", "b") is None


@pytest.mark.parametrize(
    "clause",
    [
        "A man does not walk forward.",
        "A ball never rolls quickly.",
        "A dog wants to run left.",
        "A dog wants to run gracefully.",
        "A man does not walk carefully.",
        "A dog refuses to jump over a fence.",
        "A ball would have rolled slowly to the left.",
        "A truck did not tow a trailer.",
        "Nobody picks up the mug.",
    ],
)
def test_what_does_not_happen_states_nothing(clause: str) -> None:
    assert told(WALL + clause) == []
    assert told(f"{clause} {WALL}") == []


def test_a_word_is_owned_up_to_once() -> None:
    assert told("A car drives through the smoke.") == [("not_represented", "smoke")]


def test_an_adverb_of_both_is_of_what_happens() -> None:
    prompt = "A man does not walk carefully. A car carefully hits a wall."
    (said,) = statements(prompt)
    assert said.text == "carefully" and said.start > prompt.index(".")


@pytest.mark.parametrize("prompt", ["A car hits a wall.", "A red ball lies on a table."])
def test_a_document_without_statements_keeps_its_bytes(prompt: str) -> None:
    doc = draft(prompt)
    assert doc.statements is None
    assert "statements" not in json.loads(canonical_json(doc))


def test_what_moves_on_a_table_stays_on_it() -> None:
    prompt = "A ball rolls on a table."
    assert told(prompt) == [("rolls", "rolls"), ("supported_by", "a table")]
    doc = draft(prompt)
    graph = doc.spatial_relation_graph
    region = graph.nodes["ball_1"].semantic_region
    assert graph.semantic_regions[region or ""].parent_object == "table_1"
    table = doc.asset_requirement[graph.nodes["table_1"].asset_id].expected_dimensions_cm
    assert fastest(doc) * 2.5 <= 0.5 * max(table[:2]) < fastest(draft("A ball rolls.")) * 2.5
    support = statements(prompt)[1]
    assert (support.target, support.when) == (("table_1",), "throughout")


def test_what_leaves_a_table_is_not_slowed_down() -> None:
    assert ("supported_by", "a table") not in told("A ball rolls off a table.")
    prompt = "A ball rolls on a table. The ball falls off the table."
    assert fastest(draft(prompt)) > fastest(draft("A ball rolls on a table."))


@pytest.mark.parametrize(
    ("prompt", "course"),
    [
        ("A ball rolls left.", {"heading_deg": 0.0}),
        ("A ball rolls to the right.", {"heading_deg": 180.0}),
        ("A car rolls backwards.", {"backward": True}),
        ("A car drives backward.", {"backward": True}),
        ("A car reverses slowly into a wall.", {"backward": True}),
        ("A truck backs up quickly into a gate.", {"backward": True}),
        ("A ball is thrown up.", {"elevation_deg": 90.0}),
        ("A ball is thrown up. It bounces twice on the ground.", {"elevation_deg": 90.0}),
        ("A ball is thrown up into a basket.", {"elevation_deg": (-10.0, 60.0)}),
        ("A ball rolls.", {}),
    ],
)
def test_words_of_direction_are_a_course(prompt: str, course: dict[str, object]) -> None:
    params = edge(prompt, prompt.split()[1] + "_1").params
    names = ("heading_deg", "backward", "elevation_deg")
    assert {n: v for n in names if (v := getattr(params, n)) is not None} == course


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("A car drives forward.", "forward"),
        ("A car is driving forward.", "forward"),
        ("A car drives slowly forward.", "forward"),
        ("A drone rises.", "rises"),
    ],
)
def test_a_way_is_stated_wherever_its_word_stands(prompt: str, words: str) -> None:
    assert ("moves", words) in told(prompt)


@pytest.mark.parametrize(
    "prompt", ["A ball is left on a table.", "A car drives up.", "A cup lies right next to a bowl."]
)
def test_words_that_only_look_like_directions_state_none(prompt: str) -> None:
    assert "moves" not in [says for says, _ in told(prompt)]


@pytest.mark.parametrize(
    "prompt",
    [
        "A ball is thrown by a boy.",
        "A ball kicked by a boy hits a wall.",
        "A crate is pulled by a dog.",
    ],
)
def test_who_does_it_is_not_passed(prompt: str) -> None:
    assert "past" not in [s.direction for s in statements(prompt)]


@pytest.mark.parametrize("where", ["in front of", "near", "beside", "next to"])
def test_what_stops_by_something_leaves_a_gap(where: str) -> None:
    timeline = draft(f"A car stops {where} a tree.").timeline_system
    assert timeline is not None
    stop = next(n for n in timeline.sequence_graph.nodes if n.event is NodeEvent.STOP)
    (gap,) = stop.constraints
    assert (gap.quantity, gap.object, gap.to) == ("distance", "car_1", "tree_1")
    assert isinstance(gap.value, tuple)
    assert 0.0 < gap.value[0] < gap.value[1] <= 150.0
    assert all(n.event is not NodeEvent.COLLISION for n in timeline.sequence_graph.nodes)


def test_a_stated_gap_wins() -> None:
    timeline = draft("A car stops 3 m in front of a gate.").timeline_system
    assert timeline is not None
    gaps = [c for n in timeline.sequence_graph.nodes for c in n.constraints if c.to == "gate_1"]
    assert [c.value for c in gaps] == [300.0]


@pytest.mark.parametrize(
    ("prompt", "when"),
    [
        ("A ball rolls.", "throughout"),
        ("A ball rolls off a table.", "start..ball_1_fall"),
        ("A ball rolls into a wall.", "start..ball_1_wall_1_collision"),
    ],
)
def test_a_manner_lasts_until_the_event_that_ends_it(prompt: str, when: str) -> None:
    (rolls,) = [s for s in statements(prompt) if s.predicate is Predicate.ROLLS]
    assert rolls.when == when


def test_what_an_event_tells_is_not_stated_again() -> None:
    prompt = "A dog runs towards a tree and hits it."
    assert [s.predicate for s in statements(prompt)] == [Predicate.FASTER_THAN]  # it runs
    assert "toward" in [s.direction for s in statements("A dog runs towards a tree.")]


@pytest.mark.parametrize(
    ("prompt", "says", "who", "other"),
    [
        ("A man drives a tractor.", "inside", "man_1", "tractor_1"),
        ("A man rides a horse.", "supported_by", "man_1", "horse_1"),
        ("A truck carries a crate along a road.", "carried_by", "crate_1", "truck_1"),
    ],
)
def test_riders_and_loads_are_said_to_be_with_what_moves(
    prompt: str, says: str, who: str, other: str
) -> None:
    found = [s for s in statements(prompt) if s.predicate.value == says]
    assert [(s.object, s.target) for s in found] == [((who,), (other,))]
    assert edge(prompt, other).event is EdgeEvent.UNIFORM_MOTION


@pytest.mark.parametrize(
    ("prompt", "note"),
    [
        ("A car drives through the smoke.", "light and weather are not simulated"),
        ("A ball rolls gracefully to the left.", "manner is not simulated"),
        ("A boy fetches a ball.", "nothing picks it up"),
    ],
)
def test_what_no_scene_shows_is_owned_up_to(prompt: str, note: str) -> None:
    assert note in [s.note for s in statements(prompt)]


def test_the_page_on_statements_shows_what_the_reader_says() -> None:
    page = (DOCS / "drafting" / "statements.md").read_text("utf-8")
    shown = {
        m["prompt"]: re.findall(r'`(\w+)`(?: [\w ]+)? \("([^"]+)"\)', m["said"])
        for m in EXAMPLE.finditer(page)
    }
    assert len(shown) >= 10
    assert shown == {prompt: told(prompt) for prompt in shown}


def test_the_page_of_the_document_shows_a_true_one() -> None:
    page = (DOCS / "graph" / "statements.md").read_text("utf-8")
    prompt = re.search(r'^esg draft "([^"]+)" --json', page, re.MULTILINE)
    shown = re.search(r"```json\n(.*?)```", page, re.DOTALL)
    assert prompt is not None
    assert shown is not None
    document = json.loads(canonical_json(draft(prompt[1])))
    assert json.loads(shown[1]) == document["statements"]


@pytest.mark.parametrize(
    ("prompt", "told"),
    [
        ("Turn the blue block right.", [("Spin", ("blue_block_1",))]),
        ("A sledge turns left.", [("HeadingReached", ("sledge_1",))]),
        ("A rubber ball is thrown onto the ground.", [("Bounce", ("rubber_ball_1", "ground_1"))]),
        ("Put the cup in the box.", [("EnterRegion", ("cup_1",))]),
        ("A teapot is lifted and put on a table.",
         [("PickedUp", ("teapot_1",)), ("Placed", ("teapot_1", "table_1"))]),
        ("A frog hops three times.", [("Jump", ("frog_1",))]),
        ("A child jumps onto a chair.", [("Jump", ("child_1",))]),
    ],
)  # fmt: skip
def test_hands_leaps_and_turns_are_events(prompt, told):
    """What is done to a thing that goes nowhere by itself, and what leaves the ground."""
    timeline = draft(prompt).timeline_system
    nodes = timeline.sequence_graph.nodes if timeline else ()
    kinds = ("Spin", "HeadingReached", "Bounce", "EnterRegion", "PickedUp", "Placed", "Jump")
    assert [(n.event.value, n.participants) for n in nodes if n.event.value in kinds] == told


def test_what_gets_to_another_side_also_starts_on_its_own():
    told = draft("A fox is in front of a shoe, then the fox runs to the left of the shoe.")
    sides = {(s.predicate.value, s.when, s.text) for s in told.statements or ()}
    assert sides == {
        ("in_front_of", "start", "front"),
        ("faster_than", "throughout", "runs"),
        ("left_of", "end", "left of the shoe"),
    }


@pytest.mark.parametrize(
    "prompt",
    [
        "A box rolls into a chair.",
        "A wardrobe rolls across the room.",
        "Two bricks roll towards each other and collide.",
    ],
)
def test_what_has_corners_does_not_roll(prompt: str) -> None:
    """It slides, and the draft says so instead of promising what cannot be."""
    found = [s for s in statements(prompt) if s.text in ("rolls", "roll")]
    assert found and all(s.predicate is Predicate.NOT_REPRESENTED for s in found)
    assert all("is not round" in s.note for s in found)
    mover = found[0].object[0]
    assert edge(prompt, mover).params.spin == "slide"


@pytest.mark.parametrize(
    "prompt",
    [
        "A pencil rolls into a book.",
        "A dumbbell rolls into a bench.",
        "A round hay bale rolls into a tractor.",
        "A baseball bat rolls into a ball.",
        "A trash bin rolls into a wall.",
    ],
)
def test_what_is_round_about_some_axis_rolls(prompt: str) -> None:
    """The library's flags say so, whatever class of things the drafter files it under."""
    (said,) = [s for s in statements(prompt) if s.text == "rolls"]
    assert said.predicate is Predicate.ROLLS
    assert edge(prompt, said.object[0]).params.spin == "roll"


def test_a_participle_states_the_course_and_the_pace_of_its_noun() -> None:
    """Read a participle before the subject as a verb of it, whatever the clause's own verb."""
    assert edge("A reversing truck knocks over a sign.", "truck_1").params.backward
    assert told("A reversing truck knocks over a sign.") == [("moves", "reversing")]
    assert told("A speeding car hits a wall.") == [("faster_than", "speeding")]
    assert told("A racing car hits a wall.") == []


@pytest.mark.parametrize("board", ["inclined plank", "tilted board", "sloping beam"])
def test_what_is_set_aslant_is_a_slope(board: str) -> None:
    """Put what goes down a board onto it, as onto a ramp."""
    doc = draft(f"A ball rolls down an {board}.")
    graph = doc.spatial_relation_graph
    assert len([n for n in graph.nodes.values() if n.mentioned]) == 2
    down = [s for s in doc.statements or () if s.direction == "down"]
    assert len(down) == 1 and graph.nodes[down[0].target[0]].is_static


@pytest.mark.parametrize(
    ("prompt", "when"),
    [
        ("A cube stays still while a ball rolls past it.", "throughout"),
        ("A cat sits motionless next to a box.", "throughout"),
        ("A cube remains stationary until a ball hits it.", "start..ball_1_cube_1_collision"),
        ("A cat stays still and then runs off.", None),
    ],
)
def test_what_is_said_to_stay_still_is_stated(prompt: str, when: str | None) -> None:
    """State that a thing stays still up to the first hit, and of what moves later nothing."""
    still = [s.when for s in statements(prompt) if s.predicate is Predicate.STAYS_STILL]
    assert still == ([when] if when else [])
