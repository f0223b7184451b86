"""Worlds of a Newton model: solver, arrays and the captured step, whatever their scenes."""

from __future__ import annotations

from dataclasses import dataclass
import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.newton.setup import (
    BAUMGARTE,
    ITERATIONS,
    LOOSE_ITERATIONS,
    RESTITUTION_THRESHOLD_MPS,
    SPECULATIVE_GAP_M,
    STEPS_PER_GRAPH,
    STEPS_PER_GRAPH_CPU,
    quiet_warp,
)
from esg.engines.newton.sharing import share_kernels, share_sizes, sort_few_contacts
from esg.engines.program import FIELDS
from esg.engines.traction import FEATURES

if TYPE_CHECKING:
    from esg.engines.newton.breaking import Shatter
    from esg.engines.newton.jointed import Jointed
    from esg.engines.newton.swaps import Swaps

Ints = NDArray[np.int32]
Singles = NDArray[np.float32]


@dataclass(frozen=True)
class AxisRows:
    """What joints take of the solver beside what touches.

    Args:
        axes: Rows of the axes of a world, at most.
        limits: Whether an axis has limits.
        loose: Whether a joint is in no tree.
    """

    axes: int
    limits: bool
    loose: bool


class NewtonWorlds:
    """Solver, arrays and step of a model.

    W worlds of at most B bodies each; moving bodies and shapes are numbered through all worlds.

    Args:
        device: Warp device, such as "cpu" or "cuda:0".
        n_worlds: W.
        n_bodies: B.
    """

    out_q: Any
    out_qd: Any
    jointed: Jointed | None
    shatter: Shatter | None
    swaps: Swaps | None

    def __init__(self, device: str, n_worlds: int, n_bodies: int) -> None:
        self.wp = quiet_warp()
        share_kernels()
        share_sizes()
        sort_few_contacts()
        self.device, self.n_worlds, self.n_bodies = device, n_worlds, n_bodies
        self.on_gpu = not device.startswith("cpu")
        self.graph_steps = STEPS_PER_GRAPH if self.on_gpu else STEPS_PER_GRAPH_CPU
        self._graphs: dict[object, Any] = {}
        self._primitives = 0
        self.dt, self.has_friction_change = 0.0, False
        self.jointed, self.shatter, self.swaps = None, None, None

    def _finalize(
        self,
        builder: Any,
        first_shape: NDArray[np.int64],
        n_moving: int,
        points: int,
        points_per_world: int,
        rows: AxisRows | None = None,
    ) -> None:
        """Puts the model on the device and makes its collision pipeline and solver.

        Args:
            builder: `newton.ModelBuilder` of all worlds.
            first_shape: Of each world and their number, shape [W + 1].
            n_moving: Bodies that move in all worlds.
            points: Room for contact points in all worlds.
            points_per_world: In the most crowded one.
            rows: What joints take of the solver; None without joints.

        Raises:
            RuntimeError: If Newton laid shapes or bodies out in another order than the kernels of
                this package expect.
        """
        import newton

        wp = self.wp
        self.model = model = builder.finalize(device=self.device)
        expected = np.repeat(np.arange(self.n_worlds), np.diff(first_shape))
        if not np.array_equal(model.shape_world.numpy(), expected):
            raise RuntimeError("Newton changed the order of shapes in replicated worlds")
        if model.body_count != n_moving:
            raise RuntimeError("Newton changed the number of bodies in replicated worlds")
        # On the CPU kernels run in order anyway.
        mode = wp.DeterministicMode
        self.pipeline = newton.CollisionPipeline(
            model,
            broad_phase="explicit",
            rigid_contact_max=points,
            deterministic=self.on_gpu,
            verify_buffers=False,
            speculative_contact_gap_max=SPECULATIVE_GAP_M,
        )
        self.contacts = self.pipeline.contacts()
        self.solver = newton.solvers.SolverSteel(
            model,
            iterations=ITERATIONS if rows is None or not rows.loose else LOOSE_ITERATIONS,
            friction_anchor_beta=0.2,
            restitution_velocity_threshold=RESTITUTION_THRESHOLD_MPS,
            # One row along the normal and two for friction.
            free_body_constraint_max=3 * points_per_world,
            articulation_constraint_max=1 if rows is None else rows.axes + 3 * points_per_world,
            enable_joint_limits=rows is not None and rows.limits,
            drive_mode="augmented" if rows is None or rows.axes == 0 else "rows",
            baumgarte=BAUMGARTE,
            warn_constraint_overflow=False,
            deterministic=mode.RUN_TO_RUN if self.on_gpu else mode.NOT_GUARANTEED,
        )
        self.observables = self.solver.observables({"contact_f"}, contacts=self.contacts)
        self.state, self.other = model.state(), model.state()
        self.control = model.control()

    def _allocate(
        self,
        dynamic: Ints,
        pair: Ints,
        first_pair: NDArray[np.int64],
        first_shape: NDArray[np.int64],
        owner: NDArray[Any],
        chunk_frames: int,
    ) -> None:
        """Makes the arrays of the kernels.

        Args:
            dynamic: Number of each moving body, -1 for those that stand still, shape [W, B].
            pair: Number of each pair of bodies in its world, -1 for those that are not logged; row
                and column 0 are the ground, shape [W, B + 1, B + 1].
            first_pair: Of each world and their number, shape [W + 1]; `first_shape` likewise.
            owner: Body of each shape in its world, negative for the ground.
            chunk_frames: Frames whose pairs are summed up before they are read.
        """
        wp, w, b, c = self.wp, self.n_worlds, self.n_bodies, chunk_frames
        n_pairs = max(1, int(first_pair[-1]))
        self.dynamic = wp.array(dynamic, dtype=int)
        self.pair = wp.array(pair, dtype=int)
        self.first_pair = wp.array(first_pair.astype(np.int32), dtype=int)
        self.first_shape = wp.array(first_shape.astype(np.int32), dtype=int)
        self.shape_body = wp.array(np.maximum(owner, -1).astype(np.int32), dtype=int)
        self.friction_scale = wp.ones(w, dtype=float)
        self.touched = wp.full((w, b, b), -1, dtype=int)
        self.clock = wp.zeros(4, dtype=int)
        self.grid = wp.zeros(1, dtype=wp.float64)
        self.impulse = wp.zeros((c, n_pairs), dtype=wp.int64)
        self.first = wp.full((c, n_pairs), 2**31 - 1, dtype=int)
        self.depth = wp.zeros((c, n_pairs), dtype=float)
        self.moments = wp.zeros((c, n_pairs, 6), dtype=wp.int64)
        self.primitive_counts = wp.zeros(w, dtype=int)
        n = max(1, self.model.body_count)
        self.features = wp.zeros((n, FEATURES), dtype=float)
        self.braking, self.tips = wp.zeros(n, dtype=float), wp.zeros(n, dtype=int)
        self.start = wp.array(6 * np.arange(n, dtype=np.int32), dtype=int)
        self.before = wp.zeros(n, dtype=wp.vec3)
        self.driven = wp.zeros(n, dtype=int)

    # -- before a rollout --------------------------------------------------------------------------

    def _load_bodies(
        self, mass: Singles, inertia: Singles, damping: Singles, features: Singles
    ) -> None:
        """Writes what moving bodies (D in all worlds) are like.

        Args:
            mass: [kg], shape [D].
            inertia: Body axes [kg m^2], shape [D, 3, 3].
            damping: Linear and angular [1/s], shape [D, 2].
            features: For the ground, shape [D, FEATURES].
        """
        model = self.model
        model.body_mass.assign(mass)
        model.body_inv_mass.assign(1.0 / mass)
        model.body_inertia.assign(inertia)
        model.body_inv_inertia.assign(np.linalg.inv(inertia.astype(float)))
        for target, values in zip(self._dampings(), damping.T, strict=True):
            target.assign(values.copy())
        self.features.assign(features)

    def _load_shapes(self, mu: Singles, restitution: Singles, pose: Singles) -> None:
        """Writes materials and poses [S, 7] of all shapes; `_load_bodies` comes before."""
        import newton

        model, flags = self.model, newton.ModelFlags
        model.shape_material_mu.assign(mu)
        model.shape_material_restitution.assign(restitution)
        model.shape_transform.assign(pose)
        self.solver.notify_model_changed(flags.BODY_INERTIAL_PROPERTIES | flags.SHAPE_PROPERTIES)

    def _dampings(self) -> tuple[Any, Any]:
        """Linear and angular damping of all moving bodies, which programs may change."""
        of = self.model.steel
        if self.jointed is None:
            return of.rigid_body_linear_damping, of.rigid_body_angular_damping
        return self.jointed.linear_damping, self.jointed.angular_damping

    def _load_states(self, pose: Singles, coordinates: Singles | None = None) -> None:
        """Puts moving bodies at rest where they start.

        Args:
            pose: Of each, shape [D, 7].
            coordinates: Of their joints; None where each body is free.
        """
        import newton

        model = self.model
        for state in (self.state, self.other) if len(pose) else ():
            state.body_q.assign(pose)
            state.body_qd.zero_()
            state.joint_q.assign(pose.reshape(-1) if coordinates is None else coordinates)
            state.joint_qd.zero_()
            if coordinates is not None:
                # A variation moves bodies, and joints leave what they leave of it.
                newton.eval_fk(model, state.joint_q, state.joint_qd, state)
                self.solver.notify_model_changed(newton.ModelFlags.JOINT_PROPERTIES)
        self.solver.reset(self.state)

    def _load_programs(
        self, kind: Ints, body: Ints, until: Ints, table: NDArray[np.float64], count: Ints
    ) -> None:
        """Writes programs of P primitives: [W, P], [W, P], [W, P, B], [W, P, FIELDS] and [W].

        Graphs keep addresses: where there is no room for P primitives, they are dropped.
        """
        wp, w, p = self.wp, self.n_worlds, kind.shape[1]
        if p != self._primitives:
            self._primitives = p
            self._graphs.clear()
            self.kind = wp.zeros((w, p), dtype=int)
            self.body = wp.zeros((w, p), dtype=int)
            self.until = wp.zeros((w, p, self.n_bodies), dtype=int)
            self.table = wp.zeros((w, p, FIELDS), dtype=wp.float64)
            self.done = wp.zeros((w, p), dtype=int)
            self.active = wp.zeros((w, p), dtype=int)
        for target, values in ((self.kind, kind), (self.body, body), (self.until, until),
                               (self.table, table), (self.primitive_counts, count)):  # fmt: skip
            target.assign(values)
        self.done.zero_()
        self.active.zero_()

    def _room(self, primitives: int, least: int) -> int:
        """Room for a program: the last one's, or a power of two."""
        needed = max(least, 1 << (max(1, primitives) - 1).bit_length())
        return max(needed, self._primitives)

    def _start(self, dt: float, record_every: int, chunk_frames: int) -> None:
        """Sets the time grid to the beginning."""
        self.touched.fill_(-1)
        self.braking.zero_()
        self.driven.zero_()
        self.tips.zero_()
        self.before.fill_(self.wp.vec3(math.nan))
        self.grid.fill_(dt)
        self.dt, self.record_every = dt, record_every
        self._clock = np.array([0, record_every, 0, chunk_frames], np.int32)
        self.clock.assign(self._clock)

    # -- steps -------------------------------------------------------------------------------------

    def prepare(self) -> Any:
        """The captured steps; captures them if something new was loaded."""
        key = (self.dt, self.has_friction_change)
        if key not in self._graphs:
            wp = self.wp
            with wp.ScopedDevice(self.device):
                if not self._graphs and self.device != "cpu":
                    self._warm_up()
                with wp.ScopedCapture(device=self.device) as capture:
                    for _ in range(self.graph_steps):
                        self._step()
            self._graphs[key] = capture.graph
        return self._graphs[key]

    def take_steps(self) -> None:
        """Two eager steps of worlds that no job was loaded for: they name their kernels."""
        self._load_programs(
            np.zeros((self.n_worlds, 1), np.int32), np.zeros((self.n_worlds, 1), np.int32),
            np.zeros((self.n_worlds, 1, self.n_bodies), np.int32),
            np.zeros((self.n_worlds, 1, FIELDS)), np.zeros(self.n_worlds, np.int32),
        )  # fmt: skip
        with self.wp.ScopedDevice(self.device):
            self.out_q = self.out_qd = None
            self._step()
            self._step()

    def _warm_up(self) -> None:
        """Compiles and loads all kernels by two eager steps on states that are put back.

        A GPU cannot load any while it captures; on the CPU it can.
        """
        import newton

        wp, steel = self.wp, self.model.steel
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
                steel.rigid_body_linear_damping, steel.rigid_body_angular_damping, self.braking,
                self.before, self.tips, self.driven, *self._joint_states(),
            )
        ]  # fmt: skip
        self._step()
        self._step()
        for array, copy in saved:
            wp.copy(array, copy)
        self.solver.reset(self.state)
        self.solver.notify_model_changed(newton.ModelFlags.SHAPE_PROPERTIES)

    def _joint_states(self) -> list[Any]:
        joints, shatter, swaps = self.jointed, self.shatter, self.swaps
        own = [] if joints is None else joints.states()
        own = own if shatter is None else [*own, *shatter.states()]
        return own if swaps is None else [*own, swaps.now]

    def _step(self) -> None:
        import newton

        from esg.engines.newton import kernels

        wp, model, c = self.wp, self.model, self.contacts
        s, joints = self.state, self.jointed
        if joints is not None:
            joints.begin(s)
        if self.swaps is not None:
            self.swaps.begin(self, s)
        wp.launch(
            kernels.run_programs,
            dim=self.n_worlds,
            inputs=[
                self.clock, self.grid, self.primitive_counts, self.kind, self.body, self.until,
                self.table, self.dynamic, self.first_shape, self.shape_body,
                self.friction_scale, self.touched, self.done, self.active, model.body_mass,
                *self._dampings(), model.shape_material_mu, model.gravity, s.body_q, s.body_qd,
                s.joint_qd, self.start if joints is None else joints.start, self.features,
                self.braking, self.driven, self.before, self.tips,
            ],
        )  # fmt: skip
        if self.has_friction_change:
            self.solver.notify_model_changed(newton.ModelFlags.SHAPE_PROPERTIES)
        s.clear_forces()
        if joints is not None:
            joints.push(self, s)
        self.pipeline.collide(s, c, dt=self.dt)
        count = c.rigid_contact_count if joints is None else joints.ties.solid
        if self.shatter is not None:
            self.shatter.drop(self)
        if joints is not None:
            joints.ties.hold(self, s)
        wp.launch(
            kernels.touch_movers,
            dim=c.rigid_contact_max,
            inputs=[
                count, c.rigid_contact_shape0, c.rigid_contact_shape1,
                c.rigid_contact_normal, c.rigid_contact_margin0, c.rigid_contact_margin1,
                model.shape_body, s.body_q, c.rigid_contact_point0, c.rigid_contact_point1,
            ],
        )  # fmt: skip
        self.solver.step(s, self.other, self.control, c, self.dt, observables=self.observables)
        wp.launch(
            kernels.accumulate_contacts,
            dim=c.rigid_contact_max,
            inputs=[
                self.clock, self.grid, count, c.rigid_contact_shape0,
                c.rigid_contact_shape1, c.rigid_contact_point0, c.rigid_contact_point1,
                c.rigid_contact_normal, c.rigid_contact_margin0, c.rigid_contact_margin1,
                self.observables.contact_f, model.shape_body, s.body_q, model.shape_world,
                self.shape_body, self.first_pair, self.pair, self.touched, self.impulse,
                self.first, self.depth, self.moments,
            ],
        )  # fmt: skip
        if joints is not None:
            joints.ties.end(self)
        if self.shatter is not None:
            self.shatter.end(self, count, s, self.other)
        self.state, self.other = self.other, self.state
        wp.launch(
            kernels.record_frames,
            dim=model.body_count,
            inputs=[
                self.clock, self.state.body_q, self.state.body_qd, self.out_q,
                self.out_qd,
            ],
        )  # fmt: skip
        wp.launch(kernels.advance, dim=1, inputs=[self.clock])
