"""Many worlds in one engine: those of one scene share a rollout, and an error ends only its own."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
import time

import numpy as np

from esg.dataset.whatifs.worlds import World
from esg.engines.program import Program, batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout, SimScene, Variation
from esg.scenereading import first_line


@dataclass(frozen=True)
class Played:
    """What became of a world in an engine.

    Args:
        world: The world.
        engine: physx, rapier or newton.
        dt: Physics step [s].
        rollout: Its rollout, possibly of several worlds; None if the engine failed.
        number: Which world of the rollout.
        reason: Why there is no rollout.
        seconds: Its share of the time that was spent [s].
    """

    world: World
    engine: str
    dt: float
    rollout: Rollout | None
    number: int = 0
    reason: str = ""
    seconds: float = 0.0

    @property
    def sound(self) -> bool:
        """Whether the engine played it to the end."""
        return self.rollout is not None and bool(self.rollout.valid[self.number])


def play(worlds: Sequence[World], engine: str, dt: float) -> list[Played]:
    """Replays worlds in one engine at one step, in their order.

    Worlds that differ in mass, friction, poses and numbers of the program share one rollout; others
    (another gravity, a body less, another length) have one each. No world sees the others, so that
    the unchanged scene is the same in whatever company.

    Args:
        worlds: Of one scene.
        engine: physx, rapier or newton.
        dt: Physics step [s].
    """
    out: dict[int, Played] = {}
    for group in _alike(worlds):
        start = time.perf_counter()
        rollout, reason = None, ""
        try:
            rollout = _rollout([worlds[k] for k in group], engine, dt)
        except Exception as error:  # an engine that refuses a scene is a row, not a failed scene
            reason = f"{type(error).__name__}: {first_line(error)}"
        share = (time.perf_counter() - start) / len(group)
        for number, k in enumerate(group):
            out[k] = Played(worlds[k], engine, dt, rollout, number, reason, share)
    return [out[k] for k in range(len(worlds))]


def _rollout(worlds: Sequence[World], engine: str, dt: float) -> Rollout:
    scene, duration = worlds[0].scene, worlds[0].duration
    bodies = [w.scene.bodies for w in worlds]
    mass = np.ones((len(worlds), len(scene.bodies)))
    for k, world in enumerate(worlds):
        if world.mass_scale != 1.0:
            mass[k, scene.index(world.body)] = world.mass_scale
    variation = Variation(
        quaternion=np.array([[b.quaternion for b in row] for row in bodies], float),
        mass_scale=mass,
        friction_scale=np.array([w.friction_scale for w in worlds]),
    )
    batch = batch_programs([w.program for w in worlds], scene.names)
    return get_engine(engine).rollout(
        scene, batch, dt=dt, duration=duration, variation=variation, ground_contacts=False
    )


def _alike(worlds: Sequence[World]) -> list[list[int]]:
    """Numbers of the worlds that can share a rollout, in the order of their first."""
    groups: list[list[int]] = []
    for k, world in enumerate(worlds):
        for group in groups:
            if _shareable(worlds[group[0]], world):
                group.append(k)
                break
        else:
            groups.append([k])
    return groups


def _shareable(a: World, b: World) -> bool:
    return (
        a.duration == b.duration
        and _without_poses(a.scene) == _without_poses(b.scene)
        and _structure(a.program) == _structure(b.program)
    )


def _without_poses(scene: SimScene) -> object:
    """What of a scene all worlds of a rollout must have alike: orientations may differ."""
    bodies = tuple(_fixed(b) for b in scene.bodies)
    return bodies, scene.gravity, scene.joints, scene.regions


def _fixed(body: object) -> tuple[object, ...]:
    return tuple(v for k, v in vars(body).items() if k != "quaternion")


def _structure(program: Program) -> list[tuple[str, str]]:
    return [(p.kind, p.body) for p in program.primitives]
