"""Captions and questions of synthetic recordings with known answers."""

from __future__ import annotations

from dataclasses import replace
import datetime
import json
from typing import Any

import numpy as np
import pytest

from esg.dataset.annotations.captions import captions
from esg.dataset.annotations.clauses import Story, event_clauses, hit_clauses
from esg.dataset.annotations.motion import Motion, side
from esg.dataset.annotations.nouns import Nouns
from esg.dataset.annotations.questions import questions
from esg.dataset.annotations.rows import text_rows
from esg.engines.manifest import manifest_to_json
from esg.metrics import SuiteEvent, SuiteScene
from esg.store.records import RunInfo, make_record
from tests.dataset.answers import Recording, problem
from tests.metrics.worlds import DT, World, ball, line

COMMON = {"run_id": "r", "scene_key": "r/-/s/0", "suite": "", "scene_id": "s", "seed": 0,
          "prompt": "p"}  # fmt: skip
NAMES = ("red ball", "green ball", "blue ball")
EVENTS = [
    SuiteEvent(id="e1", type="collision", a="red ball", b="green ball"),
    SuiteEvent(id="e2", type="collision", a="green ball", b="blue ball", after=("e1",)),
]


def chain(first: float = 0.4, second: float = 0.9, *, hits_last: bool = True) -> World:
    """A red ball hits a green one, and that a blue one, which then rolls on."""
    world = World()
    red, green, blue = (ball(f"{n.split()[0]}_ball_1", label=n) for n in NAMES)
    world.add(red, x=line(0.0, 2.0, 0.0, first))
    world.add(green, x=line(1.0, 2.0, first, second))
    world.add(blue, x=line(3.0, 1.0, second, 99.0) if hits_last else 3.0)
    world.touch(first, "red_ball_1", "green_ball_1", impulse=2.0)
    return world.touch(second, "green_ball_1", "blue_ball_1", impulse=1.0) if hits_last else world


def told(world: World, events: list[SuiteEvent] = EVENTS) -> tuple[Story, dict[str, Any]]:
    scene, program, rollout = world.scene, world.program, world.rollout()
    rollout.linear_velocity[:, 0] = rollout.linear_velocity[:, 1]
    verdict = world.judge(events)
    expected = SuiteScene(id="s", prompt="p", events=tuple(events))
    record = make_record(
        RunInfo("r", "dataset", datetime.datetime.now(datetime.UTC)), scene_id="s", seed=0,
        prompt="p", outcome="solved", rollouts={"physx": rollout}, bodies=scene.names,
    )  # fmt: skip
    row = record.rows["trajectories"][0]
    story = Story(scene, program, Motion(row, scene), Nouns(scene), verdict, expected)
    return story, row


def test_a_chain_is_told_in_order_at_three_lengths() -> None:
    texts = captions(told(chain())[0], "seed")
    for words in ("red ball", "green ball", "blue ball"):
        assert words in texts.short and words in texts.long
    assert texts.short.count(".") == 1 < texts.medium.count(". ") + 1
    assert texts.long.index("0.40 s") < texts.long.index("0.90 s")
    assert "2 N s" in texts.long and "2.0 m/s" in texts.long


def test_what_failed_is_not_told() -> None:
    story, _ = told(chain(hits_last=False))
    assert [e.completed for e in story.verdict.events] == [True, False]
    assert [c.event for c in event_clauses(story)] == ["e1"]
    texts = captions(story, "seed")
    assert "blue" not in texts.short and "blue" not in texts.medium


def test_hits_that_nobody_asked_for_are_told() -> None:
    story, _ = told(chain(), EVENTS[:1])
    events = event_clauses(story)
    more = hit_clauses(story, events)
    assert [(c.a, c.b) for c in more] == [("green_ball_1", "blue_ball_1")]
    assert "blue ball" in captions(story, "x").medium


def test_who_strikes_is_measured() -> None:
    """Whoever is named first in the sentence: the ball that moves hits the one that does not."""
    events = [SuiteEvent(id="e1", type="collision", a="green ball", b="red ball")]
    (clause, *_) = event_clauses(told(chain(), events)[0])
    assert (clause.a, clause.b, clause.what) == ("red_ball_1", "green_ball_1", "collision")


def test_two_that_meet_collide() -> None:
    world = World()
    world.add(ball("red_ball_1", label="red ball"), x=line(0.0, 2.0, 0.0, 0.4))
    world.add(ball("green_ball_1", label="green ball"), x=line(1.8, -2.0, 0.0, 0.4))
    world.touch(0.4, "red_ball_1", "green_ball_1", impulse=2.0)
    story, _ = told(world, EVENTS[:1])
    assert event_clauses(story)[0].what == "mutual"
    measures = {q.measure for q in questions(story, "x")}
    assert "hit_speed" not in measures and "after_hit" not in measures


def test_answers_of_a_chain() -> None:
    story, _ = told(chain())
    found = {(q.measure, *q.arguments): q for q in _all_questions(story)}
    assert found["cause", "blue_ball_1", "green_ball_1"].answer == "The green ball."
    assert found["first_cause", "blue_ball_1", "red_ball_1"].answer == "The red ball."
    speed = found["hit_speed", "red_ball_1", "green_ball_1"]
    assert speed.value == pytest.approx(2.0) and speed.answer == "About 2.0 m/s."
    three = ("red_ball_1", "green_ball_1", "blue_ball_1")
    assert found["moving_first", *three].answer == "One."
    assert found["moved", *three].value == 3.0
    assert found["hit_count", "green_ball_1", "red_ball_1", "blue_ball_1"].value == 2.0
    order = found["hit_order", "red_ball_1", "green_ball_1", "green_ball_1", "blue_ball_1"]
    assert order.answer == "The red ball hits the green ball." and order.answer in order.choices
    assert found["pushed", "green_ball_1", "blue_ball_1"].answer == "Straight on."
    assert all(q.measured_by for q in found.values())


def _all_questions(story: Story) -> list[Any]:
    """Those of several seeds: one seed picks two of a measure."""
    return [q for k in range(12) for q in questions(story, f"seed {k}")]


def test_other_code_gives_the_same_answers_and_finds_a_wrong_one() -> None:
    world = chain()
    story, row = told(world)
    manifest = manifest_to_json(story.scene, story.program, dt=DT)
    asked = text_rows(story, COMMON, [], [])["questions"]
    seen = Recording({k: _plain(v) for k, v in row.items()}, json.loads(json.dumps(manifest)))
    assert len(asked) > 10
    assert [problem(q, seen, []) for q in asked] == [""] * len(asked)
    for q in asked:
        spoilt = {**q, "answer": "Seven.", "choices": []}
        assert problem(spoilt, seen, []), q["measure"]


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.ndarray) else value


def test_what_hangs_on_a_threshold_is_not_asked() -> None:
    """An impulse near the least of a hit, a motion near the least that counts: no answer."""
    faint = chain()
    faint.contacts = [(t, a, b, 0.12 if b == "blue_ball_1" else p, d) for t, a, b, p, d in
                      faint.contacts]  # fmt: skip
    story, _ = told(faint)
    asked = _all_questions(story)
    assert not any("blue_ball_1" in q.arguments for q in asked if q.measure == "hit_order")
    assert not any(q.arguments[0] == "blue_ball_1" for q in asked if q.measure == "hit_count")


def test_bodies_of_one_name_are_not_asked_for() -> None:
    world = World()
    for k in (1, 2):
        world.add(ball(f"ball_{k}", label="ball"), x=line(float(k), 2.0 - k, 0.0, 0.4))
    world.touch(0.4, "ball_1", "ball_2", impulse=2.0)
    story, _ = told(world, [])
    assert {q.kind for q in questions(story, "x")} <= {"count"}
    assert "the other" in captions(story, "x").short


@pytest.mark.parametrize(
    ("turn", "where"),
    [(0.0, "straight on"), (-19.0, "straight on"), (25.0, None), (90.0, "left"), (-90.0, "right"),
     (155.0, None), (180.0, "back"), (-350.0, "straight on"), (270.0, "right")],
)  # fmt: skip
def test_sides(turn: float, where: str | None) -> None:
    assert side(turn) == where


def test_equal_seeds_give_equal_words_and_others_others() -> None:
    story, _ = told(chain())
    texts = {captions(story, f"{k}").medium for k in range(8)}
    assert captions(story, "1") == captions(story, "1") and len(texts) > 3
    assert questions(story, "1") == questions(story, "1")


def test_what_if_questions_need_engines_that_agree() -> None:
    story, _ = told(chain())

    def rows(done: tuple[bool, ...], late: float = 0.5) -> list[dict[str, Any]]:
        out: list[dict[str, Any]] = []
        for engine, d in zip(("physx", "rapier", "newton"), done, strict=True):
            base = {"engine": engine, "amount": "", "body": "", "event_ids": ["e1", "e2"],
                    "completed": [True, True], "event_times_s": [0.4, 0.9],
                    "variable": "none", "duration_s": 3.0}  # fmt: skip
            out += [base, {**base, "variable": "speed", "amount": "half", "body": "red_ball_1",
                           "completed": [d, True], "event_times_s": [0.4 + late, 0.9 + late]}]  # fmt: skip
        return out

    asked = [q for k in range(8) for q in questions(story, f"{k}", rows((True,) * 3))
             if q.kind == "what_if"]  # fmt: skip
    assert {(q.measure, q.answer) for q in asked} == {("happens", "Yes."), ("sooner", "Later.")}
    assert any("it still hit the green ball" in q.question for q in asked)
    split = [q for q in questions(story, "1", rows((True, False, True))) if q.kind == "what_if"]
    assert all(q.arguments[3] == "e2" for q in split)
    none = [q for q in questions(story, "1", rows((False,) * 3)) if q.measure == "happens"]
    assert {q.answer for q in none} <= {"No.", "Yes."}
    failed = [{**r, "completed": None} for r in rows((True,) * 3)]
    assert not [q for q in questions(story, "1", failed) if q.kind == "what_if"]


def test_a_text_names_nothing_that_is_not_there() -> None:
    """A fragment has no name, and the caption of a scene in which nothing happens says what stands."""
    world = World()
    world.add(ball("red_ball_1", label="red ball"))
    story, _ = told(world, [])
    assert captions(story, "x").short == "A red ball can be seen."
    piece = replace(story.scene.bodies[0], category="fragment")
    assert not Nouns(replace(story.scene, bodies=(piece,))).known("red_ball_1")
