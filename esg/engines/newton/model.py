"""A Newton model of W copies of one scene, its captured step graph and its device buffers.

A model depends only on the structure of a scene (`structure_key`): which bodies exist, their
collision shapes, whether they are static and which ground they touch. Poses, masses, inertias,
materials, damping and programs are arrays that `NewtonModel.load` writes.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import (
    CONTACT_GAP_M,
    POINTS_PER_BODY,
    POINTS_PER_SHAPE,
    POINTS_PER_WORLD,
    STEPS_PER_GRAPH,
    quiet_warp,
)
from esg.engines.newton.shapes import add_shape
from esg.engines.newton.worlds import NewtonWorlds
from esg.engines.program import FIELDS, Action, Column, ProgramBatch
from esg.engines.scene import Shape, SimScene
from esg.engines.shapes import hull
from esg.engines.worlds import Values, moving
from esg.units import quat_multiply, quat_rotate

__all__ = ["NewtonModel", "quiet_warp", "structure_key"]

_CELLS = 1_000_000
_GROUND_NAMES = (-1, -2)
_LEAST_PRIMITIVES = 16


def structure_key(scene: SimScene) -> tuple[object, ...]:
    """What a compiled model depends on; scenes with equal keys share one."""
    bodies = tuple((b.static, b.wheeled, b.shapes) for b in scene.bodies)
    return bodies, tuple(scene.gravity)


class NewtonModel(NewtonWorlds):
    """One compiled model.

    Args:
        scene: Any scene of the structure.
        n_worlds: W.
        device: Warp device, such as "cpu" or "cuda:0".
        growth: Factor on the room for contacts. Room is sized for ordinary scenes, because the
            solver visits all of it every step; `overflowed` tells when it was too small.
    """

    def __init__(self, scene: SimScene, n_worlds: int, device: str, growth: int = 1) -> None:
        super().__init__(device, n_worlds, len(scene.bodies), by_chunk=True)
        self.moving = np.nonzero(moving(scene))[0]
        self.n_dynamic = len(self.moving)
        self._bodies = scene.bodies
        with self.wp.ScopedDevice(device):
            self._build(scene, growth)
            self._make_arrays()

    def _build(self, scene: SimScene, growth: int) -> None:
        import newton

        wp = self.wp
        steel = newton.solvers.SolverSteel
        world = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=scene.gravity)
        steel.register_custom_attributes(world)
        config = newton.ModelBuilder.ShapeConfig(density=0.0, gap=CONTACT_GAP_M)
        grounds = [world.add_ground_plane(cfg=config) for _ in range(2)]
        self._shape_body: list[int] = list(_GROUND_NAMES)
        self._shapes: list[Shape | None] = [None, None]
        touches = {0: grounds[1], 1: grounds[0]}
        meshes: dict[bytes, Any] = {}
        for i, body in enumerate(scene.bodies):
            if not body.collides:
                continue
            owner = -1
            if not body.static:
                owner = world.add_body(
                    xform=wp.transform_identity(),
                    mass=body.mass,
                    inertia=wp.mat33(np.array(body.inertia, np.float32).flatten()),
                    lock_inertia=True,
                )
            for shape in body.shapes:
                convex = hull(np.array(shape.vertices)) if shape.kind == "convex" else None
                s = add_shape(
                    world, owner, shape.kind, shape.size, shape.position, shape.quaternion, convex,
                    config, meshes,
                )  # fmt: skip
                self._shape_body.append(i)
                self._shapes.append(shape)
                world.add_shape_collision_filter_pair(s, touches[int(body.wheeled)])
        self.n_shapes = len(self._shape_body)
        everything = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=scene.gravity)
        steel.register_custom_attributes(everything)
        everything.replicate(world, self.n_worlds)
        dynamic_shapes = sum(len(scene.bodies[i].shapes) for i in self.moving)
        room = POINTS_PER_BODY * self.n_dynamic + POINTS_PER_SHAPE * dynamic_shapes
        points = growth * (POINTS_PER_WORLD + room)
        self._first_shapes = np.arange(self.n_worlds + 1) * self.n_shapes
        n_moving = self.n_worlds * self.n_dynamic
        self._finalize(everything, self._first_shapes, n_moving, points * self.n_worlds, points)

    def _make_arrays(self) -> None:
        wp, w, b = self.wp, self.n_worlds, self.n_bodies
        dynamic = np.full((w, b), -1, np.int32)
        dynamic[:, self.moving] = np.arange(w * self.n_dynamic).reshape(w, self.n_dynamic)
        # Row and column 0 are the ground; pairs of two static bodies never touch.
        can_move = np.zeros(b + 1, bool)
        can_move[1 + self.moving] = True
        first, second = np.triu_indices(b + 1, 1)
        keep = can_move[first] | can_move[second]
        self.pairs = np.stack([first[keep], second[keep]], axis=1)
        pair = np.full((b + 1, b + 1), -1, np.int32)
        pair[self.pairs[:, 0], self.pairs[:, 1]] = np.arange(len(self.pairs))
        self._pair_all = np.maximum(pair, pair.T)
        self._pair_bodies = self._pair_all.copy()
        self._pair_bodies[0, :] = -1
        self._pair_bodies[:, 0] = -1
        self._logs_ground = True
        n_pairs = max(1, len(self.pairs))
        chunks = _CELLS // max(1, w * max(n_pairs, 2 * self.n_dynamic))
        self.chunk_frames = c = STEPS_PER_GRAPH * int(np.clip(chunks // STEPS_PER_GRAPH, 1, 16))
        self._allocate(
            dynamic,
            np.broadcast_to(self._pair_all, (w, b + 1, b + 1)),
            np.arange(w + 1) * n_pairs,
            self._first_shapes,
            np.tile(self._shape_body, w),
            c,
        )
        self.out_q = wp.zeros((c, w * self.n_dynamic), dtype=wp.transform)
        self.out_qd = wp.zeros((c, w * self.n_dynamic), dtype=wp.spatial_vector)

    def load(
        self,
        scene: SimScene,
        values: Values,
        batch: ProgramBatch,
        dt: float,
        record_every: int,
        ground_contacts: bool,
    ) -> None:
        """Writes initial states, materials and programs of W worlds to the device.

        Args:
            scene: A scene of this structure.
            values: W worlds.
            batch: W programs.
            dt: Physics step [s].
            record_every: Steps per frame.
            ground_contacts: Whether contacts with the ground are logged.
        """
        w, d, b = self.n_worlds, self.moving, self.n_bodies
        with self.wp.ScopedDevice(self.device):
            if len(d):
                damping = [
                    (scene.bodies[i].linear_damping, scene.bodies[i].angular_damping) for i in d
                ]
                self._load_bodies(
                    values.mass[:, d].reshape(-1).astype(np.float32),
                    values.inertia[:, d].reshape(-1, 3, 3).astype(np.float32),
                    np.tile(np.array(damping, np.float32), (w, 1)),
                )
            self._load_shapes(*self._materials(values), self._shape_transforms(values))
            self.friction_scale.assign(values.friction_scale.astype(np.float32))
            pose = np.concatenate([values.position[:, d], values.quaternion[:, d]], axis=-1)
            self._load_states(pose.reshape(-1, 7).astype(np.float32))
            self._load_batch(batch)
            if ground_contacts != self._logs_ground:
                self._logs_ground = ground_contacts
                pair = self._pair_all if ground_contacts else self._pair_bodies
                self.pair.assign(np.broadcast_to(pair, (w, b + 1, b + 1)))
            self._start(dt, record_every, 0)

    def _load_batch(self, batch: ProgramBatch) -> None:
        w, n = self.n_worlds, len(batch.kind)
        p = self._room(n, _LEAST_PRIMITIVES)
        kind, body = np.zeros((w, p), np.int32), np.zeros((w, p), np.int32)
        until, table = np.zeros((w, p, self.n_bodies), np.int32), np.zeros((w, p, FIELDS))
        kind[:, :n], body[:, :n], until[:, :n], table[:, :n] = (
            batch.kind, batch.body, batch.until, batch.table,
        )  # fmt: skip
        self._load_programs(kind, body, until, table, np.full(w, n, np.int32))
        changes = np.isfinite(batch.table[:, batch.kind == Action.ADJUST, Column.FRICTION])
        self.has_friction_change = bool(changes.any())

    def _materials(self, values: Values) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
        owner = np.array(self._shape_body)
        mu = np.empty((self.n_worlds, self.n_shapes), np.float32)
        restitution = np.empty_like(mu)
        own = owner >= 0
        mu[:, own] = values.friction[:, owner[own]]
        restitution[:, own] = values.restitution[:, owner[own]]
        mu[:, :2] = values.ground[:, :2]
        restitution[:, :2] = values.ground[:, 2:]
        return mu.reshape(-1), restitution.reshape(-1)

    def _shape_transforms(self, values: Values) -> NDArray[np.float32]:
        out = self.model.shape_transform.numpy().reshape(self.n_worlds, self.n_shapes, 7).copy()
        for s, (i, shape) in enumerate(zip(self._shape_body, self._shapes, strict=True)):
            if shape is not None and self._bodies[i].static:
                position, quaternion = values.position[:, i], values.quaternion[:, i]
                local = np.array(shape.position)
                out[:, s, :3] = position + quat_rotate(
                    quaternion, np.broadcast_to(local, position.shape)
                )
                out[:, s, 3:] = quat_multiply(quaternion, np.array(shape.quaternion))
        return out.reshape(-1, 7)

    def run_chunk(self, first_frame: int, n_frames: int) -> dict[str, NDArray[Any]]:
        """Simulates `n_frames` (at most `chunk_frames`) frames and brings them to the host.

        Args:
            first_frame: Number of frames done before this chunk.
            n_frames: Frames of this chunk.

        Returns:
            Arrays of the chunk: pose [F, W, D, 7], velocity [F, W, D, 6], and for pairs [F, W, P]:
            impulse [N s], first step, depth [m]; moments [F, W, P, 6].
        """
        wp = self.wp
        with wp.ScopedDevice(self.device):
            self._clock[2], self._clock[3] = first_frame, n_frames
            # The step counter lives on the device; all else is written anew.
            done = self.clock.numpy()[0] if first_frame else 0
            self._clock[0] = done
            self.clock.assign(self._clock)
            self.impulse.zero_()
            self.first.fill_(2**31 - 1)
            self.depth.zero_()
            self.moments.zero_()
            target = (first_frame + n_frames) * self.record_every
            launches = -(-(target - int(done)) // self.graph_steps)
            graph = self.prepare()
            for _ in range(launches):
                wp.capture_launch(graph)
            f, w, d = n_frames, self.n_worlds, self.n_dynamic
            return {
                "pose": self.out_q.numpy()[:f].reshape(f, w, d, 7),
                "velocity": self.out_qd.numpy()[:f].reshape(f, w, d, 6),
                "impulse": self.impulse.numpy()[:f].reshape(f, w, -1),
                "first": self.first.numpy()[:f].reshape(f, w, -1),
                "depth": self.depth.numpy()[:f].reshape(f, w, -1),
                "moments": self.moments.numpy()[:f].reshape(f, w, -1, 6),
            }

    def overflowed(self) -> bool:
        """Whether contacts were dropped for lack of room since `load`."""
        return bool(self.solver.constraint_overflow.numpy().any())
