"""Replays of scene folders: the recorded one, and other engines to set beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from esg.engines.scene import Rollout, SimScene

ENGINES = ("physx", "rapier", "newton")
ROLLOUT = "rollout.npz"


@dataclass(frozen=True)
class Replayed:
    """One replay of a scene.

    Args:
        scene: The bodies.
        rollout: Their motion.
        proof: `class` if the emitted class ran, `program` if its control program did.
        events: What the judge saw of the scene's events, as JSON.
    """

    scene: SimScene
    rollout: Rollout
    proof: str
    events: list[dict[str, Any]] = field(default_factory=list)


def replays_of(
    folder: Path, metrics: dict[str, Any], engines: Sequence[str] = ()
) -> tuple[Replayed, ...]:
    """The recorded replay of a scene, then those of other engines.

    A folder without the recorded states is replayed again. Of an engine that cannot run here
    nothing is shown.

    Args:
        folder: Scene folder.
        metrics: Its `metrics.json`; empty if the scene never came to a replay.
        engines: Further engines, by name.
    """
    if not metrics or not (folder / "manifest.json").is_file():
        return ()
    from esg.engines.manifest import load_manifest

    manifest = load_manifest(folder / "manifest.json")
    path = folder / ROLLOUT
    recorded = str(metrics["verdict"].get("engine", "physx"))
    if path.is_file():
        from esg.engines.rollout_file import load_rollout

        first = Replayed(manifest.scene, load_rollout(path), metrics["proof"])
    else:
        first = _replay(folder, manifest, recorded)
    # Engines are compared by the scene's own timeline, which is what the others are judged by.
    own = metrics.get("own_timeline", metrics["verdict"])
    first = Replayed(first.scene, first.rollout, first.proof, own["events"])
    others = [_judged(folder, _replay(folder, manifest, e)) for e in engines if e != recorded]
    return (first, *others)


def _replay(folder: Path, manifest: Any, engine: str) -> Replayed:
    from esg.stages import REPLAY_RATE_HZ, proof_kind

    dt = 1.0 / REPLAY_RATE_HZ
    proof = proof_kind(engine)
    if proof == "class":
        from esg.compile import replay_class

        return Replayed(manifest.scene, replay_class(folder, dt=dt).rollout, proof)
    from esg.engines.base import get_engine
    from esg.engines.program import batch_programs

    batch = batch_programs([manifest.program], manifest.scene.names)
    rollout = get_engine(engine).rollout(manifest.scene, batch, dt=dt)
    return Replayed(manifest.scene, rollout, proof)


def _judged(folder: Path, replay: Replayed) -> Replayed:
    """With the judge's verdict against the scene's own timeline."""
    from esg.engines.manifest import load_manifest
    from esg.graph import load_document
    from esg.metrics import expectations_from_timeline, judge

    manifest = load_manifest(folder / "manifest.json")
    expected = expectations_from_timeline(load_document(folder / "esg.json"))
    verdict = judge(manifest.scene, manifest.program, replay.rollout, expected)
    events = verdict.to_json()["events"]
    return Replayed(replay.scene, replay.rollout, replay.proof, events)
