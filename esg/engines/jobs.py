"""Rollouts as plain arrays: what the surrogate and Newton simulate, of one scene or of many.

Nothing here needs a GPU or Warp, so that preparing and reading rollouts can be spread over
processes. A job is one scene's rollout: W worlds, B bodies of which D move, P primitives, T frames.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass, replace
import math
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from esg.engines.base import SURROGATE
from esg.engines.breaking.stances import fill_in, own_names, stances
from esg.engines.breaking.swap import brittle, unpark
from esg.engines.program import Action, Column, ProgramBatch
from esg.engines.rest import starts_at_rest
from esg.engines.scene import ContactLog, Rollout, SimScene, Variation
from esg.engines.shapes import SceneShapes
from esg.engines.traction import features, has_tyres
from esg.engines.worlds import MAX_SPEED_MPS, Frames, Start, join_logs, moving

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]

_T = TypeVar("_T")
Pieces = Generator[None, None, _T]
"""Work in pieces, between which others may use the device, and its result."""

TUNNELLED_M = 0.3
"""A body whose centre is this far below the ground has passed through it."""

_ALIGN = 64


class Buffer:
    """Memory that results are written to before they are read; simulating again reuses it.

    Args:
        array: Bytes, shape [n].
    """

    def __init__(self, array: NDArray[np.uint8]) -> None:
        self.array = array
        self.used = 0

    def take(self, shape: tuple[int, ...]) -> tuple[int, NDArray[np.float32]]:
        """Room for single precision numbers: its offset in bytes and the array itself."""
        n = 4 * int(np.prod(shape))
        at = -(-self.used // _ALIGN) * _ALIGN
        if at + n > len(self.array):
            raise MemoryError(f"results need more than {len(self.array)} bytes")
        self.used = at + n
        return at, self.array[at : at + n].view(np.float32).reshape(shape)


@dataclass
class Job:
    """One scene's rollout.

    Args:
        engine: surrogate or newton.
        key: Number of the scene; jobs of one key have equal shapes.
        shapes: The scene; None if the simulating process has it from an earlier job of the key.
        frames: The time grid.
        position, quaternion: Starts, shape [W, B, 3] and [W, B, 4].
        mass: [kg], shape [W, B]; `friction` and `restitution` likewise.
        damping: Linear and angular [1/s], the same in all worlds, shape [B, 2].
        inertia: Of moving bodies, shape [W, D, 3, 3]; empty for the surrogate.
        ground: Two frictions and the restitution, shape [W, 3].
        friction_scale: Shape [W].
        asleep: Bodies that rest where they start, for the surrogate, shape [W, B].
        features: Of the bodies for the ground (`esg.engines.traction.features`), [B, FEATURES].
        kind, body, until, table: The programs (`ProgramBatch`).
        joint: Number of the joint that a primitive drives, -1 for none, shape [P].
        ground_contacts: Whether the log includes contacts with the ground.
    """

    engine: str
    key: int
    shapes: SceneShapes | None
    frames: Frames
    position: Singles
    quaternion: Singles
    mass: NDArray[np.float64]
    damping: NDArray[np.float64]
    friction: Singles
    restitution: Singles
    inertia: Singles
    ground: Singles
    friction_scale: Singles
    asleep: NDArray[np.bool_]
    features: Singles
    kind: Ints
    body: Ints
    until: NDArray[np.bool_]
    table: NDArray[np.float64]
    joint: Ints
    ground_contacts: bool = False

    @property
    def n_worlds(self) -> int:
        return len(self.mass)

    @property
    def grounded(self) -> bool:
        """Whether there are brakes or tyres."""
        braking = self.table[:, self.kind == Action.ADJUST, Column.BRAKING]
        return bool(np.isfinite(braking).any()) or has_tyres(self.features)

    def of_worlds(self, worlds: NDArray[np.int64]) -> Job:
        """The same for some of the worlds, in their order; a world may be named twice."""
        per_world = ("position", "quaternion", "mass", "friction", "restitution", "ground",
                     "friction_scale", "asleep", "table")  # fmt: skip
        inertia = self.inertia[worlds] if len(self.inertia) else self.inertia
        return replace(self, inertia=inertia, **{n: getattr(self, n)[worlds] for n in per_world})


@dataclass(frozen=True)
class Expected:
    """A job that is going to be handed in."""

    key: int
    n_worlds: int
    frames: Frames


@dataclass
class Played:
    """What a job's simulation gives; arrays may be views of memory that is used again.

    Args:
        position, quaternion, linear, angular: Of moving bodies from frame 1 on, in any order of
            axes that `moveaxis` names, shape [W, T - 1, D, 3 or 4].
        end: First frame that is not sound, or the number of frames, shape [W]; None if nobody has
            looked yet.
        deepest: Largest overlap [m], shape [W]; None if the engine does not tell.
        log: The contact log, sorted; without an end it goes on after broken frames.
    """

    position: Singles
    quaternion: Singles
    linear: Singles
    angular: Singles
    end: NDArray[np.int64] | None
    deepest: Singles | None
    log: ContactLog

    def first(self, n: int) -> Played:
        """The same for the first n worlds."""
        log = self.log
        keep = log.world < n
        return Played(
            *(a[:n] for a in (self.position, self.quaternion, self.linear, self.angular)),
            end=None if self.end is None else self.end[:n],
            deepest=None if self.deepest is None else self.deepest[:n],
            log=ContactLog(**{k: getattr(log, k)[keep] for k in log.__dataclass_fields__}),
        )


def make_job(
    engine: str,
    key: int,
    scene: SimScene,
    shapes: SceneShapes,
    batch: ProgramBatch,
    *,
    dt: float,
    record_every: int,
    variation: Variation | None,
) -> tuple[Job, Start]:
    """The job of a rollout, and what its result is written into.

    Args:
        engine: surrogate or newton.
        key: Number of the scene.
        scene, batch, dt, record_every, variation: As `Engine.rollout`.
        shapes: Of the scene.

    Raises:
        ValueError: For what no engine can simulate.
    """
    start = Start.of(
        scene, batch, dt=dt, record_every=record_every, duration=None, variation=variation
    )
    return job_of(engine, key, start, shapes), start


def job_of(
    engine: str,
    key: int,
    start: Start,
    shapes: SceneShapes | None,
    *,
    ground_contacts: bool = False,
) -> Job:
    """The job of a rollout.

    Args:
        engine: surrogate or newton.
        key: Number of the scene.
        start: What the rollout starts from.
        shapes: The scene, if the one that simulates does not have it.
        ground_contacts: Whether the log includes contacts with the ground.

    Raises:
        ValueError: If the surrogate is asked for a scene with joints or with what breaks.
    """
    if engine == SURROGATE:
        refuse_what_it_lacks(start.scene)
    v, batch, bodies, single = start.values, start.batch, start.scene.bodies, np.float32
    inertia = np.zeros((0,), single)
    asleep = np.zeros(v.mass.shape, bool)
    if engine == "newton":
        inertia = v.inertia[:, np.nonzero(moving(start.scene))[0]].astype(single)
    elif not ground_contacts:
        # A log that is to show the weight of what rests needs it awake.
        asleep = starts_at_rest(start.scene, v.position, v.quaternion)
    return Job(
        engine=engine,
        key=key,
        shapes=shapes,
        frames=start.frames,
        position=v.position.astype(single),
        quaternion=v.quaternion.astype(single),
        mass=v.mass,
        damping=np.array([(b.linear_damping, b.angular_damping) for b in bodies]).reshape(-1, 2),
        friction=v.friction.astype(single),
        restitution=v.restitution.astype(single),
        inertia=inertia,
        ground=v.ground.astype(single),
        friction_scale=v.friction_scale.astype(single),
        asleep=asleep,
        features=features(start.scene).astype(single),
        kind=batch.kind,
        body=batch.body,
        until=batch.until,
        table=batch.table,
        joint=_joints(start.scene, batch),
        ground_contacts=ground_contacts,
    )


def refuse_what_it_lacks(scene: SimScene) -> None:
    """Raises a ValueError for a scene that the surrogate cannot simulate."""
    if scene.joints:
        raise ValueError(
            f"{scene.scene_id!r} has joints, which the surrogate cannot simulate; take another"
        )
    if brittle(scene) or stances(scene):
        what = "break" if brittle(scene) else "change their posture"
        raise ValueError(
            f"{scene.scene_id!r} has bodies that {what}, which the surrogate cannot simulate; take "
            "another"
        )


def _joints(scene: SimScene, batch: ProgramBatch) -> Ints:
    index = {j.name: k for k, j in enumerate(scene.joints)}
    named = batch.joint or ("",) * len(batch.kind)
    return np.array([index.get(name, -1) for name in named], np.int32)


def read(job: Job, start: Start, played: Played) -> Rollout:
    """The rollout of a job: states of what stands still filled in, broken worlds frozen."""
    overlaps = played.deepest is not None
    return finish(job.engine, start, [(np.arange(job.n_worlds), played)], overlaps=overlaps)


def finish(
    engine: str,
    start: Start,
    parts: list[tuple[NDArray[np.int64], Played]],
    extra: dict[str, Any] | None = None,
    *,
    overlaps: bool = False,
) -> Rollout:
    """The rollout of worlds that were simulated in parts; worlds in no part keep their start.

    Args:
        engine: Its name.
        start: What the rollout started from; its states and validity are written.
        parts: Worlds and what became of them.
        extra: What the engine says about itself.
        overlaps: Whether it tells overlaps. Then two arrays [W] are added: `deepest` [m], and
            `tunnelled`: a body's centre passed the ground, or an overlap exceeded half of the
            thinnest body.
    """
    logs = [_fill(start, worlds, played) for worlds, played in parts]
    extra = dict(extra or {})
    if overlaps:
        extra["deepest"] = deepest = np.zeros(start.batch.n_worlds)
        for worlds, played in parts:
            deepest[worlds] = played.deepest
        below = start.states[0][..., 2].min(axis=1) < -TUNNELLED_M
        bodies = start.scene.bodies
        thin = min((min(b.half_extents) for b in bodies if b.collides), default=math.inf)
        extra["tunnelled"] = (below & moving(start.scene)).any(axis=1) | (deepest > thin)
    return start.rollout(engine, join_logs(logs), extra)


def _fill(start: Start, worlds: NDArray[np.int64], played: Played) -> ContactLog:
    """Writes the states of some worlds; returns their log, which ends where they break."""
    n_frames, end, log = start.frames.n_frames, played.end, played.log
    if end is None:
        end = _ends(n_frames, played)
        alive = log.frame < end[log.world]
        if not alive.all():
            log = ContactLog(**{n: getattr(log, n)[alive] for n in log.__dataclass_fields__})
    rows = np.ix_(worlds, np.arange(1, n_frames), np.nonzero(moving(start.scene))[0])
    sources = (played.position, played.quaternion, played.linear, played.angular)
    for target, source in zip(start.states, sources, strict=True):
        target[rows] = source
    if brittle(start.scene):
        _unpark(start, worlds)
    if stances(start.scene):
        grid = start.frames
        own = np.asarray(worlds).tolist()
        fill_in(start.scene, start.batch, grid.time, grid.dt, start.states, own)
        log = own_names(start.scene, log)
    for target in start.states:
        for k in np.nonzero(end < n_frames)[0]:
            target[worlds[k], end[k] :] = target[worlds[k], end[k] - 1]
    start.valid[worlds] &= end >= n_frames
    return replace(log, world=worlds[log.world].astype(np.int32))


def _unpark(start: Start, worlds: NDArray[np.int64]) -> None:
    """Writes where what is not there would be into the states of some worlds."""
    own = (
        start.states[0][worlds],
        start.states[1][worlds],
        start.states[2][worlds],
        start.states[3][worlds],
    )
    unpark(start.scene, own)
    for target, values in zip(start.states, own, strict=True):
        target[worlds] = values


def _ends(n_frames: int, p: Played) -> NDArray[np.int64]:
    """First frame with a value that is not finite or a speed above 500 m/s, shape [W]."""
    with np.errstate(invalid="ignore", over="ignore"):
        bad = (p.linear.astype(float) ** 2).sum(-1) > MAX_SPEED_MPS**2
    for values in (p.position, p.quaternion, p.linear, p.angular):
        bad |= ~np.isfinite(values).all(-1)
    broken = bad.any(-1)
    return np.where(broken.any(1), 1 + broken.argmax(1), n_frames)
