"""Reading suites: what is accepted, what is reported, units."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest
import yaml

from esg.graph.models import Predicate
from esg.metrics import load_suite, own_suites, parse_suite
from esg.outcomes import UserError

PAPER = Path(__file__).parents[2] / "data" / "suites" / "paper.yaml"

ONE = """
suite: one
scenes:
  - id: A
    prompt: "A car hits a box."
    events:
      - {id: e1, type: collision, a: car, b: box}
"""


def with_scene(extra: str) -> str:
    return ONE.rstrip() + "\n" + "\n".join("    " + line for line in extra.splitlines()) + "\n"


def with_events(*events: str) -> str:
    return ONE.rstrip() + "".join(f"\n      - {e}" for e in events) + "\n"


def constraint(text: str) -> str:
    return with_scene(f"constraints:\n  - {text}")


def problems(text: str) -> str:
    with pytest.raises(UserError) as caught:
        parse_suite(text)
    assert caught.value.exit_code == 2
    return str(caught.value)


def test_the_papers_suite_has_its_ten_scenes():
    suite = load_suite(PAPER)
    assert [s.id for s in suite.scenes] == [f"S{k}" for k in range(1, 11)]
    assert suite.n_events == 18
    assert sum(len(s.constraints) for s in suite.scenes) == 8


def test_after_defaults_to_the_event_before():
    text = with_events(
        "{id: e2, type: stops, object: car}",
        "{id: e3, type: falls, object: box, from: table, after: [e1]}",
        "{id: e4, type: topples, object: box, after: []}",
        "{id: e5, type: moves, object: car, after: e2}",
    )
    events = parse_suite(text).scenes[0].events
    assert [e.after for e in events] == [(), ("e1",), ("e1",), (), ("e2",)]
    assert events[2].from_ == "table"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("{kind: initial, quantity: speed, object: car, at: start, value: 36, unit: km/h}", 10.0),
        ("{kind: initial, quantity: speed, object: car, at: start, value: 500, unit: cm/s}", 5.0),
        ("{kind: initial, quantity: speed, object: car, value: 5}", 5.0),
        ("{kind: initial, quantity: mass, object: car, value: 500, unit: g}", 0.5),
        ("{kind: outcome, quantity: time, event: e1, value: 1500, unit: ms}", 1.5),
        ("{kind: outcome, quantity: distance, object: car, event: e1, value: 50, unit: cm}", 0.5),
        ("{kind: outcome, quantity: angle, object: car, event: e1, value: 30, unit: deg}", 30.0),
        ("{kind: outcome, quantity: angle, object: car, event: e1, value: 1, unit: rad}", 57.29578),
    ],
)
def test_units_become_base_units(text, value):
    found = parse_suite(constraint(text)).scenes[0].constraints[0]
    assert found.value == pytest.approx(value, rel=1e-6)


def test_ranges_are_converted_too():
    text = "{kind: outcome, quantity: time, event: e1, range: [200, 300], unit: ms}"
    found = parse_suite(constraint(text)).scenes[0].constraints[0]
    assert found.range == pytest.approx((0.2, 0.3))
    assert found.unit == "s"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ["is empty", "suite: NAME"]),
        ("- 1\n- 2", ["is a list"]),
        ("suite: [", ["not valid YAML", "line 1"]),
        ("suite: x", ["/scenes", "at least one scene"]),
        ("suite: x\nscenes: []", ["/scenes"]),
        ("suite: x\nscenes: [3]", ["/scenes/0", "is 3"]),
        ("suite: x\nscenes: [{id: A}]", ["scene 'A' /prompt", "is missing"]),
        ("suite: x\nscenes: [{prompt: hi}]", ["/scenes/0/id", "is missing"]),
        ("scenes: [{id: A, prompt: hi}]", ["/suite"]),
        (ONE + "  - {id: A, prompt: again}\n", ["'A' is already used"]),
        (ONE + "suite: two\n", ["key 'suite' is repeated"]),
        (ONE.replace("collision", "colision"), ["'colision'", "did you mean 'collision'"]),
        (ONE.replace(", b: box", ""), ["/events/0/b", "is missing"]),
        (ONE.replace("b: box", "b: ''"), ["/events/0/b", "noun phrase"]),
        (ONE.replace("id: e1", "id: start"), ["'start' means the scene start"]),
        (with_events("{id: e1, type: stops, object: car}"), ["'e1' is used twice"]),
        (with_events("{id: e2, type: stops, object: car, after: [e9]}"), ["'e9' is no event"]),
        (with_events("{id: e2, type: stops, object: car, after: [e2]}"), ["refers to itself"]),
        (
            with_events(
                "{id: e2, type: stops, object: car, after: [e3]}",
                "{id: e3, type: stops, object: box}",
            ),
            ["'e3' stands later"],
        ),
        (with_events("{id: e2, type: turns, object: car}"), ["/events/1/direction", "is missing"]),
        (with_events("{id: e2, type: turns, object: car, direction: up}"), ["left or right"]),
        (
            with_events("{id: e2, type: turns, object: car, direction: left, degrees: -3}"),
            ["above 0"],
        ),
        (with_events("{id: e2, type: stops, objekt: car}"), ["did you mean 'object'"]),
        (with_scene("constraint: []"), ["did you mean 'constraints'"]),
        (constraint("{kind: out, quantity: time, event: e1, value: 1}"), ["initial or outcome"]),
        (constraint("{kind: outcome, quantity: velocity, value: 1}"), ["'velocity'"]),
        (constraint("{kind: outcome, quantity: time, value: 1}"), ["/event", "is missing"]),
        (constraint("{kind: outcome, quantity: time, event: e7, value: 1}"), ["'e7' is no event"]),
        (
            constraint("{kind: outcome, quantity: time, event: e1, value: 1, unit: kg}"),
            ["'kg' is a unit of mass", "s, sec"],
        ),
        (
            constraint("{kind: outcome, quantity: time, event: e1, value: 1, unit: fortnights}"),
            ["'fortnights' is not a known unit"],
        ),
        (constraint("{kind: outcome, quantity: time, event: e1}"), ["neither value nor range"]),
        (
            constraint("{kind: outcome, quantity: time, event: e1, value: 1, range: [0, 2]}"),
            ["both value and range"],
        ),
        (
            constraint("{kind: outcome, quantity: time, event: e1, range: [3, 2]}"),
            ["not in increasing order", "[2, 3]"],
        ),
        (constraint("{kind: outcome, quantity: time, event: e1, range: 3}"), ["[low, high]"]),
        (constraint("{kind: outcome, quantity: time, event: e1, value: 3 s}"), ["plain number"]),
        (constraint("{kind: outcome, quantity: time, event: e1, value: .nan}"), ["finite"]),
        (constraint("{kind: outcome, quantity: time, event: e1, value: true}"), ["plain number"]),
        (constraint("{kind: initial, quantity: mass, object: car, value: -2}"), ["never negative"]),
        (
            constraint("{kind: outcome, quantity: time_since, event: e1, value: 1}"),
            ["/since", "is missing"],
        ),
    ],
)
def test_problems_name_place_value_and_remedy(text, words):
    message = problems(text)
    for word in words:
        assert word in message


def test_all_problems_are_reported_at_once():
    text = ONE.replace("collision", "boom") + "  - {id: B}\n  - {prompt: hi}\n  - 7\n"
    message = problems(text)
    assert "4 problems" in message
    assert message.count("\n") == 4


def test_suites_of_the_package_go_by_name_unless_a_file_is_called_so(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert {"paper", "breadth"} <= set(own_suites())
    for name, path in own_suites().items():
        assert load_suite(name).suite == load_suite(path).suite
    (tmp_path / "paper").write_text(ONE)
    assert load_suite("paper").suite == "one"
    with pytest.raises(UserError, match=r"papers does not exist; give a file, or one of .*paper"):
        load_suite("papers")


def test_files_that_cannot_be_read(tmp_path):
    for path, word in ((tmp_path / "none.yaml", "does not exist"), (tmp_path, "is a folder")):
        with pytest.raises(UserError, match=word):
            load_suite(path)
    binary = tmp_path / "binary.yaml"
    binary.write_bytes(b"\xff\xfe\x00\x01")
    with pytest.raises(UserError, match="UTF-8"):
        load_suite(binary)


def test_metadata_of_other_tools_is_no_mistake():
    text = ONE.replace("suite: one", "suite: one\nversion: 3\nauthors: [me]")
    assert parse_suite(with_scene("difficulty: 2").replace("suite: one", "suite: one\nx: 1"))
    assert parse_suite(text).suite == "one"


def test_yaml_cannot_run_code():
    assert "not valid YAML" in problems("suite: !!python/object/apply:os.system ['true']")


@settings(max_examples=150, deadline=None)
@given(
    st.recursive(
        st.none() | st.booleans() | st.floats() | st.text(max_size=8) | st.integers(),
        lambda inner: st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(
                ["suite", "scenes", "id", "prompt", "events", "type", "a", "b", "after", "range",
                 "constraints", "kind", "quantity", "value", "unit", "object", "degrees"]
            ),
            inner,
            max_size=5,
        ),
        max_leaves=20,
    )
)  # fmt: skip
def test_any_yaml_is_accepted_or_reported(data):
    import yaml

    try:
        parse_suite(yaml.safe_dump(data))
    except UserError as error:
        assert "problem" in str(error)


def stated(*statements: str) -> str:
    return with_scene("statements:\n" + "\n".join(f"  - {s}" for s in statements))


def test_statements_are_read_in_base_units():
    (scene,) = parse_suite(
        stated(
            "{id: s1, says: supported_by, object: ball, target: table, when: start}",
            "{id: s2, says: moves, object: ball, direction: toward the red box, when: start..e1}",
            "{id: s3, says: slower_than, object: car, value: 36, unit: km/h}",
            "{id: s4, says: above, object: kite, target: roof, distance: 50, unit: cm}",
            "{id: s5, says: size, object: pole, quantity: height, value: 3}",
            "{id: s6, says: size, object: ball, as: melon}",
            "{id: s7, says: count, noun: pin, value: 10}",
            "{id: s8, says: touches, a: car, b: box, when: e1}",
            "{id: s9, says: struck_on, object: box, target: car, side: rear, when: e1}",
        )
    ).scenes
    by_id = {s.id: s for s in scene.statements}
    assert by_id["s1"].when == "start"
    assert (by_id["s2"].direction, by_id["s2"].target) == ("toward", "the red box")
    assert by_id["s3"].value == pytest.approx(10.0)
    assert by_id["s4"].value == pytest.approx(0.5)
    assert (by_id["s5"].quantity, by_id["s5"].value) == ("height", 3.0)
    assert by_id["s6"].alike == "melon"
    assert by_id["s7"].value == 10
    assert by_id["s8"].participants == ("car", "box")
    assert by_id["s9"].side == "rear"


def test_all_mistakes_of_statements_are_reported_at_once():
    text = problems(
        stated(
            "{id: s1, says: roles, object: ball}",
            "{id: s2, says: supported_by, object: ball}",
            "{id: s2, says: moves, object: ball, direction: lef}",
            "{id: s4, says: moves, object: ball, direction: along}",
            "{id: s5, says: rolls, object: ball, when: e1..e7}",
            "{id: s6, says: faster_than, object: ball, value: fast, speed: 3}",
            "{id: s7, says: size, object: ball, value: 3, as: melon}",
            "{id: s8, says: before, a: e1, b: e9}",
            "{id: s9, says: count, noun: pin, value: -1}",
            "{says: absent, noun: tray}",
            "{id: s11, says: slower_than, object: ball, value: 3, unit: kg}",
            "{id: s12, says: struck_on, object: ball, target: car, side: front left}",
        )
    )
    for line in (
        "/statements/0/says: 'roles' is no statement; did you mean 'rolls'?",
        "/statements/11/side: 'front left' is no side; ",
        "/statements/1/target: is missing in a 'supported_by' statement",
        "/statements/2/direction: 'lef' is no direction; did you mean 'left'?",
        "/statements/2/id: id 's2' is used twice",
        "/statements/3/direction: 'along' is of nothing",
        "/statements/4/when: 'e1..e7' is no time; write one of start, end, throughout, e1",
        "/statements/5/value: is 'fast'",
        "/statements/5/speed: is not a field",
        "/statements/6: has both value and as",
        "/statements/7/b: 'e9' is no event",
        "/statements/8/value: is -1",
        "/statements/9/id: is missing",
        "/statements/10/unit: 'kg' is a unit of mass",
    ):
        assert line in text, line


def test_statements_are_a_list_of_mappings():
    assert "write a list of statements" in problems(with_scene("statements: rolls"))
    assert "write {id: s1" in problems(stated("rolls"))


def test_events_of_the_second_edition_are_read():
    text = with_events(
        "{id: e2, type: bounces, object: ball, target: floor, times: 3}",
        "{id: e3, type: spins, object: top}",
        "{id: e4, type: opens, object: door}",
        "{id: e5, type: misses, object: ball, target: goal}",
        "{id: e6, type: misses, a: ball, b: goal}",
        "{id: e7, type: separates, a: ball, b: goal}",
    )
    events = {e.id: e for e in parse_suite(text).scenes[0].events}
    assert (events["e2"].times, events["e3"].degrees, events["e4"].degrees) == (3, 360.0, 30.0)
    assert events["e5"].participants == events["e6"].participants == ("ball", "goal")
    wrong = problems(with_events("{id: e2, type: bounces, object: b, target: c, times: 0.5}"))
    assert "/times: is 0.5; write how often" in wrong
    assert "/target: is missing in a 'misses'" in problems(
        with_events("{id: e2, type: misses, object: b}")
    )


@pytest.mark.parametrize("path", sorted(PAPER.parent.glob("*.yaml")), ids=lambda p: p.stem)
def test_shipped_suites_are_read(path):
    suite = load_suite(path)
    assert suite.scenes
    assert all(s.events or s.statements or s.objects for s in suite.scenes)


def test_the_suite_of_words_keeps_a_third_of_its_scenes_unopened():
    scenes = load_suite(PAPER.with_name("words.yaml")).scenes
    assert [k for k, s in enumerate(scenes, 1) if s.level == "unopened"] == list(range(3, 40, 3))
    assert all(s.statements for s in scenes)


JUNK = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.sampled_from(["e1", "a; b", "", "left"]),
    lambda inner: (
        st.lists(inner, max_size=2) | st.dictionaries(st.text(max_size=3), inner, max_size=2)
    ),
    max_leaves=4,
)
FIELDS = ("id", "object", "target", "a", "b", "noun", "direction", "quantity", "value", "distance",
          "as", "unit", "when")  # fmt: skip


@settings(max_examples=200, deadline=None)
@given(
    st.sampled_from([p.value for p in Predicate]) | JUNK,
    st.dictionaries(st.sampled_from(FIELDS), JUNK, max_size=6),
)
def test_whatever_stands_in_a_statement_is_read_or_reported(says, fields):
    scene = {"id": "A", "prompt": "p", "statements": [{"says": says, **fields}]}
    try:
        suite = parse_suite(yaml.safe_dump({"suite": "s", "scenes": [scene]}))
    except UserError as error:
        assert "scene 'A' /statements/0" in str(error)
    else:
        assert suite.scenes[0].statements[0].says == says
