"""From a file to a verdict."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
import re
from typing import Any

import numpy as np

from esg.engines.program import Program
from esg.engines.scene import Rollout, SimScene
from esg.judging.bodies import DENSITY_KG_M3, Played, played
from esg.judging.contacts import contacts_of
from esg.judging.control import program_of
from esg.judging.readers import read_recording
from esg.judging.recording import FRAMES, Faults, Recording
from esg.judging.velocities import spins, velocities
from esg.metrics.constraints import unmeasured
from esg.metrics.judging import bind_all, judge
from esg.metrics.models import SceneVerdict, Suite, SuiteScene
from esg.outcomes import UserError

NO_FILE = "no file"
"""Instead of an outcome, of a run that nobody handed in."""


@dataclass(frozen=True)
class Judged:
    """A file before the judge.

    Args:
        file: Its path.
        format: Of the file.
        verdict: What the judge says.
        hz: Frames a second.
        notes: What was recomputed or guessed because the file does not tell it.
        scene: The bodies that were judged.
        program: What is taken for their own doing.
        rollout: Their motion.
    """

    file: Path
    format: str
    verdict: SceneVerdict
    hz: float
    notes: tuple[str, ...]
    scene: SimScene
    program: Program
    rollout: Rollout

    def to_json(self) -> dict[str, Any]:
        """What `--json` tells of it."""
        return {
            "file": str(self.file),
            "format": self.format,
            "suite_scene": self.verdict.suite_scene,
            "frames_per_second": self.hz,
            "notes": list(self.notes),
            "verified": self.verdict.verified,
            "verdict": self.verdict.to_json(),
        }


def judge_file(
    path: Path, expected: SuiteScene, *, frame: str = "z-up", names: Mapping[str, str] | None = None
) -> Judged:
    """Judges the motion that a file holds.

    Args:
        path: Of the file; its suffix tells the format.
        expected: What must happen.
        frame: Of `FRAMES`, for formats that do not state their own.
        names: Words for bodies of the file, by name.

    Raises:
        UserError: With everything that is wrong with the file.
    """
    faults = Faults(path)
    recording = named(read_recording(path, FRAMES[frame], faults), names or {}, faults)
    notes = list(recording.notes)
    if recording.rollout is not None and recording.manifest is not None:
        scene, program, rollout = (
            recording.manifest.scene, recording.manifest.program, recording.rollout,
        )  # fmt: skip
        unweighed: frozenset[str] = frozenset()
    else:
        bodies = _without_scenery(played(recording, faults), expected, notes)
        rollout = _rollout(recording, bodies, expected, notes)
        scene, program = _under_control(recording, bodies, rollout, notes)
        unweighed = bodies.unweighed
    verdict = judge(scene, program, rollout, expected)
    if unweighed:
        verdict = _without_guesses(verdict, expected, unweighed, notes)
    hz = 1.0 / float(np.median(np.diff(rollout.time)))
    return Judged(path, recording.format, verdict, hz, tuple(notes), scene, program, rollout)


def named(recording: Recording, names: Mapping[str, str], faults: Faults) -> Recording:
    """The recording with other words for some of its bodies.

    Raises:
        UserError: If a name is none of a body.
    """
    known = {thing.name for thing in recording.things}
    if recording.manifest is not None:
        known = set(recording.manifest.scene.names)
    for name in names:
        if name not in known:
            listed = ", ".join(sorted(known)[:12])
            faults.add(f"--names tells of {name!r}, which is no body of it; it has {listed}")
    faults.stop()
    if not names:
        return recording
    things = tuple(replace(t, label=names.get(t.name, t.label)) for t in recording.things)
    manifest = recording.manifest
    if manifest is not None:
        bodies = tuple(replace(b, label=names.get(b.name, b.label)) for b in manifest.scene.bodies)
        manifest = replace(manifest, scene=manifest.scene.with_bodies(bodies))
    return replace(recording, things=things, manifest=manifest)


def _without_scenery(bodies: Played, expected: SuiteScene, notes: list[str]) -> Played:
    """The bodies; what only stands there and nobody means is looked at, not run into.

    The hull of a meadow with trees or of a room would be around everything.
    """
    meant: set[int] = set()
    for binding in bind_all(bodies.scene, expected).values():
        meant |= set(binding.bodies)
    own = [
        replace(body, shapes=()) if body.static and body.name in bodies.drawn and k not in meant
        else body
        for k, body in enumerate(bodies.scene.bodies)
    ]  # fmt: skip
    left = [b.name for b, o in zip(own, bodies.scene.bodies, strict=True) if b is not o]
    if left:
        told = ", ".join(left[:5])
        notes.append(f"what never moves and no phrase means collides with nothing: {told}")
    return replace(bodies, scene=bodies.scene.with_bodies(tuple(own)))


def _rollout(
    recording: Recording, bodies: Played, expected: SuiteScene, notes: list[str]
) -> Rollout:
    contacts = recording.contacts
    if contacts is None:
        bound = bind_all(bodies.scene, expected).values()
        about = {body for binding in bound for body in binding.bodies}
        contacts = contacts_of(bodies, recording.time, None if expected.statements else about)
        notes.append(
            "contacts are recomputed from shapes and poses, impulses from changes of velocity"
        )
    velocity, spin = bodies.velocity, bodies.spin
    if velocity is None:
        velocity = velocities(bodies.position, recording.time, contacts)
        notes.append("velocities are differences of positions")
    if spin is None:
        spin = spins(bodies.quaternion, recording.time)
    step = float(np.median(np.diff(recording.time)))
    return Rollout(
        engine=recording.format,
        dt=step,
        time=recording.time,
        position=bodies.position[None].astype(np.float32),
        quaternion=bodies.quaternion[None].astype(np.float32),
        linear_velocity=velocity[None].astype(np.float32),
        angular_velocity=spin[None].astype(np.float32),
        contacts=contacts,
        valid=np.array([bool(np.isfinite(velocity).all())]),
    )


def _under_control(
    recording: Recording, bodies: Played, rollout: Rollout, notes: list[str]
) -> tuple[SimScene, Program]:
    """Scene and program: the manifest's, or what the motion looks like."""
    if recording.manifest is not None:
        return bodies.scene, recording.manifest.program
    velocity = rollout.linear_velocity[0].astype(float)
    program = program_of(bodies, velocity, rollout.contacts, recording.time)
    notes.append(
        "the file has no control program: what starts to move or slows down untouched did so itself"
    )
    driven = {p.body for p in program.primitives}
    own = tuple(replace(b, active=b.name in driven) for b in bodies.scene.bodies)
    return bodies.scene.with_bodies(own), program


def _without_guesses(
    verdict: SceneVerdict, expected: SuiteScene, unweighed: frozenset[str], notes: list[str]
) -> SceneVerdict:
    """The verdict without masses that are our guess and not the file's."""
    guess = f"{DENSITY_KG_M3:g} kg per cubic metre of their shapes"
    notes.append(f"{len(unweighed)} bodies have no mass in the file: {guess}")
    constraints = [
        unmeasured(asked, "the file gives it no mass")
        if asked.quantity == "mass"
        and unweighed & set(verdict.bindings.get(asked.object or "", ()))
        else scored
        for asked, scored in zip(expected.constraints, verdict.constraints, strict=True)
    ]
    return verdict.model_copy(update={"constraints": tuple(constraints)})


def scene_for(path: Path, suite: Suite, wanted: str | None = None) -> SuiteScene:
    """The scene of a suite that a file is about: as asked, else by its name or its folder's.

    Args:
        path: Of the file: `S6.glb`, `S6-run2.csv` or `S6-run2/scene.glb`.
        suite: The suite.
        wanted: Id of the scene; None: look at the name.

    Raises:
        UserError: If that names none.
    """
    ids = {scene.id.lower(): scene for scene in suite.scenes}
    listed = ", ".join(scene.id for scene in suite.scenes[:12])
    if wanted is not None:
        if wanted.lower() not in ids:
            raise UserError(f"--scene {wanted!r}: {suite.suite} has {listed}")
        return ids[wanted.lower()]
    for name in (path.name.split(".")[0], path.absolute().parent.name):
        key = re.sub(r"[-_ ](run)?[-_ ]?\d+$", "", name.lower())
        for candidate in (name.lower(), key):
            if candidate in ids:
                return ids[candidate]
    if len(suite.scenes) == 1:
        return suite.scenes[0]
    raise UserError(
        f"{path} does not name a scene of {suite.suite}: give --scene ID, one of {listed}"
    )


def runs_of(suite: Suite, judged: Sequence[tuple[SuiteScene, Judged]]) -> dict[str, Any]:
    """The report of `esg bench` over judged files; what has no file did nothing.

    Args:
        suite: The suite.
        judged: Files, each with its scene.
    """
    from esg.metrics.aggregate import SceneRun, bench_json

    found: dict[str, list[SceneRun]] = {scene.id: [] for scene in suite.scenes}
    for scene, one in judged:
        verdict = one.verdict
        outcome = "solved" if verdict.verified else "not_converged"
        found[scene.id].append(SceneRun(len(found[scene.id]), verdict, outcome, 0.0))
    most = max((len(runs) for runs in found.values()), default=0)
    for runs in found.values():
        runs += [SceneRun(k, None, NO_FILE, 0.0) for k in range(len(runs), most)]
    first = judged[0][1]
    report = bench_json(
        suite, found, strategy="trajectories", engine=first.format, dt=first.rollout.dt
    )
    return report | {"files": [one.to_json() for _, one in judged]}
