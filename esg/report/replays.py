"""Replays of scene folders: the recorded one, and other engines to set beside it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.engines.scene import Rollout, SimScene
from esg.outcomes import UserError
from esg.scenereading import absent, collected, read_manifest, read_rollout

if TYPE_CHECKING:
    from esg.engines.manifest import Manifest

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
    folder: Path,
    metrics: dict[str, Any],
    engines: Sequence[str] = (),
    problems: list[str] | None = None,
) -> tuple[Replayed, ...]:
    """The recorded replay of a scene, then those of other engines.

    A folder without the recorded states is replayed again. Of an engine that cannot run here
    nothing is shown.

    Args:
        folder: Scene folder.
        metrics: Its `metrics.json`; empty if the scene never came to a replay.
        engines: Further engines, by name.
        problems: Receives what is wrong with files that had to be done without.

    Raises:
        UserError: For a damaged file, if there is no `problems` to tell it.
    """
    if not metrics or absent(folder / "manifest.json"):
        return ()
    told: list[str] = []
    found = _found(folder, metrics, engines, told)
    if problems is None and told:
        raise UserError(told[0])
    if problems is not None:
        problems += told
    return found


def _found(
    folder: Path, metrics: dict[str, Any], engines: Sequence[str], told: list[str]
) -> tuple[Replayed, ...]:
    manifest = collected(told, lambda: read_manifest(folder / "manifest.json"), None)
    if manifest is None:
        return ()
    path, scene = folder / ROLLOUT, manifest.scene
    recorded = str(metrics["verdict"]["engine"])
    first = None
    if not absent(path):
        rollout = collected(told, lambda: read_rollout(path, len(scene.bodies)), None)
        first = None if rollout is None else Replayed(scene, rollout, metrics["proof"])
    if first is None:
        first = collected(told, lambda: _replay(folder, manifest, recorded), None)
    # Engines are compared by the scene's own timeline, which is what the others are judged by.
    events = metrics.get("own_timeline", metrics["verdict"])["events"]
    replays = [] if first is None else [replace(first, events=events)]
    for engine in engines:
        if engine != recorded:
            run = partial(_compared, folder, manifest, engine)
            replays += filter(None, [collected(told, run, None)])
    return tuple(replays)


def _compared(folder: Path, manifest: Manifest, engine: str) -> Replayed:
    return _judged(folder, _replay(folder, manifest, engine))


def _replay(folder: Path, manifest: Manifest, engine: str) -> Replayed:
    from esg.compile.transfer import replay_scene
    from esg.stages import REPLAY_RATE_HZ

    # To look at a scene never runs code that came with it.
    rollout, proof = replay_scene(folder, manifest, engine, 1.0 / REPLAY_RATE_HZ, trust="nothing")
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
