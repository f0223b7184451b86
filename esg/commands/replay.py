"""`esg replay`: a finished scene again, in an engine of choice."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter


def replay(
    scene: str,
    *,
    engine: Literal["physx", "rapier", "newton"] = "physx",
    hz: int = 240,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Replay a scene folder and judge it against its own timeline.

    Args:
        scene: Scene folder, or id of one below ./runs.
        engine: physx runs the emitted class; rapier and newton run its control program.
        hz: Physics steps a second.
        json: Print one JSON document: the verdict.
    """
    from esg.commands.console import emit
    from esg.commands.inputs import find_scene
    from esg.outcomes import UserError

    if not 30 <= hz <= 4000:
        raise UserError(f"--hz {hz}: choose 30 to 4000 steps a second")
    folder = find_scene(scene)
    result = run(folder, engine, 1.0 / hz)
    if json:
        emit(result)
    else:
        print(f"{folder}: {result['engine']} at {hz} Hz, proof: {result['proof']}")
        for event in result["verdict"]["events"]:
            mark = "done" if event["completed"] else "NOT DONE"
            when = f"at {event['time_s']:.2f} s" if event["time_s"] is not None else ""
            bodies = ", ".join(event["bodies"])
            line = f"  {mark:8} {event['id']} {event['type']} {bodies} {when} {event['reason']}"
            print(line.rstrip())
        print(f"  layout {'valid' if result['verdict']['slr'] else 'INVALID'}")
    return 0 if result["verdict"]["verified"] else 3


def run(folder: Path, engine: str, dt: float) -> dict[str, Any]:
    """Replays and judges one scene folder.

    Args:
        folder: Scene folder.
        engine: physx, rapier or newton.
        dt: Physics step [s].

    Raises:
        UserError: If the folder holds no compiled scene.
    """
    from esg.engines.base import get_engine
    from esg.engines.manifest import load_manifest
    from esg.engines.program import batch_programs
    from esg.graph import load_document
    from esg.metrics import expectations_from_timeline, judge
    from esg.outcomes import UserError
    from esg.stages import proof_kind

    if not (folder / "manifest.json").exists():
        raise UserError(f"{folder} holds no compiled scene; its log.jsonl says why")
    manifest = load_manifest(folder / "manifest.json")
    proof = proof_kind(engine)
    if proof == "class":
        from esg.compile import replay_class

        rollout = replay_class(folder, dt=dt).rollout
    else:
        batch = batch_programs([manifest.program], manifest.scene.names)
        rollout = get_engine(engine).rollout(manifest.scene, batch, dt=dt)
    expected = expectations_from_timeline(load_document(folder / "esg.json"))
    verdict = judge(manifest.scene, manifest.program, rollout, expected)
    return {
        "scene": str(folder),
        "engine": engine,
        "dt": dt,
        "proof": proof,
        "verdict": verdict.to_json(),
    }
