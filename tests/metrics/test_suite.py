"""Reading suites: what is accepted, what is reported, units."""

from __future__ import annotations

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest

from esg.metrics import load_suite, parse_suite
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
