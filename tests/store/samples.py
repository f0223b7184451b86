"""Records of small runs with known numbers."""

from __future__ import annotations

import datetime
import json

from esg.fidelity import judged, statement_rows
from esg.metrics import SuiteConstraint
from esg.store.records import RunInfo, SceneRecord, make_record
from tests.dataset.clips.synthetic import record as clip_record
from tests.metrics.test_events import CHAIN, chain

UTC = datetime.UTC
TIME = SuiteConstraint(kind="outcome", quantity="time", event="e2", value=0.8)
MASS = SuiteConstraint(kind="initial", quantity="mass", object="ball 1", value=1.0)

STATEMENTS = [
    {"id": "s1", "predicate": "touches", "text": "hits ball 2", "start": 18, "end": 29},
    {"id": "s2", "predicate": "not_represented", "text": "of Scene", "start": 7, "end": 15,
     "note": "no such place"},
]  # fmt: skip


def run_info(name: str = "run-1", day: int = 1, **more: object) -> RunInfo:
    values: dict[str, object] = {
        "run_id": name,
        "kind": "bench",
        "started_at": datetime.datetime(2026, 1, day, 12, tzinfo=UTC),
        "suite": "paper",
        "engine": "synthetic",
        "seeds": 2,
    }
    return RunInfo(**{**values, **more})  # type: ignore[arg-type]


def world(complete: bool = True):
    made = chain(0.4, 0.8)
    if not complete:
        made.contacts = made.contacts[:1]
    return made


def record(
    run: RunInfo, scene: str, seed: int, *, complete: bool = True, engines: tuple[str, ...] = ()
) -> SceneRecord:
    """A run of a two-event scene, both or only one completed."""
    made = world(complete)
    verdict = made.judge(CHAIN, [MASS, TIME])
    verdicts = {
        engine: verdict.model_copy(update={"engine": engine}) for engine in (run.engine, *engines)
    }
    coverage = (
        b'{"coverage": {"items": [{"text": "Ball", "start": 0, "end": 4, "kind": "object",'
        b' "status": "used"}, {"text": "gently", "start": 5, "end": 11, "kind": "modifier",'
        b' "status": "not_understood", "note": "manner"}]}'
    )
    draft = coverage + b', "statements": ' + json.dumps(STATEMENTS).encode() + b"}"
    said = [{"id": "s1", "says": "touches", "kept": complete, "measured": {"impulse_ns": 1.0},
             "reason": "" if complete else "no hit"}]  # fmt: skip
    rows = {"prompt": statement_rows(json.loads(draft), said), "suite": []}
    if run.suite:
        rows["suite"] = [judged({**said[0], "says": "ends_near", "kept": True, "reason": ""})]
    ends = {"body": "ball_1", "time_s": 0.0, "note": ""}
    checks = [
        {"name": "braking", "unit": "m/s2", "ok": True, "measured": None, "limit": None, **ends},
        {"name": "speed", "unit": "m/s", "ok": complete, "measured": 10.0 if complete else 94.6 + seed,
         "limit": 47.3, **ends},
    ]  # fmt: skip
    made = make_record(
        run,
        scene_id=scene,
        seed=seed,
        prompt=f"Ball {seed} of scene {scene} hits ball 2.",
        outcome="solved" if complete else "not_converged",
        reason="" if complete else "e2 not reached",
        level="chain",
        documents={"draft": draft, "optimize": draft},
        artifacts={"draft": "draft-" + "0" * 64},
        verdicts=verdicts,
        rollouts={run.engine: made.rollout()},
        bodies=made.scene.names,
        statements=rows,
        checks=checks,
        stages=(
            {"stage": "draft", "seconds": 0.5, "cached": False},
            {"stage": "replay", "seconds": 1.5, "cached": seed == 1},
        ),
    )
    clip = clip_record(run.run_id, scene, seed=seed, suite=run.suite, split="")
    checked = {
        "check_name": "flow", "camera": 0, "unit": "px", "samples": 4, "p50": 0.01, "p90": 0.02,
        "p99": 0.03, "worst": 0.04, "limit_value": 0.1, "ok": True, "note": "",
    }  # fmt: skip
    place = {k: made.rows["scenes"][0][k] for k in ("run_id", "scene_key", "suite", "scene_id")}
    checked |= {**place, "seed": seed}
    common = {k: made.rows["scenes"][0][k] for k in COMMON}
    mesh = {
        **common, "mesh": "meshes/ball_1.glb", "asset": "ball", "gltf": "{}", "buffer": None,
        "bytes": 20,
    }  # fmt: skip
    seen = {"clips": [clip.row()], "truth_checks": [checked], "meshes": [mesh]}
    return SceneRecord({**made.rows, **seen, **beside(common)})


COMMON = ("run_id", "scene_key", "suite", "scene_id", "seed", "prompt")


def beside(common: dict[str, object]) -> dict[str, list[dict[str, object]]]:
    """Rows that datasets have beside a record: texts, other engines, what-ifs."""
    engine = {**common, "engine": "physx", "dt_s": 1.0 / 240.0}
    happens = {"event_ids": ["e1"], "completed": [True], "event_times_s": [0.4]}
    return {
        "captions": [{**common, "short": "Two balls collide.", "hit_impulses_ns": [2000.0]}],
        "questions": [{**common, "question_index": 0, "kind": "what_if", "answer": "Yes."}],
        "engine_events": [{**engine, "event_id": "e1", "completed": True, "agrees": True}],
        "what_ifs": [{**engine, "variable": "none", "outcome": "unchanged", **happens}],
    }


def records(run: RunInfo, scenes: int = 3, seeds: int = 2) -> list[SceneRecord]:
    return [
        record(run, f"S{k}", seed, complete=(k + seed) % 3 != 0)
        for k in range(1, scenes + 1)
        for seed in range(seeds)
    ]
