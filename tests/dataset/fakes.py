"""Stages that take no time: the prompt says what becomes of a scene.

A prompt with `bug` crashes in layout, `hangs` stays there for a minute
(`pauses` only the first time), `busy` meets an error that passes at the second try, `user`
is refused by resolve, `bad` is drafted with a violation, `wrong` replays with its second event
missing, `half` ends with words that are not shown. All others replay two balls that hit a third.
"""

from __future__ import annotations

from collections.abc import Callable
import json
import os
from pathlib import Path
import time
from typing import Any

from esg import stages
from esg.engines.manifest import manifest_bytes, manifest_to_json
from esg.engines.rollout_file import save_rollout
from esg.fidelity import statement_rows
from esg.metrics import SuiteScene
from esg.outcomes import UserError
from esg.pipeline import SceneState
from esg.stages import Spec
from tests.metrics.test_events import CHAIN, chain
from tests.metrics.worlds import DT

STAGES = ("draft", "resolve", "cast", "layout", "optimize", "compile", "replay", "judge")
_CALLS = "ESG_TEST_CALLS"
"""Environment variable with a file that every stage run is noted in."""


def note_calls(path: Path) -> None:
    os.environ[_CALLS] = str(path)


def calls() -> list[str]:
    """`stage prompt` of every stage that really ran."""
    path = Path(os.environ[_CALLS])
    return path.read_text().splitlines() if path.exists() else []


def install() -> None:
    """Replaces the stages of this process; their documents have no assets to draw."""
    from esg.dataset import writing

    writing._meshes = lambda job, state, row: ([], [])  # type: ignore[assignment]  # same signature
    for name, run in _RUNS.items():
        inputs = stages.SPECS[name].inputs
        stages.SPECS[name] = Spec(_noted(name, run), inputs, stages.SPECS[name].options)
    stages.conclude = _conclude  # type: ignore[assignment]  # same signature


def in_worker(function: Callable[..., Any], *args: Any) -> Any:
    """Calls a function in a process that may not have these stages yet."""
    from esg.dataset import running

    install()
    running._compile_together = lambda states: None  # type: ignore[assignment]
    return function(*args)


def _noted(
    name: str, run: Callable[[SceneState, Path], None]
) -> Callable[[SceneState, Path], None]:
    def noted(state: SceneState, folder: Path) -> None:
        path = os.environ.get(_CALLS)
        if path:
            with open(path, "a") as file:
                file.write(f"{name} {state.request.prompt}\n")
        run(state, folder)

    return noted


def _world(state: SceneState):
    return chain(0.4, 99.0 if "wrong" in state.request.prompt else 0.8)


def _document(state: SceneState, folder: Path) -> None:
    prompt = state.request.prompt
    half, at = "half" in prompt, prompt.find("half")
    said = {"id": "s1", "predicate": "not_represented", "text": "Half", "start": at,
            "end": at + 4, "note": "no halves"}  # fmt: skip
    text = {"scene_definition": {"scene_id": "fake"}, "prompt": prompt,
            "coverage": {"items": []}, "statements": [said] if half else None}  # fmt: skip
    (folder / "esg.json").write_text(json.dumps(text))


def _draft(state: SceneState, folder: Path) -> None:
    _document(state, folder)
    found = [{"code": "CYCLE", "message": "a cycle"}] if "bad" in state.request.prompt else []
    (folder / "violations.json").write_text(json.dumps(found))


def _resolve(state: SceneState, folder: Path) -> None:
    if "user" in state.request.prompt:
        raise UserError("no such asset")
    _document(state, folder)


def _layout(state: SceneState, folder: Path) -> None:
    prompt = state.request.prompt
    if "bug" in prompt:
        raise ZeroDivisionError("a defect")
    if "deadly" in prompt:
        os._exit(9)
    if "pauses" in prompt and calls().count(f"layout {prompt}") < 2:
        time.sleep(60.0)
    if "hangs" in prompt:
        time.sleep(60.0)
    if "busy" in prompt and calls().count(f"layout {prompt}") < 2:
        raise ConnectionResetError("try again")
    _document(state, folder)


def _compile(state: SceneState, folder: Path) -> None:
    world = _world(state)
    data = manifest_to_json(
        world.scene, world.program, dt=DT, extra={"prompt": state.request.prompt}
    )
    (folder / "manifest.json").write_bytes(manifest_bytes(data))


def _replay(state: SceneState, folder: Path) -> None:
    save_rollout(_world(state).rollout(), folder / "rollout.npz")


def _judge(state: SceneState, folder: Path) -> None:
    request = state.request
    events = CHAIN
    if request.suite_scene:
        events = list(SuiteScene.model_validate_json(request.suite_scene).events) or CHAIN
        events = CHAIN if events[0].a not in ("ball 1", "ball 2") else events
    verdict = _world(state).judge(events)
    verdict = verdict.model_copy(update={"engine": "physx"})
    metrics: dict[str, Any] = {"verdict": verdict.to_json(), "proof": "class"}
    document = json.loads((state.artifact("optimize") / "esg.json").read_bytes())
    metrics["statements"] = statement_rows(document, [])
    fast = "rockets" in request.prompt
    check = {"name": "speed", "unit": "m/s", "ok": not fast, "measured": 900.0 if fast else 3.0,
             "limit": 47.3, "body": "ball_1", "time_s": 0.0, "note": ""}  # fmt: skip
    worst = "ball_1: speed 900 m/s, limit 47.3 m/s" if fast else ""
    metrics["plausibility"] = {"plausible": not fast, "worst": worst, "checks": [check]}
    (folder / "metrics.json").write_text(json.dumps(metrics))


def _conclude(stage: str, state: SceneState):
    from esg.outcomes import Outcome

    if stage == "draft" and "bad" in state.request.prompt:
        return Outcome.INVALID_DRAFT, "CYCLE: a cycle"
    if stage != "judge":
        return None, ""
    return (Outcome.PARTIAL if "half" in state.request.prompt else Outcome.SOLVED), ""


def write_mcap(path: Path, *_: object) -> None:
    """A recording: its name."""
    path.write_text(path.name)


_RUNS = {
    "draft": _draft,
    "resolve": _resolve,
    "cast": _document,
    "layout": _layout,
    "optimize": _document,
    "compile": _compile,
    "replay": _replay,
    "judge": _judge,
}
