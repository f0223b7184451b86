"""Verify engine: PhysX 5 on the CPU through SAPIEN.

Every world is a PhysX scene of its own, built, stepped and dropped, so that nothing leaks between
worlds and repeats are bit-identical. Damping is PhysX's own, which is v *= max(0, 1 - c dt).
"""

from __future__ import annotations

from collections.abc import Collection, Generator, Iterator
from contextlib import contextmanager
from dataclasses import replace
import math
from threading import RLock
from typing import Any

import numpy as np

from esg.engines.base import VERIFY_DT_S
from esg.engines.breaking.world import Breaks
from esg.engines.executor import Touch, Vec, play_all, touch_order
from esg.engines.joint_rules import Masses
from esg.engines.joints import Motor
from esg.engines.physx_joints import PhysxJoints
from esg.engines.physx_substeps import Corners, parts
from esg.engines.program import ProgramBatch
from esg.engines.scene import Body, Rollout, Shape, SimScene, Variation
from esg.engines.worlds import Principal, Start, Values, cylinder_vertices, moving, principal_axes
from esg.units import quat_multiply, quat_rotate

BOUNCE_THRESHOLD_MPS = 0.2
POSITION_ITERATIONS = 16
VELOCITY_ITERATIONS = 1
"""Of PhysX's Gauss-Seidel solver (PGS): with 8 a stack of ten boxes drifts twice as far. Its
other one (TGS) needs fewer, but bounces are up to 17% off in it. It is for joints (`solver`): in
it a rod that swings by 120 degrees keeps its height, of which PGS takes a fifth in 10 s."""
UNEVEN, MANY_ITERATIONS = 300.0, 64
"""Where the heaviest body is so many times as heavy as the lightest, a sweep passes little on: what
8 t press against a wall needs more of them. So do chains of joints: of ten links that carry 100
times the mass of one, anchors are 1.3 mm apart, 5.4 mm with 16."""
DEPENETRATION_MPS = 3.0
"""Bodies inside each other are pushed apart no faster, so that nothing explodes."""
CONTACT_OFFSET_M = 0.001
"""Two bodies see each other at twice this distance. PhysX would solve what lies further ahead
without friction, so what is fast is stepped in parts instead (`esg.engines.physx_substeps`)."""
ROLLING_SIDES, CROWN = 84, (0.05, 0.02)
"""Of a cylinder that rolls: sides, and how much lower its rims are, at most: [of half its width]
and [of its radius]."""

STEEPEST_DEG, ROLLS_OVER = 45.0, 0.1
"""Of what bears a cylinder that starts rolling: its tilt, and its gap below [of the radius]."""

ROLLS_TO = 0.17
"""Sine of the tilt of its axis up to which a cylinder rolls on the ground as on a capsule."""

_GROUND, _VEHICLE_GROUND, _BODY, _WHEELED, _ROLLING, _TREAD, _ROLLED_ON = 1, 2, 4, 8, 16, 32, 64
_TOUCHED = _BODY | _WHEELED | _ROLLING
_X_TO_Z = (0.0, -(0.5**0.5), 0.0, 0.5**0.5)
"""Rotation that takes PhysX's capsule axis X to our Z."""


class PhysxEngine:
    """PhysX 5 (see `esg.engines.base.Engine`)."""

    name = "physx"

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
        """Simulates every world of the batch (`Engine.rollout`)."""
        px = physx_module()
        start = Start.of(
            scene, batch, dt=dt, record_every=record_every, duration=duration, variation=variation
        )
        with scene_config(px, scene):
            contacts = play_all(
                start, lambda w: PhysxWorld(scene, start.values, w, dt), ground_contacts
            )
        extra = {
            "version": px.version(),
            "solver": solver(scene),
            "bounce_threshold_mps": BOUNCE_THRESHOLD_MPS,
            "iterations": [position_iterations(scene), VELOCITY_ITERATIONS],
        }
        return start.rollout(self.name, contacts, extra)


def physx_module() -> Any:
    """Imports `sapien.physx`; its notice about a missing graphics driver is not for our users."""
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import sapien.physx as px
    return px


_config_lock = RLock()


@contextmanager
def scene_config(px: Any, scene: SimScene) -> Generator[None]:
    """Sets SAPIEN's process-wide configuration for the scenes made inside, and puts it back.

    Only one thread at a time is inside, because the configuration is shared by all of them.
    """
    with _config_lock:
        yield from _configured(px, scene)


def _configured(px: Any, scene: SimScene) -> Iterator[None]:
    scene_before, body_before, shape_before = (
        px.get_scene_config(),
        px.get_body_config(),
        px.get_shape_config(),
    )
    config = px.PhysxSceneConfig()
    config.gravity = list(scene.gravity)
    config.bounce_threshold = BOUNCE_THRESHOLD_MPS
    config.enable_enhanced_determinism = True
    config.enable_tgs = solver(scene) == "TGS"
    config.enable_pcm = True
    config.enable_ccd = False
    body = px.PhysxBodyConfig()
    body.solver_position_iterations = position_iterations(scene)
    body.solver_velocity_iterations = VELOCITY_ITERATIONS
    # What sleeps would go on reporting the impulses of its last step.
    body.sleep_threshold = 0.0
    px.set_scene_config(config)
    px.set_body_config(body)
    px.set_shape_config(px.PhysxShapeConfig())
    try:
        yield
    finally:
        px.set_scene_config(scene_before)
        px.set_body_config(body_before)
        px.set_shape_config(shape_before)


def solver(scene: SimScene) -> str:
    """PhysX's solver for a scene: TGS where it holds bodies together itself, else PGS.

    Ropes and springs are rules of ours, for which PGS does as well (`esg.engines.joint_rules`).
    """
    return "TGS" if any(not j.flexible for j in scene.joints) else "PGS"


def position_iterations(scene: SimScene) -> int:
    """Sweeps of the solver over a scene's contacts in a step."""
    masses = [scene.bodies[i].mass for i in np.nonzero(moving(scene))[0]]
    uneven = bool(masses) and max(masses) > UNEVEN * min(masses)
    return MANY_ITERATIONS if uneven or solver(scene) == "TGS" else POSITION_ITERATIONS


class PhysxWorld:
    """One world as a PhysX scene; also the executor's access to its bodies.

    Args:
        scene: Bodies and shapes.
        values: Initial states and materials of W worlds.
        w: Which of them.
        dt: Physics step [s].
        principal: Principal moments and axes of bodies that state them; those of the others come
            from their inertia.
    """

    def __init__(
        self,
        scene: SimScene,
        values: Values,
        w: int,
        dt: float,
        principal: Principal | None = None,
    ) -> None:
        import sapien

        self._px = px = physx_module()
        self.system = px.PhysxCpuSystem()
        self._scene = sapien.Scene([self.system])
        self._scene.set_timestep(dt)
        self._dt = dt
        self._within: list[Touch] = []
        self._seen: list[Touch] | None = None
        self._poses: dict[int, tuple[float, ...]] = {}
        self._moves: dict[int, tuple[float, ...]] = {}
        self._unheard: frozenset[int] = frozenset()
        self._log: list[Touch] | None = None
        self._away: set[int] = set()
        self._mass = values.mass[w]
        self._scale = float(values.friction_scale[w])
        self._materials: list[Any] = []
        self.bodies: list[Any] = []
        self._index: dict[int, int] = {}
        self.moving: list[int] = np.nonzero(moving(scene))[0].tolist()
        ground_mu, vehicle_mu, ground_e = (float(v) for v in values.ground[w])
        self._fixed: dict[int, list[Corners]] = {}
        self._treads: dict[int, tuple[Any, Any, Vec]] = {}
        self._add_ground(ground_mu, ground_e, _GROUND, _BODY | _TREAD)
        self._add_ground(vehicle_mu, ground_e, _VEHICLE_GROUND, _WHEELED)
        below = rolled_on(scene, values, w)
        for i, body in enumerate(scene.bodies):
            mu = float(values.friction[w, i])
            material = px.PhysxMaterial(mu, mu, float(values.restitution[w, i]))
            self._materials.append(material)
            if not body.collides:
                self.bodies.append(None)
                continue
            component = (
                px.PhysxRigidStaticComponent() if body.static else px.PhysxRigidDynamicComponent()
            )
            group = _WHEELED if body.wheeled else _BODY
            rolls = rolls_on_rim(body)
            for k, shape in enumerate(body.shapes):
                collider = make_shape(px, shape, material, rolls=rolls)
                collider.set_collision_groups([group, _TOUCHED, 0, 0])
                if (i, k) in below:
                    own = _VEHICLE_GROUND if body.wheeled else _GROUND
                    touched = _BODY | _WHEELED | _TREAD | _ROLLED_ON | own
                    collider.set_collision_groups([_ROLLED_ON, touched, 0, 0])
                component.attach(collider)
                if rolls and not (body.static or body.wheeled):
                    self._add_tread(i, component, collider, shape, material)
            if not body.static:
                moments, axes = (principal or {}).get(i) or principal_axes(values.inertia[w, i])
                component.mass = float(values.mass[w, i])
                component.cmass_local_pose = to_pose((0.0, 0.0, 0.0), axes)
                component.inertia = moments.astype(np.float32)
                component.linear_damping = body.linear_damping
                component.angular_damping = body.angular_damping
                component.max_angular_velocity = 1e6
                component.max_depenetration_velocity = DEPENETRATION_MPS
            self._add(component, body.name, to_pose(values.position[w, i], values.quaternion[w, i]))
            self._index[component._physx_pointer] = i
            self.bodies.append(component)
            if body.static:
                self._fixed[i] = [_corners(s, values, w, i) for s in body.shapes]
        self.joints: PhysxJoints | None = None
        self._breaks: Breaks | None = None
        breaks = any(b.fragments for b in scene.bodies)
        if scene.joints or breaks:
            masses = Masses.of(scene, values, w, principal)
            if scene.joints:
                self.joints = PhysxJoints(px, to_pose, scene, self.bodies, masses, dt)
            if breaks:
                self._breaks = Breaks(scene, masses, dt, self)

    def _add_tread(self, i: int, component: Any, rim: Any, shape: Shape, material: Any) -> None:
        """Gives a cylinder on its rim a capsule that only the ground touches, instead of its hull.

        The solver drives the corners of a prism into the ground within a step and pushes them out
        again: a tyre let go at 3 m/s lost a fifth of its speed in 2 s, one at 24 m/s jumped 0.3 m
        high. Both ends of a capsule's line touch the ground as the cylinder's rims do.
        """
        tread = make_shape(self._px, replace(shape, kind="capsule"), material)
        component.attach(tread)
        axis = quat_rotate(np.array(shape.quaternion), np.array([0.0, 0.0, 1.0]))
        self._treads[i] = (rim, tread, (float(axis[0]), float(axis[1]), float(axis[2])))
        rim.set_collision_groups([_ROLLING, _TOUCHED, 0, 0])
        tread.set_collision_groups([_TREAD, 0, 0, 0])

    def _lay_down(self) -> None:
        """Lets what has tilted touch the ground with its hull, from then on."""
        for i, (rim, tread, axis) in list(self._treads.items()):
            w, x, y, z = self.bodies[i].entity.pose.q
            up = quat_rotate(np.array([x, y, z, w], float), np.array(axis))[2]
            if abs(float(up)) > ROLLS_TO:
                rim.set_collision_groups([_BODY, _TOUCHED, 0, 0])
                tread.set_collision_groups([0, 0, 0, 0])
                # Pairs that were filtered out are looked at again for what comes in anew.
                self.bodies[i].disable()
                self.bodies[i].enable()
                self._forget()
                del self._treads[i]

    def _add(self, component: Any, name: str, pose: Any) -> None:
        import sapien

        entity = sapien.Entity()
        entity.name = name
        entity.add_component(component)
        entity.set_pose(pose)
        self._scene.add_entity(entity)

    def _add_ground(self, friction: float, restitution: float, group: int, touches: int) -> None:
        px = self._px
        plane = px.PhysxCollisionShapePlane(px.PhysxMaterial(friction, friction, restitution))
        # PhysX planes face +X.
        plane.local_pose = to_pose((0.0, 0.0, 0.0), _X_TO_Z)
        plane.contact_offset = CONTACT_OFFSET_M
        plane.set_collision_groups([group, touches, 0, 0])
        component = px.PhysxRigidStaticComponent()
        component.attach(plane)
        self._add(component, "", to_pose((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)))
        self._index[component._physx_pointer] = -1

    def position(self, body: int) -> Vec:
        x, y, z = self.bodies[body].entity.pose.p
        return float(x), float(y), float(z)

    def linear(self, body: int) -> Vec:
        v = self.bodies[body].linear_velocity
        return float(v[0]), float(v[1]), float(v[2])

    def set_linear(self, body: int, velocity: Vec) -> None:
        if body in self._away:
            return
        self._moves.pop(body, None)
        self.bodies[body].linear_velocity = velocity

    def set_flight(self, body: int, velocity: Vec, pull: float) -> None:
        self.set_linear(body, (velocity[0], velocity[1], velocity[2] - pull))

    def set_angular(self, body: int, velocity: Vec) -> None:
        if body in self._away:
            return
        self._moves.pop(body, None)
        self.bodies[body].angular_velocity = velocity

    def mass(self, body: int) -> float:
        return float(self._mass[body])

    def set_linear_damping(self, body: int, damping: float) -> None:
        if hasattr(self.bodies[body], "linear_damping"):
            self.bodies[body].linear_damping = damping

    def set_angular_damping(self, body: int, damping: float) -> None:
        if hasattr(self.bodies[body], "angular_damping"):
            self.bodies[body].angular_damping = damping

    def set_friction(self, body: int, friction: float) -> None:
        material = self._materials[body]
        material.static_friction = friction * self._scale
        material.dynamic_friction = friction * self._scale

    def set_motor(self, joint: int, motor: Motor | None) -> None:
        if self.joints:
            self.joints.motors[joint] = motor

    def step(self) -> None:
        if self._treads:
            self._lay_down()
        bodies = [self.bodies[i] for i in self.moving]
        velocities = [self.motion(i)[:3] for i in self.moving]
        fixed = [c for corners in self._fixed.values() for c in corners]
        n = parts(velocities, lambda k: _filled(bodies[k]), fixed, self._dt)
        self._within, self._log = [], None
        if self.joints:
            self.joints.before_step(self, n)
        if self._breaks:
            self._breaks.before_step()
        if n > 1:
            self.system.set_timestep(self._dt / n)
            for _ in range(n - 1):
                self._step()
                self._within.extend(self._touches(ground=True))
        self._step()
        if n > 1:
            self.system.set_timestep(self._dt)
        if self.joints:
            self.joints.after_step(self, self.contacts(ground=True))
        if self._breaks:
            self._log = [*self.contacts(ground=True)]
            self._breaks.after_step(self._log)

    def retire(self, body: int) -> None:
        self._forget()
        self._away.add(body)
        self.bodies[body].disable()
        self._fixed.pop(body, None)
        if body in self.moving:
            self.moving.remove(body)

    def release(self, body: int, at: Any, turn: Any, linear: Any, angular: Any) -> None:
        self._forget()
        component = self.bodies[body]
        component.entity.set_pose(to_pose(at, turn))
        component.enable()
        component.linear_velocity, component.angular_velocity = linear, angular
        self.moving.append(body)
        self._away.discard(body)

    def states(self) -> dict[int, tuple[Any, Any, Any, Any]]:
        return self._breaks.states() if self._breaks else {}

    def read(self, body: int) -> tuple[Any, Any, Any, Any]:
        component = self.bodies[body]
        pose = component.entity.pose
        w, x, y, z = pose.q.tolist()
        return pose.p, (x, y, z, w), component.linear_velocity, component.angular_velocity

    def placed(self, body: int) -> tuple[float, ...]:
        """As `World.placed`; kept until the next step."""
        found = self._poses.get(body)
        if found is None:
            pose = self.bodies[body].entity.pose
            w, x, y, z = pose.q.tolist()
            found = self._poses[body] = (*pose.p.tolist(), x, y, z, w)
        return found

    def motion(self, body: int) -> tuple[float, ...]:
        """As `World.motion`; kept until it changes."""
        found = self._moves.get(body)
        if found is None:
            component = self.bodies[body]
            linear, angular = component.linear_velocity, component.angular_velocity
            found = self._moves[body] = (*linear.tolist(), *angular.tolist())
        return found

    def _forget(self) -> None:
        self._poses.clear()
        self._moves.clear()

    def leave_out(self, bodies: Collection[int]) -> None:
        """Has contacts of some bodies with the ground left out of all contacts.

        They are the most there are, and to read them takes longer than to step.

        Args:
            bodies: Those for which nobody asks. Joints, and what may break, want them all.
        """
        if not (self.joints or self._breaks):
            self._unheard = frozenset(bodies)

    def contacts(self, ground: bool) -> Iterator[Touch]:
        # What breaks takes its contacts along.
        for touch in self._within if self._log is None else self._log:
            if ground or (touch[0] >= 0 and touch[1] >= 0):
                yield touch
        if self._log is None:
            yield from self._touches(ground)

    def _touches(self, ground: bool) -> list[Touch]:
        """What touched in the last part of the step, in `touch_order`; read once a part."""
        if self._seen is None:
            # SAPIEN lists pairs of shapes by where they lie in memory, which tells of the scenes
            # that this process has played before: of two bodies the strongest contact comes first.
            self._seen = [*self._listed()]
            if len(self._seen) > 1:
                self._seen.sort(key=touch_order)
        return self._seen if ground else [t for t in self._seen if t[0] >= 0 and t[1] >= 0]

    def _step(self) -> None:
        self.system.step()
        self._seen = None
        self._forget()

    def _listed(self) -> Iterator[Touch]:
        index, unheard = self._index, self._unheard
        for contact in self.system.get_contacts():
            first, second = contact.bodies
            a, b = index[first._physx_pointer], index[second._physx_pointer]
            if (a < 0 and b in unheard) or (b < 0 and a in unheard):
                continue
            points = contact.points
            if not points:
                continue
            total, depth, best, strongest = 0.0, 0.0, -1.0, points[0]
            for p in points:
                impulse = float(p.impulse.dot(p.normal))
                total += impulse
                depth = max(depth, -float(p.separation))
                if impulse > best:
                    best, strongest = impulse, p
            if total > 0.0:
                yield a, b, total, depth, strongest.position, strongest.normal


def _filled(component: Any) -> Corners:
    low, high = component.compute_global_aabb_tight().tolist()
    return low, high


def _corners(shape: Shape, values: Values, w: int, body: int) -> Corners:
    """What a shape of a static body fills, at most."""
    turn = values.quaternion[w, body]
    points = np.array(shape.vertices)
    if not len(points):
        x, y, z = shape.size
        z += x if shape.kind == "capsule" else 0.0
        points = np.array(
            [(i * x, j * y, k * z) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
        )
    points = quat_rotate(np.array(shape.quaternion), points) + shape.position
    points = quat_rotate(turn, points) + values.position[w, body]
    return points.min(axis=0).tolist(), points.max(axis=0).tolist()


def to_pose(position: Any, quaternion: Any) -> Any:
    """A SAPIEN pose, whose quaternions are (w, x, y, z)."""
    import sapien

    x, y, z, w = (float(v) for v in quaternion)
    return sapien.Pose([float(v) for v in position], [w, x, y, z])


def rolls_on_rim(body: Body) -> bool:
    """Whether a body is one cylinder about its side axis Y: a wheel, a barrel that rolls."""
    if len(body.shapes) != 1 or body.shapes[0].kind != "cylinder":
        return False
    x, y, z, w = body.shapes[0].quaternion
    return abs(2.0 * (y * z - w * x)) > 0.99


def rolled_on(scene: SimScene, values: Values, w: int) -> set[tuple[int, int]]:
    """Shapes, as (body, shape), on whose flat tops a wheel or a barrel starts.

    They bear its tread as the ground does; what they hit from the side with is the same.
    """
    out: set[tuple[int, int]] = set()
    for i, body in enumerate(scene.bodies):
        if body.static or body.wheeled or not rolls_on_rim(body):
            continue
        radius = body.shapes[0].size[0]
        turn = values.quaternion[w, i]
        center = values.position[w, i] + quat_rotate(turn, np.array(body.shapes[0].position))
        for j, other in enumerate(scene.bodies):
            if i == j:
                continue
            for k, shape in enumerate(other.shapes):
                if shape.kind not in ("box", "convex"):
                    continue
                normals, away = _faces(shape, values, w, j, center)
                up = normals[:, 2] > math.cos(math.radians(STEEPEST_DEG))
                over = up & (np.abs(away - radius) < ROLLS_OVER * radius)
                # Above one upper face, and behind all others as far as the foot of its axis.
                for face in np.nonzero(over)[0]:
                    foot = away - (normals @ normals[face]) * away[face]
                    if foot[np.arange(len(foot)) != face].max() <= 0.0:
                        out.add((j, k))
    return out


def _faces(shape: Shape, values: Values, w: int, body: int, point: Any) -> tuple[Any, Any]:
    """Outer normals of a shape's faces in the world, shape [n, 3], and how far a point is off."""
    if shape.kind == "box":
        normals = np.concatenate([np.eye(3), -np.eye(3)])
        reach = np.tile(shape.size, 2)
    else:
        from scipy.spatial import ConvexHull

        equations = np.unique(ConvexHull(np.array(shape.vertices)).equations.round(9), axis=0)
        normals, reach = equations[:, :3], -equations[:, 3]
    turn = quat_multiply(values.quaternion[w, body], np.array(shape.quaternion))
    at = values.position[w, body] + quat_rotate(values.quaternion[w, body], shape.position)
    normals = quat_rotate(turn, normals)
    return normals, normals @ (point - at) - reach


def rolling_vertices(shape: Shape) -> Any:
    """Hull points of a wheel's tread: a prism that is highest in its middle, shape [252, 3].

    A plain prism hops from edge to edge and the solver's order of its two corners steers it aside
    (a tyre at 4 m/s by 7% of its way); a crowned one meets the ground in one point. PhysX takes
    255 vertices at most.
    """
    radius, _, half = shape.size
    ring = cylinder_vertices(shape, ROLLING_SIDES)[:ROLLING_SIDES] * [1.0, 1.0, 0.0]
    low = ring * (1.0 - min(CROWN[0] * half / radius, CROWN[1]))
    up = np.array([0.0, 0.0, half])
    return np.concatenate([ring, low - up, low + up])


def make_shape(px: Any, shape: Shape, material: Any, *, rolls: bool = False) -> Any:
    """A PhysX collision shape in its body's frame; cylinders become 32-sided prisms.

    Args:
        px: sapien.physx.
        shape: What collides.
        material: Its PhysX material.
        rolls: Whether the body rolls on it; a cylinder then becomes a finer, crowned one.
    """
    quaternion: Any = shape.quaternion
    one = np.ones(3, np.float32)
    if shape.kind == "sphere":
        collider = px.PhysxCollisionShapeSphere(shape.size[0], material)
    elif shape.kind == "box":
        collider = px.PhysxCollisionShapeBox(np.array(shape.size, np.float32), material)
    elif shape.kind == "capsule":
        collider = px.PhysxCollisionShapeCapsule(shape.size[0], shape.size[2], material)
        quaternion = quat_multiply(np.array(shape.quaternion), np.array(_X_TO_Z))
    else:
        if shape.kind == "cylinder":
            points = rolling_vertices(shape) if rolls else cylinder_vertices(shape)
        else:
            points = np.array(shape.vertices)
        collider = px.PhysxCollisionShapeConvexMesh(points.astype(np.float32), one, material)
    collider.local_pose = to_pose(shape.position, quaternion)
    collider.contact_offset = CONTACT_OFFSET_M
    return collider
