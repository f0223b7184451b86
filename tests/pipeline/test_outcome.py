"""What the judge stage makes of the optimizer's claim."""

from __future__ import annotations

from collections.abc import Callable
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from esg import metrics as metrics_package
from esg import stages
from esg.draft import draft
from esg.engines import rollout_file
from esg.graph.models import DynamicsResult, LayoutResult, RelationReport, Statement
from esg.metrics import SceneVerdict, SuiteScene
from esg.metrics import plausibility as plausibility_package
from esg.metrics.models import LayoutVerdict, StatementVerdict
from esg.outcomes import Outcome
from esg.pipeline import SceneRequest, SceneState, failures
from esg.stages import _outcome


def verdict(*events: Any) -> Any:
    return SimpleNamespace(events=events, slr=True, layout=None)


@pytest.mark.parametrize(
    ("prompt", "expected"),
    [
        ("A ball hits a box.", Outcome.SOLVED),
        ("A lamp stands on a desk.", Outcome.SOLVED),
        ("A wizard enchants a frog.", Outcome.NOT_CONVERGED),
    ],
)
def test_a_scene_without_the_events_of_its_prompt_is_not_solved(
    prompt: str, expected: Outcome
) -> None:
    outcome, reason = _outcome(draft(prompt), verdict())
    assert outcome is expected
    assert ("enchants" in reason) == (expected is not Outcome.SOLVED)


def test_a_replay_that_disagrees_overrules_the_claim() -> None:
    missed = SimpleNamespace(id="e1", type="collision", reason="never touch", completed=False)
    outcome, reason = _outcome(draft("A ball hits a box."), verdict(missed))
    assert outcome is Outcome.NOT_CONVERGED
    assert reason == "the replay disagrees: e1 (collision): never touch"


LOST = [
    {"words": "straight up", "status": "not_represented", "reason": "no path"},
    {"words": "on the table", "status": "broken", "reason": "0 of 95% of the samples"},
]
NEARER = {"strategy": "batched", "duration_s": 1.0, "outcome": "nearest_feasible", "reason": "late"}


def test_a_scene_that_does_not_show_all_of_its_prompt_is_partial() -> None:
    outcome, reason = _outcome(draft("A ball hits a box."), verdict(), LOST)
    assert outcome is Outcome.PARTIAL
    assert reason == (
        'not represented: "straight up"; broken: "on the table": 0 of 95% of the samples'
    )


def test_what_fails_otherwise_keeps_its_outcome() -> None:
    missed = SimpleNamespace(id="e1", type="collision", reason="never touch", completed=False)
    doc = draft("A ball hits a box.")
    assert _outcome(doc, verdict(missed), LOST)[0] is Outcome.NOT_CONVERGED
    relaxed = doc.model_copy(update={"dynamics_result": DynamicsResult.model_validate(NEARER)})
    assert _outcome(relaxed, verdict(), LOST) == (Outcome.NEAREST_FEASIBLE, "late")
    assert _outcome(draft("A wizard enchants a frog."), verdict(), LOST)[0] is Outcome.NOT_CONVERGED


def test_partial_is_good_unless_one_is_strict() -> None:
    assert Outcome.PARTIAL.has_scene and "--strict" in Outcome.PARTIAL.advice
    ended = [SceneState(SceneRequest("x"), outcome=o) for o in Outcome]
    strict = {row["outcome"] for row in failures(ended, strict=True)}
    assert strict - {row["outcome"] for row in failures(ended)} == {"partial"}


def test_what_is_implausible_is_good_unless_one_is_strict(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The outcome keeps its meaning; the failure says what nature would not have done."""
    monkeypatch.setattr(SceneState, "artifact", lambda self, stage: tmp_path)
    state = SceneState(SceneRequest("x"), {"judge": "key"}, outcome=Outcome.SOLVED)
    for worst, failed in (("", 0), ("car_1: braking 20 m/s2, limit 8 m/s2", 1)):
        found = {"plausible": not worst, "worst": worst, "checks": []}
        (tmp_path / "metrics.json").write_text(json.dumps({"plausibility": found}))
        assert failures([state]) == []
        rows = failures([state], strict=True)
        assert [r["reason"] for r in rows] == [f"implausible: {worst}"] * failed
    (tmp_path / "metrics.json").write_text("{}")
    assert failures([state], strict=True) == []


SUPPORTED = {
    "id": "s1", "predicate": "supported_by", "text": "A ball", "start": 0, "end": 6,
    "object": ("ball_1",), "target": ("box_1",),
}  # fmt: skip


def _replayed(monkeypatch: pytest.MonkeyPatch, judged: Callable[..., SceneVerdict]) -> None:
    """A replay that is not read, what judges it, and nothing implausible in it."""
    assessed = SimpleNamespace(to_json=lambda: {"worst": "", "checks": []})
    monkeypatch.setattr(stages, "load_scene", lambda state: (None, None))
    monkeypatch.setattr(rollout_file, "load_rollout", lambda path: None)
    monkeypatch.setattr(metrics_package, "judge", judged)
    monkeypatch.setattr(plausibility_package, "assess", lambda *played: assessed)


@pytest.mark.parametrize("suite", [False, True])
@pytest.mark.parametrize(("kept", "expected"), [(True, "solved"), (False, "partial")])
def test_the_prompts_own_statements_decide_with_a_suite_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suite: bool, kept: bool, expected: str
) -> None:
    """A suite that asks for nothing of the kind changes no outcome; its verdict stays alone."""
    prompt = "A ball hits a box."
    doc = draft(prompt).model_copy(update={"statements": (Statement.model_validate(SUPPORTED),)})
    said = StatementVerdict(id="s1", says="supported_by", kept=kept, measured={"share": 0.1},
                            reason="" if kept else "carried in 10%")  # fmt: skip

    def judged(*played: Any) -> SceneVerdict:
        expected = played[-1]
        own = expected.id != "T1"
        return SceneVerdict(
            scene_id="x", suite_scene=expected.id, engine="physx", dt_s=1 / 240,
            layout=LayoutVerdict(valid=True), statements=(said,) if own else (),
        )  # fmt: skip

    monkeypatch.setattr(stages, "load_doc", lambda state: doc)
    _replayed(monkeypatch, judged)
    monkeypatch.setattr(SceneState, "artifact", lambda self, stage: tmp_path)
    (tmp_path / "replay.json").write_text('{"proof": "class"}')
    asked = SuiteScene(id="T1", prompt=prompt).model_dump_json() if suite else ""
    stages._judge(SceneState(SceneRequest(prompt, suite_scene=asked)), tmp_path)
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["outcome"] == expected
    assert [(r["id"], r["kept"], r["words"]) for r in metrics["statements"]] == [
        ("s1", kept, "A ball")
    ]
    assert [r["status"] for r in metrics.get("not_kept", [])] == ([] if kept else ["broken"])
    assert len(metrics["verdict"]["statements"]) == (0 if suite else 1)
    state = SceneState(SceneRequest(prompt), {"judge": "key"})
    assert stages.not_kept(state) == metrics.get("not_kept", [])
    assert stages.conclude("judge", state)[0] is Outcome(expected)


def test_a_relation_that_the_layout_did_not_satisfy_makes_a_scene_partial(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    report = RelationReport(
        edge="ball_1 left_of box_1", relation_type="left_of", satisfied=False, violation=12.0
    )
    laid = LayoutResult(poses={}, energy=0.0, relations=(report,))
    told = "A ball to the left of a box rolls and hits the box."
    doc = draft(told).model_copy(update={"layout_result": laid})
    verdict = SceneVerdict(
        scene_id="x", suite_scene="", engine="physx", dt_s=1 / 240, layout=LayoutVerdict(valid=True)
    )
    monkeypatch.setattr(stages, "load_doc", lambda state: doc)
    _replayed(monkeypatch, lambda *played: verdict)
    monkeypatch.setattr(SceneState, "artifact", lambda self, stage: tmp_path)
    (tmp_path / "replay.json").write_text('{"proof": "class"}')
    stages._judge(SceneState(SceneRequest(told)), tmp_path)
    metrics = json.loads((tmp_path / "metrics.json").read_text())
    assert metrics["outcome"] == "partial"
    assert '"A ball to the left of a box": the layout' in metrics["reason"]
