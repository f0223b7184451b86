"""Joints of the worlds of a Newton model: their arrays, and what they do in a step.

A model whose scenes have no joints has none of this. Bodies are numbered through all worlds.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.joint_rules import APPROACH_RATE, BREAK_WINDOW_S
from esg.engines.joints import Joint
from esg.engines.newton.setup import BAUMGARTE, quiet_warp
from esg.engines.newton.trees import (
    AXES,
    Floats,
    Link,
    Poses,
    Tie,
    Trees,
    anchored,
    coordinates,
    in_world,
    turned_around,
)

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

Ints = NDArray[np.int32]
Numbers = NDArray[np.int64]


BREAK_STEPS = 64
"""Room for the steps of the window in which what breaks a rope adds up."""


class Jointed:
    """Joints of all worlds of a model.

    Args:
        worlds: The model, with its solver.
        plans: Of each scene.
        scene_of: Scene of each world, shape [W].
        first_body: Number of each world's first body, shape [W + 1].
        local: Per scene, a body's number in its world, -1 for what does not move.
        marks: Per world, the shape by which ropes hold a body of its scene.
    """

    def __init__(
        self,
        worlds: NewtonWorlds,
        plans: list[Trees],
        scene_of: Numbers,
        first_body: Numbers,
        local: list[Numbers],
        marks: list[dict[int, int]],
    ) -> None:
        self.wp = quiet_warp()
        self.model = worlds.model
        self.plans, self.scene_of, self.first_body = plans, scene_of, first_body
        self.local, self.n_worlds = local, len(scene_of)
        model = self.model
        child = model.joint_child.numpy()
        self._joint_of = np.full(model.body_count, -1)
        self._joint_of[child] = np.arange(len(child))
        self._q_start = model.joint_q_start.numpy()
        self._qd_start = model.joint_qd_start.numpy()
        self._rows: dict[str, Numbers] = {}
        self._link_bodies()
        self._axes()
        self._balls()
        self._ties(marks)
        self._springs()
        self.kept = self.wp.zeros(max(1, model.body_count), dtype=self.wp.spatial_vector)

    def numbers(self, k: int, body: int) -> Numbers:
        """A body of scene k in each of its worlds; -1 where it does not move, shape [worlds]."""
        rows = np.nonzero(self.scene_of == k)[0]
        own = self.local[k][body] if body >= 0 else -1
        return self.first_body[rows] + own if own >= 0 else np.full(len(rows), -1)

    def _all_links(self) -> list[tuple[int, Link]]:
        return [(k, link) for k, plan in enumerate(self.plans) for link in plan.links]

    # -- arrays ------------------------------------------------------------------------------------

    def _link_bodies(self) -> None:
        """Which bodies hang in trees, and where the velocities of all others are."""
        wp = self.wp
        linked = np.zeros(max(1, self.model.body_count), bool)
        for k, link in self._all_links():
            linked[self.numbers(k, link.child)] = True
        start = self._qd_start[self._joint_of] if self.model.body_count else np.zeros(1, int)
        self.start = wp.array(np.where(linked, -1, start).astype(np.int32), dtype=int)
        self.linked = wp.array(np.nonzero(linked)[0].astype(np.int32), dtype=int)
        self.free = wp.array(np.nonzero(~linked)[0].astype(np.int32), dtype=int)
        self.linear_damping = wp.zeros(len(linked), dtype=float)
        self.angular_damping = wp.zeros(len(linked), dtype=float)

    def _axes(self) -> None:
        wp = self.wp
        found = [
            (link.record, self.numbers(k, link.child), self.numbers(k, link.parent))
            for k, link in self._all_links()
            if link.record is not None and link.record.kind in AXES
        ]
        joint = np.concatenate([self._joint_of[b] for _, b, _ in found] or [np.zeros(0, int)])

        def spread(values: list[float]) -> Any:
            each = [np.full(len(b), v) for v, (_, b, _) in zip(values, found, strict=True)]
            return wp.array(np.concatenate([*each, np.zeros(0)]).astype(np.float32), dtype=float)

        self.axes = found
        self.dof = wp.array(self._qd_start[joint].astype(np.int32), dtype=int)
        self.coordinate = wp.array(self._q_start[joint].astype(np.int32), dtype=int)
        records = [r for r, *_ in found]
        motors = [r.motor for r in records]
        self.stiffness = spread([r.stiffness for r in records])
        self.damping = spread([r.damping for r in records])
        self.axis_inertia = wp.ones(len(joint), dtype=float)
        self.speed = spread([0.0 if m is None else m.speed for m in motors])
        self.place = spread(
            [math.nan if m is None or m.position is None else m.position for m in motors]
        )

    def _balls(self) -> None:
        wp = self.wp
        found = [
            (k, link)
            for k, link in self._all_links()
            if link.record is not None and link.record.kind == "ball"
        ]
        pairs = [(self.numbers(k, n.parent), self.numbers(k, n.child), n.record) for k, n in found]

        def spread(values: list[Any], kind: Any) -> Any:
            return wp.array(np.concatenate([*values, np.zeros(0)]).astype(kind))

        self.ball_a = spread([a for a, _, _ in pairs], np.int32)
        self.ball_b = spread([b for _, b, _ in pairs], np.int32)
        self.ball_damping = spread(
            [np.full(len(b), r.damping) for _, b, r in pairs if r is not None], np.float32
        )
        self.ball_friction = spread(
            [np.full(len(b), r.friction) for _, b, r in pairs if r is not None], np.float32
        )

    def _by_world(self, of: str) -> tuple[list[tuple[int, Tie]], Numbers]:
        """Ties or springs of all worlds, world by world, and the number of each one's world."""
        found, world = [], []
        for w, k in enumerate(self.scene_of):
            for tie in vars(self.plans[k])[of]:
                found.append((w, tie))
                world.append(w)
        return found, np.array(world, int)

    def _bodies_of(self, found: list[tuple[int, Tie]], end: str) -> Any:
        numbers = [
            -1 if (body := getattr(t, end)) < 0 or self.local[self.scene_of[w]][body] < 0
            else self.first_body[w] + self.local[self.scene_of[w]][body]
            for w, t in found
        ]  # fmt: skip
        return self.wp.array(np.array(numbers, np.int32), dtype=int)

    def _ties(self, marks: list[dict[int, int]]) -> None:
        wp = self.wp
        found, world = self._by_world("ties")
        self.ties = found
        self.tie_world = wp.array(world.astype(np.int32), dtype=int)
        self.tie_a, self.tie_b = self._bodies_of(found, "a"), self._bodies_of(found, "b")
        self.mark_a, self.mark_b = (
            wp.array(
                np.array([marks[w].get(getattr(t, end), -1) for w, t in found], np.int32),
                dtype=int,
            )
            for end in ("a", "b")
        )
        self.longest = wp.array(np.array([t.length for _, t in found], np.float32), dtype=float)
        strength = np.array([t.break_impulse for _, t in found], np.float32)
        self.strength = wp.array(strength, dtype=float)
        self.breaks = bool(np.isfinite(strength).any())
        self.broken = wp.zeros(len(found), dtype=int)
        self.taken = wp.zeros((len(found), BREAK_STEPS), dtype=float)
        self.point_a = wp.zeros(len(found), dtype=wp.vec3)
        self.point_b = wp.zeros(len(found), dtype=wp.vec3)
        self.solid = wp.zeros(1, dtype=int)

    def _springs(self) -> None:
        wp = self.wp
        found, world = self._by_world("springs")
        self.springs = found
        first = np.searchsorted(world, np.arange(self.n_worlds + 1))
        self.first_spring = wp.array(first.astype(np.int32), dtype=int)
        self.spring_a, self.spring_b = self._bodies_of(found, "a"), self._bodies_of(found, "b")
        values = np.array([(t.length, t.stiffness, t.damping) for _, t in found], np.float32)
        self.rest, self.spring_stiffness, self.spring_damping = (
            wp.array(v.copy(), dtype=float) for v in values.reshape(-1, 3).T
        )
        self.spring_point_a = wp.zeros(len(found), dtype=wp.vec3)
        self.spring_point_b = wp.zeros(len(found), dtype=wp.vec3)

    # -- before a rollout --------------------------------------------------------------------------

    def load(self, poses: list[Poses]) -> NDArray[np.float32]:
        """Writes where joints are on what does not move, and mends what was broken.

        Args:
            poses: Of all bodies of each scene.

        Returns:
            Coordinates of all bodies.
        """
        frames, steel = self.model.joint_X_p.numpy(), self.model.steel
        q = np.zeros(self.model.joint_coord_count, np.float32)
        for k, plan in enumerate(self.plans):
            linked = {link.child for link in plan.links}
            for body in np.nonzero(self.local[k] >= 0)[0]:
                if int(body) not in linked:
                    self._put(q, k, Link(int(body), -1, -1, -1, None), poses[k])
            for link in plan.links:
                self._put(q, k, link, poses[k])
                if link.parent < 0 and link.record is not None:
                    frames[self._joint_of[self.numbers(k, link.child)]] = anchored(link, poses[k])
        self.model.joint_X_p.assign(frames)
        self._load_axes()
        self._load_points(self.ties, self.point_a, self.point_b, poses)
        self._load_points(self.springs, self.spring_point_a, self.spring_point_b, poses)
        self.broken.zero_()
        self.taken.zero_()
        # What is in a tree is damped as programs are heard; the solver would damp roots again.
        for target in (steel.rigid_body_linear_damping, steel.rigid_body_angular_damping):
            target.zero_()
        return q

    def _put(self, q: NDArray[np.float32], k: int, link: Link, poses: Poses) -> None:
        values = coordinates(link, poses)
        start = self._q_start[self._joint_of[self.numbers(k, link.child)]]
        q[start[:, None] + np.arange(values.shape[1])] = values

    def _load_axes(self) -> None:
        """Writes what axes have to move at least: their child, and their parent if it moves."""
        mass, inertia = self.model.body_mass.numpy(), self.model.body_inertia.numpy()
        found: list[float] = []
        for record, bodies, parents in self.axes:
            back = turned_around(record)
            for b, p in zip(bodies, parents, strict=True):
                ease = 1.0 / _inertia(record, mass[b], inertia[b])
                ease += 1.0 / _inertia(back, mass[p], inertia[p]) if p >= 0 else 0.0
                found.append(1.0 / ease)
        self.axis_inertia.assign(np.array(found, np.float32))

    def _load_points(
        self, found: list[tuple[int, Tie]], a: Any, b: Any, poses: list[Poses]
    ) -> None:
        """Anchors: in the frames of bodies that move, else in the world."""
        first = np.searchsorted(self.scene_of, np.arange(len(self.plans)))
        for end, target in (("a", a), ("b", b)):
            points = np.zeros((len(found), 3), np.float32)
            for i, (w, tie) in enumerate(found):
                k = self.scene_of[w]
                body, point = getattr(tie, end), getattr(tie, f"point_{end}")
                if body >= 0 and self.local[k][body] < 0:
                    own = tuple(p[w - first[k], None] for p in poses[k])
                    point = in_world(own, body, point)[0]
                points[i] = point
            target.assign(points)

    # -- in a step ---------------------------------------------------------------------------------

    def begin(self, state: Any) -> None:
        """Before programs: notes how fast links are."""
        self.wp.copy(self.kept, state.body_qd)

    def push(self, worlds: NewtonWorlds, state: Any) -> None:
        """After programs: forces on bodies and axes."""
        from esg.engines.newton import joint_kernels as kernels

        model, launch = self.model, self.wp.launch
        if len(self.linked):
            launch(
                kernels.ask_links,
                dim=len(self.linked),
                inputs=[
                    self.linked, worlds.grid, self.kept, model.body_mass, model.body_inertia,
                    self.linear_damping, self.angular_damping, state.body_q, state.body_qd,
                    state.body_f,
                ],
            )  # fmt: skip
        for source, target in (
            (self.linear_damping, model.steel.rigid_body_linear_damping),
            (self.angular_damping, model.steel.rigid_body_angular_damping),
        ):
            if len(self.free):
                launch(kernels.damp_free, dim=len(self.free), inputs=[self.free, source, target])
        if len(self.ball_b):
            launch(
                kernels.brake_balls,
                dim=1,
                inputs=[
                    worlds.grid, self.ball_a, self.ball_b, self.ball_damping, self.ball_friction,
                    model.body_inertia, state.body_q, state.body_qd, state.body_f,
                ],
            )  # fmt: skip
        if self.springs:
            launch(
                kernels.pull_springs,
                dim=self.n_worlds,
                inputs=[
                    self.first_spring, worlds.grid, self.spring_a, self.spring_b,
                    self.spring_point_a, self.spring_point_b, self.rest, self.spring_stiffness,
                    self.spring_damping, model.body_inv_mass, model.body_inv_inertia,
                    state.body_q, state.body_qd, state.body_f,
                ],
            )  # fmt: skip
        if len(self.dof):
            control = worlds.control
            launch(
                kernels.drive_axes,
                dim=len(self.dof),
                inputs=[
                    worlds.grid, self.coordinate, self.dof, self.stiffness, self.damping,
                    self.axis_inertia, self.speed, self.place, APPROACH_RATE, state.joint_q,
                    state.joint_qd, control.joint_f, control.joint_target_qd,
                ],
            )  # fmt: skip

    def hold(self, worlds: NewtonWorlds, state: Any) -> None:
        """After collisions were found: ropes."""
        from esg.engines.newton import joint_kernels as kernels

        c, launch = worlds.contacts, self.wp.launch
        launch(kernels.count_solid, dim=1, inputs=[c.rigid_contact_count, self.solid])
        if not self.ties:
            return
        launch(
            kernels.hold_ropes,
            dim=len(self.ties),
            inputs=[
                self.solid, worlds.grid, self.model.gravity, BAUMGARTE, self.tie_world,
                self.tie_a, self.tie_b, self.mark_a, self.mark_b, self.point_a, self.point_b,
                self.longest, self.broken, state.body_q, state.body_qd,
                c.rigid_contact_count, c.rigid_contact_shape0, c.rigid_contact_shape1,
                c.rigid_contact_point0, c.rigid_contact_point1, c.rigid_contact_normal,
                c.rigid_contact_margin0, c.rigid_contact_margin1,
            ],
        )  # fmt: skip

    def end(self, worlds: NewtonWorlds) -> None:
        """After the solver: ropes that break."""
        from esg.engines.newton import joint_kernels as kernels

        if self.breaks:
            self.wp.launch(
                kernels.break_ropes,
                dim=len(self.ties),
                inputs=[
                    worlds.clock, self.solid, worlds.grid, BREAK_WINDOW_S, self.strength,
                    worlds.observables.contact_f, self.taken, self.broken,
                ],
            )  # fmt: skip


def _inertia(joint: Joint, mass: float, inertia: Floats) -> float:
    """What an axis has to move at least: its child [kg m^2 or kg]."""
    if joint.kind == "slider":
        return float(mass)
    x, y, z, w = joint.child_rotation
    axis = np.array([1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)])
    arm = np.cross(axis, np.array(joint.child_anchor))
    return float(axis @ inertia @ axis + mass * arm @ arm)
