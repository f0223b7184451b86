"""A Newton model whose worlds are those of several scenes, its captured step and its buffers."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.executor import ADJUST
from esg.engines.fleet_arena import Buffer
from esg.engines.fleet_builder import Blueprint, Wanted
from esg.engines.fleet_jobs import Job, Played, SceneShapes
from esg.engines.newton_kernels import FIXED_POINT
from esg.engines.newton_model import (
    ITERATIONS,
    POINTS_PER_SHAPE,
    POINTS_PER_WORLD,
    RESTITUTION_THRESHOLD_MPS,
    SPECULATIVE_GAP_M,
    STEPS_PER_GRAPH,
    _share_kernels,
    quiet_warp,
)
from esg.engines.program import FIELDS
from esg.engines.scene import ContactLog
from esg.units import quat_multiply, quat_rotate

CHUNK_FRAMES = 8
"""Frames whose pairs are summed up before they are packed; a multiple of STEPS_PER_GRAPH / 4."""

Singles = NDArray[np.float32]


class FleetModel:
    """Worlds of several scenes, the captured step and its buffers.

    Args:
        wanted: Per scene its key, the number of its worlds and the factor on room for contacts.
        shapes: Of the scenes.
        blueprint: Of these worlds.
        device: Warp device.
    """

    def __init__(
        self, wanted: Wanted, shapes: list[SceneShapes], blueprint: Blueprint, device: str
    ) -> None:
        self.wp = wp = quiet_warp()
        import newton

        _share_kernels()
        self.wanted, self.shapes, self.device = wanted, shapes, device
        self.last: dict[int, Job] = {}
        self.graphs: dict[object, Any] = {}
        self.primitives = 0
        self.frames = 0
        self.rows = 0
        with wp.ScopedDevice(device):
            self._build(newton, blueprint)
            self._allocate()

    def _build(self, newton: Any, blueprint: Blueprint) -> None:
        wp, steel = self.wp, newton.solvers.SolverSteel
        self.owners = blueprint.owners
        points = [
            growth * (POINTS_PER_WORLD + POINTS_PER_SHAPE * int(np.diff(s.first)[s.dynamic].sum()))
            for (_, _, growth), s in zip(self.wanted, self.shapes, strict=True)
        ]
        self.model = model = blueprint.builder.finalize(device=self.device)
        copies = np.array([w for _, w, _ in self.wanted])
        self.copies = copies
        self.scene_of = np.repeat(np.arange(len(copies)), copies)
        self.n_worlds = int(copies.sum())
        n_shapes = np.array([len(o) for o in self.owners])[self.scene_of]
        n_moving = np.array([int(s.dynamic.sum()) for s in self.shapes])[self.scene_of]
        self.first_shape = np.concatenate([[0], np.cumsum(n_shapes)])
        self.first_body = np.concatenate([[0], np.cumsum(n_moving)])
        if not np.array_equal(
            model.shape_world.numpy(), np.repeat(np.arange(self.n_worlds), n_shapes)
        ):
            raise RuntimeError("Newton changed the order of shapes in replicated worlds")
        if model.body_count != self.first_body[-1]:
            raise RuntimeError("Newton changed the number of bodies in replicated worlds")
        cuda = self.device != "cpu"
        mode = wp.DeterministicMode
        self.pipeline = newton.CollisionPipeline(
            model,
            broad_phase="explicit",
            rigid_contact_max=int((np.array(points) * copies).sum()),
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
            free_body_constraint_max=3 * _rounded(max(points)),
            articulation_constraint_max=1,
            warn_constraint_overflow=False,
            deterministic=mode.RUN_TO_RUN if cuda else mode.NOT_GUARANTEED,
        )
        self.observables = self.solver.observables({"contact_f"}, contacts=self.contacts)
        self.state, self.other = model.state(), model.state()
        self.control = model.control()

    def _allocate(self) -> None:
        wp, w = self.wp, self.n_worlds
        b = max(s.n_bodies for s in self.shapes)
        self.n_bodies = b
        dynamic = np.full((w, b), -1, np.int32)
        pair = np.full((len(self.shapes), b + 1, b + 1), -1, np.int32)
        self.pairs: list[NDArray[np.int64]] = []
        for k, s in enumerate(self.shapes):
            n = s.n_bodies
            rows = np.nonzero(self.scene_of == k)[0]
            local = np.cumsum(s.dynamic) - 1
            dynamic[rows, :n] = np.where(s.dynamic, self.first_body[rows][:, None] + local, -1)
            # Contacts with the ground are not logged; pairs of two static bodies never touch.
            first, second = np.triu_indices(n, 1)
            keep = s.dynamic[first] | s.dynamic[second]
            pairs = np.stack([first[keep], second[keep]], axis=1)
            self.pairs.append(pairs)
            number = np.arange(len(pairs))
            pair[k, pairs[:, 0] + 1, pairs[:, 1] + 1] = number
            pair[k, pairs[:, 1] + 1, pairs[:, 0] + 1] = number
        counts = np.array([len(p) for p in self.pairs])[self.scene_of]
        self.first_pair = np.concatenate([[0], np.cumsum(counts)])
        self.n_pairs = max(1, int(self.first_pair[-1]))
        self.dynamic = wp.array(dynamic, dtype=int)
        self.pair = wp.array(pair[self.scene_of], dtype=int)
        self.d_first_pair = wp.array(self.first_pair.astype(np.int32), dtype=int)
        self.d_first_shape = wp.array(self.first_shape.astype(np.int32), dtype=int)
        self.owner = np.concatenate([self.owners[k] for k in self.scene_of])
        self.shape_body = wp.array(np.maximum(self.owner, -1).astype(np.int32), dtype=int)
        self.shape_world = self.model.shape_world
        self.friction_scale = wp.ones(w, dtype=float)
        self.touched = wp.full((w, b, b), -1, dtype=int)
        self.clock = wp.zeros(5, dtype=int)
        self.grid = wp.zeros(1, dtype=wp.float64)
        c = CHUNK_FRAMES
        self.impulse = wp.zeros((c, self.n_pairs), dtype=wp.int64)
        self.first = wp.full((c, self.n_pairs), 2**31 - 1, dtype=int)
        self.depth = wp.zeros((c, self.n_pairs), dtype=float)
        self.moments = wp.zeros((c, self.n_pairs, 6), dtype=wp.int64)
        self.primitive_counts = wp.zeros(w, dtype=int)
        self.count = wp.zeros(1, dtype=int)

    # -- one pass ----------------------------------------------------------------------------------

    def play(
        self, jobs: list[Job], buffer: Buffer, seconds: dict[str, float]
    ) -> tuple[list[Played], NDArray[np.bool_]]:
        """Plays jobs of the model's scenes; also tells whose contacts found no room.

        Worlds that nobody asks for play their last job again. Wall clock is added to `seconds`.
        """
        frames = max(j.frames.n_frames for j in jobs) - 1
        every = jobs[0].frames.record_every
        chosen = self._places(jobs)
        self.last.update(zip(chosen, jobs, strict=True))
        everything = [self.last[k] for k in range(len(self.wanted))]
        begin = time.perf_counter()
        with self.wp.ScopedDevice(self.device):
            self._load(everything, frames, every)
            graph = self._graph()
            loaded = time.perf_counter()
            self._run(graph, frames, every)
            self.wp.synchronize_device()
            ran = time.perf_counter()
            played, full = self._read(everything, frames, buffer, set(chosen))
        seconds["load"] += loaded - begin
        seconds["run"] += ran - loaded
        seconds["read"] += time.perf_counter() - ran
        return [played[k] for k in chosen], full[chosen]

    def _places(self, jobs: list[Job]) -> list[int]:
        """Where in the model jobs are played; a scene may have several places."""
        free: dict[tuple[int, int], list[int]] = {}
        for k, (key, worlds, _) in enumerate(self.wanted):
            free.setdefault((key, worlds), []).append(k)
        return [free[j.key, j.n_worlds].pop(0) for j in jobs]

    def _load(self, jobs: list[Job], frames: int, every: int) -> None:
        import newton

        wp, model = self.wp, self.model
        single = np.float32
        move = [np.nonzero(s.dynamic)[0] for s in self.shapes]
        pairs = list(zip(jobs, move, strict=True))

        def bodies(values: list[Any]) -> Singles:
            return np.concatenate(values).astype(single)

        if model.body_count:
            mass = bodies([j.mass[:, d].reshape(-1) for j, d in pairs])
            inertia = bodies([j.inertia.reshape(-1, 3, 3) for j in jobs])
            damping = bodies([np.tile(s.damping[d], (j.n_worlds, 1)) for (j, d), s in
                              zip(pairs, self.shapes, strict=True)])  # fmt: skip
            model.body_mass.assign(mass)
            model.body_inv_mass.assign(1.0 / mass)
            model.body_inertia.assign(inertia)
            model.body_inv_inertia.assign(np.linalg.inv(inertia.astype(float)))
            model.steel.rigid_body_linear_damping.assign(damping[:, 0].copy())
            model.steel.rigid_body_angular_damping.assign(damping[:, 1].copy())
        self._load_shapes(jobs)
        self.solver.notify_model_changed(
            newton.ModelFlags.BODY_INERTIAL_PROPERTIES | newton.ModelFlags.SHAPE_PROPERTIES
        )
        self.friction_scale.assign(np.concatenate([j.friction_scale for j in jobs]))
        if model.body_count:
            pose = bodies([
                np.concatenate([j.position[:, d], j.quaternion[:, d]], axis=-1).reshape(-1, 7)
                for j, d in pairs
            ])  # fmt: skip
            for state in (self.state, self.other):
                state.body_q.assign(pose)
                state.body_qd.zero_()
                state.joint_q.assign(pose.reshape(-1))
                state.joint_qd.zero_()
        self.solver.reset(self.state)
        self._load_programs(jobs)
        self.touched.fill_(-1)
        self.grid.fill_(jobs[0].frames.dt)
        self.dt = jobs[0].frames.dt
        if frames > self.frames:
            self.frames = frames
            n = max(1, model.body_count)
            self.out_q = wp.zeros((frames, n), dtype=wp.transform)
            self.out_qd = wp.zeros((frames, n), dtype=wp.spatial_vector)
            self.graphs.clear()
        self._clock = np.array([0, every, 0, CHUNK_FRAMES, 0], np.int32)
        self.clock.assign(self._clock)

    def _load_shapes(self, jobs: list[Job]) -> None:
        """Materials of all shapes, and poses of those that stand still."""
        model = self.model
        mu = np.empty(len(self.owner), np.float32)
        restitution = np.empty_like(mu)
        pose = model.shape_transform.numpy()
        for k, (job, s) in enumerate(zip(jobs, self.shapes, strict=True)):
            w, own = job.n_worlds, self.owners[k]
            world = int(self.copies[:k].sum())
            span = slice(self.first_shape[world], self.first_shape[world + w])
            m = np.empty((w, len(own)), np.float32)
            r = np.empty_like(m)
            m[:, 2:], r[:, 2:] = job.friction[:, own[2:]], job.restitution[:, own[2:]]
            m[:, :2], r[:, :2] = job.ground[:, :2], job.ground[:, 2:]
            mu[span], restitution[span] = m.reshape(-1), r.reshape(-1)
            still = np.nonzero(s.static[own[2:]])[0]
            if len(still):
                rows = pose[span].reshape(w, len(own), 7)
                body, shape = own[2:][still], _shape_numbers(s)[still]
                q = job.quaternion[:, body].astype(float)
                local = np.broadcast_to(s.origin[shape], (w, len(still), 3))
                rows[:, 2 + still, :3] = job.position[:, body] + quat_rotate(q, local)
                turn = np.broadcast_to(s.rotation[shape], (w, len(still), 4))
                rows[:, 2 + still, 3:] = quat_multiply(q, turn)
        model.shape_material_mu.assign(mu)
        model.shape_material_restitution.assign(restitution)
        model.shape_transform.assign(pose)

    def _load_programs(self, jobs: list[Job]) -> None:
        wp, w, b = self.wp, self.n_worlds, self.n_bodies
        most = max(len(j.kind) for j in jobs)
        if most > self.primitives or not self.primitives:
            self.primitives = p = max(8, 1 << (max(1, most) - 1).bit_length())
            self.kind = wp.zeros((w, p), dtype=int)
            self.body = wp.zeros((w, p), dtype=int)
            self.until = wp.zeros((w, p, b), dtype=int)
            self.table = wp.zeros((w, p, FIELDS), dtype=wp.float64)
            self.done = wp.zeros((w, p), dtype=int)
            self.active = wp.zeros((w, p), dtype=int)
            self.graphs.clear()
        p = self.primitives
        kind, body = np.zeros((w, p), np.int32), np.zeros((w, p), np.int32)
        until, table = np.zeros((w, p, b), np.int32), np.zeros((w, p, FIELDS))
        count = np.zeros(w, np.int32)
        at, changes = 0, False
        for j in jobs:
            rows, n = slice(at, at + j.n_worlds), len(j.kind)
            kind[rows, :n], body[rows, :n] = j.kind, j.body
            until[rows, :n, : j.until.shape[1]] = j.until
            table[rows, :n] = j.table
            count[rows] = n
            changes |= bool(np.isfinite(j.table[:, j.kind == ADJUST, 4]).any())
            at += j.n_worlds
        for target, values in ((self.kind, kind), (self.body, body), (self.until, until),
                               (self.table, table), (self.primitive_counts, count)):  # fmt: skip
            target.assign(values)
        self.has_friction_change = changes
        self.done.zero_()
        self.active.zero_()

    def _graph(self) -> Any:
        key = (self.dt, self.has_friction_change)
        if key not in self.graphs:
            wp = self.wp
            if not self.graphs:
                self._warm_up()
            with wp.ScopedCapture(device=self.device) as capture:
                for _ in range(STEPS_PER_GRAPH):
                    self._step()
            self.graphs[key] = capture.graph
        return self.graphs[key]

    def _warm_up(self) -> None:
        """Compiles and loads all kernels by two eager steps on states that are put back."""
        import newton

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
                self.depth, self.moments, self.model.shape_material_mu,
                self.model.steel.rigid_body_linear_damping,
                self.model.steel.rigid_body_angular_damping,
            )
        ]  # fmt: skip
        self._step()
        self._step()
        for array, copy in saved:
            wp.copy(array, copy)
        self.solver.reset(self.state)
        self.solver.notify_model_changed(newton.ModelFlags.SHAPE_PROPERTIES)

    def _step(self) -> None:
        import newton

        from esg.engines import fleet_kernels as kernels
        from esg.engines.newton_kernels import advance

        wp, model, c = self.wp, self.model, self.contacts
        s = self.state
        wp.launch(
            kernels.run_programs,
            dim=self.n_worlds,
            inputs=[
                self.clock, self.grid, self.primitive_counts, self.kind, self.body, self.until,
                self.table, self.dynamic, self.d_first_shape, self.shape_body,
                self.friction_scale, self.touched, self.done, self.active, model.body_mass,
                model.steel.rigid_body_linear_damping, model.steel.rigid_body_angular_damping,
                model.shape_material_mu, s.body_qd, s.joint_qd,
            ],
        )  # fmt: skip
        if self.has_friction_change:
            self.solver.notify_model_changed(newton.ModelFlags.SHAPE_PROPERTIES)
        s.clear_forces()
        self.pipeline.collide(s, c, dt=self.dt)
        self.solver.step(s, self.other, self.control, c, self.dt, observables=self.observables)
        wp.launch(
            kernels.accumulate_many,
            dim=c.rigid_contact_max,
            inputs=[
                self.clock, self.grid, c.rigid_contact_count, c.rigid_contact_shape0,
                c.rigid_contact_shape1, c.rigid_contact_point0, c.rigid_contact_point1,
                c.rigid_contact_normal, c.rigid_contact_margin0, c.rigid_contact_margin1,
                self.observables.contact_f, model.shape_body, s.body_q, self.shape_world,
                self.shape_body, self.d_first_pair, self.pair, self.touched, self.impulse,
                self.first, self.depth, self.moments,
            ],
        )  # fmt: skip
        self.state, self.other = self.other, self.state
        wp.launch(
            kernels.record_frame,
            dim=model.body_count,
            inputs=[self.clock, self.state.body_q, self.state.body_qd, self.out_q, self.out_qd],
        )
        wp.launch(advance, dim=1, inputs=[self.clock])

    def _run(self, graph: Any, frames: int, every: int) -> None:
        """Plays all frames chunk by chunk and gathers the pairs that touched."""
        from esg.engines import fleet_kernels as kernels

        wp = self.wp
        self._reserve_rows(max(self.rows, 64 * self.n_worlds))
        self.count.zero_()
        done = 0
        for first in range(0, frames, CHUNK_FRAMES):
            n = min(CHUNK_FRAMES, frames - first)
            if first:
                # The step counter lives on the device; only where the chunk begins is written.
                wp.launch(kernels.begin_chunk, dim=1, inputs=[self.clock, first, n])
            else:
                self._clock[3] = n
                self.clock.assign(self._clock)
            target = (first + n) * every
            launches = -(-(target - done) // STEPS_PER_GRAPH)
            for _ in range(launches):
                wp.capture_launch(graph)
            done += launches * STEPS_PER_GRAPH
            wp.launch(
                kernels.pack_pairs,
                dim=(n, self.n_pairs),
                inputs=[first + 1, self.impulse, self.first, self.depth, self.moments, self.count,
                        self.ints, self.depths, self.sums],
            )  # fmt: skip

    def _reserve_rows(self, n: int) -> None:
        if n <= self.rows:
            return
        wp = self.wp
        self.rows = n
        self.ints = wp.zeros((n, 3), dtype=int)
        self.depths = wp.zeros(n, dtype=float)
        self.sums = wp.zeros((n, 7), dtype=wp.int64)

    def _read(
        self, jobs: list[Job], frames: int, buffer: Buffer, asked: set[int]
    ) -> tuple[dict[int, Played], NDArray[np.bool_]]:
        wp = self.wp
        n_bodies = self.model.body_count
        pose_at, pose = buffer.take((frames, n_bodies, 7))
        _, velocity = buffer.take((frames, n_bodies, 6))
        for target, source, dtype in ((pose, self.out_q, wp.transform),
                                      (velocity, self.out_qd, wp.spatial_vector)):  # fmt: skip
            if n_bodies:
                into = wp.array(target, dtype=dtype, device="cpu", copy=False)
                wp.copy(into, source, count=frames * n_bodies)
        used = int(self.count.numpy()[0])
        lost = used > self.rows
        n = min(used, self.rows)
        ints, depths, sums = (a[:n].numpy() for a in (self.ints, self.depths, self.sums))
        world = np.searchsorted(self.first_pair, ints[:, 1], side="right") - 1
        order = np.lexsort((ints[:, 1], ints[:, 0], world))
        world, ints, depths, sums = world[order], ints[order], depths[order], sums[order]
        overflow = self.solver.constraint_overflow.numpy()
        full = np.asarray(overflow[: self.n_worlds], bool) | bool(overflow[self.n_worlds :].any())
        over = np.zeros(len(jobs), bool)
        out: dict[int, Played] = {}
        at = -jobs[0].n_worlds
        for k, job in enumerate(jobs):
            at += jobs[k - 1].n_worlds if k else jobs[0].n_worlds
            if k not in asked:
                continue
            w, t = job.n_worlds, job.frames.n_frames - 1
            d = int(self.shapes[k].dynamic.sum())
            columns = slice(self.first_body[at], self.first_body[at + w])
            p = pose[:t, columns].reshape(t, w, d, 7).swapaxes(0, 1)
            v = velocity[:t, columns].reshape(t, w, d, 6).swapaxes(0, 1)
            begin, stop = np.searchsorted(world, [at, at + w])
            rows = slice(begin, stop)
            log = self._log(k, job, world[rows] - at, ints[rows], depths[rows], sums[rows],
                            self.first_pair[world[rows]])  # fmt: skip
            out[k] = Played(p[..., :3], p[..., 3:], v[..., :3], v[..., 3:], None, None, log)
            over[k] = full[at : at + w].any()
        if lost:
            # The list of touches was too short: play the pass again with room for all.
            self._reserve_rows(used)
            every = jobs[0].frames.record_every
            buffer.used = pose_at
            self._load(jobs, frames, every)
            self._run(self._graph(), frames, every)
            return self._read(jobs, frames, buffer, asked)
        return out, over

    def _log(
        self,
        k: int,
        job: Job,
        world: NDArray[np.int64],
        ints: NDArray[np.int32],
        depths: Singles,
        sums: NDArray[np.int64],
        first_pair: NDArray[np.int64],
    ) -> ContactLog:
        bodies = self.pairs[k][ints[:, 1] - first_pair]
        impulse = sums[:, 0].astype(float)
        moments = sums[:, 1:].astype(float) / impulse[:, None]
        normal = moments[:, 3:]
        length = np.linalg.norm(normal, axis=1, keepdims=True)
        return ContactLog(
            world=world.astype(np.int32),
            frame=ints[:, 0].astype(np.int32),
            a=bodies[:, 0].astype(np.int32),
            b=bodies[:, 1].astype(np.int32),
            time=(ints[:, 2] + 1) * job.frames.dt,
            impulse=impulse / FIXED_POINT,
            depth=np.maximum(depths.astype(float), 0.0),
            point=moments[:, :3],
            normal=normal / np.where(length > 0.0, length, 1.0),
        )


def _shape_numbers(s: SceneShapes) -> NDArray[np.int64]:
    """Numbers of the shapes that Newton's worlds hold, in their order."""
    return np.array(
        [i for b in range(s.n_bodies) if s.collides[b] for i in range(s.first[b], s.first[b + 1])],
        int,
    )


def _rounded(points: int) -> int:
    """The next power of two, or three quarters of it: kernels are compiled for every number."""
    size = 1 << max(4, (points - 1).bit_length())
    return size * 3 // 4 if points <= size * 3 // 4 else size
