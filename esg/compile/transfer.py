"""Does a scene keep its promises elsewhere? One compiled scene in every engine at every step size.

A scene is searched in one engine and verified in another at one step. Whether its events survive a
change of solver or step says how much of the result is the scene and how much the solver.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from esg.engines.base import ENGINES, MOST_STATES
from esg.engines.manifest import Manifest, load_manifest
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout
from esg.outcomes import UserError
from esg.scenereading import damaged, first_line

if TYPE_CHECKING:
    from esg.graph import EsgDocument
    from esg.metrics.models import SceneVerdict, SuiteScene

MATRIX_ENGINES = ("physx", "rapier", "newton")
MATRIX_RATES_HZ = (120, 240, 480)
REFERENCE = ("physx", 240)
"""Engine and rate that a scene is verified with."""

Proof = Literal["class", "program"]
Trust = Literal["nothing", "equal", "anything"]
"""Which classes are run: none, those that equal their document's emission, or any."""


@dataclass(frozen=True)
class TransferRun:
    """One scene in one engine at one step.

    Args:
        engine: physx, rapier or newton.
        rate_hz: Physics steps a second.
        proof: `class` if the emitted class itself ran, `program` if its control program did.
        sound: Whether the world stayed finite.
        verdict: What the judge says.
        late_s: By event: its time minus that of the reference run [s]; None where either lacks it.
        apart_m: Largest distance of a body from where it ends in the reference run [m].
        note: Why the program was replayed where the class could have been.
    """

    engine: str
    rate_hz: int
    proof: Proof
    sound: bool
    verdict: SceneVerdict
    late_s: dict[str, float | None]
    apart_m: float
    note: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain JSON values."""
        v = self.verdict
        return {
            "engine": self.engine,
            "hz": self.rate_hz,
            "dt": 1.0 / self.rate_hz,
            "proof": self.proof,
            "proof_note": self.note,
            "sound": self.sound,
            "slr": v.slr,
            "n_events": v.n_events,
            "completed": v.completed,
            "ppa": {t: v.ppa(t) for t in ("standard", "strict", "lenient")},  # type: ignore[arg-type]  # literals of a tuple
            "verified": v.verified,
            "events": [
                {
                    "id": e.id,
                    "type": e.type,
                    "completed": e.completed,
                    "time_s": e.time_s,
                    "late_s": self.late_s[e.id],
                    "reason": e.reason,
                }
                for e in v.events
            ],
            "apart_m": self.apart_m,
        }


def replay_scene(
    folder: Path,
    manifest: Manifest,
    engine: str,
    dt: float,
    *,
    trust: Trust = "equal",
    document: EsgDocument | None = None,
) -> tuple[Rollout, Proof]:
    """One replay of a compiled scene: the class in PhysX, elsewhere its control program.

    Where a class is not run because nobody vouched for it, `extra["note"]` of the rollout of its
    program says why.

    Args:
        folder: Scene folder.
        manifest: Its manifest.
        engine: physx, rapier or newton.
        dt: Physics step [s].
        trust: Which classes are run.
        document: What `esg.json` holds, if the caller has read it.

    Raises:
        UserError: If the folder holds no compiled scene or a damaged one, or for an unknown engine.
    """
    check_length(folder, manifest, dt)
    note = ""
    if engine == "physx" and trust != "nothing":
        from esg.compile.build import ClassError, CompilerMissing
        from esg.compile.replay import ForeignClass, ReplayError, replay_class
        from esg.compile.trust.confined import ClassStopped

        try:
            vouched = trust == "anything"
            replay = replay_class(folder, dt=dt, document=document, trust=vouched)
            return replay.rollout, "class"
        except CompilerMissing:
            pass
        except ForeignClass as error:
            note = error.why
        except ClassStopped as error:
            remedy = "leave out --trust, or replay its program in another engine (--engine rapier)"
            raise UserError(f"{folder}/unreal: {error}; {remedy}") from None
        except (ClassError, ReplayError) as error:
            # It compiled and ran when it was written: the files are no longer what they were.
            raise damaged(folder / "unreal", first_line(error)) from None
    batch = batch_programs([manifest.program], manifest.scene.names)
    rollout = get_engine(engine).rollout(manifest.scene, batch, dt=dt)
    return (replace(rollout, extra=rollout.extra | {"note": note}) if note else rollout), "program"


def check_length(folder: Path, manifest: Manifest, dt: float) -> None:
    """Makes sure that a replay can be held before it is begun.

    Raises:
        UserError: If not.
    """
    duration, bodies = manifest.program.duration, len(manifest.scene.bodies)
    if duration / dt * bodies > MOST_STATES:
        raise UserError(
            f"{folder / 'manifest.json'}: {duration:g} s of {bodies} bodies in steps of {dt:g} s "
            "are more than is recorded; replay it in larger steps (--hz)"
        )


def transfer_matrix(
    folder: str | Path,
    expected: SuiteScene,
    *,
    engines: Iterable[str] = MATRIX_ENGINES,
    rates_hz: Iterable[int] = MATRIX_RATES_HZ,
    trust: Trust = "equal",
    document: EsgDocument | None = None,
) -> list[TransferRun]:
    """Replays and judges a scene in every engine at every rate.

    Args:
        folder: Compiled scene folder.
        expected: What must happen.
        engines: Engines, in the order of the result.
        rates_hz: Physics steps a second, in the order of the result.
        trust: Which classes are run.
        document: What `esg.json` holds, if the caller has read it.

    Returns:
        One run per engine and rate. Differences are to PhysX at 240 Hz, or to the first run if
        that pair is not among them.

    Raises:
        UserError: If the folder holds no compiled scene, or for an unknown engine.
    """
    from esg.metrics import judge

    folder = Path(folder)
    manifest = load_manifest(folder / "manifest.json")
    pairs = [(engine, int(rate)) for engine in engines for rate in rates_hz]
    unknown = sorted({e for e, _ in pairs} - set(ENGINES))
    if unknown or not pairs:
        raise UserError(f"unknown engines {unknown}; choose from {', '.join(ENGINES)}")
    reference = REFERENCE if REFERENCE in pairs else pairs[0]
    done: dict[tuple[str, int], tuple[Rollout, Proof, SceneVerdict]] = {}
    for pair in sorted(set(pairs), key=lambda p: (p != reference, pairs.index(p))):
        rollout, proof = replay_scene(
            folder, manifest, pair[0], 1.0 / pair[1], trust=trust, document=document
        )
        verdict = judge(manifest.scene, manifest.program, rollout, expected)
        done[pair] = rollout, proof, verdict
    first, _, truth = done[reference]
    when = {e.id: e.time_s for e in truth.events}
    return [
        TransferRun(
            engine=engine,
            rate_hz=rate,
            proof=proof,
            sound=bool(rollout.valid.all()),
            verdict=verdict,
            late_s={e.id: _difference(e.time_s, when.get(e.id)) for e in verdict.events},
            apart_m=end_distance(rollout, first),
            note=str(rollout.extra.get("note", "")),
        )
        for (engine, rate) in pairs
        for rollout, proof, verdict in [done[engine, rate]]
    ]


def end_distance(one: Rollout, two: Rollout) -> float:
    """Largest distance [m] between the bodies of two rollouts at the end of the shorter one."""
    if one.position.shape[2] == 0:
        return 0.0
    end = min(one.time[-1], two.time[-1])
    places = [r.position[0, np.searchsorted(r.time, end - 1e-9)].astype(float) for r in (one, two)]
    return float(np.linalg.norm(places[0] - places[1], axis=-1).max())


def _difference(time: float | None, reference: float | None) -> float | None:
    return None if time is None or reference is None else time - reference
