"""A Newton model of W copies of one scene, its captured step graph and its device buffers.

A model depends only on the structure of a scene (`structure_key`): which bodies exist, their
collision shapes, whether they are static and which ground they touch. Poses, masses, inertias,
materials, damping and programs are arrays that `NewtonModel.load` writes.
"""

from __future__ import annotations

from functools import cache
import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.executor import ADJUST
from esg.engines.program import FIELDS, ProgramBatch
from esg.engines.scene import Floats, Shape, SimScene
from esg.engines.worlds import Values, moving
from esg.units import quat_multiply, quat_rotate

STEPS_PER_GRAPH = 4
"""Even, so that the two states are back in place after one launch of the graph."""

ITERATIONS = 6
RESTITUTION_THRESHOLD_MPS = 0.2
CONTACT_GAP_M = 0.005
SPECULATIVE_GAP_M = 0.25
"""Fast bodies are seen as far ahead as they move in a step, up to this distance [m]."""

POINTS_PER_WORLD = 16
POINTS_PER_SHAPE = 4
"""Room for contact points before it has to grow."""

_CELLS = 1_000_000
_GROUND_NAMES = (-1, -2)


def structure_key(scene: SimScene) -> tuple[object, ...]:
    """What a compiled model depends on; scenes with equal keys share one."""
    bodies = tuple((b.static, b.wheeled, b.shapes) for b in scene.bodies)
    return bodies, tuple(scene.gravity)


@cache
def quiet_warp() -> Any:
    """Imports and initializes warp without its banner and its notice that there is no GPU."""
    import warp as wp

    wp.config.quiet = True
    wp.config.log_level = wp.LOG_WARNING
    # The notice is printed by native code, past Python's sys.stderr.
    saved = os.dup(2)
    null = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(null, 2)
        wp.init()
    finally:
        os.dup2(saved, 2)
        os.close(saved)
        os.close(null)
    return wp


@cache
def _share_kernels() -> None:
    """Lets all models of a process share Newton's narrow-phase kernels.

    Newton writes these two kernels anew for every collision pipeline, although they depend on a
    few switches only. Generating and hashing them again takes longer than simulating a scene.
    """
    from newton._src.geometry import narrow_phase

    for name in ("create_narrow_phase_primitive_kernel", "create_narrow_phase_kernel_gjk_mpr"):
        factory = getattr(narrow_phase, name, None)
        if factory is not None:
            setattr(narrow_phase, name, cache(factory))


class NewtonModel:
    """One compiled model.

    Args:
        scene: Any scene of the structure.
        n_worlds: W.
        device: Warp device, such as "cpu" or "cuda:0".
        growth: Factor on the room for contacts. Room is sized for ordinary scenes, because the
            solver visits all of it every step; `overflowed` tells when it was too small.
    """

    def __init__(self, scene: SimScene, n_worlds: int, device: str, growth: int = 1) -> None:
        self.wp = wp = quiet_warp()
        import newton

        _share_kernels()
        self.n_worlds = n_worlds
        self.device = device
        self.n_bodies = len(scene.bodies)
        self.moving = np.nonzero(moving(scene))[0]
        self.n_dynamic = len(self.moving)
        self._bodies = scene.bodies
        self._graphs: dict[object, Any] = {}
        with wp.ScopedDevice(device):
            self._build(newton, scene, growth)
            self._allocate()
        self._primitives = 0

    def _build(self, newton: Any, scene: SimScene, growth: int) -> None:
        wp = self.wp
        steel = newton.solvers.SolverSteel
        world = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=scene.gravity)
        steel.register_custom_attributes(world)
        config = newton.ModelBuilder.ShapeConfig(density=0.0, gap=CONTACT_GAP_M)
        grounds = [world.add_ground_plane(cfg=config) for _ in range(2)]
        self._shape_body = list(_GROUND_NAMES)
        self._shapes: list[Shape | None] = [None, None]
        touches = {0: grounds[1], 1: grounds[0]}
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
                s = _add_shape(newton, wp, world, owner, shape, config)
                self._shape_body.append(i)
                self._shapes.append(shape)
                world.add_shape_collision_filter_pair(s, touches[int(body.wheeled)])
        self.n_shapes = len(self._shape_body)
        everything = newton.ModelBuilder(up_axis=newton.Axis.Z, gravity=scene.gravity)
        steel.register_custom_attributes(everything)
        everything.replicate(world, self.n_worlds)
        self.model = model = everything.finalize(device=self.device)
        self._check_layout(model)
        cuda = not str(self.device).startswith("cpu")
        # On the CPU kernels run in order anyway.
        mode = wp.DeterministicMode
        dynamic_shapes = sum(len(scene.bodies[i].shapes) for i in self.moving)
        points = growth * (POINTS_PER_WORLD + POINTS_PER_SHAPE * dynamic_shapes)
        self.pipeline = newton.CollisionPipeline(
            model,
            broad_phase="explicit",
            rigid_contact_max=points * self.n_worlds,
            deterministic=cuda,
            verify_buffers=False,
            speculative_contact_gap_max=SPECULATIVE_GAP_M,
        )
        self.contacts = self.pipeline.contacts()
        self.solver = steel(
            model,
            iterations=ITERATIONS,
            friction_anchor_beta=0.2,
            restitution_velocity_threshold=RESTITUTION_THRESHOLD_MPS,
            # One row along the normal and two for friction.
            free_body_constraint_max=3 * points,
            articulation_constraint_max=1,
            warn_constraint_overflow=False,
            deterministic=mode.RUN_TO_RUN if cuda else mode.NOT_GUARANTEED,
        )
        self.observables = self.solver.observables({"contact_f"}, contacts=self.contacts)
        self.state = model.state()
        self.other = model.state()
        self.control = model.control()

    def _check_layout(self, model: Any) -> None:
        """The kernels index shapes and bodies by world; make sure Newton lays them out so."""
        expected = np.repeat(np.arange(self.n_worlds), self.n_shapes)
        if not np.array_equal(model.shape_world.numpy(), expected):
            raise RuntimeError("Newton changed the order of shapes in replicated worlds")
        if model.body_count != self.n_worlds * self.n_dynamic:
            raise RuntimeError("Newton changed the number of bodies in replicated worlds")

    def _allocate(self) -> None:
        wp, w, b = self.wp, self.n_worlds, self.n_bodies
        dynamic = np.full(b, -1, np.int32)
        dynamic[self.moving] = np.arange(self.n_dynamic)
        self.dynamic = wp.array(dynamic, dtype=int)
        self.shape_body = wp.array(np.maximum(self._shape_body, -1), dtype=int)
        self.friction_scale = wp.ones(w, dtype=float)
        self.touched = wp.full((w, b, b), -1, dtype=int)
        self.clock = wp.zeros(5, dtype=int)
        self.grid = wp.zeros(1, dtype=wp.float64)
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
        self.pair = wp.array(self._pair_all, dtype=int)
        n_pairs = max(1, len(self.pairs))
        chunks = _CELLS // max(1, w * max(n_pairs, 2 * self.n_dynamic))
        self.chunk_frames = STEPS_PER_GRAPH * int(np.clip(chunks // STEPS_PER_GRAPH, 1, 16))
        c = self.chunk_frames
        self.impulse = wp.zeros((c, w, n_pairs), dtype=wp.int64)
        self.first = wp.zeros((c, w, n_pairs), dtype=int)
        self.depth = wp.zeros((c, w, n_pairs), dtype=float)
        self.moments = wp.zeros((c, w, n_pairs, 6), dtype=wp.int64)
        self.out_q = wp.zeros((c, w * self.n_dynamic), dtype=wp.transform)
        self.out_qd = wp.zeros((c, w * self.n_dynamic), dtype=wp.spatial_vector)

    def _reserve(self, n_primitives: int) -> None:
        """Makes room for a program; graphs keep addresses, so growing drops them."""
        if n_primitives <= self._primitives:
            return
        wp, w = self.wp, self.n_worlds
        self._primitives = p = max(16, 1 << (n_primitives - 1).bit_length())
        self._graphs.clear()
        self.kind = wp.zeros(p, dtype=int)
        self.body = wp.zeros(p, dtype=int)
        self.until = wp.zeros((p, self.n_bodies), dtype=int)
        self.table = wp.zeros((w, p, FIELDS), dtype=wp.float64)
        self.done = wp.zeros((w, p), dtype=int)
        self.active = wp.zeros((w, p), dtype=int)

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
        import newton

        wp, w, d, model = self.wp, self.n_worlds, self.moving, self.model
        flags = newton.ModelFlags
        with wp.ScopedDevice(self.device):
            mass = values.mass[:, d].reshape(-1).astype(np.float32)
            inertia = values.inertia[:, d].reshape(-1, 3, 3).astype(np.float32)
            if len(d):
                model.body_mass.assign(mass)
                model.body_inv_mass.assign(1.0 / mass)
                model.body_inertia.assign(inertia)
                model.body_inv_inertia.assign(np.linalg.inv(inertia.astype(float)))
                damping = [
                    (scene.bodies[i].linear_damping, scene.bodies[i].angular_damping) for i in d
                ]
                spread = np.tile(np.array(damping, np.float32), (w, 1))
                model.steel.rigid_body_linear_damping.assign(spread[:, 0].copy())
                model.steel.rigid_body_angular_damping.assign(spread[:, 1].copy())
            mu, restitution = self._materials(values)
            model.shape_material_mu.assign(mu)
            model.shape_material_restitution.assign(restitution)
            model.shape_transform.assign(self._shape_transforms(values))
            self.solver.notify_model_changed(
                flags.BODY_INERTIAL_PROPERTIES | flags.SHAPE_PROPERTIES
            )
            self.friction_scale.assign(values.friction_scale.astype(np.float32))
            pose = np.concatenate([values.position[:, d], values.quaternion[:, d]], axis=-1)
            pose = pose.reshape(-1, 7).astype(np.float32)
            for state in (self.state, self.other):
                if len(d):
                    state.body_q.assign(pose)
                    state.body_qd.zero_()
                    state.joint_q.assign(pose.reshape(-1))
                    state.joint_qd.zero_()
            self.solver.reset(self.state)
            self._load_program(batch)
            self.has_friction_change = bool(
                np.isfinite(batch.table[:, batch.kind == ADJUST, 4]).any()
            )
            self.pair.assign(self._pair_all if ground_contacts else self._pair_bodies)
            self.touched.fill_(-1)
            self.grid.fill_(dt)
            self.dt = dt
            self.record_every = record_every
            self._clock = np.array([0, record_every, 0, 0, len(batch.kind)], np.int32)
            self.clock.assign(self._clock)

    def _load_program(self, batch: ProgramBatch) -> None:
        n = len(batch.kind)
        self._reserve(max(1, n))
        p = self._primitives
        padded = np.zeros((self.n_worlds, p, FIELDS))
        padded[:, :n] = batch.table
        self.table.assign(padded)
        for target, values in ((self.kind, batch.kind), (self.body, batch.body)):
            row = np.zeros(p, np.int32)
            row[:n] = values
            target.assign(row)
        until = np.zeros((p, self.n_bodies), np.int32)
        until[:n] = batch.until
        self.until.assign(until)
        self.done.zero_()
        self.active.zero_()

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
            launches = -(-(target - int(done)) // STEPS_PER_GRAPH)
            graph = self.prepare()
            for _ in range(launches):
                wp.capture_launch(graph)
            f, w, d = n_frames, self.n_worlds, self.n_dynamic
            return {
                "pose": self.out_q.numpy()[:f].reshape(f, w, d, 7),
                "velocity": self.out_qd.numpy()[:f].reshape(f, w, d, 6),
                "impulse": self.impulse.numpy()[:f],
                "first": self.first.numpy()[:f],
                "depth": self.depth.numpy()[:f],
                "moments": self.moments.numpy()[:f],
            }

    def overflowed(self) -> bool:
        """Whether contacts were dropped for lack of room since `load`."""
        return bool(self.solver.constraint_overflow.numpy().any())

    def prepare(self) -> Any:
        """The captured steps; captures them if `load` asked for something new."""
        key = (self.dt, self.has_friction_change)
        if key not in self._graphs:
            wp = self.wp
            with wp.ScopedDevice(self.device):
                self._load_modules()
                with wp.ScopedCapture(device=self.device) as capture:
                    for _ in range(STEPS_PER_GRAPH):
                        self._step()
            self._graphs[key] = capture.graph
        return self._graphs[key]

    def _load_modules(self) -> None:
        """Compiles and loads all kernels by one eager step on states that are put back after it."""
        if self._graphs:
            return
        wp = self.wp
        saved = [
            (a, wp.clone(a))
            for a in (
                *(
                    getattr(s, n)
                    for s in (self.state, self.other)
                    for n in ("body_q", "body_qd", "joint_q", "joint_qd")
                    if getattr(s, n) is not None
                ),
                self.clock, self.touched, self.done, self.active, self.impulse, self.first,
                self.depth, self.moments, self.out_q, self.out_qd,
                self.model.shape_material_mu,
                self.model.steel.rigid_body_linear_damping,
                self.model.steel.rigid_body_angular_damping,
            )
        ]  # fmt: skip
        self._step()
        self._step()
        for array, copy in saved:
            wp.copy(array, copy)
        self.solver.reset(self.state)
        self._notify_friction()

    def _notify_friction(self) -> None:
        import newton

        self.solver.notify_model_changed(newton.ModelFlags.SHAPE_PROPERTIES)

    def _step(self) -> None:
        from esg.engines import newton_kernels as kernels

        wp, model, c = self.wp, self.model, self.contacts
        s = self.state
        wp.launch(
            kernels.run_program,
            dim=self.n_worlds,
            inputs=[
                self.clock, self.grid, self.kind, self.body, self.until, self.table, self.dynamic,
                self.n_dynamic, self.shape_body, self.n_shapes, self.friction_scale, self.touched,
                self.done, self.active, model.body_mass, model.steel.rigid_body_linear_damping,
                model.steel.rigid_body_angular_damping, model.shape_material_mu, s.body_qd,
                s.joint_qd,
            ],
        )  # fmt: skip
        if self.has_friction_change:
            self._notify_friction()
        s.clear_forces()
        self.pipeline.collide(s, c, dt=self.dt)
        self.solver.step(s, self.other, self.control, c, self.dt, observables=self.observables)
        wp.launch(
            kernels.accumulate_contacts,
            dim=c.rigid_contact_max,
            inputs=[
                self.clock, self.grid, c.rigid_contact_count, c.rigid_contact_shape0,
                c.rigid_contact_shape1, c.rigid_contact_point0, c.rigid_contact_point1,
                c.rigid_contact_normal, c.rigid_contact_margin0, c.rigid_contact_margin1,
                self.observables.contact_f, model.shape_body, s.body_q, self.shape_body,
                self.n_shapes, self.pair, self.touched, self.impulse, self.first, self.depth,
                self.moments,
            ],
        )  # fmt: skip
        self.state, self.other = self.other, self.state
        wp.launch(
            kernels.record,
            dim=model.body_count,
            inputs=[self.clock, self.state.body_q, self.state.body_qd, self.out_q, self.out_qd],
        )
        wp.launch(kernels.advance, dim=1, inputs=[self.clock])


def _add_shape(newton: Any, wp: Any, builder: Any, body: int, shape: Shape, config: Any) -> int:
    pose = wp.transform(wp.vec3(*shape.position), wp.quat(*shape.quaternion))
    size = shape.size
    if shape.kind == "sphere":
        return builder.add_shape_sphere(body, xform=pose, radius=size[0], cfg=config)
    if shape.kind == "box":
        return builder.add_shape_box(
            body, xform=pose, hx=size[0], hy=size[1], hz=size[2], cfg=config
        )
    if shape.kind == "capsule":
        return builder.add_shape_capsule(
            body, xform=pose, radius=size[0], half_height=size[2], cfg=config
        )
    if shape.kind == "cylinder":
        return builder.add_shape_cylinder(
            body, xform=pose, radius=size[0], half_height=size[2], cfg=config
        )
    vertices, faces = hull(np.array(shape.vertices))
    mesh = newton.Mesh(vertices.astype(np.float32), faces.reshape(-1).astype(np.int32))
    return builder.add_shape_convex_hull(body, xform=pose, mesh=mesh, cfg=config)


def hull(points: Floats) -> tuple[Floats, NDArray[np.int32]]:
    """Convex hull: its vertices, shape [n, 3], and outward triangles, shape [m, 3]."""
    from scipy.spatial import ConvexHull

    found = ConvexHull(points)
    used = found.vertices
    index = np.full(len(points), -1, np.int32)
    index[used] = np.arange(len(used))
    vertices = points[used]
    faces = index[found.simplices]
    corners = vertices[faces]
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", cross, found.equations[:, :3]) < 0.0
    faces[inward] = faces[inward][:, [0, 2, 1]]
    return vertices, faces
