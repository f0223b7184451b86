"""What every engine needs before and after stepping: frames, per-world values, the contact log."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import permutations
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.breaking import breaking_problems, brittle, ride, rigid
from esg.engines.breaking.stances import pose_in, stance_problems, stances
from esg.engines.joints import joint_problems
from esg.engines.program import KINDS, Action, ProgramBatch
from esg.engines.scene import GROUND, Body, ContactLog, Floats, Rollout, Shape, SimScene, Variation
from esg.engines.starts import start_velocities

MAX_SPEED_MPS = 500.0
"""A body faster than this means that the world diverged."""

CYLINDER_SIDES = 32

Principal = dict[int, tuple[Floats, Floats]]
"""Principal moments [kg m^2], shape [3], and axes, a quaternion, by body index."""


@dataclass(frozen=True)
class Frames:
    """The time grid of a rollout.

    Args:
        dt: Physics step [s].
        record_every: Steps per frame.
        n_steps: Steps simulated, a multiple of record_every.
        time: Frame times [s], shape [T]; T = n_steps / record_every + 1.
    """

    dt: float
    record_every: int
    n_steps: int
    time: Floats

    @staticmethod
    def of(duration: float, dt: float, record_every: int) -> Frames:
        """The grid that covers `duration`; the last frame may lie up to one frame beyond it.

        Raises:
            ValueError: For a step, a frame length or a duration that is not positive.
        """
        if not (math.isfinite(dt) and dt > 0.0):
            raise ValueError(f"dt is {dt}; it must be a positive number of seconds")
        if record_every < 1:
            raise ValueError(f"record_every is {record_every}; it must be at least 1")
        if not (math.isfinite(duration) and duration > 0.0):
            raise ValueError(f"duration is {duration}; it must be a positive number of seconds")
        # The tolerance keeps 4 s at 1/240 s at 960 steps in spite of rounding.
        n_frames = max(1, math.ceil(duration / dt / record_every - 1e-6))
        time = np.asarray(np.arange(n_frames + 1) * (dt * record_every), np.float64)
        return Frames(dt, record_every, n_frames * record_every, time)

    @property
    def n_frames(self) -> int:
        """Number of recorded frames."""
        return len(self.time)


@dataclass(frozen=True)
class Values:
    """Initial state and materials of W worlds (B bodies).

    Args:
        position: Centres of mass [m], shape [W, B, 3].
        quaternion: Unit (x, y, z, w), shape [W, B, 4].
        mass: [kg], shape [W, B].
        inertia: Body axes [kg m^2], shape [W, B, 3, 3].
        friction, restitution: shape [W, B].
        ground: Friction of the normal ground, friction of the vehicle ground, restitution of both,
            shape [W, 3].
        friction_scale: Also scales what AdjustProperties sets, shape [W].
    """

    position: Floats
    quaternion: Floats
    mass: Floats
    inertia: Floats
    friction: Floats
    restitution: Floats
    ground: Floats
    friction_scale: Floats


def world_values(scene: SimScene, variation: Variation | None, n_worlds: int) -> Values:
    """Merges the scene with a variation.

    Args:
        scene: B bodies.
        variation: Changes per world, or None.
        n_worlds: W.

    Raises:
        ValueError: If an array of the variation has the wrong shape.
    """
    bodies, w = scene.bodies, n_worlds
    v = variation or Variation()
    shapes = {
        "position": (w, len(bodies), 3),
        "quaternion": (w, len(bodies), 4),
        "mass_scale": (w, len(bodies)),
        "friction_scale": (w,),
        "restitution_offset": (w,),
    }
    for name, shape in shapes.items():
        value = getattr(v, name)
        if value is not None and np.shape(value) != shape:
            raise ValueError(f"variation.{name} has shape {np.shape(value)}, expected {shape}")

    def spread(values: list[object], given: Floats | None = None) -> Floats:
        base = np.array(values, float)
        return np.array(np.broadcast_to(base, (w, *base.shape)) if given is None else given, float)

    quaternion = spread([b.quaternion for b in bodies], v.quaternion).reshape(w, len(bodies), 4)
    norm = np.linalg.norm(quaternion, axis=-1, keepdims=True)
    factor = np.ones((w, len(bodies))) if v.mass_scale is None else np.array(v.mass_scale, float)
    scale = np.ones(w) if v.friction_scale is None else np.asarray(v.friction_scale, float)
    offset = np.zeros(w) if v.restitution_offset is None else np.asarray(v.restitution_offset)
    ground = np.empty((w, 3))
    ground[:, 0] = scene.ground_friction * scale
    ground[:, 1] = scene.vehicle_ground_friction * scale
    ground[:, 2] = np.clip(scene.ground_restitution + offset, 0.0, 1.0)
    inertia = spread([b.inertia for b in bodies]).reshape(w, len(bodies), 3, 3)
    position = spread([b.position for b in bodies], v.position).reshape(w, len(bodies), 3)
    quaternion = quaternion / np.where(norm > 0.0, norm, 1.0)
    still = np.zeros((w, 3))
    for b in brittle(scene):
        # Fragments are parts of their body, whatever a variation does to it.
        own = list(b.pieces)
        pose = position[:, b.whole], quaternion[:, b.whole]
        position[:, own], quaternion[:, own] = rigid(b, *pose, still, still)[:2]
        factor[:, own] = factor[:, [b.whole]]
    for s in stances(scene):
        # So are postures.
        for k, body in enumerate(s.bodies[1:], 1):
            pose = position[:, s.bodies[0]], quaternion[:, s.bodies[0]]
            position[:, body], quaternion[:, body] = pose_in(s, k, *pose)
            factor[:, body] = factor[:, s.bodies[0]]
    return Values(
        position=position,
        quaternion=quaternion,
        mass=spread([b.mass for b in bodies]).reshape(w, len(bodies)) * factor,
        inertia=inertia * factor[..., None, None],
        friction=spread([b.friction for b in bodies]).reshape(w, -1) * scale[:, None],
        restitution=np.clip(
            spread([b.restitution for b in bodies]).reshape(w, -1) + offset[:, None], 0.0, 1.0
        ),
        ground=ground,
        friction_scale=scale,
    )


def _inertia_problems(body: Body) -> Iterator[str]:
    """What is wrong with the mass and the inertia of a body that moves."""
    if body.static or not body.collides:
        return
    inertia = np.array(body.inertia, float)
    if not (math.isfinite(body.mass) and body.mass > 0.0):
        yield f"body {body.name!r} has mass {body.mass} kg; it must be positive"
    if inertia.shape != (3, 3) or not np.isfinite(inertia).all():
        yield f"body {body.name!r} has no finite 3 x 3 inertia"
    elif np.linalg.eigvalsh(0.5 * (inertia + inertia.T)).min() <= 0.0:
        yield f"body {body.name!r} has an inertia that is not positive definite"


def _shape_problems(body: Body) -> Iterator[str]:
    """What is wrong with the shapes of a body."""
    for shape in body.shapes:
        used = shape.size[:1] if shape.kind == "sphere" else shape.size
        if shape.kind == "convex" and not _has_volume(shape):
            yield f"body {body.name!r} has a convex shape without volume"
        elif shape.kind != "convex" and not all(math.isfinite(s) and s > 0.0 for s in used):
            yield f"body {body.name!r} has a {shape.kind} of size {shape.size} m"


def check(scene: SimScene, batch: ProgramBatch) -> None:
    """Rejects what no engine can simulate.

    Raises:
        ValueError: Naming every body with an impossible mass, inertia or shape, every reserved or
            repeated name, every joint that cannot be, and every primitive that would move an
            immovable body or a joint without a motor.
    """
    wrong: list[str] = []
    seen: set[str] = set()
    for body in scene.bodies:
        if body.name in seen or body.name == GROUND:
            wrong.append(f"body name {body.name!r} is reserved or used twice")
        seen.add(body.name)
        wrong += [*_inertia_problems(body), *_shape_problems(body)]
    wrong += joint_problems(scene) + breaking_problems(scene) + stance_problems(scene)
    motors = [j.name for j in scene.joints if j.kind in ("hinge", "slider")]
    wrong += [
        f"DriveJoint of {name!r}, which has no motor; hinges and sliders are {motors}"
        for name in batch.joint
        if name and name not in motors
    ]
    for k, b in zip(batch.kind, batch.body, strict=True):
        if k == Action.DRIVE:
            continue
        body = scene.bodies[int(b)]
        if k != Action.ADJUST and (body.static or not body.collides):
            wrong.append(f"{KINDS[int(k)].kind} would move {body.name!r}, which cannot move")
    if wrong:
        raise ValueError("; ".join(dict.fromkeys(wrong)))


def _has_volume(shape: Shape) -> bool:
    points = np.array(shape.vertices, float).reshape(-1, 3)
    if len(points) < 4 or not np.isfinite(points).all():
        return False
    spread = np.linalg.svd(points - points.mean(axis=0), compute_uv=False)
    return bool(spread[2] > 1e-6 * spread[0])


def moving(scene: SimScene) -> NDArray[np.bool_]:
    """Bodies that the engine integrates: neither static nor decals, shape [B]."""
    return np.array([not b.static and b.collides for b in scene.bodies], bool)


def cylinder_vertices(shape: Shape, sides: int = CYLINDER_SIDES) -> Floats:
    """Hull of a prism with the cylinder's height and cross-section area, shape [2 sides, 3]."""
    angle = (np.arange(sides) + 0.5) * (2.0 * math.pi / sides)
    step = 2.0 * math.pi / sides
    radius = shape.size[0] * math.sqrt(step / math.sin(step))
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(sides)], axis=1)
    up = np.array([0.0, 0.0, shape.size[2]])
    return np.concatenate([ring - up, ring + up])


def principal_axes(inertia: Floats) -> tuple[Floats, Floats]:
    """Principal moments, shape [3], and the quaternion (x, y, z, w) of their axes, shape [4].

    An inertia that is diagonal already keeps its axes, whatever their order. Otherwise each axis is
    the one nearest to a body axis, pointing the same way: a tensor rebuilt from its own moments and
    axes gives the same answer again, whoever rebuilds it.
    """
    inertia = 0.5 * (inertia + inertia.T)
    off = np.abs(inertia - np.diag(np.diag(inertia))).max()
    if off <= 1e-9 * np.abs(inertia).max():
        return np.diag(inertia).copy(), np.array([0.0, 0.0, 0.0, 1.0])
    moments, axes = np.linalg.eigh(inertia)
    best = max(
        permutations(range(3)), key=lambda order: float(np.abs(np.diag(axes[:, order])).sum())
    )
    moments, axes = moments[list(best)], axes[:, list(best)]
    axes = axes * np.where(np.diag(axes) < 0.0, -1.0, 1.0)
    if np.linalg.det(axes) < 0.0:
        weakest = int(np.argmin(np.abs(np.diag(axes))))
        axes[:, weakest] = -axes[:, weakest]
    return moments, _quat_from_matrix(axes)


def _quat_from_matrix(m: Floats) -> Floats:
    # Shepperd's method: the largest of the four squares keeps the division well conditioned.
    squares = np.array([m[0, 0] - m[1, 1] - m[2, 2], m[1, 1] - m[0, 0] - m[2, 2],
                        m[2, 2] - m[0, 0] - m[1, 1], np.trace(m)])  # fmt: skip
    k = int(np.argmax(squares))
    if k == 3:
        q = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1.0 + squares[3]])
    else:
        i, j, l = k, (k + 1) % 3, (k + 2) % 3  # noqa: E741  # three axes in cyclic order
        q = np.empty(4)
        q[i] = 1.0 + squares[k]
        q[j] = m[j, i] + m[i, j]
        q[l] = m[l, i] + m[i, l]
        q[3] = m[l, j] - m[j, l]
    return q / np.linalg.norm(q)


def rest_states(
    values: Values, frames: Frames
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Arrays of a rollout in which nothing moves: positions, quaternions and both velocities."""
    w, b = values.mass.shape
    t = frames.n_frames
    position = np.repeat(values.position[:, None].astype(np.float32), t, axis=1)
    quaternion = np.repeat(values.quaternion[:, None].astype(np.float32), t, axis=1)
    zero = np.zeros((w, t, b, 3), np.float32)
    return position, quaternion, zero, zero.copy()


class ContactRecorder:
    """Accumulates the touches of one world into rows of a `ContactLog`.

    A pair touches in a step if the sum of its normal impulses is positive. Rows of one frame and
    pair are merged: impulses add, the largest depth counts, time, point and normal are those of the
    frame's first touch.
    """

    def __init__(self, world: int, frames: Frames) -> None:
        self.world = world
        self._frames = frames
        self._rows: dict[tuple[int, int, int], list[object]] = {}

    def add(
        self,
        step: int,
        a: int,
        b: int,
        impulse: float,
        depth: float,
        point: Floats,
        normal: Floats,
    ) -> None:
        """Adds one pair's touch in step number `step` (0 leads from 0 to dt).

        Args:
            step: Number of the step.
            a, b: Body indices, -1 for the ground, in any order.
            impulse: Sum of normal impulses [N s], positive.
            depth: Largest penetration [m].
            point: Contact point [m], shape [3].
            normal: Unit normal from b towards a, shape [3].
        """
        # The ground is always b; otherwise a < b.
        if a < 0 or (b >= 0 and a > b):
            a, b, normal = b, a, -normal
        key = (step // self._frames.record_every + 1, a, b)
        row = self._rows.get(key)
        if row is None:
            time = (step + 1) * self._frames.dt
            self._rows[key] = [time, impulse, max(0.0, depth), np.array(point), np.array(normal)]
        else:
            row[1] += impulse  # type: ignore[operator]  # a float
            row[2] = max(row[2], depth)  # type: ignore[type-var]  # floats

    def drop_from(self, frame: int) -> None:
        """Forgets the rows of `frame` and later ones."""
        self._rows = {k: v for k, v in self._rows.items() if k[0] < frame}

    def log(self) -> ContactLog:
        """The rows sorted by (frame, a, b)."""
        keys = sorted(self._rows)
        if not keys:
            return ContactLog.empty()
        rows = [self._rows[k] for k in keys]
        index = np.array(keys, np.int32)
        return ContactLog(
            world=np.full(len(keys), self.world, np.int32),
            frame=index[:, 0],
            a=index[:, 1],
            b=index[:, 2],
            time=np.array([r[0] for r in rows], float),
            impulse=np.array([r[1] for r in rows], float),
            depth=np.array([r[2] for r in rows], float),
            point=np.array([r[3] for r in rows], float).reshape(-1, 3),
            normal=np.array([r[4] for r in rows], float).reshape(-1, 3),
        )


def join_logs(logs: list[ContactLog]) -> ContactLog:
    """One log of several, in the order given."""
    logs = [log for log in logs if len(log.world)]
    if not logs:
        return ContactLog.empty()
    names = ContactLog.__dataclass_fields__
    return ContactLog(**{n: np.concatenate([getattr(log, n) for log in logs]) for n in names})


@dataclass(frozen=True)
class Start:
    """What a rollout of W worlds starts from and fills, the same in every engine.

    Args:
        scene: B bodies.
        batch: W programs.
        frames: The time grid.
        values: Initial states and materials.
        states: Arrays of the rollout, filled in place (`rest_states`); what is under way at t = 0
            has its velocity in frame 0.
        valid: Worlds with finite start poses, shape [W]; engines clear those that diverge.
    """

    scene: SimScene
    batch: ProgramBatch
    frames: Frames
    values: Values
    states: tuple[Any, Any, Any, Any]
    valid: NDArray[np.bool_]

    @staticmethod
    def of(
        scene: SimScene,
        batch: ProgramBatch,
        *,
        dt: float,
        record_every: int,
        duration: float | None,
        variation: Variation | None,
    ) -> Start:
        """Checks the arguments of `Engine.rollout` and prepares its arrays.

        Raises:
            ValueError: For a scene that no engine can simulate, or a broken grid or variation.
        """
        check(scene, batch)
        frames = Frames.of(batch.duration if duration is None else duration, dt, record_every)
        values = world_values(scene, variation, batch.n_worlds)
        start = np.concatenate([values.position, values.quaternion], axis=2)
        finite = np.asarray(np.isfinite(start).all((1, 2)), np.bool_)
        states = rest_states(values, frames)
        states[2][:, 0], states[3][:, 0] = start_velocities(batch, values.mass, dt)
        ride(scene, states, np.s_[:, 0])
        return Start(scene, batch, frames, values, states, finite)

    def rollout(self, engine: str, contacts: ContactLog, extra: dict[str, Any]) -> Rollout:
        """The rollout after an engine has filled the arrays.

        Args:
            engine: Its name.
            contacts: The log of all worlds.
            extra: What the engine says about itself.
        """
        position, quaternion, linear, angular = self.states
        return Rollout(
            engine=engine,
            dt=self.frames.dt,
            time=self.frames.time,
            position=position,
            quaternion=quaternion,
            linear_velocity=linear,
            angular_velocity=angular,
            contacts=contacts,
            valid=self.valid,
            extra=extra,
        )
