"""Rollouts of many different scenes as plain arrays: what processes send to the one that simulates.

Nothing here needs a GPU or Warp, so that preparing and reading rollouts can be spread over
processes. A job is one scene's rollout: W worlds, B bodies of which D move, P primitives, T frames.
"""

from __future__ import annotations

from collections.abc import Generator
from dataclasses import dataclass
import math
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.shapes import hull
from esg.engines.program import ProgramBatch
from esg.engines.rest import starts_at_rest
from esg.engines.scene import ContactLog, Rollout, SimScene, Variation
from esg.engines.surrogate.model import _dimensions, _rotate
from esg.engines.worlds import MAX_SPEED_MPS, Frames, Start, moving

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]

_T = TypeVar("_T")
Pieces = Generator[None, None, _T]
"""Work in pieces, between which others may use the device, and its result."""

TUNNELLED_M = 0.3


@dataclass(frozen=True)
class SceneShapes:
    """What of a scene is the same in all its worlds (S shapes).

    Args:
        gravity: [m/s^2], shape [3].
        first: Body b owns the shapes first[b] .. first[b + 1] - 1, shape [B + 1].
        kind: Shape kinds, length S.
        size: As `Shape.size` [m], shape [S, 3].
        scale: In the convention of Newton's support maps [m], shape [S, 3].
        half: Half extents around the shape's centre [m], shape [S, 3].
        origin: Shape frame in the body frame [m], shape [S, 3].
        centre: Shape centre in the body frame [m], shape [S, 3].
        offset: Shape centre in the shape frame [m], shape [S, 3].
        rotation: Orientation (x, y, z, w) in the body frame, shape [S, 4].
        hulls: Vertices [n, 3] and triangles [m, 3] of convex shapes, None for others.
        dynamic: Bodies that move, shape [B]; so `static`, `collides` and `wheeled`.
        inertia: Body axes [kg m^2], shape [B, 3, 3]; the unit tensor for what does not move.
        mass: [kg], 1 where the scene gives none, shape [B].
        damping: Linear and angular [1/s], shape [B, 2].
    """

    gravity: tuple[float, float, float]
    first: Ints
    kind: tuple[str, ...]
    size: NDArray[np.float64]
    scale: NDArray[np.float64]
    half: NDArray[np.float64]
    origin: NDArray[np.float64]
    centre: NDArray[np.float64]
    offset: NDArray[np.float64]
    rotation: NDArray[np.float64]
    hulls: tuple[tuple[NDArray[np.float64], Ints] | None, ...]
    dynamic: NDArray[np.bool_]
    static: NDArray[np.bool_]
    collides: NDArray[np.bool_]
    wheeled: NDArray[np.bool_]
    inertia: NDArray[np.float64]
    mass: NDArray[np.float64]
    damping: NDArray[np.float64]

    @staticmethod
    def of(scene: SimScene) -> SceneShapes:
        first, kind, hulls = [0], [], []
        rows: dict[str, list[Any]] = {
            n: [] for n in ("size", "scale", "half", "origin", "centre", "offset", "rotation")
        }
        for body in scene.bodies:
            for shape in body.shapes:
                scale, offset, half = _dimensions(shape)
                kind.append(shape.kind)
                origin = np.array(shape.position)
                values = (shape.size, scale, half, origin,
                          origin + _rotate(shape.quaternion, offset), offset,
                          shape.quaternion)  # fmt: skip
                for row, value in zip(rows.values(), values, strict=True):
                    row.append(value)
                hulls.append(hull(np.array(shape.vertices)) if shape.kind == "convex" else None)
            first.append(len(kind))
        bodies = scene.bodies
        dynamic = moving(scene)
        inertia = [
            np.array(b.inertia, float) if m else np.eye(3)
            for b, m in zip(bodies, dynamic, strict=True)
        ]
        return SceneShapes(
            gravity=scene.gravity,
            first=np.array(first, np.int32),
            kind=tuple(kind),
            **{
                n: np.array(v, float).reshape(len(kind), 4 if n == "rotation" else 3)
                for n, v in rows.items()
            },
            hulls=tuple(hulls),
            dynamic=dynamic,
            static=np.array([b.static for b in bodies], bool),
            collides=np.array([b.collides for b in bodies], bool),
            wheeled=np.array([b.wheeled for b in bodies], bool),
            inertia=np.array(inertia, float).reshape(-1, 3, 3),
            mass=np.array([b.mass if b.mass > 0.0 else 1.0 for b in bodies]),
            damping=np.array([(b.linear_damping, b.angular_damping) for b in bodies], float),
        )

    @property
    def n_bodies(self) -> int:
        return len(self.dynamic)


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
        inertia: Of moving bodies, shape [W, D, 3, 3]; empty for the surrogate.
        ground: Two frictions and the restitution, shape [W, 3].
        friction_scale: Shape [W].
        asleep: Bodies that rest where they start, for the surrogate, shape [W, B].
        kind, body, until, table: The programs (`ProgramBatch`).
    """

    engine: str
    key: int
    shapes: SceneShapes | None
    frames: Frames
    position: Singles
    quaternion: Singles
    mass: NDArray[np.float64]
    friction: Singles
    restitution: Singles
    inertia: Singles
    ground: Singles
    friction_scale: Singles
    asleep: NDArray[np.bool_]
    kind: Ints
    body: Ints
    until: NDArray[np.bool_]
    table: NDArray[np.float64]

    @property
    def n_worlds(self) -> int:
        return len(self.mass)


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

    Raises:
        ValueError: For what no engine can simulate.
    """
    start = Start.of(
        scene, batch, dt=dt, record_every=record_every, duration=None, variation=variation
    )
    v, single = start.values, np.float32
    inertia = np.zeros((0,), single)
    asleep = np.zeros(v.mass.shape, bool)
    if engine == "newton":
        inertia = v.inertia[:, np.nonzero(shapes.dynamic)[0]].astype(single)
    else:
        asleep = starts_at_rest(scene, v.position, v.quaternion)
    job = Job(
        engine=engine,
        key=key,
        shapes=shapes,
        frames=start.frames,
        position=v.position.astype(single),
        quaternion=v.quaternion.astype(single),
        mass=v.mass,
        friction=v.friction.astype(single),
        restitution=v.restitution.astype(single),
        inertia=inertia,
        ground=v.ground.astype(single),
        friction_scale=v.friction_scale.astype(single),
        asleep=asleep,
        kind=batch.kind,
        body=batch.body,
        until=batch.until,
        table=batch.table,
    )
    return job, start


def read(job: Job, start: Start, played: Played) -> Rollout:
    """The rollout of a job: states of what stands still filled in, broken worlds frozen."""
    n_frames = start.frames.n_frames
    move = np.nonzero(moving(start.scene))[0]
    end, log = played.end, played.log
    if end is None:
        end = _ends(start.frames.n_frames, played)
        alive = log.frame < end[log.world]
        if not alive.all():
            log = ContactLog(**{n: getattr(log, n)[alive] for n in log.__dataclass_fields__})
    sources = (played.position, played.quaternion, played.linear, played.angular)
    for target, source in zip(start.states, sources, strict=True):
        target[:, 1:, move] = source
        for k in np.nonzero(end < n_frames)[0]:
            target[k, end[k] :] = target[k, end[k] - 1]
    start.valid[:] &= end >= n_frames
    extra: dict[str, Any] = {}
    if played.deepest is not None:
        below = start.states[0][..., 2].min(axis=1) < -TUNNELLED_M
        bodies = start.scene.bodies
        thin = min((min(b.half_extents) for b in bodies if b.collides), default=math.inf)
        deepest = played.deepest.astype(float)
        tunnelled = (below & moving(start.scene)).any(axis=1) | (deepest > thin)
        extra = {"deepest": deepest, "tunnelled": tunnelled}
    return start.rollout(job.engine, log, extra)


def _ends(n_frames: int, p: Played) -> NDArray[np.int64]:
    """First frame with a value that is not finite or a speed above 500 m/s, shape [W]."""
    with np.errstate(invalid="ignore", over="ignore"):
        bad = (p.linear.astype(float) ** 2).sum(-1) > MAX_SPEED_MPS**2
    for values in (p.position, p.quaternion, p.linear, p.angular):
        bad |= ~np.isfinite(values).all(-1)
    broken = bad.any(-1)
    return np.where(broken.any(1), 1 + broken.argmax(1), n_frames)
