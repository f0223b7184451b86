"""Hinges and sliders of trees in a Newton model: what draws them back, damps and drives them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from esg.engines.joint_rules import APPROACH_RATE
from esg.engines.joints import Joint
from esg.engines.newton.places import Places
from esg.engines.newton.setup import DRIVE_GAIN, quiet_warp
from esg.engines.newton.trees import AXES, Floats, turned_around
from esg.outcomes import UserError

if TYPE_CHECKING:
    from esg.engines.newton.worlds import NewtonWorlds

Ints = NDArray[np.int32]


class Axes:
    """Axes of all worlds, those of a joint one after the other.

    Args:
        places: Where they are.
    """

    def __init__(self, places: Places) -> None:
        self.wp = wp = quiet_warp()
        found = [
            (link.record, k, link)
            for k, link in places.links
            if link.record is not None and link.record.kind in AXES
        ]
        self._records = [record for record, _, _ in found]
        self._bodies = [places.numbers(k, link.child) for _, k, link in found]
        self._parents = [places.numbers(k, link.parent) for _, k, link in found]
        sizes = [len(b) for b in self._bodies]
        begins = np.concatenate([[0], np.cumsum(sizes)]).astype(int)
        self.count = int(begins[-1])
        self._first = {(k, link.joint): int(f) for (_, k, link), f in zip(found, begins)}  # noqa: B905  # one end more
        self._turned = [link.record != places.plans[k].joints[link.joint] for _, k, link in found]
        joint = np.concatenate([places.joint_of[b] for b in self._bodies] or [np.zeros(0, int)])
        self._dof = places.qd_start[joint]
        self.dof = wp.array(self._dof.astype(np.int32), dtype=int)
        self.coordinate = wp.array(places.q_start[joint].astype(np.int32), dtype=int)
        self.stiffness = self._spread([r.stiffness for r in self._records])
        self.damping = self._spread([r.damping for r in self._records])
        self.friction = self._spread([r.friction for r in self._records])
        self.sign = self._spread([-1.0 if t else 1.0 for t in self._turned])
        self.inertia = wp.ones(self.count, dtype=float)
        self.speed, self.place = (wp.zeros(self.count, dtype=float) for _ in range(2))

    def _values(self, values: list[float]) -> NDArray[np.float32]:
        """One number per joint, for each of its worlds."""
        each = [np.full(len(b), v) for b, v in zip(self._bodies, values, strict=True)]
        return np.concatenate([*each, np.zeros(0)]).astype(np.float32)

    def _spread(self, values: list[float]) -> Any:
        return self.wp.array(self._values(values), dtype=float)

    def load(self, model: Any) -> None:
        """Writes motors as scenes have them, and what axes have to move at least.

        That is their child, and their parent if it moves.
        """
        motors = [r.motor for r in self._records]
        self.speed.assign(self._values([0.0 if m is None else m.speed for m in motors]))
        places = [math.nan if m is None or m.position is None else m.position for m in motors]
        self.place.assign(self._values(places))
        limits = [r.friction if r.motor is None else r.motor.limit for r in self._records]
        effort, gain = model.joint_effort_limit.numpy(), model.joint_target_kd.numpy()
        effort[self._dof] = self._values(limits)
        gain[self._dof] = np.where(effort[self._dof] > 0.0, DRIVE_GAIN, 0.0)
        model.joint_effort_limit.assign(effort)
        model.joint_target_kd.assign(gain)
        mass, inertia = model.body_mass.numpy(), model.body_inertia.numpy()
        found: list[float] = []
        for record, bodies, parents in zip(self._records, self._bodies, self._parents, strict=True):
            back = turned_around(record)
            for b, p in zip(bodies, parents, strict=True):
                ease = 1.0 / _inertia(record, mass[b], inertia[b])
                ease += 1.0 / _inertia(back, mass[p], inertia[p]) if p >= 0 else 0.0
                found.append(1.0 / ease)
        self.inertia.assign(np.array(found, np.float32))

    def of(self, k: int, joints: Ints, worlds: int) -> Ints:
        """Axes that primitives of a scene drive, -1 for others, shape [worlds, P].

        Args:
            k: Scene.
            joints: Number of the joint that each primitive drives, -1 for none, shape [P].
            worlds: Of the scene.

        Raises:
            UserError: For a joint that is in no tree.
        """
        out = np.full((worlds, len(joints)), -1, np.int32)
        for p, joint in enumerate(joints):
            if joint >= 0:
                if (k, int(joint)) not in self._first:
                    raise UserError(
                        f"Newton cannot drive joint {joint}, which closes a ring or may break; "
                        "simulate in physx"
                    )
                out[:, p] = self._first[k, int(joint)] + np.arange(worlds)
        return out

    def states(self, model: Any) -> list[Any]:
        """Arrays that programs change."""
        return [self.speed, self.place, model.joint_effort_limit, model.joint_target_kd]

    def push(self, worlds: NewtonWorlds, state: Any, drives: Any) -> None:
        """Lets programs drive axes, then sets forces and speeds of all of them.

        Args:
            worlds: The model.
            state: Its state.
            drives: Axis that each primitive drives, -1 for none, shape [W, P].
        """
        from esg.engines.newton import joint_kernels as kernels

        if not self.count:
            return
        model, control = worlds.model, worlds.control
        self.wp.launch(
            kernels.run_drives,
            dim=worlds.n_worlds,
            inputs=[
                worlds.clock, worlds.grid, worlds.primitive_counts, drives, worlds.table,
                worlds.done, self.dof, self.sign, self.friction, DRIVE_GAIN, self.speed,
                self.place, model.joint_effort_limit, model.joint_target_kd,
            ],
        )  # fmt: skip
        self.wp.launch(
            kernels.drive_axes,
            dim=self.count,
            inputs=[
                worlds.grid, self.coordinate, self.dof, self.stiffness, self.damping,
                self.inertia, self.speed, self.place, APPROACH_RATE, state.joint_q,
                state.joint_qd, control.joint_f, control.joint_target_qd,
            ],
        )  # fmt: skip


def _inertia(joint: Joint, mass: float, inertia: Floats) -> float:
    """Of a joint's child about its axis, or along it [kg m^2 or kg]."""
    if joint.kind == "slider":
        return float(mass)
    x, y, z, w = joint.child_rotation
    axis = np.array([1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)])
    arm = np.cross(axis, np.array(joint.child_anchor))
    return float(axis @ inertia @ axis + mass * arm @ arm)
