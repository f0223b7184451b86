"""The scene grammar: shares, meanings, pairs, determinism."""

from __future__ import annotations

from collections import Counter
import re

from hypothesis import given, settings
from hypothesis import strategies as st
import numpy as np
import pytest

from esg.dataset.distribution import Distribution, load_distribution
from esg.dataset.grammar import CHANGEABLE, SampledScene, changed, draw, sample_scenes
from esg.dataset.rules import RULES
from esg.metrics import parse_suite
from esg.outcomes import UserError


def scenes(n: int, seed: int = 0, mix: Distribution | None = None, **more: bool):
    return list(sample_scenes(n, seed, mix, **more))


def test_a_larger_sample_begins_with_the_smaller_one() -> None:
    assert scenes(120, 5)[:30] == scenes(30, 5)


def test_seeds_differ() -> None:
    assert [s.prompt for s in scenes(30, 1)] != [s.prompt for s in scenes(30, 2)]


@pytest.mark.parametrize("n", [50, 400])
def test_levels_have_their_shares_at_any_size(n: int) -> None:
    counts = Counter(s.level for s in scenes(n, 3))
    for level, share in {"single": 0.5, "chain": 0.3, "multi_phase": 0.2}.items():
        assert abs(counts[level] - share * n) <= 3


def test_rules_have_their_weights() -> None:
    found = scenes(2000, 1, Distribution(levels={"single": 1.0}))
    counts = Counter(s.rule for s in found)
    weights = {r.name: r.weight for r in RULES if r.level == "single"}
    for name, weight in weights.items():
        assert counts[name] == pytest.approx(2000 * weight / sum(weights.values()), abs=12)


def test_every_meaning_is_a_valid_suite_scene() -> None:
    """The suite reader checks references, units and fields; ids make it a suite."""
    import json

    found = scenes(300, 2)
    data = [
        {
            **json.loads(s.expectation.model_dump_json(by_alias=True, exclude_none=True)),
            "id": f"s{i}",
        }
        for i, s in enumerate(found)
    ]
    for item in data:
        for event in item["events"]:
            if event["type"] != "turns":
                event.pop("degrees")
            event.pop("times")
    suite = parse_suite(json.dumps({"suite": "x", "scenes": data}))
    for scene, read in zip(found, suite.scenes, strict=True):
        assert read.events == scene.expectation.events
        assert read.constraints == scene.expectation.constraints


def numbers(text: str) -> list[float]:
    return [float(x) for x in re.findall(r"(?<![\w-])\d+(?:\.\d+)?", text)]


def test_every_number_of_a_sentence_is_a_constraint_and_the_reverse() -> None:
    for scene in scenes(400, 4):
        wanted = [c.value for c in scene.expectation.constraints]
        assert sorted(numbers(scene.prompt)) == sorted(v for v in wanted if v is not None)


def test_every_event_names_words_of_the_sentence() -> None:
    for scene in scenes(400, 6):
        text = scene.prompt.lower()
        for event in scene.expectation.events:
            for phrase in event.participants:
                assert phrase.lower().split()[-1] in text, (phrase, scene.prompt)


def test_sentences_have_articles_and_end() -> None:
    for scene in scenes(400, 7):
        assert scene.prompt[0].isupper()
        assert scene.prompt.endswith(".")
        assert not re.search(r"\b[Aa] (?=[aeio]|8 kg)|\b[Aa]n (?=[^aeio8])", scene.prompt), (
            scene.prompt
        )
        assert "  " not in scene.prompt


def test_pairs_differ_in_one_slot_and_share_all_else() -> None:
    found = scenes(200, 8, counterfactual=True)
    for base, twin in zip(found[::2], found[1::2], strict=True):
        assert (base.changed, twin.changed in CHANGEABLE) == ("", True)
        assert (base.unit, base.seed, base.family) == (twin.unit, twin.seed, twin.family)
        differing = {k for k in base.values if base.values[k] != twin.values[k]}
        assert differing == {twin.changed}
        assert base.prompt != twin.prompt
    assert {s.changed for s in found} == {"", *CHANGEABLE}


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(RULES), st.integers(0, 10**6))
def test_every_rule_can_always_be_changed(rule, seed: int) -> None:
    rng = np.random.default_rng(seed)
    values = draw(rule, rng, Distribution(quantified=0.0), must_change=True)
    slot, other = changed(rule, values, rng)
    assert values[slot] != other[slot]
    assert rule.render(values).prompt != rule.render(other).prompt


def speeds(found: list[SampledScene]) -> list[float]:
    return [s.values["speed"] for s in found if "speed" in s.values]


def test_the_distribution_is_obeyed() -> None:
    fast = Distribution(
        levels={"single": 1.0}, rules={"drive_into": 1.0, "bowl": 0.0}, quantified=1.0,
        speeds={"fast": 1.0}, movers=("car", "bus"),
    )  # fmt: skip
    found = scenes(80, 0, fast)
    assert {s.values["mover"] for s in found} == {"car", "bus"}
    assert {s.rule for s in found} <= {"drive_into", "drive", "head_on"}
    assert min(speeds(found)) >= 11.0
    assert all("speed" in s.values for s in found)
    silent = scenes(80, 0, Distribution(rules={"bowl": 0, "drive": 0, "head_on": 0}, quantified=0.0,
                                        levels={"single": 1.0}))  # fmt: skip
    assert not any(s.expectation.constraints for s in silent)


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("levels: {easy: 1}", "easy"),
        ("quantified: 2", "quantified"),
        ("rules: {fly: 1}", "fly"),
        ("movers: [unicorn]", "unicorn"),
        ("speed: 3", "speed"),
        ("levels: {single: 0}", "levels"),
        ("[1, 2]", "mapping"),
        ("a: [", "YAML"),
        ("levels: {single: 1}\nmovers: [cue ball]", "no rule of level 'single'"),
    ],
)
def test_mistakes_in_a_distribution_are_named(text: str, place: str) -> None:
    with pytest.raises(UserError, match=re.escape(place)):
        load_distribution(text, "mix.yaml")


def test_braking_is_what_tyres_give() -> None:
    found = [s for s in scenes(800, 9, counterfactual=True) if s.rule == "brake_to_stop"]
    assert len(found) > 20
    assert max(s.values["speed"] / s.values["time"] for s in found) <= 7.0


def test_a_distribution_that_is_no_yaml_is_told_with_its_place() -> None:
    with pytest.raises(
        UserError, match=r"d\.yaml cannot be read:\s+line 2, column \d+: .*fix"
    ) as told:
        load_distribution("levels: 1\nshares: [", "d.yaml")
    assert told.value.exit_code == 2
