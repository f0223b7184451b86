"""What an engine is: scene + program + many candidates -> rollouts with a contact log."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from esg.engines.program import ProgramBatch
from esg.engines.scene import Rollout, SimScene, Variation

ENGINES = ("newton", "physx", "rapier")
SURROGATE = "surrogate"
"""For searches only: it takes no part in verification, so `ENGINES` does not name it."""
CUDA_BREADTH = 64
"""Candidates of one scene that the surrogate plays on a GPU in about the time of one."""
MOST_STATES = 20_000_000
"""Frames times bodies of one replay: a gigabyte of poses and velocities."""

VERIFY_DT_S = 1.0 / 240.0


@runtime_checkable
class Engine(Protocol):
    """A rigid-body engine that executes control programs.

    Engines are deterministic: the same arguments give the same bytes. They may keep compiled models
    between calls, keyed by the scene; nothing else survives a call.
    """

    name: str

    def rollout(
        self,
        scene: SimScene,
        batch: ProgramBatch,
        *,
        dt: float = VERIFY_DT_S,
        record_every: int = 1,
        duration: float | None = None,
        variation: Variation | None = None,
        ground_contacts: bool = False,
    ) -> Rollout:
        """Simulates every world of the batch.

        Args:
            scene: Bodies and materials.
            batch: W programs.
            dt: Physics step [s].
            record_every: Steps per recorded frame; contacts are accumulated over a frame.
            duration: [s]; default the batch's.
            variation: Per-world changes of the scene.
            ground_contacts: Whether the log includes contacts with the ground.

        Returns:
            Rollout of W worlds.
        """
        ...


def breadth(device: str) -> int:
    """Candidates that the surrogate plays on a device in about the time of one."""
    return 1 if device == "cpu" else CUDA_BREADTH
