"""Plausibility of a replay: what physics, tyres, legs and the ground would not have allowed.

Every check is a measured value against a limit of a table (`motion.csv`, `limits.csv`), whatever
the program meant: docs/metrics/plausibility.md.
"""

from __future__ import annotations

from collections.abc import Callable

from esg.engines.program import Program
from esg.engines.scene import Rollout, SimScene
from esg.metrics.plausibility import bodies, driving
from esg.metrics.plausibility.facts import Facts
from esg.metrics.plausibility.record import Check, Plausibility
from esg.metrics.plausibility.told import Told, told_of
from esg.metrics.replay import Replay

__all__ = ["CHECKS", "Check", "Plausibility", "Told", "assess", "told_of"]

CHECKS: dict[str, Callable[[Facts], Check]] = {
    "acceleration": driving.acceleration,
    "braking": driving.braking,
    "side_slip": driving.side_slip,
    "rolling": bodies.rolling,
    "energy": bodies.energy,
    "hovering": bodies.hovering,
    "penetration": bodies.penetration,
    "motion_before": bodies.motion_before,
    "leaving": driving.leaving,
    "speed": driving.speed,
}
"""All checks by name, in the order of the documentation."""


def assess(
    scene: SimScene, program: Program, rollout: Rollout, told: Told, *, world: int = 0
) -> Plausibility:
    """Checks one world of a rollout.

    Args:
        scene: The scene that was simulated.
        program: The control program that was executed: says what is driven, held or let go when.
        rollout: Trajectories and contact log, with or without contacts of the ground.
        told: What the scene's document says beside its physics.
        world: Which world of the rollout.

    Returns:
        Every check; of a world that diverged, one that says so.
    """
    replay = Replay(scene, program, rollout, world)
    if not replay.valid:
        failed = Check(name="energy", unit="J", ok=False, note="the simulation diverged")
        return Plausibility(checks=(failed,))
    facts = Facts(replay, told)
    return Plausibility(checks=tuple(check(facts) for check in CHECKS.values()))
