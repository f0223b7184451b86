"""What is recorded of one scene run: its rows in every table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
import datetime
import hashlib
import json
import re
from typing import TYPE_CHECKING, Any

from esg import fidelity
from esg.metrics.models import SceneVerdict
from esg.store.rows import (
    check_rows,
    constraint_rows,
    coverage_rows,
    event_rows,
    statement_rows,
    trajectory_row,
)

if TYPE_CHECKING:
    from esg.engines.scene import Rollout
    from esg.pipeline import SceneState

SPLIT_SHARES = (("train", 0.8), ("validation", 0.1), ("test", 0.1))


@dataclass(frozen=True)
class RunInfo:
    """One invocation: a benchmark, a dataset, a generated scene.

    Args:
        run_id: Unique name; everything recorded carries it.
        kind: bench, dataset or generate.
        started_at: Time zone aware.
        suite: Name of the suite, empty without.
        strategy: Search strategy.
        engine: Engine of the replay.
        dt_s: Its physics step [s].
        seeds: Seeds a scene.
        version: Version of this software.
        code_version: Hash of the code of all stages.
        machine: Short description of the machine.
    """

    run_id: str
    kind: str
    started_at: datetime.datetime
    suite: str = ""
    strategy: str = "batched"
    engine: str = "physx"
    dt_s: float = 1.0 / 240.0
    seeds: int = 1
    version: str = ""
    code_version: str = ""
    machine: str = ""

    def row(self) -> dict[str, Any]:
        """The row of table `runs`."""
        return dict(vars(self))


@dataclass(frozen=True)
class SceneRecord:
    """Rows of one scene run by table."""

    rows: Mapping[str, list[dict[str, Any]]] = field(default_factory=dict)


def prompt_family(prompt: str) -> str:
    """The prompt without case, articles, numbers and punctuation: counterfactual variants of one
    prompt (other speed, other mass) share a family, and so a split.
    """
    text = re.sub(r"\d+(?:[.,]\d+)*", " # ", prompt.lower())
    text = re.sub(r"[^a-z#]+", " ", text)
    words = [w for w in text.split() if w not in ("a", "an", "the")]
    return re.sub(r"(?:# ?)+", "# ", " ".join(words)).strip()


def split_of(family: str) -> str:
    """train, validation or test, by hash of the prompt family."""
    place = int.from_bytes(hashlib.sha256(family.encode()).digest()[:8], "big") / 2**64
    for name, share in SPLIT_SHARES:
        if place < share:
            return name
        place -= share
    return SPLIT_SHARES[-1][0]


def scene_key(run_id: str, suite: str, scene_id: str, seed: int) -> str:
    """Key of a scene run; replays of it in several engines share it."""
    return f"{run_id}/{suite or '-'}/{scene_id}/{seed}"


def make_record(
    run: RunInfo,
    *,
    scene_id: str,
    seed: int,
    prompt: str,
    outcome: str,
    reason: str = "",
    level: str = "",
    drafter: str = "rules",
    device: str = "cpu",
    proof: str = "",
    documents: Mapping[str, bytes] | None = None,
    artifacts: Mapping[str, str] | None = None,
    verdicts: Mapping[str, SceneVerdict] | None = None,
    rollouts: Mapping[str, Rollout] | None = None,
    bodies: tuple[str, ...] = (),
    stages: tuple[Mapping[str, Any], ...] = (),
    statements: Mapping[str, Sequence[Mapping[str, Any]]] | None = None,
    checks: Sequence[Mapping[str, Any]] = (),
    split: str | None = None,
    family: str | None = None,
    extra: Mapping[str, Any] | None = None,
) -> SceneRecord:
    """All rows of one scene run.

    Args:
        run: The run it belongs to.
        scene_id: Id of the suite's scene, or of the generated one.
        seed: Its seed.
        prompt: Its prompt.
        outcome, reason: Value of the Outcome enum, and why.
        level: Difficulty label of the suite.
        drafter, device, proof: How it was made and proven.
        documents: Canonical JSON of the ESG by stage (draft, resolve, cast, layout, optimize).
        artifacts: Artifact keys by stage.
        verdicts: Verdicts by engine; the run's engine fills the scene's own columns.
        rollouts: Rollouts of one world by engine.
        bodies: Names in the order of the rollouts' body axis.
        stages: Log entries of the stages: stage, seconds, cached, outcome.
        statements: What became of statements (rows of esg.fidelity), by source: prompt or suite.
        checks: Of the plausibility of the replay in the run's engine, as JSON.
        split, family: Override those of the prompt (counterfactual pairs keep one family).
        extra: Further columns of the scene's row, such as rule, pair and manifest.
    """
    common = {**_common(run, scene_id, seed), "prompt": prompt}
    documents = documents or {}
    family = prompt_family(prompt) if family is None else family
    split = split_of(family) if split is None else split
    scene: dict[str, Any] = {
        **common,
        "level": level,
        "family": family,
        "split": split,
        "drafter": drafter,
        "strategy": run.strategy,
        "engine": run.engine,
        "device": device,
        "proof": proof,
        "outcome": outcome,
        "reason": reason,
        **_judged((verdicts or {}).get(run.engine), run, checks),
        **_documented(documents, statements or {}),
        **_timed(stages),
        "artifacts": json.dumps(dict(artifacts or {}), sort_keys=True),
        **(extra or {}),
    }
    played = (rollouts or {}).items()
    return SceneRecord(
        {
            "runs": [run.row()],
            "scenes": [scene],
            **_judged_rows(common, run, verdicts or {}, checks),
            "trajectories": [trajectory_row(common, split, e, r, bodies) for e, r in played],
            "coverage": coverage_rows(common, documents.get("draft")),
            "statements": statement_rows(common, run, statements or {}),
            "timings": [{**common, **_timing(i, s)} for i, s in enumerate(stages)],
        }
    )


def _common(run: RunInfo, scene_id: str, seed: int) -> dict[str, Any]:
    """Columns that the rows of a scene run share in all tables."""
    return {
        "run_id": run.run_id,
        "scene_key": scene_key(run.run_id, run.suite, scene_id, seed),
        "suite": run.suite,
        "scene_id": scene_id,
        "seed": seed,
    }


def _judged_rows(
    common: Mapping[str, Any],
    run: RunInfo,
    verdicts: Mapping[str, SceneVerdict],
    checks: Sequence[Mapping[str, Any]],
) -> dict[str, list[dict[str, Any]]]:
    """Rows of what verdicts say, of every engine."""
    judged = list(verdicts.items())
    return {
        "metrics": [row for e, v in judged for row in event_rows(common, run, e, v)],
        "constraints": [row for e, v in judged for row in constraint_rows(common, run, e, v)],
        "plausibility_checks": check_rows(common, run, checks),
    }


def _timed(stages: Iterable[Mapping[str, Any]]) -> dict[str, Any]:
    """What all stages took together [s], and how many of them had been computed before."""
    timings = [_timing(i, s) for i, s in enumerate(stages)]
    return {
        "seconds": sum(t["seconds"] for t in timings),
        "cached_stages": sum(t["cached"] for t in timings),
    }


def _judged(
    verdict: SceneVerdict | None, run: RunInfo, checks: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Columns of a scene's row that its verdict fills; without one, nothing is verified."""
    if verdict is None:
        unknown = ("plausible", "max_penetration_m", "n_events", "ppa", "ppa_strict", "ppa_lenient")
        nothing = {"dt_s": run.dt_s, "verified": False, "slr": False, "n_completed": 0}
        return {**nothing, **dict.fromkeys(unknown)}
    return {
        "dt_s": verdict.dt_s,
        "verified": verdict.verified,
        "slr": verdict.slr,
        "plausible": all(c["ok"] for c in checks) if checks else None,
        "max_penetration_m": verdict.layout.max_penetration_m,
        "n_events": verdict.n_events,
        "n_completed": verdict.completed,
        "ppa": verdict.ppa(),
        "ppa_strict": verdict.ppa("strict"),
        "ppa_lenient": verdict.ppa("lenient"),
    }


def _documented(
    documents: Mapping[str, bytes], statements: Mapping[str, Sequence[Mapping[str, Any]]]
) -> dict[str, Any]:
    """The document of every stage and the hash of the last one; whether the draft holds all that
    the prompt says, and which share of it was kept.
    """
    draft = documents.get("draft")
    last = list(documents.values())[-1] if documents else b""
    return {
        **{f"esg_{name}": data.decode() for name, data in documents.items()},
        "esg_sha256": hashlib.sha256(last).hexdigest() if last else None,
        "fully_understood": None if draft is None else fidelity.fully_understood(json.loads(draft)),
        "statements_kept": fidelity.share_kept(statements.get("prompt", ())),
    }


def _timing(index: int, stage: Mapping[str, Any]) -> dict[str, Any]:
    return {
        "stage": stage["stage"],
        "stage_index": index,
        "seconds": float(stage.get("seconds", 0.0)),
        "cached": bool(stage.get("cached")),
        "outcome": stage.get("outcome"),
    }


def record_of(
    state: SceneState,
    run: RunInfo,
    *,
    scene_id: str = "",
    level: str = "",
    trajectories: bool = True,
    fps: float | None = None,
    split: str | None = None,
    family: str | None = None,
    extra: Mapping[str, Any] | None = None,
) -> SceneRecord:
    """The record of a scene that the pipeline has ended, read from its artifacts.

    Args:
        state: The scene.
        run: The run it belongs to.
        scene_id: Id in the suite; default the suite scene's, else the document's.
        level: Difficulty label.
        trajectories: Whether to include the replay's trajectories.
        fps: Frames a second of the trajectories at most; default all.
        split, family, extra: As of `make_record`.
    """
    request = state.request
    documents = {
        stage: (state.artifact(stage) / "esg.json").read_bytes()
        for stage in ("draft", "resolve", "cast", "layout", "optimize")
        if stage in state.artifacts
    }
    if request.suite_scene:
        expected = json.loads(request.suite_scene)
        scene_id = scene_id or expected["id"]
        level = level or expected.get("level", "")
    if not scene_id and "draft" in documents:
        scene_id = json.loads(documents["draft"])["scene_definition"]["scene_id"]
    verdicts: dict[str, SceneVerdict] = {}
    proof = ""
    metrics: dict[str, Any] = {}
    said = fidelity.statement_rows(json.loads(documents.get("draft", b"{}")))
    if "judge" in state.artifacts:
        metrics = json.loads((state.artifact("judge") / "metrics.json").read_bytes())
        verdict = SceneVerdict.from_json(metrics["verdict"])
        verdicts[verdict.engine] = verdict
        proof = metrics.get("proof", "")
        said = metrics.get("statements", [])
    elif request.suite_scene:
        verdicts[run.engine] = _nothing(state, run)
    rollouts: dict[str, Rollout] = {}
    bodies: tuple[str, ...] = ()
    if trajectories and "replay" in state.artifacts:
        from esg.engines.manifest import load_manifest
        from esg.engines.rollout_file import load_rollout

        rollout = load_rollout(state.artifact("replay") / "rollout.npz")
        rollouts[rollout.engine] = rollout if fps is None else thinned(rollout, fps)
        bodies = load_manifest(state.artifact("compile") / "manifest.json").scene.names
    return make_record(
        run,
        scene_id=scene_id or request.name or "scene",
        seed=request.seed,
        prompt=request.prompt,
        outcome=state.outcome.value if state.outcome else "",
        reason=state.reason,
        level=level,
        drafter=request.drafter,
        device=request.device,
        proof=proof,
        documents=documents,
        artifacts=state.artifacts,
        verdicts=verdicts,
        rollouts=rollouts,
        bodies=bodies,
        stages=state.log,
        statements={"prompt": said, "suite": _asked(state, verdicts.get(run.engine))},
        checks=metrics.get("plausibility", {}).get("checks", ()),
        split=split,
        family=family,
        extra=extra,
    )


def _asked(state: SceneState, verdict: SceneVerdict | None) -> list[fidelity.Row]:
    """What became of the statements of a suite's scene; the prompt's own are no suite's."""
    if verdict is None or not state.request.suite_scene:
        return []
    return [fidelity.judged(s.model_dump(mode="json")) for s in verdict.statements]


def thinned(rollout: Rollout, fps: float) -> Rollout:
    """The rollout with every k-th frame, at `fps` frames a second or somewhat more.

    The contact log keeps every contact and its time; its frame numbers follow the frames kept.
    """
    import dataclasses

    import numpy as np

    if len(rollout.time) < 2:
        return rollout
    step = max(1, int(1.0 / (fps * float(np.median(np.diff(rollout.time)))) + 1e-6))
    if step == 1:
        return rollout
    contacts = dataclasses.replace(rollout.contacts, frame=rollout.contacts.frame // step)
    return dataclasses.replace(
        rollout,
        time=rollout.time[::step],
        position=rollout.position[:, ::step],
        quaternion=rollout.quaternion[:, ::step],
        linear_velocity=rollout.linear_velocity[:, ::step],
        angular_velocity=rollout.angular_velocity[:, ::step],
        contacts=contacts,
    )


def _nothing(state: SceneState, run: RunInfo) -> SceneVerdict:
    """A suite's scene that never reached the judge: its events count, and none is completed."""
    from esg.metrics.judging import failed_verdict
    from esg.metrics.models import SuiteScene

    expected = SuiteScene.model_validate_json(state.request.suite_scene)
    return failed_verdict(expected.id, expected, run.engine, run.dt_s, state.reason or "no replay")
