"""Audit engine: Rapier, which no optimizer of this project ever sees."""

from __future__ import annotations

from collections.abc import Iterator
import math
from typing import Any

import numpy as np

from esg.engines.base import VERIFY_DT_S
from esg.engines.breaking.world import Breaks
from esg.engines.executor import Touch, Vec, play_all
from esg.engines.joint_rules import Masses
from esg.engines.joints import Motor
from esg.engines.program import ProgramBatch
from esg.engines.rapier_joints import PARTS, ROUNDS, RapierJoints
from esg.engines.scene import Rollout, Shape, SimScene, Variation
from esg.engines.worlds import Principal, Start, Values, moving, principal_axes
from esg.units import quat_multiply

PREDICTION_M = 0.25
"""Fast bodies are seen as far ahead as they move in a step, up to this distance [m]."""

_GROUND, _VEHICLE_GROUND, _BODY, _WHEELED = 1, 2, 4, 8
_Y_TO_Z = (0.5**0.5, 0.0, 0.0, 0.5**0.5)
"""Rotation that takes Rapier's cylinder axis Y to our Z."""


class RapierEngine:
    """Rapier (see `esg.engines.base.Engine`)."""

    name = "rapier"

    def rollout(
        self,
        scene: SimScene,
        batch: ProgramBatch,
        *,
        dt: float = VERIFY_DT_S,
        record_every: int = 1,
        duration: float | None = None,
        variation: Variation | None = None,
        ground_contacts: bool = False,
    ) -> Rollout:
        """Simulates every world of the batch, one after the other (`Engine.rollout`)."""
        import rapier3d

        start = Start.of(
            scene, batch, dt=dt, record_every=record_every, duration=duration, variation=variation
        )
        contacts = play_all(
            start, lambda w: RapierWorld(rapier3d, scene, start.values, w, dt), ground_contacts
        )
        return start.rollout(self.name, contacts, {"version": rapier3d.__version__})


class RapierWorld:
    """One world; also the executor's access to its bodies.

    Args:
        r: The module rapier3d.
        scene: Bodies and shapes.
        values: Initial states and materials of W worlds.
        w: Which of them.
        dt: Physics step [s].
        principal: Principal moments and axes of bodies that state them; those of the others come
            from their inertia.
    """

    def __init__(
        self,
        r: Any,
        scene: SimScene,
        values: Values,
        w: int,
        dt: float,
        principal: Principal | None = None,
    ) -> None:
        self._r = r
        self._world = world = r.PhysicsWorld(gravity=tuple(scene.gravity))
        world.set_num_threads(1)
        world.integration_parameters.dt = dt
        # The default clamps at 400 m/s, which would hide a world that diverges.
        world.integration_parameters.normalized_max_linear_velocity = 1e6
        # Recycled contacts would keep the depth and normal of an earlier step.
        world.integration_parameters.contact_recycling = False
        self._dt = dt
        self._mass = values.mass[w]
        self._scale = float(values.friction_scale[w])
        self._owner: dict[int, int] = {}
        self._colliders: list[list[Any]] = []
        self._handles: list[Any] = []
        self._damping = [[b.linear_damping, b.angular_damping] for b in scene.bodies]
        self._flying: set[int] = set()
        self.moving = np.nonzero(moving(scene))[0].tolist()
        ground_mu, vehicle_mu, ground_e = (float(v) for v in values.ground[w])
        for friction, group, touches in (
            (ground_mu, _GROUND, _BODY),
            (vehicle_mu, _VEHICLE_GROUND, _WHEELED),
        ):
            plane = r.Collider.halfspace((0.0, 0.0, 1.0))
            self._own(
                world.add_collider(_material(r, plane, friction, ground_e, group, touches)), -1
            )
        for i, body in enumerate(scene.bodies):
            if not body.collides:
                self._handles.append(None)
                self._colliders.append([])
                continue
            builder = r.RigidBody.fixed() if body.static else r.RigidBody.dynamic()
            builder = builder.position(_pose(r, values.position[w, i], values.quaternion[w, i]))
            if not body.static:
                moments, axes = (principal or {}).get(i) or principal_axes(values.inertia[w, i])
                properties = r.MassProperties(
                    local_com=(0.0, 0.0, 0.0),
                    mass=float(values.mass[w, i]),
                    principal_inertia=tuple(float(v) for v in moments),
                    principal_inertia_local_frame=_rotation(r, axes),
                )
                builder = builder.additional_mass_properties(properties).can_sleep(False)
                # Damping is applied by hand: Rapier's own is v /= 1 + c dt.
                builder = builder.linear_damping(0.0).angular_damping(0.0)
                builder = builder.gyroscopic_forces(True).soft_ccd_prediction(PREDICTION_M)
            handle = world.add_body(builder)
            group = _WHEELED if body.wheeled else _BODY
            near = _BODY | _WHEELED | (_VEHICLE_GROUND if body.wheeled else _GROUND)
            mu, e = float(values.friction[w, i]), float(values.restitution[w, i])
            own = [
                world.add_collider(_material(r, make_shape(r, s), mu, e, group, near), handle)
                for s in body.shapes
            ]
            for collider in own:
                self._own(collider, i)
            self._handles.append(handle)
            self._colliders.append(own)
        self._bodies = world.rigid_bodies
        self._log: list[Touch] | None = None
        self._away: set[int] = set()
        self.joints: RapierJoints | None = None
        self._breaks: Breaks | None = None
        breaks = any(b.fragments for b in scene.bodies)
        if scene.joints or breaks:
            masses = Masses.of(scene, values, w, principal)
            if scene.joints:
                world.integration_parameters.num_solver_iterations = PARTS
                world.integration_parameters.num_internal_pgs_iterations = ROUNDS
                self.joints = RapierJoints(r, _pose, world, scene, self._handles, masses, dt)
            if breaks:
                self._breaks = Breaks(scene, masses, dt, self)

    def _own(self, collider: Any, body: int) -> None:
        self._owner[collider.index] = body

    def _body(self, body: int) -> Any:
        return self._bodies[self._handles[body]]

    def position(self, body: int) -> Vec:
        x, y, z = self._body(body).translation
        return float(x), float(y), float(z)

    def linear(self, body: int) -> Vec:
        x, y, z = self._body(body).linvel
        return float(x), float(y), float(z)

    def set_linear(self, body: int, velocity: Vec) -> None:
        if body in self._away:
            return
        self._body(body).linvel = velocity

    def set_flight(self, body: int, velocity: Vec, pull: float) -> None:
        # Gravity acts in Rapier's substeps: lifted against it, a body would rise by a part of
        # g dt^2 in every step. It is spared it for the step instead.
        self.set_linear(body, velocity)
        self._body(body).gravity_scale = 0.0
        self._flying.add(body)

    def set_angular(self, body: int, velocity: Vec) -> None:
        if body in self._away:
            return
        self._body(body).angvel = velocity

    def mass(self, body: int) -> float:
        return float(self._mass[body])

    def set_linear_damping(self, body: int, damping: float) -> None:
        self._damping[body][0] = damping

    def set_angular_damping(self, body: int, damping: float) -> None:
        self._damping[body][1] = damping

    def set_friction(self, body: int, friction: float) -> None:
        for collider in self._colliders[body]:
            self._world.colliders[collider].friction = friction * self._scale

    def set_motor(self, joint: int, motor: Motor | None) -> None:
        if self.joints:
            self.joints.motors[joint] = motor

    def step(self) -> None:
        for i in self.moving:
            linear, angular = self._damping[i]
            if linear:
                v = self.linear(i)
                k = max(0.0, 1.0 - linear * self._dt)
                self.set_linear(i, (v[0] * k, v[1] * k, v[2] * k))
            if angular:
                x, y, z = self._body(i).angvel
                k = max(0.0, 1.0 - angular * self._dt)
                self.set_angular(i, (x * k, y * k, z * k))
        if self.joints:
            self.joints.before_step(self)
        if self._breaks:
            self._breaks.before_step()
        self._log = None
        self._world.step()
        for i in self._flying:
            self._body(i).gravity_scale = 1.0
        self._flying.clear()
        if self.joints:
            self.joints.after_step(self, self.contacts(ground=True))
        if self._breaks:
            self._log = [*self.contacts(ground=True)]
            self._breaks.after_step(self._log)

    def retire(self, body: int) -> None:
        self._away.add(body)
        self._body(body).is_enabled = False
        if body in self.moving:
            self.moving.remove(body)

    def release(self, body: int, at: Any, turn: Any, linear: Any, angular: Any) -> None:
        self._away.discard(body)
        own = self._body(body)
        own.is_enabled = True
        own.position = _pose(self._r, at, turn)
        self.set_linear(body, tuple(linear))
        self.set_angular(body, tuple(angular))
        self.moving.append(body)

    def states(self) -> dict[int, tuple[Any, Any, Any, Any]]:
        return self._breaks.states() if self._breaks else {}

    def read(self, body: int) -> tuple[Any, Any, Any, Any]:
        b = self._body(body)
        return tuple(b.translation), b.rotation.quaternion, tuple(b.linvel), tuple(b.angvel)

    def placed(self, body: int) -> tuple[float, ...]:
        b = self._body(body)
        return *map(float, b.translation), *map(float, b.rotation.quaternion)

    def motion(self, body: int) -> tuple[float, ...]:
        b = self._body(body)
        return *map(float, b.linvel), *map(float, b.angvel)

    def contacts(self, ground: bool) -> Iterator[Touch]:
        # What breaks takes its contacts along.
        own = self._touches(ground) if self._log is None else self._log
        return (touch for touch in own if ground or (touch[0] >= 0 and touch[1] >= 0))

    def _touches(self, ground: bool) -> Iterator[Touch]:
        found: dict[tuple[int, int], list[Any]] = {}
        for contact in self._world.narrow_phase.contact_pairs():
            a = self._owner[contact.collider1.index]
            b = self._owner[contact.collider2.index]
            if (a < 0 or b < 0) and not ground:
                continue
            for manifold in contact.manifolds:
                n = manifold.data.normal
                for p in manifold.points:
                    if p.impulse > 0.0:
                        # Rapier's normal points from the first collider to the second.
                        direction = np.array([-n.x, -n.y, -n.z])
                        key = (a, b)
                        if (b, a) in found:
                            key, direction = (b, a), -direction
                        row = found.setdefault(key, [0.0, 0.0, -1.0, None, None])
                        row[0] += p.impulse
                        row[1] = max(row[1], -p.dist)
                        if p.impulse > row[2]:
                            row[2:] = p.impulse, self._point(contact.collider1, p), direction
        for (a, b), (impulse, depth, _, point, normal) in found.items():
            yield a, b, impulse, depth, point, normal

    def _point(self, collider: Any, contact: Any) -> Any:
        p = self._world.colliders[collider].position.transform_point(contact.local_p1)
        return np.array([p.x, p.y, p.z])


def make_shape(r: Any, shape: Shape) -> Any:
    """A collider builder in its body's frame."""
    quaternion: Any = shape.quaternion
    size = shape.size
    if shape.kind == "sphere":
        builder = r.Collider.ball(size[0])
    elif shape.kind == "box":
        builder = r.Collider.cuboid(*size)
    elif shape.kind == "capsule":
        builder = r.Collider.capsule_z(size[2], size[0])
    elif shape.kind == "cylinder":
        builder = r.Collider.cylinder(size[2], size[0])
        quaternion = quat_multiply(np.array(shape.quaternion), np.array(_Y_TO_Z))
    else:
        builder = r.Collider.convex_hull(np.array(shape.vertices, np.float32))
    return builder.position(_pose(r, shape.position, quaternion)).density(0.0)


def _material(
    r: Any, builder: Any, friction: float, restitution: float, group: int, touches: int
) -> Any:
    average = r.CoefficientCombineRule.AVERAGE
    groups = r.InteractionGroups(r.Group(group), r.Group(touches))
    return (
        builder.friction(friction)
        .restitution(restitution)
        .friction_combine_rule(average)
        .restitution_combine_rule(average)
        .collision_groups(groups)
    )


def _pose(r: Any, position: Any, quaternion: Any) -> Any:
    x, y, z = (float(v) for v in position)
    return r.Isometry3((x, y, z), _rotation(r, quaternion))


def _rotation(r: Any, quaternion: Any) -> Any:
    x, y, z, w = (float(v) for v in quaternion)
    norm = math.sqrt(x * x + y * y + z * z + w * w) or 1.0
    return r.Rotation3(w / norm, x / norm, y / norm, z / norm)
