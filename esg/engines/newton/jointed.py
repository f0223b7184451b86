"""Joints of the worlds of a Newton model: their arrays, and what they do in a step.

A model whose scenes have no joints has none of this. Bodies are numbered through all worlds.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.joints import Joint
from esg.engines.newton.axes import Axes
from esg.engines.newton.places import Places
from esg.engines.newton.setup import quiet_warp
from esg.engines.newton.ties import Ties, bodies_of, by_world, load_points
from esg.engines.newton.trees import Link, Poses, anchored, coordinates

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

Ints = NDArray[np.int32]


class Jointed:
    """Joints of all worlds of a model.

    Args:
        model: Newton's, finalized.
        places: Where bodies and joints are in it.
        marks: Per world, the shape by which ties hold a body of its scene.
    """

    def __init__(self, model: Any, places: Places, marks: list[dict[int, int]]) -> None:
        self.wp = quiet_warp()
        self.model, self._places = model, places
        self._link_bodies()
        self.axes = Axes(places)
        self.ties = Ties(places, marks)
        self.brakes = _Brakes(places, self.ties)
        self.springs = _Springs(places)
        self.kept = self.wp.zeros(max(1, model.body_count), dtype=self.wp.spatial_vector)
        self._drives = self.wp.full((len(places.scene_of), 1), -1, dtype=int)

    def _link_bodies(self) -> None:
        """Which bodies hang in trees, and where the velocities of all others are."""
        wp, places = self.wp, self._places
        linked = np.zeros(max(1, self.model.body_count), bool)
        for k, link in places.links:
            linked[places.numbers(k, link.child)] = True
        start = places.qd_start[places.joint_of] if self.model.body_count else np.zeros(1, int)
        self.start = wp.array(np.where(linked, -1, start).astype(np.int32), dtype=int)
        self.linked = wp.array(np.nonzero(linked)[0].astype(np.int32), dtype=int)
        self.free = wp.array(np.nonzero(~linked)[0].astype(np.int32), dtype=int)
        self.linear_damping = wp.zeros(len(linked), dtype=float)
        self.angular_damping = wp.zeros(len(linked), dtype=float)

    # -- before a rollout --------------------------------------------------------------------------

    def load(self, poses: list[Poses]) -> NDArray[np.float32]:
        """Writes where joints are on what does not move, and mends what was broken.

        Args:
            poses: Of all bodies of each scene.

        Returns:
            Coordinates of all bodies.
        """
        places, steel = self._places, self.model.steel
        frames = self.model.joint_X_p.numpy()
        q = np.zeros(self.model.joint_coord_count, np.float32)
        for k, plan in enumerate(places.plans):
            linked = {link.child for link in plan.links}
            free = [int(b) for b in np.nonzero(places.local[k] >= 0)[0] if int(b) not in linked]
            for link in [*(Link(b, -1, -1, -1, None) for b in free), *plan.links]:
                joint = places.joint_of[places.numbers(k, link.child)]
                values = coordinates(link, poses[k])
                q[places.q_start[joint][:, None] + np.arange(values.shape[1])] = values
                if link.parent < 0 and link.record is not None:
                    frames[joint] = anchored(link, poses[k])
        self.model.joint_X_p.assign(frames)
        self.axes.load(self.model)
        self.ties.load(poses)
        self.springs.load(poses)
        # What is in a tree is damped as programs are heard; the solver would damp roots again.
        for target in (steel.rigid_body_linear_damping, steel.rigid_body_angular_damping):
            target.zero_()
        return q

    def load_drives(self, joints: list[Ints], room: int) -> bool:
        """Writes which axes primitives drive.

        Args:
            joints: Per scene, the joint that each primitive drives, -1 for none.
            room: For primitives.

        Returns:
            Whether a captured step has lost its array.
        """
        drives = np.full((len(self._places.scene_of), room), -1, np.int32)
        for k, own in enumerate(joints):
            rows = self._places.worlds(k)
            drives[rows, : len(own)] = self.axes.of(k, own, len(rows))
        lost = self._drives.shape != drives.shape
        if lost:
            self._drives = self.wp.array(drives, dtype=int)
        else:
            self._drives.assign(drives)
        return lost

    def states(self) -> list[Any]:
        """Arrays that a step changes."""
        own = [self.linear_damping, self.angular_damping, self.ties.broken, self.ties.taken]
        return [*own, *self.axes.states(self.model)]

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
        self.brakes.push(worlds, state)
        self.springs.push(worlds, state)
        self.axes.push(worlds, state, self._drives)


class _Brakes:
    """Damping and friction of ball joints, and of hinges that are in no tree."""

    def __init__(self, places: Places, ties: Ties) -> None:
        self.wp = wp = quiet_warp()
        found: list[tuple[int, int, int, Joint]] = []
        first = [0]
        for w, k in enumerate(places.scene_of):
            plan = places.plans[k]
            for link in plan.links:
                if link.record is not None and link.record.kind == "ball":
                    ends = places.number(w, link.parent), places.number(w, link.child)
                    found.append((*ends, -1, link.record))
            for joint in plan.loose:
                tie = next(t for t in plan.ties if t.joint == joint)
                ends = places.number(w, tie.a), places.number(w, tie.b)
                found.append((*ends, ties.groups[w, joint], plan.joints[joint]))
            first.append(len(found))
        self._ties = ties
        self.first = wp.array(np.array(first, np.int32), dtype=int)
        whole = np.array([f[:3] for f in found], np.int32).reshape(-1, 3)
        slow = np.array([(f[3].damping, f[3].friction) for f in found], np.float32).reshape(-1, 2)
        self.body_a, self.body_b, self.group = (wp.array(c.copy(), dtype=int) for c in whole.T)
        self.damping, self.friction = (wp.array(c.copy(), dtype=float) for c in slow.T)

    def push(self, worlds: NewtonWorlds, state: Any) -> None:
        from esg.engines.newton import joint_kernels as kernels

        if len(self.body_b):
            self.wp.launch(
                kernels.brake_balls,
                dim=worlds.n_worlds,
                inputs=[
                    self.first, worlds.grid, self.body_a, self.body_b, self.group,
                    self._ties.broken, self.damping, self.friction, worlds.model.body_inertia,
                    state.body_q, state.body_qd, state.body_f,
                ],
            )  # fmt: skip


class _Springs:
    """Springs between two points."""

    def __init__(self, places: Places) -> None:
        self.wp = wp = quiet_warp()
        self._places = places
        self.found = found = by_world(places, "springs")
        world = [w for w, _ in found]
        first = np.searchsorted(world, np.arange(len(places.scene_of) + 1))
        self.first = wp.array(first.astype(np.int32), dtype=int)
        self.body_a, self.body_b = (bodies_of(places, found, end) for end in ("a", "b"))
        records = [places.plans[places.scene_of[w]].joints[t.joint] for w, t in found]
        values = [(t.length, r.stiffness, r.damping) for (_, t), r in zip(found, records)]  # noqa: B905  # one record each
        columns = np.array(values, np.float32).reshape(-1, 3).T
        self.rest, self.stiffness, self.damping = (wp.array(c.copy(), dtype=float) for c in columns)
        self.point_a, self.point_b = (wp.zeros(len(found), dtype=wp.vec3) for _ in range(2))

    def load(self, poses: list[Poses]) -> None:
        for end, target in (("a", self.point_a), ("b", self.point_b)):
            load_points(self._places, self.found, end, poses, target)

    def push(self, worlds: NewtonWorlds, state: Any) -> None:
        from esg.engines.newton import joint_kernels as kernels

        model = worlds.model
        if self.found:
            self.wp.launch(
                kernels.pull_springs,
                dim=worlds.n_worlds,
                inputs=[
                    self.first, worlds.grid, self.body_a, self.body_b, self.point_a, self.point_b,
                    self.rest, self.stiffness, self.damping, model.body_inv_mass,
                    model.body_inv_inertia, state.body_q, state.body_qd, state.body_f,
                ],
            )  # fmt: skip
