"""What is played of a class, in this process."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
import threading
from typing import Any

from esg.compile.build import Library
from esg.compile.class_run import ClassRun
from esg.engines.scene import Rollout, SimScene
from esg.engines.worlds import Frames

_ONE_AT_A_TIME = threading.Lock()
"""Classes of one library share the shim's state, and PhysX's configuration is the process's."""


@dataclass(frozen=True)
class Job:
    """One replay of one compiled class; plain values only.

    Args:
        library: Path of its shared library.
        create: Symbol of the function in it that makes an instance.
        imports: Its import manifest.
        duration: Of the replay [s].
        dt: Physics step [s].
        record_every: Steps per recorded frame.
        ground_contacts: Whether the contact log includes the ground.
        engine: physx or rapier.
    """

    library: str
    create: str
    imports: dict[str, Any]
    duration: float
    dt: float
    record_every: int
    ground_contacts: bool
    engine: str

    @property
    def frames(self) -> Frames:
        """Its time grid."""
        return Frames.of(self.duration, self.dt, self.record_every)

    @property
    def bodies(self) -> int:
        """How many bodies the class describes."""
        return len(self.imports["components"])


@dataclass(frozen=True)
class Played:
    """What a class did.

    Args:
        rollout: Its motion, one world.
        log: What it wrote with UE_LOG.
        scene: The physical scene it described; None of a class that ran in a child.
    """

    rollout: Rollout
    log: list[str]
    scene: SimScene | None


def play(job: Job) -> Played:
    """Runs a class in this process, which it can do anything to: see `play_confined`.

    Raises:
        ReplayError: If the class does what Unreal would refuse.
    """
    with _ONE_AT_A_TIME:
        run = ClassRun(Library(Path(job.library), job.create, 0.0), job.imports)
        try:
            rollout = run.play(job.engine, job.frames, job.ground_contacts)
        finally:
            run.close()
    return Played(rollout, run.log, run.scene)
